//! Mode `bidirectional`: paths from the camera and from the lights, joined in every way there is.
//!
//! In: rays from the eye, the numbers of their samples. Out: the radiance that they find, and what their partners from the lights show to
//! the camera. A path of light can be found by as many ways as it has pieces; each counts by how likely it was
//! (Veach 1997, chapter 10; the weights in [`super::balance`]).

use super::balance::Balance;
use super::bsdf::Transport;
use super::light::{LightRoom, LightVertex, Splat, light_paths, splats};
use super::lights::{Emitter, Toward};
use super::path::{DIMENSIONS, FIRST_DIMENSION, Goal, SHORT_OF_TARGET};
use super::vertex::{Onward, Travel, Vertex, vertices};
use super::world::{Flight, From, Met, Numbers, Passing, World};
use crate::film::Size;
use crate::render::trace::Trace;
use glam::DVec3;

/// A path from the eye on its way.
#[derive(Clone, Copy, Debug)]
struct Path {
    sample: usize,
    throughput: DVec3,
    balance: Balance,
    /// Where it left the last surface; `None` at the eye.
    from: Option<DVec3>,
    /// From the eye of parallel rays: the distance does not matter.
    is_parallel: bool,
}

/// A vertex of such a path.
#[derive(Clone, Copy)]
struct EyeVertex<'a> {
    vertex: &'a Vertex,
    path: &'a Path,
    numbers: Numbers,
    /// Which scattering event it is, from 1.
    event: u32,
}

/// A ray that joins two ends, and what it brings if nothing is in the way.
struct Join {
    sample: usize,
    light: DVec3,
    goal: Goal,
    /// Of a surface that is sought, what is weighed when it is found.
    surface: Option<Sought>,
}

/// What the weight of a surface that is found needs.
struct Sought {
    emitter: usize,
    toward: Toward,
    pdf: f64,
    back: f64,
}

/// Room for batches of paths from both ends, used again and again.
#[derive(Default)]
pub struct BothRoom {
    samples: Vec<Numbers>,
    partners: Vec<LightVertex>,
    from_lights: LightRoom,
    now: Travel<Path>,
    on: Travel<Path>,
    met: Vec<Met>,
    found: Vec<Vertex>,
    joining: Joining,
}

/// Room for the rays that join.
#[derive(Default)]
struct Joining {
    joins: Vec<Join>,
    rays: Vec<Flight>,
    met: Vec<Met>,
    found: Vec<Vertex>,
    reached: Vec<usize>,
}

/// The radiance that arrives along each ray, in `light`, and more light at places of the picture, in `shown`; both are replaced.
pub fn radiance<T: Trace>(
    world: &mut World<T>,
    eye: &[Flight],
    size: Size,
    bounces: u32,
    room: &mut BothRoom,
    (light, shown): (&mut Vec<DVec3>, &mut Vec<Splat>),
) {
    light.clear();
    light.resize(eye.len(), DVec3::ZERO);
    shown.clear();
    show_lights(world, eye, (size, bounces), true, room, shown);
    let BothRoom { partners, now, on, met, found, joining, .. } = room;
    // By sample, so that those of one lie together.
    partners.sort_by_key(|partner| (partner.vertex.path, partner.events));
    now.clear();
    eye.iter().enumerate().for_each(|(sample, flight)| now.push(start(world, size, sample, flight), *flight));
    for event in 1..=bounces + 1 {
        let from = if event == 1 { From::Eye } else { From::Elsewhere };
        let Travel { paths, flights } = &mut *now;
        world.fly(flights, from, met);
        for ((path, flight), met) in paths.iter_mut().zip(&*flights).zip(&*met) {
            path.throughput *= flight.left;
            light[path.sample] += path.throughput * seen(world, path, flight, met);
        }
        vertices(world, flights, met, found);
        for vertex in &*found {
            let (path, flight) = (&mut paths[vertex.path], &flights[vertex.path]);
            light[path.sample] += path.throughput * glow(world, path, flight, vertex);
            let distance = flight.distance + vertex.hit.t;
            path.balance = match path.is_parallel {
                true => path.balance.arrive_from_afar(vertex.cosine()),
                false => path.balance.arrive(distance, vertex.cosine()),
            };
            path.is_parallel = false;
        }
        if event > bounces || found.is_empty() {
            return;
        }
        let first = FIRST_DIMENSION + (event - 1) * DIMENSIONS;
        let ends = found.iter().map(|vertex| {
            let (path, numbers) = (&paths[vertex.path], flights[vertex.path].numbers);
            EyeVertex { vertex, path, numbers, event }
        });
        join(world, ends.clone(), partners, (first, bounces), joining, light);
        scatter(ends, first, on);
        std::mem::swap(now, on);
    }
}

