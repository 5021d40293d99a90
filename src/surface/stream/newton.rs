//! Newton's method and what follows it, for all rays of a batch at once.
//!
//! In: a batch, and g with its gradient where its rays stand. Out: the rays moved, and in the end their normals. Separate because these loops
//! must stay free of branches, and of calls that are not compiled for the same instructions.

use super::Stream;
use crate::num::level::{Level, for_each_level};
use crate::surface::sheet::POINTS;

/// A step not longer than this part of the scale is the last: the next is its square.
const CONVERGED: f64 = 2e-6;

/// How much shorter the only step must be, for the normal is that of its beginning.
const ALONE: f64 = 20.0;

/// A step by two points is the last where the term of highest order is not longer than this part of the scale: the terms that
/// are missing are smaller still.
const LAST_TERM: f64 = 1e-10;

/// What that step and the one before may come to, multiplied, as a part of the scale's square: so much a gradient
/// that is carried on in a straight line is off.
const STRAIGHT: f64 = 2e-7;

for_each_level! {
    /// Makes the first rays ready to step, and says how many of them have to.
    pub(super) fn begin[L](stream: &mut Stream, size: f64, count: usize) -> u64 {
        let mut live = 0;
        for i in 0..POINTS {
            let t = stream.t[i];
            stream.scale[i] = if t > size { t } else { size };
            let is_live = (i < count) & (stream.beyond[i] == 0.0);
            stream.moved[i] = if is_live { 1.0 } else { 0.0 };
            live += u64::from(is_live);
        }
        live
    }
}

for_each_level! {
    /// The first step in all rays, of which it says how many are left: Newton's, bent by what the second derivative is about. The gradient is that of where it began.
    pub(super) fn first_step[L](stream: &mut Stream, g: &[f64; POINTS], gradient: [&[f64; POINTS]; 3]) -> u64 {
        let mut left = 0;
        for i in 0..POINTS {
            let live = stream.moved[i] > 0.0;
            let (t, scale) = (stream.t[i], stream.scale[i]);
            let inverse = 1.0 / slope::<L>(stream, gradient, i);
            let newton = -g[i] * inverse;
            let bend = -0.5 * stream.curvature[i] * inverse * newton * newton;
            let next = t + newton + if bend.abs() < 0.5 * newton.abs() { bend } else { 0.0 };
            let next = if next > stream.a[i] { next } else { stream.a[i] };
            let next = if next < stream.b[i] { next } else { stream.b[i] };
            let stride = next - t;
            for k in 0..3 {
                stream.here[k][i] = gradient[k][i];
                stream.gradient[k][i] = gradient[k][i];
            }
            // Nothing is known of how the gradient changes after one step alone, which must be the shorter.
            let done = ALONE * stride.abs() <= CONVERGED * scale;
            stream.t[i] = if live { next } else { t };
            stream.stride[i] = stride;
            stream.value[i] = g[i];
            stream.inverse[i] = inverse;
            let moved = if live & !done { stride.abs() } else { 0.0 };
            stream.moved[i] = moved;
            left += u64::from(moved > 0.0);
        }
        left
    }
}

for_each_level! {
    /// A further step in all rays that are not done, of which it says how many are left: by the cubic in g that has values and slopes
    /// of t(g) at the last two points (inverse Hermite interpolation; Traub, Iterative Methods for the Solution of
    /// Equations, 1964, chapter 4). The gradient is carried on to where the step leads by what it changed over the step before.
    pub(super) fn step[L](stream: &mut Stream, g: &[f64; POINTS], gradient: [&[f64; POINTS]; 3]) -> u64 {
        let mut left = 0;
        for i in 0..POINTS {
            let live = stream.moved[i] > 0.0;
            let (t, scale, before) = (stream.t[i], stream.scale[i], stream.stride[i]);
            let inverse = 1.0 / slope::<L>(stream, gradient, i);
            let newton = -g[i] * inverse;
            // Newton's divided differences at g, g, g before, g before.
            let span = 1.0 / (stream.value[i] - g[i]);
            let chord = -before * span;
            let second = (chord - inverse) * span;
            let third = ((stream.inverse[i] - chord) * span - second) * span;
            let square = g[i] * g[i];
            let last = third * square * stream.value[i];
            let bend = L::fma(second, square, -last);
            let cubic = bend.abs() < 0.5 * newton.abs();
            let next = t + newton + if cubic { bend } else { 0.0 };
            let next = if next > stream.a[i] { next } else { stream.a[i] };
            let next = if next < stream.b[i] { next } else { stream.b[i] };
            let stride = next - t;
            let ahead = stride / before;
            let ahead = if ahead.abs() < 1.0 { ahead } else { 0.0 };
            for k in 0..3 {
                let here = gradient[k][i];
                let carried = L::fma(here - stream.here[k][i], ahead, here);
                stream.gradient[k][i] = if live { carried } else { stream.gradient[k][i] };
                stream.here[k][i] = here;
            }
            let straight = (stride * before).abs() <= STRAIGHT * scale * scale;
            let done = (stride.abs() <= CONVERGED * scale) | (cubic & straight & (last.abs() <= LAST_TERM * scale));
            stream.t[i] = if live { next } else { t };
            stream.stride[i] = stride;
            stream.value[i] = g[i];
            stream.inverse[i] = inverse;
            let moved = if live & !done { stride.abs() } else { 0.0 };
            stream.moved[i] = moved;
            left += u64::from(moved > 0.0);
        }
        left
    }
}

/// The derivative of g along ray i.
#[inline(always)]
fn slope<L: Level>(stream: &Stream, [x, y, z]: [&[f64; POINTS]; 3], i: usize) -> f64 {
    let [dx, dy, dz] = &stream.direction;
    L::fma(x[i], dx[i], L::fma(y[i], dy[i], z[i] * dz[i]))
}

for_each_level! {
    /// Gradients become normals that face where the rays come from.
    pub(super) fn face[L](stream: &mut Stream) {
        for i in 0..POINTS {
            let (x, y, z) = (stream.gradient[0][i], stream.gradient[1][i], stream.gradient[2][i]);
            let (dx, dy, dz) = (stream.direction[0][i], stream.direction[1][i], stream.direction[2][i]);
            let along = L::fma(x, dx, L::fma(y, dy, z * dz));
            let length = L::fma(x, x, L::fma(y, y, z * z)).sqrt();
            let size = if length < f64::INFINITY { 1.0 / length } else { f64::NAN };
            let scale = if along > 0.0 { -size } else { size };
            stream.flipped[i] = along;
            (stream.gradient[0][i], stream.gradient[1][i], stream.gradient[2][i]) = (x * scale, y * scale, z * scale);
        }
    }
}
