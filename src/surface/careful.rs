//! One hard piece of a ray at a time: roots without change of sign, poles, jumps, edges of the domain.
//!
//! In: a short stretch of a ray that batches of intervals could not settle. Out: that it is empty, or its
//! first root, or that no double can tell. Slow and thorough: everything is decided on enclosures.
//!
//! A slab is settled by the first of these that applies:
//! 1. 0 is not in g, or g has no value, or the slab is outside the clip: nothing.
//! 2. The same for each piece when jumps and poles are taken apart ([`Pieces`]): nothing.
//! 3. 0 is not in g': the signs at the ends decide, and bisection narrows the root.
//! 4. g changes sign over at most 1e-9: a root.
//! 5. 0 is not in g'': the extremum is narrowed; g there decides, or no double can: a touch.
//! 6. It is as short as slabs get: undecided.
//!
//! Otherwise it is split.

use super::hit::Ray;
use super::refine::WIDTH;
use super::sheet::{Kind, Sheet};
use crate::closure::pieces::Scratch;
use crate::num::interval::{Defined, Enclosure, Interval};

/// Slabs shorter than this part of the scale are asked for their second derivative and taken to pieces.
const SHORT: f64 = 1e-5;

/// The shortest slab, as a part of the scale: rounding of the points themselves is a hundred times smaller.
const SHORTEST: f64 = 1e-11;

/// The widest bracket whose change of sign is a root, as a part of the scale.
const BRACKET: f64 = 1e-9;

/// The most slabs one call examines.
const MOST_SLABS: u32 = 3000;

/// How a stretch of a ray ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum End {
    /// No root; `proven` unless a place without proven change of sign was passed by.
    Empty { proven: bool },
    /// g changes sign within `width` of t.
    Root { t: f64, width: f64 },
    /// An extremum that cannot be told from zero.
    Touch { t: f64, width: f64 },
    /// Nothing more can be said.
    Undecided { t: f64, width: f64 },
}

/// What one slab says.
enum Slab {
    Nothing,
    Passed,
    Split(f64),
    Found(End),
}

/// What the conditions of a sheet say about a bracket.
enum Conditions {
    Hold,
    Fail,
    Unknown,
}

/// One ray and one sheet under the magnifying glass.
pub(crate) struct Careful<'a> {
    pub(crate) sheet: &'a Sheet,
    pub(crate) kind: Kind,
    pub(crate) ray: &'a Ray,
    pub(crate) size: f64,
    /// Registers of the sheet's scalar outputs.
    pub(crate) scratch: &'a mut Scratch,
    /// Registers of g alone, side by side of its jumps.
    pub(crate) sides: &'a mut Scratch,
    /// Enclosures taken so far.
    pub(crate) cells: u64,
}

