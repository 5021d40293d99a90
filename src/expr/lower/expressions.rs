//! Expressions by kind: signs, sums, products, logic, vectors and lists.
//!
//! In: a tree no deeper than the nest limit. Out: its value. Separate from the arithmetic, which knows no trees: here
//! operands are lowered, all of them, so that each one's errors are found.

use super::regions::Region;
use super::values::{FOLDED_FROM_THE_LEFT, Placed, Side, Value};
use super::{Lowerer, Reported, Reporting, series};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::expr::op::Op;
use crate::syntax::ast::{Expr, ExprKind, Factor, FactorOp, Term, UnaryOp};

impl<'a> Lowerer<'a> {
    /// The value of an expression.
    pub(super) fn expr(&mut self, expr: &'a Expr) -> Reporting<Value> {
        self.enter(expr.span, 1)?;
        let value = self.expr_inside(expr);
        self.leave(1);
        value
    }

    // table: the kinds of expressions
    fn expr_inside(&mut self, expr: &'a Expr) -> Reporting<Value> {
        let span = expr.span;
        match &expr.kind {
            ExprKind::Number(value) => Ok(Value::Number(self.constant(value.clone(), span))),
            ExprKind::Invalid => Err(Reported),
            ExprKind::Name(name) => self.name(name, span),
            ExprKind::Unary(op, inner) => self.unary(*op, inner, span),
            ExprKind::Sum(terms) => self.sum(terms),
            ExprKind::Product(factors) => self.product(factors),
            ExprKind::Power(base, exponent) => {
                let base = self.placed(base)?;
                self.power(base, exponent, span)
            }
            ExprKind::And(items) => self.logical(items, true, span),
            ExprKind::Or(items) => self.logical(items, false, span),
            ExprKind::Chain(operands, comparisons) => self.chain(operands, comparisons, span),
            ExprKind::Bars(inner) => {
                let inner = self.placed(inner)?;
                self.magnitude(inner, span)
            }
            ExprKind::Call(name, args) => self.call(name, args, span),
            ExprKind::Vector(items) => self.vector(items, span),
            ExprKind::List(items) => self.list(items),
            ExprKind::Component(inner, letter) => {
                let inner = self.placed(inner)?;
                self.component(inner, &letter.text, letter.span)
            }
            ExprKind::Series { product, variable, over, body } => {
                self.series(series::Series { product: *product, variable, over, body }, span)
            }
        }
    }

    /// The value with its place.
    pub(super) fn placed(&mut self, expr: &'a Expr) -> Reporting<Placed> {
        Ok(Placed { value: self.expr(expr)?, span: expr.span })
    }

    /// The expression as a number.
    pub(super) fn number(&mut self, expr: &'a Expr) -> Reporting<NodeId> {
        let placed = self.placed(expr)?;
        self.wanted_number(placed)
    }

    fn unary(&mut self, op: UnaryOp, inner: &'a Expr, span: Span) -> Reporting<Value> {
        let placed = self.placed(inner)?;
        match op {
            UnaryOp::Neg => self.negate_value(placed, span),
            UnaryOp::Plus => match placed.value {
                Value::Vector(_) => Ok(placed.value),
                _ => self.wanted_number(placed).map(Value::Number),
            },
            UnaryOp::Not => {
                let region = self.wanted_region(placed)?;
                Ok(Value::Region(self.outside(region, span)))
            }
        }
    }

    /// `a + b - c`: from the left while it is short, in balanced halves when it is long.
    fn sum(&mut self, terms: &'a [Term]) -> Reporting<Value> {
        let mut placed = Vec::with_capacity(terms.len());
        for term in terms {
            placed.push(self.placed(&term.value).map(|value| (term.minus, value)));
        }
        let mut placed = placed.into_iter().collect::<Reporting<Vec<(bool, Placed)>>>()?;
        self.balanced_sum(&mut placed)
    }

    /// The sum of terms of which the first is added.
    fn balanced_sum(&mut self, terms: &mut [(bool, Placed)]) -> Reporting<Value> {
        if terms.len() > FOLDED_FROM_THE_LEFT {
            let (low, high) = terms.split_at_mut(terms.len() / 2);
            let minus = high[0].0;
            high.iter_mut().for_each(|term| term.0 ^= minus);
            let (low_span, high_span) = (whole_span(low), whole_span(high));
            let (low, high) = (self.balanced_sum(low)?, self.balanced_sum(high)?);
            let (low, high) = (Placed { value: low, span: low_span }, Placed { value: high, span: high_span });
            let side = if minus { Side::Under } else { Side::Over };
            return self.add_values(low, side, high, low_span.to(high_span));
        }
        let mut total = terms[0].1.clone();
        for (minus, term) in &terms[1..] {
            let side = if *minus { Side::Under } else { Side::Over };
            let span = total.span.to(term.span);
            total = Placed { value: self.add_values(total, side, term.clone(), span)?, span };
        }
        match total.value {
            Value::Vector(_) => Ok(total.value),
            _ => self.wanted_number(total).map(Value::Number),
        }
    }

