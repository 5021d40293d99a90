//! The f64 of a node that hangs on no variable: bounds of parameters, the camera, the clip.
//!
//! In: a node. Out: its value, or nothing if it needs x, y or z. Separate from the closures, which come later
//! and work on whole batches.

use super::Lowerer;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::lanes::Lanes;
use crate::num::level::Portable;
use crate::num::number::Number;
use std::collections::HashMap;

/// One number, computed as everywhere else.
type Point = Lanes<1>;

/// The value of a node that hangs on no variable; NaN where it has none.
pub(super) fn constant_value(graph: &Graph, root: NodeId) -> Option<f64> {
    if let Some(exact) = graph.constant(root) {
        return Some(exact.to_f64());
    }
    let mut values: HashMap<NodeId, Point> = HashMap::new();
    for id in graph.reachable(&[root]) {
        let args: Vec<&Point> = graph.args(id).iter().map(|a| &values[a]).collect();
        let mut value = Point::default();
        match graph.constant(id) {
            Some(exact) => value = Lanes([exact.to_f64()]),
            None if matches!(graph.op(id), Op::Variable(_)) => return None,
            None => operation(graph.op(id), &args, &mut value),
        }
        values.insert(id, value);
    }
    values.get(&root).map(|value| value.0[0])
}

impl Lowerer<'_> {
    /// The value of a node that hangs on no variable; NaN where it has none.
    pub(super) fn constant_value(&self, id: NodeId) -> Option<f64> {
        constant_value(&self.graph, id)
    }
}

// table: the operation on one number
fn operation(op: Op, a: &[&Point], out: &mut Point) {
    match op {
        Op::Constant(_) | Op::Variable(_) => {}
        Op::Pi => *out = Lanes([std::f64::consts::PI]),
        Op::E => *out = Lanes([std::f64::consts::E]),
        Op::Neg => Point::neg::<Portable>(a[0], out),
        Op::Abs => Point::abs::<Portable>(a[0], out),
        Op::Sign => Point::sign::<Portable>(a[0], out),
        Op::Sqrt => Point::sqrt::<Portable>(a[0], out),
        Op::Exp => Point::exp::<Portable>(a[0], out),
        Op::Ln => Point::ln::<Portable>(a[0], out),
        Op::Log2 => Point::log2::<Portable>(a[0], out),
        Op::Log10 => Point::log10::<Portable>(a[0], out),
        Op::Sin => Point::sin::<Portable>(a[0], out),
        Op::Cos => Point::cos::<Portable>(a[0], out),
        Op::Tan => Point::tan::<Portable>(a[0], out),
        Op::Asin => Point::asin::<Portable>(a[0], out),
        Op::Acos => Point::acos::<Portable>(a[0], out),
        Op::Atan => Point::atan::<Portable>(a[0], out),
        Op::Sinh => Point::sinh::<Portable>(a[0], out),
        Op::Cosh => Point::cosh::<Portable>(a[0], out),
        Op::Tanh => Point::tanh::<Portable>(a[0], out),
        Op::Asinh => Point::asinh::<Portable>(a[0], out),
        Op::Acosh => Point::acosh::<Portable>(a[0], out),
        Op::Atanh => Point::atanh::<Portable>(a[0], out),
        Op::Erf => Point::erf::<Portable>(a[0], out),
        Op::Floor => Point::floor::<Portable>(a[0], out),
        Op::Power(n) => Point::power::<Portable>(a[0], n, out),
        Op::Root(n) => Point::root::<Portable>(a[0], n, out),
        Op::Add => Point::add::<Portable>(a[0], a[1], out),
        Op::Sub => Point::sub::<Portable>(a[0], a[1], out),
        Op::Mul => Point::mul::<Portable>(a[0], a[1], out),
        Op::Div => Point::div::<Portable>(a[0], a[1], out),
        Op::FloorDiv(n) => Point::floor_div::<Portable>(a[0], a[1], n, out),
        Op::Min => Point::min::<Portable>(a[0], a[1], out),
        Op::Max => Point::max::<Portable>(a[0], a[1], out),
        Op::Pow => Point::pow::<Portable>(a[0], a[1], out),
        Op::Atan2 => Point::atan2::<Portable>(a[0], a[1], out),
        Op::Choose => Point::choose::<Portable>(a[0], a[1], a[2], out),
    }
}
