//! Natural, binary and decimal logarithms.
//!
//! In: a positive f64, or an unevaluated sum of two. Out: the logarithm, inside this folder as an unevaluated
//! sum of two with a relative error of about 2^-63. ln m = 2·artanh((m − 1)/(m + 1)) (Muller, Elementary
//! Functions, 3rd ed., section 11.4), the leading terms with their rounding errors.

use super::coefficients::{LN, LN_2, LOG2_E, LOG10_2, LOG10_E, TWO_THIRDS};
use super::double_double::{fast_two_sum, product, two_product};
use super::polynomial;
use crate::num::level::Level;

/// The bits of √½, rounded: m is taken between it and twice it.
const SQRT_HALF: u64 = 0x3fe6_a09e_667f_3bcd;

/// Natural logarithm, a > 0.
#[inline(always)]
pub fn ln<L: Level>(a: f64) -> f64 {
    let (h, l) = ln_sum::<L>(a, 0.0, 0.0);
    positive_only(a, h + l)
}

/// Logarithm to base 2, a > 0.
#[inline(always)]
pub fn log2<L: Level>(a: f64) -> f64 {
    let (k, h, l) = reduce::<L>(a, 0.0);
    let (p, e) = product::<L>((h, l), (LOG2_E[0], LOG2_E[1]));
    let (s, t) = fast_two_sum(k, p);
    positive_only(a, s + (t + e))
}

/// Logarithm to base 10, a > 0.
#[inline(always)]
pub fn log10<L: Level>(a: f64) -> f64 {
    let (k, h, l) = reduce::<L>(a, 0.0);
    let (p, e) = product::<L>((h, l), (LOG10_E[0], LOG10_E[1]));
    let (q, f) = two_product::<L>(k, LOG10_2[0]);
    let (s, t) = fast_two_sum(q, p);
    positive_only(a, s + (t + (e + L::fma(k, LOG10_2[1], f))))
}

/// The value where a is positive, infinity with a, else NaN.
#[inline(always)]
fn positive_only(a: f64, value: f64) -> f64 {
    let finite = if a < f64::INFINITY { value } else { a };
    if a > 0.0 { finite } else { f64::NAN }
}

/// ln(h + l) + k·ln 2 as a sum of two, |l| below an ulp of h > 0; l = 0 when h is below 2^-900 or above 2^900.
#[inline(always)]
pub(super) fn ln_sum<L: Level>(h: f64, l: f64, k: f64) -> (f64, f64) {
    let (exponent, m, rest) = reduce::<L>(h, l);
    let k = exponent + k;
    let (p, e) = two_product::<L>(k, LN_2[0]);
    let (s, t) = fast_two_sum(p, m);
    fast_two_sum(s, t + (rest + L::fma(k, LN_2[1], e)))
}

/// (k, s, t): ln(h + l) = k·ln 2 + s + t, √½ ≤ (h + l)/2^k < √2.
#[inline(always)]
fn reduce<L: Level>(h: f64, l: f64) -> (f64, f64, f64) {
    let subnormal = h < f64::MIN_POSITIVE;
    let scaled = h * 18014398509481984.0;
    let bits = if subnormal { scaled } else { h }.to_bits();
    let offset = bits.wrapping_sub(SQRT_HALF);
    let power = offset & 0xfff0_0000_0000_0000;
    // The biased exponent becomes a f64 by the bits of 2^52, for AVX2 converts no 64-bit whole numbers.
    let biased = f64::from_bits(((offset ^ (1 << 63)) >> 52) | 0x4330_0000_0000_0000);
    let k = biased - (4503599627370496.0 + 2048.0) - if subnormal { 54.0 } else { 0.0 };
    let m = f64::from_bits(bits.wrapping_sub(power));
    let scaled_low = l * f64::from_bits((1023_u64 << 52).wrapping_sub(power));
    let low = if l == 0.0 { 0.0 } else { scaled_low };
    let (s, t) = twice_artanh::<L>(m - 1.0, low);
    (k, s, t)
}

/// ln(1 + f + low) for −0.3 < f < 0.42, f exact, |low| below 2^-50.
#[inline(always)]
fn twice_artanh<L: Level>(f: f64, low: f64) -> (f64, f64) {
    let (d, e) = fast_two_sum(2.0, f);
    let reciprocal = 1.0 / d;
    let s = f * reciprocal;
    let t = ((L::fma(-s, d, f) + low) - s * (e + low)) * reciprocal;
    let (w, w_error) = two_product::<L>(s, s);
    let w_low = L::fma(2.0 * s, t, w_error);
    let q = w * polynomial::<L, _>(&LN, w);
    let (c, c_error) = fast_two_sum(TWO_THIRDS[0], q);
    let (u, u_error) = two_product::<L>(w, c);
    let u_low = u_error + L::fma(w, c_error + TWO_THIRDS[1], w_low * c);
    let (v, v_error) = two_product::<L>(s, u);
    let v_low = v_error + L::fma(s, u_low, t * u);
    let (high, rest) = fast_two_sum(2.0 * s, v);
    (high, rest + L::fma(2.0, t, v_low))
}
