//! `implicit check`: reads programs and draws nothing.
//!
//! In: programs. Out: their notes and errors on standard error.

use super::args::CheckArgs;
use super::complaint::Complaint;
use super::{eval, programs};

/// Checks the programs.
///
/// # Errors
/// All errors of the programs.
pub fn run(args: CheckArgs) -> Result<(), Complaint> {
    let program = programs::load(&args.program)?;
    match &args.of {
        Some(name) => eval::definition(&program, name).map(|_| ()),
        None if program.lowered.nothing_to_draw.is_empty() => Ok(()),
        None => Err(Complaint::diagnostics(&program.lowered.nothing_to_draw, &program.sources)),
    }
}
