//! Operations that pick among affine forms.
//!
//! In: forms. Out: where the choice is decided over the whole cell, a copy of the chosen one; else the hull. Separate from
//! the arithmetic because the copies are exact, which is what makes forms of minima and maxima good.

use super::{AffineLanes, repair};
use crate::num::interval_lanes::{JUMP, NOWHERE, PARTIAL};
use crate::num::level::Level;
use crate::num::mask::{Mask, any, join, word};
use crate::num::number::Number;

/// a where the word is all ones, b where it is 0, flags excepted.
#[inline(always)]
fn pick<const N: usize, const S: usize>(mask: &Mask<N>, a: &AffineLanes<N, S>, b: &AffineLanes<N, S>, out: &mut AffineLanes<N, S>) {
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
pub(super) fn min<L: Level, const N: usize, const S: usize>(a: &AffineLanes<N, S>, b: &AffineLanes<N, S>, out: &mut AffineLanes<N, S>) {
    let open = smaller(a, b, out);
    if any(&open) {
        repair!(open, out, min::<L>(a, b));
    }
}

#[inline(always)]
pub(super) fn max<L: Level, const N: usize, const S: usize>(a: &AffineLanes<N, S>, b: &AffineLanes<N, S>, out: &mut AffineLanes<N, S>) {
    let (mut c, mut d) = (*a, *b);
    super::arithmetic::neg(a, &mut c);
    super::arithmetic::neg(b, &mut d);
    let mut smaller_one = *a;
    let open = smaller(&c, &d, &mut smaller_one);
    super::arithmetic::neg(&smaller_one, out);
    if any(&open) {
        repair!(open, out, max::<L>(a, b));
    }
}

/// The smaller of two forms where the difference has one sign; marks the other lanes.
#[inline(always)]
fn smaller<const N: usize, const S: usize>(a: &AffineLanes<N, S>, b: &AffineLanes<N, S>, out: &mut AffineLanes<N, S>) -> Mask<N> {
    let mut difference = *a;
    super::arithmetic::sub(a, b, &mut difference);
    let (mut first, mut open) = ([0; N], [0; N]);
    for i in 0..N {
        let (lo, hi) = difference.bounds(i);
        first[i] = word(hi <= 0.0);
        open[i] = word(!((hi <= 0.0) | (lo >= 0.0)));
    }
    pick(&first, a, b, out);
    join(&a.flags, &b.flags, &mut out.flags);
    open
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
