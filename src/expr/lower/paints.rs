//! Colours as values of entries.
//!
//! In: `#4af`, `red`, `rgb(1, 0.5, 0)`, `hsl(30, 1, 0.5)`; where a number stands for grey, a number. Out: a colour as it was
//! written. Separate from the table of names.

use super::{Lowerer, Reporting, colours, cut};
use crate::diag::{Diagnostic, Span, nearest};
use crate::expr::graph::NodeId;
use crate::syntax::ast::{Attribute, AttributeValue, Expr, ExprKind};
use crate::syntax::functions::OF_SURFACE;
use crate::syntax::{CONSTANTS, READY};

/// A colour as it was written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Color {
    /// Red, green, blue of 0..=255, sRGB: `#rgb`, `#rrggbb`, `red`.
    Srgb([u8; 3]),
    /// Linear red, green, blue: `rgb(1, 0.5, 0)`.
    Linear([f64; 3]),
}

/// A colour or a number at every point of a surface, as it was written.
#[derive(Clone, Debug, PartialEq)]
pub enum Paint {
    /// The same everywhere; a number stands in all three parts.
    Plain(Color),
    /// Linear red, green, blue.
    Rgb([NodeId; 3]),
    /// Hue in degrees, saturation, lightness.
    Hsl([NodeId; 3]),
    /// Hue in degrees, saturation, value.
    Hsv([NodeId; 3]),
    /// The colour of a map of [`super::PALETTES`] at a place of 0..=1.
    Palette(&'static str, NodeId),
    /// The first where the number is <= 0, the second where it is >= 1, in between a mixture.
    Mix(Box<Paint>, Box<Paint>, NodeId),
}

/// What the parts of a colour may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Amount {
    /// A share of light: of 0..=1.
    Share,
    /// Light, or what it is multiplied by: >= 0.
    Light,
}

impl<'a> Lowerer<'a> {
    /// A colour.
    pub(super) fn color(&mut self, attribute: &'a Attribute, amount: Amount) -> Reporting<Color> {
        match &attribute.value {
            AttributeValue::Color(srgb, _) => Ok(Color::Srgb(*srgb)),
            AttributeValue::Text(name, span) => self.named_color(name, *span),
            AttributeValue::Expr(expr) => match &expr.kind {
                ExprKind::Name(name) => self.named_color(name, expr.span),
                ExprKind::Call(name, args) if is_color(&name.text) => {
                    match self.color_of_parts(&name.text, args, amount, expr.span)? {
                        Paint::Plain(color) => Ok(color),
                        _ => self.wrong_value(attribute, "a colour that is the same everywhere", "#4af"),
                    }
                }
                _ => self.wrong_value(attribute, "a colour", "#4af"),
            },
            AttributeValue::Call(..) => self.wrong_value(attribute, "a colour that is the same everywhere", "#4af"),
            _ => self.wrong_value(attribute, "a colour", "#4af"),
        }
    }

    /// A colour, or a number that is its grey.
    pub(super) fn color_or_grey(&mut self, attribute: &'a Attribute, amount: Amount) -> Reporting<Color> {
        let AttributeValue::Expr(expr) = &attribute.value else { return self.color(attribute, amount) };
        let is_color = match &expr.kind {
            ExprKind::Name(name) => colours::named(name).is_some() || !self.is_value(name),
            ExprKind::Call(name, _) => is_color(&name.text),
            _ => false,
        };
        if is_color {
            return self.color(attribute, amount);
        }
        let grey = self.known_number(expr, &format!("`{}`", attribute.key.text))?;
        let is_allowed = match amount {
            Amount::Share => (0.0..=1.0).contains(&grey),
            Amount::Light => grey >= 0.0,
        };
        if is_allowed {
            return Ok(Color::Linear([grey; 3]));
        }
        let wanted = match amount {
            Amount::Share => "a number from 0 to 1, or a colour",
            Amount::Light => "a number that is not negative, or a colour",
        };
        self.wrong_value(attribute, wanted, "0.5")
    }

