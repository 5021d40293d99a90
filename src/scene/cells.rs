//! Boxes of space, and what is proven of them.
//!
//! In: a question that can be asked of any boxes: is it proven that no surface is in them? Out: boxes with their answers; a ball
//! around all that may hold a surface. Separate from framing, because the eye's distance is found by them too.

use glam::DVec3;

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

    /// The distance from a point within which all of it is.
    pub(crate) fn farthest(&self, point: DVec3) -> f64 {
        (self.min - point).abs().max((self.max - point).abs()).length()
    }

    pub(super) fn nearest_point(&self) -> DVec3 {
        DVec3::ZERO.clamp(self.min, self.max)
    }
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
