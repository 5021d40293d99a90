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

/// The mean over all directions, weighted by their cosine.
fn average(share: impl Fn(f64) -> DVec3) -> DVec3 {
    AVERAGE.iter().map(|&(cosine, weight)| share(cosine) * weight).sum()
}

/// Gauss's nodes and weights for ∫ 2x·f(x) dx over 0..1, exact for f of degree 7 (Abramowitz and Stegun, table 25.8, k = 1, n = 4).
const AVERAGE: [(f64, f64); 4] = [
    (0.139_759_864_343_780_55, 0.062_361_941_900_016_16),
    (0.416_409_567_631_083_18, 0.259_695_095_216_464_88),
    (0.723_156_986_361_876_17, 0.406_929_136_020_542_72),
    (0.942_895_803_885_482_32, 0.271_013_826_862_976_23),
];

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
            Metallic::Measured(_) => average(|cosine| self.share(cosine)),
            // ∫ 2x(1 − x)⁵ dx = 1/21.
            Metallic::Tint(tint) => *tint + (DVec3::ONE - *tint) / 21.0,
        }
    }
}
