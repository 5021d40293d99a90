//! The named rules that every new node goes through; none changes where f is defined, nor any value.

use super::graph::{Graph, NodeId};
use super::op::Op;

impl Graph {
    /// The simplest node known to equal `op` of `args` wherever that has a value, and to have none elsewhere.
    pub fn apply(&mut self, op: Op, args: &[NodeId]) -> NodeId {
        self.intern(op, args)
    }
}
