//! Samples of pixels, by whichever mode follows light.
//!
//! In: pixels and the numbers of their samples. Out: for each sample the light that it found, and how it counts. A pure function of pixel,
//! sample and seed.

use super::lights::Lights;
use super::media::{Media, Solids};
use super::path;
use super::world::{Flight, Numbers, Room, World};
use crate::render::filter::{Filter, FilterTable};
use crate::render::settings::Settings;
use crate::render::trace::Trace;
use crate::scene::Scene;
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
    flights: Vec<Flight>,
    signs: Vec<f64>,
    light: Vec<DVec3>,
}

impl<'a> Estimator<'a> {
    /// With empty room.
    pub fn new(scene: &'a Scene, settings: &'a Settings, illumination: &'a Illumination) -> Self {
        let room = Room::default();
        let (flights, signs, light) = (Vec::new(), Vec::new(), Vec::new());
        Estimator { scene, settings, illumination, room, eye: None, flights, signs, light }
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
        path::radiance(&mut self.world(tracer), &flights, bounces, &mut light);
        (self.flights, self.light) = (flights, light);
        out.clear();
        let finite = |light: DVec3| if light.is_finite() { light } else { DVec3::ZERO };
        out.extend(self.light.iter().zip(&self.signs).map(|(&light, &sign)| Estimate { light: finite(light), sign }));
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
            let ray =
                self.scene.camera.ray(size.width(), size.height(), f64::from(i) + 0.5 + x, f64::from(j) + 0.5 + y);
            let media = match self.eye {
                Some(media) if !self.scene.camera.is_parallel() => media,
                _ => self.world(tracer).media_at(ray.origin),
            };
            self.eye = Some(media);
            self.flights.push(Flight::new(ray, media, numbers));
            self.signs.push(sign);
        }
    }
}
