//! One thread that draws tiles.
//!
//! In: a tile. Out: its pixels on the canvas. Separate from the tiles because it owns what a thread needs for itself:
//! a tracer, and room for rays that is used again for every tile.

use super::integrator::{pixel, shade};
use super::sampling::{self, FIRST_SAMPLES};
use super::settings::{Mode, Settings};
use super::studio::blend::Window;
use super::studio::gather::{self, Sample, gather};
use super::studio::glimpse::{Glimpse, Light, Remembered, point};
use super::studio::{self, backdrop};
use super::tiles::{Canvas, Job, TILE, Tile, lock};
use super::trace::Trace;
use super::watch::Watch;
use crate::film::Layer;
use crate::scene::Scene;
use crate::scene::light::Studio;
use crate::surface::{Hit, Ray};
use std::ops::Range;
use std::sync::Mutex;

/// One thread with its tracer and its room.
pub(super) struct Worker<'a, T> {
    scene: &'a Scene,
    settings: &'a Settings,
    watch: &'a dyn Watch,
    canvas: &'a Mutex<Canvas>,
    tracer: T,
    lights: Studio,
    samples: Vec<Sample>,
    rays: Vec<Ray>,
    hits: Vec<Hit>,
    scratch: gather::Scratch,
    gathered: Vec<Light>,
    window: Window,
    colours: Vec<[f32; 3]>,
    trace_seconds: f64,
    started: f64,
}

impl<'a, T: Trace> Worker<'a, T> {
    pub(super) fn new(job: &Job<'a, T>) -> Self {
        let started = job.watch.seconds();
        let tracer = (job.make_tracer)();
        Worker {
            scene: job.scene,
            settings: job.settings,
            watch: job.watch,
            canvas: job.canvas,
            tracer,
            lights: Studio::around(&job.scene.camera),
            samples: Vec::new(),
            rays: Vec::new(),
            hits: Vec::new(),
            scratch: gather::Scratch::default(),
            gathered: Vec::new(),
            window: Window::default(),
            colours: Vec::new(),
            trace_seconds: job.watch.seconds() - started,
            started,
        }
    }

    pub(super) fn leave(self) {
        let mut canvas = lock(self.canvas);
        let report = &mut canvas.drawing.report;
        report.counts.add(&self.tracer.counts());
        report.trace_seconds += self.trace_seconds;
        report.shade_seconds += (self.watch.seconds() - self.started - self.trace_seconds).max(0.0);
    }

    /// Looks through the centre of every pixel of the tile.
    pub(super) fn draw_centres(&mut self, tile: Tile) {
        self.look(tile.pixels().map(|(i, j)| (i, j, 0)));
        if self.settings.mode == Mode::Studio {
            let seen = (&self.samples[..], &self.rays[..], &self.hits[..]);
            gather(self.scene, &self.lights, &mut self.tracer, seen, &mut self.scratch, &mut self.gathered);
        } else {
            shade(self.settings.mode, self.scene, &self.rays, &self.hits, &mut self.colours);
        }
        let remembered = self.rays.iter().zip(&self.hits).zip(&self.gathered);
        let remembered = remembered.map(|((ray, hit), light)| Remembered::new(Glimpse::of(ray, hit), light));
        let mut canvas = lock(self.canvas);
        canvas.keep(tile, &self.hits, self.settings.samples);
        canvas.remember(tile, remembered);
        canvas.colour(tile, &self.colours);
    }

    /// Colours the pixels of the tile by what they and their neighbours remember.
    pub(super) fn light(&mut self, tile: Tile, memory: &Layer<Remembered>) {
        self.window.look(&self.scene.camera, memory, [tile.left, tile.top, tile.width, tile.height]);
        self.aim(tile.pixels().map(|(i, j)| (i, j, 0)));
        self.colours.clear();
        for (k, (i, j)) in tile.pixels().enumerate() {
            let kept = self.window.at(i, j);
            let light = self.shared_light(k, &kept.glimpse).unwrap_or_else(|| kept.light());
            self.colours.push(self.studio_colour(k, &kept.glimpse, &light));
        }
        lock(self.canvas).colour(tile, &self.colours);
    }

