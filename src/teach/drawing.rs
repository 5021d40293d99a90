//! A formula as a tree and as the graph that shares equal parts, drawn.
//!
//! In: a node. Out: characters for a terminal, SVG for a page. Separate from what a formula says, because here only its
//! shape counts.

use super::notation::function;
use super::svg::{Svg, ink};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use std::collections::BTreeMap;

/// The most nodes that are drawn.
pub const MAX_DRAWN: usize = 120;

/// A level of the drawing in pixels.
const LEVEL: f64 = 64.0;

/// The least width of a node in pixels, and the width of a letter.
const TAG: (f64, f64) = (34.0, 8.5);

/// How a formula's parts are used.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// The nodes of the graph.
    pub nodes: usize,
    /// The nodes that a tree without sharing has; saturating.
    pub tree: u64,
    /// The nodes used more than once, coordinates and constants left out, with their uses.
    pub shared: Vec<(NodeId, usize)>,
}

/// The shape of a formula.
pub fn shape(graph: &Graph, roots: &[NodeId]) -> Shape {
    let nodes = graph.reachable(roots);
    let mut sizes: BTreeMap<NodeId, u64> = BTreeMap::new();
    let mut uses: BTreeMap<NodeId, usize> = BTreeMap::new();
    for &id in &nodes {
        let below = graph.args(id).iter().fold(1u64, |sum, a| sum.saturating_add(sizes[a]));
        sizes.insert(id, below);
        graph.args(id).iter().for_each(|a| *uses.entry(*a).or_default() += 1);
    }
    let shared = uses.into_iter().filter(|&(id, n)| n > 1 && graph.op(id).arity() > 0).collect();
    let tree = roots.iter().fold(0u64, |sum, root| sum.saturating_add(sizes[root]));
    Shape { nodes: nodes.len(), tree, shared }
}

/// What a node does, in a few letters.
pub fn label(graph: &Graph, id: NodeId) -> String {
    match graph.op(id) {
        Op::Constant(index) => graph.constants(index).to_string(),
        Op::Pi => "pi".into(),
        Op::E => "e".into(),
        Op::Variable(Variable::X) => "x".into(),
        Op::Variable(Variable::Y) => "y".into(),
        Op::Variable(Variable::Z) => "z".into(),
        Op::Variable(Variable::DX | Variable::DY | Variable::DZ) => "d".into(),
        Op::Add => "+".into(),
        Op::Sub | Op::Neg => "-".into(),
        Op::Mul => "*".into(),
        Op::Div => "/".into(),
        Op::Power(n) => format!("^{n}"),
        Op::Pow => "^".into(),
        Op::Root(n) => format!("root {n}"),
        Op::FloorDiv(n) => format!("floor {n}*/"),
        op => function(op).into(),
    }
}

/// The graph as an indented tree: a shared part is drawn where it is met first, and named after that.
pub fn characters(graph: &Graph, root: NodeId) -> Option<String> {
    let shape = shape(graph, &[root]);
    if shape.nodes > MAX_DRAWN {
        return None;
    }
    let names: BTreeMap<NodeId, String> =
        shape.shared.iter().enumerate().map(|(k, &(id, _))| (id, format!("t{}", k + 1))).collect();
    let mut out = String::new();
    let mut seen: Vec<NodeId> = Vec::new();
    // A node, what stands in front of its line, and what stands in front of its children's.
    let mut open = vec![(root, String::new(), String::new())];
    while let Some((id, front, below)) = open.pop() {
        let name = names.get(&id);
        if seen.contains(&id)
            && let Some(name) = name
        {
            out += &format!("{front}{name} (above)\n");
            continue;
        }
        seen.push(id);
        let name = name.map_or(String::new(), |name| format!("   = {name}, shared"));
        out += &format!("{front}{}{name}\n", label(graph, id));
        let args = graph.args(id);
        for (k, &a) in args.iter().enumerate().rev() {
            let is_last = k + 1 == args.len();
            let front = format!("{below}{}", if is_last { "`-- " } else { "|-- " });
            let inner = format!("{below}{}", if is_last { "    " } else { "|   " });
            open.push((a, front, inner));
        }
    }
    Some(out)
}

/// The graph as a drawing: each node once, below all that use it; shared nodes are blue.
pub fn svg(graph: &Graph, root: NodeId, title: &str) -> Option<String> {
    let shape = shape(graph, &[root]);
    if shape.nodes > MAX_DRAWN {
        return None;
    }
    let rows = rows(graph, root);
    let width = |id: NodeId| TAG.0.max(14.0 + TAG.1 * label(graph, id).chars().count() as f64);
    let widest = rows.iter().map(|row| row.iter().map(|&id| width(id) + 18.0).sum::<f64>()).fold(260.0, f64::max);
    let mut places: BTreeMap<NodeId, (f64, f64)> = BTreeMap::new();
    for (level, row) in rows.iter().enumerate() {
        let total: f64 = row.iter().map(|&id| width(id)).sum();
        let gap = (widest - total) / (row.len() as f64 + 1.0);
        let mut x = gap;
        for &id in row {
            places.insert(id, (x + width(id) / 2.0, 30.0 + LEVEL * level as f64));
            x += width(id) + gap;
        }
    }
    let mut svg = Svg::new(widest, 60.0 + LEVEL * (rows.len() as f64 - 1.0));
    for (&id, &(x, y)) in &places {
        let args = graph.args(id);
        for (k, a) in args.iter().enumerate() {
            let (to_x, to_y) = places[a];
            // Two arguments that are one node get two lines.
            let aside = (k as f64 - (args.len() as f64 - 1.0) / 2.0) * 8.0;
            svg.line((x + aside, y + 7.0), (to_x + aside / 2.0, to_y - 15.0), ink::GREY, 1.3);
        }
    }
    for (&id, &place) in &places {
        let is_shared = shape.shared.iter().any(|&(other, _)| other == id);
        svg.tag(place, &label(graph, id), width(id), is_shared);
    }
    Some(svg.finish(title))
}

/// The nodes by their longest way from the root, each row in the order of the places of those above.
fn rows(graph: &Graph, root: NodeId) -> Vec<Vec<NodeId>> {
    let mut depth: BTreeMap<NodeId, usize> = BTreeMap::from([(root, 0)]);
    for id in graph.reachable(&[root]).into_iter().rev() {
        let below = depth[&id] + 1;
        for a in graph.args(id) {
            let known = depth.entry(*a).or_insert(below);
            *known = below.max(*known);
        }
    }
    let mut rows: Vec<Vec<NodeId>> = vec![Vec::new(); depth.values().max().map_or(0, |d| d + 1)];
    let (mut order, mut open) = (Vec::new(), vec![root]);
    while let Some(id) = open.pop() {
        if !order.contains(&id) {
            order.push(id);
            open.extend(graph.args(id).iter().rev());
        }
    }
    for id in order {
        rows[depth[&id]].push(id);
    }
    rows
}
