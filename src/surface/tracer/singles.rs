//! Rays one by one: what of each is open is settled by forms and intervals, with the part of the formula that matters there.
//!
//! In: open rays. Out: their hits. Separate from the door because it knows no picture.

use super::{Bare, FAR, Job, Method, STRETCH, Tracer};
use crate::surface::careful::{Careful, End};
use crate::surface::hit::{Outcome, Ray};
use crate::surface::index::{Piece, Scratch};
use crate::surface::isolate::{Open, Rays};
use crate::surface::kernels::Formula;
use crate::surface::memory::Registers;
use crate::surface::refine::{Files, Refined, points_at};
use crate::surface::sheet::{POINTS, Surface};
use glam::DVec3;

/// How many pieces of a ray are settled together, though what is behind a root is of no use: so there are more that share a formula.
const AT_ONCE: usize = 4;

/// Roots are refined in all of the formula, by full batches, unless it takes so many times the steps of their own: few pieces of a group end
/// at a root, and a batch takes its time however few are in it.
const WAITING: usize = 16;

/// How far in front of a touch its normal is taken, as a part of the scale.
const SHORT_OF_TOUCH: f64 = 1e-5;

/// Pieces by their programs.
#[derive(Default)]
struct Groups {
    /// For each program, and first for none, the end of its pieces.
    ends: Vec<usize>,
    pieces: Vec<Open>,
}

impl Groups {
    /// Takes pieces, and leaves none.
    fn fill(&mut self, pieces: &mut Vec<Piece>) {
        let number = |piece: &Piece| piece.program.map_or(0, |program| program as usize + 1);
        let count = pieces.iter().map(|piece| number(piece) + 1).max().unwrap_or(0);
        self.ends.clear();
        self.ends.resize(count, 0);
        for piece in &*pieces {
            self.ends[number(piece)] += 1;
        }
        let mut begin = 0;
        for end in &mut self.ends {
            begin += std::mem::replace(end, begin);
        }
        self.pieces.clear();
        self.pieces.extend(pieces.iter().map(|piece| piece.open));
        for piece in pieces.drain(..) {
            let place = &mut self.ends[number(&piece)];
            self.pieces[*place] = piece.open;
            *place += 1;
        }
    }

    fn iter(&self) -> impl Iterator<Item = (Option<u32>, &[Open])> {
        let begins = std::iter::once(0).chain(self.ends.iter().copied());
        let all = begins.zip(&self.ends).enumerate();
        all.map(|(k, (begin, &end))| (k.checked_sub(1).map(|k| k as u32), &self.pieces[begin..end]))
            .filter(|group| !group.1.is_empty())
    }
}

