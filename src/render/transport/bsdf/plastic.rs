//! Plastic: a matte base under a clear coat.
//!
//! In: the coat's refractive index and the width α of its slopes, the base's albedo. Out: values, densities, samples.
//!
//! What the coat lets in reaches the base, is scattered evenly, is partly thrown back by the coat from below, reaches the base
//! again, and so on: a geometric series (Saunderson 1942, "Calculation of the color of pigmented plastics"). Its sum makes base and
//! coat together reflect all if the base does. What a rough coat reflects is what its facets do, each met once; the rest comes in.

use super::Sample;
use super::direction::{cosine_spread, reflected};
use super::energy::Place;
use super::fresnel::{average_dielectric, dielectric};
use super::ggx::Slopes;
use glam::DVec3;
use std::f64::consts::FRAC_1_PI;

/// A point of a coated matte surface.
#[derive(Clone, Copy, Debug)]
pub struct Plastic {
    /// Of the coat, relative to what is outside.
    ior: f64,
    rough: Option<Rough>,
    /// The base's f over what the coat lets in from both directions.
    base: DVec3,
    /// The share that leaves by the base, of what the coat lets in, for the colour where that is greatest.
    greatest: f64,
}

/// What only rough coats have.
#[derive(Clone, Copy, Debug)]
struct Rough {
    slopes: Slopes,
    place: Place,
}

impl Plastic {
    /// A base of this albedo under a coat; α = 0 is smooth. A coat that is no denser than what is outside is none.
    pub fn new(ior: f64, albedo: DVec3, alpha: f64) -> Self {
        let ior = ior.max(1.0);
        let rough = (alpha > 0.0).then(|| Rough { slopes: Slopes { alpha }, place: Place::new(ior, alpha) });
        let entering = 1.0 - rough.as_ref().map_or_else(|| average_dielectric(ior), |r| r.place.mean_reflected());
        // Of even light from below n² times less leaves than enters of even light from above, for its cone is n² times narrower.
        let leaving = entering / (ior * ior);
        let through = albedo * leaving / (DVec3::ONE - albedo * (1.0 - leaving));
        Plastic { ior, rough, base: through * (FRAC_1_PI / entering), greatest: through.max_element() }
    }

    /// f for two directions above the surface.
    pub fn value(&self, wo: DVec3, wi: DVec3) -> DVec3 {
        let base = self.base * ((1.0 - self.reflectance(wo)) * (1.0 - self.reflectance(wi)));
        let Some(rough) = &self.rough else { return base };
        let m = (wo + wi).normalize();
        let facets = rough.slopes.quarter_pdf(wo, m) * rough.slopes.masked(wo.z, wi.z);
        base + DVec3::splat(dielectric(wo.dot(m), self.ior) * facets)
    }

    /// The density of wi, above the surface; that of a smooth coat is left out.
    pub fn pdf(&self, wo: DVec3, wi: DVec3) -> f64 {
        let chance = self.coat_chance(wo);
        let coat = self.rough.map_or(0.0, |rough| rough.slopes.quarter_pdf(wo, (wo + wi).normalize()));
        chance * coat + (1.0 - chance) * wi.z * FRAC_1_PI
    }

    /// A direction to go on in.
    pub fn sample(&self, wo: DVec3, u: [f64; 3]) -> Option<Sample> {
        let chance = self.coat_chance(wo);
        let across = [u[0], u[1]];
        let wi = match &self.rough {
            _ if u[2] >= chance => cosine_spread(across),
            None => return Some(Sample::mirrored(wo, DVec3::splat(self.reflectance(wo) / chance), chance)),
            Some(rough) => reflected(wo, rough.slopes.visible_normal(wo, across)),
        };
        if wi.z <= 0.0 {
            return None;
        }
        let pdf = self.pdf(wo, wi);
        (pdf > 0.0).then(|| Sample::spread(wi, self.value(wo, wi) * (wi.z / pdf), pdf))
    }

    /// The share that the coat reflects.
    fn reflectance(&self, w: DVec3) -> f64 {
        self.rough.map_or_else(|| dielectric(w.z, self.ior), |rough| rough.place.reflected(w.z))
    }

    /// The probability with which a sample takes the coat: its share of all that is reflected.
    fn coat_chance(&self, wo: DVec3) -> f64 {
        let coat = self.reflectance(wo);
        if coat <= 0.0 { 0.0 } else { coat / (coat + (1.0 - coat) * self.greatest) }
    }
}
