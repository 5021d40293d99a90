//! Where in space which arguments of a formula's long minima and maxima matter.
//!
//! In: a sheet's kernels and the box it is seen in. Out: for rays, their pieces from the front (`walk`), each with the number of the
//! [`Program`] that is enough on it; what is between the pieces is proven empty. The box is cut into 4 × 4 × 4 cells, those into as many, and
//! those again, each when a ray first comes to it; a cell is settled by affine forms of (x, y, z) over it. Separate from [`super::isolate`], which finds roots in one formula.

mod walk;

use super::kernels::{Kernels, Program};
use super::region::Shape;
use super::tile::Forms;
use crate::closure::specialise::{SLABS, Slabs};
use crate::num::interval_lanes::NOWHERE;
use crate::num::level::Simd;
use glam::DVec3;
use std::collections::HashMap;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
pub(crate) use walk::Piece;

/// A cell is cut into so many along each axis, so that all lanes have one.
const SIDE: usize = 4;

/// The cells that a cell is cut into.
const CHILDREN: usize = SIDE.pow(3);

/// Cells across at the last of three levels, and at the middle one.
const FINEST: usize = SIDE.pow(3);
const MIDDLE: usize = SIDE.pow(2);

/// With fewer arguments than this rays go through the whole formula.
const FEWEST: usize = 8;

/// How much a cell reaches beyond its share on each side, as a part of the box: far more than what rays and cells are rounded.
const OVERLAP: f64 = 1e-7;

/// How much the box is larger on each side than what the sheet is seen in, as a part of it: rays end before they leave it.
const RIM: f64 = 1e-6;

/// The cells of a box, which is a little larger than what the sheet is seen in.
pub(crate) struct Index {
    corner: DVec3,
    /// From side to side.
    extent: DVec3,
    /// Cells of the last level in a unit of length.
    per_cell: DVec3,
    coarse: OnceLock<[Cell; CHILDREN]>,
    /// What is known of the cells of the middle level; along the first axis first, then along the second.
    middle: Box<[AtomicU32]>,
    /// Those of the last level in each of them, in the same order.
    fine: Box<[OnceLock<Box<[Entry; CHILDREN]>>]>,
    programs: Mutex<Programs>,
    arguments: u32,
    simd: Simd,
}

/// All programs made so far, by their numbers and by the arguments that are live.
#[derive(Default)]
struct Programs {
    list: Vec<Arc<Program>>,
    numbers: HashMap<Box<[u32]>, u32>,
}

/// The number of the program that is enough in a cell; `None` where no root is.
type Cell = Option<u32>;

/// The same in a number, with the size of the cell. Two bits are the size, as a power of [`SIDE`], one says whether it is cut, and above them is
/// a program's number, counted from 2, or [`EMPTY`]; 0 is not known yet.
type Entry = u32;

/// The program of cells without roots, as it stands in an [`Entry`].
const EMPTY: u32 = 1;

/// The bit of an [`Entry`] that says that its cell is cut.
const CUT: Entry = 4;

/// Registers that an index computes with.
pub(crate) struct Scratch<'a> {
    pub(crate) leaves: &'a mut [Slabs],
    pub(crate) value: &'a mut [Forms],
}

/// What is known of a cell as a number, `size` being the power of [`SIDE`] that it is across.
fn to_entry(cell: Cell, size: u32) -> Entry {
    let cut = if size == 0 { 0 } else { CUT };
    size + cell.map_or(EMPTY << 3, |program| (program + 2) << 3 | cut)
}

/// The number of the program in an entry.
fn program_of(entry: Entry) -> Option<u32> {
    (entry >> 3).checked_sub(2)
}

impl Index {
    /// The index of a function seen in these shapes; `None` if it is not worth it.
    pub(crate) fn new(kernels: &Kernels, shapes: &[Shape], simd: Simd) -> Option<Index> {
        let arguments = kernels.parts.as_ref()?.choices.arguments();
        if arguments < FEWEST || shapes.is_empty() {
            return None;
        }
        let (mut least, mut most) = (DVec3::NEG_INFINITY, DVec3::INFINITY);
        for shape in shapes {
            let (min, max) = match *shape {
                Shape::Box { min, max } => (min, max),
                Shape::Ball { center, radius } => (center - radius, center + radius),
            };
            (least, most) = (least.max(min), most.min(max));
        }
        let is_solid = (most - least).min_element() > 0.0 && (most - least).is_finite();
        let rim = RIM * (most - least);
        let extent = most - least + 2.0 * rim;
        is_solid.then(|| Index {
            corner: least - rim,
            extent,
            per_cell: extent.recip() * FINEST as f64,
            coarse: OnceLock::new(),
            middle: (0..MIDDLE.pow(3)).map(|_| AtomicU32::new(0)).collect(),
            fine: (0..MIDDLE.pow(3)).map(|_| OnceLock::new()).collect(),
            programs: Mutex::default(),
            arguments: arguments as u32,
            simd,
        })
    }

    /// The program of a number.
    pub(crate) fn program(&self, number: u32) -> Arc<Program> {
        self.programs().list[number as usize].clone()
    }

    fn programs(&self) -> std::sync::MutexGuard<'_, Programs> {
        // What another thread was doing when it panicked does not matter: programs are whole when they get in.
        self.programs.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What is known of a cell of the last level, by the number of its cell of the middle level and by its own there; 0 if nothing is.
    #[inline(always)]
    fn known(&self, middle: usize, fine: usize) -> Entry {
        let entry = self.middle[middle].load(Ordering::Acquire);
        if entry & CUT == 0 { entry } else { self.fine[middle].get().map_or(0, |cells| cells[fine % CHILDREN]) }
    }

