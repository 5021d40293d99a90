//! Operations that pick among affine forms.
//!
//! In: forms. Out: where the choice is decided over the whole cell, a copy of the chosen one; else a mean of both, or the hull. Separate
//! from the arithmetic because the copies are exact, which is what makes forms of minima and maxima good.

use super::{AffineLanes, ROUNDING, repair};
use crate::num::interval_lanes::{JUMP, NOWHERE, PARTIAL};
use crate::num::level::Level;
use crate::num::mask::{Mask, any, join, word};
use crate::num::number::Number;

/// a where the word is all ones, b where it is 0, flags excepted.
#[inline(always)]
fn pick<const N: usize, const S: usize>(
    mask: &Mask<N>,
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
) {
    let one = |k: usize, a: &[f64; N], b: &[f64; N]| crate::num::mask::pick(mask[k], a[k], b[k]);
    for i in 0..N {
        out.center[i] = one(i, &a.center, &b.center);
        out.error[i] = one(i, &a.error, &b.error);
    }
    for s in 0..S {
        for i in 0..N {
            out.slope[s][i] = one(i, &a.slope[s], &b.slope[s]);
        }
    }
}

#[inline(always)]
pub(super) fn abs<L: Level, const N: usize, const S: usize>(a: &AffineLanes<N, S>, out: &mut AffineLanes<N, S>) {
    let (mut negative, mut open) = ([0; N], [0; N]);
    for i in 0..N {
        let (lo, hi) = a.bounds(i);
        negative[i] = word(hi <= 0.0);
        open[i] = word(!((hi <= 0.0) | (lo >= 0.0)));
    }
    let mut turned = *a;
    super::arithmetic::neg(a, &mut turned);
    pick(&negative, &turned, a, out);
    out.flags = a.flags;
    if any(&open) {
        repair!(open, out, abs::<L>(a));
    }
}

#[inline(always)]
pub(super) fn min<L: Level, const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
) {
    let open = decided(a, b, 1.0, out);
    if any(&open) {
        let blunt = mean(a, b, 1.0, &open, out);
        if any(&blunt) {
            repair!(blunt, out, min::<L>(a, b));
        }
    }
}

#[inline(always)]
pub(super) fn max<L: Level, const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
) {
    let open = decided(a, b, -1.0, out);
    if any(&open) {
        let blunt = mean(a, b, -1.0, &open, out);
        if any(&blunt) {
            repair!(blunt, out, max::<L>(a, b));
        }
    }
}

/// The smaller of two forms, or for sign −1 the larger, where the difference has one sign; marks the other lanes.
#[inline(always)]
fn decided<const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    sign: f64,
    out: &mut AffineLanes<N, S>,
) -> Mask<N> {
    let mut difference = *a;
    super::arithmetic::sub(a, b, &mut difference);
    let (mut first, mut open) = ([0; N], [0; N]);
    for i in 0..N {
        let (low, high) = turned(&difference, i, sign);
        first[i] = word(high <= 0.0);
        open[i] = word(!((high <= 0.0) | (low >= 0.0)));
    }
    pick(&first, a, b, out);
    join(&a.flags, &b.flags, &mut out.flags);
    open
}

/// The bounds of a lane, or for sign −1 those of its negative.
#[inline(always)]
fn turned<const N: usize, const S: usize>(a: &AffineLanes<N, S>, i: usize, sign: f64) -> (f64, f64) {
    let radius = a.radius(i) + ROUNDING * a.center[i].abs();
    (sign * a.center[i] - radius, sign * a.center[i] + radius)
}

/// The smaller, or for sign −1 the larger, in the open lanes. Where d = a − b is in [l, h] around 0 it is b + min(d, 0), and
/// min(d, 0) is above its chord w·(d − h), w = −l/(h − l), by at most w·h: a mean of both forms, less half of that, give or take
/// as much. Marks the lanes where the hull has one sign, as roots want it, and this has not.
#[inline(always)]
fn mean<const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    sign: f64,
    open: &Mask<N>,
    out: &mut AffineLanes<N, S>,
) -> Mask<N> {
    let mut difference = *a;
    super::arithmetic::sub(a, b, &mut difference);
    let mut blunt = [0; N];
    let (mut mean, decided) = (difference, *out);
    for i in 0..N {
        let (low, high) = turned(&difference, i, sign);
        let w = -low / (high - low);
        let rest = 1.0 - w;
        let gap = 0.5 * (w * high);
        let error = rest * b.error[i] + w * a.error[i] + gap;
        let mut size = a.center[i].abs() + b.center[i].abs() + error;
        for k in 0..S {
            size += a.slope[k][i].abs() + b.slope[k][i].abs();
            mean.slope[k][i] = rest * b.slope[k][i] + w * a.slope[k][i];
        }
        mean.center[i] = rest * b.center[i] + w * a.center[i] - sign * gap;
        mean.error[i] = error + ROUNDING * size;
        let (most_a, most_b) = (turned(a, i, sign).1, turned(b, i, sign).1);
        let has_sign = (most_a <= 0.0) | (most_b <= 0.0);
        blunt[i] = open[i] & word(has_sign & !(turned(&mean, i, sign).1 <= 0.0));
    }
    pick(open, &mean, &decided, out);
    blunt
}

#[inline(always)]
pub(super) fn choose<L: Level, const N: usize, const S: usize>(
    c: &AffineLanes<N, S>,
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
) {
    let (mut first, mut open) = ([0; N], [0; N]);
    for i in 0..N {
        let (lo, hi) = c.bounds(i);
        first[i] = word(hi <= 0.0);
        open[i] = word(!((hi <= 0.0) | (lo > 0.0)));
    }
    pick(&first, a, b, out);
    for i in 0..N {
        let condition = c.flags[i] & PARTIAL;
        let chosen = if first[i] != 0 { a.flags[i] } else { b.flags[i] };
        out.flags[i] = chosen | condition | if condition != 0 { JUMP } else { 0 };
        open[i] |= word(c.flags[i] & NOWHERE != 0);
    }
    if any(&open) {
        repair!(open, out, choose::<L>(c, a, b));
    }
}
