//! Modes `angle`, `end`, `bounces`: what becomes of a ray where every surface is a mirror.
//!
//! In: rays from the eye and what they hit. Out: the angle at which each is mirrored first; what it ends on; how often it is mirrored. What
//! one tries first when rays have learnt to reflect.

use super::cosine::NOTHING;
use super::data::scale;
use super::integrator::{facing_normal, pixel, sides};
use super::settings::Mode;
use super::trace::Trace;
use crate::num::func::native;
use crate::scene::Scene;
use crate::surface::{Hit, Ray, Side};
use glam::DVec3;
use std::f64::consts::FRAC_PI_2;

/// What became of a ray.
#[derive(Clone, Copy, Debug)]
struct Trail {
    ray: Ray,
    hit: Hit,
    bounces: u32,
}

/// The colour of every ray, of at most so many reflections, in `colours`, which is replaced.
pub fn colours<T: Trace>(
    mode: Mode,
    scene: &Scene,
    tracer: &mut T,
    seen: (&[Ray], &[Hit]),
    most: u32,
    colours: &mut Vec<[f32; 3]>,
) {
    colours.clear();
    let rays = seen.0.iter().zip(seen.1);
    if mode == Mode::Angle {
        colours.extend(rays.map(|(ray, hit)| angle(ray, hit)));
        return;
    }
    let mut trails: Vec<Trail> = rays.map(|(&ray, &hit)| Trail { ray, hit, bounces: 0 }).collect();
    follow(tracer, &mut trails, most);
    let (last_rays, last_hits): (Vec<Ray>, Vec<Hit>) = trails.iter().map(|trail| (trail.ray, trail.hit)).unzip();
    let sides = sides(scene, &last_rays, &last_hits);
    colours.extend(trails.iter().zip(seen.1).zip(sides).map(|((trail, first), side)| match mode {
        _ if !first.is_drawn() => NOTHING,
        Mode::End => end(trail, side),
        _ => scale(f64::from(trail.bounces) / f64::from(most.max(1))),
    }));
}

/// The angle of reflection, from 0 (violet) to a right angle (yellow).
fn angle(ray: &Ray, hit: &Hit) -> [f32; 3] {
    if !hit.is_drawn() {
        return NOTHING;
    }
    let cosine = -facing_normal(ray, hit).dot(ray.direction);
    scale(native::acos(cosine.clamp(0.0, 1.0)) / FRAC_PI_2)
}

/// The colour of what a ray ends on: a surface, whose side has this colour, if it may be mirrored no further; else the direction in which it leaves, (d + 1)/2.
fn end(trail: &Trail, side: DVec3) -> [f32; 3] {
    match trail.hit.is_drawn() {
        true => pixel(side),
        false => pixel((trail.ray.direction + DVec3::ONE) * 0.5),
    }
}

/// Lets rays be mirrored until they leave.
fn follow<T: Trace>(tracer: &mut T, trails: &mut [Trail], most: u32) {
    let (mut points, mut hits) = (Vec::new(), Vec::new());
    for _ in 0..most {
        let going: Vec<usize> = (0..trails.len()).filter(|&k| trails[k].hit.is_drawn()).collect();
        if going.is_empty() {
            return;
        }
        let departures: Vec<(Ray, Hit, Side)> =
            going.iter().map(|&k| (trails[k].ray, trails[k].hit, Side::Near)).collect();
        tracer.starts(&departures, &mut points);
        let mirrored = |(&(ray, hit, _), &start): (&(Ray, Hit, Side), &DVec3)| {
            let n = facing_normal(&ray, &hit);
            let direction = ray.direction - n * (2.0 * ray.direction.dot(n));
            Ray::new(start, direction.normalize())
        };
        let rays: Vec<Ray> = departures.iter().zip(&points).map(mirrored).collect();
        tracer.trace_from_surface(&rays, &mut hits);
        for ((&k, ray), hit) in going.iter().zip(&rays).zip(&hits) {
            trails[k] = Trail { ray: *ray, hit: *hit, bounces: trails[k].bounces + 1 };
        }
    }
}
