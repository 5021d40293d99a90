//! The tape as a list of closures over one number type.
//!
//! In: a [`Tape`]. Out: a [`Kernel`], one closure a step, each compiled for the instructions of the machine.
//! A batch runs through the whole list before the next: registers stay in the first cache, and the call of a
//! closure is paid once for 64 points.

use super::shorten::Shortener;
use super::tape::{Action, Register, Step, Tape};
use crate::expr::op::Op;
use crate::num::level::{Simd, for_each_level};
use crate::num::number::Number;

/// One step, ready to run on the registers.
type Closure<T> = Box<dyn Fn(&mut [T]) + Send + Sync>;

/// Formulas over one number type: from the registers of the variables to those of the roots.
pub struct Kernel<T> {
    /// The steps, and behind them the copies that some of them come down to: see [`super::shorten`].
    closures: Vec<Closure<T>>,
    steps: usize,
    blank: Vec<T>,
    outputs: Vec<Register>,
}

impl<T: Number> Kernel<T> {
    /// The closures of a tape, for the given instructions.
    pub fn new(tape: &Tape, simd: Simd) -> Self {
        let zero =
            crate::num::number::Constant { point: 0.0, range: crate::num::interval::Interval { lo: 0.0, hi: 0.0 } };
        let mut blank = vec![T::constant(zero); tape.registers];
        for &(register, value) in &tape.constants {
            blank[register as usize] = T::constant(value);
        }
        let steps = tape.steps.len();
        Kernel { closures: closures(simd, &tape.steps), steps, blank, outputs: tape.outputs.clone() }
    }

    /// The same, ready to be run in part as `shortener` says.
    pub fn with_copies(tape: &Tape, shortener: &Shortener, simd: Simd) -> Self {
        let mut kernel = Self::new(tape, simd);
        kernel.closures.extend(shortener.copies().map(|(from, to)| copy(from as usize, to as usize)));
        kernel
    }

    /// All of it as an excerpt.
    pub fn whole(&self) -> Excerpt<'_, T> {
        Excerpt { kernel: self, steps: None }
    }

    /// Some of its steps, in an order and with copies that a [`Shortener`] gave for this kernel's tape.
    pub fn excerpt<'a>(&'a self, steps: &'a [u32]) -> Excerpt<'a, T> {
        Excerpt { kernel: self, steps: Some(steps) }
    }

    /// A register file to run on: variables first, then constants, then whatever the steps need.
    pub fn registers(&self) -> Vec<T> {
        self.blank.clone()
    }

    /// Runs all steps. The caller has filled the registers of the variables, in the order of
    /// [`crate::expr::op::Variable::ALL`].
    #[inline]
    pub fn run(&self, registers: &mut [T]) {
        for closure in &self.closures[..self.steps] {
            closure(registers);
        }
    }

    /// Runs some of the steps; closure k is step k of the tape.
    pub(super) fn run_steps(&self, steps: std::ops::Range<usize>, registers: &mut [T]) {
        for closure in &self.closures[steps] {
            closure(registers);
        }
    }

    /// The k-th root after a run.
    #[inline]
    pub fn output<'a>(&self, registers: &'a [T], k: usize) -> &'a T {
        &registers[self.outputs[k] as usize]
    }

    /// How many steps there are.
    pub fn len(&self) -> usize {
        self.steps
    }

    /// Whether every root is a variable or a constant.
    pub fn is_empty(&self) -> bool {
        self.steps == 0
    }
}

/// A kernel, or so much of it as is needed in some part of space.
#[derive(Clone, Copy)]
pub struct Excerpt<'a, T> {
    kernel: &'a Kernel<T>,
    /// Which closures, if not all steps.
    steps: Option<&'a [u32]>,
}

impl<T: Number> Excerpt<'_, T> {
    /// Runs its steps: see [`Kernel::run`].
    #[inline]
    pub fn run(&self, registers: &mut [T]) {
        match self.steps {
            None => self.kernel.run(registers),
            Some(steps) => {
                for &step in steps {
                    self.kernel.closures[step as usize](registers);
                }
            }
        }
    }

    /// Registers for all of the kernel.
    pub fn registers(&self) -> Vec<T> {
        self.kernel.registers()
    }

    /// The k-th root after a run.
    #[inline]
    pub fn output<'r>(&self, registers: &'r [T], k: usize) -> &'r T {
        self.kernel.output(registers, k)
    }

    /// How many steps there are.
    pub fn len(&self) -> usize {
        self.steps.map_or(self.kernel.len(), <[u32]>::len)
    }

    /// Whether every root is a variable or a constant.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A step that takes over what another has computed.
fn copy<T: Number>(from: usize, to: usize) -> Closure<T> {
    Box::new(move |registers: &mut [T]| {
        let (others, out) = apart(registers, to);
        out.clone_from(others.at(from));
    })
}

