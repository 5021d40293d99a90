//! For tests: the value of a node with a bound of its rounding error, so that a comparison knows what it may claim.
//!
//! In: a graph and a point. Out: for every node its value in plain f64 arithmetic with a first-order error bound,
//! or that it surely has none, or that rounding does not allow to say. Separate from the closures on purpose: the
//! two check each other.

#![allow(clippy::disallowed_methods, reason = "judged by the standard library")]

use super::graph::{Graph, NodeId};
use super::op::{Op, Variable};
use crate::num::rational::Rational;

/// What is known of a node's value at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Estimate {
    /// The value, and how far it may be off.
    Value(f64, f64),
    /// No value, surely.
    Nothing,
    /// Rounding decides, or the value overflows.
    Unsure,
}

/// Errors of std's functions, generously, relative.
const FUNCTION_ERROR: f64 = 4e-15;

/// The operation on plain numbers; NaN is no value.
pub(crate) fn plain(op: Op, a: f64, b: f64, c: f64) -> f64 {
    let when = |condition: bool, value: f64| if condition { value } else { f64::NAN };
    match op {
        Op::Constant(_) | Op::Variable(_) => f64::NAN,
        Op::Pi => std::f64::consts::PI,
        Op::E => std::f64::consts::E,
        Op::Neg => -a,
        Op::Abs => a.abs(),
        Op::Sign => {
            if a > 0.0 {
                1.0
            } else if a < 0.0 {
                -1.0
            } else {
                a
            }
        }
        Op::Sqrt => a.sqrt(),
        Op::Exp => a.exp(),
        Op::Ln => when(a > 0.0, a.ln()),
        Op::Log2 => when(a > 0.0, a.log2()),
        Op::Log10 => when(a > 0.0, a.log10()),
        Op::Sin => a.sin(),
        Op::Cos => a.cos(),
        Op::Tan => a.tan(),
        Op::Asin => a.asin(),
        Op::Acos => a.acos(),
        Op::Atan => a.atan(),
        Op::Sinh => a.sinh(),
        Op::Cosh => a.cosh(),
        Op::Tanh => a.tanh(),
        Op::Asinh => a.signum() * (a.abs() + (a * a + 1.0).sqrt()).ln(),
        Op::Acosh => a.acosh(),
        Op::Atanh => when(a.abs() < 1.0, a.atanh()),
        Op::Erf => core_math::erf(a),
        Op::Floor => a.floor(),
        Op::FloorDiv(n) => when(b != 0.0, floor_of_quotient(n, a, b)),
        Op::Power(n) => when(a != 0.0 || n > 0, a.powi(n.clamp(-100_000, 100_000) as i32)),
        Op::Root(3) => a.cbrt(),
        Op::Root(n) => a.signum() * a.abs().powf(1.0 / f64::from(n)),
        Op::Add => a + b,
        Op::Sub => a - b,
        Op::Mul => a * b,
        Op::Div => when(b != 0.0, a / b),
        Op::Min => when(!b.is_nan() && !a.is_nan(), a.min(b)),
        Op::Max => when(!b.is_nan() && !a.is_nan(), a.max(b)),
        Op::Pow => when(a > 0.0 || a == 0.0 && b > 0.0, a.powf(b)),
        Op::Atan2 => when(a != 0.0 || b != 0.0, a.atan2(b)),
        Op::Choose => {
            if a <= 0.0 {
                b
            } else {
                c
            }
        }
    }
}

/// ⌊n·a/b⌋ in fractions.
fn floor_of_quotient(n: i64, a: f64, b: f64) -> f64 {
    let quotient = |a: Rational, b: Rational| Rational::from_integer(n).times(&a)?.over(&b);
    let exact = Rational::from_f64(a).zip(Rational::from_f64(b)).and_then(|(a, b)| quotient(a, b));
    exact.map_or((n as f64 * a / b).floor(), |q| q.floor().to_f64())
}

fn jumps(op: Op) -> bool {
    matches!(op, Op::Floor | Op::FloorDiv(_) | Op::Sign | Op::Choose)
}

/// How far `value` may be from the exact result for exactly these arguments.
fn rounding(op: Op, value: f64, a: f64, b: f64) -> f64 {
    let ulp = value.abs() * f64::EPSILON;
    match op {
        Op::Neg | Op::Abs | Op::Sign | Op::Floor | Op::FloorDiv(_) | Op::Min | Op::Max | Op::Choose => 0.0,
        Op::Add | Op::Sub => {
            let b = if op == Op::Sub { -b } else { b };
            let kept = value - a;
            if (a - (value - kept)) + (b - kept) == 0.0 { 0.0 } else { ulp }
        }
        Op::Mul if a.mul_add(b, -value) == 0.0 => 0.0,
        Op::Div if (-value).mul_add(b, a) == 0.0 => 0.0,
        Op::Sqrt if (-value).mul_add(value, a) == 0.0 => 0.0,
        Op::Power(2) if a.mul_add(a, -value) == 0.0 => 0.0,
        Op::Power(n) if a == 0.0 || a.abs() == 1.0 => 0.0 * n as f64,
        Op::Power(n) => ulp * n.unsigned_abs() as f64,
        Op::Root(_) if value == 0.0 => 0.0,
        Op::Exp if a == 0.0 => 0.0,
        Op::Cos | Op::Cosh if a == 0.0 => 0.0,
        _ if value == 0.0 && a == 0.0 => 0.0,
        _ => value.abs() * FUNCTION_ERROR + 1e-300,
    }
}

