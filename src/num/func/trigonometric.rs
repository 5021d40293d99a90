//! Sine, cosine and tangent.
//!
//! In: an angle. Out: its functions; NaN for an infinite angle. Up to [`REDUCIBLE`] the angle is reduced by
//! a straight line of code after Cody and Waite (Muller, Elementary Functions, 3rd ed., section 11.2); beyond,
//! by whole numbers after Payne and Hanek. Loops over arrays use the functions whose name ends in `_reducible`
//! and patch the rare large angles afterwards.

use super::coefficients::{COS, HALF_PI, SIN, TWO_OVER_PI};
use super::double_double::{fast_two_sum, product, two_sum};
use super::{ROUNDER, polynomial};
use crate::num::level::{Level, Portable};

/// Up to this angle the straight reduction holds: k·(third part of π/2) stays below 2^-105, and no f64 up to
/// it comes nearer than 2^-60 to a multiple of π/2 (Muller, section 11.3).
pub const REDUCIBLE: f64 = 1048576.0;

/// sine
#[inline(always)]
pub fn sin<L: Level>(a: f64) -> f64 {
    if a.abs() > REDUCIBLE { sin_cos_of_large(a).0 } else { sin_reducible::<L>(a) }
}

/// cosine
#[inline(always)]
pub fn cos<L: Level>(a: f64) -> f64 {
    if a.abs() > REDUCIBLE { sin_cos_of_large(a).1 } else { cos_reducible::<L>(a) }
}

/// sine and cosine
#[inline(always)]
pub fn sin_cos<L: Level>(a: f64) -> (f64, f64) {
    if a.abs() > REDUCIBLE { sin_cos_of_large(a) } else { sin_cos_reducible::<L>(a) }
}

/// tangent; finite for every f64, for none is a pole
#[inline(always)]
pub fn tan<L: Level>(a: f64) -> f64 {
    if a.abs() > REDUCIBLE { tan_of_large(a) } else { tan_reducible::<L>(a) }
}

/// sine for |a| ≤ [`REDUCIBLE`]
#[inline(always)]
pub fn sin_reducible<L: Level>(a: f64) -> f64 {
    let (r, low, quadrant) = reduce::<L>(a);
    let (s, c) = (sin_near::<L>(r, low), cos_near::<L>(r, low));
    let value = if quadrant & 1 == 0 { s } else { c };
    f64::from_bits(value.to_bits() ^ (quadrant & 2) << 62)
}

/// cosine for |a| ≤ [`REDUCIBLE`]
#[inline(always)]
pub fn cos_reducible<L: Level>(a: f64) -> f64 {
    let (r, low, quadrant) = reduce::<L>(a);
    let (s, c) = (sin_near::<L>(r, low), cos_near::<L>(r, low));
    let value = if quadrant & 1 == 0 { c } else { s };
    f64::from_bits(value.to_bits() ^ (quadrant.wrapping_add(1) & 2) << 62)
}

/// sine and cosine for |a| ≤ [`REDUCIBLE`]
#[inline(always)]
pub fn sin_cos_reducible<L: Level>(a: f64) -> (f64, f64) {
    let (r, low, quadrant) = reduce::<L>(a);
    turn::<L>(r, low, quadrant)
}

/// tangent for |a| ≤ [`REDUCIBLE`]
#[inline(always)]
pub fn tan_reducible<L: Level>(a: f64) -> f64 {
    let (r, low, quadrant) = reduce::<L>(a);
    quotient::<L>(r, low, quadrant)
}

/// tan(r + low + quadrant·π/2): the quotient of the sums, its remainder divided once more.
#[inline(always)]
fn quotient<L: Level>(r: f64, low: f64, quadrant: u64) -> f64 {
    let (s, s_low) = sin_sum::<L>(r, low);
    let (c, c_low) = cos_sum::<L>(r, low);
    let even = quadrant & 1 == 0;
    let (n, n_low) = if even { (s, s_low) } else { (-c, -c_low) };
    let (d, d_low) = if even { (c, c_low) } else { (s, s_low) };
    let t = n / d;
    t + (L::fma(-t, d, n) + (n_low - t * d_low)) / d
}

/// sine and cosine of r + low + quadrant·π/2.
#[inline(always)]
fn turn<L: Level>(r: f64, low: f64, quadrant: u64) -> (f64, f64) {
    let (s, c) = (sin_near::<L>(r, low), cos_near::<L>(r, low));
    let (sin, cos) = if quadrant & 1 == 0 { (s, c) } else { (c, s) };
    let sin = f64::from_bits(sin.to_bits() ^ (quadrant & 2) << 62);
    (sin, f64::from_bits(cos.to_bits() ^ (quadrant.wrapping_add(1) & 2) << 62))
}

/// (r, low, k): a = r + low + k·π/2 with |r| ≤ π/4 and a little; k in the low bits.
#[inline(always)]
fn reduce<L: Level>(a: f64) -> (f64, f64, u64) {
    let rounded = L::fma(a, std::f64::consts::FRAC_2_PI, ROUNDER);
    let k = rounded - ROUNDER;
    // Exact: both terms are multiples of 2^-53, the difference is below 0.8.
    let high = L::fma(-k, HALF_PI[0], a);
    let t = k * HALF_PI[1];
    let t_error = L::fma(k, HALF_PI[1], -t);
    let (r, low) = two_sum(high, -t);
    (r, L::fma(-k, HALF_PI[2], low - t_error), rounded.to_bits())
}

