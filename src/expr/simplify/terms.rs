//! Sums, differences and multiples.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::rational::Rational;

/// How far down a sum like terms are looked for: enough for what people write, and a bound on the cost of every
/// new node.
const LOOK_AHEAD: usize = 8;

/// Numbers with at most this many bits in a dyadic fraction are f64 exactly.
const MANTISSA_BITS: u64 = 53;

/// Whether the value is an f64 (of ordinary size).
pub(super) fn is_double(c: &Rational) -> bool {
    let (p, q) = (c.numerator(), c.denominator());
    q.magnitude().count_ones() == 1 && p.bits() <= MANTISSA_BITS && q.bits() < 1000
}

impl Graph {
    /// u = c·v with c as large a constant factor as is visible; whether c was written as a divisor.
    pub(super) fn coefficient(&self, u: NodeId) -> (Rational, NodeId, bool) {
        let args = self.args(u);
        match self.op(u) {
            Op::Neg => (Rational::from_integer(-1), args[0], false),
            Op::Mul => match self.constant(args[0]) {
                Some(c) => (c.clone(), args[1], false),
                None => (Rational::from_integer(1), u, false),
            },
            Op::Div => match self.constant(args[1]).and_then(Rational::reciprocal) {
                Some(c) => (c, args[0], true),
                None => (Rational::from_integer(1), u, false),
            },
            _ => (Rational::from_integer(1), u, false),
        }
    }

    /// c·v, where v has no visible constant factor of its own. `divisor` asks for v/(1/c) where that is the more
    /// exact: where c is no f64 and 1/c is.
    pub(super) fn scaled(&mut self, c: &Rational, v: NodeId, divisor: bool) -> NodeId {
        if c.is_zero() {
            return self.zero_where_defined(v);
        }
        if c.is_one() {
            return v;
        }
        if let Some(folded) = self.scaled_inside(c, v) {
            return folded;
        }
        if *c == Rational::from_integer(-1) {
            return self.intern(Op::Neg, &[v]);
        }
        if let Some(inverse) = c.reciprocal()
            && divisor
            && !is_double(c)
            && is_double(&inverse)
        {
            let inverse = self.number(inverse);
            return self.intern(Op::Div, &[v, inverse]);
        }
        let c = self.number(c.clone());
        self.intern(Op::Mul, &[c, v])
    }

    /// The factor worked into a constant, the constant above a fraction, or (−1) into a difference.
    fn scaled_inside(&mut self, c: &Rational, v: NodeId) -> Option<NodeId> {
        let minus = *c == Rational::from_integer(-1);
        let (op, args) = (self.op(v), self.node(v).args);
        match op {
            Op::Constant(_) => {
                let value = self.constant(v)?.times(c)?;
                Some(self.number(value))
            }
            Op::Div => {
                let value = self.constant(args[0])?.times(c)?;
                let value = self.number(value);
                Some(self.intern(Op::Div, &[value, args[1]]))
            }
            Op::Sub if minus => Some(self.apply(Op::Sub, &[args[1], args[0]])),
            Op::Add if minus => {
                let value = self.constant(args[1])?.negated();
                let value = self.number(value);
                Some(self.intern(Op::Sub, &[value, args[0]]))
            }
            _ => None,
        }
    }

    /// c·u for any u.
    pub(super) fn multiple(&mut self, c: &Rational, u: NodeId) -> Option<NodeId> {
        let (d, v, divisor) = self.coefficient(u);
        let c = c.times(&d)?;
        Some(self.scaled(&c, v, divisor))
    }

    /// The sum with c·v added to one of its terms, if one of them is a multiple of v.
    fn absorbed_term(&mut self, sum: NodeId, c: &Rational, v: NodeId, depth: usize) -> Option<NodeId> {
        let op @ (Op::Add | Op::Sub) = self.op(sum) else { return None };
        let [left, right, _] = self.node(sum).args;
        let (d, w, divisor) = self.coefficient(right);
        if w == v {
            let total = if op == Op::Add { d.plus(c)? } else { c.minus(&d)? };
            let term = self.scaled(&total, v, divisor);
            return Some(self.apply(Op::Add, &[left, term]));
        }
        let (d, w, divisor) = self.coefficient(left);
        if w == v {
            let total = d.plus(c)?;
            let term = self.scaled(&total, v, divisor);
            return Some(self.apply(op, &[term, right]));
        }
        let left = if depth == 0 { None } else { self.absorbed_term(left, c, v, depth - 1) }?;
        Some(self.apply(op, &[left, right]))
    }
}

