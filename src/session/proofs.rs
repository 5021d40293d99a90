//! What is proven of boxes of space: whether a surface can be in them.
//!
//! In: a surface's formula and what clips it. Out: the answer to the question that framing asks. Separate from the plan because
//! many boxes are asked about at once, and what that takes is kept from one question to the next.

use crate::closure::Formula;
use crate::closure::formula::{FormsOverBoxes, OverBoxes};
use crate::num::interval::{Defined, Enclosure, Interval};
use crate::num::interval_lanes::{NOWHERE, PARTIAL};
use crate::scene::Framing;
use crate::scene::cells::{Cell, Cube};
use crate::scene::framing::{self, Nothing};
use crate::scene::slab::Slab;
use crate::surface::Shape;
use glam::DVec3;
use std::cell::RefCell;

/// One surface's formula with its clip, ready to be asked about boxes.
pub(super) struct Prover<'a> {
    f: &'a Formula,
    shapes: &'a [Shape],
    room: RefCell<Room<'a>>,
    /// Once it is asked where in boxes surfaces can be.
    leaning: RefCell<Option<Leaning<'a>>>,
}

/// Working memory.
struct Room<'a> {
    f: OverBoxes<'a>,
    /// The clip's own formulas, > 0 outside.
    fields: Vec<OverBoxes<'a>>,
    /// The boxes of which nothing is proven yet, by their numbers, and where they are.
    open: Vec<usize>,
    ranges: Vec<[Interval; 3]>,
    enclosures: Vec<Enclosure>,
}

/// Working memory of slabs.
struct Leaning<'a> {
    f: FormsOverBoxes<'a>,
    cells: Vec<Cell>,
    /// The boxes in which a surface may be, by their numbers, and their corners.
    open: Vec<usize>,
    corners: Vec<[DVec3; 2]>,
    is_cut: Vec<bool>,
}

impl<'a> Prover<'a> {
    /// For the roots of `f` inside the shapes, where no field is positive.
    pub(super) fn new(f: &'a Formula, shapes: &'a [Shape], fields: &'a [Formula]) -> Self {
        let fields = fields.iter().map(Formula::over_boxes).collect();
        let (open, ranges, enclosures) = (Vec::new(), Vec::new(), Vec::new());
        let room = Room { f: f.over_boxes(), fields, open, ranges, enclosures };
        Prover { f, shapes, room: RefCell::new(room), leaning: RefCell::default() }
    }

    /// What is proven of each box.
    pub(super) fn classify(&self, cubes: &[Cube], cells: &mut [Cell]) {
        let mut room = self.room.borrow_mut();
        let Room { f, fields, open, ranges, enclosures } = &mut *room;
        cells.fill(Cell::Empty);
        open.clear();
        open.extend((0..cubes.len()).filter(|&k| !self.shapes.iter().any(|shape| is_apart(shape, &cubes[k]))));
        for field in fields {
            ranges.clear();
            ranges.extend(open.iter().map(|&k| range_of(&cubes[k])));
            field.enclosures(ranges, enclosures);
            let mut here = enclosures.iter();
            open.retain(|_| !here.next().is_some_and(|enclosure| enclosure.range.lo > 0.0));
        }
        ranges.clear();
        ranges.extend(open.iter().map(|&k| range_of(&cubes[k])));
        f.enclosures(ranges, enclosures);
        for (&k, enclosure) in open.iter().zip(&*enclosures) {
            cells[k] = cell_of(enclosure);
        }
    }

