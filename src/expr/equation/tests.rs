//! Tests of the rewriting: a table of equations with their sheets, and zero sets compared point by point.

use super::{Sheet, Sign, sheets, vanishes_with};
use crate::expr::estimate::{Estimate, Random, estimates};
use crate::expr::formula::formula;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::expr::print::text;

/// An equation's left side; its sheets as `g`, `g | guard`, `g / denominator`, `;` between sheets.
const ROWS: &[(&str, &str)] = &[
    // Nothing to do.
    ("x^2+y^2+z^2-1", "x^2+y^2+z^2-1"),
    ("z-sin(x)*cos(y)", "z-sin(x)*cos(y)"),
    ("min(x,y)", "min(x,y)"),
    ("max(x^2+y^2-1, abs(z)-1)", "max(x^2+y^2-1, abs(z)-1)"),
    ("ln(x)", "ln(x)"),
    ("floor(x)-z", "floor(x)-z"),
    ("x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+11.8", "x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+11.8"),
    ("z-1/(1+x^2+y^2)", "z-1/(1+x^2+y^2)"),
    ("1/(x^2+y^2+z^2)+1/((x-1)^2+y^2+z^2)-4", "1/(x^2+y^2+z^2)+1/((x-1)^2+y^2+z^2)-4"),
    ("z-sqrt(1-x^2-y^2)", "z-sqrt(1-x^2-y^2)"),
    ("z-1/x^2", "z-1/x^2"),
    // Polynomials in exponentials.
    ("exp(x)^2-2*z*exp(x)+z^2", "exp(x)-z"),
    ("exp(2*x)-2*exp(x)+1", "x"),
    ("exp(4*y)+2*x*exp(2*y)+x^2", "exp(2*y)+x"),
    // Far from the origin.
    ("x^2-200000*x+9999999999+y^2+z^2", "(x-100000)^2+y^2+z^2-1"),
    ("x^2+y^2-2*1e6*y+z^2+1e12-4", "x^2+(y-1000000)^2+z^2-4"),
    ("2*x^4-800*x^3+120000*x^2-8000000*x+199999999+y", "2*(x-100)^4+y-1"),
    ("x^2-200*x+9999+sin(y)+z", "(x-100)^2+sin(y)+z-1"),
    ("x^2-200*x+9999+ln(y)*z", "(x-100)^2+ln(y)*z-1"),
    ("(x-100000)^2+y^2+z^2-1", "(x-100000)^2+y^2+z^2-1"),
    ("x^2-4*x+y^2+z^2", "x^2-4*x+y^2+z^2"),
    ("x^2*y-200*x+9999+z", "x^2*y-200*x+9999+z"),
    // Outer functions.
    ("(x^2+y^2+z^2-1)^2", "x^2+y^2+z^2-1"),
    ("(x^2+y^2+z^2-1)^3", "x^2+y^2+z^2-1"),
    ("((x^2+y^2+z^2-1)^3)^4", "x^2+y^2+z^2-1"),
    ("abs(x^2+y^2-z)", "x^2+y^2-z"),
    ("-(x^2+y^2-z)", "z-(x^2+y^2)"),
    ("3*(x^2+y^2-z)", "x^2+y^2-z"),
    ("(x^2+y^2-z)/-7", "x^2+y^2-z"),
    ("sqrt(x^2+y^2-1)", "x^2+y^2-1"),
    ("sqrt(abs(x^2+y^2-1))", "x^2+y^2-1"),
    ("cbrt(x+y*z)", "x+y*z"),
    ("atan(x+y*z)", "x+y*z"),
    ("tanh(-2*(x+y*z)^3)", "x+y*z"),
    ("(x+y*z)^1.5", "x+y*z"),
    ("tan(x+y*z)", "sin(x+y*z)"),
    ("exp(x*y)-exp(z)", "x*y-z"),
    ("exp(x*y)-1", "x;y"),
    ("1-exp(z-x*y)", "z-x*y"),
    ("-5*abs((x^2+y^2+z^2-1)^3)^2/3", "x^2+y^2+z^2-1"),
    // Without solution.
    ("x^2+1", ""),
    ("exp(x)", ""),
    ("1/x", ""),
    ("x^-3", ""),
    ("3", ""),
    ("exp(x)*(x^2+y^2+1)", ""),
    ("cosh(x*y)", ""),
    // Products.
    ("x*y", "x;y"),
    ("x*y*z", "x;y;z"),
    ("x^2*y^3", "x;y"),
    ("(x^2+y^2+z^2-1)*(x-y)", "x^2+y^2+z^2-1;x-y"),
    ("x*(x-y)*(x-y)", "x;x-y"),
    ("exp(y)*(x+z)", "x+z"),
    ("ln(x)*z", "ln(x);z | ln(x)"),
    ("sqrt(x)*z", "x;z | sqrt(x)"),
    ("sqrt(x)*x", "x"),
    ("asin(x)*(y-z)*ln(z)", "x|ln(z);y-z|asin(x)|ln(z);ln(z)|asin(x)"),
    ("0*ln(x)+z*0", "0*ln(x)"),
    // Quotients.
    ("x*(1/x)", ""),
    ("x/x", ""),
    ("(x^2-1)/(x-1)", "x+1 / x-1"),
    ("(x-1)^2/(x-1)", ""),
    ("(x^2-2*x+1)/(x-1)", ""),
    ("(x^2+y^2-1)/z", "x^2+y^2-1 / z"),
    ("(x*y)/(y*z)", "x / y*z"),
    ("(x^2-y^2)/(x^3-y^3)", "x+y / x^3-y^3"),
    ("z/ln(x)", "z / ln(x)"),
    ("x/sqrt(x)", ""),
    ("x/(1+y^2)", "x"),
    // Fractions put together.
    ("z-1/x", "x*z-1 / x"),
    ("x*y-1/z", "x*y*z-1 / z"),
    ("z-tan(x)", "z*cos(x)-sin(x) / cos(x)"),
    ("1/x+1/y-1/z", "z*(x+y)-x*y / x / y / z"),
    ("x^2/(y-1)-z", "x^2-(y-1)*z / y-1"),
    ("x/x-1+y-y", "x/x-1"),
    ("1/x-1/x^3", "x^2-1 / x"),
    ("1/(1/x)-y", "x-y / x"),
    ("z-sin(x)/x", "x*z-sin(x) / x"),
    ("(x/y)^2-z", "x^2-z*y^2 / y"),
    ("(x+1/y)^-1-z", "x*y*z-y+z / y / x*y+1"),
    // Repeated factors in expanded form.
    ("z^2-2*z*sin(x)+sin(x)^2", "z-sin(x)"),
    ("x^4+y^4+z^4+2*x^2*y^2+2*x^2*z^2+2*y^2*z^2-2*x^2-2*y^2-2*z^2+1", "x^2+y^2+z^2-1"),
    ("x^2+2*x*y+y^2", "x+y"),
    ("-x^2-2*x*y-y^2", "x+y"),
    ("x^3-3*x^2*y+3*x*y^2-y^3", "x-y"),
    ("x^3+x^2*y", "x;x+y"),
    ("x^2*z-2*x*y*z+y^2*z", "z;x-y"),
    ("0.01*x^2-0.2*x*y+y^2", "x-10*y"),
    ("x^2+2*x*ln(y)+ln(y)^2", "x+ln(y)"),
    ("x^2-2*x*abs(y)+y^2-1", "x^2-2*x*abs(y)+y^2-1"),
    ("x^2*ln(z)+x^3", "x|ln(z);ln(z)+x"),
    ("(x^2+y^2+z^2-1)^2+0.000000001*0", "x^2+y^2+z^2-1"),
    ("(x-y)^2*(x-1)-(x-y)^3", "x-y;y-1"),
];

