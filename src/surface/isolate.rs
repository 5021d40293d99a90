//! The faithful method by intervals: where no root is, proven for 16 rays at once. For what [`super::contract`] finds hard, and for
//! [`super::tracer::Method::Intervals`].
//!
//! In: rays with the part of each that is still open. Out: brackets on which g is monotone, for
//! [`super::refine`]; rays proven empty; and rays that need [`super::careful`].
//!
//! A lane holds one ray and walks it from the front. Over its current slab [a, b] it encloses g and g', and g at a.
//! - 0 is not in g, or g has no value there: nothing is there. Go on behind it with twice the length.
//! - g at a over the steepest way to zero in g': so far there is no root. Go on from there.
//! - 0 is not in g': at most one root. Hand the slab over.
//! - None of these: try the first half.
//!
//! Where g' is much dearer than g, long slabs are tried with g alone.
//!
//! What a lane decides is computed for all lanes without a branch; only a lane that is finished is looked at
//! by itself.

use super::bundle::Asked;
use super::hit::Ray;
use super::kernels::Formula;
use super::sheet::{CELLS, Cells};
use crate::num::interval_lanes::{JUMP, NOWHERE, PARTIAL};
use crate::num::level::{Level, Simd, for_each_level};

/// A slab shorter than this part of the ray's scale is hard: left to the careful method. At that length
/// a transversal root has long been told apart; what is left has a vanishing slope, or is no root at all.
const SHORTEST: f64 = 1e-5;

/// Where the slope takes more than this many times the steps of g alone, g alone is tried first: it saves up to three
/// quarters there (`superquadric` of `cargo bench --bench primary`), and costs a fifth where the slope is cheap.
const COSTLY: f64 = 2.6;

/// The same for formulas of more than so many steps (`csg27`, `metaballs`).
const LONG: f64 = 100.0;

/// Slabs longer than this part of the scale are tried with g alone. From 0.03 to 0.15 makes little difference.
const NARROW: f64 = 0.1;

/// A factor that outweighs the rounding of one sum.
const ROUNDED_DOWN: f64 = 1.0 - f64::EPSILON;

/// A factor that outweighs the rounding of a quotient.
const SHY: f64 = 1.0 - 4.0 * f64::EPSILON;

/// A ray may take this many slabs before it is handed to the careful method, which counts its own.
pub(super) const MOST_SLABS: u32 = 20_000;

/// The part of a ray that is still open.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Open {
    /// Which ray of the batch.
    pub(crate) ray: u32,
    /// Everything in front of this is settled.
    pub(crate) a: f64,
    /// The end.
    pub(crate) end: f64,
    /// How far to reach first.
    pub(crate) step: f64,
    /// How many slabs it has taken.
    pub(crate) slabs: u32,
}

/// What all rays of a batch share.
pub(crate) struct Rays<'a> {
    /// The rays.
    pub(crate) list: Asked<'a>,
    /// The length that tolerances are measured by.
    pub(crate) size: f64,
    /// The instructions to use.
    pub(crate) simd: Simd,
}

/// The register files of a sheet's enclosures.
pub(crate) struct CellFiles {
    /// Of g.
    pub(crate) value: Vec<Cells>,
    /// Of g and g'.
    pub(crate) slope: Vec<Cells>,
}

/// A slab on which g is defined, continuous and strictly monotone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bracket {
    /// The ray it is on, open from the slab's start.
    pub(crate) open: Open,
    /// The slab's end.
    pub(crate) b: f64,
    /// The proven sign of g at the slab's start, with the other one proven at its end; 0 if they are not both known.
    pub(crate) front: f64,
    /// The least |g'| on it, or less.
    pub(crate) steepness: f64,
}

impl Bracket {
    /// Whether a root is in it for certain.
    pub(crate) fn has_root(&self) -> bool {
        self.front != 0.0
    }
}

/// A ray between two passes, with what is known around its slab.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Walker {
    pub(crate) open: Open,
    /// The slab's end.
    pub(crate) b: f64,
    /// No root is between that and this, and g is continuous there.
    pub(crate) clear: f64,
    /// The proven sign of g at the slab's start, or 0.
    pub(crate) sign: f64,
}

