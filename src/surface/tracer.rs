//! Rays in, hits out: the one door to all methods.
//!
//! In: surfaces and a batch of rays. Out: for each ray the first root of any surface. A [`Tracer`] belongs to
//! one thread and keeps its working memory between batches; the more rays a batch has, the fuller its lanes.

mod singles;
mod squares;
mod terms;

use super::bundle::{Asked, Bundle};
use super::hit::{Counts, Hit, Outcome, Ray};
use super::isolate::{Bracket, Found, Open, Pool};
use super::march::Marcher;
use super::memory::Memory;
use super::refine::{Batch, Refined};
use super::screen::{Rectangle, Screen};
use super::sheet::{POINTS, Surface};
use super::spans::Spans;
use super::start::{self, Side};
use super::stream::Stream;
use super::tile::{Settled, Walk};
use crate::num::level::Simd;
use glam::DVec3;

/// How roots are looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// By proof: no root is missed.
    Faithful,
    /// The same by natural intervals, each ray by itself: the plain way, which [`Method::Faithful`] is held against.
    Intervals,
    /// By samples at multiples of a step: what changes sign between two of them is found.
    March {
        /// The distance between samples, > 0.
        step: f64,
    },
}

/// A root nearer to the eye than this part of the region's size is where the eye is, and is skipped.
const SKIPPED: f64 = 1e-12;

/// The end of a ray that no region ends.
const FAR: f64 = 1e9;

/// How much of a hard ray the careful method settles before lanes take over again, as a part of the scale.
const STRETCH: f64 = 4e-5;

/// Traces batches of rays against surfaces; one for each thread.
pub struct Tracer<'a> {
    surfaces: &'a [Surface],
    method: Method,
    files: Vec<Vec<Memory>>,
    pool: Pool,
    batch: Batch,
    found: Found,
    /// Those that are refined with others.
    waiting: Vec<Bracket>,
    refined: Vec<Refined>,
    open: Vec<Open>,
    marcher: Marcher,
    tiles: Tiles,
    bundle: Bundle,
    /// What was computed since the tracer was made.
    pub counts: Counts,
}

/// Room for what is settled by squares of the screen.
#[derive(Default)]
struct Tiles {
    walk: Walk,
    settled: Settled,
    stream: Stream,
    spans: Spans,
}

/// The rays at hand as a rectangle of a picture.
#[derive(Clone, Copy)]
struct View<'a> {
    screen: &'a Screen,
    rectangle: Rectangle,
    bundle: &'a Bundle,
}

impl View<'_> {
    /// A part of the rectangle as pixels of the picture.
    fn on_screen(&self, place: Rectangle) -> Rectangle {
        Rectangle { left: self.rectangle.left + place.left, top: self.rectangle.top + place.top, ..place }
    }
}

/// The batch at hand.
struct Job<'a> {
    rays: Asked<'a>,
    hits: &'a mut [Hit],
    /// Rays whose emptiness is not proven, each with a distance from which on.
    doubt: Vec<(u32, f64)>,
    bare: Vec<Bare>,
    surface: u32,
    sheet: u32,
}

/// A hit whose normal is still to be found.
struct Bare {
    ray: u32,
    t: f64,
    /// Where the normal is taken.
    at: f64,
}

impl<'a> Tracer<'a> {
    /// A tracer with fresh memory.
    pub fn new(surfaces: &'a [Surface], method: Method) -> Self {
        let files = surfaces.iter().map(|s| s.sheets.iter().map(Memory::new).collect()).collect();
        Tracer {
            surfaces,
            method,
            files,
            pool: Pool::default(),
            batch: Batch::default(),
            found: Found::default(),
            waiting: Vec::new(),
            refined: Vec::new(),
            open: Vec::new(),
            marcher: Marcher::new(surfaces),
            tiles: Tiles::default(),
            bundle: Bundle::default(),
            counts: Counts::default(),
        }
    }

    /// The first root with t > 0 on each ray; `hits` is replaced, in the order of the rays.
    ///
    /// A root at the very start (within 1e-12 of the region's size) is the one the eye is on, and is skipped.
    pub fn trace(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        self.run(Asked::List(rays), SKIPPED, None, hits);
    }

    /// The same for the rays through the centres of a rectangle's pixels, row by row: many at once, where that can be.
    pub fn trace_rectangle(&mut self, screen: &Screen, rectangle: Rectangle, hits: &mut Vec<Hit>) {
        let simd = self.surfaces.first().map_or(Simd::Portable, |surface| surface.simd);
        let mut bundle = std::mem::take(&mut self.bundle);
        bundle.fill(screen, rectangle, simd);
        self.run(Asked::Bundle(&bundle), SKIPPED, Some(View { screen, rectangle, bundle: &bundle }), hits);
        self.bundle = bundle;
    }

    /// The rays of the last rectangle, row by row; what `rays` held is gone.
    pub fn rays(&self, rays: &mut Vec<Ray>) {
        self.bundle.list(rays);
    }

