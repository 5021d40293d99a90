//! Colours and numbers that change from point to point of a surface, and the words that stand for the surface itself.
//!
//! In: formulas, `rgb(…)` of formulas, `palette`, `checker`, `mix`, `every`. Out: a tree of colours over nodes. The surface's normal and
//! curvatures are nodes too, by the derivatives of its own equation as rewritten, so that what is made of them is exact.

use super::paints::{Amount, Color, Paint, is_color};
use super::surfaces::Kind;
use super::{Lowerer, Reporting, colours, cut};
use crate::diag::{Diagnostic, Span, nearest, one_of};
use crate::expr::graph::NodeId;
use crate::expr::op::Op;
use crate::expr::{curvature, equation};
use crate::syntax::ast::{Attribute, AttributeValue, Expr, ExprKind, Name};
use crate::syntax::functions::PAINTS;

/// The maps of colours that `palette` knows.
pub const PALETTES: [&str; 12] = [
    "viridis",
    "magma",
    "inferno",
    "plasma",
    "cividis",
    "turbo",
    "greys",
    "blues",
    "reds",
    "spectral",
    "red_blue",
    "purple_green",
];

/// Contour lines as they were written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lines {
    /// Of what.
    pub value: NodeId,
    /// How fast it changes along the surface.
    pub slope: NodeId,
    /// From line to line, > 0.
    pub step: f64,
    /// How wide a line is on the surface, > 0; `None`: as fits the picture.
    pub width: Option<f64>,
}

/// A checker's cubes begin a 4096th of their size before 0: where a surface lies in a plane of coordinates, rounding would else
/// decide between two colours at every point.
const CHECKER_SHIFT: (i64, i64) = (1, 4096);

/// The surface whose matter is read.
#[derive(Clone, Copy, Debug)]
pub(super) struct Field {
    f: NodeId,
    kind: Kind,
    /// Its equation as rewritten, once it was asked for.
    g: Option<NodeId>,
}

impl Field {
    pub(super) fn new(f: NodeId, kind: Kind) -> Self {
        Field { f, kind, g: None }
    }
}

impl<'a> Lowerer<'a> {
    /// `nx`, `ny`, `nz`, `mean` or `gauss` of the surface at hand.
    pub(super) fn of_surface(&mut self, name: &str) -> Reporting<NodeId> {
        let Some(g) = self.rewritten() else { return super::values::reported() };
        let node = match name {
            "mean" => curvature::mean(&mut self.graph, g),
            "gauss" => curvature::gauss(&mut self.graph, g),
            _ => curvature::normal(&mut self.graph, g)[["nx", "ny", "nz"].iter().position(|n| *n == name).unwrap_or(0)],
        };
        Ok(node)
    }

    /// The function of the surface at hand as rewritten, with the sign that f has: of several factors their product.
    fn rewritten(&mut self) -> Option<NodeId> {
        let field = self.field?;
        if let Some(g) = field.g {
            return Some(g);
        }
        let g = match field.kind {
            Kind::Solid | Kind::Number => field.f,
            Kind::Equation => equation::whole(&mut self.graph, field.f),
        };
        self.field = Some(Field { g: Some(g), ..field });
        Some(g)
    }

    /// A colour that may change from point to point.
    pub(super) fn paint(&mut self, attribute: &'a Attribute, amount: Amount) -> Reporting<Paint> {
        self.paint_of(attribute, &attribute.value, amount, false)
    }

    /// The same, or a number that is its grey.
    pub(super) fn paint_or_grey(&mut self, attribute: &'a Attribute, amount: Amount) -> Reporting<Paint> {
        self.paint_of(attribute, &attribute.value, amount, true)
    }

    /// A number of 0..=1 that may change from point to point.
    pub(super) fn share(&mut self, attribute: &'a Attribute) -> Reporting<Paint> {
        let AttributeValue::Expr(expr) = &attribute.value else {
            return self.wrong_value(attribute, "a number from 0 to 1", "0.3");
        };
        match self.formula_or_number(attribute, expr)? {
            Number::Varying(node) => Ok(Paint::Rgb([node; 3])),
            Number::Known(value) if (0.0..=1.0).contains(&value) => Ok(grey(value)),
            Number::Known(_) => self.wrong_value(attribute, "a number from 0 to 1", "0.3"),
        }
    }

