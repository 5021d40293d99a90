//! What was said of materials and lights, as what the scene is made of.
//!
//! In: a program's surfaces, lights and sky as they were written. Out: materials, lights and a sky in linear light. Separate from
//! the plan, which decides what is seen and from where.

use super::inside;
use super::paint::Painter;
use crate::diag::Diagnostic;
use crate::expr::graph::Graph;
use crate::expr::lower::{self, Color, Lowered, Matter, MatterKind, Metal, Paint, SkyKind, SurfaceFormula};
use crate::num::level::Simd;
use crate::scene::daylight::Daylight;
use crate::scene::material::{Conductor, DEFAULT_ALBEDO, DEFAULT_IOR, Dielectric, Kind};
use crate::scene::{Light, Material, Scene, Sides, Sky, Texture, angle, colour, metals};
use glam::DVec3;

/// A colour as linear light.
pub(super) fn linear(color: Color) -> DVec3 {
    match color {
        Color::Srgb(bytes) => colour::from_bytes(bytes),
        Color::Linear(rgb) => rgb.into(),
    }
}

/// Gives a scene its materials, its lights and its sky; what had to be assumed is returned.
pub(super) fn furnish(
    scene: &mut Scene,
    lowered: &mut Lowered,
    surfaces: &[&SurfaceFormula],
    simd: Simd,
) -> Vec<Diagnostic> {
    let mut notes = Vec::new();
    let kinds = kinds(&mut lowered.graph, surfaces, simd, &mut notes);
    let painter = Painter { graph: &lowered.graph, simd, radius: scene.radius };
    let materials = surfaces.iter().zip(kinds).map(|(surface, kind)| material(&surface.matter, kind, &painter));
    scene.materials = materials.collect();
    scene.lights = lowered.lights.iter().map(light).collect();
    scene.sky = sky(lowered, &scene.materials);
    notes
}

fn material(matter: &Matter, kind: Kind, painter: &Painter<'_>) -> Material {
    let texture =
        |paint: &Option<Paint>, default: DVec3, most: f64| painter.texture(paint.as_ref(), None, default, most);
    let albedo = DVec3::splat(DEFAULT_ALBEDO);
    Material {
        kind,
        color: painter.texture(matter.color.as_ref(), matter.lines.as_ref(), albedo, 1.0),
        roughness: texture(&matter.roughness, DVec3::ZERO, 1.0),
        emission: texture(&matter.emission, DVec3::ZERO, f64::MAX),
        opacity: texture(&matter.opacity, DVec3::ONE, 1.0),
    }
}

/// How the surfaces scatter, in their order; what is to be said of them goes to `notes`.
fn kinds(graph: &mut Graph, surfaces: &[&SurfaceFormula], simd: Simd, notes: &mut Vec<Diagnostic>) -> Vec<Kind> {
    let kind = |(index, surface): (usize, &&SurfaceFormula)| match surface.matter.kind {
        MatterKind::Glass => Kind::Glass(Dielectric {
            inside_is_negative: inside::is_negative(graph, surface, simd, notes),
            ..dielectric(&surface.matter, index)
        }),
        kind => kind_of(kind, &surface.matter),
    };
    surfaces.iter().enumerate().map(kind).collect()
}

/// What the two sides of a surface look like where no light is followed; `is_turned` if f is negative outside.
pub(super) fn sides(matter: &Matter, default: Sides, is_turned: bool, painter: &Painter<'_>) -> Sides {
    let white = Texture::Constant(DVec3::ONE);
    let lines = matter.lines.as_ref().map(|lines| painter.texture(None, Some(lines), DVec3::ONE, 1.0));
    let paint = matter.color.as_ref().map(|paint| painter.texture(Some(paint), None, DVec3::ZERO, 1.0));
    let metal = matter.conductor.map(|metal| conductor(metal).normal_reflectance());
    let sides = match (metal, paint) {
        (Some(reflectance), _) => Sides::of(reflectance),
        (None, Some(Texture::Constant(colour))) => Sides::of(colour),
        (None, Some(paint)) => Sides { paint: Some(paint), ..default },
        (None, None) => default,
    };
    let sides = Sides { lines: lines.filter(|lines| lines.constant() != white.constant()), is_turned, ..sides };
    if is_turned { Sides { front: sides.back, back: sides.front, ..sides } } else { sides }
}

