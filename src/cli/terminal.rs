//! The picture in the terminal.
//!
//! In: a drawing and what the terminal can do. Out: the bytes that show it: a picture where the terminal knows
//! pictures, else two pixels a character.

use super::complaint::Complaint;
use super::console;
use crate::film::blocks::{self, Colours};
use crate::film::{Layer, Print, Size, png};
use std::env;

/// Columns and rows where nobody says.
const USUAL: (u32, u32) = (80, 24);

/// Rows left for the command above and the prompt below.
const FREE_ROWS: u32 = 3;

/// The most columns that are used: a picture that fills a wide screen scrolls everything else away.
const MAX_COLUMNS: u32 = 160;

/// Bytes of base64 in one message of kitty's protocol.
const KITTY_CHUNK: usize = 4096;

/// What a terminal is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Terminal {
    columns: u32,
    rows: u32,
    way: Way,
}

/// How a terminal shows a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    /// Kitty's graphics protocol (<https://sw.kovidgoyal.net/kitty/graphics-protocol>).
    Kitty,
    /// In characters.
    Blocks(Colours),
}

impl Terminal {
    /// That of standard output, by what it and the environment say.
    pub fn of_stdout() -> Self {
        let (columns, rows) = window().unwrap_or(USUAL);
        Terminal { columns: columns.min(MAX_COLUMNS), rows: rows.saturating_sub(FREE_ROWS).max(1), way: way(&variable) }
    }

    /// The size of a picture that nobody asked to have another size; `None`: the usual one.
    pub fn size(&self) -> Option<Size> {
        match self.way {
            Way::Kitty => None,
            Way::Blocks(_) => Some(blocks::fitting(Size::default(), self.columns, self.rows)),
        }
    }

    /// Shows a picture.
    ///
    /// # Errors
    /// If standard output is full, or the picture cannot be encoded.
    pub fn show(&self, print: &Print<'_>) -> Result<(), Complaint> {
        let size = blocks::fitting(print.picture.size, self.columns, self.rows);
        let text = match self.way {
            Way::Kitty => {
                let bytes = png::encode(print).map_err(Complaint::program)?;
                kitty(&bytes, size.width(), size.height().div_ceil(2))
            }
            Way::Blocks(colours) => {
                let picture = Layer { size: print.picture.size, values: print.light() };
                blocks::draw(&picture, print.tone, print.gain, size, colours)
            }
        };
        console::print(text.as_bytes())
    }
}

/// Columns and rows of the terminal on standard output.
fn window() -> Option<(u32, u32)> {
    #[cfg(unix)]
    {
        let window = rustix::termios::tcgetwinsize(std::io::stdout()).ok()?;
        (window.ws_col > 0 && window.ws_row > 0).then(|| (window.ws_col.into(), window.ws_row.into()))
    }
    #[cfg(not(unix))]
    None
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_default()
}

/// How this environment's terminal shows pictures.
fn way(variable: &dyn Fn(&str) -> String) -> Way {
    let (term, program) = (variable("TERM"), variable("TERM_PROGRAM"));
    // https://no-color.org; and a terminal without any sequences has no colours.
    if !variable("NO_COLOR").is_empty() || term == "dumb" {
        return Way::Blocks(Colours::None);
    }
    let passes_pictures = variable("TMUX").is_empty() && variable("STY").is_empty();
    let knows_kitty = term == "xterm-kitty" || term == "xterm-ghostty" || program == "ghostty" || program == "WezTerm";
    if passes_pictures && knows_kitty {
        return Way::Kitty;
    }
    match variable("COLORTERM").as_str() {
        "truecolor" | "24bit" => Way::Blocks(Colours::True),
        _ => Way::Blocks(Colours::Palette),
    }
}

/// A PNG file as messages to the terminal that show it on so many columns and rows.
fn kitty(png: &[u8], columns: u32, rows: u32) -> String {
    let data = base64(png);
    let count = data.len().div_ceil(KITTY_CHUNK);
    let mut text = String::new();
    for (index, chunk) in data.as_bytes().chunks(KITTY_CHUNK).enumerate() {
        let keys = if index == 0 { format!("a=T,f=100,q=2,c={columns},r={rows},") } else { String::new() };
        let more = u8::from(index + 1 < count);
        text += &format!("\x1b_G{keys}m={more};{}\x1b\\", String::from_utf8_lossy(chunk));
    }
    text + "\n"
}

/// RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let bits = (0..3).fold(0u32, |bits, k| bits << 8 | u32::from(three.get(k).copied().unwrap_or(0)));
        for k in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * k) & 63) as usize] as char;
            text.push(if k <= three.len() { letter } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_standard() {
        let rows = [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")];
        for (bytes, text) in rows {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }

    #[test]
    fn the_environment_says_what_a_terminal_can_do() {
        let rows: [(&[(&str, &str)], Way); 7] = [
            (&[("TERM", "xterm-256color"), ("COLORTERM", "truecolor")], Way::Blocks(Colours::True)),
            (&[("TERM", "xterm-256color")], Way::Blocks(Colours::Palette)),
            (&[("TERM", "xterm-256color"), ("COLORTERM", "truecolor"), ("NO_COLOR", "1")], Way::Blocks(Colours::None)),
            (&[("TERM", "dumb")], Way::Blocks(Colours::None)),
            (&[("TERM", "xterm-kitty")], Way::Kitty),
            (&[("TERM", "xterm-kitty"), ("TMUX", "/tmp/x")], Way::Blocks(Colours::Palette)),
            (&[("TERM_PROGRAM", "WezTerm"), ("COLORTERM", "truecolor")], Way::Kitty),
        ];
        for (environment, expected) in rows {
            let variable = |name: &str| {
                environment.iter().find(|(key, _)| *key == name).map_or_else(String::new, |(_, value)| (*value).into())
            };
            assert_eq!(way(&variable), expected, "{environment:?}");
        }
    }

    #[test]
    fn long_pictures_are_sent_in_pieces() {
        let text = kitty(&[0; 5000], 10, 5);
        assert!(text.starts_with("\x1b_Ga=T,f=100,q=2,c=10,r=5,m=1;") && text.contains("\x1b_Gm=0;"));
    }
}
