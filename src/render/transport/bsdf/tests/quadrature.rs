//! Integrals over all directions, of functions with a lobe by facets of some slopes and a narrow band along the horizon.
//!
//! In: the direction of arrival, how wide the slopes are. Out: directions with the solid angle each stands for. Two grids, one over
//! the slopes that lead there and one above the horizon, each closer together where functions may be narrow, are added with the
//! weights of the balance heuristic (Veach 1997, section 9.2), so that each counts where it is the finer one. Knows nothing of how
//! directions are sampled; that its own solid angles are right shows in the sum of them.

use super::super::direction::{on_circle, reflected, refracted};
use super::super::fresnel::cosine_beyond;
use crate::num::func;
use crate::num::level::Portable;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Nodes of the slope's steepness, and its direction.
const SLOPES: [usize; 2] = [160, 96];

/// Nodes above the horizon, and along it.
const HORIZON: [usize; 2] = [96, 96];

/// The steepest slope.
const STEEPEST: f64 = 1e3;

/// The squared distance at which two directions are one, far above rounding, far below a step between nodes.
const SAME: f64 = 1e-12;

/// Lengths 0..=end, closest at 0, where they are about as close as `least`.
#[derive(Clone, Copy)]
struct Graded {
    least: f64,
    rate: f64,
}

impl Graded {
    fn new(least: f64, end: f64) -> Self {
        Graded { least, rate: func::ln::<Portable>(1.0 + end / least) }
    }

    fn at(self, part: f64) -> f64 {
        self.least * (func::exp::<Portable>(self.rate * part) - 1.0)
    }

    /// d length / d part.
    fn stretch(self, length: f64) -> f64 {
        self.rate * (length + self.least)
    }
}

/// Directions of one side of the surface for light that arrives along wo; `ior` is relative.
pub(super) fn directions(wo: DVec3, alpha: f64, ior: f64, is_above: bool) -> Vec<(DVec3, f64)> {
    let (steepness, height) = (Graded::new(0.3 * alpha, STEEPEST), Graded::new(0.3 * alpha, 1.0));
    let sign = if is_above { 1.0 } else { -1.0 };
    let by_slope = grid(SLOPES).filter_map(|[part, turn]| {
        let ([x, y], steep) = (on_circle(turn), steepness.at(part));
        let m = DVec3::new(x * steep, y * steep, 1.0).normalize();
        is_open(wo, m, ior, is_above).then(|| way(wo, m, ior, is_above))
    });
    let by_height = grid(HORIZON).map(|[part, turn]| {
        let (height, [x, y]) = (height.at(part), on_circle(turn));
        let flat = (1.0 - height * height).max(0.0).sqrt();
        DVec3::new(flat * x, flat * y, sign * height)
    });
    let density = |wi: DVec3| {
        let m = facet(wo, wi, ior);
        let steep = (m.x * m.x + m.y * m.y).sqrt() / m.z;
        let solid = TAU * steep * steepness.stretch(steep) * m.z * m.z * m.z * growth(wo, wi, m, ior);
        let is_reached = is_open(wo, m, ior, is_above) && way(wo, m, ior, is_above).distance_squared(wi) < SAME;
        let by_slope = if is_reached { count(SLOPES) / solid } else { 0.0 };
        by_slope + count(HORIZON) / (TAU * height.stretch(wi.z.abs()))
    };
    by_slope.chain(by_height).filter(|wi| wi.z * sign > 0.0).map(|wi| (wi, 1.0 / density(wi))).collect()
}

/// Whether a facet of normal m leads light to this side.
fn is_open(wo: DVec3, m: DVec3, ior: f64, is_above: bool) -> bool {
    wo.dot(m) > 0.0 && (is_above || cosine_beyond(wo.dot(m), ior) > 0.0)
}

fn way(wo: DVec3, m: DVec3, ior: f64, is_above: bool) -> DVec3 {
    if is_above {
        return reflected(wo, m);
    }
    refracted(wo, m, ior, cosine_beyond(wo.dot(m), ior)).normalize()
}

/// The normal of a facet that leads from wo to wi.
fn facet(wo: DVec3, wi: DVec3, ior: f64) -> DVec3 {
    let half = if wi.z > 0.0 { wo + wi } else { wo + wi * ior };
    half.normalize() * half.z.signum()
}

/// How much solid angle of wi there is to that of the facet's normal.
fn growth(wo: DVec3, wi: DVec3, m: DVec3, ior: f64) -> f64 {
    if wi.z > 0.0 {
        return 4.0 * wo.dot(m);
    }
    let sum = wo.dot(m) + ior * wi.dot(m);
    sum * sum / (ior * ior * wi.dot(m).abs())
}

fn count([rows, columns]: [usize; 2]) -> f64 {
    (rows * columns) as f64
}

/// The middles of a grid's cells, of 0..1.
fn grid([rows, columns]: [usize; 2]) -> impl Iterator<Item = [f64; 2]> {
    let middle = |k: usize, of: usize| (k as f64 + 0.5) / of as f64;
    (0..rows * columns).map(move |k| [middle(k / columns, rows), middle(k % columns, columns)])
}

/// How far off a constant may be: the worst of functions, for it does not fade where the facets that lead anywhere end, and there
/// the weights jump.
const CONSTANT_ERROR: f64 = 0.02;

#[test]
fn solid_angles_add_up() {
    for (cosine, alpha, ior) in
        [(1.0, 1.0, 1.5), (0.8, 0.01, 1.5), (0.5, 0.0025, 0.7), (0.01, 0.0025, 1.2), (0.01, 1.0, 2.0)]
    {
        let wo = super::view(cosine);
        for is_above in [true, false] {
            let all = directions(wo, alpha, ior, is_above);
            let place = format!("{cosine} {alpha} {ior} {is_above}");
            let sum = |value: fn(DVec3) -> f64| all.iter().map(|&(w, share)| value(w) * share).sum::<f64>();
            assert!((sum(|_| 1.0) / TAU - 1.0).abs() < CONSTANT_ERROR, "{place} {}", sum(|_| 1.0) / TAU);
            assert!((sum(|w| w.z.abs()) / PI - 1.0).abs() < CONSTANT_ERROR, "{place} {}", sum(|w| w.z.abs()) / PI);
        }
    }
}
