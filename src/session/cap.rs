//! Solids that are closed where they are cut.
//!
//! In: a formula and its clip. Out: the formula of the solid that is in both, which the clip cuts no more. So the cut is a surface
//! like any other, as exact and as proven.

use crate::expr::curvature::slope_along;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::lower::{Inside, Kind, SurfaceFormula};
use crate::expr::op::{Op, Variable};
use crate::num::rational::Rational;
use crate::surface::{Clip, Shape};
use glam::DVec3;

/// The shapes that cut are left that much larger, so that they bound what is looked at and cut nothing.
const ROOM: f64 = 1.0 / 16.0;

/// Closes a solid at its clip. An equation f = 0 is taken for the solid f <= 0, or f >= 0 if that is its inside.
pub(super) fn close(graph: &mut Graph, formula: &mut SurfaceFormula, clip: &mut Clip) {
    let is_positive = formula.kind == Kind::Equation && formula.matter.inside == Some(Inside::Positive);
    let mut f = if is_positive { graph.apply(Op::Neg, &[formula.f]) } else { formula.f };
    for shape in &clip.shapes {
        for side in sides(graph, shape) {
            f = graph.apply(Op::Max, &[f, side]);
        }
    }
    for &field in &clip.fields {
        f = graph.apply(Op::Max, &[f, field]);
    }
    (formula.f, formula.kind) = (f, Kind::Solid);
    if is_positive {
        formula.matter.inside = Some(Inside::Negative);
    }
    if let Some(lines) = &mut formula.matter.lines {
        lines.slope = slope_along(graph, lines.value, f);
    }
    clip.fields.clear();
    clip.shapes.iter_mut().for_each(|shape| *shape = enlarged(shape));
}

/// Functions that are all <= 0 in a shape.
fn sides(graph: &mut Graph, shape: &Shape) -> Vec<NodeId> {
    let coordinates = [Variable::X, Variable::Y, Variable::Z].map(|variable| graph.variable(variable));
    match *shape {
        Shape::Box { min, max } => {
            let mut sides = Vec::with_capacity(6);
            for (axis, coordinate) in coordinates.into_iter().enumerate() {
                let (low, high) = (number(graph, min[axis]), number(graph, max[axis]));
                sides.push(graph.apply(Op::Sub, &[low, coordinate]));
                sides.push(graph.apply(Op::Sub, &[coordinate, high]));
            }
            sides
        }
        Shape::Ball { center, radius } => {
            let squares = [0, 1, 2].map(|axis| {
                let middle = number(graph, center[axis]);
                let away = graph.apply(Op::Sub, &[coordinates[axis], middle]);
                graph.apply(Op::Power(2), &[away])
            });
            let flat = graph.apply(Op::Add, &[squares[0], squares[1]]);
            let square = graph.apply(Op::Add, &[flat, squares[2]]);
            let radius = number(graph, radius);
            let reach = graph.apply(Op::Power(2), &[radius]);
            vec![graph.apply(Op::Sub, &[square, reach])]
        }
    }
}

fn number(graph: &mut Graph, value: f64) -> NodeId {
    graph.number(Rational::from_f64(value).unwrap_or_else(|| Rational::from_integer(0)))
}

fn enlarged(shape: &Shape) -> Shape {
    let room = shape.size() * ROOM;
    match *shape {
        Shape::Box { min, max } => Shape::Box { min: min - DVec3::splat(room), max: max + DVec3::splat(room) },
        Shape::Ball { center, radius } => Shape::Ball { center, radius: radius + room },
    }
}

#[cfg(test)]
mod tests {
    use crate::session::{Plan, Program, Wishes};
    use crate::surface::{Ray, Tracer};
    use glam::DVec3;

    /// The distance of the first hit from above, and whether the outside was met.
    fn from_above(text: &str, origin: DVec3) -> (f64, bool) {
        let mut program = Program::from_text(text);
        assert!(!program.has_errors(), "{text}: {:?}", program.diagnostics);
        let plan = Plan::new(&mut program, &Wishes::default()).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
        let mut hits = Vec::new();
        Tracer::new(&plan.surfaces, plan.method).trace(&[Ray::new(origin, DVec3::NEG_Z)], &mut hits);
        (hits[0].t, !hits[0].flipped)
    }

    #[test]
    fn a_cap_closes_the_cut_and_nothing_else_changes() {
        let ball = "x^2 + y^2 + z^2 <= 4";
        let rows = [
            (format!("{ball} {{ clip: box(-3..3, -3..3, -3..1) }}"), 5.0 + 4f64.sqrt(), false),
            (format!("{ball} {{ cap: true, clip: box(-3..3, -3..3, -3..1) }}"), 4.0, true),
            (format!("{ball} {{ cap: true, clip: z <= 0.5 }}"), 4.5, true),
            (format!("{ball} {{ cap: false, clip: z <= 0.5 }}"), 7.0, false),
            (format!("{ball} {{ cap: true, clip: ball(0, 0, -1, 1.5) }}"), 4.5, true),
            (format!("{ball} {{ cap: true }}; render {{ clip: z <= 0.5 }}"), 4.5, true),
            ("x^2 + y^2 + z^2 = 4 { cap: true, clip: z <= 0.5 }".to_owned(), 4.5, true),
            ("4 = x^2 + y^2 + z^2 { cap: true, inside: positive, clip: z <= 0.5 }".to_owned(), 4.5, true),
            ("x^2 + y^2 <= 1 { cap: true, clip: box(-2..2, -2..2, -1..1) }".to_owned(), 4.0, true),
        ];
        for (text, distance, is_outside) in rows {
            let (t, outside) = from_above(&text, DVec3::new(0.0, 0.0, 5.0));
            assert!((t - distance).abs() < 1e-8 && outside == is_outside, "{text}: {t} {outside}");
        }
    }
}
