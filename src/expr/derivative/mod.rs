//! The rule of every operation: derivatives as nodes of the same graph, forward, sharing what f itself computes.
//!
//! In: nodes, and the derivatives of x, y and z. Out: the derivative of each node. With (1, 0, 0) that is f_x; with
//! the variables (DX, DY, DZ) it is g'(t) = a·f_x + b·f_y + c·f_z along a ray, and a second time it is g''.
//! Separate from the simplifier because it says what is true of functions, not of how they are written.
//!
//! A derivative holds where f has a value and is differentiable; elsewhere it may have a value or none. At a crease
//! of `abs`, `min`, `max` or `if` it is that of the first live branch.

#[cfg(test)]
mod tests;

use super::graph::{Graph, NodeId};
use super::op::{Op, Variable};

/// The derivatives of `roots` where x, y and z change at the rates `seeds`.
///
/// Every node adds a bounded number of nodes, however often it is used.
pub fn derivative(graph: &mut Graph, roots: &[NodeId], seeds: [NodeId; 3]) -> Vec<NodeId> {
    let here = graph.set_span(None);
    let zero = graph.integer(0);
    let nodes = graph.reachable(roots);
    // What was derived for other roots is not derived again.
    let mut of = graph.take_derivatives(seeds);
    let count = nodes.last().map_or(0, |last| last.0 as usize + 1);
    of.resize(of.len().max(count), None);
    for u in nodes {
        if of[u.0 as usize].is_none() {
            let inner = graph.node(u).args.map(|a| of.get(a.0 as usize).copied().flatten().unwrap_or(zero));
            of[u.0 as usize] = Some(Rules { graph, zero }.node(u, inner, seeds));
        }
    }
    graph.set_span(here);
    let found = roots.iter().map(|root| of[root.0 as usize].unwrap_or(zero)).collect();
    graph.keep_derivatives(seeds, of);
    found
}

/// The derivatives of f in x, y and z.
pub fn gradient(graph: &mut Graph, f: NodeId) -> [NodeId; 3] {
    let (zero, one) = (graph.integer(0), graph.integer(1));
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(|seeds| derivative(graph, &[f], seeds)[0])
}

/// g'(t) of each root along the ray with direction (DX, DY, DZ).
pub fn along_ray(graph: &mut Graph, roots: &[NodeId]) -> Vec<NodeId> {
    let seeds = [Variable::DX, Variable::DY, Variable::DZ].map(|v| graph.variable(v));
    derivative(graph, roots, seeds)
}

struct Rules<'a> {
    graph: &'a mut Graph,
    zero: NodeId,
}

