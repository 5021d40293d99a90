//! Sums of powers by Horner's rule, for enclosures.
//!
//! In: a node. Out: an equal one in which 128x⁸ − 256x⁶ + 160x⁴ − 32x² is (((128u − 256)u + 160)u − 32)u with u = x².
//! Enclosures of the powers do not know that they cancel; those of the nested form lose much less (Ratschek and Rokne,
//! Computer Methods for the Range of Functions, 1984, section 2). Separate from the simplifier because it is no
//! simpler to read.

use super::graph::{Graph, NodeId};
use super::op::Op;
use crate::num::rational::Rational;
use std::collections::BTreeMap;

/// Sums of more terms than this are left: they are no polynomial that a person typed.
const MOST_TERMS: usize = 400;

/// Powers from here on are worth it.
const LEAST_DEGREE: i64 = 3;

/// The nodes with their sums of powers nested.
pub fn nested(graph: &mut Graph, roots: &[NodeId]) -> Vec<NodeId> {
    let mut new: BTreeMap<NodeId, NodeId> = BTreeMap::new();
    for id in graph.reachable(roots) {
        let args: Vec<NodeId> = graph.args(id).iter().map(|a| new.get(a).copied().unwrap_or(*a)).collect();
        let op = graph.op(id);
        let sum = matches!(op, Op::Add | Op::Sub).then(|| by_horner(graph, id)).flatten();
        let node = match sum {
            Some(node) => node,
            None if args.is_empty() || args == graph.args(id) => id,
            None => graph.apply(op, &args),
        };
        new.insert(id, node);
    }
    roots.iter().map(|root| new.get(root).copied().unwrap_or(*root)).collect()
}

/// A coefficient, and a node with its exponent.
struct Term {
    coefficient: Rational,
    base: NodeId,
    exponent: i64,
}

/// A sum as nested polynomials and the rest; `None` if there is none in it.
fn by_horner(graph: &mut Graph, sum: NodeId) -> Option<NodeId> {
    let mut polynomials: BTreeMap<NodeId, BTreeMap<i64, Rational>> = BTreeMap::new();
    let mut rest = Vec::new();
    for (node, is_negative) in terms(graph, sum, MOST_TERMS)? {
        match term(graph, node) {
            Some(Term { coefficient, base, exponent }) => {
                let signed = if is_negative { coefficient.negated() } else { coefficient };
                let slot = polynomials.entry(base).or_default().entry(exponent).or_insert(Rational::from_integer(0));
                *slot = slot.plus(&signed)?;
            }
            None => rest.push((node, is_negative)),
        }
    }
    let is_worth = |p: &BTreeMap<i64, Rational>| p.len() > 1 && p.keys().any(|&e| e >= LEAST_DEGREE);
    if !polynomials.values().any(is_worth) {
        return None;
    }
    let mut total = graph.integer(0);
    for (base, polynomial) in polynomials {
        let part = horner(graph, base, &polynomial);
        total = graph.apply(Op::Add, &[total, part]);
    }
    for (node, is_negative) in rest {
        total = graph.apply(if is_negative { Op::Sub } else { Op::Add }, &[total, node]);
    }
    Some(total)
}

/// The terms of a sum, each with whether it is taken away; `None` if they are more than `most`, for shared sums can have very many.
pub(crate) fn terms(graph: &Graph, sum: NodeId, most: usize) -> Option<Vec<(NodeId, bool)>> {
    let (mut found, mut stack) = (Vec::new(), vec![(sum, false)]);
    while let Some((id, is_negative)) = stack.pop() {
        let args = graph.args(id);
        match graph.op(id) {
            Op::Add => stack.extend([(args[1], is_negative), (args[0], is_negative)]),
            Op::Sub => stack.extend([(args[1], !is_negative), (args[0], is_negative)]),
            _ => found.push((id, is_negative)),
        }
        if found.len() + stack.len() > most {
            return None;
        }
    }
    Some(found)
}

/// c·v^n, c·v, v^n or v, as that; none for numbers and products of more.
fn term(graph: &Graph, node: NodeId) -> Option<Term> {
    let (coefficient, power) = match graph.op(node) {
        Op::Mul if graph.constant(graph.args(node)[0]).is_some() => {
            (graph.constant(graph.args(node)[0])?.clone(), graph.args(node)[1])
        }
        _ => (Rational::from_integer(1), node),
    };
    let (base, exponent) = match graph.op(power) {
        Op::Power(n) if n > 0 => (graph.args(power)[0], n),
        Op::Variable(_) => (power, 1),
        _ => return None,
    };
    Some(Term { coefficient, base, exponent })
}

fn horner(graph: &mut Graph, base: NodeId, polynomial: &BTreeMap<i64, Rational>) -> NodeId {
    // In even powers alone, the square takes the place of the letter.
    let is_even = polynomial.keys().all(|e| e % 2 == 0);
    let unit = if is_even { 2 } else { 1 };
    let u = if is_even { graph.apply(Op::Power(2), &[base]) } else { base };
    let mut value = graph.integer(0);
    let mut above = None;
    for (&exponent, coefficient) in polynomial.iter().rev() {
        if let Some(before) = above {
            value = times_power(graph, value, u, (before - exponent) / unit);
        }
        let number = graph.number(coefficient.clone());
        value = graph.apply(Op::Add, &[value, number]);
        above = Some(exponent);
    }
    times_power(graph, value, u, above.unwrap_or(0) / unit)
}

fn times_power(graph: &mut Graph, value: NodeId, u: NodeId, n: i64) -> NodeId {
    let power = match n {
        0 => return value,
        1 => u,
        n => graph.apply(Op::Power(n), &[u]),
    };
    graph.apply(Op::Mul, &[value, power])
}

#[cfg(test)]
mod tests {
    use crate::expr::formula::formula;
    use crate::expr::graph::Graph;
    use crate::expr::print::text;

    #[test]
    fn powers_are_nested_and_the_rest_is_left() {
        let rows = [
            ("128*x^8-256*x^6+160*x^4-32*x^2", "((((128*x^2-256)*x^2+160)*x^2)-32)*x^2"),
            ("x^4-5*x^2+y^4-5*y^2+11.8", "(x^2-5)*x^2+(y^2-5)*y^2+11.8"),
            ("x^3+x+y*z", "(x^2+1)*x+y*z"),
            ("2*sin(x)^3-sin(x)^2+z", "(2*sin(x)-1)*sin(x)^2+z"),
            ("x^2+y^2+z^2-1", "x^2+y^2+z^2-1"),
            ("z-sin(x)*cos(y)", "z-sin(x)*cos(y)"),
        ];
        for (from, to) in rows {
            let mut graph = Graph::new();
            let (f, expected) = (formula(&mut graph, from), formula(&mut graph, to));
            let nested = super::nested(&mut graph, &[f])[0];
            assert_eq!(text(&graph, nested, 2000), text(&graph, expected, 2000), "{from}");
        }
    }
}