fn combined(op: Op, args: &[Estimate]) -> Estimate {
    let mut exact = [0.0; 3];
    let mut errors = [0.0; 3];
    for (i, argument) in args.iter().enumerate() {
        match *argument {
            Estimate::Value(v, e) => (exact[i], errors[i]) = (v, e),
            other => return other,
        }
    }
    let value = plain(op, exact[0], exact[1], exact[2]);
    let (mut error, mut unsure) = (0.0f64, false);
    for corner in 0..3usize.pow(args.len() as u32) {
        let shift = |i: usize| exact[i] + errors[i] * ((corner / 3usize.pow(i as u32) % 3) as f64 - 1.0);
        let near = plain(op, shift(0), shift(1), shift(2));
        unsure |= near.is_nan() != value.is_nan() || jumps(op) && op != Op::Choose && near != value;
        unsure |= op == Op::Choose && (shift(0) <= 0.0) != (exact[0] <= 0.0);
        error = error.max((near - value).abs());
    }
    let spans = |i: usize| errors[i] > 0.0 && exact[i].abs() <= errors[i];
    unsure |= match op {
        Op::Div | Op::FloorDiv(_) => spans(1),
        Op::Power(n) => n < 0 && spans(0),
        Op::Atan2 => spans(0),
        // Near a pole the corners of the error say nothing.
        Op::Tan => value.abs() > 1e6,
        Op::Pow | Op::Sqrt => spans(0),
        Op::Atanh | Op::Asin | Op::Acos => errors[0] > 0.0 && (exact[0].abs() - 1.0).abs() <= errors[0],
        Op::Acosh => errors[0] > 0.0 && (exact[0] - 1.0).abs() <= errors[0],
        Op::Ln | Op::Log2 | Op::Log10 => spans(0),
        _ => false,
    };
    if unsure {
        Estimate::Unsure
    } else if value.is_nan() {
        Estimate::Nothing
    } else {
        let error = 2.0 * error + rounding(op, value, exact[0], exact[1]);
        let tiny = value != 0.0 && value.abs() < 1e-150;
        let fits = value.abs() < 1e150 && !tiny && error.is_finite() && error <= 1e-3 * (1.0 + value.abs());
        if fits { Estimate::Value(value, error) } else { Estimate::Unsure }
    }
}

/// The value of each root at a point; DX, DY, DZ are `rates`.
pub(crate) fn estimates(graph: &Graph, roots: &[NodeId], point: [f64; 3], rates: [f64; 3]) -> Vec<Estimate> {
    let mut all = vec![Estimate::Unsure; graph.len()];
    for id in graph.reachable(roots) {
        let args: Vec<Estimate> = graph.args(id).iter().map(|a| all[a.0 as usize]).collect();
        all[id.0 as usize] = match graph.op(id) {
            Op::Constant(index) => {
                let exact = graph.constants(index);
                let near = exact.to_f64();
                let error = if exact.enclosure().lo == exact.enclosure().hi { 0.0 } else { near.abs() * f64::EPSILON };
                if near.abs() < 1e150 { Estimate::Value(near, error) } else { Estimate::Unsure }
            }
            Op::Variable(Variable::X) => Estimate::Value(point[0], 0.0),
            Op::Variable(Variable::Y) => Estimate::Value(point[1], 0.0),
            Op::Variable(Variable::Z) => Estimate::Value(point[2], 0.0),
            Op::Variable(Variable::DX) => Estimate::Value(rates[0], 0.0),
            Op::Variable(Variable::DY) => Estimate::Value(rates[1], 0.0),
            Op::Variable(Variable::DZ) => Estimate::Value(rates[2], 0.0),
            // The branch that is not taken need have no value.
            Op::Choose => match args[0] {
                Estimate::Value(c, e) if c.abs() > e || e == 0.0 => {
                    if c <= 0.0 {
                        args[1]
                    } else {
                        args[2]
                    }
                }
                Estimate::Nothing => Estimate::Nothing,
                _ => Estimate::Unsure,
            },
            // An argument that surely has no value decides, however unsure the others are.
            _ if args.contains(&Estimate::Nothing) => Estimate::Nothing,
            op => combined(op, &args),
        };
    }
    roots.iter().map(|root| all[root.0 as usize]).collect()
}

/// Small deterministic random numbers for tests (SplitMix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// 64 random bits.
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A whole number below n.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// A number in low..high.
    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A coordinate: often a special one.
    pub(crate) fn coordinate(&mut self) -> f64 {
        match self.below(8) {
            0 => 0.0,
            1 => [1.0, -1.0, 2.0, -2.0, 0.5, -0.5][self.below(6)],
            2 => self.within(-20.0, 20.0),
            _ => self.within(-2.0, 2.0),
        }
    }

    /// An operation with arguments (not a leaf), parameters included.
    pub(crate) fn operation(&mut self) -> Op {
        loop {
            return match Op::ALL[self.below(Op::ALL.len())] {
                Op::Power(_) => Op::Power([2, 3, -1, -2, -3, 4, 5, 6][self.below(8)]),
                Op::Root(_) => Op::Root([3, 5, 9][self.below(3)]),
                op if op.arity() == 0 => continue,
                op => op,
            };
        }
    }

    /// A leaf.
    pub(crate) fn leaf(&mut self, graph: &mut Graph) -> NodeId {
        match self.below(10) {
            0 => graph.intern(Op::Pi, &[]),
            1 => graph.intern(Op::E, &[]),
            2 | 3 => graph.integer(self.below(7) as i64 - 3),
            4 => {
                let value = [(1, 2), (1, 3), (-3, 4), (9, 4)][self.below(4)];
                graph.number(Rational::from_fraction(value.0, value.1).unwrap())
            }
            _ => graph.variable(Variable::ALL[self.below(3)]),
        }
    }
}
