//! The corrected command, where numbers are written as other programs have them.
//!
//! In: arguments, and what clap says of them. Out: the words for standard error with the command that is meant.

use super::{shell, values};
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::ffi::{OsStr, OsString};

/// Options with as many numbers.
const COUNTS: [(&str, usize); 6] =
    [("--eye", 3), ("--look-at", 3), ("--ball", 4), ("--box", 6), ("--at", 3), ("--over", 6)];

/// What is written behind an equation, and tried as options.
const ATTRIBUTES: [(&str, &str); 3] =
    [("--color", "color: red"), ("--colour", "color: red"), ("--clip", "clip: z >= 0")];

/// What clap says, without its advice to take an unknown option for a program.
pub fn plain(mut error: clap::Error) -> String {
    error.remove(ContextKind::Suggested);
    let text = error.render().to_string();
    let unknown = match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(option)) if error.kind() == ErrorKind::UnknownArgument => option.as_str(),
        _ => return text,
    };
    match ATTRIBUTES.into_iter().find(|(option, _)| *option == unknown) {
        Some((_, written)) => format!(
            "error: there is no option {unknown}; it is written behind the equation:\n\n  \
             implicit 'x^2 + y^2 + z^2 = 1 {{ {written} }}'\n"
        ),
        None => text,
    }
}

/// The words, if the command that is meant can be told.
pub fn corrected(error: &clap::Error, command: &clap::Command, argv: &[OsString]) -> Option<String> {
    let words: Vec<&OsStr> = argv.get(1..)?.iter().map(OsString::as_os_str).collect();
    let (why, words) = numbers_apart(&words).or_else(|| numbers_together(error, &words))?;
    Some(format!("{why}\n\n  {}\n", shell::command(command.get_name(), words.iter().map(OsString::as_os_str))))
}

/// Numbers that are words of their own, as in `--eye 1 -2 3`.
fn numbers_apart(words: &[&OsStr]) -> Option<(String, Vec<OsString>)> {
    for (k, word) in words.iter().enumerate().take_while(|(_, word)| **word != "--") {
        let Some((option, count)) = COUNTS.into_iter().find(|(option, _)| word == option) else { continue };
        let numbers = words.get(k + 1..k + 1 + count).and_then(joined_numbers);
        if let Some(numbers) = numbers {
            let why = format!("error: {option} takes {count} numbers with commas between them:");
            return Some((why, replaced(words, k + 1..k + 1 + count, numbers)));
        }
    }
    None
}

fn joined_numbers(words: &[&OsStr]) -> Option<String> {
    let texts = words.iter().map(|word| word.to_str()).collect::<Option<Vec<&str>>>()?;
    let are_numbers = texts.iter().all(|text| text.parse::<f64>().is_ok());
    are_numbers.then(|| texts.join(","))
}

/// Numbers that are one word with something else between them, as in `--eye '1 2 3'`.
fn numbers_together(error: &clap::Error, words: &[&OsStr]) -> Option<(String, Vec<OsString>)> {
    let context = |kind| match error.get(kind) {
        Some(ContextValue::String(text)) if error.kind() == ErrorKind::ValueValidation => Some(text.as_str()),
        _ => None,
    };
    let value = context(ContextKind::InvalidValue)?;
    let option = context(ContextKind::InvalidArg)?.split_whitespace().next()?;
    let mended = values::with_commas(value)?;
    if !std::error::Error::source(error)?.to_string().ends_with(&format!("write {mended}")) {
        return None;
    }
    let joined = format!("{option}={value}");
    let place = (0..words.len()).find(|&k| words[k] == joined.as_str() || k > 0 && words[k - 1] == option)?;
    let mended = if words[place] == joined.as_str() { format!("{option}={mended}") } else { mended };
    let why = error.render().to_string().lines().next().unwrap_or_default().to_owned();
    Some((why, replaced(words, place..place + 1, mended)))
}

fn replaced(words: &[&OsStr], place: std::ops::Range<usize>, new: String) -> Vec<OsString> {
    let mut words: Vec<OsString> = words.iter().map(|&word| word.to_owned()).collect();
    words.splice(place, [new.into()]);
    words
}