impl Careful<'_> {
    /// The first root in [a, b]; the sign of g at `a` is expected to be provable.
    pub(crate) fn trace(&mut self, a: f64, b: f64) -> End {
        let mut slabs = vec![(a, b)];
        let mut proven = true;
        let before = self.cells;
        while let Some((a, b)) = slabs.pop() {
            if self.cells - before > u64::from(MOST_SLABS) {
                return End::Undecided { t: a, width: b - a };
            }
            match self.examine(a, b) {
                Slab::Nothing => {}
                Slab::Passed => proven = false,
                Slab::Split(m) => slabs.extend([(m, b), (a, m)]),
                Slab::Found(end) => return end,
            }
        }
        End::Empty { proven }
    }

    fn scale(&self, t: f64) -> f64 {
        self.size.max(t)
    }

    fn examine(&mut self, a: f64, b: f64) -> Slab {
        let [g, slope, curvature] = self.enclose(a, b);
        if is_out(self.kind, &g) || self.fails_everywhere() {
            return Slab::Nothing;
        }
        let (length, scale) = (b - a, self.scale(a));
        let smooth = is_smooth(&g);
        if !smooth && length <= SHORT * scale && self.pieces_are_out(a, b) {
            return Slab::Nothing;
        }
        if smooth && is_nonzero(&slope) {
            return self.monotone(a, b);
        }
        if smooth && length <= BRACKET * scale && self.sign(a) * self.sign(b) == -1 {
            return self.root(a, b, false);
        }
        if smooth
            && length <= SHORT * scale
            && is_nonzero(&curvature)
            && let Some(slab) = self.extremum(a, b, curvature.range)
        {
            return slab;
        }
        if length <= SHORTEST * scale {
            return self.limit(a, b);
        }
        // Off the middle: symmetric scenes have their roots at round places.
        Slab::Split(a + 0.4921875 * length)
    }

    /// g, g', g'' over [a, b]; the conditions are left in the scratch.
    fn enclose(&mut self, a: f64, b: f64) -> [Enclosure; 3] {
        self.cells += 1;
        self.sheet.scalar.enclose(&slab_of(self.ray, a, b), self.scratch);
        [0, 1, 2].map(|k| self.sheet.scalar.output(self.scratch, k))
    }

    /// The proven sign of g at t: −1, 1, or 0.
    fn sign(&mut self, t: f64) -> i32 {
        let [g, ..] = self.enclose(t, t);
        if g.defined != Defined::Everywhere { 0 } else { sign_of(g.range) }
    }

    /// Whether a condition, as left by the last [`Self::enclose`], fails on all of the slab.
    fn fails_everywhere(&self) -> bool {
        let (guards, nonzero) = (self.sheet.guards, self.sheet.nonzero);
        (0..guards).any(|k| self.condition(k).defined == Defined::Nowhere)
            || (0..self.sheet.fields).any(|k| self.condition(guards + nonzero + k).range.lo > 0.0)
    }

    /// Whether nothing is there on any side of the jumps and poles in the slab.
    fn pieces_are_out(&mut self, a: f64, b: f64) -> bool {
        let kind = self.kind;
        let slab = slab_of(self.ray, a, b);
        let count = self.sheet.sides.all_pieces(&slab, self.sides, |g| is_out(kind, g));
        self.cells += count.unsigned_abs();
        count > 0
    }

    /// The conditions over the bracket [a, b], on which g has one root if it is monotone.
    fn conditions(&mut self, a: f64, b: f64, monotone: bool) -> Conditions {
        if self.sheet.is_free() {
            return Conditions::Hold;
        }
        self.enclose(a, b);
        if self.fails_everywhere() {
            return Conditions::Fail;
        }
        let (first, last) = (self.sheet.guards, self.sheet.guards + self.sheet.nonzero);
        // A bracket that straddles the clip's edge may count either way; it counts.
        let defined = (0..first).all(|k| self.condition(k).defined == Defined::Everywhere);
        let doubtful: Vec<usize> = (first..last).filter(|&k| !is_nonzero(&self.condition(k))).collect();
        if defined && doubtful.is_empty() {
            return Conditions::Hold;
        }
        let is_shared = |k: &usize| self.sheet.shared_roots[k - first];
        if monotone && doubtful.iter().any(|k| is_shared(k) && self.crosses_zero(*k, a, b)) {
            // The one root of g is that of a denominator.
            return Conditions::Fail;
        }
        Conditions::Unknown
    }

    /// The k-th condition, as left by the last [`Self::enclose`].
    fn condition(&self, k: usize) -> Enclosure {
        self.sheet.scalar.output(self.scratch, 3 + k)
    }

    /// Whether the k-th condition is continuous on [a, b] and of opposite signs at its ends.
    fn crosses_zero(&mut self, k: usize, a: f64, b: f64) -> bool {
        let [whole, front, behind] = [(a, b), (a, a), (b, b)].map(|(a, b)| {
            self.enclose(a, b);
            self.condition(k)
        });
        is_smooth(&whole) && sign_of(front.range) * sign_of(behind.range) == -1
    }

    /// A bracket with a change of sign, at most [`BRACKET`] wide.
    fn root(&mut self, a: f64, b: f64, monotone: bool) -> Slab {
        let (t, width) = (0.5 * (a + b), 0.5 * (b - a));
        match self.conditions(a, b, monotone) {
            Conditions::Hold => Slab::Found(End::Root { t, width }),
            Conditions::Fail => Slab::Nothing,
            Conditions::Unknown => Slab::Found(End::Undecided { t, width }),
        }
    }

    /// A slab on which g is continuous and strictly monotone.
    fn monotone(&mut self, a: f64, b: f64) -> Slab {
        let (mut a, mut b) = (a, b);
        let (mut in_front, mut behind) = (self.sign(a), self.sign(b));
        // A root too close to an end for its sign: look a little past the end, where g is monotone still.
        for nudge in [1e-13, 1e-12, 1e-11, 1e-10] {
            let nudge = nudge * self.scale(a);
            if in_front == 0 && a - nudge > 0.0 && self.is_monotone(a - nudge, b) {
                a -= nudge;
                in_front = self.sign(a);
            }
            if behind == 0 && self.is_monotone(a, b + nudge) {
                b += nudge;
                behind = self.sign(b);
            }
        }
        match in_front * behind {
            1 => Slab::Nothing,
            -1 => self.solve(a, b, in_front),
            _ if b - a <= SHORTEST * self.scale(a) => self.limit(a, b),
            _ => Slab::Split(a + 0.4921875 * (b - a)),
        }
    }

    fn is_monotone(&mut self, a: f64, b: f64) -> bool {
        let [g, slope, _] = self.enclose(a, b);
        is_smooth(&g) && is_nonzero(&slope)
    }

    /// Narrows the one root in [a, b], where g has the sign `in_front` at a and the other at b.
    fn solve(&mut self, a: f64, b: f64, in_front: i32) -> Slab {
        let (mut lo, mut hi) = (a, b);
        let target = 2.0 * WIDTH * self.scale(a);
        while hi - lo > target {
            let width = hi - lo;
            let middle = self.newton(lo, hi);
            let near = 0.25 * target;
            let candidates = [middle - near, middle + near, lo + 0.5 * width, lo + 0.25 * width, lo + 0.75 * width];
            for t in candidates {
                if t > lo && t < hi {
                    match self.sign(t) * in_front {
                        1 => lo = t,
                        -1 => hi = t,
                        _ => {}
                    }
                }
            }
            if hi - lo > 0.9 * width {
                break;
            }
        }
        if hi - lo <= BRACKET * self.scale(a) {
            self.root(lo, hi, true)
        } else {
            Slab::Found(End::Undecided { t: 0.5 * (lo + hi), width: 0.5 * (hi - lo) })
        }
    }

    /// Newton's guess of the root from the middle of a slab.
    fn newton(&mut self, a: f64, b: f64) -> f64 {
        let t = 0.5 * (a + b);
        let [g, slope, _] = self.enclose(t, t);
        t - middle_of(g.range) / middle_of(slope.range)
    }

    /// A slab on which g'' has one sign: at most one extremum, at most two roots. `None`: no conclusion.
    fn extremum(&mut self, a: f64, b: f64, curvature: Interval) -> Option<Slab> {
        let bend = sign_of(curvature);
        let [at_a, at_b] = [a, b].map(|t| self.slope_sign(t));
        if at_a * bend > 0 || at_b * bend < 0 {
            // g' is monotone and does not reach zero inside.
            return Some(self.monotone(a, b));
        }
        if at_a * at_b != -1 {
            return None;
        }
        let (lo, hi) = self.narrow_extremum(a, b, at_a);
        let [g, ..] = self.enclose(lo, hi);
        match sign_of(g.range) {
            0 => Some(self.touch(a, b, lo, hi, &g, curvature)),
            // Bent away from zero: nowhere in the slab is g nearer to it than at the extremum.
            s if s == bend => Some(Slab::Nothing),
            _ => Some(match self.monotone(a, lo) {
                Slab::Nothing => self.monotone(hi, b),
                other => other,
            }),
        }
    }

    fn slope_sign(&mut self, t: f64) -> i32 {
        let [_, slope, _] = self.enclose(t, t);
        if slope.defined != Defined::Everywhere { 0 } else { sign_of(slope.range) }
    }

    /// The shortest [lo, hi] over which the slope's sign provably changes.
    fn narrow_extremum(&mut self, a: f64, b: f64, at_a: i32) -> (f64, f64) {
        let (mut lo, mut hi) = (a, b);
        loop {
            let width = hi - lo;
            for t in [0.5, 0.375, 0.625].map(|part| lo + part * width) {
                if t > lo && t < hi {
                    match self.slope_sign(t) * at_a {
                        1 => lo = t,
                        -1 => hi = t,
                        _ => {}
                    }
                }
            }
            if hi - lo > 0.9 * width || hi - lo <= 8.0 * f64::EPSILON * hi {
                return (lo, hi);
            }
        }
    }

    /// The extremum in [lo, hi] cannot be told from zero.
    fn touch(&mut self, a: f64, b: f64, lo: f64, hi: f64, g: &Enclosure, curvature: Interval) -> Slab {
        if self.kind == Kind::Solid && self.sign(a) * self.sign(b) == 1 {
            return Slab::Passed;
        }
        let depth = g.range.lo.abs().max(g.range.hi.abs());
        let bend = curvature.lo.abs().min(curvature.hi.abs());
        let (t, width) = (0.5 * (lo + hi), hi - lo + (2.0 * depth / bend).sqrt());
        match self.conditions(lo, hi, false) {
            Conditions::Fail => Slab::Nothing,
            _ => Slab::Found(End::Touch { t, width: width.min(b - a) }),
        }
    }

    /// A slab as short as they get.
    fn limit(&mut self, a: f64, b: f64) -> Slab {
        let [g, ..] = self.enclose(a, b);
        let signs = self.sign(a) * self.sign(b);
        if is_smooth(&g) && signs == -1 {
            return self.root(a, b, false);
        }
        if self.pieces_are_out(a, b) {
            return Slab::Nothing;
        }
        if self.kind == Kind::Solid && signs == 1 {
            return Slab::Passed;
        }
        Slab::Found(End::Undecided { t: 0.5 * (a + b), width: 0.5 * (b - a) })
    }
}

