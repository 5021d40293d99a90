//! Arithmetic of all lanes at once.
//!
//! In: arrays of bounds. Out: arrays of bounds, and the lanes that `interval` has to compute instead. Each bound is
//! rounded to nearest and pushed outward by the least part that reaches the next f64 (Rump, Zimmermann, Boldo and
//! Melquiond, BIT 49 (2009) 419). Separate because these loops must stay free of branches.

use super::{IntervalLanes, JUMP, PARTIAL};
use crate::num::func;
use crate::num::func::bound;
use crate::num::interval::Enclosure;
use crate::num::level::Level;
use crate::num::mask::{Mask, any, join, mark, word};

/// 2^-53·(1 + 2^-52): r ± this part of |r|, rounded to nearest, is the next f64 or the one after.
const STEP: f64 = f64::EPSILON * 0.5 * (1.0 + f64::EPSILON);

/// The smallest f64: what a product or a quotient may lose by underflow.
const SMALLEST: f64 = 5e-324;

/// Whole powers up to this one are plain products: their roundings cost less width than the exact way time.
const PLAIN_POWERS: u64 = 4;

#[inline(always)]
pub(super) fn down<L: Level>(r: f64) -> f64 {
    L::fma(-STEP, r.abs(), r)
}

#[inline(always)]
pub(super) fn up<L: Level>(r: f64) -> f64 {
    L::fma(STEP, r.abs(), r)
}

/// The smaller and the larger by one instruction; b where either is NaN.
#[inline(always)]
pub(super) fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
pub(super) fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

/// Computes the marked lanes again, one by one.
#[cold]
#[inline(never)]
pub(super) fn repair<const N: usize>(
    a: &IntervalLanes<N>,
    out: &mut IntervalLanes<N>,
    marked: &Mask<N>,
    f: impl Fn(Enclosure) -> Enclosure,
) {
    for i in 0..N {
        if marked[i] != 0 {
            out.set(i, f(a.get(i)));
        }
    }
}

/// Computes the marked lanes again, one by one.
#[cold]
#[inline(never)]
pub(super) fn repair_pairs<const N: usize>(
    a: &IntervalLanes<N>,
    b: &IntervalLanes<N>,
    out: &mut IntervalLanes<N>,
    marked: &Mask<N>,
    f: impl Fn(Enclosure, Enclosure) -> Enclosure,
) {
    for i in 0..N {
        if marked[i] != 0 {
            out.set(i, f(a.get(i), b.get(i)));
        }
    }
}

/// 0 − x, for flipping the sign bit becomes one whole number after the other.
#[inline(always)]
pub(super) fn neg<const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    for i in 0..N {
        (out.lo[i], out.hi[i]) = (0.0 - a.hi[i], 0.0 - a.lo[i]);
    }
    out.flags = a.flags;
}

/// The least and the largest |x|; NaN stays.
#[inline(always)]
fn sizes(lo: f64, hi: f64) -> (f64, f64) {
    (greater(0.0, greater(lo, -hi)), greater(-lo, hi))
}

#[inline(always)]
pub(super) fn abs<const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    for i in 0..N {
        (out.lo[i], out.hi[i]) = sizes(a.lo[i], a.hi[i]);
    }
    out.flags = a.flags;
}

#[inline(always)]
pub(super) fn add<L: Level, const N: usize>(a: &IntervalLanes<N>, b: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let (lo, hi) = (down::<L>(a.lo[i] + b.lo[i]), up::<L>(a.hi[i] + b.hi[i]));
        (out.lo[i], out.hi[i]) = (lo, hi);
        odd[i] = word(!(hi - lo < f64::INFINITY));
    }
    join(&a.flags, &b.flags, &mut out.flags);
    if any(&odd) {
        repair_pairs(a, b, out, &odd, Enclosure::plus);
    }
}

#[inline(always)]
pub(super) fn sub<L: Level, const N: usize>(a: &IntervalLanes<N>, b: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let (lo, hi) = (down::<L>(a.lo[i] - b.hi[i]), up::<L>(a.hi[i] - b.lo[i]));
        (out.lo[i], out.hi[i]) = (lo, hi);
        odd[i] = word(!(hi - lo < f64::INFINITY));
    }
    join(&a.flags, &b.flags, &mut out.flags);
    if any(&odd) {
        repair_pairs(a, b, out, &odd, Enclosure::minus);
    }
}

