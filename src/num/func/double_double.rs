//! Sums and products with their rounding errors.
//!
//! In: two f64. Out: the rounded result and what it lacks (Dekker, Numer. Math. 18 (1971) 224; Knuth, TAOCP 2,
//! section 4.2.2). Separate because every function that must be better than one rounding builds on it.

use crate::num::level::Level;

/// a + b and its error, for any a, b.
#[inline(always)]
pub(super) fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// a + b and its error, for |a| ≥ |b| or a = 0.
#[inline(always)]
pub(super) fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    (s, (a - s) + b)
}

/// a · b and its error, where the error is not below 2^-1074.
#[inline(always)]
pub(super) fn two_product<L: Level>(a: f64, b: f64) -> (f64, f64) {
    let p = a * b;
    (p, L::fma(a, b, -p))
}

/// √(h + l) to about twice the precision, h > 0.
#[inline(always)]
pub(super) fn sqrt<L: Level>(h: f64, l: f64) -> (f64, f64) {
    let s = h.sqrt();
    (s, (L::fma(-s, s, h) + l) / (2.0 * s))
}

/// (ah + al) · (bh + bl) to about twice the precision.
#[inline(always)]
pub(super) fn product<L: Level>(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let (p, e) = two_product::<L>(a.0, b.0);
    fast_two_sum(p, e + L::fma(a.0, b.1, a.1 * b.0))
}
