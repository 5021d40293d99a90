//! So much of a list of steps as some part of space needs.
//!
//! In: a tape, which of its nodes choose between groups of arguments, and which arguments are live. Out: numbers of closures of
//! the tape's [`super::Kernel`]: the steps that the roots still depend on, a choice between a live side and a dead one
//! become a copy. No formula is built and nothing compiled: a part of space costs four bytes a step. Registers stay what
//! they are, for between a step that writes one and those that read it no other step of the tape writes it.
//! Separate from [`super::specialise`], which finds out what is live.

use super::tape::{Action, Register, Tape};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use std::collections::BTreeMap;

/// A node that takes one of two sides: each a range of arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fork {
    /// The node.
    pub node: NodeId,
    /// The arguments behind its first operand and behind its second.
    pub sides: Sides,
    /// Whether it is the whole group, whose value is the same whatever is left out.
    pub is_top: bool,
}

/// The arguments behind each of two operands: from the first of them to the one after the last.
pub type Sides = [(u32, u32); 2];

/// No step: a variable or a constant.
const NONE: u32 = u32::MAX;

/// A tape taken apart.
pub struct Shortener {
    /// For every step, the steps that make what it reads.
    sources: Vec<[u32; 4]>,
    /// For every step, which fork it is.
    fork: Vec<u32>,
    /// The forks: their sides, and which of the step's operands each is.
    forks: Vec<(Sides, [usize; 2])>,
    /// What the copies behind the steps copy, and to where.
    copies: Vec<(Register, Register)>,
    /// The steps that make the roots.
    outputs: Vec<u32>,
}

impl Shortener {
    /// A tape with these forks, which are private: see [`is_private`].
    pub fn new(tape: &Tape, forks: &[Fork]) -> Shortener {
        let known: BTreeMap<NodeId, Sides> = forks.iter().map(|fork| (fork.node, fork.sides)).collect();
        let mut maker = vec![NONE; tape.registers];
        let mut all = Shortener {
            sources: Vec::with_capacity(tape.steps.len()),
            fork: Vec::with_capacity(tape.steps.len()),
            forks: Vec::new(),
            copies: Vec::new(),
            outputs: Vec::new(),
        };
        for (k, (step, node)) in tape.steps.iter().zip(&tape.nodes).enumerate() {
            all.sources.push(step.args.map(|a| maker[a as usize]));
            let operands = match step.action {
                Action::One(Op::Min | Op::Max) => Some([0, 1]),
                Action::One(Op::Choose) => Some([1, 2]),
                _ => None,
            };
            let fork = operands.zip(known.get(node).copied()).map(|(operands, sides)| {
                all.copies.extend(operands.map(|o| (step.args[o], step.out)));
                all.forks.push((sides, operands));
                all.forks.len() as u32 - 1
            });
            all.fork.push(fork.unwrap_or(NONE));
            maker[step.out as usize] = k as u32;
            if let Action::SinCos(cosine) = step.action {
                maker[cosine as usize] = k as u32;
            }
        }
        all.outputs = tape.outputs.iter().map(|&o| maker[o as usize]).collect();
        all
    }

    /// From where to where each copy goes; their closures follow those of the steps.
    pub fn copies(&self) -> impl Iterator<Item = (Register, Register)> + '_ {
        self.copies.iter().copied()
    }

    /// The closures that compute some of the roots where only the live arguments matter.
    pub fn shorten(&self, roots: impl Iterator<Item = usize>, live: &[u32]) -> Vec<u32> {
        let mut needed = vec![0u64; self.fork.len().div_ceil(64)];
        let mut stack: Vec<u32> = roots.map(|k| self.outputs[k]).collect();
        while let Some(step) = stack.pop() {
            if step == NONE || needed[step as usize / 64] >> (step % 64) & 1 == 1 {
                continue;
            }
            needed[step as usize / 64] |= 1 << (step % 64);
            let sources = &self.sources[step as usize];
            match self.taken(step, live) {
                Some((_, operand)) => stack.push(sources[operand]),
                None => stack.extend_from_slice(sources),
            }
        }
        let mut list = numbers(&needed);
        for step in &mut list {
            *step = self.taken(*step, live).map_or(*step, |(copy, _)| copy);
        }
        list
    }

    /// The copy that a step comes down to, and the operand copied, if one of its sides alone is live.
    fn taken(&self, step: u32, live: &[u32]) -> Option<(u32, usize)> {
        let fork = self.fork[step as usize];
        let (sides, operands) = self.forks.get(fork as usize)?;
        let side = match sides.map(|side| is_any(live, side)) {
            [true, false] => 0,
            [false, true] => 1,
            _ => return None,
        };
        Some((self.fork.len() as u32 + 2 * fork + side, operands[side as usize]))
    }
}

/// The numbers of the bits that are set.
pub(crate) fn numbers(bits: &[u64]) -> Vec<u32> {
    let mut list = Vec::new();
    for (word, &bits) in bits.iter().enumerate() {
        let mut bits = bits;
        while bits != 0 {
            list.push(word as u32 * 64 + bits.trailing_zeros());
            bits &= bits - 1;
        }
    }
    list
}

/// Whether any of the live arguments, in rising order, is in the range.
fn is_any(live: &[u32], (first, end): (u32, u32)) -> bool {
    live.get(live.partition_point(|&k| k < first)).is_some_and(|&k| k < end)
}

/// Whether none of these forks but whole groups is read more than once among `roots`. Elsewhere it would have to have its true
/// value, and so would a node that is two forks.
pub fn is_private(graph: &Graph, roots: &[NodeId], forks: &[Fork]) -> bool {
    let users = users(graph, roots);
    let mut sides = BTreeMap::new();
    forks.iter().all(|fork| {
        (fork.is_top || users.get(fork.node.0 as usize).is_none_or(|&count| count <= 1))
            && *sides.entry(fork.node).or_insert(fork.sides) == fork.sides
    })
}

/// How often each node is read, the roots once more.
pub(super) fn users(graph: &Graph, roots: &[NodeId]) -> Vec<u32> {
    let mut users = vec![0; graph.len()];
    for id in graph.reachable(roots) {
        for &a in graph.args(id) {
            users[a.0 as usize] += 1;
        }
    }
    for root in roots {
        users[root.0 as usize] += 1;
    }
    users
}
