//! The fast way: squares of pixels between two depths, settled for all their rays at once.
//!
//! In: the rays of a rectangle of the picture. Out: brackets in which each ray of a square has exactly one root and none
//! before, for [`super::stream`]; and the rays that squares could not settle, for [`super::isolate`]. Rays that are
//! in neither meet nothing: proven.
//!
//! A square walks from the front. Over its slab of depths [a, b] it encloses g by an affine form of (across, down, along).
//! - 0 is not in the form: nothing is there for any ray. Go on behind it with twice the length.
//! - The linear part says where along the rays zero can be: the slab becomes that part, longer than before where a sheet
//!   lies askew and reaches out of it.
//! - Zero is all inside: g has opposite signs at both ends for every ray. Where its slope along the rays has one sign too,
//!   each ray has one root there.
//! - None of these: half the slab, or four squares.

use super::bundle::{BLOCK, Bundle};
use super::kernels::Formula;
use super::screen::{Places, Rectangle, Screen, place_forms};
use crate::num::affine_lanes::AffineLanes;
use crate::num::interval_lanes::{JUMP, NOWHERE, PARTIAL};
use crate::num::level::{Simd, for_each_level};

/// How many squares are enclosed at once.
pub(crate) const FORMS: usize = 16;

/// Enclosures over [`FORMS`] squares.
pub(crate) type Forms = AffineLanes<FORMS>;

/// The first squares, in pixels a side: smaller ones cost more in empty space, larger ones rarely settle anything.
const LARGEST: u32 = BLOCK;

/// The last squares: one ray, whose form still leans where its interval would not; what they do not settle is left to intervals.
const SMALLEST: u32 = 1;

/// A sheet that lies so much askew that it is this many half slabs thick is not followed but cut.
const MOST_GROWTH: f64 = 6.0;

/// A form whose error is more than this part of what it rises along the slab does not say where zero is.
const BENT: f64 = 0.6;

/// A slab longer than this many widths of its square is halved, a shorter one cut into squares.
const LONG: f64 = 3.0;

/// What a few sums and products of forms' numbers may be off by, far more than they are.
pub(crate) const WIDER: f64 = 1.0 + 1e-12;
pub(crate) const NARROWER: f64 = 1.0 - 1e-12;

/// How much a contracted slab is left wider than it must be, in half slabs: far more than its sums round off.
const MARGIN: f64 = 1e-6;

/// A square may take this many slabs before it is cut.
const MOST_SLABS: u32 = 12;

/// A slab that was moved to where a sheet leans counts for so many more: where rays graze a sheet, the next says the same again.
const FOLLOWED: u32 = 3;

/// A square of pixels of a rectangle, which may reach out of it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Place {
    /// From the rectangle's corner.
    corner: [u32; 2],
    /// Pixels a side, a power of two that divides both.
    pub(crate) side: u32,
    /// Where in the bundle its rays begin.
    pub(crate) first: usize,
}

impl Place {
    /// How many rays it has.
    pub(crate) fn count(self) -> usize {
        (self.side * self.side) as usize
    }

    /// The squares that a part of a rectangle is first looked at by.
    pub(crate) fn of(part: Rectangle, bundle: &Bundle) -> impl Iterator<Item = Place> + '_ {
        let whole = part.width.max(part.height).next_power_of_two();
        // A part of one square would leave lanes empty.
        let side = if whole <= LARGEST { (whole / 4).max(1) } else { LARGEST };
        part.parts(side).map(move |place| {
            let corner = [part.left + place.left, part.top + place.top];
            Place { corner, side, first: bundle.first(corner) }
        })
    }

    /// Its four quarters, in the order of their rays.
    fn quarters(self) -> [Place; 4] {
        let (side, [i, j]) = (self.side / 2, self.corner);
        [0, 1, 2, 3].map(|k| Place {
            corner: [i + k % 2 * side, j + k / 2 * side],
            side,
            first: self.first + (k * side * side) as usize,
        })
    }
}

/// A square of pixels on its way.
#[derive(Clone, Copy, Debug, Default)]
struct Square {
    place: Place,
    /// The slab.
    a: f64,
    b: f64,
    /// Where the last ray of it ends.
    end: f64,
    /// The proven sign of g at a for every ray, or 0; NaN while nothing is known of what is in front of a, so that the slab may
    /// begin sooner.
    sign: f64,
    /// Slabs since it was cut, and in all.
    slabs: u32,
    cost: u32,
}

