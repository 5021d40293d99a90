//! Mode `cosine`: colour by the angle between the normal and the direction to the light.
//!
//! In: a hit. Out: colour · max(0, cos), linear, without ambient light; the first shading one writes.

use super::integrator::{facing_normal, pixel};
use crate::surface::{Hit, Ray};
use glam::DVec3;

/// What is seen where there is no surface: dark, so that shadows and nothing differ.
pub const NOTHING: [f32; 3] = [0.018, 0.021, 0.030];

/// The colour of one ray, whose surface has this colour, where the light comes from this direction.
pub fn colour(light: DVec3, ray: &Ray, hit: &Hit, side: DVec3) -> [f32; 3] {
    if !hit.is_drawn() {
        return NOTHING;
    }
    let cos = facing_normal(ray, hit).dot(light);
    pixel(side * cos.max(0.0))
}
