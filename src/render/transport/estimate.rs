//! Samples of pixels, by whichever mode follows light.
//!
//! In: pixels and the numbers of their samples. Out: for each sample the light that it found, and how it counts. A pure function of pixel,
//! sample and seed.

use super::light::Splat;
use super::lights::Lights;
use super::media::{Media, Solids};
use super::world::{Flight, Numbers, Room, World};
use super::{bidirectional, path, whitted};
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
}

impl Illumination {
    /// The light of a scene.
    pub fn new(scene: &Scene) -> Self {
        Illumination { lights: Lights::new(scene), solids: Solids::new(&scene.materials) }
    }
}

/// A sample of a pixel: which pixel, which sample.
pub type Sample = ((u32, u32), u32);

/// The light of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// Where in the picture, in pixels from its upper left corner.
    pub place: [f64; 2],
    /// The radiance.
    pub light: DVec3,
    /// Whether there is anything but surroundings.
    pub is_covered: bool,
}

/// One thread's room for estimates.
pub struct Estimator<'a> {
    scene: &'a Scene,
    settings: &'a Settings,
    illumination: &'a Illumination,
    room: Room,
    eye: Option<Media>,
    paths: path::PathRoom,
    both: bidirectional::BothRoom,
    flights: Vec<Flight>,
    places: Vec<[f64; 2]>,
    light: Vec<DVec3>,
    shown: Vec<Splat>,
}

impl<'a> Estimator<'a> {
    /// With empty room.
    pub fn new(scene: &'a Scene, settings: &'a Settings, illumination: &'a Illumination) -> Self {
        let (room, paths, both) = (Room::default(), path::PathRoom::default(), bidirectional::BothRoom::default());
        let (flights, places, light, shown) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Estimator { scene, settings, illumination, room, eye: None, paths, both, flights, places, light, shown }
    }

    /// The scene with someone who traces.
    pub fn world<'b, T: Trace>(&'b mut self, tracer: &'b mut T) -> World<'b, T> {
        let Illumination { lights, solids, .. } = self.illumination;
        let hides_sky = self.settings.background.keeps_alpha();
        World { scene: self.scene, lights, solids, hides_sky, tracer, room: &mut self.room }
    }

    /// The light of samples, in their order, into `out`, which is replaced.
    pub fn estimate<T: Trace>(&mut self, tracer: &mut T, samples: &[Sample], out: &mut Vec<Estimate>) {
        self.aim(tracer, samples);
        let bounces = self.settings.bounces;
        let (flights, mut light) = (std::mem::take(&mut self.flights), std::mem::take(&mut self.light));
        let (mut shown, mut paths) = (std::mem::take(&mut self.shown), std::mem::take(&mut self.paths));
        let mut both = std::mem::take(&mut self.both);
        shown.clear();
        let (size, mode) = (self.settings.size, self.settings.mode);
        let mut world = self.world(tracer);
        match mode {
            Mode::Light => {
                bidirectional::show_lights(&mut world, &flights, (size, bounces), false, &mut both, &mut shown);
                path::radiance(&mut world, &flights, 0, &mut paths, &mut light);
            }
            Mode::Bidirectional => {
                let found = (&mut light, &mut shown);
                bidirectional::radiance(&mut world, &flights, size, bounces, &mut both, found);
            }
            _ => path::radiance(&mut world, &flights, bounces, &mut paths, &mut light),
        }
        (self.flights, self.light, self.shown, self.paths, self.both) = (flights, light, shown, paths, both);
        out.clear();
        let finite = |light: DVec3| if light.is_finite() { light } else { DVec3::ZERO };
        let estimate = |((&light, &place), &is_covered)| Estimate { place, light: finite(light), is_covered };
        out.extend(self.light.iter().zip(&self.places).zip(self.room.covered()).map(estimate));
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
        colours.extend(light.iter().map(|&light| pixel(bright_as_can_be(light))));
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

    /// What the last samples show elsewhere in the picture, for one sample a pixel.
    pub fn shown(&self) -> impl Iterator<Item = &Splat> {
        self.shown.iter().filter(|splat| splat.light.is_finite())
    }

    /// The rays from the eye.
    fn aim<T: Trace>(&mut self, tracer: &mut T, samples: &[Sample]) {
        let size = self.settings.size;
        self.flights.clear();
        self.places.clear();
        for &((i, j), sample) in samples {
            let pixel = u64::from(j) * u64::from(size.width()) + u64::from(i);
            let numbers = Numbers { pixel, sample, seed: self.settings.seed };
            // The only sample is in the middle.
            let [x, y] = if self.settings.samples == 1 { [0.5, 0.5] } else { path::pixel_numbers(&numbers) };
            let place = [f64::from(i) + x, f64::from(j) + y];
            let ray = self.scene.camera.ray(size.width(), size.height(), place[0], place[1]);
            let media = self.media(tracer, ray.origin);
            self.flights.push(Flight::new(ray, media, numbers));
            self.places.push(place);
        }
    }
}

/// Light that single precision can keep; what has no value, as infinite light on what is black, is dark.
fn bright_as_can_be(light: DVec3) -> DVec3 {
    // A maximum with 0 is 0 of what has no value, too.
    light.max(DVec3::ZERO).min(DVec3::splat(f64::from(f32::MAX)))
}
