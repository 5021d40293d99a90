//! An interface of two clear media: light is reflected or refracted.
//!
//! In: the relative refractive index, the width α of the slopes. Out: values, densities, samples.

use super::direction::refracted;
use super::fresnel::{cosine_beyond, dielectric};
use super::{Sample, Transport};
use glam::DVec3;

/// A point of an interface of clear media.
#[derive(Clone, Copy, Debug)]
pub struct Glass {
    /// Refractive index on the far side over that on the side of arrival.
    ior: f64,
}

impl Glass {
    /// `ior` is relative: beyond over before.
    pub fn new(ior: f64, _alpha: f64) -> Self {
        Glass { ior }
    }

    /// Whether there are only mirror-like parts.
    pub fn is_smooth(&self) -> bool {
        true
    }

    /// The same interface, met from the other side.
    pub fn swapped(&self) -> Self {
        Glass { ior: 1.0 / self.ior }
    }

    /// f, of any colour.
    pub fn value(&self, _wo: DVec3, _wi: DVec3, _transport: Transport) -> f64 {
        0.0
    }

    /// The density of wi.
    pub fn pdf(&self, _wo: DVec3, _wi: DVec3) -> f64 {
        0.0
    }

    /// A direction to go on in.
    pub fn sample(&self, wo: DVec3, u: [f64; 3], transport: Transport) -> Option<Sample> {
        let reflectance = dielectric(wo.z, self.ior);
        if u[2] < reflectance {
            return Some(Sample::mirrored(wo, DVec3::ONE, reflectance));
        }
        Some(Sample {
            wi: refracted(wo, DVec3::Z, self.ior, cosine_beyond(wo.z, self.ior)),
            weight: DVec3::splat(self.widening(transport)),
            pdf: 1.0 - reflectance,
            is_specular: true,
            is_transmission: true,
        })
    }

    /// What radiance gains where its cone narrows or widens (Veach 1997, "Robust Monte Carlo methods for light transport
    /// simulation", section 5.2).
    fn widening(&self, transport: Transport) -> f64 {
        match transport {
            Transport::Radiance => 1.0 / (self.ior * self.ior),
            Transport::Importance => 1.0,
        }
    }
}
