//! What the language reads, says and refuses, as tables.

use super::{Parsed, parse, print};
use crate::diag::{Diagnostic, SourceId, Sources};

mod errors;
mod hostile;
mod notes;
mod readings;
mod roundtrip;

/// A program of one text, read.
fn read(text: &str) -> Parsed {
    parse(&[(SourceId(0), text)])
}

/// The fully bracketed readings of all statements.
fn readings(parsed: &Parsed) -> Vec<String> {
    parsed.program.statements.iter().map(print::bracketed_statement).collect()
}

/// The errors of a program.
fn errors(parsed: &Parsed) -> Vec<&Diagnostic> {
    parsed.diagnostics.iter().filter(|diagnostic| diagnostic.is_error()).collect()
}

/// The notes of a program.
fn notes(parsed: &Parsed) -> Vec<&Diagnostic> {
    parsed.diagnostics.iter().filter(|diagnostic| !diagnostic.is_error()).collect()
}

/// Line and column where a diagnostic points in a program of one text.
fn place(text: &str, diagnostic: &Diagnostic) -> (usize, usize) {
    let mut sources = Sources::new();
    sources.add("test", text);
    let position = sources.position(diagnostic.span());
    (position.line, position.column)
}
