//! Names, functions, parameters, lists and regions become nodes.
//!
//! In: a whole program's tree and the values that were set from outside. Out: a [`Lowered`]: one graph, the function
//! of every surface in it, what was defined, and the blocks with their numbers worked out. Separate from the parser
//! because here names get their meaning, and from the scene because nothing here knows what a camera is for.
//!
//! - [`names`]: what is declared, in which order it can be lowered; circles.
//! - [`values`]: numbers, vectors, lists and their arithmetic.
//! - [`powers`], [`functions`], [`regions`], [`series`]: the expressions, by kind.
//! - [`parameters`], [`surfaces`], [`blocks`], [`colours`]: the statements, by kind.
//! - [`constants`]: the f64 of a node that hangs on no variable.
//! - [`limits`]: what no text may exceed.

mod blocks;
mod colours;
mod constants;
mod functions;
pub mod limits;
mod names;
mod parameters;
mod powers;
mod regions;
mod series;
mod surfaces;
#[cfg(test)]
mod tests;
mod values;

pub use blocks::{Camera, Clip, ClipShape, Color, Mode, Render};
pub use parameters::{Parameter, Setting};
pub use regions::{Edge, Region};
pub use surfaces::{Kind, SurfaceFormula};
pub use values::Value;

use super::graph::{Graph, NodeId};
use super::op::{Op, Variable};
use crate::diag::{Diagnostic, Severity, Span};
use crate::num::rational::Rational;
use crate::syntax::ast::{Expr, ExprKind, Factor, FactorOp, Name, Program, Term, UnaryOp};
use names::{DeclarationKind, Names};
use std::collections::HashMap;
use values::{Placed, Side};

/// What is said from outside the program.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// Values of parameters; of two for one name the last counts.
    pub set: Vec<Setting>,
    /// Whether the parser has reported errors: statements may be missing, so unknown names are not reported again.
    pub incomplete: bool,
}

/// A name that the program defines, with its value.
#[derive(Clone, Debug)]
pub struct Definition {
    /// The name.
    pub name: String,
    /// Its value.
    pub value: Value,
    /// Where it is defined.
    pub span: Span,
}

/// A program's mathematics.
#[derive(Clone, Debug, Default)]
pub struct Lowered {
    /// The graph that all nodes are of.
    pub graph: Graph,
    /// What is to be drawn, in the order of the statements.
    pub surfaces: Vec<SurfaceFormula>,
    /// Every definition and parameter that has a value, in the order in which they were lowered.
    pub definitions: Vec<Definition>,
    /// The parameters, in the order of the statements.
    pub parameters: Vec<Parameter>,
    /// The camera block.
    pub camera: Option<Camera>,
    /// The render block.
    pub render: Option<Render>,
    /// Errors and notes, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// What hinders drawing but not evaluating: a number alone, no surface at all.
    pub nothing_to_draw: Vec<Diagnostic>,
}

impl Lowered {
    /// Whether there is an error, so that the program cannot be used.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }

    /// The definition of a name.
    pub fn definition(&self, name: &str) -> Option<&Definition> {
        self.definitions.iter().find(|definition| definition.name == name)
    }
}

/// The mark of an error that was reported: what stands on it is silent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Reported;

type Reporting<T> = Result<T, Reported>;

/// Text from the user in messages is cut to this many characters.
const LONGEST_QUOTE: usize = 60;

/// Makes the graph of a program.
///
/// # Errors
/// None in the type: errors and notes are in [`Lowered::diagnostics`], all independent ones of the program, and what
/// could be lowered is there beside them.
pub fn lower(program: &Program, settings: &Settings) -> Lowered {
    let (names, diagnostics) = Names::collect(program);
    let mut lowerer = Lowerer::new(names, settings, diagnostics);
    lowerer.definitions();
    lowerer.check_settings();
    lowerer.statements(program);
    let mut lowered = lowerer.finish();
    lowered.diagnostics.sort_by_key(|diagnostic| diagnostic.labels.first().map(|label| label.span));
    lowered
}

