//! A long sum, and so much of it as some part of space needs.
//!
//! In: a node that is a sum of many terms. Out: kernels of all its terms, each with its slope along the rays; and, from forms of them over
//! slabs, a [`Share`] for each: the terms that change there, and bounds of what the others come to. A share is for enclosures alone; points
//! take all terms. Separate from minima, of which the arguments that do not matter leave nothing behind.

use super::tile::{FORMS, FormFiles, Forms, WIDER};
use crate::closure::shorten::{Shortener, numbers};
use crate::closure::{Kernel, Tape};
use crate::expr::derivative::along_ray;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::nest::terms;
use crate::expr::op::Op;
use crate::num::affine_lanes::AffineLanes;
use crate::num::interval_lanes::{JUMP, NOWHERE, PARTIAL};
use crate::num::level::{Simd, for_each_level};
use crate::num::number::Number;

/// Sums of fewer terms are not worth it.
const FEWEST: usize = 32;

/// Sums of more are left whole: sharing can make an enormous sum of a small graph.
const MOST: usize = 10_000;

/// What is left out may change by so much of the largest term: so little that squares of a few pixels still see how the rest leans.
const LEFT_OUT: f64 = 0.03;

/// The terms of a function that is a long sum.
pub(crate) struct Sum {
    /// How many there are.
    pub(crate) count: usize,
    /// All terms, and behind them their slopes.
    kernel: Kernel<Forms>,
    /// The steps of each term, and of each with its slope.
    own: Vec<[Box<[u32]>; 2]>,
}

/// The part of a sum that matters somewhere.
#[derive(Clone, Debug)]
pub(crate) struct Share {
    /// The terms, rising.
    pub(crate) live: Box<[u32]>,
    /// The steps that compute them, without and with their slopes.
    steps: [Box<[u32]>; 2],
    /// Bounds of the sum of the others and of its slope: middle and half width.
    rest: [[f64; 2]; 2],
}

/// What forms over some slabs say of the terms.
#[derive(Debug, Default)]
pub(crate) struct Weighed {
    /// Whether the sum has no root in a slab.
    pub(crate) is_empty: [bool; FORMS],
    /// Whether each term, and its slope, is defined and continuous; how much each changes; bounds of each.
    terms: Vec<Weight>,
}

#[derive(Clone, Copy, Debug)]
struct Weight {
    is_smooth: [bool; FORMS],
    center: [[f64; FORMS]; 2],
    radius: [[f64; FORMS]; 2],
}

impl Sum {
    /// The terms of a node, whose slopes are added to the graph; `None` if they are few, or too many.
    pub(crate) fn new(graph: &mut Graph, node: NodeId, simd: Simd) -> Option<Sum> {
        let terms = terms(graph, node, MOST).filter(|terms| terms.len() >= FEWEST)?;
        let signed = |(id, is_negative)| if is_negative { graph.apply(Op::Neg, &[id]) } else { id };
        let terms: Vec<NodeId> = terms.into_iter().map(signed).collect();
        let slopes = along_ray(graph, &terms);
        let count = terms.len();
        let tape = Tape::new(graph, &[terms, slopes].concat());
        let shortener = Shortener::new(&tape, &[]);
        let steps = |roots: &[usize]| shortener.shorten(roots.iter().copied(), &[]).into_boxed_slice();
        let own = (0..count).map(|k| [steps(&[k]), steps(&[k, count + k])]).collect();
        Some(Sum { count, kernel: Kernel::new(&tape, simd), own })
    }

    /// Registers for all terms.
    pub(crate) fn registers(&self) -> Vec<Forms> {
        self.kernel.registers()
    }

    /// All of it.
    pub(crate) fn whole(&self) -> Share {
        let all: Vec<u32> = (0..self.count as u32).collect();
        self.share(&all, [[0.0; 2]; 2])
    }

    fn share(&self, live: &[u32], rest: [[f64; 2]; 2]) -> Share {
        let steps = [0, 1].map(|which| {
            let mut needed = vec![0u64; self.kernel.len().div_ceil(64)];
            for &step in live.iter().flat_map(|&k| &self.own[k as usize][which]) {
                needed[step as usize / 64] |= 1 << (step % 64);
            }
            numbers(&needed).into()
        });
        Share { live: live.into(), steps, rest }
    }

