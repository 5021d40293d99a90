//! Where the rays from a surface go: few a pixel, together many.
//!
//! In: a pixel, the number of a sample. Out: points of the unit disc and the unit sphere, a pure function of them.
//! The sixteen pixels of any 4 × 4 square have sixteen different patterns, which together fill disc and sphere evenly
//! (Keller and Heidrich 2001, "Interleaved sampling"); so a mean over such a square has no noise.

use crate::num::func;
use crate::num::level::Portable;
use glam::DVec3;
use std::sync::LazyLock;

/// How many rays towards the key light leave a pixel's surface.
pub const KEY_RAYS: usize = 4;

/// How many rays towards the sky do.
pub const SKY_RAYS: usize = 4;

/// The patterns of a 4 × 4 square of pixels: neighbours have distant ones (Bayer 1973).
const PATTERNS: [[u32; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// A number of turns whose multiples never crowd: 1/φ².
const GOLDEN_TURN: f64 = 0.381_966_011_250_105_15;

/// The pattern of sample k of pixel (i, j).
pub fn pattern(i: u32, j: u32, k: u32) -> usize {
    // Five is odd, so that sixteen samples of one pixel have all patterns too.
    ((PATTERNS[(j & 3) as usize][(i & 3) as usize] + 5 * k) & 15) as usize
}

/// The points of the disc for a pattern.
pub fn on_disc(pattern: usize) -> [[f64; 2]; KEY_RAYS] {
    std::array::from_fn(|n| DISC[n * 16 + pattern])
}

/// The points of the sphere for a pattern.
pub fn on_sphere(pattern: usize) -> [DVec3; SKY_RAYS] {
    std::array::from_fn(|n| SPHERE[n * 16 + pattern])
}

/// Vogel 1979, "A better way to construct the sunflower head".
static DISC: LazyLock<[[f64; 2]; KEY_RAYS * 16]> = LazyLock::new(|| {
    std::array::from_fn(|n| {
        let radius = ((n as f64 + 0.5) / (KEY_RAYS * 16) as f64).sqrt();
        let (sine, cosine) = turned(n);
        [radius * cosine, radius * sine]
    })
});

/// The same on the sphere, by bands of equal area (Swinbank and Purser 2006, "Fibonacci grids").
static SPHERE: LazyLock<[DVec3; SKY_RAYS * 16]> = LazyLock::new(|| {
    std::array::from_fn(|n| {
        let z = 1.0 - (2 * n + 1) as f64 / (SKY_RAYS * 16) as f64;
        let (sine, cosine) = turned(n);
        let radius = (1.0 - z * z).sqrt();
        DVec3::new(radius * cosine, radius * sine, z)
    })
});

fn turned(n: usize) -> (f64, f64) {
    let turns = n as f64 * GOLDEN_TURN;
    func::sin_cos::<Portable>(std::f64::consts::TAU * (turns - turns.floor()))
}