/// Why a step's registers can be borrowed together.
const DISTINCT: &str = "a step's result is none of its arguments";

/// All registers but one.
struct Others<'a, T> {
    below: &'a [T],
    above: &'a [T],
}

impl<'a, T> Others<'a, T> {
    #[inline(always)]
    fn at(&self, register: usize) -> &'a T {
        if register < self.below.len() { &self.below[register] } else { &self.above[register - self.below.len() - 1] }
    }
}

/// The register that a step writes, and those it may read.
#[inline(always)]
fn apart<T>(registers: &mut [T], out: usize) -> (Others<'_, T>, &mut T) {
    let (below, rest) = registers.split_at_mut(out);
    let (out, above) = rest.split_first_mut().expect("every register is in the file");
    (Others { below, above }, out)
}

// table: one line an operation.
for_each_level! {
    /// The closures of the steps, compiled for one set of instructions.
    fn closures[L, T: Number](steps: &[Step]) -> Vec<Closure<T>> {
        macro_rules! step {
            ($out:expr, |$registers:ident, $to:ident| $body:expr) => {{
                let out = $out;
                Box::new(move |registers: &mut [T]| {
                    let ($registers, $to) = apart(registers, out);
                    $body;
                })
            }};
        }
        macro_rules! unary {
            ($step:expr, $method:ident $(, $extra:expr)?) => {{
                let a = $step.args[0] as usize;
                step!($step.out as usize, |r, out| T::$method::<L>(r.at(a), $($extra,)? out))
            }};
        }
        macro_rules! binary {
            ($step:expr, $method:ident $(, $extra:expr)?) => {{
                let (a, b) = ($step.args[0] as usize, $step.args[1] as usize);
                step!($step.out as usize, |r, out| T::$method::<L>(r.at(a), r.at(b), $($extra,)? out))
            }};
        }
        let mut list: Vec<Closure<T>> = Vec::with_capacity(steps.len());
        for step in steps {
            let ([a, b, c, d], out) = (step.args.map(|a| a as usize), step.out as usize);
            let op = match step.action {
                Action::One(op) => op,
                Action::SinCos(cosine) => {
                    let cosine = cosine as usize;
                    list.push(Box::new(move |r: &mut [T]| {
                        let [a, sine, cosine] = r.get_disjoint_mut([a, out, cosine]).expect(DISTINCT);
                        T::sin_cos::<L>(a, sine, cosine);
                    }));
                    continue;
                }
                Action::Pair(pair) => {
                    list.push(step!(out, |r, out| T::pair::<L>(pair, r.at(a), r.at(b), r.at(c), out)));
                    continue;
                }
                Action::Sized => {
                    list.push(step!(out, |r, out| T::sized(r.at(a), r.at(b), out)));
                    continue;
                }
                Action::Products { minus } => {
                    list.push(step!(out, |r, out| T::products::<L>(minus, [a, b, c, d].map(|k| r.at(k)), out)));
                    continue;
                }
            };
            list.push(match op {
                Op::Constant(_) | Op::Pi | Op::E | Op::Variable(_) => continue,
                Op::Neg => unary!(step, neg),
                Op::Abs => unary!(step, abs),
                Op::Sign => unary!(step, sign),
                Op::Sqrt => unary!(step, sqrt),
                Op::Exp => unary!(step, exp),
                Op::Ln => unary!(step, ln),
                Op::Log2 => unary!(step, log2),
                Op::Log10 => unary!(step, log10),
                Op::Sin => unary!(step, sin),
                Op::Cos => unary!(step, cos),
                Op::Tan => unary!(step, tan),
                Op::Asin => unary!(step, asin),
                Op::Acos => unary!(step, acos),
                Op::Atan => unary!(step, atan),
                Op::Sinh => unary!(step, sinh),
                Op::Cosh => unary!(step, cosh),
                Op::Tanh => unary!(step, tanh),
                Op::Asinh => unary!(step, asinh),
                Op::Acosh => unary!(step, acosh),
                Op::Atanh => unary!(step, atanh),
                Op::Erf => unary!(step, erf),
                Op::Floor => unary!(step, floor),
                Op::Power(2) => unary!(step, square),
                Op::Power(n) => unary!(step, power, n),
                Op::Root(n) => unary!(step, root, n),
                Op::Add => binary!(step, add),
                Op::Sub => binary!(step, sub),
                Op::Mul => binary!(step, mul),
                Op::Div => binary!(step, div),
                Op::FloorDiv(n) => binary!(step, floor_div, n),
                Op::Min => binary!(step, min),
                Op::Max => binary!(step, max),
                Op::Pow if a == b => unary!(step, self_power),
                Op::Pow => binary!(step, pow),
                Op::Atan2 => binary!(step, atan2),
                Op::Choose => step!(out, |r, out| T::choose::<L>(r.at(a), r.at(b), r.at(c), out)),
            });
        }
        list
    }
}
