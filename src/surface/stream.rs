//! The roots of whole squares: Newton's method for 64 rays at once, and one enclosure to certify each.
//!
//! In: rays with a bracket in which g has exactly one root and its slope along the ray is at least so steep. Out: roots. A point
//! t of the bracket is within |g(t)| / steepness of the root (mean value theorem), so that an enclosure of g at t alone
//! proves how near it is: a ball, or where that says too little an interval. Separate from [`super::refine`], which knows less of its brackets and must look at both sides.

mod certificate;
mod newton;

use super::bundle::{BEYOND, Bundle, PLACES};
use super::kernels::Formula;
use super::refine::points_at;
use super::sheet::{Balls, Cells, POINTS, Points};
use super::spans::{LENGTHENED, SHORTENED, Spans};
use super::tile::Crossing;
use crate::num::level::{Simd, for_each_level};
use certificate::{Certified, certify};

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
        let mut live = newton::begin(tools.simd, self, tools.size, count);
        for number in 0..MOST_STEPS {
            if live == 0 {
                break;
            }
            let [origin, direction] = [&self.origin, &self.direction].map(|all| all.each_ref().map(|one| part(one, 0)));
            points_at(tools.simd, origin, direction, part(&self.t, 0), tools.gradient);
            tools.formula.gradient().run(tools.gradient);
            tools.evaluations += live;
            let [g, x, y, z] = [0, 1, 2, 3].map(|k| &tools.formula.gradient().output(tools.gradient, k).0);
            let take_step = if number == 0 { newton::first_step } else { newton::step };
            live = take_step(tools.simd, self, g, [x, y, z]);
        }
        newton::face(tools.simd, self);
        self.file(tools, count, sink);
    }

    /// Finds the roots of all rays that wait, and of those that wait once more.
    pub(crate) fn finish(&mut self, tools: &mut Tools, sink: &mut impl Sink) {
        while self.count > 0 {
            self.run(tools, sink);
        }
    }

    /// Tells what is proven of each ray. Rays that were wrongly thought to end before their root wait again.
    fn file(&mut self, tools: &mut Tools, count: usize, sink: &mut impl Sink) {
        let certified = certify(self, tools, count);
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
