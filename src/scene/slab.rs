//! Where in a box a surface can be, more closely than the box says.
//!
//! In: a question that gives, for boxes, what a function is near to and how near. Out: how far from a point all its surfaces reach. Separate from
//! [`super::extreme`], which knows of a box only whether a surface can be in it: it has to halve boxes until they are as small as what
//! is looked for is to be known, and all of a sphere is about as far from its middle. A surface that is smooth is nearly a plane in a
//! box, and as the box is halved, what it differs by becomes a quarter.

#[cfg(test)]
use super::cells::Cell;
use super::cells::Cube;
use glam::DVec3;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// The part of a box between two planes: |center + slope · ε| ≤ error, ε being the place in the box, −1 to 1 along each axis.
#[derive(Clone, Copy, Debug)]
pub struct Slab {
    /// The linear function in the middle of the box.
    pub center: f64,
    /// What it changes by from there to the sides.
    pub slope: DVec3,
    /// How far from zero it is at most where there is a surface; ∞ if nothing is known.
    pub error: f64,
    /// Whether the surface goes on as far as the box does, for all that is known.
    pub is_whole: bool,
}

/// Where in each of many boxes surfaces can be, with the box's number: one slab for each surface that can be in it. What was there is gone.
pub type Slabs<'a> = &'a dyn Fn(&[Cube], &mut Vec<(usize, Slab)>);

/// Boxes asked about before it is given up.
const CELLS: usize = 4000;

/// Boxes that are halved together: what they become is asked about at once.
const TOGETHER: usize = 2;

/// To which share a distance is found: a fifth of the margin around it.
const SHARE: f64 = 0.01;

/// A slab this thick, as a share of what its function changes by in the box, tells where a surface is, and not only where none is.
const THIN: f64 = 0.25;

impl Slab {
    /// A slab that is all of its box.
    pub const ALL: Slab = Slab { center: 0.0, slope: DVec3::ZERO, error: f64::INFINITY, is_whole: false };

    /// The most of `lean · ε` in it.
    ///
    /// By duality that is the least over λ of Σ|leanᵢ − λ·slopeᵢ| − λ·center + |λ|·error, which has its corners where λ or one of the
    /// parts of the sum is 0.
    fn most(&self, lean: DVec3) -> f64 {
        let bound = |factor: f64| {
            (lean - factor * self.slope).abs().element_sum() - factor * self.center + factor.abs() * self.error
        };
        let corners = (lean / self.slope).to_array().into_iter().filter(|factor| factor.is_finite());
        corners.map(bound).filter(|bound| !bound.is_nan()).fold(lean.abs().element_sum(), f64::min)
    }

    /// Whether it is so thin that a surface is where it is.
    fn is_thin(&self) -> bool {
        let change = self.slope.abs().element_sum();
        self.is_whole && self.error <= THIN * change && self.center.abs() <= change
    }
}

/// A box, with the square of the distance from a point within which everything in it is.
struct Reaching {
    square: f64,
    /// Whether something is nearly as far.
    is_found: bool,
    cube: Cube,
}

impl Reaching {
    fn new(cube: Cube, slab: &Slab, point: DVec3) -> Self {
        let (middle, half) = ((cube.min + cube.max) * 0.5 - point, (cube.max - cube.min) * 0.5);
        // |middle + half·ε|² = |middle|² + 2·middle·half·ε + |half·ε|².
        let lean = 2.0 * middle * half;
        let by_slab = middle.length_squared() + half.length_squared() + slab.most(lean);
        let corner = cube.farthest(point);
        let square = by_slab.min(corner * corner);
        let on_plane = middle.length_squared() + Slab { error: 0.0, ..*slab }.most(lean);
        Reaching { square, is_found: slab.is_thin() && square - on_plane <= 2.0 * SHARE * square, cube }
    }
}

/// How far from a point what is in the boxes of a box reaches, found to a share of that or to boxes of a width; `None` if it takes too
/// long to find. Nothing is farther.
pub(super) fn farthest(slabs: Slabs, within: Cube, width: f64, point: DVec3) -> Option<f64> {
    let mut queue = BinaryHeap::from([Reaching::new(within, &Slab::ALL, point)]);
    let (mut cubes, mut found) = (Vec::new(), Vec::new());
    let mut cells_left = CELLS;
    let is_last = |top: &Reaching| top.is_found || top.cube.width() <= width;
    while let Some(top) = queue.pop() {
        if is_last(&top) {
            return Some(top.square.sqrt());
        }
        cubes.clear();
        cubes.extend(top.cube.children());
        while cubes.len() < 8 * TOGETHER
            && queue.peek().is_some_and(|next| !is_last(next))
            && let Some(next) = queue.pop()
        {
            cubes.extend(next.cube.children());
        }
        cells_left = cells_left.checked_sub(cubes.len())?;
        slabs(&cubes, &mut found);
        // Of all surfaces in a box the one that may reach farthest counts.
        let mut most: [Option<Reaching>; 8 * TOGETHER] = [const { None }; _];
        for (k, slab) in &found {
            most[*k] = most[*k].take().max(Some(Reaching::new(cubes[*k], slab, point)));
        }
        queue.extend(most.into_iter().flatten());
    }
    None
}

impl Ord for Reaching {
    fn cmp(&self, other: &Self) -> Ordering {
        self.square.total_cmp(&other.square).then(self.is_found.cmp(&other.is_found))
    }
}

