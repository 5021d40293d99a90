//! Mode `light`: light found by paths from the lights, connected to the camera: caustics.
//!
//! In: the numbers of samples. Out: the vertices of paths that left emitters; and what each of them shows to the camera, with the place in the
//! picture. What is seen without scattering is left to rays from the eye.

use super::balance::Balance;
use super::bsdf::Transport;
use super::lights::{Emitted, Emitter};
use super::path::{DIMENSIONS, FIRST_DIMENSION, SHORT_OF_TARGET};
use super::vertex::{Onward, Travel, Vertex, vertices};
use super::world::{Flight, From, Met, Numbers, Passing, World};
use crate::film::Size;
use crate::render::trace::Trace;
use glam::DVec3;

/// What makes the numbers of a light's paths others than those of the eye's.
const OF_LIGHTS: u64 = 0x5bd1_e995_7b1d_cafe;

/// A vertex of a path from a light.
#[derive(Clone, Copy, Debug)]
pub struct LightVertex {
    /// The point; its `path` is the sample's place in the batch.
    pub vertex: Vertex,
    /// The power that arrives there.
    pub throughput: DVec3,
    /// How other ways would have found it.
    pub balance: Balance,
    /// How many scattering events there are up to here, this one included.
    pub events: u32,
}

/// Light at a place of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Splat {
    /// In pixels from the upper left corner.
    pub place: [f64; 2],
    /// The light, for one path a pixel.
    pub light: DVec3,
}

/// A path on its way.
#[derive(Clone, Copy, Debug)]
struct Path {
    sample: usize,
    throughput: DVec3,
    balance: Balance,
    /// Until its first vertex, what it left.
    emitted: Option<Emitted>,
}

/// Room for batches of paths from lights, used again and again.
#[derive(Default)]
pub struct LightRoom {
    now: Travel<Path>,
    on: Travel<Path>,
    sought: Travel<Path>,
    met: Vec<Met>,
    found: Vec<Vertex>,
    shown: Vec<Splat>,
    rays: Vec<Flight>,
}

/// The vertices of one path a sample, of at most so many events, in the order of their events; `out` is replaced.
pub fn light_paths<T: Trace>(
    world: &mut World<T>,
    samples: &[Numbers],
    bounces: u32,
    room: &mut LightRoom,
    out: &mut Vec<LightVertex>,
) {
    out.clear();
    if bounces == 0 {
        return;
    }
    leave(world, samples, room);
    for event in 1..=bounces {
        let LightRoom { now: Travel { paths, flights }, met, found, .. } = room;
        world.fly(flights, From::Elsewhere, met);
        vertices(world, flights, met, found);
        let first = out.len();
        for vertex in &*found {
            let (path, flight) = (&mut paths[vertex.path], &flights[vertex.path]);
            path.throughput *= flight.left;
            let distance = flight.distance + vertex.hit.t;
            path.balance = match path.emitted.take() {
                Some(emitted) => first_balance(world, &emitted, vertex, distance, path),
                None => path.balance.arrive(distance, vertex.cosine()),
            };
            let Path { throughput, balance, sample, .. } = *path;
            let vertex = vertex.of_path(sample);
            out.push(LightVertex { vertex, throughput, balance, events: event });
        }
        if event == bounces || found.is_empty() {
            return;
        }
        let dimension = FIRST_DIMENSION + event * DIMENSIONS;
        scatter(samples, &out[first..], dimension, &mut room.on);
        std::mem::swap(&mut room.now, &mut room.on);
    }
}

/// Rays that leave emitters, one a sample.
fn leave<T: Trace>(world: &mut World<T>, samples: &[Numbers], room: &mut LightRoom) {
    room.now.clear();
    room.sought.clear();
    for (sample, numbers) in samples.iter().enumerate() {
        let numbers = of_lights(numbers);
        let (choice, place, aim) = (numbers.at(0), numbers.at(1), numbers.at(2));
        let Some(emitted) = world.lights.emit(choice, place, aim, numbers.at(3)[0]) else { continue };
        let flight = Flight::new(emitted.ray, world.media_at(emitted.ray.origin), numbers);
        let path = Path { sample, throughput: emitted.power, balance: Balance::default(), emitted: Some(emitted) };
        if matches!(world.lights.list[emitted.emitter], Emitter::Glow { .. }) {
            room.sought.push(path, flight);
        } else if emitted.power != DVec3::ZERO {
            room.now.push(path, flight);
        }
    }
    leave_surfaces(world, room);
}

