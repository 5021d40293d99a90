//! e^a.
//!
//! In: the exponent, as one f64 or as an unevaluated sum of two. Out: the power, scaled by a power of two on
//! wish. The classical reduction by multiples of ln 2 (Muller, Elementary Functions, 3rd ed., section 11.1).

use super::coefficients::{EXP, LN_2};
use super::double_double::fast_two_sum;
use super::{ROUNDER, polynomial};
use crate::num::level::Level;

/// Above, e^a is infinite, whatever the scale of a function that uses it; below its negative, it is 0.
const OVERFLOW: f64 = 746.0;

/// e^a.
#[inline(always)]
pub fn exp<L: Level>(a: f64) -> f64 {
    exp_scaled::<L>(a, 0.0, 0.0)
}

/// e^(a + low)·2^shift, |low| below 2^-30, for a small whole shift.
#[inline(always)]
pub(super) fn exp_scaled<L: Level>(a: f64, low: f64, shift: f64) -> f64 {
    let (s, e, k) = exp_parts::<L>(a, low);
    scale(s + e, k + shift)
}

/// e^a·2^shift as a sum of two.
#[inline(always)]
pub(super) fn exp_sum<L: Level>(a: f64, shift: f64) -> (f64, f64) {
    let (s, e, k) = exp_parts::<L>(a, 0.0);
    let (p, rest) = fast_two_sum(s, e);
    (scale(p, k + shift), scale(rest, k + shift))
}

/// (s, e, k): e^(a + low) = (s + e)·2^k.
#[inline(always)]
fn exp_parts<L: Level>(a: f64, low: f64) -> (f64, f64, f64) {
    let a = if a > OVERFLOW { OVERFLOW } else { a };
    let a = if a < -OVERFLOW { -OVERFLOW } else { a };
    let k = L::fma(a, std::f64::consts::LOG2_E, ROUNDER) - ROUNDER;
    // Exact: both terms are multiples of 2^-54, the difference is below 0.35.
    let high = L::fma(-k, LN_2[0], a);
    let t = k * LN_2[1] - low;
    let r = high - t;
    let rest = (high - r) - t;
    let (s, e) = fast_two_sum(1.0, r);
    (s, e + L::fma(r * r, polynomial::<L, _>(&EXP, r), rest * s), k)
}

/// p·2^k for whole |k| < 2000: in two steps, so that subnormal results come out by one rounding and
/// results that are too large as infinity.
#[inline(always)]
fn scale(p: f64, k: f64) -> f64 {
    let half = 0.5 * k + ROUNDER;
    let first = f64::from_bits(half.to_bits().wrapping_add(1023) << 52);
    let rest = (k - (half - ROUNDER)) + ROUNDER;
    let second = f64::from_bits(rest.to_bits().wrapping_add(1023) << 52);
    p * first * second
}
