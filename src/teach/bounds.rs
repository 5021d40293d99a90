//! Whether a polynomial's surface is bounded, by what its highest terms say.
//!
//! In: a polynomial. Out: a proof, or nothing. Far from the origin the terms of the highest degree outweigh all others: where they are
//! 0 in no direction, the surface ends. That they are not is proven by enclosures over the faces of a cube.

use crate::closure::Formula;
use crate::expr::graph::Graph;
use crate::expr::polynomial::Polynomial;
use crate::expr::polynomial::expand::{Letters, node_of};
use crate::num::interval::Interval;
use crate::num::level::Simd;

/// How often a face of the cube is halved, each way.
const DEPTH: u32 = 6;

/// Whether the terms of this degree have no common root but the origin.
pub fn is_bounded(p: &Polynomial, places: &[usize], degree: u32) -> bool {
    let mut top = Polynomial::default();
    for (exponents, coefficient) in p.terms() {
        if exponents.iter().map(|&e| u32::from(e)).sum::<u32>() == degree {
            top.add_term(*exponents, coefficient.clone());
        }
    }
    if places.len() < 3 || top.is_empty() {
        return false;
    }
    let mut graph = Graph::new();
    let all = super::substitute::coordinates(&mut graph);
    let letters = Letters { nodes: places.iter().map(|&place| all[place]).collect() };
    let Some(node) = node_of(&mut graph, &top, &letters) else { return false };
    let formula = Formula::new(&mut graph, node, Simd::best());
    let whole = Interval::new(-1.0, 1.0);
    // An even form is the same in opposite directions: three faces suffice.
    (0..3).all(|axis| {
        let mut face = [whole; 3];
        face[axis] = Interval::point(1.0);
        is_nonzero(&formula, face, DEPTH)
    })
}

fn is_nonzero(formula: &Formula, face: [Interval; 3], depth: u32) -> bool {
    let range = formula.enclosure(face).range;
    if range.lo > 0.0 || range.hi < 0.0 {
        return true;
    }
    if depth == 0 {
        return false;
    }
    let halves = |side: Interval| {
        let middle = 0.5 * (side.lo + side.hi);
        if side.lo == side.hi {
            vec![side]
        } else {
            vec![Interval::new(side.lo, middle), Interval::new(middle, side.hi)]
        }
    };
    let [xs, ys, zs] = face.map(halves);
    let children =
        xs.iter().flat_map(|&x| ys.iter().map(move |&y| (x, y))).flat_map(|(x, y)| zs.iter().map(move |&z| [x, y, z]));
    children.into_iter().all(|child| is_nonzero(formula, child, depth - 1))
}
