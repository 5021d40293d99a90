//! Text → tree, by nom.
//!
//! In: a program's text. Out: its [`ast::Program`], and all its errors and notes at once. Parsing never
//! panics and never nests deeper than its limit; it knows nothing later than [`crate::diag`].

pub mod ast;
