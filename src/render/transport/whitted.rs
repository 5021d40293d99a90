//! Mode `whitted`: shadows, mirrored and refracted rays, all of them sharp (Whitted 1980, "An improved illumination model for shaded
//! display").
//!
//! In: rays from the eye. Out: the light of each. Nothing is chosen by chance: where a ray is both mirrored and refracted, both are
//! followed, each with its share by Fresnel. Lights are points, roughness makes highlights only, and what is around gives an even light.

use super::bsdf::{Transport, direction, fresnel};
use super::lights::Lights;
use super::path::{Goal, SHORT_OF_TARGET};
use super::vertex::{Vertex, vertices};
use super::world::{Flight, From, Met, Passing, World};
use crate::render::trace::Trace;
use crate::scene::material::Kind;
use crate::scene::{Light, Scene, studio};
use glam::DVec3;
use std::f64::consts::PI;

/// A ray that stands for less of a pixel's light than this is not followed: a quarter of the least step that eight bits show.
const LEAST_SHARE: f64 = 1e-3;

/// What the light over the shoulder gives where a scene has no light of its own, over π; and the share of the surroundings.
const SHOULDER: [f64; 2] = [0.8, 0.25];

/// A far or near light, without size; a ray towards it has to find its ball, if it has one, or nothing up to its distance.
struct Lamp {
    toward: DVec3,
    distance: f64,
    irradiance: DVec3,
    goal: Goal,
}

/// The light that arrives along each ray, in `light`, which is replaced; of at most so many events.
pub fn radiance<T: Trace>(world: &mut World<T>, eye: &[Flight], bounces: u32, light: &mut Vec<DVec3>) {
    light.clear();
    light.resize(eye.len(), DVec3::ZERO);
    let mut flights = eye.to_vec();
    flights.iter_mut().for_each(|flight| flight.passing = Passing::BothWays);
    let mut shares: Vec<(usize, DVec3)> = (0..eye.len()).map(|place| (place, DVec3::ONE)).collect();
    let (mut met, mut found) = (Vec::new(), Vec::new());
    let around = world.scene.sky.as_ref().map_or(DVec3::ZERO, |sky| super::sky::SkyTable::new(sky).mean);
    for event in 0..=bounces {
        let from = if event == 0 { From::Eye } else { From::Elsewhere };
        world.fly(&mut flights, from, &mut met);
        for &(k, flight, surface) in world.stayed() {
            shares.push(shares[k]);
            flights.push(flight);
            met.push(surface);
        }
        for (((place, share), flight), met) in shares.iter_mut().zip(&flights).zip(&met) {
            *share *= flight.left;
            light[*place] += *share * seen(world.lights, flight, met, event == 0 && world.hides_sky);
        }
        vertices(world, &flights, &met, &mut found);
        for vertex in &found {
            light[shares[vertex.path].0] += shares[vertex.path].1 * vertex.emission;
        }
        if event == bounces || found.is_empty() {
            return;
        }
        shine(world, &found, &shares, (&flights, around), light);
        let mut next = (Vec::new(), Vec::new());
        for vertex in &found {
            let (place, share) = shares[vertex.path];
            for (wi, part) in branches(vertex) {
                let share = share * part;
                if share.max_element() >= LEAST_SHARE {
                    let flight = vertex.go_on(wi, flights[vertex.path].numbers);
                    next.0.push((place, share));
                    next.1.push(Flight { passing: Passing::BothWays, ..flight });
                }
            }
        }
        (shares, flights) = next;
    }
}

fn seen(lights: &Lights, flight: &Flight, met: &Met, hides_sky: bool) -> DVec3 {
    match *met {
        Met::Surface(..) => DVec3::ZERO,
        Met::Ball(emitter, t) => lights.ball_radiance(emitter, &flight.ray, t).0,
        Met::Nothing if hides_sky => DVec3::ZERO,
        Met::Nothing => lights.far(flight.ray.direction).map(|(_, radiance)| radiance).sum(),
    }
}

