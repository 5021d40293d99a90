//! Texts to formulas.
//!
//! In: the texts of a program. Out: its graph with the functions of its surfaces, and every error and note about it.

use super::include::{Loader, Texts};
use crate::diag::{Diagnostic, Severity, Sources};
use crate::expr::lower::{Lowered, Setting, Settings, lower};
use crate::syntax::ast::StatementKind;
use crate::syntax::parse;

/// One text as it came in.
#[derive(Clone, Debug)]
pub struct Text {
    /// The name shown in messages.
    pub name: String,
    /// A file's true path; empty for a text that is no file.
    pub key: String,
    /// The text.
    pub text: String,
}

/// A program, read.
#[derive(Clone, Debug)]
pub struct Program {
    /// Its texts, with those that were included.
    pub sources: Sources,
    /// What was set from outside.
    pub set: Vec<Setting>,
    /// Its mathematics.
    pub lowered: Lowered,
    /// Errors and notes; the program can be used if none is an error.
    pub diagnostics: Vec<Diagnostic>,
}

impl Program {
    /// Reads a program of one or several texts that are joined.
    ///
    /// ```
    /// use implicit::session::Program;
    /// let program = Program::from_text("x^2 + y^2 + z^2 = 1");
    /// assert!(program.diagnostics.is_empty());
    /// assert_eq!(program.lowered.surfaces.len(), 1);
    /// ```
    pub fn read(texts: Vec<Text>, set: Vec<Setting>, loader: &dyn Loader) -> Program {
        let mut texts = Texts::new(texts, loader);
        let mut parsed = loop {
            let parsed = parse(&texts.sources.texts());
            if !texts.follow(&parsed.program) {
                break parsed;
            }
        };
        // What is included stands beside these statements by now, or an error says why not.
        parsed.program.statements.retain(|statement| !matches!(statement.kind, StatementKind::Include { .. }));
        let mut diagnostics = parsed.diagnostics;
        diagnostics.append(&mut texts.diagnostics);
        let incomplete = diagnostics.iter().any(|d| d.severity == Severity::Error);
        let settings = Settings { set, incomplete };
        let mut lowered = lower(&parsed.program, &settings);
        diagnostics.append(&mut lowered.diagnostics);
        diagnostics.sort_by_key(Diagnostic::span);
        Program { sources: texts.sources, set: settings.set, lowered, diagnostics }
    }

    /// Reads a program of one text that includes nothing.
    pub fn from_text(text: &str) -> Program {
        let text = Text { name: "<program>".into(), key: String::new(), text: text.into() };
        Program::read(vec![text], Vec::new(), &super::NoFiles)
    }

    /// Whether it cannot be used.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }
}
