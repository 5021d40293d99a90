//! What is farthest among the boxes that may hold a surface.
//!
//! In: a question that can be asked of boxes, and a key that says how far one reaches. Out: the largest key. The search goes from the
//! largest keys down. As a box promises no more than the one it is part of, boxes wait in drawers by their keys, and those of
//! a drawer need no order while there is work left for all of them and none is small enough to be what is looked for.

use super::cells::{Asked, Cell, Classify, Cube};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Boxes asked about in one search; more would not be seen in the picture.
pub(super) const EXTREME_CELLS: u32 = 12_000;

/// An extreme is found to this share of the searched box.
pub(super) const EXTREME_SHARE: f64 = 1.0 / 256.0;

/// Boxes of the largest keys that are followed down to something when a search has no work left.
const DIVES: usize = 16;

/// Boxes asked about while they are followed.
const DIVE_CELLS: u32 = 20_000;

/// How many drawers there are: each holds keys that differ by less than the smallest boxes that a search comes to are wide.
const DRAWERS: usize = 1024;

/// No box.
const NONE: u32 = u32::MAX;

/// The largest key of a box that may hold a surface, found to `width`; `None` if no box can. The key of a box is not less than
/// that of a box inside it.
///
/// Without work left, the boxes of the largest keys are followed down one by one: then the key is that of a box that
/// may hold a surface, as before, and may be less than the largest by what the margin makes good.
pub(super) fn extreme(
    classify: Classify,
    within: Cube,
    width: f64,
    cells: u32,
    key: &dyn Fn(&Cube) -> f64,
) -> Option<f64> {
    let first = within.asked(classify);
    if first.cell != Cell::Possible || within.width() <= width {
        return (first.cell == Cell::Possible).then(|| key(&within));
    }
    let mut search = Search::new(classify, within, width, key);
    let mut cells_left = cells.saturating_sub(1);
    search.expand(within, None, |_, _| {});
    for drawer in 0..DRAWERS {
        match search.in_any_order(drawer, cells_left) {
            Some(asked) => cells_left -= asked,
            None => return search.by_rank(drawer, cells_left),
        }
    }
    None
}

struct Search<'a> {
    classify: Classify<'a>,
    width: f64,
    key: &'a dyn Fn(&Cube) -> f64,
    waiting: Vec<Waiting>,
    /// Boxes whose children have been added.
    parents: Vec<Cube>,
    /// The first box of each drawer, from the largest keys down.
    drawers: Vec<u32>,
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

impl<'a> Search<'a> {
    fn new(classify: Classify<'a>, within: Cube, width: f64, key: &'a dyn Fn(&Cube) -> f64) -> Self {
        // A key changes by about as much as the place does.
        let per_drawer = DRAWERS as f64 / (within.max - within.min).length();
        let (waiting, parents, drawers) = (Vec::new(), Vec::new(), vec![NONE; DRAWERS]);
        Search { classify, width, key, waiting, parents, drawers, largest: key(&within), per_drawer }
    }

    fn drawer_of(&self, key: f64) -> usize {
        // A number that is none, or too large or small, becomes the first or the last.
        (((self.largest - key) * self.per_drawer) as usize).min(DRAWERS - 1)
    }

    fn cube(&self, place: u32) -> Cube {
        self.parents[place as usize / 8].child(place as usize % 8)
    }

    /// The boxes in a drawer.
    fn in_drawer(&self, drawer: usize) -> impl Iterator<Item = Waiting> {
        let from = |number: u32| self.waiting.get(number as usize).copied();
        std::iter::successors(from(self.drawers[drawer]), move |waiting| from(waiting.next))
    }

    /// Puts the children of a box into drawers; those that are not below the open one are handed out instead.
    fn expand(&mut self, parent: Cube, open: Option<usize>, mut take: impl FnMut(Waiting, Cube)) {
        let first = self.parents.len() as u32 * 8;
        self.parents.push(parent);
        let cubes = parent.children();
        let mut cells = [Cell::Possible; 8];
        (self.classify)(&cubes, &mut cells);
        // By reference: to move a box that has just been written waits until it is.
        for ((place, cube), cell) in (first..).zip(&cubes).zip(cells) {
            let key = (self.key)(cube);
            let drawer = self.drawer_of(key);
            if open.is_some_and(|open| drawer <= open) {
                take(Waiting { key, next: NONE, place, cell }, *cube);
            } else {
                let next = std::mem::replace(&mut self.drawers[drawer], self.waiting.len() as u32);
                self.waiting.push(Waiting { key, next, place, cell });
            }
        }
    }

    /// Asks about all boxes of a drawer; how many there were. `None`, and all as it was, if there are too many or one is what may be
    /// looked for: then their order matters.
    fn in_any_order(&mut self, drawer: usize, cells_left: u32) -> Option<u32> {
        let (waiting, parents) = (self.waiting.len(), self.parents.len());
        let mut stack: Vec<Waiting> = self.in_drawer(drawer).collect();
        let mut asked = 0;
        while let Some(Waiting { place, cell, .. }) = stack.pop() {
            asked += 1;
            let cube = self.cube(place);
            let is_possible = cell == Cell::Possible;
            if asked > cells_left || is_possible && cube.width() <= self.width {
                while self.waiting.len() > waiting
                    && let Some(last) = self.waiting.pop()
                {
                    let drawer = self.drawer_of(last.key);
                    self.drawers[drawer] = last.next;
                }
                self.parents.truncate(parents);
                return None;
            }
            if is_possible {
                self.expand(cube, Some(drawer), |child, _| stack.push(child));
            }
        }
        Some(asked)
    }

