//! Subexpressions without variables, computed once.
//!
//! In: a graph. Out: the point and the enclosure of each node that depends on nothing, such as √2 or sin(π/8).
//! Separate because rational folding in the graph is exact and this is not: the enclosure carries the error.

use super::kernel::Kernel;
use super::tape::Tape;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::interval::{Defined, Interval};
use crate::num::interval_lanes::IntervalLanes;
use crate::num::lanes::Lanes;
use crate::num::level::Simd;
use crate::num::number::Constant;

/// The largest of the constant subexpressions among `order` (arguments first), with their values. One whose
/// existence rounding leaves open, such as √(sin π), is left to be computed with its doubt.
pub(super) fn fold(graph: &Graph, order: &[NodeId], roots: &[NodeId]) -> Vec<(NodeId, Constant)> {
    let mut constant = vec![false; graph.len()];
    for &id in order {
        let leaf = match graph.op(id) {
            Op::Variable(_) => false,
            Op::Constant(_) | Op::Pi | Op::E => true,
            _ => graph.args(id).iter().all(|a| constant[a.0 as usize]),
        };
        constant[id.0 as usize] = leaf;
    }
    let composite = |id: NodeId| constant[id.0 as usize] && graph.op(id).arity() > 0;
    let users = order.iter().filter(|&&id| !constant[id.0 as usize]).flat_map(|&id| graph.args(id));
    let mut largest: Vec<NodeId> = users.chain(roots).copied().filter(|&id| composite(id)).collect();
    largest.sort();
    largest.dedup();
    if largest.is_empty() {
        return Vec::new();
    }
    evaluate(&Tape::unfolded(graph, &largest), &largest)
}

fn evaluate(tape: &Tape, nodes: &[NodeId]) -> Vec<(NodeId, Constant)> {
    let points: Kernel<Lanes<1>> = Kernel::new(tape, Simd::Portable);
    let ranges: Kernel<IntervalLanes<1>> = Kernel::new(tape, Simd::Portable);
    let (mut p, mut r) = (points.registers(), ranges.registers());
    points.run(&mut p);
    ranges.run(&mut r);
    let value = |k: usize| {
        let range = ranges.output(&r, k).get(0);
        match range.defined {
            Defined::Everywhere if range.continuous => {
                Some(Constant { point: points.output(&p, k).0[0], range: range.range })
            }
            Defined::Nowhere => Some(Constant { point: f64::NAN, range: Interval::EMPTY }),
            Defined::Everywhere | Defined::Somewhere => None,
        }
    };
    nodes.iter().enumerate().filter_map(|(k, &id)| Some((id, value(k)?))).collect()
}
