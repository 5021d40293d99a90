//! Mode `whitted`, ray by ray, against formulas.
//!
//! In: scenes of planes and balls, one ray each. Out: its light against what Lambert, Fresnel, Snell, Beer and elementary geometry say,
//! computed here. Nothing is chosen by chance in this mode, so the bounds are those of single precision and of rays too weak to be followed.

use super::{Mode, WAY, Way, draw, ray};
use glam::DVec3;
use std::f64::consts::PI;

/// Pixels have single precision.
const ROUNDING: f64 = 1e-6;

/// Rays that stand for less than a thousandth are not followed; two of them may be left out at an interface.
const UNFOLLOWED: f64 = 2e-3;

const ALBEDO: DVec3 = DVec3::new(0.25, 0.5, 0.75);

/// What is seen of the origin of a floor of that albedo.
fn floor(more: &str) -> DVec3 {
    let text = format!("z=0 {{ color: rgb(0.25,0.5,0.75), clip: box(-30..30,-30..30,-1..1) }}; {more}");
    ray(&text, Mode::Whitted, ("(0.3,-1,2)", "(0,0,0)"), 8)
}

#[test]
fn lights_shine_on_matte_by_lambert_and_the_square_of_the_distance() {
    // The irradiance: P·cos/(4πd²) of points and of balls as if from their middle, E·cos of suns of any size; what is around counts
    // as an even light, π times its radiance. What is in the way takes all of it, or its opacity twice, on the way in and out.
    let (near, far) = (100.0 / (4.0 * PI * 9.0), 100.0 * 0.8 / (4.0 * PI * 25.0));
    let rows = [
        ("light { at: (0,0,3), power: 100 }", near),
        ("light { at: (3,0,4), power: 100 }", far),
        ("light { at: (0,0,3), power: 100, radius: 0.5 }", near),
        ("light { at: (3,0,4), power: 100, radius: 2 }", far),
        ("light { at: (0,3,4), power: 100 }; light { at: (0,0,3), power: 100 }", near + far),
        ("sun { from: (0,0,1), irradiance: 5 }", 5.0),
        ("sun { from: (0,3,4), irradiance: 5 }", 4.0),
        ("sun { from: (0,3,4), irradiance: 5, angle: 30 }", 4.0),
        ("sun { from: (0,3,4), irradiance: 5 }; sky { radiance: 2 }", 4.0 + 2.0 * PI),
        ("light { at: (0,0,-3), power: 100 }", 0.0),
        ("sun { from: (1,0,-1e-9), irradiance: 5 }", 0.0),
        ("light { at: (3,0,4), power: 100 }; (x-1.5)^2+y^2+(z-2)^2=0.1", 0.0),
        ("light { at: (3,0,4), power: 100 }; (x-4.5)^2+y^2+(z-6)^2=0.1", far),
        ("light { at: (3,0,4), power: 100 }; (x-1.5)^2+y^2+(z-2)^2=0.1 { opacity: 0.25 }", 0.75 * 0.75 * far),
        ("sun { from: (3,0,4), irradiance: 5 }; (x-300)^2+y^2+(z-400)^2=1 { clip: ball(300,0,400,2) }", 0.0),
        ("light { at: (3,0,4), power: 100, radius: 2 }; (x-1.5)^2+y^2+(z-2)^2=0.1", 0.0),
        ("light { at: (3,0,4), power: 100 }; light { at: (1.5,0,2), power: 0, radius: 0.3 }", 0.0),
    ];
    for (more, irradiance) in rows {
        let (seen, expected) = (floor(more), ALBEDO * irradiance / PI);
        assert!(
            (seen - expected).abs().max_element() <= ROUNDING * (1.0 + irradiance),
            "{more}: {seen}, not {expected}"
        );
    }
    let seen = floor("light { at: (0,0,3), power: 100, color: rgb(1,0.5,0) }");
    let expected = ALBEDO * DVec3::new(1.0, 0.5, 0.0) * near / PI;
    assert!((seen - expected).abs().max_element() < ROUNDING, "{seen}, not {expected}");
}

