//! Programs that start with a minus.
//!
//! In: a command's arguments. Out: if one of them is a program like `-x^2 + y`, the error that says so, with the
//! corrected command. Separate from reading the arguments, because it has to look at them before they are taken for
//! options.

use super::args::{Takes, option_of};
use super::shell;
use std::ffi::{OsStr, OsString};

/// What to say if a program starts with a minus and stands where options do.
pub fn complaint(command: &clap::Command, argv: &[OsString]) -> Option<String> {
    let sorted = Sorted::new(command, argv);
    let first = sorted.programs.iter().find(|(_, is_dashed)| *is_dashed)?.0;
    let mut corrected = sorted.options;
    corrected.push(OsStr::new("--"));
    corrected.extend(sorted.programs.iter().map(|(program, _)| *program));
    Some(format!(
        "error: '{}' starts with a minus and is no option; a program that does needs -- before it:\n\n  {}\n",
        shell::shown(first),
        shell::command(command.get_name(), corrected.into_iter())
    ))
}

/// The arguments by what they are.
struct Sorted<'a> {
    options: Vec<&'a OsStr>,
    /// Programs, and whether each starts with a minus before `--`.
    programs: Vec<(&'a OsStr, bool)>,
}

impl<'a> Sorted<'a> {
    fn new(command: &clap::Command, argv: &'a [OsString]) -> Self {
        let mut sorted = Sorted { options: Vec::new(), programs: Vec::new() };
        let mut rest = argv.iter().skip(1).map(OsString::as_os_str).peekable();
        while let Some(word) = rest.next() {
            if word == "--" {
                sorted.programs.extend(rest.by_ref().map(|program| (program, false)));
                break;
            }
            if !starts_with_dash(word) || word == "-" {
                sorted.programs.push((word, false));
                continue;
            }
            match option_of(command, word) {
                Some(takes) => {
                    sorted.options.push(word);
                    let has_value = rest.peek().is_some_and(|next| match takes {
                        Takes::Nothing => false,
                        Takes::Value => !starts_with_dash(next) || *next == "-",
                        Takes::AnyValue => true,
                    });
                    sorted.options.extend(has_value.then(|| rest.next()).flatten());
                }
                None if is_option(command, word) => sorted.options.push(word),
                None => sorted.programs.push((word, true)),
            }
        }
        sorted
    }
}

fn starts_with_dash(word: &OsStr) -> bool {
    word.as_encoded_bytes().first() == Some(&b'-')
}

/// Whether a word that is no option's bare name is meant as one: `--name=value`, `-ofile`, `-s8x6`, a misspelt `--name`.
fn is_option(command: &clap::Command, word: &OsStr) -> bool {
    let Some(text) = word.to_str() else { return true };
    if let Some(long) = text.strip_prefix("--") {
        let name = long.split('=').next().unwrap_or(long);
        let looks_like_a_name = name.len() > 1 && name.bytes().all(|b| b.is_ascii_lowercase() || b == b'-');
        return looks_like_a_name
            && (!long.contains('=') || option_of(command, OsStr::new(&format!("--{name}"))).is_some());
    }
    match text.as_bytes() {
        [b'-', b'o', ..] => option_of(command, OsStr::new("-o")).is_some(),
        [b'-', b's', value @ ..] => {
            let is_size = value.first().is_some_and(|b| b.is_ascii_digit() || *b == b'=');
            is_size && option_of(command, OsStr::new("-s")).is_some()
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::args::{EvalArgs, RenderArgs};
    use clap::CommandFactory;

    fn corrected(line: &[&str]) -> Option<String> {
        let argv: Vec<OsString> = line.iter().map(OsString::from).collect();
        let command = if line.get(1) == Some(&"eval") { EvalArgs::command() } else { RenderArgs::command() };
        let argv = if line.get(1) == Some(&"eval") { &argv[1..] } else { &argv[..] };
        complaint(&command, argv).map(|text| text.lines().last().unwrap_or_default().trim().to_owned())
    }

    #[test]
    fn programs_with_a_leading_minus_are_told_from_options() {
        let rows: [(&[&str], Option<&str>); 14] = [
            (&["implicit", "-x^2+y", "-o", "a.png"], Some("implicit -o a.png -- '-x^2+y'")),
            (&["implicit", "-o", "a.png", "-x"], Some("implicit -o a.png -- -x")),
            (&["implicit", "-sin(x)=z", "--quiet"], Some("implicit --quiet -- '-sin(x)=z'")),
            (&["implicit", "-2x=y", "z=1"], Some("implicit -- -2x=y z=1")),
            (&["implicit", "-h(x)", "y"], Some("implicit -- '-h(x)' y")),
            (&["implicit", "--x^2=y"], Some("implicit -- '--x^2=y'")),
            (&["implicit", "eval", "-x", "--at", "-1,2,3"], Some("implicit eval --at -1,2,3 -- -x")),
            (&["implicit", "x", "--", "-y"], None),
            (&["implicit", "x", "--eye", "-1,2,3", "--set", "-a=1"], None),
            (&["implicit", "-oa.png", "-s8x6", "--size=8x6", "x"], None),
            (&["implicit", "x", "--colour", "red"], None),
            (&["implicit", "-", "-o", "-"], None),
            (&["implicit", "-h"], None),
            (&["implicit"], None),
        ];
        for (line, expected) in rows {
            assert_eq!(corrected(line).as_deref(), expected, "{line:?}");
        }
    }
}
