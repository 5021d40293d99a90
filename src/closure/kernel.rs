//! The tape as a list of closures over one number type.
//!
//! In: a [`Tape`]. Out: a [`Kernel`], one closure a step, each compiled for the instructions of the machine.
//! A batch runs through the whole list before the next: registers stay in the first cache, and the call of a
//! closure is paid once for 64 points.

use super::tape::{Action, Register, Step, Tape};
use crate::expr::op::Op;
use crate::num::level::{Simd, for_each_level};
use crate::num::number::Number;

/// One step, ready to run on the registers.
type Closure<T> = Box<dyn Fn(&mut [T]) + Send + Sync>;

/// Formulas over one number type: from the registers of the variables to those of the roots.
pub struct Kernel<T> {
    closures: Vec<Closure<T>>,
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
        Kernel { closures: closures(simd, &tape.steps), blank, outputs: tape.outputs.clone() }
    }

    /// A register file to run on: variables first, then constants, then whatever the steps need.
    pub fn registers(&self) -> Vec<T> {
        self.blank.clone()
    }

    /// Runs all steps. The caller has filled the registers of the variables, in the order of
    /// [`crate::expr::op::Variable::ALL`].
    #[inline]
    pub fn run(&self, registers: &mut [T]) {
        for closure in &self.closures {
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
        self.closures.len()
    }

    /// Whether every root is a variable or a constant.
    pub fn is_empty(&self) -> bool {
        self.closures.is_empty()
    }
}

/// Why a step's registers can be borrowed together.
const DISTINCT: &str = "a step's result is none of its arguments";

// table: one line an operation.
for_each_level! {
    /// The closures of the steps, compiled for one set of instructions.
    fn closures[L, T: Number](steps: &[Step]) -> Vec<Closure<T>> {
        macro_rules! unary {
            ($step:expr, $method:ident $(, $extra:expr)?) => {{
                let (a, out) = ($step.args[0] as usize, $step.out as usize);
                Box::new(move |r: &mut [T]| {
                    let [a, out] = r.get_disjoint_mut([a, out]).expect(DISTINCT);
                    T::$method::<L>(a, $($extra,)? out);
                })
            }};
        }
        macro_rules! binary {
            ($step:expr, $method:ident $(, $extra:expr)?) => {{
                let (a, b, out) = ($step.args[0] as usize, $step.args[1] as usize, $step.out as usize);
                if a == b {
                    Box::new(move |r: &mut [T]| {
                        let [a, out] = r.get_disjoint_mut([a, out]).expect(DISTINCT);
                        T::$method::<L>(a, a, $($extra,)? out);
                    })
                } else {
                    Box::new(move |r: &mut [T]| {
                        let [a, b, out] = r.get_disjoint_mut([a, b, out]).expect(DISTINCT);
                        T::$method::<L>(a, b, $($extra,)? out);
                    })
                }
            }};
        }
        let mut list: Vec<Closure<T>> = Vec::with_capacity(steps.len());
        for step in steps {
            let op = match step.action {
                Action::One(op) => op,
                Action::SinCos(cosine) => {
                    let (a, sine, cosine) = (step.args[0] as usize, step.out as usize, cosine as usize);
                    list.push(Box::new(move |r: &mut [T]| {
                        let [a, sine, cosine] = r.get_disjoint_mut([a, sine, cosine]).expect(DISTINCT);
                        T::sin_cos::<L>(a, sine, cosine);
                    }));
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
                Op::Pow => binary!(step, pow),
                Op::Atan2 => binary!(step, atan2),
                Op::Choose => {
                    let ([c, a, b], out) = (step.args.map(|a| a as usize), step.out as usize);
                    if c == a || a == b || b == c {
                        Box::new(move |r: &mut [T]| {
                            let mut result = r[out].clone();
                            T::choose::<L>(&r[c], &r[a], &r[b], &mut result);
                            r[out] = result;
                        })
                    } else {
                        Box::new(move |r: &mut [T]| {
                            let [c, a, b, out] = r.get_disjoint_mut([c, a, b, out]).expect(DISTINCT);
                            T::choose::<L>(c, a, b, out);
                        })
                    }
                }
            });
        }
        list
    }
}
