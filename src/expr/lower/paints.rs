//! Colours as values of entries.
//!
//! In: `#4af`, `red`, `rgb(1, 0.5, 0)`, `hsl(30, 1, 0.5)`; where a number stands for grey, a number. Out: a colour as it was
//! written. Separate from the table of names.

use super::{Lowerer, Reporting, colours, cut};
use crate::diag::{Diagnostic, Span, nearest};
use crate::syntax::CONSTANTS;
use crate::syntax::ast::{Attribute, AttributeValue, Expr, ExprKind};

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
                ExprKind::Call(name, args) if name.text == "rgb" => self.linear_color(args, amount, expr.span),
                ExprKind::Call(name, args) if matches!(name.text.as_str(), "hsl" | "hsv") => {
                    self.color_by_hue(&name.text, args, expr.span)
                }
                _ => self.wrong_value(attribute, "a colour", "#4af"),
            },
            _ => self.wrong_value(attribute, "a colour", "#4af"),
        }
    }

    /// A colour, or a number that is its grey.
    pub(super) fn color_or_grey(&mut self, attribute: &'a Attribute, amount: Amount) -> Reporting<Color> {
        let AttributeValue::Expr(expr) = &attribute.value else { return self.color(attribute, amount) };
        let is_color = match &expr.kind {
            ExprKind::Name(name) => colours::named(name).is_some() || !self.is_value(name),
            ExprKind::Call(name, _) => matches!(name.text.as_str(), "rgb" | "hsl" | "hsv"),
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
    fn is_value(&self, name: &str) -> bool {
        self.names.find(name).is_some() || CONSTANTS.contains(&name)
    }

    fn named_color(&mut self, name: &str, span: Span) -> Reporting<Color> {
        if let Some(srgb) = colours::named(name).or_else(|| colours::hexadecimal(name)) {
            return Ok(Color::Srgb(srgb));
        }
        let help = match nearest(name, colours::names()).first() {
            Some(near) => format!("did you mean `{near}`?"),
            None => "write a name such as `orange`, `#f80` or `rgb(1, 0.25, 0)`".to_owned(),
        };
        Err(self.report(Diagnostic::error(span, format!("there is no colour `{}`", cut(name))).help(help)))
    }

    fn linear_color(&mut self, args: &'a [Expr], amount: Amount, span: Span) -> Reporting<Color> {
        let [r, g, b] = self.three_parts(args, "rgb(red, green, blue)", span)?;
        let [r, g, b] = [r, g, b].map(|part| self.part_of_color(part, amount));
        Ok(Color::Linear([r?, g?, b?]))
    }

    /// `hsl(hue, saturation, lightness)` or `hsv(hue, saturation, value)`, the hue in degrees.
    fn color_by_hue(&mut self, model: &str, args: &'a [Expr], span: Span) -> Reporting<Color> {
        let third = if model == "hsl" { "lightness" } else { "value" };
        let [hue, saturation, last] = self.three_parts(args, &format!("{model}(hue, saturation, {third})"), span)?;
        let hue = self.known_number(hue, "the hue of a colour");
        let [saturation, last] = [saturation, last].map(|part| self.part_of_color(part, Amount::Share));
        let (hue, saturation, last) = (hue?, saturation?, last?);
        Ok(Color::Srgb(if model == "hsl" {
            colours::of_lightness(hue, saturation, last)
        } else {
            colours::of_value(hue, saturation, last)
        }))
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

    fn part_of_color(&mut self, expr: &'a Expr, amount: Amount) -> Reporting<f64> {
        let value = self.known_number(expr, "a part of a colour")?;
        match amount {
            Amount::Share if !(0.0..=1.0).contains(&value) => {
                let error = Diagnostic::error(expr.span, "a part of a surface's colour lies between 0 and 1");
                Err(self.report(error.help("divide by 255, or write the colour as `#ff8000`")))
            }
            Amount::Light if value < 0.0 => {
                Err(self.report(Diagnostic::error(expr.span, "a part of a light's colour is not negative")))
            }
            Amount::Share | Amount::Light => Ok(value),
        }
    }
}
