//! Ground: how the program speaks to the person who typed something.
//!
//! In: places in texts ([`Span`], [`Sources`]) and what is to be said about them
//! ([`Diagnostic`]). Out: the message, drawn with its line and carets ([`render()`]).
//! Separate because every stage reports in this one form and none of them prints.

pub mod diagnostic;
pub mod render;
pub mod source;
pub mod suggest;

pub use diagnostic::{Diagnostic, Label, Severity};
pub use render::{printable, render};
pub use source::{Position, Source, SourceId, Sources, Span};
pub use suggest::{nearest, one_of};
