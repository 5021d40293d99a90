//! The size of a formula, case by case.
//!
//! In: a node that chooses between cases, perhaps after a few sums and products. Out: a node that is |g| in every case, with the choice
//! outermost. Where g jumps from one sign to the other, an enclosure of g holds 0 however short the piece; an enclosure of the
//! size does not, unless one of the cases has a root there. Separate from derivatives, which are of g itself.

use super::graph::{Graph, NodeId};
use super::op::Op;

/// Formulas of more cases than this, or with more operations around them, are looked at so far only.
const MOST_CASES: usize = 64;
const MOST_AROUND: usize = 32;

/// The size of a formula by cases.
#[derive(Clone, Debug)]
pub struct Size {
    /// The node.
    pub node: NodeId,
    /// The choices in it, each with the one in the formula that has the same condition and cases.
    pub choices: Vec<(NodeId, NodeId)>,
}

/// A formula with its choices outermost.
enum Cases {
    One(NodeId),
    /// The choice in the formula, and both of its cases.
    Choice(NodeId, Box<[Cases; 2]>),
}

/// The size of a node by cases, which are added to the graph; `None` if it has one case only.
pub fn size(graph: &mut Graph, node: NodeId) -> Option<Size> {
    let mut most = MOST_CASES;
    let cases = cases(graph, node, &mut most, MOST_AROUND);
    let mut choices = Vec::new();
    let node = sized(graph, &cases, &mut choices);
    (!choices.is_empty()).then_some(Size { node, choices })
}

fn cases(graph: &mut Graph, node: NodeId, most: &mut usize, around: usize) -> Cases {
    let args = graph.args(node).to_vec();
    match (graph.op(node), args.as_slice()) {
        (Op::Choose, &[_, a, b]) if *most > 1 => {
            *most -= 1;
            let sides = [a, b].map(|side| cases(graph, side, most, around));
            Cases::Choice(node, Box::new(sides))
        }
        (op @ (Op::Neg | Op::Add | Op::Sub | Op::Mul), args) if around > 0 => {
            let mut inner: Vec<Cases> = args.iter().map(|&a| cases(graph, a, most, around - 1)).collect();
            let has_cases: Vec<bool> = inner.iter().map(|cases| matches!(cases, Cases::Choice(..))).collect();
            match has_cases.iter().position(|&has| has) {
                // Cases of both would multiply.
                Some(k) if !has_cases[k + 1..].contains(&true) => {
                    let inner = inner.swap_remove(k);
                    lifted(graph, inner, &|graph, case| {
                        let mut args = args.to_vec();
                        args[k] = case;
                        graph.apply(op, &args)
                    })
                }
                _ => Cases::One(node),
            }
        }
        _ => Cases::One(node),
    }
}

/// Does something in every case.
fn lifted(graph: &mut Graph, inner: Cases, around: &dyn Fn(&mut Graph, NodeId) -> NodeId) -> Cases {
    match inner {
        Cases::One(node) => Cases::One(around(graph, node)),
        Cases::Choice(node, sides) => {
            let sides = sides.map(|side| lifted(graph, side, around));
            Cases::Choice(node, Box::new(sides))
        }
    }
}

fn sized(graph: &mut Graph, cases: &Cases, choices: &mut Vec<(NodeId, NodeId)>) -> NodeId {
    match cases {
        Cases::One(node) => graph.apply(Op::Abs, &[*node]),
        Cases::Choice(choice, sides) => {
            let [a, b] = sides.each_ref().map(|side| sized(graph, side, choices));
            let node = graph.intern(Op::Choose, &[graph.args(*choice)[0], a, b]);
            choices.push((node, *choice));
            node
        }
    }
}
