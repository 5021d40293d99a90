//! Calls: the functions of the table, and those the program defines.
//!
//! In: a name and values. Out: the nodes of the function, composite ones made of simpler operations. Separate
//! because it is one flat table; what the functions mean is said in `grammar.md`.

use super::regions::{Combination, Edge, Region};
use super::values::{Placed, Value};
use super::{Argument, Bound, Lowerer, Reporting, limits};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::expr::op::Op;
use crate::num::rational::Rational;
use crate::syntax::ast::{Expr, Name};
use crate::syntax::functions;

/// The operation that is the whole of a function of one number.
fn plain_operation(name: &str) -> Option<Op> {
    Some(match name {
        "sin" => Op::Sin,
        "cos" => Op::Cos,
        "tan" => Op::Tan,
        "asin" => Op::Asin,
        "acos" => Op::Acos,
        "atan" => Op::Atan,
        "sinh" => Op::Sinh,
        "cosh" => Op::Cosh,
        "tanh" => Op::Tanh,
        "asinh" => Op::Asinh,
        "acosh" => Op::Acosh,
        "atanh" => Op::Atanh,
        "exp" => Op::Exp,
        "ln" => Op::Ln,
        "log2" => Op::Log2,
        "log10" => Op::Log10,
        "sqrt" => Op::Sqrt,
        "cbrt" => Op::Root(3),
        "sign" => Op::Sign,
        "floor" => Op::Floor,
        "erf" => Op::Erf,
        _ => return None,
    })
}

impl<'a> Lowerer<'a> {
    /// `name(args)`.
    pub(super) fn call(&mut self, name: &Name, args: &'a [Expr], span: Span) -> Reporting<Value> {
        if let Some(index) = self.names.function(&name.text) {
            return self.call_defined(index, name, args, span);
        }
        let Some(entry) = functions::find(&name.text) else {
            return Err(self.unknown_function(name));
        };
        let placed = self.placed_all(args);
        if args.len() < entry.least || entry.most.is_some_and(|most| args.len() > most) {
            return Err(self.wrong_count(name, entry.signature, args.len(), span));
        }
        self.built_in(&name.text, placed?, span)
    }

    fn placed_all(&mut self, args: &'a [Expr]) -> Reporting<Vec<Placed>> {
        let placed: Vec<_> = args.iter().map(|arg| self.placed(arg)).collect();
        placed.into_iter().collect()
    }

    fn wrong_count(&mut self, name: &Name, signature: &str, found: usize, span: Span) -> super::Reported {
        let message = format!("`{}` was given {}", name.text, arguments(found));
        self.report(Diagnostic::error(span, message).help(format!("it is `{signature}`")))
    }

