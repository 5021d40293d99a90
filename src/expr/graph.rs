//! The arena of nodes: hash-consed, so that an equal subexpression is one node however often it is written.

use super::op::{Op, Variable};
use super::signs::Signs;
use crate::diag::Span;
use crate::num::rational::Rational;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// A node of one [`Graph`]. A node's arguments have smaller numbers than the node itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(pub u32);

/// An operation with its arguments; those past the operation's arity are `NodeId(0)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Node {
    /// What it does.
    pub op: Op,
    /// To what.
    pub args: [NodeId; 3],
}

/// Hashes nodes: a few small numbers, mixed by a multiplication of which both halves count (Dietzfelbinger et al. 1997 say why
/// a product's upper half is a good hash). The standard library's hasher took a tenth of the time that derivatives take.
#[derive(Clone, Copy, Debug, Default)]
struct Mixer(u64);

impl Hasher for Mixer {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.write_u64(byte.into()));
    }

    fn write_u32(&mut self, number: u32) {
        self.write_u64(number.into());
    }

    fn write_u64(&mut self, number: u64) {
        // The fraction of the golden ratio: an odd number without a pattern (Knuth, TAOCP 3, section 6.4).
        let product = u128::from(self.0.rotate_left(32) ^ number ^ 0x5851_f42d_4c95_7f2d) * 0x9e37_79b9_7f4a_7c15;
        self.0 = (product as u64) ^ (product >> 64) as u64;
    }

    fn write_i64(&mut self, number: i64) {
        self.write_u64(number as u64);
    }

    fn write_isize(&mut self, number: isize) {
        self.write_u64(number as u64);
    }

    fn write_usize(&mut self, number: usize) {
        self.write_u64(number as u64);
    }
}

