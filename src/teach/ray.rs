//! One ray and one surface, as a story: g(t), what marching sees of it, what Newton does, what intervals prove.
//!
//! In: a formula, a ray as it was given, a part of it, a step. Out: a [`Story`] with every number of it, and the page it makes.
//! The ray's direction keeps its length, so that t is counted in its units. Separate from `surface`, which answers millions
//! of rays and tells of none.

pub mod figure;
pub mod light;
pub mod march;
pub mod proof;
pub mod write;

use super::substitute::substitute;
use crate::closure::Formula;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;
use crate::num::level::Simd;
use crate::num::rational::Rational;
use glam::DVec3;
use light::Optics;
use march::Bracket;
use proof::Proof;

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Question {
    /// Where the ray starts.
    pub origin: DVec3,
    /// Where it goes, as given: t counts its lengths.
    pub direction: DVec3,
    /// The part of it that is looked at, t ≥ 0.
    pub span: (f64, f64),
    /// The march's step in t, > 0.
    pub step: f64,
    /// The index of refraction behind the surface, over that in front of it.
    pub ior: f64,
    /// The unit direction towards the light.
    pub light: DVec3,
    /// Whether the surface is the boundary of a solid: nothing is rewritten, and only changes of sign count.
    pub is_solid: bool,
}

/// What the tracer of the pictures says of the same ray, t in the units of the question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    /// The key of its words in the texts.
    pub outcome: &'static str,
    /// Whether that is proven.
    pub is_proven: bool,
    /// The root, +∞ for none.
    pub t: f64,
    /// The unit normal, turned against the ray; NaN where there is none.
    pub normal: DVec3,
    /// Whether the gradient points along the ray.
    pub is_flipped: bool,
}

/// All that is told of a ray.
#[derive(Clone, Debug)]
pub struct Story {
    /// What was asked.
    pub question: Question,
    /// g(t), t being called x; none if it is too long.
    pub g: Option<super::term::Term>,
    /// Whether f is 0 where the ray starts.
    pub starts_on_surface: bool,
    /// t and g(t) at the march's samples.
    pub samples: Vec<(f64, f64)>,
    /// The changes of sign, with Newton's way in each.
    pub brackets: Vec<Bracket>,
    /// What is proven.
    pub proof: Proof,
    /// The tracer's own answer.
    pub verdict: Verdict,
    /// f and its gradient at the tracer's root.
    pub at_hit: Option<(f64, DVec3)>,
    /// What becomes of light there.
    pub optics: Option<Optics>,
    /// Whether f has one sign on both sides of a proven root, so that no samples can show it.
    pub keeps_sign: bool,
    /// g for the figures.
    pub curve: Curve,
}

/// g(t) at many places, for drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curve {
    /// t and g(t) over the whole part that is looked at.
    pub whole: Vec<(f64, f64)>,
    /// The same over the first bracket.
    pub bracket: Vec<(f64, f64)>,
}

/// A root this near to the start, as a part of the stretch looked at, is the start itself.
const AT_START: f64 = 1e-12;

/// A proven root and a sample this near, as a part of the stretch, are one place: the root is known to a thousandth of that.
const NEAR: f64 = 1e-9;

/// How far beside a root its sign is read, as a part of the stretch.
const BESIDE: f64 = 1e-6;

/// Places at which a curve is drawn.
const DRAWN: usize = 600;

