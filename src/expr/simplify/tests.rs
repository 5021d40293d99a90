//! Tests of the rules: no value and no domain changes; what people write becomes one form.

use crate::expr::estimate::{Estimate, Random, estimates};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use crate::num::rational::Rational;

/// A random formula, as it was asked for and as the rules made it.
fn pair(graph: &mut Graph, random: &mut Random) -> (NodeId, NodeId) {
    let mut pool: Vec<(NodeId, NodeId)> = (0..4).map(|_| random.leaf(graph)).map(|id| (id, id)).collect();
    for _ in 0..2 + random.below(9) {
        // Arithmetic more often than functions, and recent nodes more often than old ones.
        let op = if random.below(2) == 0 {
            [Op::Neg, Op::Add, Op::Sub, Op::Mul, Op::Div, Op::Power(2), Op::Abs, Op::Sqrt][random.below(8)]
        } else {
            random.operation()
        };
        let picks: Vec<(NodeId, NodeId)> = (0..op.arity())
            .map(|_| {
                let recent = pool.len().saturating_sub(3);
                pool[if random.below(2) == 0 {
                    recent + random.below(pool.len() - recent)
                } else {
                    random.below(pool.len())
                }]
            })
            .collect();
        let plain: Vec<NodeId> = picks.iter().map(|p| p.0).collect();
        let ruled: Vec<NodeId> = picks.iter().map(|p| p.1).collect();
        let made = (graph.intern(op, &plain), graph.apply(op, &ruled));
        pool.push(made);
    }
    pool[pool.len() - 1]
}

#[test]
fn no_rule_changes_a_value_or_the_domain() {
    let mut random = Random(1);
    let (mut values, mut nothings) = (0, 0);
    for round in 0..60_000 {
        let mut graph = Graph::new();
        let (plain, ruled) = pair(&mut graph, &mut random);
        if plain == ruled {
            continue;
        }
        for _ in 0..4 {
            let point = [random.coordinate(), random.coordinate(), random.coordinate()];
            match estimates(&graph, &[plain, ruled], point, [0.0; 3])[..] {
                [Estimate::Value(a, e), Estimate::Value(b, d)] => {
                    values += 1;
                    assert!(
                        (a - b).abs() <= e + d + 1e-13 * a.abs(),
                        "{round}: {point:?} {a} ± {e} became {b} ± {d}\n{graph:?}"
                    );
                }
                [Estimate::Nothing, Estimate::Nothing] => nothings += 1,
                [Estimate::Unsure, _] | [_, Estimate::Unsure] => {}
                [a, b] => panic!("{round}: {point:?} {a:?} became {b:?}: {plain:?} {ruled:?}\n{graph:?}"),
                _ => unreachable!(),
            }
        }
    }
    assert!(values > 20_000 && nothings > 5_000, "{values} values and {nothings} without are too few to say anything");
}

#[test]
fn what_is_called_total_has_a_value_and_known_signs_hold() {
    let mut random = Random(2);
    for _ in 0..40_000 {
        let mut graph = Graph::new();
        let (plain, ruled) = pair(&mut graph, &mut random);
        let point = [random.coordinate(), random.coordinate(), random.coordinate()];
        for (id, value) in [plain, ruled].into_iter().zip(estimates(&graph, &[plain, ruled], point, [0.0; 3])) {
            if graph.is_total(id) {
                assert_ne!(value, Estimate::Nothing, "{point:?} {id:?} {graph:?}");
            }
            let Estimate::Value(v, e) = value else { continue };
            assert!(!graph.is_nonnegative(id) || v >= -e);
            assert!(!graph.is_nonpositive(id) || v <= e);
            assert!(!graph.is_nonzero(id) || v != 0.0 || e > 0.0);
        }
    }
}

type Build = fn(&mut Graph, [NodeId; 3]) -> NodeId;

fn check(name: &str, left: Build, right: Build) {
    let mut graph = Graph::new();
    let leaves = [Variable::X, Variable::Y, Variable::Z].map(|v| graph.variable(v));
    let (left, right) = (left(&mut graph, leaves), right(&mut graph, leaves));
    assert_eq!(left, right, "{name}: {graph:?}");
}

macro_rules! node {
    ($g:ident, $op:expr $(, $arg:expr)*) => {{ let args = [$($arg),*]; $g.apply($op, &args) }};
}

