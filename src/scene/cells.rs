//! Boxes of space, and the search for what is farthest among those that may hold a surface.
//!
//! In: a question that can be asked of any box: is it proven that no surface is in it? Out: the largest value that a
//! function takes where there can be surface. Separate from framing, because the eye's distance is found by it too.

use super::frontier::{Frontier, Ranked};
use glam::DVec3;

/// Boxes asked about in one search for an extreme; more would not be seen in the picture.
pub(super) const EXTREME_CELLS: u32 = 12_000;

/// An extreme is found to this share of the searched box.
pub(super) const EXTREME_SHARE: f64 = 1.0 / 256.0;

/// Boxes of the largest keys that are followed down to something when a search for an extreme has no work left.
const DIVES: usize = 16;

/// Boxes asked about while they are followed.
const DIVE_CELLS: u32 = 20_000;

/// What is proven of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// f > 0 all over.
    Positive,
    /// f < 0 all over.
    Negative,
    /// f has no value anywhere.
    Undefined,
    /// No surface, for a reason that differs from place to place or from surface to surface.
    Empty,
    /// Nothing: there may be a surface.
    Possible,
}

/// The answer to the question, for many boxes at once, each in its place.
pub type Classify<'a> = &'a dyn Fn(&[Cube], &mut [Cell]);

/// The answer by a question that is asked of one box at a time, by its corners.
pub fn each(question: impl Fn(DVec3, DVec3) -> Cell) -> impl Fn(&[Cube], &mut [Cell]) {
    move |cubes, cells| {
        for (cube, cell) in cubes.iter().zip(cells) {
            *cell = question(cube.min, cube.max);
        }
    }
}

/// A box, by its corners.
#[derive(Clone, Copy, Debug)]
pub struct Cube {
    /// The corner of the least coordinates.
    pub min: DVec3,
    /// The corner of the greatest.
    pub max: DVec3,
}

/// A box with what is proven of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked {
    pub cube: Cube,
    pub cell: Cell,
}

impl Cube {
    pub(super) fn around_origin(half: f64) -> Self {
        Cube { min: DVec3::splat(-half), max: DVec3::splat(half) }
    }

    pub(super) fn width(&self) -> f64 {
        (self.max - self.min).max_element()
    }

    pub(super) fn children(&self) -> [Cube; 8] {
        std::array::from_fn(|k| self.child(k))
    }

    #[inline]
    pub(super) fn child(&self, k: usize) -> Cube {
        let middle = (self.min + self.max) * 0.5;
        let upper = glam::BVec3::new(k & 1 != 0, k & 2 != 0, k & 4 != 0);
        Cube { min: DVec3::select(upper, middle, self.min), max: DVec3::select(upper, self.max, middle) }
    }

    /// What is proven of this one.
    pub(super) fn asked(self, classify: Classify) -> Asked {
        let mut cell = [Cell::Possible];
        classify(&[self], &mut cell);
        Asked { cube: self, cell: cell[0] }
    }

    /// The children, with what is proven of each: they are asked about together, which costs about as much as one alone.
    pub(super) fn asked_children(&self, classify: Classify) -> [Asked; 8] {
        let cubes = self.children();
        let mut cells = [Cell::Possible; 8];
        classify(&cubes, &mut cells);
        std::array::from_fn(|k| Asked { cube: cubes[k], cell: cells[k] })
    }

    pub(super) fn farthest(&self, point: DVec3) -> f64 {
        (self.min - point).abs().max((self.max - point).abs()).length()
    }

    pub(super) fn nearest_point(&self) -> DVec3 {
        DVec3::ZERO.clamp(self.min, self.max)
    }
}