    /// Adds the slab of each box in which the surface can be, with the box's number.
    fn add_slabs(&self, cubes: &[Cube], slabs: &mut Vec<(usize, Slab)>) {
        let kept = self.leaning.take();
        let mut leaning = kept.unwrap_or_else(|| Leaning {
            f: self.f.forms_over_boxes(),
            cells: Vec::new(),
            open: Vec::new(),
            corners: Vec::new(),
            is_cut: Vec::new(),
        });
        let Leaning { f, cells, open, corners, is_cut } = &mut leaning;
        cells.resize(cubes.len(), Cell::Empty);
        self.classify(cubes, cells);
        open.clear();
        open.extend((0..cubes.len()).filter(|&k| cells[k] == Cell::Possible));
        self.cut(open.iter().map(|&k| &cubes[k]), is_cut);
        corners.clear();
        corners.extend(open.iter().map(|&k| [cubes[k].min, cubes[k].max]));
        f.over(corners, |number, form, lane| {
            let (least, most) = form.bounds(lane);
            let is_empty = least > 0.0 || most < 0.0 || form.flags[lane] & NOWHERE != 0;
            let slab = Slab {
                center: form.center[lane],
                slope: DVec3::from_array(form.slope.map(|slope| slope[lane])),
                error: form.error[lane],
                is_whole: form.flags[lane] & PARTIAL == 0 && !is_cut[number],
            };
            if !is_empty {
                slabs.push((open[number], if least.is_finite() && most.is_finite() { slab } else { Slab::ALL }));
            }
        });
        self.leaning.replace(Some(leaning));
    }

    /// Whether some of each box may be clipped away.
    fn cut<'b>(&self, cubes: impl Iterator<Item = &'b Cube> + Clone, is_cut: &mut Vec<bool>) {
        is_cut.clear();
        is_cut.extend(cubes.clone().map(|cube| !self.shapes.iter().all(|shape| holds(shape, cube))));
        let Room { fields, ranges, enclosures, .. } = &mut *self.room.borrow_mut();
        for field in fields {
            ranges.clear();
            ranges.extend(cubes.clone().map(range_of));
            field.enclosures(ranges, enclosures);
            for (is_cut, enclosure) in is_cut.iter_mut().zip(&*enclosures) {
                *is_cut |= cell_of(enclosure) != Cell::Negative || enclosure.defined != Defined::Everywhere;
            }
        }
    }
}

/// The ball around what there is to see of all surfaces.
pub(super) fn frame(provers: &[Prover]) -> Result<Framing, Nothing> {
    let classify = |cubes: &[Cube], cells: &mut [Cell]| classify_all(provers, cubes, cells);
    let slabs = |cubes: &[Cube], slabs: &mut Vec<(usize, Slab)>| {
        slabs.clear();
        provers.iter().for_each(|prover| prover.add_slabs(cubes, slabs));
    };
    framing::find(&classify, &slabs)
}

/// What is proven of each box for all surfaces.
pub(super) fn classify_all(provers: &[Prover], cubes: &[Cube], cells: &mut [Cell]) {
    let Some((first, others)) = provers.split_first() else { return cells.fill(Cell::Empty) };
    first.classify(cubes, cells);
    for prover in others {
        let open: Vec<usize> = (0..cubes.len()).filter(|&k| cells[k] != Cell::Possible).collect();
        let asked: Vec<Cube> = open.iter().map(|&k| cubes[k]).collect();
        let mut here = vec![Cell::Empty; asked.len()];
        prover.classify(&asked, &mut here);
        for (&k, &cell) in open.iter().zip(&here) {
            cells[k] = if cell == Cell::Possible || cell == cells[k] { cell } else { Cell::Empty };
        }
    }
}

/// A box as intervals.
fn range_of(cube: &Cube) -> [Interval; 3] {
    let Cube { min, max } = cube;
    [Interval { lo: min.x, hi: max.x }, Interval { lo: min.y, hi: max.y }, Interval { lo: min.z, hi: max.z }]
}

/// What an enclosure of f over a box proves.
fn cell_of(enclosure: &Enclosure) -> Cell {
    match enclosure.defined {
        Defined::Nowhere => Cell::Undefined,
        _ if enclosure.range.lo > 0.0 => Cell::Positive,
        _ if enclosure.range.hi < 0.0 => Cell::Negative,
        Defined::Everywhere | Defined::Somewhere => Cell::Possible,
    }
}

/// Whether a shape and a box have no point in common.
fn is_apart(shape: &Shape, Cube { min, max }: &Cube) -> bool {
    match *shape {
        Shape::Box { min: low, max: high } => low.cmpgt(*max).any() || high.cmplt(*min).any(),
        Shape::Ball { center, radius } => center.clamp(*min, *max).distance(center) > radius,
    }
}

