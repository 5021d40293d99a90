//! Squares of the screen for a long sum: where its terms do not change, forms take what they come to.
//!
//! In: a part of a rectangle. Out: hits, and the rays that are still open. Separate from the squares of minima because there
//! is nothing to choose: every term counts, but most are as good as constant somewhere.

use super::squares::{Block, Here};
use super::{Job, Tracer, View};
use crate::surface::bundle::BLOCK;
use crate::surface::screen::{Rectangle, place_cells};
use crate::surface::sum::Share;

/// With so few terms nothing is looked for that could be left out.
const FEW: usize = 8;

impl Tracer<'_> {
    /// Settles a part of the rectangle by the terms of its blocks, from the front. Blocks side by side share the batches of points.
    pub(super) fn terms(&mut self, here: Here, view: View, block: Block, share: Share, job: &mut Job) {
        let mut leaves = Vec::new();
        self.divide(here, view, block, share, &mut leaves);
        leaves.sort_by(|(a, _), (b, _)| a.depths.0.total_cmp(&b.depths.0));
        let kernels = &here.surface.sheets[here.k].kernels;
        let mut covered: Vec<Rectangle> = Vec::new();
        for (block, share) in &leaves {
            if covered.iter().any(|place| place.meets(block.place)) {
                self.finish(here, kernels.whole(), view, job);
                covered.clear();
            }
            self.walk(here, kernels.with_share(share), view, *block, job);
            covered.push(block.place);
        }
        self.finish(here, kernels.whole(), view, job);
    }

    /// Divides a block until dividing leaves nothing out; blocks without a root are left out themselves.
    fn divide(&mut self, here: Here, view: View, block: Block, share: Share, leaves: &mut Vec<(Block, Share)>) {
        let (surface, sheet) = (here.surface, &here.surface.sheets[here.k]);
        let Some(sum) = &sheet.kernels.sum else { return };
        let Some(block) = self.shrunk(surface.simd, view, block) else { return };
        if share.live.len() <= FEW || block.place.width.max(block.place.height) <= BLOCK {
            leaves.push((block, share));
            return;
        }
        let cells = block.cells();
        let on_screen: Vec<_> = cells.iter().map(|cell| (view.on_screen(cell.place), cell.depths)).collect();
        let files = &mut self.files[here.index][here.k].registers.forms;
        place_cells(surface.simd, view.screen, &on_screen, &mut files.terms);
        let weighed = sum.weigh(&share, files, surface.simd);
        self.counts.cells += cells.len() as u64;
        let parts: Vec<(Block, Share)> = (cells.iter().enumerate())
            .filter(|(lane, _)| !weighed.is_empty[*lane])
            .map(|(lane, cell)| (*cell, sum.part(&share, &weighed, lane, cell.depths.1 - cell.depths.0)))
            .collect();
        if parts.iter().all(|(_, part)| part.live.len() == share.live.len()) && !parts.is_empty() {
            leaves.push((block, share));
            return;
        }
        for (cell, part) in parts {
            self.divide(here, view, cell, part, leaves);
        }
    }
}