#[test]
fn mirrors_show_images_where_geometry_has_them() {
    // The mirror z = 0 shows the ball around (3, 0, 3) around (3, 0, -3): a ray from the eye meets it if it passes there nearer than
    // the radius.
    let (eye, image) = (DVec3::new(-3.0, 0.0, 3.0), DVec3::new(3.0, 0.0, -3.0));
    for (x, y) in [(0.2, 0.0), (-0.3, 0.1), (0.0, 0.25)] {
        let way = (DVec3::new(x, y, 0.0) - eye).normalize();
        let off = (image - eye).cross(way).length();
        for (share, is_seen) in [(1.01, 1.0), (0.99, 0.0)] {
            let radius = off * share;
            let lamp = format!("light {{ at: (3,0,3), power: 100, radius: {radius} }}");
            let glowing = format!("(x-3)^2+y^2+(z-3)^2={} {{ emission: 2, color: black }}", radius * radius);
            for (ball, radiance) in [(lamp, 100.0 / (4.0 * PI * PI * radius * radius)), (glowing, 2.0)] {
                let plane = "z=0 { kind: mirror, color: rgb(0.25,0.5,0.75), clip: box(-30..30,-30..30,-1..1) }";
                let at = format!("({x},{y},0)");
                let of = |bounces| ray(&format!("{plane}; {ball}"), Mode::Whitted, ("(-3,0,3)", at.as_str()), bounces);
                let expected = ALBEDO * radiance * is_seen;
                assert!((of(1) - expected).abs().max_element() <= ROUNDING * radiance, "{ball}: {} {expected}", of(1));
                assert_eq!(of(0), DVec3::ZERO, "{ball}");
            }
        }
    }
}

#[test]
fn between_mirrors_each_image_takes_its_bounces() {
    // Plates z = 0 and z = 1 with tints 1/2 and 1/4; a ray down by 45° from (0, 0, 1/2) meets them in turn at x = 1/2, 3/2, … and the
    // wall x = k just before the plate number k + 1.
    let plates = "z=0 { kind: mirror, color: rgb(0.5,0.5,0.5) }; z=1 { kind: mirror, color: rgb(0.25,0.25,0.25) }; \
                  render { clip: box(-1..9,-1..1,-1..2) }";
    for wall in 1..=5u32 {
        let text = format!("{plates}; x={wall} {{ emission: 1, color: black }}");
        let expected = (0..wall).map(|k| if k % 2 == 0 { 0.5 } else { 0.25 }).product::<f64>();
        let seen = |bounces| ray(&text, Mode::Whitted, ("(0,0,0.5)", "(0.5,0,0)"), bounces).x;
        assert!((seen(wall) - expected).abs() < ROUNDING && seen(wall - 1) == 0.0, "{wall}: {}", seen(wall));
    }
}

/// Fresnel's share for unpolarised light, by the sines and tangents of the angles (Hecht, "Optics", equations 4.42 and 4.43).
fn reflectance(angle: f64, ior: f64) -> f64 {
    let beyond = (angle.sin() / ior).asin();
    if angle == 0.0 {
        return ((ior - 1.0) / (ior + 1.0)).powi(2);
    }
    let (minus, plus) = (angle - beyond, angle + beyond);
    0.5 * ((minus.sin() / plus.sin()).powi(2) + (minus.tan() / plus.tan()).powi(2))
}