    /// Goes on from a drawer one box at a time.
    fn by_rank(mut self, mut open: usize, mut cells_left: u32) -> Option<f64> {
        let mut queue = BinaryHeap::new();
        loop {
            queue.extend(self.in_drawer(open).map(|waiting| self.ranked(waiting)));
            while let Some(top) = queue.pop() {
                if cells_left == 0 {
                    queue.push(top);
                    return self.dives(queue, open).or(Some(top.key));
                }
                cells_left -= 1;
                let Asked { cube, cell } = top.asked;
                if cell == Cell::Possible {
                    if cube.width() <= self.width {
                        return Some(top.key);
                    }
                    let take =
                        |Waiting { key, cell, .. }, cube| queue.push(Ranked { key, asked: Asked { cube, cell } });
                    self.expand(cube, Some(open), take);
                }
            }
            open += 1;
            if open == DRAWERS {
                return None;
            }
        }
    }

    fn ranked(&self, Waiting { key, place, cell, .. }: Waiting) -> Ranked {
        Ranked { key, asked: Asked { cube: self.cube(place), cell } }
    }

    /// The largest key that is found by following the boxes of the largest keys down.
    fn dives(&self, mut queue: BinaryHeap<Ranked>, open: usize) -> Option<f64> {
        let mut cells_left = DIVE_CELLS;
        let mut keys = Vec::new();
        let mut drawers = open + 1..DRAWERS;
        while keys.len() < DIVES && cells_left > 0 {
            let Some(top) = queue.pop() else {
                let Some(drawer) = drawers.next() else { break };
                queue.extend(self.in_drawer(drawer).map(|waiting| self.ranked(waiting)));
                continue;
            };
            keys.extend(self.dive(top.asked, &mut cells_left));
        }
        keys.into_iter().reduce(f64::max)
    }

    /// The key of a smallest box in the cube that may hold a surface, largest keys first.
    fn dive(&self, Asked { cube, cell }: Asked, cells_left: &mut u32) -> Option<f64> {
        if *cells_left == 0 {
            return None;
        }
        *cells_left -= 1;
        if cell != Cell::Possible {
            return None;
        }
        let key = self.key;
        if cube.width() <= self.width {
            return Some(key(&cube));
        }
        let mut children = cube.asked_children(self.classify);
        children.sort_by(|a, b| key(&b.cube).total_cmp(&key(&a.cube)));
        children.into_iter().find_map(|child| self.dive(child, cells_left))
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

    /// The same by a queue alone.
    fn by_queue(
        classify: Classify,
        within: Cube,
        width: f64,
        cells: u32,
        key: &dyn Fn(&Cube) -> f64,
    ) -> (Option<f64>, bool) {
        let mut queue = BinaryHeap::from([Ranked::new(within.asked(classify), key)]);
        let mut cells_left = cells;
        while let Some(top) = queue.pop() {
            if cells_left == 0 {
                let search = Search::new(classify, within, width, key);
                queue.push(top);
                return (search.dives(queue, DRAWERS - 1).or(Some(top.key)), true);
            }
            cells_left -= 1;
            if top.asked.cell == Cell::Possible {
                if top.asked.cube.width() <= width {
                    return (Some(top.key), false);
                }
                queue.extend(top.asked.cube.asked_children(classify).map(|child| Ranked::new(child, key)));
            }
        }
        (None, false)
    }

    #[test]
    fn drawers_change_nothing() {
        let on_ball = |min: DVec3, max: DVec3| {
            let cube = Cube { min, max };
            let is_on = cube.nearest_point().length() <= 0.8 && cube.farthest(DVec3::ZERO) >= 0.8;
            if is_on { Cell::Possible } else { Cell::Empty }
        };
        let on_plate = |min: DVec3, max: DVec3| {
            if min.z <= 0.3 && max.z >= 0.3 && min.x <= 0.7 { Cell::Possible } else { Cell::Positive }
        };
        let few = |min: DVec3, max: DVec3| if max.x - min.x < 0.1 { Cell::Empty } else { Cell::Possible };
        let aslant = DVec3::new(0.6, -0.7, 0.4);
        let keys: [&dyn Fn(&Cube) -> f64; 4] =
            [&|cube| cube.max.z, &|cube| -cube.min.x, &|cube| cube.farthest(DVec3::new(0.1, 0.0, 0.0)), &|cube| {
                ((cube.min + cube.max) * 0.5).dot(aslant) + ((cube.max - cube.min) * 0.5).dot(aslant.abs())
            }];
        let within = Cube { min: DVec3::new(-0.9, -1.03, -1.1), max: DVec3::new(1.07, 0.93, 1.2) };
        let mut exhausted = 0;
        for classify in [&each(on_ball) as Classify, &each(on_plate), &each(few)] {
            for key in keys {
                for cells in [1, 2, 9, 100, 400, 1000, 3000, 12_000] {
                    for width in [0.3, 0.01] {
                        let (expected, is_exhausted) = by_queue(classify, within, width, cells, key);
                        assert_eq!(extreme(classify, within, width, cells, key), expected, "{cells} {width}");
                        exhausted += u32::from(is_exhausted);
                    }
                }
            }
        }
        assert!(exhausted > 40 && exhausted < 150, "{exhausted}");
    }
}
