//! Type an equation and see its surface, exactly.
#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests compare with the functions of std"))]

pub mod cli;
pub mod closure;
pub mod diag;
pub mod expr;
pub mod film;
pub mod num;
pub mod render;
pub mod scene;
pub mod session;
pub mod surface;
pub mod syntax;