#[test]
fn slabs_of_glass_reflect_and_let_through_by_fresnel_and_beer() {
    // All orders of a slab of thickness 1 between two walls: through it (1 − R)²t/(1 − R²t²), back R + (1 − R)²Rt²/(1 − R²t²), where
    // t = e^(−a/cos) of the angle inside.
    for (ior, degrees, absorption) in [
        (1.5f64, 0.0f64, 0.0f64),
        (1.5, 0.0, 0.7),
        (1.5, 40.0, 0.0),
        (1.5, 40.0, 0.7),
        (1.5, 56.309_932_474_020_21, 0.3),
        (1.5, 75.0, 0.3),
        (2.4, 30.0, 1.5),
        (1.0, 50.0, 0.5),
    ] {
        let angle = degrees.to_radians();
        let (r, inside) = (reflectance(angle, ior), (angle.sin() / ior).asin());
        let t = (-absorption / inside.cos()).exp();
        let inner = (1.0 - r).powi(2) / (1.0 - r * r * t * t);
        let (x, y) = (-3.0 * angle.sin(), -0.5 - 3.0 * angle.cos());
        for (wall, expected) in [("y=5", inner * t), ("y=-9", r + inner * r * t * t)] {
            let text = format!(
                "|y| <= 0.5 {{ kind: glass, ior: {ior}, absorption: {absorption}, clip: box(-99..99,-2..2,-9..9) }}; \
                 {wall} {{ emission: 1, color: black, clip: box(-99..99,-10..6,-9..9) }}"
            );
            let seen = ray(&text, Mode::Whitted, (&format!("({x},{y},0)"), "(0,-0.5,0)"), 64).x;
            assert!(
                (seen - expected).abs() < UNFOLLOWED,
                "{ior} {degrees} {absorption} {wall}: {seen}, not {expected}"
            );
        }
    }
}

#[test]
fn glass_holds_back_what_comes_to_its_surface_too_flat() {
    // From inside, n = 1.5: beyond 41.8 degrees nothing leaves; before it, what Fresnel lets through along the same way back.
    let text = "y <= 0.5 { kind: glass, ior: 1.5, clip: box(-9..9,-9..2,-9..9) }; \
                y=1 { emission: 1, color: black, clip: box(-99..99,0..2,-9..9) }";
    for (degrees, is_open) in [(0.0f64, true), (30.0, true), (41.7, true), (41.9, false), (70.0, false)] {
        let angle = degrees.to_radians();
        let at = format!("({},{},0)", angle.sin(), angle.cos());
        let seen = ray(text, Mode::Whitted, ("(0,0,0)", &at), 1).x;
        let outside = (1.5 * angle.sin()).min(1.0).asin();
        let expected = if is_open { 1.0 - reflectance(outside, 1.5) } else { 0.0 };
        assert!((seen - expected).abs() < ROUNDING, "{degrees}: {seen}, not {expected}");
    }
}

#[test]
fn a_ball_of_glass_turns_a_ray_by_snell() {
    // At height h of the unit ball a ray arrives under sin i = h, is turned by 2(i − r), sin r = h/n, and leaves at a known place.
    for (ior, h) in [(1.5f64, 0.0f64), (1.5, 0.3), (1.5, 0.8), (2.4, 0.5), (1.33, 0.9)] {
        let (i, r) = (h.asin(), (h / ior).asin());
        let turned = 2.0 * (i - r);
        // It leaves where its first point is turned about the middle by π − 2r; measured from the ray's direction that is 2r − i
        // above the axis, and goes down by the turn.
        let (leaves, slope) = (DVec3::new(0.0, (2.0 * r - i).cos(), (2.0 * r - i).sin()), -turned.tan());
        let meets = leaves.z + slope * (6.0 - leaves.y);
        let lamp = |z: f64| {
            format!(
                "x^2+y^2+z^2=1 {{ kind: glass, ior: {ior} }}; x^2+(y-6)^2+(z-({z}))^2=0.0001 {{ emission: 1, color: black }}"
            )
        };
        let seen = |z: f64| {
            let (eye, at) = (format!("(0,-4,{h})"), format!("(0,0,{h})"));
            ray(&lamp(z), Mode::Whitted, (&eye, &at), 2).x
        };
        let share = 1.0 - reflectance(i, ior);
        let across = turned.cos();
        assert!((seen(meets) - share * share).abs() < 1e-4, "{ior} {h}: {}, not {}", seen(meets), share * share);
        assert_eq!([seen(meets + 0.012 / across), seen(meets - 0.012 / across)], [0.0; 2], "{ior} {h}");
    }
}

