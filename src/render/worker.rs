//! One thread with its tracer and its room, and what it does with a tile.
//!
//! In: tiles, one after the other. Out: colours and what the rays know, on the canvas that all threads share.

use super::canvas::{Canvas, Edge, lock};
use super::integrator::{Scratch, Seen, shade};
use super::sampling;
use super::settings::Settings;
use super::tiles::{Job, Tile};
use super::trace::Trace;
use super::watch::Watch;
use crate::scene::Scene;
use crate::surface::{Hit, Ray};
use std::sync::Mutex;

/// About so many rays are traced at once.
const BATCH: usize = 1024;

/// One thread.
pub struct Worker<'a, T> {
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
    /// A thread that is told its job.
    pub fn new(job: &Job<'a, T>) -> Self {
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

    /// Writes down what it did.
    pub fn leave(self) {
        let shade_seconds = (self.watch.seconds() - self.started - self.trace_seconds).max(0.0);
        lock(self.canvas).add_work(&self.tracer.counts(), self.trace_seconds, shade_seconds);
    }

    /// One ray through the middle of every square of the tile.
    pub fn draw_squares(&mut self, tile: Tile, side: u32) {
        self.look(tile.squares(side).map(|square| (square.middle().0, square.middle().1, 0)));
        lock(self.canvas).fill(tile.squares(side), &self.colours);
    }

    /// One ray through the centre of every pixel of the tile.
    pub fn draw_centres(&mut self, tile: Tile) {
        self.look(tile.pixels().map(|(i, j)| (i, j, 0)));
        lock(self.canvas).keep(tile, &self.hits, &self.colours, self.settings.samples);
    }

    /// Adds samples to the tile's edges until those that still differ have as many as the last of `ends`.
    pub fn smooth_edges(&mut self, tile: Tile, ends: &[u32]) {
        let mut edges = lock(self.canvas).take_edges(tile);
        for &end in ends {
            let mut torn: Vec<&mut Edge> = edges.iter_mut().filter(|edge| edge.is_torn && edge.count < end).collect();
            // All edges that are still torn have had the same samples.
            let Some(count) = torn.first().map(|edge| edge.count) else { break };
            let batch = (BATCH / (end - count) as usize).max(1);
            torn.chunks_mut(batch).for_each(|edges| self.add_samples(edges, count..end));
        }
        lock(self.canvas).put_edges(tile, edges);
    }

    /// Takes the samples of these indices in every pixel.
    fn add_samples(&mut self, edges: &mut [&mut Edge], indices: std::ops::Range<u32>) {
        self.look(edges.iter().flat_map(|edge| indices.clone().map(|k| (edge.at.0, edge.at.1, k))));
        for (edge, colours) in edges.iter_mut().zip(self.colours.chunks(indices.len())) {
            if edge.count == 1 {
                let first = edge.sum.map(|light| light as f32);
                edge.is_torn = sampling::is_torn(first, colours);
            }
            for colour in colours {
                for (sum, &light) in edge.sum.iter_mut().zip(colour) {
                    *sum += f64::from(light);
                }
            }
            edge.count = indices.end;
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
