//! What stands between operators: numbers, names, brackets, bars, roots, sums.
//!
//! In: words from the reader. Out: the operand, with its component behind a dot. Separate from the operators
//! because here names decide what is read.

use super::application::Applied;
use super::ast::{Expr, ExprKind, Name, SeriesRange, UnaryOp};
use super::names::Meaning;
use super::reader::{Read, Reader, Stop};
use super::token::{Bracket, Token, TokenKind};
use crate::diag::{Diagnostic, Span, printable};
use crate::num::rational::Rational;

impl Reader<'_> {
    /// An operand and the components behind it.
    pub(super) fn operand(&mut self) -> Read<Expr> {
        let mut value = self.bare_operand()?;
        let mut levels = 0;
        while self.peek().kind == TokenKind::Dot {
            let start = value.span;
            let dot = self.take();
            let word = self.peek();
            let name = self.written(word.span);
            if word.kind != TokenKind::Name || !super::names::COORDINATES.contains(&name) {
                let error = Diagnostic::error(dot.span.to(word.span), "expected a component behind the dot");
                return Err(self.stop(error.help("the components of a vector are `.x`, `.y` and `.z`")));
            }
            self.take();
            let component = Name { text: name.to_owned(), span: word.span };
            self.nest()?;
            levels += 1;
            value = Expr { kind: ExprKind::Component(Box::new(value), component), span: self.since(start) };
        }
        self.depth -= levels;
        Ok(value)
    }

    fn bare_operand(&mut self) -> Read<Expr> {
        let word = self.peek();
        match word.kind {
            TokenKind::Number => self.number(),
            TokenKind::Name | TokenKind::Symbol => self.named(),
            TokenKind::Invalid => {
                self.take();
                Ok(Expr { kind: ExprKind::Invalid, span: word.span })
            }
            TokenKind::Open(Bracket::Round) => self.bracketed(),
            TokenKind::Open(Bracket::Square) => {
                let open = self.take();
                let items = self.arguments(open, Bracket::Square)?;
                Ok(Expr { kind: ExprKind::List(items), span: self.since(open.span) })
            }
            TokenKind::Bar => self.bars(),
            TokenKind::SquareRoot | TokenKind::CubeRoot => self.root(),
            _ => Err(self.missing_operand()),
        }
    }

    pub(super) fn number(&mut self) -> Read<Expr> {
        let word = self.take();
        let kind = match Rational::from_decimal(self.written(word.span)) {
            Some(value) => ExprKind::Number(value),
            None => {
                let limit = crate::num::rational::MAX_EXPONENT;
                self.error(
                    Diagnostic::error(word.span, "this number is too large or too small")
                        .help(format!("exponents go from -{limit} to {limit}")),
                );
                ExprKind::Invalid
            }
        };
        Ok(Expr { kind, span: word.span })
    }

    /// Raised digits as a number.
    pub(super) fn raised(&mut self) -> Read<Expr> {
        let word = self.take();
        let value = super::lexer::raised_digits(self.written(word.span))
            .and_then(|(minus, digits)| Some((minus, Rational::from_decimal(&digits)?)));
        let Some((minus, value)) = value else {
            return Err(self.stop(Diagnostic::error(word.span, "this raised text is no whole number")));
        };
        let number = Expr { kind: ExprKind::Number(value), span: word.span };
        let kind = if minus { ExprKind::Unary(UnaryOp::Neg, Box::new(number)) } else { number.kind };
        Ok(Expr { kind, span: word.span })
    }

    /// `(a)` or `(a, b, c)`
    pub(super) fn bracketed(&mut self) -> Read<Expr> {
        let open = self.take();
        let mut items = self.arguments(open, Bracket::Round)?;
        let span = self.since(open.span);
        match items.pop() {
            Some(only) if items.is_empty() => Ok(Expr { kind: only.kind, span }),
            Some(last) => {
                items.push(last);
                Ok(Expr { kind: ExprKind::Vector(items), span })
            }
            None => Err(self.stop(Diagnostic::error(span, "there is nothing in these brackets"))),
        }
    }

    /// Expressions with commas between them, up to the bracket that closes `open`.
    pub(super) fn arguments(&mut self, open: Token, bracket: Bracket) -> Read<Vec<Expr>> {
        let bars = std::mem::take(&mut self.bars);
        let mut items = Vec::new();
        if self.accept(TokenKind::Close(bracket)).is_none() {
            loop {
                items.push(self.expression()?);
                if self.accept(TokenKind::Comma).is_none() {
                    break;
                }
            }
            self.close(open, bracket)?;
        }
        self.bars = bars;
        Ok(items)
    }

    /// Takes the closing bracket, or says that it is missing and where its partner stands.
    pub(super) fn close(&mut self, open: Token, bracket: Bracket) -> Read<()> {
        if self.accept(TokenKind::Close(bracket)).is_some() {
            return Ok(());
        }
        let word = self.peek();
        if let Some(stop) = self.foreign_operator(word) {
            return Err(stop);
        }
        let (opening, closing) = bracket.pair();
        let error = match word.kind {
            TokenKind::End | TokenKind::Close(_) | TokenKind::Open(Bracket::Curly) => {
                Diagnostic::error(word.span, format!("missing `{closing}`"))
            }
            TokenKind::Equal => Diagnostic::error(word.span, "an equation cannot stand inside brackets")
                .help(format!("if the bracket ends before `=`, write `{closing}` there")),
            _ => {
                let found = printable(self.written(word.span), 20);
                Diagnostic::error(word.span, format!("expected `,` or `{closing}`, found `{found}`"))
            }
        };
        Err(self.stop(error.label("expected here").also(open.span, format!("this `{opening}` is open"))))
    }

    /// `|a|`
    fn bars(&mut self) -> Read<Expr> {
        let open = self.take();
        self.bars += 1;
        let inner = self.expression()?;
        if self.accept(TokenKind::Bar).is_none() {
            let word = self.peek();
            if let Some(stop) = self.foreign_operator(word) {
                return Err(stop);
            }
            return Err(self.unpaired_bar(open));
        }
        self.bars -= 1;
        Ok(Expr { kind: ExprKind::Bars(Box::new(inner)), span: self.since(open.span) })
    }

    /// The error for a bar without partner; `||` between two operands was meant as `or`.
    fn unpaired_bar(&mut self, open: Token) -> Stop {
        let start = open.span.start as usize;
        let double = self.text[..start].ends_with('|') || self.text[open.span.end as usize..].starts_with('|');
        let error = if double {
            let from = if self.text[..start].ends_with('|') { start - 1 } else { start };
            Diagnostic::error(Span::new(open.span.source, from, from + 2), "`||` is not an operator here")
                .help("write `or`")
        } else {
            Diagnostic::error(open.span, "this bar has no partner")
                .help("bars stand on both sides, `|x|`; or write `abs(x)`")
        };
        self.stop(error)
    }

    /// `√` takes one factor with its power.
    fn root(&mut self) -> Read<Expr> {
        let sign = self.take();
        let text = if sign.kind == TokenKind::SquareRoot { "sqrt" } else { "cbrt" };
        let operand = self.peek();
        let inner = self.nested(Self::power)?;
        self.note_root(sign, operand, &inner);
        let name = Name { text: text.to_owned(), span: sign.span };
        Ok(Expr { kind: ExprKind::Call(name, vec![inner]), span: self.since(sign.span) })
    }

    /// A name: a value, a call, or a function and what follows it.
    fn named(&mut self) -> Read<Expr> {
        let word = self.take();
        let name = self.name(word);
        let bracket = self.peek().kind == TokenKind::Open(Bracket::Round);
        let meaning = match super::functions::find(name) {
            Some(function) if bracket && super::functions::is_of_attributes(name) => Meaning::Builtin(function),
            _ => self.meaning(name),
        };
        match meaning {
            Meaning::Value => {
                self.note_angle(word);
                Ok(Expr { kind: ExprKind::Name(name.to_owned()), span: word.span })
            }
            Meaning::Builtin(function) if bracket && matches!(function.name, "sum" | "product") => self.series(word),
            Meaning::Builtin(function) => self.applied(word, Applied::Builtin(function)),
            Meaning::Function(count) => self.applied(word, Applied::Own(count)),
            Meaning::Unknown => {
                self.unknown(word, bracket);
                if bracket || self.is_function_in_other_case(name) {
                    return self.applied(word, Applied::Unknown);
                }
                Ok(Expr { kind: ExprKind::Invalid, span: word.span })
            }
        }
    }

    fn is_function_in_other_case(&self, name: &str) -> bool {
        super::functions::find(&name.to_lowercase()).is_some()
    }

    /// `sum(k = 1..n, term)`, `product(c in list, term)`
    fn series(&mut self, word: Token) -> Read<Expr> {
        let product = self.written(word.span) == "product";
        let open = self.take();
        let bars = std::mem::take(&mut self.bars);
        let variable = self.running_name(word)?;
        let over = match self.accept(TokenKind::Equal) {
            Some(_) => self.integers()?,
            None => {
                self.take();
                SeriesRange::List(Box::new(self.expression()?))
            }
        };
        if self.accept(TokenKind::Comma).is_none() {
            let here = self.peek().span;
            let error = Diagnostic::error(here, "expected `,` and the term behind the range");
            return Err(self.stop(error.also(open.span, "this `(` is open").help("write `sum(k = 1..3, k*x)`")));
        }
        self.scope.push(variable.text.clone());
        let body = self.expression();
        self.scope.pop();
        let body = Box::new(body?);
        self.close(open, Bracket::Round)?;
        self.bars = bars;
        Ok(Expr { kind: ExprKind::Series { product, variable, over, body }, span: self.since(word.span) })
    }

    /// The running name of a sum, with `=` or `in` next.
    fn running_name(&mut self, function: Token) -> Read<Name> {
        let word = self.raw().unwrap_or_else(|| self.peek());
        let named = matches!(word.kind, TokenKind::Name | TokenKind::Symbol);
        if named && matches!(self.second().kind, TokenKind::Equal | TokenKind::In) {
            self.skip(1);
            return Ok(Name { text: self.name(word).to_owned(), span: word.span });
        }
        let name = self.written(function.span);
        let message = format!("expected a running name: `{name}` needs to know what it runs over");
        let help = format!("write `{name}(k = 1..3, k*x)` or `{name}(k in [1, 2, 3], k*x)`");
        Err(self.stop(Diagnostic::error(word.span, message).help(help)))
    }

    fn integers(&mut self) -> Read<SeriesRange> {
        let (low, high) = self.range()?;
        Ok(SeriesRange::Integers(Box::new(low), Box::new(high)))
    }

    /// `a..b`
    pub(super) fn range(&mut self) -> Read<(Expr, Expr)> {
        let low = self.nested(Self::sum)?;
        if self.accept(TokenKind::Range).is_none() {
            let here = self.peek().span;
            return Err(
                self.stop(Diagnostic::error(here, "expected `..` and the end of the range").help("write `1..3`"))
            );
        }
        Ok((low, self.nested(Self::sum)?))
    }
}
