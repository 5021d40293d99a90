//! Derivations against themselves, against the graph's own rules, and against what a person would write.

use super::*;
use crate::expr::derivative::gradient;
use crate::expr::formula::typed;
use crate::expr::graph::NodeId;
use crate::teach::classify::COORDINATES;
use crate::teach::notation::{Form, text};

/// The formulas of the tables that the project keeps for values and derivatives.
fn table() -> Vec<String> {
    let files = [
        (include_str!("../../../tests/data/derivatives.tsv"), 1),
        // Every twentieth of the random programs: they are made to be nasty, and there are 2000.
        (include_str!("../../../tests/data/random-formulas.tsv"), 20),
    ];
    let mut all = Vec::new();
    for (file, stride) in files {
        let rows = file.lines().filter(|line| !line.starts_with('#')).filter_map(|line| line.split('\t').next());
        let mut rows: Vec<String> = rows.map(str::to_owned).collect();
        rows.dedup();
        all.extend(rows.into_iter().step_by(stride));
    }
    all
}

fn derivations(program: &str) -> (Graph, NodeId, Vec<Derivation>) {
    let (graph, f) = typed(program);
    let term = Term::of(&graph, f);
    let list = COORDINATES.into_iter().filter_map(|v| derive(term.as_ref()?, v)).collect();
    (graph, f, list)
}

#[test]
fn every_line_has_the_value_of_the_one_before() {
    let (mut lines, mut compared) = (0, 0);
    for program in table() {
        let (mut graph, f, list) = derivations(&program);
        let slopes = gradient(&mut graph, f);
        for derivation in &list {
            let (wrong, points) = derivation.compared(&mut graph, Simd::best());
            let shown = |k: usize| derivation.lines.get(k).map(|line| (text::write(&Form::of(&line.term)), line.rule));
            assert_eq!(wrong, None, "{program}: {:?}\n{:?}", wrong.map(|k| shown(k - 1)), wrong.map(shown));
            // The last line against the graph's own derivative.
            let place = COORDINATES.iter().position(|&v| v == derivation.variable).unwrap();
            let ours = derivation.result().unwrap().node(&mut graph);
            let pair = [ours, slopes[place]].map(|node| Formula::new(&mut graph, node, Simd::best()));
            for point in Points::new().take(POINTS) {
                let [a, b] = [&pair[0], &pair[1]].map(|formula| formula.value(point));
                let is_same = !(a.is_finite() && b.is_finite()) || (a - b).abs() <= SAME * (1.0 + a.abs().max(b.abs()));
                assert!(is_same, "{program} at {point}: {a} is not {b}");
            }
            lines += derivation.lines.len();
            compared += usize::from(points > 0);
        }
    }
    assert!(lines > 3000 && compared > 300, "{lines} lines, {compared} derivations with points");
}

#[test]
fn a_wrong_line_is_found() {
    let (mut graph, _, list) = derivations("x^2*sin(y)+z");
    let mut derivation = list[0].clone();
    let last = derivation.lines.len() - 1;
    derivation.lines[last].term = Term::Sum(vec![derivation.lines[last].term.clone(), Term::integer(1)]);
    assert_eq!(derivation.compared(&mut graph, Simd::best()).0, Some(last));
}

#[test]
fn results_are_as_a_person_writes_them() {
    let rows = [
        ("x^2+y^2+z^2-1", ["2*x", "2*y", "2*z"]),
        ("(x^2+y^2+z^2-1)^2", ["4*x*(x^2 + y^2 + z^2 - 1)", "4*y*(x^2 + y^2 + z^2 - 1)", "4*z*(x^2 + y^2 + z^2 - 1)"]),
        ("z - sin(x)*cos(y)", ["-cos(x)*cos(y)", "sin(x)*sin(y)", "1"]),
        ("z - x/y", ["-1/y", "x/y^2", "1"]),
        ("sqrt(x^2+y^2) - z", ["x/sqrt(x^2 + y^2)", "y/sqrt(x^2 + y^2)", "-1"]),
        ("exp(-x^2) - z", ["-2*x*exp(-x^2)", "0", "-1"]),
        ("x*y*z - 1", ["y*z", "x*z", "x*y"]),
        ("z - x^3/3", ["-x^2", "0", "1"]),
        ("ln(x*y) - z", ["y/(x*y)", "x/(x*y)", "-1"]),
        ("z - tan(x)", ["-(1 + tan(x)^2)", "0", "1"]),
        ("x^2*y^3", ["2*x*y^3", "3*x^2*y^2", "0"]),
        ("x+2*x+y", ["3", "1", "0"]),
    ];
    for (program, expected) in rows {
        let (_, _, list) = derivations(program);
        let shown: Vec<String> = list.iter().map(|d| text::write(&Form::of(d.result().unwrap()))).collect();
        assert_eq!(shown, expected, "{program}");
    }
}

#[test]
fn rules_are_named_in_the_order_of_a_first_course() {
    let (_, _, list) = derivations("(x^2+y)^3 - z");
    let rules: Vec<&str> = list[0].lines.iter().map(|line| line.rule).collect();
    assert_eq!(
        rules,
        ["", "rule.sum", "rule.chain.power", "rule.sum", "rule.power", "rule.constant", "tidy.zeros", "tidy.numbers"]
    );
}
