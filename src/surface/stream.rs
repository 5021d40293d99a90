//! The roots of whole squares: Newton's method for 64 rays at once, and one enclosure to certify each.
//!
//! In: rays with a bracket in which g has exactly one root and its slope along the ray is at least so steep. Out: roots. A point
//! t of the bracket is within |g(t)| / steepness of the root (mean value theorem), so that an enclosure of g at t alone
//! proves how near it is: a ball, or where that says too little an interval. Separate from [`super::refine`], which knows less of its brackets and must look at both sides.

use super::bundle::{BEYOND, Bundle, LENGTHENED, PLACES, SHORTENED, Spans};
use super::isolate::{PER_DISTANCE, PER_ORIGIN, place};
use super::kernels::Formula;
use super::refine::{WIDTH, points_at};
use super::sheet::{Balls, CELLS, Cells, POINTS, Points};
use super::tile::Crossing;
use crate::num::interval_lanes::PARTIAL;
use crate::num::level::{Level, Simd, for_each_level};

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

/// Steps after which the rest is left to single rays.
const MOST_STEPS: usize = 5;

/// Rays are taken so many at once, those that are not looked at and those beyond the last too.
const LANES: usize = BEYOND;

/// Room for a batch and for what is taken beyond its end.
const ROOM: usize = POINTS + LANES;

/// A number of each ray.
type Column = [f64; ROOM];

/// Who is told what became of the rays, each by its place in the bundle.
pub(crate) trait Sink {
    /// Where each ray of the bundle begins and ends.
    fn spans(&self) -> &Spans;

    /// The ray has a root at t, proven to be within `width` of it, where the unit gradient of g, turned against the ray, is `normal`.
    fn hit(&mut self, place: usize, cost: u32, t: f64, width: f64, normal: [f64; 3], flipped: bool);

    /// The ray has none in its part of the bracket, or none is proven.
    fn other(&mut self, place: usize, cost: u32, bracket: (f64, f64), end: End);
}

/// What became of a ray that has no proven root between its beginning and its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// The root is in front of the ray's beginning.
    Before,
    /// The root is behind the ray's end.
    Behind,
    /// It could not be told where it is.
    Unknown,
}

/// Rays waiting to be a batch, a number of each in an array.
#[derive(Debug)]
pub(crate) struct Stream {
    count: usize,
    place: [u32; ROOM],
    cost: [u32; ROOM],
    origin: [Column; 3],
    direction: [Column; 3],
    near: Column,
    far: Column,
    a: Column,
    b: Column,
    t: Column,
    steepness: Column,
    /// The sign of g in front of the root.
    front: Column,
    /// Whether t is not where the root may be, but the ray's end, which is likely in front of it (1), or its beginning (−1).
    beyond: Column,
    /// What the second derivative of g along the ray is about.
    curvature: Column,
    /// The last step's length, 0 for a ray that is done, 1 before the first.
    moved: Column,
    /// What tolerances are parts of.
    scale: Column,
    /// The last step, and where it began: g, its inverse slope along the ray, and its gradient.
    stride: Column,
    value: Column,
    inverse: Column,
    here: [Column; 3],
    /// The gradient where it ended: at first as computed, then carried on.
    gradient: [Column; 3],
    flipped: Column,
}

impl Default for Stream {
    fn default() -> Self {
        let zero = [0.0; ROOM];
        Stream {
            count: 0,
            place: [0; ROOM],
            cost: [0; ROOM],
            origin: [zero; 3],
            direction: [zero; 3],
            near: zero,
            far: zero,
            a: zero,
            b: zero,
            t: zero,
            steepness: zero,
            front: zero,
            beyond: zero,
            curvature: zero,
            moved: zero,
            scale: zero,
            stride: zero,
            value: zero,
            inverse: zero,
            here: [zero; 3],
            gradient: [zero; 3],
            flipped: zero,
        }
    }
}

/// What a stream computes with.
pub(crate) struct Tools<'a> {
    pub(crate) formula: Formula<'a>,
    /// Registers of the sheet's gradient at points, and of its values around points and over pieces of rays.
    pub(crate) gradient: &'a mut [Points],
    pub(crate) balls: &'a mut [Balls],
    pub(crate) cells: &'a mut [Cells],
    /// The length that tolerances are measured by.
    pub(crate) size: f64,
    pub(crate) simd: Simd,
    /// Evaluations so far.
    pub(crate) evaluations: u64,
    /// Enclosures so far.
    pub(crate) enclosures: u64,
}

/// What g is at least and at most where each ray stands, and whether that is worth anything.
#[derive(Debug)]
struct Known {
    lo: [f64; POINTS],
    hi: [f64; POINTS],
    is_whole: [bool; POINTS],
}

/// What that says of each ray.
#[derive(Debug)]
struct Certified {
    /// How far the root can be; NaN if that could not be told.
    width: [f64; POINTS],
    /// Whether the ray reaches its root.
    is_hit: [bool; POINTS],
    /// Whether the root is beyond the ray's end or beginning, which was asked.
    is_beyond: [bool; POINTS],
}

