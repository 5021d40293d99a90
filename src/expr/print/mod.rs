//! A node as text: in the language, so that it reads back as the same node, and in LaTeX.
//!
//! In: a node. Out: text, with the fewest brackets; or none where sharing would make it longer than asked for, and
//! then [`definitions`] names what is shared. Separate because how a formula looks is no property of the formula.

use super::graph::{Graph, NodeId};
use super::op::{Op, Variable};
use crate::num::rational::Rational;
use std::collections::BTreeMap;

/// How tightly a form binds, loosest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    /// `a + b`, `-a`
    Sum,
    /// `a*b`, `a/b`
    Product,
    /// What may stand behind `*` or `/`.
    Factor,
    /// `a^b`
    Power,
    /// `f(a)`, `x`, `2`
    Atom,
}

/// What remains to be written.
enum Piece {
    Text(&'static str),
    Owned(String),
    /// A node, in brackets if it binds more loosely than this.
    Node(NodeId, Binding),
    /// A node that stands in a place with brackets of its own.
    Free(NodeId),
}

use Piece::{Free, Owned, Text};

/// A form: how tightly it binds, and its pieces.
type Form = (Binding, Vec<Piece>);

/// The node in the language of the program; `None` where it would take more than `limit` bytes. A `dx dy dz` stands
/// for the direction of a ray, which the language has no name for.
pub fn text(graph: &Graph, root: NodeId, limit: usize) -> Option<String> {
    write(graph, root, limit, &BTreeMap::new(), ["(", ")"], text_form)
}

/// The node in LaTeX, for mathematics mode; `None` where it would take more than `limit` bytes.
pub fn latex(graph: &Graph, root: NodeId, limit: usize) -> Option<String> {
    write(graph, root, limit, &BTreeMap::new(), ["\\left(", "\\right)"], latex_form)
}

/// The node with a name for everything that is used more than once: `t1 = …; t2 = …`, and the node itself last.
pub fn definitions(graph: &Graph, root: NodeId) -> (Vec<(String, String)>, String) {
    let nodes = graph.reachable(&[root]);
    let mut uses: BTreeMap<NodeId, usize> = BTreeMap::new();
    for id in &nodes {
        for a in graph.args(*id) {
            *uses.entry(*a).or_default() += 1;
        }
    }
    let (mut names, mut list) = (BTreeMap::new(), Vec::new());
    for id in nodes {
        let shared = id != root && uses.get(&id).is_some_and(|&n| n > 1) && graph.op(id).arity() > 0;
        if shared && let Some(value) = write(graph, id, usize::MAX, &names, ["(", ")"], text_form) {
            let name = format!("t{}", list.len() + 1);
            names.insert(id, name.clone());
            list.push((name, value));
        }
    }
    let last = write(graph, root, usize::MAX, &names, ["(", ")"], text_form);
    (list, last.unwrap_or_default())
}

fn write(
    graph: &Graph,
    root: NodeId,
    limit: usize,
    names: &BTreeMap<NodeId, String>,
    brackets: [&'static str; 2],
    form: fn(&Graph, NodeId) -> Form,
) -> Option<String> {
    let mut out = String::new();
    let mut open = vec![Free(root)];
    while let Some(piece) = open.pop() {
        let (id, least) = match piece {
            Text(text) => {
                out.push_str(text);
                continue;
            }
            Owned(text) => {
                out.push_str(&text);
                continue;
            }
            Free(id) => (id, Binding::Sum),
            Piece::Node(id, least) => (id, least),
        };
        if out.len() > limit {
            return None;
        }
        if let Some(name) = names.get(&id) {
            out.push_str(name);
            continue;
        }
        let (binding, pieces) = form(graph, id);
        if binding < least {
            out.push_str(brackets[0]);
            open.push(Text(brackets[1]));
        }
        open.extend(pieces.into_iter().rev());
    }
    (out.len() <= limit).then_some(out)
}

fn variable_name(variable: Variable) -> &'static str {
    match variable {
        Variable::X => "x",
        Variable::Y => "y",
        Variable::Z => "z",
        Variable::DX => "dx",
        Variable::DY => "dy",
        Variable::DZ => "dz",
    }
}

/// `a + b` and `a - b`, with a negative constant behind `+` as a difference.
fn sum_form(graph: &Graph, op: Op, a: NodeId, b: NodeId, constant: fn(&Rational) -> (Binding, String)) -> Form {
    let first = Piece::Node(a, Binding::Sum);
    let pieces = match graph.constant(b) {
        Some(c) if c.is_negative() && op == Op::Add => vec![first, Text(" - "), Owned(constant(&c.negated()).1)],
        _ => vec![first, Text(if op == Op::Add { " + " } else { " - " }), Piece::Node(b, Binding::Product)],
    };
    (Binding::Sum, pieces)
}

/// `a*b`; behind a constant a further product needs no brackets, and the constant's sign is that of all of it.
fn product_form(graph: &Graph, a: NodeId, b: NodeId, between: &'static str) -> Form {
    let Some(c) = graph.constant(a) else {
        let pieces = vec![Piece::Node(a, Binding::Product), Text(between), Piece::Node(b, Binding::Factor)];
        return (Binding::Product, pieces);
    };
    let binding = if c.is_negative() { Binding::Sum } else { Binding::Product };
    // 0*(u/v) is kept for its domain, and (0*u)/v is another node; (2*3/u)/v would fold.
    let kept = c.is_zero() || graph.constant(first_factor(graph, b)).is_some();
    let rest = if kept { Binding::Factor } else { Binding::Product };
    (binding, vec![Free(a), Text(between), Piece::Node(b, rest)])
}

/// How tightly what follows a minus must bind: the sign may go to the first factor alone, which is the same unless
/// that is a difference, which would turn round, or a constant, which would fold.
fn negated_binding(graph: &Graph, id: NodeId) -> Binding {
    if matches!(graph.op(first_factor(graph, id)), Op::Sub | Op::Add | Op::Constant(_)) {
        Binding::Factor
    } else {
        Binding::Product
    }
}

/// What stands first in a product.
fn first_factor(graph: &Graph, mut id: NodeId) -> NodeId {
    while matches!(graph.op(id), Op::Mul | Op::Div) {
        id = graph.args(id)[0];
    }
    id
}

fn text_constant(c: &Rational) -> (Binding, String) {
    let text = c.to_string();
    let binding = match (c.is_negative(), text.contains('/')) {
        (true, _) => Binding::Sum,
        (false, true) => Binding::Product,
        (false, false) => Binding::Atom,
    };
    (binding, text)
}

/// The name of an operation that is written as a function.
fn function_name(op: Op) -> &'static str {
    match op {
        Op::Abs => "abs",
        Op::Sign => "sign",
        Op::Sqrt => "sqrt",
        Op::Exp => "exp",
        Op::Ln => "ln",
        Op::Log2 => "log2",
        Op::Log10 => "log10",
        Op::Sin => "sin",
        Op::Cos => "cos",
        Op::Tan => "tan",
        Op::Asin => "asin",
        Op::Acos => "acos",
        Op::Atan => "atan",
        Op::Sinh => "sinh",
        Op::Cosh => "cosh",
        Op::Tanh => "tanh",
        Op::Asinh => "asinh",
        Op::Acosh => "acosh",
        Op::Atanh => "atanh",
        Op::Erf => "erf",
        Op::Floor => "floor",
        Op::Root(3) => "cbrt",
        Op::Root(_) => "root",
        Op::Min => "min",
        Op::Max => "max",
        Op::Atan2 => "atan2",
        Op::Choose => "if",
        Op::Constant(_) | Op::Pi | Op::E | Op::Variable(_) => "",
        Op::Neg | Op::Power(_) | Op::Add | Op::Sub | Op::Mul | Op::Div | Op::FloorDiv(_) | Op::Pow => "",
    }
}