/// A slab in which every ray of a square has one root.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    pub(crate) place: Place,
    /// The depths between which it is.
    pub(crate) a: f64,
    pub(crate) b: f64,
    /// The least |dg/ds|, s the depth.
    pub(crate) steepness: f64,
    /// The sign of g in front of the root.
    pub(crate) front: f64,
    /// What d²g/ds² is about.
    pub(crate) curvature: f64,
    /// The root's depth in the middle of the square, and what a pixel across and down adds to it.
    pub(crate) depth: [f64; 3],
    /// Enclosures so far.
    pub(crate) cost: u32,
}

/// A square whose rays go on one by one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rest {
    pub(crate) place: Place,
    /// The depth up to which they are settled, and how far to reach first.
    pub(crate) a: f64,
    pub(crate) step: f64,
    /// Enclosures so far.
    pub(crate) cost: u32,
}

/// What the squares of a rectangle came to.
#[derive(Debug, Default)]
pub(crate) struct Settled {
    pub(crate) crossings: Vec<Crossing>,
    pub(crate) rest: Vec<Rest>,
    /// Slabs enclosed.
    pub(crate) cells: u64,
}

impl Settled {
    pub(crate) fn clear(&mut self) {
        self.crossings.clear();
        self.rest.clear();
        self.cells = 0;
    }
}

/// The register files of a sheet's forms.
pub(crate) struct FormFiles {
    /// Of g.
    pub(crate) value: Vec<Forms>,
    /// Of g and its slope along the rays.
    pub(crate) slope: Vec<Forms>,
    /// Of the terms of a long sum, and what they come to, with its slope.
    pub(crate) terms: Vec<Forms>,
    pub(crate) sums: [Forms; 2],
}

/// Room for the walk of squares.
#[derive(Debug, Default)]
pub(crate) struct Walk {
    open: Vec<Square>,
    /// With opposite signs at both ends, the slope to be looked at.
    crossed: Vec<Square>,
    places: Places,
    /// The depths between which the formula is what it is.
    limits: (f64, f64),
}

/// What forms say of their slabs.
#[derive(Debug, Default)]
struct Said {
    /// Whether there is no root.
    is_empty: [bool; FORMS],
    /// Whether the linear part says where roots can be: between these places, in half slabs from the middle.
    is_leaning: [bool; FORMS],
    from: [f64; FORMS],
    to: [f64; FORMS],
    /// The sign of g where there is no root, 0 if that is not known; else that of its slope along the rays.
    sign: [f64; FORMS],
}

/// What becomes of a square after a slab.
enum Verdict {
    Empty,
    Again,
    Crossed,
    Cut,
}

impl Walk {
    /// Settles what squares of pixels can in a part of the rectangle, each ray between the depths that `range` gives for a square, looking no farther
    /// than the limits on either side.
    pub(crate) fn run(
        &mut self,
        formula: Formula,
        files: &mut FormFiles,
        (screen, rectangle, simd): (&Screen, Rectangle, Simd),
        (part, bundle, limits, range): (Rectangle, &Bundle, (f64, f64), impl Fn(Place) -> Option<(f64, f64)>),
        settled: &mut Settled,
    ) {
        self.open.clear();
        self.limits = limits;
        for place in Place::of(part, bundle) {
            if let Some((a, end)) = range(place) {
                self.open.push(Square { place, a, b: end, end, sign: f64::NAN, ..Square::default() });
            }
        }
        self.settle(formula, files, (screen, rectangle, simd), settled);
    }

    /// Settles what is behind the crossings of the last run, for rays that are still looked at there.
    pub(crate) fn resume(
        &mut self,
        formula: Formula,
        files: &mut FormFiles,
        view: (&Screen, Rectangle, Simd),
        range: impl Fn(Place) -> Option<(f64, f64)>,
        settled: &mut Settled,
    ) {
        self.open.clear();
        for crossing in settled.crossings.drain(..) {
            let Crossing { place, b: a, front, cost, .. } = crossing;
            if let Some((_, end)) = range(place).filter(|(_, end)| *end > a) {
                self.open.push(Square { place, a, b: end, end, sign: -front, slabs: 0, cost });
            }
        }
        settled.clear();
        self.settle(formula, files, view, settled);
    }