    /// The same; what is not known is made.
    fn entry(&self, middle: usize, fine: usize, kernels: &Kernels, scratch: &mut Scratch) -> Entry {
        let across = FINEST / MIDDLE;
        let of_axis = |axis: u32| middle / MIDDLE.pow(axis) % MIDDLE;
        let first = [0, 1, 2].map(of_axis);
        if self.middle[middle].load(Ordering::Acquire) == 0 {
            self.cut_coarse(first.map(|c| c / SIDE), kernels, scratch);
        }
        let entry = self.middle[middle].load(Ordering::Acquire);
        let (Some(program), true) = (program_of(entry), entry & CUT != 0) else { return entry };
        let cells = self.fine[middle].get_or_init(|| {
            let live = &self.program(program).live;
            Box::new(self.cut(live, first.map(|c| c * across), across, kernels, scratch).map(|cell| to_entry(cell, 0)))
        });
        cells[fine]
    }

    /// Finds out what is in the cells of the middle level in one of the first.
    fn cut_coarse(&self, place: [usize; 3], kernels: &Kernels, scratch: &mut Scratch) {
        let all: Vec<u32> = (0..self.arguments).collect();
        let coarse = self.coarse.get_or_init(|| self.cut(&all, [0; 3], FINEST, kernels, scratch));
        let cell = coarse[(place[2] * SIDE + place[1]) * SIDE + place[0]];
        let entries = match cell {
            None => [to_entry(cell, 2); CHILDREN],
            Some(program) => {
                let (live, across) = (&self.program(program).live, FINEST / SIDE);
                self.cut(live, place.map(|c| c * across), across, kernels, scratch).map(|cell| to_entry(cell, 1))
            }
        };
        for (k, entry) in entries.into_iter().enumerate() {
            let along = [k % SIDE, k / SIDE % SIDE, k / SIDE.pow(2)];
            let [x, y, z] = [0, 1, 2].map(|axis| place[axis] * SIDE + along[axis]);
            self.middle[(z * MIDDLE + y) * MIDDLE + x].store(entry, Ordering::Release);
        }
    }

    /// Cuts a cell where these arguments matter.
    fn cut(
        &self,
        live: &[u32],
        first: [usize; 3],
        across: usize,
        kernels: &Kernels,
        scratch: &mut Scratch,
    ) -> [Cell; CHILDREN] {
        let mut children = [None; CHILDREN];
        let Some(parts) = &kernels.parts else { return children };
        let steps = parts.steps_of(live);
        let (leaves, parent) = (parts.leaves(&steps), Program::new(live));
        let value = kernels.only(&parent).value_form();
        let mut bits = Vec::new();
        let part = across / SIDE;
        for plane in 0..SIDE {
            let places: [[usize; 3]; SLABS] = std::array::from_fn(|k| {
                let along = [k % SIDE, k / SIDE, plane];
                [0, 1, 2].map(|axis| first[axis] + along[axis] * part)
            });
            self.fill(&places, part, scratch.leaves);
            leaves.run(scratch.leaves);
            parts.choices.live(self.simd, &leaves, scratch.leaves, live, &mut bits);
            self.fill(&places, part, scratch.value);
            value.run(scratch.value);
            let g = value.output(scratch.value, 0);
            for lane in 0..SLABS {
                let is_empty = g.center[lane].abs() > g.radius(lane) * (1.0 + 1e-12) || g.flags[lane] & NOWHERE != 0;
                let here: Vec<u32> =
                    live.iter().zip(&bits).filter(|(_, bits)| **bits >> lane & 1 == 1).map(|(&k, _)| k).collect();
                if !is_empty && !here.is_empty() {
                    children[plane * SLABS + lane] = Some(self.number(here));
                }
            }
        }
        children
    }

    /// The number of the program for these arguments.
    fn number(&self, live: Vec<u32>) -> u32 {
        let mut programs = self.programs();
        if let Some(&number) = programs.numbers.get(live.as_slice()) {
            return number;
        }
        let number = programs.list.len() as u32;
        programs.list.push(Arc::new(Program::new(&live)));
        programs.numbers.insert(live.into(), number);
        number
    }

    /// Puts the points of cells, by the numbers of their first corners, into the registers of the coordinates.
    fn fill(&self, places: &[[usize; 3]; SLABS], across: usize, forms: &mut [Forms]) {
        let at = |place: [usize; 3], offset: usize| {
            let part = place.map(|first| (first + offset) as f64);
            self.corner + self.extent * (1.0 / FINEST as f64) * DVec3::from_array(part)
        };
        for (lane, &place) in places.iter().enumerate() {
            let (min, max) = (at(place, 0), at(place, across));
            let (middle, half) = (0.5 * (min + max), 0.5 * (max - min) + 2.0 * OVERLAP * self.extent);
            for axis in 0..3 {
                let form = &mut forms[axis];
                form.center[lane] = middle[axis];
                for symbol in 0..3 {
                    form.slope[symbol][lane] = if symbol == axis { half[axis] } else { 0.0 };
                }
                (form.error[lane], form.flags[lane]) = (0.0, 0);
            }
        }
    }
}

#[cfg(test)]
mod tests;