fn text_form(graph: &Graph, id: NodeId) -> Form {
    let [a, b, c] = graph.node(id).args;
    match graph.op(id) {
        Op::Constant(index) => {
            let (binding, text) = text_constant(graph.constants(index));
            (binding, vec![Owned(text)])
        }
        Op::Pi => (Binding::Atom, vec![Text("pi")]),
        Op::E => (Binding::Atom, vec![Text("e")]),
        Op::Variable(variable) => (Binding::Atom, vec![Text(variable_name(variable))]),
        Op::Neg => (Binding::Sum, vec![Text("-"), Piece::Node(a, negated_binding(graph, a))]),
        op @ (Op::Add | Op::Sub) => sum_form(graph, op, a, b, text_constant),
        Op::Mul => product_form(graph, a, b, "*"),
        Op::Div => {
            (Binding::Product, vec![Piece::Node(a, Binding::Product), Text("/"), Piece::Node(b, Binding::Factor)])
        }
        Op::FloorDiv(n) => {
            let start = if n == 1 { "floor(".to_owned() } else { format!("floor({n}*") };
            let numerator = Piece::Node(a, if n == 1 { Binding::Product } else { Binding::Factor });
            (Binding::Atom, vec![Owned(start), numerator, Text("/"), Piece::Node(b, Binding::Factor), Text(")")])
        }
        Op::Power(n) => (Binding::Power, vec![Piece::Node(a, Binding::Atom), Owned(format!("^{n}"))]),
        Op::Pow => {
            // A constant exponent must be read as one that varies, not as a whole number or a fraction.
            let front = if graph.constant(b).is_some() { "^(0*x + " } else { "^(" };
            (Binding::Power, vec![Piece::Node(a, Binding::Atom), Text(front), Free(b), Text(")")])
        }
        Op::Root(n) if n != 3 => (Binding::Atom, vec![Owned(format!("root({n}, ")), Free(a), Text(")")]),
        Op::Choose => {
            (Binding::Atom, vec![Text("if("), Free(a), Text(" <= 0, "), Free(b), Text(", "), Free(c), Text(")")])
        }
        op @ (Op::Min | Op::Max | Op::Atan2) => {
            (Binding::Atom, vec![Text(function_name(op)), Text("("), Free(a), Text(", "), Free(b), Text(")")])
        }
        op => (Binding::Atom, vec![Text(function_name(op)), Text("("), Free(a), Text(")")]),
    }
}

