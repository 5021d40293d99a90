//! Mode `studio`: one look that flatters any surface.
//!
//! In: hits, and shadow rays from them. Out: linear light of a warm key light with a hard shadow, a sky that fills the
//! shade from above, a little light from the eye, a soft sheen; before a quiet background.

use super::integrator::{Scratch, Seen, facing_normal, pixel, side};
use super::trace::Trace;
use crate::scene::{Scene, light};
use crate::surface::Ray;
use glam::DVec3;

/// The key light's strength, warm.
const KEY: DVec3 = DVec3::new(0.92, 0.86, 0.76);

/// Light from straight above, cool.
const SKY: DVec3 = DVec3::new(0.33, 0.38, 0.47);

/// Light from straight below, warm as if from a floor.
const FLOOR: DVec3 = DVec3::new(0.16, 0.145, 0.13);

/// Light from the eye, so that no shade is flat.
const EYE: f64 = 0.13;

/// The share of light that leaves a smooth surface at a right angle without entering it: glass or lacquer.
const SHEEN: f64 = 0.04;

/// How strongly the sky shows in the sheen of a surface seen from the side.
const SKY_SHEEN: f64 = 0.55;

/// The brightness of the key light's highlight.
const HIGHLIGHT: f64 = 0.30;

/// The background's light at the top and at the bottom.
const BACKGROUND: [DVec3; 2] = [DVec3::new(0.55, 0.62, 0.71), DVec3::new(0.86, 0.86, 0.85)];

/// Sends a ray towards the key light from every hit that faces it.
pub fn send_shadow_rays<T: Trace>(scene: &Scene, tracer: &mut T, seen: Seen, scratch: &mut Scratch) {
    let toward_light = light::key(&scene.camera);
    scratch.rays.clear();
    scratch.owners.clear();
    for (index, (ray, hit)) in seen.rays.iter().zip(seen.hits).enumerate() {
        if hit.is_drawn() && facing_normal(ray, hit).dot(toward_light) > 0.0 {
            scratch.rays.push(Ray { origin: ray.at(hit.near), direction: toward_light });
            scratch.owners.push(index as u32);
        }
    }
    tracer.trace_from_surface(&scratch.rays, &mut scratch.hits);
}

/// The colours of the seen rays, once the shadow rays are traced.
pub fn shade(scene: &Scene, seen: Seen, scratch: &Scratch, colours: &mut Vec<[f32; 3]>) {
    let toward_light = light::key(&scene.camera);
    let mut shadows = scratch.owners.iter().zip(&scratch.hits).peekable();
    for (index, (ray, hit)) in seen.rays.iter().zip(seen.hits).enumerate() {
        let is_lit =
            shadows.next_if(|(owner, _)| **owner == index as u32).is_some_and(|(_, shadow)| !shadow.is_drawn());
        colours.push(pixel(if hit.is_drawn() {
            let n = facing_normal(ray, hit);
            let key = if is_lit { KEY } else { DVec3::ZERO };
            lacquer(side(scene, hit), n, -ray.direction, toward_light, key)
        } else {
            background(seen.heights[index])
        }));
    }
}

/// A lacquered surface of colour `albedo` with normal n, seen from direction v, lit by `key` from direction l.
fn lacquer(albedo: DVec3, n: DVec3, v: DVec3, l: DVec3, key: DVec3) -> DVec3 {
    let cos_view = n.dot(v).clamp(0.0, 1.0);
    let fill = FLOOR.lerp(SKY, 0.5 + 0.5 * n.z) + DVec3::splat(EYE * cos_view);
    let diffuse = albedo * (key * n.dot(l).max(0.0) + fill);
    // Schlick 1994, "An inexpensive BRDF model for physically-based rendering", eq. 15.
    let fresnel = SHEEN + (1.0 - SHEEN) * power(1.0 - cos_view, 5);
    let reflected = n * (2.0 * n.dot(v)) - v;
    let sky = FLOOR.lerp(SKY, 0.5 + 0.5 * reflected.z) * (fresnel * SKY_SHEEN);
    // Blinn 1977, "Models of light reflection for computer synthesized pictures": a broad and a narrow highlight.
    let cos_half = n.dot((l + v).normalize_or_zero()).max(0.0);
    let highlight = key * (HIGHLIGHT * (0.25 * power(cos_half, 24) + 0.75 * power(cos_half, 160)));
    diffuse + sky + highlight
}

fn power(base: f64, exponent: u32) -> f64 {
    let (mut result, mut square, mut rest) = (1.0, base, exponent);
    while rest > 0 {
        if rest & 1 == 1 {
            result *= square;
        }
        square *= square;
        rest >>= 1;
    }
    result
}

/// What is behind everything, by the height in the picture.
fn background(height: f64) -> DVec3 {
    let smooth = height * height * (3.0 - 2.0 * height);
    BACKGROUND[0].lerp(BACKGROUND[1], smooth)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_powers() {
        for n in [0, 1, 5, 24, 160] {
            assert!((power(0.9, n) - 0.9f64.powi(n as i32)).abs() < 1e-14);
        }
    }

    #[test]
    fn light_is_brighter_than_shade_everywhere() {
        let (n, l) = (DVec3::Z, DVec3::new(0.3, 0.4, 0.9).normalize());
        for v in [DVec3::Z, DVec3::X, DVec3::new(1.0, 1.0, 1.0).normalize()] {
            let lit = lacquer(DVec3::splat(0.5), n, v, l, KEY);
            let shaded = lacquer(DVec3::splat(0.5), n, v, l, DVec3::ZERO);
            assert!(lit.cmpgt(shaded).all());
            assert!(shaded.cmpgt(DVec3::splat(0.05)).all(), "shade is never black");
        }
    }
}
