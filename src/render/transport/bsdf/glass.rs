//! An interface of two clear media: light is reflected or refracted.
//!
//! In: the relative refractive index, the width α of the slopes. Out: values, densities, samples.
//!
//! Rough interfaces are those of Walter, Marschner, Li and Torrance 2007, "Microfacet models for refraction through rough surfaces".
//! What meets more than one facet, and would be lost, leaves in even lobes above and below (Kulla and Conty 2017, "Revisiting
//! physically based shading at Imageworks"), shared so that they are reciprocal.

use super::direction::{grazing_density, grazing_spread, reflected, refracted};
use super::energy::Place;
use super::fresnel::{average_dielectric, cosine_beyond, dielectric};
use super::ggx::Slopes;
use super::{Sample, Transport, turned};
use glam::DVec3;
use std::f64::consts::FRAC_1_PI;

/// Refractive indices nearer than this part light by less than a millionth, and bend it by less: nothing is there.
const MATCHED: f64 = 1e-6;

/// A mean loss below this is rounding: 1 − 1 of a few hundred terms.
const NO_LOSS: f64 = 1e-14;

/// A point of an interface of clear media.
#[derive(Clone, Copy, Debug)]
pub struct Glass {
    /// Refractive index on the far side over that on the side of arrival.
    ior: f64,
    rough: Option<Rough>,
}

/// What only rough interfaces have.
#[derive(Clone, Copy, Debug)]
struct Rough {
    slopes: Slopes,
    place: Place,
    /// Of the light that meets more than one facet, the share that goes through.
    through: f64,
    /// The even lobes above and below, of importance, over the two losses.
    further: [f64; 2],
}

impl Glass {
    /// `ior` is relative: beyond over before. α = 0 is smooth.
    pub fn new(ior: f64, alpha: f64) -> Self {
        if (ior - 1.0).abs() < MATCHED {
            return Glass { ior: 1.0, rough: None };
        }
        Glass { ior, rough: (alpha > 0.0).then(|| Rough::new(ior, alpha)) }
    }

    /// Whether there are only mirror-like parts.
    pub fn is_smooth(&self) -> bool {
        self.rough.is_none()
    }

    /// f, of any colour.
    pub fn value(&self, wo: DVec3, wi: DVec3, transport: Transport) -> f64 {
        self.pdf_and_value(wo, wi)[1] * self.widening(wi, transport)
    }

    /// The density of wi.
    pub fn pdf(&self, wo: DVec3, wi: DVec3) -> f64 {
        self.pdf_and_value(wo, wi)[0]
    }

    /// The density of wi, and f of importance: by one facet and by several.
    fn pdf_and_value(&self, wo: DVec3, wi: DVec3) -> [f64; 2] {
        let Some(rough) = self.rough.as_ref().filter(|_| wo.z > 0.0 && wi.z != 0.0) else { return [0.0; 2] };
        let (once, lost, height) = (self.facet_pdf(rough, wo, wi), rough.place.lost(wo.z), wi.z.abs());
        let further = lost * grazing_density(height, rough.slopes.alpha);
        let [share, masked, lobe] = if wi.z > 0.0 {
            let lobe = rough.further[0] * rough.place.lost(height);
            [1.0 - rough.through, rough.slopes.masked(wo.z, height), lobe]
        } else {
            let lobe = rough.further[1] * rough.place.swapped().lost(height);
            [rough.through, rough.slopes.masked_beyond(wo.z, height), lobe]
        };
        [(1.0 - lost) * once + share * further, once * masked + lost * lobe]
    }

    /// The density with which a path that arrives along wi, from beyond, would take wo.
    pub fn pdf_from_beyond(&self, wo: DVec3, wi: DVec3) -> f64 {
        let ior = 1.0 / self.ior;
        let rough = self.rough.map(|rough| Rough::new(ior, rough.slopes.alpha));
        Glass { ior, rough }.pdf(turned(wi), turned(wo))
    }