    /// Walks all open squares to their ends.
    fn settle(
        &mut self,
        formula: Formula,
        files: &mut FormFiles,
        (screen, rectangle, simd): (&Screen, Rectangle, Simd),
        settled: &mut Settled,
    ) {
        while !self.open.is_empty() || !self.crossed.is_empty() {
            while !self.open.is_empty() {
                self.look_at_values(formula, files, (screen, rectangle, simd), settled);
                if self.crossed.len() >= FORMS {
                    self.look_at_slopes(formula, files, (screen, rectangle, simd), settled);
                }
            }
            self.look_at_slopes(formula, files, (screen, rectangle, simd), settled);
        }
    }

    fn place(
        &mut self,
        forms: &mut [Forms],
        squares: &[Square],
        (screen, rectangle, simd): (&Screen, Rectangle, Simd),
    ) {
        for (lane, square) in squares.iter().enumerate() {
            let Place { corner: [left, top], side, .. } = square.place;
            let corner = [rectangle.left + left, rectangle.top + top];
            for axis in 0..2 {
                self.places.start[axis][lane] = f64::from(corner[axis]);
                self.places.last[axis][lane] = f64::from(corner[axis] + side - 1);
            }
            (self.places.start[2][lane], self.places.last[2][lane]) = (square.a, square.b);
        }
        place_forms(simd, screen, &self.places, forms);
    }

    fn look_at_values(
        &mut self,
        formula: Formula,
        files: &mut FormFiles,
        view: (&Screen, Rectangle, Simd),
        settled: &mut Settled,
    ) {
        let mut squares = [Square::default(); FORMS];
        let count = self.open.len().min(FORMS);
        for square in &mut squares[..count] {
            *square = self.open.pop().unwrap_or_default();
        }
        let [g, _] = formula.forms(false, files, view.2, |forms| self.place(forms, &squares[..count], view));
        let mut said = Said::default();
        read(view.2, g, &mut said);
        settled.cells += count as u64;
        for (lane, square) in squares[..count].iter_mut().enumerate() {
            square.slabs += 1;
            square.cost += 1;
            match square.judge(&said, lane, view.0, self.limits) {
                Verdict::Empty => {}
                Verdict::Again => self.open.push(*square),
                Verdict::Crossed => self.crossed.push(*square),
                Verdict::Cut => self.cut(square, view.1, settled),
            }
        }
    }

    /// Files the crossed squares whose slope has one sign, and cuts the others.
    fn look_at_slopes(
        &mut self,
        formula: Formula,
        files: &mut FormFiles,
        view: (&Screen, Rectangle, Simd),
        settled: &mut Settled,
    ) {
        let mut squares = [Square::default(); FORMS];
        let count = self.crossed.len().min(FORMS);
        for square in &mut squares[..count] {
            *square = self.crossed.pop().unwrap_or_default();
            square.cost += 1;
        }
        if count == 0 {
            return;
        }
        let [g, slope] = formula.forms(true, files, view.2, |forms| self.place(forms, &squares[..count], view));
        settled.cells += count as u64;
        for (lane, square) in squares[..count].iter().enumerate() {
            let (lo, hi) = slope.bounds(lane);
            let steepness = lo.max(-hi);
            let smooth = (g.flags[lane] & (PARTIAL | JUMP)) | (slope.flags[lane] & PARTIAL) == 0;
            if smooth && steepness > 0.0 {
                settled.crossings.push(square.crossing(g, slope, lane, view.0));
            } else {
                self.cut(square, view.1, settled);
            }
        }
    }

    /// Four squares, or single rays.
    fn cut(&mut self, square: &Square, rectangle: Rectangle, settled: &mut Settled) {
        if square.place.side <= SMALLEST {
            let Square { place, a, b, cost, .. } = *square;
            settled.rest.push(Rest { place, a, step: b - a, cost });
            return;
        }
        let is_inside = |place: &Place| place.corner[0] < rectangle.width && place.corner[1] < rectangle.height;
        let quarters = square.place.quarters().into_iter().filter(is_inside);
        self.open.extend(quarters.map(|place| Square { place, slabs: 0, ..*square }));
    }
}

impl Square {
    /// What the form of g over the slab says; moves the slab.
    fn judge(&mut self, said: &Said, lane: usize, screen: &Screen, limits: (f64, f64)) -> Verdict {
        if said.is_empty[lane] {
            return self.pass(said.sign[lane]);
        }
        if !said.is_leaning[lane] || self.slabs >= MOST_SLABS {
            return self.halve(screen);
        }
        let verdict = self.follow(-said.sign[lane], said.from[lane], said.to[lane], screen);
        let beyond = self.a < limits.0 || self.b > limits.1;
        (self.a, self.b) = (self.a.max(limits.0), self.b.min(limits.1));
        let is_cut = !(self.a < self.b) || (beyond && matches!(verdict, Verdict::Crossed));
        if is_cut { Verdict::Cut } else { verdict }
    }