/// Finds where on surfaces that glow the rays begin.
fn leave_surfaces<T: Trace>(world: &mut World<T>, room: &mut LightRoom) {
    let LightRoom { now, sought: Travel { paths: sought, flights: seekers }, met, found, .. } = room;
    world.fly(seekers, From::Elsewhere, met);
    vertices(world, seekers, met, found);
    for vertex in &*found {
        let Path { throughput, emitted: Some(emitted), .. } = sought[vertex.path] else { continue };
        let is_it = world.lights.of_surface(vertex.hit.surface) == Some(emitted.emitter);
        if !is_it || vertex.emission == DVec3::ZERO {
            continue;
        }
        // The way there and back through media: the light has only the way back, which the flight from here takes.
        let direction = -seekers[vertex.path].ray.direction;
        let seeker = &seekers[vertex.path];
        let flight = vertex.leave(vertex.wo, direction, f64::INFINITY, seeker.numbers);
        // What the seeker passed on its way here lets this through too: it is the same way.
        let flight = Flight { sure: seeker.distance + vertex.hit.t, ..flight };
        let emitted = Emitted { ray: flight.ray, cosine: vertex.cosine(), ..emitted };
        let throughput = throughput * vertex.emission;
        now.push(Path { throughput, emitted: Some(emitted), ..sought[vertex.path] }, flight);
    }
}

/// The balance at the first vertex; what glows learns there how likely its ray was.
fn first_balance<T: Trace>(
    world: &World<T>,
    emitted: &Emitted,
    vertex: &Vertex,
    distance: f64,
    path: &mut Path,
) -> Balance {
    let lights = world.lights;
    let (emitter, direction) = (emitted.emitter, -emitted.ray.direction);
    let mut emission_pdf = emitted.emission_pdf;
    if let Emitter::Glow { .. } = lights.list[emitter] {
        let length = lights.length_in_ball(emitter, &emitted.ray, distance);
        path.throughput /= length;
        emission_pdf = lights.emission_pdf(emitter, direction, emitted.cosine, length);
    }
    let toward = lights.pdf_toward(emitter, vertex.point, direction);
    let choice = lights.choice(emitter);
    // The density of finding the light from here: per area of it, or per solid angle if it is far.
    let (connected, reversed) = match lights.list[emitter] {
        Emitter::Point { .. } => (choice * distance * distance, 0.0),
        Emitter::Parallel { .. } => (choice, 0.0),
        Emitter::Disc { .. } | Emitter::Sky(_) => (toward, 1.0),
        Emitter::Ball { .. } | Emitter::Glow { .. } => (toward * emitted.cosine, emitted.cosine),
    };
    let balance = Balance { connected: connected / emission_pdf, reversed: reversed / emission_pdf };
    balance.arrive_from_afar(vertex.cosine())
}

/// Goes on from every vertex as its surface scatters, into `on`.
fn scatter(samples: &[Numbers], found: &[LightVertex], first: u32, on: &mut Travel<Path>) {
    on.clear();
    for LightVertex { vertex, throughput, balance, .. } in found {
        let numbers = of_lights(&samples[vertex.path]);
        let onward = vertex.scatter(*throughput, numbers, first, Transport::Importance);
        let Some(Onward { sample, throughput, flight }) = onward else { continue };
        let balance = vertex.balance_behind(*balance, &sample);
        on.push(Path { sample: vertex.path, throughput, balance, emitted: None }, flight);
    }
}

/// The numbers of the path from a light that belongs to a sample.
fn of_lights(numbers: &Numbers) -> Numbers {
    Numbers { seed: numbers.seed ^ OF_LIGHTS, ..*numbers }
}

/// What light vertices show to the camera. With `is_weighed` each counts by how likely other ways were to find it, where there are as many
/// paths from the eye; else it is all there is.
pub fn splats<T: Trace>(
    world: &mut World<T>,
    list: &[LightVertex],
    samples: &[Numbers],
    size: Size,
    is_weighed: bool,
    room: &mut LightRoom,
    out: &mut Vec<Splat>,
) {
    let count = f64::from(size.width()) * f64::from(size.height());
    let LightRoom { shown, rays, met, .. } = room;
    shown.clear();
    rays.clear();
    for LightVertex { vertex, throughput, balance, .. } in list.iter().filter(|v| !v.vertex.bsdf.is_specular()) {
        let Some(seen) = world.scene.camera.see(size.width(), size.height(), vertex.point) else { continue };
        let wi = vertex.local(seen.direction);
        let value = vertex.value(wi, Transport::Importance);
        if value == DVec3::ZERO || !value.is_finite() {
            continue;
        }
        let pixels_per_area = seen.pixels_per_solid_angle / (seen.distance * seen.distance);
        let ratio = if is_weighed {
            let reverse = vertex.bsdf.reverse_pdf(vertex.wo, wi);
            balance.ratio(pixels_per_area * wi.z.abs() / count, reverse)
        } else {
            0.0
        };
        let light = *throughput * value * (pixels_per_area / (count * (1.0 + ratio)));
        shown.push(Splat { place: seen.place, light });
        let numbers = of_lights(&samples[vertex.path]);
        let ray = vertex.leave(wi, seen.direction, seen.distance * SHORT_OF_TARGET, numbers);
        rays.push(Flight { passing: Passing::ByShare, ..ray });
    }
    world.fly(rays, From::Elsewhere, met);
    for ((splat, ray), met) in shown.iter().zip(&*rays).zip(&*met) {
        if let Met::Nothing = met {
            out.push(Splat { light: splat.light * ray.left, ..*splat });
        }
    }
}
