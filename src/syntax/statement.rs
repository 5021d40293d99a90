//! Statements: surfaces, definitions, functions, parameters, blocks.
//!
//! In: the outline of a statement and the program's names. Out: a [`Statement`], in any case: what could not
//! be read is [`ExprKind::Invalid`] in it. Separate from expressions, which know nothing of statements.

use super::ast::{BlockKind, Expr, ExprKind, Name, Statement, StatementKind};
use super::heads::HeadKind;
use super::names::{self, Names, Outline};
use super::reader::{Read, Reader, Report};
use super::token::{Bracket, Token, TokenKind};
use crate::diag::{Diagnostic, Span};

/// A function has at most so many parameters: each is looked for at every name of its body.
pub const MAX_PARAMETERS: usize = 100;

/// Reads one statement.
pub(super) fn statement(outline: &Outline<'_>, names: &Names, report: &mut Report) -> Statement {
    let (Some(first), Some(last)) = (outline.words.first(), outline.words.last()) else {
        return Statement { kind: surface_of(invalid(Span::default())), span: Span::default() };
    };
    let span = first.span.to(last.span);
    let mut reader = Reader::new(outline.text, outline.words, names, report);
    let name = Name { text: reader.name(outline.head.name).to_owned(), span: outline.head.name.span };
    let kind = match outline.head.kind {
        HeadKind::Surface => reader.surface(outline, span),
        HeadKind::Definition => {
            reader.check_name(outline.head.name);
            reader.skip(outline.head.length);
            let value = reader.whole_expression().unwrap_or(invalid(span));
            StatementKind::Definition { name, value }
        }
        HeadKind::Parameter => reader.parameter(outline, name, span),
        HeadKind::Function => reader.function(outline, name, span),
        HeadKind::Block(kind) => reader.block(outline, kind, name),
        HeadKind::Include => reader.include(outline, span),
    };
    Statement { kind, span }
}

fn invalid(span: Span) -> Expr {
    Expr { kind: ExprKind::Invalid, span }
}

fn surface_of(left: Expr) -> StatementKind {
    StatementKind::Surface { left, right: None, attributes: Vec::new() }
}

