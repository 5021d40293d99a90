//! Colours as they were written, as textures that run.
//!
//! In: trees over nodes. Out: textures: one kernel for all the formulas of a tree. Separate from what surfaces are made of, because
//! what they look like in the modes without light is painted in the same way.

use super::matter::linear;
use crate::closure::{Kernel, Tape};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::lower::{self, Paint};
use crate::num::level::Simd;
use crate::scene::Texture;
use crate::scene::palette::Palette;
use crate::scene::texture::{Lines, Shade, Varying};
use glam::DVec3;
use std::sync::Arc;

/// The width of a contour line where none is given, in radii of the scene: two or three pixels of a usual picture.
const LINE_WIDTH: f64 = 0.008;

/// The map that shows curvature: red at one end, blue at the other, white between them.
const CURVATURE_MAP: &str = "red_blue";

/// Makes textures.
pub(super) struct Painter<'a> {
    pub graph: &'a Graph,
    pub simd: Simd,
    /// The scene's.
    pub radius: f64,
}

impl Painter<'_> {
    /// A colour, or `default` where none was written, under lines if there are any; no part is more than `most`.
    pub(super) fn texture(
        &self,
        paint: Option<&Paint>,
        lines: Option<&lower::Lines>,
        default: DVec3,
        most: f64,
    ) -> Texture {
        let mut nodes = Vec::new();
        let mut shade = paint.map_or(Shade::Plain(default), |paint| shade(paint, &mut nodes));
        if let Some(lines) = lines {
            shade = Shade::Lined(Box::new(shade), self.lines(lines, &mut nodes));
        }
        match shade {
            Shade::Plain(colour) => Texture::Constant(colour),
            shade => self.varying(shade, &nodes, most),
        }
    }

    /// A Gauss curvature as colour.
    pub(super) fn curvature(&self, gauss: NodeId) -> Option<Texture> {
        let palette = Palette::named(CURVATURE_MAP)?;
        Some(self.varying(Shade::Curvature(palette, 0, self.radius * self.radius), &[gauss], 1.0))
    }

    fn varying(&self, shade: Shade, nodes: &[NodeId], most: f64) -> Texture {
        let kernel = Kernel::new(&Tape::for_points(self.graph, nodes), self.simd);
        Texture::Varying(Arc::new(Varying { kernel, shade, most }))
    }

    fn lines(&self, lines: &lower::Lines, nodes: &mut Vec<NodeId>) -> Lines {
        Lines {
            value: number(lines.value, nodes),
            slope: number(lines.slope, nodes),
            step: lines.step,
            width: lines.width.unwrap_or(LINE_WIDTH * self.radius),
        }
    }
}

/// The tree with numbers in place of nodes.
fn shade(paint: &Paint, nodes: &mut Vec<NodeId>) -> Shade {
    match paint {
        Paint::Plain(color) => Shade::Plain(linear(*color)),
        Paint::Rgb(parts) => Shade::Rgb(parts.map(|part| number(part, nodes))),
        Paint::Hsl(parts) => Shade::Hsl(parts.map(|part| number(part, nodes))),
        Paint::Hsv(parts) => Shade::Hsv(parts.map(|part| number(part, nodes))),
        Paint::Palette(name, place) => match Palette::named(name) {
            Some(palette) => Shade::Palette(palette, number(*place, nodes)),
            None => Shade::Plain(DVec3::ZERO),
        },
        Paint::Mix(a, b, t) => {
            let t = number(*t, nodes);
            Shade::Mix(Box::new(shade(a, nodes)), Box::new(shade(b, nodes)), t)
        }
    }
}

