//! Directions: reflected, refracted, spread over a hemisphere.
//!
//! In: directions away from the surface; numbers of 0..1. Out: directions of length 1.

use glam::DVec3;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2};

/// w mirrored at the plane whose normal is m.
pub fn reflected(w: DVec3, m: DVec3) -> DVec3 {
    m * (2.0 * w.dot(m)) - w
}

/// w refracted at the plane whose normal m is on its side; `ior` is the refractive index beyond over that before, `cosine_beyond`
/// what Snell's law says of the way there ([`super::fresnel::cosine_beyond`]).
pub fn refracted(w: DVec3, m: DVec3, ior: f64, cosine_beyond: f64) -> DVec3 {
    (m * w.dot(m) - w) / ior - m * cosine_beyond
}

/// A direction of the upper hemisphere with a density of its cosine over π: even in the disc below (Malley's method; Pharr, Jakob
/// and Humphreys 2023, "Physically Based Rendering", section A.5.3).
pub fn cosine_spread([u, v]: [f64; 2]) -> DVec3 {
    let (radius, height) = (u.sqrt(), (1.0 - u).max(0.0).sqrt());
    let [x, y] = on_circle(v);
    DVec3::new(radius * x, radius * y, height)
}

/// The point of the unit circle after u turns, 0 ≤ u ≤ 1: the series of cos and sin on an eighth of a turn to each side, turned by
/// quarters. Sums and products alone, so it is the same on every machine, and much quicker than the proven functions.
pub fn on_circle(u: f64) -> [f64; 2] {
    let quarter = (u * 4.0 + 0.5).floor();
    let angle = (u * 4.0 - quarter) * FRAC_PI_2;
    let square = angle * angle;
    let cosine = horner(square, &[1.0, -2.0, 24.0, -720.0, 40_320.0, -3_628_800.0, 479_001_600.0, -87_178_291_200.0]);
    let sine = angle * horner(square, &[1.0, -6.0, 120.0, -5_040.0, 362_880.0, -39_916_800.0, 6_227_020_800.0]);
    match quarter as i32 & 3 {
        0 => [cosine, sine],
        1 => [-sine, cosine],
        2 => [-cosine, -sine],
        _ => [sine, -cosine],
    }
}

/// The sum of x^k / d_k.
#[inline(always)]
fn horner<const N: usize>(x: f64, divisors: &[f64; N]) -> f64 {
    divisors.iter().rev().fold(0.0, |sum, d| sum * x + 1.0 / d)
}

/// A direction of the upper hemisphere, the more often grazing the smaller α: about as light leaves that met several facets. Its
/// cosine's square is u·α/(1 + α − u).
pub fn grazing_spread([u, v]: [f64; 2], alpha: f64) -> DVec3 {
    let square = (u * alpha / (1.0 + alpha - u)).min(1.0);
    let radius = (1.0 - square).sqrt();
    let [x, y] = on_circle(v);
    DVec3::new(radius * x, radius * y, square.sqrt())
}

/// The density of [`grazing_spread`] per solid angle.
pub fn grazing_density(cosine: f64, alpha: f64) -> f64 {
    let sum = cosine * cosine + alpha;
    FRAC_1_PI * cosine * alpha * (1.0 + alpha) / (sum * sum)
}