impl Tracer<'_> {
    pub(super) fn open_rays(&mut self, surface: &Surface, skipped: f64, job: &Job) {
        for (number, hit) in job.hits.iter().enumerate() {
            let ray = job.rays.ray(number as u32);
            let Some((t0, t1)) = surface.span(&ray) else { continue };
            let (a, end) = (t0.max(skipped * surface.size), t1.min(hit.t).min(FAR).min(ray.end));
            if a <= end {
                self.open.push(Open { ray: number as u32, a, end, step: end - a, slabs: 0 });
            }
        }
        // Lanes take from the back: the first rays first.
        self.open.reverse();
    }

    /// Settles all open rays: piece by piece where parts of space have formulas of their own, those of one formula together.
    pub(super) fn singles(&mut self, surface: &Surface, index: usize, k: usize, job: &mut Job) {
        let sheet = &surface.sheets[k];
        let map = sheet.index.as_ref().filter(|_| self.method != Method::Intervals);
        let Some(map) = map else {
            self.settle_open(sheet.kernels.whole(), surface, (index, k), job);
            return;
        };
        let mut waiting = std::mem::take(&mut self.open);
        let (mut pieces, mut rest, mut groups) = (Vec::new(), Vec::new(), Groups::default());
        while !waiting.is_empty() {
            for open in &mut waiting {
                job.hits[open.ray as usize].cost += std::mem::take(&mut open.slabs);
            }
            let memory = &mut self.files[index][k];
            let mut scratch = Scratch { leaves: &mut memory.leaves, value: &mut memory.registers.forms.value };
            map.pieces(&sheet.kernels, job.rays, &mut waiting, AT_ONCE, &mut scratch, (&mut pieces, &mut rest));
            groups.fill(&mut pieces);
            for (program, group) in groups.iter() {
                self.open.extend_from_slice(group);
                let program = program.map(|number| map.program(number));
                let formula = program.as_deref().map_or(sheet.kernels.whole(), |program| sheet.kernels.only(program));
                self.settle_open(formula, surface, (index, k), job);
            }
            self.settle_waiting(surface, (index, k), job);
            waiting.extend(rest.drain(..).filter(|open| job.hits[open.ray as usize].t > open.a));
        }
        self.open = waiting;
    }

    /// Settles all open rays in one formula.
    fn settle_open(&mut self, formula: Formula, surface: &Surface, (index, k): (usize, usize), job: &mut Job) {
        while !self.open.is_empty() {
            let Registers { cells, along, .. } = &mut self.files[index][k].registers;
            let rays = Rays { list: job.rays, size: surface.size, simd: surface.simd };
            if self.method == Method::Intervals {
                self.pool.run(formula, cells, &rays, &mut self.open, &mut self.found);
            } else {
                self.pool.contract(formula, (cells, along), &rays, &mut self.open, &mut self.found);
                // Numbers too large for forms have one bound at least as intervals.
                std::mem::swap(&mut self.open, &mut self.found.hard);
                self.pool.run(formula, cells, &rays, &mut self.open, &mut self.found);
            }
            self.counts.cells += std::mem::take(&mut self.found.cells);
            for (ray, slabs) in self.found.empty.drain(..) {
                job.hits[ray as usize].cost += slabs;
            }
            let whole = surface.sheets[k].kernels.whole().point().len();
            let steps = formula.point().len();
            // Not by how many there are: what a ray meets must not depend on the others.
            if steps < whole && whole < WAITING * steps {
                self.waiting.append(&mut self.found.brackets);
            } else {
                self.refine(formula, surface, (index, k), job);
            }
            let hard = std::mem::take(&mut self.found.hard);
            for open in &hard {
                let end = open.end.min(open.a + STRETCH * surface.size.max(open.a));
                self.careful(surface, index, k, *open, end, job);
            }
            self.found.hard = hard;
            self.found.hard.clear();
        }
    }

    /// Settles the brackets that wait for others, in all of the formula.
    fn settle_waiting(&mut self, surface: &Surface, (index, k): (usize, usize), job: &mut Job) {
        let whole = surface.sheets[k].kernels.whole();
        std::mem::swap(&mut self.waiting, &mut self.found.brackets);
        self.refine(whole, surface, (index, k), job);
        self.settle_open(whole, surface, (index, k), job);
    }

    /// Refines all brackets found, and files what comes of it.
    fn refine(&mut self, formula: Formula, surface: &Surface, (index, k): (usize, usize), job: &mut Job) {
        let mut brackets = std::mem::take(&mut self.found.brackets);
        // Those that are known to have a root need less, if they are together.
        brackets.sort_by_key(|bracket| !bracket.has_root());
        for chunk in brackets.chunks(POINTS) {
            let Registers { point, gradient, cells, .. } = &mut self.files[index][k].registers;
            let mut files = Files { point, gradient, cells: &mut cells.value };
            self.refined.clear();
            let rays = Rays { list: job.rays, size: surface.size, simd: surface.simd };
            let work = self.batch.run(formula, &mut files, &rays, chunk, &mut self.refined);
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
                if job.settle(bracket.open, Outcome::Hit, t, width) {
                    job.turn(bracket.open.ray, gradient);
                }
            }
            Refined::Root { bracket, .. } | Refined::Unclear(bracket) => {
                self.careful(surface, index, k, bracket.open, bracket.b, job);
            }
        }
    }

    /// Settles the stretch from `open.a` to `b` of one ray.
    fn careful(&mut self, surface: &Surface, index: usize, k: usize, open: Open, b: f64, job: &mut Job) {
        let ray = job.rays.ray(open.ray);
        let memory = &mut self.files[index][k];
        let mut careful = Careful {
            sheet: &surface.sheets[k],
            kind: surface.kind,
            ray: &ray,
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
                    job.doubt.push((open.ray, open.a));
                }
                self.resume(open, b, job);
            }
            End::Root { t, width } => {
                job.settle_bare(open, Outcome::Hit, (t, width), t);
            }
            End::Touch { t, width } => {
                // On the extremum itself the gradient is rounding; a little in front it points away from it.
                job.settle_bare(open, Outcome::Touch, (t, width), t - SHORT_OF_TOUCH * surface.size.max(t));
            }
            End::Undecided { t, width } => {
                job.settle_bare(open, Outcome::Undecided, (t, width), t);
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
    pub(super) fn normals(&mut self, surface: &Surface, index: usize, k: usize, job: &mut Job) {
        let mut bare = std::mem::take(&mut job.bare);
        // What another root turned out to be in front of has none.
        bare.retain(|bare| bare.t == job.hits[bare.ray as usize].t);
        let kernel = surface.sheets[k].kernels.whole().gradient();
        let registers = &mut self.files[index][k].registers.gradient;
        for chunk in bare.chunks(POINTS) {
            let at = |i: usize| &chunk[i.min(chunk.len() - 1)];
            let rays: [Ray; POINTS] = std::array::from_fn(|i| job.rays.ray(at(i).ray));
            let origin = [0, 1, 2].map(|axis| rays.map(|ray| ray.origin[axis]));
            let direction = [0, 1, 2].map(|axis| rays.map(|ray| ray.direction[axis]));
            points_at(
                surface.simd,
                origin.each_ref(),
                direction.each_ref(),
                &std::array::from_fn(|i| at(i).at),
                registers,
            );
            kernel.run(registers);
            self.counts.gradients += chunk.len() as u64;
            for (i, &Bare { ray, .. }) in chunk.iter().enumerate() {
                let [x, y, z] = [1, 2, 3].map(|c| kernel.output(registers, c).0[i]);
                job.turn(ray, DVec3::new(x, y, z));
            }
        }
    }
}