#[inline(always)]
pub(super) fn mul<L: Level, const N: usize>(a: &IntervalLanes<N>, b: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let (al, ah, bl, bh) = (a.lo[i], a.hi[i], b.lo[i], b.hi[i]);
        let (p, q, r, s) = (al * bl, al * bh, ah * bl, ah * bh);
        let least = lesser(lesser(p, q), lesser(r, s));
        let most = greater(greater(p, q), greater(r, s));
        (out.lo[i], out.hi[i]) = (down::<L>(least), up::<L>(most));
        let plain = (((p + s) + (q + r)).abs() < f64::INFINITY) & (lesser(least.abs(), most.abs()) >= TINY);
        odd[i] = word(!plain);
    }
    join(&a.flags, &b.flags, &mut out.flags);
    // A bound of 0 and one near underflow need more than a push outward; NaN and ∞ stay in the sum.
    if any(&odd) {
        mul_near_zero::<L, N>(a, b, out);
    }
}

/// [`mul`] where a product is 0, may have vanished, or is not finite.
#[inline(always)]
fn mul_near_zero<L: Level, const N: usize>(a: &IntervalLanes<N>, b: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let (al, ah, bl, bh) = (a.lo[i], a.hi[i], b.lo[i], b.hi[i]);
        let (p, q, r, s) = (al * bl, al * bh, ah * bl, ah * bh);
        let least = lesser(lesser(p, q), lesser(r, s));
        let most = greater(greater(p, q), greater(r, s));
        // Underflow may hide a sign, and must not move a bound that is exactly 0.
        let negative = ((al < 0.0) & (bh > 0.0)) | ((ah > 0.0) & (bl < 0.0));
        let positive = ((ah > 0.0) & (bh > 0.0)) | ((al < 0.0) & (bl < 0.0));
        let (lo, hi) = (down::<L>(least) - SMALLEST, up::<L>(most) + SMALLEST);
        out.lo[i] = if negative { lo } else { greater(lo, 0.0) };
        out.hi[i] = if positive { hi } else { lesser(hi, 0.0) };
        odd[i] = word(!(((p + s) + (q + r)).abs() < f64::INFINITY));
    }
    if any(&odd) {
        repair_pairs(a, b, out, &odd, Enclosure::times);
    }
}

#[inline(always)]
pub(super) fn div<L: Level, const N: usize>(a: &IntervalLanes<N>, b: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        // Both mirrored where the divisor is negative.
        let mirrored = b.hi[i] < 0.0;
        let (al, ah) = if mirrored { (-a.hi[i], -a.lo[i]) } else { (a.lo[i], a.hi[i]) };
        let (bl, bh) = if mirrored { (-b.hi[i], -b.lo[i]) } else { (b.lo[i], b.hi[i]) };
        let least = al / if al < 0.0 { bl } else { bh };
        let most = ah / if ah < 0.0 { bh } else { bl };
        let (lo, hi) = (down::<L>(least) - SMALLEST, up::<L>(most) + SMALLEST);
        let (lo, hi) = (if al < 0.0 { lo } else { greater(lo, 0.0) }, if ah > 0.0 { hi } else { lesser(hi, 0.0) });
        (out.lo[i], out.hi[i]) = (lo, hi);
        odd[i] = word(!((bl > 0.0) & (least.abs() < f64::INFINITY) & (most.abs() < f64::INFINITY)));
    }
    join(&a.flags, &b.flags, &mut out.flags);
    if any(&odd) {
        repair_pairs(a, b, out, &odd, Enclosure::over);
    }
}

#[inline(always)]
pub(super) fn sqrt<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let (mut odd, mut cut) = ([0; N], [0; N]);
    for i in 0..N {
        let (lo, hi) = (down::<L>(greater(a.lo[i], 0.0).sqrt()), up::<L>(a.hi[i].sqrt()));
        (out.lo[i], out.hi[i]) = (lo, hi);
        cut[i] = word(a.lo[i] < 0.0);
        odd[i] = word(!(hi < f64::INFINITY));
    }
    out.flags = a.flags;
    mark(&mut out.flags, &cut, PARTIAL | JUMP);
    if any(&odd) {
        repair(a, out, &odd, Enclosure::sqrt);
    }
}

#[inline(always)]
pub(super) fn square<L: Level, const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut odd = [0; N];
    for i in 0..N {
        let (least, most) = sizes(a.lo[i], a.hi[i]);
        let hi = up::<L>(most * most) + SMALLEST;
        out.lo[i] = greater(down::<L>(least * least) - SMALLEST, 0.0);
        out.hi[i] = if most == 0.0 { 0.0 } else { hi };
        odd[i] = word(!(hi < f64::INFINITY));
    }
    out.flags = a.flags;
    if any(&odd) {
        repair(a, out, &odd, Enclosure::square);
    }
}

#[inline(always)]
pub(super) fn floor<const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut jumps = [0; N];
    for i in 0..N {
        let (lo, hi) = (a.lo[i].floor(), a.hi[i].floor());
        (out.lo[i], out.hi[i]) = (lo, hi);
        jumps[i] = word(lo != hi);
    }
    out.flags = a.flags;
    mark(&mut out.flags, &jumps, JUMP);
}

