//! Where rays start that leave a surface.
//!
//! In: rays with what they hit, and the side to go on from. Out: points there. No distance is chosen: a point counts as
//! in front of a surface if its own coordinates prove the sign of g that holds there, so that a ray from it cannot meet the root it
//! leaves, and cannot miss the next one however near it is.

use super::hit::{Hit, Ray};
use super::sheet::{CELLS, Cells, Sheet};
use glam::DVec3;

/// Which side of a hit a ray leaves from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Where the ray came from: reflections and shadows.
    Near,
    /// Beyond: refraction and what passes straight on.
    Far,
}

/// After so many doublings a point is a millionth of a millionth of the scale away: where g cannot be told from zero even there,
/// it is a root without change of sign, and the point is taken as it is.
const MOST_DOUBLINGS: i32 = 12;

/// A place to start from, on its way.
struct Try {
    number: usize,
    /// Where the first point is, and how the next ones move away from the root.
    t: f64,
    away: f64,
    is_positive: bool,
}

/// Replaces the points of these departures from one sheet. Where the normal is unknown, so is the sign, and the first point is taken.
pub(super) fn starts(
    sheet: &Sheet,
    cells: &mut [Cells],
    departures: impl Iterator<Item = (usize, Ray, Hit, Side)>,
    points: &mut [DVec3],
) -> u64 {
    let value = sheet.kernels.whole().value();
    let mut enclosures = 0;
    let mut open: Vec<(Try, Ray)> = Vec::new();
    for (number, ray, hit, side) in departures {
        let scale = ray.at(hit.t).abs().max_element().max(hit.t);
        let ulp = scale * f64::EPSILON;
        let (t, away) = if side == Side::Near { (hit.near(), -ulp) } else { (hit.far(), ulp) };
        points[number] = ray.at(t);
        if hit.normal.is_finite() {
            open.push((Try { number, t, away, is_positive: hit.flipped != (side == Side::Near) }, ray));
        }
    }
    let mut doublings = 0;
    while !open.is_empty() && doublings <= MOST_DOUBLINGS {
        let mut left = Vec::new();
        let mut rest = open.into_iter().peekable();
        while rest.peek().is_some() {
            let lanes: Vec<(Try, Ray)> = rest.by_ref().take(CELLS).collect();
            enclosures += lanes.len() as u64;
            place(&lanes, points, cells);
            value.run(cells);
            let g = value.output(cells, 0);
            for (lane, (attempt, ray)) in lanes.into_iter().enumerate() {
                let is_proven = if attempt.is_positive { g.lo[lane] > 0.0 } else { g.hi[lane] < 0.0 };
                if !is_proven {
                    let steps = f64::from((1u32 << doublings) * 2 - 1);
                    points[attempt.number] = ray.at(attempt.t + attempt.away * steps);
                    left.push((attempt, ray));
                }
            }
        }
        open = left;
        doublings += 1;
    }
    enclosures
}

/// The points alone, without the room for rounding that points on a ray need.
fn place(lanes: &[(Try, Ray)], points: &[DVec3], cells: &mut [Cells]) {
    for axis in 0..3 {
        let cell = &mut cells[axis];
        for lane in 0..CELLS {
            let (attempt, _) = &lanes[lane.min(lanes.len() - 1)];
            let value = points[attempt.number][axis];
            (cell.lo[lane], cell.hi[lane], cell.flags[lane]) = (value, value, 0);
        }
    }
}
