//! The ways of rays through the cells of an index, 16 at once.
//!
//! In: rays, each between two distances. Out: their pieces, with the numbers of their programs. A lane holds one ray and the cell it is in; all
//! lanes go to the next cell together, without a branch, for where a ray leaves a cell cannot be foreseen. What is rounded on
//! the way is far less than what a cell reaches beyond its share: that is made sure of once for a ray.

use super::{EMPTY, FINEST, Index, MIDDLE, OVERLAP, RIM, SIDE, Scratch, program_of};
use crate::num::level::for_each_level;
use crate::surface::bundle::Asked;
use crate::surface::hit::Ray;
use crate::surface::isolate::Open;
use crate::surface::kernels::Kernels;

/// Rays that are walked together.
const LANES: usize = 16;

/// How many cells of the last level those of each size are across.
const ACROSS: [f64; 4] = [1.0, SIDE as f64, SIDE.pow(2) as f64, SIDE.pow(3) as f64];

/// What points of rays, and where they leave cells, are rounded, as a part of the distances involved, or more: 2^-46.
const ROUNDED: f64 = 1.0 / (1u64 << 46) as f64;

/// 1.5·2^52: adding it rounds a number to a whole one, which is then in the last bits.
const WHOLE: f64 = 6755399441055744.0;

/// A piece of a ray, and the number of what is enough on it; all of the formula, if there is none.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) program: Option<u32>,
    pub(crate) open: Open,
}

/// The rays of all lanes, in units of the cells of the last level from the corner of the box.
struct Lanes {
    origin: [[f64; LANES]; 3],
    direction: [[f64; LANES]; 3],
    inverse: [[f64; LANES]; 3],
    /// Along the ray.
    t: [f64; LANES],
    /// The cell of the last level that each is in.
    at: [[f64; LANES]; 3],
    /// The size of the cell that is known there.
    across: [f64; LANES],
    /// Numbers of the cells of the middle and of the last level, see [`Index::known`].
    middle: [u32; LANES],
    fine: [u32; LANES],
    /// What each is walking.
    walkers: [Option<Walker>; LANES],
}

/// A ray on its way.
#[derive(Clone, Copy)]
struct Walker {
    open: Open,
    /// Where the piece at hand begins.
    from: f64,
    /// Its program, as it stands in an entry.
    program: u32,
    /// How many pieces may be added.
    left: usize,
}

impl Index {
    /// Adds the pieces of rays on which anything can be, from the front and at most so many of each, and what is left behind those.
    pub(crate) fn pieces(
        &self,
        kernels: &Kernels,
        rays: Asked,
        waiting: &mut Vec<Open>,
        most: usize,
        scratch: &mut Scratch,
        (pieces, rest): (&mut Vec<Piece>, &mut Vec<Open>),
    ) {
        let mut lanes = Lanes::new();
        loop {
            for i in 0..LANES {
                if lanes.walkers[i].is_none() {
                    lanes.walkers[i] = self.next(rays, waiting, most, pieces);
                    if let Some(Walker { open, .. }) = lanes.walkers[i] {
                        self.enter(&mut lanes, i, &rays.ray(open.ray), open.a);
                    }
                }
            }
            if lanes.walkers.iter().all(Option::is_none) {
                return;
            }
            for i in 0..LANES {
                self.look(&mut lanes, i, kernels, scratch, (pieces, rest));
            }
            step(self.simd, &mut lanes);
        }
    }

    /// What a lane has come to: another piece, or the end of its ray.
    #[inline(always)]
    fn look(
        &self,
        lanes: &mut Lanes,
        i: usize,
        kernels: &Kernels,
        scratch: &mut Scratch,
        (pieces, rest): (&mut Vec<Piece>, &mut Vec<Open>),
    ) {
        let Some(walker) = &mut lanes.walkers[i] else { return };
        let (t, end) = (lanes.t[i], walker.open.end);
        let (middle, fine) = (lanes.middle[i] as usize, lanes.fine[i] as usize);
        if t >= end || middle >= MIDDLE.pow(3) {
            walker.close(t.min(end), pieces);
            if t < end {
                // Rays end before they leave the box.
                pieces.push(Piece { program: None, open: walker.part(t, end) });
            }
            lanes.walkers[i] = None;
            return;
        }
        let mut entry = self.known(middle, fine);
        if entry == 0 {
            entry = self.entry(middle, fine, kernels, scratch);
        }
        lanes.across[i] = ACROSS[(entry & 3) as usize];
        if entry >> 3 != walker.program {
            walker.close(t, pieces);
            (walker.from, walker.program) = (t, entry >> 3);
            if walker.left == 0 {
                rest.push(walker.part(t, end));
                lanes.walkers[i] = None;
            }
        }
    }

    /// The next ray that can be walked; those that cannot be are pieces as they are.
    fn next(&self, rays: Asked, waiting: &mut Vec<Open>, most: usize, pieces: &mut Vec<Piece>) -> Option<Walker> {
        while let Some(open) = waiting.pop() {
            if open.a < open.end && self.holds(&rays.ray(open.ray), open.a, open.end) {
                return Some(Walker { open, from: open.a, program: EMPTY, left: most });
            }
            pieces.push(Piece { program: None, open });
        }
        None
    }