/// sin(r + low), |r| ≤ π/4.
#[inline(always)]
fn sin_near<L: Level>(r: f64, low: f64) -> f64 {
    let z = r * r;
    let tail = L::fma(-0.5 * z, low, low);
    r + L::fma(z * r, polynomial::<L, _>(&SIN, z), tail)
}

/// [`sin_near`] as a sum of two.
#[inline(always)]
fn sin_sum<L: Level>(r: f64, low: f64) -> (f64, f64) {
    let z = r * r;
    let tail = L::fma(-0.5 * z, low, low);
    fast_two_sum(r, L::fma(z * r, polynomial::<L, _>(&SIN, z), tail))
}

/// cos(r + low), |r| ≤ π/4.
#[inline(always)]
fn cos_near<L: Level>(r: f64, low: f64) -> f64 {
    cos_sum::<L>(r, low).0
}

/// [`cos_near`] as a sum of two.
#[inline(always)]
fn cos_sum<L: Level>(r: f64, low: f64) -> (f64, f64) {
    let z = r * r;
    let half = 0.5 * z;
    let w = 1.0 - half;
    let z_error = L::fma(r, r, -z);
    let tail = L::fma(-r, low, -0.5 * z_error);
    fast_two_sum(w, ((1.0 - w) - half) + L::fma(z * z, polynomial::<L, _>(&COS, z), tail))
}

/// sine and cosine of |a| > [`REDUCIBLE`]; the same bits at every level.
#[cold]
#[inline(never)]
pub fn sin_cos_of_large(a: f64) -> (f64, f64) {
    if !a.is_finite() {
        return (f64::NAN, f64::NAN);
    }
    let (r, low, quadrant) = reduce_large(a.abs());
    let (s, c) = turn::<Portable>(r, low, quadrant);
    (if a < 0.0 { -s } else { s }, c)
}

/// tangent of |a| > [`REDUCIBLE`]; the same bits at every level.
#[cold]
#[inline(never)]
pub fn tan_of_large(a: f64) -> f64 {
    if !a.is_finite() {
        return f64::NAN;
    }
    let (r, low, quadrant) = reduce_large(a.abs());
    let t = quotient::<Portable>(r, low, quadrant);
    if a < 0.0 { -t } else { t }
}

/// (r, low, k): a = r + low + k·π/2 for finite a ≥ 2^20. a·2/π modulo 4 needs only the bits of 2/π that weigh
/// from 2^1 to 2^-190 after the product; what is cut off is below 2^-137.
fn reduce_large(a: f64) -> (f64, f64, u64) {
    let bits = a.to_bits();
    let mantissa = (bits & ((1 << 52) - 1)) | 1 << 52;
    let exponent = (bits >> 52) as i64 - 1075;
    let window = two_over_pi(exponent - 2);
    let turns = times(window, mantissa);
    // The top two bits are the quadrant; the rest, read as signed, is the fraction to the nearest one.
    let half_up = (turns[0] >> 61) & 1;
    let quadrant = (turns[0] >> 62) + half_up;
    let fraction = shifted_left(turns, 2);
    let negative = half_up == 1;
    let magnitude = if negative { negated(fraction) } else { fraction };
    let zeros = magnitude[0].leading_zeros().min(63);
    let digits = shifted_left(magnitude, zeros);
    let scale = f64::from_bits(u64::from(1023 - 53 - zeros) << 52);
    let high = (digits[0] >> 11) as f64 * scale;
    let low = ((digits[0] << 53) | (digits[1] >> 11)) as f64 * (scale * f64::from_bits((1023 - 64) << 52));
    let (r, low) = product::<Portable>((high, low), (HALF_PI[0], HALF_PI[1]));
    if negative { (-r, -low, quadrant) } else { (r, low, quadrant) }
}

/// 192 bits of 2/π from the given place after the binary point on (zeros before it).
fn two_over_pi(from: i64) -> [u64; 3] {
    let word = |i: i64| if i < 0 { 0 } else { TWO_OVER_PI.get(i as usize).copied().unwrap_or(0) };
    let (first, shift) = (from.div_euclid(64), from.rem_euclid(64) as u32);
    let four = [word(first), word(first + 1), word(first + 2), word(first + 3)];
    std::array::from_fn(|i| {
        let next = if shift == 0 { 0 } else { four[i + 1] >> (64 - shift) };
        (four[i] << shift) | next
    })
}

/// The low 192 bits of a product, most significant word first.
fn times(window: [u64; 3], factor: u64) -> [u64; 3] {
    let wide = |w: u64| u128::from(w) * u128::from(factor);
    let low = wide(window[2]);
    let middle = wide(window[1]) + (low >> 64);
    let high = wide(window[0]) + (middle >> 64);
    [high as u64, middle as u64, low as u64]
}

fn shifted_left(words: [u64; 3], shift: u32) -> [u64; 3] {
    if shift == 0 {
        return words;
    }
    let carry = 64 - shift;
    [(words[0] << shift) | (words[1] >> carry), (words[1] << shift) | (words[2] >> carry), words[2] << shift]
}

fn negated(words: [u64; 3]) -> [u64; 3] {
    let (low, borrow) = 0u64.overflowing_sub(words[2]);
    let (middle, borrow) = {
        let (m, b) = 0u64.overflowing_sub(words[1]);
        let (m, c) = m.overflowing_sub(u64::from(borrow));
        (m, b || c)
    };
    [0u64.wrapping_sub(words[0]).wrapping_sub(u64::from(borrow)), middle, low]
}
