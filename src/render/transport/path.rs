//! Mode `path`: light found by paths from the camera.
//!
//! In: rays from the eye. Out: an unbiased estimate of the radiance of each, of at most so many scattering events. At every event light
//! is sought in two ways, by a ray towards an emitter and by going on as the surface scatters; each way counts by how likely it was to
//! find what it found (Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", section 9.2, power heuristic).

use super::bsdf::Transport;
use super::lights::{Emitter, Lights};
use super::vertex::{Onward, Travel, Vertex, vertices};
use super::world::{Flight, From, Met, Numbers, Passing, World};
use crate::render::trace::Trace;
use glam::DVec3;

/// Dimensions a scattering event takes.
pub(super) const DIMENSIONS: u32 = 4;

/// The first of them: before come the place in the pixel and what else is chosen at the eye.
pub(super) const FIRST_DIMENSION: u32 = 2;

/// After so many events a path goes on only with a probability, its throughput's (Arvo and Kirk 1990, "Particle transport and image
/// synthesis").
const SURE_EVENTS: u32 = 4;

/// The least probability of going on.
const LEAST_SURVIVAL: f64 = 0.05;

/// A ray that ends at a place is looked at to just before it: the place is known to a few units of rounding.
pub(super) const SHORT_OF_TARGET: f64 = 1.0 - 1e-11;

/// A path on its way.
#[derive(Clone, Copy, Debug)]
struct Path {
    /// Which of the samples.
    place: usize,
    throughput: DVec3,
    /// The density of the last direction; +∞ where no other way finds light: from the eye, and behind a mirror.
    pdf: f64,
    /// Where it left the last surface.
    from: DVec3,
    is_from_eye: bool,
}

/// A ray towards an emitter.
struct Shadow {
    place: usize,
    /// What arrives if nothing is in the way; for surfaces, of a radiance of 1.
    light: DVec3,
    goal: Goal,
}

/// What a ray towards an emitter has to find.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Goal {
    /// Nothing in the way.
    Free,
    /// This ball.
    Ball(usize),
    /// This surface.
    Surface(u32),
}

impl Goal {
    /// What there is to find of an emitter.
    pub(super) fn of(lights: &Lights, emitter: usize) -> Self {
        match lights.list[emitter] {
            Emitter::Glow { surface, .. } => Goal::Surface(surface),
            Emitter::Ball { .. } => Goal::Ball(emitter),
            Emitter::Point { .. } | Emitter::Parallel { .. } | Emitter::Disc { .. } | Emitter::Sky(_) => Goal::Free,
        }
    }

    /// Whether a ray that met this found it.
    pub(super) fn is_found(self, met: &Met) -> bool {
        match (*met, self) {
            (Met::Nothing, Goal::Free) => true,
            (Met::Ball(ball, _), Goal::Ball(emitter)) => ball == emitter,
            (Met::Surface(hit, _), Goal::Surface(surface)) => hit.surface == surface,
            _ => false,
        }
    }

    /// How such a ray passes what is partly there: a surface that is sought may itself be so, and is met by chance.
    pub(super) fn passing(self) -> Passing {
        if let Goal::Surface(_) = self { Passing::ByChance } else { Passing::ByShare }
    }
}

/// Room for batches of paths, used again and again.
#[derive(Default)]
pub struct PathRoom {
    now: Travel<Path>,
    on: Travel<Path>,
    met: Vec<Met>,
    found: Vec<Vertex>,
    shadows: Vec<Shadow>,
    rays: Vec<Flight>,
}

/// The radiance that arrives along each flight, in `light`, which is replaced.
pub fn radiance<T: Trace>(
    world: &mut World<T>,
    eye: &[Flight],
    bounces: u32,
    room: &mut PathRoom,
    light: &mut Vec<DVec3>,
) {
    light.clear();
    light.resize(eye.len(), DVec3::ZERO);
    let start = |(place, flight): (usize, &Flight)| Path {
        place,
        throughput: DVec3::ONE,
        pdf: f64::INFINITY,
        from: flight.ray.origin,
        is_from_eye: true,
    };
    room.now.paths.clear();
    room.now.paths.extend(eye.iter().enumerate().map(start));
    room.now.flights.clear();
    room.now.flights.extend_from_slice(eye);
    for event in 0..=bounces {
        let from = if event == 0 { From::Eye } else { From::Elsewhere };
        let Travel { paths, flights } = &mut room.now;
        world.fly(flights, from, &mut room.met);
        for ((path, flight), met) in paths.iter_mut().zip(&*flights).zip(&room.met) {
            path.throughput *= flight.left;
            light[path.place] += path.throughput * seen(world, path, flight, met);
        }
        vertices(world, flights, &room.met, &mut room.found);
        for vertex in room.found.iter().filter(|vertex| vertex.emission != DVec3::ZERO) {
            let path = &paths[vertex.path];
            let emitter = world.lights.of_surface(vertex.hit.surface);
            let other = emitter.map_or(0.0, |k| world.lights.pdf_toward(k, path.from, vertex.ray.direction));
            light[path.place] += path.throughput * vertex.emission * share(path.pdf, other);
        }
        if event == bounces || room.found.is_empty() {
            return;
        }
        let first = FIRST_DIMENSION + event * DIMENSIONS;
        seek(world, room, first, light);
        scatter(room, first, event);
        std::mem::swap(&mut room.now, &mut room.on);
    }
}

