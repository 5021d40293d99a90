//! Tests of the derivatives: against dual numbers, and against a table of fifty digits.

#![allow(clippy::disallowed_methods, reason = "judged by the standard library")]

use super::{along_ray, derivative, gradient};
use crate::expr::estimate::{Estimate, Random, estimates, plain};
use crate::expr::formula::typed;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};

/// The derivative of an operation at plain numbers with plain rates: written a second time, in other forms.
fn dual(op: Op, [a, b, _]: [f64; 3], [p, q, r]: [f64; 3]) -> f64 {
    match op {
        Op::Constant(_) | Op::Pi | Op::E | Op::Variable(_) | Op::Floor | Op::FloorDiv(_) | Op::Sign => 0.0,
        Op::Neg => -p,
        Op::Abs => {
            if a < 0.0 {
                -p
            } else {
                p
            }
        }
        Op::Sqrt => 0.5 * p * a.powf(-0.5),
        Op::Exp => a.exp() * p,
        Op::Ln => p / a,
        Op::Log2 => p / a * std::f64::consts::LOG2_E,
        Op::Log10 => p / a * std::f64::consts::LOG10_E,
        Op::Sin => a.cos() * p,
        Op::Cos => -a.sin() * p,
        Op::Tan => p / (a.cos() * a.cos()),
        Op::Asin => p / ((1.0 - a) * (1.0 + a)).sqrt(),
        Op::Acos => -p / ((1.0 - a) * (1.0 + a)).sqrt(),
        Op::Atan => p / (1.0 + a * a),
        Op::Sinh => a.cosh() * p,
        Op::Cosh => a.sinh() * p,
        Op::Tanh => p / (a.cosh() * a.cosh()),
        Op::Asinh => p / a.hypot(1.0),
        Op::Acosh => p / ((a - 1.0).sqrt() * (a + 1.0).sqrt()),
        Op::Atanh => p / ((1.0 - a) * (1.0 + a)),
        Op::Erf => std::f64::consts::FRAC_2_SQRT_PI * (-a * a).exp() * p,
        Op::Power(n) => n as f64 * a.powf(n as f64 - 1.0) * p,
        Op::Root(n) => plain(op, a, 0.0, 0.0) / (a * f64::from(n)) * p,
        Op::Add => p + q,
        Op::Sub => p - q,
        Op::Mul => p * b + a * q,
        Op::Div => (p * b - a * q) / (b * b),
        Op::Min => {
            if a <= b {
                p
            } else {
                q
            }
        }
        Op::Max => {
            if a >= b {
                p
            } else {
                q
            }
        }
        Op::Pow => {
            let power = if p == 0.0 { 0.0 } else { b * a.powf(b - 1.0) * p };
            power + if q == 0.0 { 0.0 } else { a.powf(b) * a.ln() * q }
        }
        Op::Atan2 => (b * p - a * q) / (a * a + b * b),
        Op::Choose => {
            if a <= 0.0 {
                q
            } else {
                r
            }
        }
    }
}

/// f's value and rate of change by dual numbers.
fn dual_of(graph: &Graph, f: NodeId, point: [f64; 3], rates: [f64; 3]) -> f64 {
    let mut all = vec![(0.0, 0.0); graph.len()];
    for id in graph.reachable(&[f]) {
        let mut args = [(0.0, 0.0); 3];
        for (slot, a) in args.iter_mut().zip(graph.args(id)) {
            *slot = all[a.0 as usize];
        }
        let op = graph.op(id);
        all[id.0 as usize] = match op {
            Op::Constant(index) => (graph.constants(index).to_f64(), 0.0),
            Op::Variable(Variable::X) => (point[0], rates[0]),
            Op::Variable(Variable::Y) => (point[1], rates[1]),
            Op::Variable(Variable::Z) => (point[2], rates[2]),
            op => (plain(op, args[0].0, args[1].0, args[2].0), dual(op, args.map(|a| a.0), args.map(|a| a.1))),
        };
    }
    all[f.0 as usize].1
}

/// Compares the symbolic derivative with the dual one; says whether there was something to compare.
fn agrees(graph: &Graph, f: NodeId, slope: NodeId, point: [f64; 3], rates: [f64; 3]) -> bool {
    let [Estimate::Value(..), Estimate::Value(symbolic, error)] = estimates(graph, &[f, slope], point, rates)[..]
    else {
        return false;
    };
    let expected = dual_of(graph, f, point, rates);
    if !expected.is_finite() || expected.abs() > 1e9 {
        return false;
    }
    let allowed = 30.0 * error + 1e-11 * (1.0 + expected.abs());
    assert!(
        (symbolic - expected).abs() <= allowed,
        "{point:?} {symbolic} ± {error}, dual {expected}: {f:?} {slope:?}\n{graph:?}"
    );
    true
}

