//! Graph → closures: a formula as something that runs.
//!
//! In: nodes of a [`crate::expr::graph::Graph`]. Out: functions of points, of batches of 64 points, of
//! intervals. One builder serves every number type; sharing in the graph is sharing in the result.
//!
//! - [`tape`]: the nodes of some formulas as a list of steps over registers.
//! - `fuse`: which of them are computed in one step.
//! - [`kernel`]: the tape as a list of closures over one [`crate::num::number::Number`] type; what runs in the tracer.
//! - [`constant`]: subexpressions without variables, computed once.
//! - [`tree`]: the formula as a tree of closures of one point, as a first course writes it: the reference.
//! - [`pieces`]: one enclosure at a time, with jumps and poles taken apart.
//! - [`shorten`]: so much of a list of steps as some part of space needs.
//! - [`specialise`]: which arguments of minima and maxima, and which branches, matter in a part of space.
//! - [`formula`]: one formula with its value, gradient and enclosure, for whoever wants a single number.

mod constant;
pub mod formula;
mod fuse;
pub mod kernel;
pub mod pieces;
pub mod shorten;
pub mod specialise;
pub mod tape;
pub mod tree;

pub use formula::Formula;
pub use kernel::{Excerpt, Kernel};
pub use tape::Tape;
