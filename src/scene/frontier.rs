//! Boxes that a search has still to look at, the most promising first.
//!
//! In: boxes, each with a key. Out: them again, by their rank. As a search goes on keys only fall, for a box promises no more than
//! the one it is part of; so boxes wait in drawers by their keys, and only those of the topmost drawer are put in order. Most
//! searches end with most boxes still in their drawers.

use super::cells::{Asked, Cell, Classify, Cube};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// How many drawers there are: each holds keys that differ by less than the smallest boxes that a search comes to are wide.
const DRAWERS: usize = 1024;

/// No box.
const NONE: u32 = u32::MAX;

/// Boxes on their way.
pub(super) struct Frontier {
    /// Those of the topmost drawer and what has come since: their keys are above those of all others.
    top: BinaryHeap<Ranked>,
    /// All others.
    waiting: Vec<Waiting>,
    /// Boxes whose children have been added.
    parents: Vec<Cube>,
    /// The first of each drawer, from the largest keys down.
    drawers: Vec<u32>,
    /// Drawers above this one are empty, and it is the one that is open.
    open: usize,
    largest: f64,
    per_drawer: f64,
}

/// A box in a drawer: a few bytes, for there are many and most are never taken out.
#[derive(Clone, Copy)]
struct Waiting {
    key: f64,
    /// The next in the drawer.
    next: u32,
    /// Which child of which parent it is: eight numbers for each parent.
    place: u32,
    cell: Cell,
}

impl Frontier {
    /// Without boxes, for keys that are mostly from `largest` down to `largest − span`.
    pub(super) fn new(largest: f64, span: f64) -> Self {
        let per_drawer = DRAWERS as f64 / span;
        let (top, waiting, parents) = (BinaryHeap::new(), Vec::new(), Vec::new());
        Frontier { top, waiting, parents, drawers: vec![NONE; DRAWERS], open: 0, largest, per_drawer }
    }

    /// Adds a box that nothing in a drawer can be above: the first, or one that was just taken out.
    pub(super) fn push(&mut self, ranked: Ranked) {
        self.top.push(ranked);
    }

    /// Adds the children of a box, with what is proven of each.
    pub(super) fn push_children(&mut self, parent: Cube, classify: Classify, key: &dyn Fn(&Cube) -> f64) {
        let first = self.parents.len() as u32 * 8;
        self.parents.push(parent);
        for (place, asked) in (first..).zip(parent.asked_children(classify)) {
            let key = key(&asked.cube);
            // A number that is none, or too large or small, becomes the first or the last.
            let drawer = (((self.largest - key) * self.per_drawer) as usize).min(DRAWERS - 1);
            if drawer <= self.open {
                self.top.push(Ranked { key, asked });
            } else {
                let next = std::mem::replace(&mut self.drawers[drawer], self.waiting.len() as u32);
                self.waiting.push(Waiting { key, next, place, cell: asked.cell });
            }
        }
    }

    /// Takes away the box of the highest rank.
    pub(super) fn pop(&mut self) -> Option<Ranked> {
        while self.top.is_empty() && self.open + 1 < DRAWERS {
            self.open += 1;
            let mut number = std::mem::replace(&mut self.drawers[self.open], NONE);
            while number != NONE {
                let Waiting { key, next, place, cell } = self.waiting[number as usize];
                let cube = self.parents[place as usize / 8].child(place as usize % 8);
                self.top.push(Ranked { key, asked: Asked { cube, cell } });
                number = next;
            }
        }
        self.top.pop()
    }
}

/// A box with its rank: the largest key first, of equal keys the smallest box, then by place.
#[derive(Clone, Copy)]
pub(super) struct Ranked {
    pub key: f64,
    pub asked: Asked,
}

impl Ranked {
    pub(super) fn new(asked: Asked, key: &dyn Fn(&Cube) -> f64) -> Self {
        Ranked { key: key(&asked.cube), asked }
    }
}

impl Ord for Ranked {
    fn cmp(&self, other: &Self) -> Ordering {
        let (a, b) = (&self.asked.cube, &other.asked.cube);
        let by_place = || {
            let [x, y, z] = [0, 1, 2].map(|axis| a.min[axis].total_cmp(&b.min[axis]));
            x.then(y).then(z)
        };
        self.key.total_cmp(&other.key).then_with(|| b.width().total_cmp(&a.width())).then_with(by_place)
    }
}

impl PartialOrd for Ranked {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Ranked {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Ranked {}

#[cfg(test)]
mod tests {
    use super::super::cells::each;
    use super::*;
    use glam::DVec3;

    /// Boxes are cut as a search cuts them, by keys of which many are equal and some are beyond the ends of what was said.
    #[test]
    fn boxes_come_by_their_rank() {
        let classify = each(|min, _| if min.x + min.y > 0.3 { Cell::Empty } else { Cell::Possible });
        let keys: [(&dyn Fn(&Cube) -> f64, f64, f64); 4] = [
            (&|cube| cube.max.z, 1.0, 2.0),
            (&|cube| cube.max.z, 0.5, 0.25),
            (&|cube| cube.farthest(DVec3::ZERO), 1.8, 3.5),
            (&|cube| -cube.nearest_point().length(), 0.0, 6.0),
        ];
        for (key, largest, span) in keys {
            let mut frontier = Frontier::new(largest, span);
            let mut all = BinaryHeap::new();
            let first = Ranked::new(Cube::around_origin(1.0).asked(&classify), key);
            frontier.push(first);
            all.push(first);
            for _ in 0..5000 {
                let (found, expected) = (frontier.pop(), all.pop());
                assert!(found == expected);
                let Some(Ranked { asked, .. }) = expected else { break };
                assert_eq!(found.map(|found| found.asked.cell), Some(asked.cell));
                if asked.cell == Cell::Possible && asked.cube.width() > 1e-2 {
                    frontier.push_children(asked.cube, &classify, key);
                    all.extend(asked.cube.asked_children(&classify).map(|child| Ranked::new(child, key)));
                }
            }
        }
    }
}
