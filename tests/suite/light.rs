//! Light whose amount is known: furnaces, closed forms, and ways of finding it that must agree.
//!
//! In: programs. Out: means over pictures of linear light against numbers from outside of the renderer.

mod agreement;
mod bytes;
mod trails;
mod whitted;

use glam::DVec3;
use implicit::film::Size;
use implicit::render::{Mode, Silent};
use implicit::session::{Plan, Program, Wishes};

/// A picture in linear light.
struct Picture {
    pixels: Vec<DVec3>,
}

/// How a picture is drawn.
#[derive(Clone, Copy)]
struct Way {
    mode: Mode,
    size: (u32, u32),
    samples: u32,
    bounces: u32,
    seed: u64,
}

const WAY: Way = Way { mode: Mode::Path, size: (16, 16), samples: 64, bounces: 8, seed: 0 };

/// The modes that must find the same light.
const TRANSPORT: [Mode; 3] = [Mode::Path, Mode::Light, Mode::Bidirectional];

fn draw(text: &str, way: Way) -> Picture {
    let mut program = Program::from_text(text);
    assert!(!program.has_errors(), "{text}: {:?}", program.diagnostics);
    let wishes = Wishes {
        size: Some(Size::new(way.size.0.into(), way.size.1.into()).unwrap()),
        mode: Some(way.mode),
        samples: Some(way.samples),
        bounces: Some(way.bounces),
        seed: Some(way.seed),
        threads: 1,
        simd: implicit::num::level::Simd::best(),
        ..Wishes::default()
    };
    let plan = Plan::new(&mut program, &wishes).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"));
    let drawing = plan.draw(&Silent).unwrap();
    let linear = |pixel: &[f32; 3]| DVec3::from_array(pixel.map(f64::from));
    Picture { pixels: drawing.picture.values.iter().map(linear).collect() }
}

/// The light along one ray: through the only pixel of a picture, from an eye to a point that is looked at.
fn ray(text: &str, mode: Mode, (eye, at): (&str, &str), bounces: u32) -> DVec3 {
    let text = format!("{text}; camera {{ eye: {eye}, look_at: {at} }}");
    draw(&text, Way { mode, size: (1, 1), samples: 1, bounces, seed: 0 }).mean()
}

impl Picture {
    fn mean(&self) -> DVec3 {
        self.pixels.iter().sum::<DVec3>() / self.pixels.len() as f64
    }
}

/// A picture in a uniform sky of radiance 1 whose every pixel sees the unit ball.
fn furnace(material: &str, way: Way) -> DVec3 {
    let text = format!(
        "x^2+y^2+z^2=1 {{ {material} }}; sky {{ radiance: 1 }}; camera {{ eye: (0,-4,0), look_at: (0,0,0), fov: 18 }}"
    );
    draw(&text, way).mean()
}

/// Light is lost at the last of 64 bounces, and by chance in the last paths: less than this share.
const LOST: f64 = 1e-3;

fn vanishes(material: &str, samples: u32, bound: f64) {
    let mean = furnace(material, Way { bounces: 64, samples, ..WAY });
    assert!((mean - 1.0).abs().max_element() < bound + LOST, "{material}: {mean}");
}

#[test]
fn white_balls_vanish_in_a_furnace() {
    // How far from 1 a mean may be: noise, and for lobes of rough facets the 1 % that their tables keep.
    vanishes("color: rgb(1,1,1)", 32, 5e-3);
    vanishes("kind: mirror, color: rgb(1,1,1)", 32, 1e-6);
    vanishes("kind: glass, ior: 1.5", 32, 1e-6);
    vanishes("kind: glass, ior: 1", 32, 1e-6);
    vanishes("kind: plastic, color: rgb(1,1,1)", 32, 0.01);
    for roughness in ["0.1", "0.3", "0.6", "1"] {
        vanishes(&format!("kind: metal, color: rgb(1,1,1), roughness: {roughness}"), 32, 0.01);
        vanishes(&format!("kind: plastic, color: rgb(1,1,1), roughness: {roughness}"), 32, 0.01);
    }
}

#[test]
fn white_balls_of_rough_glass_vanish_in_a_furnace() {
    // What passes rough facets at grazing angles comes in few, heavy samples; with so many of them a mean deviates by 0.15 % or less.
    for (ior, roughness, samples) in [
        ("1.5", "0.1", 256),
        ("1.5", "0.3", 256),
        ("1.5", "0.6", 2048),
        ("1.5", "1", 2048),
        ("1.33", "0.45", 512),
        ("2.42", "0.45", 512),
        ("1.05", "0.45", 256),
    ] {
        vanishes(&format!("kind: glass, ior: {ior}, roughness: {roughness}"), samples, 0.004);
    }
}

