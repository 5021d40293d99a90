//! The f64 of a node that hangs on no variable: bounds of parameters, the camera, the clip.
//!
//! In: a node. Out: its value, or nothing if it needs x, y or z. Separate from the closures, which come later
//! and work on whole batches.

use super::Lowerer;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use std::collections::HashMap;

/// The value of a node that hangs on no variable; NaN where it has none.
pub(super) fn constant_value(graph: &Graph, root: NodeId) -> Option<f64> {
    if let Some(exact) = graph.constant(root) {
        return Some(exact.to_f64());
    }
    let mut values: HashMap<NodeId, f64> = HashMap::new();
    for id in graph.reachable(&[root]) {
        let args: Vec<f64> = graph.args(id).iter().map(|a| values[a]).collect();
        let value = match graph.constant(id) {
            Some(exact) => exact.to_f64(),
            None => operation(graph.op(id), &args)?,
        };
        values.insert(id, value);
    }
    values.get(&root).copied()
}

impl Lowerer<'_> {
    /// The value of a node that hangs on no variable; NaN where it has none.
    pub(super) fn constant_value(&self, id: NodeId) -> Option<f64> {
        constant_value(&self.graph, id)
    }
}

fn operation(op: Op, a: &[f64]) -> Option<f64> {
    Some(match op {
        Op::Pi => std::f64::consts::PI,
        Op::E => std::f64::consts::E,
        Op::Neg => -a[0],
        Op::Abs => a[0].abs(),
        Op::Sqrt => a[0].sqrt(),
        Op::Add => a[0] + a[1],
        Op::Sub => a[0] - a[1],
        Op::Mul => a[0] * a[1],
        Op::Div => a[0] / a[1],
        _ => return None,
    })
}
