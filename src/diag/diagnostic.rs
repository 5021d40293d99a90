//! What is said about a place: an error or a note, its labels and the way out.

use super::source::Span;

/// How grave a diagnostic is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The program cannot be used as it is.
    Error,
    /// It can, and this is how it was read.
    Note,
}

/// A place and a few words about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// The words beside the carets; may be empty.
    pub text: String,
}

/// One message. Lower case, no final dot, in the words of the person who typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Error or note.
    pub severity: Severity,
    /// The headline: what is wrong, or what was read.
    pub message: String,
    /// The main place first, then others (where the bracket stood open, the first definition).
    pub labels: Vec<Label>,
    /// The way out, if there is one: a corrected line or "did you mean".
    pub help: Option<String>,
}