/// The box around a slab of a ray and its direction, with the error of the points' own rounding: the same as
/// in [`super::isolate::place`].
fn slab_of(ray: &Ray, a: f64, b: f64) -> [Interval; 6] {
    const UNIT: f64 = f64::EPSILON;
    std::array::from_fn(|k| {
        let (o, d) = (ray.origin[k % 3], ray.direction[k % 3]);
        if k < 3 {
            let (p, q) = (o + a * d, o + b * d);
            let error = 6.0 * UNIT * b + 2.0 * UNIT * o.abs();
            Interval { lo: p.min(q) - error, hi: p.max(q) + error }
        } else {
            Interval { lo: d - 4.0 * UNIT, hi: d + 4.0 * UNIT }
        }
    })
}

/// Whether nothing is drawn in a slab with this enclosure.
fn is_out(kind: Kind, g: &Enclosure) -> bool {
    match kind {
        Kind::Equation => g.defined == Defined::Nowhere || sign_of(g.range) != 0,
        // Without a change of sign there is no boundary: touching zero is not crossing it.
        Kind::Solid => g.defined == Defined::Nowhere || g.range.lo >= 0.0 || g.range.hi <= 0.0,
    }
}

fn sign_of(range: Interval) -> i32 {
    i32::from(range.lo > 0.0) - i32::from(range.hi < 0.0)
}

fn middle_of(range: Interval) -> f64 {
    0.5 * (range.lo + range.hi)
}

fn is_smooth(e: &Enclosure) -> bool {
    e.defined == Defined::Everywhere && e.continuous
}

fn is_nonzero(e: &Enclosure) -> bool {
    e.defined == Defined::Everywhere && sign_of(e.range) != 0
}
