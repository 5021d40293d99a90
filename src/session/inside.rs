//! Which side of a clear surface is its inside.
//!
//! In: the function as it was written, and what its equation becomes. Out: whether the inside is where the rewritten function is
//! negative. Separate because it takes proofs: a surface that is bounded has its inside where the sign differs from that far away.

use super::proofs::{Prover, frame};
use crate::closure::Formula;
use crate::diag::Diagnostic;
use crate::expr::equation::{self, Sheet, Sign};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::lower::{Inside, Kind, SurfaceFormula};
use crate::num::interval::{Defined, Interval};
use crate::num::level::Simd;
use glam::DVec3;

/// How far from the middle of a bounded surface the space around it begins whose sign is proven, in its radii.
const AROUND: f64 = 2.0;

/// How often a box of that space is halved, each way, to prove its sign.
const DEPTH: u32 = 4;

/// Whether the inside of a surface is where its function, as rewritten, is negative; a note if that had to be assumed.
///
/// A product is the surfaces of its factors, and each factor is a body of its own.
pub(super) fn is_negative(
    graph: &mut Graph,
    surface: &SurfaceFormula,
    simd: Simd,
    notes: &mut Vec<Diagnostic>,
) -> bool {
    let sheets = match surface.kind {
        Kind::Solid => vec![Sheet { g: surface.f, guards: Vec::new(), nonzero: Vec::new(), sign: Sign::Same }],
        Kind::Equation | Kind::Number => equation::sheets(graph, surface.f).sheets,
    };
    let far: Vec<Option<Far>> = sheets.iter().map(|sheet| sign_far_away(graph, sheet.g, simd)).collect();
    if let Some(inside) = surface.matter.inside {
        let is_negative = inside == Inside::Negative;
        return is_negative == (sign_of_f(&sheets, &far) == Far::Positive);
    }
    match far.first() {
        Some(Some(sign)) => {
            if far.contains(&Some(sign.other())) {
                let note = Diagnostic::note(surface.span, "the factors of this product have opposite signs far away");
                notes.push(note.help("write each factor as a glass of its own; the inside is that of the first here"));
            }
            *sign == Far::Positive
        }
        _ => {
            if surface.kind == Kind::Equation {
                let message =
                    "glass without an end: its inside is taken to be where left side minus right side is negative";
                let note = Diagnostic::note(surface.span, message);
                notes.push(note.help("write `inside: negative` or `inside: positive`"));
            }
            sheets.first().is_none_or(|sheet| sheet.sign != Sign::Opposite)
        }
    }
}

/// A sign that is the same everywhere far away.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Far {
    Positive,
    Negative,
}

impl Far {
    fn other(self) -> Far {
        match self {
            Far::Positive => Far::Negative,
            Far::Negative => Far::Positive,
        }
    }
}

/// The sign of f where the first sheet's function is positive: f is the product of the factors, up to a positive one, and the
/// other factors have the sign that they have far away.
fn sign_of_f(sheets: &[Sheet], far: &[Option<Far>]) -> Far {
    let first_is_opposite = sheets.first().is_some_and(|sheet| sheet.sign == Sign::Opposite);
    let negative_factors = far.iter().skip(1).filter(|sign| **sign == Some(Far::Negative)).count();
    if first_is_opposite != (negative_factors % 2 == 1) { Far::Negative } else { Far::Positive }
}

/// The sign that g has everywhere around a bounded surface; `None` if that is not proven.
fn sign_far_away(graph: &mut Graph, g: NodeId, simd: Simd) -> Option<Far> {
    let g = Formula::new(graph, g, simd);
    let prover = Prover::new(&g, &[], &[]);
    let found = frame(&[prover]).ok().filter(|found| found.is_all)?;
    let half = found.radius * AROUND;
    let mut sign = None;
    // 4 × 4 × 4 boxes but for the middle 2 × 2 × 2: a closed shell around all there is.
    for (i, j, k) in (0..64).map(|n| (n & 3, (n >> 2) & 3, n >> 4)) {
        if [i, j, k].iter().all(|&n| n == 1 || n == 2) {
            continue;
        }
        let min = found.center + (DVec3::new(f64::from(i), f64::from(j), f64::from(k)) / 2.0 - 1.0) * half;
        let here = proven_sign(&g, min, min + half / 2.0, DEPTH)?;
        if sign.is_some_and(|sign| sign != here) {
            return None;
        }
        sign = Some(here);
    }
    sign
}

/// The one sign of g in a box where it has a value everywhere.
fn proven_sign(g: &Formula, min: DVec3, max: DVec3, depth: u32) -> Option<Far> {
    let enclosure = g.enclosure([0, 1, 2].map(|axis| Interval { lo: min[axis], hi: max[axis] }));
    match enclosure.defined {
        Defined::Everywhere if enclosure.range.lo > 0.0 => return Some(Far::Positive),
        Defined::Everywhere if enclosure.range.hi < 0.0 => return Some(Far::Negative),
        Defined::Nowhere => return None,
        Defined::Everywhere | Defined::Somewhere if depth == 0 => return None,
        Defined::Everywhere | Defined::Somewhere => {}
    }
    let middle = (min + max) / 2.0;
    let mut sign = None;
    for k in 0..8 {
        let upper = glam::BVec3::new(k & 1 != 0, k & 2 != 0, k & 4 != 0);
        let here = proven_sign(g, DVec3::select(upper, middle, min), DVec3::select(upper, max, middle), depth - 1)?;
        if sign.is_some_and(|sign| sign != here) {
            return None;
        }
        sign = Some(here);
    }
    sign
}
