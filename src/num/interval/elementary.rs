//! Exponentials, logarithms, inverse and hyperbolic functions, the error function, roots, powers and angles.
//!
//! In: boxes. Out: the enclosure of the function on the box. Each is monotone in each argument on known parts;
//! its f64 value at the ends is pushed outward by its error bound and cut by the function's range. Separate from
//! the arithmetic because of those bounds.

use super::round::{above, above_vanishing, below};
use super::{Enclosure, Interval};
use crate::num::func::{bound, native};
use std::f64::consts::{FRAC_PI_2, PI};

/// The f64 next above π/2 and π, whose nearest f64 lie below them.
const HALF_PI_UP: f64 = FRAC_PI_2.next_up();
const PI_UP: f64 = PI.next_up();

impl Interval {
    /// The hull of a rising function with the given error bound in ulp.
    fn rising(self, f: fn(f64) -> f64, ulps: f64) -> Interval {
        Interval { lo: below(f(self.lo), ulps), hi: above(f(self.hi), ulps) }
    }

    /// What is in [lo, hi] of a range that is not empty and touches it.
    fn within(self, lo: f64, hi: f64) -> Interval {
        Interval { lo: self.lo.clamp(lo, hi), hi: self.hi.clamp(lo, hi) }
    }

    /// e^a
    pub fn exp(self) -> Enclosure {
        let (lo, hi) = (native::exp(self.lo), native::exp(self.hi));
        let hi = if self.hi == f64::INFINITY { hi } else { above_vanishing(hi, bound::EXP) };
        let hi = if self.hi == f64::NEG_INFINITY { 0.0 } else { hi };
        let exact = if self.lo == 0.0 { 1.0 } else { below(lo, bound::EXP).max(0.0) };
        Enclosure::total(Interval { lo: exact, hi: if self.hi == 0.0 { 1.0 } else { hi } })
    }

    /// A logarithm, given as a function of f64.
    fn logarithm(self, f: fn(f64) -> f64) -> Enclosure {
        if !(self.hi > 0.0) {
            return Enclosure::NOWHERE;
        }
        let lo = if self.lo > 0.0 { below(f(self.lo), bound::LN) } else { f64::NEG_INFINITY };
        let hi = if self.hi == f64::INFINITY { self.hi } else { above(f(self.hi), bound::LN) };
        let range = Interval { lo, hi };
        if self.lo > 0.0 { Enclosure::total(range) } else { Enclosure::partial(range) }
    }

    /// natural logarithm
    pub fn ln(self) -> Enclosure {
        self.logarithm(native::ln)
    }

    /// logarithm to base 2
    pub fn log2(self) -> Enclosure {
        self.logarithm(native::log2)
    }

    /// logarithm to base 10
    pub fn log10(self) -> Enclosure {
        self.logarithm(native::log10)
    }

    /// arctangent
    pub fn atan(self) -> Enclosure {
        Enclosure::total(self.rising(native::atan, bound::ATAN).within(-HALF_PI_UP, HALF_PI_UP))
    }

    /// The part of the box in [lo, hi], and whether that is all of it; `None` when there is none.
    fn domain(self, lo: f64, hi: f64) -> Option<(Interval, bool)> {
        let inside = self.intersection(Interval { lo, hi });
        (!inside.is_empty()).then_some((inside, inside == self))
    }

    /// arcsine
    pub fn asin(self) -> Enclosure {
        let Some((inside, all)) = self.domain(-1.0, 1.0) else { return Enclosure::NOWHERE };
        let range = inside.rising(native::asin, bound::ASIN).within(-HALF_PI_UP, HALF_PI_UP);
        if all { Enclosure::total(range) } else { Enclosure::partial(range) }
    }

    /// arccosine
    pub fn acos(self) -> Enclosure {
        let Some((inside, all)) = self.domain(-1.0, 1.0) else { return Enclosure::NOWHERE };
        let falling = Interval { lo: inside.hi, hi: inside.lo };
        let range = falling.rising(native::acos, bound::ACOS).within(0.0, PI_UP);
        if all { Enclosure::total(range) } else { Enclosure::partial(range) }
    }

    /// hyperbolic sine
    pub fn sinh(self) -> Enclosure {
        let mut range = self.rising(native::sinh, bound::SINH);
        if self.lo == f64::NEG_INFINITY {
            range.lo = self.lo;
        }
        if self.hi == f64::INFINITY {
            range.hi = self.hi;
        }
        Enclosure::total(range)
    }

