//! Squares of the screen: what of a rectangle they can settle, with the part of the formula that matters there.
//!
//! In: the rays of a rectangle. Out: hits, and the rays that are still open. Separate from single rays because these
//! have much in common: what matters is found out for many at once.

use super::{FAR, Job, Tiles, Tracer, View};
use crate::closure::specialise::SLABS;
use crate::num::level::Simd;
use crate::surface::bundle::Bundle;
use crate::surface::hit::Outcome;
use crate::surface::isolate::Open;
use crate::surface::kernels::{Formula, Program};
use crate::surface::memory::Registers;
use crate::surface::screen::{Rectangle, place_cells};
use crate::surface::sheet::Surface;
use crate::surface::spans::{SHORTENED, Spans};
use crate::surface::stream::{End, Sink, Stream, Tools};
use crate::surface::tile::{Crossing, Place, Rest};
use std::ops::Range;

/// A rectangle in which more arguments than this matter is quartered.
const MANY: usize = 8;

/// A rectangle of this side is not: lanes would be empty.
const SMALLEST: u32 = 8;

/// Where more than one argument for so many pixels matters, rays go one by one through an index of space if there is one: squares would hardly be
/// settled before they are single rays.
const PER_ARGUMENT: u32 = 50;

/// What matters is found out for this many layers of each quarter, one behind the other.
const LAYERS: usize = SLABS / 4;

/// Pixels of the rectangle between two depths.
#[derive(Clone, Copy)]
pub(super) struct Block {
    pub(super) place: Rectangle,
    pub(super) depths: (f64, f64),
}

impl Block {
    /// Its quarters, each in as many layers, from the front.
    pub(super) fn cells(&self) -> Vec<Block> {
        let Block { place, depths: (a, end) } = *self;
        let side = (place.width.max(place.height).next_power_of_two() / 2).max(1);
        let step = (end - a) / LAYERS as f64;
        let edge = |layer: usize| if layer == LAYERS { end } else { a + layer as f64 * step };
        place
            .parts(side)
            .flat_map(|quarter| {
                let (left, top) = (place.left + quarter.left, place.top + quarter.top);
                let place = Rectangle { left, top, ..quarter };
                (0..LAYERS).map(move |layer| Block { place, depths: (edge(layer), edge(layer + 1)) })
            })
            .collect()
    }
}

/// A sheet of a surface by its numbers.
#[derive(Clone, Copy)]
pub(super) struct Here<'a> {
    pub(super) surface: &'a Surface,
    pub(super) index: usize,
    pub(super) k: usize,
}