/// The number of a node among the formulas.
fn number(node: NodeId, nodes: &mut Vec<NodeId>) -> usize {
    nodes.iter().position(|known| *known == node).unwrap_or_else(|| {
        nodes.push(node);
        nodes.len() - 1
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Size;
    use crate::render::{Drawing, Mode, Silent};
    use crate::scene::colour::from_bytes;
    use crate::session::plan::planned;
    use crate::session::{Plan, Program, Wishes};

    fn values(texture: &Texture, points: &[DVec3]) -> Vec<DVec3> {
        let mut out = Vec::new();
        texture.values(points, &mut out);
        out
    }

    #[test]
    fn colours_are_those_of_their_formulas() {
        let ball = "x^2 + y^2 + z^2 = 4";
        let [red, green, blue] = [DVec3::X, from_bytes([0, 128, 0]), DVec3::Z];
        let viridis = |place: f64| Palette::named("viridis").unwrap().at(place);
        let v = DVec3::new;
        let rows = [
            (ball, "color: rgb(x, y/2, 0.25)", [0.5, 0.5, 0.0], v(0.5, 0.25, 0.25)),
            (ball, "color: rgb(2x, -y, xy)", [0.75, 0.5, 0.0], v(1.0, 0.0, 0.375)),
            (ball, "color: rgb(sqrt(-1 - x^2), ln(y), 0.5)", [0.5, -1.0, 1.0], v(0.0, 0.0, 0.5)),
            (ball, "color: hsv(120*x, 1, 1)", [1.0, 0.0, 0.0], v(0.0, 1.0, 0.0)),
            (ball, "color: hsl(240, 1, z/2)", [0.0, 0.0, 1.0], blue),
            (ball, "color: palette(\"viridis\", z)", [0.0, 0.0, 0.25], viridis(0.25)),
            (ball, "color: palette(viridis, z, -1, 3)", [0.0, 0.0, 1.0], viridis(0.5)),
            (ball, "color: palette(viridis, z, 3, -1)", [0.0, 0.0, 2.0], viridis(0.25)),
            (ball, "color: checker(0.5, red, #00f)", [0.1, 0.1, 0.1], red),
            (ball, "color: checker(0.5, red, #00f)", [0.6, 0.1, 0.1], blue),
            (ball, "color: checker(0.5, red, #00f)", [0.6, -0.1, 0.1], red),
            (ball, "color: checker(0.5, red, #00f)", [0.1, 0.1, -1e-9], red),
            (ball, "color: checker(1, red, blue, theta, z)", [-1.0, 0.1, 0.5], blue),
            (ball, "color: mix(red, blue, z)", [0.0, 0.0, 0.25], v(0.75, 0.0, 0.25)),
            (ball, "color: mix(red, green, z)", [0.0, 0.0, 7.0], green),
            (ball, "color: mix(checker(1, red, blue), mix(blue, green, 1), 0)", [0.5, 0.5, 0.5], red),
            (ball, "color: rgb(mean, gauss, nz)", [0.0, 0.0, 2.0], v(0.5, 0.25, 1.0)),
            ("4 = x^2 + y^2 + z^2", "color: rgb(-mean, gauss, -nz)", [0.0, 0.0, 2.0], v(0.5, 0.25, 1.0)),
            ("-3*(x^2 + y^2 + z^2 - 4) = 0", "color: rgb(-mean, gauss, -nz)", [0.0, 0.0, 2.0], v(0.5, 0.25, 1.0)),
            ("(x^2 + y^2 + z^2 - 4)^2 = 0", "color: rgb(|mean|, gauss, |ny|)", [0.0, 2.0, 0.0], v(0.5, 0.25, 1.0)),
            (
                "(x^2 + y^2 + z^2 - 4)*(x - 9) = 0",
                "color: rgb(|mean|, gauss, |ny|)",
                [0.0, 2.0, 0.0],
                v(0.5, 0.25, 1.0),
            ),
            ("x^2 + y^2 + z^2 <= 4", "color: rgb(mean, gauss, nx)", [2.0, 0.0, 0.0], v(0.5, 0.25, 1.0)),
            (ball, "color: red, lines: every(0.5, z, 0.1)", [3f64.sqrt(), 0.0, 1.0], red * 0.12),
            (ball, "color: red, lines: every(0.5, z, 0.1)", [2.0, 0.0, 0.25], red),
            (ball, "lines: every(1, z)", [2.0, 0.0, 0.0], DVec3::splat(0.8 * 0.12)),
            ("z = 1", "color: red, lines: every(0.5, z)", [0.3, 0.7, 1.0], red),
        ];
        for (surface, said, point, expected) in rows {
            let plan = planned(&format!("{surface} {{ {said} }}"));
            let found = values(&plan.scene.materials[0].color, &[DVec3::from(point)])[0];
            assert!((found - expected).abs().max_element() < 1e-9, "{surface} {said}: {found} {expected}");
        }
    }

    #[test]
    fn other_values_are_too_and_light_may_be_strong() {
        let text = "a = 0.5 in [0, 1]; w = a*x; f(u) = u^2
            x^2+y^2+z^2 = 9 { kind: plastic, roughness: w, opacity: f(z), emission: 5z }";
        let plan = planned(text);
        let material = &plan.scene.materials[0];
        let point = [DVec3::new(1.0, 0.0, 2.0)];
        let found = [&material.roughness, &material.opacity, &material.emission].map(|t| values(t, &point)[0].x);
        assert_eq!(found, [0.5, 1.0, 10.0]);
        assert!(material.is_glowing());
    }

    fn drawn(text: &str, mode: Mode, samples: u32) -> (Plan, Drawing) {
        let mut program = Program::from_text(text);
        let size = Size::new(25, 19).ok();
        let wishes = Wishes { size, mode: Some(mode), samples: Some(samples), keep_depth: true, ..Wishes::default() };
        let plan = Plan::new(&mut program, &wishes).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
        let drawing = plan.draw(&Silent).unwrap();
        (plan, drawing)
    }

    #[test]
    fn pictures_show_the_colours_of_formulas() {
        // A formula that is red everywhere and cannot be known to be.
        let red = "rgb(min(1, 2 + x^2), max(0, -1 - y^2), 0)";
        for surface in ["x^2+y^2+z^2 = 1", "1 = x^2+y^2+z^2", "z = x*y { clip: ball(0, 0, 0, 2) }", "|p| <= 1; z = -1"]
        {
            for mode in [Mode::Studio, Mode::Cosine, Mode::Mirror] {
                let with = |color: &str| match surface.split_once(" {") {
                    Some((surface, rest)) => format!("{surface} {{ color: {color}, {rest}"),
                    None => {
                        surface.replace(';', &format!(" {{ color: {color} }};")) + &format!(" {{ color: {color} }}")
                    }
                };
                let (plain, painted) = (drawn(&with("red"), mode, 4).1, drawn(&with(red), mode, 4).1);
                assert!(plain.picture == painted.picture, "{surface} {mode:?}");
            }
        }
        let (plan, drawing) = drawn("x^2+y^2+z^2 = 1 { color: rgb(x^2, y^2, z^2) }", Mode::Cosine, 1);
        let camera = &plan.scene.camera;
        let t = f64::from(drawing.depth.as_ref().unwrap().at(12, 9));
        let point = camera.ray(25, 19, 12.5, 9.5).at(t);
        let cosine = point.dot(crate::scene::studio::shoulder(camera));
        let found = DVec3::from(drawing.picture.at(12, 9).map(f64::from));
        assert!((found - point * point * cosine).abs().max_element() < 1e-5, "{found} {point}");
    }

    #[test]
    fn curvature_is_shown_as_white_red_and_blue() {
        let rows = [
            ("x^2+y^2+z^2 = 1", [true, false]),
            ("z = x*y { clip: ball(0,0,0,1) }", [false, true]),
            ("z = 0", [false; 2]),
        ];
        for (text, expected) in rows {
            let [r, _, b] = drawn(text, Mode::Curvature, 1).1.picture.at(12, 9);
            assert_eq!([r > 1.2 * b, b > 1.2 * r], expected, "{text}: {r} {b}");
        }
    }

    #[test]
    fn clear_backgrounds_say_what_is_covered() {
        let mut program =
            Program::from_text("x^2+y^2+z^2 = 1; render { background: transparent, size: 25x19, samples: 16 }");
        let plan = Plan::new(&mut program, &Wishes::default()).unwrap();
        let alpha = plan.draw(&Silent).unwrap().alpha.unwrap();
        assert_eq!((alpha.at(0, 0), alpha.at(12, 9)), (0.0, 1.0));
        // The disc's share of the picture, by its angle: sin of half of it is radius over distance.
        let camera = &plan.scene.camera;
        let sine = 1.0 / camera.eye.length();
        let half_heights = sine / (1.0 - sine * sine).sqrt() / crate::scene::angle::tangent(20.0);
        let covered: f64 = alpha.values.iter().map(|&alpha| f64::from(alpha)).sum();
        let expected = std::f64::consts::PI * (half_heights * 9.5) * (half_heights * 9.5);
        assert!((covered / expected - 1.0).abs() < 0.02, "{covered} {expected}");
    }

    #[test]
    fn many_points_have_the_values_of_each_alone() {
        let plan = planned("x^2+y^2+z^2 = 4 { color: checker(0.3, palette(turbo, gauss*z), rgb(nx, ny, r/2)) }");
        let texture = &plan.scene.materials[0].color;
        let points: Vec<DVec3> = (0..150)
            .map(|k| DVec3::new(f64::from(k % 7) - 3.0, f64::from(k % 11) / 4.0, f64::from(k) / 40.0))
            .collect();
        let each: Vec<DVec3> = points.iter().map(|&point| values(texture, &[point])[0]).collect();
        assert_eq!(values(texture, &points), each);
    }

    #[test]
    fn a_material_used_twice_follows_each_surface() {
        let plan = planned("material m { color: rgb(gauss, 0, 0) }; rho = 1 { material: m }; rho = 2 { material: m }");
        let at = |k: usize, x: f64| values(&plan.scene.materials[k].color, &[DVec3::new(x, 0.0, 0.0)])[0].x;
        assert!((at(0, 1.0) - 1.0).abs() < 1e-12 && (at(1, 2.0) - 0.25).abs() < 1e-12);
    }

    #[test]
    fn the_back_of_a_painted_side_is_darker_whatever_the_sign() {
        for text in ["x^2+y^2+z^2 = 4 { color: rgb(1, z/4, 0) }", "4 = x^2+y^2+z^2 { color: rgb(1, z/4, 0) }"] {
            let plan = planned(text);
            let (mut out, point) = (Vec::new(), DVec3::new(0.0, 0.0, 2.0));
            plan.scene.sides[0].colours(&[point, point], &[false, true], &mut out);
            let (positive, negative) = (out[0], out[1]);
            let outside = if text.starts_with('4') { negative } else { positive };
            assert_eq!(outside, DVec3::new(1.0, 0.5, 0.0), "{text}");
            assert!(positive != negative);
        }
    }
}
