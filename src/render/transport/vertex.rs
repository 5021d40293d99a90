//! A point where a path scatters.
//!
//! In: a flight and the surface it met. Out: the frame, the bsdf, the light emitted there, and how a path goes on on either side.

use super::balance::Balance;
use super::bsdf::{Bsdf, Sample, Transport};
use super::media::{Boundary, Media};
use super::warp::Frame;
use super::world::{Flight, Matter, Met, Numbers, World};
use crate::render::trace::Trace;
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

    /// A flight in a direction of the frame, which is `direction` in the world; at most up to `end`.
    pub fn leave(&self, wi: DVec3, direction: DVec3, end: f64, numbers: Numbers) -> Flight {
        let side = usize::from(wi.z < 0.0);
        let ray = Ray { end, ..Ray::new(self.starts[side], direction) };
        Flight { passes: self.passes, ..Flight::new(ray, self.media[side], numbers) }
    }
}

/// The vertices at the surfaces that flights met, in their order; a vertex's `path` is the flight's place in the batch.
pub fn vertices<T: Trace>(world: &mut World<T>, flights: &[Flight], met: &[Met], out: &mut Vec<Vertex>) {
    let surfaces: Vec<(usize, Hit, Option<Boundary>)> = met
        .iter()
        .enumerate()
        .filter_map(|(k, met)| match *met {
            Met::Surface(hit, boundary) if flights[k].left != DVec3::ZERO => Some((k, hit, boundary)),
            _ => None,
        })
        .collect();
    let places: Vec<(u32, DVec3)> =
        surfaces.iter().map(|(k, hit, _)| (hit.surface, flights[*k].ray.at(hit.t))).collect();
    let mut matter = Vec::new();
    world.matter(&places, &mut matter);
    let both = |(k, hit, boundary): &(usize, Hit, Option<Boundary>)| {
        // Nothing goes through what is not clear.
        let far = boundary.is_some().then_some((flights[*k].ray, *hit, Side::Far));
        std::iter::once((flights[*k].ray, *hit, Side::Near)).chain(far)
    };
    let departures: Vec<(Ray, Hit, Side)> = surfaces.iter().flat_map(both).collect();
    let mut points = Vec::new();
    world.tracer.starts(&departures, &mut points);
    let mut points = points.into_iter();
    out.clear();
    for ((&(k, hit, boundary), place), matter) in surfaces.iter().zip(&places).zip(&matter) {
        let near = points.next().unwrap_or(place.1);
        let far = if boundary.is_some() { points.next().unwrap_or(place.1) } else { near };
        out.push(vertex(world, k, &flights[k], (hit, boundary), place.1, matter, [near, far]));
    }
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
    let bsdf = Bsdf::new(&world.material(&hit).kind, matter.color, matter.roughness, relative_ior);
    let media = boundary.map_or([flight.media; 2], |boundary| [boundary.before, boundary.after]);
    let Flight { ray, passes, .. } = *flight;
    let Matter { color, emission, .. } = *matter;
    Vertex { path, point, frame, wo, bsdf, color, relative_ior, emission, hit, ray, media, starts, passes }
}
