//! Angles as people give them, in degrees.
//!
//! In: degrees. Out: sine, cosine, tangent; exact at the multiples of 90 that an orbit is made of.

use crate::num::func;
use crate::num::level::Portable;

const RADIANS_PER_DEGREE: f64 = std::f64::consts::PI / 180.0;

/// An angle in radians.
pub fn radians(degrees: f64) -> f64 {
    degrees * RADIANS_PER_DEGREE
}

/// The sine of an angle in degrees.
pub fn sine(degrees: f64) -> f64 {
    match degrees.rem_euclid(360.0) {
        0.0 | 180.0 => 0.0,
        90.0 => 1.0,
        270.0 => -1.0,
        reduced => func::sin::<Portable>(reduced * RADIANS_PER_DEGREE),
    }
}

/// The cosine of an angle in degrees.
pub fn cosine(degrees: f64) -> f64 {
    match degrees.rem_euclid(360.0) {
        0.0 => 1.0,
        180.0 => -1.0,
        90.0 | 270.0 => 0.0,
        reduced => func::cos::<Portable>(reduced * RADIANS_PER_DEGREE),
    }
}

/// The tangent of an angle in degrees, of less than 90.
pub fn tangent(degrees: f64) -> f64 {
    func::tan::<Portable>(degrees * RADIANS_PER_DEGREE)
}
