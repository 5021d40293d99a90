//! Transport of light: what the modes that follow whole paths are made of.
//!
//! - [`sobol`]: the numbers that choose.

pub mod sobol;
