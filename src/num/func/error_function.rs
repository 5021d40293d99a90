//! The error function.
//!
//! In: an f64. Out: erf a. A polynomial up to 1; beyond, 1 − erfc with erfc = e^(−x²)·p((x − c)/(x + c))
//! (Shepherd and Laframboise, Math. Comp. 36 (1981) 249).

use super::coefficients::{ERF, ERFC};
use super::exponential::exp_scaled;
use super::polynomial;
use crate::num::level::Level;

/// From here on 1 − erf is below half an ulp of 1.
const SATURATED: f64 = 6.0;

/// The centre of the substitution, as in the script that made [`ERFC`].
const CENTRE: f64 = 2.4375;

/// error function
#[inline(always)]
pub fn erf<L: Level>(a: f64) -> f64 {
    let x = a.abs();
    let x = if x > SATURATED { SATURATED } else { x };
    let z = x * x;
    let near = L::fma(x, polynomial::<L, _>(&ERF, z), x);
    let t = (x - CENTRE) / (x + CENTRE);
    let complement = exp_scaled::<L>(-z, -L::fma(x, x, -z), 0.0) * polynomial::<L, _>(&ERFC, t);
    let far = 1.0 - complement;
    if x < 1.0 { near } else { far }.copysign(a)
}
