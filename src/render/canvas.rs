//! What all threads draw on.
//!
//! In: what the rays of a tile know, and what further samples add. Out: the drawing, whole after every pass.

use super::exposure::Exposure;
use super::knowledge::{Knowledge, edges};
use super::sampling;
use super::settings::{Mode, Settings};
use super::studio::glimpse::Remembered;
use super::tiles::{Drawing, Pass, Report, Tile};
use crate::film::{Layer, Size};
use crate::surface::{Counts, Hit, Rectangle};
use std::sync::{Mutex, MutexGuard};

/// What all threads write to, under one lock that is held for a copy at a time.
pub struct Canvas {
    /// The drawing so far.
    pub drawing: Drawing,
    known: Layer<Knowledge>,
    /// What mode `studio` keeps for neighbours.
    pub memory: Option<Layer<Remembered>>,
    /// The colours of the squares that the last pass left, while the next draws over them.
    squares: Option<Squares>,
    /// By tile, the pixels that get more samples.
    edges: Vec<Vec<Edge>>,
    /// Of the modes that follow light, the samples so far.
    pub exposure: Option<Exposure>,
}

/// What a coarse pass drew, one value a square.
struct Squares {
    colours: Layer<[f32; 3]>,
    alpha: Option<Layer<f32>>,
}

/// A pixel that gets more samples than one.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    /// Which pixel.
    pub at: (u32, u32),
    /// Its samples, added up.
    pub sum: [f64; 3],
    /// How many there are.
    pub count: u32,
    /// How many of them met a surface, where that is asked for.
    pub covered: u32,
    /// Whether they still differ.
    pub is_torn: bool,
}

impl Canvas {
    /// An empty one.
    pub fn new(settings: &Settings) -> Self {
        let size = settings.size;
        let known_size = if settings.samples > 1 { size } else { Size::new(1, 1).unwrap_or_default() };
        Canvas {
            drawing: Drawing {
                picture: Layer::filled(size, [0.0; 3]),
                alpha: settings.background.keeps_alpha().then(|| Layer::filled(size, 0.0)),
                depth: settings.keep_depth.then(|| Layer::filled(size, f32::INFINITY)),
                normals: settings.keep_normals.then(|| Layer::filled(size, [f32::NAN; 3])),
                report: Report::default(),
                pass: Pass::Last,
            },
            known: Layer::filled(known_size, Knowledge::MISS),
            memory: (settings.mode == Mode::Studio).then(|| Layer::filled(size, Remembered::NONE)),
            squares: None,
            edges: Vec::new(),
            exposure: settings.mode.is_transport().then(|| Exposure::new(size, settings.mode != Mode::Path)),
        }
    }

    /// Keeps what the rays through the centres of a tile's pixels know.
    pub fn keep(&mut self, tile: Tile, hits: &[Hit], samples: u32) {
        let seen = || tile.pixels().zip(hits);
        if let Some(depth) = &mut self.drawing.depth {
            seen().for_each(|((i, j), hit)| depth.set(i, j, hit.t as f32));
        }
        if let Some(alpha) = &mut self.drawing.alpha {
            seen().for_each(|((i, j), hit)| alpha.set(i, j, f32::from(u8::from(hit.is_drawn()))));
        }
        if let Some(normals) = &mut self.drawing.normals {
            seen().for_each(|((i, j), hit)| normals.set(i, j, hit.normal.as_vec3().to_array()));
        }
        if samples > 1 {
            seen().for_each(|((i, j), hit)| self.known.set(i, j, Knowledge::of(hit)));
        }
        hits.iter().for_each(|hit| self.drawing.report.count(hit));
    }

    /// Keeps what neighbours want to know of the tile's pixels.
    pub fn keep_memory(&mut self, tile: Tile, remembered: impl Iterator<Item = Remembered>) {
        if let Some(memory) = &mut self.memory {
            tile.pixels().zip(remembered).for_each(|((i, j), kept)| memory.set(i, j, kept));
        }
    }

    /// Gives the pixels of a tile their colours.
    pub fn colour(&mut self, tile: Tile, colours: &[[f32; 3]]) {
        let Rectangle { left, top, width, .. } = tile.rectangle();
        for (j, row) in (top..).zip(colours.chunks(width as usize)) {
            self.drawing.picture.set_row(left, j, row);
        }
    }