/// The light of lamps and of what is around.
fn shine<T: Trace>(
    world: &mut World<T>,
    found: &[Vertex],
    shares: &[(usize, DVec3)],
    (flights, around): (&[Flight], DVec3),
    light: &mut [DVec3],
) {
    let (mut rays, mut arriving) = (Vec::new(), Vec::new());
    let around = if world.scene.lights.is_empty() { around * SHOULDER[1] } else { around };
    for vertex in found {
        let (place, share) = shares[vertex.path];
        if matches!(vertex.kind, Kind::Matte | Kind::Plastic { .. }) {
            light[place] += share * vertex.color * around;
        }
        for lamp in lamps(world.scene, vertex.point) {
            let wi = vertex.local(lamp.toward);
            let value = vertex.value(wi, Transport::Radiance);
            if value != DVec3::ZERO && value.is_finite() {
                arriving.push((place, share * value * lamp.irradiance, lamp.goal));
                let ray = vertex.leave(wi, lamp.toward, lamp.distance, flights[vertex.path].numbers);
                rays.push(Flight { passing: Passing::ByShare, ..ray });
            }
        }
    }
    let mut met = Vec::new();
    world.fly(&mut rays, From::Elsewhere, &mut met);
    for (((place, part, goal), ray), met) in arriving.into_iter().zip(&rays).zip(&met) {
        if goal.is_found(met) {
            light[place] += part * ray.left;
        }
    }
}

/// The lights as they are seen from a point, without their size.
fn lamps(scene: &Scene, from: DVec3) -> Vec<Lamp> {
    if scene.lights.is_empty() {
        return vec![far_lamp(studio::shoulder(&scene.camera), DVec3::splat(SHOULDER[0] * PI))];
    }
    let lamp = |(emitter, light): (usize, &Light)| match *light {
        Light::Point { at, power } => near_lamp(at - from, power, Goal::Free),
        Light::Ball { center, power, .. } => near_lamp(center - from, power, Goal::Ball(emitter)),
        Light::Sun { toward, irradiance, .. } => far_lamp(toward, irradiance),
    };
    scene.lights.iter().enumerate().map(lamp).collect()
}

fn far_lamp(toward: DVec3, irradiance: DVec3) -> Lamp {
    Lamp { toward, distance: f64::INFINITY, irradiance, goal: Goal::Free }
}

fn near_lamp(way: DVec3, power: DVec3, goal: Goal) -> Lamp {
    let distance = way.length();
    let irradiance = power / (4.0 * PI * distance * distance);
    Lamp { toward: way / distance, distance: distance * SHORT_OF_TARGET, irradiance, goal }
}

/// The sharp rays that go on from a vertex, with their shares.
fn branches(vertex: &Vertex) -> Vec<(DVec3, DVec3)> {
    let wo = vertex.wo;
    let mirrored = direction::reflected(wo, DVec3::Z);
    match vertex.kind {
        Kind::Matte => Vec::new(),
        Kind::Mirror => vec![(mirrored, vertex.color)],
        Kind::Metal(Some(conductor)) => vec![(mirrored, fresnel::Metallic::Measured(conductor).share(wo.z))],
        Kind::Metal(None) => vec![(mirrored, fresnel::Metallic::Tint(vertex.color).share(wo.z))],
        Kind::Plastic { ior } => vec![(mirrored, DVec3::splat(fresnel::dielectric(wo.z, ior.max(1.0))))],
        Kind::Glass(_) => {
            let ior = vertex.relative_ior;
            let reflected = fresnel::dielectric(wo.z, ior);
            let beyond = DVec3::new(-wo.x / ior, -wo.y / ior, -fresnel::cosine_beyond(wo.z, ior));
            let all = [(mirrored, reflected), (beyond, 1.0 - reflected)];
            all.into_iter().filter(|part| part.1 > 0.0).map(|(wi, part)| (wi, DVec3::splat(part))).collect()
        }
    }
}