impl From<Open> for Walker {
    fn from(open: Open) -> Self {
        let b = (open.a + open.step).min(open.end);
        Walker { open: Open { step: b - open.a, ..open }, b, clear: b, sign: 0.0 }
    }
}

/// What became of the rays.
#[derive(Debug, Default)]
pub(crate) struct Found {
    /// To be refined.
    pub(crate) brackets: Vec<Bracket>,
    /// To be looked at one by one.
    pub(crate) hard: Vec<Open>,
    /// Between the two passes: slabs that are short enough for the slope, or long enough to do without.
    pub(super) other: Vec<Walker>,
    /// Proven empty to their ends: ray and slabs taken.
    pub(crate) empty: Vec<(u32, u32)>,
    /// Slabs enclosed.
    pub(crate) cells: u64,
}

/// The rays of 16 lanes, a number of each in an array.
#[derive(Clone, Debug)]
pub(crate) struct Pool {
    pub(super) origin: [[f64; CELLS]; 3],
    pub(super) direction: [[f64; CELLS]; 3],
    pub(super) a: [f64; CELLS],
    pub(super) b: [f64; CELLS],
    /// See [`Walker`].
    pub(super) clear: [f64; CELLS],
    pub(super) sign: [f64; CELLS],
    pub(super) end: [f64; CELLS],
    pub(super) step: [f64; CELLS],
    pub(super) shortest: [f64; CELLS],
    /// See [`Bracket`].
    pub(super) front: [f64; CELLS],
    pub(super) steepness: [f64; CELLS],
    pub(super) slabs: [u32; CELLS],
    ray: [u32; CELLS],
    pub(super) verdict: [Verdict; CELLS],
    pub(super) walkers: Vec<Walker>,
}

/// What a lane says after a slab.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Verdict {
    Idle,
    Open,
    Empty,
    Monotone,
    Hard,
    /// To the other pass.
    Other,
}

impl Default for Pool {
    fn default() -> Self {
        let zero = [0.0; CELLS];
        Pool {
            origin: [zero; 3],
            direction: [zero; 3],
            a: zero,
            b: zero,
            clear: zero,
            sign: zero,
            end: zero,
            step: zero,
            shortest: zero,
            front: zero,
            steepness: zero,
            slabs: [0; CELLS],
            ray: [0; CELLS],
            verdict: [Verdict::Idle; CELLS],
            walkers: Vec::new(),
        }
    }
}

impl Pool {
    /// Walks all open rays until each is settled, bracketed or found hard.
    pub(crate) fn run(
        &mut self,
        formula: Formula,
        files: &mut CellFiles,
        rays: &Rays,
        open: &mut Vec<Open>,
        found: &mut Found,
    ) {
        let CellFiles { value, slope } = files;
        let narrow = rays.size * narrow(formula);
        (self.front, self.steepness) = ([0.0; CELLS], [0.0; CELLS]);
        let mut walkers = std::mem::take(&mut self.walkers);
        walkers.extend(open.drain(..).map(Walker::from));
        while !walkers.is_empty() {
            if narrow < f64::INFINITY {
                self.pass(rays, &mut walkers, found, |pool| {
                    place(rays.simd, pool.origin.each_ref(), pool.direction.each_ref(), &pool.a, &pool.b, value);
                    formula.value().run(value);
                    decide_by_value(rays.simd, pool, narrow, formula.value().output(value, 0));
                    1
                });
                std::mem::swap(&mut walkers, &mut found.other);
            }
            self.pass(rays, &mut walkers, found, |pool| {
                place(rays.simd, pool.origin.each_ref(), pool.direction.each_ref(), &pool.a, &pool.a, value);
                formula.value().run(value);
                place(rays.simd, pool.origin.each_ref(), pool.direction.each_ref(), &pool.a, &pool.b, slope);
                formula.slope().run(slope);
                let (g, of_slope) = (formula.slope().output(slope, 0), formula.slope().output(slope, 1));
                decide_by_slope(rays.simd, pool, 2.0 * narrow, formula.value().output(value, 0), g, of_slope);
                2
            });
            std::mem::swap(&mut walkers, &mut found.other);
        }
        self.walkers = walkers;
    }

