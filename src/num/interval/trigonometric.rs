//! Sine, cosine and tangent of an interval.
//!
//! In: boxes. Out: the enclosure of the function on the box. Separate because an extremum or a pole between the
//! ends decides more than the ends.

use super::round::{above, below};
use super::{Enclosure, Interval};
use crate::num::func::trigonometric::REDUCIBLE;
use crate::num::func::{bound, native};
use std::f64::consts::FRAC_2_PI;

/// A quarter turn count a·2/π is wrong by less than this part of itself (two roundings).
pub(in crate::num) const TURN_ERROR: f64 = 4.0 * f64::EPSILON;

impl Interval {
    /// The box in quarter turns, rounded outward by more than the error; `None` for large angles.
    fn quarter_turns(self) -> Option<Interval> {
        if !(self.lo >= -REDUCIBLE && self.hi <= REDUCIBLE) {
            return None;
        }
        let (lo, hi) = (self.lo * FRAC_2_PI, self.hi * FRAC_2_PI);
        Some(Interval { lo: lo - lo.abs() * TURN_ERROR, hi: hi + hi.abs() * TURN_ERROR })
    }

    /// Whether a whole number that is `rest` modulo `period` is in it.
    fn meets(self, rest: f64, period: f64) -> bool {
        ((self.hi - rest) / period).floor() * period + rest >= self.lo
    }

    /// The hull of the values at the ends, with the extrema where the box may contain them.
    fn wave(self, f: fn(f64) -> f64, crest: f64) -> Enclosure {
        let Some(turns) = self.quarter_turns() else {
            return Enclosure::total(Interval::new(-1.0, 1.0));
        };
        let (a, b) = (f(self.lo), f(self.hi));
        let least = below(a.min(b), bound::SIN).max(-1.0);
        let most = above(a.max(b), bound::SIN).min(1.0);
        Enclosure::total(Interval {
            lo: if turns.meets(crest + 2.0, 4.0) { -1.0 } else { least },
            hi: if turns.meets(crest, 4.0) { 1.0 } else { most },
        })
    }

    /// sine
    pub fn sin(self) -> Enclosure {
        self.wave(native::sin, 1.0)
    }

    /// cosine
    pub fn cos(self) -> Enclosure {
        self.wave(native::cos, 0.0)
    }

    /// tangent
    pub fn tan(self) -> Enclosure {
        match self.quarter_turns() {
            Some(turns) if !turns.meets(1.0, 2.0) => Enclosure::total(Interval {
                lo: below(native::tan(self.lo), bound::TAN),
                hi: above(native::tan(self.hi), bound::TAN),
            }),
            _ => Enclosure::partial(Interval::WHOLE),
        }
    }
}
