//! Least, greatest, chosen.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::rational::Rational;

fn is_extreme(op: Op) -> bool {
    matches!(op, Op::Min | Op::Max)
}

pub(super) fn equals(_: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    (is_extreme(op) && args[0] == args[1]).then(|| args[0])
}

pub(super) fn constants(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let &[a, b] = args else { return None };
    if !is_extreme(op) || graph.op(a) != op {
        return None;
    }
    let [u, c, _] = graph.node(a).args;
    let (c, d) = (graph.constant(c)?.clone(), graph.constant(b)?.clone());
    let value = graph.number(if op == Op::Min { c.min(d) } else { c.max(d) });
    Some(graph.apply(op, &[u, value]))
}

pub(super) fn repeated(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let &[a, b] = args else { return None };
    if !is_extreme(op) {
        return None;
    }
    let holds = |whole: NodeId, part: NodeId| graph.op(whole) == op && graph.args(whole).contains(&part);
    if holds(a, b) {
        Some(a)
    } else if holds(b, a) {
        Some(b)
    } else {
        None
    }
}

pub(super) fn opposites(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let &[a, b] = args else { return None };
    let opposite = match op {
        Op::Min => Op::Max,
        Op::Max => Op::Min,
        _ => return None,
    };
    if graph.op(a) != Op::Neg || graph.op(b) != Op::Neg {
        return None;
    }
    let (u, v) = (graph.args(a)[0], graph.args(b)[0]);
    let value = graph.apply(opposite, &[u, v]);
    Some(graph.apply(Op::Neg, &[value]))
}

pub(super) fn decided(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Choose, &[c, a, b]) = (op, args) else { return None };
    if let Some(value) = graph.constant(c) {
        return Some(if *value > Rational::from_integer(0) { b } else { a });
    }
    if !graph.is_total(c) {
        return None;
    }
    if graph.is_positive(c) {
        return Some(b);
    }
    graph.is_nonpositive(c).then_some(a)
}

pub(super) fn equal_branches(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Choose, &[c, a, b]) = (op, args) else { return None };
    (a == b && graph.is_total(c)).then_some(a)
}
