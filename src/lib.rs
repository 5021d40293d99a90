//! Type an equation and see its surface, exactly.

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
