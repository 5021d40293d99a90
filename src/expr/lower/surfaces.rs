//! The statements that are to be drawn.
//!
//! In: equations, regions and their attributes. Out: for each the function whose zeros are drawn, as it was written.

use super::clips::Clip;
use super::matter::Matter;
use super::names::DeclarationKind;
use super::textures::Field;
use super::values::{Placed, Side, Value};
use super::{Lowerer, Reporting, cut};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::expr::op::Op;
use crate::syntax::ast::{Attribute, Expr, Name, Program, StatementKind};

/// What is drawn: where `f` is 0, or where it changes sign.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceFormula {
    /// Left side minus right side as written; of a region the function that is negative inside.
    pub f: NodeId,
    /// What it was.
    pub kind: Kind,
    /// The attribute `name`.
    pub name: Option<String>,
    /// What it is made of.
    pub matter: Matter,
    /// The attribute `clip`.
    pub clip: Option<Clip>,
    /// The statement.
    pub span: Span,
}

/// The kinds of statements that stand for a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// f = 0.
    Equation,
    /// The boundary of a region.
    Solid,
    /// A number that hangs on nothing: it can be evaluated, and there is nothing to draw.
    Number,
}

/// The entries behind a surface; those of a material are among them.
const OF_SURFACE: [&str; 17] = [
    "cap",
    "lines",
    "color",
    "material",
    "kind",
    "roughness",
    "ior",
    "metal",
    "n",
    "k",
    "absorption",
    "emission",
    "opacity",
    "inside",
    "priority",
    "clip",
    "name",
];

impl<'a> Lowerer<'a> {
    /// Lowers everything that is no declaration, in the order of the text.
    pub(super) fn statements(&mut self, program: &'a Program) {
        let mut wanted = false;
        for (position, statement) in program.statements.iter().enumerate() {
            match &statement.kind {
                StatementKind::Surface { left, right, attributes } => {
                    wanted = true;
                    self.surface(left, right.as_ref(), attributes, statement.span);
                }
                StatementKind::Function { name, parameters, body } if self.names.equations[position] => {
                    wanted = true;
                    self.value_of_function(name, parameters, body, statement.span);
                }
                StatementKind::Block { kind, attributes, .. } => self.block(*kind, attributes, statement.span),
                StatementKind::Include { path_span, .. } => {
                    let error = Diagnostic::error(*path_span, "this file was not read in");
                    self.report(error.help("`include` stands in program files"));
                }
                StatementKind::Definition { .. } | StatementKind::Function { .. } | StatementKind::Parameter { .. } => {
                }
            }
        }
        if !wanted {
            self.draw_only_function(program);
        }
    }

    fn surface(&mut self, left: &'a Expr, right: Option<&'a Expr>, attributes: &'a [Attribute], span: Span) {
        let formula = match right {
            None => self.bare(left, span),
            Some(right) => self.equation(left, right),
        };
        // Of a surface that failed the entries are read for their own errors.
        let (f, kind) = formula.unwrap_or_else(|_| (self.coordinates(span)[0], Kind::Number));
        self.field = Some(Field::new(f, kind));
        let attributes = self.surface_attributes(attributes);
        self.field = None;
        if formula.is_err() {
            return;
        }
        self.draw(SurfaceFormula { f, kind, span, ..attributes });
    }

    /// The attributes of a surface, in a formula whose other fields are to be filled in.
    fn surface_attributes(&mut self, attributes: &'a [Attribute]) -> SurfaceFormula {
        self.check_keys(attributes, "a surface", &OF_SURFACE);
        let clip = self.entry(attributes, "clip").map(|attribute| self.clip(attribute));
        let name = self.entry(attributes, "name").map(|attribute| self.text(attribute));
        SurfaceFormula {
            clip: clip.and_then(Result::ok),
            name: name.and_then(Result::ok),
            matter: self.matter_of_surface(attributes),
            ..SurfaceFormula::plain(NodeId(0), Kind::Equation, Span::default())
        }
    }

