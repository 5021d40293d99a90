//! Which arguments of minima and maxima, and which branches of conditions, matter in a part of space.
//!
//! In: a formula. Out: the same with its long minima and maxima in balanced order; their arguments and the branches of its dear conditions are
//! numbered; and, from affine forms of the arguments and the conditions over slabs, which can be the smallest (or largest), or are chosen, in each. Separate from the operations,
//! which decide between two arguments in one cell; here many are struck out for many cells. [`super::shorten`] leaves
//! the others out.

use super::Excerpt;
use super::shorten::{Fork, users};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::affine_lanes::{AffineLanes, SYMBOLS};
use crate::num::level::{Simd, for_each_level};
use std::ops::Range;

/// The slabs that are looked at together.
pub const SLABS: usize = 16;

/// Forms over all slabs.
pub type Slabs = AffineLanes<SLABS>;

/// Fewer arguments than this are not worth it.
const FEWEST: usize = 3;

/// How many of the best arguments each is compared with: the nearest object and its neighbours.
const RIVALS: usize = 6;

/// Branches of fewer nodes than this, both together, are not worth it either.
const FEWEST_NODES: usize = 40;

/// The minima and maxima of several arguments in a formula, and the conditions between branches.
#[derive(Clone, Debug)]
pub struct Choices {
    groups: Vec<Group>,
    /// The arguments, group by group.
    pub leaves: Vec<NodeId>,
    /// For each, the node that tells whether it matters: itself, or the condition.
    pub telling: Vec<NodeId>,
    /// The nodes that choose between two of them, or between two such nodes.
    pub forks: Vec<Fork>,
}

/// A minimum or maximum of many, or a condition between two.
#[derive(Clone, Debug)]
struct Group {
    /// [`Op::Min`], [`Op::Max`] or [`Op::Choose`].
    op: Op,
    /// Numbers of its arguments.
    leaves: Range<usize>,
    /// Whether it is the whole formula, of which only the zeros and signs matter.
    is_root: bool,
}

/// A group as it is found.
type Extreme = (NodeId, Op, Vec<NodeId>);

impl Choices {
    /// The choices of a formula, and the formula in which they are balanced; `None` if it has none that are worth it.
    pub fn new(graph: &mut Graph, root: NodeId) -> Option<(NodeId, Choices)> {
        let mut found = extremes(graph, root);
        found.extend(branches(graph, root));
        // In the order in which they are balanced, so that their places are the same.
        found.sort_by_key(|group| group.0);
        loop {
            if found.is_empty() {
                return None;
            }
            let (new_root, choices) = balance(graph, root, &found);
            // A part of a group that is also read elsewhere must have its true value there.
            let users = users(graph, &[new_root]);
            let is_shared = |fork: &&Fork| !fork.is_top && users[fork.node.0 as usize] != 1;
            let Some(shared) = choices.forks.iter().find(is_shared) else { return Some((new_root, choices)) };
            let argument = shared.sides[0].0 as usize;
            let group = choices.groups.iter().position(|group| group.leaves.contains(&argument));
            found.remove(group.unwrap_or(0));
        }
    }

    /// How many arguments there are in all.
    pub fn arguments(&self) -> usize {
        self.leaves.len()
    }

    /// For each of these arguments (in rising order), a bit for every slab in which it matters, provided that no other
    /// argument does; `leaves` was run on the registers.
    pub fn live(&self, simd: Simd, leaves: &Excerpt<Slabs>, registers: &[Slabs], of: &[u32], bits: &mut Vec<u16>) {
        bits.clear();
        let mut bounds = Bounds::default();
        for group in &self.groups {
            let start = bits.len();
            let count = of[start..].partition_point(|&k| (k as usize) < group.leaves.end);
            let here = &of[start..start + count];
            let forms: Vec<&Slabs> = here.iter().map(|&k| leaves.output(registers, k as usize)).collect();
            if group.op == Op::Choose {
                let first = group.leaves.start as u32;
                bits.extend(here.iter().zip(forms).map(|(&k, condition)| chosen(condition, k == first)));
            } else {
                live_in_group(simd, &forms, group, &mut bounds, bits);
            }
        }
    }
}

