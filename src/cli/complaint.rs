//! Why a command failed: the words, and the exit status.
//!
//! In: what went wrong. Out: the text for standard error, ready to print.

use crate::diag::{Diagnostic, Sources, render};
use std::fmt;

/// Exit statuses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// All done.
    Done = 0,
    /// The program text or a file could not be used.
    Program = 1,
    /// The command line is wrong.
    Usage = 2,
    /// A mistake of ours.
    Fault = 70,
}

/// What to print, and with which status to end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Complaint {
    /// The exit status.
    pub status: Status,
    /// The text, with its line end; empty: nothing to say.
    pub text: String,
}

impl Complaint {
    /// The end without a complaint.
    pub const DONE: Complaint = Complaint { status: Status::Done, text: String::new() };

    /// A text that is complete as it is.
    pub fn worded(status: Status, text: String) -> Self {
        Complaint { status, text }
    }

    /// A program or a file that cannot be used.
    pub fn program(message: impl fmt::Display) -> Self {
        Complaint { status: Status::Program, text: format!("error: {message}\n") }
    }

    /// A wrong command line.
    pub fn usage(message: impl fmt::Display) -> Self {
        Complaint { status: Status::Usage, text: format!("error: {message}\n") }
    }

    /// Errors in a program, drawn at their places.
    pub fn diagnostics(diagnostics: &[Diagnostic], sources: &Sources) -> Self {
        let mut text = render(diagnostics, sources, super::console::has_colour());
        if !text.ends_with('\n') {
            text.push('\n');
        }
        Complaint { status: Status::Program, text }
    }
}
