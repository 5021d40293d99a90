//! Metal: light is reflected or swallowed.
//!
//! In: refractive index or tint, the width α of the slopes. Out: values, densities, samples.
//!
//! Light that meets one facet is followed exactly. What meets more, and would be lost, leaves in an even, reciprocal lobe (Kulla and
//! Conty 2017, "Revisiting physically based shading at Imageworks"), coloured by every further reflection (Hill 2018, "A
//! multi-faceted exploration", part 3).

use super::Sample;
use super::direction::{grazing_density, grazing_spread, reflected};
use super::energy::Place;
use super::fresnel::Metallic;
use super::ggx::Slopes;
use crate::scene::material::Conductor;
use glam::DVec3;
use std::f64::consts::FRAC_1_PI;

/// A point of a metal.
#[derive(Clone, Copy, Debug)]
pub struct Metal {
    fresnel: Metallic,
    rough: Option<Rough>,
}

/// What only rough metal has.
#[derive(Clone, Copy, Debug)]
struct Rough {
    slopes: Slopes,
    /// For what facets lose that reflect all.
    place: Place,
    /// The even lobe over the two losses.
    further: DVec3,
}

impl Metal {
    /// The tint counts where the refractive index is not known. α = 0 is a mirror.
    pub fn new(conductor: Option<Conductor>, tint: DVec3, alpha: f64) -> Self {
        let fresnel = conductor.map_or(Metallic::Tint(tint), Metallic::Measured);
        let rough = (alpha > 0.0).then(|| {
            let place = Place::new(f64::INFINITY, alpha);
            let (lost, mean) = (place.mean_lost(), fresnel.average());
            // Twice for the first two facets, then a geometric series.
            let colour = mean * mean * (1.0 - lost) / (DVec3::ONE - mean * lost);
            Rough { slopes: Slopes { alpha }, place, further: colour * (FRAC_1_PI / lost) }
        });
        Metal { fresnel, rough }
    }

    /// Whether it is a mirror.
    pub fn is_smooth(&self) -> bool {
        self.rough.is_none()
    }

    /// f for two directions above the surface.
    pub fn value(&self, wo: DVec3, wi: DVec3) -> DVec3 {
        let Some(rough) = &self.rough else { return DVec3::ZERO };
        let m = (wo + wi).normalize();
        let once = rough.slopes.quarter_pdf(wo, m) * rough.slopes.masked(wo.z, wi.z);
        self.fresnel.share(wo.dot(m)) * once + rough.further * (rough.place.lost(wo.z) * rough.place.lost(wi.z))
    }

    /// The density of wi, above the surface.
    pub fn pdf(&self, wo: DVec3, wi: DVec3) -> f64 {
        self.rough.as_ref().map_or(0.0, |rough| {
            let (lost, m) = (rough.place.lost(wo.z), (wo + wi).normalize());
            (1.0 - lost) * rough.slopes.quarter_pdf(wo, m) + lost * grazing_density(wi.z, rough.slopes.alpha)
        })
    }

    /// A direction to go on in.
    pub fn sample(&self, wo: DVec3, u: [f64; 3]) -> Option<Sample> {
        let Some(rough) = &self.rough else {
            return Some(Sample::mirrored(wo, self.fresnel.share(wo.z), 1.0));
        };
        let across = [u[0], u[1]];
        let wi = if u[2] < rough.place.lost(wo.z) {
            grazing_spread(across, rough.slopes.alpha)
        } else {
            reflected(wo, rough.slopes.visible_normal(wo, across))
        };
        if wi.z <= 0.0 {
            return None;
        }
        let pdf = self.pdf(wo, wi);
        (pdf > 0.0).then(|| Sample::spread(wi, self.value(wo, wi) * (wi.z / pdf), pdf))
    }
}