impl Tracer<'_> {
    /// Settles what squares of the screen can, and opens the rays of the rest.
    pub(super) fn squares(
        &mut self,
        surface: &Surface,
        index: usize,
        k: usize,
        skipped: f64,
        view: View,
        job: &mut Job,
    ) {
        let spans = &mut self.tiles.spans;
        spans.fill(view.bundle, &surface.shapes, (skipped * surface.size, FAR), surface.simd);
        if (index, k) != (0, 0) {
            spans.end_at(view.bundle, job.hits);
        }
        let Rectangle { width, height, .. } = view.rectangle;
        let all = Rectangle { left: 0, top: 0, width, height };
        let here = Here { surface, index, k };
        self.part(here, view, Block { place: all, depths: (0.0, f64::INFINITY) }, None, job);
    }

    /// Settles a part of the rectangle between two depths, where these arguments matter (`None`: all).
    fn part(&mut self, here: Here, view: View, block: Block, among: Option<&[u32]>, job: &mut Job) {
        let sheet = &here.surface.sheets[here.k];
        if let Some(sum) = &sheet.kernels.sum {
            self.terms(here, view, block, sum.whole(), job);
            return;
        }
        let Some(parts) = &sheet.kernels.parts else {
            self.walk_through(here, sheet.kernels.whole(), view, block, job);
            return;
        };
        let Some(block) = self.shrunk(here.surface.simd, view, block) else { return };
        let every: Vec<u32>;
        let among = match among {
            Some(among) => among,
            None => {
                every = (0..parts.choices.arguments() as u32).collect();
                &every
            }
        };
        let cells = block.cells();
        let registers = &mut self.files[here.index][here.k].leaves;
        let on_screen: Vec<_> = cells.iter().map(|cell| (view.on_screen(cell.place), cell.depths)).collect();
        place_cells(here.surface.simd, view.screen, &on_screen, registers);
        let steps = parts.steps_of(among);
        let leaves = parts.leaves(&steps);
        leaves.run(registers);
        let mut bits = Vec::with_capacity(among.len());
        parts.choices.live(here.surface.simd, &leaves, registers, among, &mut bits);
        self.counts.cells += cells.len() as u64;
        let live = |cells: Range<usize>| -> Vec<u32> {
            let mask = cells.fold(0, |mask, lane| mask | 1u16 << lane);
            among.iter().zip(&bits).filter(|(_, bits)| **bits & mask != 0).map(|(&k, _)| k).collect()
        };
        let all = live(0..cells.len());
        let is_crowded = all.len() as u32 * PER_ARGUMENT > block.place.width * block.place.height;
        let is_small = block.place.width.max(block.place.height) <= SMALLEST;
        if all.len() > MANY && is_crowded && sheet.index.is_some() {
            self.open_block(view, block);
            return;
        }
        if all.len() <= MANY || is_small {
            self.settle(here, view, block, &all, job);
            return;
        }
        for first in (0..cells.len()).step_by(LAYERS) {
            let mut layer = first;
            while layer < first + LAYERS {
                let mut end = layer + 1;
                let mut here_live = live(layer..end);
                while end < first + LAYERS && live(layer..end + 1).len() <= MANY {
                    end += 1;
                    here_live = live(layer..end);
                }
                let depths = (cells[layer].depths.0, cells[end - 1].depths.1);
                let part = Block { depths, ..cells[layer] };
                if here_live.len() > MANY {
                    self.part(here, view, part, Some(&here_live), job);
                } else {
                    self.settle(here, view, part, &here_live, job);
                }
                layer = end;
            }
        }
    }

    /// Settles a block where these arguments alone matter.
    fn settle(&mut self, here: Here, view: View, block: Block, live: &[u32], job: &mut Job) {
        if !live.is_empty() {
            let program = Program::new(live);
            let formula = here.surface.sheets[here.k].kernels.only(&program);
            if let Some(block) = self.shrunk(here.surface.simd, view, block) {
                self.walk_through(here, formula, view, block, job);
            }
        }
    }

    /// A block without what lies in front of and behind the rays that are still looked at; `None` if there are none.
    pub(super) fn shrunk(&self, simd: Simd, view: View, block: Block) -> Option<Block> {
        let spans = &self.tiles.spans;
        let each = Place::of(block.place, view.bundle);
        let depths = each.filter_map(|square| spans.depths(view.bundle, square.first, square.count(), simd));
        let depths = depths.reduce(|(a, end), (b, last)| (a.min(b), end.max(last)));
        depths.and_then(|found| meet(beyond(found), block.depths)).map(|depths| Block { depths, ..block })
    }

    /// Settles what squares of a part of the rectangle can in one formula, and opens the rays of the rest. Some roots
    /// may wait for more of the same formula, until [`Self::finish`].
    pub(super) fn walk(&mut self, here: Here, formula: Formula, view: View, block: Block, job: &mut Job) {
        self.look(here, formula, view, block, false);
        self.stream(here, formula, view, job, |stream, crossings, tools, filing| {
            for crossing in crossings {
                stream.take(crossing, view.bundle, tools, filing);
            }
        });
        self.open_rest(view.bundle);
    }

    /// The same, until none waits. Rays that begin behind a root go on in their squares.
    fn walk_through(&mut self, here: Here, formula: Formula, view: View, block: Block, job: &mut Job) {
        self.look(here, formula, view, block, false);
        loop {
            let mut begun = 0;
            self.stream(here, formula, view, job, |stream, crossings, tools, filing| {
                filing.begun = Some(0);
                for crossing in crossings {
                    stream.take(crossing, view.bundle, tools, filing);
                }
                stream.finish(tools, filing);
                begun = filing.begun.unwrap_or(0);
            });
            self.open_rest(view.bundle);
            if begun == 0 {
                return;
            }
            self.look(here, formula, view, block, true);
        }
    }

    /// Walks the squares of a block, or goes on behind the crossings that they have found.
    fn look(&mut self, here: Here, formula: Formula, view: View, block: Block, goes_on: bool) {
        let (simd, bundle) = (here.surface.simd, view.bundle);
        let Tiles { walk, settled, spans, .. } = &mut self.tiles;
        let forms = &mut self.files[here.index][here.k].registers.forms;
        let range = |square: Place| {
            let found = spans.depths(bundle, square.first, square.count(), simd);
            found.and_then(|found| meet(found, block.depths))
        };
        let screen = (view.screen, view.rectangle, simd);
        if goes_on {
            walk.resume(formula, forms, screen, range, settled);
        } else {
            settled.clear();
            walk.run(formula, forms, screen, (block.place, bundle, block.depths, range), settled);
        }
        self.counts.cells += settled.cells;
    }

    /// Opens all rays of a block.
    fn open_block(&mut self, view: View, Block { place, depths: (a, end) }: Block) {
        self.tiles.settled.clear();
        let rest = Place::of(place, view.bundle).map(|place| Rest { place, a, step: end - a, cost: 0 });
        self.tiles.settled.rest.extend(rest);
        self.open_rest(view.bundle);
    }

    /// Opens the rays that squares have left.
    fn open_rest(&mut self, bundle: &Bundle) {
        let Tiles { settled, spans, .. } = &mut self.tiles;
        for &Rest { place, a, step, cost } in &settled.rest {
            for i in place.first..place.first + place.count() {
                let (t0, t1, long) = (spans.near[i], spans.far[i], bundle.length[i]);
                let a = t0.max(a * long * SHORTENED);
                if a <= t1 {
                    spans.far[i] = a;
                    self.open.push(Open { ray: bundle.pixel[i], a, end: t1, step: step * long, slabs: cost });
                }
            }
        }
    }

    /// Settles the roots that wait.
    pub(super) fn finish(&mut self, here: Here, formula: Formula, view: View, job: &mut Job) {
        self.stream(here, formula, view, job, |stream, _, tools, filing| stream.finish(tools, filing));
    }

    /// Works on the stream of roots of a formula.
    fn stream(
        &mut self,
        Here { surface, index, k }: Here,
        formula: Formula,
        view: View,
        job: &mut Job,
        work: impl FnOnce(&mut Stream, &[Crossing], &mut Tools, &mut Filing),
    ) {
        let Tiles { settled, stream, spans, .. } = &mut self.tiles;
        let Registers { gradient, balls, cells, .. } = &mut self.files[index][k].registers;
        let (cells, size, simd) = (&mut cells.value, surface.size, surface.simd);
        let mut tools = Tools { formula, gradient, balls, cells, size, simd, evaluations: 0, enclosures: 0 };
        let mut filing = Filing { bundle: view.bundle, spans, open: &mut self.open, job, begun: None };
        work(stream, &settled.crossings, &mut tools, &mut filing);
        self.counts.gradients += tools.evaluations;
        self.counts.cells += tools.enclosures;
    }
}

