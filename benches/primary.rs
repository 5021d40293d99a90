//! Primary visibility and normals of the scenes of `tests/data/scenes.toml`, one thread, in processor time.
//!
//! `cargo bench --bench primary` draws all at 1024 x 1024; `cargo bench --bench primary -- 512 sphere barth6` some.
//! A row: ns a pixel (median of three runs, processor time of the trace alone, rays included), enclosures a pixel,
//! evaluations of f with gradient a hit, the share of pixels that is settled by squares of the screen, and the share that is proven.
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, clippy::disallowed_methods)]

use glam::DVec3;
use implicit::diag::Sources;
use implicit::expr::lower::{self, lower};
use implicit::num::level::Simd;
use implicit::scene::camera::{Camera, Projection};
use implicit::surface::{Clip, Counts, Kind, Method, Rectangle, Shape, Surface, Tracer};
use rustix::time::{ClockId, clock_gettime};

/// Rays of one batch: a square of pixels, as the renderer gives them.
const TILE: u32 = 64;

/// Runs of each scene; the median counts.
const RUNS: usize = 3;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let size = words.iter().find_map(|word| word.parse().ok()).unwrap_or(1024);
    let wanted = |name: &str| words.iter().all(|word| word.parse::<u32>().is_ok()) || words.iter().any(|w| w == name);
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/scenes.toml");
    let table: toml::Table = std::fs::read_to_string(path).unwrap().parse().unwrap();
    println!(
        "{size} x {size}, one thread\n{:14} {:>9} {:>9} {:>9} {:>9} {:>9}",
        "", "ns/pixel", "cells/px", "f,g/hit", "squares", "proven"
    );
    for scene in table["scene"].as_array().unwrap() {
        if wanted(scene["name"].as_str().unwrap()) {
            measure(scene, size);
        }
    }
}

fn measure(scene: &toml::Value, size: u32) {
    let surfaces = surfaces(scene);
    let eye = scene["eye"].as_array().unwrap().iter().map(|c| c.as_float().unwrap()).collect::<Vec<_>>();
    let camera = Camera::new(DVec3::from_slice(&eye), DVec3::ZERO, Projection::Perspective { fov: 40.0 }).unwrap();
    let mut runs: Vec<_> = (0..RUNS).map(|_| trace(&surfaces, &camera, size)).collect();
    runs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (seconds, counts, hits, proven) = runs[RUNS / 2];
    let pixels = f64::from(size) * f64::from(size);
    println!(
        "{:14} {:>9.0} {:>9.1} {:>9.2} {:>8.2}% {:>8.2}%",
        scene["name"].as_str().unwrap(),
        seconds * 1e9 / pixels,
        counts.cells as f64 / pixels,
        counts.gradients as f64 / hits as f64,
        100.0 * (1.0 - counts.singles as f64 / pixels),
        100.0 * proven as f64 / pixels
    );
}

fn surfaces(scene: &toml::Value) -> Vec<Surface> {
    let mut sources = Sources::new();
    sources.add("scene", scene["formula"].as_str().unwrap());
    let mut lowered = lower(&implicit::syntax::parse(&sources.texts()).program, &lower::Settings::default());
    let shape = match scene["clip"].get("ball") {
        Some(radius) => Shape::Ball { center: DVec3::ZERO, radius: radius.as_float().unwrap() },
        None => {
            let half = DVec3::splat(scene["clip"]["box"].as_float().unwrap());
            Shape::Box { min: -half, max: half }
        }
    };
    let f = lowered.surfaces[0].f;
    vec![Surface::new(&mut lowered.graph, f, Kind::Equation, &Clip::shape(shape), Simd::best())]
}

/// Processor seconds, what was computed, hits and proven pixels of one picture.
fn trace(surfaces: &[Surface], camera: &Camera, size: u32) -> (f64, Counts, u64, u64) {
    let mut tracer = Tracer::new(surfaces, Method::Faithful);
    let screen = camera.screen(size, size);
    let mut hits = Vec::new();
    let (mut drawn, mut proven) = (0, 0);
    let start = processor_seconds();
    for top in (0..size).step_by(TILE as usize) {
        for left in (0..size).step_by(TILE as usize) {
            let rectangle = Rectangle { left, top, width: TILE, height: TILE };
            tracer.trace_rectangle(&screen, rectangle, &mut hits);
            drawn += hits.iter().filter(|hit| hit.is_drawn()).count() as u64;
            proven += hits.iter().filter(|hit| hit.proven).count() as u64;
        }
    }
    (processor_seconds() - start, tracer.counts, drawn, proven)
}

fn processor_seconds() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}
