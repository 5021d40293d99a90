//! What rays meet on their way: surfaces, balls of light, nothing.
//!
//! In: flights, many at once. Out: for each what it met first that matters. What is partly there is passed by chance or by share,
//! boundaries inside a solid of higher priority are passed as if they were not there, and media take their part of the light.

use super::lights::Lights;
use super::media::{Boundary, Media, Solids, transmittance};
use super::sobol;
use super::vertex::Arrivals;
use crate::render::trace::Trace;
use crate::scene::{Material, Scene};
use crate::surface::{Hit, Ray, Shape, Side};
use glam::DVec3;

/// A flight passes through at most so many surfaces; then it is lost. As many as a thin shell of foam has.
const MOST_PASSES: u32 = 4096;

/// The dimension from which on the numbers say what is passed.
const PASSING: u32 = 1 << 20;

/// Which numbers a path chooses by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Numbers {
    /// The pixel.
    pub pixel: u64,
    /// The sample.
    pub sample: u32,
    /// The seed.
    pub seed: u64,
}

impl Numbers {
    /// The pair of a dimension.
    pub fn at(&self, dimension: u32) -> [f64; 2] {
        sobol::numbers(self.pixel, self.sample, dimension, self.seed)
    }
}

/// A ray on its way.
#[derive(Clone, Copy, Debug)]
pub struct Flight {
    /// The rest of the way.
    pub ray: Ray,
    /// What it is in.
    pub media: Media,
    /// What is left of its light.
    pub left: DVec3,
    /// How far it has come.
    pub distance: f64,
    /// How it chooses what it passes.
    pub numbers: Numbers,
    /// How many surfaces it has passed, in all of its path.
    pub passes: u32,
    /// How it passes what is partly there.
    pub passing: Passing,
    /// Up to this distance it passes whatever is partly there.
    pub sure: f64,
}

impl Flight {
    /// At the start of a ray.
    pub fn new(ray: Ray, media: Media, numbers: Numbers) -> Self {
        let passing = Passing::ByChance;
        Flight { ray, media, left: DVec3::ONE, distance: 0.0, numbers, passes: 0, passing, sure: 0.0 }
    }
}

/// What a flight met.
#[derive(Clone, Copy, Debug)]
pub enum Met {
    /// A surface. If it bounds a clear solid, what is on its two sides.
    Surface(Hit, Option<Boundary>),
    /// A ball of light: the emitter, and the distance on the rest of the ray.
    Ball(usize, f64),
    /// Nothing up to the end.
    Nothing,
}

/// How what is partly there is passed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Passing {
    /// By chance: all of the light, or none.
    ByChance,
    /// By share: the part that passes.
    ByShare,
    /// By share, and the other part stays: [`World::stayed`] tells of it.
    BothWays,
}

/// Where flights start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum From {
    /// At the eye, on a root perhaps, which is skipped.
    Eye,
    /// Anywhere else: nothing is skipped.
    Elsewhere,
}

/// What a surface is like at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Matter {
    /// Albedo or tint.
    pub color: DVec3,
    /// Roughness.
    pub roughness: f64,
    /// Radiance.
    pub emission: DVec3,
}

/// A scene with someone who traces rays.
pub struct World<'a, T> {
    /// What there is.
    pub scene: &'a Scene,
    /// Where light comes from.
    pub lights: &'a Lights,
    /// What is clear.
    pub solids: &'a Solids,
    /// Whether the surroundings are not seen where the eye sees nothing else.
    pub hides_sky: bool,
    /// Who traces.
    pub tracer: &'a mut T,
    /// Room.
    pub room: &'a mut Room,
}

/// Room for batches, used again and again.
#[derive(Debug, Default)]
pub struct Room {
    rays: Vec<Ray>,
    hits: Vec<Hit>,
    open: Vec<usize>,
    asked: Vec<(usize, Hit)>,
    stayed: Vec<(usize, Flight, Met)>,
    opacity: Vec<DVec3>,
    passing: Vec<(usize, Hit)>,
    departures: Vec<(Ray, Hit, Side)>,
    points: Vec<DVec3>,
    /// Of the vertices.
    pub(super) arrivals: Arrivals,
    covered: Vec<bool>,
}

