//! The nodes of some formulas as a list of steps over registers.
//!
//! In: a graph and its roots. Out: steps in an order in which arguments come before their users, with
//! registers given out again once nobody reads them, so that the working set stays in the first cache.
//! Separate because every number type runs the same list.

use super::constant;
use super::fuse::Fusion;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use crate::num::interval::Interval;
use crate::num::number::{Constant, Pair};
use crate::num::rational::Rational;

/// A place in the register file.
pub type Register = u32;

/// One operation on registers. `out` differs from every argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// What to do.
    pub action: Action,
    /// With what; those past what the action reads repeat the first.
    pub args: [Register; 4],
    /// Where the result goes.
    pub out: Register,
}

/// What a step does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// The operation of one node.
    One(Op),
    /// Sine into `out` and cosine into the register named here.
    SinCos(Register),
    /// Two operations, of the first three arguments.
    Pair(Pair),
    /// The first argument, of which the second is the size: see [`Number::sized`](crate::num::number::Number::sized).
    Sized,
    /// The sum or the difference of two products of the arguments.
    Products {
        /// Whether it is the difference.
        minus: bool,
    },
}

/// A list of steps.
#[derive(Clone, Debug)]
pub struct Tape {
    /// The steps, in order.
    pub steps: Vec<Step>,
    /// The node that each step computes.
    pub nodes: Vec<NodeId>,
    /// Registers that hold constants and are never written.
    pub constants: Vec<(Register, Constant)>,
    /// How many registers there are; the first six are the variables, in the order of [`Variable::ALL`].
    pub registers: usize,
    /// Where the roots end up, in the order asked.
    pub outputs: Vec<Register>,
}

impl Tape {
    /// The steps that compute `roots`; what depends on no variable is computed here and now.
    pub fn new(graph: &Graph, roots: &[NodeId]) -> Self {
        let folded = constant::fold(graph, &graph.reachable(roots), roots);
        Self::build(graph, roots, &folded, false)
    }

    /// The same, with the size of the first root (`expr::cases`), which says where that is not zero.
    pub fn sized(graph: &Graph, roots: &[NodeId], size: NodeId) -> Self {
        let mut tape = Tape::new(graph, &[roots, &[size]].concat());
        if let Some(size) = tape.outputs.pop() {
            let [first, out] = [tape.outputs[0], tape.registers as Register];
            tape.registers += 1;
            tape.steps.push(Step { action: Action::Sized, args: [first, size, first, first], out });
            tape.nodes.push(roots[0]);
            tape.outputs[0] = out;
        }
        tape
    }

    /// The same for batches of points: where it saves time, a step does the work of two. The results are the same bits.
    pub fn for_points(graph: &Graph, roots: &[NodeId]) -> Self {
        let folded = constant::fold(graph, &graph.reachable(roots), roots);
        Self::build(graph, roots, &folded, true)
    }

    /// The same with every operation a step.
    pub(super) fn unfolded(graph: &Graph, roots: &[NodeId]) -> Self {
        Self::build(graph, roots, &[], false)
    }

    fn build(graph: &Graph, roots: &[NodeId], folded: &[(NodeId, Constant)], fuse: bool) -> Self {
        let order = order(graph, roots, folded);
        let known: Vec<NodeId> = folded.iter().map(|&(id, _)| id).collect();
        let fusion = if fuse { Fusion::of(graph, &order, roots, &known) } else { Fusion::none(graph) };
        let mut build = Build::new(graph, &order, roots, fusion);
        for &(id, value) in folded {
            build.done[id.0 as usize] = true;
            build.leaf[id.0 as usize] = true;
            build.constant(id.0 as usize, value);
        }
        for (position, &id) in order.iter().enumerate() {
            build.emit(position, id);
        }
        let outputs = roots.iter().map(|&r| build.register[r.0 as usize]).collect();
        Tape {
            steps: build.steps,
            nodes: build.nodes,
            constants: build.constants,
            registers: build.count as usize,
            outputs,
        }
    }
}

/// The nodes that `roots` need, arguments first; nothing below a folded node.
fn order(graph: &Graph, roots: &[NodeId], folded: &[(NodeId, Constant)]) -> Vec<NodeId> {
    let mut seen = vec![false; graph.len()];
    let mut known = vec![false; graph.len()];
    for (id, _) in folded {
        known[id.0 as usize] = true;
    }
    let mut stack = roots.to_vec();
    while let Some(id) = stack.pop() {
        let at = id.0 as usize;
        if !known[at] && !std::mem::replace(&mut seen[at], true) {
            stack.extend_from_slice(graph.args(id));
        }
    }
    (0..graph.len() as u32).map(NodeId).filter(|id| seen[id.0 as usize]).collect()
}

