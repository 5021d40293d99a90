//! Hyperbolic functions and their inverses.
//!
//! In: an f64. Out: the value. By e^|a| or a polynomial near 0; the inverses as logarithms whose argument keeps
//! its rounding error (Muller, Elementary Functions, 3rd ed., section 11.7).

use super::coefficients::SINH;
use super::double_double::{fast_two_sum, sqrt, two_product, two_sum};
use super::exponential::exp_sum;
use super::logarithm::ln_sum;
use super::polynomial;
use crate::num::level::Level;

/// Below, the first terms of the series are exact to the last place.
const SMALL: f64 = 1e-4;

/// Above, a² would overflow and 2·a is a ± √(a² ± 1) to the last place.
const LARGE: f64 = 1e150;

/// From here on tanh is 1 to the last place.
const SATURATED: f64 = 40.0;

/// hyperbolic sine
#[inline(always)]
pub fn sinh<L: Level>(a: f64) -> f64 {
    let x = a.abs();
    let (half, low) = exp_sum::<L>(x, -1.0);
    let (q, q_low) = quarter_over::<L>(half, low);
    let (s, e) = fast_two_sum(half, -q);
    let far = s + (e + (low - q_low));
    let far = if half < f64::INFINITY { far } else { half };
    let (near, rest) = sinh_near::<L>(x);
    if x < 1.0 { near + rest } else { far }.copysign(a)
}

/// hyperbolic cosine
#[inline(always)]
pub fn cosh<L: Level>(a: f64) -> f64 {
    let (half, low) = exp_sum::<L>(a.abs(), -1.0);
    let (q, q_low) = quarter_over::<L>(half, low);
    let (s, e) = fast_two_sum(half, q);
    let value = s + (e + (low + q_low));
    if half < f64::INFINITY { value } else { half }
}

/// hyperbolic tangent
#[inline(always)]
pub fn tanh<L: Level>(a: f64) -> f64 {
    let x = a.abs();
    let x = if x > SATURATED { SATURATED } else { x };
    let (half, low) = exp_sum::<L>(x, -1.0);
    let (q, q_low) = quarter_over::<L>(half, low);
    let (c, c_low) = fast_two_sum(half, q);
    let (far, far_low) = fast_two_sum(half, -q);
    let (near, near_low) = sinh_near::<L>(x);
    let s = if x < 1.0 { near } else { far };
    let s_low = if x < 1.0 { near_low } else { far_low + (low - q_low) };
    let t = s / c;
    let value = t + (L::fma(-t, c, s) + (s_low - t * (c_low + (low + q_low)))) / c;
    value.copysign(a)
}

/// 1/(4·(half + low)) as a sum of two.
#[inline(always)]
fn quarter_over<L: Level>(half: f64, low: f64) -> (f64, f64) {
    let q = 0.25 / half;
    (q, (L::fma(-q, half, 0.25) - q * low) * (4.0 * q))
}

/// sinh x for 0 ≤ x ≤ 1, as a sum of two.
#[inline(always)]
fn sinh_near<L: Level>(x: f64) -> (f64, f64) {
    let z = x * x;
    fast_two_sum(x, x * z * polynomial::<L, _>(&SINH, z))
}

/// inverse hyperbolic sine
#[inline(always)]
pub fn asinh<L: Level>(a: f64) -> f64 {
    let x = a.abs();
    let large = x > LARGE;
    let (square, square_low) = two_product::<L>(x, x);
    let (h, l) = two_sum(square, 1.0);
    let (s, s_low) = sqrt::<L>(h, l + square_low);
    let (sum, rest) = two_sum(x, s);
    let argument = if large { x } else { sum };
    let low = if large { 0.0 } else { rest + s_low };
    let (value, value_low) = ln_sum::<L>(argument, low, if large { 1.0 } else { 0.0 });
    let near = L::fma(x * square, L::fma(square, 3.0 / 40.0, -1.0 / 6.0), x);
    let far = value + value_low;
    let finite = if x < SMALL { near } else { far };
    if x == f64::INFINITY { x } else { finite }.copysign(a)
}

/// inverse hyperbolic cosine, a ≥ 1
#[inline(always)]
pub fn acosh<L: Level>(a: f64) -> f64 {
    let large = a > LARGE;
    let (square, square_low) = two_product::<L>(a, a);
    let (d, d_low) = two_sum(square, -1.0);
    let (h, l) = fast_two_sum(d, d_low + square_low);
    let (s, s_low) = sqrt::<L>(h, l);
    let s_low = if h > 0.0 { s_low } else { 0.0 };
    let (sum, rest) = fast_two_sum(a, s);
    let argument = if large { a } else { sum };
    let low = if large { 0.0 } else { rest + s_low };
    let (value, value_low) = ln_sum::<L>(argument, low, if large { 1.0 } else { 0.0 });
    let finite = if a == f64::INFINITY { a } else { value + value_low };
    if a >= 1.0 { finite } else { f64::NAN }
}

/// inverse hyperbolic tangent, |a| < 1
#[inline(always)]
pub fn atanh<L: Level>(a: f64) -> f64 {
    let x = a.abs();
    let (n, n_low) = fast_two_sum(1.0, x);
    let (d, d_low) = fast_two_sum(1.0, -x);
    let q = n / d;
    let q_low = (L::fma(-q, d, n) + (n_low - q * d_low)) / d;
    let (value, value_low) = ln_sum::<L>(q, q_low, 0.0);
    let z = x * x;
    let near = L::fma(x * z, L::fma(z, 1.0 / 5.0, 1.0 / 3.0), x);
    let far = 0.5 * (value + value_low);
    let inside = if x < SMALL { near } else { far };
    if x < 1.0 { inside.copysign(a) } else { f64::NAN }
}
