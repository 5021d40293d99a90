//! How near the rays of a batch are to their roots: proven.
//!
//! In: a batch whose rays stand where Newton's method ended, or where they end themselves. Out: for each what is proven. A ball around g says
//! enough of nearly all; the others are enclosed by intervals.

use super::{Stream, Tools, part};
use crate::num::interval_lanes::PARTIAL;
use crate::num::level::{Level, for_each_level};

use crate::surface::isolate::{PER_DISTANCE, PER_ORIGIN, place};
use crate::surface::refine::WIDTH;
use crate::surface::sheet::{Balls, CELLS, POINTS};
use crate::surface::spans::{LENGTHENED, SHORTENED};

/// What g is at least and at most where each ray stands, and whether that is worth anything.
#[derive(Debug)]
struct Known {
    lo: [f64; POINTS],
    hi: [f64; POINTS],
    is_whole: [bool; POINTS],
}

/// What that says of each ray.
#[derive(Debug)]
pub(super) struct Certified {
    /// How far the root can be; NaN if that could not be told.
    pub(super) width: [f64; POINTS],
    /// Whether the ray reaches its root.
    pub(super) is_hit: [bool; POINTS],
    /// Whether the root is beyond the ray's end or beginning, which was asked.
    pub(super) is_beyond: [bool; POINTS],
}

/// What is proven of the first rays of a batch.
pub(super) fn certify(stream: &Stream, tools: &mut Tools, count: usize) -> Certified {
    let [origin, direction] = [&stream.origin, &stream.direction].map(|all| all.each_ref().map(|one| part(one, 0)));
    balls_at(tools.simd, origin, direction, part(&stream.t, 0), tools.balls);
    tools.formula.ball().run(tools.balls);
    tools.enclosures += count as u64;
    let mut known = Known { lo: [0.0; POINTS], hi: [0.0; POINTS], is_whole: [true; POINTS] };
    let all = u64::MAX >> (POINTS - count);
    let unclear = all & bound(tools.simd, stream, tools.size, tools.formula.ball().output(tools.balls, 0), &mut known);
    for first in (0..count).step_by(CELLS).filter(|first| unclear >> first & ((1 << CELLS) - 1) != 0) {
        enclose(stream, tools, first, unclear >> first, &mut known);
    }
    let mut certified = Certified { width: [0.0; POINTS], is_hit: [false; POINTS], is_beyond: [false; POINTS] };
    judge(tools.simd, stream, tools.size, &known, &mut certified);
    certified
}

/// Encloses g by intervals where some rays stand, of which a mask says for which that is needed.
#[cold]
fn enclose(stream: &Stream, tools: &mut Tools, first: usize, unclear: u64, known: &mut Known) {
    let [origin, direction] = [&stream.origin, &stream.direction].map(|all| all.each_ref().map(|one| part(one, first)));
    let t = part(&stream.t, first);
    place(tools.simd, origin, direction, t, t, tools.cells);
    tools.formula.value().run(tools.cells);
    tools.enclosures += CELLS as u64;
    let g = tools.formula.value().output(tools.cells, 0);
    for lane in (0..CELLS).filter(|lane| unclear >> lane & 1 != 0) {
        let i = first + lane;
        (known.lo[i], known.hi[i], known.is_whole[i]) = (g.lo[lane], g.hi[lane], g.flags[lane] & PARTIAL == 0);
    }
}

for_each_level! {
    /// Puts balls around the points at distance t on each ray into the registers of the coordinates: see [`place`].
    fn balls_at[L](
        origin: [&[f64; POINTS]; 3], direction: [&[f64; POINTS]; 3], t: &[f64; POINTS], balls: &mut [Balls],
    ) {
        for axis in 0..3 {
            let (o, d) = (origin[axis], direction[axis]);
            let ball = &mut balls[axis];
            for i in 0..POINTS {
                ball.center.0[i] = L::fma(t[i], d[i], o[i]);
                let radius = L::fma(t[i], PER_DISTANCE, o[i].abs() * PER_ORIGIN);
                ball.radius.0[i] = if t[i] > 0.0 { radius } else { 0.0 };
            }
        }
    }
}

for_each_level! {
    /// The bounds of g by its balls. Says, a bit each, for which rays that is too little. There is a value: g is defined all along each
    /// ray's bracket.
    fn bound[L](stream: &Stream, size: f64, g: &Balls, known: &mut Known) -> u64 {
        let mut unclear = 0;
        let (t, steepness): (&[f64; POINTS], &[f64; POINTS]) = (part(&stream.t, 0), part(&stream.steepness, 0));
        for i in 0..POINTS {
            let (center, radius) = (g.center.0[i], g.radius.0[i]);
            let scale = if t[i] > size { t[i] } else { size };
            let is_narrow = radius <= 0.5 * WIDTH * scale * steepness[i];
            // Room for one more rounding each.
            let radius = L::fma(center.abs(), f64::EPSILON, radius);
            known.lo[i] = center - radius;
            known.hi[i] = center + radius;
            unclear |= u64::from(!is_narrow) << i;
        }
        unclear
    }
}

for_each_level! {
    /// Judges the rays by what is known of g where each stands.
    fn judge[L](stream: &Stream, size: f64, g: &Known, certified: &mut Certified) {
        let [t, near, far, beyond]: [&[f64; POINTS]; 4] =
            [&stream.t, &stream.near, &stream.far, &stream.beyond].map(|column| part(column, 0));
        let [moved, steepness, front]: [&[f64; POINTS]; 3] =
            [&stream.moved, &stream.steepness, &stream.front].map(|column| part(column, 0));
        let [a, b]: [&[f64; POINTS]; 2] = [&stream.a, &stream.b].map(|column| part(column, 0));
        for i in 0..POINTS {
            // The bracket was taken wider than what the slope is known of, and what is left out may be a jump.
            let is_inside = (t[i] > a[i] * LENGTHENED) & (t[i] < b[i] * SHORTENED);
            let off = g.hi[i].max(-g.lo[i]) / steepness[i];
            let width = WIDTH * if t[i] > size { t[i] } else { size };
            let known = g.is_whole[i] & is_inside & (off <= width) & (moved[i] == 0.0);
            let sign = if g.lo[i] > 0.0 { 1.0 } else { 0.0 } - if g.hi[i] < 0.0 { 1.0 } else { 0.0 };
            certified.width[i] = if known { width } else { f64::NAN };
            certified.is_hit[i] = known & (beyond[i] == 0.0) & (t[i] >= near[i]) & (t[i] <= far[i]);
            certified.is_beyond[i] = g.is_whole[i] & (sign == front[i] * beyond[i]);
        }
    }
}
