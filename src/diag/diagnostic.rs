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

impl Diagnostic {
    /// An error at a place; the words beside the carets and the way out may follow.
    ///
    /// ```
    /// use implicit::diag::{Diagnostic, Span};
    /// let error = Diagnostic::error(Span::default(), "unknown name `a`").label("not defined").help("write x");
    /// assert_eq!(error.labels[0].text, "not defined");
    /// ```
    pub fn error(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, span, message.into())
    }

    /// A note at a place: how something was read.
    pub fn note(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Note, span, message.into())
    }

    fn new(severity: Severity, span: Span, message: String) -> Self {
        Diagnostic { severity, message, labels: vec![Label { span, text: String::new() }], help: None }
    }

    /// The same with words beside the carets of the main place.
    pub fn label(mut self, text: impl Into<String>) -> Self {
        if let Some(first) = self.labels.first_mut() {
            first.text = text.into();
        }
        self
    }

    /// The same with one more place.
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// The same with a way out.
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }

    /// Whether it is an error.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }

    /// The main place.
    pub fn span(&self) -> Span {
        self.labels.first().map(|label| label.span).unwrap_or_default()
    }
}
