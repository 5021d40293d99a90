//! Arithmetic, whole powers, and the operations that pick among numbers.
//!
//! In: boxes. Out: the enclosure of the operation on the box. Separate because these are exact but for one
//! rounding, unlike the elementary functions.

use super::round::{above, above_vanishing, below, product_down, product_up, quotient_down, quotient_up};
use super::round::{root_down, root_up, sum_down, sum_up};
use super::{Enclosure, Interval};
use crate::num::func::{self, bound, native};
use crate::num::level::Portable;

/// Whole powers up to this size have the stated error bound; larger ones lose 2^-104 of relative precision a
/// squaring, which the bound then grows by.
const CERTAIN_POWER: f64 = 1099511627776.0;

impl Interval {
    /// −a
    pub fn negated(self) -> Enclosure {
        Enclosure::total(Interval { lo: -self.hi, hi: -self.lo })
    }

    /// a + b
    pub fn plus(self, other: Self) -> Enclosure {
        Enclosure::total(Interval { lo: sum_down(self.lo, other.lo), hi: sum_up(self.hi, other.hi) })
    }

    /// a − b
    pub fn minus(self, other: Self) -> Enclosure {
        Enclosure::total(Interval { lo: sum_down(self.lo, -other.hi), hi: sum_up(self.hi, -other.lo) })
    }

    /// a · b
    pub fn times(self, other: Self) -> Enclosure {
        let (a, b) = (self, other);
        let pairs = [(a.lo, b.lo), (a.lo, b.hi), (a.hi, b.lo), (a.hi, b.hi)];
        Enclosure::total(Interval {
            lo: pairs.iter().fold(f64::INFINITY, |least, &(a, b)| least.min(product_down(a, b))),
            hi: pairs.iter().fold(f64::NEG_INFINITY, |most, &(a, b)| most.max(product_up(a, b))),
        })
    }

    /// a / b for b without 0.
    pub(super) fn over_nonzero(self, other: Self) -> Interval {
        let (a, b) = (self, other);
        let pairs = [(a.lo, b.lo), (a.lo, b.hi), (a.hi, b.lo), (a.hi, b.hi)];
        Interval {
            lo: pairs.iter().fold(f64::INFINITY, |least, &(a, b)| least.min(quotient_down(a, b))),
            hi: pairs.iter().fold(f64::NEG_INFINITY, |most, &(a, b)| most.max(quotient_up(a, b))),
        }
    }

    /// a / b
    pub fn over(self, other: Self) -> Enclosure {
        if other.lo > 0.0 || other.hi < 0.0 {
            return Enclosure::total(self.over_nonzero(other));
        }
        Enclosure::partial(self.over_pieces(other).hull())
    }

    /// |a|
    pub fn abs(self) -> Enclosure {
        let (least, most) = (self.lo.abs().min(self.hi.abs()), self.lo.abs().max(self.hi.abs()));
        Enclosure::total(Interval { lo: if self.contains(0.0) { 0.0 } else { least }, hi: most })
    }

    /// −1, 0, 1
    pub fn sign(self) -> Enclosure {
        let range = Interval { lo: func::sign(self.lo), hi: func::sign(self.hi) };
        if range.lo == range.hi { Enclosure::total(range) } else { Enclosure::jumping(range) }
    }

    /// largest whole number ≤ a
    pub fn floor(self) -> Enclosure {
        let range = Interval { lo: self.lo.floor(), hi: self.hi.floor() };
        if range.lo == range.hi { Enclosure::total(range) } else { Enclosure::jumping(range) }
    }

    /// largest whole number ≤ n·a / b, n in 1…2^53
    pub fn floor_over(self, n: i64, other: Self) -> Enclosure {
        if other.hi < 0.0 {
            return self.negated().range.floor_over(n, other.negated().range);
        }
        let factor = n as f64;
        if other.lo > 0.0 {
            let end = |a: f64, b: f64| func::floor_div::<Portable>(factor, a, b);
            let lo = end(self.lo, if self.lo < 0.0 { other.lo } else { other.hi });
            let hi = end(self.hi, if self.hi < 0.0 { other.hi } else { other.lo });
            if lo.abs() < func::EXACT_WHOLE && hi.abs() < func::EXACT_WHOLE {
                return Interval { lo, hi }.floor();
            }
        }
        Interval::point(factor).times(self).over(Enclosure::total(other)).floor()
    }