/// The work in hand.
struct Lowerer<'a> {
    graph: Graph,
    names: Names<'a>,
    settings: &'a Settings,
    /// The value of each declaration, once it is lowered.
    values: Vec<Option<Reporting<Value>>>,
    /// Names bound by functions and series, the innermost last.
    scope: Vec<(&'a str, Value)>,
    /// Where in `scope` the names of the current function's body begin.
    frame: usize,
    /// Calls of the program's functions that were lowered, by function and arguments.
    calls: HashMap<(usize, Vec<Value>), Reporting<Value>>,
    /// The node under the root of each vector's length.
    squares_of_lengths: HashMap<NodeId, NodeId>,
    /// The depth of each node.
    depths: Vec<u32>,
    depth: u32,
    steps: u64,
    terms: usize,
    stopped: bool,
    out: Lowered,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> Lowerer<'a> {
    fn new(names: Names<'a>, settings: &'a Settings, diagnostics: Vec<Diagnostic>) -> Self {
        Lowerer {
            graph: Graph::new(),
            values: vec![None; names.list.len()],
            names,
            settings,
            scope: Vec::new(),
            frame: 0,
            calls: HashMap::new(),
            squares_of_lengths: HashMap::new(),
            depths: Vec::new(),
            depth: 0,
            steps: 0,
            terms: 0,
            stopped: false,
            out: Lowered::default(),
            diagnostics,
        }
    }

    fn finish(mut self) -> Lowered {
        self.graph.set_span(None);
        Lowered { graph: self.graph, diagnostics: self.diagnostics, ..self.out }
    }

    /// Keeps a diagnostic, unless it was said before or nothing more is to be said.
    fn report(&mut self, diagnostic: Diagnostic) -> Reported {
        let place = |d: &Diagnostic| d.labels.first().map(|label| label.span);
        let said = |known: &Diagnostic| known.message == diagnostic.message && place(known) == place(&diagnostic);
        if !self.stopped && self.diagnostics.len() < MAX_DIAGNOSTICS && !self.diagnostics.iter().any(said) {
            self.diagnostics.push(diagnostic);
        }
        Reported
    }

    /// Lowers every definition, each after those it needs.
    fn definitions(&mut self) {
        for index in std::mem::take(&mut self.names.order) {
            let declaration = &self.names.list[index];
            if declaration.poisoned {
                continue;
            }
            let (name, span) = (declaration.name.text.clone(), declaration.name.span);
            let value = match declaration.kind {
                DeclarationKind::Value(value) => self.expr(value),
                DeclarationKind::Parameter { value, low, high, step, span } => {
                    self.parameter(&name, [value, low, high], step, span).map(Value::Number)
                }
                DeclarationKind::Function(..) => continue,
            };
            if let Ok(value) = &value {
                self.out.definitions.push(Definition { name, value: value.clone(), span });
            }
            self.values[index] = Some(value);
        }
    }

    /// The value of an expression.
    fn expr(&mut self, expr: &'a Expr) -> Reporting<Value> {
        self.enter(expr.span, 1)?;
        let value = self.expr_inside(expr);
        self.leave(1);
        value
    }

    // table: the kinds of expressions
    fn expr_inside(&mut self, expr: &'a Expr) -> Reporting<Value> {
        let span = expr.span;
        match &expr.kind {
            ExprKind::Number(value) => Ok(Value::Number(self.constant(value.clone(), span))),
            ExprKind::Invalid => Err(Reported),
            ExprKind::Name(name) => self.name(name, span),
            ExprKind::Unary(op, inner) => self.unary(*op, inner, span),
            ExprKind::Sum(terms) => self.sum(terms),
            ExprKind::Product(factors) => self.product(factors),
            ExprKind::Power(base, exponent) => {
                let base = self.placed(base)?;
                self.power(base, exponent, span)
            }
            ExprKind::And(items) => self.logical(items, true, span),
            ExprKind::Or(items) => self.logical(items, false, span),
            ExprKind::Chain(operands, comparisons) => self.chain(operands, comparisons, span),
            ExprKind::Bars(inner) => {
                let inner = self.placed(inner)?;
                self.magnitude(inner, span)
            }
            ExprKind::Call(name, args) => self.call(name, args, span),
            ExprKind::Vector(items) => self.vector(items, span),
            ExprKind::List(items) => self.list(items),
            ExprKind::Component(inner, letter) => {
                let inner = self.placed(inner)?;
                self.component(inner, &letter.text, letter.span)
            }
            ExprKind::Series { product, variable, over, body } => {
                self.series(series::Series { product: *product, variable, over, body }, span)
            }
        }
    }

    /// The value with its place.
    fn placed(&mut self, expr: &'a Expr) -> Reporting<Placed> {
        Ok(Placed { value: self.expr(expr)?, span: expr.span })
    }

    /// The expression as a number.
    fn number(&mut self, expr: &'a Expr) -> Reporting<NodeId> {
        let placed = self.placed(expr)?;
        self.wanted_number(placed)
    }

    fn unary(&mut self, op: UnaryOp, inner: &'a Expr, span: Span) -> Reporting<Value> {
        let placed = self.placed(inner)?;
        match op {
            UnaryOp::Neg => self.negate_value(placed, span),
            UnaryOp::Plus => match placed.value {
                Value::Vector(_) => Ok(placed.value),
                _ => self.wanted_number(placed).map(Value::Number),
            },
            UnaryOp::Not => {
                let region = self.wanted_region(placed)?;
                Ok(Value::Region(self.outside(region, span)))
            }
        }
    }

    /// `a + b - c`: from the left while it is short, in balanced halves when it is long.
    fn sum(&mut self, terms: &'a [Term]) -> Reporting<Value> {
        let mut placed = Vec::with_capacity(terms.len());
        for term in terms {
            placed.push(self.placed(&term.value).map(|value| (term.minus, value)));
        }
        let mut placed = placed.into_iter().collect::<Reporting<Vec<(bool, Placed)>>>()?;
        self.balanced_sum(&mut placed)
    }

    /// The sum of terms of which the first is added.
    fn balanced_sum(&mut self, terms: &mut [(bool, Placed)]) -> Reporting<Value> {
        if terms.len() > values::FOLDED_FROM_THE_LEFT {
            let (low, high) = terms.split_at_mut(terms.len() / 2);
            let minus = high[0].0;
            high.iter_mut().for_each(|term| term.0 ^= minus);
            let (low_span, high_span) = (whole_span(low), whole_span(high));
            let (low, high) = (self.balanced_sum(low)?, self.balanced_sum(high)?);
            let (low, high) = (Placed { value: low, span: low_span }, Placed { value: high, span: high_span });
            let side = if minus { Side::Under } else { Side::Over };
            return self.add_values(low, side, high, low_span.to(high_span));
        }
        let mut total = terms[0].1.clone();
        for (minus, term) in &terms[1..] {
            let side = if *minus { Side::Under } else { Side::Over };
            let span = total.span.to(term.span);
            total = Placed { value: self.add_values(total, side, term.clone(), span)?, span };
        }
        match total.value {
            Value::Vector(_) => Ok(total.value),
            _ => self.wanted_number(total).map(Value::Number),
        }
    }

    /// `a * b / c % d`, from the left; a long product without quotients in balanced halves.
    fn product(&mut self, factors: &'a [Factor]) -> Reporting<Value> {
        let mut placed = Vec::with_capacity(factors.len());
        for factor in factors {
            placed.push(self.placed(&factor.value).map(|value| (factor.operator, value)));
        }
        let placed = placed.into_iter().collect::<Reporting<Vec<(FactorOp, Placed)>>>()?;
        self.balanced_product(&placed)
    }

    fn balanced_product(&mut self, factors: &[(FactorOp, Placed)]) -> Reporting<Value> {
        let plain =
            |(op, placed): &(FactorOp, Placed)| *op == FactorOp::Mul && matches!(placed.value, Value::Number(_));
        if factors.len() > values::FOLDED_FROM_THE_LEFT && factors.iter().all(plain) {
            let numbers: Vec<NodeId> = factors.iter().flat_map(|(_, placed)| placed.value.nodes()).collect();
            let span = factors[0].1.span.to(factors[factors.len() - 1].1.span);
            return Ok(Value::Number(self.fold(Op::Mul, &numbers, span)));
        }
        let mut total = factors[0].1.clone();
        for (op, factor) in &factors[1..] {
            let span = total.span.to(factor.span);
            let value = match op {
                FactorOp::Mul => self.multiply_values(total, Side::Over, factor.clone(), span)?,
                FactorOp::Div => self.multiply_values(total, Side::Under, factor.clone(), span)?,
                FactorOp::Mod => {
                    let (a, b) = (self.wanted_number(total), self.wanted_number(factor.clone()));
                    Value::Number(self.modulo(a?, b?, span))
                }
            };
            total = Placed { value, span };
        }
        Ok(total.value)
    }

    fn logical(&mut self, items: &'a [Expr], and: bool, span: Span) -> Reporting<Value> {
        let mut regions = Vec::with_capacity(items.len());
        for item in items {
            let placed = self.placed(item);
            regions.push(placed.and_then(|placed| self.wanted_region(placed)));
        }
        let regions = regions.into_iter().collect::<Reporting<Vec<Region>>>()?;
        Ok(Value::Region(self.balanced_regions(&regions, and, span)))
    }

    fn balanced_regions(&mut self, regions: &[Region], and: bool, span: Span) -> Region {
        let [first, rest @ ..] = regions else { unreachable!("the parser gives `and` and `or` two operands or more") };
        if rest.is_empty() {
            return *first;
        }
        let (low, high) = regions.split_at(regions.len().div_ceil(2));
        let (low, high) = (self.balanced_regions(low, and, span), self.balanced_regions(high, and, span));
        if and { self.both(low, high, span) } else { self.either(low, high, span) }
    }

    fn vector(&mut self, items: &'a [Expr], span: Span) -> Reporting<Value> {
        let mut numbers = Vec::with_capacity(items.len());
        for item in items {
            numbers.push(self.number(item));
        }
        let numbers = numbers.into_iter().collect::<Reporting<Vec<NodeId>>>()?;
        if !(2..=3).contains(&numbers.len()) {
            let message = format!("a vector has two or three numbers, and this has {}", numbers.len());
            return Err(self.report(Diagnostic::error(span, message).help("a list is written `[a, b, c, d]`")));
        }
        Ok(Value::Vector(numbers))
    }

    fn list(&mut self, items: &'a [Expr]) -> Reporting<Value> {
        let mut values = Vec::with_capacity(items.len());
        for item in items {
            let placed = self.placed(item);
            values.push(placed.and_then(|placed| match placed.value {
                Value::List(_) => {
                    let error = Diagnostic::error(placed.span, "a list cannot stand in a list");
                    Err(self.report(error.help("write the items one by one")))
                }
                value => Ok(value),
            }));
        }
        Ok(Value::List(values.into_iter().collect::<Reporting<Vec<Value>>>()?.into()))
    }

    /// What a name stands for: bound names first, then the program's, then those everybody has.
    fn name(&mut self, name: &str, span: Span) -> Reporting<Value> {
        if let Some((_, value)) = self.scope[self.frame..].iter().rev().find(|(bound, _)| *bound == name) {
            return Ok(value.clone());
        }
        if let Some(index) = self.names.find(name) {
            if self.names.list[index].as_function().is_some() {
                return Err(self.function_without_arguments(name, span));
            }
            return self.values[index].clone().unwrap_or(Err(Reported));
        }
        self.known_name(name, span)
    }

    fn known_name(&mut self, name: &str, span: Span) -> Reporting<Value> {
        let one = |lowerer: &mut Self, op| Ok(Value::Number(lowerer.node(op, &[], span)));
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
            "r" | "theta" | "rho" | "phi" | "p" => Ok(self.ready(name, span)),
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

    fn coordinates(&mut self, span: Span) -> [NodeId; 3] {
        [Variable::X, Variable::Y, Variable::Z].map(|variable| self.node(Op::Variable(variable), &[], span))
    }

    /// An exact number as a node.
    fn constant(&mut self, value: Rational, span: Span) -> NodeId {
        self.graph.set_span(Some(span));
        self.graph.number(value)
    }

    fn function_without_arguments(&mut self, name: &str, span: Span) -> Reported {
        let message = format!("`{}` is a function and stands here without arguments", cut(name));
        self.report(Diagnostic::error(span, message).help(format!("write `{}(...)`", cut(name))))
    }

    fn unknown_name(&mut self, name: &str, span: Span) -> Reported {
        if crate::syntax::functions::find(name).is_some() {
            return self.function_without_arguments(name, span);
        }
        if self.settings.incomplete {
            return Reported;
        }
        let error = Diagnostic::error(span, format!("the name `{}` is not defined", cut(name)));
        self.report(error.help(format!("define it: `{0} = 1`, or as a parameter: `{0} = 1 in [0, 2]`", cut(name))))
    }

    fn unknown_function(&mut self, name: &Name) -> Reported {
        if self.settings.incomplete {
            return Reported;
        }
        let error = Diagnostic::error(name.span, format!("there is no function `{}`", cut(&name.text)));
        self.report(error.help(format!("define it: `{}(u) = ...`", cut(&name.text))))
    }
}

/// Errors kept at most: nobody reads more, and looking through them takes time.
const MAX_DIAGNOSTICS: usize = 200;

/// What a ready-made name means, as text.
fn ready_meaning(name: &str) -> &'static str {
    match name {
        "r" => "sqrt(x^2 + y^2)",
        "theta" => "atan2(y, x)",
        "rho" => "sqrt(x^2 + y^2 + z^2)",
        "phi" => "acos(z/sqrt(x^2 + y^2 + z^2))",
        _ => "(x, y, z)",
    }
}

fn whole_span(terms: &[(bool, Placed)]) -> Span {
    terms[0].1.span.to(terms[terms.len() - 1].1.span)
}

/// Text from the user, short enough for a message.
fn cut(text: &str) -> String {
    if text.chars().count() <= LONGEST_QUOTE {
        return text.to_owned();
    }
    let head: String = text.chars().take(LONGEST_QUOTE).collect();
    format!("{head}…")
}