    /// Whether a bare word is a value of the program or of the language, and not a colour.
    pub(super) fn is_value(&self, name: &str) -> bool {
        let is_coordinate = COORDINATES.contains(&name) || READY.contains(&name) && name != "p";
        let is_of_surface = self.field.is_some() && OF_SURFACE.contains(&name);
        self.names.find(name).is_some() || CONSTANTS.contains(&name) || is_coordinate || is_of_surface
    }

    /// The colour of a name.
    pub(super) fn named_color(&mut self, name: &str, span: Span) -> Reporting<Color> {
        if let Some(srgb) = colours::color_of_text(name) {
            return Ok(Color::Srgb(srgb));
        }
        let help = match nearest(name, colours::names()).first() {
            Some(near) => format!("did you mean `{near}`?"),
            None => "write a name such as `orange`, `#f80` or `rgb(1, 0.25, 0)`".to_owned(),
        };
        Err(self.report(Diagnostic::error(span, format!("there is no colour `{}`", cut(name))).help(help)))
    }

    /// `rgb(red, green, blue)`, linear; `hsl(hue, saturation, lightness)` or `hsv(hue, saturation, value)`, the hue in degrees. One
    /// colour, if all parts are known.
    pub(super) fn color_of_parts(
        &mut self,
        model: &str,
        args: &'a [Expr],
        amount: Amount,
        span: Span,
    ) -> Reporting<Paint> {
        let signature = match model {
            "rgb" => "rgb(red, green, blue)",
            "hsl" => "hsl(hue, saturation, lightness)",
            _ => "hsv(hue, saturation, value)",
        };
        let parts = self.three_parts(args, signature, span)?;
        let nodes = parts.map(|part| self.number(part));
        let nodes = [nodes[0]?, nodes[1]?, nodes[2]?];
        let mut known = [None; 3];
        for (k, part) in parts.into_iter().enumerate() {
            let amount = match (model, k) {
                ("rgb", _) => Some(amount),
                (_, 0) => None,
                _ => Some(Amount::Share),
            };
            known[k] = self.part_of_color(nodes[k], part.span, amount)?;
        }
        Ok(match (model, known) {
            ("rgb", [Some(r), Some(g), Some(b)]) => Paint::Plain(Color::Linear([r, g, b])),
            ("hsl", [Some(h), Some(s), Some(l)]) => {
                Paint::Plain(Color::Srgb(colours::bytes(colours::parts_of_lightness(h, s, l))))
            }
            (_, [Some(h), Some(s), Some(v)]) => {
                Paint::Plain(Color::Srgb(colours::bytes(colours::parts_of_value(h, s, v))))
            }
            ("rgb", _) => Paint::Rgb(nodes),
            ("hsl", _) => Paint::Hsl(nodes),
            _ => Paint::Hsv(nodes),
        })
    }

    fn three_parts(&mut self, args: &'a [Expr], signature: &str, span: Span) -> Reporting<[&'a Expr; 3]> {
        match args {
            [a, b, c] => Ok([a, b, c]),
            _ => {
                let message = format!("a colour has three numbers, and this has {}", args.len());
                Err(self.report(Diagnostic::error(span, message).help(format!("it is `{signature}`"))))
            }
        }
    }

    /// The value of a part, if it hangs on no coordinate; refused where it is too little or too much.
    fn part_of_color(&mut self, node: NodeId, span: Span, amount: Option<Amount>) -> Reporting<Option<f64>> {
        if self.constant_value(node).is_none() {
            return Ok(None);
        }
        let value = self.known(node, span, "a part of a colour")?;
        match amount {
            Some(Amount::Share) if !(0.0..=1.0).contains(&value) => {
                let error = Diagnostic::error(span, "a part of a surface's colour lies between 0 and 1");
                Err(self.report(error.help("divide by 255, or write the colour as `#ff8000`")))
            }
            Some(Amount::Light) if value < 0.0 => {
                Err(self.report(Diagnostic::error(span, "a part of a light's colour is not negative")))
            }
            _ => Ok(Some(value)),
        }
    }
}

/// Whether it makes a colour of three numbers.
pub(super) fn is_color(name: &str) -> bool {
    matches!(name, "rgb" | "hsl" | "hsv")
}

/// The coordinates, which a bare word may be.
const COORDINATES: [&str; 3] = ["x", "y", "z"];