fn latex_constant(c: &Rational) -> (Binding, String) {
    let mut text = c.absolute().to_string();
    if let Some((p, q)) = text.split_once('/') {
        text = format!("\\frac{{{p}}}{{{q}}}");
    }
    if c.is_negative() { (Binding::Sum, format!("-{text}")) } else { (Binding::Atom, text) }
}

/// What stands before the bracket of a function in LaTeX.
fn latex_function(op: Op) -> &'static str {
    match op {
        Op::Sign => "\\operatorname{sgn}",
        Op::Log2 => "\\log_{2}",
        Op::Log10 => "\\log_{10}",
        Op::Asin => "\\arcsin",
        Op::Acos => "\\arccos",
        Op::Atan => "\\arctan",
        Op::Asinh => "\\operatorname{arsinh}",
        Op::Acosh => "\\operatorname{arcosh}",
        Op::Atanh => "\\operatorname{artanh}",
        Op::Erf => "\\operatorname{erf}",
        Op::Atan2 => "\\operatorname{atan2}",
        Op::Ln => "\\ln",
        Op::Sin => "\\sin",
        Op::Cos => "\\cos",
        Op::Tan => "\\tan",
        Op::Sinh => "\\sinh",
        Op::Cosh => "\\cosh",
        Op::Tanh => "\\tanh",
        Op::Min => "\\min",
        Op::Max => "\\max",
        other => function_name(other),
    }
}

fn latex_form(graph: &Graph, id: NodeId) -> Form {
    let [a, b, c] = graph.node(id).args;
    let call = |op: Op| vec![Text(latex_function(op)), Text("\\left("), Free(a), Text("\\right)")];
    match graph.op(id) {
        Op::Constant(index) => {
            let (binding, text) = latex_constant(graph.constants(index));
            (binding, vec![Owned(text)])
        }
        Op::Pi => (Binding::Atom, vec![Text("\\pi")]),
        Op::E => (Binding::Atom, vec![Text("e")]),
        Op::Variable(variable) => (Binding::Atom, vec![Text(variable_name(variable))]),
        Op::Neg => (Binding::Sum, vec![Text("-"), Piece::Node(a, Binding::Product)]),
        op @ (Op::Add | Op::Sub) => sum_form(graph, op, a, b, latex_constant),
        Op::Mul => latex_product(graph, a, b),
        Op::Div => (Binding::Factor, vec![Text("\\frac{"), Free(a), Text("}{"), Free(b), Text("}")]),
        Op::Power(n) => (Binding::Power, vec![Piece::Node(a, Binding::Atom), Owned(format!("^{{{n}}}"))]),
        Op::Pow => (Binding::Power, vec![Piece::Node(a, Binding::Atom), Text("^{"), Free(b), Text("}")]),
        Op::Exp => (Binding::Power, vec![Text("e^{"), Free(a), Text("}")]),
        Op::Sqrt => (Binding::Atom, vec![Text("\\sqrt{"), Free(a), Text("}")]),
        Op::Root(n) => (Binding::Atom, vec![Owned(format!("\\sqrt[{n}]{{")), Free(a), Text("}")]),
        Op::Abs => (Binding::Atom, vec![Text("\\left|"), Free(a), Text("\\right|")]),
        Op::Floor => (Binding::Atom, vec![Text("\\left\\lfloor "), Free(a), Text("\\right\\rfloor ")]),
        Op::FloorDiv(n) => {
            let factor = if n == 1 { String::new() } else { format!("{n} \\cdot ") };
            let start = Owned(format!("\\left\\lfloor {factor}\\frac{{"));
            (Binding::Atom, vec![start, Free(a), Text("}{"), Free(b), Text("}\\right\\rfloor ")])
        }
        Op::Choose => {
            let start = vec![Text("\\begin{cases}"), Free(b), Text(" & "), Free(a), Text(" \\le 0\\\\")];
            (Binding::Atom, start.into_iter().chain([Free(c), Text(" & \\text{otherwise}\\end{cases}")]).collect())
        }
        op @ (Op::Min | Op::Max | Op::Atan2) => (
            Binding::Atom,
            vec![Text(latex_function(op)), Text("\\left("), Free(a), Text(", "), Free(b), Text("\\right)")],
        ),
        op => (Binding::Atom, call(op)),
    }
}

/// Factors side by side; a dot where a number comes second.
fn latex_product(graph: &Graph, a: NodeId, b: NodeId) -> Form {
    let starts_with_digit = |mut id: NodeId| loop {
        match graph.op(id) {
            Op::Constant(_) => return true,
            Op::Mul | Op::Power(_) | Op::Pow => id = graph.args(id)[0],
            _ => return false,
        }
    };
    product_form(graph, a, b, if starts_with_digit(b) { " \\cdot " } else { " " })
}

#[cfg(test)]
mod tests;
