//! The mathematics, shown.
//!
//! In: a formula, a ray, a scene. Out: pages: how a formula is derived by the rules of a first course, what a surface is, what
//! a step along a ray misses and an interval does not, what a picture costs. Nothing here prints or touches a file.
//!
//! - [`texts`]: every sentence, one file a language.
//! - [`page`]: headings, formulas, tables, figures, for a terminal, Markdown, LaTeX and HTML; [`svg`]: line drawings.
//! - [`term`], [`mod@notation`]: a formula as a person writes it, and how it is set.
//! - [`derivation`]: derivatives step by step, by [`rules`] and the habits of [`shorten`].
//! - [`classify`]: what a surface is; [`quadric`], [`bounds`]; [`substitute`]: mirror images, turns, rays.
//! - [`drawing`], [`evaluation`]: the graph of a formula, and what runs.
//! - [`mod@explain`]: all of that as one page.
//! - [`ray`]: one ray, told. - [`mod@compare`]: what steps, samples and objects cost and change.
//! - [`lessons`]: all of it in order, for a first course.
//! - [`chance`]: points at which formulas are compared.

pub mod bounds;
pub mod chance;
pub mod classify;
pub mod compare;
pub mod derivation;
pub mod drawing;
pub mod evaluation;
pub mod explain;
pub mod lessons;
pub mod notation;
pub mod page;
pub mod quadric;
pub mod ray;
pub mod rules;
pub mod shorten;
pub mod substitute;
pub mod svg;
pub mod term;
pub mod texts;
