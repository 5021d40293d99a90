//! One formula with its value, gradient and enclosure, for whoever wants a single number.
//!
//! In: a node. Out: plain functions of a point or a box. Separate from [`super::kernel`] because a caller with
//! one question should not have to know registers and batches.

use super::{Kernel, Tape};
use crate::expr::derivative::gradient;
use crate::expr::graph::{Graph, NodeId};
use crate::num::affine_lanes::AffineLanes;
use crate::num::interval::{Enclosure, Interval};
use crate::num::interval_lanes::IntervalLanes;
use crate::num::lanes::Lanes;
use crate::num::level::Simd;
use glam::DVec3;
use std::sync::OnceLock;

/// How many boxes are enclosed at once by [`Formula::enclosures`].
const BOXES: usize = 16;

/// A function of (x, y, z).
pub struct Formula {
    gradient: Kernel<Lanes<1>>,
    single: Kernel<IntervalLanes<1>>,
    many: Kernel<IntervalLanes<BOXES>>,
    /// Made when it is first asked for: most formulas never are.
    forms: OnceLock<Kernel<AffineLanes<BOXES>>>,
    tape: Tape,
    simd: Simd,
}

impl Formula {
    /// The function of a node; its derivatives are added to the graph.
    pub fn new(graph: &mut Graph, f: NodeId, simd: Simd) -> Self {
        let [x, y, z] = gradient(graph, f);
        let tape = Tape::new(graph, &[f]);
        Formula {
            gradient: Kernel::new(&Tape::for_points(graph, &[f, x, y, z]), simd),
            single: Kernel::new(&tape, simd),
            many: Kernel::new(&tape, simd),
            forms: OnceLock::new(),
            tape,
            simd,
        }
    }

    /// f at a point; NaN where it has no value.
    pub fn value(&self, point: DVec3) -> f64 {
        self.gradient(point).0
    }

    /// f and its gradient at a point; a component is NaN where the derivative has no value.
    pub fn gradient(&self, point: DVec3) -> (f64, DVec3) {
        let mut registers = self.gradient.registers();
        for axis in 0..3 {
            registers[axis].0 = [point[axis]];
        }
        self.gradient.run(&mut registers);
        let [f, x, y, z] = [0, 1, 2, 3].map(|k| self.gradient.output(&registers, k).0[0]);
        (f, DVec3::new(x, y, z))
    }

    /// What is known of f over a box.
    pub fn enclosure(&self, range: [Interval; 3]) -> Enclosure {
        let mut registers = self.single.registers();
        for (register, side) in registers.iter_mut().zip(range) {
            register.set(0, Enclosure::total(side));
        }
        self.single.run(&mut registers);
        self.single.output(&registers, 0).get(0)
    }

    /// f over many boxes, with how it leans in each.
    pub fn forms_over_boxes(&self) -> FormsOverBoxes<'_> {
        let kernel = self.forms.get_or_init(|| Kernel::new(&self.tape, self.simd));
        FormsOverBoxes { kernel, registers: kernel.registers() }
    }

    /// The same as [`Formula::enclosure`] for many boxes, a number of them at once.
    pub fn over_boxes(&self) -> OverBoxes<'_> {
        OverBoxes { kernel: &self.many, registers: self.many.registers() }
    }
}

/// A function as affine forms over boxes, with the memory it runs on.
pub struct FormsOverBoxes<'a> {
    kernel: &'a Kernel<AffineLanes<BOXES>>,
    registers: Vec<AffineLanes<BOXES>>,
}

impl FormsOverBoxes<'_> {
    /// The forms over so many boxes, each lane one, from their corners; each symbol is the place along one axis.
    pub fn over(&mut self, boxes: &[[DVec3; 2]], mut give: impl FnMut(usize, &AffineLanes<BOXES>, usize)) {
        for (number, chunk) in boxes.chunks(BOXES).enumerate() {
            for lane in 0..BOXES {
                // As in [`OverBoxes::enclosures`].
                let [min, max] = *chunk.get(lane).unwrap_or(&chunk[0]);
                let (middle, half) = ((min + max) * 0.5, (max - min) * 0.5);
                let rounded = min.abs().max(max.abs()) * f64::EPSILON;
                for axis in 0..3 {
                    let form = &mut self.registers[axis];
                    (form.center[lane], form.error[lane], form.flags[lane]) = (middle[axis], rounded[axis], 0);
                    for symbol in 0..3 {
                        form.slope[symbol][lane] = if symbol == axis { half[axis] } else { 0.0 };
                    }
                }
            }
            self.kernel.run(&mut self.registers);
            let f = self.kernel.output(&self.registers, 0);
            (0..chunk.len()).for_each(|lane| give(number * BOXES + lane, f, lane));
        }
    }
}

/// A function of boxes, with the memory it runs on.
pub struct OverBoxes<'a> {
    kernel: &'a Kernel<IntervalLanes<BOXES>>,
    registers: Vec<IntervalLanes<BOXES>>,
}

impl OverBoxes<'_> {
    /// What is known of f over each box; `out` is replaced.
    pub fn enclosures(&mut self, ranges: &[[Interval; 3]], out: &mut Vec<Enclosure>) {
        out.clear();
        for chunk in ranges.chunks(BOXES) {
            for lane in 0..BOXES {
                // A lane too many does what another does: what was left in it could be a slow case.
                let range = chunk.get(lane).unwrap_or(&chunk[0]);
                for (register, &side) in self.registers.iter_mut().zip(range) {
                    register.set(lane, Enclosure::total(side));
                }
            }
            self.kernel.run(&mut self.registers);
            let f = self.kernel.output(&self.registers, 0);
            out.extend((0..chunk.len()).map(|lane| f.get(lane)));
        }
    }
}
