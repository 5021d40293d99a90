//! How a point of a surface scatters light.
//!
//! In: a material's kind and the values of its textures there; directions in the local frame, whose z is the normal turned to the
//! side the path arrives from, so that wo.z > 0. wo points back along the path and wi onward, both of length 1 and away from the
//! surface. Out: values, densities, samples. Knows no scene and no ray, so that it can be held against integrals.
//!
//! - [`direction`]: reflected, refracted, spread directions.
//! - [`fresnel`]: how much a smooth interface reflects.
//! - [`ggx`]: the slopes of rough surfaces; [`energy`]: what they lose.
//! - [`metal`], [`plastic`], [`glass`]: the kinds that are more than a line.

pub mod direction;
pub mod energy;
pub mod fresnel;
pub mod ggx;
pub mod glass;
pub mod metal;
pub mod plastic;

use crate::scene::material::Kind;
use direction::{cosine_spread, reflected};
use glam::DVec3;
use glass::Glass;
use metal::Metal;
use plastic::Plastic;
use std::f64::consts::FRAC_1_PI;

/// Below this width α of the slopes, that is below roughness 0.0316, a surface is as good as smooth: its lobe is narrower than a
/// fifth of the sun (Pharr, Jakob and Humphreys 2023, "Physically Based Rendering", section 9.6.1).
pub const SMOOTH_ALPHA: f64 = 1e-3;

/// What is carried along a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transport {
    /// Radiance: the path comes from the eye.
    Radiance,
    /// Its adjoint: the path comes from a light.
    Importance,
}

/// Scattering at one point.
#[derive(Clone, Copy, Debug)]
pub enum Bsdf {
    /// Evenly, this share (Lambert).
    Matte(DVec3),
    /// This share, mirrored.
    Mirror(DVec3),
    /// Smooth or rough metal.
    Metal(Metal),
    /// Matte under a smooth or rough coat.
    Plastic(Plastic),
    /// A smooth or rough interface of clear media.
    Glass(Glass),
}

/// A direction to go on in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Onward.
    pub wi: DVec3,
    /// f·|cos wi| / pdf.
    pub weight: DVec3,
    /// The density per solid angle; of a mirror-like part the probability of its choice.
    pub pdf: f64,
    /// Whether a mirror-like part was chosen, which has no density.
    pub is_specular: bool,
    /// Whether it goes through the surface.
    pub is_transmission: bool,
}

impl Bsdf {
    /// `color` is the albedo or tint, `roughness` r of 0..=1. `relative_ior` is the refractive index on the far side over that on
    /// the side of arrival; it matters for glass only.
    pub fn new(kind: &Kind, color: DVec3, roughness: f64, relative_ior: f64) -> Bsdf {
        let alpha = roughness * roughness;
        let alpha = if alpha < SMOOTH_ALPHA { 0.0 } else { alpha };
        match *kind {
            Kind::Matte => Bsdf::Matte(color),
            Kind::Mirror => Bsdf::Mirror(color),
            Kind::Metal(conductor) => Bsdf::Metal(Metal::new(conductor, color, alpha)),
            Kind::Plastic { ior } => Bsdf::Plastic(Plastic::new(ior, color, alpha)),
            Kind::Glass(_) => Bsdf::Glass(Glass::new(relative_ior, alpha)),
        }
    }

    /// Whether it is only mirror-like: [`Bsdf::value`] and [`Bsdf::pdf`] are 0 and only samples tell.
    pub fn is_specular(&self) -> bool {
        match self {
            Bsdf::Matte(_) | Bsdf::Plastic(_) => false,
            Bsdf::Mirror(_) => true,
            Bsdf::Metal(metal) => metal.is_smooth(),
            Bsdf::Glass(glass) => glass.is_smooth(),
        }
    }

    /// f(wo, wi), without the cosine; the mirror-like parts are left out.
    pub fn value(&self, wo: DVec3, wi: DVec3, transport: Transport) -> DVec3 {
        let is_reflection = wo.z > 0.0 && wi.z > 0.0;
        match self {
            Bsdf::Glass(glass) => DVec3::splat(glass.value(wo, wi, transport)),
            Bsdf::Matte(albedo) if is_reflection => *albedo * FRAC_1_PI,
            Bsdf::Metal(metal) if is_reflection => metal.value(wo, wi),
            Bsdf::Plastic(plastic) if is_reflection => plastic.value(wo, wi),
            Bsdf::Matte(_) | Bsdf::Mirror(_) | Bsdf::Metal(_) | Bsdf::Plastic(_) => DVec3::ZERO,
        }
    }

    /// The density, per solid angle, with which [`Bsdf::sample`] takes wi; the mirror-like parts are left out.
    pub fn pdf(&self, wo: DVec3, wi: DVec3) -> f64 {
        let is_reflection = wo.z > 0.0 && wi.z > 0.0;
        match self {
            Bsdf::Glass(glass) => glass.pdf(wo, wi),
            Bsdf::Matte(_) if is_reflection => wi.z * FRAC_1_PI,
            Bsdf::Metal(metal) if is_reflection => metal.pdf(wo, wi),
            Bsdf::Plastic(plastic) if is_reflection => plastic.pdf(wo, wi),
            Bsdf::Matte(_) | Bsdf::Mirror(_) | Bsdf::Metal(_) | Bsdf::Plastic(_) => 0.0,
        }
    }

    /// The density with which wo would be sampled by a path that arrives along wi.
    pub fn reverse_pdf(&self, wo: DVec3, wi: DVec3) -> f64 {
        match self {
            Bsdf::Glass(glass) if wi.z < 0.0 => glass.pdf_from_beyond(wo, wi),
            _ => self.pdf(wi, wo),
        }
    }

    /// A direction to go on in, chosen by three numbers of 0..1; `None`: absorbed.
    pub fn sample(&self, wo: DVec3, u: [f64; 3], transport: Transport) -> Option<Sample> {
        if wo.z <= 0.0 {
            return None;
        }
        match self {
            Bsdf::Matte(albedo) => {
                let wi = cosine_spread([u[0], u[1]]);
                Some(Sample::spread(wi, *albedo, wi.z * FRAC_1_PI)).filter(|_| wi.z > 0.0)
            }
            Bsdf::Mirror(color) => Some(Sample::mirrored(wo, *color, 1.0)),
            Bsdf::Metal(metal) => metal.sample(wo, u),
            Bsdf::Plastic(plastic) => plastic.sample(wo, u),
            Bsdf::Glass(glass) => glass.sample(wo, u, transport),
        }
    }
}

impl Sample {
    /// Into the mirrored direction.
    fn mirrored(wo: DVec3, weight: DVec3, probability: f64) -> Self {
        Sample { wi: reflected(wo, DVec3::Z), weight, pdf: probability, is_specular: true, is_transmission: false }
    }

    /// With a density.
    fn spread(wi: DVec3, weight: DVec3, pdf: f64) -> Self {
        Sample { wi, weight, pdf, is_specular: false, is_transmission: wi.z < 0.0 }
    }
}

/// The same direction with the surface's sides swapped.
fn turned(w: DVec3) -> DVec3 {
    DVec3::new(w.x, w.y, -w.z)
}

#[cfg(test)]
mod tests;
