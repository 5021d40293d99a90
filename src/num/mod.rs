//! Ground: numbers that know no formula.
//!
//! In: numbers. Out: numbers, with a promise of how exact they are.
//!
//! - [`level`]: which instructions the machine has; the one macro that compiles a function for each.
//! - [`fused`]: a·b + c with one rounding, in software where the hardware has none.
//! - [`func`]: the only home of sin, exp, pow…: for one number, branch-free so that loops over arrays vectorise.
//! - [`number`]: what a number type must be able to do to be computed with by closures.
//! - [`lanes`]: a fixed-size array of f64.
//! - [`interval`]: one interval, rounded outward, with what is known of the function on it.
//! - [`interval_lanes`]: a fixed-size array of those.
//! - [`affine_lanes`]: a fixed-size array of affine forms: enclosures that know how they lean.
//! - [`ball_lanes`]: a fixed-size array of balls: points that know how far they are off.
//! - [`rational`]: exact fractions, and the f64 and the interval nearest to one.

// Comparisons are negated where NaN has to fall to the side that decides nothing.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

pub mod affine_lanes;
pub mod ball_lanes;
pub mod func;
pub mod fused;
pub mod interval;
pub mod interval_lanes;
pub mod lanes;
pub mod level;
mod mask;
pub mod number;
pub mod rational;
#[cfg(test)]
mod speed;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod trial;
