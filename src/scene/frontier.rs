//! Boxes that a search has still to look at, the most promising first.
//!
//! In: boxes, each with a key. Out: them again, by their rank. As a search goes on keys only fall, for a box promises no more than
//! the one it is part of; so boxes wait in drawers by their keys, and only those of the topmost drawer are put in order. Most
//! searches end with most boxes still in their drawers.

use super::cells::{Asked, Cube};
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
    /// All others, each with the number of the next in its drawer.
    waiting: Vec<(Ranked, u32)>,
    /// The first of each drawer, from the largest keys down.
    drawers: Vec<u32>,
    /// Drawers above this one are empty, and it is the one that is open.
    open: usize,
    largest: f64,
    per_drawer: f64,
}

impl Frontier {
    /// Without boxes, for keys that are mostly from `largest` down to `largest − span`.
    pub(super) fn new(largest: f64, span: f64) -> Self {
        let per_drawer = DRAWERS as f64 / span;
        let (top, waiting) = (BinaryHeap::new(), Vec::new());
        Frontier { top, waiting, drawers: vec![NONE; DRAWERS], open: 0, largest, per_drawer }
    }

    /// Adds a box.
    pub(super) fn push(&mut self, ranked: Ranked) {
        // A number that is none, or too large or small, becomes the first or the last.
        let drawer = (((self.largest - ranked.key) * self.per_drawer) as usize).min(DRAWERS - 1);
        if drawer <= self.open {
            self.top.push(ranked);
        } else {
            let number = self.waiting.len() as u32;
            self.waiting.push((ranked, std::mem::replace(&mut self.drawers[drawer], number)));
        }
    }

    /// Takes away the box of the highest rank.
    pub(super) fn pop(&mut self) -> Option<Ranked> {
        while self.top.is_empty() && self.open + 1 < DRAWERS {
            self.open += 1;
            let mut next = std::mem::replace(&mut self.drawers[self.open], NONE);
            while next != NONE {
                let (ranked, behind) = self.waiting[next as usize];
                self.top.push(ranked);
                next = behind;
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
    use super::super::cells::Cell;
    use super::*;
    use glam::DVec3;

    /// Boxes by chance, whose keys are also equal, beyond the ends of what was said, and rising a little.
    #[test]
    fn boxes_come_by_their_rank_whenever_they_are_added() {
        let mut random = 1u64;
        let mut chance = move |n: u64| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (random >> 33) % n
        };
        let mut frontier = Frontier::new(5.0, 8.0);
        let mut all = BinaryHeap::new();
        let mut floor = 6.0;
        for _ in 0..20_000 {
            if chance(3) > 0 {
                let key = floor - chance(640) as f64 / 64.0;
                let min = DVec3::new(chance(3) as f64, chance(3) as f64, chance(3) as f64);
                let cube = Cube { min, max: min + 1.0 + chance(2) as f64 };
                let ranked = Ranked { key, asked: Asked { cube, cell: Cell::Possible } };
                frontier.push(ranked);
                all.push(ranked);
            } else {
                let (found, expected) = (frontier.pop(), all.pop());
                assert!(found == expected);
                floor = expected.map_or(floor, |ranked: Ranked| ranked.key + 1e-9);
            }
        }
        while let Some(expected) = all.pop() {
            assert!(frontier.pop() == Some(expected));
        }
        assert!(frontier.pop().is_none());
    }
}