impl Room {
    /// Of the last flights from the eye, which met anything.
    pub fn covered(&self) -> &[bool] {
        &self.covered
    }
}

impl<T: Trace> World<'_, T> {
    /// Lets flights go on until each meets something that matters; `met` is replaced.
    pub fn fly(&mut self, flights: &mut [Flight], from: From, met: &mut Vec<Met>) {
        met.clear();
        met.resize(flights.len(), Met::Nothing);
        let mut room = std::mem::take(self.room);
        room.stayed.clear();
        let is_from_eye = from == From::Eye;
        let mut from = from;
        room.open.clear();
        room.open.extend(0..flights.len());
        while !room.open.is_empty() {
            room.rays.clear();
            room.rays.extend(room.open.iter().map(|&k| flights[k].ray));
            match from {
                From::Eye => self.tracer.trace(&room.rays, &mut room.hits),
                From::Elsewhere => self.tracer.trace_from_surface(&room.rays, &mut room.hits),
            }
            from = From::Elsewhere;
            self.sort(flights, &mut room, met);
            self.pass_by_opacity(flights, &mut room, met);
            self.go_on(flights, &mut room);
        }
        if is_from_eye {
            room.covered.clear();
            room.covered.extend(met.iter().map(|met| !matches!(met, Met::Nothing)));
        }
        *self.room = room;
    }

    /// What stayed at surfaces that the last flights passed both ways: of which flight, the part with its light, and the surface.
    pub fn stayed(&self) -> &[(usize, Flight, Met)] {
        &self.room.stayed
    }

    /// What each open flight met; those that may pass are put aside.
    fn sort(&mut self, flights: &mut [Flight], room: &mut Room, met: &mut [Met]) {
        room.asked.clear();
        room.passing.clear();
        for (&k, hit) in room.open.iter().zip(&room.hits) {
            let flight = &mut flights[k];
            let end = hit.t.min(flight.ray.end);
            if let Some((t, ball)) = self.lights.first_ball(&flight.ray, end) {
                self.weaken(flight, flight.media, t);
                met[k] = Met::Ball(ball, t);
                continue;
            }
            if !hit.is_drawn() {
                self.weaken(flight, flight.media, flight.ray.end);
                met[k] = Met::Nothing;
                continue;
            }
            let from_negative = self.tracer.comes_from_negative(&flight.ray, hit);
            let boundary = self.solids.boundary(flight.media, hit.surface, from_negative);
            if let Some(boundary) = boundary {
                flight.media = boundary.before;
            }
            self.weaken(flight, flight.media, hit.t);
            met[k] = Met::Surface(*hit, boundary);
            match boundary {
                Some(Boundary { relative_ior: None, .. }) => room.passing.push((k, *hit)),
                _ if self.material(hit).opacity.constant() != Some(DVec3::ONE) => room.asked.push((k, *hit)),
                _ => {}
            }
        }
    }

    /// What a surface is made of.
    pub fn material(&self, hit: &Hit) -> &Material {
        &self.scene.materials[hit.surface as usize]
    }

    /// Takes what the medium takes on the next `t` of the ray, inside the clip of its solid.
    fn weaken(&self, flight: &mut Flight, media: Media, t: f64) {
        let Some((surface, dielectric)) = self.solids.filling(media) else { return };
        if dielectric.absorption == DVec3::ZERO {
            return;
        }
        let span = self.scene.clips[*surface as usize].iter().try_fold((0.0f64, t), |(a, b), shape: &Shape| {
            let (near, far) = shape.span(&flight.ray)?;
            Some((a.max(near), b.min(far)))
        });
        if let Some((a, b)) = span {
            flight.left *= transmittance(dielectric.absorption, b - a);
        }
    }

    /// Of those that met what is partly there, finds who passes.
    fn pass_by_opacity(&mut self, flights: &mut [Flight], room: &mut Room, met: &[Met]) {
        let places = |&(k, hit): &(usize, Hit)| (hit.surface, flights[k].ray.at(hit.t));
        let asked: Vec<(u32, DVec3)> = room.asked.iter().map(places).collect();
        textures(self.scene, &asked, |material| &material.opacity, &mut room.opacity);
        for (&(k, hit), share) in room.asked.iter().zip(&room.opacity) {
            let flight = &mut flights[k];
            let share = share.x.clamp(0.0, 1.0);
            let passes = match flight.passing {
                _ if flight.distance + hit.t < flight.sure => true,
                Passing::ByChance => flight.numbers.at(PASSING + flight.passes)[0] >= share,
                Passing::ByShare => {
                    flight.left *= 1.0 - share;
                    share < 1.0
                }
                Passing::BothWays => {
                    let stays = Flight { left: flight.left * share, ..*flight };
                    if share > 0.0 && share < 1.0 {
                        room.stayed.push((k, stays, met[k]));
                    }
                    flight.left *= if share < 1.0 { 1.0 - share } else { 1.0 };
                    share < 1.0
                }
            };
            if passes {
                room.passing.push((k, hit));
            } else {
                flight.passes += 1;
            }
        }
    }

    /// Moves those that pass to the far side.
    fn go_on(&mut self, flights: &mut [Flight], room: &mut Room) {
        room.open.clear();
        room.departures.clear();
        room.departures.extend(room.passing.iter().map(|&(k, hit)| (flights[k].ray, hit, Side::Far)));
        self.tracer.starts(&room.departures, &mut room.points);
        for (&(k, hit), &point) in room.passing.iter().zip(&room.points) {
            let flight = &mut flights[k];
            let from_negative = self.tracer.comes_from_negative(&flight.ray, &hit);
            if let Some(boundary) = self.solids.boundary(flight.media, hit.surface, from_negative) {
                flight.media = boundary.after;
            }
            flight.passes += 1;
            if flight.passes > MOST_PASSES {
                flight.left = DVec3::ZERO;
                continue;
            }
            flight.distance += hit.t;
            flight.ray.origin = point;
            flight.ray.end -= hit.t;
            room.open.push(k);
        }
        // In the flights' order, so that batches are the same however they came about.
        room.open.sort_unstable();
    }

    /// What surfaces are like at points of them.
    pub fn matter(&self, places: &[(u32, DVec3)], out: &mut Vec<Matter>) {
        out.clear();
        out.resize(places.len(), Matter::default());
        let mut values = Vec::new();
        textures(self.scene, places, |material| &material.color, &mut values);
        out.iter_mut().zip(&values).for_each(|(matter, &value)| matter.color = value);
        textures(self.scene, places, |material| &material.roughness, &mut values);
        out.iter_mut().zip(&values).for_each(|(matter, value)| matter.roughness = value.x);
        textures(self.scene, places, |material| &material.emission, &mut values);
        out.iter_mut().zip(&values).for_each(|(matter, &value)| matter.emission = value);
    }

    /// The media at a point in space.
    pub fn media_at(&mut self, point: DVec3) -> Media {
        let mut media = Media::default();
        for (surface, inside_is_negative) in self.solids.surfaces() {
            let is_in_clip = self.scene.clips[surface as usize].iter().all(|shape| shape.contains(point));
            if is_in_clip && self.tracer.is_negative(surface, point) == Some(inside_is_negative) {
                media = self.solids.with(media, surface, true);
            }
        }
        media
    }
}

/// One texture of each surface at points of it, many points of one surface at a time.
fn textures(
    scene: &Scene,
    places: &[(u32, DVec3)],
    which: fn(&Material) -> &crate::scene::Texture,
    out: &mut Vec<DVec3>,
) {
    out.clear();
    let constant = |surface: u32| which(&scene.materials[surface as usize]).constant();
    out.extend(places.iter().map(|&(surface, _)| constant(surface).unwrap_or(DVec3::NAN)));
    let mut varied: Vec<u32> = places.iter().map(|place| place.0).filter(|&s| constant(s).is_none()).collect();
    varied.sort_unstable();
    varied.dedup();
    let mut values = Vec::new();
    for surface in varied {
        let points: Vec<DVec3> = places.iter().filter(|place| place.0 == surface).map(|place| place.1).collect();
        which(&scene.materials[surface as usize]).values(&points, &mut values);
        let of_surface = out.iter_mut().zip(places).filter(|(_, place)| place.0 == surface);
        of_surface.zip(&values).for_each(|((slot, _), &value)| *slot = value);
    }
}
