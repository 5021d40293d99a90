//! The roots of whole squares: Newton's method for 64 rays at once, and one enclosure to certify each.
//!
//! In: rays with a bracket in which g has exactly one root and its slope along the ray is at least so steep. Out: roots. A point
//! t of the bracket is within |g(t)| / steepness of the root (mean value theorem), so that an enclosure of g at t alone
//! proves how near it is. Separate from [`super::refine`], which knows less of its brackets and must look at both sides.

use super::bundle::{Bundle, Spans};
use super::isolate::place;
use super::kernels::Formula;
use super::refine::{WIDTH, points_at};
use super::sheet::{CELLS, Cells, POINTS, Points};
use super::tile::Crossing;
use crate::num::interval_lanes::PARTIAL;
use crate::num::level::{Level, Simd, for_each_level};
use glam::DVec3;
use std::ops::Range;

/// A step not longer than this part of the scale is the last: the next is its square.
const CONVERGED: f64 = 2e-6;

/// How much shorter the only step must be, for the normal is that of its beginning.
const ALONE: f64 = 20.0;

/// A step by two points is the last where the term of highest order is not longer than this part of the scale: the terms that
/// are missing are smaller still.
const LAST_TERM: f64 = 1e-10;

/// What that step and the one before may come to, multiplied, as a part of the scale's square: so much a gradient
/// that is carried on in a straight line is off.
const STRAIGHT: f64 = 2e-7;

/// Steps after which the rest is left to single rays.
const MOST_STEPS: usize = 5;

/// What a distance along a ray and a depth may be off by, being products of a few roundings; a hundred times too much.
pub(crate) const SHORTENED: f64 = 1.0 - 1e-13;
pub(crate) const LENGTHENED: f64 = 1.0 + 1e-13;

/// What became of a ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Root {
    /// Which ray.
    pub(crate) ray: usize,
    /// The bracket.
    pub(crate) a: f64,
    pub(crate) b: f64,
    /// Enclosures so far.
    pub(crate) cost: u32,
    /// The root; an end of the bracket, if it is proven to be beyond an end of the ray.
    pub(crate) t: f64,
    /// How far the true one can be from it; NaN if that could not be told.
    pub(crate) width: f64,
    /// The unit gradient of g there, turned against the ray, and whether it had to be turned.
    pub(crate) normal: DVec3,
    pub(crate) flipped: bool,
}

/// Rays waiting to be a batch, a number of each in an array.
#[derive(Debug)]
pub(crate) struct Stream {
    count: usize,
    ray: [usize; POINTS],
    cost: [u32; POINTS],
    origin: [[f64; POINTS]; 3],
    direction: [[f64; POINTS]; 3],
    a: [f64; POINTS],
    b: [f64; POINTS],
    t: [f64; POINTS],
    steepness: [f64; POINTS],
    /// The sign of g in front of the root.
    front: [f64; POINTS],
    /// Whether t is not where the root may be, but the ray's end, which is likely in front of it (1), or its beginning (−1).
    beyond: [f64; POINTS],
    /// What the second derivative of g along the ray is about.
    curvature: [f64; POINTS],
    /// The last step's length, 0 for a ray that is done; infinite before the first.
    moved: [f64; POINTS],
    /// What tolerances are parts of.
    scale: [f64; POINTS],
    /// The last step, and where it began: g, its inverse slope along the ray, and its gradient.
    stride: [f64; POINTS],
    value: [f64; POINTS],
    inverse: [f64; POINTS],
    here: [[f64; POINTS]; 3],
    /// The gradient where it ended: at first as computed, then carried on.
    gradient: [[f64; POINTS]; 3],
    flipped: [f64; POINTS],
}

impl Default for Stream {
    fn default() -> Self {
        let zero = [0.0; POINTS];
        Stream {
            count: 0,
            ray: [0; POINTS],
            cost: [0; POINTS],
            origin: [zero; 3],
            direction: [zero; 3],
            a: zero,
            b: zero,
            t: zero,
            steepness: zero,
            front: zero,
            beyond: zero,
            curvature: zero,
            moved: zero,
            scale: zero,
            stride: zero,
            value: zero,
            inverse: zero,
            here: [zero; 3],
            gradient: [zero; 3],
            flipped: zero,
        }
    }
}