/// N numbers of a column from some place on.
#[inline(always)]
fn part<const N: usize>(column: &[f64], first: usize) -> &[f64; N] {
    column[first..].first_chunk().expect("columns are longer than what is looked at by a vector")
}

impl Stream {
    /// Takes the rays of a crossing, but for those that end before it.
    pub(crate) fn take(&mut self, crossing: &Crossing, bundle: &Bundle, tools: &mut Tools, sink: &mut impl Sink) {
        let mut taken = 0;
        while taken < crossing.place.count() {
            taken = take(tools.simd, self, crossing, bundle, sink.spans(), taken);
            if self.count + LANES > POINTS {
                self.run(tools, sink);
            }
        }
    }

    /// Finds the roots of all rays that wait.
    fn run(&mut self, tools: &mut Tools, sink: &mut impl Sink) {
        let count = std::mem::take(&mut self.count);
        let mut live = begin(tools.simd, self, tools.size, count);
        for number in 0..MOST_STEPS {
            if live == 0 {
                break;
            }
            let [origin, direction] = [&self.origin, &self.direction].map(|all| all.each_ref().map(|one| part(one, 0)));
            points_at(tools.simd, origin, direction, part(&self.t, 0), tools.gradient);
            tools.formula.gradient().run(tools.gradient);
            tools.evaluations += live;
            let [g, x, y, z] = [0, 1, 2, 3].map(|k| &tools.formula.gradient().output(tools.gradient, k).0);
            let take_step = if number == 0 { first_step } else { step };
            live = take_step(tools.simd, self, g, [x, y, z]);
        }
        face(tools.simd, self);
        self.certify(tools, count, sink);
    }

    /// Finds the roots of all rays that wait, and of those that wait once more.
    pub(crate) fn finish(&mut self, tools: &mut Tools, sink: &mut impl Sink) {
        while self.count > 0 {
            self.run(tools, sink);
        }
    }

    /// Encloses g where Newton's method ended, or where the ray does. Rays that were wrongly thought to end before their root wait again.
    fn certify(&mut self, tools: &mut Tools, count: usize, sink: &mut impl Sink) {
        let [origin, direction] = [&self.origin, &self.direction].map(|all| all.each_ref().map(|one| part(one, 0)));
        balls_at(tools.simd, origin, direction, part(&self.t, 0), tools.balls);
        tools.formula.ball().run(tools.balls);
        tools.enclosures += count as u64;
        let mut known = Known { lo: [0.0; POINTS], hi: [0.0; POINTS], is_whole: [true; POINTS] };
        let all = u64::MAX >> (POINTS - count);
        let unclear =
            all & bound(tools.simd, self, tools.size, tools.formula.ball().output(tools.balls, 0), &mut known);
        for first in (0..count).step_by(CELLS).filter(|first| unclear >> first & ((1 << CELLS) - 1) != 0) {
            self.enclose(tools, first, unclear >> first, &mut known);
        }
        let mut certified = Certified { width: [0.0; POINTS], is_hit: [false; POINTS], is_beyond: [false; POINTS] };
        judge(tools.simd, self, tools.size, &known, &mut certified);
        for i in 0..count {
            let (place, cost) = (self.place[i] as usize, self.cost[i]);
            if certified.is_hit[i] {
                let [x, y, z] = &self.gradient;
                sink.hit(place, cost, self.t[i], certified.width[i], [x[i], y[i], z[i]], self.flipped[i] > 0.0);
            } else {
                self.other(i, &certified, sink);
            }
        }
    }

    /// Encloses g by intervals where some rays stand, of which a mask says for which that is needed.
    #[cold]
    fn enclose(&mut self, tools: &mut Tools, first: usize, unclear: u64, known: &mut Known) {
        let [origin, direction] = [&self.origin, &self.direction].map(|all| all.each_ref().map(|one| part(one, first)));
        let t = part(&self.t, first);
        place(tools.simd, origin, direction, t, t, tools.cells);
        tools.formula.value().run(tools.cells);
        tools.enclosures += CELLS as u64;
        let g = tools.formula.value().output(tools.cells, 0);
        for lane in (0..CELLS).filter(|lane| unclear >> lane & 1 != 0) {
            let i = first + lane;
            (known.lo[i], known.hi[i], known.is_whole[i]) = (g.lo[lane], g.hi[lane], g.flags[lane] & PARTIAL == 0);
        }
    }

    /// Files ray i, which has no proven root between its ends.
    #[cold]
    fn other(&mut self, i: usize, certified: &Certified, sink: &mut impl Sink) {
        let is_before = if self.beyond[i] == 0.0 { self.t[i] < self.near[i] } else { self.beyond[i] < 0.0 };
        let end = if self.beyond[i] != 0.0 && !certified.is_beyond[i] {
            self.wait_again(i);
            return;
        } else if self.beyond[i] == 0.0 && certified.width[i].is_nan() {
            End::Unknown
        } else if is_before {
            End::Before
        } else {
            End::Behind
        };
        sink.other(self.place[i] as usize, self.cost[i], (self.a[i], self.b[i]), end);
    }

