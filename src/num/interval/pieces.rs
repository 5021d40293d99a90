//! One interval on each side of a jump or a pole.
//!
//! In: a box that an operation jumps in. Out: up to four intervals that together contain every value the
//! operation takes on the box, each on one side of the jump. Separate because only the last step of a proof pays
//! for it: when the hull contains 0 but no piece does, there is no root.

use super::{Enclosure, Interval};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// Up to four intervals.
#[derive(Clone, Copy, Debug)]
pub struct Pieces {
    list: [Interval; Pieces::MOST],
    count: usize,
}

impl Pieces {
    /// The most pieces of one operation; what has more sides becomes one hull.
    pub const MOST: usize = 4;

    /// The pieces that are not empty.
    fn of(all: &[Interval]) -> Self {
        let mut pieces = Pieces { list: [Interval::EMPTY; Self::MOST], count: 0 };
        for &piece in all.iter().filter(|piece| !piece.is_empty()).take(Self::MOST) {
            pieces.list[pieces.count] = piece;
            pieces.count += 1;
        }
        pieces
    }

    /// The pieces, in no promised order; none when the operation has no value on the box.
    pub fn as_slice(&self) -> &[Interval] {
        &self.list[..self.count]
    }

    /// The narrowest interval that contains all.
    pub fn hull(&self) -> Interval {
        self.as_slice().iter().fold(Interval::EMPTY, |hull, &piece| hull.hull(piece))
    }
}

impl Interval {
    /// What is below 0 and what is above, each with 0 where it is in the box.
    fn sides(self) -> [Interval; 2] {
        [self.intersection(Interval::new(f64::NEG_INFINITY, 0.0)), self.intersection(Interval::new(0.0, f64::INFINITY))]
    }

    /// a / b on each side of b = 0.
    pub fn over_pieces(self, other: Self) -> Pieces {
        if other.lo > 0.0 || other.hi < 0.0 {
            return Pieces::of(&[self.over_nonzero(other)]);
        }
        let [negative, positive] = other.sides().map(|side| self.over_side(side));
        Pieces::of(&[negative, positive])
    }

    /// a / b for b on one side of 0 that 0 itself borders; the exclusion of b = 0 is by limits.
    fn over_side(self, side: Self) -> Interval {
        if side.is_empty() || side.is_point(0.0) {
            return Interval::EMPTY;
        }
        if self.is_point(0.0) {
            return Interval::point(0.0);
        }
        if side.hi <= 0.0 {
            let mirrored = Interval { lo: -self.hi, hi: -self.lo };
            return mirrored.over_side(Interval { lo: -side.hi, hi: -side.lo });
        }
        if side.lo > 0.0 {
            return self.over_nonzero(side);
        }
        let far = self.over_nonzero(Interval::point(side.hi));
        Interval {
            lo: if self.lo < 0.0 { f64::NEG_INFINITY } else { far.lo },
            hi: if self.hi > 0.0 { f64::INFINITY } else { far.hi },
        }
    }

    /// a^n, n < 0, on each side of a = 0.
    pub fn power_pieces(self, n: i64) -> Pieces {
        if n > 0 || self.lo > 0.0 || self.hi < 0.0 {
            return Pieces::of(&[self.power_beside_zero(n)]);
        }
        let [negative, positive] = self.sides().map(|side| side.power_side(n));
        Pieces::of(&[negative, positive])
    }

    /// a^n, n < 0, for a on one side of 0 that 0 itself borders.
    fn power_side(self, n: i64) -> Interval {
        if self.is_empty() || self.is_point(0.0) {
            return Interval::EMPTY;
        }
        if self.hi > 0.0 {
            let far = Interval::point(self.hi).power_beside_zero(n);
            return Interval { lo: far.lo, hi: f64::INFINITY };
        }
        let far = Interval::point(self.lo).power_beside_zero(n);
        if n % 2 == 0 {
            Interval { lo: far.lo, hi: f64::INFINITY }
        } else {
            Interval { lo: f64::NEG_INFINITY, hi: far.hi }
        }
    }

    /// Whole numbers that floor takes, one piece each when they are few.
    pub fn floor_pieces(self) -> Pieces {
        let range = self.floor().range;
        let count = range.width();
        if !(count < Pieces::MOST as f64) {
            return Pieces::of(&[range]);
        }
        let each: [Interval; Pieces::MOST] = std::array::from_fn(|i| {
            let value = range.lo + i as f64;
            if value <= range.hi { Interval::point(value) } else { Interval::EMPTY }
        });
        Pieces::of(&each)
    }

    /// Whole numbers that ⌊n·a/b⌋ takes, on each side of b = 0.
    pub fn floor_over_pieces(self, n: i64, other: Self) -> Pieces {
        if other.lo > 0.0 || other.hi < 0.0 {
            return self.floor_over(n, other).range.floor_pieces();
        }
        let mut sides = Interval::point(n as f64).times(self).range.over_pieces(other);
        for side in &mut sides.list[..sides.count] {
            *side = side.floor().range;
        }
        sides
    }

    /// The signs that occur.
    pub fn sign_pieces(self) -> Pieces {
        let each = [-1.0, 0.0, 1.0].map(|s: f64| {
            let occurs = (s < 0.0 && self.lo < 0.0) || (s > 0.0 && self.hi > 0.0) || (s == 0.0 && self.contains(0.0));
            if occurs { Interval::point(s) } else { Interval::EMPTY }
        });
        Pieces::of(&each)
    }

    /// The tangent on each side of a pole; one piece when there may be several.
    pub fn tan_pieces(self) -> Pieces {
        let one = self.tan().range;
        if one != Interval::WHOLE || !(self.width() < 3.0) {
            return Pieces::of(&[one]);
        }
        // The nearest odd multiple of π/2. The tangent rises on both sides of it, from the lower end to ∞ and from −∞
        // to the upper end; an end nearer to the pole than its rounding is moved away, which only widens.
        let turns = 0.5 * (self.lo + self.hi) * FRAC_2_PI;
        let pole = (2.0 * (turns * 0.5).floor() + 1.0) * FRAC_PI_2;
        let margin = pole.abs() * 16.0 * f64::EPSILON;
        let before = Interval::new(self.lo.min(pole - margin), pole - margin).tan();
        let after = Interval::new(pole + margin, self.hi.max(pole + margin)).tan();
        if !(before.continuous && after.continuous) {
            return Pieces::of(&[one]);
        }
        Pieces::of(&[Interval::new(before.range.lo, f64::INFINITY), Interval::new(f64::NEG_INFINITY, after.range.hi)])
    }

    /// The angle of (x = b, y = a) on each side of its cut y = 0, x < 0.
    pub fn atan2_pieces(self, x: Self) -> Pieces {
        let [below, above] = self.angle_halves(x);
        if x.lo >= 0.0 {
            return Pieces::of(&[below.hull(above)]);
        }
        Pieces::of(&[below, above])
    }
}

impl Enclosure {
    /// a and b where the sign of c is open, else the one that it takes.
    pub fn choose_pieces(c: Self, a: Self, b: Self) -> Pieces {
        if c.range.is_empty() {
            Pieces::of(&[])
        } else if c.range.hi <= 0.0 {
            Pieces::of(&[a.range])
        } else if c.range.lo > 0.0 {
            Pieces::of(&[b.range])
        } else {
            Pieces::of(&[a.range, b.range])
        }
    }
}