/// Files what the stream finds.
struct Filing<'a, 'b> {
    bundle: &'a Bundle,
    spans: &'a mut Spans,
    open: &'a mut Vec<Open>,
    job: &'a mut Job<'b>,
    /// How many rays have begun behind a root, if their squares go on.
    begun: Option<u32>,
}

impl Sink for Filing<'_, '_> {
    fn spans(&self) -> &Spans {
        self.spans
    }

    #[inline(always)]
    fn hit(&mut self, place: usize, cost: u32, t: f64, width: f64, [x, y, z]: [f64; 3], flipped: bool) {
        self.spans.far[place] = t;
        let (surface, sheet) = (self.job.surface, self.job.sheet);
        let hit = &mut self.job.hits[self.bundle.pixel[place] as usize];
        // Number by number: a copy in larger pieces would wait until all of them are in memory.
        (hit.outcome, hit.proven, hit.flipped) = (Outcome::Hit, true, flipped);
        (hit.t, hit.width) = (t, width);
        (hit.surface, hit.sheet) = (surface, sheet);
        (hit.normal.x, hit.normal.y, hit.normal.z) = (x, y, z);
        hit.cost += cost;
    }

    fn other(&mut self, place: usize, cost: u32, (a, b): (f64, f64), end: End) {
        let (t0, t1) = (self.spans.near[place], self.spans.far[place]);
        let ray = self.bundle.pixel[place];
        let again = Open { ray, a: a.max(t0), end: t1, step: b - a, slabs: cost };
        match end {
            _ if again.a > t1 => {}
            End::Unknown => {
                self.spans.far[place] = again.a;
                self.open.push(again);
            }
            End::Before => match &mut self.begun {
                Some(begun) => {
                    *begun += 1;
                    self.spans.near[place] = b.max(t0);
                }
                None => {
                    self.spans.far[place] = f64::NEG_INFINITY;
                    self.open.extend((b < t1).then_some(Open { a: b.max(t0), ..again }));
                }
            },
            End::Behind => self.job.hits[ray as usize].cost += cost,
        }
    }
}

/// A stretch of depths with a margin: squares may look a little beyond their rays' ends.
fn beyond((first, last): (f64, f64)) -> (f64, f64) {
    (first * 0.9, if last < FAR { last + 0.1 * (last - first) } else { last })
}

/// What two stretches have in common.
fn meet(a: (f64, f64), b: (f64, f64)) -> Option<(f64, f64)> {
    let (first, last) = (a.0.max(b.0), a.1.min(b.1));
    (first <= last).then_some((first, last))
}
