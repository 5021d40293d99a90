//! Messages as people see them: headline, place, the program's line, carets, the way out.
//!
//! In: [`Diagnostic`]s and the texts they point into. Out: one string, plain or coloured. Separate because this is
//! the only user of annotate-snippets, and the only place where a user's text is made fit for a terminal.

use super::diagnostic::{Diagnostic, Label, Severity};
use super::source::{Source, Sources};
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Padding, Renderer, Snippet};
use std::ops::Range;

/// Lines with more characters than this are cut around the place: a terminal's line, twice.
const MAX_LINE: usize = 160;

/// How many characters stay before the place in a line that is cut.
const CONTEXT: usize = 50;

/// Messages and names of sources are cut to this many characters.
const MAX_MESSAGE: usize = 600;

/// Draws messages one after the other; each ends with an empty line.
///
/// Places are shown as `--> NAME:LINE:COLUMN`, counted from 1, columns in characters. Control characters are
/// replaced, and long lines cut around the place.
pub fn render(diagnostics: &[Diagnostic], sources: &Sources, color: bool) -> String {
    let renderer = if color { Renderer::styled() } else { Renderer::plain() }.term_width(2 * MAX_LINE);
    let mut out = String::new();
    for diagnostic in diagnostics {
        out.push_str(&render_one(&renderer, diagnostic, sources));
        out.push_str("\n\n");
    }
    out
}

fn render_one(renderer: &Renderer, diagnostic: &Diagnostic, sources: &Sources) -> String {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Note => Level::NOTE,
    };
    let mut group = Group::with_title(level.primary_title(printable(&diagnostic.message, MAX_MESSAGE)));
    for line in lines_of(diagnostic, sources) {
        group = group.element(line.origin()).element(Padding).element(line.snippet());
    }
    if let Some(help) = &diagnostic.help {
        group = group.element(Level::HELP.message(printable(help, MAX_MESSAGE)));
    }
    without_empty_marks(&renderer.render(&[group]))
}

/// The drawing without the lines that stand for a second file without a name: annotate-snippets draws `:::` before a
/// snippet whose place was named separately.
fn without_empty_marks(drawn: &str) -> String {
    let mut lines: Vec<&str> = Vec::new();
    for line in drawn.lines() {
        if uncolored(line).trim() == ":::" {
            lines.pop();
        } else {
            lines.push(line);
        }
    }
    lines.join("\n")
}

/// A line without its colour codes, which go from ESC to `m`.
fn uncolored(line: &str) -> String {
    let mut parts = line.split('\u{1b}');
    let first = parts.next().unwrap_or("").to_owned();
    first + &parts.map(|part| part.split_once('m').map_or(part, |(_, rest)| rest)).collect::<String>()
}

/// A line of a source with the labels that point into it, the first of them the one its place is named by.
struct Line<'a> {
    source: &'a Source,
    bytes: Range<usize>,
    labels: Vec<&'a Label>,
}

/// The lines that labels point into, in the order of the labels.
fn lines_of<'a>(diagnostic: &'a Diagnostic, sources: &'a Sources) -> Vec<Line<'a>> {
    let mut lines: Vec<Line<'a>> = Vec::new();
    for label in &diagnostic.labels {
        let Some(source) = sources.get(label.span.source) else { continue };
        let bytes = source.line_range(label.span.start as usize);
        match lines.iter_mut().find(|line| std::ptr::eq(line.source, source) && line.bytes == bytes) {
            Some(line) => line.labels.push(label),
            None => lines.push(Line { source, bytes, labels: vec![label] }),
        }
    }
    lines
}

impl Line<'_> {
    fn origin(&self) -> Origin<'static> {
        let start = self.labels.first().map_or(0, |label| label.span.start as usize);
        let position = self.source.position(start);
        Origin::path(printable(&self.source.name, MAX_MESSAGE)).line(position.line).char_column(position.column)
    }

    fn snippet(&self) -> Snippet<'static, annotate_snippets::Annotation<'static>> {
        let text = &self.source.text[self.bytes.clone()];
        let characters: Vec<(usize, char)> = window(text, self.first_byte());
        let mut shown = String::new();
        // Where each character's first byte went; the end of the text counts as one character more.
        let mut places: Vec<(usize, usize)> = Vec::new();
        if characters.first().is_some_and(|&(byte, _)| byte > 0) {
            shown.push('…');
        }
        for &(byte, character) in &characters {
            places.push((byte, shown.len()));
            shown.push(visible(character));
        }
        let last = characters.last().map_or(0, |&(byte, character)| byte + character.len_utf8());
        places.push((last, shown.len()));
        shown.push(if last < text.len() { '…' } else { ' ' });
        let position = self.source.position(self.bytes.start);
        let mut snippet = Snippet::source(shown.clone()).line_start(position.line).fold(false);
        for (i, label) in self.labels.iter().enumerate() {
            let span = self.span_in(&label.span.range(), &places, &shown);
            let kind = if i == 0 { AnnotationKind::Primary } else { AnnotationKind::Context };
            let annotation = kind.span(span);
            let text = printable(&label.text, MAX_MESSAGE);
            snippet = snippet.annotation(if text.is_empty() { annotation } else { annotation.label(text) });
        }
        snippet
    }

    /// The first label's first byte, counted from the line's start.
    fn first_byte(&self) -> usize {
        self.labels.first().map_or(0, |label| label.span.start as usize).saturating_sub(self.bytes.start)
    }

    /// A span of the source as a span of the shown text, one character at least.
    fn span_in(&self, span: &Range<usize>, places: &[(usize, usize)], shown: &str) -> Range<usize> {
        let find = |byte: usize| {
            let inside = byte.saturating_sub(self.bytes.start);
            let i = places.partition_point(|&(b, _)| b < inside).min(places.len() - 1);
            places[i].1
        };
        let start = find(span.start);
        let end = find(span.end.min(self.bytes.end.max(span.start)));
        let one_more = shown[start..].chars().next().map_or(0, char::len_utf8);
        start..end.max(start + one_more)
    }
}

