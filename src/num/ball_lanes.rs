//! A fixed-size array of balls: the batch that proves how far points are from what they were computed for.
//!
//! In: c ± r. Out: the function's computed value at c, and how far its exact value anywhere in the ball can be from that.
//! Nothing is said of whether there is a value: who asks knows that already. Where an interval holds for arguments far
//! apart, a ball is for those that are as good as one point, and costs little more than the point: its radius is carried on by the
//! bounds of a running error analysis (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002, section 3.3).

use super::func::{self, bound};
use super::lanes::Lanes;
use super::level::Level;
use super::number::{Basic, Constant, Number, Pair};
use std::f64::consts::{LOG2_E, LOG10_E};

/// N balls. One whose radius is not finite says nothing.
#[derive(Clone, Copy, Debug)]
pub struct BallLanes<const N: usize> {
    /// What a point would be.
    pub center: Lanes<N>,
    /// How far the exact value can be from it, ≥ 0.
    pub radius: Lanes<N>,
}

/// Outweighs the roundings of a radius: a dozen of 2^-53 at most.
const GROWN: f64 = 1.0 + 8.0 * f64::EPSILON;

/// What is added for what is too small for its rounding to be a part of it.
const TINY: f64 = 1e-300;

/// A relative radius up to which the series of e^r − 1 and ln(1 + r) are bounded by their first terms here.
const SMALL: f64 = 0.5;

/// Where nothing is known.
const UNKNOWN: f64 = f64::INFINITY;

/// x if a condition holds, and otherwise that nothing is known.
#[inline(always)]
fn known_if(condition: bool, x: f64) -> f64 {
    if condition { x } else { UNKNOWN }
}

#[inline(always)]
fn add<L: Level>((a, r): (f64, f64), (b, s): (f64, f64)) -> (f64, f64) {
    let c = a + b;
    (c, L::fma(r + s, GROWN, c.abs() * f64::EPSILON))
}

#[inline(always)]
fn sub<L: Level>(a: (f64, f64), (b, s): (f64, f64)) -> (f64, f64) {
    add::<L>(a, (-b, s))
}

#[inline(always)]
fn mul<L: Level>((a, r): (f64, f64), (b, s): (f64, f64)) -> (f64, f64) {
    let c = a * b;
    let spread = L::fma(a.abs() + r, s, b.abs() * r);
    (c, L::fma(spread, GROWN, L::fma(c.abs(), f64::EPSILON, TINY)))
}

/// The radius behind a function that is computed to `ulps` and changes by at most `spread`.
#[inline(always)]
fn around<L: Level>(value: f64, spread: f64, ulps: f64) -> f64 {
    L::fma(spread, GROWN, L::fma(value.abs(), 2.0 * ulps * f64::EPSILON, TINY))
}

/// What e^r − 1 is at most for r ≤ [`SMALL`]: the series has r + r²/2·(1 + r/3 + …).
#[inline(always)]
fn grown(r: f64) -> f64 {
    r + r * r
}

/// What −ln(1 − q) is at most for a relative radius q ≤ [`SMALL`].
#[inline(always)]
fn relative(c: f64, r: f64) -> f64 {
    let q = r / c.abs();
    known_if(q <= SMALL, q + 2.0 * q * q)
}

impl<const N: usize> BallLanes<N> {
    #[inline(always)]
    fn at(&self, i: usize) -> (f64, f64) {
        (self.center.0[i], self.radius.0[i])
    }

    #[inline(always)]
    fn set(&mut self, i: usize, (center, radius): (f64, f64)) {
        (self.center.0[i], self.radius.0[i]) = (center, radius);
    }
}

/// Functions of one argument: the computed value, and a radius from c, the value v there, and r.
macro_rules! each {
    ($($name:ident($($n:ident: $type:ty)?), $ulps:expr, |$c:ident, $v:ident, $r:ident| $spread:expr;)*) => {
        $(#[inline(always)]
        fn $name<L: Level>(a: &Self, $($n: $type,)? out: &mut Self) {
            Lanes::$name::<L>(&a.center, $($n,)? &mut out.center);
            for i in 0..N {
                let ($c, $v, $r) = (a.center.0[i], out.center.0[i], a.radius.0[i]);
                let _ = ($c, $v);
                out.radius.0[i] = around::<L>($v, $spread, $ulps);
            }
        })*
    };
}

/// Functions that are exact and nowhere steeper than 1 or constant.
macro_rules! exact {
    ($($name:ident, |$c:ident, $r:ident| $radius:expr;)*) => {
        $(#[inline(always)]
        fn $name<L: Level>(a: &Self, out: &mut Self) {
            Lanes::$name::<L>(&a.center, &mut out.center);
            for i in 0..N {
                let ($c, $r) = a.at(i);
                let _ = $c;
                out.radius.0[i] = $radius;
            }
        })*
    };
}