    fn draw(&mut self, formula: SurfaceFormula) {
        if self.check_graph_depth(formula.f, formula.span).is_ok() {
            self.out.surfaces.push(formula);
        }
    }

    /// An expression alone: a formula that is 0, a region, or a number.
    fn bare(&mut self, expr: &'a Expr, span: Span) -> Reporting<(NodeId, Kind)> {
        let placed = self.placed(expr)?;
        match placed.value {
            Value::Region(region) => Ok((region.side, Kind::Solid)),
            Value::Number(f) if self.is_number(f) => {
                let error = Diagnostic::error(span, "this is a number: there is nothing to draw");
                let error = error.help("write a formula of x, y and z, such as `x^2 + y^2 + z^2 = 1`");
                self.out.nothing_to_draw.push(error);
                Ok((f, Kind::Number))
            }
            Value::Number(f) => Ok((f, Kind::Equation)),
            other => {
                let message = format!("{} is no surface", other.kind());
                let help = "a surface is an equation such as `x^2 + y^2 + z^2 = 1`; `a = (1, 2, 3)` defines a name";
                Err(self.report(Diagnostic::error(placed.span, message).help(help)))
            }
        }
    }

    fn equation(&mut self, left: &'a Expr, right: &'a Expr) -> Reporting<(NodeId, Kind)> {
        let (left, right) = (self.placed(left), self.placed(right));
        let (left, right) = (self.side_of_equation(left?), self.side_of_equation(right?));
        let (left, right) = (left?, right?);
        let span = left.span.to(right.span);
        match (self.wanted_number(left), self.wanted_number(right)) {
            (Ok(a), Ok(b)) => {
                let is_plain = self.graph.constant(b).is_some_and(|value| value.is_zero());
                let f = if is_plain { a } else { self.node(Op::Sub, &[a, b], span) };
                Ok((f, self.kind_of_equation(f, span)))
            }
            _ => super::values::reported(),
        }
    }

    /// An equation without x, y and z holds everywhere or nowhere: there is nothing to draw.
    fn kind_of_equation(&mut self, f: NodeId, span: Span) -> Kind {
        let Some(value) = self.graph.constant(f) else { return Kind::Equation };
        let holds = if value.is_zero() { "this holds everywhere" } else { "this holds nowhere" };
        let error = Diagnostic::error(span, format!("{holds}: there is no surface to draw"));
        let error = error.help("write an equation of x, y and z, such as `x^2 + y^2 + z^2 = 1`");
        self.out.nothing_to_draw.push(error);
        Kind::Number
    }

    /// Refuses what cannot be a side of an equation, with the way out that fits there.
    fn side_of_equation(&mut self, placed: Placed) -> Reporting<Placed> {
        let (message, help) = match &placed.value {
            Value::Number(_) => return Ok(placed),
            Value::Region(_) => (
                "a region stands in an equation",
                "write the region alone; a number that hangs on one is `if(x > 0, 1, 0)`",
            ),
            Value::Vector(_) => {
                ("a vector stands in an equation", "write an equation of numbers, such as `|p - c| = 1`")
            }
            Value::List(_) => ("a list stands in an equation", "a list is for sums: `sum(c in list, ...)`"),
        };
        Err(self.report(Diagnostic::error(placed.span, message).help(help)))
    }

    /// Whether a node hangs on no coordinate.
    fn is_number(&self, f: NodeId) -> bool {
        self.graph.reachable(&[f]).iter().all(|&id| !matches!(self.graph.op(id), Op::Variable(_)))
    }

    /// `f(x, y, z) = 0` where f is defined by an earlier statement.
    fn value_of_function(&mut self, name: &'a Name, arguments: &'a [Name], body: &'a Expr, span: Span) {
        let head = arguments.last().map_or(name.span, |last| name.span.to(last.span));
        let left = self.call_by_names(name, arguments, head);
        let right = self.placed(body);
        let (Ok(left), Ok(right)) = (left, right) else { return };
        let left = self.side_of_equation(Placed { value: left, span: head });
        let (Ok(left), Ok(right)) = (left, self.side_of_equation(right)) else { return };
        if let Ok(Value::Number(f)) = self.add_values(left, Side::Under, right, span) {
            self.draw(SurfaceFormula::plain(f, Kind::Equation, span));
        }
    }

