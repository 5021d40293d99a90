//! Three ways of following light, held against each other and against a closed form, closely enough to notice a part of one of them that
//! weighs a few hundredths too much.
//!
//! In: scenes that `path`, `light` and `bidirectional` can all sample. Out: means over pictures, each from several seeds, whose spread says
//! how far a mean may be from the truth.

use super::{Mode, TRANSPORT, WAY, Way, draw};
use std::f64::consts::PI;

/// So many independent pictures make a mean and its error.
const SEEDS: u64 = 10;

/// Means may be apart by so many of their errors: by chance once in a thousand comparisons of twice ten pictures.
const ERRORS: f64 = 4.0;

/// Pixels have single precision: a mean that all seeds agree on is known no better than this share.
const ROUNDING: f64 = 1e-6;

/// A mean over pictures, and its standard error.
#[derive(Clone, Copy, Debug)]
struct Measured {
    mean: f64,
    error: f64,
}

/// The mean light of a scene, all colours alike.
fn measured(text: &str, way: Way) -> Measured {
    let of = |seed| draw(text, Way { seed, ..way }).mean().element_sum() / 3.0;
    let means: Vec<f64> = (1..=SEEDS).map(of).collect();
    let count = SEEDS as f64;
    let mean = means.iter().sum::<f64>() / count;
    let variance = means.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / (count - 1.0);
    Measured { mean, error: (variance / count).sqrt() }
}

/// Fails if two means differ, or are not known well enough for that to mean anything.
fn agree(scene: &str, a: Measured, b: Measured, most_error: f64) {
    let error = (a.error * a.error + b.error * b.error).sqrt();
    assert!(error <= most_error * b.mean, "{scene}: too noisy to tell: {a:?} {b:?}");
    assert!((a.mean - b.mean).abs() <= ERRORS * error + ROUNDING * b.mean, "{scene}: {a:?} is not {b:?}");
}

/// A scene; how many samples `path`, `light`, `bidirectional` take, 0 where the mode does not find all of its light; how many bounces; the greatest error of two means together, as a
/// part of them.
fn compare(scene: &str, samples: [u32; 3], bounces: u32, most_error: f64) {
    let measured =
        |k: usize| measured(scene, Way { mode: TRANSPORT[k], size: (24, 18), samples: samples[k], bounces, ..WAY });
    let both = measured(2);
    for way in (0..2).filter(|&way| samples[way] > 0) {
        agree(scene, measured(way), both, most_error);
    }
}

#[test]
fn a_white_room_is_as_bright_by_all_ways() {
    // Most of this light has been at several walls: the place where joined paths count.
    compare(
        "max(|x|,|y|,|z|) = 2 { color: rgb(0.8,0.8,0.7) }; x^2+(y-0.8)^2+(z+1)^2=0.5 { color: rgb(0.3,0.6,0.8) }; \
         light { at: (0.7,-0.4,0.9), power: 100, radius: 0.4 }; camera { eye: (-1.2,-1.9,0.4), look_at: (0,0.8,-0.6), fov: 60 }",
        [48, 96, 32],
        5,
        0.004,
    );
}

#[test]
fn a_caustic_is_as_bright_by_all_ways() {
    // Only the floor is looked at, where the ball of glass above it throws its light.
    compare(
        "x^2+y^2+z^2=0.5 { kind: glass, absorption: rgb(0.1,0.5,0.9) }; z=-1 { clip: box(-3..3,-3..3,-2..2) }; \
         light { at: (0.4,0.2,2.5), power: 50, radius: 0.8 }; camera { eye: (1.2,-1.6,-0.3), look_at: (-0.05,0,-1), fov: 12 }",
        [256, 256, 48],
        5,
        0.01,
    );
}

#[test]
fn sun_and_sky_are_as_bright_by_all_ways() {
    compare(
        "x^2+y^2+z^2=1 { kind: plastic, color: rgb(0.8,0.4,0.2), roughness: 0.5 }; z=-1 { color: rgb(0.6,0.7,0.8) }; \
         (x-1.4)^2+(y+0.9)^2+(z+0.5)^2=0.2 { metal: \"copper\", roughness: 0.6 }; \
         sun { from: (1,-2,3), irradiance: 2, angle: 12 }; \
         sky { top: rgb(0.6,0.8,1.4), horizon: rgb(0.9,0.7,0.5), ground: rgb(0.1,0.1,0.1) }; \
         render { clip: box(-3..3,-3..3,-1.5..2) }; camera { eye: (4,-5,3), look_at: (0,0,-0.2), fov: 32 }",
        [32, 96, 32],
        4,
        0.006,
    );
}

