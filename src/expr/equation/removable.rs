//! Where numerator and denominator vanish together: `z - sin(x)/x` becomes `z*x - sin(x) = 0`, whose every root on
//! x = 0 is none of the equation.
//!
//! In: a numerator and a denominator. Out: whether the numerator is 0 wherever the denominator is, by substitution.
//! Separate because it is knowledge for the tracer: where the numerator has one root on a piece of a ray and the
//! denominator has one, they are the same, and nothing is there; no enclosure alone could tell.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use crate::num::rational::Rational;
use std::collections::BTreeMap;

/// Whether g has the value 0 wherever d = 0. Only a d that is linear in a coordinate, with a constant factor, is
/// understood; "no" means not known.
pub fn vanishes_with(graph: &mut Graph, g: NodeId, d: NodeId) -> bool {
    [Variable::X, Variable::Y, Variable::Z].into_iter().any(|variable| {
        let variable = graph.variable(variable);
        let Some(value) = solved_for(graph, d, variable) else { return false };
        let substituted = substituted(graph, g, variable, value);
        graph.constant(substituted).is_some_and(Rational::is_zero)
    })
}

/// The value of the variable where d = 0, for d = c·v + rest with a constant c ≠ 0.
fn solved_for(graph: &mut Graph, d: NodeId, variable: NodeId) -> Option<NodeId> {
    let (zero, one) = (graph.integer(0), graph.integer(1));
    let seeds = [Variable::X, Variable::Y, Variable::Z].map(|v| if graph.variable(v) == variable { one } else { zero });
    let slope = crate::expr::derivative::derivative(graph, &[d], seeds)[0];
    if !graph.is_total(d) || graph.constant(slope).is_none_or(Rational::is_zero) || !is_smooth(graph, d) {
        return None;
    }
    let rest = substituted(graph, d, variable, zero);
    let quotient = graph.apply(Op::Div, &[rest, slope]);
    Some(graph.apply(Op::Neg, &[quotient]))
}

/// Whether a constant derivative means that the function is linear: nothing in it jumps.
fn is_smooth(graph: &Graph, d: NodeId) -> bool {
    graph
        .reachable(&[d])
        .into_iter()
        .all(|id| !matches!(graph.op(id), Op::Floor | Op::FloorDiv(_) | Op::Sign | Op::Choose))
}

/// The node with a value for a variable.
fn substituted(graph: &mut Graph, root: NodeId, variable: NodeId, value: NodeId) -> NodeId {
    let mut all: BTreeMap<NodeId, NodeId> = BTreeMap::new();
    for id in graph.reachable(&[root]) {
        let node = graph.node(id);
        let args: Vec<NodeId> = graph.args(id).iter().map(|a| all.get(a).copied().unwrap_or(*a)).collect();
        let new = if id == variable {
            value
        } else if args.is_empty() || args == node.args[..args.len()] {
            id
        } else {
            graph.apply(node.op, &args)
        };
        all.insert(id, new);
    }
    all.get(&root).copied().unwrap_or(root)
}
