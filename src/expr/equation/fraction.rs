//! Sums of quotients over one denominator: `z - 1/x` becomes `(z*x - 1)/x`, `z - tan(x)` (z cos x − sin x)/cos x.
//!
//! In: a node. Out: a numerator without poles, and the denominators. Separate because it walks through sums,
//! products and powers, while the rest of the rewriting looks at one operation. Only poles that change sign are
//! worth it: `1/(1+x^2)` and `1/x^2` stay as they are.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use std::collections::BTreeMap;

/// The most different denominators; each multiplies all other terms.
const MAX_DENOMINATORS: usize = 4;

/// The most nodes that the numerator may have, as a multiple of what f has, and besides.
const MAX_GROWTH: (usize, usize) = (4, 60);

/// The highest power of a denominator.
const MAX_POWER: i64 = 12;

/// numerator / ∏ denominators: equal to what it was made from wherever no denominator is 0.
pub(super) struct Fraction {
    /// Has a value wherever the original has one.
    pub(super) numerator: NodeId,
    /// The different denominators, without their powers.
    pub(super) denominators: Vec<NodeId>,
}

/// A node as numerator over powers of denominators.
#[derive(Clone)]
struct Parts {
    numerator: NodeId,
    powers: BTreeMap<NodeId, i64>,
}

/// The node as one fraction; `None` where there is no denominator that can be 0, or too many, or nothing is gained.
pub(super) fn together(graph: &mut Graph, root: NodeId) -> Option<Fraction> {
    let order = interior(graph, root);
    if !order.iter().any(|&(id, inside)| inside && has_pole(graph, id)) {
        return None;
    }
    let size = graph.reachable(&[root]).len();
    let mut all: BTreeMap<NodeId, Parts> = BTreeMap::new();
    for (id, inside) in order {
        let parts = if inside { combined(graph, id, &all)? } else { Parts { numerator: id, powers: BTreeMap::new() } };
        if parts.powers.len() > MAX_DENOMINATORS || parts.powers.values().any(|&n| n > MAX_POWER) {
            return None;
        }
        all.insert(id, parts);
    }
    let parts = all.remove(&root)?;
    let vanishes =
        graph.constant(parts.numerator).is_some_and(|c| c.is_zero()) || is_zero_multiple(graph, parts.numerator);
    if parts.powers.is_empty() || vanishes {
        return None;
    }
    let grown = graph.reachable(&[parts.numerator]).len();
    (grown <= size * MAX_GROWTH.0 + MAX_GROWTH.1)
        .then(|| Fraction { numerator: parts.numerator, denominators: parts.powers.into_keys().collect() })
}

fn is_zero_multiple(graph: &Graph, id: NodeId) -> bool {
    graph.op(id) == Op::Mul && graph.constant(graph.args(id)[0]).is_some_and(|c| c.is_zero())
}

/// Whether the operation has a pole that hides the sign of f: one across which it jumps, or where it is 0/0. Near
/// `1/x^2` f is large and of one sign, and a common denominator would only make its enclosures wider.
fn has_pole(graph: &Graph, id: NodeId) -> bool {
    match graph.op(id) {
        Op::Div => {
            let (a, b) = (graph.args(id)[0], graph.args(id)[1]);
            let one_sided = graph.is_nonzero(a) && (graph.is_nonnegative(b) || graph.is_nonpositive(b));
            !graph.is_nonzero(b) && !one_sided
        }
        Op::Power(n) => n < 0 && n % 2 != 0 && !graph.is_nonzero(graph.args(id)[0]),
        Op::Tan => true,
        _ => false,
    }
}

/// The nodes that a fraction is built through, leaves included, arguments before users.
fn interior(graph: &Graph, root: NodeId) -> Vec<(NodeId, bool)> {
    let mut seen = BTreeMap::new();
    let mut stack = vec![root];
    while let Some(id) = stack.pop() {
        let inside = match graph.op(id) {
            Op::Neg | Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Tan => true,
            Op::Power(n) => n.abs() <= MAX_POWER,
            _ => false,
        };
        if seen.insert(id, inside).is_none() && inside && graph.op(id) != Op::Tan {
            stack.extend_from_slice(graph.args(id));
        }
    }
    seen.into_iter().collect()
}

