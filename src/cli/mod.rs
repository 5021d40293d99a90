//! The command line: the only place that prints, reads files and clocks, and ends the process.
//!
//! In: the process's arguments. Out: files, messages, an exit status.
//!
//! - [`args`]: what was typed; [`values`]: one value of an option; [`dashes`]: programs that start with a minus;
//!   [`mend`]: numbers that are written in another way; [`shell`]: commands as they are typed.
//! - [`render`], [`eval`], [`check`], [`import`], [`completions`], [`greeting`]: the commands.
//! - [`explain`], [`ray`], [`compare`], [`lesson`]: the commands that teach; [`pages`]: what they print.
//! - [`programs`]: program texts from arguments, files and standard input; [`files`]: what they include.
//! - [`destination`]: where a picture goes; [`terminal`]: pictures in the terminal.
//! - [`output`]: files that appear whole or not at all; [`signals`]: what an interruption leaves behind.
//! - [`console`]: standard output and error, which may be closed; [`progress`]: the bar; [`clock`], [`stats`]: times.
//! - [`complaint`]: why a command failed, and its exit status; [`fault`]: our own mistakes.

pub mod args;
pub mod check;
pub mod clock;
pub mod completions;
pub mod compare;
pub mod complaint;
pub mod console;
pub mod dashes;
pub mod destination;
pub mod eval;
pub mod explain;
pub mod fault;
pub mod files;
pub mod greeting;
pub mod import;
pub mod lesson;
pub mod mend;
pub mod output;
pub mod pages;
pub mod programs;
pub mod progress;
pub mod ray;
pub mod render;
pub mod shell;
pub mod signals;
pub mod stats;
pub mod terminal;
pub mod values;

pub use complaint::{Complaint, Status};

use std::ffi::OsString;

/// Commands, as first arguments.
const COMMANDS: [&str; 8] = ["check", "eval", "explain", "ray", "compare", "lesson", "import", "completions"];

/// Commands that have a name and are not built yet.
const LATER: [&str; 10] = ["ray", "compare", "lesson", "gallery", "serve", "mesh", "animate", "plan", "work", "merge"];

/// Runs the command that the arguments name; the first is the program's own name.
///
/// # Errors
/// Why it failed, to be printed, and the exit status.
pub fn run(argv: Vec<OsString>) -> Result<(), Complaint> {
    match argv.get(1).and_then(|word| word.to_str()) {
        None if argv.len() < 2 => greeting::run(),
        Some("check") => check::run(read(&argv[1..])?),
        Some("eval") => eval::run(read(&argv[1..])?),
        Some("explain") => explain::run(read(&argv[1..])?),
        Some("ray") => ray::run(read(&argv[1..])?),
        Some("compare") => compare::run(read(&argv[1..])?),
        Some("lesson") => lesson::run(read(&argv[1..])?),
        Some("import") => import::run(&read(&argv[1..])?),
        Some("completions") => completions::run(&read(&argv[1..])?),
        Some(name) if LATER.contains(&name) => Err(Complaint::usage(format!(
            "the command '{name}' is not built yet; there are {}",
            crate::diag::one_of(&COMMANDS)
        ))),
        first => read(&argv).and_then(render::run).map_err(|mut complaint| {
            complaint.text += &command_meant(first.unwrap_or_default());
            complaint
        }),
    }
}

/// Says so if the first argument is nearly the name of a command, and was read as a program.
fn command_meant(first: &str) -> String {
    let is_word = first.len() > 3 && first.bytes().all(|b| b.is_ascii_lowercase());
    let near = crate::diag::nearest(first, COMMANDS.into_iter().filter(|_| is_word));
    near.first().map_or_else(String::new, |near| format!("note: if a command was meant: implicit {near}\n"))
}

/// The arguments of a command; help and version are printed and end it.
fn read<T: clap::Parser>(argv: &[OsString]) -> Result<T, Complaint> {
    args::read(argv).map_err(|refusal| {
        if refusal.is_answer {
            console::print(refusal.text.as_bytes()).map_or_else(|complaint| complaint, |()| Complaint::DONE)
        } else {
            Complaint::worded(Status::Usage, refusal.text)
        }
    })
}
