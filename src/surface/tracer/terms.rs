//! Squares of the screen for a long sum: where its terms do not change, forms take what they come to.
//!
//! In: a part of a rectangle between two depths, and the terms that matter there. Out: hits, and the rays that are still open. Separate from the
//! squares of minima because there is nothing to choose: every term counts, but most are as good as constant somewhere.

use super::squares::{Block, Here};
use crate::surface::bundle::BLOCK;
use super::{Job, Tracer, View};
use crate::surface::screen::place_cells;
use crate::surface::sum::Share;

/// With so few terms nothing is looked for that could be left out.
const FEW: usize = 8;

impl Tracer<'_> {
    /// Settles a part of the rectangle between two depths by the terms of a share.
    pub(super) fn terms(&mut self, here: Here, view: View, block: Block, share: &Share, job: &mut Job) {
        let (surface, sheet) = (here.surface, &here.surface.sheets[here.k]);
        let Some(sum) = &sheet.kernels.sum else { return };
        let Some(block) = self.shrunk(surface.simd, view, block) else { return };
        let is_small = block.place.width.max(block.place.height) <= BLOCK;
        if share.live.len() <= FEW || is_small {
            self.walk(here, sheet.kernels.with_share(share), view, block, job);
            return;
        }
        let cells = block.cells();
        let on_screen: Vec<_> = cells.iter().map(|cell| (view.on_screen(cell.place), cell.depths)).collect();
        let files = &mut self.files[here.index][here.k].registers.forms;
        place_cells(surface.simd, view.screen, &on_screen, &mut files.terms);
        let mut weighed = std::mem::take(&mut self.tiles.weighed);
        sum.weigh(share, files, surface.simd, &mut weighed);
        self.counts.cells += cells.len() as u64;
        let part = |(lane, cell): (usize, &Block)| {
            (!weighed.is_empty[lane]).then(|| sum.part(share, &weighed, lane, cell.depths.1 - cell.depths.0))
        };
        let shares: Vec<Option<Share>> = cells.iter().enumerate().map(part).collect();
        self.tiles.weighed = weighed;
        if shares.iter().flatten().all(|part| part.live.len() == share.live.len()) {
            self.walk(here, sheet.kernels.with_share(share), view, block, job);
            return;
        }
        for (cell, share) in cells.iter().zip(&shares) {
            if let Some(share) = share {
                self.terms(here, view, *cell, share, job);
            }
        }
    }
}
