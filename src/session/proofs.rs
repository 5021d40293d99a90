//! What is proven of boxes of space: whether a surface can be in them.
//!
//! In: a surface's formula and what clips it. Out: the answer to the question that framing asks. Separate from the plan because
//! many boxes are asked about at once, and what that takes is kept from one question to the next.

use crate::closure::Formula;
use crate::closure::formula::OverBoxes;
use crate::num::interval::{Defined, Enclosure, Interval};
use crate::scene::cells::{Cell, Cube};
use crate::surface::Shape;
use std::cell::RefCell;

/// One surface's formula with its clip, ready to be asked about boxes.
pub(super) struct Prover<'a> {
    shapes: &'a [Shape],
    room: RefCell<Room<'a>>,
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

impl<'a> Prover<'a> {
    /// For the roots of `f` inside the shapes, where no field is positive.
    pub(super) fn new(f: &'a Formula, shapes: &'a [Shape], fields: &'a [Formula]) -> Self {
        let fields = fields.iter().map(Formula::over_boxes).collect();
        let (open, ranges, enclosures) = (Vec::new(), Vec::new(), Vec::new());
        Prover { shapes, room: RefCell::new(Room { f: f.over_boxes(), fields, open, ranges, enclosures }) }
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