    /// The same for rays that start beside a surface, at [`Hit::near`] or a point of [`Tracer::starts`]: nothing is skipped.
    pub fn trace_from_surface(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        self.run(Asked::List(rays), 0.0, None, hits);
    }

    /// Points from which rays can leave what was hit, on the side asked for: beside the surface by as little as proves
    /// on which side they are. `points` is replaced, in the order of the departures, each of which hit something.
    pub fn starts(&mut self, departures: &[(Ray, Hit, Side)], points: &mut Vec<DVec3>) {
        points.clear();
        points.resize(departures.len(), DVec3::ZERO);
        for (index, surface) in self.surfaces.iter().enumerate() {
            for (k, sheet) in surface.sheets.iter().enumerate() {
                let here = departures.iter().enumerate().map(|(number, &(ray, hit, side))| (number, ray, hit, side));
                let here = here.filter(|(_, _, hit, _)| (hit.surface, hit.sheet) == (index as u32, k as u32));
                let cells = &mut self.files[index][k].registers.cells.value;
                self.counts.cells += start::starts(sheet, cells, here, points);
            }
        }
    }

    /// Whether a ray meets a surface on the side where its equation as rewritten, the product of its sheets, is negative.
    pub fn comes_from_negative(&mut self, ray: &Ray, hit: &Hit) -> bool {
        if self.surfaces[hit.surface as usize].sheets.len() == 1 {
            return hit.flipped;
        }
        self.is_negative(hit.surface, ray.at(hit.near())).unwrap_or(hit.flipped)
    }

    /// Whether that product is negative at a point; `None` if it is neither negative nor positive.
    pub fn is_negative(&mut self, surface: u32, point: DVec3) -> Option<bool> {
        let mut is_negative = false;
        for (sheet, memory) in self.surfaces[surface as usize].sheets.iter().zip(&mut self.files[surface as usize]) {
            let registers = &mut memory.registers.point;
            for axis in 0..3 {
                registers[axis].0 = [point[axis]; POINTS];
            }
            let kernel = sheet.kernels.whole().point();
            kernel.run(registers);
            self.counts.points += 1;
            let g = kernel.output(registers, 0).0[0];
            if g.is_nan() || g == 0.0 {
                return None;
            }
            is_negative ^= g < 0.0;
        }
        Some(is_negative)
    }

    fn run(&mut self, rays: Asked, skipped: f64, view: Option<View>, hits: &mut Vec<Hit>) {
        hits.clear();
        self.counts.rays += rays.len() as u64;
        if let Method::March { step } = self.method {
            hits.resize(rays.len(), Hit::NONE);
            self.marcher.run(self.surfaces, step, skipped, rays, hits, &mut self.counts);
            return;
        }
        hits.resize(rays.len(), Hit { proven: true, ..Hit::NONE });
        let mut job = Job { rays, hits, doubt: Vec::new(), bare: Vec::new(), surface: 0, sheet: 0 };
        for (index, surface) in self.surfaces.iter().enumerate() {
            job.surface = index as u32;
            for k in 0..surface.sheets.len() {
                job.sheet = k as u32;
                self.sheet(index, k, skipped, view, &mut job);
            }
        }
        for (ray, doubt) in job.doubt {
            let hit = &mut job.hits[ray as usize];
            hit.proven &= doubt >= hit.t;
        }
    }

    /// One sheet of one surface, for all rays.
    fn sheet(&mut self, index: usize, k: usize, skipped: f64, view: Option<View>, job: &mut Job) {
        let surface = &self.surfaces[index];
        self.open.clear();
        match view {
            Some(view) if surface.sheets[k].is_free() && self.method == Method::Faithful => {
                self.squares(surface, index, k, skipped, view, job);
                self.counts.singles += self.open.len() as u64;
            }
            _ => self.open_rays(surface, skipped, job),
        }
        self.singles(surface, index, k, job);
        self.normals(surface, index, k, job);
    }
}

impl Job<'_> {
    /// A root; whether it is in front of all known so far.
    fn settle(&mut self, open: Open, outcome: Outcome, t: f64, width: f64) -> bool {
        let hit = &mut self.hits[open.ray as usize];
        hit.cost += open.slabs;
        let is_first = t <= hit.t;
        if is_first {
            let (proven, cost) = (outcome == Outcome::Hit, hit.cost);
            *hit = Hit { outcome, proven, t, width, surface: self.surface, sheet: self.sheet, cost, ..Hit::NONE };
        }
        is_first
    }

    /// The same of a root whose normal is to be taken somewhere.
    fn settle_bare(&mut self, open: Open, outcome: Outcome, (t, width): (f64, f64), at: f64) {
        if self.settle(open, outcome, t, width) {
            self.bare.push(Bare { ray: open.ray, t, at });
        }
    }

    /// The normal of a hit from the gradient, turned against the ray.
    fn turn(&mut self, ray: u32, gradient: DVec3) {
        let hit = &mut self.hits[ray as usize];
        let normal = gradient.try_normalize().unwrap_or(DVec3::NAN);
        hit.flipped = normal.dot(self.rays.ray(ray).direction) > 0.0;
        hit.normal = if hit.flipped { -normal } else { normal };
    }
}