/// The state of one pass over the nodes.
struct Build<'a> {
    graph: &'a Graph,
    fusion: Fusion,
    steps: Vec<Step>,
    nodes: Vec<NodeId>,
    constants: Vec<(Register, Constant)>,
    /// Of each node that has been emitted.
    register: Vec<Register>,
    /// Position in the order of the last reader of each node.
    last_use: Vec<usize>,
    /// Sine and cosine nodes by argument, for fusing.
    partner: Vec<Option<NodeId>>,
    done: Vec<bool>,
    /// Variables and constants: their registers are never given away.
    leaf: Vec<bool>,
    free: Vec<Register>,
    count: u32,
}

impl<'a> Build<'a> {
    fn new(graph: &'a Graph, order: &[NodeId], roots: &[NodeId], fusion: Fusion) -> Self {
        let mut last_use = vec![0; graph.len()];
        let mut sine_of = vec![None; graph.len()];
        let mut cosine_of = vec![None; graph.len()];
        for (position, &id) in order.iter().enumerate() {
            for &a in operands(graph, &fusion, id) {
                last_use[a.0 as usize] = position;
            }
            match graph.op(id) {
                Op::Sin => sine_of[graph.args(id)[0].0 as usize] = Some(id),
                Op::Cos => cosine_of[graph.args(id)[0].0 as usize] = Some(id),
                _ => {}
            }
        }
        for &r in roots {
            last_use[r.0 as usize] = usize::MAX;
        }
        let mut partner = vec![None; graph.len()];
        for (s, c) in sine_of.into_iter().zip(cosine_of) {
            if let (Some(s), Some(c)) = (s, c) {
                (partner[s.0 as usize], partner[c.0 as usize]) = (Some(c), Some(s));
            }
        }
        Build {
            graph,
            fusion,
            steps: Vec::with_capacity(order.len()),
            nodes: Vec::with_capacity(order.len()),
            constants: Vec::new(),
            register: vec![0; graph.len()],
            last_use,
            partner,
            done: vec![false; graph.len()],
            leaf: (0..graph.len() as u32).map(|id| graph.op(NodeId(id)).arity() == 0).collect(),
            free: Vec::new(),
            count: Variable::ALL.len() as u32,
        }
    }

    fn emit(&mut self, position: usize, id: NodeId) {
        let at = id.0 as usize;
        if self.fusion.inside[at] {
            return;
        }
        if std::mem::replace(&mut self.done[at], true) {
            self.release_arguments(position, id);
            return;
        }
        match self.graph.op(id) {
            Op::Variable(v) => self.register[at] = v as Register,
            Op::Constant(index) => self.constant(at, rational_constant(self.graph.constants(index))),
            Op::Pi => self.constant(at, PI),
            Op::E => self.constant(at, E),
            op => self.step(position, id, op),
        }
    }

    fn constant(&mut self, at: usize, value: Constant) {
        self.register[at] = self.count;
        self.constants.push((self.count, value));
        self.count += 1;
    }

    fn step(&mut self, position: usize, id: NodeId, op: Op) {
        let arguments = operands(self.graph, &self.fusion, id);
        let first = self.register[arguments[0].0 as usize];
        let mut args = [first; 4];
        for (slot, a) in args.iter_mut().zip(arguments) {
            *slot = self.register[a.0 as usize];
        }
        self.nodes.push(id);
        let out = self.take();
        self.register[id.0 as usize] = out;
        let action = match self.partner[id.0 as usize] {
            Some(partner) => {
                let other = self.take();
                self.register[partner.0 as usize] = other;
                self.done[partner.0 as usize] = true;
                if op == Op::Sin {
                    Action::SinCos(other)
                } else {
                    self.steps.push(Step { action: Action::SinCos(out), args, out: other });
                    self.release_arguments(position, id);
                    return;
                }
            }
            None => self.fusion.joined[id.0 as usize].map_or(Action::One(op), |(action, _)| action),
        };
        self.steps.push(Step { action, args, out });
        self.release_arguments(position, id);
    }

    fn take(&mut self) -> Register {
        self.free.pop().unwrap_or_else(|| {
            self.count += 1;
            self.count - 1
        })
    }