    /// The slab is empty.
    fn pass(&mut self, sign: f64) -> Verdict {
        let step = 2.0 * (self.b - self.a);
        self.a = self.b;
        self.b = (self.a + step).min(self.end);
        self.sign = sign;
        if self.a >= self.end { Verdict::Empty } else { Verdict::Again }
    }

    /// Zero can only be between `from` and `to`, in half slabs from the middle; g has the sign `front` before that.
    fn follow(&mut self, front: f64, from: f64, to: f64, screen: &Screen) -> Verdict {
        let (middle, half) = (0.5 * (self.a + self.b), 0.5 * (self.b - self.a));
        let (a, b) = (middle + from * half, middle + to * half);
        let known = from > -1.0 || self.sign == front;
        if from > -1.0 {
            (self.a, self.sign) = (a, front);
        }
        if known && to < 1.0 {
            self.b = b;
            return Verdict::Crossed;
        }
        if !known && !self.sign.is_nan() {
            // There is another sheet, or the form knows less than its past.
            return self.halve(screen);
        }
        if !known && a > 0.0 {
            // The sheet is cut by the beginning of the rays: look at all of it.
            self.a = a;
        }
        if !known && !(a > 0.0) {
            return self.halve(screen);
        }
        self.b = b.max(self.a + 0.5 * half);
        self.slabs += FOLLOWED;
        Verdict::Again
    }

    fn halved(&mut self) -> Verdict {
        self.b = self.a + 0.5 * (self.b - self.a);
        Verdict::Again
    }

    fn halve(&mut self, screen: &Screen) -> Verdict {
        let width = screen.width_at(self.place.side, 0.5 * (self.a + self.b));
        if self.b - self.a > LONG * width && self.slabs < 2 * MOST_SLABS { self.halved() } else { Verdict::Cut }
    }

    fn crossing(&self, g: &Forms, slope: &Forms, lane: usize, screen: &Screen) -> Crossing {
        let Square { place, a, b, cost, .. } = *self;
        let half = 0.5 * (b - a);
        let per = -half / g.slope[2][lane];
        // A symbol goes from −1 to 1 over the centres of the square's pixels.
        let per_pixel = |axis: usize| 2.0 * screen.step[axis].signum() / f64::from(place.side.max(2) - 1);
        let depth = [
            0.5 * (a + b) + per * g.center[lane],
            per * g.slope[0][lane] * per_pixel(0),
            per * g.slope[1][lane] * per_pixel(1),
        ];
        let (lo, hi) = slope.bounds(lane);
        let (steepness, front) = (lo.max(-hi), if lo > 0.0 { -1.0 } else { 1.0 });
        Crossing { place, a, b, steepness, front, curvature: slope.slope[2][lane] / half, depth, cost }
    }
}

for_each_level! {
    /// Reads what the forms of g say. Written so that NaN says nothing.
    fn read[L](g: &Forms, said: &mut Said) {
        for i in 0..FORMS {
            let (c, slope, radius) = (g.center[i], g.slope[2][i], g.radius(i));
            let smooth = g.flags[i] & (PARTIAL | JUMP) == 0;
            let is_empty = (c.abs() > radius * WIDER) | (g.flags[i] & NOWHERE != 0);
            let along = slope.abs();
            let lean = g.slope[0][i].abs() + g.slope[1][i].abs();
            let bent = radius - lean - along;
            let is_leaning = smooth & (along > 0.0) & (bent < BENT * along) & (lean < MOST_GROWTH * along);
            let (middle, half) = (-c / slope, (radius - along * NARROWER) / along);
            let margin = MARGIN * (1.0 + middle.abs() + half);
            let of = if is_empty { c } else { slope };
            let sign = if of < 0.0 { -1.0 } else { 1.0 };
            said.is_empty[i] = is_empty;
            said.is_leaning[i] = is_leaning;
            said.from[i] = middle - half - margin;
            said.to[i] = middle + half + margin;
            said.sign[i] = if smooth { sign } else { 0.0 };
        }
    }
}