    // table: the composite functions
    fn built_in(&mut self, name: &str, args: Vec<Placed>, span: Span) -> Reporting<Value> {
        match name {
            "if" => return self.conditional(args, span),
            "union" => return self.combine(Combination::Union, args, span),
            "intersection" => return self.combine(Combination::Intersection, args, span),
            "difference" => return self.combine(Combination::Difference, args, span),
            "smooth_union" => return self.smooth_union(args, span),
            "dot" | "cross" | "length" | "normalize" => return self.vector_function(name, args, span),
            "abs" => return self.absolute(args, span),
            _ => {}
        }
        let places: Vec<Span> = args.iter().map(|placed| placed.span).collect();
        let numbers: Vec<_> = args.into_iter().map(|placed| self.wanted_number(placed)).collect();
        let n = numbers.into_iter().collect::<Reporting<Vec<NodeId>>>()?;
        if let Some(op) = plain_operation(name) {
            return Ok(Value::Number(self.node(op, &n, span)));
        }
        Ok(Value::Number(match (name, n.as_slice()) {
            ("atan2", &[y, x]) => self.node(Op::Atan2, &[y, x], span),
            ("min", _) => self.fold(Op::Min, &n, span),
            ("max", _) => self.fold(Op::Max, &n, span),
            ("hypot", _) => self.length(&n, span),
            ("mod", &[a, b]) => self.modulo(a, b, span),
            ("frac", &[x]) => {
                let whole = self.node(Op::Floor, &[x], span);
                self.node(Op::Sub, &[x, whole], span)
            }
            ("ceil", &[x]) => {
                let minus = self.node(Op::Neg, &[x], span);
                let below = self.node(Op::Floor, &[minus], span);
                self.node(Op::Neg, &[below], span)
            }
            ("round", &[x]) => self.round(x, span),
            ("clamp", &[x, low, high]) => self.clamp(x, low, high, span),
            ("step", &[edge, x]) => {
                let ahead = self.node(Op::Sub, &[edge, x], span);
                let (one, zero) = (self.integer(1, span), self.integer(0, span));
                self.node(Op::Choose, &[ahead, one, zero], span)
            }
            ("smoothstep", &[low, high, x]) => self.smoothstep(low, high, x, span),
            ("log", &[x]) => self.node(Op::Log10, &[x], span),
            ("log", &[base, x]) => self.logarithm(base, x, span),
            ("root", &[n, x]) => {
                let n = self.whole(n, places[0], "the order of a root")?;
                self.root(n, places[0], x, span)?
            }
            ("chebyshev", &[n, x]) => {
                let n = self.degree(n, places[0])?;
                self.chebyshev(n, x, span)?
            }
            ("legendre", &[n, x]) => {
                let n = self.degree(n, places[0])?;
                self.legendre(n, x, span)?
            }
            ("ball", &[a, b, c, radius]) => return Ok(Value::Region(self.ball_region([a, b, c], radius, span))),
            _ => {
                let error = Diagnostic::error(span, format!("`{name}` cannot stand in a formula"));
                return Err(self.report(error.help("boxes and colours stand behind `clip:` and `color:`")));
            }
        }))
    }

    fn smooth_union(&mut self, mut args: Vec<Placed>, span: Span) -> Reporting<Value> {
        let radius = args.remove(0);
        let radius = self.wanted_number(radius)?;
        self.combine(Combination::SmoothUnion(radius), args, span)
    }

    fn absolute(&mut self, args: Vec<Placed>, span: Span) -> Reporting<Value> {
        match args.into_iter().next() {
            Some(placed) if !matches!(placed.value, Value::Vector(_)) => self.magnitude(placed, span),
            Some(placed) => {
                let error = Diagnostic::error(placed.span, "a vector stands where a number is wanted");
                Err(self.report(error.help("the length of a vector is `length(p)` or `|p|`")))
            }
            None => super::values::reported(),
        }
    }

    fn vector_function(&mut self, name: &str, args: Vec<Placed>, span: Span) -> Reporting<Value> {
        let vectors: Vec<_> = args.iter().map(|placed| self.wanted_vector(placed.clone())).collect();
        let vectors = vectors.into_iter().collect::<Reporting<Vec<Vec<NodeId>>>>()?;
        match (name, vectors.as_slice()) {
            ("dot", [a, b]) => {
                self.same_length(a.len(), b.len(), &args[0], &args[1], span)?;
                Ok(Value::Number(self.dot(a, b, span)))
            }
            ("cross", [a, b]) => match (a.len(), b.len()) {
                (3, 3) => Ok(self.cross(a, b, span)),
                _ => {
                    let error = Diagnostic::error(span, "`cross` wants two vectors of three numbers");
                    Err(self.report(error.help("write `(a, b, 0)` for a vector in the plane")))
                }
            },
            ("length", [a]) => Ok(Value::Number(self.length(a, span))),
            ("normalize", [a]) => {
                let length = self.length(a, span);
                Ok(Value::Vector(a.iter().map(|&a| self.node(Op::Div, &[a, length], span)).collect()))
            }
            _ => super::values::reported(),
        }
    }

    /// The points within `radius` of a centre: |p − c|² − radius².
    fn ball_region(&mut self, centre: [NodeId; 3], radius: NodeId, span: Span) -> Region {
        let mut terms = Vec::with_capacity(3);
        for (coordinate, c) in self.coordinates(span).into_iter().zip(centre) {
            let away = self.node(Op::Sub, &[coordinate, c], span);
            terms.push(self.integer_power(away, 2, span));
        }
        let square = self.fold(Op::Add, &terms, span);
        let reach = self.integer_power(radius, 2, span);
        Region { side: self.node(Op::Sub, &[square, reach], span), edge: Edge::Closed }
    }

