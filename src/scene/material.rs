//! What surfaces are made of.
//!
//! In: what the program says of a surface. Out: plain data: how it scatters, what it emits, how much of it is there. Colours are
//! linear red, green, blue; lengths are those of the world. How light is scattered by it is `render`'s business.

use super::texture::Texture;
use glam::DVec3;

/// The albedo of what was given no colour.
pub const DEFAULT_ALBEDO: f64 = 0.8;

/// The refractive index of glass and of coats where none is given: crown glass.
pub const DEFAULT_IOR: f64 = 1.5;

/// How a surface scatters, emits and lets through.
#[derive(Clone, Debug)]
pub struct Material {
    /// How it scatters.
    pub kind: Kind,
    /// Albedo or tint, each part of 0..=1.
    pub color: Texture,
    /// Roughness r of 0..=1, in the first part; the width α of the microfacets' slopes is r².
    pub roughness: Texture,
    /// Radiance of both sides in W/(m² sr).
    pub emission: Texture,
    /// The share of light that meets the surface at all, of 0..=1, in the first part; the rest passes straight on.
    pub opacity: Texture,
}

/// The kinds of scattering.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Evenly into all directions (Lambert).
    Matte,
    /// Matte under a coat of this refractive index.
    Plastic {
        /// Of the coat, relative to air.
        ior: f64,
    },
    /// Rough or smooth metal; `None`: the colour is the reflectance at normal incidence.
    Metal(Option<Conductor>),
    /// Reflects its colour's share, whatever the angle.
    Mirror,
    /// Clear, smooth or rough.
    Glass(Dielectric),
}

/// The complex refractive index n + ik of a metal, relative to air, for red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductor {
    /// The real part.
    pub n: DVec3,
    /// The imaginary part.
    pub k: DVec3,
}

/// The inside of a clear solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric {
    /// Its refractive index, > 0.
    pub ior: f64,
    /// What a way of length 1 through it takes: light falls by e^(−absorption · length).
    pub absorption: DVec3,
    /// Whether the inside is where the gradient's own side is left, that is where the equation as rewritten is negative.
    pub inside_is_negative: bool,
    /// Where solids overlap, the one of the greatest priority fills the place.
    pub priority: u32,
}

impl Kind {
    /// The same where a medium of this refractive index surrounds it: what is known relative to air becomes relative to that medium.
    /// Of glass both sides are media, and known elsewhere.
    pub fn inside(self, surrounding: f64) -> Self {
        match self {
            _ if surrounding == 1.0 => self,
            Kind::Plastic { ior } => Kind::Plastic { ior: ior / surrounding },
            Kind::Metal(Some(Conductor { n, k })) => {
                Kind::Metal(Some(Conductor { n: n / surrounding, k: k / surrounding }))
            }
            Kind::Matte | Kind::Metal(None) | Kind::Mirror | Kind::Glass(_) => self,
        }
    }
}

impl Material {
    /// Matte of this albedo.
    pub fn matte(albedo: DVec3) -> Self {
        Material {
            kind: Kind::Matte,
            color: Texture::Constant(albedo),
            roughness: Texture::Constant(DVec3::ZERO),
            emission: Texture::Constant(DVec3::ZERO),
            opacity: Texture::Constant(DVec3::ONE),
        }
    }

    /// Whether light may come from the surface itself.
    pub fn is_glowing(&self) -> bool {
        self.emission.constant() != Some(DVec3::ZERO)
    }
}
