//! Sums and products of affine forms.
//!
//! In: forms. Out: forms; every error grows by [`ROUNDING`] of all magnitudes in play, which covers the roundings of
//! the operation many times over: cells are told apart long before that matters. Separate because these loops
//! must stay free of branches, and of calls that are not
//! compiled for the same instructions, such as that of a map over an array.

use super::{AffineLanes, ROUNDING, SYMBOLS, TINY};
use crate::num::mask::join;

#[inline(always)]
pub(super) fn neg<const N: usize>(a: &AffineLanes<N>, out: &mut AffineLanes<N>) {
    for i in 0..N {
        out.center[i] = 0.0 - a.center[i];
    }
    for k in 0..SYMBOLS {
        for i in 0..N {
            out.slope[k][i] = 0.0 - a.slope[k][i];
        }
    }
    out.error = a.error;
    out.flags = a.flags;
}

/// The sum or the difference, by what joins two numbers.
#[inline(always)]
fn linear<const N: usize>(
    a: &AffineLanes<N>,
    b: &AffineLanes<N>,
    out: &mut AffineLanes<N>,
    f: impl Fn(f64, f64) -> f64,
) {
    for i in 0..N {
        let c = f(a.center[i], b.center[i]);
        let (x, y) = (f(a.slope[0][i], b.slope[0][i]), f(a.slope[1][i], b.slope[1][i]));
        let z = f(a.slope[2][i], b.slope[2][i]);
        let error = a.error[i] + b.error[i];
        let size = (c.abs() + x.abs()) + (y.abs() + z.abs()) + error;
        out.center[i] = c;
        (out.slope[0][i], out.slope[1][i], out.slope[2][i]) = (x, y, z);
        out.error[i] = error + ROUNDING * size;
    }
    join(&a.flags, &b.flags, &mut out.flags);
}

#[inline(always)]
pub(super) fn add<const N: usize>(a: &AffineLanes<N>, b: &AffineLanes<N>, out: &mut AffineLanes<N>) {
    linear(a, b, out, |a, b| a + b);
}

#[inline(always)]
pub(super) fn sub<const N: usize>(a: &AffineLanes<N>, b: &AffineLanes<N>, out: &mut AffineLanes<N>) {
    linear(a, b, out, |a, b| a - b);
}

/// The product: of the two linear parts, ε² is between 0 and 1 and εᵢεⱼ between −1 and 1.
#[inline(always)]
pub(super) fn mul<const N: usize>(a: &AffineLanes<N>, b: &AffineLanes<N>, out: &mut AffineLanes<N>) {
    for i in 0..N {
        let (c, d) = (a.center[i], b.center[i]);
        let (x, y, z) = (a.slope[0][i], a.slope[1][i], a.slope[2][i]);
        let (u, v, w) = (b.slope[0][i], b.slope[1][i], b.slope[2][i]);
        let (e, f) = (a.error[i], b.error[i]);
        let (xu, yv, zw) = (x * u, y * v, z * w);
        let squares = 0.5 * (xu + yv + zw);
        let spread = 0.5 * ((xu.abs() + yv.abs()) + zw.abs());
        let mixed = (x * v + y * u).abs() + ((x * w + z * u).abs() + (y * w + z * v).abs());
        let size = (c.abs() + x.abs()) + (y.abs() + z.abs());
        let other = (d.abs() + u.abs()) + (v.abs() + w.abs());
        let doubt = size * f + (other + f) * e;
        let all = (size + e) * (other + f);
        out.center[i] = c * d + squares;
        out.slope[0][i] = c * u + d * x;
        out.slope[1][i] = c * v + d * y;
        out.slope[2][i] = c * w + d * z;
        out.error[i] = (spread + mixed) + (doubt + (ROUNDING * all + TINY));
    }
    join(&a.flags, &b.flags, &mut out.flags);
}

/// The square: [`mul`] of equals.
#[inline(always)]
pub(super) fn square<const N: usize>(a: &AffineLanes<N>, out: &mut AffineLanes<N>) {
    for i in 0..N {
        let c = a.center[i];
        let (x, y, z) = (a.slope[0][i], a.slope[1][i], a.slope[2][i]);
        let e = a.error[i];
        let squares = 0.5 * ((x * x + y * y) + z * z);
        let mixed = 2.0 * ((x * y).abs() + ((x * z).abs() + (y * z).abs()));
        let size = (c.abs() + x.abs()) + (y.abs() + z.abs());
        let all = size + e;
        out.center[i] = c * c + squares;
        out.slope[0][i] = 2.0 * c * x;
        out.slope[1][i] = 2.0 * c * y;
        out.slope[2][i] = 2.0 * c * z;
        out.error[i] = (squares + mixed) + ((size + all) * e + (ROUNDING * (all * all) + TINY));
    }
    out.flags = a.flags;
}