/// A bit for every slab in which a branch can be chosen: the first where the condition is not positive.
fn chosen(condition: &Slabs, is_first: bool) -> u16 {
    (0..SLABS).fold(0, |mask, lane| {
        let (lo, hi) = condition.bounds(lane);
        let is_other = if is_first { lo > 0.0 } else { hi <= 0.0 };
        mask | u16::from(!is_other | (condition.flags[lane] != 0)) << lane
    })
}

/// The conditions between branches that are dear.
fn branches(graph: &Graph, root: NodeId) -> Vec<Extreme> {
    let order = graph.reachable(&[root]);
    let conditions = order.iter().copied().filter(|&id| graph.op(id) == Op::Choose);
    let branches = conditions.map(|id| (id, Op::Choose, graph.args(id)[1..].to_vec()));
    branches.filter(|(_, _, sides)| sides[0] != sides[1] && graph.reachable(sides).len() >= FEWEST_NODES).collect()
}

/// The minima and maxima of several arguments, each as large as it can be.
fn extremes(graph: &Graph, root: NodeId) -> Vec<Extreme> {
    let order = graph.reachable(&[root]);
    let is_choice = |id: NodeId| matches!(graph.op(id), Op::Min | Op::Max);
    let mut inside = vec![false; graph.len()];
    for &id in order.iter().filter(|&&id| is_choice(id)) {
        for &a in graph.args(id) {
            inside[a.0 as usize] |= graph.op(a) == graph.op(id);
        }
    }
    let tops = order.iter().copied().filter(|&id| is_choice(id) && (!inside[id.0 as usize] || id == root));
    tops.map(|node| (node, graph.op(node), leaves(graph, node))).filter(|group| group.2.len() >= FEWEST).collect()
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

/// The formula with each group as a tree of as few stages as can be: what is left of it in a part of space then is few copies deep.
fn balance(graph: &mut Graph, root: NodeId, found: &[Extreme]) -> (NodeId, Choices) {
    let mut choices = Choices { groups: Vec::new(), leaves: Vec::new(), telling: Vec::new(), forks: Vec::new() };
    let order = graph.reachable(&[root]);
    let mut copy: Vec<NodeId> = (0..graph.len() as u32).map(NodeId).collect();
    for id in order {
        let of = |id: &NodeId| copy[id.0 as usize];
        let node = match found.iter().find(|group| group.0 == id) {
            Some((_, op, leaves)) => {
                let leaves: Vec<NodeId> = leaves.iter().map(of).collect();
                let first = choices.leaves.len();
                let (node, telling) = if *op == Op::Choose {
                    let condition = of(&graph.args(id)[0]);
                    let node = graph.intern(Op::Choose, &[condition, leaves[0], leaves[1]]);
                    let (a, b) = (first as u32, first as u32 + 1);
                    choices.forks.push(Fork { node, sides: [(a, b), (b, b + 1)], is_top: true });
                    (node, vec![condition; 2])
                } else {
                    (tree(graph, *op, &leaves, first as u32, true, &mut choices.forks), leaves.clone())
                };
                choices.leaves.extend(leaves);
                choices.telling.extend(telling);
                let leaves = first..choices.leaves.len();
                choices.groups.push(Group { op: *op, leaves, is_root: id == root });
                node
            }
            None => {
                let args: Vec<NodeId> = graph.args(id).iter().map(of).collect();
                if args == graph.args(id) { id } else { graph.intern(graph.op(id), &args) }
            }
        };
        copy[id.0 as usize] = node;
    }
    (copy[root.0 as usize], choices)
}

fn tree(graph: &mut Graph, op: Op, leaves: &[NodeId], first: u32, is_top: bool, forks: &mut Vec<Fork>) -> NodeId {
    if let &[leaf] = leaves {
        return leaf;
    }
    let half = leaves.len() / 2;
    let (middle, end) = (first + half as u32, first + leaves.len() as u32);
    let left = tree(graph, op, &leaves[..half], first, false, forks);
    let right = tree(graph, op, &leaves[half..], middle, false, forks);
    let node = graph.intern(op, &[left, right]);
    forks.push(Fork { node, sides: [(first, middle), (middle, end)], is_top });
    node
}

/// What each argument of a group reaches, turned so that the smallest matters.
#[derive(Default)]
struct Bounds {
    low: Vec<[f64; SLABS]>,
    high: Vec<[f64; SLABS]>,
}

/// Adds for each argument of a group in which slabs it matters.
fn live_in_group(simd: Simd, forms: &[&Slabs], group: &Group, bounds: &mut Bounds, bits: &mut Vec<u16>) {
    let sign = if group.op == Op::Max { -1.0 } else { 1.0 };
    let least = bound(simd, forms, sign, group.is_root, bounds);
    let first = bits.len();
    for (k, form) in forms.iter().enumerate() {
        let mut mask = 0;
        for lane in 0..SLABS {
            // Written so that NaN is live. What may have no value takes the value of the whole with it.
            let is_live = !(bounds.low[k][lane] > least[lane]) | (form.flags[lane] != 0);
            mask |= u16::from(is_live) << lane;
        }
        bits.push(mask);
    }
    let bits = &mut bits[first..];
    let mut rivals: Vec<usize> = Vec::new();
    for lane in 0..SLABS {
        let high = |k: usize| bounds.high[k][lane];
        rivals.clear();
        rivals.extend((0..forms.len()).filter(|&k| bits[k] >> lane & 1 == 1));
        let rest: Vec<usize> = rivals.iter().copied().filter(|&k| forms[k].flags[lane] == 0).collect();
        rivals.retain(|&k| high(k) < f64::INFINITY);
        if rivals.len() > RIVALS {
            rivals.select_nth_unstable_by(RIVALS - 1, |&a, &b| high(a).total_cmp(&high(b)));
            rivals.truncate(RIVALS);
        }
        for k in rest {
            if rivals.iter().any(|&r| r != k && beats(forms[r], forms[k], lane, sign)) {
                bits[k] &= !(1 << lane);
            }
        }
    }
}

for_each_level! {
    /// The bounds of all forms; in each slab the least upper one, or 0 where only zeros matter and that is less: what is
    /// above it everywhere does not matter.
    fn bound[L](forms: &[&Slabs], sign: f64, is_root: bool, bounds: &mut Bounds) -> [f64; SLABS] {
        bounds.low.clear();
        bounds.high.clear();
        let mut least = [if is_root { 0.0 } else { f64::INFINITY }; SLABS];
        for form in forms {
            let (mut low, mut high) = ([0.0; SLABS], [0.0; SLABS]);
            for i in 0..SLABS {
                let radius = form.radius(i) + 4.0 * f64::EPSILON * form.center[i].abs();
                let center = sign * form.center[i];
                low[i] = center - radius;
                high[i] = center + radius;
                least[i] = if high[i] < least[i] { high[i] } else { least[i] };
            }
            bounds.low.push(low);
            bounds.high.push(high);
        }
        least
    }
}

/// Whether a is proven to be smaller than b (larger, for sign −1) in a slab.
fn beats(a: &Slabs, b: &Slabs, lane: usize, sign: f64) -> bool {
    let distance = sign * (b.center[lane] - a.center[lane]);
    let spread: f64 = (0..SYMBOLS).map(|s| (b.slope[s][lane] - a.slope[s][lane]).abs()).sum();
    let size = a.center[lane].abs() + b.center[lane].abs() + a.radius(lane) + b.radius(lane);
    distance > spread + a.error[lane] + b.error[lane] + 64.0 * f64::EPSILON * size
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::formula::formula;

    #[test]
    fn what_is_read_elsewhere_too_is_left_out_and_the_rest_stays() {
        let wave = |k: usize| format!("sin({k}*x)*cos({k}*y)*exp(z/{k})");
        let waves = |from: usize| (from..from + 8).map(wave).collect::<Vec<_>>().join("+");
        let branches = format!("if(x<=0,{},{})", waves(2), waves(20));
        // The minimum of y and z is a part of the first minimum.
        for text in [format!("{branches}+min(x,min(y,z))+2*min(y,z)"), format!("min(x,min(y,z))+2*min(y,z)+{branches}")]
        {
            let mut graph = Graph::new();
            let root = formula(&mut graph, &text);
            let (_, choices) = Choices::new(&mut graph, root).unwrap();
            assert_eq!(
                choices.forks.iter().map(|fork| graph.op(fork.node)).collect::<Vec<_>>(),
                [Op::Choose],
                "{text}"
            );
        }
    }
}