fn kind_of(kind: MatterKind, matter: &Matter) -> Kind {
    match kind {
        MatterKind::Matte => Kind::Matte,
        MatterKind::Plastic => Kind::Plastic { ior: matter.ior.unwrap_or(DEFAULT_IOR) },
        MatterKind::Metal => Kind::Metal(matter.conductor.map(conductor)),
        MatterKind::Mirror => Kind::Mirror,
        MatterKind::Glass => Kind::Glass(dielectric(matter, 0)),
    }
}

/// Clear stuff; what is written later is inside of what is written before.
fn dielectric(matter: &Matter, index: usize) -> Dielectric {
    Dielectric {
        ior: matter.ior.unwrap_or(DEFAULT_IOR),
        absorption: matter.absorption.map_or(DVec3::ZERO, linear),
        inside_is_negative: true,
        priority: matter.priority.unwrap_or(u32::try_from(index).unwrap_or(u32::MAX)),
    }
}

fn conductor(written: lower::Conductor) -> Conductor {
    match written {
        lower::Conductor::Written { n, k } => Conductor { n: linear(n), k: linear(k) },
        lower::Conductor::Measured(metal) => match metal {
            Metal::Gold => metals::GOLD,
            Metal::Silver => metals::SILVER,
            Metal::Copper => metals::COPPER,
            Metal::Aluminium => metals::ALUMINIUM,
            Metal::Iron => metals::IRON,
        },
    }
}

fn light(written: &lower::Light) -> Light {
    match *written {
        lower::Light::Lamp { at, power, color, radius } => {
            let (at, power) = (DVec3::from(at), power * linear(color));
            if radius > 0.0 { Light::Ball { center: at, radius, power } } else { Light::Point { at, power } }
        }
        lower::Light::Sun { from, irradiance, color, angle } => Light::Sun {
            toward: toward(from),
            irradiance: irradiance * linear(color),
            half_angle: angle::radians(angle) / 2.0,
        },
    }
}

/// The unit vector, of however long or short a one.
fn toward(from: [f64; 3]) -> DVec3 {
    let from = DVec3::from(from);
    (from / from.abs().max_element()).normalize()
}