    /// A program of definitions alone draws its function, if it has one of (x, y, z) or (x, y).
    fn draw_only_function(&mut self, program: &'a Program) {
        let functions: Vec<usize> =
            (0..self.names.list.len()).filter(|&i| self.graph_of_function(i).is_some()).collect();
        let [only] = functions[..] else {
            let error = self.nothing_to_draw(program, functions.len());
            self.out.nothing_to_draw.push(error);
            return;
        };
        let name = &self.names.list[only].name;
        let (text, span) = (cut(&name.text), name.span);
        let Some((parameters, body)) = self.graph_of_function(only) else { return };
        let coordinates = self.coordinates(span);
        let values = coordinates[..parameters.len()].iter().map(|&id| (Value::Number(id), true)).collect();
        let Ok(value) = self.applied(only, values, span) else { return };
        let (f, kind, equation) = match (value, parameters.len()) {
            (Value::Region(region), _) => (region.side, Kind::Solid, text),
            (Value::Number(f), 2) => {
                let height = self.node(Op::Sub, &[coordinates[2], f], span);
                (height, Kind::Equation, format!("z = {text}(x, y)"))
            }
            (Value::Number(f), _) => (f, Kind::Equation, format!("{text}(x, y, z) = 0")),
            (other, _) => {
                let message = format!("{} is no surface", other.kind());
                self.out.nothing_to_draw.push(Diagnostic::error(body.span, message));
                return;
            }
        };
        let note = Diagnostic::note(span, format!("drawn is `{equation}`, the only function of the program"));
        self.report(note.help("write the equation in a statement of its own to draw something else"));
        self.draw(SurfaceFormula::plain(f, kind, body.span));
    }

    /// Parameters and body of a function of (x, y, z) or (x, y).
    fn graph_of_function(&self, index: usize) -> Option<(&'a [Name], &'a Expr)> {
        let (parameters, body) = self.names.list[index].as_function()?;
        let names: Vec<&str> = parameters.iter().map(|name| name.text.as_str()).collect();
        (names == ["x", "y", "z"] || names == ["x", "y"]).then_some((parameters, body))
    }

    fn nothing_to_draw(&self, program: &Program, functions: usize) -> Diagnostic {
        let first = program.statements.first().map(|statement| statement.span).unwrap_or_default();
        let formula = self.names.list.iter().find(|known| matches!(known.kind, DeclarationKind::Value(_)));
        let (span, help) = match formula {
            _ if functions > 1 => {
                (first, "several functions could be drawn; write an equation such as `f(x, y, z) = 0`".to_owned())
            }
            Some(known) => {
                let name = cut(&known.name.text);
                let value = self.out.definition(&known.name.text).map(|definition| &definition.value);
                let help = match value {
                    Some(Value::Number(f)) if !self.is_number(*f) => {
                        format!("this defines `{name}`; to draw where it is 0 write `{name}` in a statement of its own")
                    }
                    Some(Value::Region(_)) => {
                        format!("this defines `{name}`; to draw it write `{name}` in a statement of its own")
                    }
                    _ => {
                        format!("this defines `{name}`; write an equation of x, y and z, such as `x^2 + y^2 + z^2 = 1`")
                    }
                };
                (known.name.span, help)
            }
            None => (first, "write an equation such as `x^2 + y^2 + z^2 = 1`".to_owned()),
        };
        Diagnostic::error(span, "the program has no surface: there is nothing to draw").help(help)
    }
}

impl SurfaceFormula {
    /// A formula without attributes.
    pub(super) fn plain(f: NodeId, kind: Kind, span: Span) -> Self {
        SurfaceFormula { f, kind, name: None, matter: Matter::default(), clip: None, span }
    }
}
