//! f = 0 as the sheets whose roots it has: the same zero set, but with roots that change sign, and without poles.
//!
//! In: the node f. Out: [`Sheet`]s, whose roots together are exactly those of f, and the named rewritings that led
//! there. Separate because here, unlike in the simplifier, only the zero set is kept, not the values; what a sheet
//! says of a root that f itself does not is written on it as a condition.
//!
//! Only for equations. The boundary of a solid is where its function changes sign: nothing may be rewritten.
//!
//! - [`fraction`]: sums of quotients over one denominator. - [`removable`]: where numerator and denominator vanish
//!   together. - [`mod@whole`]: the sheets as one function again. - [`centre`]: polynomials about the place where they lie. - [`exponentials`]: e^(2u) as (e^u)².

mod centre;
mod exponentials;
mod fraction;
mod removable;
#[cfg(test)]
mod tests;
mod whole;

pub use removable::vanishes_with;
pub use whole::whole;

use super::graph::{Graph, NodeId};
use super::op::Op;
use super::polynomial::{divisor, expand, modular};
use crate::num::rational::Rational;
use expand::Letters;

/// What the sign of g says of the sign of f.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// f and g have the same sign wherever f has a value.
    Same,
    /// f and g have opposite signs wherever f has a value.
    Opposite,
    /// Nothing.
    Unrelated,
}

impl Sign {
    fn flipped(self) -> Sign {
        match self {
            Sign::Same => Sign::Opposite,
            Sign::Opposite => Sign::Same,
            Sign::Unrelated => Sign::Unrelated,
        }
    }
}

/// One equation g = 0 whose roots are roots of f, under conditions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sheet {
    /// A root of g counts where g is defined and all conditions hold.
    pub g: NodeId,
    /// Nodes that must have a value at the root.
    pub guards: Vec<NodeId>,
    /// Nodes that must have a value other than 0 at the root.
    pub nonzero: Vec<NodeId>,
    /// What the sign of g says of f.
    pub sign: Sign,
}

/// One rewriting, as a person may be told it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// Its name.
    pub name: &'static str,
    /// The left side before.
    pub from: NodeId,
    /// The left sides after; none if the equation has no solution.
    pub to: Vec<NodeId>,
}

/// An equation f = 0, rewritten.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Equation {
    /// The roots of f are the roots of the sheets; without sheets f has no root at all.
    pub sheets: Vec<Sheet>,
    /// What was done, outermost first.
    pub steps: Vec<Step>,
}

/// The most sheets that are made; a product of more factors is kept whole.
const MAX_SHEETS: usize = 64;

/// The zero set of f as sheets.
pub fn sheets(graph: &mut Graph, f: NodeId) -> Equation {
    let here = graph.set_span(graph.span(f));
    let mut search = Search { graph, steps: Vec::new() };
    let mut found = Vec::new();
    let root = Sheet { g: f, guards: Vec::new(), nonzero: Vec::new(), sign: Sign::Same };
    let complete = search.split(root.clone(), &mut found);
    let sheets: Vec<Sheet> =
        found.into_iter().filter_map(|sheet| search.without_roots_of_denominators(sheet)).collect();
    let steps = search.steps;
    graph.set_span(here);
    if complete {
        Equation { sheets: merged(sheets), steps }
    } else {
        Equation { sheets: vec![root], steps: Vec::new() }
    }
}

/// The sheets without those that another one contains.
fn merged(sheets: Vec<Sheet>) -> Vec<Sheet> {
    let mut kept: Vec<Sheet> = Vec::new();
    let within = |a: &[NodeId], b: &[NodeId]| a.iter().all(|id| b.contains(id));
    for sheet in sheets {
        let weaker =
            |a: &Sheet, b: &Sheet| a.g == b.g && within(&a.guards, &b.guards) && within(&a.nonzero, &b.nonzero);
        if kept.iter().any(|k| weaker(k, &sheet)) {
            continue;
        }
        kept.retain(|k| !weaker(&sheet, k));
        kept.push(sheet);
    }
    kept
}

