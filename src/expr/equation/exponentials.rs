//! e^(2u) as (e^u)², so that polynomials in e^u are seen as such.
//!
//! In: a node. Out: the same with whole multiples in exponents written as powers. Separate because the simplifier goes the
//! other way, which is shorter.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use std::collections::BTreeMap;

/// The node with e^(n·u), n > 1 whole, as powers; `None` if there is none.
pub(super) fn as_powers(graph: &mut Graph, root: NodeId) -> Option<NodeId> {
    let mut written: BTreeMap<NodeId, NodeId> = BTreeMap::new();
    let mut found = false;
    for id in graph.reachable(&[root]) {
        let args: Vec<NodeId> = graph.args(id).iter().map(|a| written.get(a).copied().unwrap_or(*a)).collect();
        let new = match multiple(graph, id) {
            Some((n, u)) => {
                found = true;
                let base = graph.apply(Op::Exp, &[u]);
                graph.intern(Op::Power(n), &[base])
            }
            None if args.is_empty() => id,
            None => graph.intern(graph.op(id), &args),
        };
        written.insert(id, new);
    }
    if found { written.remove(&root) } else { None }
}

/// (n, u) of e^(n·u).
fn multiple(graph: &Graph, id: NodeId) -> Option<(i64, NodeId)> {
    let exponent = (graph.op(id) == Op::Exp).then(|| graph.args(id)[0])?;
    if graph.op(exponent) != Op::Mul {
        return None;
    }
    let [n, u, _] = graph.node(exponent).args;
    Some((graph.constant(n)?.to_i64().filter(|&n| n > 1)?, u))
}