/// Operations of two balls, lane by lane.
macro_rules! binary {
    ($($name:ident),*) => {
        $(#[inline(always)]
        fn $name<L: Level>(a: &Self, b: &Self, out: &mut Self) {
            for i in 0..N {
                out.set(i, $name::<L>(a.at(i), b.at(i)));
            }
        })*
    };
}

impl<const N: usize> Number for BallLanes<N> {
    #[inline(always)]
    fn constant(value: Constant) -> Self {
        let radius = (value.range.hi - value.point).max(value.point - value.range.lo);
        let radius = if radius > 0.0 { radius * GROWN } else { 0.0 };
        BallLanes { center: Lanes::splat(value.point), radius: Lanes::splat(radius) }
    }

    exact! {
        neg, |c, r| r;
        abs, |c, r| r;
        sign, |c, r| known_if(c.abs() > r, 0.0);
        floor, |c, r| {
            let r = r * GROWN + c.abs() * f64::EPSILON;
            known_if((c - r).floor() == (c + r).floor(), 0.0)
        };
    }

    // Cubes and fourth powers take up to three roundings, hence two units there.
    // table: a line a function, by the mean value theorem with the steepest slope in the ball.
    each! {
        sqrt(), 1.0, |c, v, r| r / v;
        exp(), bound::EXP, |c, v, r| v * known_if(r <= SMALL, grown(r));
        ln(), bound::LN, |c, v, r| known_if(c > 0.0, relative(c, r));
        log2(), bound::LN, |c, v, r| known_if(c > 0.0, relative(c, r) * LOG2_E);
        log10(), bound::LN, |c, v, r| known_if(c > 0.0, relative(c, r) * LOG10_E);
        sin(), bound::SIN, |c, v, r| r;
        cos(), bound::SIN, |c, v, r| r;
        tan(), bound::TAN, |c, v, r| {
            // tan(c + r) by its addition theorem; tan r ≤ 1.1·r for r ≤ 1/2.
            let t = 1.1 * r;
            known_if((r <= SMALL) & (t * v.abs() <= SMALL), t * (1.0 + v * v) / (1.0 - t * v.abs()))
        };
        asin(), bound::ASIN, |c, v, r| {
            let m = (c.abs() + r) * GROWN;
            known_if(m < 1.0, r / ((1.0 - m) * (1.0 + m)).sqrt())
        };
        acos(), bound::ACOS, |c, v, r| {
            let m = (c.abs() + r) * GROWN;
            known_if(m < 1.0, r / ((1.0 - m) * (1.0 + m)).sqrt())
        };
        atan(), bound::ATAN, |c, v, r| r;
        sinh(), bound::SINH, |c, v, r| known_if(r <= SMALL, r * (1.0 + v.abs()) * (1.0 + 2.0 * r));
        cosh(), bound::COSH, |c, v, r| known_if(r <= SMALL, r * v * (1.0 + 2.0 * r));
        tanh(), bound::TANH, |c, v, r| r;
        asinh(), bound::ASINH, |c, v, r| r;
        acosh(), bound::ASINH, |c, v, r| {
            let m = (c - r) * (2.0 - GROWN);
            known_if(m > 1.0, r / ((m - 1.0).sqrt() * (m + 1.0).sqrt()))
        };
        atanh(), bound::ASINH, |c, v, r| {
            let m = (c.abs() + r) * GROWN;
            known_if(m < 1.0, r / ((1.0 - m) * (1.0 + m)))
        };
        // 2/√π < 1.13.
        erf(), bound::ERF, |c, v, r| 1.13 * r;
        power(n: i64), 2.0, |c, v, r| {
            let m = n.unsigned_abs() as f64 * relative(c, r);
            v.abs() * known_if((m <= SMALL) & (n.unsigned_abs() <= bound::MOST_POWER), grown(m))
        };
        root(n: u32), bound::POW, |c, v, r| v.abs() * grown(relative(c, r));
    }

    binary! { add, sub, mul }

    #[inline(always)]
    fn square<L: Level>(a: &Self, out: &mut Self) {
        Self::mul::<L>(a, a, out);
    }

    #[inline(always)]
    fn sin_cos<L: Level>(a: &Self, sin: &mut Self, cos: &mut Self) {
        Lanes::sin_cos::<L>(&a.center, &mut sin.center, &mut cos.center);
        for i in 0..N {
            sin.radius.0[i] = around::<L>(sin.center.0[i], a.radius.0[i], bound::SIN);
            cos.radius.0[i] = around::<L>(cos.center.0[i], a.radius.0[i], bound::SIN);
        }
    }

    #[inline(always)]
    fn div<L: Level>(a: &Self, b: &Self, out: &mut Self) {
        for i in 0..N {
            let ((a, r), (b, s)) = (a.at(i), b.at(i));
            let c = func::div(a, b);
            // Divided by what is tiny, an underflow would not be.
            let (left, away) = (L::fma(c.abs(), s, r + TINY), b.abs() - s * GROWN);
            out.set(i, (c, known_if(away > 0.0, around::<L>(c, left / away, 1.0))));
        }
    }

