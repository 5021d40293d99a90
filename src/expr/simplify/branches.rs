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

/// max(u, -u) = |u|, min(u, -u) = -|u|: both sides of one boundary, as in `x <= 0 or x >= 0`.
pub(super) fn both_sides(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let &[a, b] = args else { return None };
    if !is_extreme(op) || !is_negated(graph, a, b) {
        return None;
    }
    let size = graph.apply(Op::Abs, &[a]);
    Some(if op == Op::Max { size } else { graph.apply(Op::Neg, &[size]) })
}

/// Whether a = -b in the forms that simplification leaves: -u and u, u - v and v - u, u + 1 and -1 - u.
fn is_negated(graph: &Graph, a: NodeId, b: NodeId) -> bool {
    let ([p, q, _], [r, s, _]) = (graph.node(a).args, graph.node(b).args);
    let opposite =
        |c: NodeId, d: NodeId| graph.constant(c).zip(graph.constant(d)).is_some_and(|(c, d)| *c == d.negated());
    match (graph.op(a), graph.op(b)) {
        (Op::Sub, Op::Sub) => p == s && q == r,
        (Op::Add, Op::Sub) => p == s && opposite(q, r),
        (Op::Sub, Op::Add) => r == q && opposite(s, p),
        _ => {
            let ((c, u, _), (d, v, _)) = (graph.coefficient(a), graph.coefficient(b));
            u == v && c == d.negated()
        }
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
