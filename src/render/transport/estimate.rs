//! Samples of pixels, by whichever mode follows light.
//!
//! In: pixels and the numbers of their samples. Out: for each sample the light that it found, and how it counts. A pure function of pixel,
//! sample and seed.

use super::light::{Splat, light_paths, splats};
use super::lights::Lights;
use super::media::{Media, Solids};
use super::world::{Flight, Numbers, Room, World};
use super::{bidirectional, path, whitted};
use crate::render::filter::{Filter, FilterTable};
use crate::render::integrator::pixel;
use crate::render::settings::{Mode, Settings};
use crate::render::trace::Trace;
use crate::scene::Scene;
use crate::surface::Ray;
use glam::DVec3;

/// What all threads know of a scene's light.
pub struct Illumination {
    /// Where light comes from.
    pub lights: Lights,
    /// What is clear.
    pub solids: Solids,
    filter: FilterTable,
}

impl Illumination {
    /// The light of a scene.
    pub fn new(scene: &Scene, filter: Filter) -> Self {
        let solids = Solids::new(&scene.materials);
        Illumination { lights: Lights::new(scene), solids, filter: FilterTable::new(filter) }
    }
}

/// From so many samples on the negative parts of a filter are sure to be outweighed in every pixel; of fewer all count alike.
const SIGNED: u32 = 16;

/// A sample of a pixel: which pixel, which sample.
pub type Sample = ((u32, u32), u32);

/// The light of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The radiance.
    pub light: DVec3,
    /// How it counts: 1 or −1.
    pub sign: f64,
}

/// One thread's room for estimates.
pub struct Estimator<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    illumination: &'a Illumination,
    room: Room,
    eye: Option<Media>,
    paths: path::PathRoom,
    flights: Vec<Flight>,
    signs: Vec<f64>,
    light: Vec<DVec3>,
    shown: Vec<Splat>,
}

impl<'a> Estimator<'a> {
    /// With empty room.
    pub fn new(scene: &'a Scene, settings: &'a Settings, illumination: &'a Illumination) -> Self {
        let (room, paths) = (Room::default(), path::PathRoom::default());
        let (flights, signs, light, shown) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Estimator { scene, settings, illumination, room, eye: None, paths, flights, signs, light, shown }
    }

    /// The scene with someone who traces.
    pub fn world<'b, T: Trace>(&'b mut self, tracer: &'b mut T) -> World<'b, T> {
        let Illumination { lights, solids, .. } = self.illumination;
        World { scene: self.scene, lights, solids, tracer, room: &mut self.room }
    }

    /// The light of samples, in their order, into `out`, which is replaced.
    pub fn estimate<T: Trace>(&mut self, tracer: &mut T, samples: &[Sample], out: &mut Vec<Estimate>) {
        self.aim(tracer, samples);
        let bounces = self.settings.bounces;
        let (flights, mut light) = (std::mem::take(&mut self.flights), std::mem::take(&mut self.light));
        let (mut shown, mut paths) = (std::mem::take(&mut self.shown), std::mem::take(&mut self.paths));
        shown.clear();
        let (size, mode) = (self.settings.size, self.settings.mode);
        let mut world = self.world(tracer);
        match mode {
            Mode::Light => {
                let samples: Vec<Numbers> = flights.iter().map(|flight| flight.numbers).collect();
                let mut vertices = Vec::new();
                light_paths(&mut world, &samples, bounces, &mut vertices);
                splats(&mut world, &vertices, &samples, size, false, &mut shown);
                path::radiance(&mut world, &flights, 0, &mut paths, &mut light);
            }
            Mode::Bidirectional => {
                bidirectional::radiance(&mut world, &flights, size, bounces, (&mut light, &mut shown));
            }
            _ => path::radiance(&mut world, &flights, bounces, &mut paths, &mut light),
        }
        (self.flights, self.light, self.shown, self.paths) = (flights, light, shown, paths);
        out.clear();
        let finite = |light: DVec3| if light.is_finite() { light } else { DVec3::ZERO };
        out.extend(self.light.iter().zip(&self.signs).map(|(&light, &sign)| Estimate { light: finite(light), sign }));
    }

    /// The light of rays from the eye in mode `whitted`, as a film keeps it; `colours` is replaced.
    pub fn whitted<T: Trace>(&mut self, tracer: &mut T, rays: &[Ray], colours: &mut Vec<[f32; 3]>) {
        let mut flights = Vec::with_capacity(rays.len());
        for &ray in rays {
            let media = self.media(tracer, ray.origin);
            flights.push(Flight::new(ray, media, Numbers::default()));
        }
        let mut light = std::mem::take(&mut self.light);
        let bounces = self.settings.bounces;
        whitted::radiance(&mut self.world(tracer), &flights, bounces, &mut light);
        colours.clear();
        colours.extend(light.iter().map(|&light| pixel(light)));
        self.light = light;
    }

    /// The media at the start of a ray from the eye.
    fn media<T: Trace>(&mut self, tracer: &mut T, start: DVec3) -> Media {
        let media = match self.eye {
            Some(media) if !self.scene.camera.is_parallel() => media,
            _ => self.world(tracer).media_at(start),
        };
        self.eye = Some(media);
        media
    }

    /// What the last samples show elsewhere in the picture: pixels with their share of light, for one sample a pixel.
    pub fn shown(&self, mut take: impl FnMut((u32, u32), DVec3)) {
        let (size, filter) = (self.settings.size, &self.illumination.filter);
        let reach = filter.radius();
        let pixels = |place: f64, count: u32| {
            let first = (place - 0.5 - reach).ceil().max(0.0) as u32;
            let end = (place - 0.5 + reach).floor() + 1.0;
            first..(end.max(0.0) as u32).min(count)
        };
        for &Splat { place: [x, y], light } in self.shown.iter().filter(|splat| splat.light.is_finite()) {
            for j in pixels(y, size.height()) {
                for i in pixels(x, size.width()) {
                    let weight = filter.weight(x - f64::from(i) - 0.5, y - f64::from(j) - 0.5);
                    take((i, j), light * weight);
                }
            }
        }
    }

    /// The rays from the eye.
    fn aim<T: Trace>(&mut self, tracer: &mut T, samples: &[Sample]) {
        let size = self.settings.size;
        self.flights.clear();
        self.signs.clear();
        for &((i, j), sample) in samples {
            let pixel = u64::from(j) * u64::from(size.width()) + u64::from(i);
            let numbers = Numbers { pixel, sample, seed: self.settings.seed };
            let ([x, y], sign) = match self.settings.samples {
                1 => ([0.0, 0.0], 1.0),
                _ => self.illumination.filter.place(path::pixel_numbers(&numbers)),
            };
            let sign = if self.settings.samples < SIGNED { 1.0 } else { sign };
            let ray =
                self.scene.camera.ray(size.width(), size.height(), f64::from(i) + 0.5 + x, f64::from(j) + 0.5 + y);
            let media = self.media(tracer, ray.origin);
            self.flights.push(Flight::new(ray, media, numbers));
            self.signs.push(sign);
        }
    }
}
