//! Transport of light: what the modes that follow whole paths are made of.
//!
//! - [`bsdf`]: how a point of a surface scatters.
//! - [`sobol`]: the numbers that choose.

pub mod bsdf;
pub mod sobol;
