//! Sums, products, comparisons: the operators of an expression by rising precedence.
//!
//! In: words from the reader. Out: flat sums and products. The order is `or`, `and`, `not`, comparisons, `+ -`,
//! `* / %` and products without a sign, signs, `^`. Separate from what stands between the operators (`operand`).

use super::ast::{Expr, ExprKind, Factor, FactorOp, Term, UnaryOp};
use super::reader::{Read, Reader};
use super::token::{Bracket, Token, TokenKind};
use crate::diag::{Diagnostic, Span};

impl Reader<'_> {
    /// A whole expression, regions included; one level down.
    pub(super) fn expression(&mut self) -> Read<Expr> {
        self.nested(Self::alternatives)
    }

    /// `a or b or c`
    fn alternatives(&mut self) -> Read<Expr> {
        let first = self.conjunction()?;
        let start = first.span;
        let mut list = vec![first];
        while self.accept(TokenKind::Or).is_some() {
            list.push(self.conjunction()?);
        }
        Ok(self.gather(start, list, ExprKind::Or))
    }

    /// `a and b and c`
    fn conjunction(&mut self) -> Read<Expr> {
        let first = self.negation()?;
        let start = first.span;
        let mut list = vec![first];
        while self.accept(TokenKind::And).is_some() {
            list.push(self.negation()?);
        }
        Ok(self.gather(start, list, ExprKind::And))
    }

    /// The only one of a list, or the node of several.
    fn gather(&self, start: Span, mut list: Vec<Expr>, node: fn(Vec<Expr>) -> ExprKind) -> Expr {
        match list.pop() {
            Some(only) if list.is_empty() => only,
            Some(last) => {
                list.push(last);
                Expr { kind: node(list), span: self.since(start) }
            }
            None => Expr { kind: ExprKind::Invalid, span: start },
        }
    }

    /// `not a`
    fn negation(&mut self) -> Read<Expr> {
        let Some(word) = self.accept(TokenKind::Not) else { return self.comparison() };
        let inner = self.nested(Self::negation)?;
        Ok(Expr { kind: ExprKind::Unary(UnaryOp::Not, Box::new(inner)), span: self.since(word.span) })
    }

    /// `a <= b < c`
    fn comparison(&mut self) -> Read<Expr> {
        let first = self.sum()?;
        let start = first.span;
        let (mut operands, mut signs) = (vec![first], Vec::new());
        let mut direction: Option<(bool, Token)> = None;
        while let Some(sign) = self.peek().kind.comparison() {
            let word = self.take();
            use super::ast::Comparison::{Less, LessEqual};
            let rising = matches!(sign, Less | LessEqual);
            match direction {
                Some((other, before)) if other != rising => {
                    let error = Diagnostic::error(word.span, "these comparisons point in two directions")
                        .also(before.span, "this one points the other way")
                        .help("write two comparisons with `and` between them");
                    self.error(error);
                }
                _ => direction = Some((rising, word)),
            }
            signs.push(sign);
            operands.push(self.sum()?);
        }
        if signs.is_empty() {
            return Ok(self.gather(start, operands, ExprKind::Or));
        }
        Ok(Expr { kind: ExprKind::Chain(operands, signs), span: self.since(start) })
    }

    /// `a + b - c`
    pub(super) fn sum(&mut self) -> Read<Expr> {
        let first = self.product()?;
        let start = first.span;
        let mut terms = vec![Term { minus: false, value: first }];
        loop {
            let minus = match self.peek().kind {
                TokenKind::Plus => false,
                TokenKind::Minus => true,
                _ => break,
            };
            self.take();
            terms.push(Term { minus, value: self.product()? });
        }
        if terms.len() > 1 {
            return Ok(Expr { kind: ExprKind::Sum(terms), span: self.since(start) });
        }
        Ok(terms.pop().map_or(Expr { kind: ExprKind::Invalid, span: start }, |term| term.value))
    }

    /// `a * b / c d % e`
    fn product(&mut self) -> Read<Expr> {
        let first_word = self.peek();
        let first = self.unary()?;
        let start = first.span;
        let mut factors = vec![Factor { operator: FactorOp::Mul, value: first }];
        let mut run = Run::default();
        run.begin(self, first_word, FactorOp::Mul);
        loop {
            let word = self.peek();
            let operator = match word.kind {
                TokenKind::Star => FactorOp::Mul,
                TokenKind::Slash => FactorOp::Div,
                TokenKind::Percent => FactorOp::Mod,
                _ if self.begins_factor(word)? => {
                    self.check_bars(word, &run)?;
                    let value = self.power()?;
                    factors.push(Factor { operator: FactorOp::Mul, value });
                    self.note_factor(start, &factors, &mut run, word);
                    continue;
                }
                _ => break,
            };
            self.note_run(start, &factors, &run);
            self.take();
            self.note_quotient(&factors, operator, &run);
            let operand = self.peek();
            factors.push(Factor { operator, value: self.unary()? });
            run.begin(self, operand, operator);
        }
        self.note_run(start, &factors, &run);
        Ok(self.multiply(start, factors))
    }

    /// The only one of some factors, or their product.
    pub(super) fn multiply(&self, start: Span, mut factors: Vec<Factor>) -> Expr {
        if factors.len() > 1 {
            return Expr { kind: ExprKind::Product(factors), span: self.since(start) };
        }
        factors.pop().map_or(Expr { kind: ExprKind::Invalid, span: start }, |factor| factor.value)
    }

    /// `-a`, `+a`
    fn unary(&mut self) -> Read<Expr> {
        let operator = match self.peek().kind {
            TokenKind::Minus => UnaryOp::Neg,
            TokenKind::Plus => UnaryOp::Plus,
            _ => return self.power(),
        };
        let word = self.take();
        let inner = self.nested(Self::unary)?;
        Ok(Expr { kind: ExprKind::Unary(operator, Box::new(inner)), span: self.since(word.span) })
    }

    /// `a ^ b`, to the right: the exponent may have a sign and be a power itself.
    pub(super) fn power(&mut self) -> Read<Expr> {
        let base = self.operand()?;
        self.exponent(base)
    }

    /// What is raised behind a base.
    pub(super) fn exponent(&mut self, base: Expr) -> Read<Expr> {
        let start = base.span;
        let exponent = match self.peek().kind {
            TokenKind::Caret => {
                self.take();
                self.nested(Self::unary)?
            }
            TokenKind::Raised => {
                let raised = self.raised()?;
                self.nested(|reader| reader.exponent(raised))?
            }
            _ => return Ok(base),
        };
        Ok(Expr { kind: ExprKind::Power(Box::new(base), Box::new(exponent)), span: self.since(start) })
    }

    /// Whether a word begins one more factor without an operator before it.
    pub(super) fn begins_factor(&mut self, word: Token) -> Read<bool> {
        match word.kind {
            TokenKind::Number => Err(self.number_behind(word)),
            TokenKind::Bar => Ok(self.bars == 0),
            TokenKind::Name
            | TokenKind::Symbol
            | TokenKind::Invalid
            | TokenKind::SquareRoot
            | TokenKind::CubeRoot
            | TokenKind::Open(Bracket::Round) => Ok(true),
            _ => Ok(false),
        }
    }

    /// The error for `5 3`, `x 2`, `(x+1)2`.
    fn number_behind(&mut self, word: Token) -> super::reader::Stop {
        let number = crate::diag::printable(self.written(word.span), 20);
        let before = self.previous().map_or(word.span, |token| token.span);
        let left = crate::diag::printable(self.written(before), 20);
        let error = Diagnostic::error(word.span, format!("a number directly behind `{left}`"));
        let help = match self.previous().map(|token| token.kind) {
            Some(TokenKind::Number) => format!("write `{left}*{number}`, or join the digits: `{left}{number}`"),
            Some(TokenKind::Name | TokenKind::Symbol) => format!("write `{left}*{number}` or `{left}^{number}`"),
            _ => format!("put an operator between them: `*{number}` or `^{number}`"),
        };
        self.stop(error.label("expected an operator").help(help))
    }

    /// `|x|y|z|` can be read in two ways: an error.
    fn check_bars(&mut self, word: Token, run: &Run) -> Read<()> {
        if word.kind != TokenKind::Bar || !run.bars_then_other {
            return Ok(());
        }
        let error = Diagnostic::error(word.span, "it is not clear whether this bar opens or closes");
        Err(self.stop(error.help("write `abs()` for the bars, or `*` between the factors: `abs(x)*y*abs(z)`")))
    }
}

