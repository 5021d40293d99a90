//! What there is to see, when nobody said where to look.
//!
//! In: a question that can be asked of any box: is it proven that no surface is in it? Out: a ball around the
//! surfaces, or around the part of them that is nearest to the origin. Separate from the camera because a clip is
//! found in the same way whoever looks.

use super::cells::{Asked, Cell, Classify, Cube};
use super::extreme::{EXTREME_CELLS, EXTREME_SHARE, Ranked, extreme};
use super::slab::{Slabs, farthest};
use crate::surface::Shape;
use glam::DVec3;
use std::collections::BinaryHeap;

/// Half the side of the largest box that is searched is 2 to this power.
pub const MAX_POWER: i32 = 20;

/// The most boxes that are asked about: a few tenths of a second for a long formula.
const MAX_CELLS: u32 = 1 << 18;

/// Empty shells in a row after which what is inside is all: each is twice as large as the one before.
const EMPTY_SHELLS: i32 = 3;

/// How often a cube of a shell is halved before what is left of it counts as surface.
const SHELL_DEPTH: u32 = 3;

/// How often the inside is halved, each way, to see whether anything is there at all.
const INSIDE_DEPTH: u32 = 6;

/// The radius of the ball when what there is to see has no end.
const ENDLESS_RADIUS: f64 = 6.0;

/// The margin around what is bounded.
const MARGIN: f64 = 1.05;

/// Rounds of measuring what is bounded, and the shrinking that makes another one worth while.
const ROUNDS: (u32, f64) = (40, 0.97);

/// The width to which the point nearest to the origin is found, and the grid it is put on.
const NEAREST_WIDTH: f64 = 1.0 / 128.0;

/// The same as a share of its distance: what is far is not found finer than the picture shows.
const NEAREST_SHARE: f64 = 1.0 / 256.0;

/// A box this wide, or less, is small beside a ball of [`ENDLESS_RADIUS`].
const SMALL: f64 = 1.0;

/// The width of the boxes by which points are compared that are about as near as the nearest.
const TIE_WIDTH: f64 = 1.0 / 8.0;

/// Boxes asked about to find all of those; if there are more, the nearest alone counts.
const TIE_CELLS: u32 = 8000;

/// A box this narrow, as a share of its distance from the origin, is a point: doubles tell little more of it.
const POINT_SHARE: f64 = 1e-12;

/// A box narrower than this is a point: sixth powers of less underflow.
const SMALLEST: f64 = 1e-50;

/// The radius of the ball around a point: as good as any, and easily read.
const POINT_RADIUS: f64 = 1.0;

/// The grid on which the middle of the picture is put, so that what is printed can be typed.
const GRID: f64 = 1.0 / 16.0;

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Framing {
    /// The ball to look at.
    pub center: DVec3,
    /// Its radius.
    pub radius: f64,
    /// Whether all there is to see is in it.
    pub is_all: bool,
}

impl Framing {
    /// As a clip's shape.
    pub fn shape(&self) -> Shape {
        Shape::Ball { center: self.center, radius: self.radius }
    }
}

/// That there is nothing to see, and what is proven instead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Nothing(pub Cell);

/// Finds the ball, by what is proven of boxes and by where in them surfaces can be.
///
/// # Errors
/// If no box within 2^[`MAX_POWER`] of the origin can hold a surface.
pub fn find(classify: Classify, slabs: Slabs) -> Result<Framing, Nothing> {
    let mut search = Search { classify, slabs, cells_left: MAX_CELLS };
    if let Some(framing) = search.bounded() {
        return Ok(framing);
    }
    search.nearest()
}

struct Search<'a> {
    classify: Classify<'a>,
    slabs: Slabs<'a>,
    cells_left: u32,
}

