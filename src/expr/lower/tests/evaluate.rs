//! The value of a graph's node at a point, without the closures.

use crate::expr::estimate::plain;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use std::collections::HashMap;

/// The value of a node at a point; NaN where it has none.
pub(super) fn value_at(graph: &Graph, root: NodeId, point: [f64; 3]) -> f64 {
    let mut values: HashMap<NodeId, f64> = HashMap::new();
    for id in graph.reachable(&[root]) {
        let arg = |k: usize| graph.args(id).get(k).map_or(0.0, |a| values[a]);
        let value = match (graph.constant(id), graph.op(id)) {
            (Some(exact), _) => exact.to_f64(),
            (None, Op::Variable(Variable::X)) => point[0],
            (None, Op::Variable(Variable::Y)) => point[1],
            (None, Op::Variable(Variable::Z)) => point[2],
            (None, Op::Choose) if arg(0).is_nan() => f64::NAN,
            (None, op) => plain(op, arg(0), arg(1), arg(2)),
        };
        values.insert(id, value);
    }
    values[&root]
}
