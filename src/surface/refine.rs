//! Newton's method inside a bracket, and the certificate of its result.
//!
//! In: slabs on which g is strictly monotone. Out: roots, each with a proof that g changes sign within
//! [`WIDTH`] of it; slabs proven to hold no root; and what could not be proven, for [`super::careful`].
//!
//! Newton runs on points, 64 rays at once: it may be wrong and nobody is harmed. Where a slab is known to hold a root, the proof is one
//! enclosure of g at the result: over the least slope it is how far the root can be. Else it is two, in front of the result and
//! behind it: g is monotone, so opposite signs there mean exactly one root between them and none elsewhere in
//! the slab, and equal signs at both ends mean none at all.

use super::bundle::Asked;
use super::isolate::{Bracket, Rays, place};
use super::kernels::Formula;
use super::sheet::{CELLS, Cells, POINTS, Points};
use crate::num::level::{Level, Simd, for_each_level};
use glam::DVec3;

/// Half the width of a certified bracket, as a part of the ray's scale (the larger of the distance and the
/// region's size): the bracket is a fifth of the 1e-9 that is promised.
pub(crate) const WIDTH: f64 = 1e-10;

/// Newton's steps end when one is shorter than this part of the scale: the next would be its square.
const CONVERGED: f64 = 1e-8;

/// Steps after which a bracket is left to the careful method; bisection alone would need 27.
const MOST_STEPS: usize = 40;

/// What became of a bracket.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Refined {
    /// One root, proven within `width` of t; the gradient of g there.
    Root {
        /// The slab.
        bracket: Bracket,
        /// The root.
        t: f64,
        /// How far it can be from the true one.
        width: f64,
        /// The gradient of g at the root.
        gradient: DVec3,
    },
    /// Proven: no root in the slab.
    Nothing(Bracket),
    /// Neither could be proven.
    Unclear(Bracket),
}

/// The rays of one batch, a number of each in an array.
#[derive(Clone, Debug)]
pub(crate) struct Batch {
    origin: [[f64; POINTS]; 3],
    direction: [[f64; POINTS]; 3],
    /// Where g was seen with the sign it has at the slab's start.
    a: [f64; POINTS],
    /// Where it was seen with the other.
    b: [f64; POINTS],
    t: [f64; POINTS],
    /// g at a, then the sign there.
    front: [f64; POINTS],
    behind: [f64; POINTS],
    /// How far the last step went; a ray is done when that is within its tolerance.
    moved: [f64; POINTS],
    tolerance: [f64; POINTS],
    gradient: [[f64; POINTS]; 3],
}

impl Default for Batch {
    fn default() -> Self {
        let zero = [0.0; POINTS];
        Batch {
            origin: [zero; 3],
            direction: [zero; 3],
            a: zero,
            b: zero,
            t: zero,
            front: zero,
            behind: zero,
            moved: zero,
            tolerance: zero,
            gradient: [zero; 3],
        }
    }
}

/// What was computed.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Work {
    pub(crate) points: u64,
    pub(crate) gradients: u64,
    pub(crate) cells: u64,
}

/// The register files that refining runs on.
pub(crate) struct Files<'a> {
    pub(crate) point: &'a mut [Points],
    pub(crate) gradient: &'a mut [Points],
    pub(crate) cells: &'a mut [Cells],
}

impl Batch {
    /// Refines at most [`POINTS`] brackets.
    pub(crate) fn run(
        &mut self,
        formula: Formula,
        files: &mut Files,
        rays: &Rays,
        brackets: &[Bracket],
        out: &mut Vec<Refined>,
    ) -> Work {
        let brackets = &brackets[..brackets.len().min(POINTS)];
        let mut work = Work::default();
        self.load(brackets, rays.list);
        if !brackets.iter().all(Bracket::has_root) {
            self.ends(rays.simd, formula, files);
            work.points += 2 * brackets.len() as u64;
        }
        self.known_ends(brackets);
        work.gradients += self.newton(formula, files, rays, brackets);
        let mut left = Vec::with_capacity(POINTS);
        let all: [usize; POINTS] = std::array::from_fn(|i| i);
        for lanes in all[..brackets.len()].chunks(CELLS) {
            if lanes.iter().any(|&i| brackets[i].has_root()) {
                self.certify_by_slope(formula, files, rays, lanes, brackets, (out, &mut left));
                work.cells += lanes.len() as u64;
            } else {
                left.extend_from_slice(lanes);
            }
        }
        for lanes in left.chunks(CELLS) {
            self.certify(formula, files, rays, lanes, brackets, out);
            work.cells += 2 * lanes.len() as u64;
        }
        work
    }

