//! What the evaluator makes of a formula: the list of its steps, and what sharing saves.
//!
//! In: the node f. Out: steps as text, and counts. Separate from the drawing of the graph: here is what runs.

use super::drawing::{label, shape};
use super::notation::function;
use crate::closure::Tape;
use crate::closure::tape::{Action, Register, Step};
use crate::expr::derivative::gradient;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;

/// The most steps that are listed.
pub const MAX_LISTED: usize = 80;

/// What it takes to compute a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// The steps of f alone, each `r3 = r1 + r2`.
    pub steps: Vec<String>,
    /// Registers of f alone.
    pub registers: usize,
    /// Steps of f with its three derivatives, as they run.
    pub gradient_steps: usize,
    /// Registers of that.
    pub gradient_registers: usize,
    /// Operations of f and its three derivatives, each written out as a tree of its own; saturating.
    pub written_out: u64,
    /// Nodes of the graph that they share.
    pub shared: usize,
}

/// What the evaluator makes of f.
pub fn evaluation(graph: &mut Graph, f: NodeId) -> Evaluation {
    let [x, y, z] = gradient(graph, f);
    let tape = Tape::new(graph, &[f]);
    let with_gradient = Tape::for_points(graph, &[f, x, y, z]);
    let whole = shape(graph, &[f, x, y, z]);
    let constants: Vec<(Register, f64)> = tape.constants.iter().map(|(r, c)| (*r, c.point)).collect();
    let steps = tape.steps.iter().map(|step| line(step, &constants)).collect();
    Evaluation {
        steps,
        registers: tape.registers,
        gradient_steps: with_gradient.steps.len(),
        gradient_registers: with_gradient.registers,
        written_out: whole.tree,
        shared: whole.nodes,
    }
}

fn line(step: &Step, constants: &[(Register, f64)]) -> String {
    let name = |r: Register| match (r, constants.iter().find(|(known, _)| *known == r)) {
        (_, Some((_, value))) => super::page::shown(*value),
        (0, _) => "x".into(),
        (1, _) => "y".into(),
        (2, _) => "z".into(),
        (r, _) => format!("r{r}"),
    };
    let [a, b, c, d] = step.args.map(name);
    let out = format!("r{}", step.out);
    match step.action {
        Action::One(op) => format!("{out} = {}", operation(op, [&a, &b, &c])),
        Action::SinCos(cosine) => format!("{out} = sin({a}), r{cosine} = cos({a})"),
        Action::Sized => format!("{out} = {a}"),
        Action::Products { minus } => format!("{out} = {a}*{b} {} {c}*{d}", if minus { "-" } else { "+" }),
        Action::Pair(pair) => format!("{out} = {pair:?}({a}, {b}, {c})"),
    }
}

fn operation(op: Op, [a, b, c]: [&str; 3]) -> String {
    match op {
        Op::Add => format!("{a} + {b}"),
        Op::Sub => format!("{a} - {b}"),
        Op::Mul => format!("{a} * {b}"),
        Op::Div => format!("{a} / {b}"),
        Op::Neg => format!("-{a}"),
        Op::Power(n) => format!("{a}^{n}"),
        Op::Pow => format!("{a}^{b}"),
        Op::FloorDiv(n) => format!("floor({n}*{a}/{b})"),
        Op::Root(n) => format!("root({n}, {a})"),
        Op::Choose => format!("if({a} <= 0, {b}, {c})"),
        Op::Min | Op::Max | Op::Atan2 => format!("{}({a}, {b})", function(op)),
        op => format!("{}({a})", function(op)),
    }
}

/// What a node is, for those who read no list of steps: its label and how often it is used.
pub fn shared_parts(graph: &Graph, root: NodeId) -> Vec<(String, usize)> {
    let list = shape(graph, &[root]).shared;
    list.into_iter()
        .map(|(id, uses)| (crate::expr::print::text(graph, id, 80).unwrap_or_else(|| label(graph, id)), uses))
        .collect()
}
