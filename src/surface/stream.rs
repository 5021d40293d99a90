//! The roots of whole squares: Newton's method for 64 rays at once, and one enclosure to certify each.
//!
//! In: rays with a bracket in which g has exactly one root and its slope along the ray is at least so steep. Out: roots. A point
//! t of the bracket is within |g(t)| / steepness of the root (mean value theorem), so that an enclosure of g at t alone
//! proves how near it is. Separate from [`super::refine`], which knows less of its brackets and must look at both sides.

use super::hit::Ray;
use super::isolate::place;
use super::refine::{WIDTH, points_at};
use super::sheet::{CELLS, Cells, POINTS, Points, Sheet};
use crate::num::interval_lanes::PARTIAL;
use crate::num::level::{Level, Simd, for_each_level};
use glam::DVec3;

/// Newton's method ends when no step was longer than this part of the scale; the next is its square, and the normal, taken
/// before the last step, is as exact as f32.
const CONVERGED: f64 = 1e-7;

/// Steps after which the rest is left to single rays.
const MOST_STEPS: usize = 5;

/// One ray with its bracket.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Guess {
    /// Which ray.
    pub(crate) ray: u32,
    /// The bracket.
    pub(crate) a: f64,
    pub(crate) b: f64,
    /// Where the root may be.
    pub(crate) t: f64,
    /// The least |g'| in the bracket.
    pub(crate) steepness: f64,
    /// Enclosures so far.
    pub(crate) cost: u32,
}

/// What became of a guess.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Root {
    /// What was asked.
    pub(crate) guess: Guess,
    /// The root.
    pub(crate) t: f64,
    /// How far the true one can be from it; NaN if that could not be told.
    pub(crate) width: f64,
    /// The gradient of g beside it.
    pub(crate) gradient: DVec3,
}

/// Rays waiting to be a batch, a number of each in an array.
#[derive(Debug)]
pub(crate) struct Stream {
    guesses: Vec<Guess>,
    origin: [[f64; POINTS]; 3],
    direction: [[f64; POINTS]; 3],
    a: [f64; POINTS],
    b: [f64; POINTS],
    t: [f64; POINTS],
    moved: [f64; POINTS],
    tolerance: [f64; POINTS],
    gradient: [[f64; POINTS]; 3],
}

impl Default for Stream {
    fn default() -> Self {
        let zero = [0.0; POINTS];
        Stream {
            guesses: Vec::with_capacity(POINTS),
            origin: [zero; 3],
            direction: [zero; 3],
            a: zero,
            b: zero,
            t: zero,
            moved: zero,
            tolerance: zero,
            gradient: [zero; 3],
        }
    }
}

/// The register files of a stream.
pub(crate) struct StreamFiles<'a> {
    pub(crate) gradient: &'a mut [Points],
    pub(crate) cells: &'a mut [Cells],
}

impl Stream {
    /// Takes one more ray; true when the batch is full and must be run.
    pub(crate) fn push(&mut self, guess: Guess, ray: &Ray, size: f64) -> bool {
        let i = self.guesses.len();
        for axis in 0..3 {
            self.origin[axis][i] = ray.origin[axis];
            self.direction[axis][i] = ray.direction[axis];
        }
        (self.a[i], self.b[i], self.t[i]) = (guess.a, guess.b, guess.t);
        self.tolerance[i] = CONVERGED * size.max(guess.t);
        self.moved[i] = f64::INFINITY;
        self.guesses.push(guess);
        i + 1 == POINTS
    }

    /// Finds the roots of all rays that wait, and says how many evaluations it took.
    pub(crate) fn run(
        &mut self,
        sheet: &Sheet,
        files: &mut StreamFiles,
        (size, simd): (f64, Simd),
        out: &mut Vec<Root>,
    ) -> u64 {
        let count = self.guesses.len();
        if count == 0 {
            return 0;
        }
        self.moved[count..].fill(0.0);
        let mut evaluations = 0;
        for _ in 0..MOST_STEPS {
            let live = (0..count).filter(|&i| self.moved[i] > self.tolerance[i]).count();
            if live == 0 {
                break;
            }
            points_at(simd, &self.origin, &self.direction, &self.t, files.gradient);
            sheet.gradient.run(files.gradient);
            evaluations += live as u64;
            let [g, x, y, z] = [0, 1, 2, 3].map(|k| &sheet.gradient.output(files.gradient, k).0);
            step(simd, self, g, [x, y, z]);
        }
        for first in (0..count).step_by(CELLS) {
            self.certify(sheet, files, (size, simd), first, out);
        }
        self.guesses.clear();
        evaluations
    }

    /// Encloses g where Newton's method ended.
    fn certify(
        &self,
        sheet: &Sheet,
        files: &mut StreamFiles,
        (size, simd): (f64, Simd),
        first: usize,
        out: &mut Vec<Root>,
    ) {
        let part = |all: &[f64; POINTS]| -> [f64; CELLS] { std::array::from_fn(|k| all[first + k]) };
        let (origin, direction) =
            ([0, 1, 2].map(|k| part(&self.origin[k])), [0, 1, 2].map(|k| part(&self.direction[k])));
        let t = part(&self.t);
        place(simd, &origin, &direction, &t, &t, files.cells);
        sheet.value.run(files.cells);
        let g = sheet.value.output(files.cells, 0);
        for (k, guess) in self.guesses.iter().skip(first).take(CELLS).enumerate() {
            let i = first + k;
            let far = g.hi[k].max(-g.lo[k]) / guess.steepness;
            let width = WIDTH * size.max(t[k]);
            let known = g.flags[k] & PARTIAL == 0 && far <= width && self.moved[i] <= self.tolerance[i];
            let gradient = DVec3::new(self.gradient[0][i], self.gradient[1][i], self.gradient[2][i]);
            out.push(Root { guess: *guess, t: t[k], width: if known { width } else { f64::NAN }, gradient });
        }
    }
}

for_each_level! {
    /// One step of Newton's method in all rays that are not done.
    fn step[L](stream: &mut Stream, g: &[f64; POINTS], gradient: [&[f64; POINTS]; 3]) {
        let [x, y, z] = gradient;
        for i in 0..POINTS {
            let live = stream.moved[i] > stream.tolerance[i];
            let t = stream.t[i];
            let [dx, dy, dz] = [stream.direction[0][i], stream.direction[1][i], stream.direction[2][i]];
            let slope = L::fma(x[i], dx, L::fma(y[i], dy, z[i] * dz));
            let next = (t - g[i] / slope).max(stream.a[i]).min(stream.b[i]);
            stream.t[i] = if live { next } else { t };
            stream.moved[i] = if live { (next - t).abs() } else { stream.moved[i] };
            stream.gradient[0][i] = if live { x[i] } else { stream.gradient[0][i] };
            stream.gradient[1][i] = if live { y[i] } else { stream.gradient[1][i] };
            stream.gradient[2][i] = if live { z[i] } else { stream.gradient[2][i] };
        }
    }
}
