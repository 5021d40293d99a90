//! A formula made ready to be met by rays.
//!
//! In: a graph, the node of f, a clip. Out: a [`Surface`]: the sheets its zero set is made of, each with the
//! kernels that the tracers run. Separate because it is built once and then shared by all threads.

use super::hit::Ray;
use super::index::Index;
use super::kernels::Kernels;
use super::region::{self, Clip, Shape};
use crate::closure::pieces::Pieces;
use crate::closure::{Kernel, Tape};
use crate::expr::derivative::{along_ray, gradient};
use crate::expr::equation::{self, Sign};
use crate::expr::graph::{Graph, NodeId};
use crate::num::affine_lanes::AffineLanes;
use crate::num::ball_lanes::BallLanes;
use crate::num::interval_lanes::IntervalLanes;
use crate::num::lanes::Lanes;
use crate::num::level::Simd;

/// How many pieces of rays are enclosed at once. Measured: fewer pay more for calls, more leave the first cache.
pub const CELLS: usize = 16;

/// How many points are evaluated at once.
pub const POINTS: usize = 64;

/// Enclosures over [`CELLS`] pieces of rays.
pub type Cells = IntervalLanes<CELLS>;

/// Enclosures over as many that know how g leans along the ray.
pub type RayForms = AffineLanes<CELLS, 1>;

/// Values at [`POINTS`] points.
pub type Points = Lanes<POINTS>;

/// The same, and how far they are off.
pub type Balls = BallLanes<POINTS>;

/// What of a function is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// All its roots.
    Equation,
    /// The places where its sign changes.
    Solid,
}

/// A surface ready to be traced; shared by all threads.
pub struct Surface {
    /// What its zero set is made of; a ray's first root is the first of any sheet.
    pub(crate) sheets: Vec<Sheet>,
    /// f as it was written, for the textbook method.
    pub(crate) written: Written,
    /// Boxes and balls that cut it.
    pub(crate) shapes: Vec<Shape>,
    /// The length that tolerances are measured by.
    pub(crate) size: f64,
    /// What is drawn.
    pub(crate) kind: Kind,
    /// The instructions its kernels were made for.
    pub(crate) simd: Simd,
}

/// One function g whose roots, where all conditions hold, are roots of f.
pub(crate) struct Sheet {
    /// g and its derivatives, as the tracers run them.
    pub(crate) kernels: Kernels,
    /// Where which part of g matters.
    pub(crate) index: Option<Index>,
    /// g, g', g'' and then the conditions, one piece of a ray at a time.
    pub(crate) scalar: Pieces,
    /// g alone, with its jumps and poles taken apart.
    pub(crate) sides: Pieces,
    /// How many of the scalar outputs behind g'' must be defined where a root counts.
    pub(crate) guards: usize,
    /// How many behind those must not be 0 there.
    pub(crate) nonzero: usize,
    /// For each of those, whether g is 0 wherever it is.
    pub(crate) shared_roots: Vec<bool>,
    /// How many behind those must be ≤ 0 there: the clip's own formulas.
    pub(crate) fields: usize,
}

/// A function as it was written.
pub(crate) struct Written {
    /// f at points.
    pub(crate) point: Kernel<Points>,
    /// f, f_x, f_y, f_z at points.
    pub(crate) gradient: Kernel<Points>,
}

impl Sheet {
    /// Whether a root counts without further conditions.
    pub(crate) fn is_free(&self) -> bool {
        self.guards + self.nonzero + self.fields == 0
    }
}

impl Surface {
    /// The surface of `f = 0`, or the boundary of the region where `f ≤ 0`, seen inside `clip`.
    ///
    /// The equation is rewritten into sheets that have the same roots and are easier to prove; the graph
    /// gains the nodes of that and of the derivatives.
    pub fn new(graph: &mut Graph, f: NodeId, kind: Kind, clip: &Clip, simd: Simd) -> Surface {
        let parts = match kind {
            Kind::Equation => equation::sheets(graph, f).sheets,
            Kind::Solid => vec![equation::Sheet { g: f, guards: Vec::new(), nonzero: Vec::new(), sign: Sign::Same }],
        };
        let sheets = parts.iter().map(|part| sheet(graph, part, kind, clip, simd)).collect();
        let written = written(graph, f, simd);
        Surface { sheets, written, shapes: clip.shapes.clone(), size: clip.size(), kind, simd }
    }

    /// How many operations it takes to compute its functions at a point.
    pub fn steps(&self) -> usize {
        self.sheets.iter().map(|sheet| sheet.kernels.whole().value().len()).sum()
    }

    /// The distances between which the ray is inside the clip's shapes; `None` if it never is.
    pub(crate) fn span(&self, ray: &Ray) -> Option<(f64, f64)> {
        region::span(&self.shapes, ray)
    }
}

fn written(graph: &mut Graph, f: NodeId, simd: Simd) -> Written {
    let [x, y, z] = gradient(graph, f);
    Written {
        point: Kernel::new(&Tape::for_points(graph, &[f]), simd),
        gradient: Kernel::new(&Tape::for_points(graph, &[f, x, y, z]), simd),
    }
}

fn sheet(graph: &mut Graph, part: &equation::Sheet, kind: Kind, clip: &Clip, simd: Simd) -> Sheet {
    let (g, fields) = (part.g, &clip.fields);
    let slope = along_ray(graph, &[g])[0];
    let curvature = along_ray(graph, &[slope])[0];
    let mut scalar = vec![g, slope, curvature];
    scalar.extend(part.guards.iter().chain(&part.nonzero).chain(fields));
    let kernels = Kernels::new(graph, g, kind == Kind::Solid, simd);
    Sheet {
        index: Index::new(&kernels, &clip.shapes, simd),
        kernels,
        scalar: Pieces::new(Tape::new(graph, &scalar), simd),
        sides: Pieces::new(Tape::new(graph, &[g]), simd),
        shared_roots: part.nonzero.iter().map(|&d| equation::vanishes_with(graph, g, d)).collect(),
        guards: part.guards.len(),
        nonzero: part.nonzero.len(),
        fields: fields.len(),
    }
}