    /// a − b·floor(a/b).
    pub(super) fn modulo(&mut self, a: NodeId, b: NodeId, span: Span) -> NodeId {
        let quotient = self.node(Op::Div, &[a, b], span);
        let whole = self.node(Op::Floor, &[quotient], span);
        let whole = self.node(Op::Mul, &[b, whole], span);
        self.node(Op::Sub, &[a, whole], span)
    }

    /// sign(x)·floor(|x| + 1/2): halves go away from zero.
    fn round(&mut self, x: NodeId, span: Span) -> NodeId {
        let sign = self.node(Op::Sign, &[x], span);
        let magnitude = self.node(Op::Abs, &[x], span);
        let half = self.quotient(1, 2, span);
        let raised = self.node(Op::Add, &[magnitude, half], span);
        let whole = self.node(Op::Floor, &[raised], span);
        self.node(Op::Mul, &[sign, whole], span)
    }

    fn clamp(&mut self, x: NodeId, low: NodeId, high: NodeId, span: Span) -> NodeId {
        let raised = self.node(Op::Max, &[x, low], span);
        self.node(Op::Min, &[raised, high], span)
    }

    /// t²·(3 − 2t) of t = (x − low)/(high − low) clamped to 0…1.
    fn smoothstep(&mut self, low: NodeId, high: NodeId, x: NodeId, span: Span) -> NodeId {
        let (risen, width) = (self.node(Op::Sub, &[x, low], span), self.node(Op::Sub, &[high, low], span));
        let t = self.node(Op::Div, &[risen, width], span);
        let (zero, one) = (self.integer(0, span), self.integer(1, span));
        let t = self.clamp(t, zero, one, span);
        let (two, three) = (self.integer(2, span), self.integer(3, span));
        let twice = self.node(Op::Mul, &[two, t], span);
        let rest = self.node(Op::Sub, &[three, twice], span);
        let square = self.integer_power(t, 2, span);
        self.node(Op::Mul, &[square, rest], span)
    }

    fn logarithm(&mut self, base: NodeId, x: NodeId, span: Span) -> NodeId {
        match self.graph.constant(base).and_then(Rational::to_i64) {
            Some(2) => self.node(Op::Log2, &[x], span),
            Some(10) => self.node(Op::Log10, &[x], span),
            _ if self.graph.op(base) == Op::E => self.node(Op::Ln, &[x], span),
            _ => {
                let (x, base) = (self.node(Op::Ln, &[x], span), self.node(Op::Ln, &[base], span));
                self.node(Op::Div, &[x, base], span)
            }
        }
    }

    /// A whole number that is known before drawing.
    pub(super) fn whole(&mut self, id: NodeId, place: Span, what: &str) -> Reporting<i64> {
        let Some(value) = self.graph.constant(id) else {
            let known = self.constant_value(id).is_some();
            let error = if known {
                Diagnostic::error(place, format!("{what} is a whole number")).help("take `floor(...)` or `round(...)`")
            } else {
                let message = format!("{what} is a number that is known before drawing");
                Diagnostic::error(place, message).help("it cannot hang on x, y or z")
            };
            return Err(self.report(error));
        };
        match value.to_i64() {
            Some(n) => Ok(n),
            None => {
                let message = format!("{what} is a whole number, and this is {}", super::cut(&value.to_string()));
                Err(self.report(Diagnostic::error(place, message).help("take `floor(...)` or `round(...)`")))
            }
        }
    }

    fn degree(&mut self, id: NodeId, place: Span) -> Reporting<i64> {
        let n = self.whole(id, place, "the degree")?;
        if n < 0 {
            return Err(self.report(Diagnostic::error(place, "the degree is 0 or more")));
        }
        Ok(n)
    }

    fn call_defined(&mut self, index: usize, name: &Name, args: &'a [Expr], span: Span) -> Reporting<Value> {
        let values: Vec<_> = args.iter().map(|arg| self.argument(|lowerer| lowerer.expr(arg))).collect();
        self.check_count(index, name, args.len(), span)?;
        self.applied(index, values.into_iter().collect::<Reporting<_>>()?, span)
    }

    fn argument(&mut self, lower: impl FnOnce(&mut Self) -> Reporting<Value>) -> Reporting<Argument> {
        let (value, varies) = self.watched(lower);
        Ok((value?, varies))
    }

