//! Sums and products over ranges and lists, and the polynomials that are defined by a recurrence.
//!
//! In: a running name, what it runs over and a term. Out: one node, the terms joined in a shallow tree. Separate
//! because here a short text makes many nodes, and every term is counted.

use super::values::{Placed, Value};
use super::{Argument, Bound, Lowerer, Reporting};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::expr::op::Op;
use crate::num::rational::Rational;
use crate::syntax::ast::{Expr, Name, SeriesRange};
use std::collections::HashMap;
use std::sync::Arc;

/// A sum or a product as it was written.
#[derive(Clone, Copy)]
pub(super) struct Series<'a> {
    pub(super) product: bool,
    pub(super) variable: &'a Name,
    pub(super) over: &'a SeriesRange,
    pub(super) body: &'a Expr,
}

/// What the running name takes as values.
enum Run {
    Integers(i64, i64),
    /// The items, and whether their text hangs on a coordinate.
    Items(Arc<[Value]>, bool),
}

impl<'a> Lowerer<'a> {
    /// `sum(k = a..b, term)`, `product(c in list, term)`.
    pub(super) fn series(&mut self, series: Series<'a>, span: Span) -> Reporting<Value> {
        let op = if series.product { Op::Mul } else { Op::Add };
        let terms = match self.run(series.over)? {
            Run::Integers(low, high) => self.terms_over_integers(series, low, high, span)?,
            Run::Items(items, vary) => {
                let mut terms = Vec::with_capacity(items.len());
                for item in items.iter() {
                    terms.push(self.term(series, (item.clone(), vary), span)?);
                }
                terms
            }
        };
        match terms.first() {
            Some(Value::Vector(first)) if !series.product => self.sum_of_vectors(first.len(), &terms, series, span),
            _ => {
                let mut numbers = Vec::with_capacity(terms.len());
                for value in terms {
                    numbers.push(self.wanted_number(Placed { value, span: series.body.span })?);
                }
                Ok(Value::Number(self.fold(op, &numbers, span)))
            }
        }
    }

    fn run(&mut self, over: &'a SeriesRange) -> Reporting<Run> {
        match over {
            SeriesRange::Integers(low, high) => {
                let (a, b) = (self.number(low), self.number(high));
                let a = a.and_then(|a| self.whole(a, low.span, "a bound"));
                let b = b.and_then(|b| self.whole(b, high.span, "a bound"));
                Ok(Run::Integers(a?, b?))
            }
            SeriesRange::List(list) => match self.watched(|lowerer| lowerer.expr(list)) {
                (Ok(Value::List(items)), vary) => Ok(Run::Items(items, vary)),
                (Err(reported), _) => Err(reported),
                (Ok(other), _) => {
                    let message = format!("{} stands where a list is wanted", other.kind());
                    let help = "a list is written `[a, b, c]`; `k = 1..10` runs over whole numbers";
                    Err(self.report(Diagnostic::error(list.span, message).help(help)))
                }
            },
        }
    }

    fn terms_over_integers(&mut self, series: Series<'a>, low: i64, high: i64, span: Span) -> Reporting<Vec<Value>> {
        let count = high.checked_sub(low).map_or(u64::MAX, |last| (last.max(-1) + 1) as u64);
        self.count_terms(count, span)?;
        let mut terms = Vec::with_capacity(count as usize);
        for k in low..low.saturating_add(count as i64) {
            let item = Value::Number(self.integer(k, series.variable.span));
            terms.push(self.term(series, (item, false), span)?);
        }
        Ok(terms)
    }

    fn term(&mut self, series: Series<'a>, (item, varies): Argument, span: Span) -> Reporting<Value> {
        self.count_terms(1, span)?;
        self.scope.push(Bound { name: &series.variable.text, value: Ok(item), varies });
        let value = self.expr(series.body);
        self.scope.pop();
        value
    }

    fn sum_of_vectors(&mut self, length: usize, terms: &[Value], series: Series<'a>, span: Span) -> Reporting<Value> {
        let mut columns: Vec<Vec<NodeId>> = vec![Vec::with_capacity(terms.len()); length];
        for value in terms {
            let items = self.wanted_vector(Placed { value: value.clone(), span: series.body.span })?;
            if items.len() != length {
                let error = Diagnostic::error(series.body.span, "the terms are vectors of different lengths");
                return Err(self.report(error));
            }
            for (column, item) in columns.iter_mut().zip(items) {
                column.push(item);
            }
        }
        Ok(Value::Vector(columns.iter().map(|column| self.fold(Op::Add, column, span)).collect()))
    }

    /// The Chebyshev polynomial T_n(x), by T_2k = 2·T_k² − 1 and T_2k+1 = 2·T_k·T_k+1 − x (DLMF 18.18.21 with m = n,
    /// m = n + 1): few nodes, and tight on intervals because T_2k is a function of T_k alone.
    pub(super) fn chebyshev(&mut self, n: i64, x: NodeId, span: Span) -> Reporting<NodeId> {
        let mut known = HashMap::from([(0, self.one_where_defined(x, span)), (1, x)]);
        Ok(self.chebyshev_known(n, x, span, &mut known))
    }

    fn chebyshev_known(&mut self, n: i64, x: NodeId, span: Span, known: &mut HashMap<i64, NodeId>) -> NodeId {
        if let Some(&id) = known.get(&n) {
            return id;
        }
        let low = self.chebyshev_known(n / 2, x, span, known);
        let two = self.integer(2, span);
        let id = if n % 2 == 0 {
            let (square, one) = (self.integer_power(low, 2, span), self.integer(1, span));
            let twice = self.node(Op::Mul, &[two, square], span);
            self.node(Op::Sub, &[twice, one], span)
        } else {
            let high = self.chebyshev_known(n / 2 + 1, x, span, known);
            let product = self.node(Op::Mul, &[low, high], span);
            let twice = self.node(Op::Mul, &[two, product], span);
            self.node(Op::Sub, &[twice, x], span)
        };
        known.insert(n, id);
        id
    }

    /// The Legendre polynomial P_n(x), by (k+1)·P_k+1 = (2k+1)·x·P_k − k·P_k−1 (DLMF 18.9.1 with table 18.9.1).
    pub(super) fn legendre(&mut self, n: i64, x: NodeId, span: Span) -> Reporting<NodeId> {
        let mut before = self.one_where_defined(x, span);
        if n == 0 {
            return Ok(before);
        }
        self.count_terms(n as u64, span)?;
        let mut last = x;
        for k in 1..n {
            self.check_size(span)?;
            let (rise, fall) = (self.quotient(2 * k + 1, k + 1, span), self.quotient(k, k + 1, span));
            let product = self.node(Op::Mul, &[x, last], span);
            let raised = self.node(Op::Mul, &[rise, product], span);
            let taken = self.node(Op::Mul, &[fall, before], span);
            (before, last) = (last, self.node(Op::Sub, &[raised, taken], span));
        }
        Ok(last)
    }

    /// The exact number p/q, q ≠ 0.
    pub(super) fn quotient(&mut self, p: i64, q: i64, span: Span) -> NodeId {
        let value = Rational::from_fraction(p, q).expect("the callers' denominators are positive");
        self.constant(value, span)
    }
}
