//! Entries of blocks: keys that are known, and values of one kind each.
//!
//! In: a `key: value` pair. Out: a number, a point, a word; or the error that says what is wanted, with an example. Separate
//! from the blocks, which know what their keys are for.

use super::values::Value;
use super::{Lowerer, Reporting, cut};
use crate::diag::{Diagnostic, Span, nearest, one_of};
use crate::syntax::ast::{Attribute, AttributeValue, Expr, ExprKind, UnaryOp};

impl<'a> Lowerer<'a> {
    /// Refuses keys that the owner does not know.
    pub(super) fn check_keys(&mut self, attributes: &[Attribute], owner: &str, known: &[&str]) {
        for attribute in attributes {
            let key = &attribute.key;
            if !known.contains(&key.text.as_str()) {
                let near = nearest(&key.text, known.iter().copied());
                let help = match near.first() {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("{owner} takes {}", one_of(known)),
                };
                let message = format!("{owner} has no attribute `{}`", cut(&key.text));
                self.report(Diagnostic::error(key.span, message).help(help));
            }
        }
    }

    /// Says what is wanted behind a key, with an example.
    pub(super) fn wrong_value<T>(&mut self, attribute: &Attribute, wanted: &str, example: &str) -> Reporting<T> {
        let message = format!("`{}` wants {wanted}", attribute.key.text);
        let help = format!("for example `{}: {example}`", attribute.key.text);
        Err(self.report(Diagnostic::error(place(&attribute.value), message).help(help)))
    }

    /// A text in quotes.
    pub(super) fn text(&mut self, attribute: &Attribute) -> Reporting<String> {
        match &attribute.value {
            AttributeValue::Text(text, _) => Ok(text.clone()),
            _ => self.wrong_value(attribute, "a text in quotes", "\"ball\""),
        }
    }

    /// A word, bare or in quotes.
    pub(super) fn word(&mut self, attribute: &'a Attribute, wanted: &str, example: &str) -> Reporting<(&'a str, Span)> {
        match &attribute.value {
            AttributeValue::Text(word, span) | AttributeValue::Expr(Expr { kind: ExprKind::Name(word), span }) => {
                Ok((word, *span))
            }
            _ => self.wrong_value(attribute, wanted, example),
        }
    }

    /// A whole number.
    pub(super) fn count(&mut self, attribute: &'a Attribute, least: u32) -> Reporting<u32> {
        let AttributeValue::Expr(expr) = &attribute.value else {
            return self.wrong_value(attribute, "a whole number", "8");
        };
        let node = self.number(expr)?;
        let value = self.whole(node, expr.span, &format!("`{}`", attribute.key.text))?;
        match u32::try_from(value) {
            Ok(value) if value >= least => Ok(value),
            _ => self.wrong_value(attribute, &format!("a whole number from {least} to {}", u32::MAX), "8"),
        }
    }

    /// A whole number of any length that the language can say.
    pub(super) fn long_count(&mut self, attribute: &'a Attribute) -> Reporting<u64> {
        let AttributeValue::Expr(expr) = &attribute.value else {
            return self.wrong_value(attribute, "a whole number", "8");
        };
        let node = self.number(expr)?;
        let value = self.whole(node, expr.span, &format!("`{}`", attribute.key.text))?;
        match u64::try_from(value) {
            Ok(value) => Ok(value),
            Err(_) => self.wrong_value(attribute, "a whole number from 0", "8"),
        }
    }

    /// A number that is known before drawing, and for which `is_allowed` holds.
    pub(super) fn number_that(
        &mut self,
        attribute: &'a Attribute,
        is_allowed: impl Fn(f64) -> bool,
        wanted: &str,
        example: &str,
    ) -> Reporting<f64> {
        let AttributeValue::Expr(expr) = &attribute.value else {
            return self.wrong_value(attribute, wanted, example);
        };
        let value = self.known_number(expr, &format!("`{}`", attribute.key.text))?;
        if is_allowed(value) { Ok(value) } else { self.wrong_value(attribute, wanted, example) }
    }

    /// A number >= 0.
    pub(super) fn not_negative(&mut self, attribute: &'a Attribute, what: &str, example: &str) -> Reporting<f64> {
        self.number_that(attribute, |value| value >= 0.0, &format!("{what}, 0 or more"), example)
    }

    /// The entry of a key.
    pub(super) fn entry(&self, attributes: &'a [Attribute], key: &str) -> Option<&'a Attribute> {
        attributes.iter().find(|attribute| attribute.key.text == key)
    }

    /// A point.
    pub(super) fn point(&mut self, attribute: &'a Attribute) -> Reporting<[f64; 3]> {
        let AttributeValue::Expr(expr) = &attribute.value else {
            return self.wrong_value(attribute, "a point", "(4, -3, 2)");
        };
        if let Some(point) = literal_point(expr) {
            return Ok(point);
        }
        match self.expr(expr)? {
            Value::Vector(items) if items.len() == 3 => {
                let mut point = [0.0; 3];
                for (coordinate, id) in point.iter_mut().zip(items) {
                    *coordinate = self.known(id, expr.span, &format!("each coordinate of `{}`", attribute.key.text))?;
                }
                Ok(point)
            }
            _ => self.wrong_value(attribute, "a point", "(4, -3, 2)"),
        }
    }

    /// A direction: a point that is not the origin.
    pub(super) fn direction(&mut self, attribute: &'a Attribute) -> Reporting<[f64; 3]> {
        let direction = self.point(attribute)?;
        if direction == [0.0; 3] {
            return self.wrong_value(attribute, "a direction, and (0, 0, 0) has none", "(1, -1, 2)");
        }
        Ok(direction)
    }
}

/// The value of a number as it is written, with a sign or without.
pub(super) fn literal(expr: &Expr) -> Option<f64> {
    match &expr.kind {
        ExprKind::Number(value) => Some(value.to_f64()).filter(|value| value.is_finite()),
        ExprKind::Unary(UnaryOp::Neg, inner) => literal(inner).map(|value| -value),
        _ => None,
    }
}

/// A point whose numbers are written out: ten thousand lights need no node of the graph for theirs.
fn literal_point(expr: &Expr) -> Option<[f64; 3]> {
    let ExprKind::Vector(items) = &expr.kind else { return None };
    let [x, y, z] = items.as_slice() else { return None };
    Some([literal(x)?, literal(y)?, literal(z)?])
}

/// The place of a value.
pub(super) fn place(value: &AttributeValue) -> Span {
    match value {
        AttributeValue::Expr(expr) => expr.span,
        AttributeValue::Color(_, span)
        | AttributeValue::Text(_, span)
        | AttributeValue::Call(_, _, span)
        | AttributeValue::Size(_, _, span)
        | AttributeValue::Box(_, span) => *span,
    }
}