#[test]
fn a_convex_body_of_albedo_a_shows_a() {
    for mode in [Mode::Path, Mode::Bidirectional] {
        let mean = furnace("color: rgb(0.25, 0.5, 0.75)", Way { mode, samples: 16, ..WAY });
        assert!((mean - DVec3::new(0.25, 0.5, 0.75)).abs().max_element() < 0.005, "{mean}");
    }
    // What is seen by the mode of lights alone has its noise.
    let mean = furnace("color: rgb(0.25, 0.5, 0.75)", Way { mode: Mode::Light, samples: 256, ..WAY });
    assert!((mean - DVec3::new(0.25, 0.5, 0.75)).abs().max_element() < 0.02, "{mean}");
}

#[test]
fn inside_a_glowing_ball_light_is_a_truncated_series() {
    // Emission 1 and albedo a everywhere: 1 + a + a² + … + aⁿ after n events, from any place inside.
    let text =
        "x^2+y^2+z^2=1 { color: rgb(0.5,0.8,0.2), emission: 1 }; camera { eye: (0.3,0.2,0.1), look_at: (1,0,0) }";
    for (mode, bounces) in [(Mode::Path, 0), (Mode::Path, 1), (Mode::Path, 5), (Mode::Bidirectional, 3)] {
        let mean = draw(text, Way { mode, bounces, samples: 64, ..WAY }).mean();
        let series = |a: f64| (0..=bounces).map(|_| ()).fold((0.0, 1.0), |(sum, term), ()| (sum + term, term * a)).0;
        let expected = DVec3::new(series(0.5), series(0.8), series(0.2));
        assert!((mean / expected - 1.0).abs().max_element() < 0.005, "{bounces}: {mean}, not {expected}");
    }
}

/// The radiance of a matte floor of albedo 0.5 at the origin.
fn floor(lights: &str, way: Way) -> f64 {
    let text = format!(
        "z=0 {{ color: rgb(0.5,0.5,0.5) }}; {lights}; render {{ clip: box(-30..30,-30..30,-1..1) }}; \
         camera {{ eye: (0,-1,2), look_at: (0,0,0), fov: 0.5 }}"
    );
    draw(&text, way).mean().x
}

#[test]
fn lights_give_the_irradiance_of_their_closed_forms() {
    let pi = std::f64::consts::PI;
    // The irradiance on the floor: of a point and of a ball P·cos/(4πd²), of a sun E·cos, of a uniform sky πL, of a gradient
    // 2π∫(h + (t − h)s)s ds.
    let rows = [
        ("light { at: (0,0,3), power: 100 }", 100.0 / (4.0 * pi * 9.0)),
        ("light { at: (0,0,3), power: 100, radius: 0.5 }", 100.0 / (4.0 * pi * 9.0)),
        ("light { at: (3,0,4), power: 100, radius: 2 }", 100.0 * 0.8 / (4.0 * pi * 25.0)),
        ("light { at: (3,0,4), power: 50 }; light { at: (3,0,4), power: 50 }", 100.0 * 0.8 / (4.0 * pi * 25.0)),
        ("sun { from: (0,3,4), irradiance: 5 }", 4.0),
        ("sun { from: (0,3,4), irradiance: 5, angle: 30 }", 4.0),
        ("sky { radiance: 2 }", 2.0 * pi),
        ("sky { top: rgb(3,3,3), horizon: rgb(1,1,1), ground: rgb(9,9,9) }", 2.0 * pi * (0.5 + 2.0 / 3.0)),
    ];
    for (lights, irradiance) in rows {
        for mode in [Mode::Path, Mode::Bidirectional] {
            let seen = floor(lights, Way { mode, samples: 256, bounces: 1, size: (8, 8), ..WAY });
            let expected = 0.5 * irradiance / pi;
            assert!((seen / expected - 1.0).abs() < 0.005, "{lights}: {seen}, not {expected}");
        }
    }
}

