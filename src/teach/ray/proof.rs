//! What intervals prove of a ray, piece by piece.
//!
//! In: a formula and a ray. Out: the stretch in pieces, for each what is known of it, and all roots. A re-run in teaching size of
//! what `surface::isolate` and `surface::careful` do: one ray, one piece at a time, everything written down. The equation is
//! rewritten first, as it is there.

use super::{Question, along};
use crate::closure::Tape;
use crate::closure::pieces::{Pieces, Scratch};
use crate::expr::derivative::derivative;
use crate::expr::equation;
use crate::expr::graph::{Graph, NodeId};
use crate::num::interval::{Defined, Enclosure, Interval};
use crate::num::level::Simd;
use crate::num::rational::Rational;

/// Pieces shorter than this part of the stretch have their jumps and poles taken apart.
const SHORT: f64 = 1e-4;

/// Pieces shorter than this part are not halved any more: rounding is near.
const SHORTEST: f64 = 1e-10;

/// A root is closed in to this part of the stretch.
const WIDTH: f64 = 1e-12;

/// The most pieces that are looked at.
const MOST_PIECES: usize = 20_000;

/// What is known of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Finding {
    /// g > 0 or g < 0 all over.
    Empty,
    /// g has no value anywhere.
    Undefined,
    /// g rises or falls all over, and has the same sign at both ends.
    MonotoneEmpty,
    /// g rises or falls all over and changes its sign: one root.
    Root,
    /// A pole or a jump: on neither side of it is g zero.
    Pole,
    /// A root of the rewritten equation where the equation as written has no value, or a forbidden one.
    Excluded,
    /// Too short to go on, and nothing is proven.
    Undecided,
}

/// A piece of the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// From this t.
    pub a: f64,
    /// To this.
    pub b: f64,
    /// All values of g on it are in here.
    pub range: Interval,
    /// What is known.
    pub finding: Finding,
    /// How many neighbours of one kind it stands for.
    pub count: usize,
}

/// A proven root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Root {
    /// In the middle of its bracket.
    pub t: f64,
    /// The bracket, at whose ends g has proven opposite signs.
    pub bracket: (f64, f64),
}

/// What is proven of a ray.
#[derive(Clone, Debug, Default)]
pub struct Proof {
    /// The equation that is solved, where it is not f itself, as text.
    pub rewritten: Vec<String>,
    /// The pieces, in the order of t, sheet by sheet.
    pub pieces: Vec<Piece>,
    /// The roots, in the order of t.
    pub roots: Vec<Root>,
    /// Whether every piece is decided.
    pub is_complete: bool,
}

/// Proves what can be proven.
pub fn prove(graph: &mut Graph, f: NodeId, question: &Question) -> Proof {
    let mut proof = Proof { is_complete: true, ..Proof::default() };
    let bare = || equation::Sheet { g: f, guards: Vec::new(), nonzero: Vec::new(), sign: equation::Sign::Same };
    let sheets = if question.is_solid { vec![bare()] } else { equation::sheets(graph, f).sheets };
    for sheet in sheets {
        if sheet.g != f {
            proof.rewritten.extend(crate::expr::print::text(graph, sheet.g, 400));
        }
        let mut walk = Walk::new(graph, &sheet, question);
        walk.run(question.span);
        proof.is_complete &= walk.is_complete;
        proof.pieces.extend(joined(walk.pieces));
        proof.roots.extend(walk.roots);
    }
    proof.roots.sort_by(|a, b| a.t.total_cmp(&b.t));
    let same = 4.0 * SHORTEST * (question.span.1 - question.span.0);
    proof.roots.dedup_by(|a, b| (a.t - b.t).abs() <= same);
    proof
}

/// One sheet on the ray.
struct Walk {
    /// g, g', then what must have a value, then what must not be 0.
    formulas: Pieces,
    scratch: Scratch,
    /// g alone, side by side of its poles.
    sides: Pieces,
    sides_scratch: Scratch,
    guards: usize,
    nonzero: usize,
    length: f64,
    pieces: Vec<Piece>,
    roots: Vec<Root>,
    is_complete: bool,
}

impl Walk {
    fn new(graph: &mut Graph, sheet: &equation::Sheet, question: &Question) -> Walk {
        let g = along(graph, sheet.g, question, Rational::from_f64);
        let (one, zero) = (graph.integer(1), graph.integer(0));
        let slope = derivative(graph, &[g], [one, zero, zero])[0];
        let mut roots = vec![g, slope];
        for &condition in sheet.guards.iter().chain(&sheet.nonzero) {
            roots.push(along(graph, condition, question, Rational::from_f64));
        }
        let formulas = Pieces::new(Tape::new(graph, &roots), Simd::best());
        let sides = Pieces::new(Tape::new(graph, &[g]), Simd::best());
        Walk {
            scratch: formulas.scratch(),
            sides_scratch: sides.scratch(),
            formulas,
            sides,
            guards: sheet.guards.len(),
            nonzero: sheet.nonzero.len(),
            length: question.span.1 - question.span.0,
            pieces: Vec::new(),
            roots: Vec::new(),
            is_complete: true,
        }
    }

    fn run(&mut self, span: (f64, f64)) {
        let mut open = vec![span];
        let mut looked = 0;
        while let Some((a, b)) = open.pop() {
            looked += 1;
            if looked > MOST_PIECES {
                self.is_complete = false;
                self.pieces.push(Piece { a, b: span.1, range: Interval::WHOLE, finding: Finding::Undecided, count: 1 });
                return;
            }
            let (range, finding) = self.examine(a, b);
            match finding {
                Some(finding) => {
                    self.is_complete &= finding != Finding::Undecided;
                    self.pieces.push(Piece { a, b, range, finding, count: 1 });
                }
                None => {
                    // Off the middle: symmetric formulas have their roots at round places.
                    let m = a + 0.4921875 * (b - a);
                    open.extend([(m, b), (a, m)]);
                }
            }
        }
    }

