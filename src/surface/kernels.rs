//! A function g over everything that rays are asked about, and so much of it as some part of space needs.
//!
//! In: a node, with what of it can be left out. Out: [`Kernels`] for all of it, made once; a [`Program`] for a set of live
//! arguments, which is lists of their steps, each made when it is first asked for; and the [`Formula`] at hand, which is one of the
//! two. Separate from the sheet because squares, single rays and the index each have a formula of their own at hand.

use super::sheet::{Balls, Cells, Points, RayForms};
use super::sum::{Share, Sum};
use super::tile::{FormFiles, Forms};
use crate::closure::shorten::{Fork, Shortener, is_private};
use crate::closure::specialise::{Choices, Slabs};
use crate::closure::{Excerpt, Kernel, Tape};
use crate::expr::cases::{self, Size};
use crate::expr::derivative::{along_ray, derivative};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::nest::nested;
use crate::expr::op::Op;
use crate::num::level::Simd;
use std::sync::OnceLock;

/// A function g over everything that rays are asked about.
pub(crate) struct Kernels {
    value: Kernel<Cells>,
    slope: Kernel<Cells>,
    value_along: Kernel<RayForms>,
    slope_along: Kernel<RayForms>,
    value_form: Kernel<Forms>,
    slope_form: Kernel<Forms>,
    point: Kernel<Points>,
    ball: Kernel<Balls>,
    gradient: Kernel<Points>,
    /// What can be left out.
    pub(crate) parts: Option<Parts>,
    /// Its terms, if it is a long sum.
    pub(crate) sum: Option<Sum>,
}

/// What of a function can be left out in a part of space.
pub(crate) struct Parts {
    /// The arguments of its long minima and maxima.
    pub(crate) choices: Choices,
    /// Their forms.
    leaves: Kernel<Slabs>,
    /// What each kernel comes down to without some of them.
    shorten: Shorteners,
}

struct Shorteners {
    leaves: Shortener,
    value: Shortener,
    slope: Shortener,
    point: Shortener,
    gradient: Shortener,
}

/// The steps that are enough where some arguments alone are live.
pub(crate) struct Program {
    /// Their numbers, rising.
    pub(crate) live: Box<[u32]>,
    value: OnceLock<Box<[u32]>>,
    slope: OnceLock<Box<[u32]>>,
    point: OnceLock<Box<[u32]>>,
    gradient: OnceLock<Box<[u32]>>,
}

/// The function at hand: all of it, or what a program leaves.
#[derive(Clone, Copy)]
pub(crate) struct Formula<'a> {
    kernels: &'a Kernels,
    program: Option<&'a Program>,
    share: Option<&'a Share>,
}

impl Program {
    pub(crate) fn new(live: &[u32]) -> Program {
        Program {
            live: live.into(),
            value: OnceLock::new(),
            slope: OnceLock::new(),
            point: OnceLock::new(),
            gradient: OnceLock::new(),
        }
    }
}