#[test]
fn a_ball_of_formula_shines_as_a_ball_of_light() {
    // Radiance P/(4π²r²) of a surface: the same ball.
    let (pi, power, radius) = (std::f64::consts::PI, 100.0, 0.5);
    let radiance = power / (4.0 * pi * pi * radius * radius);
    let glowing = format!("x^2+y^2+(z-3)^2=0.25 {{ emission: {radiance}, color: black, clip: ball(0,0,3,0.6) }}");
    let text = format!(
        "z=0 {{ color: rgb(0.5,0.5,0.5), clip: box(-30..30,-30..30,-1..1) }}; {glowing}; \
         camera {{ eye: (0,-1,2), look_at: (0,0,0), fov: 0.5 }}"
    );
    let expected = 0.5 * power / (4.0 * pi * 9.0) / pi;
    for mode in [Mode::Path, Mode::Bidirectional] {
        let seen = draw(&text, Way { mode, samples: 256, bounces: 1, size: (8, 8), ..WAY }).mean().x;
        assert!((seen / expected - 1.0).abs() < 0.01, "{seen}, not {expected}");
    }
}

#[test]
fn what_glass_reflects_and_lets_through_is_fresnel_s_and_beer_s() {
    // A slab seen at a right angle against a light of its own, n = 1.5: R = 0.04; the series of inner reflections has all orders.
    let slab = |absorption: f64| {
        let text = format!(
            "|y| <= 0.5 {{ kind: glass, ior: 1.5, absorption: {absorption}, clip: box(-9..9,-2..2,-9..9) }}; \
             y = 5 {{ emission: 1, color: black, clip: box(-9..9,4..6,-9..9) }}; \
             camera {{ eye: (0,-4,0), look_at: (0,0,0), fov: 0.2 }}"
        );
        draw(&text, Way { bounces: 64, samples: 1024, size: (8, 8), ..WAY }).mean().x
    };
    for absorption in [0.0, 0.3, 1.0f64] {
        let (r, left) = (0.04, (-absorption).exp());
        let expected = (1.0 - r) * (1.0 - r) * left / (1.0 - r * r * left * left);
        let seen = slab(absorption);
        assert!((seen / expected - 1.0).abs() < 0.005, "{absorption}: {seen}, not {expected}");
    }
}

#[test]
fn a_caustic_is_found_by_light_from_its_source() {
    // A point light behind glass: paths from the camera never find it, those from the light do.
    let text = "x^2+y^2+z^2=0.5 { kind: glass }; z=-1; light { at: (0,0,2), power: 50 }; \
                render { clip: box(-2..2,-2..2,-2..2) }; camera { eye: (0,-3,2), look_at: (0,0,-1), fov: 20 }";
    let way = Way { size: (24, 24), samples: 64, ..WAY };
    let seen = |mode| draw(text, Way { mode, ..way });
    let brightest = |picture: &Picture| picture.pixels.iter().map(|p| p.x).fold(0.0, f64::max);
    let [path, light, both] = [Mode::Path, Mode::Light, Mode::Bidirectional].map(|mode| brightest(&seen(mode)));
    assert!(light > 3.0 * path && both > 3.0 * path, "{path} {light} {both}");
}

#[test]
fn a_closed_box_is_black_inside() {
    // Lit from outside as brightly as can be, the walls 1e-3 thick: not one bit of light comes in.
    let text = "max(|x|,|y|,|z|) <= 1.001 and not max(|x|,|y|,|z|) <= 1; light { at: (0,0,3), power: 1e12, radius: 0.5 }; \
                sun { from: (1,2,3), irradiance: 1e12 }; sky { radiance: 1e12 }; \
                camera { eye: (0.9,-0.9,0.9), look_at: (-0.5,0.6,-0.7), fov: 100 }";
    for mode in TRANSPORT.into_iter().chain([Mode::Whitted]) {
        let picture = draw(text, Way { mode, size: (24, 24), samples: 64, bounces: 16, ..WAY });
        let sky = if mode == Mode::Whitted { continue } else { DVec3::ZERO };
        assert!(picture.pixels.iter().all(|&pixel| pixel == sky), "{mode:?}: {}", picture.mean());
    }
}

#[test]
fn no_interface_is_lost_in_shells() {
    // Shells of glass, each so thin that an offset would tunnel through; all have the index of the air around, so that whatever is
    // missed or met twice shows as a wrong count of events: with exactly enough events light arrives, with one less it does not.
    let shells = "x^2+y^2+z^2 <= 1 and x^2+y^2+z^2 >= 0.998 { kind: glass, ior: 1 }; \
                  x^2+y^2+z^2 <= 0.5 and x^2+y^2+z^2 >= 0.4985 { kind: glass, ior: 1 }";
    let text = format!("{shells}; sky {{ radiance: 1 }}; camera {{ eye: (0,-4,0), look_at: (0,0,0), fov: 10 }}");
    let seen = |bounces| draw(&text, Way { bounces, samples: 4, size: (32, 32), ..WAY }).mean().x;
    assert_eq!(seen(8), 1.0);
    assert_eq!(seen(7), 0.0);
}