/// What a stream computes with.
pub(crate) struct Tools<'a> {
    pub(crate) formula: Formula<'a>,
    /// Registers of the sheet's gradient at points, and of its values over pieces of rays.
    pub(crate) gradient: &'a mut [Points],
    pub(crate) cells: &'a mut [Cells],
    /// The length that tolerances are measured by.
    pub(crate) size: f64,
    pub(crate) simd: Simd,
    /// Evaluations so far.
    pub(crate) evaluations: u64,
    /// Enclosures so far.
    pub(crate) enclosures: u64,
}

impl Stream {
    /// Takes the rays of a crossing in a rectangle `width` pixels wide, but for those that end before it.
    pub(crate) fn take(
        &mut self,
        crossing: &Crossing,
        (bundle, spans, width): (&Bundle, &mut Spans, u32),
        tools: &mut Tools,
        found: &mut impl FnMut(&Root, &mut Spans),
    ) {
        let place = crossing.place;
        for row in 0..place.height {
            while self.count + place.width as usize > POINTS {
                self.run(spans, tools, found);
            }
            let first = ((place.top + row) * width + place.left) as usize;
            let mut rays = first..first + place.width as usize;
            let ends = |i: &usize| {
                !(spans.near[*i] <= spans.far[*i]) || crossing.a * bundle.length[*i] > spans.far[*i] * LENGTHENED
            };
            while let Some(start) = rays.find(|i| !ends(i)) {
                let end = rays.find(ends).unwrap_or(rays.end);
                self.take_row(crossing, (row, first), start..end, (bundle, spans), tools.simd);
            }
        }
    }

    /// Takes some rays of a row of a crossing whose first ray has this number.
    fn take_row(
        &mut self,
        crossing: &Crossing,
        (row, first): (u32, usize),
        rays: Range<usize>,
        (bundle, spans): (&Bundle, &Spans),
        simd: Simd,
    ) {
        let (start, end) = (self.count, self.count + rays.len());
        for axis in 0..3 {
            self.origin[axis][start..end].copy_from_slice(&bundle.origin[axis][rays.clone()]);
            self.direction[axis][start..end].copy_from_slice(&bundle.direction[axis][rays.clone()]);
        }
        let column = (rays.start - first) as f64;
        let [length, near, far] = [&bundle.length, &spans.near, &spans.far].map(|all| &all[rays.clone()]);
        guess(simd, self, crossing, [column, f64::from(row)], length, [near, far]);
        for (slot, ray) in self.ray[start..end].iter_mut().zip(rays) {
            *slot = ray;
        }
        self.cost[start..end].fill(crossing.cost);
        self.count = end;
    }

    /// Finds the roots of all rays that wait.
    pub(crate) fn run(&mut self, spans: &mut Spans, tools: &mut Tools, found: &mut impl FnMut(&Root, &mut Spans)) {
        let count = std::mem::take(&mut self.count);
        let mut live = begin(tools.simd, self, tools.size, count);
        for _ in 0..MOST_STEPS {
            if live == 0 {
                break;
            }
            points_at(tools.simd, &self.origin, &self.direction, &self.t, tools.gradient);
            tools.formula.gradient().run(tools.gradient);
            tools.evaluations += live;
            let [g, x, y, z] = [0, 1, 2, 3].map(|k| &tools.formula.gradient().output(tools.gradient, k).0);
            live = step(tools.simd, self, g, [x, y, z]);
        }
        face(tools.simd, self);
        for first in (0..count).step_by(CELLS) {
            self.certify((spans, tools), first, count, found);
        }
    }

    /// Finds the roots of all rays that wait, and of those that wait once more.
    pub(crate) fn finish(&mut self, spans: &mut Spans, tools: &mut Tools, found: &mut impl FnMut(&Root, &mut Spans)) {
        while self.count > 0 {
            self.run(spans, tools, found);
        }
    }

