//! Sums and products of affine forms.
//!
//! In: forms. Out: forms; every error grows by [`ROUNDING`] of all magnitudes in play, which covers the roundings of
//! the operation many times over: cells are told apart long before that matters. Separate because these loops
//! must stay free of branches, and of calls that are not
//! compiled for the same instructions, such as that of a map over an array.

use super::{AffineLanes, ROUNDING, TINY};
use crate::num::mask::join;

#[inline(always)]
pub(super) fn neg<const N: usize, const S: usize>(a: &AffineLanes<N, S>, out: &mut AffineLanes<N, S>) {
    for i in 0..N {
        out.center[i] = 0.0 - a.center[i];
    }
    for k in 0..S {
        for i in 0..N {
            out.slope[k][i] = 0.0 - a.slope[k][i];
        }
    }
    out.error = a.error;
    out.flags = a.flags;
}

/// The sum or the difference, by what joins two numbers.
#[inline(always)]
fn linear<const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
    f: impl Fn(f64, f64) -> f64,
) {
    for i in 0..N {
        let c = f(a.center[i], b.center[i]);
        let error = a.error[i] + b.error[i];
        let mut size = c.abs() + error;
        for k in 0..S {
            let slope = f(a.slope[k][i], b.slope[k][i]);
            size += slope.abs();
            out.slope[k][i] = slope;
        }
        out.center[i] = c;
        out.error[i] = error + ROUNDING * size;
    }
    join(&a.flags, &b.flags, &mut out.flags);
}

#[inline(always)]
pub(super) fn add<const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
) {
    linear(a, b, out, |a, b| a + b);
}

#[inline(always)]
pub(super) fn sub<const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
) {
    linear(a, b, out, |a, b| a - b);
}

/// The product: of the two linear parts, ε² is between 0 and 1 and εᵢεⱼ between −1 and 1.
#[inline(always)]
pub(super) fn mul<const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
) {
    for i in 0..N {
        let (c, d) = (a.center[i], b.center[i]);
        let (e, f) = (a.error[i], b.error[i]);
        let (mut squares, mut spread, mut mixed) = (0.0, 0.0, 0.0);
        let (mut size, mut other) = (c.abs(), d.abs());
        for k in 0..S {
            let (x, u) = (a.slope[k][i], b.slope[k][i]);
            squares += x * u;
            spread += (x * u).abs();
            size += x.abs();
            other += u.abs();
            for l in 0..k {
                mixed += (x * b.slope[l][i] + a.slope[l][i] * u).abs();
            }
            out.slope[k][i] = c * u + d * x;
        }
        let doubt = size * f + (other + f) * e;
        let all = (size + e) * (other + f);
        out.center[i] = c * d + 0.5 * squares;
        out.error[i] = (0.5 * spread + mixed) + (doubt + (ROUNDING * all + TINY));
    }
    join(&a.flags, &b.flags, &mut out.flags);
}

/// The square: [`mul`] of equals.
#[inline(always)]
pub(super) fn square<const N: usize, const S: usize>(a: &AffineLanes<N, S>, out: &mut AffineLanes<N, S>) {
    for i in 0..N {
        let (c, e) = (a.center[i], a.error[i]);
        let (mut squares, mut mixed, mut size) = (0.0, 0.0, c.abs());
        for k in 0..S {
            let x = a.slope[k][i];
            squares += x * x;
            size += x.abs();
            for l in 0..k {
                mixed += (x * a.slope[l][i]).abs();
            }
            out.slope[k][i] = 2.0 * c * x;
        }
        let all = size + e;
        out.center[i] = c * c + 0.5 * squares;
        out.error[i] = (0.5 * squares + 2.0 * mixed) + ((size + all) * e + (ROUNDING * (all * all) + TINY));
    }
    out.flags = a.flags;
}
