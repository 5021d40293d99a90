//! Modes `normal`, `depth`, `cost`, `proof`, `curvature`: what the tracer knows, as colour.
//!
//! In: a hit. Out: values of 0..=1 that the screen is to show as they are.

use super::cosine::NOTHING;
use super::integrator::{facing_normal, pixel};
use crate::scene::Scene;
use crate::surface::{Hit, Outcome, Ray};
use glam::DVec3;

const BLACK: [f32; 3] = [0.0; 3];

/// Five colours of the map "viridis" (van der Walt and Smith 2015), at equal steps.
const VIRIDIS: [[u8; 3]; 5] = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/// The cost at the end of the colour map is 2 to this power.
const MAX_COST_POWER: f32 = 12.0;

/// The depth's grey at the far end: light enough to differ from nothing.
const FAR_GREY: f64 = 0.12;

/// The normal, (n + 1)/2; grey where the surface has none, black where there is no surface.
pub fn normal(hit: &Hit) -> [f32; 3] {
    match hit.is_drawn() {
        false => BLACK,
        true if hit.normal.is_finite() => (hit.normal * 0.5 + 0.5).as_vec3().to_array(),
        true => [0.5; 3],
    }
}

/// White at the near end of what is framed, dark grey at the far end.
pub fn depth(scene: &Scene, ray: &Ray, hit: &Hit) -> [f32; 3] {
    if !hit.is_drawn() {
        return BLACK;
    }
    let middle = (scene.center - ray.origin).dot(ray.direction);
    let near = (middle - scene.radius).max(0.0);
    let share = ((hit.t - near) / (middle + scene.radius - near)).clamp(0.0, 1.0);
    [(1.0 - share * (1.0 - FAR_GREY)) as f32; 3]
}

/// The number of enclosures on a scale of powers of two.
pub fn cost(hit: &Hit) -> [f32; 3] {
    let count = hit.cost + 1;
    let power = count.ilog2();
    let logarithm = power as f32 + (count as f32 / (1u32 << power) as f32 - 1.0);
    scale(f64::from(logarithm / MAX_COST_POWER))
}

/// The colour of a share of 0..=1, from violet over green to yellow.
pub fn scale(share: f64) -> [f32; 3] {
    let place = share.clamp(0.0, 1.0) as f32 * 4.0;
    let (index, share) = ((place as usize).min(3), place - (place as usize).min(3) as f32);
    std::array::from_fn(|c| {
        let (a, b) = (f32::from(VIRIDIS[index][c]), f32::from(VIRIDIS[index + 1][c]));
        (a + (b - a) * share) / 255.0
    })
}

/// What is proven, a colour each; the form shines through.
///
/// Proven: miss dark blue, hit green. Not proven: miss grey, hit orange, touch yellow, undecided red.
pub fn proof(ray: &Ray, hit: &Hit) -> [f32; 3] {
    let colour = match (hit.outcome, hit.proven) {
        (Outcome::Miss, true) => return [0.07, 0.10, 0.20],
        (Outcome::Miss, false) => return [0.35, 0.35, 0.35],
        (Outcome::Hit, true) => [0.10, 0.72, 0.53],
        (Outcome::Hit, false) => [0.90, 0.62, 0.0],
        (Outcome::Touch, _) => [0.94, 0.89, 0.26],
        (Outcome::Undecided, _) => [0.84, 0.25, 0.1],
    };
    let form = form(ray, hit) as f32;
    colour.map(|c: f32| c * form)
}

/// The colour of a curvature; the form shines through.
pub fn curvature(ray: &Ray, hit: &Hit, colour: DVec3) -> [f32; 3] {
    if hit.is_drawn() { pixel(colour * form(ray, hit)) } else { NOTHING }
}

/// Brighter where the surface faces the eye.
fn form(ray: &Ray, hit: &Hit) -> f64 {
    0.45 + 0.55 * facing_normal(ray, hit).dot(-ray.direction).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn costs_grow_from_violet_to_yellow() {
        let green = |cost| super::cost(&Hit { cost, ..Hit::NONE })[1];
        assert!((0..4000u32).step_by(7).all(|cost| green(cost) <= green(cost + 7)));
        assert_eq!(super::cost(&Hit { cost: u32::MAX - 1, ..Hit::NONE }), VIRIDIS[4].map(|b| f32::from(b) / 255.0));
    }

    #[test]
    fn every_outcome_has_its_colour() {
        let ray = Ray::new(DVec3::ZERO, DVec3::X);
        let mut colours = Vec::new();
        for outcome in [Outcome::Miss, Outcome::Hit, Outcome::Touch, Outcome::Undecided] {
            for proven in [true, false] {
                if proven && matches!(outcome, Outcome::Touch | Outcome::Undecided) {
                    continue;
                }
                let colour = proof(&ray, &Hit { outcome, proven, ..Hit::NONE });
                assert!(!colours.contains(&colour));
                colours.push(colour);
            }
        }
    }
}