    /// A direction to go on in.
    pub fn sample(&self, wo: DVec3, u: [f64; 3], transport: Transport) -> Option<Sample> {
        let Some(rough) = &self.rough else { return Some(self.sample_smooth(wo, u[2], transport)) };
        let (across, lost) = ([u[0], u[1]], rough.place.lost(wo.z));
        let wi = if u[2] < lost {
            let wi = grazing_spread(across, rough.slopes.alpha);
            if u[2] < lost * rough.through { turned(wi) } else { wi }
        } else {
            self.by_facet(wo, rough.slopes.visible_normal(wo, across), (u[2] - lost) / (1.0 - lost))?
        };
        let [pdf, value] = self.pdf_and_value(wo, wi);
        let weight = value * self.widening(wi, transport) * wi.z.abs() / pdf;
        (pdf > 0.0).then(|| Sample::spread(wi, DVec3::splat(weight), pdf))
    }

    fn sample_smooth(&self, wo: DVec3, u: f64, transport: Transport) -> Sample {
        let reflectance = dielectric(wo.z, self.ior);
        if u < reflectance {
            return Sample::mirrored(wo, DVec3::ONE, reflectance);
        }
        let wi = refracted(wo, DVec3::Z, self.ior, cosine_beyond(wo.z, self.ior));
        Sample {
            wi,
            weight: DVec3::splat(self.widening(wi, transport)),
            pdf: 1.0 - reflectance,
            is_specular: true,
            is_transmission: true,
        }
    }

    /// The way by a facet of normal m, if it leaves.
    fn by_facet(&self, wo: DVec3, m: DVec3, choice: f64) -> Option<DVec3> {
        let facing = wo.dot(m);
        if choice < dielectric(facing, self.ior) {
            return Some(reflected(wo, m)).filter(|wi| wi.z > 0.0);
        }
        let wi = refracted(wo, m, self.ior, cosine_beyond(facing, self.ior));
        Some(wi.normalize()).filter(|wi| wi.z < 0.0)
    }

    /// The density with which a facet leads from wo to wi.
    fn facet_pdf(&self, rough: &Rough, wo: DVec3, wi: DVec3) -> f64 {
        let is_reflection = wi.z > 0.0;
        let half = if is_reflection { wo + wi } else { wo + wi * self.ior };
        let m = half.normalize() * half.z.signum();
        let (facing, facing_i) = (wo.dot(m), wi.dot(m));
        if facing <= 0.0 || (facing_i > 0.0) != is_reflection {
            return 0.0;
        }
        let (reflectance, quarter) = (dielectric(facing, self.ior), rough.slopes.quarter_pdf(wo, m));
        if is_reflection {
            return reflectance * quarter;
        }
        // How much solid angle of m there is to that of wi (Walter and others, equation 17).
        let sum = facing_i + facing / self.ior;
        (1.0 - reflectance) * quarter * 4.0 * facing * facing_i.abs() / (sum * sum)
    }

    /// What radiance from wi gains where its cone narrows or widens (Veach 1997, "Robust Monte Carlo methods for light transport
    /// simulation", section 5.2).
    fn widening(&self, wi: DVec3, transport: Transport) -> f64 {
        match transport {
            Transport::Radiance if wi.z < 0.0 => 1.0 / (self.ior * self.ior),
            Transport::Radiance | Transport::Importance => 1.0,
        }
    }
}

impl Rough {
    fn new(ior: f64, alpha: f64) -> Self {
        let place = Place::new(ior, alpha);
        let [lost, lost_beyond] = [place.mean_lost(), place.swapped().mean_lost()];
        // What a smooth interface lets through from all around, times a ratio that makes the lobes through the surface reciprocal:
        // through·lost on one side is n² times that on the other, for any two losses.
        let entering = 1.0 - average_dielectric(ior);
        let through = if lost > lost_beyond { entering * lost_beyond / lost } else { entering };
        let over = |share: f64, lost: f64| if lost > NO_LOSS { share * FRAC_1_PI / lost } else { 0.0 };
        Rough {
            slopes: Slopes { alpha },
            place,
            through,
            further: [over(1.0 - through, lost), over(through, lost_beyond)],
        }
    }
}
