//! Node → polynomial → node.
//!
//! In: a node, and the letters met so far. Out: its polynomial over a common denominator; and back, a sum of
//! products of powers.

use super::{MAX_LETTERS, Polynomial};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use crate::num::rational::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::One;
use std::collections::BTreeMap;

/// The nodes that polynomials are made of, in the order in which they were met.
#[derive(Clone, Debug, Default)]
pub struct Letters {
    /// The node of each letter.
    pub nodes: Vec<NodeId>,
}

impl Letters {
    fn index(&mut self, node: NodeId) -> Option<usize> {
        if let Some(known) = self.nodes.iter().position(|&n| n == node) {
            return Some(known);
        }
        self.nodes.push(node);
        (self.nodes.len() <= MAX_LETTERS).then_some(self.nodes.len() - 1)
    }
}

/// The most products of terms in the expansion of one node, about 0.3 s.
const MAX_WORK: usize = 1_500_000;

/// Whether a node is built from its arguments by ring operations, so that it is no letter.
fn is_interior(graph: &Graph, id: NodeId) -> bool {
    match graph.op(id) {
        Op::Constant(_) | Op::Neg | Op::Add | Op::Sub | Op::Mul => true,
        Op::Power(n) => n > 0,
        Op::Div => graph.constant(graph.args(id)[1]).is_some_and(|c| !c.is_zero()),
        _ => false,
    }
}

/// The nodes that a polynomial is built from, letters included, arguments before users.
pub(super) fn parts(graph: &Graph, root: NodeId) -> Vec<(NodeId, bool)> {
    let mut seen = BTreeMap::new();
    let mut stack = vec![root];
    while let Some(id) = stack.pop() {
        let interior = is_interior(graph, id);
        if seen.insert(id, interior).is_none() && interior {
            stack.extend_from_slice(graph.args(id));
        }
    }
    seen.into_iter().collect()
}

/// The node as polynomial / number > 0; `None` where it has too many letters, terms or digits.
pub fn expanded(graph: &Graph, root: NodeId, letters: &mut Letters) -> Option<(Polynomial, BigInt)> {
    let mut all: BTreeMap<NodeId, (Polynomial, BigInt)> = BTreeMap::new();
    let mut work = MAX_WORK;
    for (id, interior) in parts(graph, root) {
        let value = if interior {
            combined(graph, id, &all, &mut work)?
        } else {
            (Polynomial::letter(letters.index(id)?), BigInt::one())
        };
        all.insert(id, value);
    }
    all.remove(&root)
}

type Known = BTreeMap<NodeId, (Polynomial, BigInt)>;

fn combined(graph: &Graph, id: NodeId, all: &Known, work: &mut usize) -> Option<(Polynomial, BigInt)> {
    let args = graph.args(id);
    let get = |i: usize| all.get(&args[i]);
    match graph.op(id) {
        Op::Constant(index) => {
            let value = graph.constants(index);
            Some((Polynomial::constant(value.numerator().clone()), value.denominator().clone()))
        }
        Op::Neg => get(0).map(|(p, d)| (p.scaled(&BigInt::from(-1)), d.clone())),
        op @ (Op::Add | Op::Sub) => {
            let ((p, d), (q, e)) = (get(0)?, get(1)?);
            *work = work.checked_sub(p.len() + q.len())?;
            let common = d.lcm(e);
            let sign = if op == Op::Sub { -1 } else { 1 };
            let sum = p.scaled(&(&common / d)).plus(&q.scaled(&(&common / e * sign)))?;
            Some((sum, common))
        }
        Op::Mul => {
            let ((p, d), (q, e)) = (get(0)?, get(1)?);
            *work = work.checked_sub(p.cost(q))?;
            Some((p.times(q)?, d * e))
        }
        Op::Power(n) => {
            let (p, d) = get(0)?;
            let n = u32::try_from(n).ok().filter(|&n| n < 1 << 12)?;
            let power = p.to_power(n)?;
            *work = work.checked_sub(power.cost(p))?;
            Some((power, d.pow(n)))
        }
        _ => {
            let (p, d) = get(0)?;
            let divisor = graph.constant(args[1])?.reciprocal()?;
            Some((p.scaled(divisor.numerator()), d * divisor.denominator()))
        }
    }
}

/// The node that is the polynomial: a sum of products of powers, highest total degree first.
pub fn node_of(graph: &mut Graph, p: &Polynomial, letters: &Letters) -> Option<NodeId> {
    let mut terms: Vec<_> = p.terms().collect();
    let degree = |e: &[u16]| e.iter().map(|&e| u32::from(e)).sum::<u32>();
    terms.sort_by(|(a, _), (b, _)| degree(*b).cmp(&degree(*a)).then(b.cmp(a)));
    let mut sum = graph.integer(0);
    for (exponents, coefficient) in terms {
        let mut term = graph.number(Rational::from_big_integer(coefficient.clone())?);
        for (letter, &e) in letters.nodes.iter().zip(exponents) {
            if e > 0 {
                let power = graph.apply(Op::Power(i64::from(e)), &[*letter]);
                term = graph.apply(Op::Mul, &[term, power]);
            }
        }
        sum = graph.apply(Op::Add, &[sum, term]);
    }
    Some(sum)
}

/// The total degree in x, y and z if the node is a polynomial in them by its form: that of the expanded form, unless
/// leading terms cancel, when it may be less.
pub fn total_degree(graph: &Graph, root: NodeId) -> Option<u32> {
    let mut all: BTreeMap<NodeId, u32> = BTreeMap::new();
    for (id, interior) in parts(graph, root) {
        let get = |i: usize| all[&graph.args(id)[i]];
        let degree = match graph.op(id) {
            Op::Variable(Variable::X | Variable::Y | Variable::Z) => 1,
            Op::Constant(_) | Op::Pi | Op::E => 0,
            _ if !interior => return None,
            Op::Add | Op::Sub => get(0).max(get(1)),
            Op::Mul => get(0).checked_add(get(1))?,
            Op::Power(n) => get(0).checked_mul(u32::try_from(n).ok()?)?,
            _ => get(0),
        };
        all.insert(id, degree);
    }
    all.get(&root).copied()
}
