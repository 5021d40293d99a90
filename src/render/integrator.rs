//! From hits to light.
//!
//! In: rays, what they hit, the scene. Out: a colour a ray. One file a mode; here is what they share.

use super::settings::Mode;
use super::{cosine, data, mirror};
use crate::scene::Scene;
use crate::surface::{Hit, Ray};
use glam::DVec3;

/// The colour of every ray, in `colours`, which is emptied first; none in mode `studio`, which looks at
/// neighbours too, and in those that follow light.
pub fn shade(mode: Mode, scene: &Scene, rays: &[Ray], hits: &[Hit], colours: &mut Vec<[f32; 3]>) {
    colours.clear();
    let rays = rays.iter().zip(hits);
    match mode {
        Mode::Studio | Mode::Path | Mode::Light | Mode::Bidirectional => {}
        Mode::Whitted | Mode::Angle | Mode::End | Mode::Bounces => {}
        Mode::Cosine => colours.extend(rays.map(|(ray, hit)| cosine::colour(scene, ray, hit))),
        Mode::Mirror => colours.extend(rays.map(|(ray, hit)| mirror::colour(scene, ray, hit))),
        Mode::Normal => colours.extend(rays.map(|(_, hit)| data::normal(hit))),
        Mode::Depth => colours.extend(rays.map(|(ray, hit)| data::depth(scene, ray, hit))),
        Mode::Cost => colours.extend(rays.map(|(_, hit)| data::cost(hit))),
        Mode::Proof => colours.extend(rays.map(|(ray, hit)| data::proof(ray, hit))),
    }
}

/// The normal turned to the eye; where the surface has none, it faces the eye.
pub fn facing_normal(ray: &Ray, hit: &Hit) -> DVec3 {
    if hit.normal.is_finite() { hit.normal } else { -ray.direction }
}

/// The colour of the side that was hit.
pub fn side(scene: &Scene, hit: &Hit) -> DVec3 {
    let sides = &scene.sides[hit.surface as usize];
    if hit.flipped { sides.back } else { sides.front }
}

/// As a film keeps it.
pub fn pixel(colour: DVec3) -> [f32; 3] {
    colour.as_vec3().to_array()
}
