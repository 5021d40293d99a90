//! A point where a path scatters.
//!
//! In: a flight and the surface it met. Out: the frame, the bsdf, the light emitted there, and how a path goes on on either side.

use super::balance::Balance;
use super::bsdf::{Bsdf, Sample, Transport};
use super::media::{Boundary, Media};
use super::warp::Frame;
use super::world::{Flight, Matter, Met, Numbers, World};
use crate::render::trace::Trace;
use crate::scene::material::Kind;
use crate::surface::{Hit, Ray, Side};
use glam::DVec3;

/// A point of a surface that a path arrives at.
#[derive(Clone, Copy, Debug)]
pub struct Vertex {
    /// Which of the paths of a batch.
    pub path: usize,
    /// The root.
    pub point: DVec3,
    /// Around the normal, turned to where the path comes from.
    pub frame: Frame,
    /// Back along the path, in that frame.
    pub wo: DVec3,
    /// Of which kind the surface is, seen from the medium in front.
    pub kind: Kind,
    /// How it scatters.
    pub bsdf: Bsdf,
    /// Albedo or tint.
    pub color: DVec3,
    /// The refractive index behind over that in front; 1 where nothing is clear.
    pub relative_ior: f64,
    /// The light emitted towards where the path comes from.
    pub emission: DVec3,
    /// What was hit.
    pub hit: Hit,
    /// By which ray.
    pub ray: Ray,
    /// The media in front and behind.
    media: [Media; 2],
    /// A point in front of the surface, and one behind.
    starts: [DVec3; 2],
    /// Surfaces passed so far.
    passes: u32,
}

impl Vertex {
    /// The same point, of another path of a batch.
    pub fn of_path(self, path: usize) -> Self {
        Vertex { path, ..self }
    }

    /// The cosine at which the path arrives.
    pub fn cosine(&self) -> f64 {
        self.wo.z
    }

    /// A direction of the world in the frame.
    pub fn local(&self, direction: DVec3) -> DVec3 {
        self.frame.local_from_world(direction)
    }

    /// f and the cosine towards a direction of the frame.
    pub fn value(&self, wi: DVec3, transport: Transport) -> DVec3 {
        self.bsdf.value(self.wo, wi, transport) * wi.z.abs()
    }

    /// How other ways weigh behind this point, of a path that goes on as sampled.
    pub fn balance_behind(&self, balance: Balance, sample: &Sample) -> Balance {
        let cosine = sample.wi.z.abs();
        if sample.is_specular {
            return balance.reflect(cosine);
        }
        balance.scatter(sample.pdf, self.bsdf.reverse_pdf(self.wo, sample.wi), cosine)
    }

    /// Where a ray in a direction of the frame starts.
    pub fn start(&self, wi: DVec3) -> DVec3 {
        self.starts[usize::from(wi.z < 0.0)]
    }

    /// Goes on as the surface scatters, chosen by three numbers from this dimension on; `None`: all is absorbed.
    pub fn scatter(&self, throughput: DVec3, numbers: Numbers, dimension: u32, transport: Transport) -> Option<Onward> {
        let ([u, v], [w, _]) = (numbers.at(dimension), numbers.at(dimension + 1));
        let sample = self.bsdf.sample(self.wo, [u, v, w], transport)?;
        let throughput = throughput * sample.weight;
        let has_light = throughput != DVec3::ZERO && throughput.is_finite();
        has_light.then(|| Onward { sample, throughput, flight: self.go_on(sample.wi, numbers) })
    }

    /// A flight that goes on in a direction of the frame.
    pub fn go_on(&self, wi: DVec3, numbers: Numbers) -> Flight {
        let direction = self.frame.world_from_local(wi).normalize();
        self.leave(wi, direction, f64::INFINITY, numbers)
    }

    /// A flight in a direction of the frame, which is `direction` in the world; at most up to `end`.
    pub fn leave(&self, wi: DVec3, direction: DVec3, end: f64, numbers: Numbers) -> Flight {
        let side = usize::from(wi.z < 0.0);
        let ray = Ray { end, ..Ray::new(self.starts[side], direction) };
        Flight { passes: self.passes, ..Flight::new(ray, self.media[side], numbers) }
    }
}

