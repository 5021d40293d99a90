//! Modes `angle`, `end`, `bounces`, `curvature`, ray by ray, against geometry.
//!
//! In: surfaces whose angles, ends, reflections and curvatures are known in closed form. Out: the colour of each ray.

use super::{Mode, ray};
use glam::DVec3;
use implicit::film::Size;
use implicit::session::{Plan, Program, Wishes};
use std::f64::consts::{FRAC_PI_2, PI};

/// Pixels have single precision.
const ROUNDING: f64 = 2e-6;

/// The scale of the data modes: five colours of "viridis" at equal steps, as published, and straight lines between.
fn viridis(share: f64) -> DVec3 {
    const COLOURS: [[f64; 3]; 5] =
        [[68.0, 1.0, 84.0], [59.0, 82.0, 139.0], [33.0, 145.0, 140.0], [94.0, 201.0, 98.0], [253.0, 231.0, 37.0]];
    let place = share.clamp(0.0, 1.0) * 4.0;
    let below = (place as usize).min(3);
    let [a, b] = [COLOURS[below], COLOURS[below + 1]].map(DVec3::from);
    a.lerp(b, place - below as f64) / 255.0
}

fn near(seen: DVec3, expected: DVec3, row: &str) {
    assert!((seen - expected).abs().max_element() < ROUNDING, "{row}: {seen}, not {expected}");
}

#[test]
fn angles_are_those_between_ray_and_normal() {
    // On a plane the angle of the eye above it; on the unit ball the one whose sine is the ray's distance from the middle.
    for degrees in [0.0f64, 10.0, 45.0, 60.0, 89.0] {
        let eye = format!("({},0,{})", 3.0 * degrees.to_radians().sin(), 3.0 * degrees.to_radians().cos());
        let plane = "z=0 { clip: box(-9..9,-9..9,-1..1) }";
        near(ray(plane, Mode::Angle, (&eye, "(0,0,0)"), 8), viridis(degrees / 90.0), &format!("plane {degrees}"));
    }
    for off in [0.0, 0.1, 0.5, 0.9, 0.99f64] {
        let (eye, at) = (format!("(-4,{off},0)"), format!("(0,{off},0)"));
        let share = off.asin() / FRAC_PI_2;
        for ball in ["x^2+y^2+z^2=1", "2 = 2*(x^2+y^2+z^2)"] {
            near(ray(ball, Mode::Angle, (&eye, &at), 8), viridis(share), &format!("ball {off}"));
        }
    }
}

#[test]
fn rays_end_where_mirrors_send_them() {
    let planes = "x=0 { color: red }; y=0 { color: red }; z=0 { color: red }; render { clip: box(-9..9,-9..9,-9..9) }";
    let toward = |d: DVec3| (d.normalize() + 1.0) * 0.5;
    let d = DVec3::new(-3.0, -2.0, -1.0);
    let seen = |text: &str, bounces| ray(text, Mode::End, ("(4.5,3.4,2.3)", "(1.5,1.4,1.3)"), bounces);
    // A corner of three mirrors sends every ray back; with fewer reflections the ray ends on the next of them.
    near(seen(planes, 8), toward(-d), "corner");
    near(seen(planes, 3), toward(-d), "corner, just enough");
    near(seen(planes, 2), DVec3::X, "corner, one short");
    // One of them turns one coordinate around.
    near(seen("x=0; render { clip: box(-9..9,-9..9,-9..9) }", 8), toward(DVec3::new(3.0, -2.0, -1.0)), "plane");
    // The unit ball at distance h of its middle turns a ray by π − 2·asin h.
    for h in [0.0f64, 0.3, 0.8] {
        let turn = PI - 2.0 * h.asin();
        let (eye, at) = (format!("(-4,{h},0)"), format!("(0,{h},0)"));
        let expected = toward(DVec3::new(turn.cos(), turn.sin(), 0.0));
        near(ray("x^2+y^2+z^2=1", Mode::End, (&eye, &at), 8), expected, &format!("ball {h}"));
    }
}

#[test]
fn bounces_between_two_mirrors_are_those_of_the_unfolded_ray() {
    // Plates z = 0 and z = 1, 10 long: unfolded, a ray crosses a whole number of heights between both ends.
    let plates = "z=0; z=1; render { clip: box(0..10,-1..1,-0.5..1.5) }";
    for slope in [0.0f64, 0.07, 0.31, 0.5, 1.13, 1.9] {
        let height = |x: f64| 0.4 + slope * x;
        let crossed = (1..100).filter(|&k| (height(0.0)..height(10.0)).contains(&f64::from(k))).count();
        let (eye, at) = (format!("(-1,0,{})", height(-1.0)), format!("(0,0,{})", height(0.0)));
        for most in [40u32, 3] {
            let seen = ray(plates, Mode::Bounces, (&eye, &at), most);
            let expected = match crossed {
                0 => DVec3::from([0.018, 0.021, 0.030]),
                count => viridis(count.min(most as usize) as f64 / f64::from(most)),
            };
            near(seen, expected, &format!("{slope} {most}"));
        }
    }
}

