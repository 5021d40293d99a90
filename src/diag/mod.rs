//! Ground: how the program speaks to the person who typed something.
//!
//! In: places in texts ([`Span`], [`Sources`]) and what is to be said about them
//! ([`Diagnostic`]). Out: the message, drawn with its line and carets.
//! Separate because every stage reports in this one form and none of them prints.

pub mod diagnostic;
pub mod source;

pub use diagnostic::{Diagnostic, Label, Severity};
pub use source::{Source, SourceId, Sources, Span};