/// A path from a light for every ray from the eye, and what it shows to the camera; with `is_weighed` as one way among others.
pub fn show_lights<T: Trace>(
    world: &mut World<T>,
    eye: &[Flight],
    (size, bounces): (Size, u32),
    is_weighed: bool,
    room: &mut BothRoom,
    shown: &mut Vec<Splat>,
) {
    let BothRoom { samples, partners, from_lights, .. } = room;
    samples.clear();
    samples.extend(eye.iter().map(|flight| flight.numbers));
    light_paths(world, samples, bounces, from_lights, partners);
    splats(world, partners, samples, size, is_weighed, from_lights, shown);
}

fn start<T: Trace>(world: &World<T>, size: Size, sample: usize, flight: &Flight) -> Path {
    let count = f64::from(size.width()) * f64::from(size.height());
    let ahead = flight.ray.at(1.0);
    let seen = world.scene.camera.see(size.width(), size.height(), ahead);
    let pixels = seen.map_or(1.0, |seen| seen.pixels_per_solid_angle / (seen.distance * seen.distance));
    let balance = Balance { connected: count / pixels, reversed: 0.0 };
    Path { sample, throughput: DVec3::ONE, balance, from: None, is_parallel: world.scene.camera.is_parallel() }
}

/// The light of balls and of what is far that a flight met, weighed.
fn seen<T: Trace>(world: &World<T>, path: &Path, flight: &Flight, met: &Met) -> DVec3 {
    let direction = flight.ray.direction;
    let weighed = |emitter: usize, radiance: DVec3, cosine: f64| {
        radiance * weight_of_emission(world, path, emitter, direction, (cosine, 0.0))
    };
    match *met {
        Met::Surface(..) => DVec3::ZERO,
        Met::Ball(emitter, t) => {
            let (radiance, cosine) = world.lights.ball_radiance(emitter, &flight.ray, t);
            weighed(emitter, radiance, cosine)
        }
        Met::Nothing if path.from.is_none() && world.hides_sky => DVec3::ZERO,
        Met::Nothing => world.lights.far(direction).map(|(emitter, radiance)| weighed(emitter, radiance, 1.0)).sum(),
    }
}

/// The light that a surface emits, weighed.
fn glow<T: Trace>(world: &World<T>, path: &Path, flight: &Flight, vertex: &Vertex) -> DVec3 {
    let Some(emitter) = world.lights.of_surface(vertex.hit.surface).filter(|_| vertex.emission != DVec3::ZERO) else {
        return DVec3::ZERO;
    };
    let direction = flight.ray.direction;
    let back = crate::surface::Ray::new(vertex.point, -direction);
    let length = world.lights.length_in_ball(emitter, &back, flight.distance + vertex.hit.t);
    vertex.emission * weight_of_emission(world, path, emitter, direction, (vertex.cosine(), length))
}

/// The weight of light that a path from the eye ran into, met with this cosine.
fn weight_of_emission<T: Trace>(
    world: &World<T>,
    path: &Path,
    emitter: usize,
    direction: DVec3,
    (cosine, length): (f64, f64),
) -> f64 {
    let Some(from) = path.from else { return 1.0 };
    let toward = world.lights.pdf_toward(emitter, from, direction);
    let emission = world.lights.emission_pdf(emitter, direction, cosine, length);
    1.0 / (1.0 + toward * path.balance.connected + emission * path.balance.reversed / cosine)
}

/// Joins the vertices of one event to emitters and to the vertices of their partners.
fn join<'a, T: Trace>(
    world: &mut World<T>,
    ends: impl Iterator<Item = EyeVertex<'a>>,
    partners: &[LightVertex],
    (first, bounces): (u32, u32),
    room: &mut Joining,
    light: &mut [DVec3],
) {
    let Joining { joins, rays, met, found, reached } = room;
    joins.clear();
    rays.clear();
    reached.clear();
    for end in ends.filter(|end| !end.vertex.bsdf.is_specular()) {
        join_emitter(world, &end, first, joins, rays);
        let sample = end.path.sample;
        let start = partners.partition_point(|partner| partner.vertex.path < sample);
        let own = partners[start..].iter().take_while(|partner| partner.vertex.path == sample);
        for partner in own.filter(|partner| end.event + partner.events <= bounces) {
            join_partner(&end, partner, joins, rays);
        }
    }
    world.fly(rays, From::Elsewhere, met);
    for (k, (join, met)) in joins.iter().zip(&*met).enumerate() {
        match met {
            _ if !join.goal.is_found(met) => {}
            Met::Surface(..) => reached.push(k),
            Met::Ball(..) | Met::Nothing => light[join.sample] += join.light * rays[k].left,
        }
    }
    vertices(world, rays, met, found);
    let mut of_ray = found.iter().peekable();
    for &k in &*reached {
        while of_ray.next_if(|vertex| vertex.path < k).is_some() {}
        let (Some(vertex), Some(sought)) = (of_ray.next_if(|vertex| vertex.path == k), &joins[k].surface) else {
            continue;
        };
        light[joins[k].sample] += joins[k].light * rays[k].left * found_glow(world, sought, vertex, &rays[k]);
    }
}