    fn paint_of(
        &mut self,
        attribute: &'a Attribute,
        value: &'a AttributeValue,
        amount: Amount,
        allows_grey: bool,
    ) -> Reporting<Paint> {
        match value {
            AttributeValue::Color(srgb, _) => Ok(Paint::Plain(Color::Srgb(*srgb))),
            AttributeValue::Text(name, span) => self.named_color(name, *span).map(Paint::Plain),
            AttributeValue::Call(name, arguments, span) => self.paint_call(attribute, (name, arguments, *span), amount),
            AttributeValue::Expr(expr) => match &expr.kind {
                ExprKind::Call(name, args) if is_color(&name.text) => {
                    self.color_of_parts(&name.text, args, amount, expr.span)
                }
                ExprKind::Name(name) if colours::named(name).is_some() || !self.is_value(name) => {
                    self.named_color(name, expr.span).map(Paint::Plain)
                }
                ExprKind::Invalid => super::values::reported(),
                _ if allows_grey => self.grey(attribute, expr, amount),
                _ => self.number_for_color(attribute, expr),
            },
            AttributeValue::Size(_, _, span) | AttributeValue::Box(_, span) => self.no_color(attribute, *span),
        }
    }

    /// A number where a colour is wanted: which grey it may mean is shown, as sRGB and linear light have different ones.
    fn number_for_color(&mut self, attribute: &'a Attribute, expr: &'a Expr) -> Reporting<Paint> {
        match self.formula_or_number(attribute, expr)? {
            Number::Known(value) if (0.0..=1.0).contains(&value) => {
                let error = Diagnostic::error(expr.span, format!("`{}` wants a colour", attribute.key.text));
                let grey = format!("rgb({value}, {value}, {value})");
                Err(self
                    .report(error.help(format!("for a grey that sends back this share of the light write `{grey}`"))))
            }
            Number::Known(_) | Number::Varying(_) => self.no_color(attribute, expr.span),
        }
    }

    fn no_color(&mut self, attribute: &Attribute, span: Span) -> Reporting<Paint> {
        let error = Diagnostic::error(span, format!("`{}` wants a colour", attribute.key.text));
        Err(self.report(error.help("write `#4af`, `orange`, `rgb(1, 0.5, 0)` or `palette(\"viridis\", z)`")))
    }

    fn grey(&mut self, attribute: &'a Attribute, expr: &'a Expr, amount: Amount) -> Reporting<Paint> {
        match (self.formula_or_number(attribute, expr)?, amount) {
            (Number::Varying(node), _) => Ok(Paint::Rgb([node; 3])),
            (Number::Known(value), Amount::Light) if value >= 0.0 => Ok(grey(value)),
            (Number::Known(value), Amount::Share) if (0.0..=1.0).contains(&value) => Ok(grey(value)),
            (_, Amount::Light) => self.wrong_value(attribute, "a number that is not negative, or a colour", "0.5"),
            (_, Amount::Share) => self.wrong_value(attribute, "a number from 0 to 1, or a colour", "0.5"),
        }
    }

    fn formula_or_number(&mut self, attribute: &'a Attribute, expr: &'a Expr) -> Reporting<Number> {
        let node = self.number(expr)?;
        if self.constant_value(node).is_none() {
            return Ok(Number::Varying(node));
        }
        self.known(node, expr.span, &format!("`{}`", attribute.key.text)).map(Number::Known)
    }

    /// `palette(…)`, `checker(…)`, `mix(…)`.
    fn paint_call(
        &mut self,
        attribute: &'a Attribute,
        (name, arguments, span): (&'a Name, &'a [AttributeValue], Span),
        amount: Amount,
    ) -> Reporting<Paint> {
        match (name.text.as_str(), arguments) {
            ("palette", [map, value]) => {
                let (map, place) = (self.palette(map), self.argument_number(value));
                Ok(Paint::Palette(map?, place?))
            }
            ("palette", [map, value, low, high]) => {
                let map = self.palette(map);
                let [value, low, high] = [value, low, high].map(|argument| self.argument_number(argument));
                let (value, low, high) = (value?, low?, high?);
                let (risen, range) = (self.node(Op::Sub, &[value, low], span), self.node(Op::Sub, &[high, low], span));
                Ok(Paint::Palette(map?, self.node(Op::Div, &[risen, range], span)))
            }
            ("checker", [size, a, b]) => {
                let coordinates = self.coordinates(span);
                self.checker(attribute, size, [a, b], &coordinates, amount, span)
            }
            ("checker", [size, a, b, u, v]) => {
                let [u, v] = [u, v].map(|argument| self.argument_number(argument));
                self.checker(attribute, size, [a, b], &[u?, v?], amount, span)
            }
            ("mix", [a, b, t]) => {
                let [a, b] = [a, b].map(|color| self.paint_of(attribute, color, amount, false));
                let t = self.argument_number(t)?;
                Ok(Paint::Mix(Box::new(a?), Box::new(b?), t))
            }
            ("every", _) => {
                let error = Diagnostic::error(span, "`every` draws lines and is no colour");
                Err(self.report(error.help("write `lines: every(0.25, z)` beside `color`")))
            }
            _ => self.wrong_arguments(name, arguments.len(), span),
        }
    }