    fn load(&mut self, brackets: &[Bracket], rays: Asked) {
        for i in 0..POINTS {
            let bracket = &brackets[i.min(brackets.len() - 1)];
            let ray = rays.ray(bracket.open.ray);
            for axis in 0..3 {
                self.origin[axis][i] = ray.origin[axis];
                self.direction[axis][i] = ray.direction[axis];
            }
            (self.a[i], self.b[i]) = (bracket.open.a, bracket.b);
        }
    }

    /// g at both ends, and where the chord between them crosses zero.
    fn ends(&mut self, simd: Simd, formula: Formula, files: &mut Files) {
        points_at(simd, self.origin.each_ref(), self.direction.each_ref(), &self.a, files.point);
        formula.point().run(files.point);
        self.front = formula.point().output(files.point, 0).0;
        points_at(simd, self.origin.each_ref(), self.direction.each_ref(), &self.b, files.point);
        formula.point().run(files.point);
        self.behind = formula.point().output(files.point, 0).0;
        for i in 0..POINTS {
            let (a, b, f, g) = (self.a[i], self.b[i], self.front[i], self.behind[i]);
            let t = a - f * (b - a) / (g - f);
            self.t[i] = if t > a && t < b { t } else { 0.5 * (a + b) };
        }
    }

    /// The signs at both ends where they are known; the middle is where the bracket's form says that the root is.
    fn known_ends(&mut self, brackets: &[Bracket]) {
        for (i, bracket) in brackets.iter().enumerate().filter(|(_, bracket)| bracket.has_root()) {
            (self.front[i], self.behind[i]) = (bracket.front, -bracket.front);
            self.t[i] = 0.5 * (bracket.open.a + bracket.b);
        }
    }

    /// Whether the values at the ends say that there is a root. They are not proven; the certificate is.
    fn crosses(&self, i: usize) -> bool {
        (self.front[i] < 0.0) != (self.behind[i] < 0.0)
    }

    /// Newton's method for all brackets with a root, each kept inside its bracket; how many evaluations it took.
    fn newton(&mut self, formula: Formula, files: &mut Files, rays: &Rays, brackets: &[Bracket]) -> u64 {
        self.moved = std::array::from_fn(|i| if i < brackets.len() && self.crosses(i) { f64::INFINITY } else { 0.0 });
        self.tolerance = std::array::from_fn(|i| CONVERGED * rays.size.max(self.a[i]));
        let mut evaluations = 0;
        for _ in 0..MOST_STEPS {
            let live = (0..POINTS).filter(|&i| self.moved[i] > self.tolerance[i]).count();
            if live == 0 {
                break;
            }
            points_at(rays.simd, self.origin.each_ref(), self.direction.each_ref(), &self.t, files.gradient);
            formula.gradient().run(files.gradient);
            evaluations += live as u64;
            let [g, x, y, z] = [0, 1, 2, 3].map(|k| &formula.gradient().output(files.gradient, k).0);
            step(rays.simd, self, g, [x, y, z]);
        }
        evaluations
    }

    /// Proves what Newton found where a root is known to be, for at most [`CELLS`] brackets: g at the result over the least slope is how far
    /// the root can be. Leaves those for which that is not near enough.
    fn certify_by_slope(
        &self,
        formula: Formula,
        files: &mut Files,
        rays: &Rays,
        lanes: &[usize],
        brackets: &[Bracket],
        (out, left): (&mut Vec<Refined>, &mut Vec<usize>),
    ) {
        let (origin, direction) = self.rays_of(lanes);
        let mut at = [0.0; CELLS];
        for (k, &i) in lanes.iter().enumerate() {
            at[k] = self.t[i];
        }
        place(rays.simd, origin.each_ref(), direction.each_ref(), &at, &at, files.cells);
        formula.value().run(files.cells);
        let g = formula.value().output(files.cells, 0);
        for (k, &i) in lanes.iter().enumerate() {
            let width = WIDTH * rays.size.max(self.t[i]);
            let most = g.hi[k].max(-g.lo[k]);
            let is_near = most <= brackets[i].steepness * width * (1.0 - 4.0 * f64::EPSILON);
            if brackets[i].has_root() && is_near {
                out.push(self.root(i, brackets[i], width));
            } else {
                left.push(i);
            }
        }
    }

    fn root(&self, i: usize, bracket: Bracket, width: f64) -> Refined {
        let gradient = DVec3::new(self.gradient[0][i], self.gradient[1][i], self.gradient[2][i]);
        Refined::Root { bracket, t: self.t[i], width, gradient }
    }