impl Reader<'_> {
    /// An expression with nothing behind it.
    pub(super) fn whole_expression(&mut self) -> Read<Expr> {
        let value = self.expression()?;
        self.finish()?;
        Ok(value)
    }

    /// Nothing more may follow.
    pub(super) fn finish(&mut self) -> Read<()> {
        if self.peek().kind == TokenKind::End { Ok(()) } else { Err(self.leftover()) }
    }

    fn surface(&mut self, outline: &Outline<'_>, span: Span) -> StatementKind {
        let read = |reader: &mut Self| -> Read<StatementKind> {
            let left = reader.expression()?;
            let right = match reader.accept(TokenKind::Equal) {
                Some(_) => Some(reader.expression()?),
                None => None,
            };
            let attributes = match reader.peek().kind {
                TokenKind::Open(Bracket::Curly) => reader.attributes()?,
                _ => Vec::new(),
            };
            reader.finish()?;
            Ok(StatementKind::Surface { left, right, attributes })
        };
        match read(self) {
            Ok(kind) => {
                self.note_surface(outline);
                kind
            }
            Err(_) => surface_of(invalid(span)),
        }
    }

    /// `r = 1` and `xy = 1` could have been definitions, `xy(z) = 1` a function.
    fn note_surface(&mut self, outline: &Outline<'_>) {
        let [first, second, ..] = outline.words else { return };
        let name = self.name(*first);
        let named = matches!(first.kind, TokenKind::Name | TokenKind::Symbol);
        if !named || self.failed || names::COORDINATES.contains(&name) {
            return;
        }
        if second.kind == TokenKind::Equal && !names::CONSTANTS.contains(&name) {
            let written = self.written(first.span);
            self.note(
                first.span,
                format!(
                    "`{written} = …` read as a surface; use `{written}` in another statement to make it a definition"
                ),
            );
        } else if !outline.head.parameters.is_empty() && names::is_product(name) {
            self.note(
                first.span,
                format!("`{name}(…) = …` read as a surface, not as a function; give a function another name"),
            );
        }
    }

    /// Reports a name that no program may define.
    fn check_name(&mut self, name: Token) {
        let text = self.name(name);
        let what = match text {
            _ if names::COORDINATES.contains(&text) => "a coordinate",
            _ if names::CONSTANTS.contains(&text) => "a constant",
            _ if names::is_fixed(text) => "a function of the language",
            _ => return,
        };
        let error = Diagnostic::error(name.span, format!("`{text}` is {what} and cannot be defined"));
        self.error(error.help("choose another name"));
    }

    fn parameter(&mut self, outline: &Outline<'_>, name: Name, span: Span) -> StatementKind {
        self.check_name(outline.head.name);
        self.skip(outline.head.length);
        let failed = |name| StatementKind::Parameter {
            name,
            value: invalid(span),
            low: invalid(span),
            high: invalid(span),
            step: None,
        };
        match self.range_of_parameter() {
            Ok((value, low, high, step)) => StatementKind::Parameter { name, value, low, high, step },
            Err(_) => failed(name),
        }
    }

    /// `0.5 in [0, 1] step 0.1`
    fn range_of_parameter(&mut self) -> Read<(Expr, Expr, Expr, Option<Expr>)> {
        let value = self.expression()?;
        if self.accept(TokenKind::In).is_none() {
            return Err(self.leftover());
        }
        let word = self.peek();
        let range = Diagnostic::error(word.span, "expected the range of a parameter").help("write `a = 1 in [0, 2]`");
        if word.kind != TokenKind::Open(Bracket::Square) {
            return Err(self.stop(range));
        }
        let open = self.take();
        let bounds = self.arguments(open, Bracket::Square)?;
        let place = self.since(open.span);
        let Ok([low, high]) = <[Expr; 2]>::try_from(bounds) else {
            let error = Diagnostic::error(place, "a range has two ends").help("write `a = 1 in [0, 2]`");
            return Err(self.stop(error));
        };
        let next = self.peek();
        let step = if next.kind == TokenKind::Name && self.written(next.span) == "step" {
            self.take();
            Some(self.expression()?)
        } else {
            None
        };
        self.finish()?;
        Ok((value, low, high, step))
    }

    fn function(&mut self, outline: &Outline<'_>, name: Name, span: Span) -> StatementKind {
        if super::functions::is_of_attributes(&name.text) {
            let message = format!("`{}` is a function of clips and colours and cannot be defined", name.text);
            self.error(Diagnostic::error(name.span, message).help("choose another name"));
        }
        if super::functions::is_not_yet(&name.text) {
            self.error(super::reader::not_yet(&name.text, name.span));
        }
        let mut parameters: Vec<Name> = Vec::new();
        for &word in outline.head.parameters.iter().take(MAX_PARAMETERS) {
            let text = self.name(word).to_owned();
            if super::functions::find(&text).is_some() {
                let error = Diagnostic::error(word.span, format!("`{text}` is a function of the language"));
                self.error(error.help("choose another name for the parameter"));
            }
            if let Some(first) = parameters.iter().find(|known| known.text == text) {
                let error = Diagnostic::error(word.span, format!("the parameter `{text}` stands twice"));
                self.error(error.also(first.span, "first here"));
            }
            parameters.push(Name { text, span: word.span });
        }
        if let Some(word) = outline.head.parameters.get(MAX_PARAMETERS) {
            let error = Diagnostic::error(word.span, format!("a function has at most {MAX_PARAMETERS} parameters"));
            self.error(error);
        }
        self.skip(outline.head.length);
        self.scope = parameters.iter().map(|parameter| parameter.text.clone()).collect();
        let body = self.whole_expression().unwrap_or(invalid(span));
        StatementKind::Function { name, parameters, body }
    }

    fn block(&mut self, outline: &Outline<'_>, kind: BlockKind, name: Name) -> StatementKind {
        self.skip(outline.head.length);
        let attributes = self.attributes().unwrap_or_default();
        let _ = self.finish();
        let name = (kind == BlockKind::Material).then_some(name);
        StatementKind::Block { kind, name, attributes }
    }

    fn include(&mut self, outline: &Outline<'_>, span: Span) -> StatementKind {
        self.skip(outline.head.length);
        let word = self.take();
        let path = super::lexer::unquoted(self.written(word.span)).to_owned();
        let _ = self.finish();
        if path.trim().is_empty() {
            self.error(Diagnostic::error(span, "this file has no name").help("write `include \"gold.imp\"`"));
        }
        StatementKind::Include { path, path_span: word.span }
    }
}
