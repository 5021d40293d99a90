//! Rays one by one: what of each is open is settled by forms and intervals, with the part of the formula that matters there.
//!
//! In: open rays. Out: their hits. Separate from the door because it knows no picture.

use super::{FAR, Job, Method, STRETCH, Tracer};
use crate::surface::careful::{Careful, End};
use crate::surface::hit::{Outcome, Ray};
use crate::surface::index::{Piece, Scratch};
use crate::surface::isolate::{Open, Rays};
use crate::surface::kernels::Formula;
use crate::surface::memory::Registers;
use crate::surface::refine::{Files, Refined, points_at};
use crate::surface::sheet::{POINTS, Surface};
use glam::DVec3;

/// How far in front of a touch its normal is taken, as a part of the scale.
const SHORT_OF_TOUCH: f64 = 1e-5;

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
        let Some(map) = &sheet.index else {
            self.settle_open(sheet.kernels.whole(), surface, (index, k), job);
            return;
        };
        let mut waiting = std::mem::take(&mut self.open);
        let mut pieces: Vec<(Piece, Open)> = Vec::new();
        while !waiting.is_empty() {
            let memory = &mut self.files[index][k];
            let mut scratch = Scratch { leaves: &mut memory.leaves, value: &mut memory.registers.forms.value };
            for open in waiting.drain(..) {
                let ray = job.rays.ray(open.ray);
                match map.piece(&sheet.kernels, &ray, (open.a, open.end), &mut scratch) {
                    Some(piece) => pieces.push((piece, open)),
                    None => job.hits[open.ray as usize].cost += open.slabs,
                }
            }
            pieces.sort_unstable_by_key(|(piece, open)| (piece.place(), open.ray));
            for group in pieces.chunk_by(|(p, _), (q, _)| p.place() == q.place()) {
                self.open.extend(group.iter().rev().map(|(piece, open)| {
                    let length = piece.b - piece.a;
                    let step = if piece.a > open.a { length } else { length.min(open.step) };
                    Open { a: piece.a, end: piece.b, step, ..*open }
                }));
                let program = group[0].0.program.as_deref();
                let formula = program.map_or(sheet.kernels.whole(), |program| sheet.kernels.only(program));
                self.settle_open(formula, surface, (index, k), job);
            }
            for (piece, open) in pieces.drain(..) {
                if piece.b < open.end && job.hits[open.ray as usize].t > piece.b {
                    waiting.push(Open { a: piece.b, step: open.end - piece.b, slabs: 0, ..open });
                }
            }
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
            self.refine(formula, surface, (index, k), job);
            let hard = std::mem::take(&mut self.found.hard);
            for open in &hard {
                let end = open.end.min(open.a + STRETCH * surface.size.max(open.a));
                self.careful(surface, index, k, *open, end, job);
            }
            self.found.hard = hard;
            self.found.hard.clear();
        }
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
    pub(super) fn normals(&mut self, surface: &Surface, index: usize, k: usize, job: &mut Job) {
        let bare = std::mem::take(&mut job.bare);
        let kernel = surface.sheets[k].kernels.whole().gradient();
        let registers = &mut self.files[index][k].registers.gradient;
        for chunk in bare.chunks(POINTS) {
            let at = |i: usize| &chunk[i.min(chunk.len() - 1)];
            let rays: [Ray; POINTS] = std::array::from_fn(|i| job.rays.ray(at(i).0));
            let origin = [0, 1, 2].map(|axis| rays.map(|ray| ray.origin[axis]));
            let direction = [0, 1, 2].map(|axis| rays.map(|ray| ray.direction[axis]));
            points_at(
                surface.simd,
                origin.each_ref(),
                direction.each_ref(),
                &std::array::from_fn(|i| at(i).1),
                registers,
            );
            kernel.run(registers);
            self.counts.gradients += chunk.len() as u64;
            for (i, &(ray, _)) in chunk.iter().enumerate() {
                let [x, y, z] = [1, 2, 3].map(|c| kernel.output(registers, c).0[i]);
                job.turn(ray, DVec3::new(x, y, z));
            }
        }
    }
}
