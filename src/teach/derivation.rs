//! A partial derivative, step by step, each with the name of its rule.
//!
//! In: a formula and a variable. Out: the lines of the derivation, from d/dx of the formula to its tidy result; every line
//! has the value of the one before, which is tried at points. Separate from the rules so that their order is in
//! one place: the first derivative that is still to be taken says the rule, and all others of its kind follow at once.

use super::chance::Points;
use super::term::Term;
use super::{rules, shorten};
use crate::closure::Formula;
use crate::expr::graph::Graph;
use crate::expr::op::Variable;
use crate::num::level::Simd;

/// The most lines of one derivation.
const MAX_LINES: usize = 120;

/// The most parts of a line; what grows beyond is not shown.
const MAX_PARTS: usize = 4000;

/// How often the habits of tidying up are tried again: each round removes something.
const MAX_ROUNDS: usize = 12;

/// Points at which lines are compared.
pub const POINTS: usize = 20;

/// How far two lines may differ, relative to the sizes of both: a thousand roundings of long sums that cancel.
const SAME: f64 = 1e-9;

/// One line.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it says.
    pub term: Term,
    /// The key of the rule that made it from the line before; empty for the first.
    pub rule: &'static str,
}

/// All lines of one partial derivative.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivation {
    /// The variable.
    pub variable: Variable,
    /// From d/dv of the formula to the result.
    pub lines: Vec<Line>,
}

/// Derives f; `None` if it would take more lines or longer ones than anybody reads.
pub fn derive(f: &Term, variable: Variable) -> Option<Derivation> {
    let mut term = f.clone().derivative(variable);
    let mut lines = vec![Line { term: term.clone(), rule: "" }];
    while let Some(rule) = first_rule(&term) {
        term = take(term, rule);
        lines.push(Line { term: term.clone(), rule });
        if lines.len() > MAX_LINES || term.size() > MAX_PARTS {
            return None;
        }
    }
    for _ in 0..MAX_ROUNDS {
        let before = term.clone();
        for (rule, habit) in shorten::HABITS {
            let tidy = shorten::everywhere(term.clone(), habit);
            if tidy != term {
                lines.push(Line { term: tidy.clone(), rule });
                term = tidy;
            }
        }
        if term == before {
            break;
        }
    }
    Some(Derivation { variable, lines })
}

/// The rule of the first derivative that is still to be taken.
fn first_rule(term: &Term) -> Option<&'static str> {
    match term {
        Term::Derivative(v, u) => Some(rules::taken(*v, (**u).clone()).0),
        other => other.parts().into_iter().find_map(first_rule),
    }
}

/// Takes every derivative that this rule is for.
fn take(term: Term, rule: &'static str) -> Term {
    match term {
        Term::Derivative(v, u) => match rules::taken(v, (*u).clone()) {
            (name, taken) if name == rule => taken,
            _ => Term::Derivative(v, u),
        },
        other => other.map(&mut |part| take(part, rule)),
    }
}

impl Derivation {
    /// The last line.
    pub fn result(&self) -> Option<&Term> {
        self.lines.last().map(|line| &line.term)
    }

    /// The first line whose value differs from that of the line before at one of [`POINTS`] points where both have a value,
    /// and at how many points lines could be compared.
    pub fn compared(&self, graph: &mut Graph, simd: Simd) -> (Option<usize>, usize) {
        let formulas: Vec<Formula> = self
            .lines
            .iter()
            .map(|line| {
                let node = line.term.node(graph);
                Formula::new(graph, node, simd)
            })
            .collect();
        let (mut wrong, mut tried) = (None, 0);
        for point in Points::new().take(POINTS) {
            let values: Vec<f64> = formulas.iter().map(|formula| formula.value(point)).collect();
            tried += usize::from(values.iter().all(|value| value.is_finite()));
            for (k, pair) in values.windows(2).enumerate() {
                let scale = 1.0 + pair[0].abs().max(pair[1].abs());
                if pair.iter().all(|value| value.is_finite()) && (pair[0] - pair[1]).abs() > SAME * scale {
                    wrong = wrong.or(Some(k + 1));
                }
            }
        }
        (wrong, tried)
    }
}

#[cfg(test)]
mod tests;
