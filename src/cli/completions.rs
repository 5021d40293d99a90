//! `implicit completions`: what shells and `man` read.
//!
//! In: the definitions of all commands. Out: a script for a shell, or the manual page.

use super::args::{CheckArgs, CompletionsArgs, EvalArgs, ImportArgs, RenderArgs, Script};
use super::complaint::Complaint;
use super::console;
use crate::render::Mode;
use clap::builder::PossibleValuesParser;
use clap::{Command, CommandFactory};

/// What only the manual says.
const MANUAL: &str = "\
Exit status: 0 done; 1 the program text or a file could not be used; 2 the command line is wrong; 70 an internal fault; \
130 interrupted; 143 terminated. A failed or interrupted run leaves an existing file as it was; under --progressive it \
is the last whole pass.

Environment: NO_COLOR takes colours from messages and from pictures in the terminal. COLORTERM=truecolor gives these \
24 bits of colour. IMPLICIT_SIMD=off takes instructions that every machine has; the bytes are the same.";

/// Prints it.
///
/// # Errors
/// If standard output is full.
pub fn run(args: &CompletionsArgs) -> Result<(), Complaint> {
    let mut bytes = Vec::new();
    match args.script {
        Script::Completions(shell) => clap_complete::generate(shell, &mut whole(), "implicit", &mut bytes),
        Script::Manual => clap_mangen::Man::new(whole().after_long_help(MANUAL))
            .render(&mut bytes)
            .map_err(|error| Complaint::program(console::reason(&error)))?,
    }
    console::print(&bytes)
}

/// All commands as one, as shells and readers see it.
fn whole() -> Command {
    let scripts = PossibleValuesParser::new(["bash", "zsh", "fish", "elvish", "powershell", "man"]);
    let modes = PossibleValuesParser::new(Mode::ALL.map(|(name, _)| name));
    let commands = [
        CheckArgs::command().name("check"),
        EvalArgs::command().name("eval"),
        ImportArgs::command().name("import"),
        CompletionsArgs::command().name("completions").mut_arg("script", |arg| arg.value_parser(scripts)),
    ];
    RenderArgs::command()
        .mut_arg("mode", |arg| arg.value_parser(modes))
        .mut_arg("method", |arg| arg.hide_possible_values(false))
        .disable_help_subcommand(true)
        .subcommands(commands)
}