    /// `a * b / c % d`, from the left; a long product without quotients in balanced halves.
    fn product(&mut self, factors: &'a [Factor]) -> Reporting<Value> {
        let mut placed = Vec::with_capacity(factors.len());
        for factor in factors {
            placed.push(self.placed(&factor.value).map(|value| (factor.operator, value)));
        }
        let placed = placed.into_iter().collect::<Reporting<Vec<(FactorOp, Placed)>>>()?;
        self.balanced_product(&placed)
    }

    fn balanced_product(&mut self, factors: &[(FactorOp, Placed)]) -> Reporting<Value> {
        let plain =
            |(op, placed): &(FactorOp, Placed)| *op == FactorOp::Mul && matches!(placed.value, Value::Number(_));
        if factors.len() > FOLDED_FROM_THE_LEFT && factors.iter().all(plain) {
            let numbers: Vec<NodeId> = factors.iter().flat_map(|(_, placed)| placed.value.nodes()).collect();
            let span = factors[0].1.span.to(factors[factors.len() - 1].1.span);
            return Ok(Value::Number(self.fold(Op::Mul, &numbers, span)));
        }
        let mut total = factors[0].1.clone();
        for (op, factor) in &factors[1..] {
            let span = total.span.to(factor.span);
            let value = match op {
                FactorOp::Mul => self.multiply_values(total, Side::Over, factor.clone(), span)?,
                FactorOp::Div => self.multiply_values(total, Side::Under, factor.clone(), span)?,
                FactorOp::Mod => {
                    let (a, b) = (self.wanted_number(total), self.wanted_number(factor.clone()));
                    Value::Number(self.modulo(a?, b?, span))
                }
            };
            total = Placed { value, span };
        }
        Ok(total.value)
    }

    fn logical(&mut self, items: &'a [Expr], and: bool, span: Span) -> Reporting<Value> {
        let mut regions = Vec::with_capacity(items.len());
        for item in items {
            let placed = self.placed(item);
            regions.push(placed.and_then(|placed| self.wanted_region(placed)));
        }
        let regions = regions.into_iter().collect::<Reporting<Vec<Region>>>()?;
        Ok(Value::Region(self.balanced_regions(&regions, and, span)))
    }

    fn balanced_regions(&mut self, regions: &[Region], and: bool, span: Span) -> Region {
        let [first, rest @ ..] = regions else { unreachable!("the parser gives `and` and `or` two operands or more") };
        if rest.is_empty() {
            return *first;
        }
        let (low, high) = regions.split_at(regions.len().div_ceil(2));
        let (low, high) = (self.balanced_regions(low, and, span), self.balanced_regions(high, and, span));
        if and { self.both(low, high, span) } else { self.either(low, high, span) }
    }

    fn vector(&mut self, items: &'a [Expr], span: Span) -> Reporting<Value> {
        let mut numbers = Vec::with_capacity(items.len());
        for item in items {
            numbers.push(self.number(item));
        }
        let numbers = numbers.into_iter().collect::<Reporting<Vec<NodeId>>>()?;
        if !(2..=3).contains(&numbers.len()) {
            let message = format!("a vector has two or three numbers, and this has {}", numbers.len());
            return Err(self.report(Diagnostic::error(span, message).help("a list is written `[a, b, c, d]`")));
        }
        Ok(Value::Vector(numbers))
    }

    fn list(&mut self, items: &'a [Expr]) -> Reporting<Value> {
        let mut values = Vec::with_capacity(items.len());
        for item in items {
            let placed = self.placed(item);
            values.push(placed.and_then(|placed| match placed.value {
                Value::List(_) => {
                    let error = Diagnostic::error(placed.span, "a list cannot stand in a list");
                    Err(self.report(error.help("write the items one by one")))
                }
                value => Ok(value),
            }));
        }
        Ok(Value::List(values.into_iter().collect::<Reporting<Vec<Value>>>()?.into()))
    }
}

fn whole_span(terms: &[(bool, Placed)]) -> Span {
    terms[0].1.span.to(terms[terms.len() - 1].1.span)
}