impl Rules<'_> {
    fn one(&mut self, op: Op, a: NodeId) -> NodeId {
        self.graph.apply(op, &[a])
    }

    fn two(&mut self, op: Op, a: NodeId, b: NodeId) -> NodeId {
        self.graph.apply(op, &[a, b])
    }

    /// u·a' for a rate of change a': nothing changes where a' is 0, whatever u is.
    fn times(&mut self, u: NodeId, rate: NodeId) -> NodeId {
        if rate == self.zero { self.zero } else { self.two(Op::Mul, u, rate) }
    }

    /// a'/u.
    fn over(&mut self, rate: NodeId, u: NodeId) -> NodeId {
        if rate == self.zero { self.zero } else { self.two(Op::Div, rate, u) }
    }

    /// 1 + s·u².
    fn one_plus_square(&mut self, negative: bool, u: NodeId) -> NodeId {
        let (one, square) = (self.graph.integer(1), self.one(Op::Power(2), u));
        self.two(if negative { Op::Sub } else { Op::Add }, one, square)
    }

    /// The derivative of u, whose arguments have the derivatives `rates`.
    fn node(&mut self, u: NodeId, rates: [NodeId; 3], seeds: [NodeId; 3]) -> NodeId {
        let node = self.graph.node(u);
        let ([a, b, _], [da, db, dc]) = (node.args, rates);
        match node.op {
            Op::Constant(_) | Op::Pi | Op::E | Op::Floor | Op::FloorDiv(_) | Op::Sign => self.zero,
            Op::Variable(Variable::X) => seeds[0],
            Op::Variable(Variable::Y) => seeds[1],
            Op::Variable(Variable::Z) => seeds[2],
            Op::Variable(Variable::DX | Variable::DY | Variable::DZ) => self.zero,
            Op::Neg => self.one(Op::Neg, da),
            Op::Abs => {
                let (falling, minus) = (self.one(Op::Neg, a), self.one(Op::Neg, da));
                self.branch(falling, da, minus)
            }
            Op::Add | Op::Sub => self.two(node.op, da, db),
            Op::Mul => {
                let (left, right) = (self.times(b, da), self.times(a, db));
                self.two(Op::Add, left, right)
            }
            Op::Div => {
                let changed = self.times(u, db);
                let rate = self.two(Op::Sub, da, changed);
                self.over(rate, b)
            }
            Op::Min => {
                let difference = self.two(Op::Sub, a, b);
                self.branch(difference, da, db)
            }
            Op::Max => {
                let difference = self.two(Op::Sub, b, a);
                self.branch(difference, da, db)
            }
            Op::Choose => self.branch(a, db, dc),
            Op::Pow => self.power_of_two_changes(u, [a, b], [da, db]),
            Op::Atan2 => self.angle([a, b], [da, db]),
            _ if da == self.zero => self.zero,
            Op::Exp | Op::Sqrt | Op::Root(_) | Op::Power(_) | Op::Ln | Op::Log2 | Op::Log10 | Op::Erf => {
                self.power_or_logarithm(u, a, da)
            }
            Op::Sin | Op::Cos | Op::Tan | Op::Asin | Op::Acos | Op::Atan => self.circular(u, a, da),
            Op::Sinh | Op::Cosh | Op::Tanh | Op::Asinh | Op::Acosh | Op::Atanh => self.hyperbolic(u, a, da),
        }
    }

    /// The rate of the branch that is taken: `a` where condition ≤ 0.
    fn branch(&mut self, condition: NodeId, a: NodeId, b: NodeId) -> NodeId {
        if a == b { a } else { self.graph.apply(Op::Choose, &[condition, a, b]) }
    }

    /// (a^b)' = b·a^(b−1)·a' + a^b·ln(a)·b'.
    fn power_of_two_changes(&mut self, u: NodeId, [a, b]: [NodeId; 2], [da, db]: [NodeId; 2]) -> NodeId {
        let mut sum = self.zero;
        if da != self.zero {
            let one = self.graph.integer(1);
            let less = self.two(Op::Sub, b, one);
            let power = self.two(Op::Pow, a, less);
            let slope = self.two(Op::Mul, b, power);
            sum = self.times(slope, da);
        }
        if db != self.zero {
            let logarithm = self.one(Op::Ln, a);
            let slope = self.two(Op::Mul, u, logarithm);
            let term = self.times(slope, db);
            sum = self.two(Op::Add, sum, term);
        }
        sum
    }

    /// atan2(a, b)' = (b·a' − a·b')/(a² + b²).
    fn angle(&mut self, [a, b]: [NodeId; 2], [da, db]: [NodeId; 2]) -> NodeId {
        let (left, right) = (self.times(b, da), self.times(a, db));
        let turn = self.two(Op::Sub, left, right);
        let (a, b) = (self.one(Op::Power(2), a), self.one(Op::Power(2), b));
        let square = self.two(Op::Add, a, b);
        self.over(turn, square)
    }

    fn power_or_logarithm(&mut self, u: NodeId, a: NodeId, da: NodeId) -> NodeId {
        match self.graph.op(u) {
            Op::Exp => self.times(u, da),
            Op::Sqrt => {
                let two = self.graph.integer(2);
                let double = self.two(Op::Mul, two, u);
                self.over(da, double)
            }
            Op::Root(n) => {
                let power = self.one(Op::Power(i64::from(n) - 1), u);
                let n = self.graph.integer(i64::from(n));
                let slope = self.two(Op::Mul, n, power);
                self.over(da, slope)
            }
            Op::Power(n) => {
                let power = match n.checked_sub(1) {
                    Some(less) => self.one(Op::Power(less), a),
                    None => self.two(Op::Div, u, a),
                };
                let n = self.graph.integer(n);
                let slope = self.two(Op::Mul, n, power);
                self.times(slope, da)
            }
            Op::Erf => self.bell(a, da),
            base => {
                let slope = match base {
                    Op::Log2 => self.times_logarithm_of(2, a),
                    Op::Log10 => self.times_logarithm_of(10, a),
                    _ => a,
                };
                self.over(da, slope)
            }
        }
    }

    /// a·ln(base).
    fn times_logarithm_of(&mut self, base: i64, a: NodeId) -> NodeId {
        let base = self.graph.integer(base);
        let logarithm = self.one(Op::Ln, base);
        self.two(Op::Mul, logarithm, a)
    }

    /// erf(a)' = 2/√π · e^(−a²) · a'.
    fn bell(&mut self, a: NodeId, da: NodeId) -> NodeId {
        let square = self.one(Op::Power(2), a);
        let exponent = self.one(Op::Neg, square);
        let bell = self.one(Op::Exp, exponent);
        let pi = self.graph.apply(Op::Pi, &[]);
        let (two, root) = (self.graph.integer(2), self.one(Op::Sqrt, pi));
        let factor = self.two(Op::Div, two, root);
        let slope = self.two(Op::Mul, factor, bell);
        self.times(slope, da)
    }

    fn circular(&mut self, u: NodeId, a: NodeId, da: NodeId) -> NodeId {
        match self.graph.op(u) {
            Op::Sin => {
                let cosine = self.one(Op::Cos, a);
                self.times(cosine, da)
            }
            Op::Cos => {
                let sine = self.one(Op::Sin, a);
                let fall = self.times(sine, da);
                self.one(Op::Neg, fall)
            }
            Op::Tan => {
                let slope = self.one_plus_square(false, u);
                self.times(slope, da)
            }
            Op::Atan => {
                let slope = self.one_plus_square(false, a);
                self.over(da, slope)
            }
            inverse => {
                let square = self.one_plus_square(true, a);
                let root = self.one(Op::Sqrt, square);
                let rate = self.over(da, root);
                if inverse == Op::Acos { self.one(Op::Neg, rate) } else { rate }
            }
        }
    }

    fn hyperbolic(&mut self, u: NodeId, a: NodeId, da: NodeId) -> NodeId {
        match self.graph.op(u) {
            Op::Sinh => {
                let cosine = self.one(Op::Cosh, a);
                self.times(cosine, da)
            }
            Op::Cosh => {
                let sine = self.one(Op::Sinh, a);
                self.times(sine, da)
            }
            Op::Tanh => {
                let slope = self.one_plus_square(true, u);
                self.times(slope, da)
            }
            Op::Atanh => {
                let slope = self.one_plus_square(true, a);
                self.over(da, slope)
            }
            Op::Asinh => {
                let square = self.one_plus_square(false, a);
                let root = self.one(Op::Sqrt, square);
                self.over(da, root)
            }
            _ => {
                let (one, square) = (self.graph.integer(1), self.one(Op::Power(2), a));
                let difference = self.two(Op::Sub, square, one);
                let root = self.one(Op::Sqrt, difference);
                self.over(da, root)
            }
        }
    }
}
