//! Plastic: a matte base under a clear coat.
//!
//! In: the coat's refractive index and the width α of its slopes, the base's albedo. Out: values, densities, samples.
//!
//! What the coat lets in reaches the base, is scattered evenly, is partly thrown back by the coat from below, reaches the base
//! again, and so on: a geometric series (Saunderson 1942, "Calculation of the color of pigmented plastics"). Its sum makes base and
//! coat together reflect all if the base does.

use super::Sample;
use super::direction::cosine_spread;
use super::fresnel::dielectric;
use glam::DVec3;
use std::f64::consts::FRAC_1_PI;

/// A point of a coated matte surface.
#[derive(Clone, Copy, Debug)]
pub struct Plastic {
    /// Of the coat, relative to what is outside.
    ior: f64,
    /// The base's share of what the coat lets in from outside, and would let in from all around.
    base: DVec3,
    /// The share that leaves by the base, of what the coat lets in, for the colour where that is greatest.
    greatest: f64,
}

impl Plastic {
    /// A base of this albedo under a coat.
    pub fn new(ior: f64, albedo: DVec3, _alpha: f64) -> Self {
        let entering = 1.0 - average_dielectric(ior);
        // Of even light from below n² times less leaves than enters of even light from above, for its cone is n² times narrower.
        let leaving = entering / (ior * ior);
        let base = albedo * leaving / (DVec3::ONE - albedo * (1.0 - leaving)) / entering;
        Plastic { ior, base, greatest: base.max_element() * entering }
    }

    /// f of the base, for two directions above the surface.
    pub fn value(&self, wo: DVec3, wi: DVec3) -> DVec3 {
        self.base * (self.entering(wo) * self.entering(wi) * FRAC_1_PI)
    }

    /// The density of wi, above the surface, by way of the base.
    pub fn pdf(&self, wo: DVec3, wi: DVec3) -> f64 {
        (1.0 - self.coat_chance(wo)) * wi.z * FRAC_1_PI
    }

    /// A direction to go on in.
    pub fn sample(&self, wo: DVec3, u: [f64; 3]) -> Option<Sample> {
        let chance = self.coat_chance(wo);
        if u[2] < chance {
            return Some(Sample::mirrored(wo, DVec3::splat((1.0 - self.entering(wo)) / chance), chance));
        }
        let wi = cosine_spread([u[0], u[1]]);
        let pdf = (1.0 - chance) * wi.z * FRAC_1_PI;
        (pdf > 0.0).then(|| Sample::spread(wi, self.value(wo, wi) * (wi.z / pdf), pdf))
    }

    /// The share that the coat lets in.
    fn entering(&self, w: DVec3) -> f64 {
        1.0 - dielectric(w.z, self.ior)
    }

    /// The probability with which a sample takes the coat: its share of all that is reflected.
    fn coat_chance(&self, wo: DVec3) -> f64 {
        let entering = self.entering(wo);
        let coat = 1.0 - entering;
        if coat <= 0.0 { 0.0 } else { coat / (coat + entering * self.greatest) }
    }
}

/// Nodes of the midpoint rule for the mean reflectance.
const NODES: u32 = 64;

/// The mean share that a smooth interface reflects, over all directions weighted by their cosine.
fn average_dielectric(ior: f64) -> f64 {
    let middle = |k: u32| (f64::from(k) + 0.5) / f64::from(NODES);
    (0..NODES).map(|k| 2.0 * middle(k) * dielectric(middle(k), ior) / f64::from(NODES)).sum()
}