#[inline(always)]
pub(super) fn floor_div<L: Level, const N: usize>(
    a: &IntervalLanes<N>,
    b: &IntervalLanes<N>,
    n: i64,
    out: &mut IntervalLanes<N>,
) {
    let n = n as f64;
    let (mut odd, mut jumps) = ([0; N], [0; N]);
    for i in 0..N {
        // Both mirrored where the divisor is negative.
        let mirrored = b.hi[i] < 0.0;
        let (al, ah) = if mirrored { (-a.hi[i], -a.lo[i]) } else { (a.lo[i], a.hi[i]) };
        let (bl, bh) = if mirrored { (-b.hi[i], -b.lo[i]) } else { (b.lo[i], b.hi[i]) };
        let lo = func::floor_div::<L>(n, al, if al < 0.0 { bl } else { bh });
        let hi = func::floor_div::<L>(n, ah, if ah < 0.0 { bh } else { bl });
        (out.lo[i], out.hi[i]) = (lo, hi);
        jumps[i] = word(lo != hi);
        odd[i] = word(!((bl > 0.0) & (lo.abs() < func::EXACT_WHOLE) & (hi.abs() < func::EXACT_WHOLE)));
    }
    join(&a.flags, &b.flags, &mut out.flags);
    mark(&mut out.flags, &jumps, JUMP);
    if any(&odd) {
        repair_pairs(a, b, out, &odd, |a, b| a.floor_over(n as i64, b));
    }
}

#[inline(always)]
pub(super) fn sign<const N: usize>(a: &IntervalLanes<N>, out: &mut IntervalLanes<N>) {
    let mut jumps = [0; N];
    for i in 0..N {
        let (lo, hi) = (func::sign(a.lo[i]), func::sign(a.hi[i]));
        (out.lo[i], out.hi[i]) = (lo, hi);
        jumps[i] = word(lo != hi);
    }
    out.flags = a.flags;
    mark(&mut out.flags, &jumps, JUMP);
}

/// a^n for small n > 0 by plain products, whose roundings widen the bounds; the rest one by one.
#[inline(always)]
pub(super) fn power<L: Level, const N: usize>(a: &IntervalLanes<N>, n: i64, out: &mut IntervalLanes<N>) {
    let even = n % 2 == 0;
    let plain = n.unsigned_abs() <= PLAIN_POWERS;
    let (mut least, mut most) = (a.lo, a.hi);
    if even {
        for i in 0..N {
            (least[i], most[i]) = sizes(a.lo[i], a.hi[i]);
        }
    }
    if n < 0 {
        (least, most) = (most, least);
    }
    let bases = (least, most);
    raise::<L, N>(&mut least, n, plain);
    raise::<L, N>(&mut most, n, plain);
    // Each of up to n roundings is half an ulp. Points raise to n > 0 by the same products, which rise with their
    // factors, and need no more; for n < 0 they are another way wrong.
    let roundings = 0.5 * n.unsigned_abs() as f64 + 0.1;
    let ulps = match (plain, n > 0) {
        (true, true) => roundings,
        (true, false) => roundings + bound::POWER,
        (false, _) => 2.0 * bound::POWER,
    };
    let part = ulps * f64::EPSILON;
    let mut odd = [0; N];
    for i in 0..N {
        let (lo, hi) = (least[i], most[i]);
        let vanished = word(((lo.abs() < TINY) & (bases.0[i] != 0.0)) | ((hi.abs() < TINY) & (bases.1[i] != 0.0)));
        (out.lo[i], out.hi[i]) = (L::fma(-part, lo.abs(), lo), L::fma(part, hi.abs(), hi));
        let crossing = word((n < 0) & (a.lo[i] <= 0.0) & (a.hi[i] >= 0.0));
        odd[i] = word(!((lo.abs() < f64::INFINITY) & (hi.abs() < f64::INFINITY))) | vanished | crossing;
    }
    out.flags = a.flags;
    if any(&odd) || n.unsigned_abs() > bound::MOST_POWER {
        if n.unsigned_abs() > bound::MOST_POWER {
            odd = [u64::MAX; N];
        }
        repair(a, out, &odd, |e| e.power(n));
    }
}

/// Results below this may have lost more than a rounding.
const TINY: f64 = 1e-290;

#[inline(always)]
fn raise<L: Level, const N: usize>(x: &mut [f64; N], n: i64, plain: bool) {
    if !plain {
        super::super::lanes::power_all::<L, N>(x, n);
        return;
    }
    for i in 0..N {
        let base = x[i];
        let value = match n.unsigned_abs() {
            1 => base,
            2 => base * base,
            3 => base * base * base,
            _ => (base * base) * (base * base),
        };
        x[i] = if n < 0 { 1.0 / value } else { value };
    }
}
