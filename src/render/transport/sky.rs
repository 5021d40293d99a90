//! The surroundings, as directions are chosen from them.
//!
//! In: a sky. Out: directions, as likely as they are bright, and how likely. Cells of equal solid angle, each as likely as the light of its
//! middle; a floor under all keeps what is dark possible.

use super::warp::ON_SPHERE;
use crate::num::func::native;
use crate::scene::Sky;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Cells by height and around.
const CELLS: [usize; 2] = [64, 128];

/// The least share of the mean that a cell's likelihood has.
const FLOOR: f64 = 0.05;

/// A sky with its likelihoods.
#[derive(Clone, Debug)]
pub struct SkyTable {
    sky: Sky,
    /// Sums of the cells' likelihoods, each cell's own included; the last is 1. Empty: all cells are alike.
    sums: Vec<f64>,
    /// The mean radiance.
    pub mean: DVec3,
}

impl SkyTable {
    /// The table of a sky.
    pub fn new(sky: &Sky) -> Self {
        if let Sky::Uniform(radiance) = sky {
            return SkyTable { sky: sky.clone(), sums: Vec::new(), mean: *radiance };
        }
        let count = CELLS[0] * CELLS[1];
        let radiance: Vec<DVec3> = (0..count).map(|cell| sky.radiance(direction(cell, [0.5, 0.5]))).collect();
        let mean = radiance.iter().sum::<DVec3>() / count as f64;
        let floor = FLOOR * mean.max_element().max(f64::MIN_POSITIVE);
        let total: f64 = radiance.iter().map(|light| light.max_element().max(floor)).sum();
        let mut sum = 0.0;
        let mut sums: Vec<f64> = radiance
            .iter()
            .map(|light| {
                sum += light.max_element().max(floor) / total;
                sum
            })
            .collect();
        sums[count - 1] = 1.0;
        SkyTable { sky: sky.clone(), sums, mean }
    }

    /// The radiance from direction d.
    pub fn radiance(&self, d: DVec3) -> DVec3 {
        self.sky.radiance(d)
    }

    /// A direction.
    pub fn sample(&self, [u, v]: [f64; 2]) -> DVec3 {
        if self.sums.is_empty() {
            return super::warp::on_sphere([u, v]);
        }
        let cell = self.sums.partition_point(|&sum| sum <= u).min(self.sums.len() - 1);
        let before = if cell == 0 { 0.0 } else { self.sums[cell - 1] };
        let rest = ((u - before) / (self.sums[cell] - before)).clamp(0.0, 1.0);
        direction(cell, [rest, v])
    }

    /// How likely [`SkyTable::sample`] takes d, per solid angle.
    pub fn pdf(&self, d: DVec3) -> f64 {
        if self.sums.is_empty() {
            return ON_SPHERE;
        }
        let turns = native::atan2(d.y, d.x) / TAU;
        let turns = turns - turns.floor();
        let place = |share: f64, count: usize| ((share * count as f64) as usize).min(count - 1);
        let cell = place((d.z + 1.0) * 0.5, CELLS[0]) * CELLS[1] + place(turns, CELLS[1]);
        let before = if cell == 0 { 0.0 } else { self.sums[cell - 1] };
        (self.sums[cell] - before) * (CELLS[0] * CELLS[1]) as f64 / (4.0 * PI)
    }
}

/// A place in a cell.
fn direction(cell: usize, [u, v]: [f64; 2]) -> DVec3 {
    let z = ((cell / CELLS[1]) as f64 + u) / CELLS[0] as f64 * 2.0 - 1.0;
    let angle = ((cell % CELLS[1]) as f64 + v) / CELLS[1] as f64 * TAU;
    let radius = (1.0 - z * z).max(0.0).sqrt();
    DVec3::new(radius * native::cos(angle), radius * native::sin(angle), z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_over_samples_are_integrals_over_the_sphere() {
        let (top, horizon, ground) = (DVec3::new(4.0, 2.0, 1.0), DVec3::new(0.5, 1.0, 1.0), DVec3::splat(0.01));
        for sky in [Sky::Uniform(DVec3::ONE), Sky::Gradient { top, horizon, ground }] {
            let table = SkyTable::new(&sky);
            let n = 300;
            let (mut light, mut all) = (DVec3::ZERO, 0.0);
            for k in 0..n * n {
                // Both numbers even, the first in steps finer than the cells.
                let u = [(k as f64 + 0.5) / (n * n) as f64, k as f64 * 0.618_033_988_749_895 % 1.0];
                let d = table.sample(u);
                light += table.radiance(d) / table.pdf(d);
                all += 1.0 / table.pdf(d);
            }
            let total = (n * n) as f64;
            assert!((all / total / (4.0 * PI) - 1.0).abs() < 2e-3, "{}", all / total);
            let expected = match sky {
                // The sine of the elevation is even over the sphere: its mean above the horizon is a half.
                Sky::Gradient { .. } => ((top + horizon) * 0.5 + ground) * 2.0 * PI,
                _ => DVec3::splat(4.0 * PI),
            };
            assert!((light / total - expected).length() < 2e-3 * expected.length(), "{light} {expected}");
        }
    }
}
