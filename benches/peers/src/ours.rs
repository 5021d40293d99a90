//! This tracer: primary visibility and normals, in this process.
//!
//! In: a formula, a clip, a camera. Out: times with what was computed, or the depth of every pixel.

use crate::clock::timed;
use crate::scenes::Clip;
use implicit::diag::Sources;
use implicit::expr::lower::{self, Lowered, lower};
use implicit::num::level::Simd;
use implicit::scene::camera::Camera;
use implicit::surface::{self, Counts, Hit, Kind, Method, Rectangle, Surface, Tracer};

/// Pixels across the squares that are traced one after the other, as the renderer does.
pub const SQUARE: u32 = 64;

/// One picture, measured.
#[derive(Clone, Copy)]
pub struct Run {
    /// Processor seconds, rays included.
    pub seconds: f64,
    pub counts: Counts,
    pub pixels: u64,
    pub hits: u64,
    pub proven: u64,
}

/// The formula as a graph.
pub fn graph(formula: &str) -> Lowered {
    let mut sources = Sources::new();
    sources.add("scene", formula);
    let lowered = lower(&implicit::syntax::parse(&sources.texts()).program, &lower::Settings::default());
    assert!(!lowered.has_errors() && lowered.surfaces.len() == 1, "not one surface: {formula}");
    lowered
}

/// f = 0 inside the clip, compiled.
pub fn surfaces(formula: &str, clip: Clip) -> Vec<Surface> {
    let mut lowered = graph(formula);
    let f = lowered.surfaces[0].f;
    let clip = surface::Clip::shape(clip.shape());
    vec![Surface::new(&mut lowered.graph, f, Kind::Equation, &clip, Simd::best())]
}

/// The rectangles of a picture of `size` × `size` pixels.
pub fn squares(size: u32) -> impl Iterator<Item = Rectangle> {
    let starts = move || (0..size).step_by(SQUARE as usize);
    starts().flat_map(move |top| {
        starts().map(move |left| Rectangle {
            left,
            top,
            width: SQUARE.min(size - left),
            height: SQUARE.min(size - top),
        })
    })
}

/// Traces all pixels once.
pub fn trace(surfaces: &[Surface], camera: &Camera, size: u32) -> Run {
    let mut run = Run { seconds: 0.0, counts: Counts::default(), pixels: u64::from(size).pow(2), hits: 0, proven: 0 };
    let screen = camera.screen(size, size);
    let mut hits = Vec::new();
    let (counts, seconds) = timed(|| {
        let mut tracer = Tracer::new(surfaces, Method::Faithful);
        for square in squares(size) {
            tracer.trace_rectangle(&screen, square, &mut hits);
            run.hits += hits.iter().filter(|hit| hit.is_drawn()).count() as u64;
            run.proven += hits.iter().filter(|hit| hit.proven).count() as u64;
        }
        tracer.counts
    });
    Run { seconds, counts, ..run }
}

/// The distance along every pixel's ray, row by row; ∞ where there is nothing.
pub fn depths(surfaces: &[Surface], camera: &Camera, size: u32) -> Vec<f64> {
    let mut tracer = Tracer::new(surfaces, Method::Faithful);
    let screen = camera.screen(size, size);
    let mut depths = vec![f64::INFINITY; (size * size) as usize];
    let mut hits: Vec<Hit> = Vec::new();
    for square in squares(size) {
        tracer.trace_rectangle(&screen, square, &mut hits);
        for (k, hit) in hits.iter().enumerate() {
            let (i, j) = (square.left + k as u32 % square.width, square.top + k as u32 / square.width);
            depths[(j * size + i) as usize] = hit.t;
        }
    }
    depths
}
