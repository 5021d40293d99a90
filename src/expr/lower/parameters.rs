//! Parameters: numbers that may be set from outside.
//!
//! In: `a = 0.5 in [0, 1] step 0.1` and the settings. Out: the number to compute with, and the range for sliders.

use super::{Lowerer, Reporting, cut};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::num::rational::Rational;
use crate::syntax::ast::Expr;

/// A value given from outside: `--set name=value`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The parameter.
    pub name: String,
    /// Its value, exact.
    pub value: Rational,
}

/// A parameter of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The name.
    pub name: String,
    /// The value in use, set or default.
    pub value: f64,
    /// The least value.
    pub low: f64,
    /// The greatest.
    pub high: f64,
    /// The step of a slider, > 0.
    pub step: Option<f64>,
    /// The statement.
    pub span: Span,
}

impl<'a> Lowerer<'a> {
    /// The number a parameter has in this run.
    pub(super) fn parameter(
        &mut self,
        name: &str,
        [default, low, high]: [&'a Expr; 3],
        step: Option<&'a Expr>,
        span: Span,
    ) -> Reporting<NodeId> {
        let node = self.number(default);
        let value = node.and_then(|node| self.known(node, default.span, "the value of a parameter"));
        let (least, greatest) = (self.known_number(low, "a bound"), self.known_number(high, "a bound"));
        let step = step.map(|step| self.step(step)).transpose();
        let (node, value, least, greatest, step) = (node?, value?, least?, greatest?, step?);
        if least > greatest {
            let place = low.span.to(high.span);
            let error = Diagnostic::error(place, "this range is empty: its lower end is above its upper end");
            return Err(self.report(error.help(format!("write `[{greatest}, {least}]`"))));
        }
        if !(least <= value && value <= greatest) {
            let message = format!("the value {value} lies outside of the range [{least}, {greatest}]");
            let error = Diagnostic::error(default.span, message).also(low.span.to(high.span), "the range");
            return Err(self.report(error.help("widen the range or take a value inside")));
        }
        let set = self.settings.set.iter().rev().find(|setting| setting.name == name);
        let (node, value) = match set {
            None => (node, value),
            Some(setting) => (self.set_value(setting, least, greatest, span)?, setting.value.to_f64()),
        };
        let parameter = Parameter { name: name.to_owned(), value, low: least, high: greatest, step, span };
        self.out.parameters.push(parameter);
        Ok(node)
    }

    fn set_value(&mut self, setting: &Setting, low: f64, high: f64, span: Span) -> Reporting<NodeId> {
        let value = setting.value.to_f64();
        if !(low <= value && value <= high) {
            let message = format!("`--set {}={value}` lies outside of the range [{low}, {high}]", cut(&setting.name));
            return Err(self.report(Diagnostic::error(span, message).help("widen the range or set a value inside")));
        }
        Ok(self.constant(setting.value.clone(), span))
    }

    fn step(&mut self, step: &'a Expr) -> Reporting<f64> {
        let value = self.known_number(step, "the step")?;
        if value > 0.0 {
            return Ok(value);
        }
        Err(self.report(Diagnostic::error(step.span, "the step of a parameter is more than 0")))
    }

    /// An expression whose value is a finite number known before drawing.
    pub(super) fn known_number(&mut self, expr: &'a Expr, what: &str) -> Reporting<f64> {
        if let Some(value) = super::entries::literal(expr) {
            return Ok(value);
        }
        let node = self.number(expr)?;
        self.known(node, expr.span, what)
    }

    /// A node whose value is a finite number known before drawing.
    pub(super) fn known(&mut self, node: NodeId, span: Span, what: &str) -> Reporting<f64> {
        match self.constant_value(node) {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => {
                Err(self.report(Diagnostic::error(span, format!("{what} is a finite number, and this has no value"))))
            }
            None => {
                let error = Diagnostic::error(span, format!("{what} is a number that is known before drawing"));
                Err(self.report(error.help("it cannot hang on x, y or z")))
            }
        }
    }

    /// Refuses settings of names that are no parameters.
    pub(super) fn check_settings(&mut self) {
        let settings = self.settings;
        for setting in &settings.set {
            let declared = self.names.find(&setting.name);
            let parameter = declared.is_some_and(|index| self.names.list[index].is_parameter());
            if parameter || (declared.is_none() && settings.incomplete) {
                continue;
            }
            let (name, value) = (cut(&setting.name), setting.value.to_f64());
            let error = match declared {
                Some(index) => {
                    let place = self.names.list[index].name.span;
                    let error = Diagnostic::error(place, format!("`--set {name}={value}`: `{name}` is no parameter"));
                    error.help(format!("a parameter is defined with a range: `{name} = {value} in [0, 1]`"))
                }
                None => self.unknown_parameter(&name, value),
            };
            self.report(error);
        }
    }

    fn unknown_parameter(&self, name: &str, value: f64) -> Diagnostic {
        let list = &self.names.list;
        let known = || list.iter().filter(|known| known.is_parameter()).map(|known| known.name.text.as_str());
        let message = format!("`--set {name}={value}`: the program has no parameter `{name}`");
        let help = match crate::diag::suggest::nearest(name, known()).first() {
            Some(near) => format!("did you mean `{near}`?"),
            None if known().next().is_none() => {
                format!("it has none; write `{name} = {value} in [0, 1]` in the program")
            }
            None => format!(
                "it has {}",
                known().take(8).map(|name| format!("`{}`", cut(name))).collect::<Vec<_>>().join(", ")
            ),
        };
        Diagnostic { severity: crate::diag::Severity::Error, message, labels: Vec::new(), help: Some(help) }
    }
}