    /// Whether all points of a ray between two distances are in the box, and its cells are large beside what its points are rounded.
    fn holds(&self, ray: &Ray, a: f64, end: f64) -> bool {
        let rim = 0.5 * RIM * self.extent;
        let (p, q) = (ray.origin + a * ray.direction, ray.origin + end * ray.direction);
        let is_inside = p.min(q).cmpge(self.corner + rim) & p.max(q).cmple(self.corner + self.extent - rim);
        let rounded = ROUNDED * (ray.origin.abs().max_element() + end);
        is_inside.all() && rounded <= 0.5 * OVERLAP * self.extent.min_element()
    }

    /// Puts a ray into a lane.
    fn enter(&self, lanes: &mut Lanes, i: usize, ray: &Ray, t: f64) {
        let (origin, direction) = ((ray.origin - self.corner) * self.per_cell, ray.direction * self.per_cell);
        let at = (origin + t * direction).to_array().map(|c| (c as u32).min(FINEST as u32 - 1));
        for axis in 0..3 {
            lanes.origin[axis][i] = origin[axis];
            lanes.direction[axis][i] = direction[axis];
            lanes.inverse[axis][i] = if direction[axis] == 0.0 { f64::INFINITY } else { 1.0 / direction[axis] };
            lanes.at[axis][i] = f64::from(at[axis]);
        }
        lanes.t[i] = t;
        (lanes.middle[i], lanes.fine[i]) = numbers(at);
    }
}

impl Walker {
    /// Ends the piece at hand. One without a length is all in its neighbours.
    fn close(&mut self, b: f64, pieces: &mut Vec<Piece>) {
        let program = program_of(self.program << 3);
        if program.is_some() && self.from < b {
            pieces.push(Piece { program, open: self.part(self.from, b) });
            self.left -= 1;
        }
        self.program = EMPTY;
    }

    fn part(&self, a: f64, end: f64) -> Open {
        let length = end - a;
        let step = if a > self.open.a { length } else { length.min(self.open.step) };
        Open { a, end, step, ..self.open }
    }
}

/// The numbers of the cells of the middle and of the last level.
#[inline(always)]
fn numbers([x, y, z]: [u32; 3]) -> (u32, u32) {
    let shift = SIDE.trailing_zeros();
    let (low, middle) = (SIDE as u32 - 1, MIDDLE as u32);
    // What is out of the box becomes a number that there is not.
    let out = (x | y | z) >> FINEST.trailing_zeros();
    let out = if out == 0 { 0 } else { u32::MAX };
    let number = ((z >> shift) * middle + (y >> shift)) * middle + (x >> shift);
    (number | out, ((z & low) << (2 * shift)) | ((y & low) << shift) | (x & low))
}

impl Lanes {
    fn new() -> Lanes {
        let zero = [0.0; LANES];
        Lanes {
            origin: [zero; 3],
            direction: [[1.0; LANES]; 3],
            inverse: [[1.0; LANES]; 3],
            t: zero,
            at: [zero; 3],
            across: [1.0; LANES],
            middle: [0; LANES],
            fine: [0; LANES],
            walkers: [None; LANES],
        }
    }
}

for_each_level! {
    /// All lanes go to the cells behind those they are in.
    fn step[L](lanes: &mut Lanes) {
        for i in 0..LANES {
            let across = lanes.across[i];
            let mut first = [0.0; 3];
            let mut next = [0.0; 3];
            let mut leaves = [0.0; 3];
            for axis in 0..3 {
                let is_rising = lanes.direction[axis][i] >= 0.0;
                let part = lanes.at[axis][i] / across;
                let whole = (part + WHOLE) - WHOLE;
                let whole = if whole > part { whole - 1.0 } else { whole };
                first[axis] = whole * across;
                let side = if is_rising { first[axis] + across } else { first[axis] };
                next[axis] = if is_rising { side } else { side - 1.0 };
                let t = (side - lanes.origin[axis][i]) * lanes.inverse[axis][i];
                // Where the ray does not move along an axis this is infinite, or NaN on a side.
                leaves[axis] = if t.is_nan() { f64::INFINITY } else { t };
            }
            let is_first = (leaves[0] <= leaves[1]) & (leaves[0] <= leaves[2]);
            let is_second = !is_first & (leaves[1] <= leaves[2]);
            let least = if is_second { leaves[1] } else { leaves[2] };
            let least = if is_first { leaves[0] } else { least };
            let t = if least > lanes.t[i] { least } else { lanes.t[i] };
            let is_left = [is_first, is_second, !is_first & !is_second];
            let mut numbers_at = [0; 3];
            for axis in 0..3 {
                let part = lanes.origin[axis][i] + t * lanes.direction[axis][i];
                let whole = (part + WHOLE) - WHOLE;
                let whole = if whole > part { whole - 1.0 } else { whole };
                let last = first[axis] + (across - 1.0);
                let whole = if whole > first[axis] { whole } else { first[axis] };
                let whole = if whole < last { whole } else { last };
                let at = if is_left[axis] { next[axis] } else { whole };
                lanes.at[axis][i] = at;
                numbers_at[axis] = (at + WHOLE).to_bits() as u32;
            }
            lanes.t[i] = t;
            (lanes.middle[i], lanes.fine[i]) = numbers(numbers_at);
        }
    }
}