    /// Encloses g where Newton's method ended, or where the ray does. Rays that were wrongly thought to end before their root wait again.
    fn certify(
        &mut self,
        (spans, tools): (&mut Spans, &mut Tools),
        first: usize,
        count: usize,
        found: &mut impl FnMut(&Root, &mut Spans),
    ) {
        let part = |all: &[f64; POINTS]| -> [f64; CELLS] { std::array::from_fn(|k| all[first + k]) };
        let (origin, direction) =
            ([0, 1, 2].map(|k| part(&self.origin[k])), [0, 1, 2].map(|k| part(&self.direction[k])));
        let t = part(&self.t);
        place(tools.simd, &origin, &direction, &t, &t, tools.cells);
        tools.formula.value().run(tools.cells);
        tools.enclosures += CELLS.min(count - first) as u64;
        let g = tools.formula.value().output(tools.cells, 0);
        for k in 0..CELLS.min(count - first) {
            let i = first + k;
            let is_whole = g.flags[k] & PARTIAL == 0;
            let (a, b) = (self.a[i], self.b[i]);
            let (t, width) = if self.beyond[i] == 0.0 {
                let far = g.hi[k].max(-g.lo[k]) / self.steepness[i];
                let width = WIDTH * tools.size.max(t[k]);
                let known = is_whole && far <= width && self.moved[i] == 0.0;
                (t[k], if known { width } else { f64::NAN })
            } else {
                let sign = f64::from(i8::from(g.lo[k] > 0.0) - i8::from(g.hi[k] < 0.0));
                if !(is_whole && sign == self.front[i] * self.beyond[i]) {
                    self.wait_again(i);
                    continue;
                }
                (if self.beyond[i] > 0.0 { b } else { a }, b - a)
            };
            let normal = DVec3::new(self.gradient[0][i], self.gradient[1][i], self.gradient[2][i]);
            let (ray, cost, flipped) = (self.ray[i], self.cost[i], self.flipped[i] > 0.0);
            found(&Root { ray, a, b, cost, t, width, normal, flipped }, spans);
        }
    }

    /// Lets ray i wait once more. Those that wait are before it, for it was taken out of as many places as it stands behind.
    fn wait_again(&mut self, i: usize) {
        let to = self.count;
        (self.ray[to], self.cost[to]) = (self.ray[i], self.cost[i]);
        let Stream { a, b, t, steepness, front, curvature, origin, direction, .. } = self;
        for all in [a, b, t, steepness, front, curvature].into_iter().chain(origin).chain(direction) {
            all[to] = all[i];
        }
        self.beyond[to] = 0.0;
        self.count += 1;
    }
}

for_each_level! {
    /// Where the roots in a row of a crossing may be, from some column on.
    fn guess[L](stream: &mut Stream, crossing: &Crossing, at: [f64; 2], length: &[f64], span: [&[f64]; 2]) {
        let start = stream.count;
        let ([column, row], [near, far], [depth, across, down]) = (at, span, crossing.depth);
        let (near, far) = (&near[..length.len()], &far[..length.len()]);
        let depth = depth + down * (row - 0.5 * f64::from(crossing.place.height - 1));
        let middle = 0.5 * f64::from(crossing.place.width - 1) - column;
        let end = start + length.len();
        let (a, b, t) = (&mut stream.a[start..end], &mut stream.b[start..end], &mut stream.t[start..end]);
        let (steepness, curvature) = (&mut stream.steepness[start..end], &mut stream.curvature[start..end]);
        let (front, beyond) = (&mut stream.front[start..end], &mut stream.beyond[start..end]);
        for i in 0..length.len() {
            let long = length[i];
            a[i] = crossing.a * long * SHORTENED;
            b[i] = crossing.b * long * LENGTHENED;
            let likely = (depth + across * (i as f64 - middle)) * long;
            let inside = (likely > a[i]) & (likely < b[i]);
            let likely = if inside { likely } else { 0.5 * (a[i] + b[i]) };
            let behind = likely > far[i];
            let limit = if behind { far[i] } else { near[i] };
            let is_beyond = (behind | (likely < near[i])) & (limit > a[i] * LENGTHENED) & (limit < b[i] * SHORTENED);
            t[i] = if is_beyond { limit } else { likely };
            let side = if behind { 1.0 } else { -1.0 };
            beyond[i] = if is_beyond { side } else { 0.0 };
            front[i] = crossing.front;
            steepness[i] = crossing.steepness / long * SHORTENED;
            curvature[i] = crossing.curvature / (long * long);
        }
    }
}

