//! What is behind everything: a wall of paper with a soft pool of light.
//!
//! In: a place in the picture, and its pixel. Out: its light.

use super::directions::pattern;
use glam::DVec3;

/// The light in the pool's middle, and far from it.
const PAPER: [DVec3; 2] = [DVec3::new(1.25, 1.24, 1.22), DVec3::new(0.50, 0.55, 0.61)];

/// Where the pool's middle is, in half heights to the right and down from the picture's.
const MIDDLE: [f64; 2] = [-0.1, -0.15];

/// How far it reaches, in half heights.
const REACH: f64 = 2.1;

/// How far from its place a pixel's light is taken, in half heights: about the width of the bands that eight bits would
/// show, so that they dissolve.
const BLUR: f64 = 0.025;

/// The light at a place in half heights to the right and down from the picture's middle, in pixel (i, j).
pub fn backdrop(place: [f64; 2], (i, j): (u32, u32)) -> DVec3 {
    let (x, y) = (place[0] - MIDDLE[0], place[1] - MIDDLE[1]);
    let aside = (pattern(i, j, 0) as f64 + 0.5) / 8.0 - 1.0;
    let far = ((x * x + y * y).sqrt() + aside * BLUR) / REACH;
    let far = far * far;
    PAPER[0].lerp(PAPER[1], far / (0.45 + far))
}
