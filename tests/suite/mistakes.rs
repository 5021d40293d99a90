//! Programs that are wrong on purpose, and what is said about each, word for word.
//!
//! In: examples/mistakes, each program with its messages beside it. Out: passed or failed; a program without messages and
//! messages without a program fail too. The first line of a program says what was meant, for whoever reads the message.
//! After a change of words: `implicit check NAME.imp 2> NAME.txt` in that folder, and read what it says.

use crate::command::{PROGRAM, said};
use std::path::Path;
use std::process::Command;

#[test]
fn every_mistake_is_met_with_its_message() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/mistakes");
    let names = |extension: &str| {
        let files = std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path());
        let mut names: Vec<String> = files
            .filter(|file| file.extension().is_some_and(|e| e == extension))
            .map(|file| file.file_stem().unwrap().to_str().unwrap().to_owned())
            .collect();
        names.sort();
        names
    };
    let programs = names("imp");
    assert!(programs.len() >= 50, "{}", programs.len());
    assert_eq!(programs, names("txt"), "a program without its messages, or messages without their program");
    let mut wrong = Vec::new();
    for name in programs {
        let program = std::fs::read_to_string(folder.join(format!("{name}.imp"))).unwrap();
        assert!(program.starts_with("// Meant: "), "{name} does not say what was meant");
        let mut command = Command::new(PROGRAM);
        let found = said(command.args(["check", &format!("{name}.imp")]).current_dir(&folder).output().unwrap());
        let expected = std::fs::read_to_string(folder.join(format!("{name}.txt"))).unwrap();
        if found.status != 1 || found.err != expected || !found.out.is_empty() {
            wrong.push(format!("{name}: exit {}\n{}", found.status, found.err));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
