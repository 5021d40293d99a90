//! The place where reading stands in one statement: the next word, the open brackets, the names in scope.
//!
//! In: the words of a statement and the program's names. Out: words one by one, split names letter by letter, and
//! errors. Separate from the grammar, which only asks for words.

use super::names::{self, Meaning, Names};
use super::token::{Bracket, Token, TokenKind};
use crate::diag::{Diagnostic, Span, nearest, one_of, printable};
use std::collections::BTreeSet;

/// How deep brackets, signs, powers, bars and functions may nest. People stop at ten; the way through
/// the grammar takes about 2 KiB of stack a level, and a worker's stack is 2 MiB.
pub const MAX_NESTING: usize = 256;

/// An unknown name is compared with at most so many known ones: each comparison takes about a microsecond.
const MAX_COMPARED: usize = 2000;

/// Reading of the statement has stopped; the error is reported.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stop;

pub(super) type Read<T> = Result<T, Stop>;

/// What all statements of a program add to.
#[derive(Debug, Default)]
pub(super) struct Report {
    pub(super) diagnostics: Vec<Diagnostic>,
    /// Notes given and names complained about already: the same is not said twice.
    said: BTreeSet<String>,
}

impl Report {
    /// Whether there are more errors than will be shown, so that no more words need be found for them.
    fn is_full(&self) -> bool {
        self.diagnostics.len() > 2 * super::MAX_REPORTED
    }

    /// Adds a message, unless one with these words was given before.
    pub(super) fn once(&mut self, diagnostic: Diagnostic) {
        if self.said.insert(diagnostic.message.clone()) {
            self.diagnostics.push(diagnostic);
        }
    }
}

pub(super) struct Reader<'p> {
    pub(super) text: &'p str,
    words: &'p [Token],
    at: usize,
    /// Which letter of the word at `at` is next, if it is a name that splits.
    letter: Option<usize>,
    /// Whether `letter` is decided for the word at `at`.
    settled: bool,
    end: Token,
    /// Where the last word or letter that was taken ends.
    pub(super) last_end: u32,
    pub(super) names: &'p Names,
    /// Parameters and running names, the innermost last.
    pub(super) scope: Vec<String>,
    /// Bars that stand open within the innermost bracket.
    pub(super) bars: usize,
    pub(super) depth: usize,
    pub(super) report: &'p mut Report,
    /// Whether the lexer has complained about this statement: then a misfit is no news.
    pub(super) damaged: bool,
    /// Whether an error was found while reading.
    pub(super) failed: bool,
}

impl<'p> Reader<'p> {
    /// A reader of `words`, which stand in `text`.
    pub(super) fn new(text: &'p str, words: &'p [Token], names: &'p Names, report: &'p mut Report) -> Self {
        let last = words.last().map_or_else(Span::default, |word| word.span);
        let end = Token { kind: TokenKind::End, span: last.after() };
        let damaged = words.iter().any(|word| word.kind == TokenKind::Invalid);
        Reader {
            text,
            words,
            at: 0,
            letter: None,
            settled: false,
            end,
            last_end: words.first().map_or(0, |word| word.span.start),
            names,
            scope: Vec::new(),
            bars: 0,
            depth: 0,
            report,
            damaged,
            failed: damaged,
        }
    }

    /// The next word, or the next letter of a name that splits.
    pub(super) fn peek(&mut self) -> Token {
        let Some(&word) = self.words.get(self.at) else { return self.end };
        if !self.settled {
            self.settled = true;
            self.letter = (word.kind == TokenKind::Name && self.splits(word)).then_some(0);
            if self.letter.is_some() {
                self.note_split(word);
            }
        }
        match self.letter {
            Some(i) => {
                let start = word.span.start as usize + i;
                Token { kind: TokenKind::Name, span: Span::new(word.span.source, start, start + 1) }
            }
            None => word,
        }
    }

    /// The word after the next one, as it is written.
    pub(super) fn second(&self) -> Token {
        self.words.get(self.at + 1).copied().unwrap_or(self.end)
    }

    /// The word after that.
    pub(super) fn third(&self) -> Token {
        self.words.get(self.at + 2).copied().unwrap_or(self.end)
    }

    /// The next word as it is written, without splitting; `None` at the end.
    pub(super) fn raw(&self) -> Option<Token> {
        self.words.get(self.at).copied()
    }

    /// The word before the next one, as it is written.
    pub(super) fn previous(&self) -> Option<Token> {
        self.at.checked_sub(1).and_then(|i| self.words.get(i)).copied()
    }

