//! A function behind its name: a call with brackets, a power of the function, or the factors it takes without brackets.
//!
//! In: the name, already read, and the words behind it. Out: a call. Separate from other operands because how far a
//! function without brackets reaches is a rule of its own.

use super::ast::{Expr, ExprKind, Factor, FactorOp, Name, UnaryOp};
use super::names::Meaning;
use super::reader::{Read, Reader};
use super::token::{Bracket, Token, TokenKind};
use crate::diag::{Diagnostic, printable};

/// What a name before its arguments is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Applied {
    Builtin(&'static super::functions::Function),
    /// A function of the program with so many arguments.
    Own(usize),
    /// Known to nobody; reported already.
    Unknown,
}

impl Reader<'_> {
    /// A function behind its name: a call, a power of the function, or the run of factors it takes.
    pub(super) fn applied(&mut self, word: Token, applied: Applied) -> Read<Expr> {
        let name = Name { text: self.name(word).to_owned(), span: word.span };
        match self.peek().kind {
            TokenKind::Open(Bracket::Round) => {
                let open = self.take();
                let list = self.arguments(open, Bracket::Round)?;
                self.note_log(word, list.len());
                Ok(self.call(name, list, applied))
            }
            TokenKind::Caret | TokenKind::Raised => {
                let exponent = self.function_exponent(word)?;
                let inner = match self.peek().kind {
                    TokenKind::Open(Bracket::Round) => {
                        let open = self.take();
                        self.arguments(open, Bracket::Round)?
                    }
                    _ => vec![self.run(word, applied)?],
                };
                self.note_log(word, inner.len());
                let base = self.call(name, inner, applied);
                let kind = ExprKind::Power(Box::new(base), Box::new(exponent));
                Ok(Expr { kind, span: self.since(word.span) })
            }
            _ => {
                let inner = self.run(word, applied)?;
                self.note_log(word, 1);
                Ok(self.call(name, vec![inner], applied))
            }
        }
    }

    fn call(&self, name: Name, list: Vec<Expr>, applied: Applied) -> Expr {
        let span = self.since(name.span);
        let kind = if matches!(applied, Applied::Unknown) { ExprKind::Invalid } else { ExprKind::Call(name, list) };
        Expr { kind, span }
    }

    /// The exponent of `sin^2 x`: a number, a name or a bracket; never negative.
    fn function_exponent(&mut self, word: Token) -> Read<Expr> {
        let name = self.written(word.span);
        let start = self.peek().span;
        let exponent = if self.peek().kind == TokenKind::Raised {
            self.raised()?
        } else {
            self.take();
            match self.peek().kind {
                TokenKind::Minus => {
                    self.take();
                    let inner = self.nested(Self::operand)?;
                    Expr { span: inner.span, kind: ExprKind::Unary(UnaryOp::Neg, Box::new(inner)) }
                }
                _ => self.nested(Self::exponent_operand)?,
            }
        };
        if let ExprKind::Unary(UnaryOp::Neg, inner) = &exponent.kind {
            let whole = self.since(start);
            let one = matches!(&inner.kind, ExprKind::Number(n) if n.is_one());
            let inverse = format!("a{name}");
            let shown = printable(self.written(whole), 20);
            let help = if one && super::functions::find(&inverse).is_some() {
                format!("write `{inverse}(x)` for the inverse function, or `1/{name}(x)`")
            } else {
                format!("write `1/{name}(x)` or `{name}(x){shown}`")
            };
            let error = Diagnostic::error(word.span.to(whole), format!("`{name}{shown}` can mean two things"));
            return Err(self.stop(error.help(help)));
        }
        Ok(exponent)
    }

    /// A number, a name that is no function, or a bracket, with no more behind it.
    fn exponent_operand(&mut self) -> Read<Expr> {
        let word = self.peek();
        match word.kind {
            TokenKind::Number => self.number(),
            TokenKind::Open(Bracket::Round) => self.bracketed(),
            TokenKind::Name | TokenKind::Symbol if matches!(self.meaning(self.name(word)), Meaning::Value) => {
                self.take();
                Ok(Expr { kind: ExprKind::Name(self.name(word).to_owned()), span: word.span })
            }
            _ => Err(self.missing_operand()),
        }
    }

    /// The argument of a function without brackets: a sign and factors, up to an operator or the next function.
    fn run(&mut self, word: Token, applied: Applied) -> Read<Expr> {
        self.check_bare(word, applied)?;
        let sign = match self.peek().kind {
            TokenKind::Minus => Some((UnaryOp::Neg, self.take())),
            TokenKind::Plus => Some((UnaryOp::Plus, self.take())),
            _ => None,
        };
        let first = self.peek();
        let factors = self.nested(|reader| reader.run_factors(word))?;
        let argument = self.multiply(first.span, factors);
        let Some((operator, sign)) = sign else { return Ok(argument) };
        Ok(Expr { kind: ExprKind::Unary(operator, Box::new(argument)), span: self.since(sign.span) })
    }

    fn run_factors(&mut self, function: Token) -> Read<Vec<Factor>> {
        let first = self.peek();
        let mut factors = vec![Factor { operator: FactorOp::Mul, value: self.power()? }];
        let mut doubtful = false;
        let mut constants = true;
        loop {
            let word = self.peek();
            if self.is_function(word) || !self.begins_factor(word)? {
                break;
            }
            constants &= factors.last().is_some_and(|factor| factor.value.is_constant());
            doubtful |= !constants && self.is_doubtful(&factors, word);
            let value = self.power()?;
            factors.push(Factor { operator: FactorOp::Mul, value });
        }
        self.note_application(function, first, &factors, doubtful);
        Ok(factors)
    }

    /// Whether a word is the name of a function.
    pub(super) fn is_function(&self, word: Token) -> bool {
        let name = self.name(word);
        !name.is_empty() && matches!(self.meaning(name), Meaning::Builtin(_) | Meaning::Function(_))
    }

    /// Whether a function can stand without brackets, and something follows it.
    fn check_bare(&mut self, word: Token, applied: Applied) -> Read<()> {
        let name = self.written(word.span);
        let (bare, signature) = match applied {
            Applied::Builtin(function) => (function.applies_bare(), function.signature.to_owned()),
            Applied::Own(count) => (count == 1, format!("{name}(…)")),
            Applied::Unknown => (true, String::new()),
        };
        let next = self.peek();
        let operand = matches!(next.kind, TokenKind::Plus | TokenKind::Minus | TokenKind::Number | TokenKind::Bar)
            || matches!(next.kind, TokenKind::Invalid | TokenKind::SquareRoot | TokenKind::CubeRoot)
            || matches!(next.kind, TokenKind::Name | TokenKind::Symbol | TokenKind::Open(Bracket::Round));
        if bare && operand {
            return Ok(());
        }
        let message = if operand {
            format!("`{name}` takes its arguments in brackets")
        } else {
            format!("`{name}` needs an argument")
        };
        let example = if signature.is_empty() { format!("{name}(x)") } else { signature };
        Err(self.stop(Diagnostic::error(word.span, message).help(format!("write `{example}`"))))
    }
}
