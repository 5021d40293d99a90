//! Operations that pick among enclosures, all lanes at once.
//!
//! In: arrays of bounds and flags. Out: the same, of the smaller, the larger or the chosen. Separate from
//! the arithmetic because nothing is rounded here and the flags are what needs care.

use super::arithmetic::{greater, lesser};
use super::{IntervalLanes, JUMP, NOWHERE, PARTIAL};
use crate::num::func;
use crate::num::interval::Enclosure;
use crate::num::mask::{join, pick, word};

#[inline(always)]
pub(super) fn min<const N: usize>(a: &IntervalLanes<N>, b: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    for i in 0..N {
        out.lo[i] = func::min(a.lo[i], b.lo[i]);
        out.hi[i] = func::min(a.hi[i], b.hi[i]);
    }
    join(&a.flags, &b.flags, &mut out.flags);
}

#[inline(always)]
pub(super) fn max<const N: usize>(a: &IntervalLanes<N>, b: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    for i in 0..N {
        out.lo[i] = func::max(a.lo[i], b.lo[i]);
        out.hi[i] = func::max(a.hi[i], b.hi[i]);
    }
    join(&a.flags, &b.flags, &mut out.flags);
}

/// a where c ≤ 0, else b; the hull of both where c leaves it open. Values are picked by masks, for a lane's own branch
/// would end the vector instructions.
#[inline(always)]
pub(super) fn choose<const N: usize>(
    c: &IntervalLanes<N>,
    a: &IntervalLanes<N>,
    b: &IntervalLanes<N>,
    out: &mut IntervalLanes<N>,
) {
    let (mut first, mut second) = ([0; N], [0; N]);
    for i in 0..N {
        let (one, two) = (word(c.hi[i] <= 0.0), word(c.lo[i] > 0.0));
        let lo = lesser(a.lo[i], b.lo[i]);
        let hi = greater(a.hi[i], b.hi[i]);
        out.lo[i] = pick(one, a.lo[i], pick(two, b.lo[i], lo));
        out.hi[i] = pick(one, a.hi[i], pick(two, b.hi[i], hi));
        (first[i], second[i]) = (one, two);
    }
    let mut nowhere = 0;
    for i in 0..N {
        let (one, two) = (first[i] as u8, second[i] as u8);
        // An open choice may jump, and has a value for certain only where everything has one.
        let open = !(one | two);
        // The branch of a decided choice may not continue where the condition is not defined, but a jump of the
        // condition elsewhere is none of the choice.
        let condition = c.flags[i] & PARTIAL;
        let flags = (a.flags[i] & (one | open)) | (b.flags[i] & (two | open)) | condition | condition << 1;
        out.flags[i] = flags | (open & JUMP);
        nowhere |= a.flags[i] | b.flags[i] | c.flags[i];
    }
    if nowhere & NOWHERE != 0 {
        choose_among_none(c, a, b, out);
    }
}

/// The lanes of [`choose`] where something has no value.
#[cold]
#[inline(never)]
fn choose_among_none<const N: usize>(
    c: &IntervalLanes<N>,
    a: &IntervalLanes<N>,
    b: &IntervalLanes<N>,
    out: &mut IntervalLanes<N>,
) {
    for i in 0..N {
        if (a.flags[i] | b.flags[i] | c.flags[i]) & NOWHERE != 0 {
            out.set(i, Enclosure::choose(c.get(i), a.get(i), b.get(i)));
        }
    }
}