    /// Takes the next word.
    pub(super) fn take(&mut self) -> Token {
        let taken = self.peek();
        let length = self.words.get(self.at).map_or(0, |word| word.span.range().len());
        match self.letter {
            Some(i) if i + 1 < length => self.letter = Some(i + 1),
            _ => {
                self.at = (self.at + 1).min(self.words.len());
                self.letter = None;
                self.settled = false;
            }
        }
        self.last_end = taken.span.end;
        taken
    }

    /// Takes the next word if it is of this kind.
    pub(super) fn accept(&mut self, kind: TokenKind) -> Option<Token> {
        (self.peek().kind == kind).then(|| self.take())
    }

    /// Moves on to the word with this number.
    pub(super) fn skip(&mut self, count: usize) {
        for _ in 0..count {
            self.settled = true;
            self.letter = None;
            self.take();
        }
    }

    /// The text of a span.
    pub(super) fn written(&self, span: Span) -> &'p str {
        self.text.get(span.range()).unwrap_or("")
    }

    /// From the start of `first` to the end of what was taken last.
    pub(super) fn since(&self, first: Span) -> Span {
        Span { end: self.last_end.max(first.start), ..first }
    }

    /// The name a word stands for.
    pub(super) fn name(&self, token: Token) -> &'p str {
        names::canonical(&token, self.text)
    }

    /// What a name means here.
    pub(super) fn meaning(&self, name: &str) -> Meaning {
        if self.scope.iter().any(|known| known == name) { Meaning::Value } else { self.names.meaning(name) }
    }

    /// Whether a name is unknown, and all its letters may be split off.
    pub(super) fn splits(&self, word: Token) -> bool {
        let name = self.written(word.span);
        if name.len() < 2 || !matches!(self.meaning(name), Meaning::Unknown) {
            return false;
        }
        let letter = |i: usize| self.scope.iter().any(|known| *known == name[i..=i]) || self.names.splits(&name[i..=i]);
        let bracket = self.second().kind == TokenKind::Open(Bracket::Round);
        (!bracket || names::is_product(name)) && (0..name.len()).all(letter)
    }

    fn note_split(&mut self, word: Token) {
        let name = self.written(word.span);
        if !names::is_product(name) {
            let letters: Vec<String> = name.chars().map(String::from).collect();
            let reading = letters.join("*");
            let message = format!("`{name}` read as {reading}; define `{name}` if it is a name of its own");
            self.note(word.span, message);
        }
    }

    /// Says once how something was read.
    pub(super) fn note(&mut self, span: Span, message: impl Into<String>) {
        self.report.once(Diagnostic::note(span, message));
    }

    /// Reports an error and goes on.
    pub(super) fn error(&mut self, error: Diagnostic) {
        self.failed = true;
        self.report.diagnostics.push(error);
    }

    /// Reports an error at which reading of the statement stops. In a statement that the lexer
    /// has complained about it is not news.
    pub(super) fn stop(&mut self, error: Diagnostic) -> Stop {
        self.failed = true;
        if !self.damaged {
            self.report.diagnostics.push(error);
        }
        Stop
    }

    /// Goes one level down; an error beyond the limit.
    pub(super) fn nest(&mut self) -> Read<()> {
        self.depth += 1;
        if self.depth > MAX_NESTING {
            let here = self.peek().span;
            let message = format!("this is nested more than {MAX_NESTING} levels deep");
            return Err(self.stop(Diagnostic::error(here, message).help("give inner parts names of their own")));
        }
        Ok(())
    }

    /// Runs one level down.
    pub(super) fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Read<T>) -> Read<T> {
        self.nest()?;
        let found = read(self);
        self.depth -= 1;
        found
    }

    /// Reports a name that nothing declares. Each name is reported once.
    pub(super) fn unknown(&mut self, token: Token, called: bool) {
        self.failed = true;
        let name = self.name(token);
        if self.report.said.contains(name) {
            return;
        }
        self.report.said.insert(name.to_owned());
        let error = match self.report.is_full() {
            true => Diagnostic::error(token.span, format!("unknown name `{name}`")),
            false => self.unknown_name(name, token.span, called),
        };
        self.report.diagnostics.push(error);
    }

    fn unknown_name(&self, name: &str, span: Span, called: bool) -> Diagnostic {
        let shown = printable(name, super::lexer::MAX_NAME);
        if let Some(known) = self.same_but_for_case(name) {
            return Diagnostic::error(span, format!("unknown name `{shown}`: upper and lower case differ")).help(
                match name.len() {
                    1 if !names::COORDINATES.contains(&known.as_str()) => {
                        format!("write `{known}`, or define it: `{name} = 1`")
                    }
                    _ => format!("write `{known}`"),
                },
            );
        }
        if super::functions::is_not_yet(name) {
            return not_yet(name, span);
        }
        if let Some(here) = super::functions::elsewhere(name) {
            let error = Diagnostic::error(span, format!("unknown function `{shown}`"));
            return error.help(format!("here it is written `{here}`"));
        }
        let what = if called && name.len() > 1 { "function" } else { "name" };
        let error = Diagnostic::error(span, format!("unknown {what} `{shown}`"));
        error.help(self.mend(name, called))
    }

    /// The known name that differs only in upper and lower case.
    fn same_but_for_case(&self, name: &str) -> Option<String> {
        let scope = self.scope.iter().map(String::as_str);
        scope.chain(self.names.known()).find(|known| known.eq_ignore_ascii_case(name)).map(str::to_owned)
    }

    /// What to do about an unknown name.
    fn mend(&self, name: &str, called: bool) -> String {
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = &name[letters.len()..];
        if !digits.is_empty() && matches!(self.meaning(letters), Meaning::Value) {
            return format!("write `{letters}^{digits}` or `{letters}*{digits}`");
        }
        if let Some(application) = self.application(name).filter(|_| !called) {
            return format!("write `{application}`");
        }
        let scope = self.scope.iter().map(String::as_str);
        let near = nearest(name, scope.chain(self.names.known()).take(MAX_COMPARED));
        if !near.is_empty() && name.chars().count() > 1 {
            return format!("did you mean {}?", one_of(&near));
        }
        if name.chars().count() == 1 {
            return format!(
                "make it a parameter, `{name} = 1 in [0, 2]`, which `--set {name}=1` then moves, or define it, `{name} = 1`"
            );
        }
        match self.segments(name) {
            Some(product) if !called => format!("write `{product}` if a product is meant, or define it: `{name} = 1`"),
            _ if called => format!("define it: `{name}(u) = u^2`"),
            _ if let Some((letter, product)) = self.undefined_letter(name) => {
                format!("`{letter}` is not defined; with `{letter} = 1` it is read as `{product}`")
            }
            _ => format!("define it: `{name} = 1`"),
        }
    }

    /// `sinx` as `sin x`: a function that takes one argument, and what can be one.
    fn application(&self, name: &str) -> Option<String> {
        let ends = (1..name.len()).rev().filter(|&end| name.is_char_boundary(end));
        ends.map(|end| name.split_at(end)).find_map(|(function, argument)| {
            let applies = match self.meaning(function) {
                Meaning::Builtin(function) => function.applies_bare(),
                Meaning::Function(count) => count == 1 && function.len() > 1,
                Meaning::Value | Meaning::Unknown => false,
            };
            let letters = argument != "e" && argument.bytes().all(|b| b.is_ascii_alphabetic());
            let splits = letters && self.segments_of(argument).is_some();
            (applies && splits).then(|| format!("{function} {argument}"))
        })
    }

    /// The only letter that keeps a short name from being a product, and the product.
    fn undefined_letter<'n>(&self, name: &'n str) -> Option<(&'n str, String)> {
        /// Longer names are words, not products.
        const MAX_PRODUCT: usize = 4;
        if name.len() > MAX_PRODUCT || !name.bytes().all(|b| b.is_ascii_alphabetic()) {
            return None;
        }
        let letters: Vec<&str> = (0..name.len()).map(|i| &name[i..=i]).collect();
        let mut unknown: Vec<&str> = letters.iter().copied().filter(|letter| !self.names.splits(letter)).collect();
        unknown.dedup();
        match unknown[..] {
            [letter] if letters.len() > 1 => Some((letter, letters.join("*"))),
            _ => None,
        }
    }

    /// A name as a product of known names, the longest first at each place.
    fn segments(&self, name: &str) -> Option<String> {
        self.segments_of(name).filter(|parts| parts.len() > 1).map(|parts| parts.join("*"))
    }

    fn segments_of<'n>(&self, name: &'n str) -> Option<Vec<&'n str>> {
        let mut parts: Vec<&str> = Vec::new();
        let mut rest = name;
        while !rest.is_empty() && name.is_ascii() {
            let known = |n: &usize| matches!(self.meaning(&rest[..*n]), Meaning::Value);
            let length = (1..=rest.len()).rev().find(known)?;
            parts.push(&rest[..length]);
            rest = &rest[length..];
        }
        Some(parts)
    }
}

/// The error for a known function that the language does not have yet, called or defined.
pub(super) fn not_yet(name: &str, span: Span) -> Diagnostic {
    let error = Diagnostic::error(span, format!("the function `{name}` is not built yet"));
    error.help("give a function of your own another name")
}
