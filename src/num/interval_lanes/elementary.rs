//! Elementary functions of all lanes at once.
//!
//! In: arrays of bounds. Out: arrays of bounds, each the function's value pushed outward by its error bound and cut
//! by its range; lanes out of the ordinary by `interval`. Separate because these loops must stay free of branches.

use super::arithmetic::{down, greater, lesser, repair, repair_pairs};
use super::{IntervalLanes, JUMP, PARTIAL};
use crate::num::func::bound::steps;
use crate::num::func::trigonometric::{self, REDUCIBLE};
use crate::num::func::{self, bound};
use crate::num::interval::{Enclosure, TURN_ERROR};
use crate::num::level::Level;
use crate::num::mask::{Mask, any, join, mark, word};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

/// A few of the smallest f64: what rounding below the normal range may lose, doubled.
const SUBNORMAL: f64 = 8e-323;

/// A lower bound of a result computed within `ulps`, as in `interval`; 0 is exact.
#[inline(always)]
fn below<L: Level>(r: f64, ulps: f64) -> f64 {
    let mut pushed = r;
    let mut step = 0;
    while step < steps(ulps) {
        pushed = down::<L>(pushed);
        step += 1;
    }
    let pushed = pushed - SUBNORMAL;
    if r == 0.0 { r } else { pushed }
}

#[inline(always)]
fn above<L: Level>(r: f64, ulps: f64) -> f64 {
    -below::<L>(-r, ulps)
}

/// As [`above`] for r ≥ 0 that is 0 because it is too small.
#[inline(always)]
fn above_vanishing<L: Level>(r: f64, ulps: f64) -> f64 {
    let pushed = above::<L>(r, ulps);
    if r == 0.0 { SUBNORMAL } else { pushed }
}

/// A function that rises everywhere, 0 only where it is exactly 0, cut to its range.
macro_rules! rising {
    ($($name:ident($x:ident) = $value:expr, $ulps:expr, $least:expr, $most:expr;)*) => { $(
        #[inline(always)]
        pub(super) fn $name<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
            let mut odd = [0; N];
            for i in 0..N {
                let $x = a.lo[i];
                let lo = $value;
                let $x = a.hi[i];
                let hi = $value;
                out.lo[i] = greater(below::<L>(lo, $ulps), $least);
                out.hi[i] = lesser(above::<L>(hi, $ulps), $most);
                odd[i] = word(!((lo.abs() < f64::INFINITY) & (hi.abs() < f64::INFINITY)));
            }
            out.flags = a.flags;
            if any(&odd) {
                repair(a, out, &odd, Enclosure::$name);
            }
        }
    )* };
}

const NONE: f64 = f64::INFINITY;

rising! {
    atan(x) = func::atan::<L>(x), bound::ATAN, -FRAC_PI_2.next_up(), FRAC_PI_2.next_up();
    asin(x) = func::asin::<L>(x), bound::ASIN, -FRAC_PI_2.next_up(), FRAC_PI_2.next_up();
    sinh(x) = func::sinh::<L>(x), bound::SINH, -NONE, NONE;
    tanh(x) = func::tanh::<L>(x), bound::TANH, -1.0, 1.0;
    asinh(x) = func::asinh::<L>(x), bound::ASINH, -NONE, NONE;
    acosh(x) = func::acosh::<L>(x), bound::ASINH, 0.0, NONE;
    atanh(x) = func::atanh::<L>(x), bound::ASINH, -NONE, NONE;
    erf(x) = func::erf::<L>(x), bound::ERF, -1.0, 1.0;
}

