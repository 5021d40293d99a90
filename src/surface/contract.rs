//! The faithful method by forms: as [`super::isolate`], with affine forms of the distance along the ray in place of intervals.
//!
//! In: rays with the part of each that is still open. Out: brackets on which g is monotone, most of them with g known to be of opposite
//! signs at both ends; rays proven empty; rays that need [`super::careful`]. Separate from intervals because a form
//! knows more than how large g gets.
//!
//! Over its slab [a, b] a lane encloses g by c + s·ε ± error, ε from −1 to 1 along the slab.
//! - 0 is not in it, or g has no value there: nothing is there. Go on behind it with twice the length.
//! - The linear part says where zero can be, and what sign g has in front of that and behind it: the slab becomes that part.
//! - g' has one sign: at most one root. Without one if g has that sign in front; else the slab is handed over.
//! - None of these: the first half of where zero can be.
//!
//! g' costs as much again as g or more, so it is looked at only where g has opposite signs at both ends or moves away from zero, and where a ray
//! leaves a surface.

use super::isolate::{
    CellFiles, Found, MOST_SLABS, Open, PER_DISTANCE, PER_ORIGIN, Pool, Rays, Verdict, Walker, place,
};
use super::kernels::Formula;
use super::sheet::{CELLS, Cells, RayForms};
use super::tile::{NARROWER, WIDER};
use crate::num::interval_lanes::{JUMP, NOWHERE, PARTIAL};
use crate::num::level::{Level, for_each_level};

/// The first slab of a ray that leaves a surface, as a part of the scale: its g and g' are looked at together, for g alone cannot tell the
/// start from a root. From 0.3 to 1 makes little difference.
const FIRST: f64 = 0.3;

/// The same where the slope takes more than [`COSTLY`] times the steps of g.
const FIRST_OF_COSTLY: f64 = 0.1;
const COSTLY: f64 = 2.6;

/// The same for formulas of [`LONG`] steps and more, whose slope is dear, and whose forms know little of long slabs.
const FIRST_OF_LONG: f64 = 0.05;

/// Formulas of so many steps are long (`csg27`, `metaballs`).
const LONG: usize = 100;

/// Slabs shorter than this part of the scale are always looked at with the slope.
const NARROW: f64 = 0.02;

/// Where zero can be is taken wider by this part of the slab: far more than its sums round off.
const MARGIN: f64 = 1e-8;

/// A slab that is contracted to less than this part is looked at again; else it is halved.
const CONTRACTED: f64 = 0.7;

/// The register files of a sheet's forms along rays.
pub(crate) struct RayFiles {
    /// Of g.
    pub(crate) value: Vec<RayForms>,
    /// Of g and g'.
    pub(crate) slope: Vec<RayForms>,
}

impl Pool {
    /// Walks all open rays until each is settled, bracketed or found hard.
    pub(crate) fn contract(
        &mut self,
        formula: Formula,
        (cells, forms): (&mut CellFiles, &mut RayFiles),
        rays: &Rays,
        open: &mut Vec<Open>,
        found: &mut Found,
    ) {
        let narrow = rays.size * NARROW;
        let first = rays.size * first(formula);
        let mut walkers = std::mem::take(&mut self.walkers);
        let mut fresh: Vec<Walker> = Vec::new();
        for open in open.drain(..) {
            if open.a == 0.0 {
                fresh.push(Walker::from(Open { step: open.step.min(first), ..open }));
            } else {
                walkers.push(Walker::from(open));
            }
        }
        self.starts(formula, &mut cells.value, rays, &mut fresh, found);
        self.pass_by_slope(formula, forms, rays, &mut fresh, found);
        walkers.append(&mut found.other);
        while !walkers.is_empty() {
            self.pass(rays, &mut walkers, found, |pool| {
                place_along(rays.simd, &pool.origin, &pool.direction, &pool.a, &pool.b, &mut forms.value);
                formula.value_along().run(&mut forms.value);
                decide_by_value(rays.simd, pool, narrow, formula.value_along().output(&forms.value, 0));
                1
            });
            std::mem::swap(&mut walkers, &mut found.other);
            self.pass_by_slope(formula, forms, rays, &mut walkers, found);
            std::mem::swap(&mut walkers, &mut found.other);
        }
        self.walkers = walkers;
    }

