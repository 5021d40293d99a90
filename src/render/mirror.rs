//! Mode `mirror`: colour by the angle between the reflected ray and the direction to the light.
//!
//! In: a hit. Out: colour · max(0, cos), linear, without ambient light.

use super::cosine::NOTHING;
use super::integrator::{facing_normal, pixel};
use crate::scene::{Scene, studio};
use crate::surface::{Hit, Ray};
use glam::DVec3;

/// The colour of one ray, whose surface has this colour.
pub fn colour(scene: &Scene, ray: &Ray, hit: &Hit, side: DVec3) -> [f32; 3] {
    if !hit.is_drawn() {
        return NOTHING;
    }
    let n = facing_normal(ray, hit);
    let d = ray.direction;
    let reflected = d - n * (2.0 * d.dot(n));
    pixel(side * reflected.dot(studio::shoulder(&scene.camera)).max(0.0))
}
