//! The picture in squares, each drawn by one thread.
//!
//! In: a scene, settings, a tracer for every thread. Out: the drawing. A tile is a batch of rays, so that the tracer
//! has many at once; which thread draws a tile changes nothing, because tiles are written to their own places and
//! sums are of whole numbers.

use super::knowledge::{Knowledge, edges};
use super::settings::{Mode, Settings};
use super::studio::glimpse::Remembered;
use super::trace::Trace;
use super::watch::Watch;
use super::worker::Worker;
use crate::film::Layer;
use crate::scene::Scene;
use crate::surface::{Counts, Hit, Outcome};
use std::fmt;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The side of a tile in pixels: 1024 rays fill the tracer's lanes and still fit the nearest caches.
pub(super) const TILE: u32 = 32;

/// The stack of a drawing thread in bytes: as large as a main thread's usually is.
const STACK: usize = 8 << 20;

/// What was drawn.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Colours: linear light, or data as it is to be shown, by the mode.
    pub picture: Layer<[f32; 3]>,
    /// Distance to the first root on the ray through each pixel's centre, +∞ where there is none; if it was asked for.
    pub depth: Option<Layer<f32>>,
    /// The unit normal there, NaN where there is none; if it was asked for.
    pub normals: Option<Layer<[f32; 3]>>,
    /// What is known of the centre rays, and what it took.
    pub report: Report,
}

/// Numbers about a drawing; the first five of the rays through pixel centres only.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report {
    /// Hits.
    pub hits: u64,
    /// Misses.
    pub misses: u64,
    /// Touches.
    pub touch: u64,
    /// Undecided.
    pub undecided: u64,
    /// Hits and misses that are proven.
    pub proven: u64,
    /// The work of all rays.
    pub counts: Counts,
    /// Seconds of tracing, summed over threads.
    pub trace_seconds: f64,
    /// Seconds of everything else, summed over threads.
    pub shade_seconds: f64,
}

/// Why there is no drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Failure {
    /// The watch said so.
    Cancelled,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Cancelled => f.write_str("drawing was cancelled"),
        }
    }
}

impl std::error::Error for Failure {}

