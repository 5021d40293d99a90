//! The sheets of an equation as one function again.
//!
//! In: the node of f. Out: a node that is 0 where the sheets are, with simple roots, so that its gradient is the surface's normal.

use super::{Sheet, Sign, sheets};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;

/// The rewritten function of an equation, with the sign of f where that is known; of several factors their product.
pub fn whole(graph: &mut Graph, f: NodeId) -> NodeId {
    match &sheets(graph, f).sheets[..] {
        [] => f,
        [Sheet { g, sign: Sign::Opposite, .. }] => graph.apply(Op::Neg, &[*g]),
        [first, rest @ ..] => rest.iter().fold(first.g, |product, sheet| graph.apply(Op::Mul, &[product, sheet.g])),
    }
}