    /// The rays of some brackets.
    fn rays_of(&self, lanes: &[usize]) -> ([[f64; CELLS]; 3], [[f64; CELLS]; 3]) {
        let (mut origin, mut direction) = ([[0.0; CELLS]; 3], [[0.0; CELLS]; 3]);
        for (k, &i) in lanes.iter().enumerate() {
            for axis in 0..3 {
                origin[axis][k] = self.origin[axis][i];
                direction[axis][k] = self.direction[axis][i];
            }
        }
        (origin, direction)
    }

    /// Proves what Newton found, for at most [`CELLS`] brackets.
    fn certify(
        &self,
        formula: Formula,
        files: &mut Files,
        rays: &Rays,
        lanes: &[usize],
        brackets: &[Bracket],
        out: &mut Vec<Refined>,
    ) {
        let (simd, size) = (rays.simd, rays.size);
        let (origin, direction) = self.rays_of(lanes);
        let (mut front, mut behind) = ([0.0; CELLS], [0.0; CELLS]);
        for (k, &i) in lanes.iter().enumerate() {
            let (bracket, width) = (&brackets[i], WIDTH * size.max(self.t[i]));
            (front[k], behind[k]) = if self.crosses(i) {
                ((self.t[i] - width).max(bracket.open.a), (self.t[i] + width).min(bracket.b))
            } else {
                (bracket.open.a, bracket.b)
            };
        }
        let in_front = signs_at(simd, formula, files.cells, &origin, &direction, &front);
        let after = signs_at(simd, formula, files.cells, &origin, &direction, &behind);
        for (k, &i) in lanes.iter().enumerate() {
            out.push(match (self.crosses(i), in_front[k] * after[k]) {
                (true, -1) => self.root(i, brackets[i], WIDTH * size.max(self.t[i])),
                (false, 1) => Refined::Nothing(brackets[i]),
                _ => Refined::Unclear(brackets[i]),
            });
        }
    }
}

/// The proven sign of g at one distance on each ray: −1, 1, or 0 when it is not proven.
fn signs_at(
    simd: Simd,
    formula: Formula,
    cells: &mut [Cells],
    origin: &[[f64; CELLS]; 3],
    direction: &[[f64; CELLS]; 3],
    t: &[f64; CELLS],
) -> [i8; CELLS] {
    place(simd, origin.each_ref(), direction.each_ref(), t, t, cells);
    formula.value().run(cells);
    let g = formula.value().output(cells, 0);
    std::array::from_fn(|i| i8::from(g.lo[i] > 0.0) - i8::from(g.hi[i] < 0.0))
}

for_each_level! {
    /// One step of Newton's method in all rays that are not done.
    fn step[L](batch: &mut Batch, g: &[f64; POINTS], gradient: [&[f64; POINTS]; 3]) {
        let [x, y, z] = gradient;
        for i in 0..POINTS {
            let live = batch.moved[i] > batch.tolerance[i];
            let (t, value) = (batch.t[i], g[i]);
            let [dx, dy, dz] = [batch.direction[0][i], batch.direction[1][i], batch.direction[2][i]];
            let slope = L::fma(x[i], dx, L::fma(y[i], dy, z[i] * dz));
            let in_front = (value < 0.0) == (batch.front[i] < 0.0);
            let a = if live & in_front { t } else { batch.a[i] };
            let b = if live & !in_front { t } else { batch.b[i] };
            let newton = t - value / slope;
            let next = if (newton >= a) & (newton <= b) { newton } else { 0.5 * (a + b) };
            batch.a[i] = a;
            batch.b[i] = b;
            batch.t[i] = if live { next } else { t };
            batch.moved[i] = if live { (next - t).abs() } else { batch.moved[i] };
            batch.gradient[0][i] = if live { x[i] } else { batch.gradient[0][i] };
            batch.gradient[1][i] = if live { y[i] } else { batch.gradient[1][i] };
            batch.gradient[2][i] = if live { z[i] } else { batch.gradient[2][i] };
        }
    }
}

for_each_level! {
    /// Puts the points at distance t on each ray into the registers of the coordinates.
    pub(crate) fn points_at[L](
        origin: [&[f64; POINTS]; 3], direction: [&[f64; POINTS]; 3], t: &[f64; POINTS], points: &mut [Points],
    ) {
        for axis in 0..3 {
            let (o, d) = (origin[axis], direction[axis]);
            let point = &mut points[axis].0;
            for i in 0..POINTS {
                point[i] = L::fma(t[i], d[i], o[i]);
            }
        }
    }
}