/// Draws the scene; `make_tracer` is called once a thread.
///
/// # Errors
/// If the watch cancels.
pub fn draw<T: Trace>(
    scene: &Scene,
    settings: &Settings,
    make_tracer: &(dyn Fn() -> T + Sync),
    watch: &dyn Watch,
) -> Result<Drawing, Failure> {
    let canvas = Mutex::new(Canvas::new(settings));
    let tiles = tiles_of(settings);
    let (is_studio, is_smoothed) = (settings.mode == Mode::Studio, settings.samples > 1);
    let passes = 1 + usize::from(is_studio) + usize::from(is_smoothed);
    let job = Job { scene, settings, make_tracer, watch, canvas: &canvas, tiles: &tiles, total: tiles.len() * passes };
    job.run(&|worker, tile| worker.draw_centres(tile), 0)?;
    let memory = lock(&canvas).memory.take();
    if let Some(memory) = &memory {
        job.run(&|worker, tile| worker.light(tile, memory), tiles.len())?;
    }
    if is_smoothed {
        let edges = {
            let canvas = lock(&canvas);
            edges(&canvas.drawing.picture, &canvas.known)
        };
        job.run(&|worker, tile| worker.smooth_edges(tile, &edges, memory.as_ref()), tiles.len() * (passes - 1))?;
    }
    Ok(canvas.into_inner().expect("a thread that panics ends the drawing").drawing)
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Tile {
    pub left: u32,
    pub top: u32,
    pub width: u32,
    pub height: u32,
}

impl Tile {
    pub(super) fn pixels(self) -> impl Iterator<Item = (u32, u32)> {
        (self.top..self.top + self.height).flat_map(move |j| (self.left..self.left + self.width).map(move |i| (i, j)))
    }
}

fn tiles_of(settings: &Settings) -> Vec<Tile> {
    let (width, height) = (settings.size.width(), settings.size.height());
    let starts = |length: u32| (0..length).step_by(TILE as usize);
    let row = |top: u32| {
        starts(width).map(move |left| Tile { left, top, width: TILE.min(width - left), height: TILE.min(height - top) })
    };
    starts(height).flat_map(row).collect()
}

/// What all threads write to, under one lock that is held for a copy at a time.
pub(super) struct Canvas {
    pub drawing: Drawing,
    known: Layer<Knowledge>,
    /// What mode `studio` keeps for neighbours.
    memory: Option<Layer<Remembered>>,
}

impl Canvas {
    fn new(settings: &Settings) -> Self {
        let size = settings.size;
        let known_size = if settings.samples > 1 { size } else { crate::film::Size::new(1, 1).unwrap_or_default() };
        Canvas {
            drawing: Drawing {
                picture: Layer::filled(size, [0.0; 3]),
                depth: settings.keep_depth.then(|| Layer::filled(size, f32::INFINITY)),
                normals: settings.keep_normals.then(|| Layer::filled(size, [f32::NAN; 3])),
                report: Report::default(),
            },
            known: Layer::filled(known_size, Knowledge::MISS),
            memory: (settings.mode == Mode::Studio).then(|| Layer::filled(size, Remembered::NONE)),
        }
    }

    /// Keeps what the centre rays know.
    pub(super) fn keep(&mut self, tile: Tile, hits: &[Hit], samples: u32) {
        for ((i, j), hit) in tile.pixels().zip(hits) {
            if let Some(depth) = &mut self.drawing.depth {
                depth.set(i, j, hit.t as f32);
            }
            if let Some(normals) = &mut self.drawing.normals {
                normals.set(i, j, hit.normal.as_vec3().to_array());
            }
            if samples > 1 {
                self.known.set(i, j, Knowledge::of(hit));
            }
            self.drawing.report.count(hit);
        }
    }

    /// Keeps it for neighbours.
    pub(super) fn remember(&mut self, tile: Tile, remembered: impl Iterator<Item = Remembered>) {
        if let Some(memory) = &mut self.memory {
            tile.pixels().zip(remembered).for_each(|((i, j), kept)| memory.set(i, j, kept));
        }
    }

    /// Gives the pixels of a tile their colours.
    pub(super) fn colour(&mut self, tile: Tile, colours: &[[f32; 3]]) {
        tile.pixels().zip(colours).for_each(|((i, j), &colour)| self.drawing.picture.set(i, j, colour));
    }
}

impl Report {
    fn count(&mut self, hit: &Hit) {
        match hit.outcome {
            Outcome::Miss => self.misses += 1,
            Outcome::Hit => self.hits += 1,
            Outcome::Touch => self.touch += 1,
            Outcome::Undecided => self.undecided += 1,
        }
        self.proven += u64::from(hit.proven);
    }
}

pub(super) fn lock<'a>(canvas: &'a Mutex<Canvas>) -> std::sync::MutexGuard<'a, Canvas> {
    canvas.lock().expect("a thread that panics ends the drawing")
}

/// What every thread is told.
pub(super) struct Job<'a, T> {
    pub scene: &'a Scene,
    pub settings: &'a Settings,
    pub make_tracer: &'a (dyn Fn() -> T + Sync),
    pub watch: &'a dyn Watch,
    pub canvas: &'a Mutex<Canvas>,
    tiles: &'a [Tile],
    total: usize,
}

impl<'a, T: Trace> Job<'a, T> {
    /// Lets every thread take the next tile until none is left.
    fn run(&self, paint: &(dyn Fn(&mut Worker<'a, T>, Tile) + Sync), done_before: usize) -> Result<(), Failure> {
        let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(done_before));
        let work = || {
            let mut worker = Worker::new(self);
            while let Some(&tile) = self.tiles.get(next.fetch_add(1, Ordering::Relaxed)) {
                if self.watch.is_cancelled() {
                    break;
                }
                paint(&mut worker, tile);
                self.watch.advanced(done.fetch_add(1, Ordering::Relaxed) + 1, self.total);
            }
            worker.leave();
        };
        let threads = self.settings.threads.clamp(1, self.tiles.len());
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build();
        match pool {
            Ok(pool) if threads > 1 => {
                pool.broadcast(|_| work());
            }
            // One thread needs no others; and where the system gives none, one draws the same picture.
            _ => work(),
        }
        if self.watch.is_cancelled() { Err(Failure::Cancelled) } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests;
