//! What a level set's derivatives say of its form: its normal, its curvatures, and how fast something else changes along it.
//!
//! In: the node of f. Out: nodes that have a value at every point where f has two derivatives and its gradient is not 0; on f = c they
//! are those of that surface. Exact, as derivatives are.

use super::derivative::{derivative, gradient};
use super::graph::{Graph, NodeId};
use super::op::Op;

/// The unit normal, towards greater f.
pub fn normal(graph: &mut Graph, f: NodeId) -> [NodeId; 3] {
    let gradient = gradient(graph, f);
    let square = dot(graph, gradient, gradient);
    let length = graph.apply(Op::Sqrt, &[square]);
    gradient.map(|part| graph.apply(Op::Div, &[part, length]))
}

/// The mean of the two principal curvatures: of a sphere of radius R with f < 0 inside it is 1/R.
///
/// Goldman 2005, "Curvature formulas for implicit curves and surfaces", equation 4.2, with the other sign:
/// (|∇f|²·trace H − ∇f·H·∇f) / (2|∇f|³).
pub fn mean(graph: &mut Graph, f: NodeId) -> NodeId {
    let g = gradient(graph, f);
    let h = hessian(graph, g);
    let square = dot(graph, g, g);
    let diagonal = graph.apply(Op::Add, &[h[0][0], h[1][1]]);
    let trace = graph.apply(Op::Add, &[diagonal, h[2][2]]);
    let all = graph.apply(Op::Mul, &[square, trace]);
    let turned = h.map(|row| dot(graph, row, g));
    let along = dot(graph, g, turned);
    let over = graph.apply(Op::Sub, &[all, along]);
    let length = graph.apply(Op::Sqrt, &[square]);
    let cube = graph.apply(Op::Mul, &[square, length]);
    let two = graph.integer(2);
    let under = graph.apply(Op::Mul, &[two, cube]);
    graph.apply(Op::Div, &[over, under])
}

/// The product of the two principal curvatures: > 0 where the surface is like an egg, < 0 where it is like a saddle; of a sphere of
/// radius R it is 1/R².
///
/// Goldman 2005, equation 4.1: ∇f·adj(H)·∇f / |∇f|⁴.
pub fn gauss(graph: &mut Graph, f: NodeId) -> NodeId {
    let g = gradient(graph, f);
    let h = hessian(graph, g);
    // Row i of the adjugate of a symmetric matrix is the vector product of its two other rows.
    let adjugate = [cross(graph, h[1], h[2]), cross(graph, h[2], h[0]), cross(graph, h[0], h[1])];
    let turned = adjugate.map(|row| dot(graph, row, g));
    let over = dot(graph, g, turned);
    let square = dot(graph, g, g);
    let under = graph.apply(Op::Power(2), &[square]);
    graph.apply(Op::Div, &[over, under])
}

/// How fast `value` changes along the surface where it changes fastest: the length of the part of its gradient that lies in the
/// surface f = c.
pub fn slope_along(graph: &mut Graph, value: NodeId, f: NodeId) -> NodeId {
    let (slope, normal) = (gradient(graph, value), normal(graph, f));
    let across = dot(graph, slope, normal);
    let (all, across) = (dot(graph, slope, slope), graph.apply(Op::Power(2), &[across]));
    let square = graph.apply(Op::Sub, &[all, across]);
    let zero = graph.integer(0);
    let square = graph.apply(Op::Max, &[square, zero]);
    graph.apply(Op::Sqrt, &[square])
}

/// The second derivatives, by rows; x before y before z, so that equal ones are one node.
fn hessian(graph: &mut Graph, [x, y, z]: [NodeId; 3]) -> [[NodeId; 3]; 3] {
    let (zero, one) = (graph.integer(0), graph.integer(1));
    let [xx, yx, zx] = derivative(graph, &[x, y, z], [one, zero, zero])[..] else { unreachable!("three of three") };
    let [yy, zy] = derivative(graph, &[y, z], [zero, one, zero])[..] else { unreachable!("two of two") };
    let zz = derivative(graph, &[z], [zero, zero, one])[0];
    [[xx, yx, zx], [yx, yy, zy], [zx, zy, zz]]
}