    fn wrong_arguments<T>(&mut self, name: &Name, found: usize, span: Span) -> Reporting<T> {
        let signature = PAINTS.iter().find(|known| known.name == name.text).map_or("", |known| known.signature);
        let signature = signature.replace(" or ", "` or `");
        let message = format!("`{}` was given {found} argument{}", name.text, if found == 1 { "" } else { "s" });
        Err(self.report(Diagnostic::error(span, message).help(format!("it is `{signature}`"))))
    }

    /// One of [`PALETTES`].
    fn palette(&mut self, value: &'a AttributeValue) -> Reporting<&'static str> {
        let (AttributeValue::Text(name, span) | AttributeValue::Expr(Expr { kind: ExprKind::Name(name), span })) =
            value
        else {
            let error = Diagnostic::error(super::entries::place(value), "`palette` wants the name of a map first");
            return Err(self.report(error.help(format!("there are {}", one_of(&PALETTES)))));
        };
        if let Some(known) = PALETTES.into_iter().find(|known| known == name) {
            return Ok(known);
        }
        let help = match nearest(name, PALETTES).first() {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("there are {}", one_of(&PALETTES)),
        };
        Err(self.report(Diagnostic::error(*span, format!("there is no palette `{}`", cut(name))).help(help)))
    }

    fn argument_number(&mut self, value: &'a AttributeValue) -> Reporting<NodeId> {
        match value {
            AttributeValue::Expr(Expr { kind: ExprKind::Name(name), span })
                if colours::named(name).is_some() && !self.is_value(name) =>
            {
                self.no_number(*span)
            }
            AttributeValue::Expr(expr) => self.number(expr),
            other => self.no_number(super::entries::place(other)),
        }
    }

    fn no_number(&mut self, span: Span) -> Reporting<NodeId> {
        let error = Diagnostic::error(span, "a colour stands where a number is wanted");
        Err(self.report(error.help("write a formula such as `z` or `2*r`")))
    }

    fn checker(
        &mut self,
        attribute: &'a Attribute,
        size: &'a AttributeValue,
        [a, b]: [&'a AttributeValue; 2],
        coordinates: &[NodeId],
        amount: Amount,
        span: Span,
    ) -> Reporting<Paint> {
        let size = self.more_than_zero(size, "the size of a checker");
        let [a, b] = [a, b].map(|color| self.paint_of(attribute, color, amount, false));
        let size = size?;
        let shift = self.quotient(CHECKER_SHIFT.0, CHECKER_SHIFT.1, span);
        let mut steps = Vec::with_capacity(coordinates.len());
        for &coordinate in coordinates {
            let scaled = self.node(Op::Div, &[coordinate, size], span);
            let shifted = self.node(Op::Add, &[scaled, shift], span);
            steps.push(self.node(Op::Floor, &[shifted], span));
        }
        let count = self.fold(Op::Add, &steps, span);
        let two = self.integer(2, span);
        let parity = self.modulo(count, two, span);
        Ok(Paint::Mix(Box::new(a?), Box::new(b?), parity))
    }

    /// A number > 0 that is known before drawing.
    fn more_than_zero(&mut self, value: &'a AttributeValue, what: &str) -> Reporting<NodeId> {
        let node = self.argument_number(value)?;
        let span = super::entries::place(value);
        if self.known(node, span, what)? > 0.0 {
            return Ok(node);
        }
        Err(self.report(Diagnostic::error(span, format!("{what} is more than 0"))))
    }

    /// `every(step, f)` or `every(step, f, width)`.
    pub(super) fn lines(&mut self, attribute: &'a Attribute) -> Reporting<Lines> {
        let AttributeValue::Call(name, arguments, span) = &attribute.value else {
            return self.wrong_value(attribute, "lines", "every(0.25, z)");
        };
        let (step, value, width) = match (name.text.as_str(), &arguments[..]) {
            ("every", [step, value]) => (step, value, None),
            ("every", [step, value, width]) => (step, value, Some(width)),
            ("every", _) => return self.wrong_arguments(name, arguments.len(), *span),
            _ => return self.wrong_value(attribute, "lines", "every(0.25, z)"),
        };
        let known = |lowerer: &mut Self, value: &'a AttributeValue, what: &str| {
            let node = lowerer.more_than_zero(value, what)?;
            lowerer.known(node, super::entries::place(value), what)
        };
        let step = known(self, step, "the step from line to line");
        let width = width.map(|width| known(self, width, "the width of a line")).transpose();
        let value = self.argument_number(value)?;
        let Some(g) = self.rewritten() else { return super::values::reported() };
        let slope = curvature::slope_along(&mut self.graph, value, g);
        Ok(Lines { value, slope, step: step?, width: width? })
    }
}

/// A number, or a formula.
enum Number {
    Known(f64),
    Varying(NodeId),
}

fn grey(value: f64) -> Paint {
    Paint::Plain(Color::Linear([value; 3]))
}
