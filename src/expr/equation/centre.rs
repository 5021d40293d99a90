//! A polynomial about the place where it lies, so that its terms do not cancel.
//!
//! In: a polynomial such as x² − 200000x + 9999999999. Out: the same in x − 100000: (x − 100000)² − 1. In doubles the first
//! knows f to 1e-6, the second to 1e-16. Separate because it changes no root, only how well values know it.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use crate::expr::polynomial::expand::{Letters, expanded, node_of};
use crate::expr::polynomial::{Exponents, Polynomial};
use crate::num::rational::Rational;
use num_bigint::BigInt;

/// Centres nearer to the origin than this are left: the terms lose three digits at most for a sphere of radius 1.
const NEAR: f64 = 30.0;

/// The polynomial `g` about its centre, if that is far from the origin; with the letters that must have a value.
pub(super) fn about_centre(graph: &mut Graph, g: NodeId) -> Option<(NodeId, Vec<NodeId>)> {
    if !matches!(graph.op(g), Op::Add | Op::Sub) || coordinates_alone(graph, g).is_empty() {
        return None;
    }
    let mut letters = Letters::default();
    let (p, _) = expanded(graph, g, &mut letters)?;
    let mut from = letters.clone();
    let mut to = letters.clone();
    let mut moved = false;
    for coordinate in coordinates_alone(graph, g) {
        let Some(index) = letters.nodes.iter().position(|&n| n == coordinate) else { continue };
        let Some(center) = center(&p, index).filter(|c| c.to_f64().abs() > NEAR) else { continue };
        let center = graph.number(center);
        from.nodes[index] = graph.intern(Op::Add, &[coordinate, center]);
        to.nodes[index] = graph.apply(Op::Sub, &[coordinate, center]);
        moved = true;
    }
    if !moved {
        return None;
    }
    let shifted = node_of(graph, &p, &from)?;
    let mut same = letters.clone();
    let (q, _) = expanded(graph, shifted, &mut same)?;
    for (node, moved) in letters.nodes.iter().zip(&to.nodes) {
        if let Some(letter) = same.nodes.iter_mut().find(|letter| *letter == node) {
            *letter = *moved;
        }
    }
    Some((node_of(graph, &q, &same)?, letters.nodes))
}

/// The coordinates that stand in g by themselves, not only with a number added to them: those may be far from their centre.
fn coordinates_alone(graph: &Graph, g: NodeId) -> Vec<NodeId> {
    let is_coordinate = |id: NodeId| matches!(graph.op(id), Op::Variable(Variable::X | Variable::Y | Variable::Z));
    let mut alone = Vec::new();
    for id in graph.reachable(&[g]) {
        let args = graph.args(id);
        let shifts = matches!(graph.op(id), Op::Add | Op::Sub) && args.iter().any(|&a| graph.constant(a).is_some());
        if !shifts {
            alone.extend(args.iter().copied().filter(|&a| is_coordinate(a)));
        }
    }
    alone.sort();
    alone.dedup();
    alone
}

/// The mean of the roots in one letter, if it is the same whatever the other letters are: −b/(n·a) of a·v^n + b·v^(n−1) + ….
fn center(p: &Polynomial, letter: usize) -> Option<Rational> {
    let degree = p.degrees()[letter];
    if degree < 2 {
        return None;
    }
    let a = coefficient(p, letter, degree)?;
    let b = coefficient(p, letter, degree - 1)?;
    let a = Rational::from_big_integer(a * BigInt::from(degree))?;
    let exact = Rational::from_big_integer(-b)?.over(&a)?;
    // A number of few digits serves as well, and is exact when it is subtracted.
    Rational::from_f64(exact.to_f64().round())
}

/// The coefficient of letter^exponent, if it is a number.
fn coefficient(p: &Polynomial, letter: usize, exponent: u16) -> Option<BigInt> {
    let mut found = BigInt::ZERO;
    for (exponents, c) in p.terms().filter(|(e, _)| e[letter] == exponent) {
        let mut alone: Exponents = Default::default();
        alone[letter] = exponent;
        if *exponents != alone {
            return None;
        }
        found = c.clone();
    }
    Some(found)
}
