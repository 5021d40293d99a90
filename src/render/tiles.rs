//! The picture in squares, each drawn by one thread, and in passes.
//!
//! In: a scene, settings, a tracer for every thread. Out: the drawing. A tile is a batch of rays, so that the tracer
//! has many at once; which thread draws a tile changes nothing, because tiles are written to their own places and
//! sums are of whole numbers. After every pass the drawing is whole: what the next one adds is put into the picture
//! when that pass is done.

use super::canvas::{Canvas, lock};
use super::sampling::FIRST_SAMPLES;
use super::settings::{Mode, Passes, Settings};
use super::trace::Trace;
use super::transport::estimate::Illumination;
use super::watch::Watch;
use super::worker::Worker;
use crate::film::{Layer, Size};
use crate::scene::Scene;
use crate::surface::{Counts, Hit, Outcome, Rectangle};
use std::fmt;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// The side of a tile in pixels: as many rays as fill the tracer's lanes with squares of them and still fit a core's caches.
const TILE: u32 = 64;

/// The stack of a drawing thread in bytes: as large as a main thread's usually is.
const STACK: usize = 8 << 20;

/// The sides of the squares in the coarse passes: 1/256 and 1/16 of the rays of a pass with one ray a pixel.
const SQUARES: [u32; 2] = [16, 4];

/// The samples a pixel at the ends of the passes after the first; each further one has four times as many.
const STEPS: [u32; 2] = [FIRST_SAMPLES, 16];

/// What was drawn.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Colours: linear light, or data as it is to be shown, by the mode.
    pub picture: Layer<[f32; 3]>,
    /// The share of each pixel that surfaces cover, where that is asked for; the picture's light is that of this share.
    pub alpha: Option<Layer<f32>>,
    /// Distance to the first root on the ray through each pixel's centre, +∞ where there is none; if it was asked for.
    pub depth: Option<Layer<f32>>,
    /// The unit normal there, NaN where there is none; if it was asked for.
    pub normals: Option<Layer<[f32; 3]>>,
    /// What is known of the centre rays, and what it took.
    pub report: Report,
    /// The last pass that is in it.
    pub pass: Pass,
}

/// How far a drawing has come.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pass {
    /// Squares of so many pixels a side have one ray each.
    Squares(u32),
    /// Pixels have at most so many samples, and would get more.
    Samples(u32),
    /// All is drawn.
    #[default]
    Last,
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
    /// The watch said so before a pass was whole.
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

/// Draws the scene; `make_tracer` is called once a thread and pass. When the watch cancels, the drawing is as the last
/// whole pass left it.
///
/// # Errors
/// If the watch cancels before a pass is whole.
pub fn draw<T: Trace>(
    scene: &Scene,
    settings: &Settings,
    make_tracer: &(dyn Fn() -> T + Sync),
    watch: &dyn Watch,
) -> Result<Drawing, Failure> {
    let canvas = Mutex::new(Canvas::new(settings));
    let illumination =
        (settings.mode.is_transport() || settings.mode == Mode::Whitted).then(|| Illumination::new(scene));
    let illumination = illumination.as_ref();
    let job = Job { scene, settings, make_tracer, watch, canvas: &canvas, illumination, total: pieces(settings) };
    let end = job.all_passes();
    let mut drawing = canvas.into_inner().expect("a thread that panics ends the drawing").into_drawing();
    match end {
        Ok(()) => drawing.pass = Pass::Last,
        Err(Stopped { has_drawn: false }) => return Err(Failure::Cancelled),
        Err(Stopped { has_drawn: true }) => {}
    }
    Ok(drawing)
}

/// The watch cancelled; whether a pass had been whole by then.
struct Stopped {
    has_drawn: bool,
}

/// A square of the picture, all of which one thread draws at once.
#[derive(Clone, Copy, Debug)]
pub struct Tile {
    /// Which of the tiles it is.
    pub index: usize,
    left: u32,
    top: u32,
    width: u32,
    height: u32,
}

