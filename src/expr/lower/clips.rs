//! Clips: the parts of space to which something is cut.
//!
//! In: the value behind `clip`. Out: a box, a ball, or a region's function. Separate because surfaces and the render block
//! have the same clips.

use super::values::Value;
use super::{Lowerer, Reporting};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::syntax::ast::{Attribute, AttributeValue, Expr, ExprKind};

/// A part of space to which something is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip {
    /// Which part.
    pub shape: ClipShape,
    /// The place of the value.
    pub span: Span,
}

/// The kinds of clips.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClipShape {
    /// `box(x0..x1, y0..y1, z0..z1)`, each low < high.
    Box {
        /// The least x, y, z.
        low: [f64; 3],
        /// The greatest.
        high: [f64; 3],
    },
    /// `ball(x, y, z, r)`, r > 0.
    Ball {
        /// The centre.
        centre: [f64; 3],
        /// The radius.
        radius: f64,
    },
    /// Any region: where this node is negative.
    Region(NodeId),
}

impl<'a> Lowerer<'a> {
    /// The clip behind a key.
    pub(super) fn clip(&mut self, attribute: &'a Attribute) -> Reporting<Clip> {
        match &attribute.value {
            AttributeValue::Box(ranges, span) => {
                let shape = self.box_of_ranges(ranges, *span)?;
                Ok(Clip { shape, span: *span })
            }
            AttributeValue::Expr(expr) => {
                let shape = match &expr.kind {
                    ExprKind::Call(name, args) if name.text == "ball" => self.ball(args, expr.span)?,
                    _ => match self.expr(expr)? {
                        Value::Region(region) => {
                            self.check_graph_depth(region.side, expr.span)?;
                            ClipShape::Region(region.side)
                        }
                        _ => return self.wrong_value(attribute, "a box, a ball or a region", "ball(0, 0, 0, 2)"),
                    },
                };
                Ok(Clip { shape, span: expr.span })
            }
            _ => self.wrong_value(attribute, "a box, a ball or a region", "ball(0, 0, 0, 2)"),
        }
    }

    fn box_of_ranges(&mut self, ranges: &'a [(Expr, Expr)], span: Span) -> Reporting<ClipShape> {
        if ranges.len() != 3 {
            let message = format!("a box has three ranges, and this has {}", ranges.len());
            return Err(self.report(Diagnostic::error(span, message).help("write `box(-2..2, -2..2, -2..2)`")));
        }
        let (mut least, mut greatest) = ([0.0; 3], [0.0; 3]);
        for (axis, (low, high)) in ranges.iter().enumerate() {
            let (a, b) = (self.known_number(low, "an end of a range"), self.known_number(high, "an end of a range"));
            (least[axis], greatest[axis]) = (a?, b?);
            if least[axis] >= greatest[axis] {
                let message = format!("the range {}..{} is empty", least[axis], greatest[axis]);
                let error = Diagnostic::error(low.span.to(high.span), message);
                return Err(self.report(error.help("the lower end comes first")));
            }
        }
        Ok(ClipShape::Box { low: least, high: greatest })
    }

    fn ball(&mut self, args: &'a [Expr], span: Span) -> Reporting<ClipShape> {
        let [x, y, z, r] = args else {
            let message = format!("a ball has four numbers, and this has {}", args.len());
            return Err(self.report(Diagnostic::error(span, message).help("it is `ball(x, y, z, radius)`")));
        };
        let centre = [x, y, z].map(|expr| self.known_number(expr, "the centre of a ball"));
        let radius = self.known_number(r, "the radius of a ball")?;
        if radius <= 0.0 {
            return Err(self.report(Diagnostic::error(r.span, "the radius of a ball is more than 0")));
        }
        Ok(ClipShape::Ball { centre: [centre[0]?, centre[1]?, centre[2]?], radius })
    }
}
