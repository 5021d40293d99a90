//! Points by chance, the same every time.
//!
//! In: nothing. Out: points of the cube |x|, |y|, |z| < 2. Separate because every comparison of formulas draws from
//! the same ones.

use glam::DVec3;

/// Half the side of the cube.
const HALF: f64 = 2.0;

/// An endless list of points.
#[derive(Clone, Debug)]
pub struct Points(u64);

impl Points {
    /// From the beginning.
    pub fn new() -> Self {
        Points(1)
    }

    /// A number of (−1, 1): Knuth's multiplicative generator (The Art of Computer Programming 2, 3.3.4), upper bits.
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

impl Default for Points {
    fn default() -> Self {
        Points::new()
    }
}

impl Iterator for Points {
    type Item = DVec3;

    fn next(&mut self) -> Option<DVec3> {
        Some(DVec3::new(self.number(), self.number(), self.number()) * HALF)
    }
}