/// Whether all of a box is in a shape.
fn holds(shape: &Shape, cube: &Cube) -> bool {
    match *shape {
        Shape::Box { min, max } => min.cmple(cube.min).all() && max.cmpge(cube.max).all(),
        Shape::Ball { center, radius } => cube.farthest(center) <= radius,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::formula::formula;
    use crate::expr::graph::Graph;
    use crate::num::level::Simd;
    use crate::scene::slab::Slab;

    /// Boxes of a grid from −2 to 2.
    fn grid(across: u32) -> Vec<Cube> {
        let width = 4.0 / f64::from(across);
        let place =
            |n: u32| DVec3::new(f64::from(n % across), f64::from(n / across % across), f64::from(n / across.pow(2)));
        let cube = |n| Cube { min: place(n) * width - 2.0, max: (place(n) + 1.0) * width - 2.0 };
        (0..across.pow(3)).map(cube).collect()
    }

    fn slabs(prover: &Prover, cubes: &[Cube]) -> Vec<(usize, Slab)> {
        let mut slabs = Vec::new();
        prover.add_slabs(cubes, &mut slabs);
        slabs
    }

    #[test]
    fn a_function_is_as_near_to_its_slab_as_that_says() {
        let rows =
            ["x^2+y^2+z^2-1", "z-sin(3*x)*cos(y)", "abs(x)+abs(y)-z", "sqrt(x)+y*z", "exp(x*y)-1/z-1", "floor(2*x)+y"];
        for text in rows {
            let mut graph = Graph::new();
            let f = formula(&mut graph, text);
            let f = Formula::new(&mut graph, f, Simd::best());
            let (cubes, mut checked) = (grid(7), 0);
            for (k, slab) in slabs(&Prover::new(&f, &[], &[]), &cubes) {
                let (middle, half) = ((cubes[k].min + cubes[k].max) * 0.5, (cubes[k].max - cubes[k].min) * 0.5);
                for n in 0..27u32 {
                    let at = DVec3::new(f64::from(n % 3), f64::from(n / 3 % 3), f64::from(n / 9)) - 1.0;
                    let value = f.value(middle + half * at);
                    let off = (value - slab.center - slab.slope.dot(at)).abs();
                    assert!(!(off > slab.error), "{text} {middle} {at} {value} {slab:?}");
                    checked += u32::from(off <= slab.error && slab.error.is_finite());
                }
            }
            assert!(checked > 500, "{text}: {checked}");
        }
    }

    #[test]
    fn what_is_clipped_or_without_value_is_not_whole() {
        let mut graph = Graph::new();
        let [plane, edge, field] = ["z-0.1", "z-0.1+0*sqrt(x-0.3)", "x-0.3"].map(|text| formula(&mut graph, text));
        let [plane, edge, field] = [plane, edge, field].map(|f| Formula::new(&mut graph, f, Simd::best()));
        let cubes = grid(8);
        let high = DVec3::new(0.3, 5.0, 5.0);
        let shapes = [Shape::Box { min: DVec3::splat(-5.0), max: high }];
        let ball = [Shape::Ball { center: DVec3::ZERO, radius: 1.5 }];
        let field = [field];
        let on = |slabs: Vec<(usize, Slab)>| {
            slabs.into_iter().map(|(k, slab)| (cubes[k], slab.is_whole)).collect::<Vec<_>>()
        };
        for prover in [Prover::new(&plane, &shapes, &[]), Prover::new(&plane, &[], &field)] {
            let found = on(slabs(&prover, &cubes));
            assert_eq!(found.len(), 5 * 8);
            assert!(found.iter().all(|(cube, is_whole)| *is_whole == (cube.max.x < 0.3)), "{found:?}");
        }
        let found = on(slabs(&Prover::new(&edge, &[], &[]), &cubes));
        assert!(found.iter().all(|(cube, is_whole)| *is_whole == (cube.min.x > 0.3)), "{found:?}");
        assert!(found.iter().any(|(_, is_whole)| *is_whole) && found.iter().any(|(_, is_whole)| !is_whole));
        let found = on(slabs(&Prover::new(&plane, &ball, &[]), &cubes));
        assert!(found.iter().all(|(cube, is_whole)| *is_whole == (cube.farthest(DVec3::ZERO) <= 1.5)), "{found:?}");
    }
}