    /// the smaller
    pub fn min(self, other: Self) -> Enclosure {
        Enclosure::total(Interval { lo: self.lo.min(other.lo), hi: self.hi.min(other.hi) })
    }

    /// the larger
    pub fn max(self, other: Self) -> Enclosure {
        Enclosure::total(Interval { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi) })
    }

    /// √a
    pub fn sqrt(self) -> Enclosure {
        if self.hi < 0.0 {
            return Enclosure::NOWHERE;
        }
        let range = Interval { lo: root_down(self.lo.max(0.0)), hi: root_up(self.hi) };
        if self.lo >= 0.0 { Enclosure::total(range) } else { Enclosure::partial(range) }
    }

    /// a²
    pub fn square(self) -> Enclosure {
        let size = self.abs().range;
        Enclosure::total(Interval { lo: product_down(size.lo, size.lo), hi: product_up(size.hi, size.hi) })
    }

    /// a^n, n ≠ 0
    pub fn power(self, n: i64) -> Enclosure {
        if n > 0 || self.lo > 0.0 || self.hi < 0.0 {
            return Enclosure::total(self.power_beside_zero(n));
        }
        Enclosure::partial(self.power_pieces(n).hull())
    }

    /// a^n where n > 0 or 0 is not in the box.
    pub(super) fn power_beside_zero(self, n: i64) -> Interval {
        let size = self.abs().range;
        let even = n % 2 == 0;
        if even && n < 0 {
            return Interval { lo: power_down(size.hi, n), hi: power_up(size.lo, n) };
        }
        if even {
            return Interval { lo: power_down(size.lo, n), hi: power_up(size.hi, n) };
        }
        let (least, most) = if n < 0 { (self.hi, self.lo) } else { (self.lo, self.hi) };
        Interval { lo: power_down(least, n), hi: power_up(most, n) }
    }
}

/// The error bound of a^n in ulp.
fn power_bound(n: i64) -> f64 {
    let n = n.unsigned_abs() as f64;
    if n <= CERTAIN_POWER { bound::POWER } else { bound::POWER + n / CERTAIN_POWER }
}

/// a^n, rounded down; a may be infinite.
pub(super) fn power_down(a: f64, n: i64) -> f64 {
    if a == 0.0 || a.is_infinite() || n == 1 {
        return infinite_power(a, n);
    }
    let p = native::power(a, n);
    let positive = a > 0.0 || n % 2 == 0;
    let bound = if positive { below(p, power_bound(n)).max(0.0) } else { -above_vanishing(-p, power_bound(n)) };
    bound.min(point_power(a, n, p))
}

/// a^n, rounded up; a may be infinite.
pub(super) fn power_up(a: f64, n: i64) -> f64 {
    if a == 0.0 || a.is_infinite() || n == 1 {
        return infinite_power(a, n);
    }
    let p = native::power(a, n);
    let positive = a > 0.0 || n % 2 == 0;
    let bound = if positive { above_vanishing(p, power_bound(n)) } else { above(p, power_bound(n)).min(0.0) };
    bound.max(point_power(a, n, p))
}

/// a^n as points compute it, `value` being the nearest: their third and fourth powers are plain products, which rise
/// with a, so that the ends of a box bound what is computed inside.
fn point_power(a: f64, n: i64, value: f64) -> f64 {
    match n {
        3 => a * a * a,
        4 => (a * a) * (a * a),
        _ => value,
    }
}

/// a^n for a = 0 (n > 0), a = ±∞, or n = 1.
fn infinite_power(a: f64, n: i64) -> f64 {
    match (n, n % 2 == 0) {
        (1, _) => a,
        (i64::MIN..=-1, _) => 0.0,
        (_, true) => a.abs(),
        _ => a,
    }
}