/// What a ray that sought a surface found of it, weighed.
fn found_glow<T: Trace>(world: &World<T>, sought: &Sought, vertex: &Vertex, ray: &Flight) -> DVec3 {
    let back = crate::surface::Ray::new(vertex.point, -sought.toward.direction);
    let length = world.lights.length_in_ball(sought.emitter, &back, ray.distance + vertex.hit.t);
    let cosine = vertex.cosine();
    let emission = world.lights.emission_pdf(sought.emitter, sought.toward.direction, cosine, length);
    let ratio = sought.pdf / sought.toward.pdf + emission / (sought.toward.pdf * cosine) * sought.back;
    vertex.emission / (1.0 + ratio)
}

fn join_emitter<T: Trace>(
    world: &World<T>,
    end: &EyeVertex,
    first: u32,
    joins: &mut Vec<Join>,
    rays: &mut Vec<Flight>,
) {
    let EyeVertex { vertex, path, numbers, .. } = *end;
    let Some(toward) = world.lights.toward(vertex.point, numbers.at(first), numbers.at(first + 1)) else { return };
    let wi = vertex.local(toward.direction);
    let value = vertex.value(wi, Transport::Radiance);
    if value == DVec3::ZERO || !value.is_finite() {
        return;
    }
    let pdf = if toward.is_delta { 0.0 } else { vertex.bsdf.pdf(vertex.wo, wi) };
    let reverse = vertex.bsdf.reverse_pdf(vertex.wo, wi);
    let back = path.balance.ratio(wi.z.abs(), reverse);
    let arriving = path.throughput * value / toward.pdf;
    let mut ray = vertex.leave(wi, toward.direction, toward.distance * SHORT_OF_TARGET, numbers);
    let (light, surface) = match world.lights.list[toward.emitter] {
        Emitter::Glow { .. } => (arriving, Some(Sought { emitter: toward.emitter, toward, pdf, back })),
        Emitter::Point { .. } => {
            // Per area of a point there is no density; per solid angle seen from here it is its square distance.
            let density = toward.pdf * toward.distance * toward.distance;
            (arriving * toward.radiance / (1.0 + toward.emission_pdf / density * back), None)
        }
        _ => {
            let ratio = pdf / toward.pdf + toward.emission_pdf / (toward.pdf * toward.cosine) * back;
            (arriving * toward.radiance / (1.0 + ratio), None)
        }
    };
    let goal = Goal::of(world.lights, toward.emitter);
    ray.passing = goal.passing();
    joins.push(Join { sample: path.sample, light, goal, surface });
    rays.push(ray);
}

fn join_partner(end: &EyeVertex, partner: &LightVertex, joins: &mut Vec<Join>, rays: &mut Vec<Flight>) {
    let (eye, other) = (end.vertex, &partner.vertex);
    let way = other.point - eye.point;
    let squared = way.length_squared();
    let direction = way / squared.sqrt();
    let (wi, wj) = (eye.local(direction), other.local(-direction));
    if other.bsdf.is_specular() || !direction.is_finite() {
        return;
    }
    let values = eye.value(wi, Transport::Radiance) * other.value(wj, Transport::Importance);
    if values == DVec3::ZERO || !values.is_finite() {
        return;
    }
    let to_other = eye.bsdf.pdf(eye.wo, wi) * wj.z.abs() / squared;
    let to_eye = other.bsdf.pdf(other.wo, wj) * wi.z.abs() / squared;
    let of_light = partner.balance.ratio(to_other, other.bsdf.reverse_pdf(other.wo, wj));
    let of_eye = end.path.balance.ratio(to_eye, eye.bsdf.reverse_pdf(eye.wo, wi));
    let light = end.path.throughput * partner.throughput * values / (squared * (1.0 + of_light + of_eye));
    let (start, goal) = (eye.start(wi), other.start(wj));
    let between = goal - start;
    let distance = between.length();
    let ray = eye.leave(wi, between / distance, distance * SHORT_OF_TARGET, end.numbers);
    joins.push(Join { sample: end.path.sample, light, goal: Goal::Free, surface: None });
    rays.push(Flight { passing: Passing::ByShare, ..ray });
}

/// Goes on from every vertex as its surface scatters, into `on`.
fn scatter<'a>(ends: impl Iterator<Item = EyeVertex<'a>>, first: u32, on: &mut Travel<Path>) {
    on.clear();
    for EyeVertex { vertex, path, numbers, .. } in ends {
        let onward = vertex.scatter(path.throughput, numbers, first + 2, Transport::Radiance);
        let Some(Onward { sample, throughput, flight }) = onward else { continue };
        let balance = vertex.balance_behind(path.balance, &sample);
        on.push(Path { throughput, balance, from: Some(vertex.point), ..*path }, flight);
    }
}