struct Search<'a> {
    graph: &'a mut Graph,
    steps: Vec<Step>,
}

/// What one rewriting makes of a sheet: nothing to rewrite, or the sheets instead of it.
type Rewritten = Option<(&'static str, Vec<Sheet>)>;

impl Search<'_> {
    /// Rewrites until nothing applies; false if there are too many sheets.
    fn split(&mut self, root: Sheet, found: &mut Vec<Sheet>) -> bool {
        let mut open = vec![root];
        while let Some(sheet) = open.pop() {
            match self.rewritten(&sheet) {
                None => found.push(sheet),
                Some((name, parts)) => {
                    let to = parts.iter().map(|part| part.g).collect();
                    self.steps.push(Step { name, from: sheet.g, to });
                    open.extend(parts.into_iter().rev());
                }
            }
            if open.len() + found.len() > MAX_SHEETS {
                return false;
            }
        }
        true
    }

    fn rewritten(&mut self, sheet: &Sheet) -> Rewritten {
        self.never_zero(sheet)
            .or_else(|| self.outer_function(sheet))
            .or_else(|| self.product(sheet))
            .or_else(|| self.quotient(sheet))
            .or_else(|| self.exponential(sheet))
            .or_else(|| self.fractions_together(sheet))
            .or_else(|| self.repeated_factors(sheet))
            .or_else(|| self.about_centre(sheet))
    }

    fn never_zero(&mut self, sheet: &Sheet) -> Rewritten {
        self.graph.is_nonzero(sheet.g).then(|| ("never zero", Vec::new()))
    }

    /// h(g) where h is zero exactly where g is, and defined there.
    fn outer_function(&mut self, sheet: &Sheet) -> Rewritten {
        let [a, b, _] = self.graph.node(sheet.g).args;
        let sign_of = |c: Option<&Rational>| match c {
            Some(c) if c.is_positive() => Some(Sign::Same),
            Some(c) if c.is_negative() => Some(Sign::Opposite),
            _ => None,
        };
        let (name, g, relation) = match self.graph.op(sheet.g) {
            Op::Neg => ("-g = 0 where g = 0", a, Sign::Opposite),
            Op::Mul => ("c*g = 0 where g = 0", b, sign_of(self.graph.constant(a))?),
            Op::Div => ("g/c = 0 where g = 0", a, sign_of(self.graph.constant(b))?),
            Op::Abs => ("|g| = 0 where g = 0", a, Sign::Unrelated),
            Op::Sqrt => ("sqrt(g) = 0 where g = 0", a, Sign::Unrelated),
            Op::Power(n) if n > 0 && n % 2 == 0 => ("g^n = 0 where g = 0", a, Sign::Unrelated),
            Op::Power(n) if n > 0 => ("g^n = 0 where g = 0", a, Sign::Same),
            Op::Pow if self.graph.constant(b).is_some_and(Rational::is_positive) => {
                ("g^n = 0 where g = 0", a, Sign::Unrelated)
            }
            Op::Root(_) => ("root(g) = 0 where g = 0", a, Sign::Same),
            Op::Asin | Op::Atan | Op::Sinh | Op::Tanh | Op::Asinh | Op::Atanh | Op::Erf => {
                ("h(g) = 0 where g = 0, h odd and increasing", a, Sign::Same)
            }
            Op::Tan => return self.tangent(sheet, a),
            _ => return None,
        };
        let sign = match relation {
            Sign::Same => sheet.sign,
            Sign::Opposite => sheet.sign.flipped(),
            Sign::Unrelated => Sign::Unrelated,
        };
        Some((name, vec![Sheet { g, sign, ..sheet.clone() }]))
    }

    /// tan(u) = 0 where sin(u) = 0: the cosine is ±1 there.
    fn tangent(&mut self, sheet: &Sheet, u: NodeId) -> Rewritten {
        let g = self.graph.apply(Op::Sin, &[u]);
        Some(("tan(g) = 0 where sin(g) = 0", vec![Sheet { g, sign: Sign::Unrelated, ..sheet.clone() }]))
    }

    /// A product is 0 where a factor is 0 and the others are defined.
    fn product(&mut self, sheet: &Sheet) -> Rewritten {
        let [a, b, _] = self.graph.node(sheet.g).args;
        if self.graph.op(sheet.g) != Op::Mul || self.graph.constant(a).is_some() {
            return None;
        }
        let parts = [(a, b), (b, a)].map(|(g, other)| {
            let mut part = Sheet { g, sign: Sign::Unrelated, ..sheet.clone() };
            self.guard(&mut part, other);
            part
        });
        Some(("a product is 0 where a factor is 0", parts.to_vec()))
    }

    /// A quotient is 0 where the numerator is 0 and the denominator is not.
    fn quotient(&mut self, sheet: &Sheet) -> Rewritten {
        let [a, b, _] = self.graph.node(sheet.g).args;
        if self.graph.op(sheet.g) != Op::Div {
            return None;
        }
        let sign = if self.graph.is_positive(b) { sheet.sign } else { Sign::Unrelated };
        let mut part = Sheet { g: a, sign, ..sheet.clone() };
        self.exclude_zero(&mut part, b);
        Some(("a quotient is 0 where its numerator is 0", vec![part]))
    }

    /// exp(u) − exp(v) and exp(u) − c: the exponential is increasing.
    fn exponential(&mut self, sheet: &Sheet) -> Rewritten {
        let [a, b, _] = self.graph.node(sheet.g).args;
        let exponent = |id: NodeId| (self.graph.op(id) == Op::Exp).then(|| self.graph.args(id)[0]);
        let (u, v, sign) = match self.graph.op(sheet.g) {
            Op::Sub => match (exponent(a), exponent(b)) {
                (Some(u), Some(v)) => (u, Some(v), sheet.sign),
                (None, Some(v)) if self.graph.constant(a)?.is_one() => (v, None, sheet.sign.flipped()),
                _ => return None,
            },
            Op::Add if *self.graph.constant(b)? == Rational::from_integer(-1) => (exponent(a)?, None, sheet.sign),
            _ => return None,
        };
        let g = match v {
            Some(v) => self.graph.apply(Op::Sub, &[u, v]),
            None => u,
        };
        Some(("exp(u) = exp(v) where u = v", vec![Sheet { g, sign, ..sheet.clone() }]))
    }

    /// A sum of quotients over one denominator.
    fn fractions_together(&mut self, sheet: &Sheet) -> Rewritten {
        let fraction = fraction::together(self.graph, sheet.g)?;
        let mut part = Sheet { g: fraction.numerator, sign: Sign::Unrelated, ..sheet.clone() };
        for denominator in fraction.denominators {
            self.exclude_zero(&mut part, denominator);
        }
        Some(("fractions over one denominator", vec![part]))
    }

    /// An expanded polynomial with a repeated factor, as the product of its square-free factors.
    fn repeated_factors(&mut self, sheet: &Sheet) -> Rewritten {
        if !matches!(self.graph.op(sheet.g), Op::Add | Op::Sub) {
            return None;
        }
        let g = exponentials::as_powers(self.graph, sheet.g).unwrap_or(sheet.g);
        if !modular::may_have_repeated_factor(self.graph, g) {
            return None;
        }
        let mut letters = Letters::default();
        let (p, _) = expand::expanded(self.graph, g, &mut letters)?;
        let factors = divisor::square_free_factors(&p)?;
        if factors.iter().all(|(_, n)| *n == 1) {
            return None;
        }
        let opposite = p.content() < num_bigint::BigInt::ZERO;
        let mut parts = Vec::new();
        for (factor, n) in &factors {
            let g = expand::node_of(self.graph, factor, &letters)?;
            let sign = match (factors.len(), n % 2, opposite) {
                (1, 1, false) => sheet.sign,
                (1, 1, true) => sheet.sign.flipped(),
                _ => Sign::Unrelated,
            };
            let mut part = Sheet { g, sign, ..sheet.clone() };
            for &letter in &letters.nodes {
                self.guard(&mut part, letter);
            }
            parts.push(part);
        }
        Some(("square-free factors of an expanded polynomial", parts))
    }

    /// A polynomial that lies far from the origin, written about its own centre.
    fn about_centre(&mut self, sheet: &Sheet) -> Rewritten {
        let (g, letters) = centre::about_centre(self.graph, sheet.g)?;
        let mut part = Sheet { g, ..sheet.clone() };
        for letter in letters {
            self.guard(&mut part, letter);
        }
        Some(("a polynomial about its centre", vec![part]))
    }

    /// Demands that a node has a value: its parts that can fail, unless they are known or implied.
    fn guard(&self, sheet: &mut Sheet, node: NodeId) {
        let mut open = vec![node];
        while let Some(node) = open.pop() {
            if self.graph.is_total(node) || requires(self.graph, sheet.g, node) {
                continue;
            }
            if matches!(self.graph.op(node), Op::Add | Op::Sub | Op::Mul | Op::Neg | Op::Abs | Op::Power(1..)) {
                open.extend_from_slice(self.graph.args(node));
            } else if !sheet.guards.contains(&node) && !sheet.nonzero.contains(&node) {
                sheet.guards.push(node);
            }
        }
    }

    /// Demands that a node has a value that is not 0, unless that is known.
    fn exclude_zero(&self, sheet: &mut Sheet, node: NodeId) {
        if self.graph.is_nonzero(node) {
            self.guard(sheet, node);
        } else if !sheet.nonzero.contains(&node) {
            sheet.nonzero.push(node);
        }
    }

    /// The sheet without the factors of g that are factors of a denominator; none if nothing is left.
    fn without_roots_of_denominators(&mut self, sheet: Sheet) -> Option<Sheet> {
        let mut sheet = sheet;
        for i in 0..sheet.nonzero.len() {
            let denominator = sheet.nonzero[i];
            if zero_with(self.graph, denominator) == zero_with(self.graph, sheet.g) {
                self.steps.push(Step { name: "the denominator is 0 there", from: sheet.g, to: Vec::new() });
                return None;
            }
            let Some(g) = self.divided(sheet.g, denominator) else { continue };
            let to = if self.graph.constant(g).is_some() { Vec::new() } else { vec![g] };
            let gone = to.is_empty();
            self.steps.push(Step { name: "the denominator is 0 there", from: sheet.g, to });
            if gone {
                return None;
            }
            let before = std::mem::replace(&mut sheet.g, g);
            sheet.sign = Sign::Unrelated;
            self.guard(&mut sheet, before);
        }
        Some(sheet)
    }

    /// g without the factors that it shares with the denominator, if there are any.
    fn divided(&mut self, g: NodeId, denominator: NodeId) -> Option<NodeId> {
        if !modular::may_have_common_factor(self.graph, g, denominator) {
            return None;
        }
        let mut letters = Letters::default();
        let (p, _) = expand::expanded(self.graph, g, &mut letters)?;
        let (q, _) = expand::expanded(self.graph, denominator, &mut letters)?;
        let rest = divisor::coprime_part(&p, &q)?;
        if rest == p.primitive() {
            return None;
        }
        expand::node_of(self.graph, &rest, &letters)
    }
}

/// A simpler node that is 0 at least wherever this one is, and has no other zeros where this one has a value.
fn zero_with(graph: &Graph, mut id: NodeId) -> NodeId {
    while let Op::Abs | Op::Neg | Op::Sqrt | Op::Root(_) | Op::Power(1..) = graph.op(id) {
        id = graph.args(id)[0];
    }
    id
}

/// Whether g surely has no value where the node has none: the node is g, or an argument that is always needed.
fn requires(graph: &Graph, g: NodeId, node: NodeId) -> bool {
    /// Deep enough for a factor in a sum of terms; a bound on the cost.
    const DEPTH: usize = 6;
    let mut level = vec![g];
    for _ in 0..DEPTH {
        if level.contains(&node) {
            return true;
        }
        level =
            level.iter().filter(|id| graph.op(**id) != Op::Choose).flat_map(|id| graph.args(*id)).copied().collect();
        if level.len() > 64 {
            return false;
        }
    }
    false
}
