//! The cheap test that spares most formulas exact algebra: one letter at a time, numbers modulo a prime for the others.
//!
//! In: nodes. Out: whether a repeated factor, or a common one, is possible. A wrong "no" has a chance of about
//! degree/2^61 and costs nothing but a rewriting that is not made; a "yes" is checked by exact algebra afterwards.

use super::MAX_LETTERS;
use super::expand::parts;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;
use std::collections::BTreeMap;

/// 2^61 − 1, prime.
const P: u64 = (1 << 61) - 1;

/// The highest degree that is looked at.
const MAX_DEGREE: usize = 400;

/// The most operations of one test: about 0.05 s.
const MAX_WORK: usize = 20_000_000;

fn times(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(P)) as u64
}

fn plus(a: u64, b: u64) -> u64 {
    (a + b) % P
}

fn minus(a: u64, b: u64) -> u64 {
    (a + P - b) % P
}

fn power(mut a: u64, mut n: u64) -> u64 {
    let mut result = 1;
    while n > 0 {
        if n & 1 == 1 {
            result = times(result, a);
        }
        a = times(a, a);
        n >>= 1;
    }
    result
}

fn inverse(a: u64) -> u64 {
    power(a, P - 2)
}

fn residue(n: &BigInt) -> u64 {
    n.mod_floor(&BigInt::from(P)).to_u64().unwrap_or(0)
}

/// A polynomial in one letter, lowest coefficient first, the last one not 0.
type Univariate = Vec<u64>;

fn trimmed(mut p: Univariate) -> Univariate {
    while p.last() == Some(&0) {
        p.pop();
    }
    p
}

fn product(p: &[u64], q: &[u64], work: &mut usize) -> Option<Univariate> {
    if p.is_empty() || q.is_empty() {
        return Some(Vec::new());
    }
    *work = work.checked_sub(p.len() * q.len())?;
    let mut r = vec![0; p.len() + q.len() - 1];
    if r.len() > MAX_DEGREE {
        return None;
    }
    for (i, &a) in p.iter().enumerate() {
        for (j, &b) in q.iter().enumerate() {
            r[i + j] = plus(r[i + j], times(a, b));
        }
    }
    Some(trimmed(r))
}

/// The degree of the greatest common divisor, by Euclid.
fn gcd_degree(mut p: Univariate, mut q: Univariate) -> usize {
    while !q.is_empty() {
        let scale = inverse(q[q.len() - 1]);
        while p.len() >= q.len() {
            let (shift, factor) = (p.len() - q.len(), times(p[p.len() - 1], scale));
            for (i, &c) in q.iter().enumerate() {
                p[shift + i] = minus(p[shift + i], times(factor, c));
            }
            p = trimmed(p);
        }
        std::mem::swap(&mut p, &mut q);
    }
    p.len().saturating_sub(1)
}

/// The node as a polynomial in the letter, with a fixed arbitrary number for each other letter.
fn image(graph: &Graph, root: NodeId, letter: NodeId, work: &mut usize) -> Option<Univariate> {
    let mut all: BTreeMap<NodeId, Univariate> = BTreeMap::new();
    for (id, interior) in parts(graph, root) {
        let get = |i: usize| all.get(&graph.args(id)[i]).map_or(&[][..], |p| p);
        let value = match graph.op(id) {
            Op::Constant(index) => {
                let value = graph.constants(index);
                let denominator = residue(value.denominator());
                if denominator == 0 {
                    return None;
                }
                trimmed(vec![times(residue(value.numerator()), inverse(denominator))])
            }
            _ if id == letter => vec![0, 1],
            _ if !interior => vec![power(3, 1_000_003 + 7919 * u64::from(id.0))],
            Op::Neg => get(0).iter().map(|&c| minus(0, c)).collect(),
            op @ (Op::Add | Op::Sub) => {
                let (p, q) = (get(0), get(1));
                let at = |p: &[u64], i: usize| p.get(i).copied().unwrap_or(0);
                let combine = if op == Op::Add { plus } else { minus };
                trimmed((0..p.len().max(q.len())).map(|i| combine(at(p, i), at(q, i))).collect())
            }
            Op::Mul => product(get(0), get(1), work)?,
            Op::Power(n) => powered(get(0), n, work)?,
            _ => {
                let divisor = get(1).first().copied().filter(|&c| c != 0)?;
                get(0).iter().map(|&c| times(c, inverse(divisor))).collect()
            }
        };
        all.insert(id, value);
    }
    all.remove(&root)
}

fn powered(p: &[u64], n: i64, work: &mut usize) -> Option<Univariate> {
    let n = u64::try_from(n).ok()?;
    if let [c] = p {
        return Some(vec![power(*c, n)]);
    }
    if n > MAX_DEGREE as u64 {
        return None;
    }
    let mut result = vec![1];
    for bit in (0..64 - n.leading_zeros()).rev() {
        result = product(&result, &result, work)?;
        if n >> bit & 1 == 1 {
            result = product(&result, p, work)?;
        }
    }
    Some(result)
}

/// The letters; none where there are more than exact algebra would take.
fn letters_of(graph: &Graph, root: NodeId) -> Vec<NodeId> {
    let letters: Vec<NodeId> =
        parts(graph, root).into_iter().filter(|(_, interior)| !interior).map(|(id, _)| id).collect();
    if letters.len() > MAX_LETTERS { Vec::new() } else { letters }
}

/// Whether the polynomial can have a repeated factor. No, where it is too large to say.
pub fn may_have_repeated_factor(graph: &Graph, root: NodeId) -> bool {
    let mut work = MAX_WORK;
    letters_of(graph, root).into_iter().any(|letter| {
        let Some(p) = image(graph, root, letter, &mut work) else { return false };
        let slope: Univariate = p.iter().enumerate().skip(1).map(|(i, &c)| times(c, i as u64)).collect();
        !p.is_empty() && gcd_degree(p, trimmed(slope)) > 0
    })
}

/// Whether the polynomials can have a common factor. No, where they are too large to say.
pub fn may_have_common_factor(graph: &Graph, a: NodeId, b: NodeId) -> bool {
    let (mut work, second) = (MAX_WORK, letters_of(graph, b));
    letters_of(graph, a).into_iter().filter(|letter| second.contains(letter)).any(|letter| {
        let images = (image(graph, a, letter, &mut work), image(graph, b, letter, &mut work));
        let (Some(p), Some(q)) = images else { return false };
        gcd_degree(p, q) > 0
    })
}