/// All characters of a line, or those around a place if they are too many.
fn window(text: &str, place: usize) -> Vec<(usize, char)> {
    let total = text.chars().count();
    if total <= MAX_LINE {
        return text.char_indices().collect();
    }
    let before = text.char_indices().take_while(|&(byte, _)| byte < place).count();
    let first = before.saturating_sub(CONTEXT).min(total - MAX_LINE);
    text.char_indices().skip(first).take(MAX_LINE).collect()
}

/// A character that does nothing to a terminal: controls and marks that turn the writing direction are replaced.
fn visible(character: char) -> char {
    match character {
        '\t' | '\n' | '\r' => ' ',
        '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' => {
            '\u{fffd}'
        }
        c if c.is_control() => '\u{fffd}',
        c => c,
    }
}

/// A user's text on one line, control characters replaced, cut to `limit` characters.
pub fn printable(text: &str, limit: usize) -> String {
    let mut out: String = text.chars().take(limit).map(visible).collect();
    if text.chars().nth(limit).is_some() {
        out.push('…');
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Span;

    fn show(text: &str, start: usize, end: usize) -> String {
        let mut sources = Sources::new();
        let id = sources.add("<argument 1>", text);
        let error = Diagnostic::error(Span::new(id, start, end), "wrong").label("here").help("write it well");
        render(&[error], &sources, false)
    }

    /// The line of the program and the columns of its carets.
    fn carets(shown: &str) -> (String, Range<usize>) {
        let lines: Vec<&str> = shown.lines().collect();
        let at = lines
            .iter()
            .position(|line| line.contains('|') && line.contains('^') && line.contains("here"))
            .expect("there are carets");
        let line = lines[at].chars().collect::<Vec<_>>();
        let from = line.iter().position(|&c| c == '^').expect("a caret");
        let count = line.iter().filter(|&&c| c == '^').count();
        let program: Vec<char> = lines[at - 1].chars().collect();
        (program[from.min(program.len())..(from + count).min(program.len())].iter().collect(), from..from + count)
    }

    #[test]
    fn the_place_is_named_and_marked() {
        let rows = [
            ("x^2 + abc = 1", 6, 9, "<argument 1>:1:7", "abc"),
            ("x = 1\ny + zz\n", 10, 12, "<argument 1>:2:5", "zz"),
            ("θ + abc", 5, 8, "<argument 1>:1:5", "abc"),
            ("x = 1\r\ny + zz\r\n", 11, 13, "<argument 1>:2:5", "zz"),
            ("\tabc", 1, 4, "<argument 1>:1:2", "abc"),
        ];
        for (text, start, end, place, marked) in rows {
            let shown = show(text, start, end);
            assert!(shown.contains(&format!("--> {place}")), "{shown}");
            assert_eq!(carets(&shown).0, marked, "{shown}");
            assert!(!shown.contains(":::"), "{shown}");
            assert!(shown.contains("help: write it well") && shown.contains("error: wrong"), "{shown}");
        }
    }

    #[test]
    fn the_end_of_the_text_can_be_marked() {
        for text in ["", "x +", "x +\n", "é"] {
            let shown = show(text, text.len(), text.len());
            assert_eq!(carets(&shown).1.len(), 1, "{shown}");
        }
    }

    #[test]
    fn a_long_line_is_cut_around_the_place() {
        let text = format!("{}abc{}", "x+".repeat(500_000), "+y".repeat(500_000));
        let shown = show(&text, 1_000_000, 1_000_003);
        assert!(shown.len() < 1000 && shown.contains("--> <argument 1>:1:1000001"), "{shown}");
        assert_eq!(carets(&shown).0, "abc");
        assert!(show(&text, 0, text.len()).len() < 1500);
    }

    #[test]
    fn nothing_typed_reaches_the_terminal_as_a_control() {
        let shown = show("x\u{1b}[31m\u{202e}y\u{7}+abc", 0, 3);
        assert!(shown.chars().all(|c| c == '\n' || (!c.is_control() && c != '\u{202e}')), "{shown:?}");
        assert_eq!(printable("a\nb\u{0}c", 4), "a b\u{fffd}…");
    }

    #[test]
    fn two_places_on_two_lines_are_both_shown() {
        let mut sources = Sources::new();
        let id = sources.add("a.imp", "first\nx\nx\nsecond\n");
        let other = sources.add("b.imp", "third");
        let error = Diagnostic::error(Span::new(id, 10, 16), "twice")
            .also(Span::new(id, 0, 5), "defined here")
            .also(Span::new(other, 0, 5), "and here");
        let shown = render(&[error], &sources, false);
        for part in ["--> a.imp:4:1", "first", "second", "defined here", "b.imp:1:1", "and here"] {
            assert!(shown.contains(part), "{part}: {shown}");
        }
    }
}