fn combined(graph: &mut Graph, id: NodeId, all: &BTreeMap<NodeId, Parts>) -> Option<Parts> {
    let [a, b, _] = graph.node(id).args;
    let get = |id: NodeId| all.get(&id).cloned();
    let whole = graph.args(id).iter().all(|a| all.get(a).is_some_and(|parts| parts.powers.is_empty()));
    if whole && !has_pole(graph, id) {
        return Some(Parts { numerator: id, powers: BTreeMap::new() });
    }
    match graph.op(id) {
        Op::Neg => {
            let a = get(a)?;
            Some(Parts { numerator: graph.apply(Op::Neg, &[a.numerator]), powers: a.powers })
        }
        op @ (Op::Add | Op::Sub) => {
            let (a, b) = (get(a)?, get(b)?);
            let mut powers = a.powers.clone();
            for (&d, &n) in &b.powers {
                let m = powers.entry(d).or_default();
                *m = n.max(*m);
            }
            let (left, right) = (raised(graph, &a, &powers), raised(graph, &b, &powers));
            Some(Parts { numerator: graph.apply(op, &[left, right]), powers })
        }
        Op::Mul => Some(product(graph, get(a)?, get(b)?)),
        Op::Div => {
            let (a, b) = (get(a)?, get(b)?);
            Some(quotient(graph, a, b))
        }
        Op::Power(n) => {
            let a = get(a)?;
            Some(power(graph, a, n))
        }
        _ => {
            let (sine, cosine) = (graph.apply(Op::Sin, &[a]), graph.apply(Op::Cos, &[a]));
            Some(Parts { numerator: sine, powers: BTreeMap::from([(cosine, 1)]) })
        }
    }
}

/// The numerator over the larger denominator.
fn raised(graph: &mut Graph, parts: &Parts, powers: &BTreeMap<NodeId, i64>) -> NodeId {
    let mut numerator = parts.numerator;
    for (&d, &n) in powers {
        let missing = n - parts.powers.get(&d).copied().unwrap_or(0);
        if missing > 0 {
            let factor = graph.apply(Op::Power(missing), &[d]);
            numerator = graph.apply(Op::Mul, &[numerator, factor]);
        }
    }
    numerator
}

fn product(graph: &mut Graph, a: Parts, b: Parts) -> Parts {
    let mut powers = a.powers;
    for (d, n) in b.powers {
        *powers.entry(d).or_default() += n;
    }
    Parts { numerator: graph.apply(Op::Mul, &[a.numerator, b.numerator]), powers }
}

/// a/b, where b's own denominators must stay ≠ 0 too: they remain below, with their power above.
fn quotient(graph: &mut Graph, a: Parts, b: Parts) -> Parts {
    let mut powers = a.powers;
    let mut numerator = a.numerator;
    for (&d, &n) in &b.powers {
        let raised = graph.apply(Op::Power(n + 1), &[d]);
        numerator = graph.apply(Op::Mul, &[numerator, raised]);
        *powers.entry(d).or_default() += 1;
    }
    let (base, n) = match graph.op(b.numerator) {
        Op::Power(n) if n > 0 => (graph.args(b.numerator)[0], n),
        _ => (b.numerator, 1),
    };
    if graph.constant(base).is_some_and(|c| !c.is_zero()) {
        return Parts { numerator: graph.apply(Op::Div, &[numerator, b.numerator]), powers };
    }
    *powers.entry(base).or_default() += n;
    Parts { numerator, powers }
}

fn power(graph: &mut Graph, a: Parts, n: i64) -> Parts {
    let powers = a.powers.into_iter().map(|(d, m)| (d, m * n.abs())).collect();
    let raised = Parts { numerator: graph.apply(Op::Power(n.abs()), &[a.numerator]), powers };
    if n > 0 {
        return raised;
    }
    let one = Parts { numerator: graph.integer(1), powers: BTreeMap::new() };
    quotient(graph, one, raised)
}
