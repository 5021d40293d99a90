//! Standard output and standard error, which may be closed or full.
//!
//! In: bytes. Out: the same, or a complaint; never a panic.

use super::complaint::{Complaint, Status};
use std::io::{self, ErrorKind, IsTerminal, Write};

/// Says something on standard error; if nobody can hear it, there is nobody to tell.
pub fn say(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Writes to standard output.
///
/// # Errors
/// If it is full. A reader that has had enough is no error for text: the command ends, done.
pub fn print(bytes: &[u8]) -> Result<(), Complaint> {
    let mut out = io::stdout().lock();
    out.write_all(bytes).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => Complaint::DONE,
        _ => Complaint::worded(Status::Program, cannot_write(&error)),
    })
}

/// Writes a whole file to standard output.
///
/// # Errors
/// If it is closed or full.
pub fn print_file(bytes: &[u8]) -> Result<(), Complaint> {
    let mut out = io::stdout().lock();
    out.write_all(bytes)
        .and_then(|()| out.flush())
        .map_err(|error| Complaint::worded(Status::Program, cannot_write(&error)))
}

fn cannot_write(error: &io::Error) -> String {
    format!("error: cannot write to standard output: {}\n", reason(error))
}

/// Whether messages are coloured: on a terminal, unless `NO_COLOR` says otherwise (<https://no-color.org>).
pub fn has_colour() -> bool {
    io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

/// An error of the system in words, without its number.
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or(&text);
    text.chars().next().map_or_else(String::new, |first| first.to_lowercase().chain(text.chars().skip(1)).collect())
}
