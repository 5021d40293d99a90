//! Hyperbolic functions and their inverses.
//!
//! In: an f64. Out: the value. By e^|a| or a polynomial near 0; the inverses as logarithms whose argument keeps
//! its rounding error (Muller, Elementary Functions, 3rd ed., section 11.7).

use super::coefficients::SINH;
use super::double_double::{fast_two_sum, sqrt, two_product, two_sum};
use super::exponential::exp_scaled;
use super::logarithm::ln_sum;
use super::polynomial;
use crate::num::level::Level;

/// Below, the first terms of the series are exact to the last place.
const SMALL: f64 = 1e-4;

/// Above, a² would overflow and 2·a is a ± √(a² ± 1) to the last place.
const LARGE: f64 = 1e150;

/// hyperbolic sine
#[inline(always)]
pub fn sinh<L: Level>(a: f64) -> f64 {
    let x = a.abs();
    let half = exp_scaled::<L>(x, 0.0, -1.0);
    let far = half - 0.25 / half;
    if x < 1.0 { sinh_near::<L>(x) } else { far }.copysign(a)
}

/// hyperbolic cosine
#[inline(always)]
pub fn cosh<L: Level>(a: f64) -> f64 {
    let half = exp_scaled::<L>(a.abs(), 0.0, -1.0);
    half + 0.25 / half
}

/// hyperbolic tangent
#[inline(always)]
pub fn tanh<L: Level>(a: f64) -> f64 {
    let x = a.abs();
    let half = exp_scaled::<L>(x, 0.0, -1.0);
    let near = sinh_near::<L>(x) / (half + 0.25 / half);
    let far = 1.0 - 2.0 / L::fma(4.0 * half, half, 1.0);
    if x < 1.0 { near } else { far }.copysign(a)
}

/// sinh x for 0 ≤ x ≤ 1.
#[inline(always)]
fn sinh_near<L: Level>(x: f64) -> f64 {
    let z = x * x;
    L::fma(x * z, polynomial::<L, _>(&SINH, z), x)
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