fn described(graph: &mut Graph, text: &str) -> Vec<(NodeId, Vec<NodeId>, Vec<NodeId>)> {
    let mut list = Vec::new();
    for sheet in text.split(';').filter(|s| !s.trim().is_empty()) {
        let mut guards: Vec<&str> = sheet.split('|').collect();
        let last = guards.len() - 1;
        let mut denominators: Vec<&str> = guards[last].split(" / ").collect();
        guards[last] = denominators.remove(0);
        let g = formula(graph, guards.remove(0));
        let mut all = [guards, denominators].map(|texts| {
            let mut ids: Vec<NodeId> = texts.into_iter().map(|t| formula(graph, t)).collect();
            ids.sort();
            ids
        });
        list.push((g, std::mem::take(&mut all[0]), std::mem::take(&mut all[1])));
    }
    list.sort();
    list
}

#[test]
fn equations_become_the_sheets_expected() {
    let mut wrong = Vec::new();
    for (input, expected) in ROWS {
        let mut graph = Graph::new();
        let f = formula(&mut graph, input);
        let equation = sheets(&mut graph, f);
        let expected = described(&mut graph, expected);
        let mut found: Vec<(NodeId, Vec<NodeId>, Vec<NodeId>)> = equation
            .sheets
            .iter()
            .map(|s| {
                let (mut guards, mut nonzero) = (s.guards.clone(), s.nonzero.clone());
                guards.sort();
                nonzero.sort();
                // A polynomial may come back with the other sign.
                let g = expected.iter().map(|e| e.0).find(|&e| e == s.g || graph.apply(Op::Neg, &[e]) == s.g);
                (g.unwrap_or(s.g), guards, nonzero)
            })
            .collect();
        found.sort();
        if found != expected {
            let show = |list: &[(NodeId, Vec<NodeId>, Vec<NodeId>)]| {
                let text = |id: &NodeId| text(&graph, *id, 2000);
                let texts = |ids: &[NodeId]| ids.iter().map(text).collect::<Vec<_>>();
                list.iter()
                    .map(|(g, a, b)| format!("{:?} | {:?} / {:?}", text(g), texts(a), texts(b)))
                    .collect::<Vec<_>>()
            };
            wrong.push(format!("{input}: {:#?}, not {:#?} {:?}", show(&found), show(&expected), equation.steps));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether a sheet's conditions hold at a point; `None` if rounding hides it.
fn allowed(graph: &Graph, sheet: &Sheet, point: [f64; 3]) -> Option<bool> {
    let mut all = true;
    for (list, zero_is_out) in [(&sheet.guards, false), (&sheet.nonzero, true)] {
        for value in estimates(graph, list, point, [0.0; 3]) {
            match value {
                Estimate::Nothing => all = false,
                Estimate::Value(v, e) if zero_is_out => match (v == 0.0, v.abs() > e || e == 0.0) {
                    (_, false) => return None,
                    (zero, true) => all &= !zero,
                },
                Estimate::Value(..) => {}
                Estimate::Unsure => return None,
            }
        }
    }
    Some(all)
}

/// Compares the zeros of f and of its sheets at points with small whole coordinates, which hit zeros exactly; the
/// number of zeros met.
fn compare_zeros(graph: &mut Graph, f: NodeId, random: &mut Random, points: usize) -> usize {
    let equation = sheets(graph, f);
    let mut zeros = 0;
    for _ in 0..points {
        let point = [(); 3].map(|()| random.below(7) as f64 - 3.0);
        let expected = match estimates(graph, &[f], point, [0.0; 3])[0] {
            Estimate::Value(0.0, 0.0) => true,
            Estimate::Value(v, e) if v.abs() > e => false,
            Estimate::Nothing => false,
            _ => continue,
        };
        let mut found = Some(false);
        for sheet in &equation.sheets {
            let zero = match estimates(graph, &[sheet.g], point, [0.0; 3])[0] {
                Estimate::Value(0.0, 0.0) => allowed(graph, sheet, point),
                Estimate::Value(v, e) if v.abs() > e => Some(false),
                Estimate::Nothing => Some(false),
                _ => None,
            };
            found = if found == Some(true) || zero == Some(true) { Some(true) } else { found.and(zero) };
        }
        if let Some(found) = found {
            zeros += usize::from(expected);
            assert_eq!(found, expected, "{:?} at {point:?}: {equation:?}", text(graph, f, 2000));
        }
    }
    zeros
}

#[test]
fn zeros_of_the_sheets_are_the_zeros_of_the_equation() {
    let mut random = Random(5);
    let mut zeros = 0;
    for (text, _) in ROWS {
        let mut graph = Graph::new();
        let f = formula(&mut graph, text);
        zeros += compare_zeros(&mut graph, f, &mut random, 3000);
    }
    assert!(zeros > 5000, "{zeros}");
}

#[test]
fn zeros_of_random_equations_are_kept() {
    let mut random = Random(6);
    let (mut zeros, mut rewritten) = (0, 0);
    for _ in 0..6000 {
        let mut graph = Graph::new();
        let mut pool: Vec<NodeId> = ["x", "y", "z", "x", "y", "1", "2"].map(|t| formula(&mut graph, t)).to_vec();
        for _ in 0..2 + random.below(8) {
            let op = match random.below(12) {
                0..=2 => Op::Add,
                3..=5 => Op::Sub,
                6 | 7 => Op::Mul,
                8 => Op::Div,
                9 => Op::Power([2, 3, -1, -2][random.below(4)]),
                _ => [Op::Abs, Op::Sqrt, Op::Ln, Op::Sin, Op::Tan, Op::Neg, Op::Exp, Op::Root(3), Op::Min]
                    [random.below(9)],
            };
            let recent = pool.len() - 4;
            let args: Vec<NodeId> = (0..op.arity())
                .map(|_| pool[if random.below(3) > 0 { recent + random.below(4) } else { random.below(pool.len()) }])
                .collect();
            pool.push(graph.apply(op, &args));
        }
        let f = pool[pool.len() - 1];
        rewritten += usize::from(!sheets(&mut graph, f).steps.is_empty());
        zeros += compare_zeros(&mut graph, f, &mut random, 60);
    }
    assert!(zeros > 8000 && rewritten > 2000, "{zeros} zeros, {rewritten} rewritten");
}

#[test]
fn the_sign_of_a_sheet_is_what_it_says() {
    let mut random = Random(6);
    let mut compared = 0;
    for (text, _) in ROWS {
        let mut graph = Graph::new();
        let f = formula(&mut graph, text);
        for sheet in sheets(&mut graph, f).sheets {
            for _ in 0..300 {
                let point = [(); 3].map(|()| random.within(-2.0, 2.0));
                let [Estimate::Value(v, e), Estimate::Value(g, d)] =
                    estimates(&graph, &[f, sheet.g], point, [0.0; 3])[..]
                else {
                    continue;
                };
                let same = v * g > 0.0;
                if sheet.sign != Sign::Unrelated && v.abs() > e && g.abs() > d {
                    compared += 1;
                    assert_eq!(same, sheet.sign == Sign::Same, "{text} at {point:?}: {v} {g} {sheet:?}");
                }
            }
        }
    }
    assert!(compared > 2000, "{compared}");
}

#[test]
fn numerators_that_vanish_with_their_denominator_are_known() {
    let rows = [
        ("x*z-sin(x)", "x", true),
        ("x*z-cos(x)", "x", false),
        ("(x-y)*z-sin(x-y)", "x-y", true),
        ("(2*x-3)*z+2*x-3", "2*x-3", true),
        ("z*(x/3-y^2)-sin(2*x/3-2*y^2)", "x/3-y^2", true),
        ("z*cos(x)-sin(x)", "cos(x)", false),
        ("x*ln(x)", "x", false),
        ("x*y*z-1", "x", false),
        ("x^2*z-1+cos(x)", "x", true),
    ];
    for (numerator, denominator, expected) in rows {
        let mut graph = Graph::new();
        let [g, d] = [numerator, denominator].map(|t| formula(&mut graph, t));
        assert_eq!(vanishes_with(&mut graph, g, d), expected, "{numerator} where {denominator} = 0");
    }
}

#[test]
fn large_formulas_are_rewritten_quickly() {
    let start = std::time::Instant::now();
    let sum: String = (1..2000).map(|k| format!("+exp(-(x-{k})^2-y^2)")).collect();
    let poles: String = (1..2000).map(|k| format!("+1/(x-{k})")).collect();
    let squares: String = (1..400).map(|k| format!("*(x+y+z+sin(x)+{k})")).collect();
    let wide = format!("(x+y+z+sin(x)+cos(y)+ln(z)+1)^9*x^2+x^2{}", "+(x+y*z)^30".repeat(50));
    for text in [format!("z{sum}"), format!("z{poles}"), format!("x^2{squares}+x^2*y"), wide] {
        let mut graph = Graph::new();
        let f = formula(&mut graph, &text);
        assert!(!sheets(&mut graph, f).sheets.is_empty());
    }
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
}