/// A logarithm: −∞ below where the box reaches out of the domain.
macro_rules! logarithm {
    ($($name:ident),*) => { $(
        #[inline(always)]
        pub(super) fn $name<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
            let (mut odd, mut cut) = ([0; N], [0; N]);
            for i in 0..N {
                let (lo, hi) = (func::$name::<L>(a.lo[i]), func::$name::<L>(a.hi[i]));
                let inside = a.lo[i] > 0.0;
                let least = below::<L>(lo, bound::LN);
                out.lo[i] = if inside { least } else { f64::NEG_INFINITY };
                out.hi[i] = above::<L>(hi, bound::LN);
                cut[i] = word(!inside);
                odd[i] = word(!(hi.abs() < f64::INFINITY));
            }
            out.flags = a.flags;
            mark(&mut out.flags, &cut, PARTIAL | JUMP);
            if any(&odd) {
                repair(a, out, &odd, Enclosure::$name);
            }
        }
    )* };
}

logarithm!(ln, log2, log10);

#[inline(always)]
pub(super) fn exp<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let (lo, hi) = (func::exp::<L>(a.lo[i]), func::exp::<L>(a.hi[i]));
        out.lo[i] = greater(below::<L>(lo, bound::EXP), 0.0);
        out.hi[i] = above_vanishing::<L>(hi, bound::EXP);
        odd[i] = word(!((lo < f64::INFINITY) & (hi < f64::INFINITY)));
    }
    out.flags = a.flags;
    if any(&odd) {
        repair(a, out, &odd, Enclosure::exp);
    }
}

#[inline(always)]
pub(super) fn acos<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let (lo, hi) = (func::acos::<L>(a.hi[i]), func::acos::<L>(a.lo[i]));
        out.lo[i] = greater(below::<L>(lo, bound::ACOS), 0.0);
        out.hi[i] = lesser(above::<L>(hi, bound::ACOS), PI.next_up());
        odd[i] = word(!((lo >= 0.0) & (hi >= 0.0)));
    }
    out.flags = a.flags;
    if any(&odd) {
        repair(a, out, &odd, Enclosure::acos);
    }
}

#[inline(always)]
pub(super) fn cosh<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let least = greater(0.0, greater(a.lo[i], -a.hi[i]));
        let (lo, hi) = (func::cosh::<L>(least), func::cosh::<L>(greater(-a.lo[i], a.hi[i])));
        out.lo[i] = greater(below::<L>(lo, bound::COSH), 1.0);
        out.hi[i] = above::<L>(hi, bound::COSH);
        odd[i] = word(!((lo < f64::INFINITY) & (hi < f64::INFINITY)));
    }
    out.flags = a.flags;
    if any(&odd) {
        repair(a, out, &odd, Enclosure::cosh);
    }
}

#[inline(always)]
pub(super) fn root<L: Level, const N: usize>(a: &IntervalLanes<N>, n: u32, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let (lo, hi) = (func::root::<L>(a.lo[i], n), func::root::<L>(a.hi[i], n));
        out.lo[i] = below::<L>(lo, bound::POW);
        out.hi[i] = above::<L>(hi, bound::POW);
        odd[i] = word(!(hi - lo < f64::INFINITY));
    }
    out.flags = a.flags;
    if any(&odd) {
        repair(a, out, &odd, |e| e.root(n));
    }
}

/// A box in quarter turns, outward.
#[inline(always)]
fn quarter_turns(lo: f64, hi: f64) -> (f64, f64) {
    let (s, t) = (lo * FRAC_2_PI, hi * FRAC_2_PI);
    (s - s.abs() * TURN_ERROR, t + t.abs() * TURN_ERROR)
}

/// Whether a whole number that is `rest` modulo the period (a power of two, its inverse given) is between.
#[inline(always)]
fn meets(turns: (f64, f64), rest: f64, period: f64, inverse: f64) -> bool {
    ((turns.1 - rest) * inverse).floor() * period + rest >= turns.0
}

