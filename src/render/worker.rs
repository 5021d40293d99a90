//! One thread with its tracer and its room, and what it does with a tile.
//!
//! In: tiles, one after the other. Out: colours and what the rays know, on the canvas that all threads share.

use super::canvas::{Canvas, Edge, lock};
use super::exposure::TileExposure;
use super::filter::{Filter, Weights};
use super::integrator::{behind, colours_of, pixel, shade};
use super::sampling;
use super::settings::{Background, Mode, Settings};
use super::studio::blend::Window;
use super::studio::gather::{self, Sample, gather};
use super::studio::glimpse::{Glimpse, Light, Remembered, point};
use super::studio::{self, Seen, backdrop};
use super::tiles::{Job, Tile};
use super::trace::Trace;
use super::trails;
use super::transport::estimate::Estimator;
use super::watch::Watch;
use crate::film::Layer;
use crate::scene::Scene;
use crate::scene::studio::Studio;
use crate::surface::{Hit, Ray, Rectangle};
use glam::DVec3;
use std::ops::Range;
use std::sync::Mutex;

/// About so many rays are traced at once.
const BATCH: usize = 1024;

/// About so many paths are followed at once: as many as keep the tracer's lanes full to the last bounce.
const SHINING: usize = 4096;

/// One thread.
pub struct Worker<'a, T> {
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
    estimator: Option<Estimator<'a>>,
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
            lights: Studio::around(&job.scene.camera),
            samples: Vec::new(),
            rays: Vec::new(),
            hits: Vec::new(),
            scratch: gather::Scratch::default(),
            gathered: Vec::new(),
            window: Window::default(),
            estimator: job.illumination.map(|light| Estimator::new(job.scene, job.settings, light)),
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
        self.window = Window::default();
        self.colour();
        lock(self.canvas).fill(tile.squares(side), &self.hits, &self.colours);
    }

    /// One ray through the centre of every pixel of the tile. In mode `studio` they are coloured when all are known.
    pub fn draw_centres(&mut self, tile: Tile) {
        self.samples.clear();
        self.samples.extend(tile.pixels().map(|(i, j)| (i, j, 0)));
        let size = self.settings.size;
        let screen = self.scene.camera.screen(size.width(), size.height());
        let started = self.watch.seconds();
        self.tracer.trace_rectangle(&screen, tile.rectangle(), &mut self.rays, &mut self.hits);
        self.trace_seconds += self.watch.seconds() - started;
        if self.settings.mode == Mode::Studio {
            let seen = (&self.samples[..], &self.rays[..], &self.hits[..]);
            gather(self.scene, &self.lights, &mut self.tracer, seen, &mut self.scratch, &mut self.gathered);
        } else {
            self.shade();
        }
        let remembered = self.rays.iter().zip(&self.hits).zip(&self.gathered);
        let remembered = remembered.map(|((ray, hit), light)| Remembered::new(Glimpse::of(ray, hit), light));
        let mut canvas = lock(self.canvas);
        canvas.keep(tile, &self.hits, self.settings.samples);
        canvas.keep_memory(tile, remembered);
        canvas.colour(tile, &self.colours);
    }

    /// Colours the pixels of the tile by what they and their neighbours remember.
    pub fn light(&mut self, tile: Tile, memory: &Layer<Remembered>) {
        self.look_around(tile, memory);
        self.aim(tile.pixels().map(|(i, j)| (i, j, 0)));
        self.colours.clear();
        let glimpses: Vec<Glimpse> = tile.pixels().map(|(i, j)| self.window.at(i, j).glimpse).collect();
        let sides = self.sides(&glimpses);
        for (k, (i, j)) in tile.pixels().enumerate() {
            let kept = self.window.at(i, j);
            let light = self.shared_light(k, &kept.glimpse).unwrap_or_else(|| kept.light());
            self.colours.push(self.studio_colour(k, &kept.glimpse, &light, sides[k]));
        }
        lock(self.canvas).colour(tile, &self.colours);
    }

    /// Adds samples to the tile's edges until those that still differ have as many as the last of `ends`.
    pub fn smooth_edges(&mut self, tile: Tile, ends: &[u32], memory: Option<&Layer<Remembered>>) {
        let mut edges = lock(self.canvas).take_edges(tile);
        if let (Some(memory), false) = (memory, edges.is_empty()) {
            self.look_around(tile, memory);
        }
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
    fn add_samples(&mut self, edges: &mut [&mut Edge], indices: Range<u32>) {
        self.look(edges.iter().flat_map(|edge| indices.clone().map(|k| (edge.at.0, edge.at.1, k))));
        self.colour();
        let hits = self.hits.chunks(indices.len());
        for ((edge, colours), hits) in edges.iter_mut().zip(self.colours.chunks(indices.len())).zip(hits) {
            edge.covered += hits.iter().map(|hit| u32::from(hit.is_drawn())).sum::<u32>();
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

    /// Follows light for these samples of every pixel of the tile.
    pub fn shine(&mut self, tile: Tile, samples: Range<u32>) {
        let Some(mut estimator) = self.estimator.take() else { return };
        let pixels: Vec<(u32, u32)> = tile.pixels().collect();
        // The only sample of a pixel is its own.
        let filter = if self.settings.samples == 1 { Filter::Box } else { self.settings.filter };
        let weights = Weights::new(filter);
        let mut exposure = TileExposure::new(tile, self.settings.size, &weights);
        let mut estimates = Vec::new();
        let at_once = (SHINING / samples.len().max(1)).max(1);
        let started = self.watch.seconds();
        for pixels in pixels.chunks(at_once) {
            for samples in chunks(samples.clone(), SHINING) {
                let each = pixels.iter().flat_map(|&pixel| samples.clone().map(move |sample| (pixel, sample)));
                let each: Vec<((u32, u32), u32)> = each.collect();
                estimator.estimate(&mut self.tracer, &each, &mut estimates);
                exposure.add(&estimates, &weights);
                if let Some(all) = &mut lock(self.canvas).exposure {
                    all.add_shown(estimator.shown(), &weights);
                }
            }
        }
        if let Some(all) = &mut lock(self.canvas).exposure {
            all.add(&exposure);
        }
        self.trace_seconds += self.watch.seconds() - started;
        self.estimator = Some(estimator);
    }

    /// Lets the pixels of the tile see what their neighbours remember.
    fn look_around(&mut self, tile: Tile, memory: &Layer<Remembered>) {
        let Rectangle { left, top, width, height } = tile.rectangle();
        self.window.look(&self.scene.camera, memory, [left, top, width, height]);
    }

    /// Colours the rays looked at last.
    fn colour(&mut self) {
        if self.settings.mode == Mode::Studio {
            self.colour_samples();
        } else {
            self.shade();
        }
    }

    /// Colours the rays looked at last, each by itself.
    fn shade(&mut self) {
        let (mode, colours) = (self.settings.mode, &mut self.colours);
        match mode {
            Mode::Whitted => {
                if let Some(estimator) = &mut self.estimator {
                    estimator.whitted(&mut self.tracer, &self.rays, colours);
                }
            }
            Mode::Angle | Mode::End | Mode::Bounces => {
                let seen = (&self.rays[..], &self.hits[..]);
                trails::colours(mode, self.scene, &mut self.tracer, seen, self.settings.bounces, colours);
            }
            _ => shade(mode, self.scene, &self.rays, &self.hits, colours),
        }
        self.lay_behind();
    }

    /// Puts what is behind the surfaces where nothing was hit, if it was asked for.
    fn lay_behind(&mut self) {
        let background = self.settings.background;
        if background == Background::Own {
            return;
        }
        for ((colour, ray), hit) in self.colours.iter_mut().zip(&self.rays).zip(&self.hits) {
            if let (false, Some(behind)) = (hit.is_drawn(), behind(background, self.scene, ray)) {
                *colour = pixel(behind);
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
        let sides = self.sides(&glimpses);
        let mut own = self.gathered.iter();
        self.colours.clear();
        for (k, glimpse) in glimpses.iter().enumerate() {
            let light = match shared[k] {
                None if glimpse.is_drawn() => own.next().copied().unwrap_or(Light::OPEN),
                shared => shared.unwrap_or(Light::OPEN),
            };
            let colour = self.studio_colour(k, glimpse, &light, sides[k]);
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

    /// The colours of what the rays see.
    fn sides(&self, glimpses: &[Glimpse]) -> Vec<DVec3> {
        colours_of(self.scene, self.rays.iter().zip(glimpses).map(|(ray, glimpse)| glimpse.place(ray)))
    }

    /// What ray k sees, of which the surface has this colour.
    fn studio_colour(&self, k: usize, glimpse: &Glimpse, light: &Light, colour: DVec3) -> [f32; 3] {
        if !glimpse.is_drawn() {
            if let Some(behind) = behind(self.settings.background, self.scene, &self.rays[k]) {
                return pixel(behind);
            }
            let (i, j, _) = self.samples[k];
            let [across, down] = place(self.samples[k]);
            let half = f64::from(self.settings.size.height()) / 2.0;
            let aspect = f64::from(self.settings.size.width()) / f64::from(self.settings.size.height());
            return pixel(backdrop::backdrop([across / half - aspect, down / half - 1.0], (i, j)));
        }
        let seen = Seen { colour, footprint: self.footprint(glimpse) };
        pixel(studio::colour(self.scene, &self.lights, &self.rays[k], glimpse, light, seen))
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

/// A range in pieces of at most so many.
fn chunks(range: Range<u32>, most: usize) -> impl Iterator<Item = Range<u32>> {
    let end = range.end;
    range.step_by(most).map(move |start| start..end.min(start + most as u32))
}

/// Where a sample is in the picture, in pixels from its upper left corner.
fn place((i, j, k): Sample) -> [f64; 2] {
    let (across, down) = sampling::offset(k);
    [f64::from(i) + across, f64::from(j) + down]
}