    #[inline(always)]
    fn floor_div<L: Level>(a: &Self, b: &Self, n: i64, out: &mut Self) {
        for i in 0..N {
            let ((a, r), (b, s), n) = (a.at(i), b.at(i), n as f64);
            let c = n * a / b;
            let (left, away) = (L::fma(c.abs(), s, L::fma(n, r, TINY)), b.abs() - s * GROWN);
            let r = around::<L>(c, left / away, 4.0);
            let is_known = (away > 0.0) & ((c - r).floor() == (c + r).floor());
            out.set(i, (func::floor_div::<L>(n, a, b), known_if(is_known, 0.0)));
        }
    }

    #[inline(always)]
    fn min<L: Level>(a: &Self, b: &Self, out: &mut Self) {
        for i in 0..N {
            let ((a, r), (b, s)) = (a.at(i), b.at(i));
            out.set(i, (func::min(a, b), func::max(r, s)));
        }
    }

    #[inline(always)]
    fn max<L: Level>(a: &Self, b: &Self, out: &mut Self) {
        for i in 0..N {
            let ((a, r), (b, s)) = (a.at(i), b.at(i));
            out.set(i, (func::max(a, b), func::max(r, s)));
        }
    }

    /// By a^b = e^(b·ln a).
    #[inline(always)]
    fn pow<L: Level>(a: &Self, b: &Self, out: &mut Self) {
        for i in 0..N {
            let ((a, r), (b, s)) = (a.at(i), b.at(i));
            let v = func::pow::<L>(a, b);
            let log = func::ln::<L>(a);
            let change = relative(a, r);
            let m = L::fma(b.abs() + s, change, s * (log.abs() + 2.0 * f64::EPSILON)) * GROWN;
            let spread = v * known_if((a > 0.0) & (m <= SMALL), grown(m));
            out.set(i, (v, around::<L>(v, spread, bound::POW)));
        }
    }

    /// The angle changes by at most the way across over the distance from the origin; behind the origin it jumps.
    #[inline(always)]
    fn atan2<L: Level>(a: &Self, b: &Self, out: &mut Self) {
        for i in 0..N {
            let ((a, r), (b, s)) = (a.at(i), b.at(i));
            let v = func::atan2::<L>(a, b);
            let way = (r + s) * GROWN;
            let away = a.abs().max(b.abs()) - way;
            let is_known = (away > 0.0) & ((a.abs() > r) | (b > s));
            out.set(i, (v, known_if(is_known, around::<L>(v, way / away, bound::ATAN))));
        }
    }

    #[inline(always)]
    fn choose<L: Level>(c: &Self, a: &Self, b: &Self, out: &mut Self) {
        for i in 0..N {
            let (c, r) = c.at(i);
            let pick = |a: f64, b: f64| func::choose(c, a, b);
            let radius = known_if((c > r) | (c <= -r), pick(a.radius.0[i], b.radius.0[i]));
            out.set(i, (pick(a.center.0[i], b.center.0[i]), radius));
        }
    }

    #[inline(always)]
    fn pair<L: Level>(pair: Pair, a: &Self, b: &Self, c: &Self, out: &mut Self) {
        match pair.first {
            Basic::Add => second::<L, N>(pair, |i| add::<L>(a.at(i), b.at(i)), c, out),
            Basic::Sub => second::<L, N>(pair, |i| sub::<L>(a.at(i), b.at(i)), c, out),
            Basic::Mul => second::<L, N>(pair, |i| mul::<L>(a.at(i), b.at(i)), c, out),
        }
    }

    #[inline(always)]
    fn products<L: Level>(minus: bool, [a, b, c, d]: [&Self; 4], out: &mut Self) {
        if minus {
            for i in 0..N {
                out.set(i, sub::<L>(mul::<L>(a.at(i), b.at(i)), mul::<L>(c.at(i), d.at(i))));
            }
        } else {
            for i in 0..N {
                out.set(i, add::<L>(mul::<L>(a.at(i), b.at(i)), mul::<L>(c.at(i), d.at(i))));
            }
        }
    }
}

/// The second operation of a pair, a loop each.
#[inline(always)]
fn second<L: Level, const N: usize>(
    pair: Pair,
    first: impl Fn(usize) -> (f64, f64),
    c: &BallLanes<N>,
    out: &mut BallLanes<N>,
) {
    macro_rules! each {
        ($i:ident => $value:expr) => {
            for $i in 0..N {
                out.set($i, $value);
            }
        };
    }
    match (pair.second, pair.reversed) {
        (Basic::Add, _) => each!(i => add::<L>(first(i), c.at(i))),
        (Basic::Mul, _) => each!(i => mul::<L>(first(i), c.at(i))),
        (Basic::Sub, false) => each!(i => sub::<L>(first(i), c.at(i))),
        (Basic::Sub, true) => each!(i => sub::<L>(c.at(i), first(i))),
    }
}
