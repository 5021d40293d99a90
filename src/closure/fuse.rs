//! Which nodes are computed together with their only user, in one pass over the batch.
//!
//! In: nodes in order. Out: for each node the step that computes it, or that its user does. Points are computed as fast
//! as they can be read and written, and a sum or a product costs less than that; so two of them in one step cost as
//! much as one. Separate from the list itself because enclosures, which cost more, do not profit.

use super::tape::Action;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::number::{Basic, Pair};

/// How each node is computed.
pub(super) struct Fusion {
    /// Computed by its user.
    pub(super) inside: Vec<bool>,
    /// Computed together with arguments of its own: the step, and what it reads.
    pub(super) joined: Vec<Option<(Action, [NodeId; 4])>>,
}

impl Fusion {
    /// Nothing together.
    pub(super) fn none(graph: &Graph) -> Self {
        Fusion { inside: vec![false; graph.len()], joined: vec![None; graph.len()] }
    }

    /// As many as can be, among `order` (arguments first); `known` nodes are not computed at all.
    pub(super) fn of(graph: &Graph, order: &[NodeId], roots: &[NodeId], known: &[NodeId]) -> Self {
        let mut users = vec![0u32; graph.len()];
        for &a in order.iter().flat_map(|&id| graph.args(id)).chain(roots).chain(roots) {
            users[a.0 as usize] += 1;
        }
        for id in known {
            users[id.0 as usize] = u32::MAX;
        }
        let mut fusion = Fusion::none(graph);
        for &id in order {
            fusion.join(graph, id, &users);
        }
        fusion
    }

    fn join(&mut self, graph: &Graph, id: NodeId, users: &[u32]) {
        let Some((second, [p, q])) = basic(graph, id).filter(|(_, [p, q])| p != q) else { return };
        let inner = |fusion: &Fusion, a: NodeId| {
            let free = users[a.0 as usize] == 1 && fusion.joined[a.0 as usize].is_none();
            basic(graph, a).filter(|_| free)
        };
        let (left, right) = (inner(self, p), inner(self, q));
        let joined = match (left, right) {
            (Some((Basic::Mul, [a, b])), Some((Basic::Mul, [c, d]))) if second != Basic::Mul => {
                self.inside[q.0 as usize] = true;
                self.inside[p.0 as usize] = true;
                (Action::Products { minus: second == Basic::Sub }, [a, b, c, d])
            }
            (Some((first, [a, b])), _) => {
                self.inside[p.0 as usize] = true;
                (Action::Pair(Pair { first, second, reversed: false }), [a, b, q, q])
            }
            (None, Some((first, [a, b]))) => {
                self.inside[q.0 as usize] = true;
                (Action::Pair(Pair { first, second, reversed: true }), [a, b, p, p])
            }
            (None, None) => return,
        };
        self.joined[id.0 as usize] = Some(joined);
    }
}

/// The node as one of the three basic operations.
fn basic(graph: &Graph, id: NodeId) -> Option<(Basic, [NodeId; 2])> {
    let args = graph.args(id);
    match graph.op(id) {
        Op::Add => Some((Basic::Add, [args[0], args[1]])),
        Op::Sub => Some((Basic::Sub, [args[0], args[1]])),
        Op::Mul => Some((Basic::Mul, [args[0], args[1]])),
        Op::Power(2) => Some((Basic::Mul, [args[0], args[0]])),
        _ => None,
    }
}
