//! The picture in squares, each drawn by one thread.
//!
//! In: a scene, settings, a tracer for every thread. Out: the drawing. A tile is a batch of rays, so that the tracer
//! has many at once; which thread draws a tile changes nothing, because tiles are written to their own places and
//! sums are of whole numbers.

use super::integrator::{Scratch, Seen, shade};
use super::knowledge::{Knowledge, edges};
use super::sampling::{self, FIRST_SAMPLES};
use super::settings::Settings;
use super::trace::Trace;
use super::watch::Watch;
use crate::film::Layer;
use crate::scene::Scene;
use crate::surface::{Counts, Hit, Outcome, Ray};
use std::fmt;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The side of a tile in pixels: 1024 rays fill the tracer's lanes and still fit the nearest caches.
const TILE: u32 = 32;

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
    let passes = if settings.samples > 1 { 2 } else { 1 };
    let job = Job { scene, settings, make_tracer, watch, canvas: &canvas, tiles: &tiles, total: tiles.len() * passes };
    job.run(&|worker, tile| worker.draw_centres(tile), 0)?;
    if settings.samples > 1 {
        let edges = {
            let canvas = lock(&canvas);
            edges(&canvas.drawing.picture, &canvas.known)
        };
        job.run(&|worker, tile| worker.smooth_edges(tile, &edges), tiles.len())?;
    }
    Ok(canvas.into_inner().expect("a thread that panics ends the drawing").drawing)
}

#[derive(Clone, Copy, Debug)]
struct Tile {
    left: u32,
    top: u32,
    width: u32,
    height: u32,
}

impl Tile {
    fn pixels(self) -> impl Iterator<Item = (u32, u32)> {
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
struct Canvas {
    drawing: Drawing,
    known: Layer<Knowledge>,
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
        }
    }

    fn keep(&mut self, tile: Tile, hits: &[Hit], colours: &[[f32; 3]], samples: u32) {
        for (((i, j), hit), &colour) in tile.pixels().zip(hits).zip(colours) {
            self.drawing.picture.set(i, j, colour);
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

fn lock<'a>(canvas: &'a Mutex<Canvas>) -> std::sync::MutexGuard<'a, Canvas> {
    canvas.lock().expect("a thread that panics ends the drawing")
}

/// What every thread is told.
struct Job<'a, T> {
    scene: &'a Scene,
    settings: &'a Settings,
    make_tracer: &'a (dyn Fn() -> T + Sync),
    watch: &'a dyn Watch,
    canvas: &'a Mutex<Canvas>,
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

/// One thread with its tracer and its room.
struct Worker<'a, T> {
    scene: &'a Scene,
    settings: &'a Settings,
    watch: &'a dyn Watch,
    canvas: &'a Mutex<Canvas>,
    tracer: T,
    rays: Vec<Ray>,
    heights: Vec<f64>,
    hits: Vec<Hit>,
    scratch: Scratch,
    colours: Vec<[f32; 3]>,
    trace_seconds: f64,
    started: f64,
}

impl<'a, T: Trace> Worker<'a, T> {
    fn new(job: &Job<'a, T>) -> Self {
        let started = job.watch.seconds();
        let tracer = (job.make_tracer)();
        Worker {
            scene: job.scene,
            settings: job.settings,
            watch: job.watch,
            canvas: job.canvas,
            tracer,
            rays: Vec::new(),
            heights: Vec::new(),
            hits: Vec::new(),
            scratch: Scratch::default(),
            colours: Vec::new(),
            trace_seconds: job.watch.seconds() - started,
            started,
        }
    }

    fn leave(self) {
        let mut canvas = lock(self.canvas);
        let report = &mut canvas.drawing.report;
        report.counts.add(&self.tracer.counts());
        report.trace_seconds += self.trace_seconds;
        report.shade_seconds += (self.watch.seconds() - self.started - self.trace_seconds).max(0.0);
    }

    fn draw_centres(&mut self, tile: Tile) {
        self.look(tile.pixels().map(|(i, j)| (i, j, 0)));
        lock(self.canvas).keep(tile, &self.hits, &self.colours, self.settings.samples);
    }

    /// Gives every edge pixel of the tile the mean of several samples.
    fn smooth_edges(&mut self, tile: Tile, edges: &Layer<bool>) {
        let pixels: Vec<(u32, u32)> = tile.pixels().filter(|&(i, j)| edges.at(i, j)).collect();
        if pixels.is_empty() {
            return;
        }
        let all = self.settings.samples;
        let first = FIRST_SAMPLES.min(all);
        let mut samples: Vec<Vec<[f32; 3]>> = vec![Vec::new(); pixels.len()];
        self.add_samples(&pixels, 0..first, &mut samples);
        let torn: Vec<usize> = (0..pixels.len()).filter(|&k| sampling::is_torn(&samples[k])).collect();
        if first < all && !torn.is_empty() {
            let torn_pixels: Vec<(u32, u32)> = torn.iter().map(|&k| pixels[k]).collect();
            let mut more = vec![Vec::new(); torn.len()];
            self.add_samples(&torn_pixels, first..all, &mut more);
            for (k, more) in torn.into_iter().zip(more) {
                samples[k].extend(more);
            }
        }
        let mut canvas = lock(self.canvas);
        for (&(i, j), samples) in pixels.iter().zip(&samples) {
            canvas.drawing.picture.set(i, j, sampling::mean(samples));
        }
    }

    /// Takes the samples of these indices in every pixel, a batch of about a tile's rays at a time.
    fn add_samples(&mut self, pixels: &[(u32, u32)], indices: std::ops::Range<u32>, samples: &mut [Vec<[f32; 3]>]) {
        let batch = ((TILE * TILE) as usize / indices.len()).max(1);
        for (pixels, samples) in pixels.chunks(batch).zip(samples.chunks_mut(batch)) {
            self.look(pixels.iter().flat_map(|&(i, j)| indices.clone().map(move |k| (i, j, k))));
            for (samples, colours) in samples.iter_mut().zip(self.colours.chunks(indices.len())) {
                samples.extend_from_slice(colours);
            }
        }
    }

    /// Traces and shades the sample k of pixel (i, j) for all (i, j, k), into `hits` and `colours`.
    fn look(&mut self, samples: impl Iterator<Item = (u32, u32, u32)>) {
        let (width, height) = (self.settings.size.width(), self.settings.size.height());
        self.rays.clear();
        self.heights.clear();
        for (i, j, k) in samples {
            let (across, down) = sampling::offset(k);
            let down = f64::from(j) + down;
            self.rays.push(self.scene.camera.ray(width, height, f64::from(i) + across, down));
            self.heights.push(down / f64::from(height));
        }
        let started = self.watch.seconds();
        self.tracer.trace(&self.rays, &mut self.hits);
        self.trace_seconds += self.watch.seconds() - started;
        let seen = Seen { rays: &self.rays, hits: &self.hits, heights: &self.heights };
        shade(self.settings.mode, self.scene, &mut self.tracer, seen, &mut self.scratch, &mut self.colours);
    }
}

#[cfg(test)]
mod tests;
