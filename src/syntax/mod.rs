//! Text → tree, by nom.
//!
//! In: a program's texts. Out: its [`ast::Program`], and all its errors and notes at once. Parsing never
//! panics and never nests deeper than its limit; it knows nothing later than [`crate::diag`].
//!
//! The way: `lexer` makes words, `outline` finds where statements end, `heads` what each of them is and names,
//! `names` what the names of all of them mean; then `statement`, `attributes`, `expression` and `operand` read each
//! statement, with `notes` and `misfit` for what is to be said about it. [`functions`] is the table of functions.
//!
//! ```
//! use implicit::{diag::SourceId, syntax};
//! let parsed = syntax::parse(&[(SourceId(0), "R = 1.5; x^2 + y^2 + z^2 = R^2")]);
//! assert!(parsed.diagnostics.is_empty());
//! assert_eq!(parsed.program.statements.len(), 2);
//! ```

pub mod ast;
mod attributes;
mod expression;
pub mod functions;
mod heads;
mod letters;
mod lexer;
mod misfit;
mod names;
mod notes;
mod operand;
mod outline;
pub mod print;
mod reader;
mod statement;
mod token;

pub use names::{CONSTANTS, READY};
pub use reader::MAX_NESTING;
pub use statement::MAX_PARAMETERS;

use crate::diag::{Diagnostic, Severity, SourceId, Span};
use ast::{Program, StatementKind};
use names::{Names, Outline};
use reader::Report;

/// A program text has at most so many bytes: a thousand times the longest written by hand.
pub const MAX_TEXT: usize = 1 << 20;

/// So many errors of a program, and so many notes, are reported; of more only the number.
pub const MAX_REPORTED: usize = 100;

/// A program as far as it could be read, and what is to be said about it.
#[derive(Clone, Debug, Default)]
pub struct Parsed {
    /// The tree; [`ast::ExprKind::Invalid`] stands for what could not be read.
    pub program: Program,
    /// Errors and notes, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
}

impl Parsed {
    /// Whether there is an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }
}

/// Reads texts as one program: a name declared in one is known in all.
///
/// Texts longer than [`MAX_TEXT`] are refused. Included files are not read here: give their texts along.
pub fn parse(texts: &[(SourceId, &str)]) -> Parsed {
    let mut report = Report::default();
    let mut lists = Vec::new();
    for &(source, text) in texts {
        if text.len() > MAX_TEXT {
            let message = format!("this program has {} bytes; the limit is {MAX_TEXT}", text.len());
            report.diagnostics.push(Diagnostic::error(Span::new(source, 0, 0), message));
            continue;
        }
        let tokens = lexer::tokens(source, text, &mut report.diagnostics);
        lists.extend(outline::statements(&tokens).into_iter().map(|words| (text, words)));
    }
    let mut outlines: Vec<Outline<'_>> =
        lists.iter().map(|(text, words)| Outline { text, words, head: heads::head(words, text) }).collect();
    let names: Names = names::declare(&mut outlines);
    let statements = outlines.iter().map(|outline| statement::statement(outline, &names, &mut report)).collect();
    Parsed { program: Program { statements }, diagnostics: limited(report.diagnostics) }
}

/// The files that a text includes, with the places of their names, for who loads them.
pub fn includes(source: SourceId, text: &str) -> Vec<(String, Span)> {
    let parsed = parse(&[(source, text)]);
    let path = |statement: ast::Statement| match statement.kind {
        StatementKind::Include { path, path_span } => Some((path, path_span)),
        _ => None,
    };
    parsed.program.statements.into_iter().filter_map(path).collect()
}

/// Messages in the order of the text, those beyond the limit replaced by their number.
fn limited(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    diagnostics.sort_by_key(|diagnostic| diagnostic.span());
    let (errors, notes): (Vec<_>, Vec<_>) = diagnostics.into_iter().partition(Diagnostic::is_error);
    let mut kept = Vec::new();
    for (mut list, severity, word) in [(errors, Severity::Error, "errors"), (notes, Severity::Note, "notes")] {
        let more = list.len().saturating_sub(MAX_REPORTED);
        let place = list.get(MAX_REPORTED).map(Diagnostic::span);
        list.truncate(MAX_REPORTED);
        if let Some(place) = place {
            list.push(Diagnostic { severity, ..Diagnostic::note(place, format!("and {more} more {word}")) });
        }
        kept.append(&mut list);
    }
    kept.sort_by_key(|diagnostic| diagnostic.span());
    kept
}

#[cfg(test)]
mod tests;
