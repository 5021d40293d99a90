//! Powers: which of the several meanings of `a^b` is meant.
//!
//! In: a base and the exponent as it was written. Out: repeated squaring, a real root, or the power of a base that is
//! not negative. Separate because the choice hangs on the text of the exponent, before anything is folded.

use super::values::{Placed, Value};
use super::{Lowerer, Reporting};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::expr::op::Op;
use crate::num::rational::Rational;
use crate::syntax::ast::{Expr, ExprKind, Factor, FactorOp, UnaryOp};

/// The largest order of a root: the graph keeps it in 32 bits.
const MAX_ROOT: i64 = u32::MAX as i64;

/// An exponent of literals alone.
struct Written {
    value: Rational,
    /// Whether it is a quotient of whole numbers, which asks for the real root.
    fraction: bool,
}

/// The number that a literal, a signed literal or a quotient of two of them spells.
fn written(exponent: &Expr) -> Option<Written> {
    match &exponent.kind {
        ExprKind::Number(value) => Some(Written { value: value.clone(), fraction: false }),
        ExprKind::Unary(UnaryOp::Plus, inner) => written(inner),
        ExprKind::Unary(UnaryOp::Neg, inner) => {
            let inner = written(inner)?;
            Some(Written { value: inner.value.negated(), fraction: inner.fraction })
        }
        ExprKind::Product(factors) => match factors.as_slice() {
            [Factor { value: p, .. }, Factor { operator: FactorOp::Div, value: q }] => {
                let (p, q) = (written(p)?, written(q)?);
                let whole = p.value.is_integer() && q.value.is_integer() && !p.fraction && !q.fraction;
                Some(Written { value: p.value.over(&q.value)?, fraction: whole })
            }
            _ => None,
        },
        _ => None,
    }
}

impl<'a> Lowerer<'a> {
    /// `base ^ exponent`.
    pub(super) fn power(&mut self, base: Placed, exponent: &'a Expr, span: Span) -> Reporting<Value> {
        if let Value::Vector(_) = base.value {
            let error = Diagnostic::error(span, "a vector has no powers");
            return Err(self.report(error.help("write `dot(p, p)` or `|p|^2` for the square of its length")));
        }
        let base = self.wanted_number(base);
        let node = match written(exponent) {
            Some(written) => {
                let base = base?;
                self.written_power(base, &written, exponent.span, span)?
            }
            None => {
                let (exponent_node, varies) = self.watched(|lowerer| lowerer.number(exponent));
                let (base, exponent_node) = (base?, exponent_node?);
                match self.graph.constant(exponent_node).cloned() {
                    // An exponent with x, y or z in it keeps the domain of one that varies, whatever it folds to.
                    Some(value) if !varies => {
                        let written = Written { value, fraction: false };
                        self.written_power(base, &written, exponent.span, span)?
                    }
                    _ if self.graph.op(base) == Op::E => self.node(Op::Exp, &[exponent_node], span),
                    _ => self.node(Op::Pow, &[base, exponent_node], span),
                }
            }
        };
        Ok(Value::Number(node))
    }

    fn written_power(&mut self, base: NodeId, exponent: &Written, place: Span, span: Span) -> Reporting<NodeId> {
        let value = &exponent.value;
        if self.graph.op(base) == Op::E {
            let power = self.constant(value.clone(), place);
            return Ok(self.node(Op::Exp, &[power], span));
        }
        if value.is_integer() {
            return match value.to_i64() {
                Some(n) => Ok(self.integer_power(base, n, span)),
                None => {
                    let error = Diagnostic::error(place, "this exponent is too large");
                    Err(self.report(error.help("whole exponents lie between -2^63 and 2^63")))
                }
            };
        }
        match value.to_fraction() {
            Some((p, q)) if exponent.fraction && q % 2 != 0 => {
                let root = self.odd_root(base, q, place, span)?;
                Ok(self.integer_power(root, p, span))
            }
            Some((p, 2)) => {
                let root = self.node(Op::Sqrt, &[base], span);
                Ok(self.integer_power(root, p, span))
            }
            _ => {
                let power = self.constant(value.clone(), place);
                Ok(self.node(Op::Pow, &[base, power], span))
            }
        }
    }

    /// The real root of odd order n ≥ 1.
    fn odd_root(&mut self, base: NodeId, n: i64, place: Span, span: Span) -> Reporting<NodeId> {
        if n > MAX_ROOT {
            let error = Diagnostic::error(place, "the order of this root is too large");
            return Err(self.report(error.help(format!("the largest is {MAX_ROOT}"))));
        }
        Ok(if n == 1 { base } else { self.node(Op::Root(n as u32), &[base], span) })
    }

    /// `root(n, x)`: the real root for odd n, the root of x ≥ 0 for even n.
    pub(super) fn root(&mut self, n: i64, place: Span, x: NodeId, span: Span) -> Reporting<NodeId> {
        if n < 1 {
            let error = Diagnostic::error(place, "the order of a root is 1 or more");
            return Err(self.report(error.help("for `1/root(n, x)` write just that")));
        }
        if n % 2 != 0 {
            return self.odd_root(x, n, place, span);
        }
        if n == 2 {
            return Ok(self.node(Op::Sqrt, &[x], span));
        }
        let Some(power) = Rational::from_fraction(1, n) else { return super::values::reported() };
        let power = self.constant(power, place);
        Ok(self.node(Op::Pow, &[x, power], span))
    }

    /// a^n by repeated squaring. The square of a vector's length is the sum of the squares, without a root.
    pub(super) fn integer_power(&mut self, base: NodeId, n: i64, span: Span) -> NodeId {
        match n {
            0 => self.one_where_defined(base, span),
            1 => base,
            _ => match self.squares_of_lengths.get(&base).copied() {
                Some(square) if n % 2 == 0 => self.integer_power(square, n / 2, span),
                _ => self.node(Op::Power(n), &[base], span),
            },
        }
    }

    /// 1 where `base` has a value, none elsewhere.
    pub(super) fn one_where_defined(&mut self, base: NodeId, span: Span) -> NodeId {
        let one = self.integer(1, span);
        if self.graph.is_total(base) {
            return one;
        }
        let low = self.node(Op::Min, &[base, one], span);
        self.node(Op::Max, &[low, one], span)
    }
}