#[test]
fn what_is_partly_there_shows_the_rest_behind() {
    // Opacity a: a of its own light, 1 − a of what is behind; two behind each other multiply.
    let behind = "y=5 { emission: 2, color: black }; sun { from: (0,-3,4), irradiance: 5 }; render { clip: box(-9..9,-3..9,-9..9) }";
    for (a, b) in [(0.0, 0.0), (0.3, 0.0), (1.0, 0.7), (0.3, 0.7)] {
        let matte = |y: u32, opacity: f64| format!("y={y} {{ color: rgb(0.5,0.5,0.5), opacity: {opacity} }}");
        let text = format!("{}; {}; {behind}", matte(0, a), matte(1, b));
        let seen = ray(&text, Mode::Whitted, ("(0,-4,0)", "(0,0,0)"), 8).x;
        // The second is in the first one's half shadow.
        let own = 0.5 * 5.0 * 0.6 / PI;
        let expected = a * own + (1.0 - a) * (b * own * (1.0 - a) + (1.0 - b) * 2.0);
        assert!((seen - expected).abs() < ROUNDING * 4.0, "{a} {b}: {seen}, not {expected}");
    }
}

#[test]
fn metal_of_known_index_mirrors_by_its_index() {
    // At a right angle ((n − 1)² + k²)/((n + 1)² + k²), a colour each.
    let text = "y=0 { n: rgb(0.2,0.9,1.4), k: rgb(3.9,2.4,1.6) }; y=-9 { emission: 1, color: black }; \
                render { clip: box(-9..9,-10..1,-9..9) }";
    let seen = ray(text, Mode::Whitted, ("(0,-4,0)", "(0,0,0)"), 1);
    let share = |n: f64, k: f64| ((n - 1.0).powi(2) + k * k) / ((n + 1.0).powi(2) + k * k);
    let expected = DVec3::new(share(0.2, 3.9), share(0.9, 2.4), share(1.4, 1.6));
    assert!((seen - expected).abs().max_element() < ROUNDING, "{seen}, not {expected}");
}

#[test]
fn metal_and_coats_under_water_are_known_relative_to_water() {
    // Everything is in a medium of index m: at a right angle ((n/m − 1)² + (k/m)²)/((n/m + 1)² + (k/m)²), and a coat of index m is none.
    let around = "y=-9 { emission: 1, color: black }; render { clip: box(-20..20,-10..1,-20..20) }";
    for m in [1.0, 1.33, 1.5f64] {
        let medium = format!("x^2+y^2+z^2=90000 {{ kind: glass, ior: {m}, inside: negative }}");
        let seen = |kind: &str| {
            let text = format!("{medium}; y=0 {{ {kind} }}; {around}");
            ray(&text, Mode::Whitted, ("(0,-4,0)", "(0,0,0)"), 1).x
        };
        let share = |n: f64, k: f64| ((n - m).powi(2) + k * k) / ((n + m).powi(2) + k * k);
        for (kind, expected) in [
            ("n: 0.9, k: 2.4", share(0.9, 2.4)),
            ("n: 2, k: 0", share(2.0, 0.0)),
            ("kind: metal, color: rgb(0.4,0.4,0.4)", 0.4),
            ("kind: plastic, ior: 1.5, color: black", share(1.5, 0.0)),
            ("kind: plastic, ior: 1.33, color: black", if m > 1.33 { 0.0 } else { share(1.33, 0.0) }),
        ] {
            assert!((seen(kind) - expected).abs() < ROUNDING, "{m} {kind}: {}, not {expected}", seen(kind));
        }
    }
}

#[test]
fn light_stays_a_number_however_strong() {
    let text = |kind: &str| {
        format!(
            "x^2+y^2+z^2=1 {{ emission: 1e300 }}; z=-1 {{ {kind} }}; light {{ at: (0,-3,3), power: 1e300 }}; \
                 sun {{ from: (0,-1,1), irradiance: 1e300 }}; render {{ clip: box(-3..3,-3..3,-2..2) }}"
        )
    };
    for kind in ["kind: mirror", "color: white", "kind: plastic", "metal: \"gold\"", "kind: glass", "opacity: 0.5"] {
        for mode in [Mode::Whitted, Mode::Path, Mode::Light, Mode::Bidirectional] {
            let picture = draw(&text(kind), Way { mode, size: (12, 12), samples: 1, ..WAY });
            assert!(picture.pixels.iter().all(|light| light.is_finite()), "{mode:?} {kind}");
        }
    }
}