/// A set of formulas that share their subexpressions.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    /// The text each node came from first; none for what no text says (a derivative's own terms).
    spans: Vec<Option<Span>>,
    /// Whether each node has a value at every point where its variables have one.
    total: Vec<bool>,
    /// Which signs the values of each node can have.
    signs: Vec<Signs>,
    index: HashMap<Node, NodeId, BuildHasherDefault<Mixer>>,
    constants: Vec<Rational>,
    constant_index: HashMap<Rational, u32>,
    /// The derivatives of nodes that are known, by the rates of x, y and z.
    derivatives: HashMap<[NodeId; 3], Vec<Option<NodeId>>>,
    /// The text given to nodes made from now on.
    here: Option<Span>,
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// The node that is exactly `op` of `args`, made if it is new. No rule is applied: see [`super::simplify`].
    pub fn intern(&mut self, op: Op, args: &[NodeId]) -> NodeId {
        debug_assert_eq!(args.len(), op.arity());
        let mut node = Node { op, args: [NodeId(0); 3] };
        node.args[..args.len()].copy_from_slice(args);
        if let Some(&known) = self.index.get(&node) {
            return known;
        }
        let id = NodeId(self.nodes.len() as u32);
        let total = args.iter().all(|&a| self.total[a.0 as usize]) && self.is_defined_for_all(node);
        self.nodes.push(node);
        self.spans.push(self.here);
        self.total.push(total);
        let signs = self.signs_of(node);
        self.signs.push(signs);
        self.index.insert(node, id);
        id
    }

    /// Whether the operation itself has a value for all values of these arguments.
    fn is_defined_for_all(&self, node: Node) -> bool {
        match node.op {
            Op::Constant(_)
            | Op::Pi
            | Op::E
            | Op::Variable(_)
            | Op::Neg
            | Op::Abs
            | Op::Sign
            | Op::Exp
            | Op::Sin
            | Op::Cos
            | Op::Atan
            | Op::Sinh
            | Op::Cosh
            | Op::Tanh
            | Op::Asinh
            | Op::Erf
            | Op::Floor
            | Op::Root(_)
            | Op::Add
            | Op::Sub
            | Op::Mul
            | Op::Min
            | Op::Max
            | Op::Choose => true,
            Op::Power(n) => n > 0 || self.is_nonzero(node.args[0]),
            Op::Div | Op::FloorDiv(_) => self.is_nonzero(node.args[1]),
            Op::Sqrt => self.is_nonnegative(node.args[0]),
            Op::Ln | Op::Log2 | Op::Log10 => self.is_positive(node.args[0]),
            Op::Pow => {
                self.is_positive(node.args[0]) || self.is_nonnegative(node.args[0]) && self.is_positive(node.args[1])
            }
            Op::Tan | Op::Asin | Op::Acos | Op::Acosh | Op::Atanh | Op::Atan2 => false,
        }
    }

    fn signs_of(&self, node: Node) -> Signs {
        if let Op::Constant(index) = node.op {
            return match self.constants[index as usize].cmp(&Rational::from_integer(0)) {
                Ordering::Less => Signs::NEGATIVE,
                Ordering::Equal => Signs::ZERO,
                Ordering::Greater => Signs::POSITIVE,
            };
        }
        let argument = |i: usize| if i < node.op.arity() { self.signs[node.args[i].0 as usize] } else { Signs::ALL };
        Signs::of(node.op, [argument(0), argument(1), argument(2)])
    }

    /// Whether no value of the node is < 0.
    pub fn is_nonnegative(&self, id: NodeId) -> bool {
        self.signs[id.0 as usize].within(Signs::NOT_NEGATIVE)
    }

    /// Whether every value of the node is > 0.
    pub fn is_positive(&self, id: NodeId) -> bool {
        self.signs[id.0 as usize].within(Signs::POSITIVE)
    }

    /// Whether no value of the node is > 0.
    pub fn is_nonpositive(&self, id: NodeId) -> bool {
        self.signs[id.0 as usize].within(Signs::NOT_POSITIVE)
    }

    /// Whether no value of the node is 0.
    pub fn is_nonzero(&self, id: NodeId) -> bool {
        let signs = self.signs[id.0 as usize];
        !Signs::ZERO.within(signs)
    }

    /// The node of an exact number.
    pub fn number(&mut self, value: Rational) -> NodeId {
        let next = self.constants.len() as u32;
        let index = *self.constant_index.entry(value.clone()).or_insert(next);
        if index == next {
            self.constants.push(value);
        }
        self.intern(Op::Constant(index), &[])
    }

    /// The node of a whole number.
    pub fn integer(&mut self, value: i64) -> NodeId {
        self.number(Rational::from_integer(value))
    }

    /// The node of a variable.
    pub fn variable(&mut self, variable: Variable) -> NodeId {
        self.intern(Op::Variable(variable), &[])
    }

    /// The operation and arguments of a node.
    pub fn node(&self, id: NodeId) -> Node {
        self.nodes[id.0 as usize]
    }

    /// The operation of a node.
    pub fn op(&self, id: NodeId) -> Op {
        self.nodes[id.0 as usize].op
    }

    /// The arguments of a node: as many as its operation takes.
    pub fn args(&self, id: NodeId) -> &[NodeId] {
        let node = &self.nodes[id.0 as usize];
        &node.args[..node.op.arity()]
    }

    /// The number, if the node is an exact constant.
    pub fn constant(&self, id: NodeId) -> Option<&Rational> {
        match self.op(id) {
            Op::Constant(index) => Some(&self.constants[index as usize]),
            _ => None,
        }
    }

    /// The number behind an [`Op::Constant`].
    pub fn constants(&self, index: u32) -> &Rational {
        &self.constants[index as usize]
    }

    /// Whether the node has a value at every point: no root, quotient or logarithm in it can fail.
    pub fn is_total(&self, id: NodeId) -> bool {
        self.total[id.0 as usize]
    }

    /// The text the node came from.
    pub fn span(&self, id: NodeId) -> Option<Span> {
        self.spans[id.0 as usize]
    }

    /// The derivatives of nodes, by their numbers, that were kept for these rates of x, y and z.
    pub(super) fn take_derivatives(&mut self, seeds: [NodeId; 3]) -> Vec<Option<NodeId>> {
        self.derivatives.remove(&seeds).unwrap_or_default()
    }

    /// Keeps derivatives of nodes.
    pub(super) fn keep_derivatives(&mut self, seeds: [NodeId; 3], of: Vec<Option<NodeId>>) {
        self.derivatives.insert(seeds, of);
    }

    /// Sets the text that nodes made from now on come from, and returns the one before.
    pub fn set_span(&mut self, span: Option<Span>) -> Option<Span> {
        std::mem::replace(&mut self.here, span)
    }

    /// How many nodes there are.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// The nodes that `roots` are made of, arguments before their users, each once.
    pub fn reachable(&self, roots: &[NodeId]) -> Vec<NodeId> {
        let mut seen = vec![false; self.nodes.len()];
        let mut stack: Vec<NodeId> = roots.to_vec();
        while let Some(id) = stack.pop() {
            if !std::mem::replace(&mut seen[id.0 as usize], true) {
                stack.extend_from_slice(self.args(id));
            }
        }
        (0..self.nodes.len() as u32).map(NodeId).filter(|id| seen[id.0 as usize]).collect()
    }
}