    /// What is known of a piece; `None` if it is to be halved.
    fn examine(&mut self, a: f64, b: f64) -> (Interval, Option<Finding>) {
        let [g, slope] = self.enclose(a, b);
        if g.defined == Defined::Nowhere {
            return (g.range, Some(Finding::Undefined));
        }
        if excludes_zero(g.range) {
            return (g.range, Some(Finding::Empty));
        }
        let is_smooth = g.continuous && g.defined == Defined::Everywhere;
        if !is_smooth && b - a <= SHORT * self.length && self.is_pole(a, b) {
            return (g.range, Some(Finding::Pole));
        }
        if is_smooth && slope.defined == Defined::Everywhere && excludes_zero(slope.range) {
            match (self.sign(a), self.sign(b)) {
                (0, _) | (_, 0) => {}
                (front, behind) if front == behind => return (g.range, Some(Finding::MonotoneEmpty)),
                (front, _) => return (g.range, Some(self.close_in(a, b, front))),
            }
        }
        if b - a <= SHORTEST * self.length {
            return (g.range, Some(self.at_the_limit(a, b)));
        }
        (g.range, None)
    }

    fn enclose(&mut self, a: f64, b: f64) -> [Enclosure; 2] {
        let zero = Interval::point(0.0);
        self.formulas.enclose(&[Interval::new(a, b), zero, zero, zero, zero, zero], &mut self.scratch);
        [0, 1].map(|k| self.formulas.output(&self.scratch, k))
    }

    /// The proven sign of g at t, 0 where it cannot be told.
    fn sign(&mut self, t: f64) -> i32 {
        let [g, _] = self.enclose(t, t);
        match g.range {
            _ if g.defined != Defined::Everywhere => 0,
            range if range.lo > 0.0 => 1,
            range if range.hi < 0.0 => -1,
            _ => 0,
        }
    }

    fn is_pole(&mut self, a: f64, b: f64) -> bool {
        let zero = Interval::point(0.0);
        let place = [Interval::new(a, b), zero, zero, zero, zero, zero];
        let is_out = |side: &Enclosure| side.defined == Defined::Nowhere || excludes_zero(side.range);
        self.sides.all_pieces(&place, &mut self.sides_scratch, is_out) > 0
    }

    /// Halves [a, b], on which g is monotone with opposite signs at the ends, as long as signs can be told.
    fn close_in(&mut self, a: f64, b: f64, front: i32) -> Finding {
        let (mut a, mut b) = (a, b);
        while b - a > WIDTH * self.length {
            let m = 0.5 * (a + b);
            match self.sign(m) {
                _ if !(m > a && m < b) => break,
                0 => break,
                sign if sign == front => a = m,
                _ => b = m,
            }
        }
        self.enclose(a, b);
        let condition = |walk: &Walk, k: usize| walk.formulas.output(&walk.scratch, 2 + k);
        let fails = (0..self.guards).any(|k| condition(self, k).defined == Defined::Nowhere)
            || (self.guards..self.guards + self.nonzero).any(|k| {
                let value = condition(self, k);
                value.defined == Defined::Nowhere || value.range == Interval::point(0.0)
            });
        let holds = (0..self.guards).all(|k| condition(self, k).defined == Defined::Everywhere)
            && (self.guards..self.guards + self.nonzero).all(|k| {
                let value = condition(self, k);
                value.defined == Defined::Everywhere && excludes_zero(value.range)
            });
        match (fails, holds) {
            (true, _) => Finding::Excluded,
            (_, false) => Finding::Undecided,
            (false, true) => {
                self.roots.push(Root { t: 0.5 * (a + b), bracket: (a, b) });
                Finding::Root
            }
        }
    }

    /// A piece too short to be halved: a root at its end shows when it is widened.
    fn at_the_limit(&mut self, a: f64, b: f64) -> Finding {
        let slack = SHORTEST * self.length;
        let (wide_a, wide_b) = (a - slack, b + slack);
        let [g, slope] = self.enclose(wide_a, wide_b);
        let is_smooth = g.continuous && g.defined == Defined::Everywhere && slope.defined == Defined::Everywhere;
        let (front, behind) = (self.sign(wide_a), self.sign(wide_b));
        if !is_smooth || !excludes_zero(slope.range) || front * behind == 0 {
            return Finding::Undecided;
        }
        if front == behind { Finding::MonotoneEmpty } else { self.close_in(wide_a, wide_b, front) }
    }
}

fn excludes_zero(range: Interval) -> bool {
    range.lo > 0.0 || range.hi < 0.0
}

/// Neighbours of which the same is known, as one piece.
fn joined(pieces: Vec<Piece>) -> Vec<Piece> {
    let mut out: Vec<Piece> = Vec::new();
    for piece in pieces {
        let sign = |piece: &Piece| (piece.range.lo > 0.0, piece.range.hi < 0.0);
        match out.last_mut() {
            Some(last)
                if last.finding == piece.finding && piece.finding != Finding::Root && sign(last) == sign(&piece) =>
            {
                last.b = piece.b;
                last.range = last.range.hull(piece.range);
                last.count += 1;
            }
            _ => out.push(piece),
        }
    }
    out
}
