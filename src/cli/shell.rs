//! Commands as a person types them, for messages that show the corrected one.
//!
//! In: words. Out: a line that a shell takes as these words.

use std::ffi::OsStr;

/// A command of our own with its arguments, on one line.
pub fn command<'a>(name: &str, words: impl Iterator<Item = &'a OsStr>) -> String {
    let mut line = name.to_owned();
    for word in words {
        line.push(' ');
        line += &quoted(word);
    }
    line
}

/// A word as a shell takes it.
fn quoted(word: &OsStr) -> String {
    let text = shown(word);
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./,=:+@%".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        return text;
    }
    format!("'{}'", text.replace('\'', r"'\''"))
}

/// A word in a message, control characters replaced.
pub fn shown(word: &OsStr) -> String {
    word.to_string_lossy().chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}