    fn pass_by_slope(
        &mut self,
        formula: Formula,
        forms: &mut RayFiles,
        rays: &Rays,
        walkers: &mut Vec<Walker>,
        found: &mut Found,
    ) {
        let long = 2.0 * NARROW * rays.size;
        let slope = &mut forms.slope;
        self.pass(rays, walkers, found, |pool| {
            place_along(rays.simd, &pool.origin, &pool.direction, &pool.a, &pool.b, slope);
            formula.slope_along().run(slope);
            let (g, of_slope) = (formula.slope_along().output(slope, 0), formula.slope_along().output(slope, 1));
            decide_by_slope(rays.simd, pool, long, g, of_slope);
            1
        });
    }

    /// The signs of g where rays start: one that leaves a surface would else be contracted towards its start again and again.
    fn starts(
        &mut self,
        formula: Formula,
        cells: &mut [Cells],
        rays: &Rays,
        walkers: &mut [Walker],
        found: &mut Found,
    ) {
        for lanes in walkers.chunks_mut(CELLS) {
            for axis in 0..3 {
                for (lane, walker) in lanes.iter().enumerate() {
                    let ray = &rays.list.ray(walker.open.ray);
                    self.origin[axis][lane] = ray.origin[axis];
                    self.direction[axis][lane] = ray.direction[axis];
                }
            }
            let zero = [0.0; CELLS];
            place(rays.simd, self.origin.each_ref(), self.direction.each_ref(), &zero, &zero, cells);
            formula.value().run(cells);
            let g = formula.value().output(cells, 0);
            for (lane, walker) in lanes.iter_mut().enumerate() {
                walker.sign = f64::from(i8::from(g.lo[lane] > 0.0) - i8::from(g.hi[lane] < 0.0));
            }
            found.cells += lanes.len() as u64;
        }
    }
}

/// The first slab of a ray that leaves a surface, as a part of the scale.
fn first(formula: Formula) -> f64 {
    let (value, slope) = (formula.value().len(), formula.slope().len());
    match value {
        LONG.. => FIRST_OF_LONG,
        _ if slope as f64 >= COSTLY * value as f64 => FIRST_OF_COSTLY,
        _ => FIRST,
    }
}

/// The middle of a slab and half its length, or a little more.
#[inline(always)]
fn middle(a: f64, b: f64) -> (f64, f64) {
    let m = 0.5 * (a + b);
    let (before, behind) = (m - a, b - m);
    (m, if before > behind { before } else { behind } * (1.0 + 4.0 * f64::EPSILON))
}

for_each_level! {
    /// The points of slab [a, b] of each lane's ray as forms, and its direction; errors as those of [`place`].
    fn place_along[L](
        origin: &[[f64; CELLS]; 3], direction: &[[f64; CELLS]; 3], a: &[f64; CELLS], b: &[f64; CELLS], forms: &mut [RayForms],
    ) {
        for axis in 0..3 {
            let (o, d) = (&origin[axis], &direction[axis]);
            let form = &mut forms[axis];
            for i in 0..CELLS {
                let (m, h) = middle(a[i], b[i]);
                form.center[i] = L::fma(m, d[i], o[i]);
                form.slope[0][i] = h * d[i];
                form.error[i] = L::fma(b[i], PER_DISTANCE, o[i].abs() * PER_ORIGIN);
            }
            form.flags = [0; CELLS];
            let form = &mut forms[axis + 3];
            form.center = *d;
            form.slope[0] = [0.0; CELLS];
            form.error = [PER_DISTANCE; CELLS];
            form.flags = [0; CELLS];
        }
    }
}

/// What a form says of its slab.
#[derive(Clone, Copy)]
struct Look {
    /// No root is in it.
    empty: bool,
    /// The sign of g where it is left, if it is empty; or 0.
    beyond: f64,
    /// Where a root can be.
    a: f64,
    b: f64,
    /// The signs of g at those, or 0.
    front: f64,
    behind: f64,
    /// g is defined and continuous.
    smooth: bool,
}

impl Look {
    #[inline(always)]
    fn new(pool: &Pool, g: &RayForms, i: usize) -> Look {
        let (a, b) = (pool.a[i], pool.b[i]);
        let (m, h) = middle(a, b);
        let (c, s, radius, flags) = (g.center[i], g.slope[0][i], g.radius(i), g.flags[i]);
        let smooth = flags & (PARTIAL | JUMP) == 0;
        // NaN says nothing in all of these.
        let per = 1.0 / s;
        let (at, half) = (-c * per, (radius - s.abs() * NARROWER) * per.abs());
        let margin = MARGIN * (1.0 + at.abs() + half);
        let (from, to) = (at - half - margin, at + half + margin);
        let slack = b * (4.0 * f64::EPSILON);
        let (first, last) = (m + from * h - slack, m + to * h + slack);
        let (has_front, has_behind) = ((from > -1.0) & (first > a), (to < 1.0) & (last < b));
        let rising = if s > 0.0 { 1.0 } else { -1.0 };
        let known = if smooth { rising } else { 0.0 };
        let first = if has_front { first } else { a };
        let first = if first < b { first } else { b };
        let last = if has_behind { last } else { b };
        Look {
            empty: (c.abs() > radius * WIDER) | (flags & NOWHERE != 0),
            beyond: if !smooth {
                0.0
            } else if c > 0.0 {
                1.0
            } else {
                -1.0
            },
            a: first,
            b: if last > first { last } else { first },
            front: if has_front { -known } else { pool.sign[i] },
            behind: if has_behind { known } else { 0.0 },
            smooth,
        }
    }
}