#[test]
fn every_operation_agrees_with_dual_numbers() {
    let mut random = Random(3);
    for op in Op::ALL.into_iter().chain([3, -1, -2, 7].map(Op::Power)).chain([5, 9].map(Op::Root)) {
        let mut graph = Graph::new();
        let leaves = [Variable::X, Variable::Y, Variable::Z].map(|v| graph.variable(v));
        // Arguments that depend on everything, so that no rate is trivially 0.
        let products = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| graph.apply(Op::Mul, &[leaves[i], leaves[j]]));
        let args: Vec<NodeId> = (0..op.arity()).map(|i| graph.apply(Op::Add, &[leaves[i], products[i]])).collect();
        let f = match op {
            Op::Constant(_) => graph.integer(3),
            Op::Variable(v) => graph.variable(v),
            op => graph.apply(op, &args),
        };
        let slope = along_ray(&mut graph, &[f])[0];
        let compared = (0..4000)
            .filter(|_| {
                let [point, rates] = [(); 2].map(|()| [(); 3].map(|()| random.within(-2.0, 2.0)));
                agrees(&graph, f, slope, point, rates)
            })
            .count();
        assert!(compared > 300, "{op:?}: only {compared} points");
    }
}

#[test]
fn random_formulas_agree_with_dual_numbers() {
    let mut random = Random(4);
    let mut compared = 0;
    for _ in 0..20_000 {
        let mut graph = Graph::new();
        let mut pool: Vec<NodeId> = (0..4).map(|_| random.leaf(&mut graph)).collect();
        for _ in 0..2 + random.below(7) {
            let op = random.operation();
            let args: Vec<NodeId> = (0..op.arity()).map(|_| pool[random.below(pool.len())]).collect();
            pool.push(graph.apply(op, &args));
        }
        let f = pool[pool.len() - 1];
        let slope = along_ray(&mut graph, &[f])[0];
        let [point, rates] = [(); 2].map(|()| [(); 3].map(|()| random.within(-2.0, 2.0)));
        compared += usize::from(agrees(&graph, f, slope, point, rates));
    }
    assert!(compared > 5000, "only {compared}");
}

#[test]
fn the_second_derivative_is_the_derivative_of_the_first() {
    let mut graph = Graph::new();
    let x = graph.variable(Variable::X);
    let (cube, sine) = (graph.apply(Op::Power(3), &[x]), graph.apply(Op::Sin, &[x]));
    let f = graph.apply(Op::Mul, &[cube, sine]);
    let first = along_ray(&mut graph, &[f])[0];
    let second = along_ray(&mut graph, &[first])[0];
    for i in 0..100 {
        let t = f64::from(i) * 0.07 - 3.0;
        let exact = 4.0 * (6.0 * t * t.sin() + 6.0 * t * t * t.cos() - t.powi(3) * t.sin());
        let Estimate::Value(value, _) = estimates(&graph, &[second], [t, 0.0, 0.0], [2.0, 0.0, 0.0])[0] else {
            panic!("no value at {t}")
        };
        assert!((value - exact).abs() < 1e-10 * (1.0 + exact.abs()), "{t}: {value} {exact}");
    }
}

#[test]
fn derivatives_of_shared_formulas_stay_linear() {
    let mut graph = Graph::new();
    let leaves = [Variable::X, Variable::Y, Variable::Z].map(|v| graph.variable(v));
    let mut u = graph.apply(Op::Add, &[leaves[0], leaves[1]]);
    for i in 0..60 {
        let sine = graph.apply(Op::Sin, &[u]);
        let product = graph.apply(Op::Mul, &[u, sine]);
        u = graph.apply(Op::Add, &[product, leaves[i % 3]]);
    }
    let size = graph.reachable(&[u]).len();
    let slopes = gradient(&mut graph, u);
    let both = graph.reachable(&slopes).len();
    assert!(both < 14 * size, "{size} nodes became {both}");
}

#[test]
fn an_enormous_power_is_harmless() {
    let mut graph = Graph::new();
    let x = graph.variable(Variable::X);
    let f = graph.apply(Op::Power(1_000_000_000), &[x]);
    let (one, zero) = (graph.integer(1), graph.integer(0));
    let slope = derivative(&mut graph, &[f], [one, zero, zero])[0];
    assert_eq!(graph.op(graph.args(slope)[1]), Op::Power(999_999_999));
    let least = graph.apply(Op::Power(i64::MIN), &[x]);
    derivative(&mut graph, &[least], [one, zero, zero]);
}

#[test]
fn values_and_gradients_agree_with_fifty_digits() {
    let (mut rows, mut unsure) = (0, 0);
    for line in include_str!("../../../tests/data/derivatives.tsv").lines() {
        let columns: Vec<&str> = line.split('\t').collect();
        let numbers = |i: usize| columns[i].split(' ').map(|n| n.parse::<f64>().unwrap()).collect::<Vec<f64>>();
        let (point, value, slopes) = (numbers(1), numbers(2), numbers(3));
        let (mut graph, f) = typed(columns[0]);
        let [a, b, c] = gradient(&mut graph, f);
        let found = estimates(&graph, &[f, a, b, c], [point[0], point[1], point[2]], [0.0; 3]);
        for (estimate, exact) in found.into_iter().zip(value.into_iter().chain(slopes)) {
            rows += 1;
            match estimate {
                Estimate::Value(v, e) => {
                    assert!((v - exact).abs() <= e + 1e-14 * exact.abs(), "{line}: {v} ± {e}, exactly {exact}")
                }
                Estimate::Nothing => panic!("{line}: no value"),
                Estimate::Unsure => unsure += 1,
            }
        }
    }
    assert!(rows == 2400 && unsure < 60, "{rows} numbers, {unsure} of them unsure");
}