/// Factors without an operator between them, from the last operator on.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Run {
    /// The operator before its first factor.
    pub(super) after: Option<FactorOp>,
    /// Which factor of the product is its first.
    pub(super) first: usize,
    /// How many factors it has.
    pub(super) count: usize,
    /// Whether the last factor was written with bars.
    last_is_bars: bool,
    /// Whether bars stood in it and something else behind them.
    bars_then_other: bool,
}

impl Run {
    /// Starts with the factor read last, whose first word was `word`.
    fn begin(&mut self, reader: &Reader<'_>, word: Token, after: FactorOp) {
        let first = if self.count == 0 { 0 } else { self.first + self.count };
        let last_is_bars = reader.ends_in_bars(word);
        *self = Run { after: Some(after), first, count: 1, last_is_bars, bars_then_other: false };
    }

    /// Goes on with the factor read last.
    pub(super) fn extend(&mut self, reader: &Reader<'_>, word: Token) {
        let bars = reader.ends_in_bars(word);
        self.bars_then_other |= self.last_is_bars && !bars;
        self.last_is_bars = bars;
        self.count += 1;
    }
}

impl Reader<'_> {
    /// Whether the factor read last was `|…|`, by its first and last word.
    fn ends_in_bars(&self, first: Token) -> bool {
        first.kind == TokenKind::Bar && self.previous().is_some_and(|token| token.kind == TokenKind::Bar)
    }
}