    /// `f(x, y, z)` of names.
    pub(super) fn call_by_names(&mut self, name: &Name, args: &[Name], span: Span) -> Reporting<Value> {
        let values: Vec<_> =
            args.iter().map(|arg| self.argument(|lowerer| lowerer.name(&arg.text, arg.span))).collect();
        let Some(index) = self.names.function(&name.text) else { return super::values::reported() };
        self.check_count(index, name, args.len(), span)?;
        self.applied(index, values.into_iter().collect::<Reporting<_>>()?, span)
    }

    /// Refuses a wrong number of arguments of a program's function.
    fn check_count(&mut self, index: usize, name: &Name, found: usize, span: Span) -> Reporting<()> {
        let Some((parameters, _)) = self.names.list[index].as_function() else { return super::values::reported() };
        if found == parameters.len() {
            return Ok(());
        }
        let listed: Vec<&str> = parameters.iter().map(|parameter| parameter.text.as_str()).collect();
        let signature = format!("{}({})", name.text, listed.join(", "));
        let message = format!("`{}` was given {}", super::cut(&name.text), arguments(found));
        let error = Diagnostic::error(span, message).also(self.names.list[index].name.span, "defined here");
        Err(self.report(error.help(format!("it is `{}`", super::cut(&signature)))))
    }

    /// The body with values for the parameters; the same function of the same values is lowered once.
    pub(super) fn applied(&mut self, index: usize, values: Vec<Argument>, span: Span) -> Reporting<Value> {
        let Some((parameters, body)) = self.names.list[index].as_function() else { return super::values::reported() };
        if self.names.list[index].poisoned {
            return super::values::reported();
        }
        self.called[index] = true;
        let key = (index, values);
        if let Some((known, met)) = self.calls.get(&key) {
            self.met_coordinate |= met;
            return known.clone();
        }
        self.enter(span, limits::CALL_WEIGHT)?;
        let before = self.diagnostics.len();
        let arguments = key.1.iter().map(|(value, varies)| (Ok(value.clone()), *varies)).collect();
        let (value, met) = self.watched(|lowerer| lowerer.body(parameters, arguments, body));
        self.leave(limits::CALL_WEIGHT);
        self.mark_call(before, span);
        self.calls.insert(key, (value.clone(), met));
        value
    }

    /// The body with its parameters bound, and with no other bound name.
    fn body(
        &mut self,
        parameters: &'a [Name],
        values: Vec<(Reporting<Value>, bool)>,
        body: &'a Expr,
    ) -> Reporting<Value> {
        let frame = std::mem::replace(&mut self.frame, self.scope.len());
        let bound = parameters.iter().zip(values);
        self.scope.extend(bound.map(|(name, (value, varies))| Bound { name: &name.text, value, varies }));
        let value = self.expr(body);
        self.scope.truncate(self.frame);
        self.frame = frame;
        value
    }

    /// Looks for errors in functions that nothing calls: those that do not hang on what the arguments are.
    pub(super) fn check_uncalled(&mut self) {
        for index in 0..self.names.list.len() {
            let Some((parameters, body)) = self.names.list[index].as_function() else { continue };
            if !self.called[index] && !self.names.list[index].poisoned {
                // The value is not wanted, only what is reported on the way to it.
                let _ = self.body(parameters, vec![(super::values::reported(), true); parameters.len()], body);
            }
        }
    }

    /// Says in errors that arose inside a function's body which call brought them up, and which brought up that.
    fn mark_call(&mut self, before: usize, span: Span) {
        for diagnostic in &mut self.diagnostics[before..] {
            let calls = diagnostic.labels.iter().filter(|label| label.text == CALL).count();
            if calls < CALLS_SHOWN && diagnostic.labels.iter().all(|label| label.span != span) {
                diagnostic.labels.push(crate::diag::Label { span, text: CALL.to_owned() });
            }
        }
    }
}

/// The words at a call that brought up an error.
const CALL: &str = "in this call";

/// Calls shown with an error: the innermost ones tell most.
const CALLS_SHOWN: usize = 2;

fn arguments(count: usize) -> String {
    if count == 1 { "1 argument".to_owned() } else { format!("{count} arguments") }
}
