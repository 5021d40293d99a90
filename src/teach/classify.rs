//! What a surface is, as far as its formula proves it.
//!
//! In: a graph and the node f of f = 0. Out: [`Facts`]. Every fact is a proof from the formula: polynomials are compared
//! exactly, other formulas by being the same node. Where nothing is proven nothing is said.

use super::quadric::{Quadric, quadric};
use super::substitute::{coordinates, substitute};
use crate::expr::derivative::gradient;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use crate::expr::polynomial::Polynomial;
use crate::expr::polynomial::expand::{self, Letters};

/// The coordinates in order.
pub const COORDINATES: [Variable; 3] = [Variable::X, Variable::Y, Variable::Z];

/// What is proven of f = 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts {
    /// The degree of f, if it is a polynomial.
    pub degree: Option<u32>,
    /// Which quadric it is, if the degree is 2.
    pub quadric: Option<Quadric>,
    /// Coordinates that do not occur.
    pub absent: Vec<Variable>,
    /// For each coordinate v: u, where f = c·(v − u) and v does not occur in u.
    pub graphs: Vec<(Variable, NodeId)>,
    /// The axes about which it can be turned.
    pub axes: Vec<Variable>,
    /// Its symmetries, by their keys in the texts.
    pub symmetries: Vec<&'static str>,
    /// Whether it is proven to be bounded, or to be not.
    pub is_bounded: Option<bool>,
}

/// The facts about f = 0.
pub fn facts(graph: &mut Graph, f: NodeId) -> Facts {
    let mut facts = Facts { axes: axes(graph, f), symmetries: symmetries(graph, f), ..Facts::default() };
    let slopes = gradient(graph, f);
    let nodes = graph.reachable(&[f]);
    for (v, slope) in COORDINATES.into_iter().zip(slopes) {
        if !nodes.iter().any(|&id| graph.op(id) == Op::Variable(v)) {
            facts.absent.push(v);
        } else if let Some(u) = height(graph, f, v, slope) {
            facts.graphs.push((v, u));
        }
    }
    if let Some((p, places)) = polynomial(graph, f) {
        let degree = p.terms().map(|(e, _)| e.iter().map(|&e| u32::from(e)).sum::<u32>()).max().unwrap_or(0);
        facts.degree = Some(degree);
        if degree == 2 {
            facts.quadric = quadric(&p, &places);
        }
        facts.is_bounded = match &facts.quadric {
            Some(quadric) => quadric.is_bounded,
            // On nearly every line a polynomial of odd degree changes its sign, so it has roots on lines that are as far away
            // as one likes.
            None if degree % 2 == 1 => Some(false),
            None => super::bounds::is_bounded(&p, &places, degree).then_some(true),
        };
    }
    let has_points = facts.graphs.iter().any(|&(_, u)| graph.is_total(u));
    if has_points {
        facts.is_bounded = Some(false);
    }
    facts
}

/// The polynomial of a node in x, y, z, and which coordinate each letter is.
pub fn polynomial(graph: &Graph, f: NodeId) -> Option<(Polynomial, Vec<usize>)> {
    let mut letters = Letters::default();
    let (p, _) = expand::expanded(graph, f, &mut letters)?;
    let place = |id: &NodeId| match graph.op(*id) {
        Op::Variable(v) => COORDINATES.iter().position(|&c| c == v),
        _ => None,
    };
    let places = letters.nodes.iter().map(place).collect::<Option<Vec<usize>>>()?;
    Some((p, places))
}

/// u, where f = c·(v − u).
fn height(graph: &mut Graph, f: NodeId, v: Variable, slope: NodeId) -> Option<NodeId> {
    graph.constant(slope).filter(|c| !c.is_zero())?;
    let zero = graph.integer(0);
    let mut by = coordinates(graph);
    by[COORDINATES.iter().position(|&c| c == v)?] = zero;
    let rest = substitute(graph, f, by);
    let u = graph.apply(Op::Div, &[rest, slope]);
    Some(graph.apply(Op::Neg, &[u]))
}

/// Whether two formulas are the same function: one node, or one polynomial in the same letters.
fn are_same(graph: &mut Graph, a: NodeId, b: NodeId) -> bool {
    if a == b {
        return true;
    }
    let mut letters = Letters::default();
    if expand::expanded(graph, a, &mut letters).is_none() {
        return false;
    }
    let count = letters.nodes.len();
    let difference = graph.apply(Op::Sub, &[a, b]);
    let is_zero = expand::expanded(graph, difference, &mut letters).is_some_and(|(p, _)| p.is_empty());
    // The same letters have the same values at the same points, and fail at the same points.
    is_zero && letters.nodes.len() == count
}

/// Whether f = 0 goes over into itself where x, y, z are replaced.
fn is_symmetric(graph: &mut Graph, f: NodeId, by: [NodeId; 3]) -> bool {
    let image = substitute(graph, f, by);
    if are_same(graph, f, image) {
        return true;
    }
    let opposite = graph.apply(Op::Neg, &[image]);
    are_same(graph, f, opposite)
}

fn symmetries(graph: &mut Graph, f: NodeId) -> Vec<&'static str> {
    let [x, y, z] = coordinates(graph);
    let [nx, ny, nz] = [x, y, z].map(|v| graph.apply(Op::Neg, &[v]));
    let mirrors = [
        ("symmetry.x", [nx, y, z]),
        ("symmetry.y", [x, ny, z]),
        ("symmetry.z", [x, y, nz]),
        ("symmetry.point", [nx, ny, nz]),
        ("symmetry.xy", [y, x, z]),
        ("symmetry.yz", [x, z, y]),
        ("symmetry.xz", [z, y, x]),
        ("symmetry.cycle", [y, z, x]),
    ];
    mirrors.into_iter().filter(|&(_, by)| is_symmetric(graph, f, by)).map(|(key, _)| key).collect()
}

/// The axes through the origin about which f can be turned: f(x, y, z) is f(r, 0, z), r being the distance from the axis.
fn axes(graph: &mut Graph, f: NodeId) -> Vec<Variable> {
    let all = coordinates(graph);
    let zero = graph.integer(0);
    let mut found = Vec::new();
    for axis in 0..3 {
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let squares = [i, j].map(|k| graph.apply(Op::Power(2), &[all[k]]));
        let square = graph.apply(Op::Add, &squares);
        let distance = graph.apply(Op::Sqrt, &[square]);
        let mut by = all;
        (by[i], by[j]) = (distance, zero);
        let image = substitute(graph, f, by);
        if are_same(graph, f, image) {
            found.push(COORDINATES[axis]);
        }
    }
    found
}

#[cfg(test)]
mod tests;