for_each_level! {
    /// What each lane does next, from the form of g over its slab.
    fn decide_by_value[L](pool: &mut Pool, narrow: f64, g: &RayForms) {
        for i in 0..CELLS {
            let look = Look::new(pool, g, i);
            let (end, step, clear) = (pool.end[i], pool.step[i], pool.clear[i]);
            let empty = look.empty;
            let part = look.b - look.a;
            // Opposite signs at both ends, or away from zero: the slope tells the rest.
            let ready = !empty & (look.front * look.behind != 0.0);
            let contracted = part < CONTRACTED * (pool.b[i] - pool.a[i]);
            let short = !empty & !contracted & (0.5 * part < narrow);
            let halved = !empty & !contracted & !ready;
            let next_step = if empty { 2.0 * step } else if halved { 0.5 * part } else { step };
            let next_a = if empty { clear } else { look.a };
            let reach = (next_a + next_step).min(end);
            let next_b = if empty | halved { reach } else { look.b };
            let through = empty & (clear >= end);
            pool.slabs[i] += 1;
            pool.a[i] = next_a;
            pool.b[i] = next_b;
            pool.clear[i] = if empty | halved | !look.smooth { next_b } else { clear };
            pool.step[i] = next_step;
            pool.sign[i] = if empty { look.beyond } else { look.front };
            let other = ready | short | (pool.slabs[i] >= MOST_SLABS);
            let verdict = if other { Verdict::Other } else { Verdict::Open };
            let verdict = if through { Verdict::Empty } else { verdict };
            pool.verdict[i] = if pool.verdict[i] == Verdict::Idle { Verdict::Idle } else { verdict };
        }
    }
}

for_each_level! {
    /// What each lane does next, from the forms of g and g' over its slab.
    fn decide_by_slope[L](pool: &mut Pool, long: f64, g: &RayForms, slope: &RayForms) {
        for i in 0..CELLS {
            let look = Look::new(pool, g, i);
            let (end, step, clear) = (pool.end[i], pool.step[i], pool.clear[i]);
            let (low, high) = slope.bounds(i);
            let monotone = look.smooth & (slope.flags[i] & PARTIAL == 0) & ((low > 0.0) | (high < 0.0));
            let way = if low > 0.0 { 1.0 } else { -1.0 };
            let leaves = monotone & (look.front == way);
            let empty = look.empty | leaves;
            let crossed = monotone & !empty;
            let part = look.b - look.a;
            let contracted = part < CONTRACTED * (pool.b[i] - pool.a[i]);
            let halved = !empty & !crossed & !contracted;
            let next_step = if empty { 2.0 * step } else if halved { 0.5 * part } else { step };
            let next_a = if empty { clear } else { look.a };
            let reach = (next_a + next_step).min(end);
            let next_b = if empty | halved { reach } else { look.b };
            let through = empty & (clear >= end);
            let hard = halved & (next_step < pool.shortest[i]) | (pool.slabs[i] >= MOST_SLABS);
            let front = if leaves { way } else { look.front };
            pool.slabs[i] += 1;
            pool.a[i] = next_a;
            pool.b[i] = next_b;
            pool.clear[i] = if empty | halved | !look.smooth { next_b } else { clear };
            pool.step[i] = next_step;
            pool.sign[i] = if empty { if leaves { way } else { look.beyond } } else { front };
            pool.front[i] = if look.front * look.behind < 0.0 { look.front } else { 0.0 };
            pool.steepness[i] = if low > 0.0 { low } else { -high };
            let other = empty & (next_step > long);
            let verdict = if other { Verdict::Other } else { Verdict::Open };
            let verdict = if hard { Verdict::Hard } else { verdict };
            let verdict = if crossed { Verdict::Monotone } else { verdict };
            let verdict = if through { Verdict::Empty } else { verdict };
            pool.verdict[i] = if pool.verdict[i] == Verdict::Idle { Verdict::Idle } else { verdict };
        }
    }
}