impl Tile {
    /// Its pixels, row by row.
    pub fn pixels(self) -> impl Iterator<Item = (u32, u32)> {
        (self.top..self.top + self.height).flat_map(move |j| (self.left..self.left + self.width).map(move |i| (i, j)))
    }

    /// The tile in squares of `side` pixels, those at its ends smaller.
    pub fn squares(self, side: u32) -> impl Iterator<Item = Tile> {
        tiles_of(self.width, self.height, side).map(move |square| Tile {
            left: self.left + square.left,
            top: self.top + square.top,
            ..square
        })
    }

    /// Its pixels as the tracer is told them.
    pub fn rectangle(self) -> Rectangle {
        Rectangle { left: self.left, top: self.top, width: self.width, height: self.height }
    }

    /// The pixel in its middle.
    pub fn middle(self) -> (u32, u32) {
        (self.left + self.width / 2, self.top + self.height / 2)
    }
}

fn tiles_of(width: u32, height: u32, side: u32) -> impl Iterator<Item = Tile> {
    let starts = move |length: u32| (0..length).step_by(side as usize);
    let row = move |top: u32| {
        let tile = move |left: u32| Tile {
            index: 0,
            left,
            top,
            width: side.min(width - left),
            height: side.min(height - top),
        };
        starts(width).map(tile)
    };
    starts(height).flat_map(row).enumerate().map(|(index, tile)| Tile { index, ..tile })
}

/// The tiles of a pass whose squares have this side; a tile always has about as many rays.
fn tiles(size: Size, square: u32) -> Vec<Tile> {
    tiles_of(size.width(), size.height(), TILE * square).collect()
}

/// The passes that add samples, each by the numbers of samples a pixel that it goes to, one after the other.
fn sample_passes(settings: &Settings) -> Vec<Vec<u32>> {
    let all = settings.samples;
    if all <= 1 {
        return Vec::new();
    }
    if settings.passes == Passes::Few {
        return vec![vec![FIRST_SAMPLES.min(all), all]];
    }
    let further = std::iter::successors(Some(STEPS[1]), |n| n.checked_mul(4));
    let mut steps: Vec<u32> = std::iter::once(STEPS[0]).chain(further).take_while(|&n| n < all).collect();
    steps.push(all);
    steps.into_iter().map(|n| vec![n]).collect()
}

/// The samples a pixel at the ends of the passes of the modes that follow light.
fn light_passes(settings: &Settings) -> Vec<u32> {
    let all = settings.samples.max(1);
    if settings.passes == Passes::Few {
        return vec![all];
    }
    let mut ends: Vec<u32> = std::iter::successors(Some(1u32), |n| n.checked_mul(2)).take_while(|&n| n < all).collect();
    ends.push(all);
    ends
}

/// How many tiles all passes have together.
fn pieces(settings: &Settings) -> usize {
    let count = tiles(settings.size, 1).len();
    if settings.mode.is_transport() {
        return count * (1 + light_passes(settings).len());
    }
    let squares = coarse(settings).iter().map(|&square| tiles(settings.size, square).len()).sum::<usize>();
    let is_lit_later = settings.mode == Mode::Studio;
    squares + count * (1 + usize::from(is_lit_later) + sample_passes(settings).len())
}

fn coarse(settings: &Settings) -> &'static [u32] {
    if settings.passes == Passes::CoarseFirst && !settings.mode.is_transport() { &SQUARES } else { &[] }
}

impl Report {
    /// Counts what a ray through a pixel's centre met.
    pub fn count(&mut self, hit: &Hit) {
        match hit.outcome {
            Outcome::Miss => self.misses += 1,
            Outcome::Hit => self.hits += 1,
            Outcome::Touch => self.touch += 1,
            Outcome::Undecided => self.undecided += 1,
        }
        self.proven += u64::from(hit.proven);
    }
}

