//! How much a smooth interface reflects (Fresnel 1823).
//!
//! In: the cosine of the angle of arrival, refractive indices. Out: the share of unpolarised light that is reflected; the angle
//! beyond.

use crate::scene::material::Conductor;
use glam::DVec3;

/// The cosine of the angle to the normal beyond an interface of relative index `ior` (beyond over before); 0 where all is
/// reflected (Snell).
pub fn cosine_beyond(cosine: f64, ior: f64) -> f64 {
    (1.0 - (1.0 - cosine * cosine) / (ior * ior)).max(0.0).sqrt()
}

/// The share reflected of the parts polarised across the plane of incidence (s) and in it (p).
pub fn polarised(cosine: f64, ior: f64) -> [f64; 2] {
    let beyond = cosine_beyond(cosine, ior);
    let s = (cosine - ior * beyond) / (cosine + ior * beyond);
    let p = (ior * cosine - beyond) / (ior * cosine + beyond);
    [s * s, p * p]
}

/// The share that clear media reflect; `ior` is the refractive index beyond over that before.
pub fn dielectric(cosine: f64, ior: f64) -> f64 {
    if cosine <= 0.0 {
        return 1.0;
    }
    let [s, p] = polarised(cosine, ior);
    0.5 * (s + p)
}

/// Gauss's nodes and weights for ∫ 2x·f(x) dx over 0..1, exact for polynomials of degree 11 (Abramowitz and Stegun, section 25.4.33 with
/// k = 1): means over all directions x, weighted by their cosine.
const MEAN: [(f64, f64); 6] = [
    (0.073_054_328_680_258_88, 0.017_476_603_627_219_065),
    (0.230_766_137_969_945_5, 0.087_910_331_101_017_95),
    (0.441_328_481_228_449_86, 0.197_322_301_781_310_52),
    (0.663_015_309_718_845_7, 0.281_585_107_576_397_9),
    (0.851_921_400_331_515_8, 0.271_084_994_463_037_24),
    (0.970_683_572_840_215_1, 0.144_620_661_451_017_37),
];

/// The mean share that clear media reflect over all directions, weighted by their cosine.
pub fn average_dielectric(ior: f64) -> f64 {
    if ior < 1.0 {
        // What leaves the denser side is what enters there, over the square of the index: the cone is so much narrower.
        return 1.0 - (1.0 - average_dielectric(1.0 / ior)) * ior * ior;
    }
    MEAN.iter().map(|&(cosine, weight)| dielectric(cosine, ior) * weight).sum()
}

/// The share that a metal reflects, of one colour (Born and Wolf, "Principles of Optics", section 14.2, in real numbers as in
/// Lagarde 2013, "Memo on Fresnel equations").
pub fn conductor(cosine: f64, n: f64, k: f64) -> f64 {
    let (cos2, sin2) = (cosine * cosine, 1.0 - cosine * cosine);
    let real = n * n - k * k - sin2;
    let length = (real * real + 4.0 * n * n * k * k).sqrt();
    let twice = 2.0 * cosine * (0.5 * (length + real)).max(0.0).sqrt();
    let s = (length + cos2 - twice) / (length + cos2 + twice);
    let (sum, difference) = (length * cos2 + sin2 * sin2, twice * sin2);
    0.5 * s * (1.0 + (sum - difference) / (sum + difference))
}

/// The share that a metal reflects.
#[derive(Clone, Copy, Debug)]
pub enum Metallic {
    /// Of known refractive index.
    Measured(Conductor),
    /// Of this colour where light arrives at a right angle (Schlick 1994, "An inexpensive BRDF model for physically-based
    /// rendering").
    Tint(DVec3),
}

impl Metallic {
    /// The share reflected at this angle.
    pub fn share(&self, cosine: f64) -> DVec3 {
        match self {
            Metallic::Measured(Conductor { n, k }) => {
                let of = |n: f64, k: f64| conductor(cosine, n, k);
                DVec3::new(of(n.x, k.x), of(n.y, k.y), of(n.z, k.z))
            }
            Metallic::Tint(tint) => {
                let rest = (1.0 - cosine).max(0.0);
                let square = rest * rest;
                *tint + (DVec3::ONE - *tint) * (square * square * rest)
            }
        }
    }

    /// The mean share over all directions, weighted by their cosine.
    pub fn average(&self) -> DVec3 {
        match self {
            Metallic::Measured(_) => MEAN.iter().map(|&(cosine, weight)| self.share(cosine) * weight).sum(),
            // ∫ 2x(1 − x)⁵ dx = 1/21.
            Metallic::Tint(tint) => *tint + (DVec3::ONE - *tint) / 21.0,
        }
    }
}
