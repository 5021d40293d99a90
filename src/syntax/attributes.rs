//! The entries of a block: `{ color: #4af, clip: box(-2..2, -2..2, -2..2), name: "ball" }`.
//!
//! In: the words from `{` to `}`. Out: keys with their values. Each entry is read by itself, so that a mistake in one
//! does not hide those in the others.

use super::ast::{Attribute, AttributeValue, Expr, ExprKind, Name};
use super::functions;
use super::reader::{Read, Reader};
use super::token::{Bracket, Token, TokenKind};
use crate::diag::{Diagnostic, printable};

impl Reader<'_> {
    /// The entries between braces; the reader stands at `{`.
    pub(super) fn attributes(&mut self) -> Read<Vec<Attribute>> {
        let open = self.take();
        let entries = self.entries(open)?;
        let mut attributes: Vec<Attribute> = Vec::new();
        for entry in entries {
            let Some(attribute) = self.entry(&entry) else { continue };
            if let Some(first) = attributes.iter().find(|known| known.key.text == attribute.key.text) {
                let error = Diagnostic::error(attribute.key.span, format!("`{}` stands twice", attribute.key.text));
                let error = error.also(first.key.span, "first here");
                self.error(error);
            }
            attributes.push(attribute);
            if attributes.len() > MAX_ENTRIES {
                let error = Diagnostic::error(open.span, format!("this block has more than {MAX_ENTRIES} entries"));
                return Err(self.stop(error));
            }
        }
        Ok(attributes)
    }

    /// The words of each entry, up to the brace that closes `open`.
    fn entries(&mut self, open: Token) -> Read<Vec<Vec<Token>>> {
        let mut entries = vec![Vec::new()];
        let mut depth = 0usize;
        loop {
            let Some(word) = self.raw() else {
                let end = self.peek();
                let error = Diagnostic::error(end.span, "missing `}`").label("expected here");
                return Err(self.stop(error.also(open.span, "this `{` is open")));
            };
            self.skip(1);
            match word.kind {
                TokenKind::Close(Bracket::Curly) if depth == 0 => break,
                TokenKind::Comma if depth == 0 => {
                    entries.push(Vec::new());
                    continue;
                }
                TokenKind::Open(_) => depth += 1,
                TokenKind::Close(_) => depth = depth.saturating_sub(1),
                _ => {}
            }
            if let Some(last) = entries.last_mut() {
                last.push(word);
            }
        }
        entries.retain(|entry| !entry.is_empty());
        Ok(entries)
    }

    fn entry(&mut self, words: &[Token]) -> Option<Attribute> {
        let mut reader = Reader::new(self.text, words, self.names, self.report);
        // A name that the program defines is the program's.
        let free = |name: &&&str| self.names.declared(name).is_none();
        reader.scope = functions::OF_SURFACE.iter().filter(free).map(|name| (*name).to_owned()).collect();
        let found = reader.key_and_value();
        let failed = reader.failed;
        self.failed |= failed;
        found.ok()
    }

    fn key_and_value(&mut self) -> Read<Attribute> {
        let word = self.raw().unwrap_or_else(|| self.peek());
        let text = self.written(word.span);
        self.skip(1);
        if word.kind == TokenKind::Name && self.raw().is_some_and(|sign| sign.kind == TokenKind::Equal) {
            let sign = self.peek().span;
            let error = Diagnostic::error(sign, format!("expected `:` behind `{}`, found `=`", printable(text, 20)));
            return Err(self.stop(error.help(format!("write `{}: ...`", printable(text, 20)))));
        }
        if word.kind != TokenKind::Name || self.raw().is_none_or(|colon| colon.kind != TokenKind::Colon) {
            let shown = printable(text, 20);
            let error = Diagnostic::error(word.span, format!("expected `key: value`, found `{shown}`"));
            return Err(self.stop(error.help("entries look like `color: red`, with commas between them")));
        }
        self.skip(1);
        let key = Name { text: text.to_owned(), span: word.span };
        let value = self.attribute_value(&key.text, false)?;
        if self.peek().kind == TokenKind::Name && self.second().kind == TokenKind::Colon {
            let next = self.peek().span;
            let error = Diagnostic::error(next, format!("expected `,` before `{}`", printable(self.written(next), 20)));
            return Err(self.stop(error.help("entries have commas between them")));
        }
        self.finish()?;
        Ok(Attribute { key, value })
    }

    /// The value behind a key, or an argument of a call that is one.
    fn attribute_value(&mut self, key: &str, is_argument: bool) -> Read<AttributeValue> {
        let Some(word) = self.raw() else {
            let end = self.peek().span;
            return Err(self.stop(Diagnostic::error(end, "the value is missing")));
        };
        let written = self.written(word.span);
        match word.kind {
            // Reported where it was found: there is no value to complain about.
            TokenKind::Invalid => Err(self.stop(Diagnostic::error(word.span, "this is no value"))),
            TokenKind::Color => {
                self.skip(1);
                Ok(AttributeValue::Color(super::lexer::color(written).unwrap_or_default(), word.span))
            }
            TokenKind::Text => {
                self.skip(1);
                Ok(AttributeValue::Text(super::lexer::unquoted(written).to_owned(), word.span))
            }
            TokenKind::Number if self.size(word).is_some() => {
                let (width, height) = self.size(word).unwrap_or_default();
                let span = word.span.to(self.second().span);
                self.skip(2);
                Ok(AttributeValue::Size(width, height, span))
            }
            TokenKind::Name if functions::is_paint(written) && self.is_call() => self.paint_call(key, word),
            TokenKind::Name if key != "clip" && self.ends_after_one() && !self.is_formula(key, word, is_argument) => {
                self.skip(1);
                let kind = ExprKind::Name(written.to_owned());
                Ok(AttributeValue::Expr(Expr { kind, span: word.span }))
            }
            TokenKind::Name if written == "box" && self.second().kind == TokenKind::Open(Bracket::Round) => {
                self.box_of_ranges()
            }
            _ => Ok(AttributeValue::Expr(self.expression()?)),
        }
    }

    /// Whether the next word has a bracket behind it, and is no function of the program.
    fn is_call(&self) -> bool {
        self.second().kind == TokenKind::Open(Bracket::Round)
            && self.raw().is_some_and(|word| self.names.declared(self.written(word.span)).is_none())
    }

    /// `checker(0.5, white, navy)`
    fn paint_call(&mut self, key: &str, word: Token) -> Read<AttributeValue> {
        self.nest()?;
        let name = Name { text: self.written(word.span).to_owned(), span: word.span };
        self.skip(1);
        let open = self.take();
        let mut arguments = Vec::new();
        loop {
            arguments.push(self.attribute_value(key, true)?);
            if self.accept(TokenKind::Comma).is_none() {
                break;
            }
        }
        self.close(open, Bracket::Round)?;
        self.depth -= 1;
        Ok(AttributeValue::Call(name, arguments, self.since(word.span)))
    }

    /// Whether a single word is read as a formula, in which `xy` is a product: where numbers are expected, and among the arguments
    /// of a call unless it is the name of nothing, as colours are.
    fn is_formula(&self, key: &str, word: Token, is_argument: bool) -> bool {
        let is_number = matches!(key, "roughness" | "opacity" | "emission");
        (is_number || is_argument) && self.splits(word)
    }

    /// Whether the value is one word, such as `red`: that need not be a name of the program.
    fn ends_after_one(&self) -> bool {
        matches!(
            self.second().kind,
            TokenKind::End | TokenKind::Semicolon | TokenKind::Comma | TokenKind::Close(Bracket::Round)
        ) || self.second().kind == TokenKind::Name && self.third().kind == TokenKind::Colon
    }

    /// `800x600`, which is a number and a name to the lexer.
    fn size(&self, word: Token) -> Option<(u32, u32)> {
        let second = self.second();
        let height = self.written(second.span).strip_prefix(['x', 'X'])?;
        let joined = second.kind == TokenKind::Name && word.span.end == second.span.start;
        let digits = height.bytes().all(|b| b.is_ascii_digit());
        if joined && digits { Some((self.written(word.span).parse().ok()?, height.parse().ok()?)) } else { None }
    }

    /// `box(x0..x1, y0..y1, z0..z1)`
    fn box_of_ranges(&mut self) -> Read<AttributeValue> {
        let start = self.peek().span;
        self.skip(1);
        let open = self.take();
        let mut ranges = vec![self.range()?];
        while self.accept(TokenKind::Comma).is_some() {
            ranges.push(self.range()?);
        }
        self.close(open, Bracket::Round)?;
        let span = self.since(start);
        if ranges.len() != 3 {
            let error = Diagnostic::error(span, format!("a box has three ranges, found {}", ranges.len()));
            return Err(self.stop(error.help("write `box(x0..x1, y0..y1, z0..z1)`")));
        }
        Ok(AttributeValue::Box(ranges, span))
    }
}

/// Blocks have a dozen keys; more entries than this are no block.
const MAX_ENTRIES: usize = 100;
