//! Which arguments of minima and maxima matter in a part of space, and the formula without the others.
//!
//! In: a formula, and affine forms of its arguments over slabs that together cover the part. Out: the arguments that can
//! be the smallest (or largest) somewhere in it, and a formula of those alone, which has the same values there.
//! Separate from the operations, which decide between two arguments in one cell; here many are struck out for many cells.

use super::{Kernel, Tape};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::affine_lanes::{AffineLanes, SYMBOLS};
use crate::num::level::Simd;

/// The slabs that are looked at together.
pub const SLABS: usize = 16;

/// Forms over all slabs.
pub type Slabs = AffineLanes<SLABS>;

/// Fewer arguments than this are not worth it.
const FEWEST: usize = 3;

/// How many of the best arguments each is compared with: the nearest object and its neighbours.
const RIVALS: usize = 6;

/// Which arguments are left, a bit each, group by group.
pub type Key = Vec<u64>;

/// A formula with minima and maxima of several arguments.
pub struct Choices {
    graph: Graph,
    root: NodeId,
    groups: Vec<Group>,
    leaves: Kernel<Slabs>,
}

/// A minimum or maximum of many.
struct Group {
    node: NodeId,
    op: Op,
    leaves: Vec<NodeId>,
}

impl Choices {
    /// The choices of a formula; `None` if it has none that are worth it.
    pub fn new(graph: &Graph, root: NodeId, simd: Simd) -> Option<Choices> {
        let groups = groups(graph, root);
        if groups.is_empty() {
            return None;
        }
        let mut own = Graph::new();
        let mut copy = vec![NodeId(0); graph.len()];
        for id in graph.reachable(&[root]) {
            copy[id.0 as usize] = copied(graph, id, &copy, &mut own);
        }
        let of = |id: NodeId| copy[id.0 as usize];
        let groups: Vec<Group> = groups
            .into_iter()
            .map(|g| Group { node: of(g.node), op: g.op, leaves: g.leaves.into_iter().map(of).collect() })
            .collect();
        let all: Vec<NodeId> = groups.iter().flat_map(|group| &group.leaves).copied().collect();
        let leaves = Kernel::new(&Tape::new(&own, &all), simd);
        Some(Choices { root: of(root), graph: own, groups, leaves })
    }

    /// Registers for the forms of all arguments.
    pub fn registers(&self) -> Vec<Slabs> {
        self.leaves.registers()
    }

    /// The arguments that matter in the first `count` slabs, whose coordinates are in the registers; `None` if all do.
    pub fn live(&self, registers: &mut [Slabs], count: usize) -> Option<Key> {
        self.leaves.run(registers);
        let total: usize = self.groups.iter().map(|group| group.leaves.len()).sum();
        let mut key = vec![0u64; total.div_ceil(64)];
        let (mut first, mut kept) = (0, 0);
        for group in &self.groups {
            let forms: Vec<&Slabs> =
                (first..first + group.leaves.len()).map(|k| self.leaves.output(registers, k)).collect();
            for (k, is_live) in live_in_group(&forms, count, group.op == Op::Max).into_iter().enumerate() {
                if is_live {
                    key[(first + k) / 64] |= 1 << ((first + k) % 64);
                    kept += 1;
                }
            }
            first += group.leaves.len();
        }
        (kept < total).then_some(key)
    }

    /// The formula of the arguments in the key alone.
    pub fn pruned(&self, key: &Key) -> (Graph, NodeId) {
        let mut first = 0;
        let mut live: Vec<Vec<NodeId>> = Vec::with_capacity(self.groups.len());
        for group in &self.groups {
            let is_live = |k: usize| key[(first + k) / 64] >> ((first + k) % 64) & 1 == 1;
            live.push((0..group.leaves.len()).filter(|&k| is_live(k)).map(|k| group.leaves[k]).collect());
            first += group.leaves.len();
        }
        let mut out = Graph::new();
        let mut copy = vec![None; self.graph.len()];
        let root = self.copy_live(self.root, &live, &mut copy, &mut out);
        (out, root)
    }