    /// hyperbolic cosine
    pub fn cosh(self) -> Enclosure {
        let size = self.abs().range;
        let lo = if size.lo == 0.0 { 1.0 } else { below(native::cosh(size.lo), bound::COSH).max(1.0) };
        let hi = if size.hi == 0.0 { 1.0 } else { above(native::cosh(size.hi), bound::COSH) };
        Enclosure::total(Interval { lo, hi })
    }

    /// hyperbolic tangent
    pub fn tanh(self) -> Enclosure {
        Enclosure::total(self.rising(native::tanh, bound::TANH).within(-1.0, 1.0))
    }

    /// inverse hyperbolic sine
    pub fn asinh(self) -> Enclosure {
        let mut range = self.rising(native::asinh, bound::ASINH);
        if self.lo == f64::NEG_INFINITY {
            range.lo = self.lo;
        }
        Enclosure::total(Interval { hi: if self.hi == f64::INFINITY { self.hi } else { range.hi }, ..range })
    }

    /// inverse hyperbolic cosine
    pub fn acosh(self) -> Enclosure {
        let Some((inside, all)) = self.domain(1.0, f64::INFINITY) else { return Enclosure::NOWHERE };
        let range = inside.rising(native::acosh, bound::ASINH);
        if all { Enclosure::total(range) } else { Enclosure::partial(range) }
    }

    /// inverse hyperbolic tangent
    pub fn atanh(self) -> Enclosure {
        if !(self.hi > -1.0 && self.lo < 1.0) {
            return Enclosure::NOWHERE;
        }
        let all = self.lo > -1.0 && self.hi < 1.0;
        let lo = if self.lo > -1.0 { below(native::atanh(self.lo), bound::ASINH) } else { f64::NEG_INFINITY };
        let hi = if self.hi < 1.0 { above(native::atanh(self.hi), bound::ASINH) } else { f64::INFINITY };
        let range = Interval { lo, hi };
        if all { Enclosure::total(range) } else { Enclosure::partial(range) }
    }

    /// error function
    pub fn erf(self) -> Enclosure {
        Enclosure::total(self.rising(native::erf, bound::ERF).within(-1.0, 1.0))
    }

    /// real root of odd order n ≥ 3
    pub fn root(self, n: u32) -> Enclosure {
        let down = |a: f64| if a.is_infinite() { a } else { below(native::root(a, n), bound::POW) };
        let up = |a: f64| -down(-a);
        Enclosure::total(Interval { lo: down(self.lo), hi: up(self.hi) })
    }

    /// a^b: monotone in each argument, so that the corners decide.
    pub fn pow(self, exponent: Self) -> Enclosure {
        let (a, b) = (self, exponent);
        if a.hi < 0.0 || (a.hi == 0.0 && b.hi <= 0.0) {
            return Enclosure::NOWHERE;
        }
        let all = a.lo > 0.0 || (a.lo == 0.0 && b.lo > 0.0);
        let range = if a.hi == 0.0 {
            Interval::point(0.0)
        } else {
            let low = a.lo.max(0.0);
            [(low, b.lo), (low, b.hi), (a.hi, b.lo), (a.hi, b.hi)]
                .iter()
                .fold(Interval::EMPTY, |hull, &(a, b)| hull.hull(power_at_corner(a, b)))
        };
        if all { Enclosure::total(range) } else { Enclosure::partial(range) }
    }

    /// a^a for a > 0: it falls from its limit 1 to (1/e)^(1/e), and rises from there. The corners of two
    /// independent boxes would reach from 0 to 1 near a = 0.
    pub fn self_power(self) -> Enclosure {
        /// f64 around 1/e = 0.36787944117144232….
        const LOWEST_AT: (f64, f64) = (0.3678794411714423, 0.3678794411714424);
        /// Below (1/e)^(1/e) = 0.69220062755534635….
        const LOWEST: f64 = 0.6922006275553462;
        if self.hi <= 0.0 {
            return Enclosure::NOWHERE;
        }
        let ends =
            [self.lo.max(0.0), self.hi].map(|a| if a == 0.0 { Interval::point(1.0) } else { power_at_corner(a, a) });
        let mut range = ends[0].hull(ends[1]);
        if self.lo <= LOWEST_AT.1 && self.hi >= LOWEST_AT.0 {
            range.lo = LOWEST;
        }
        if self.lo > 0.0 { Enclosure::total(range) } else { Enclosure::partial(range) }
    }