    /// Keeps the lanes full with open rays, and lets `look` examine and move them, until none is left.
    /// `look` says how many enclosures of a lane it took.
    #[inline(always)]
    pub(super) fn pass(
        &mut self,
        rays: &Rays,
        walkers: &mut Vec<Walker>,
        found: &mut Found,
        mut look: impl FnMut(&mut Pool) -> u64,
    ) {
        self.verdict = [Verdict::Idle; CELLS];
        let mut active = 0;
        loop {
            for lane in 0..CELLS {
                if self.verdict[lane] != Verdict::Open {
                    active -= usize::from(self.retire(lane, found));
                    if let Some(next) = walkers.pop() {
                        self.fill(lane, next, &rays.list.ray(next.open.ray), rays.size);
                        active += 1;
                    }
                }
            }
            if active == 0 {
                return;
            }
            found.cells += active as u64 * look(self);
        }
    }

    fn fill(&mut self, lane: usize, Walker { open, b, clear, sign }: Walker, ray: &Ray, size: f64) {
        for axis in 0..3 {
            self.origin[axis][lane] = ray.origin[axis];
            self.direction[axis][lane] = ray.direction[axis];
        }
        self.a[lane] = open.a;
        self.b[lane] = b;
        self.clear[lane] = clear;
        self.sign[lane] = sign;
        self.end[lane] = open.end;
        self.step[lane] = open.step;
        self.shortest[lane] = SHORTEST * size.max(open.a);
        self.slabs[lane] = open.slabs;
        self.ray[lane] = open.ray;
        self.verdict[lane] = Verdict::Open;
    }

    /// Empties a lane that is no longer open and files its ray; false if it held none.
    fn retire(&mut self, lane: usize, found: &mut Found) -> bool {
        let open = Open {
            ray: self.ray[lane],
            a: self.a[lane],
            end: self.end[lane],
            step: self.step[lane],
            slabs: self.slabs[lane],
        };
        match std::mem::replace(&mut self.verdict[lane], Verdict::Idle) {
            Verdict::Idle | Verdict::Open => return false,
            Verdict::Empty => found.empty.push((open.ray, open.slabs)),
            Verdict::Monotone => {
                let (front, steepness) = (self.front[lane], self.steepness[lane]);
                found.brackets.push(Bracket { open, b: self.b[lane], front, steepness });
            }
            Verdict::Hard => found.hard.push(open),
            Verdict::Other => {
                let (b, clear, sign) = (self.b[lane], self.clear[lane], self.sign[lane]);
                found.other.push(Walker { open, b, clear, sign });
            }
        }
        true
    }
}

/// The length of slab, as a part of the scale, below which the slope is enclosed too.
fn narrow(formula: Formula) -> f64 {
    let (value, slope) = (formula.value().len() as f64, formula.slope().len() as f64);
    if value >= LONG || slope >= COSTLY * value { NARROW } else { f64::INFINITY }
}

/// What points of a ray are off by rounding, as parts of the distance and of the origin's coordinates: 2^-50 and 2^-52, see [`place`].
pub(crate) const PER_DISTANCE: f64 = 1.0 / (1u64 << 50) as f64;
pub(crate) const PER_ORIGIN: f64 = 1.0 / (1u64 << 52) as f64;

for_each_level! {
    /// Encloses the points of slab [a, b] of each lane's ray in the registers of the variables.
    ///
    /// The direction's components, as components of a line through the origin, are known to 5 units of
    /// rounding (two fused products, one division), its product with t and the sum to one more each; 2^-50·t +
    /// 2^-52·|origin| covers them all.
    pub(crate) fn place[L](
        origin: [&[f64; CELLS]; 3], direction: [&[f64; CELLS]; 3], a: &[f64; CELLS], b: &[f64; CELLS], cells: &mut [Cells],
    ) {
        for axis in 0..3 {
            let (o, d) = (origin[axis], direction[axis]);
            let cell = &mut cells[axis];
            for i in 0..CELLS {
                // The origin itself is exact.
                let error = if b[i] > 0.0 { L::fma(b[i], PER_DISTANCE, o[i].abs() * PER_ORIGIN) } else { 0.0 };
                let (p, q) = (L::fma(a[i], d[i], o[i]), L::fma(b[i], d[i], o[i]));
                cell.lo[i] = p.min(q) - error;
                cell.hi[i] = p.max(q) + error;
            }
            cell.flags = [0; CELLS];
            let cell = &mut cells[axis + 3];
            for i in 0..CELLS {
                cell.lo[i] = d[i] - PER_DISTANCE;
                cell.hi[i] = d[i] + PER_DISTANCE;
            }
            cell.flags = [0; CELLS];
        }
    }
}