for_each_level! {
    /// Makes the first rays ready to step, and says how many of them have to.
    fn begin[L](stream: &mut Stream, size: f64, count: usize) -> u64 {
        let mut live = 0;
        for i in 0..POINTS {
            let t = stream.t[i];
            stream.scale[i] = if t > size { t } else { size };
            let is_live = (i < count) & (stream.beyond[i] == 0.0);
            stream.moved[i] = if is_live { f64::INFINITY } else { 0.0 };
            live += u64::from(is_live);
        }
        live
    }
}

for_each_level! {
    /// One step in all rays that are not done, of which it says how many are left: the first by Newton's method, the others by the cubic in g that has values and slopes
    /// of t(g) at the last two points (inverse Hermite interpolation; Traub, Iterative Methods for the Solution of
    /// Equations, 1964, chapter 4). The gradient is carried on to where the step leads by what it changed over the step before.
    fn step[L](stream: &mut Stream, g: &[f64; POINTS], gradient: [&[f64; POINTS]; 3]) -> u64 {
        let mut left = 0;
        for i in 0..POINTS {
            let live = stream.moved[i] > 0.0;
            let first = stream.moved[i] == f64::INFINITY;
            let (t, scale, before) = (stream.t[i], stream.scale[i], stream.stride[i]);
            let (x, y, z) = (stream.direction[0][i], stream.direction[1][i], stream.direction[2][i]);
            let inverse = 1.0 / L::fma(gradient[0][i], x, L::fma(gradient[1][i], y, gradient[2][i] * z));
            let newton = -g[i] * inverse;
            // Newton's divided differences at g, g, g before, g before.
            let span = 1.0 / (stream.value[i] - g[i]);
            let chord = -before * span;
            let second = (chord - inverse) * span;
            let third = ((stream.inverse[i] - chord) * span - second) * span;
            let square = g[i] * g[i];
            let last = third * square * stream.value[i];
            let bend = L::fma(second, square, -last);
            let bend = if first { -0.5 * stream.curvature[i] * inverse * newton * newton } else { bend };
            let bent = bend.abs() < 0.5 * newton.abs();
            let cubic = !first & bent;
            let next = t + newton + if bent { bend } else { 0.0 };
            let next = if next > stream.a[i] { next } else { stream.a[i] };
            let next = if next < stream.b[i] { next } else { stream.b[i] };
            let stride = next - t;
            let ahead = stride / before;
            let ahead = if !first & (ahead.abs() < 1.0) { ahead } else { 0.0 };
            for k in 0..3 {
                let here = gradient[k][i];
                let carried = L::fma(here - stream.here[k][i], ahead, here);
                stream.gradient[k][i] = if live { carried } else { stream.gradient[k][i] };
                stream.here[k][i] = here;
            }
            // Nothing is known of how the gradient changes after one step alone, which must be the shorter.
            let moved = if first { ALONE * stride.abs() } else { stride.abs() };
            let straight = (stride * before).abs() <= STRAIGHT * scale * scale;
            let done = (moved <= CONVERGED * scale) | (cubic & straight & (last.abs() <= LAST_TERM * scale));
            stream.t[i] = if live { next } else { t };
            stream.stride[i] = stride;
            stream.value[i] = g[i];
            stream.inverse[i] = inverse;
            let moved = if done { 0.0 } else { stride.abs() };
            let moved = if live { moved } else { 0.0 };
            stream.moved[i] = moved;
            left += u64::from(moved > 0.0);
        }
        left
    }
}

for_each_level! {
    /// Gradients become normals that face where the rays come from.
    fn face[L](stream: &mut Stream) {
        for i in 0..POINTS {
            let (x, y, z) = (stream.gradient[0][i], stream.gradient[1][i], stream.gradient[2][i]);
            let (dx, dy, dz) = (stream.direction[0][i], stream.direction[1][i], stream.direction[2][i]);
            let along = L::fma(x, dx, L::fma(y, dy, z * dz));
            let length = L::fma(x, x, L::fma(y, y, z * z)).sqrt();
            let size = if length < f64::INFINITY { 1.0 / length } else { f64::NAN };
            let scale = if along > 0.0 { -size } else { size };
            stream.flipped[i] = along;
            (stream.gradient[0][i], stream.gradient[1][i], stream.gradient[2][i]) = (x * scale, y * scale, z * scale);
        }
    }
}