pub(super) fn negation(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Neg, &[a]) = (op, args) else { return None };
    graph.multiple(&Rational::from_integer(-1), a)
}

pub(super) fn constants_of_sum(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let &[a, b] = args else { return None };
    match op {
        Op::Add => {
            let c = graph.constant(b)?.clone();
            if c.is_zero() {
                return Some(a);
            }
            let [u, v, _] = graph.node(a).args;
            let (inner, other) = match graph.op(a) {
                Op::Add => (Op::Add, graph.constant(v)?.plus(&c)?),
                Op::Sub => (Op::Sub, graph.constant(u)?.plus(&c)?),
                _ => return None,
            };
            let other = graph.number(other);
            Some(if inner == Op::Add { graph.apply(inner, &[u, other]) } else { graph.apply(inner, &[other, v]) })
        }
        Op::Sub => difference_with_constant(graph, a, b),
        _ => None,
    }
}

fn difference_with_constant(graph: &mut Graph, a: NodeId, b: NodeId) -> Option<NodeId> {
    if let Some(c) = graph.constant(b) {
        let c = c.negated();
        let c = graph.number(c);
        return Some(graph.apply(Op::Add, &[a, c]));
    }
    let c = graph.constant(a)?.clone();
    if c.is_zero() {
        return Some(graph.apply(Op::Neg, &[b]));
    }
    let [u, v, _] = graph.node(b).args;
    match graph.op(b) {
        Op::Add => {
            let c = c.minus(graph.constant(v)?)?;
            let c = graph.number(c);
            Some(graph.apply(Op::Sub, &[c, u]))
        }
        Op::Sub => {
            let c = c.minus(graph.constant(u)?)?;
            let c = graph.number(c);
            Some(graph.apply(Op::Add, &[v, c]))
        }
        _ => None,
    }
}

pub(super) fn like_terms(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Add | Op::Sub, &[a, b]) = (op, args) else { return None };
    if graph.constant(a).is_some() || graph.constant(b).is_some() {
        return None;
    }
    let (c, u, first) = graph.coefficient(a);
    let (d, v, second) = graph.coefficient(b);
    let d = if op == Op::Sub { d.negated() } else { d };
    if u == v {
        let sum = c.plus(&d)?;
        return Some(graph.scaled(&sum, u, first || second));
    }
    if let Some(sum) = graph.absorbed_term(a, &d, v, LOOK_AHEAD) {
        return Some(sum);
    }
    if op == Op::Sub { None } else { graph.absorbed_term(b, &c, u, LOOK_AHEAD) }
}

pub(super) fn sine_and_cosine(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Add, &[a, b]) = (op, args) else { return None };
    let inner = |id: NodeId| {
        let square = (graph.op(id) == Op::Power(2)).then(|| graph.args(id)[0])?;
        let function = graph.op(square);
        matches!(function, Op::Sin | Op::Cos).then(|| (function, graph.args(square)[0]))
    };
    let ((f, u), (g, v)) = (inner(a)?, inner(b)?);
    if f == g || u != v {
        return None;
    }
    let one = graph.integer(1);
    let zero = graph.zero_where_defined(u);
    Some(graph.apply(Op::Add, &[zero, one]))
}

pub(super) fn signs_of_terms(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Add | Op::Sub, &[a, b]) = (op, args) else { return None };
    let (d, v, divisor) = graph.coefficient(b);
    if d.is_negative() {
        let b = graph.scaled(&d.negated(), v, divisor);
        return Some(graph.apply(if op == Op::Add { Op::Sub } else { Op::Add }, &[a, b]));
    }
    let (c, u, divisor) = graph.coefficient(a);
    if op == Op::Add && c.is_negative() {
        let a = graph.scaled(&c.negated(), u, divisor);
        return Some(graph.apply(Op::Sub, &[b, a]));
    }
    if op == Op::Sub && c == Rational::from_integer(-1) {
        let sum = graph.apply(Op::Add, &[u, b]);
        return Some(graph.apply(Op::Neg, &[sum]));
    }
    None
}
