//! Program texts: from arguments, files and standard input.
//!
//! In: the PROGRAM arguments. Out: a program that can be used, its notes printed; or the complaint with all its errors.

use super::args::ProgramArgs;
use super::complaint::Complaint;
use super::{console, files};
use crate::diag::{Diagnostic, Severity, render};
use crate::expr::lower::Setting;
use crate::session::{Program, Text};
use std::ffi::OsStr;
use std::io::Read;
use std::path::Path;

/// The argument that stands for standard input.
pub const STDIN: &str = "-";

/// Reads the programs and prints their notes.
///
/// # Errors
/// What cannot be read, or all errors of the program; notes too, if they are to be errors.
pub fn load(args: &ProgramArgs) -> Result<Program, Complaint> {
    let texts = args.programs.iter().enumerate().map(|(i, program)| text(i, program)).collect::<Result<Vec<_>, _>>()?;
    let root = files::root_of(&args.programs);
    let set = args.set.iter().map(|(name, value)| Setting { name: name.clone(), value: value.clone() }).collect();
    let mut program = Program::read(texts, set, &files::Folder { root });
    if args.strict {
        for diagnostic in &mut program.diagnostics {
            diagnostic.severity = Severity::Error;
        }
    }
    if args.quiet {
        program.diagnostics.retain(Diagnostic::is_error);
    }
    if program.has_errors() {
        let mut complaint = Complaint::diagnostics(&program.diagnostics, &program.sources);
        complaint.text.push_str(&files_meant(args));
        return Err(complaint);
    }
    if !program.diagnostics.is_empty() {
        let text = render(&program.diagnostics, &program.sources, console::has_colour());
        console::say(&format!("{}\n", text.trim_end()));
    }
    Ok(program)
}

/// Says so if an argument that was read as text names a file.
fn files_meant(args: &ProgramArgs) -> String {
    let is_file = |program: &&std::ffi::OsString| !is_program_file(program) && Path::new(program).is_file();
    let say = |program: &std::ffi::OsString| {
        let name = files::shown(program);
        match Path::new(program).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("png")) {
            true => format!("note: '{name}' is a picture; to print the program that drew it: implicit import FILE\n"),
            false => format!("note: '{name}' is a file; the name of a program's file must end in .imp\n"),
        }
    };
    args.programs.iter().filter(is_file).map(say).collect()
}

/// Whether an argument names a file with a program.
pub fn is_program_file(program: &OsStr) -> bool {
    let bytes = program.as_encoded_bytes();
    bytes.len() >= 4 && bytes[bytes.len() - 4..].eq_ignore_ascii_case(b".imp")
}

fn text(index: usize, program: &OsStr) -> Result<Text, Complaint> {
    if program == STDIN {
        return from_stdin();
    }
    if is_program_file(program) {
        let loaded = files::read(Path::new(program))
            .map_err(|why| Complaint::program(format!("cannot read '{}': {why}", files::shown(program))))?;
        return Ok(Text { name: files::shown(program), key: loaded.key, text: loaded.text });
    }
    let name = format!("<argument {}>", index + 1);
    match program.to_str() {
        Some(text) => Ok(Text { name, key: String::new(), text: text.to_owned() }),
        None => Err(Complaint::program(format!("argument {} is no text in UTF-8", index + 1))),
    }
}

fn from_stdin() -> Result<Text, Complaint> {
    let mut bytes = Vec::new();
    let limit = files::MAX_BYTES + 1;
    let fail = |why: String| Complaint::program(format!("cannot read standard input: {why}"));
    std::io::stdin().lock().take(limit).read_to_end(&mut bytes).map_err(|error| fail(console::reason(&error)))?;
    let text = files::text_of(bytes).map_err(fail)?;
    Ok(Text { name: "<stdin>".into(), key: String::new(), text })
}
