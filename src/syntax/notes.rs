//! What is said where people and programs disagree: how it was read, and how to write the other reading.
//!
//! In: the operands just read. Out: notes in the report. Separate because none of it changes what is read.

use super::ast::{Expr, ExprKind, Factor, FactorOp, Name, UnaryOp};
use super::expression::Run;
use super::names;
use super::reader::Reader;
use super::token::{Bracket, Token, TokenKind};
use crate::diag::{Span, printable};

/// Parts of a formula are quoted up to this many characters.
const MAX_QUOTED: usize = 40;

impl Expr {
    /// Whether it is a number or the name of one.
    pub(super) fn is_constant(&self) -> bool {
        match &self.kind {
            ExprKind::Number(_) => true,
            ExprKind::Name(name) => names::CONSTANTS.contains(&name.as_str()),
            _ => false,
        }
    }
}

impl Reader<'_> {
    fn quote(&self, span: Span) -> String {
        printable(self.written(span).trim(), MAX_QUOTED)
    }

    fn read_as(&mut self, span: Span, reading: &str, other: &str) {
        self.note(span, format!("read as {reading}; write {other} for the other"));
    }

    /// After a factor without an operator before it: `e^2x`, `√2x`.
    pub(super) fn note_factor(&mut self, start: Span, factors: &[Factor], run: &mut Run, word: Token) {
        run.extend(self, word);
        let [.., before, factor] = factors else { return };
        let (before, factor) = (&before.value, &factor.value);
        let right = self.quote(factor.span);
        let span = start.to(factor.span);
        if let ExprKind::Power(base, exponent) = &before.kind
            && matches!(&base.kind, ExprKind::Name(name) if name == "e")
            && !self.written(exponent.span).starts_with('(')
        {
            let joined = self.quote(exponent.span.to(factor.span));
            let left = self.quote(before.span);
            self.read_as(span, &format!("({left})*{right}"), &format!("e^({joined})"));
        }
        if let ExprKind::Call(name, list) = &before.kind
            && matches!(self.written(name.span), "√" | "∛")
            && before.span.end == factor.span.start
            && let [argument] = list.as_slice()
            && !self.written(argument.span).starts_with('(')
        {
            let sign = self.written(name.span);
            let joined = self.quote(argument.span.to(factor.span));
            let left = self.quote(before.span);
            self.read_as(span, &format!("{left}*{right}"), &format!("{sign}({joined})"));
        }
    }

    /// At the end of factors without operators: `1/2x`, `a/b c`.
    pub(super) fn note_run(&mut self, start: Span, factors: &[Factor], run: &Run) {
        let sign = match run.after {
            Some(FactorOp::Div) => '/',
            Some(FactorOp::Mod) => '%',
            _ => return,
        };
        let members = &factors[run.first.min(factors.len())..];
        let ([first, second, ..], [.., last], true) = (members, members, run.first > 0) else { return };
        let (first, second, last) = (first.value.span, second.value.span, last.value.span);
        let numerator = self.quote(start.to(factors[run.first - 1].value.span));
        let left = self.quote(start.to(first));
        let (right, joined) = (self.quote(second.to(last)), self.quote(first.to(last)));
        self.read_as(start.to(last), &format!("({left})*{right}"), &format!("{numerator}{sign}({joined})"));
    }

    /// After `/`: `x^1/2`, `sin x/2`.
    pub(super) fn note_quotient(&mut self, factors: &[Factor], operator: FactorOp, run: &Run) {
        let (FactorOp::Div, Some(last)) = (operator, factors.last()) else { return };
        let mut left = &last.value;
        while let ExprKind::Unary(UnaryOp::Neg | UnaryOp::Plus, inner) = &left.kind
            && run.count == 1
        {
            left = inner;
        }
        let next = self.peek();
        let shown = self.quote(left.span);
        let divisor = self.quote(next.span);
        if let ExprKind::Power(base, exponent) = &left.kind
            && matches!(self.written(exponent.span), "1" | "-1" | "−1")
            && next.kind == TokenKind::Number
        {
            let (base, exponent) = (self.quote(base.span), self.quote(exponent.span));
            let span = left.span.to(next.span);
            self.read_as(span, &format!("({shown})/{divisor}"), &format!("{base}^({exponent}/{divisor})"));
            return;
        }
        if let Some((name, argument)) = self.bare_call(left)
            && !self.is_function(next)
        {
            let (name, argument) = (self.quote(name), self.quote(argument));
            let span = left.span.to(next.span);
            self.read_as(span, &format!("({shown})/{divisor}"), &format!("{name}({argument}/{divisor})"));
        }
    }

    /// The function, with its power, and the argument of an application without brackets.
    fn bare_call(&self, value: &Expr) -> Option<(Span, Span)> {
        let call = match &value.kind {
            ExprKind::Power(base, _) => base,
            _ => value,
        };
        let ExprKind::Call(Name { span, .. }, list) = &call.kind else { return None };
        let [argument] = list.as_slice() else { return None };
        let between = Span { start: span.end, end: argument.span.start, ..*span };
        let head = Span { end: argument.span.start, ..*span };
        let sign = matches!(self.written(*span), "√" | "∛");
        (!sign && !self.written(between).contains('(')).then_some((head, argument.span))
    }

    /// Whether it is not plain that one more factor belongs to the argument of a function without brackets: it is
    /// in `sin xy`, and behind numbers and constants only (`sin 2 pi x`); it is not in `sin x y`, `sin x(y+1)`.
    pub(super) fn is_doubtful(&self, factors: &[Factor], word: Token) -> bool {
        let power = factors.last().is_some_and(|factor| matches!(factor.value.kind, ExprKind::Power(..)));
        let bracket = matches!(word.kind, TokenKind::Open(Bracket::Round) | TokenKind::Bar);
        let closed = self.previous().is_some_and(|word| matches!(word.kind, TokenKind::Close(_)));
        power || bracket || closed || self.last_end != word.span.start
    }

    /// After the argument of a function without brackets: `sin x y`, `sin x(y+1)`, `sin x^2`.
    pub(super) fn note_application(&mut self, function: Token, first: Token, factors: &[Factor], doubtful: bool) {
        let ([one, ..], [.., last]) = (factors, factors) else { return };
        let (one, last) = (&one.value, &last.value);
        let name = self.written(Span { end: first.span.start, ..function.span }).trim_end();
        let name = printable(name, MAX_QUOTED);
        let argument = self.quote(one.span.to(last.span));
        let span = function.span.to(last.span);
        if doubtful {
            let rest = self.quote(factors.get(1).map_or(last.span, |second| second.value.span).to(last.span));
            let left = self.quote(one.span);
            self.read_as(span, &format!("{name}({argument})"), &format!("{name}({left})*{rest}"));
        } else if let ExprKind::Power(base, exponent) = &last.kind
            && !self.written(last.span).starts_with('(')
        {
            let base = self.quote(Span { start: one.span.start, ..base.span });
            let exponent = self.quote(exponent.span);
            let caret = if exponent.chars().all(|c| super::letters::raised(c).is_some()) { "" } else { "^" };
            self.read_as(span, &format!("{name}({argument})"), &format!("({name}({base})){caret}{exponent}"));
        }
    }

    /// `√(x)^2` is the root of the power.
    pub(super) fn note_root(&mut self, sign: Token, operand: Token, inner: &Expr) {
        let ExprKind::Power(base, exponent) = &inner.kind else { return };
        if operand.kind != TokenKind::Open(Bracket::Round) || !self.written(base.span).ends_with(')') {
            return;
        }
        let (root, whole) = (self.written(sign.span), self.quote(inner.span));
        let (base, exponent) = (self.quote(base.span), self.quote(exponent.span));
        let caret = if exponent.chars().all(|c| super::letters::raised(c).is_some()) { "" } else { "^" };
        let span = sign.span.to(inner.span);
        self.read_as(span, &format!("{root}({whole})"), &format!("({root}{base}){caret}{exponent}"));
    }

    /// `log` of one argument is to base 10.
    pub(super) fn note_log(&mut self, word: Token, count: usize) {
        if self.written(word.span) == "log" && count == 1 {
            self.note(word.span, "`log` read as the logarithm to base 10; write `ln` for the natural one");
        }
    }

    /// `phi` and `theta` are angles, unless the program defines them.
    pub(super) fn note_angle(&mut self, word: Token) {
        let name = self.name(word);
        if self.scope.iter().any(|known| known == name) || self.names.declared(name).is_some() {
            return;
        }
        match name {
            "phi" => self
                .note(word.span, "`phi` read as the angle acos(z/rho) from the z axis; the golden ratio is `golden`"),
            "theta" => self.note(
                word.span,
                "`theta` read as the angle atan2(y, x) around the z axis; define `theta` for another meaning",
            ),
            _ => {}
        }
    }
}