    /// The value (0) or the slope (1) of a share, where the registers of the coordinates are filled.
    fn add_up(&self, share: &Share, which: usize, registers: &[Forms], simd: Simd) -> Forms {
        let mut sum = share.constant(which);
        let terms = share.live.iter().map(|&k| self.kernel.output(registers, which * self.count + k as usize));
        let terms: Vec<&Forms> = terms.collect();
        add_all(simd, &terms, &mut sum);
        sum
    }

    /// The sum over squares of the screen, and with `with_slope` its slope.
    pub(crate) fn run(&self, share: &Share, with_slope: bool, files: &mut FormFiles, simd: Simd) {
        self.kernel.excerpt(&share.steps[usize::from(with_slope)]).run(&mut files.terms);
        for which in 0..=usize::from(with_slope) {
            files.sums[which] = self.add_up(share, which, &files.terms, simd);
        }
    }

    /// Weighs the terms of a share over slabs, where the registers of the coordinates are filled.
    pub(crate) fn weigh(&self, share: &Share, files: &mut FormFiles, simd: Simd) -> Weighed {
        let mut weighed = Weighed::default();
        self.run(share, true, files, simd);
        let sum = &files.sums[0];
        for lane in 0..FORMS {
            let radius = sum.radius(lane) * WIDER;
            weighed.is_empty[lane] = sum.center[lane].abs() > radius || sum.flags[lane] & NOWHERE != 0;
        }
        weighed.terms.extend(share.live.iter().map(|&k| {
            let forms = [0, self.count].map(|first| self.kernel.output(&files.terms, first + k as usize));
            let flags = |lane: usize| (forms[0].flags[lane] | forms[1].flags[lane]) & (PARTIAL | JUMP | NOWHERE);
            Weight {
                is_smooth: std::array::from_fn(|lane| flags(lane) == 0),
                center: forms.map(|form| form.center),
                radius: forms.map(|form| std::array::from_fn(|lane| form.bounds(lane).1 - form.center[lane])),
            }
        }));
        weighed
    }

    /// The part of a share that matters in one of the slabs, which is so long. Measured by the largest that a term is everywhere in it: the radii of
    /// forms over large slabs say little.
    pub(crate) fn part(&self, share: &Share, weighed: &Weighed, lane: usize, length: f64) -> Share {
        let least = |w: &Weight| w.center[0][lane].abs() - w.radius[0][lane];
        let scale = weighed.terms.iter().map(least).fold(0.0, f64::max);
        let weight = |w: &Weight| w.radius[0][lane].max(0.5 * length * w.radius[1][lane]) / scale;
        let smooth = weighed.terms.iter().enumerate().filter(|(_, w)| w.is_smooth[lane]);
        let mut light: Vec<(f64, usize)> = smooth.map(|(k, w)| (weight(w), k)).filter(|w| w.0 <= LEFT_OUT).collect();
        light.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let (mut live, mut rest, mut left_out) = (share.live.to_vec(), share.rest, 0.0);
        for (weight, k) in light {
            left_out += weight;
            if left_out > LEFT_OUT {
                break;
            }
            for (which, [middle, half]) in rest.iter_mut().enumerate() {
                let (center, radius) = (weighed.terms[k].center[which][lane], weighed.terms[k].radius[which][lane]);
                *middle += center;
                // The roundings of both sums.
                *half = (*half + radius) * (1.0 + 4.0 * f64::EPSILON) + 2.0 * f64::EPSILON * middle.abs();
            }
            live[k] = u32::MAX;
        }
        live.retain(|&k| k != u32::MAX);
        self.share(&live, rest)
    }
}

impl Share {
    /// What all terms that are left out come to, or their slopes.
    fn constant(&self, which: usize) -> Forms {
        let [middle, half] = self.rest[which];
        Forms::splat(middle, half)
    }
}

for_each_level! {
    /// Adds forms to a form.
    fn add_all[L](terms: &[&Forms], sum: &mut Forms) {
        for term in terms {
            let before = *sum;
            AffineLanes::add::<L>(&before, term, sum);
        }
    }
}