    /// Lets ray i wait once more. Those that wait are before it, for it was taken out of as many places as it stands behind.
    fn wait_again(&mut self, i: usize) {
        self.copy(i, self.count);
        self.beyond[self.count] = 0.0;
        self.count += 1;
    }

    /// Moves those of the rays behind all that wait which are not gone to the front, and says how many they are.
    #[cold]
    fn pack(&mut self, is_gone: &[u64]) -> usize {
        let mut kept = 0;
        for i in (0..is_gone.len()).filter(|&i| is_gone[i] == 0) {
            self.copy(self.count + i, self.count + kept);
            kept += 1;
        }
        kept
    }

    /// Writes what was taken of one ray over another.
    fn copy(&mut self, from: usize, to: usize) {
        (self.place[to], self.cost[to]) = (self.place[from], self.cost[from]);
        let Stream { near, far, a, b, t, steepness, front, beyond, curvature, origin, direction, .. } = self;
        let columns = [near, far, a, b, t, steepness, front, beyond, curvature];
        for all in columns.into_iter().chain(origin).chain(direction) {
            all[to] = all[from];
        }
    }
}

for_each_level! {
    /// Takes rays of a crossing from some of them on, as many as there is room for, and guesses where their roots are. Says how many have been looked at.
    fn take[L](stream: &mut Stream, crossing: &Crossing, bundle: &Bundle, spans: &Spans, from: usize) -> usize {
        let (first, count) = (crossing.place.first, crossing.place.count());
        let middle = 0.5 * f64::from(crossing.place.side - 1);
        let [depth, across, down] = crossing.depth;
        let mut taken = from;
        while taken < count && stream.count + LANES <= POINTS {
            let (rays, to) = (first + taken, stream.count);
            let [columns, rows]: [&[f64; LANES]; 2] = [part(&PLACES[0], taken), part(&PLACES[1], taken)];
            let [length, near, far]: [&[f64; LANES]; 3] =
                [part(&bundle.length, rays), part(&spans.near, rays), part(&spans.far, rays)];
            let lanes = LANES.min(count - taken);
            let (mut is_gone, zero) = ([0u64; LANES], [0.0; LANES]);
            let (mut a, mut b, mut t, mut beyond) = (zero, zero, zero, zero);
            let (mut steepness, mut curvature) = (zero, zero);
            for i in 0..LANES {
                let long = length[i];
                let per_length = 1.0 / long;
                (a[i], b[i]) = (crossing.a * long * SHORTENED, crossing.b * long * LENGTHENED);
                let likely = (depth + across * (columns[i] - middle) + down * (rows[i] - middle)) * long;
                let inside = (likely > a[i]) & (likely < b[i]);
                let likely = if inside { likely } else { 0.5 * (a[i] + b[i]) };
                let behind = likely > far[i];
                let limit = if behind { far[i] } else { near[i] };
                let is_beyond = (behind | (likely < near[i])) & (limit > a[i] * LENGTHENED) & (limit < b[i] * SHORTENED);
                let side = if behind { 1.0 } else { -1.0 };
                t[i] = if is_beyond { limit } else { likely };
                beyond[i] = if is_beyond { side } else { 0.0 };
                steepness[i] = crossing.steepness * per_length * SHORTENED;
                curvature[i] = crossing.curvature * per_length * per_length;
                is_gone[i] = u64::from(!((near[i] <= far[i]) & (a[i] <= far[i] * LENGTHENED)));
            }
            let front = [crossing.front; LANES];
            let pairs = [
                (&mut stream.near, near),
                (&mut stream.far, far),
                (&mut stream.a, &a),
                (&mut stream.b, &b),
                (&mut stream.t, &t),
                (&mut stream.beyond, &beyond),
                (&mut stream.front, &front),
                (&mut stream.steepness, &steepness),
                (&mut stream.curvature, &curvature),
            ];
            for (column, values) in pairs {
                column[to..to + LANES].copy_from_slice(values);
            }
            for (i, place) in stream.place[to..to + LANES].iter_mut().enumerate() {
                *place = (rays + i) as u32;
            }
            stream.cost[to..to + LANES].fill(crossing.cost);
            for axis in 0..3 {
                let (origin, direction): (&[f64; LANES], &[f64; LANES]) =
                    (part(&bundle.origin[axis], rays), part(&bundle.direction[axis], rays));
                stream.origin[axis][to..to + LANES].copy_from_slice(origin);
                stream.direction[axis][to..to + LANES].copy_from_slice(direction);
            }
            let is_gone = &is_gone[..lanes];
            stream.count += if is_gone.iter().sum::<u64>() == 0 { lanes } else { stream.pack(is_gone) };
            taken += lanes;
        }
        taken
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

for_each_level! {
    /// Makes the first rays ready to step, and says how many of them have to.
    fn begin[L](stream: &mut Stream, size: f64, count: usize) -> u64 {
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
    fn first_step[L](stream: &mut Stream, g: &[f64; POINTS], gradient: [&[f64; POINTS]; 3]) -> u64 {
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
    fn step[L](stream: &mut Stream, g: &[f64; POINTS], gradient: [&[f64; POINTS]; 3]) -> u64 {
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
    fn face[L](stream: &mut Stream) {
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