/// The largest key of a box that may hold a surface, found to `width`; `None` if no box can. The key of a box is not less than
/// that of a box inside it.
///
/// Without work left, the boxes of the largest keys are followed down one by one: then the key is that of a box that
/// may hold a surface, as before, and may be less than the largest by what the margin makes good.
pub(super) fn extreme(
    classify: Classify,
    within: Cube,
    width: f64,
    cells: u32,
    key: &dyn Fn(&Cube) -> f64,
) -> Option<f64> {
    // A key changes by about as much as the place does.
    let mut frontier = Frontier::new(key(&within), (within.max - within.min).length());
    frontier.push(Ranked::new(within.asked(classify), key));
    let mut cells_left = cells;
    while let Some(top) = frontier.pop() {
        if cells_left == 0 {
            frontier.push(top);
            return dives(classify, frontier, width, key).or(Some(top.key));
        }
        cells_left -= 1;
        let Asked { cube, cell } = top.asked;
        if cell == Cell::Possible {
            if cube.width() <= width {
                return Some(top.key);
            }
            frontier.push_children(cube, classify, key);
        }
    }
    None
}

/// The largest key that is found by following the boxes of the largest keys down.
fn dives(classify: Classify, mut frontier: Frontier, width: f64, key: &dyn Fn(&Cube) -> f64) -> Option<f64> {
    let mut cells_left = DIVE_CELLS;
    let mut keys = Vec::new();
    while let Some(top) = frontier.pop()
        && keys.len() < DIVES
        && cells_left > 0
    {
        keys.extend(dive(classify, top.asked, width, key, &mut cells_left));
    }
    keys.into_iter().reduce(f64::max)
}

/// Boxes that may hold a surface are halved until there are so many: enough for a ball around a torus that is a twentieth too large.
const BALL_CELLS: usize = 1024;

/// How often they are halved at most: a point is held by one box, however small.
const BALL_DEPTH: u32 = 24;

/// A ball, by its middle and its radius, around all of the box from `min` to `max` that may hold a surface; `None` if nothing may.
pub(super) fn ball_around(classify: Classify, min: DVec3, max: DVec3) -> Option<(DVec3, f64)> {
    let mut cubes = vec![Cube { min, max }];
    let mut depth = 0;
    while cubes.len() <= BALL_CELLS && depth < BALL_DEPTH {
        let children = cubes.iter().flat_map(|cube| cube.asked_children(classify));
        cubes = children.filter(|child| child.cell == Cell::Possible).map(|child| child.cube).collect();
        depth += 1;
    }
    let (min, max) = cubes.iter().map(|cube| (cube.min, cube.max)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))?;
    let center = (min + max) * 0.5;
    let radius = cubes.iter().map(|cube| cube.farthest(center)).reduce(f64::max)?;
    Some((center, radius))
}

/// The key of a smallest box in the cube that may hold a surface, largest keys first.
fn dive(
    classify: Classify,
    Asked { cube, cell }: Asked,
    width: f64,
    key: &dyn Fn(&Cube) -> f64,
    cells_left: &mut u32,
) -> Option<f64> {
    if *cells_left == 0 {
        return None;
    }
    *cells_left -= 1;
    if cell != Cell::Possible {
        return None;
    }
    if cube.width() <= width {
        return Some(key(&cube));
    }
    let mut children = cube.asked_children(classify);
    children.sort_by(|a, b| key(&b.cube).total_cmp(&key(&a.cube)));
    children.into_iter().find_map(|child| dive(classify, child, width, key, cells_left))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a sphere of radius 1/4 around (1, 1, 1) can meet the box.
    fn small_sphere(min: DVec3, max: DVec3) -> Cell {
        let at = DVec3::ONE;
        let (near, far) = (at.clamp(min, max).distance(at), Cube { min, max }.farthest(at));
        if near <= 0.25 && far >= 0.25 { Cell::Possible } else { Cell::Empty }
    }

    #[test]
    fn a_ball_around_a_small_thing_is_small_and_holds_it() {
        let (low, high) = (DVec3::splat(-5.0), DVec3::splat(4.0));
        let (center, radius) = ball_around(&each(small_sphere), low, high).unwrap();
        assert!(center.distance(DVec3::ONE) + 0.25 <= radius, "{center} {radius}");
        assert!(radius < 0.3, "{center} {radius}");
        assert_eq!(ball_around(&each(small_sphere), low, DVec3::ZERO), None);
    }
}
