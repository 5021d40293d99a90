//! Rays in, hits out: the one door to both methods.
//!
//! In: surfaces and a batch of rays. Out: for each ray the first root of any surface. A [`Tracer`] belongs to
//! one thread and keeps its working memory between batches; the more rays a batch has, the fuller its lanes.

use super::bundle::{Bundle, Spans};
use super::careful::{Careful, End};
use super::hit::{Counts, Hit, Outcome, Ray};
use super::isolate::{Found, Open, Pool, Rays};
use super::march::Marcher;
use super::memory::{Memory, Registers, kernels_of};
use super::refine::{Batch, Files, Refined, points_at};
use super::screen::{Rectangle, Screen};
use super::sheet::{POINTS, Surface};
use super::start::{self, Side};
use super::stream::{LENGTHENED, Root, SHORTENED, Stream, Tools};
use super::tile::{Rest, Settled, Walk};
use crate::closure::specialise::Choices;
use crate::num::level::Simd;
use glam::DVec3;

/// How roots are looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// By proof: no root is missed.
    Faithful,
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

/// The batch at hand.
struct Job<'a> {
    rays: &'a [Ray],
    hits: &'a mut [Hit],
    /// The distance from which on a ray's emptiness is not proven.
    doubt: Vec<f64>,
    /// Hits whose normal is still to be found, with the distance to take it at.
    bare: Vec<(u32, f64)>,
    surface: u32,
    sheet: u32,
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
        self.run(rays, SKIPPED, None, hits);
    }

    /// The same for the rays through the centres of a rectangle's pixels, row by row: many at once, where that can be.
    pub fn trace_rectangle(&mut self, screen: &Screen, rectangle: Rectangle, hits: &mut Vec<Hit>) {
        let simd = self.surfaces.first().map_or(Simd::Portable, |surface| surface.simd);
        let mut bundle = std::mem::take(&mut self.bundle);
        let side = self.surfaces.iter().map(side).min().unwrap_or(u32::MAX);
        if rectangle.width > side || rectangle.height > side {
            let mut part = Vec::new();
            hits.clear();
            hits.resize(rectangle.width as usize * rectangle.height as usize, Hit::NONE);
            for place in rectangle.parts(side) {
                let (left, top) = (rectangle.left + place.left, rectangle.top + place.top);
                let rectangle_part = Rectangle { left, top, ..place };
                bundle.fill(screen, rectangle_part, simd);
                let view = View { screen, rectangle: rectangle_part, bundle: &bundle };
                self.run(&bundle.rays, SKIPPED, Some(view), &mut part);
                for (i, hit) in place.numbers(rectangle.width).zip(&part) {
                    hits[i] = *hit;
                }
            }
            bundle.fill(screen, rectangle, simd);
        } else {
            bundle.fill(screen, rectangle, simd);
            self.run(&bundle.rays, SKIPPED, Some(View { screen, rectangle, bundle: &bundle }), hits);
        }
        self.bundle = bundle;
    }

    /// The rays of the last rectangle; what `rays` held is used again.
    pub fn take_rays(&mut self, rays: &mut Vec<Ray>) {
        std::mem::swap(rays, &mut self.bundle.rays);
    }

    /// The same for rays that start beside a surface, at [`Hit::near`] or a point of [`Tracer::starts`]: nothing is skipped.
    pub fn trace_from_surface(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        self.run(rays, 0.0, None, hits);
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
        self.is_negative(hit.surface, ray.at(hit.near)).unwrap_or(hit.flipped)
    }

    /// Whether that product is negative at a point; `None` if it is neither negative nor positive.
    pub fn is_negative(&mut self, surface: u32, point: DVec3) -> Option<bool> {
        let mut is_negative = false;
        for (sheet, memory) in self.surfaces[surface as usize].sheets.iter().zip(&mut self.files[surface as usize]) {
            let registers = &mut memory.registers.point;
            for axis in 0..3 {
                registers[axis].0 = [point[axis]; POINTS];
            }
            sheet.kernels.point.run(registers);
            self.counts.points += 1;
            let g = sheet.kernels.point.output(registers, 0).0[0];
            if g.is_nan() || g == 0.0 {
                return None;
            }
            is_negative ^= g < 0.0;
        }
        Some(is_negative)
    }

    fn run(&mut self, rays: &[Ray], skipped: f64, view: Option<View>, hits: &mut Vec<Hit>) {
        hits.clear();
        hits.resize(rays.len(), Hit::NONE);
        self.counts.rays += rays.len() as u64;
        if let Method::March { step } = self.method {
            self.marcher.run(self.surfaces, step, skipped, rays, hits, &mut self.counts);
            return;
        }
        let mut job =
            Job { rays, hits, doubt: vec![f64::INFINITY; rays.len()], bare: Vec::new(), surface: 0, sheet: 0 };
        for (index, surface) in self.surfaces.iter().enumerate() {
            job.surface = index as u32;
            for k in 0..surface.sheets.len() {
                job.sheet = k as u32;
                self.sheet(index, k, skipped, view, &mut job);
            }
        }
        for (hit, &doubt) in job.hits.iter_mut().zip(&job.doubt) {
            hit.proven = matches!(hit.outcome, Outcome::Miss | Outcome::Hit) && (doubt >= hit.t);
        }
    }

    /// One sheet of one surface, for all rays.
    fn sheet(&mut self, index: usize, k: usize, skipped: f64, view: Option<View>, job: &mut Job) {
        let surface = &self.surfaces[index];
        self.open.clear();
        match view {
            Some(view) if surface.sheets[k].is_free() => self.squares(surface, index, k, skipped, view, job),
            _ => self.open_rays(surface, skipped, job),
        }
        while !self.open.is_empty() {
            let memory = &mut self.files[index][k];
            let Memory { registers, special, .. } = memory;
            let kernels = kernels_of(&surface.sheets[k], special);
            let rays = Rays { list: job.rays, size: surface.size, simd: surface.simd };
            self.pool.run(kernels, &mut registers.cells, &rays, &mut self.open, &mut self.found);
            self.counts.cells += std::mem::take(&mut self.found.cells);
            for (ray, slabs) in self.found.empty.drain(..) {
                job.hits[ray as usize].cost += slabs;
            }
            self.refine(surface, index, k, job);
            let hard = std::mem::take(&mut self.found.hard);
            for open in &hard {
                let end = open.end.min(open.a + STRETCH * surface.size.max(open.a));
                self.careful(surface, index, k, *open, end, job);
            }
            self.found.hard = hard;
            self.found.hard.clear();
        }
        self.normals(surface, index, k, job);
        self.files[index][k].generalise();
    }

    fn open_rays(&mut self, surface: &Surface, skipped: f64, job: &Job) {
        for (number, (ray, hit)) in job.rays.iter().zip(&*job.hits).enumerate() {
            let Some((t0, t1)) = surface.span(ray) else { continue };
            let (a, end) = (t0.max(skipped * surface.size), t1.min(hit.t).min(FAR).min(ray.end));
            if a <= end {
                self.open.push(Open { ray: number as u32, a, end, step: end - a, slabs: 0 });
            }
        }
        // Lanes take from the back: the first rays first.
        self.open.reverse();
    }

    /// Settles what squares of the screen can, and opens the rays of the rest.
    fn squares(
        &mut self,
        surface: &Surface,
        index: usize,
        k: usize,
        skipped: f64,
        View { screen, rectangle, bundle }: View,
        job: &mut Job,
    ) {
        let (sheet, size, simd) = (&surface.sheets[k], surface.size, surface.simd);
        let Tiles { walk, settled, stream, spans } = &mut self.tiles;
        spans.fill(bundle, &surface.shapes, skipped * size, simd);
        for (far, hit) in spans.far.iter_mut().zip(&*job.hits) {
            *far = far.min(hit.t).min(FAR);
        }
        settled.clear();
        let Some((first, last)) = depths(bundle, spans, 0..bundle.rays.len()) else { return };
        // Squares may look a little beyond their rays' ends.
        let (first, last) = (first * 0.9, if last < FAR { last + 0.1 * (last - first) } else { last });
        let memory = &mut self.files[index][k];
        memory.specialise(sheet, (first, last), (screen, rectangle), simd);
        let Memory { registers, special, .. } = memory;
        let kernels = kernels_of(sheet, special);
        let range = |square: Rectangle| depths(bundle, spans, square.numbers(rectangle.width));
        walk.run(kernels, &mut registers.forms, (screen, rectangle, simd), ((first, last), range), settled);
        self.counts.cells += settled.cells;
        let (gradient, cells) = (&mut registers.gradient, &mut registers.cells.value);
        let mut tools = Tools { kernels, gradient, cells, size, simd, evaluations: 0, enclosures: 0 };
        let open = &mut self.open;
        let mut found = |root: &Root| {
            let (t0, t1) = (spans.near[root.ray], spans.far[root.ray]);
            let (ray, a) = (root.ray as u32, root.a.max(t0));
            let again = Open { ray, a, end: t1, step: root.b - root.a, slabs: root.cost };
            match root.t {
                _ if !(t0 <= t1) || a > t1 => {}
                _ if root.width.is_nan() => open.push(again),
                t if t < t0 => open.extend((root.b < t1).then_some(Open { a: root.b.max(t0), ..again })),
                t if t <= t1 => {
                    job.settle(again, Outcome::Hit, t, root.width);
                    let hit = &mut job.hits[root.ray];
                    (hit.normal, hit.flipped) = (root.normal, root.flipped);
                }
                _ => job.hits[root.ray].cost += root.cost,
            }
        };
        for crossing in &settled.crossings {
            stream.take(crossing, bundle, rectangle.width, &mut tools, &mut found);
        }
        stream.run(&mut tools, &mut found);
        self.counts.gradients += tools.evaluations;
        self.counts.cells += tools.enclosures;
        for &Rest { place, a, step, cost } in &settled.rest {
            for i in place.numbers(rectangle.width) {
                let (t0, t1, long) = (spans.near[i], spans.far[i], bundle.length[i]);
                let a = t0.max(a * long * SHORTENED);
                if a <= t1 {
                    self.open.push(Open { ray: i as u32, a, end: t1, step: step * long, slabs: cost });
                }
            }
        }
    }

    /// Refines all brackets found, and files what comes of it.
    fn refine(&mut self, surface: &Surface, index: usize, k: usize, job: &mut Job) {
        let brackets = std::mem::take(&mut self.found.brackets);
        for chunk in brackets.chunks(POINTS) {
            let Memory { registers, special, .. } = &mut self.files[index][k];
            let Registers { point, gradient, cells, .. } = registers;
            let mut files = Files { point, gradient, cells: &mut cells.value };
            let kernels = kernels_of(&surface.sheets[k], special);
            self.refined.clear();
            let rays = Rays { list: job.rays, size: surface.size, simd: surface.simd };
            let work = self.batch.run(kernels, &mut files, &rays, chunk, &mut self.refined);
            self.counts.points += work.points;
            self.counts.gradients += work.gradients;
            self.counts.cells += work.cells;
            for number in 0..self.refined.len() {
                self.file(surface, index, k, self.refined[number], job);
            }
        }
        self.found.brackets = brackets;
        self.found.brackets.clear();
    }

    fn file(&mut self, surface: &Surface, index: usize, k: usize, refined: Refined, job: &mut Job) {
        match refined {
            Refined::Nothing(bracket) => self.resume(bracket.open, bracket.b, job),
            Refined::Root { bracket, t, width, gradient } if surface.sheets[k].is_free() => {
                job.settle(bracket.open, Outcome::Hit, t, width);
                job.turn(bracket.open.ray, gradient);
            }
            Refined::Root { bracket, .. } | Refined::Unclear(bracket) => {
                self.careful(surface, index, k, bracket.open, bracket.b, job);
            }
        }
    }

    /// Settles the stretch from `open.a` to `b` of one ray.
    fn careful(&mut self, surface: &Surface, index: usize, k: usize, open: Open, b: f64, job: &mut Job) {
        let ray = &job.rays[open.ray as usize];
        let memory = &mut self.files[index][k];
        let mut careful = Careful {
            sheet: &surface.sheets[k],
            kind: surface.kind,
            ray,
            size: surface.size,
            scratch: &mut memory.scalar,
            sides: &mut memory.sides,
            cells: 0,
        };
        let end = careful.trace(open.a, b);
        self.counts.cells += careful.cells;
        job.hits[open.ray as usize].cost += careful.cells as u32;
        match end {
            End::Empty { proven } => {
                if !proven {
                    let doubt = &mut job.doubt[open.ray as usize];
                    *doubt = doubt.min(open.a);
                }
                self.resume(open, b, job);
            }
            End::Root { t, width } => {
                job.settle(open, Outcome::Hit, t, width);
                job.bare.push((open.ray, t));
            }
            End::Touch { t, width } => {
                job.settle(open, Outcome::Touch, t, width);
                // On the extremum itself the gradient is rounding; a little in front it points away from it.
                job.bare.push((open.ray, t - SHORT_OF_TOUCH * surface.size.max(t)));
            }
            End::Undecided { t, width } => {
                job.settle(open, Outcome::Undecided, t, width);
                job.bare.push((open.ray, t));
            }
        }
    }

    /// Goes on behind b, if anything is left there.
    fn resume(&mut self, open: Open, b: f64, job: &mut Job) {
        if b >= open.end {
            job.hits[open.ray as usize].cost += open.slabs;
        } else {
            self.open.push(Open { a: b, step: 2.0 * (b - open.a), ..open });
        }
    }

    /// Finds the normals that are still missing, a batch at a time.
    fn normals(&mut self, surface: &Surface, index: usize, k: usize, job: &mut Job) {
        let bare = std::mem::take(&mut job.bare);
        let Memory { registers, special, .. } = &mut self.files[index][k];
        let kernels = kernels_of(&surface.sheets[k], special);
        let registers = &mut registers.gradient;
        for chunk in bare.chunks(POINTS) {
            let at = |i: usize| &chunk[i.min(chunk.len() - 1)];
            let part =
                |pick: fn(&Ray) -> DVec3, axis: usize| std::array::from_fn(|i| pick(&job.rays[at(i).0 as usize])[axis]);
            let origin = [0, 1, 2].map(|axis| part(|r| r.origin, axis));
            let direction = [0, 1, 2].map(|axis| part(|r| r.direction, axis));
            points_at(surface.simd, &origin, &direction, &std::array::from_fn(|i| at(i).1), registers);
            kernels.gradient.run(registers);
            self.counts.gradients += chunk.len() as u64;
            for (i, &(ray, _)) in chunk.iter().enumerate() {
                let [x, y, z] = [1, 2, 3].map(|c| kernels.gradient.output(registers, c).0[i]);
                job.turn(ray, DVec3::new(x, y, z));
            }
        }
    }
}

