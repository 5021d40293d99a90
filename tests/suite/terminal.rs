//! What only a terminal shows: pictures in characters, the bar.
//!
//! In: the program in a pseudo terminal of known size. Out: what a person would see there.
#![cfg(target_os = "linux")]

use super::command::{Folder, PROGRAM};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{Winsize, tcsetwinsize};
use std::fs::File;
use std::io::Read;
use std::process::{Command, Stdio};

/// What is written to a terminal of so many columns and rows, and the exit status. `streams` are those that the
/// terminal is for: `o`utput, `e`rror.
fn seen(args: &[&str], (columns, rows): (u16, u16), environment: &[(&str, &str)], streams: &str) -> (String, i32) {
    let folder = Folder::new();
    let terminal = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
    grantpt(&terminal).unwrap();
    unlockpt(&terminal).unwrap();
    tcsetwinsize(&terminal, Winsize { ws_row: rows, ws_col: columns, ws_xpixel: 0, ws_ypixel: 0 }).unwrap();
    let name = ptsname(&terminal, Vec::new()).unwrap();
    let side = File::options().read(true).write(true).open(name.to_str().unwrap()).unwrap();
    let stream = |letter| match streams.contains(letter) {
        true => Stdio::from(side.try_clone().unwrap()),
        false => Stdio::null(),
    };
    let mut command = Command::new(PROGRAM);
    command.args(args).current_dir(&folder.path).stdin(Stdio::null()).stdout(stream('o')).stderr(stream('e'));
    for name in ["COLORTERM", "NO_COLOR", "TERM_PROGRAM", "TMUX", "STY"] {
        command.env_remove(name);
    }
    let mut child = command.env("TERM", "xterm-256color").envs(environment.iter().copied()).spawn().unwrap();
    drop((command, side));
    let mut bytes = Vec::new();
    // When nobody writes to it any more, a terminal ends with an error.
    let _ = File::from(terminal).read_to_end(&mut bytes);
    (String::from_utf8(bytes).unwrap(), child.wait().unwrap().code().unwrap())
}

/// The characters that are left without escape sequences.
fn plain(text: &str) -> String {
    let mut parts = text.split('\u{1b}');
    let first = parts.next().unwrap_or_default().to_owned();
    first + &parts.map(|part| part.split_once('m').map_or("", |(_, rest)| rest)).collect::<String>()
}

const SPHERE: [&str; 2] = ["x^2+y^2+z^2=1", "--quiet"];

#[test]
fn a_picture_fits_into_its_terminal() {
    for (columns, rows, width, height) in [(80, 24, 56, 21), (30, 50, 30, 11), (1, 1, 1, 1)] {
        let (text, status) = seen(&SPHERE, (columns, rows), &[("COLORTERM", "truecolor")], "o");
        let lines: Vec<String> = text.lines().map(plain).collect();
        assert_eq!((status, lines.len()), (0, height), "{columns}x{rows}");
        assert!(lines.iter().all(|line| line.chars().count() == width && line.chars().all(|c| c == '▀')), "{lines:?}");
    }
}

#[test]
fn colours_are_those_that_the_terminal_has() {
    let seen = |environment: &[(&str, &str)]| seen(&SPHERE, (80, 24), environment, "o").0;
    let (palette, all) = (seen(&[]), seen(&[("COLORTERM", "truecolor")]));
    assert!(palette.contains("\x1b[38;5;") && !palette.contains("[38;2;"));
    assert!(all.contains("\x1b[38;2;") && !all.contains("[38;5;"));
    for environment in [[("NO_COLOR", "1")], [("TERM", "dumb")]] {
        let none = seen(&environment);
        assert!(!none.contains('\x1b') && none.contains('=') && none.lines().count() == 21, "{none}");
    }
    let picture = seen(&[("TERM", "xterm-kitty")]);
    assert!(picture.starts_with("\x1b_Ga=T,f=100,"), "{picture:.60}");
}

#[test]
fn the_bar_is_on_standard_error_and_only_in_a_terminal() {
    let args = ["x^2+y^2+z^2=1", "-s", "1500x1500", "--threads", "1", "-o", "a.png"];
    let (text, status) = seen(&args, (80, 24), &[], "e");
    assert!(status == 0 && text.contains("left:") && text.contains('%'), "{text:?}");
    let (text, status) = seen(&[&args[..], &["--quiet"]].concat(), (80, 24), &[], "e");
    assert_eq!((text.as_str(), status), ("", 0));
    let said = Folder::new().run(&args);
    assert!(said.status == 0 && !said.err.contains("left:"), "{}", said.err);
}
