//! The formula as a tree of closures of one point: what a first course writes, and the reference.
//!
//! In: a node. Out: a function of (x, y, z) made of functions of (x, y, z), one inside the other. Nothing is
//! shared: a subexpression used twice is computed twice, which is why the tracer runs a
//! [`super::Kernel`] instead. Separate because it is the plainest statement of what a formula means.

use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use crate::num::lanes::Lanes;
use crate::num::level::{Simd, for_each_level};
use crate::num::number::Number;

/// A function of the variables, in the order of [`Variable::ALL`].
pub type Tree = Box<dyn Fn(&[f64; 6]) -> f64 + Send + Sync>;

/// The largest tree that is built, in closures: sharing can make a small graph an enormous tree.
pub const MAX_TREE: u64 = 1 << 16;

/// The deepest tree that is built: a call of it nests as deep on the stack.
pub const MAX_DEPTH: u32 = 1 << 9;

/// The tree of a node; `None` if it would be larger than [`MAX_TREE`] or deeper than [`MAX_DEPTH`].
pub fn tree(graph: &Graph, root: NodeId, simd: Simd) -> Option<Tree> {
    let mut size = vec![(0u64, 0u32); graph.len()];
    for id in graph.reachable(&[root]) {
        let (mut total, mut depth) = (1u64, 1u32);
        for a in graph.args(id) {
            let (s, d) = size[a.0 as usize];
            total = total.saturating_add(s);
            depth = depth.max(d.saturating_add(1));
        }
        size[id.0 as usize] = (total, depth);
    }
    let (total, depth) = size[root.0 as usize];
    (total <= MAX_TREE && depth <= MAX_DEPTH).then(|| grow(graph, root, simd))
}

fn grow(graph: &Graph, id: NodeId, simd: Simd) -> Tree {
    let children = graph.args(id).iter().map(|&a| grow(graph, a, simd)).collect();
    let constant = graph.constant(id).map_or(0.0, |c| c.to_f64());
    join(simd, graph.op(id), constant, children)
}

/// Every operation on one number is the batch operation on a batch of one.
macro_rules! one {
    ($level:ident, $method:ident, [$($arg:expr),*] $(, $extra:expr)?) => {{
        let mut out = Lanes([0.0]);
        Lanes::<1>::$method::<$level>($(&Lanes([$arg]),)* $($extra,)? &mut out);
        out.0[0]
    }};
}

// table: one line an operation.
for_each_level! {
    /// One operation over the closures of its arguments.
    fn join[L](op: Op, constant: f64, children: Vec<Tree>) -> Tree {
        let mut children = children.into_iter();
        let mut child = || children.next().unwrap_or_else(|| Box::new(|_| f64::NAN));
        macro_rules! unary {
            ($method:ident $(, $extra:expr)?) => {{
                let a = child();
                Box::new(move |p| one!(L, $method, [a(p)] $(, $extra)?))
            }};
        }
        macro_rules! binary {
            ($method:ident $(, $extra:expr)?) => {{
                let (a, b) = (child(), child());
                Box::new(move |p| one!(L, $method, [a(p), b(p)] $(, $extra)?))
            }};
        }
        match op {
            Op::Constant(_) => Box::new(move |_| constant),
            Op::Pi => Box::new(|_| std::f64::consts::PI),
            Op::E => Box::new(|_| std::f64::consts::E),
            Op::Variable(Variable::X) => Box::new(|p| p[0]),
            Op::Variable(Variable::Y) => Box::new(|p| p[1]),
            Op::Variable(Variable::Z) => Box::new(|p| p[2]),
            Op::Variable(Variable::DX) => Box::new(|p| p[3]),
            Op::Variable(Variable::DY) => Box::new(|p| p[4]),
            Op::Variable(Variable::DZ) => Box::new(|p| p[5]),
            Op::Neg => unary!(neg),
            Op::Abs => unary!(abs),
            Op::Sign => unary!(sign),
            Op::Sqrt => unary!(sqrt),
            Op::Exp => unary!(exp),
            Op::Ln => unary!(ln),
            Op::Log2 => unary!(log2),
            Op::Log10 => unary!(log10),
            Op::Sin => unary!(sin),
            Op::Cos => unary!(cos),
            Op::Tan => unary!(tan),
            Op::Asin => unary!(asin),
            Op::Acos => unary!(acos),
            Op::Atan => unary!(atan),
            Op::Sinh => unary!(sinh),
            Op::Cosh => unary!(cosh),
            Op::Tanh => unary!(tanh),
            Op::Asinh => unary!(asinh),
            Op::Acosh => unary!(acosh),
            Op::Atanh => unary!(atanh),
            Op::Erf => unary!(erf),
            Op::Floor => unary!(floor),
            Op::Power(2) => unary!(square),
            Op::Power(n) => unary!(power, n),
            Op::Root(n) => unary!(root, n),
            Op::Add => binary!(add),
            Op::Sub => binary!(sub),
            Op::Mul => binary!(mul),
            Op::Div => binary!(div),
            Op::FloorDiv(n) => binary!(floor_div, n),
            Op::Min => binary!(min),
            Op::Max => binary!(max),
            Op::Pow => binary!(pow),
            Op::Atan2 => binary!(atan2),
            Op::Choose => {
                let (c, a, b) = (child(), child(), child());
                Box::new(move |p| {
                    let c = c(p);
                    if c <= 0.0 { a(p) } else if c > 0.0 { b(p) } else { f64::NAN }
                })
            }
        }
    }
}
