//! Exact folding: fractions stay fractions, and the few irrational places with rational values are known.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::rational::Rational;
use std::cmp::Ordering;

/// Arithmetic and the other operations that give a fraction of fractions.
pub(super) fn arithmetic(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let a = graph.constant(*args.first()?)?;
    let value = match args {
        [_] => match op {
            Op::Neg => Some(a.negated()),
            Op::Abs => Some(a.absolute()),
            Op::Sign => Some(sign(a)),
            Op::Floor => Some(a.floor()),
            Op::Sqrt => a.exact_root(2),
            Op::Root(n) => a.exact_root(n),
            Op::Power(n) => a.to_power(n),
            _ => None,
        },
        [_, b] => {
            let b = graph.constant(*b)?;
            match op {
                Op::Add => a.plus(b),
                Op::Sub => a.minus(b),
                Op::Mul => a.times(b),
                Op::Div => a.over(b),
                Op::Min => Some(a.min(b).clone()),
                Op::Max => Some(a.max(b).clone()),
                _ => None,
            }
        }
        _ => None,
    }?;
    Some(graph.number(value))
}

fn sign(a: &Rational) -> Rational {
    Rational::from_integer(match a.cmp(&Rational::from_integer(0)) {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    })
}

/// Functions at the places where their value is known exactly.
pub(super) fn function_value(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let &[a] = args else { return None };
    if op == Op::Ln && graph.op(a) == Op::E {
        return Some(graph.integer(1));
    }
    let c = graph.constant(a)?.clone();
    if op == Op::Exp && c.is_one() {
        return Some(graph.intern(Op::E, &[]));
    }
    let value = match op {
        Op::Exp | Op::Cos | Op::Cosh => c.is_zero().then_some(1),
        Op::Ln | Op::Acos | Op::Acosh => c.is_one().then_some(0),
        Op::Log2 => exact_logarithm(&c, 2),
        Op::Log10 => exact_logarithm(&c, 10),
        Op::Sin | Op::Tan | Op::Asin | Op::Atan | Op::Sinh | Op::Tanh | Op::Asinh | Op::Atanh | Op::Erf => {
            c.is_zero().then_some(0)
        }
        _ => None,
    }?;
    Some(graph.integer(value))
}

/// n with base^n = c, for the sizes that occur in formulas.
fn exact_logarithm(c: &Rational, base: i64) -> Option<i64> {
    if !c.is_positive() {
        return None;
    }
    let size = c.numerator().bits().max(c.denominator().bits()) as i64;
    let base = Rational::from_integer(base);
    let sign = if *c >= Rational::from_integer(1) { 1 } else { -1 };
    (0..=size).map(|n| sign * n).find(|&n| base.to_power(n).as_ref() == Some(c))
}

/// Sine, cosine and tangent of the multiples of π that have rational values.
pub(super) fn angle(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    if !matches!(op, Op::Sin | Op::Cos | Op::Tan) {
        return None;
    }
    let (c, v, _) = graph.coefficient(args[0]);
    if graph.op(v) != Op::Pi {
        return None;
    }
    let (p, q) = c.to_fraction()?;
    let value = match op {
        Op::Tan => match (q, p.rem_euclid(q.checked_mul(2)?)) {
            (1, _) => (0, 1),
            (4, 1 | 5) => (1, 1),
            (4, 3 | 7) => (-1, 1),
            _ => return None,
        },
        _ if 12 % q != 0 => return None,
        _ => {
            // In twelfths of π; cos u = sin(u + π/2).
            let twelfths = p.rem_euclid(2 * q) * (12 / q);
            sine_of_twelfths((twelfths + if op == Op::Cos { 6 } else { 0 }) % 24)?
        }
    };
    let value = Rational::from_fraction(value.0, value.1)?;
    Some(graph.number(value))
}

fn sine_of_twelfths(n: i64) -> Option<(i64, i64)> {
    match n {
        0 | 12 => Some((0, 1)),
        2 | 10 => Some((1, 2)),
        6 => Some((1, 1)),
        14 | 22 => Some((-1, 2)),
        18 => Some((-1, 1)),
        _ => None,
    }
}

/// General powers that have a simpler operation or an exact value.
pub(super) fn power(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Pow, &[a, b]) = (op, args) else { return None };
    if graph.op(a) == Op::E {
        return Some(graph.apply(Op::Exp, &[b]));
    }
    let exponent = graph.constant(b)?.clone();
    if let Some((n, 2)) = exponent.to_fraction() {
        let root = graph.apply(Op::Sqrt, &[a]);
        return Some(graph.apply(Op::Power(n), &[root]));
    }
    if let Some(n) = exponent.to_i64()
        && (graph.is_positive(a) || n > 0 && graph.is_nonnegative(a))
    {
        return Some(graph.apply(Op::Power(n), &[a]));
    }
    let base = graph.constant(a)?.clone();
    let (p, q) = exponent.to_fraction()?;
    if base.is_negative() || base.is_zero() && p <= 0 {
        return None;
    }
    let value = base.exact_root(u32::try_from(q).ok()?)?.to_power(p)?;
    Some(graph.number(value))
}
