//! Products, quotients, whole powers and roots.

use super::terms::is_double;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::rational::Rational;

/// How far down a product like factors are looked for; both sides of every product are searched.
const LOOK_AHEAD: usize = 5;

pub(super) fn trivial_power(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Power(n), &[a]) = (op, args) else { return None };
    let one = graph.integer(1);
    match n {
        1 => Some(a),
        0 => {
            let zero = graph.zero_where_defined(a);
            Some(graph.apply(Op::Add, &[zero, one]))
        }
        -1 => Some(graph.apply(Op::Div, &[one, a])),
        _ => None,
    }
}

pub(super) fn constant_factor(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Mul, &[a, b]) = (op, args) else { return None };
    let c = graph.constant(a)?.clone();
    let (d, v, divisor) = graph.coefficient(b);
    if c.is_zero() && graph.op(b) == Op::Mul && d.is_zero() {
        return Some(b);
    }
    let c = c.times(&d)?;
    Some(graph.scaled(&c, v, divisor))
}

pub(super) fn factors_in_front(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Mul, &[a, b]) = (op, args) else { return None };
    let (c, u, first) = graph.coefficient(a);
    let (d, v, second) = graph.coefficient(b);
    if u == a && v == b {
        return None;
    }
    let c = c.times(&d)?;
    let product = graph.apply(Op::Mul, &[u, v]);
    let (d, v, third) = graph.coefficient(product);
    let c = c.times(&d)?;
    Some(graph.scaled(&c, v, first || second || third))
}

pub(super) fn constant_divisor(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Div, &[a, b]) = (op, args) else { return None };
    let c = graph.constant(b)?.clone();
    let inverse = c.reciprocal()?;
    let (d, v, _) = graph.coefficient(a);
    if v == a && !is_double(&inverse) && is_double(&c) && graph.constant(a).is_none() {
        return None;
    }
    let c = inverse.times(&d)?;
    Some(graph.scaled(&c, v, true))
}

pub(super) fn constants_of_quotient(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Div, &[a, b]) = (op, args) else { return None };
    if graph.constant(b).is_some_and(|c| !c.is_zero()) {
        return None;
    }
    if graph.constant(a).is_some_and(Rational::is_zero) && graph.is_total(b) && graph.is_nonzero(b) {
        return Some(a);
    }
    let (c, u, first) = graph.coefficient(a);
    let (d, v, second) = graph.coefficient(b);
    if (u == a && v == b) || d.is_zero() || c.is_zero() {
        return None;
    }
    let c = c.over(&d)?;
    let quotient = graph.apply(Op::Div, &[u, v]);
    let (d, v, third) = graph.coefficient(quotient);
    let c = c.times(&d)?;
    Some(graph.scaled(&c, v, first || second || third))
}

pub(super) fn reciprocal_factor(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Mul, &[a, b]) = (op, args) else { return None };
    let parts = |graph: &Graph, id: NodeId| {
        let [k, w, _] = graph.node(id).args;
        if graph.op(id) == Op::Div { graph.constant(k).map(|k| (k.clone(), w)) } else { None }
    };
    let (k, w, other) = match (parts(graph, a), parts(graph, b)) {
        (Some((k, w)), None) => (k, w, b),
        (None, Some((k, w))) => (k, w, a),
        _ => return None,
    };
    if k.is_zero() {
        return None;
    }
    let quotient = graph.apply(Op::Div, &[other, w]);
    graph.multiple(&k, quotient)
}

/// u = base^n with n as large as is visible.
fn base_and_exponent(graph: &Graph, u: NodeId) -> (NodeId, i64) {
    match graph.op(u) {
        Op::Power(n) => (graph.args(u)[0], n),
        _ => (u, 1),
    }
}

/// base^m · base^n as one power, where that has the same domain.
fn merged(graph: &mut Graph, base: NodeId, m: i64, n: i64) -> Option<NodeId> {
    if (m < 0) != (n < 0) {
        return None;
    }
    Some(graph.apply(Op::Power(m.checked_add(n)?), &[base]))
}

