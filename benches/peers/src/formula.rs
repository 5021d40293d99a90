//! A formula in the notation of each peer.
//!
//! In: the text of a scene, read by implicit's own parser. Out: whatever an [`Algebra`] makes of sums, products, powers
//! and calls. Separate because three peers are written to in the same way.

use implicit::diag::Sources;
use implicit::syntax::ast::{Expr, ExprKind, FactorOp, StatementKind, UnaryOp};

/// What a peer's notation is made of.
pub trait Algebra {
    type Value: Clone;
    fn number(&self, value: f64) -> Self::Value;
    /// `axis` is 0, 1, 2 for x, y, z.
    fn coordinate(&self, axis: usize) -> Self::Value;
    fn negated(&self, a: Self::Value) -> Self::Value;
    fn plus(&self, a: Self::Value, b: Self::Value) -> Self::Value;
    fn minus(&self, a: Self::Value, b: Self::Value) -> Self::Value;
    fn times(&self, a: Self::Value, b: Self::Value) -> Self::Value;
    fn over(&self, a: Self::Value, b: Self::Value) -> Self::Value;
    /// `None` where the peer has no such power.
    fn power(&self, a: Self::Value, exponent: f64) -> Option<Self::Value>;
    /// `None` where the peer has no such function.
    fn call(&self, name: &str, arguments: Vec<Self::Value>) -> Option<Self::Value>;
}

/// The formula in that notation; `None` where it has none.
pub fn translate<A: Algebra>(text: &str, algebra: &A) -> Option<A::Value> {
    let mut sources = Sources::new();
    sources.add("formula", text);
    let program = implicit::syntax::parse(&sources.texts()).program;
    match &program.statements.first()?.kind {
        StatementKind::Surface { left, right: None, .. } => value(left, algebra),
        _ => None,
    }
}

fn value<A: Algebra>(expr: &Expr, algebra: &A) -> Option<A::Value> {
    Some(match &expr.kind {
        ExprKind::Number(number) => algebra.number(number.to_f64()),
        ExprKind::Name(name) => algebra.coordinate(["x", "y", "z"].iter().position(|axis| axis == name)?),
        ExprKind::Unary(UnaryOp::Neg, a) => algebra.negated(value(a, algebra)?),
        ExprKind::Sum(terms) => {
            let mut sum = None;
            for term in terms {
                let next = value(&term.value, algebra)?;
                sum = Some(match (sum, term.minus) {
                    (None, false) => next,
                    (None, true) => algebra.negated(next),
                    (Some(sum), false) => algebra.plus(sum, next),
                    (Some(sum), true) => algebra.minus(sum, next),
                });
            }
            sum?
        }
        ExprKind::Product(factors) => {
            let mut product = value(&factors.first()?.value, algebra)?;
            for factor in &factors[1..] {
                let next = value(&factor.value, algebra)?;
                product = match factor.operator {
                    FactorOp::Mul => algebra.times(product, next),
                    FactorOp::Div => algebra.over(product, next),
                    FactorOp::Mod => return None,
                };
            }
            product
        }
        ExprKind::Power(a, exponent) => match &exponent.kind {
            ExprKind::Number(exponent) => algebra.power(value(a, algebra)?, exponent.to_f64())?,
            _ => return None,
        },
        ExprKind::Call(name, arguments) => {
            let arguments: Option<Vec<_>> = arguments.iter().map(|argument| value(argument, algebra)).collect();
            algebra.call(&name.text, arguments?)?
        }
        _ => return None,
    })
}