#[test]
fn surfaces_that_glow_are_as_bright_by_all_ways() {
    compare(
        "(sqrt(x^2+y^2)-1.2)^2+(z-0.3)^2=0.06 { emission: rgb(3,2,1), color: rgb(0.5,0.5,0.5), clip: box(-1.5..1.5,-1.5..1.5,0..0.6) }; \
         x^2+y^2+z^2=0.5; z=-1 { color: rgb(0.7,0.8,0.6), clip: box(-3..3,-3..3,-1.5..0) }; \
         camera { eye: (4,-5,3), look_at: (0,0,-0.4), fov: 34 }",
        [48, 192, 48],
        4,
        0.006,
    );
}

#[test]
fn lights_without_size_are_as_bright_by_all_ways() {
    compare(
        "x^2+y^2+z^2=1 { color: rgb(0.8,0.4,0.2) }; z=-1 { color: rgb(0.6,0.7,0.8) }; y=1.5 { metal: \"iron\", roughness: 0.7 }; \
         sun { from: (1,-2,3), irradiance: 2 }; light { at: (-1.5,-1,0.5), power: 20 }; \
         render { clip: box(-3..3,-3..3,-1.5..2) }; camera { eye: (3,-5,3), look_at: (0,0,-0.2), fov: 32 }",
        [32, 96, 32],
        4,
        0.006,
    );
}

#[test]
fn rough_glass_and_what_is_partly_there_are_as_bright_by_all_ways() {
    compare(
        "x^2+y^2+z^2=0.8 { kind: glass, roughness: 0.6, absorption: rgb(0.2,0.6,1.2) }; z=-1; y=1.2 { opacity: 0.6 }; y=-1.6 { opacity: 0.3 }; \
         light { at: (1.5,-1,2), power: 60, radius: 0.7 }; render { clip: box(-2.5..2.5,-2.5..2.5,-1.5..2) }; \
         camera { eye: (3,-5,2), look_at: (0,0,-0.3), fov: 34 }",
        [64, 128, 48],
        5,
        0.008,
    );
}

#[test]
fn mirrors_glass_and_coats_are_as_bright_by_both_ways_that_see_them() {
    compare(
        "(x+1)^2+y^2+z^2=0.9 { kind: glass, absorption: rgb(0.5,0.1,0.1) }; (x-1)^2+(y-0.8)^2+z^2=0.9 { kind: mirror, color: rgb(0.9,0.8,0.7) }; \
         (x-0.9)^2+(y+1)^2+(z+0.5)^2=0.2 { kind: plastic, color: rgb(0.9,0.2,0.1) }; z=-1; \
         light { at: (1,-2,3), power: 100, radius: 0.8 }; render { clip: box(-3..3,-3..3,-1.5..2) }; \
         camera { eye: (1,-6,3), look_at: (0,0,-0.2), fov: 30 }",
        [96, 0, 48],
        6,
        0.01,
    );
}

#[test]
fn light_in_a_closed_ball_is_a_series_in_all_modes() {
    // Inside a matte ball of radius 2 and albedo a, a lamp of radius r in the middle: every wall has the same irradiance E = P/(4π·4),
    // and of what a wall throws back the lamp, which scatters nothing, takes its share (r/2)². Radiance E·a/π·Σ(a(1 − (r/2)²))^k.
    let (albedo, radius, power) = (0.8, 0.5, 100.0);
    let camera = "camera { eye: (0.9,-0.6,0.5), look_at: (2,-1.8,1.2), fov: 110 }";
    let wall = format!("x^2+y^2+z^2=4 {{ color: rgb({albedo},{albedo},{albedo}) }}");
    let lamp = format!("light {{ at: (0,0,0), power: {power}, radius: {radius} }}");
    // The same lamp as a black surface that glows.
    let radiance = power / (4.0 * PI * PI * radius * radius);
    let glow = format!("x^2+y^2+z^2={} {{ color: black, emission: {radiance} }}", radius * radius);
    // A point hides nothing.
    let point = format!("light {{ at: (0,0,0), power: {power} }}");
    for (lamp, radius) in [(lamp, radius), (glow, radius), (point, 0.0)] {
        for bounces in [1, 4] {
            let kept: f64 = albedo * (1.0 - radius * radius / 4.0);
            let series: f64 = (0..bounces).map(|k| kept.powi(k)).sum();
            let exact = Measured { mean: power / (16.0 * PI) * albedo / PI * series, error: 0.0 };
            for (mode, samples, most_error) in
                [(Mode::Path, 16, 0.002), (Mode::Bidirectional, 24, 0.004), (Mode::Light, 512, 0.01)]
            {
                // One picture by light alone costs as much as all others together, and shows all orders at once.
                if mode == Mode::Light && bounces == 1 {
                    continue;
                }
                let way = Way { mode, size: (16, 12), samples, bounces: bounces as u32, ..WAY };
                let scene = format!("{wall}; {lamp}; {camera}");
                agree(&format!("{mode:?} {bounces} {lamp}"), measured(&scene, way), exact, most_error);
            }
        }
    }
}