    /// Gives back the registers of arguments that nobody reads after this position.
    fn release_arguments(&mut self, position: usize, id: NodeId) {
        let arguments = operands(self.graph, &self.fusion, id);
        for (k, &a) in arguments.iter().enumerate() {
            if !self.leaf[a.0 as usize] && self.last_use[a.0 as usize] == position && !arguments[..k].contains(&a) {
                self.free.push(self.register[a.0 as usize]);
            }
        }
    }
}

/// What the step of a node reads.
fn operands<'a>(graph: &'a Graph, fusion: &'a Fusion, id: NodeId) -> &'a [NodeId] {
    match &fusion.joined[id.0 as usize] {
        Some((_, operands)) => operands,
        None if fusion.inside[id.0 as usize] => &[],
        None => graph.args(id),
    }
}

/// π and the two f64 around it.
const PI: Constant = Constant {
    point: std::f64::consts::PI,
    range: Interval { lo: std::f64::consts::PI, hi: std::f64::consts::PI.next_up() },
};

/// e = 2.718281828459045 09…, just above the f64's value of 2.718281828459045 09079….
const E: Constant = Constant {
    point: std::f64::consts::E,
    range: Interval { lo: std::f64::consts::E, hi: std::f64::consts::E.next_up() },
};

fn rational_constant(value: &Rational) -> Constant {
    Constant { point: value.to_f64(), range: value.enclosure() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closure::{Formula, Kernel};
    use crate::expr::cases;
    use crate::expr::formula::formula;
    use crate::num::affine_lanes::AffineLanes;
    use crate::num::interval::Enclosure;
    use crate::num::interval_lanes::{IntervalLanes, NOWHERE};
    use crate::num::level::Simd;
    use glam::DVec3;

    #[test]
    fn a_jump_past_zero_is_no_root_and_a_root_is_one() {
        // Whether the formula has a root for x, y, z from −1/2 to 1/2; none has a sign there.
        let rows = [
            ("if(x<=0,1+x/10,y/10-1)", false),
            ("if(x<=0,x+0.1,0-1)", true),
            ("if(x<=0,1,if(y<=0,2,z-3))", false),
            ("if(x<=0,1,if(y<=0,2,z-0.3))", true),
            ("z-if(x<=0,2,0-2)", false),
            ("z-if(x<=0,2,y)", true),
            ("(y+1)*(0.1-if(x<=0,2,0-2+z))", false),
            ("(y+0.1)*(0.1-if(x<=0,2,0-2+z))", true),
            ("0-3*if(x*x-y<=0,exp(z),0-cos(z))", false),
        ];
        for (text, has_root) in rows {
            let mut graph = Graph::new();
            let g = formula(&mut graph, text);
            let size = cases::size(&mut graph, g).expect(text);
            let (value, sized) =
                (Formula::new(&mut graph, g, Simd::best()), Formula::new(&mut graph, size.node, Simd::best()));
            for k in 0..200 {
                let part = |k: i32, n: i32| f64::from(k * n % 199) / 199.0 - 0.5;
                let point = DVec3::new(part(k, 7), part(k, 31), part(k, 83));
                assert!((value.value(point).abs() - sized.value(point)).abs() < 1e-14, "{text} {point}");
            }
            let tape = Tape::sized(&graph, &[g], size.node);
            let range = Enclosure::total(Interval { lo: -0.5, hi: 0.5 });
            let kernel: Kernel<IntervalLanes<8>> = Kernel::new(&tape, Simd::best());
            let mut registers = kernel.registers();
            registers[..3].fill(IntervalLanes::splat(range));
            kernel.run(&mut registers);
            assert_eq!(kernel.output(&registers, 0).flags[3] & NOWHERE == 0, has_root, "{text}");
            let kernel: Kernel<AffineLanes<8>> = Kernel::new(&tape, Simd::best());
            let mut registers = kernel.registers();
            for axis in 0..3 {
                registers[axis] = AffineLanes::splat(0.0, 0.0);
                registers[axis].slope[axis] = [0.5; 8];
            }
            kernel.run(&mut registers);
            assert_eq!(kernel.output(&registers, 0).flags[3] & NOWHERE == 0, has_root, "{text}");
        }
        let mut graph = Graph::new();
        let g = formula(&mut graph, "x*sin(if(x<=0,1,y))");
        assert!(cases::size(&mut graph, g).is_none());
    }
}
