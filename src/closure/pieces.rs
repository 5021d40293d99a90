//! One enclosure at a time, with jumps and poles taken apart.
//!
//! In: a tape and a box. Out: enclosures of its roots; and, for the tracer's last resort, one enclosure for
//! every way of standing on one side of each jump and pole in the box. The union of all of them contains every
//! value that the function takes, though their hull would contain much more: over a box around x = 0,
//! 1/x is not near zero, but the hull of its two sides is everything.

use super::kernel::Kernel;
use super::tape::{Action, Register, Tape};
use crate::expr::op::Op;
use crate::num::interval::{Defined, Enclosure, Interval, Pieces as Sides};

use crate::num::interval_lanes::IntervalLanes;
use crate::num::level::Simd;

/// The most combinations of sides that are tried: six jumps in one tiny box.
const MOST_COMBINATIONS: i64 = 64;

/// Formulas over one box at a time.
pub struct Pieces {
    kernel: Kernel<IntervalLanes<1>>,
    /// Steps with a jump or a pole: their place in the tape.
    forks: Vec<Fork>,
}

/// A step whose argument may straddle a jump or a pole.
struct Fork {
    step: usize,
    op: Op,
    args: [Register; 4],
    out: Register,
}

/// Registers for [`Pieces`].
pub struct Scratch {
    registers: Vec<IntervalLanes<1>>,
}

impl Pieces {
    /// Evaluates all roots of the tape.
    pub fn new(tape: Tape, simd: Simd) -> Self {
        let forks = tape.steps.iter().enumerate().filter_map(|(step, s)| match s.action {
            Action::One(op) if jumps(op) => Some(Fork { step, op, args: s.args, out: s.out }),
            Action::One(_) | Action::SinCos(_) | Action::Pair(_) | Action::Sized | Action::Products { .. } => None,
        });
        Pieces { forks: forks.collect(), kernel: Kernel::new(&tape, simd) }
    }

    /// Fresh registers.
    pub fn scratch(&self) -> Scratch {
        Scratch { registers: self.kernel.registers() }
    }

    /// Encloses all roots over a box of the variables, in the order of [`crate::expr::op::Variable::ALL`].
    pub fn enclose(&self, variables: &[Interval; 6], scratch: &mut Scratch) {
        fill(variables, scratch);
        self.kernel.run(&mut scratch.registers);
    }

    /// The k-th root after [`Self::enclose`].
    pub fn output(&self, scratch: &Scratch, k: usize) -> Enclosure {
        self.kernel.output(&scratch.registers, k).get(0)
    }

    /// Whether `accept` holds for the first root over every combination of sides; the number of
    /// combinations tried, negative if one was not accepted or there were too many.
    pub fn all_pieces(
        &self,
        variables: &[Interval; 6],
        scratch: &mut Scratch,
        accept: impl Fn(&Enclosure) -> bool,
    ) -> i64 {
        let mut sides = vec![0usize; self.forks.len()];
        for tried in 1..=MOST_COMBINATIONS {
            fill(variables, scratch);
            let counts = self.run_sides(&sides, scratch);
            if !accept(&self.output(scratch, 0)) {
                return -tried;
            }
            // The next combination: the last fork with a side left moves on, those behind it start again.
            let Some(next) = (0..sides.len()).rev().find(|&k| sides[k] + 1 < counts[k]) else { return tried };
            sides[next] += 1;
            sides[next + 1..].fill(0);
        }
        -MOST_COMBINATIONS
    }

    /// Runs all steps with each fork on the given side, and says how many sides each had.
    fn run_sides(&self, sides: &[usize], scratch: &mut Scratch) -> Vec<usize> {
        let mut counts = Vec::with_capacity(self.forks.len());
        let mut next = 0;
        for (fork, &side) in self.forks.iter().zip(sides) {
            self.kernel.run_steps(next..fork.step, &mut scratch.registers);
            let arguments = fork.args.map(|r| scratch.registers[r as usize].get(0));
            let list = sides_of(fork.op, arguments);
            let sides = list.as_slice();
            counts.push(sides.len());
            let chosen = sides.get(side).map_or(Enclosure::NOWHERE, |&range| Enclosure::total(range));
            scratch.registers[fork.out as usize].set(0, spread(chosen, &arguments[..fork.op.arity()], fork.op));
            next = fork.step + 1;
        }
        self.kernel.run_steps(next..self.kernel.len(), &mut scratch.registers);
        counts
    }
}

/// The ranges of an operation on each side of its jumps and poles.
fn sides_of(op: Op, arguments: [Enclosure; 4]) -> Sides {
    let [a, b, ..] = arguments.map(|e| e.range);
    match op {
        Op::Sign => a.sign_pieces(),
        Op::Floor => a.floor_pieces(),
        Op::Tan => a.tan_pieces(),
        Op::Power(n) => a.power_pieces(n),
        Op::Div => a.over_pieces(b),
        Op::FloorDiv(n) => a.floor_over_pieces(n, b),
        Op::Atan2 => a.atan2_pieces(b),
        _ => Enclosure::choose_pieces(arguments[0], arguments[1], arguments[2]),
    }
}

/// One side of an operation with what is known of its arguments: without value where one of them has none.
fn spread(side: Enclosure, arguments: &[Enclosure], op: Op) -> Enclosure {
    // The branch that is not taken need have no value, and an empty side says that there is none to take.
    let empty = op != Op::Choose && arguments.iter().any(|a| a.defined == Defined::Nowhere);
    if empty || side.range.is_empty() { Enclosure::NOWHERE } else { side }
}

fn fill(variables: &[Interval; 6], scratch: &mut Scratch) {
    for (register, &range) in scratch.registers.iter_mut().zip(variables) {
        register.set(0, Enclosure::total(range));
    }
}

/// Whether the operation has a jump or a pole.
fn jumps(op: Op) -> bool {
    match op {
        Op::Sign | Op::Floor | Op::Tan | Op::Div | Op::FloorDiv(_) | Op::Atan2 | Op::Choose => true,
        Op::Power(n) => n < 0,
        Op::Constant(_)
        | Op::Pi
        | Op::E
        | Op::Variable(_)
        | Op::Neg
        | Op::Abs
        | Op::Sqrt
        | Op::Exp
        | Op::Ln
        | Op::Log2
        | Op::Log10
        | Op::Sin
        | Op::Cos
        | Op::Asin
        | Op::Acos
        | Op::Atan
        | Op::Sinh
        | Op::Cosh
        | Op::Tanh
        | Op::Asinh
        | Op::Acosh
        | Op::Atanh
        | Op::Erf
        | Op::Root(_)
        | Op::Add
        | Op::Sub
        | Op::Mul
        | Op::Min
        | Op::Max
        | Op::Pow => false,
    }
}
