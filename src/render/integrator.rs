//! From hits to light.
//!
//! In: rays, what they hit, the scene. Out: a colour a ray. One file a mode; here is what they share.

use super::settings::Mode;
use super::trace::Trace;
use super::{cosine, data, mirror, studio};
use crate::scene::Scene;
use crate::surface::{Hit, Ray};
use glam::DVec3;

/// Rays, what they hit, and how far down the picture each is, of 0..1.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    /// The rays from the eye.
    pub rays: &'a [Ray],
    /// What each hit.
    pub hits: &'a [Hit],
    /// Where each is between the picture's upper edge (0) and its lower (1).
    pub heights: &'a [f64],
}

/// Room for the rays that a mode sends on.
#[derive(Debug, Default)]
pub struct Scratch {
    /// Rays from hits.
    pub rays: Vec<Ray>,
    /// What they hit.
    pub hits: Vec<Hit>,
    /// Which of the seen rays each belongs to.
    pub owners: Vec<u32>,
}

/// The colour of every ray, in `colours`, which is emptied first.
pub fn shade<T: Trace>(
    mode: Mode,
    scene: &Scene,
    tracer: &mut T,
    seen: Seen,
    scratch: &mut Scratch,
    colours: &mut Vec<[f32; 3]>,
) {
    colours.clear();
    let rays = seen.rays.iter().zip(seen.hits);
    match mode {
        Mode::Studio => {
            studio::send_shadow_rays(scene, tracer, seen, scratch);
            studio::shade(scene, seen, scratch, colours);
        }
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
