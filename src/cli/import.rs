//! `implicit import`: the program that draws a picture again.
//!
//! In: a PNG file that this program wrote. Out: the program on standard output.

use super::args::ImportArgs;
use super::complaint::Complaint;
use super::{console, output};
use crate::film::png;
use crate::film::size::MAX_PIXELS;
use std::fs::File;
use std::io::Read;

/// The keyword under which a picture keeps the program that draws it.
pub const KEYWORD: &str = "implicit program";

/// The largest file that is read: eight bytes for each pixel of the largest picture.
const MAX_BYTES: u64 = MAX_PIXELS * 8;

/// Prints the program.
///
/// # Errors
/// If the file cannot be read or carries none.
pub fn run(args: &ImportArgs) -> Result<(), Complaint> {
    let fail = |why: &str| Complaint::program(format!("cannot import '{}': {why}", output::shown(&args.picture)));
    let read = || {
        let file = File::open(&args.picture)?;
        if file.metadata()?.is_dir() {
            return Err(std::io::Error::from(std::io::ErrorKind::IsADirectory));
        }
        let mut bytes = Vec::new();
        file.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
        Ok(bytes)
    };
    let bytes = read().map_err(|error| fail(&console::reason(&error)))?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(fail("it is larger than any picture"));
    }
    match png::note(&bytes, KEYWORD) {
        Ok(Some(text)) => console::print(clean(&text).as_bytes()),
        Ok(None) => Err(fail("it carries no program; pictures do that implicit wrote and nothing changed since")),
        Err(png::ReadError::NotPng) => Err(fail("it is no PNG file; only those carry their program")),
        Err(error) => Err(fail(&error.to_string())),
    }
}

/// The text with line ends and tabs as its only control characters, so that it does nothing to a terminal.
fn clean(text: &str) -> String {
    text.chars().map(|c| if c.is_control() && !matches!(c, '\n' | '\t') { '\u{fffd}' } else { c }).collect()
}
