//! Sets of points: comparisons, `and or not`, unions, and the choice by a condition.
//!
//! In: numbers and regions. Out: for each region a function that is negative inside, which is what is drawn, and
//! what is needed to decide a point on the boundary exactly, which is what `if` asks for.

use super::values::{Placed, Value};
use super::{Lowerer, Reporting};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::expr::op::Op;
use crate::syntax::ast::{Comparison, Expr};

/// A set of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Region {
    /// The function that is negative inside and positive outside.
    pub side: NodeId,
    /// Which points where `side` is 0 belong to the set.
    pub edge: Edge,
}

/// Whether a region's boundary belongs to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Edge {
    /// The set is side ≤ 0.
    Closed,
    /// The set is side < 0.
    Open,
    /// The set is where this node is ≤ 0: parts of the boundary belong to it and parts do not.
    Mixed(NodeId),
}

impl<'a> Lowerer<'a> {
    /// The region, or an error that says what stands there.
    pub(super) fn wanted_region(&mut self, placed: Placed) -> Reporting<Region> {
        match placed.value {
            Value::Region(region) => Ok(region),
            other => {
                let message = format!("{} stands where a region is wanted", other.kind());
                let help = "a region is a comparison such as `x^2 + y^2 <= 1`";
                Err(self.report(Diagnostic::error(placed.span, message).help(help)))
            }
        }
    }

    /// `a <= b < c`.
    pub(super) fn chain(&mut self, operands: &'a [Expr], comparisons: &[Comparison], span: Span) -> Reporting<Value> {
        let mut nodes = Vec::with_capacity(operands.len());
        for operand in operands {
            nodes.push(self.number(operand));
        }
        let nodes = nodes.into_iter().collect::<Reporting<Vec<NodeId>>>()?;
        let mut whole: Option<Region> = None;
        for (pair, comparison) in nodes.windows(2).zip(comparisons) {
            let part = self.comparison(pair[0], *comparison, pair[1], span);
            whole = Some(match whole {
                None => part,
                Some(before) => self.both(before, part, span),
            });
        }
        match whole {
            Some(region) => Ok(Value::Region(region)),
            None => Err(self.report(Diagnostic::error(span, "a comparison needs two sides"))),
        }
    }

    fn comparison(&mut self, left: NodeId, comparison: Comparison, right: NodeId, span: Span) -> Region {
        let (low, high, edge) = match comparison {
            Comparison::Less => (left, right, Edge::Open),
            Comparison::LessEqual => (left, right, Edge::Closed),
            Comparison::Greater => (right, left, Edge::Open),
            Comparison::GreaterEqual => (right, left, Edge::Closed),
        };
        Region { side: self.node(Op::Sub, &[low, high], span), edge }
    }

    /// The points of both: max(a, b).
    pub(super) fn both(&mut self, a: Region, b: Region, span: Span) -> Region {
        self.join(Op::Max, a, b, span)
    }

    /// The points of either: min(a, b).
    pub(super) fn either(&mut self, a: Region, b: Region, span: Span) -> Region {
        self.join(Op::Min, a, b, span)
    }

    fn join(&mut self, op: Op, a: Region, b: Region, span: Span) -> Region {
        let side = self.node(op, &[a.side, b.side], span);
        let edge = match (a.edge, b.edge) {
            (Edge::Closed, Edge::Closed) => Edge::Closed,
            (Edge::Open, Edge::Open) => Edge::Open,
            _ => {
                let (a, b) = (self.indicator(a, span), self.indicator(b, span));
                Edge::Mixed(self.node(op, &[a, b], span))
            }
        };
        Region { side, edge }
    }

    /// The points outside: −a.
    pub(super) fn outside(&mut self, a: Region, span: Span) -> Region {
        let side = self.node(Op::Neg, &[a.side], span);
        let edge = match a.edge {
            Edge::Closed => Edge::Open,
            Edge::Open => Edge::Closed,
            Edge::Mixed(indicator) => {
                let (no, yes) = (self.integer(1, span), self.integer(-1, span));
                Edge::Mixed(self.node(Op::Choose, &[indicator, no, yes], span))
            }
        };
        Region { side, edge }
    }

    /// A node that is ≤ 0 exactly at the points of the region.
    fn indicator(&mut self, region: Region, span: Span) -> NodeId {
        match region.edge {
            Edge::Closed => region.side,
            Edge::Mixed(indicator) => indicator,
            Edge::Open => {
                let outside = self.node(Op::Neg, &[region.side], span);
                let (no, yes) = (self.integer(1, span), self.integer(-1, span));
                self.node(Op::Choose, &[outside, no, yes], span)
            }
        }
    }

    /// The number that is `yes` at the points of the region and `no` elsewhere.
    pub(super) fn choose(&mut self, region: Region, yes: NodeId, no: NodeId, span: Span) -> NodeId {
        match region.edge {
            Edge::Closed => self.node(Op::Choose, &[region.side, yes, no], span),
            Edge::Mixed(indicator) => self.node(Op::Choose, &[indicator, yes, no], span),
            Edge::Open => {
                let outside = self.node(Op::Neg, &[region.side], span);
                self.node(Op::Choose, &[outside, no, yes], span)
            }
        }
    }

