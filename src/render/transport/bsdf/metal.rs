//! Metal: light is reflected or swallowed.
//!
//! In: refractive index or tint, the width α of the slopes. Out: values, densities, samples.

use super::Sample;
use super::fresnel::Metallic;
use crate::scene::material::Conductor;
use glam::DVec3;

/// A point of a metal.
#[derive(Clone, Copy, Debug)]
pub struct Metal {
    fresnel: Metallic,
}

impl Metal {
    /// The tint counts where the refractive index is not known.
    pub fn new(conductor: Option<Conductor>, tint: DVec3, _alpha: f64) -> Self {
        Metal { fresnel: conductor.map_or(Metallic::Tint(tint), Metallic::Measured) }
    }

    /// Whether it is a mirror.
    pub fn is_smooth(&self) -> bool {
        true
    }

    /// f for two directions above the surface.
    pub fn value(&self, _wo: DVec3, _wi: DVec3) -> DVec3 {
        DVec3::ZERO
    }

    /// The density of wi, above the surface.
    pub fn pdf(&self, _wo: DVec3, _wi: DVec3) -> f64 {
        0.0
    }

    /// A direction to go on in.
    pub fn sample(&self, wo: DVec3, _u: [f64; 3]) -> Option<Sample> {
        Some(Sample::mirrored(wo, self.fresnel.share(wo.z), 1.0))
    }
}