#[test]
fn what_people_write_becomes_one_form() {
    check(
        "x + x is 2x",
        |g, [x, ..]| node!(g, Op::Add, x, x),
        |g, [x, ..]| {
            let two = g.integer(2);
            g.intern(Op::Mul, &[two, x])
        },
    );
    check(
        "x*y*x is x^2*y",
        |g, [x, y, _]| {
            let p = node!(g, Op::Mul, x, y);
            node!(g, Op::Mul, p, x)
        },
        |g, [x, y, _]| {
            let square = node!(g, Op::Power(2), x);
            node!(g, Op::Mul, square, y)
        },
    );
    check(
        "(x - 1) + 1 is x",
        |g, [x, ..]| {
            let one = g.integer(1);
            let less = node!(g, Op::Sub, x, one);
            node!(g, Op::Add, less, one)
        },
        |_, [x, ..]| x,
    );
    check(
        "sqrt(x^2 + y^2)^2 is x^2 + y^2",
        |g, [x, y, _]| {
            let (a, b) = (node!(g, Op::Power(2), x), node!(g, Op::Power(2), y));
            let sum = node!(g, Op::Add, a, b);
            let root = node!(g, Op::Sqrt, sum);
            node!(g, Op::Power(2), root)
        },
        |g, [x, y, _]| {
            let (a, b) = (node!(g, Op::Power(2), x), node!(g, Op::Power(2), y));
            node!(g, Op::Add, a, b)
        },
    );
    check(
        "x + y - x is y",
        |g, [x, y, _]| {
            let sum = node!(g, Op::Add, x, y);
            node!(g, Op::Sub, sum, x)
        },
        |_, [_, y, _]| y,
    );
    check(
        "(y - x)^2 is (x - y)^2",
        |g, [x, y, _]| {
            let d = node!(g, Op::Sub, y, x);
            node!(g, Op::Power(2), d)
        },
        |g, [x, y, _]| {
            let d = node!(g, Op::Sub, x, y);
            node!(g, Op::Power(2), d)
        },
    );
    check(
        "((x^9)^9)^9 is x^729",
        |g, [x, ..]| {
            let nine = node!(g, Op::Power(9), x);
            let nine = node!(g, Op::Power(9), nine);
            node!(g, Op::Power(9), nine)
        },
        |g, [x, ..]| g.intern(Op::Power(729), &[x]),
    );
    check(
        "min(x - 1, 1 - x) is -|x - 1|",
        |g, [x, ..]| {
            let one = g.integer(1);
            let (a, b) = (node!(g, Op::Sub, x, one), node!(g, Op::Sub, one, x));
            node!(g, Op::Min, a, b)
        },
        |g, [x, ..]| {
            let one = g.integer(1);
            let a = node!(g, Op::Sub, x, one);
            let size = node!(g, Op::Abs, a);
            g.intern(Op::Neg, &[size])
        },
    );
    check(
        "floor(x/y) is one operation",
        |g, [x, y, _]| {
            let quotient = node!(g, Op::Div, x, y);
            node!(g, Op::Floor, quotient)
        },
        |g, [x, y, _]| g.intern(Op::FloorDiv(1), &[x, y]),
    );
    check(
        "floor(-0.6*x) is floor(3*(-x)/5)",
        |g, [x, ..]| {
            let c = g.number(Rational::from_fraction(-3, 5).unwrap());
            let product = node!(g, Op::Mul, c, x);
            node!(g, Op::Floor, product)
        },
        |g, [x, ..]| {
            let (minus, five) = (g.intern(Op::Neg, &[x]), g.integer(5));
            g.intern(Op::FloorDiv(3), &[minus, five])
        },
    );
    check(
        "the floor of x/4 is that of 0.25*x",
        |g, [x, ..]| {
            let four = g.integer(4);
            node!(g, Op::FloorDiv(1), x, four)
        },
        |g, [x, ..]| {
            let four = g.integer(4);
            let quotient = node!(g, Op::Div, x, four);
            g.intern(Op::Floor, &[quotient])
        },
    );
    check(
        "sin(pi/6) is 1/2",
        |g, _| {
            let (pi, six) = (g.intern(Op::Pi, &[]), g.integer(6));
            let angle = node!(g, Op::Div, pi, six);
            node!(g, Op::Sin, angle)
        },
        |g, _| {
            let (one, two) = (g.integer(1), g.integer(2));
            node!(g, Op::Div, one, two)
        },
    );
}

#[test]
fn what_would_change_the_domain_is_kept() {
    let rows: [(&str, Build); 6] = [
        ("x/x", |g, [x, ..]| node!(g, Op::Div, x, x)),
        ("sqrt(x)^2", |g, [x, ..]| {
            let r = node!(g, Op::Sqrt, x);
            node!(g, Op::Power(2), r)
        }),
        ("0*ln(x)", |g, [x, ..]| {
            let (l, zero) = (node!(g, Op::Ln, x), g.integer(0));
            node!(g, Op::Mul, zero, l)
        }),
        ("ln(x)^0", |g, [x, ..]| {
            let l = node!(g, Op::Ln, x);
            node!(g, Op::Power(0), l)
        }),
        ("ln(x) - ln(x)", |g, [x, ..]| {
            let l = node!(g, Op::Ln, x);
            node!(g, Op::Sub, l, l)
        }),
        ("exp(ln(x))", |g, [x, ..]| {
            let l = node!(g, Op::Ln, x);
            node!(g, Op::Exp, l)
        }),
    ];
    for (name, build) in rows {
        let mut graph = Graph::new();
        let leaves = [Variable::X, Variable::Y, Variable::Z].map(|v| graph.variable(v));
        let id = build(&mut graph, leaves);
        let none = if name == "x/x" { 0.0 } else { -1.0 };
        assert_eq!(estimates(&graph, &[id], [none, 0.0, 0.0], [0.0; 3])[0], Estimate::Nothing, "{name}");
        assert!(matches!(estimates(&graph, &[id], [2.0, 0.0, 0.0], [0.0; 3])[0], Estimate::Value(..)), "{name}");
    }
}