/// What every thread is told.
pub struct Job<'a, T> {
    /// What there is to see.
    pub scene: &'a Scene,
    /// What to draw.
    pub settings: &'a Settings,
    /// Makes the tracer of a thread.
    pub make_tracer: &'a (dyn Fn() -> T + Sync),
    /// Who looks on.
    pub watch: &'a dyn Watch,
    /// Where it is drawn.
    pub canvas: &'a Mutex<Canvas>,
    /// Where light comes from, in the modes that follow it.
    pub illumination: Option<&'a Illumination>,
    total: usize,
}

/// What a thread does with a tile.
type Paint<'p, 'a, T> = &'p (dyn Fn(&mut Worker<'a, T>, Tile) + Sync);

impl<'a, T: Trace> Job<'a, T> {
    fn all_passes(&self) -> Result<(), Stopped> {
        let mut done = 0;
        let mut has_drawn = false;
        let mut pass = |tiles: &[Tile], paint: Paint<'_, 'a, T>, is_whole: bool| {
            self.run(tiles, paint, done).map_err(|()| Stopped { has_drawn })?;
            done += tiles.len();
            has_drawn |= is_whole;
            Ok(())
        };
        for &square in coarse(self.settings) {
            pass(&tiles(self.settings.size, square), &|worker, tile| worker.draw_squares(tile, square), true)?;
            self.passed(Pass::Squares(square));
            lock(self.canvas).remember(square);
        }
        let tiles = tiles(self.settings.size, 1);
        let is_whole = self.settings.mode != Mode::Studio && !self.settings.mode.is_transport();
        pass(&tiles, &|worker, tile| worker.draw_centres(tile), is_whole)?;
        if self.settings.mode.is_transport() {
            let mut start = 0;
            for end in light_passes(self.settings) {
                pass(&tiles, &|worker, tile| worker.shine(tile, start..end), true)?;
                lock(self.canvas).show_light(end);
                if end < self.settings.samples {
                    self.passed(Pass::Samples(end));
                }
                start = end;
            }
            return Ok(());
        }
        let memory = lock(self.canvas).memory.take();
        if let Some(memory) = &memory {
            pass(&tiles, &|worker, tile| worker.light(tile, memory), true)?;
        }
        lock(self.canvas).forget();
        let sample_passes = sample_passes(self.settings);
        if !sample_passes.is_empty() {
            self.passed(Pass::Samples(1));
            lock(self.canvas).find_edges(&tiles);
        }
        for (index, ends) in sample_passes.iter().enumerate() {
            pass(&tiles, &|worker, tile| worker.smooth_edges(tile, ends, memory.as_ref()), true)?;
            lock(self.canvas).show_edges();
            if let (Some(&end), true) = (ends.last(), index + 1 < sample_passes.len()) {
                self.passed(Pass::Samples(end));
            }
        }
        Ok(())
    }

    fn passed(&self, pass: Pass) {
        let mut canvas = lock(self.canvas);
        canvas.drawing.pass = pass;
        self.watch.passed(&canvas.drawing);
    }

    /// Lets every thread take the next tile until none is left.
    fn run(&self, tiles: &[Tile], paint: Paint<'_, 'a, T>, done_before: usize) -> Result<(), ()> {
        let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(done_before));
        let is_stopped = AtomicBool::new(false);
        let work = || {
            let mut worker = Worker::new(self);
            while let Some(&tile) = tiles.get(next.fetch_add(1, Ordering::Relaxed)) {
                if self.watch.is_cancelled() {
                    is_stopped.store(true, Ordering::Relaxed);
                    break;
                }
                paint(&mut worker, tile);
                self.watch.advanced(done.fetch_add(1, Ordering::Relaxed) + 1, self.total);
            }
            worker.leave();
        };
        let threads = self.settings.threads.clamp(1, tiles.len());
        let pool = || rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build();
        match (threads > 1).then(pool) {
            Some(Ok(pool)) => {
                pool.broadcast(|_| work());
            }
            // One thread needs no others; and where the system gives none, one draws the same picture.
            _ => work(),
        }
        if is_stopped.into_inner() { Err(()) } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests;
