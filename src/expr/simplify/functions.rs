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
        Op::Floor | Op::Sign => Some(a),
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