/// The product with base^n multiplied into one of its factors, if one of them is a power of the same base.
fn absorbed_factor(graph: &mut Graph, product: NodeId, base: NodeId, n: i64, depth: usize) -> Option<NodeId> {
    let [left, right, _] = graph.node(product).args;
    if graph.op(product) != Op::Mul {
        return None;
    }
    for (this, other) in [(left, right), (right, left)] {
        let (b, m) = base_and_exponent(graph, this);
        if b == base {
            let power = merged(graph, base, m, n)?;
            return Some(graph.apply(Op::Mul, &[power, other]));
        }
    }
    let depth = depth.checked_sub(1)?;
    for (this, other) in [(left, right), (right, left)] {
        if let Some(product) = absorbed_factor(graph, this, base, n, depth) {
            return Some(graph.apply(Op::Mul, &[product, other]));
        }
    }
    None
}

pub(super) fn like_factors(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Mul, &[a, b]) = (op, args) else { return None };
    if graph.constant(a).is_some() {
        return None;
    }
    let ((u, m), (v, n)) = (base_and_exponent(graph, a), base_and_exponent(graph, b));
    if u == v {
        return merged(graph, u, m, n);
    }
    absorbed_factor(graph, a, v, n, LOOK_AHEAD).or_else(|| absorbed_factor(graph, b, u, m, LOOK_AHEAD))
}

pub(super) fn exponentials(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Mul, &[a, b]) = (op, args) else { return None };
    if graph.op(a) != Op::Exp || graph.op(b) != Op::Exp {
        return None;
    }
    let (u, v) = (graph.args(a)[0], graph.args(b)[0]);
    let sum = graph.apply(Op::Add, &[u, v]);
    Some(graph.apply(Op::Exp, &[sum]))
}

pub(super) fn power_of_power(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Power(n), &[a]) = (op, args) else { return None };
    let [u, v, _] = graph.node(a).args;
    match graph.op(a) {
        Op::Power(m) if m > 0 || n > 0 => Some(graph.apply(Op::Power(m.checked_mul(n)?), &[u])),
        Op::Div if n > 0 && graph.constant(u)?.is_one() => Some(graph.apply(Op::Power(n.checked_neg()?), &[v])),
        _ => None,
    }
}

pub(super) fn power_of_root(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Power(n), &[a]) = (op, args) else { return None };
    let u = graph.node(a).args[0];
    match graph.op(a) {
        Op::Sqrt if n % 2 == 0 && graph.is_nonnegative(u) => Some(graph.apply(Op::Power(n / 2), &[u])),
        Op::Root(m) if n % i64::from(m) == 0 => Some(graph.apply(Op::Power(n / i64::from(m)), &[u])),
        Op::E => {
            let n = graph.integer(n);
            Some(graph.apply(Op::Exp, &[n]))
        }
        Op::Exp => {
            let u = graph.multiple(&Rational::from_integer(n), u)?;
            Some(graph.apply(Op::Exp, &[u]))
        }
        _ => None,
    }
}

pub(super) fn parity(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let (Op::Power(n), &[a]) = (op, args) else { return None };
    if n % 2 == 0 {
        let a = graph.without_sign(a)?;
        return Some(graph.apply(op, &[a]));
    }
    if graph.op(a) != Op::Neg {
        return None;
    }
    let u = graph.args(a)[0];
    let power = graph.apply(op, &[u]);
    Some(graph.apply(Op::Neg, &[power]))
}

pub(super) fn root_of_power(graph: &mut Graph, op: Op, args: &[NodeId]) -> Option<NodeId> {
    let &[a] = args else { return None };
    let u = graph.node(a).args[0];
    match (op, graph.op(a)) {
        (Op::Sqrt, Op::Power(n)) if n % 2 == 0 => {
            let half = graph.apply(Op::Power(n / 2), &[u]);
            Some(graph.apply(Op::Abs, &[half]))
        }
        (Op::Root(m), Op::Power(n)) if n % i64::from(m) == 0 => Some(graph.apply(Op::Power(n / i64::from(m)), &[u])),
        (Op::Root(m), Op::Root(n)) => Some(graph.apply(Op::Root(m.checked_mul(n)?), &[u])),
        _ => None,
    }
}
