//! Pages, in the form that is wanted.
//!
//! In: a page, and the same as JSON. Out: text on standard output or a file.

use super::args::teaching::PageArgs;
use super::complaint::Complaint;
use super::console;
use super::output::{self, Outputs};
use crate::teach::page::{Page, html, latex, markdown, plain};
use std::path::Path;

/// Writes a page.
///
/// # Errors
/// If there is no figure where one is wanted, or the file cannot be written.
pub fn deliver(page: &Page, json: impl FnOnce() -> serde_json::Value, args: &PageArgs) -> Result<(), Complaint> {
    let text = if args.json {
        format!("{}\n", json())
    } else if args.html {
        html::document(page, &args.language, "")
    } else if args.markdown {
        markdown::write(page)
    } else if args.latex {
        latex::write(page)
    } else if args.svg {
        let figure = page.figures().next();
        format!("{}\n", figure.ok_or_else(|| Complaint::program("there is no figure to write as SVG"))?)
    } else {
        plain::write(page)
    };
    match &args.output {
        Some(path) => file(path, text.into_bytes()),
        None => console::print(text.as_bytes()),
    }
}

/// Refuses a file that cannot be written, before any work is done for it.
///
/// # Errors
/// Why not.
pub fn check(args: &PageArgs) -> Result<(), Complaint> {
    args.output.as_deref().map_or(Ok(()), output::check)
}

fn file(path: &Path, bytes: Vec<u8>) -> Result<(), Complaint> {
    let mut outputs = Outputs::default();
    outputs.stage(path, bytes)?;
    outputs.commit()
}
