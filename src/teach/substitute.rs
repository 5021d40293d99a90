//! A formula with other formulas for x, y and z.
//!
//! In: a node, and what stands for each coordinate. Out: a node. Separate because a mirror image, a turn and a ray are all of
//! this kind.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};

/// f with x, y, z replaced at the same time.
pub fn substitute(graph: &mut Graph, f: NodeId, by: [NodeId; 3]) -> NodeId {
    let nodes = graph.reachable(&[f]);
    let mut image: Vec<NodeId> = vec![NodeId(0); f.0 as usize + 1];
    for id in nodes {
        let node = graph.node(id);
        image[id.0 as usize] = match node.op {
            Op::Variable(Variable::X) => by[0],
            Op::Variable(Variable::Y) => by[1],
            Op::Variable(Variable::Z) => by[2],
            op if op.arity() == 0 => id,
            op => {
                let args: Vec<NodeId> = graph.args(id).iter().map(|a| image[a.0 as usize]).collect();
                graph.apply(op, &args)
            }
        };
    }
    image[f.0 as usize]
}

/// The nodes of x, y, z.
pub fn coordinates(graph: &mut Graph) -> [NodeId; 3] {
    [Variable::X, Variable::Y, Variable::Z].map(|v| graph.variable(v))
}