impl Search<'_> {
    /// Whether a surface may be in the cube, halved at most `depth` times.
    fn survives(&mut self, Asked { cube, cell }: Asked, depth: u32) -> bool {
        if self.cells_left == 0 {
            return true;
        }
        self.cells_left -= 1;
        match cell {
            Cell::Possible if depth == 0 => true,
            Cell::Possible => {
                cube.asked_children(self.classify).into_iter().any(|child| self.survives(child, depth - 1))
            }
            Cell::Positive | Cell::Negative | Cell::Undefined | Cell::Empty => false,
        }
    }

    /// Whether nothing is between the cubes of half sides `half / 2` and `half`.
    fn shell_is_empty(&mut self, half: f64) -> bool {
        let step = half / 2.0;
        let is_inner = |i: u32| i == 1 || i == 2;
        let places = (0..64u32).map(|n| [n & 3, (n >> 2) & 3, n >> 4]);
        let cubes = places.filter(|place| !place.iter().all(|&i| is_inner(i))).map(|place| {
            let min = DVec3::from_array(place.map(f64::from)) * step - DVec3::splat(half);
            Cube { min, max: min + DVec3::splat(step) }
        });
        let cubes: Vec<Cube> = cubes.collect();
        let mut cells = vec![Cell::Possible; cubes.len()];
        (self.classify)(&cubes, &mut cells);
        let mut asked = cubes.into_iter().zip(cells).map(|(cube, cell)| Asked { cube, cell });
        !asked.any(|asked| self.survives(asked, SHELL_DEPTH))
    }

    /// The ball around all there is, if enough space around it is empty.
    fn bounded(&mut self) -> Option<Framing> {
        let mut empty_shells = 0;
        for power in 0..=MAX_POWER + EMPTY_SHELLS {
            let half = f64::from(1u32 << power);
            empty_shells = if self.shell_is_empty(half) { empty_shells + 1 } else { 0 };
            if self.cells_left == 0 {
                return None;
            }
            let inside = Cube::around_origin(half / f64::from(1 << EMPTY_SHELLS));
            if empty_shells >= EMPTY_SHELLS
                && self.survives(inside.asked(self.classify), INSIDE_DEPTH)
                && let Some(framing) = self.around_all(inside)
            {
                return Some(framing);
            }
        }
        None
    }

    /// The ball around everything inside; `None` if on a closer look nothing is.
    fn around_all(&self, inside: Cube) -> Option<Framing> {
        let (bounds, is_point) = self.tight(inside)?;
        let half = bounds.width() / 2.0;
        let middle = (bounds.min + bounds.max) * 0.5;
        if is_point {
            let center = rounded(middle, POINT_RADIUS);
            return Some(Framing { center, radius: POINT_RADIUS, is_all: true });
        }
        let center = DVec3::select(middle.abs().cmplt(DVec3::splat(half / 64.0)), DVec3::ZERO, middle);
        let center = rounded(center, half);
        let width = bounds.width() * EXTREME_SHARE;
        let radius = match farthest(self.slabs, bounds, width, center) {
            Some(radius) => radius,
            None => extreme(self.classify, bounds, width, EXTREME_CELLS, &|cube| cube.farthest(center))?,
        };
        Some(Framing { center, radius: round_to_three_digits(radius * MARGIN), is_all: true })
    }

    /// A box around everything inside that measuring does not shrink any more, or one so small that it is a point.
    fn tight(&self, inside: Cube) -> Option<(Cube, bool)> {
        let mut bounds = inside;
        // Each round measures to a share of the last box, so that the smallest thing is found to its own scale.
        for _ in 0..ROUNDS.0 {
            if bounds.width() < (POINT_SHARE * bounds.farthest(DVec3::ZERO)).max(SMALLEST) {
                return Some((bounds, true));
            }
            let tighter = self.bounding_box(bounds)?;
            if tighter.width() > ROUNDS.1 * bounds.width() {
                return Some((tighter, false));
            }
            bounds = tighter;
        }
        Some((bounds, true))
    }

    fn bounding_box(&self, within: Cube) -> Option<Cube> {
        let width = within.width() * EXTREME_SHARE;
        let mut tight = within;
        for axis in 0..3 {
            let top = extreme(self.classify, within, width, EXTREME_CELLS, &|cube| cube.max[axis])?;
            let bottom = extreme(self.classify, within, width, EXTREME_CELLS, &|cube| -cube.min[axis])?;
            tight.max[axis] = top;
            tight.min[axis] = -bottom;
        }
        Some(tight)
    }

    /// The ball around the point nearest to the origin; in the middle, if there are several as near.
    fn nearest(&mut self) -> Result<Framing, Nothing> {
        let all = Cube::around_origin(f64::from(1u32 << MAX_POWER)).asked(self.classify);
        let mut queue = BinaryHeap::from([Ranked::new(all, &nearness)]);
        let mut proven = None;
        self.cells_left = MAX_CELLS;
        while let Some(Ranked { key, asked }) = queue.pop() {
            let width = NEAREST_WIDTH.max(-key * NEAREST_SHARE);
            self.cells_left = self.cells_left.saturating_sub(1);
            match asked.cell {
                Cell::Possible if asked.cube.width() <= width || self.cells_left == 0 => {
                    let cube = self.dive(asked);
                    let center = self.center_of_nearest(cube.nearest_point());
                    return Ok(Framing { center, radius: ENDLESS_RADIUS, is_all: false });
                }
                Cell::Possible => {
                    let children = asked.cube.asked_children(self.classify);
                    queue.extend(children.map(|child| Ranked::new(child, &nearness)));
                }
                other => proven = Some(if proven.is_none_or(|p| p == other) { other } else { Cell::Empty }),
            }
        }
        Err(Nothing(proven.unwrap_or(Cell::Empty)))
    }

    /// A box inside `cube` that is small beside the ball and may hold a surface, the nearest ones tried first; the cube
    /// itself if none is found within the work allowed.
    fn dive(&mut self, start: Asked) -> Cube {
        self.cells_left = MAX_CELLS;
        let mut stack = vec![start];
        while let Some(next) = stack.pop() {
            if self.cells_left == 0 {
                break;
            }
            self.cells_left -= 1;
            if next.cell != Cell::Possible {
                continue;
            }
            if next.cube.width() <= SMALL {
                return next.cube;
            }
            let mut children = next.cube.asked_children(self.classify);
            children.sort_by(|a, b| nearness(&a.cube).total_cmp(&nearness(&b.cube)));
            stack.extend(children);
        }
        start.cube
    }

    /// The middle of all points about as near as the nearest, if it is close to them; else the nearest itself.
    fn center_of_nearest(&mut self, nearest: DVec3) -> DVec3 {
        let distance = nearest.length();
        let mut found = Vec::new();
        self.cells_left = TIE_CELLS;
        let half = f64::from((distance + 1.0).min(1e6).ceil() as u32).max(1.0);
        let half = (half as u32).next_power_of_two();
        self.gather(Cube::around_origin(f64::from(half)).asked(self.classify), distance + TIE_WIDTH, &mut found);
        let middle = found.iter().sum::<DVec3>() / found.len().max(1) as f64;
        let is_close = (middle - nearest).length() < ENDLESS_RADIUS / 2.0;
        let center = if self.cells_left > 0 && !found.is_empty() && is_close { middle } else { nearest };
        // Adding zero makes no zero negative.
        (center / GRID).round() * GRID + 0.0
    }

    /// The middles of boxes within `distance` of the origin that may hold a surface.
    fn gather(&mut self, Asked { cube, cell }: Asked, distance: f64, found: &mut Vec<DVec3>) {
        if self.cells_left == 0 || cube.nearest_point().length() > distance {
            return;
        }
        self.cells_left -= 1;
        if cell != Cell::Possible {
            return;
        }
        if cube.width() <= TIE_WIDTH {
            found.push((cube.min + cube.max) * 0.5);
            return;
        }
        for child in cube.asked_children(self.classify) {
            self.gather(child, distance, found);
        }
    }
}