impl Kernels {
    /// The kernels of a node; its derivatives, and its minima in balanced order, are added to the graph.
    /// With `jumps_are_walls` a root is also where g jumps from one sign to the other.
    pub(crate) fn new(graph: &mut Graph, g: NodeId, jumps_are_walls: bool, simd: Simd) -> Self {
        let (g, choices) = match Choices::new(graph, g) {
            Some((g, choices)) => (g, Some(choices)),
            None => (g, None),
        };
        // g, then every fork, every argument and what tells of it: the derivative of a fork chooses between those of its sides.
        let mut nodes = vec![g];
        if let Some(choices) = &choices {
            nodes.extend(choices.forks.iter().map(|fork| fork.node));
            nodes.extend(&choices.leaves);
            nodes.extend(&choices.telling);
        }
        // Enclosures of powers do not know that they cancel; points need not.
        let nested = nested(graph, &nodes);
        let slopes = along_ray(graph, &nested);
        let (zero, one) = (graph.integer(0), graph.integer(1));
        let seeds = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        let gradients = seeds.map(|seeds| derivative(graph, &nodes, seeds));

        let size = if jumps_are_walls { None } else { cases::size(graph, nested[0]) };
        let enclosing = |graph: &Graph, roots: &[NodeId]| match &size {
            Some(size) => Tape::sized(graph, roots, size.node),
            None => Tape::new(graph, roots),
        };

        let with_slope = [nested[0], slopes[0]];
        let with_gradient = [g, gradients[0][0], gradients[1][0], gradients[2][0]];
        let tapes = [
            enclosing(graph, &nested[..1]),
            enclosing(graph, &with_slope),
            Tape::for_points(graph, &[g]),
            Tape::for_points(graph, &with_gradient),
        ];
        let found = choices.and_then(|choices| {
            let mut value = forks_of(graph, &choices.forks, &nodes, &nested, &[])?;
            let mut slope = forks_of(graph, &choices.forks, &nodes, &nested, &[&slopes])?;
            if let Some(size) = &size {
                let forks = forks_of_size(size, &value.0);
                value.1.extend_from_slice(&forks);
                slope.1.extend(forks);
            }
            let gradient = forks_of(graph, &choices.forks, &nodes, &nodes, &gradients.each_ref())?;
            let is_private = is_private(graph, &nested[..1], &value.0)
                && is_private(graph, &with_slope, &slope.1)
                && is_private(graph, &with_gradient, &gradient.1);
            is_private.then_some((choices, [value, slope, gradient].map(|(forks, more)| [forks, more].concat())))
        });
        let sum = if found.is_none() { Sum::new(graph, nested[0], simd) } else { None };
        let nothing = [Vec::new(), Vec::new(), Vec::new()];
        let [of_value, of_slope, of_gradient] = found.as_ref().map_or(&nothing, |(_, forks)| forks);
        let points = found.as_ref().map_or(&[][..], |(choices, _)| &choices.forks);
        let value = Shortener::new(&tapes[0], of_value);
        let slope = Shortener::new(&tapes[1], of_slope);
        let point = Shortener::new(&tapes[2], points);
        let gradient = Shortener::new(&tapes[3], of_gradient);
        Kernels {
            value: Kernel::with_copies(&tapes[0], &value, simd),
            slope: Kernel::with_copies(&tapes[1], &slope, simd),
            value_along: Kernel::with_copies(&tapes[0], &value, simd),
            slope_along: Kernel::with_copies(&tapes[1], &slope, simd),
            value_form: Kernel::with_copies(&tapes[0], &value, simd),
            slope_form: Kernel::with_copies(&tapes[1], &slope, simd),
            point: Kernel::with_copies(&tapes[2], &point, simd),
            ball: Kernel::with_copies(&tapes[2], &point, simd),
            gradient: Kernel::with_copies(&tapes[3], &gradient, simd),
            sum,
            parts: found.map(|(choices, [of_value, ..])| {
                let tape = Tape::new(graph, &nested[1 + choices.forks.len() + choices.leaves.len()..]);
                let leaves = Shortener::new(&tape, &of_value);
                Parts {
                    leaves: Kernel::with_copies(&tape, &leaves, simd),
                    shorten: Shorteners { leaves, value, slope, point, gradient },
                    choices,
                }
            }),
        }
    }

    /// All of it.
    pub(crate) fn whole(&self) -> Formula<'_> {
        Formula { kernels: self, program: None, share: None }
    }

    /// What a program leaves of it.
    pub(crate) fn only<'a>(&'a self, program: &'a Program) -> Formula<'a> {
        Formula { kernels: self, program: Some(program), share: None }
    }

    /// All of it, of which forms take so much of the sum as matters.
    pub(crate) fn with_share<'a>(&'a self, share: &'a Share) -> Formula<'a> {
        Formula { kernels: self, program: None, share: Some(share) }
    }
}

impl Parts {
    /// The closures that compute the forms of some arguments.
    pub(crate) fn steps_of(&self, arguments: &[u32]) -> Vec<u32> {
        self.shorten.leaves.shorten(arguments.iter().map(|&k| k as usize), arguments)
    }

    /// The same, to be run.
    pub(crate) fn leaves<'a>(&'a self, steps: &'a [u32]) -> Excerpt<'a, Slabs> {
        self.leaves.excerpt(steps)
    }

    /// Registers for the forms of all arguments.
    pub(crate) fn registers(&self) -> Vec<Slabs> {
        self.leaves.registers()
    }
}