/// What is seen where there is nothing: the sky as written; without one darkness, or a bright sky where nothing else shines.
fn sky(lowered: &Lowered, materials: &[Material]) -> Option<Sky> {
    let is_lit = || !lowered.lights.is_empty() || materials.iter().any(Material::is_glowing);
    match &lowered.sky {
        None if is_lit() => None,
        None => Some(Sky::Uniform(DVec3::ONE)),
        Some(sky) => Some(match sky.kind {
            SkyKind::Uniform { radiance, color } => Sky::Uniform(radiance * linear(color)),
            SkyKind::Gradient { top, horizon, ground } => {
                Sky::Gradient { top: linear(top), horizon: linear(horizon), ground: linear(ground) }
            }
            SkyKind::Daylight { sun, turbidity } => Sky::Daylight(Daylight::new(toward(sun), turbidity)),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::plan::planned;
    use crate::surface::{Ray, Tracer};
    use std::f64::consts::PI;

    fn material(said: &str) -> Material {
        planned(&format!("x^2 + y^2 + z^2 = 1 {{ {said} }}")).scene.materials.remove(0)
    }

    #[test]
    fn kinds_are_those_that_were_written_or_spoken_of() {
        let glass = Dielectric { ior: 1.5, absorption: DVec3::ZERO, inside_is_negative: true, priority: 0 };
        let written = Conductor { n: DVec3::new(0.2, 0.4, 1.4), k: DVec3::splat(3.0) };
        let rows = [
            ("", Kind::Matte),
            ("color: red", Kind::Matte),
            ("emission: 3", Kind::Matte),
            ("kind: plastic", Kind::Plastic { ior: 1.5 }),
            ("kind: \"plastic\", ior: 1.3", Kind::Plastic { ior: 1.3 }),
            ("kind: metal, color: red", Kind::Metal(None)),
            ("metal: gold", Kind::Metal(Some(metals::GOLD))),
            ("metal: \"aluminum\"", Kind::Metal(Some(metals::ALUMINIUM))),
            ("n: rgb(0.2, 0.4, 1.4), k: 3", Kind::Metal(Some(written))),
            ("kind: mirror", Kind::Mirror),
            ("kind: glass", Kind::Glass(glass)),
            ("ior: 1", Kind::Glass(Dielectric { ior: 1.0, ..glass })),
            ("absorption: 2", Kind::Glass(Dielectric { absorption: DVec3::splat(2.0), ..glass })),
            (
                "kind: glass, absorption: rgb(3, 0, 1)",
                Kind::Glass(Dielectric { absorption: DVec3::new(3.0, 0.0, 1.0), ..glass }),
            ),
            ("kind: glass, priority: 7", Kind::Glass(Dielectric { priority: 7, ..glass })),
        ];
        for (said, kind) in rows {
            assert_eq!(material(said).kind, kind, "{said}");
        }
    }

    #[test]
    fn values_are_linear_and_have_their_defaults() {
        let all = |material: &Material| {
            [&material.color, &material.roughness, &material.emission, &material.opacity].map(|t| t.constant().unwrap())
        };
        let [zero, one] = [DVec3::ZERO, DVec3::ONE];
        assert_eq!(all(&material("")), [one * 0.8, zero, zero, one]);
        let said = "color: #80ff00, roughness: 0.25, emission: rgb(3, 2, 0), opacity: 1/2";
        let green = DVec3::new(colour::linear_from_srgb(128.0 / 255.0), 1.0, 0.0);
        assert_eq!(all(&material(said)), [green, one * 0.25, DVec3::new(3.0, 2.0, 0.0), one * 0.5]);
        assert_eq!(all(&material("emission: 2"))[2], one * 2.0);
        assert_eq!(all(&material("emission: red"))[2], DVec3::X);
    }

    #[test]
    fn surfaces_win_over_the_material_they_name() {
        let plan = planned(
            "material stuff { kind: plastic, color: red, ior: 1.4 }
            x^2 + y^2 + z^2 = 1 { material: stuff }
            x^2 + y^2 + z^2 = 2 { material: \"stuff\", color: blue }",
        );
        let [first, second] = &plan.scene.materials[..] else { panic!("two materials") };
        assert_eq!((first.kind, second.kind), (Kind::Plastic { ior: 1.4 }, Kind::Plastic { ior: 1.4 }));
        assert_eq!((first.color.constant(), second.color.constant()), (Some(DVec3::X), Some(DVec3::Z)));
    }

    /// Whether a ray from above the pole of the unit ball towards its middle comes from outside, by what the tracer says of the
    /// first hit and by what the material says; and how many notes there are.
    fn enters(text: &str) -> (bool, usize) {
        let plan = planned(text);
        let Kind::Glass(glass) = plan.scene.materials[0].kind else { panic!("{text}") };
        let mut hits = Vec::new();
        let ray = Ray::new(DVec3::new(0.01, 0.02, 4.0), DVec3::NEG_Z);
        Tracer::new(&plan.surfaces, plan.method).trace(&[ray], &mut hits);
        assert!(hits[0].is_drawn(), "{text}");
        (hits[0].flipped != glass.inside_is_negative, plan.notes.len())
    }

    #[test]
    fn the_inside_is_where_the_sign_differs_from_that_far_away() {
        let rows = [
            ("x^2 + y^2 + z^2 = 1 { kind: glass }", (true, 0)),
            ("1 = x^2 + y^2 + z^2 { kind: glass }", (true, 0)),
            ("3*(1 - x^2 - y^2 - z^2) = 0 { kind: glass }", (true, 0)),
            ("-2*(x^2 + y^2 + z^2 - 1) = 0 { kind: glass }", (true, 0)),
            ("1/(x^2 + y^2 + z^2) = 1 { kind: glass }", (true, 0)),
            ("exp(1) = exp(x^2 + y^2 + z^2) { kind: glass }", (true, 0)),
            ("(x^2 + y^2 + z^2 - 1)^2 = 0 { kind: glass }", (true, 0)),
            ("x^2 + y^2 + z^2 <= 1 { kind: glass }", (true, 0)),
            ("x^2 + y^2 + z^2 >= 1 { kind: glass }", (true, 0)),
            ("(x^2 + y^2 + z^2 - 1)*((x-3)^2 + y^2 + z^2 - 1) = 0 { kind: glass }", (true, 0)),
            ("(x^2 + y^2 + z^2 - 1)*(1 - (x-3)^2 - y^2 - z^2) = 0 { kind: glass }", (true, 1)),
            ("z = 0 { kind: glass }", (true, 1)),
            ("-z = 0 { kind: glass }", (false, 1)),
            ("z <= 0 { kind: glass }", (true, 0)),
            ("z = 0 { kind: glass, inside: negative }", (true, 0)),
            ("z = 0 { kind: glass, inside: positive }", (false, 0)),
            ("-2*z = 0 { kind: glass, inside: positive }", (true, 0)),
            ("x^2 + y^2 + z^2 = 1 { kind: glass, inside: positive }", (false, 0)),
            ("x^2 + y^2 + z^2 <= 1 { kind: glass, inside: positive }", (false, 0)),
            ("-2*(x^2 + y^2 + z^2 - 1) = 0 { kind: glass, inside: negative }", (false, 0)),
            ("-2*(x^2 + y^2 + z^2 - 1) = 0 { kind: glass, inside: positive }", (true, 0)),
        ];
        for (text, expected) in rows {
            assert_eq!(enters(text), expected, "{text}");
        }
    }

    #[test]
    fn what_is_written_later_is_inside_of_what_is_written_before() {
        let plan = planned("x^2+y^2+z^2 = 4 { kind: glass }; x^2+y^2+z^2 = 1 { kind: glass, ior: 1.33 }");
        let priorities = plan.scene.materials.iter().map(|material| match material.kind {
            Kind::Glass(glass) => glass.priority,
            _ => panic!("glass"),
        });
        assert_eq!(priorities.collect::<Vec<u32>>(), [0, 1]);
    }

    #[test]
    fn power_and_irradiance_become_strength() {
        let rows = [
            ("light { at: (1, 2, 3), power: 60 }", DVec3::splat(60.0 / (4.0 * PI))),
            (
                "light { at: (1, 2, 3), power: 60, color: rgb(2, 1, 0) }",
                DVec3::new(2.0, 1.0, 0.0) * (60.0 / (4.0 * PI)),
            ),
            ("light { at: (1, 2, 3), power: 60, radius: 0.5 }", DVec3::splat(60.0 / (4.0 * PI * PI * 0.25))),
            ("sun { from: (0, 0, 2), irradiance: 3 }", DVec3::splat(3.0)),
            ("sun { from: (0, 0, 2), irradiance: 3, color: red, angle: 60 }", DVec3::X * (3.0 / (PI * 0.25))),
        ];
        for (text, strength) in rows {
            let plan = planned(&format!("x^2 + y^2 + z^2 = 1; {text}"));
            let [light] = plan.scene.lights[..] else { panic!("{text}") };
            assert!(
                (light.strength() - strength).abs().max_element() < 1e-14 * strength.max_element(),
                "{text}: {light:?}"
            );
            assert_eq!(plan.scene.sky, None, "{text}");
        }
        let plan =
            planned("x = 0; sun { from: (3e200, 0, -4e200), irradiance: 1 }; light { at: (1, 2, -3), power: 0 }");
        let [Light::Sun { toward, .. }, Light::Point { at, .. }] = plan.scene.lights[..] else { panic!() };
        assert!(toward.distance(DVec3::new(0.6, 0.0, -0.8)) < 1e-15);
        assert_eq!(at, DVec3::new(1.0, 2.0, -3.0));
    }

    #[test]
    fn a_scene_without_light_has_a_bright_sky() {
        let white = Some(Sky::Uniform(DVec3::ONE));
        let day = Daylight::new(toward([3.0, 0.0, 4.0]), 2.5);
        let gradient = Sky::Gradient { top: DVec3::Z, horizon: DVec3::splat(0.5), ground: DVec3::ZERO };
        let rows = [
            ("", white.clone()),
            ("sky { radiance: 0 }", Some(Sky::Uniform(DVec3::ZERO))),
            ("sky { radiance: 2, color: blue }", Some(Sky::Uniform(DVec3::Z * 2.0))),
            ("sky { top: blue, horizon: 0.5, ground: black }", Some(gradient)),
            ("sky { sun: (3, 0, 4), turbidity: 2.5 }", Some(Sky::Daylight(day))),
            ("light { at: (0, 0, 9), power: 0 }", None),
            ("x = 4 { emission: 1 }", None),
            ("x = 4 { emission: 0 }", white),
        ];
        for (text, sky) in rows {
            assert_eq!(planned(&format!("x^2 + y^2 + z^2 = 1; {text}")).scene.sky, sky, "{text}");
        }
    }

    #[test]
    fn ten_thousand_lights_are_no_work() {
        let mut text = "x^2 + y^2 + z^2 = 1\n".to_owned();
        for k in 0..10_000 {
            text += &format!("light {{ at: ({}, {}.5, -3), power: 1e-{} }}\n", k, k, k % 30);
        }
        assert_eq!(planned(&text).scene.lights.len(), 10_000);
    }
}