    /// `if(condition, yes, no)`.
    pub(super) fn conditional(&mut self, args: Vec<Placed>, span: Span) -> Reporting<Value> {
        let Ok([condition, yes, no]) = <[Placed; 3]>::try_from(args) else {
            return super::values::reported();
        };
        let region = match condition.value {
            Value::Region(region) => region,
            other => {
                let message = format!("the condition of `if` is {}, not a region", other.kind());
                let help = "a condition is a comparison such as `x < 0`";
                return Err(self.report(Diagnostic::error(condition.span, message).help(help)));
            }
        };
        match (&yes.value, &no.value) {
            (Value::Number(a), Value::Number(b)) => Ok(Value::Number(self.choose(region, *a, *b, span))),
            (Value::Region(a), Value::Region(b)) => Ok(Value::Region(self.choose_region(region, *a, *b, span))),
            (Value::Vector(a), Value::Vector(b)) => {
                self.same_length(a.len(), b.len(), &yes, &no, span)?;
                Ok(Value::Vector(a.iter().zip(b).map(|(&a, &b)| self.choose(region, a, b, span)).collect()))
            }
            (a, b) => {
                let error = Diagnostic::error(span, "the two branches of `if` are not of one kind");
                let error = error.also(yes.span, format!("this is {}", a.kind()));
                let error = error.also(no.span, format!("this is {}", b.kind()));
                Err(self.report(error.help("both are numbers, both are vectors or both are regions")))
            }
        }
    }

    fn choose_region(&mut self, condition: Region, yes: Region, no: Region, span: Span) -> Region {
        let side = self.choose(condition, yes.side, no.side, span);
        let edge = match (yes.edge, no.edge) {
            (Edge::Closed, Edge::Closed) => Edge::Closed,
            (Edge::Open, Edge::Open) => Edge::Open,
            _ => {
                let (yes, no) = (self.indicator(yes, span), self.indicator(no, span));
                Edge::Mixed(self.choose(condition, yes, no, span))
            }
        };
        Region { side, edge }
    }

    /// `union`, `intersection`, `difference` of regions, or of numbers that are negative inside.
    pub(super) fn combine(&mut self, combination: Combination, args: Vec<Placed>, span: Span) -> Reporting<Value> {
        let numbers = self.one_kind(&args, span)?;
        let mut whole: Option<Region> = None;
        for placed in args {
            let part = match placed.value {
                Value::Number(side) => Region { side, edge: Edge::Closed },
                _ => self.wanted_region(placed)?,
            };
            whole = Some(match whole {
                None => part,
                Some(before) => self.combined(combination, before, part, span),
            });
        }
        match whole {
            Some(region) if numbers => Ok(Value::Number(region.side)),
            Some(region) => Ok(Value::Region(region)),
            None => super::values::reported(),
        }
    }

    fn combined(&mut self, combination: Combination, before: Region, part: Region, span: Span) -> Region {
        match combination {
            Combination::Union => self.either(before, part, span),
            Combination::Intersection => self.both(before, part, span),
            Combination::Difference => {
                let outside = self.outside(part, span);
                self.both(before, outside, span)
            }
            Combination::SmoothUnion(radius) => {
                let side = self.smooth_minimum(radius, before.side, part.side, span);
                Region { side, edge: Edge::Closed }
            }
        }
    }

    /// min(a, b) − max(k − |a − b|, 0)²/(4k): the quadratic polynomial blend (Quílez, "smooth minimum").
    fn smooth_minimum(&mut self, k: NodeId, a: NodeId, b: NodeId, span: Span) -> NodeId {
        let smaller = self.node(Op::Min, &[a, b], span);
        let gap = self.node(Op::Sub, &[a, b], span);
        let gap = self.node(Op::Abs, &[gap], span);
        let reach = self.node(Op::Sub, &[k, gap], span);
        let zero = self.integer(0, span);
        let reach = self.node(Op::Max, &[reach, zero], span);
        let square = self.integer_power(reach, 2, span);
        let four = self.integer(4, span);
        let scale = self.node(Op::Mul, &[four, k], span);
        let blend = self.node(Op::Div, &[square, scale], span);
        self.node(Op::Sub, &[smaller, blend], span)
    }

    /// Whether all are numbers; refuses a mixture with regions.
    fn one_kind(&mut self, args: &[Placed], span: Span) -> Reporting<bool> {
        let number = args.iter().find(|placed| matches!(placed.value, Value::Number(_)));
        let region = args.iter().find(|placed| matches!(placed.value, Value::Region(_)));
        match (number, region) {
            (Some(number), Some(region)) => {
                let error = Diagnostic::error(span, "regions and numbers cannot be combined");
                let error = error.also(number.span, "this is a number").also(region.span, "this is a region");
                Err(self.report(error.help("compare the number: `f <= 0` is the region where f is not positive")))
            }
            (number, _) => Ok(number.is_some()),
        }
    }
}

/// How two sets become one.
#[derive(Clone, Copy, Debug)]
pub(super) enum Combination {
    /// Points of either.
    Union,
    /// Points of both.
    Intersection,
    /// Points of the first and of no other.
    Difference,
    /// Points of either, with the crease rounded over this width.
    SmoothUnion(NodeId),
}