/// The part of a formula for one kind of number.
macro_rules! excerpt {
    ($($(#[$doc:meta])* $name:ident from $list:ident of $roots:literal: $number:ty;)*) => {
        $($(#[$doc])*
        pub(crate) fn $name(&self) -> Excerpt<'a, $number> {
            let kernel = &self.kernels.$name;
            match (self.program, &self.kernels.parts) {
                (Some(program), Some(parts)) => {
                    let make = || parts.shorten.$list.shorten(0..$roots, &program.live).into();
                    kernel.excerpt(program.$list.get_or_init(make))
                }
                _ => kernel.whole(),
            }
        })*
    };
}

impl<'a> Formula<'a> {
    excerpt! {
        /// g over pieces of rays.
        value from value of 1: Cells;
        /// g and g' = a·g_x + b·g_y + c·g_z over pieces of rays.
        slope from slope of 2: Cells;
        /// g over pieces of rays, as forms of the distance.
        value_along from value of 1: RayForms;
        /// g and g' there.
        slope_along from slope of 2: RayForms;
        /// g over squares of the screen.
        value_form from value of 1: Forms;
        /// g and g' there.
        slope_form from slope of 2: Forms;
        /// g at points.
        point from point of 1: Points;
        /// g at points, and how far it is off.
        ball from point of 1: Balls;
        /// g, g_x, g_y, g_z at points.
        gradient from gradient of 4: Points;
    }
}

impl Formula<'_> {
    /// The forms of g and, if asked for, of its slope, over squares of the screen that `place` writes into registers of the coordinates.
    pub(crate) fn forms<'f>(
        &self,
        with_slope: bool,
        files: &'f mut FormFiles,
        simd: Simd,
        place: impl FnOnce(&mut [Forms]),
    ) -> [&'f Forms; 2] {
        if let (Some(share), Some(sum)) = (self.share, &self.kernels.sum) {
            place(&mut files.terms);
            sum.run(share, with_slope, files, simd);
            return files.sums.each_ref();
        }
        let (excerpt, file, last) = if with_slope {
            (self.slope_form(), &mut files.slope, 1)
        } else {
            (self.value_form(), &mut files.value, 0)
        };
        place(file);
        excerpt.run(file);
        let file = &*file;
        [excerpt.output(file, 0), excerpt.output(file, last)]
    }
}

/// The forks among other nodes that stand for the same functions, and those among their derivatives: `nodes` are g, the forks and
/// the arguments, `images` the same in another form, and each of the derivatives again. `None` if a derivative does not choose
/// as the function does: then nothing can be left out of either.
fn forks_of(
    graph: &Graph,
    forks: &[Fork],
    nodes: &[NodeId],
    images: &[NodeId],
    derivatives: &[&Vec<NodeId>],
) -> Option<(Vec<Fork>, Vec<Fork>)> {
    let mut place = vec![usize::MAX; graph.len()];
    for (k, node) in nodes.iter().enumerate() {
        place[node.0 as usize] = k;
    }
    let (mut found, mut further) = (Vec::with_capacity(forks.len()), Vec::new());
    for (k, fork) in forks.iter().enumerate() {
        let operands = sides_of(graph, fork.node).map(|side| place[side.0 as usize]);
        let node = images[k + 1];
        let [left, right] = operands.map(|p| images[p]);
        if graph.op(node) != graph.op(fork.node) {
            return None;
        }
        let is_turned = sides_of(graph, node) == [right, left] && graph.op(node) != Op::Choose;
        if !is_turned && sides_of(graph, node) != [left, right] {
            return None;
        }
        let turned = |mut pair: [NodeId; 2]| {
            if is_turned {
                pair.reverse();
            }
            pair
        };
        let mut sides = fork.sides;
        if is_turned {
            sides.reverse();
        }
        found.push(Fork { node, sides, ..*fork });
        for derivative in derivatives {
            let node = derivative[k + 1];
            let [first, second] = turned(operands.map(|p| derivative[p]));
            if graph.op(node) == Op::Choose && sides_of(graph, node) == [first, second] {
                further.push(Fork { node, sides, ..*fork });
            } else if node != first || node != second {
                return None;
            }
        }
    }
    Some((found, further))
}

/// The two operands between which a node chooses.
fn sides_of(graph: &Graph, node: NodeId) -> [NodeId; 2] {
    let args = graph.args(node);
    [args[args.len() - 2], args[args.len() - 1]]
}

/// The forks in the size of a function that choose as some of its own.
fn forks_of_size(size: &Size, forks: &[Fork]) -> Vec<Fork> {
    let of = |&(node, choice): &(NodeId, NodeId)| {
        forks.iter().find(|fork| fork.node == choice).map(|fork| Fork { node, ..*fork })
    };
    size.choices.iter().filter_map(of).collect()
}