impl PartialOrd for Reaching {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Reaching {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Reaching {}

/// The slabs where nothing is known but which boxes may hold a surface.
#[cfg(test)]
pub(super) fn nothing_known(classify: impl Fn(&[Cube], &mut [Cell])) -> impl Fn(&[Cube], &mut Vec<(usize, Slab)>) {
    move |cubes, slabs| {
        let mut cells = vec![Cell::Empty; cubes.len()];
        classify(cubes, &mut cells);
        slabs.clear();
        slabs.extend((0..cubes.len()).filter(|&k| cells[k] == Cell::Possible).map(|k| (k, Slab::ALL)));
    }
}

#[cfg(test)]
mod tests {
    use super::super::cells::each;
    use super::*;

    /// A linear congruential generator (Knuth, TAOCP 2, section 3.3.4), from −1 to 1.
    struct Random(u64);

    impl Random {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        }

        fn vector(&mut self) -> DVec3 {
            DVec3::new(self.next(), self.next(), self.next())
        }
    }

    /// The most of `lean · ε` among the corners of the slab, where each linear function has its most: corners of the box, and places on its
    /// edges where one of the planes is met. `None` if the slab is empty.
    fn most_of_corners(slab: &Slab, lean: DVec3) -> Option<f64> {
        let corner =
            |k: u32| DVec3::select(glam::BVec3::new(k & 1 != 0, k & 2 != 0, k & 4 != 0), DVec3::ONE, DVec3::NEG_ONE);
        let value = |p: DVec3| slab.center + slab.slope.dot(p);
        let inside = (0..8).map(corner).filter(|&p| value(p).abs() <= slab.error);
        let on_edges = (0..8).flat_map(|k| (0..3).map(move |axis| (k, axis))).flat_map(|(k, axis)| {
            [-slab.error, slab.error].into_iter().filter_map(move |level| {
                let mut p = corner(k);
                p[axis] = 0.0;
                p[axis] = (level - value(p)) / slab.slope[axis];
                (p[axis].abs() <= 1.0).then_some(p)
            })
        });
        inside.chain(on_edges).map(|p| lean.dot(p)).reduce(f64::max)
    }

    #[test]
    fn the_most_in_a_slab_is_that_of_its_corners() {
        let mut random = Random(3);
        let mut checked = 0;
        for k in 0..2000 {
            let (mut slope, lean) = (random.vector(), random.vector());
            slope[k % 3] *= f64::from(k.is_multiple_of(2) as u8);
            let slab = Slab { center: 2.0 * random.next(), slope, error: 0.3 * random.next().abs(), is_whole: true };
            if let Some(expected) = most_of_corners(&slab, lean) {
                assert!((slab.most(lean) - expected).abs() < 1e-12, "{slab:?} {lean} {expected}");
                checked += 1;
            }
            assert_eq!(Slab { error: f64::INFINITY, ..slab }.most(lean), lean.abs().element_sum());
        }
        assert!(checked > 1000);
    }

    /// The slabs of |axes · (p − middle)|² = 1, and how many boxes were asked about.
    fn ellipsoid(
        middle: DVec3,
        axes: DVec3,
        asked: &std::cell::Cell<usize>,
    ) -> impl Fn(&[Cube], &mut Vec<(usize, Slab)>) {
        move |cubes, slabs| {
            asked.set(asked.get() + cubes.len());
            slabs.clear();
            slabs.extend(cubes.iter().enumerate().filter_map(|(k, cube)| {
                let (at, half) = (axes * ((cube.min + cube.max) * 0.5 - middle), axes * (cube.max - cube.min) * 0.5);
                let error = half.length_squared() / 2.0;
                let slab =
                    Slab { center: at.length_squared() - 1.0 + error, slope: 2.0 * at * half, error, is_whole: true };
                (slab.center.abs() <= slab.slope.abs().element_sum() + error).then_some((k, slab))
            }));
        }
    }

    #[test]
    fn the_farthest_is_not_nearer_than_it_is_and_little_farther() {
        let rows = [
            (DVec3::ZERO, DVec3::ONE, DVec3::ZERO, 1.0),
            (DVec3::ZERO, DVec3::ONE, DVec3::new(0.3, -0.4, 1.2), 2.3),
            (DVec3::new(0.1, 0.2, -0.1), DVec3::new(2.0, 1.0, 4.0), DVec3::new(0.1, 0.2, -0.1), 1.0),
            (DVec3::new(0.3, 0.0, 0.0), DVec3::new(8.0, 10.0, 10.0), DVec3::ZERO, 0.425),
        ];
        let within = Cube { min: DVec3::splat(-1.03), max: DVec3::new(1.01, 1.03, 1.03) };
        for (middle, axes, point, expected) in rows {
            let asked = std::cell::Cell::new(0);
            let slabs = ellipsoid(middle, axes, &asked);
            let found = farthest(&slabs, within, 0.01, point).unwrap_or(f64::NAN);
            assert!(found >= expected && found <= expected * (1.0 + 1.5 * SHARE), "{found} {expected}");
            assert!(asked.get() <= CELLS, "{}", asked.get());
        }
    }

    #[test]
    fn where_nothing_is_known_boxes_are_halved_to_the_width_or_it_is_given_up() {
        let within = Cube { min: DVec3::ZERO, max: DVec3::ONE };
        let open_if = |is_open: bool| if is_open { Cell::Possible } else { Cell::Empty };
        let in_corner = nothing_known(each(|min, _| open_if(min.max_element() <= 0.4)));
        let found = farthest(&in_corner, within, 0.01, DVec3::ZERO).unwrap();
        let expected = 0.4 * 3f64.sqrt();
        assert!(found >= expected && found <= expected + 0.01 * 3f64.sqrt(), "{found}");
        let on_sphere = nothing_known(each(|min, max| {
            let cube = Cube { min, max };
            open_if(cube.nearest_point().length() <= 0.5 && cube.farthest(DVec3::ZERO) >= 0.5)
        }));
        assert_eq!(farthest(&on_sphere, within, 0.001, DVec3::ZERO), None);
    }
}