fn dot(graph: &mut Graph, a: [NodeId; 3], b: [NodeId; 3]) -> NodeId {
    let products: [NodeId; 3] = std::array::from_fn(|i| match a[i] == b[i] {
        true => graph.apply(Op::Power(2), &[a[i]]),
        false => graph.apply(Op::Mul, &[a[i], b[i]]),
    });
    let sum = graph.apply(Op::Add, &[products[0], products[1]]);
    graph.apply(Op::Add, &[sum, products[2]])
}

fn cross(graph: &mut Graph, a: [NodeId; 3], b: [NodeId; 3]) -> [NodeId; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let (plus, minus) = (graph.apply(Op::Mul, &[a[i], b[j]]), graph.apply(Op::Mul, &[a[j], b[i]]));
        graph.apply(Op::Sub, &[plus, minus])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::estimate::{Estimate, estimates};
    use crate::expr::formula::formula;

    fn at(graph: &Graph, nodes: &[NodeId], point: [f64; 3]) -> Vec<f64> {
        let value = |estimate: &Estimate| match estimate {
            Estimate::Value(value, _) => *value,
            _ => f64::NAN,
        };
        estimates(graph, nodes, point, [0.0; 3]).iter().map(value).collect()
    }

    #[test]
    fn curvatures_are_those_of_differential_geometry() {
        let (s, r) = (3f64.sqrt(), 0.5);
        // Formula, point, mean, Gauss. Torus of radii 2 and 1/2: at distance d of the axis K = (d-2)/(r²d), and the outermost circle
        // has the principal curvatures 1/r and 1/(2+r). z = xy at the origin is a saddle of K = -1. Cylinder 1/(2R), 0.
        let rows: [(&str, [f64; 3], f64, f64); 9] = [
            ("x^2+y^2+z^2-4", [2.0, 0.0, 0.0], 0.5, 0.25),
            ("3*(x^2+y^2+z^2-1)", [1.0 / s, -1.0 / s, 1.0 / s], 1.0, 1.0),
            ("1-x^2-y^2-z^2", [0.0, 0.6, 0.8], -1.0, 1.0),
            ("x^2+y^2-9", [0.0, 3.0, 7.0], 1.0 / 6.0, 0.0),
            ("x+2*y-z", [1.0, 1.0, 3.0], 0.0, 0.0),
            ("z-x*y", [0.0, 0.0, 0.0], 0.0, -1.0),
            ("(x^2+y^2+z^2+3.75)^2-16*(x^2+y^2)", [2.5, 0.0, 0.0], (1.0 / r + 1.0 / 2.5) / 2.0, 1.0 / (r * 2.5)),
            ("(x^2+y^2+z^2+3.75)^2-16*(x^2+y^2)", [1.5, 0.0, 0.0], (1.0 / r - 1.0 / 1.5) / 2.0, -1.0 / (r * 1.5)),
            ("(x^2+y^2+z^2+3.75)^2-16*(x^2+y^2)", [0.0, 2.0, 0.5], 1.0, 0.0),
        ];
        for (text, point, mean_expected, gauss_expected) in rows {
            let mut graph = Graph::new();
            let f = formula(&mut graph, text);
            let nodes = [mean(&mut graph, f), gauss(&mut graph, f)];
            let found = at(&graph, &nodes, point);
            let is_near = |a: f64, b: f64| (a - b).abs() < 1e-12;
            assert!(is_near(found[0], mean_expected) && is_near(found[1], gauss_expected), "{text}: {found:?}");
        }
    }

    #[test]
    fn slopes_are_those_along_the_surface() {
        // On the unit sphere z falls along the meridian by the sine of the angle to the axis.
        let mut graph = Graph::new();
        let (f, z) = (formula(&mut graph, "x^2+y^2+z^2-1"), formula(&mut graph, "z"));
        let slope = slope_along(&mut graph, z, f);
        for (point, expected) in [([0.6, 0.0, 0.8], 0.6), ([0.0, 1.0, 0.0], 1.0), ([0.0, 0.0, 1.0], 0.0)] {
            let found = at(&graph, &[slope], point)[0];
            assert!((found - expected).abs() < 1e-7, "{point:?}: {found}");
        }
    }
}