impl Story {
    /// Tells the story of a ray.
    pub fn tell(graph: &mut Graph, f: NodeId, question: Question, verdict: Verdict) -> Story {
        let node = along(graph, f, &question, Rational::from_f64);
        let g = Formula::new(graph, node, Simd::best());
        let at = |t: f64| {
            let (value, slope) = g.gradient(DVec3::new(t, 0.0, 0.0));
            (value, slope.x)
        };
        let samples = march::samples(&at, question.span, question.step);
        let brackets = march::brackets(&at, &samples);
        let proof = proof::prove(graph, f, &question);
        let formula = Formula::new(graph, f, Simd::best());
        let at_hit = verdict.t.is_finite().then(|| formula.gradient(question.origin + question.direction * verdict.t));
        let optics = (at_hit.is_some() && verdict.normal.is_finite()).then(|| {
            light::optics(question.direction, verdict.normal, verdict.is_flipped, question.ior, question.light)
        });
        let plotted = |(a, b): (f64, f64)| {
            let place = |k: usize| a + (b - a) * k as f64 / DRAWN as f64;
            (0..=DRAWN).map(place).map(|t| (t, at(t).0)).collect::<Vec<(f64, f64)>>()
        };
        let bracket = brackets.first().map(|bracket| plotted((bracket.a, bracket.b))).unwrap_or_default();
        let curve = Curve { whole: plotted(question.span), bracket };
        let start = formula.value(question.origin);
        let near = question.direction.length() * (question.span.1 - question.span.0) * AT_START;
        let starts_on_surface =
            question.span.0 == 0.0 && start.abs() <= near * formula.gradient(question.origin).1.length();
        // For people the ray's numbers are the decimals that were typed.
        let decimal = |value: f64| {
            Rational::from_decimal(&value.abs().to_string()).map(|size| if value < 0.0 { size.negated() } else { size })
        };
        let node = along(graph, f, &question, decimal);
        let term = super::term::Term::of(graph, node);
        let beside = BESIDE * (question.span.1 - question.span.0);
        let keeps_sign = proof.roots.iter().any(|root| at(root.t - beside).0 * at(root.t + beside).0 > 0.0);
        Story {
            question,
            g: term,
            keeps_sign,
            starts_on_surface,
            samples,
            brackets,
            proof,
            verdict,
            at_hit,
            optics,
            curve,
        }
    }

    /// The proven roots that no change of sign between two samples shows.
    pub fn missed(&self) -> Vec<f64> {
        let slack = NEAR * (self.question.span.1 - self.question.span.0);
        let is_seen = |t: f64| self.brackets.iter().any(|bracket| bracket.a - slack <= t && t <= bracket.b + slack);
        self.proof.roots.iter().map(|root| root.t).filter(|&t| !is_seen(t) && !self.is_start(t)).collect()
    }

    /// The changes of sign that are no roots: poles and jumps.
    pub fn mistaken(&self) -> Vec<(f64, f64)> {
        let has_root = |bracket: &Bracket| {
            let slack = NEAR * (self.question.span.1 - self.question.span.0);
            self.proof.roots.iter().any(|root| bracket.a - slack <= root.t && root.t <= bracket.b + slack)
        };
        let is_decided = self.proof.is_complete;
        self.brackets.iter().filter(|bracket| is_decided && !has_root(bracket)).map(|b| (b.a, b.b)).collect()
    }

    /// Whether a root is where the ray starts.
    pub fn is_start(&self, t: f64) -> bool {
        self.starts_on_surface && t <= NEAR * (self.question.span.1 - self.question.span.0)
    }
}

/// g(t) = f(o + t·d) as a node, t standing in the place of x; `number` says which number each f64 of the ray is.
pub fn along(graph: &mut Graph, f: NodeId, question: &Question, number: impl Fn(f64) -> Option<Rational>) -> NodeId {
    let t = graph.variable(crate::expr::op::Variable::X);
    let by = [0, 1, 2].map(|axis| {
        let number = |value: f64| number(value).unwrap_or_else(|| Rational::from_integer(0));
        let (start, rate) = (number(question.origin[axis]), number(question.direction[axis]));
        let (start, rate) = (graph.number(start), graph.number(rate));
        let moved = graph.apply(Op::Mul, &[rate, t]);
        graph.apply(Op::Add, &[start, moved])
    });
    substitute(graph, f, by)
}

#[cfg(test)]
mod tests;
