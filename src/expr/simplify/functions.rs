//! Parity, inverse functions, and what a known sign decides.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::rational::Rational;

impl Graph {
    /// ±u in the one form that an even function takes it in; `None` if u has it already.
    pub(super) fn without_sign(&mut self, u: NodeId) -> Option<NodeId> {
        let (c, v, divisor) = self.coefficient(u);
        if c.is_negative() {
            return Some(self.scaled(&c.negated(), v, divisor));
        }
        let [a, b, _] = self.node(u).args;
        match self.op(u) {
            Op::Abs => Some(a),
            Op::Div if self.constant(a).is_some_and(Rational::is_negative) => Some(self.apply(Op::Neg, &[u])),
            Op::Sub if a > b || self.constant(a).is_some() => Some(self.apply(Op::Sub, &[b, a])),
            _ => None,
        }
    }
}

pub(super) fn absolute(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Abs, &[a]) = (op, args) else { return None };
    if graph.is_nonnegative(a) {
        return Some(a);
    }
    let (c, v, divisor) = graph.coefficient(a);
    if v != a && !c.is_zero() {
        let size = graph.apply(Op::Abs, &[v]);
        let (d, w, second) = graph.coefficient(size);
        let c = c.absolute().times(&d)?;
        return Some(graph.scaled(&c, w, divisor || second));
    }
    let a = graph.without_sign(a)?;
    Some(graph.apply(Op::Abs, &[a]))
}

pub(super) fn odd(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (
        Op::Sin
        | Op::Tan
        | Op::Asin
        | Op::Atan
        | Op::Sinh
        | Op::Tanh
        | Op::Asinh
        | Op::Atanh
        | Op::Erf
        | Op::Sign
        | Op::Root(_),
        &[a],
    ) = (op, args)
    else {
        return None;
    };
    let (c, v, divisor) = graph.coefficient(a);
    if !c.is_negative() {
        return None;
    }
    let a = graph.scaled(&c.negated(), v, divisor);
    let value = graph.apply(op, &[a]);
    Some(graph.apply(Op::Neg, &[value]))
}

pub(super) fn even(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Cos | Op::Cosh, &[a]) = (op, args) else { return None };
    let a = graph.without_sign(a)?;
    Some(graph.apply(op, &[a]))
}

pub(super) fn inverse(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let &[a] = args else { return None };
    let u = graph.node(a).args[0];
    match (op, graph.op(a)) {
        (Op::Ln, Op::Exp) => Some(u),
        (Op::Exp, Op::Ln) if graph.is_positive(u) => Some(u),
        _ => None,
    }
}

pub(super) fn known_sign(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Sign, &[a]) = (op, args) else { return None };
    if !graph.is_total(a) || !graph.is_nonzero(a) {
        return None;
    }
    let value = if graph.is_positive(a) {
        1
    } else if graph.is_nonpositive(a) {
        -1
    } else {
        return None;
    };
    Some(graph.integer(value))
}

pub(super) fn whole(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Floor, &[a]) = (op, args) else { return None };
    match graph.op(a) {
        Op::Floor | Op::FloorDiv(_) | Op::Sign => Some(a),
        Op::Add => {
            let [u, c, _] = graph.node(a).args;
            if !graph.constant(c)?.is_integer() {
                return None;
            }
            let floor = graph.apply(Op::Floor, &[u]);
            Some(graph.apply(Op::Add, &[floor, c]))
        }
        _ => None,
    }
}

/// The largest whole factor of a quotient under a floor: every whole number up to it is an f64.
const MOST_FACTOR: i64 = 1 << 53;

pub(super) fn floor_of_quotient(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    match (op, args) {
        (Op::Floor, &[a]) => floor_of_fraction(graph, a),
        (Op::FloorDiv(n), &[u, v]) => {
            let n = graph.integer(n);
            let numerator = graph.apply(Op::Mul, &[n, u]);
            let quotient = graph.apply(Op::Div, &[numerator, v]);
            Some(graph.apply(Op::Floor, &[quotient]))
        }
        _ => None,
    }
}

/// floor(p*u/(q*v)) for a fraction p/q in front that rounding could spoil.
fn floor_of_fraction(graph: &mut Graph, a: NodeId) -> Option<NodeId> {
    let (mut c, mut u, _) = graph.coefficient(a);
    let mut v = graph.integer(1);
    if graph.op(u) == Op::Div {
        [u, v, _] = graph.node(u).args;
        if let Some(numerator) = graph.constant(u) {
            c = c.times(numerator)?;
            u = graph.integer(1);
        }
    } else if graph.constant(a).is_some() || is_power_of_two(&c) {
        return None;
    }
    let (p, q) = c.to_fraction()?;
    if p == 0 || p.abs() > MOST_FACTOR {
        return None;
    }
    // A whole factor that the numerator takes into itself, as in 2*(1/x) = 2/x, is none in front.
    let numerator = graph.scaled(&Rational::from_integer(p), u, false);
    let (factor, inner, _) = graph.coefficient(numerator);
    let (n, u) = match factor.to_i64() {
        Some(n) if inner == u => (n.abs(), graph.scaled(&Rational::from_integer(n.signum()), u, false)),
        _ => (1, numerator),
    };
    let v = graph.scaled(&Rational::from_integer(q), v, false);
    Some(graph.intern(Op::FloorDiv(n), &[u, v]))
}

/// Whether a product with it has no rounding error.
fn is_power_of_two(c: &Rational) -> bool {
    c.numerator().magnitude().count_ones() == 1 && c.denominator().magnitude().count_ones() == 1
}