for_each_level! {
    /// What each lane does next, from the enclosure of g over its slab.
    fn decide_by_value[L](pool: &mut Pool, narrow: f64, g: &Cells) {
        for i in 0..CELLS {
            let empty = is_out(g, i);
            let (a, b, end, step) = (pool.a[i], pool.b[i], pool.end[i], pool.step[i]);
            let (next_a, next_step) = if empty { (b, 2.0 * step) } else { (a, 0.5 * step) };
            let through = empty & (b >= end);
            let short = !empty & (next_step < narrow);
            pool.slabs[i] += 1;
            pool.a[i] = next_a;
            pool.step[i] = next_step;
            pool.b[i] = (next_a + next_step).min(end);
            let verdict = if short { Verdict::Other } else { Verdict::Open };
            let verdict = if through { Verdict::Empty } else { verdict };
            pool.verdict[i] = if pool.verdict[i] == Verdict::Idle { Verdict::Idle } else { verdict };
        }
    }
}

for_each_level! {
    /// What each lane does next, from g at the slab's start, and g and g' over the slab.
    fn decide_by_slope[L](pool: &mut Pool, long: f64, front: &Cells, g: &Cells, slope: &Cells) {
        for i in 0..CELLS {
            let known = (g.flags[i] & (PARTIAL | JUMP)) | (slope.flags[i] & PARTIAL) == 0;
            let (a, b, end, step) = (pool.a[i], pool.b[i], pool.end[i], pool.step[i]);
            // The mean value theorem: g cannot reach zero sooner than its value in front over its steepest way there.
            let down = if front.lo[i] > 0.0 { front.lo[i] / (-slope.lo[i]).max(0.0) } else { 0.0 };
            let up = if front.hi[i] < 0.0 { -front.hi[i] / slope.hi[i].max(0.0) } else { 0.0 };
            let reach = if known { (down + up) * SHY } else { 0.0 };
            let empty = is_out(g, i) | (reach >= b - a);
            let monotone = !empty & known & ((slope.lo[i] > 0.0) | (slope.hi[i] < 0.0));
            let ahead = if reach > 0.25 * step { step } else { 0.5 * step };
            let next_step = if empty { 2.0 * step } else { ahead };
            let next_a = if empty { b } else { ((a + reach) * ROUNDED_DOWN).max(a) };
            let through = empty & (b >= end);
            let hard = !empty & (next_step < pool.shortest[i]) | (pool.slabs[i] >= MOST_SLABS);
            pool.slabs[i] += 1;
            pool.a[i] = if monotone { a } else { next_a };
            pool.step[i] = if monotone { step } else { next_step };
            pool.b[i] = if monotone { b } else { (next_a + next_step).min(end) };
            let other = empty & (next_step > long);
            let verdict = if other { Verdict::Other } else { Verdict::Open };
            let verdict = if hard { Verdict::Hard } else { verdict };
            let verdict = if monotone { Verdict::Monotone } else { verdict };
            let verdict = if through { Verdict::Empty } else { verdict };
            pool.verdict[i] = if pool.verdict[i] == Verdict::Idle { Verdict::Idle } else { verdict };
        }
    }
}

/// Whether g has no root in lane i: proven.
#[inline(always)]
fn is_out(g: &Cells, i: usize) -> bool {
    (g.lo[i] > 0.0) | (g.hi[i] < 0.0) | (g.flags[i] & NOWHERE != 0)
}