    /// Fills squares with the colours of what their rays hit.
    pub fn fill(&mut self, squares: impl Iterator<Item = Tile>, hits: &[Hit], colours: &[[f32; 3]]) {
        for ((square, hit), &colour) in squares.zip(hits).zip(colours) {
            square.pixels().for_each(|(i, j)| self.drawing.picture.set(i, j, colour));
            if let Some(alpha) = &mut self.drawing.alpha {
                square.pixels().for_each(|(i, j)| alpha.set(i, j, f32::from(u8::from(hit.is_drawn()))));
            }
        }
    }

    /// The pixels of a tile that get more samples; taken away until they are put back.
    pub fn take_edges(&mut self, tile: Tile) -> Vec<Edge> {
        std::mem::take(&mut self.edges[tile.index])
    }

    /// Puts them back.
    pub fn put_edges(&mut self, tile: Tile, edges: Vec<Edge>) {
        self.edges[tile.index] = edges;
    }

    /// Remembers a picture of squares of this side, for the case that the next pass is not finished.
    pub fn remember(&mut self, side: u32) {
        let size = self.drawing.picture.size;
        let Ok(count) = Size::new(size.width().div_ceil(side).into(), size.height().div_ceil(side).into()) else {
            return;
        };
        let corners =
            || (0..count.width() * count.height()).map(|k| (k % count.width() * side, k / count.width() * side));
        let values = corners().map(|(i, j)| self.drawing.picture.at(i, j)).collect();
        let of_alpha =
            |alpha: &Layer<f32>| Layer { size: count, values: corners().map(|(i, j)| alpha.at(i, j)).collect() };
        let alpha = self.drawing.alpha.as_ref().map(of_alpha);
        self.squares = Some(Squares { colours: Layer { size: count, values }, alpha });
    }

    /// The next pass is finished.
    pub fn forget(&mut self) {
        self.squares = None;
    }

    /// The drawing as the last whole pass left it.
    pub fn into_drawing(mut self) -> Drawing {
        if let (Some(squares), Pass::Squares(side)) = (&self.squares, self.drawing.pass) {
            let size = self.drawing.picture.size;
            for (i, j) in (0..size.height()).flat_map(|j| (0..size.width()).map(move |i| (i, j))) {
                self.drawing.picture.set(i, j, squares.colours.at(i / side, j / side));
                if let (Some(alpha), Some(squares)) = (&mut self.drawing.alpha, &squares.alpha) {
                    alpha.set(i, j, squares.at(i / side, j / side));
                }
            }
        }
        self.drawing
    }

    /// Puts the means of so many samples of light into the picture.
    pub fn show_light(&mut self, samples: u32) {
        let Some(exposure) = &self.exposure else { return };
        for (k, exposed) in exposure.develop(samples).enumerate() {
            self.drawing.picture.values[k] = exposed.light;
            if let Some(alpha) = &mut self.drawing.alpha {
                alpha.values[k] = exposed.alpha;
            }
        }
    }

    /// Adds what a thread did to the report.
    pub fn add_work(&mut self, counts: &Counts, trace_seconds: f64, shade_seconds: f64) {
        let report = &mut self.drawing.report;
        report.counts.add(counts);
        report.trace_seconds += trace_seconds;
        report.shade_seconds += shade_seconds;
    }

    /// Finds the pixels that get more samples; the ray through its centre is the first of each.
    pub fn find_edges(&mut self, tiles: &[Tile]) {
        let picture = &self.drawing.picture;
        let is_edge = edges(picture, &self.known);
        let alpha = self.drawing.alpha.as_ref();
        let first = |at: (u32, u32)| Edge {
            at,
            sum: picture.at(at.0, at.1).map(f64::from),
            count: 1,
            covered: u32::from(alpha.is_some_and(|alpha| alpha.at(at.0, at.1) > 0.0)),
            is_torn: true,
        };
        let of_tile = |tile: &Tile| tile.pixels().filter(|&(i, j)| is_edge.at(i, j)).map(first).collect();
        self.edges = tiles.iter().map(of_tile).collect();
    }

    /// Puts the means of all samples into the picture.
    pub fn show_edges(&mut self) {
        for edge in self.edges.iter().flatten() {
            self.drawing.picture.set(edge.at.0, edge.at.1, sampling::mean(edge.sum, edge.count));
            if let Some(alpha) = &mut self.drawing.alpha {
                alpha.set(edge.at.0, edge.at.1, edge.covered as f32 / edge.count as f32);
            }
        }
    }
}

/// The canvas, for the time of a copy.
pub fn lock(canvas: &Mutex<Canvas>) -> MutexGuard<'_, Canvas> {
    canvas.lock().expect("a thread that panics ends the drawing")
}