    /// Gives every edge pixel of the tile the mean of several samples.
    pub(super) fn smooth_edges(&mut self, tile: Tile, edges: &Layer<bool>, memory: Option<&Layer<Remembered>>) {
        let pixels: Vec<(u32, u32)> = tile.pixels().filter(|&(i, j)| edges.at(i, j)).collect();
        if pixels.is_empty() {
            return;
        }
        if let Some(memory) = memory {
            self.window.look(&self.scene.camera, memory, [tile.left, tile.top, tile.width, tile.height]);
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
    fn add_samples(&mut self, pixels: &[(u32, u32)], indices: Range<u32>, samples: &mut [Vec<[f32; 3]>]) {
        let batch = ((TILE * TILE) as usize / indices.len()).max(1);
        for (pixels, samples) in pixels.chunks(batch).zip(samples.chunks_mut(batch)) {
            self.look(pixels.iter().flat_map(|&(i, j)| indices.clone().map(move |k| (i, j, k))));
            if self.settings.mode == Mode::Studio {
                self.colour_samples();
            } else {
                shade(self.settings.mode, self.scene, &self.rays, &self.hits, &mut self.colours);
            }
            for (samples, colours) in samples.iter_mut().zip(self.colours.chunks(indices.len())) {
                samples.extend_from_slice(colours);
            }
        }
    }

    /// Colours the rays looked at last, by the light of their neighbours, or where there is none by light of their own.
    fn colour_samples(&mut self) {
        let glimpses: Vec<Glimpse> = self.rays.iter().zip(&self.hits).map(|(ray, hit)| Glimpse::of(ray, hit)).collect();
        let shared: Vec<Option<Light>> = glimpses.iter().enumerate().map(|(k, g)| self.shared_light(k, g)).collect();
        let alone: Vec<usize> = (0..shared.len()).filter(|&k| glimpses[k].is_drawn() && shared[k].is_none()).collect();
        let samples: Vec<Sample> = alone.iter().map(|&k| self.samples[k]).collect();
        let rays: Vec<Ray> = alone.iter().map(|&k| self.rays[k]).collect();
        let hits: Vec<Hit> = alone.iter().map(|&k| self.hits[k]).collect();
        let seen = (&samples[..], &rays[..], &hits[..]);
        gather(self.scene, &self.lights, &mut self.tracer, seen, &mut self.scratch, &mut self.gathered);
        let mut own = self.gathered.iter();
        self.colours.clear();
        for (k, glimpse) in glimpses.iter().enumerate() {
            let light = match shared[k] {
                None if glimpse.is_drawn() => own.next().copied().unwrap_or(Light::OPEN),
                shared => shared.unwrap_or(Light::OPEN),
            };
            let colour = self.studio_colour(k, glimpse, &light);
            self.colours.push(colour);
        }
    }

    /// The light that the neighbours of ray k share with it.
    fn shared_light(&self, k: usize, glimpse: &Glimpse) -> Option<Light> {
        if !glimpse.is_drawn() {
            return None;
        }
        self.window.light(place(self.samples[k]), point(&self.rays[k], glimpse), glimpse, self.footprint(glimpse))
    }

    fn footprint(&self, glimpse: &Glimpse) -> f64 {
        self.scene.camera.footprint(self.settings.size.height(), f64::from(glimpse.t))
    }

    /// What ray k sees.
    fn studio_colour(&self, k: usize, glimpse: &Glimpse, light: &Light) -> [f32; 3] {
        if !glimpse.is_drawn() {
            let (i, j, _) = self.samples[k];
            let [across, down] = place(self.samples[k]);
            let half = f64::from(self.settings.size.height()) / 2.0;
            let aspect = f64::from(self.settings.size.width()) / f64::from(self.settings.size.height());
            return pixel(backdrop::backdrop([across / half - aspect, down / half - 1.0], (i, j)));
        }
        pixel(studio::colour(self.scene, &self.lights, &self.rays[k], glimpse, light, self.footprint(glimpse)))
    }

    /// Traces the sample k of pixel (i, j) for all (i, j, k), into `rays` and `hits`.
    fn look(&mut self, samples: impl Iterator<Item = Sample>) {
        self.aim(samples);
        let started = self.watch.seconds();
        self.tracer.trace(&self.rays, &mut self.hits);
        self.trace_seconds += self.watch.seconds() - started;
    }

    /// The rays of samples, into `rays`.
    fn aim(&mut self, samples: impl Iterator<Item = Sample>) {
        let (width, height) = (self.settings.size.width(), self.settings.size.height());
        self.samples.clear();
        self.samples.extend(samples);
        self.rays.clear();
        let rays = self.samples.iter().map(|&sample| {
            let [across, down] = place(sample);
            self.scene.camera.ray(width, height, across, down)
        });
        self.rays.extend(rays);
    }
}

/// Where a sample is in the picture, in pixels from its upper left corner.
fn place((i, j, k): Sample) -> [f64; 2] {
    let (across, down) = sampling::offset(k);
    [f64::from(i) + across, f64::from(j) + down]
}
