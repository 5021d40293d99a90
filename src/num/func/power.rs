//! Powers and roots.
//!
//! In: a base and an exponent. Out: the power. a^b = e^(b·ln a) with the logarithm as a sum of two; whole
//! powers by repeated squaring of a sum of two, so that even a^1000000 is right to the last place.

use super::double_double::{fast_two_sum, two_product};
use super::exponential::exp_scaled;
use super::logarithm::ln_sum;
use crate::num::level::Level;

/// Exponents of e beyond this overflow or vanish whatever their low part says.
const DECIDED: f64 = 800.0;

/// a^b for a > 0, or a = 0 and b > 0; NaN else.
#[inline(always)]
pub fn pow<L: Level>(a: f64, b: f64) -> f64 {
    let (h, l) = ln_sum::<L>(a, 0.0, 0.0);
    let (p, e) = two_product::<L>(b, h);
    let low = L::fma(b, l, e);
    let low = if p.abs() < DECIDED { low } else { 0.0 };
    let value = exp_scaled::<L>(p, low, 0.0);
    let zero = if b > 0.0 { 0.0 } else { f64::NAN };
    let value = if a < f64::INFINITY { value } else { f64::NAN };
    if a > 0.0 {
        value
    } else if a == 0.0 {
        zero
    } else {
        f64::NAN
    }
}

/// The real root of odd order n ≥ 3, for every a.
#[inline(always)]
pub fn root<L: Level>(a: f64, n: u32) -> f64 {
    let n = f64::from(n);
    let x = a.abs();
    let (h, l) = ln_sum::<L>(x, 0.0, 0.0);
    let q = h / n;
    let q_low = (L::fma(-q, n, h) + l) / n;
    let value = exp_scaled::<L>(q, q_low, 0.0);
    let finite = if x < f64::INFINITY { value } else { x };
    if x > 0.0 { finite.copysign(a) } else { a }
}

/// a^n for n ≠ 0; NaN for a = 0 and n < 0. The same n for a whole loop: its branches are decided outside.
#[inline(always)]
pub fn power<L: Level>(a: f64, n: i64) -> f64 {
    let base = if n < 0 { reciprocal::<L>(a) } else { (a, 0.0) };
    let mut square = base;
    let mut rest = n.unsigned_abs();
    while rest & 1 == 0 && rest > 0 {
        square = times::<L>(square, square);
        rest >>= 1;
    }
    let mut value = square;
    rest >>= 1;
    while rest > 0 {
        square = times::<L>(square, square);
        if rest & 1 == 1 {
            value = times::<L>(value, square);
        }
        rest >>= 1;
    }
    value.0
}

/// 1/a as a sum of two; NaN for 0.
#[inline(always)]
pub(in crate::num) fn reciprocal<L: Level>(a: f64) -> (f64, f64) {
    let q = 1.0 / a;
    let low = L::fma(-q, a, 1.0) * q;
    let low = if low.abs() < f64::INFINITY { low } else { 0.0 };
    (if a == 0.0 { f64::NAN } else { q }, low)
}

/// (ah + al) · (bh + bl), the low part dropped where the product overflows.
#[inline(always)]
pub(in crate::num) fn times<L: Level>(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let (p, e) = two_product::<L>(a.0, b.0);
    let low = e + L::fma(a.0, b.1, a.1 * b.0);
    fast_two_sum(p, if low.abs() < f64::INFINITY { low } else { 0.0 })
}