/// Points with normals, the mean and the Gauss curvature there, of the side that f leaves.
fn curved() -> Vec<(String, DVec3, DVec3, f64, f64)> {
    let mut rows = Vec::new();
    for radius in [0.5, 1.0, 2.0f64] {
        let n = DVec3::new(0.36, 0.48, 0.8);
        let text = format!("x^2+y^2+z^2={}", radius * radius);
        rows.push((text, n * radius, n, 1.0 / radius, 1.0 / (radius * radius)));
    }
    // A torus of radii 2 and 1/2, by the angle around its tube (do Carmo, "Differential Geometry", section 3-3, example 5).
    let (large, small) = (2.0, 0.5);
    for degrees in [0.0f64, 50.0, 90.0, 130.0, 180.0] {
        let (s, c) = degrees.to_radians().sin_cos();
        let (n, out) = (DVec3::new(c, 0.0, s), large + small * c);
        let (mean, gauss) = ((large + 2.0 * small * c) / (2.0 * small * out), c / (small * out));
        let text = "(sqrt(x^2+y^2)-2)^2+z^2=0.25".to_owned();
        rows.push((text, DVec3::new(large, 0.0, 0.0) + n * small, n, mean, gauss));
    }
    // z = (x² − y²)/2 with slopes p = x, q = −y: K = −1/(1 + p² + q²)², and of z − (x² − y²)/2 the mean is
    // −((1 + q²) − (1 + p²))/(2(1 + p² + q²)^(3/2)).
    for (x, y) in [(0.0f64, 0.0f64), (0.7, 0.0), (0.2, -0.6)] {
        let w = 1.0 + x * x + y * y;
        let (point, n) = (DVec3::new(x, y, (x * x - y * y) / 2.0), DVec3::new(-x, y, 1.0) / w.sqrt());
        let mean = -((1.0 + y * y) - (1.0 + x * x)) / (2.0 * w * w.sqrt());
        rows.push(("z=(x^2-y^2)/2".to_owned(), point, n, mean, -1.0 / (w * w)));
    }
    rows.push(("z=0".to_owned(), DVec3::ZERO, DVec3::Z, 0.0, 0.0));
    rows
}

fn written(p: DVec3) -> String {
    format!("({},{},{})", p.x, p.y, p.z)
}

/// The radius of the ball that all is clipped by.
const RADIUS: f64 = 3.0;

#[test]
fn curvatures_are_those_of_differential_geometry() {
    for (text, point, n, mean, gauss) in curved() {
        // As light, which may be anything that is not negative.
        let text = format!(
            "{text} {{ color: black, emission: rgb(mean + 9, gauss + 9, nz + 9) }}; render {{ clip: ball(0,0,0,{RADIUS}) }}"
        );
        let eye = point + n * 0.5 + DVec3::new(0.01, 0.02, 0.005);
        for mode in [Mode::Whitted, Mode::Path] {
            let seen = ray(&text, mode, (&written(eye), &written(point)), 0) - 9.0;
            near(seen, DVec3::new(mean, gauss, n.z), &format!("{text} at {point}"));
        }
    }
}

/// The radius of what is seen.
fn radius(text: &str, eye: DVec3, at: DVec3) -> f64 {
    let text = format!("{text}; camera {{ eye: {}, look_at: {} }}", written(eye), written(at));
    let wishes = Wishes { size: Size::new(1, 1).ok(), ..Wishes::default() };
    Plan::new(&mut Program::from_text(&text), &wishes).unwrap().scene.radius
}

#[test]
fn mode_curvature_shows_gauss_on_a_scale_from_red_to_blue() {
    let palette = implicit::scene::palette::Palette::named("red_blue").unwrap();
    for (text, point, n, _, gauss) in curved() {
        let text = format!("{text} {{ clip: ball(0,0,0,{RADIUS}) }}; render {{ clip: ball(0,0,0,{RADIUS}) }}");
        let (eye, across) = (point + n * 0.5, n.any_orthonormal_vector() * 0.25);
        for eye in [eye, eye + across] {
            // 30 over the square of the scene's radius is full, by an inverse hyperbolic sine; brighter where the surface faces the eye.
            let radius = radius(&text, eye, point);
            let place = ((gauss * radius * radius).asinh() / 30f64.asinh()).clamp(-1.0, 1.0);
            let form = 0.45 + 0.55 * (eye - point).normalize().dot(n);
            let seen = ray(&text, Mode::Curvature, (&written(eye), &written(point)), 0);
            near(seen, palette.at(0.5 - 0.5 * place) * form, &format!("{text} at {point}"));
        }
    }
}