/// The light of balls and of what is far that a flight met.
fn seen<T: Trace>(world: &World<T>, path: &Path, flight: &Flight, met: &Met) -> DVec3 {
    let direction = flight.ray.direction;
    let is_from_eye = path.is_from_eye;
    let weighed = |(emitter, radiance): (usize, DVec3)| {
        radiance * share(path.pdf, world.lights.pdf_toward(emitter, path.from, direction))
    };
    match *met {
        Met::Surface(..) => DVec3::ZERO,
        Met::Ball(emitter, t) => weighed((emitter, world.lights.ball_radiance(emitter, &flight.ray, t).0)),
        Met::Nothing if is_from_eye && world.hides_sky => DVec3::ZERO,
        Met::Nothing => world.lights.far(direction).map(weighed).sum(),
    }
}

/// Seeks light at every vertex by a ray towards some emitter.
fn seek<T: Trace>(world: &mut World<T>, room: &mut PathRoom, first: u32, light: &mut [DVec3]) {
    let PathRoom { now: Travel { paths, flights }, found, shadows, rays, met, .. } = room;
    shadows.clear();
    rays.clear();
    for vertex in found.iter().filter(|vertex| !vertex.bsdf.is_specular()) {
        let (path, numbers) = (&paths[vertex.path], flights[vertex.path].numbers);
        let sought = world.lights.toward(vertex.point, numbers.at(first), numbers.at(first + 1));
        let Some(toward) = sought else { continue };
        let wi = vertex.local(toward.direction);
        let value = vertex.value(wi, Transport::Radiance);
        if value == DVec3::ZERO || !value.is_finite() {
            continue;
        }
        let other = if toward.is_delta { 0.0 } else { vertex.bsdf.pdf(vertex.wo, wi) };
        let goal = Goal::of(world.lights, toward.emitter);
        // What a surface emits is known when it is found.
        let radiance = if let Goal::Surface(_) = goal { DVec3::ONE } else { toward.radiance };
        let weighed = path.throughput * value * radiance * (share(toward.pdf, other) / toward.pdf);
        shadows.push(Shadow { place: path.place, light: weighed, goal });
        let ray = vertex.leave(wi, toward.direction, toward.distance * SHORT_OF_TARGET, numbers);
        rays.push(Flight { passing: goal.passing(), ..ray });
    }
    world.fly(rays, From::Elsewhere, met);
    arrive(world, shadows, rays, met, |place, arriving| light[place] += arriving);
}

/// Hands over what arrives by rays towards emitters, by what they met.
fn arrive<T: Trace>(
    world: &World<T>,
    shadows: &[Shadow],
    rays: &[Flight],
    met: &[Met],
    mut take: impl FnMut(usize, DVec3),
) {
    let mut glowing = Vec::new();
    for (k, (shadow, met)) in shadows.iter().zip(met).enumerate() {
        match *met {
            _ if !shadow.goal.is_found(met) => {}
            Met::Surface(hit, _) => glowing.push((k, hit)),
            Met::Ball(..) | Met::Nothing => take(shadow.place, shadow.light * rays[k].left),
        }
    }
    let places: Vec<(u32, DVec3)> = glowing.iter().map(|&(k, hit)| (hit.surface, rays[k].ray.at(hit.t))).collect();
    let mut matter = Vec::new();
    world.matter(&places, &mut matter);
    for (&(k, _), matter) in glowing.iter().zip(&matter) {
        take(shadows[k].place, shadows[k].light * rays[k].left * matter.emission);
    }
}

/// Goes on from every vertex as its surface scatters, into `on`.
fn scatter(room: &mut PathRoom, first: u32, event: u32) {
    let PathRoom { now: Travel { paths, flights }, on, found, .. } = room;
    on.clear();
    for vertex in &*found {
        let (path, numbers) = (&paths[vertex.path], flights[vertex.path].numbers);
        let onward = vertex.scatter(path.throughput, numbers, first + 2, Transport::Radiance);
        let Some(Onward { sample, mut throughput, flight }) = onward else { continue };
        if event >= SURE_EVENTS {
            let survival = throughput.max_element().clamp(LEAST_SURVIVAL, 1.0);
            if numbers.at(first + 3)[1] >= survival {
                continue;
            }
            throughput /= survival;
        }
        let pdf = if sample.is_specular { f64::INFINITY } else { sample.pdf };
        on.push(Path { place: path.place, throughput, pdf, from: vertex.point, is_from_eye: false }, flight);
    }
}

/// The share of a way of this density where another way finds the same with the other density.
fn share(pdf: f64, other: f64) -> f64 {
    if other == 0.0 || pdf == f64::INFINITY {
        return 1.0;
    }
    let ratio = other / pdf;
    1.0 / (1.0 + ratio * ratio)
}

/// The numbers of the place in the pixel.
pub fn pixel_numbers(numbers: &Numbers) -> [f64; 2] {
    numbers.at(0)
}