fn nearness(cube: &Cube) -> f64 {
    -cube.nearest_point().length()
}

/// The point with no more decimals than are seen beside `size`, so that what is printed can be typed.
fn rounded(point: DVec3, size: f64) -> DVec3 {
    let text = format!("{size:e}");
    let exponent: i32 = text.split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
    let decimals = usize::try_from(2 - exponent).unwrap_or(0);
    // Adding zero makes no zero negative.
    DVec3::from_array(point.to_array().map(|c| format!("{c:.decimals$}").parse().unwrap_or(c))) + 0.0
}

/// The nearest number of three decimal digits, so that what is printed can be typed.
fn round_to_three_digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::super::cells::each;
    use super::super::slab::nothing_known;
    use super::*;

    /// What is found by a question that is asked of one box at a time, with nothing known of where in a box a surface is.
    fn find(classify: impl Fn(&[Cube], &mut [Cell])) -> Result<Framing, Nothing> {
        super::find(&classify, &nothing_known(&classify))
    }

    /// Classifies boxes against the sphere around `center`, exactly.
    fn sphere(center: DVec3, radius: f64) -> impl Fn(DVec3, DVec3) -> Cell {
        move |min, max| {
            let cube = Cube { min: min - center, max: max - center };
            if cube.nearest_point().length() > radius {
                Cell::Positive
            } else if cube.farthest(DVec3::ZERO) < radius {
                Cell::Negative
            } else {
                Cell::Possible
            }
        }
    }

    #[test]
    fn spheres_are_framed_with_a_small_margin() {
        let rows = [
            (DVec3::ZERO, 1.0),
            (DVec3::ZERO, 1e-6),
            (DVec3::ZERO, 1e4),
            (DVec3::new(50.0, 0.0, 0.0), 1e-3),
            (DVec3::new(-3.0, 7.0, 11.0), 2.0),
            (DVec3::ZERO, 1e6),
            (DVec3::new(1e6, 0.0, 0.0), 1.0),
        ];
        for (center, radius) in rows {
            let framing = find(each(sphere(center, radius))).unwrap();
            assert!(framing.is_all);
            assert!((framing.center - center).length() < 0.03 * radius, "{framing:?}");
            assert!(framing.radius > 1.02 * radius && framing.radius < 1.12 * radius, "{framing:?}");
        }
    }

    #[test]
    fn a_point_is_framed_by_a_ball_of_radius_one() {
        for center in [DVec3::ZERO, DVec3::new(1.0, 2.0, 3.0), DVec3::new(-0.1, 70.0, 1e-5), DVec3::splat(1e5)] {
            let framing = find(each(sphere(center, 0.0))).unwrap();
            assert_eq!((framing.radius, framing.is_all), (1.0, true), "{center}");
            assert!(framing.center.distance(center) < 1e-3, "{framing:?}");
        }
    }

    #[test]
    fn what_is_framed_is_easily_typed() {
        let framing = find(each(sphere(DVec3::new(0.123456, -7.654321, 0.0), 0.5))).unwrap();
        assert!(framing.center.distance(DVec3::new(0.123456, -7.654321, 0.0)) < 0.003);
        assert!(framing.center.to_array().iter().all(|c| c.to_string().len() <= 6), "{framing:?}");
    }

    #[test]
    fn endless_surfaces_are_framed_around_their_nearest_point() {
        let plane = |height: f64| {
            move |min: DVec3, max: DVec3| match () {
                () if min.z > height => Cell::Positive,
                () if max.z < height => Cell::Negative,
                () => Cell::Possible,
            }
        };
        for height in [0.0, 1.0, -40.0, 1000.0f64] {
            let framing = find(each(plane(height))).unwrap();
            let tolerance = 0.1 + height.abs() / 64.0;
            assert!((framing.center - DVec3::Z * height).length() < tolerance, "{height}: {framing:?}");
            assert_eq!((framing.radius, framing.is_all), (6.0, false));
        }
    }

    #[test]
    fn a_tube_around_an_axis_is_framed_from_its_middle() {
        let tube = |min: DVec3, max: DVec3| {
            let cube = Cube { min: min.with_z(0.0), max: max.with_z(0.0) };
            let inside = cube.nearest_point().length() <= 1.0 && cube.farthest(DVec3::ZERO) >= 1.0;
            if inside { Cell::Possible } else { Cell::Empty }
        };
        assert_eq!(find(each(tube)).unwrap(), Framing { center: DVec3::ZERO, radius: 6.0, is_all: false });
    }

    #[test]
    fn nothing_is_said_with_what_is_proven() {
        for cell in [Cell::Positive, Cell::Negative, Cell::Undefined, Cell::Empty] {
            assert_eq!(find(each(|_, _| cell)), Err(Nothing(cell)));
        }
        let both = |min: DVec3, _: DVec3| if min.x >= 0.0 { Cell::Positive } else { Cell::Empty };
        assert_eq!(find(each(both)), Err(Nothing(Cell::Empty)));
    }
}