/// The bounds of a wave with values a, b at the ends and a crest at `crest` modulo 4 quarter turns; [−1, 1] for
/// large angles, NaN for none.
#[inline(always)]
fn wave<L: Level>(lo: f64, hi: f64, a: f64, b: f64, crest: f64) -> (f64, f64) {
    let turns = quarter_turns(lo, hi);
    let large = !((lo >= -REDUCIBLE) & (hi <= REDUCIBLE));
    let least = greater(below::<L>(lesser(a, b), bound::SIN), -1.0);
    let most = lesser(above::<L>(greater(a, b), bound::SIN), 1.0);
    let least = if meets(turns, crest + 2.0, 4.0, 0.25) | large { -1.0 } else { least };
    let most = if meets(turns, crest, 4.0, 0.25) | large { 1.0 } else { most };
    let empty = lo.is_nan();
    (if empty { lo } else { least }, if empty { hi } else { most })
}

#[inline(always)]
pub(super) fn sin<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    for i in 0..N {
        let (lo, hi) = (a.lo[i], a.hi[i]);
        let ends = (trigonometric::sin_reducible::<L>(lo), trigonometric::sin_reducible::<L>(hi));
        (out.lo[i], out.hi[i]) = wave::<L>(lo, hi, ends.0, ends.1, 1.0);
    }
    out.flags = a.flags;
}

#[inline(always)]
pub(super) fn cos<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    for i in 0..N {
        let (lo, hi) = (a.lo[i], a.hi[i]);
        let ends = (trigonometric::cos_reducible::<L>(lo), trigonometric::cos_reducible::<L>(hi));
        (out.lo[i], out.hi[i]) = wave::<L>(lo, hi, ends.0, ends.1, 0.0);
    }
    out.flags = a.flags;
}

#[inline(always)]
pub(super) fn sin_cos<L: Level, const N: usize>(
    a: &IntervalLanes<N>,
    sin: &mut IntervalLanes<N>,
    cos: &mut IntervalLanes<N>,
) {
    for i in 0..N {
        let (lo, hi) = (a.lo[i], a.hi[i]);
        let (s, c) = trigonometric::sin_cos_reducible::<L>(lo);
        let (t, d) = trigonometric::sin_cos_reducible::<L>(hi);
        (sin.lo[i], sin.hi[i]) = wave::<L>(lo, hi, s, t, 1.0);
        (cos.lo[i], cos.hi[i]) = wave::<L>(lo, hi, c, d, 0.0);
    }
    sin.flags = a.flags;
    cos.flags = a.flags;
}

#[inline(always)]
pub(super) fn tan<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let (lo, hi) = (a.lo[i], a.hi[i]);
        let pole = meets(quarter_turns(lo, hi), 1.0, 2.0, 0.5);
        let large = !((lo >= -REDUCIBLE) & (hi <= REDUCIBLE));
        out.lo[i] = below::<L>(trigonometric::tan_reducible::<L>(lo), bound::TAN);
        out.hi[i] = above::<L>(trigonometric::tan_reducible::<L>(hi), bound::TAN);
        odd[i] = word(pole | large);
    }
    out.flags = a.flags;
    if any(&odd) {
        repair(a, out, &odd, Enclosure::tan);
    }
}

/// Bases above 0: the corners decide, and two of them by the sign of the exponent and the side of 1.
#[inline(always)]
pub(super) fn pow<L: Level, const N: usize>(a: &IntervalLanes<N>, b: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd: Mask<N> = [0; N];
    for i in 0..N {
        let (al, ah, bl, bh) = (a.lo[i], a.hi[i], b.lo[i], b.hi[i]);
        let (p, q) = (func::pow::<L>(al, bl), func::pow::<L>(al, bh));
        let (r, s) = (func::pow::<L>(ah, bl), func::pow::<L>(ah, bh));
        let least = lesser(lesser(p, q), lesser(r, s));
        let most = greater(greater(p, q), greater(r, s));
        out.lo[i] = greater(below::<L>(least, bound::POW), 0.0);
        out.hi[i] = above_vanishing::<L>(most, bound::POW);
        odd[i] = word(!((al > 0.0) & (((p + q) + (r + s)) < f64::INFINITY)));
    }
    join(&a.flags, &b.flags, &mut out.flags);
    if any(&odd) {
        repair_pairs(a, b, out, &odd, Enclosure::pow);
    }
}
