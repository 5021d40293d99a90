//! Tree → graph: mathematics without a number type.
//!
//! In: a program's tree ([`crate::syntax`]). Out: a hash-consed [`graph::Graph`] in which equal
//! subexpressions are one node, its symbolic derivatives, and its equations rewritten so that they
//! are easy to solve. Knows no scene, no pixel, no colour.
//!
//! - [`op`]: THE table of operations.
//! - [`graph`]: the arena; a node is made once.
//! - [`signs`]: which signs a node's values can have.
//! - [`simplify`]: the named rules that every new node goes through; none changes where f is defined.
//! - [`derivative`]: the rule of every operation.
//! - [`curvature`]: normals and curvatures of level sets.
//! - [`polynomial`]: exact polynomials over nodes as letters; square-free parts.
//! - [`nest`]: sums of powers by Horner's rule, for enclosures.
//! - [`equation`]: f = 0 as the sheets whose roots it has.
//! - [`lower`]: names, functions, parameters, lists and regions become nodes.
//! - [`mod@print`]: text that reads back as the same graph, and LaTeX.

pub mod cases;
pub mod curvature;
pub mod derivative;
pub mod equation;
#[cfg(test)]
mod estimate;
#[cfg(test)]
pub(crate) mod formula;
pub mod graph;
pub mod lower;
pub mod nest;
pub mod op;
pub mod polynomial;
pub mod print;
pub mod signs;
pub mod simplify;
