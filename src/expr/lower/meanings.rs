//! What a name stands for: bound names, the program's own, and those that everybody has.
//!
//! In: a name and its place. Out: its value. Separate from the table of declarations, which knows no values.

use super::values::Value;
use super::{Lowerer, Reported, Reporting, cut};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::expr::op::{Op, Variable};
use crate::num::rational::Rational;
use crate::syntax::ast::Name;
use crate::syntax::functions;

impl Lowerer<'_> {
    /// What a name stands for: bound names first, then the program's, then those everybody has.
    pub(super) fn name(&mut self, name: &str, span: Span) -> Reporting<Value> {
        if let Some(bound) = self.scope[self.frame..].iter().rev().find(|bound| bound.name == name) {
            self.met_coordinate |= bound.varies;
            return bound.value.clone();
        }
        if let Some(index) = self.names.find(name) {
            if self.names.list[index].as_function().is_some() {
                return Err(self.function_without_arguments(name, span));
            }
            let Some((value, varies)) = &self.values[index] else { return Err(Reported) };
            self.met_coordinate |= varies;
            return value.clone();
        }
        self.known_name(name, span)
    }

    fn known_name(&mut self, name: &str, span: Span) -> Reporting<Value> {
        let one = |lowerer: &mut Self, op| {
            lowerer.met_coordinate |= matches!(op, Op::Variable(_));
            Ok(Value::Number(lowerer.node(op, &[], span)))
        };
        match name {
            "x" => one(self, Op::Variable(Variable::X)),
            "y" => one(self, Op::Variable(Variable::Y)),
            "z" => one(self, Op::Variable(Variable::Z)),
            "e" => one(self, Op::E),
            "pi" | "π" => one(self, Op::Pi),
            "tau" => {
                let (two, pi) = (self.integer(2, span), self.node(Op::Pi, &[], span));
                Ok(Value::Number(self.node(Op::Mul, &[two, pi], span)))
            }
            "golden" => {
                let (one, two, five) = (self.integer(1, span), self.integer(2, span), self.integer(5, span));
                let root = self.node(Op::Sqrt, &[five], span);
                let sum = self.node(Op::Add, &[one, root], span);
                Ok(Value::Number(self.node(Op::Div, &[sum, two], span)))
            }
            _ if self.field.is_some() && functions::OF_SURFACE.contains(&name) => {
                self.met_coordinate = true;
                self.of_surface(name).map(Value::Number)
            }
            _ if ready_meaning(name).is_some() => Ok(self.ready(name, span)),
            _ => Err(self.unknown_name(name, span)),
        }
    }

    /// The cylinder's and the sphere's coordinates, and the point itself.
    fn ready(&mut self, name: &str, span: Span) -> Value {
        let [x, y, z] = self.coordinates(span);
        Value::Number(match name {
            "r" => self.length(&[x, y], span),
            "theta" => self.node(Op::Atan2, &[y, x], span),
            "rho" => self.length(&[x, y, z], span),
            "phi" => {
                let rho = self.length(&[x, y, z], span);
                let cosine = self.node(Op::Div, &[z, rho], span);
                self.node(Op::Acos, &[cosine], span)
            }
            _ => return Value::Vector(vec![x, y, z]),
        })
    }

    pub(super) fn coordinates(&mut self, span: Span) -> [NodeId; 3] {
        self.met_coordinate = true;
        [Variable::X, Variable::Y, Variable::Z].map(|variable| self.node(Op::Variable(variable), &[], span))
    }

    /// An exact number as a node.
    pub(super) fn constant(&mut self, value: Rational, span: Span) -> NodeId {
        self.graph.set_span(Some(span));
        self.graph.number(value)
    }

    fn function_without_arguments(&mut self, name: &str, span: Span) -> Reported {
        let message = format!("`{}` is a function and stands here without arguments", cut(name));
        self.report(Diagnostic::error(span, message).help(format!("write `{}(...)`", cut(name))))
    }

    pub(super) fn unknown_name(&mut self, name: &str, span: Span) -> Reported {
        if functions::find(name).is_some() {
            return self.function_without_arguments(name, span);
        }
        if self.settings.incomplete {
            return Reported;
        }
        let error = Diagnostic::error(span, format!("the name `{}` is not defined", cut(name)));
        self.report(error.help(format!("define it: `{0} = 1`, or as a parameter: `{0} = 1 in [0, 2]`", cut(name))))
    }

    pub(super) fn unknown_function(&mut self, name: &Name) -> Reported {
        if self.settings.incomplete {
            return Reported;
        }
        let error = Diagnostic::error(name.span, format!("there is no function `{}`", cut(&name.text)));
        self.report(error.help(format!("define it: `{}(u) = ...`", cut(&name.text))))
    }
}

/// What a name that is ready for use means, as text.
pub(super) fn ready_meaning(name: &str) -> Option<&'static str> {
    Some(match name {
        "r" => "sqrt(x^2 + y^2)",
        "theta" => "atan2(y, x)",
        "rho" => "sqrt(x^2 + y^2 + z^2)",
        "phi" => "acos(z/sqrt(x^2 + y^2 + z^2))",
        "p" => "(x, y, z)",
        _ => return None,
    })
}