/// The side of the rectangles in which a surface is made anew: the more there is to leave out, the smaller.
fn side(surface: &Surface) -> u32 {
    let arguments = surface.sheets.iter().filter_map(|sheet| sheet.choices.as_ref()).map(Choices::arguments).max();
    match arguments.unwrap_or(0) {
        0..64 => u32::MAX,
        64..256 => 32,
        256.. => 16,
    }
}

/// Between which depths any of these rays is looked at.
fn depths(bundle: &Bundle, spans: &Spans, rays: impl Iterator<Item = usize>) -> Option<(f64, f64)> {
    let (mut a, mut end) = (f64::INFINITY, f64::NEG_INFINITY);
    for i in rays {
        if spans.near[i] <= spans.far[i] {
            a = a.min(spans.near[i] / bundle.length[i]);
            end = end.max(spans.far[i] / bundle.length[i]);
        }
    }
    (a <= end).then_some((a * SHORTENED, end * LENGTHENED))
}

/// How far in front of a touch its normal is taken, as a part of the scale.
const SHORT_OF_TOUCH: f64 = 1e-5;

impl Job<'_> {
    /// A root in front of all known so far.
    fn settle(&mut self, open: Open, outcome: Outcome, t: f64, width: f64) {
        let hit = &mut self.hits[open.ray as usize];
        let cost = hit.cost + open.slabs;
        let (near, far) = ((t - width).max(0.0), t + width);
        *hit = Hit { outcome, t, width, near, far, surface: self.surface, sheet: self.sheet, cost, ..Hit::NONE };
    }

    /// The normal of a hit from the gradient, turned against the ray.
    fn turn(&mut self, ray: u32, gradient: DVec3) {
        let hit = &mut self.hits[ray as usize];
        let normal = gradient.try_normalize().unwrap_or(DVec3::NAN);
        hit.flipped = normal.dot(self.rays[ray as usize].direction) > 0.0;
        hit.normal = if hit.flipped { -normal } else { normal };
    }
}