    /// angle of the point (x = b, y = a)
    pub fn atan2(self, x: Self) -> Enclosure {
        let origin = self.contains(0.0) && x.contains(0.0);
        if self.is_point(0.0) && x.is_point(0.0) {
            return Enclosure::NOWHERE;
        }
        let [below, above] = self.angle_halves(x);
        let cut = x.lo < 0.0 && self.lo < 0.0 && self.hi >= 0.0;
        let range = below.hull(above);
        match (origin, cut) {
            (true, _) => Enclosure::partial(range),
            (false, true) => Enclosure::jumping(range),
            (false, false) => Enclosure::total(range),
        }
    }

    /// The angles for y < 0 and for y ≥ 0.
    pub(super) fn angle_halves(self, x: Self) -> [Interval; 2] {
        let below = if self.lo < 0.0 {
            let mirrored = Interval { lo: (-self.hi).max(0.0), hi: -self.lo }.angle_above(x, true);
            Interval { lo: -mirrored.hi, hi: -mirrored.lo }
        } else {
            Interval::EMPTY
        };
        let above = if self.hi >= 0.0 {
            Interval { lo: self.lo.max(0.0), hi: self.hi }.angle_above(x, false)
        } else {
            Interval::EMPTY
        };
        [below, above]
    }

    /// The angles of x and y ≥ 0, of y > 0 alone where the limit y → 0 is `open` (the closure then). The angle
    /// falls with x, rises with y for x > 0, falls with it for x < 0.
    fn angle_above(self, x: Self, open: bool) -> Interval {
        let y = self;
        if y.hi == 0.0 && x.is_point(0.0) {
            return Interval::EMPTY;
        }
        // Only x = 0, or x ≤ 0 with y = 0, needs a limit: the corner (0, 0) itself has no angle.
        let least = match () {
            _ if x.hi > 0.0 => (y.lo, x.hi),
            _ if y.hi > 0.0 => (y.hi, x.hi),
            _ => (0.0, x.lo),
        };
        let most = match () {
            _ if x.lo < 0.0 => (y.lo, x.lo),
            _ if y.hi > 0.0 => (y.hi, x.lo),
            _ => (0.0, x.hi),
        };
        let range = Interval { lo: angle_bounds(least).lo, hi: angle_bounds(most).hi };
        debug_assert!(open || !range.is_empty());
        range
    }
}

/// Encloses the angle of (y, x), y ≥ 0, not both 0; infinite coordinates by their limits, [0, π] where those
/// depend on the way.
fn angle_bounds((y, x): (f64, f64)) -> Interval {
    let half = Interval::new(FRAC_PI_2, HALF_PI_UP);
    let straight = Interval::new(PI, PI_UP);
    match (y.is_infinite(), x.is_infinite()) {
        (true, true) if x > 0.0 => Interval::new(0.0, HALF_PI_UP),
        (true, true) => Interval::new(FRAC_PI_2, PI_UP),
        (true, false) => half,
        (false, true) if x > 0.0 => Interval::point(0.0),
        (false, true) => straight,
        _ if y == 0.0 && x > 0.0 => Interval::point(0.0),
        _ if y == 0.0 => straight,
        _ if x == 0.0 => half,
        _ => {
            let angle = native::atan2(y, x);
            Interval::new(below(angle, bound::ATAN), above_vanishing(angle, bound::ATAN)).within(0.0, PI_UP)
        }
    }
}

/// Encloses a^b for a ≥ 0, or its limit as the arguments come to a corner of a box from inside.
fn power_at_corner(a: f64, b: f64) -> Interval {
    if a == 1.0 || b == 0.0 {
        return Interval::point(1.0);
    }
    if a == 0.0 || a == f64::INFINITY || b.is_infinite() {
        let grows = (a > 1.0) == (b > 0.0);
        return Interval::point(if grows { f64::INFINITY } else { 0.0 });
    }
    let p = native::pow(a, b);
    Interval::new(below(p, bound::POW).max(0.0), above_vanishing(p, bound::POW))
}