    /// Copies a node with what it still needs; iteratively, for formulas can be deep.
    fn copy_live(&self, root: NodeId, live: &[Vec<NodeId>], copy: &mut [Option<NodeId>], out: &mut Graph) -> NodeId {
        let mut stack = vec![root];
        while let Some(&id) = stack.last() {
            if copy[id.0 as usize].is_some() {
                stack.pop();
                continue;
            }
            let group = self.groups.iter().position(|group| group.node == id);
            let needed: &[NodeId] = group.map_or(self.graph.args(id), |k| &live[k]);
            let missing = stack.len();
            stack.extend(needed.iter().filter(|a| copy[a.0 as usize].is_none()));
            if stack.len() > missing {
                continue;
            }
            let args: Vec<NodeId> = needed.iter().filter_map(|a| copy[a.0 as usize]).collect();
            let new = match group {
                Some(k) => {
                    let op = self.groups[k].op;
                    args.into_iter().reduce(|a, b| out.apply(op, &[a, b])).unwrap_or(NodeId(0))
                }
                None => rebuilt(&self.graph, id, &args, out),
            };
            copy[id.0 as usize] = Some(new);
            stack.pop();
        }
        copy[root.0 as usize].unwrap_or(NodeId(0))
    }
}

/// The minima and maxima of several arguments, each as large as it can be.
fn groups(graph: &Graph, root: NodeId) -> Vec<Group> {
    let order = graph.reachable(&[root]);
    let is_choice = |id: NodeId| matches!(graph.op(id), Op::Min | Op::Max);
    let mut inside = vec![false; graph.len()];
    for &id in order.iter().filter(|&&id| is_choice(id)) {
        for &a in graph.args(id) {
            inside[a.0 as usize] |= graph.op(a) == graph.op(id);
        }
    }
    let tops = order.iter().copied().filter(|&id| is_choice(id) && (!inside[id.0 as usize] || id == root));
    let groups = tops.map(|node| Group { node, op: graph.op(node), leaves: leaves(graph, node) });
    groups.filter(|group| group.leaves.len() >= FEWEST).collect()
}

fn leaves(graph: &Graph, node: NodeId) -> Vec<NodeId> {
    let op = graph.op(node);
    let (mut found, mut stack) = (Vec::new(), vec![node]);
    while let Some(id) = stack.pop() {
        if graph.op(id) == op {
            stack.extend_from_slice(graph.args(id));
        } else {
            found.push(id);
        }
    }
    found.sort();
    found.dedup();
    found
}

fn copied(graph: &Graph, id: NodeId, copy: &[NodeId], out: &mut Graph) -> NodeId {
    let args: Vec<NodeId> = graph.args(id).iter().map(|a| copy[a.0 as usize]).collect();
    rebuilt(graph, id, &args, out)
}

fn rebuilt(graph: &Graph, id: NodeId, args: &[NodeId], out: &mut Graph) -> NodeId {
    match graph.constant(id) {
        Some(value) => out.number(value.clone()),
        None => out.intern(graph.op(id), args),
    }
}

/// For each argument, whether it can be the smallest (largest, if `max`) in some slab.
fn live_in_group(forms: &[&Slabs], count: usize, max: bool) -> Vec<bool> {
    let sign = if max { -1.0 } else { 1.0 };
    let mut live = vec![false; forms.len()];
    // What may have no value takes the value of the whole with it.
    let may_fail: Vec<bool> = forms.iter().map(|form| form.flags[..count].iter().any(|&f| f != 0)).collect();
    let mut rivals: Vec<usize> = Vec::with_capacity(forms.len());
    for lane in 0..count {
        let upper = |k: usize| sign * forms[k].center[lane] + forms[k].radius(lane);
        let lower = |k: usize| sign * forms[k].center[lane] - forms[k].radius(lane);
        rivals.clear();
        rivals.extend((0..forms.len()).filter(|&k| upper(k) < f64::INFINITY));
        if rivals.len() > RIVALS {
            rivals.select_nth_unstable_by(RIVALS - 1, |&a, &b| upper(a).total_cmp(&upper(b)));
            rivals.truncate(RIVALS);
        }
        let least = rivals.iter().map(|&k| upper(k)).fold(f64::INFINITY, f64::min);
        for k in 0..forms.len() {
            live[k] |= may_fail[k]
                || (!(lower(k) > least) && !rivals.iter().any(|&r| r != k && beats(forms[r], forms[k], lane, sign)));
        }
    }
    live
}

/// Whether a is proven to be smaller than b (larger, for sign −1) in a slab.
fn beats(a: &Slabs, b: &Slabs, lane: usize, sign: f64) -> bool {
    let distance = sign * (b.center[lane] - a.center[lane]);
    let spread: f64 = (0..SYMBOLS).map(|s| (b.slope[s][lane] - a.slope[s][lane]).abs()).sum();
    let size = a.center[lane].abs() + b.center[lane].abs() + a.radius(lane) + b.radius(lane);
    distance > spread + a.error[lane] + b.error[lane] + 64.0 * f64::EPSILON * size
}
