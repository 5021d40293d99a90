//! Rays from the surface: what hides the key light and the sky.
//!
//! In: hits and their pixels. Out: the light that arrives at each. The rays are traced as exactly as those from the
//! eye, and all at once, so that the tracer's lanes are full.

use super::super::trace::Trace;
use super::directions::{KEY_RAYS, SKY_RAYS, on_disc, on_sphere, pattern};
use super::glimpse::Light;
use crate::render::integrator::{facing_normal, sides};
use crate::scene::Scene;
use crate::scene::studio::Studio;
use crate::surface::{Hit, Ray, Side};
use glam::DVec3;

/// How far, in radii of the scene, a surface hides the sky by half: what is far leaves the shade open.
const REACH: f64 = 0.7;

/// The share of the open key light and of the open sky that is thought to arrive on what hides the sky.
const BOUNCE: [f64; 2] = [0.5, 0.6];

/// Room for rays from the surface.
#[derive(Debug, Default)]
pub struct Scratch {
    rays: Vec<Ray>,
    hits: Vec<Hit>,
    key_counts: Vec<u8>,
    departures: Vec<(Ray, Hit, Side)>,
    starts: Vec<DVec3>,
}

/// A sample: its pixel and its number there.
pub type Sample = (u32, u32, u32);

/// The light at each hit; open where nothing was hit.
pub fn gather<T: Trace>(
    scene: &Scene,
    lights: &Studio,
    tracer: &mut T,
    seen: (&[Sample], &[Ray], &[Hit]),
    scratch: &mut Scratch,
    light: &mut Vec<Light>,
) {
    scratch.rays.clear();
    scratch.key_counts.clear();
    scratch.departures.clear();
    let drawn = || seen.0.iter().zip(seen.1).zip(seen.2).filter(|(_, hit)| hit.is_drawn());
    scratch.departures.extend(drawn().map(|((_, ray), hit)| (*ray, *hit, Side::Near)));
    tracer.starts(&scratch.departures, &mut scratch.starts);
    for (((sample, ray), hit), &origin) in drawn().zip(&scratch.starts) {
        let before = scratch.rays.len();
        let n = facing_normal(ray, hit);
        let pattern = pattern(sample.0, sample.1, sample.2);
        if n.dot(lights.key.direction) > -lights.key.sine {
            let toward = on_disc(pattern).map(|place| lights.key.toward(place));
            let risen = toward.into_iter().filter(|d| d.dot(n) > 0.0);
            scratch.rays.extend(risen.map(|direction| Ray::new(origin, direction)));
        }
        scratch.key_counts.push((scratch.rays.len() - before) as u8);
        // A point of the unit sphere around the tip of n, seen from the foot of n, is as likely as its cosine.
        let toward = on_sphere(pattern).map(|s| (n + s).try_normalize().unwrap_or(n));
        scratch.rays.extend(toward.map(|direction| Ray::new(origin, direction)));
    }
    tracer.trace_from_surface(&scratch.rays, &mut scratch.hits);
    light.clear();
    let colours = sides(scene, &scratch.rays, &scratch.hits);
    let mut traced = scratch.rays.iter().zip(&scratch.hits).zip(&colours);
    let mut key_counts = scratch.key_counts.iter();
    for hit in seen.2 {
        light.push(match hit.is_drawn().then(|| key_counts.next()).flatten() {
            None => Light::OPEN,
            Some(&count) => {
                let key = key_share(traced.by_ref().take(count.into()), facing_count(count));
                Light { key, ..sky(scene, lights, traced.by_ref().take(SKY_RAYS)) }
            }
        });
    }
}

fn facing_count(count: u8) -> f32 {
    f32::from(count.max(1)).min(KEY_RAYS as f32)
}

/// A ray from the surface, what it hits, and the colour of that.
type Traced<'a> = ((&'a Ray, &'a Hit), &'a DVec3);

fn key_share<'a>(traced: impl Iterator<Item = Traced<'a>>, count: f32) -> f32 {
    let hidden = traced.filter(|((_, hit), _)| hit.is_drawn()).count();
    1.0 - hidden as f32 / count
}

fn sky<'a>(scene: &Scene, lights: &Studio, traced: impl Iterator<Item = Traced<'a>>) -> Light {
    let (mut hidden, mut height, mut bounce) = (0.0, 0.0, DVec3::ZERO);
    for ((ray, hit), &colour) in traced.filter(|((_, hit), _)| hit.is_drawn()) {
        let far = hit.t / (REACH * scene.radius);
        let share = 1.0 / (1.0 + far * far);
        let n = facing_normal(ray, hit);
        hidden += share;
        height += share * lights.sky.top.dot(ray.direction);
        let arriving = lights.key.strength * (BOUNCE[0] * lights.key.share(n.dot(lights.key.direction)))
            + lights.sky.irradiance(n) * BOUNCE[1];
        bounce += colour * arriving * share;
    }
    let count = SKY_RAYS as f64;
    Light {
        key: 1.0,
        open: (1.0 - hidden / count) as f32,
        hidden_height: (height / count) as f32,
        bounce: (bounce / count).as_vec3(),
    }
}