/// How a path goes on behind a point.
#[derive(Clone, Copy, Debug)]
pub struct Onward {
    /// In which direction, and how likely.
    pub sample: Sample,
    /// What it carries from here.
    pub throughput: DVec3,
    /// Its next flight.
    pub flight: Flight,
}

/// Paths with their flights, in the same order.
#[derive(Debug)]
pub struct Travel<P> {
    /// What each carries and knows.
    pub paths: Vec<P>,
    /// Where each is.
    pub flights: Vec<Flight>,
}

impl<P> Default for Travel<P> {
    fn default() -> Self {
        Travel { paths: Vec::new(), flights: Vec::new() }
    }
}

impl<P> Travel<P> {
    /// Without any.
    pub fn clear(&mut self) {
        self.paths.clear();
        self.flights.clear();
    }

    /// One more.
    pub fn push(&mut self, path: P, flight: Flight) {
        self.paths.push(path);
        self.flights.push(flight);
    }
}

/// Room for batches of vertices, used again and again.
#[derive(Debug, Default)]
pub struct Arrivals {
    surfaces: Vec<(usize, Hit, Option<Boundary>)>,
    places: Vec<(u32, DVec3)>,
    matter: Vec<Matter>,
    departures: Vec<(Ray, Hit, Side)>,
    points: Vec<DVec3>,
}

impl Arrivals {
    fn clear(&mut self) {
        self.surfaces.clear();
        self.places.clear();
        self.departures.clear();
    }
}

/// The vertices at the surfaces that flights met, in their order; a vertex's `path` is the flight's place in the batch.
pub fn vertices<T: Trace>(world: &mut World<T>, flights: &[Flight], met: &[Met], out: &mut Vec<Vertex>) {
    let mut room = std::mem::take(&mut world.room.arrivals);
    room.clear();
    for (k, met) in met.iter().enumerate() {
        let (Met::Surface(hit, boundary), Flight { ray, left, .. }) = (*met, flights[k]) else { continue };
        if left == DVec3::ZERO {
            continue;
        }
        room.surfaces.push((k, hit, boundary));
        room.places.push((hit.surface, ray.at(hit.t)));
        room.departures.push((ray, hit, Side::Near));
        // Nothing goes through what is not clear.
        if boundary.is_some() {
            room.departures.push((ray, hit, Side::Far));
        }
    }
    world.matter(&room.places, &mut room.matter);
    world.tracer.starts(&room.departures, &mut room.points);
    let mut points = room.points.iter().copied();
    out.clear();
    for ((&(k, hit, boundary), place), matter) in room.surfaces.iter().zip(&room.places).zip(&room.matter) {
        let near = points.next().unwrap_or(place.1);
        let far = if boundary.is_some() { points.next().unwrap_or(place.1) } else { near };
        out.push(vertex(world, k, &flights[k], (hit, boundary), place.1, matter, [near, far]));
    }
    world.room.arrivals = room;
}

fn vertex<T: Trace>(
    world: &World<T>,
    path: usize,
    flight: &Flight,
    (hit, boundary): (Hit, Option<Boundary>),
    point: DVec3,
    matter: &Matter,
    starts: [DVec3; 2],
) -> Vertex {
    let normal = if hit.normal.is_finite() { hit.normal } else { -flight.ray.direction };
    let frame = Frame::around(normal);
    let mut wo = frame.local_from_world(-flight.ray.direction);
    // A normal of length 1 that is turned to the ray has a cosine of at least 0; rounding may make it a little less.
    wo.z = wo.z.max(f64::MIN_POSITIVE);
    let relative_ior = boundary.and_then(|boundary| boundary.relative_ior).unwrap_or(1.0);
    let kind = world.material(&hit).kind.inside(world.solids.ior(flight.media));
    let bsdf = Bsdf::new(&kind, matter.color, matter.roughness, relative_ior);
    let media = boundary.map_or([flight.media; 2], |boundary| [boundary.before, boundary.after]);
    let Flight { ray, passes, .. } = *flight;
    let Matter { color, emission, .. } = *matter;
    Vertex { path, point, frame, wo, kind, bsdf, color, relative_ior, emission, hit, ray, media, starts, passes }
}
