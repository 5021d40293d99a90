//! The names a program declares: which are there, what hangs on what, and in which order they are lowered.
//!
//! In: the statements. Out: a table of declarations and an order in which each stands after those it
//! needs, so that lowering follows no chain of names by recursion. Circles and double definitions are found here.

use super::limits::MAX_CHAIN;
use super::{cut, meanings};
use crate::diag::{Diagnostic, Span};
use crate::syntax::ast::{Expr, ExprKind, Name, Program, SeriesRange, Statement, StatementKind};
use crate::syntax::{READY, functions, print};
use std::collections::HashMap;

/// Circles reported at most: each takes time to follow, and nobody reads more.
const MAX_CIRCLES: usize = 20;

/// A name that the program gives a meaning.
pub(super) struct Declaration<'a> {
    pub(super) name: &'a Name,
    pub(super) kind: DeclarationKind<'a>,
    /// Whether it cannot be used, and that was said.
    pub(super) poisoned: bool,
}

/// What a declaration says.
#[derive(Clone, Copy)]
pub(super) enum DeclarationKind<'a> {
    /// `name = value`
    Value(&'a Expr),
    /// `name(parameters) = body`
    Function(&'a [Name], &'a Expr),
    /// `name = value in [low, high] step step`
    Parameter { value: &'a Expr, low: &'a Expr, high: &'a Expr, step: Option<&'a Expr>, span: Span },
}

impl<'a> Declaration<'a> {
    /// Whether it may be set from outside.
    pub(super) fn is_parameter(&self) -> bool {
        matches!(self.kind, DeclarationKind::Parameter { .. })
    }

    /// The parameters and the body, if it is a function.
    pub(super) fn as_function(&self) -> Option<(&'a [Name], &'a Expr)> {
        match self.kind {
            DeclarationKind::Function(parameters, body) => Some((parameters, body)),
            DeclarationKind::Value(_) | DeclarationKind::Parameter { .. } => None,
        }
    }
}

/// All declarations of a program.
#[derive(Default)]
pub(super) struct Names<'a> {
    pub(super) list: Vec<Declaration<'a>>,
    index: HashMap<&'a str, usize>,
    /// Every declaration that can be lowered, after those it needs.
    pub(super) order: Vec<usize>,
    /// Of each statement whether it is an equation though it looks like a function: `f(x, y, z) = 0` where f is
    /// defined before.
    pub(super) equations: Vec<bool>,
    /// How many circles were reported.
    circles: usize,
}

impl<'a> Names<'a> {
    /// The table of a program, and what is wrong with its names.
    pub(super) fn collect(program: &'a Program) -> (Self, Vec<Diagnostic>) {
        let mut names = Names { equations: vec![false; program.statements.len()], ..Names::default() };
        let mut diagnostics = Vec::new();
        let mut again = Vec::new();
        for (position, statement) in program.statements.iter().enumerate() {
            if let Some((name, kind)) = declaration(statement) {
                match names.find(&name.text) {
                    Some(first) => again.push((position, first, Declaration { name, kind, poisoned: false })),
                    None => names.declare(name, kind, &mut diagnostics),
                }
            }
        }
        for (position, first, second) in again {
            names.equations[position] = names.is_equation(first, &second);
            if !names.equations[position] {
                diagnostics.push(names.defined_twice(first, &second));
            }
        }
        names.sort(&mut diagnostics);
        (names, diagnostics)
    }

    /// The declaration of a name.
    pub(super) fn find(&self, name: &str) -> Option<usize> {
        self.index.get(name).copied()
    }

    /// The declaration of a function.
    pub(super) fn function(&self, name: &str) -> Option<usize> {
        self.find(name).filter(|&index| self.list[index].as_function().is_some())
    }

    fn declare(&mut self, name: &'a Name, kind: DeclarationKind<'a>, diagnostics: &mut Vec<Diagnostic>) {
        if !matches!(kind, DeclarationKind::Function(..)) {
            diagnostics.extend(note_of_ready_name(name));
        }
        self.index.insert(&name.text, self.list.len());
        self.list.push(Declaration { name, kind, poisoned: false });
    }

    fn defined_twice(&self, first: usize, second: &Declaration<'a>) -> Diagnostic {
        let name = cut(&second.name.text);
        let error = Diagnostic::error(second.name.span, format!("`{name}` is defined twice"));
        let error = error.also(self.list[first].name.span, "first defined here");
        match second.kind {
            // A definition with a block behind it was not read.
            DeclarationKind::Value(Expr { kind: ExprKind::Invalid, .. }) if self.is_formula(first) => error.help(
                format!("to draw a surface where `{name}` has a value write the value first, as in `1 = {name}`"),
            ),
            DeclarationKind::Value(value) if self.is_formula(first) => {
                let value = cut(&print::expression(value));
                error.help(format!("to draw the surface where `{name}` is {value} write `{value} = {name}`; else give one of the two another name"))
            }
            _ => error.help("give one of the two another name"),
        }
    }

    /// Whether a definition changes from place to place by what it says itself.
    fn is_formula(&self, index: usize) -> bool {
        let DeclarationKind::Value(value) = self.list[index].kind else { return false };
        let mut has_place = false;
        let is_place = |name: &str| matches!(name, "x" | "y" | "z") || READY.contains(&name);
        each_name(value, &mut Vec::new(), &mut |name| has_place |= is_place(name) && self.find(name).is_none());
        has_place
    }

    /// Whether a second `f(x, y, z) = …` says where the function `first` has that value: its arguments are known.
    fn is_equation(&self, first: usize, second: &Declaration<'a>) -> bool {
        match (self.list[first].as_function(), second.as_function()) {
            (Some(_), Some((arguments, _))) => arguments.iter().all(|argument| {
                let name = argument.text.as_str();
                matches!(name, "x" | "y" | "z") || meanings::ready_meaning(name).is_some() || self.find(name).is_some()
            }),
            _ => false,
        }
    }

    /// The declarations that one needs, in the order in which its text names them.
    fn needs(&self, index: usize) -> Vec<usize> {
        let mut needed = Vec::new();
        let mut add = |name: &str| needed.extend(self.index.get(name));
        let mut bound = Vec::new();
        match self.list[index].kind {
            DeclarationKind::Value(value) => each_name(value, &mut bound, &mut add),
            DeclarationKind::Function(parameters, body) => {
                bound.extend(parameters.iter().map(|name| name.text.as_str()));
                each_name(body, &mut bound, &mut add);
            }
            DeclarationKind::Parameter { value, low, high, step, .. } => {
                for part in [Some(value), Some(low), Some(high), step].into_iter().flatten() {
                    each_name(part, &mut bound, &mut add);
                }
            }
        }
        needed
    }

    /// Depth-first search with a stack of its own (Cormen et al., "Introduction to Algorithms", 22.4): a
    /// name met again while it is still open closes a circle.
    fn sort(&mut self, diagnostics: &mut Vec<Diagnostic>) {
        let mut state = vec![State::New; self.list.len()];
        let mut chain = vec![0u32; self.list.len()];
        for start in 0..self.list.len() {
            if state[start] != State::New {
                continue;
            }
            let mut open = vec![(start, self.needs(start), 0)];
            state[start] = State::Open;
            while let Some((index, needs, next)) = open.last_mut() {
                let (index, need) = (*index, needs.get(*next).copied());
                *next += 1;
                match need {
                    Some(need) if state[need] == State::New => {
                        state[need] = State::Open;
                        open.push((need, self.needs(need), 0));
                    }
                    Some(need) if state[need] == State::Open => {
                        if !self.list[need].poisoned && self.circles < MAX_CIRCLES {
                            let from = open.iter().position(|(other, ..)| *other == need).unwrap_or(0);
                            let circle: Vec<usize> = open[from..].iter().map(|(other, ..)| *other).collect();
                            self.refuse_circle(&circle, diagnostics);
                        }
                        self.list[need].poisoned = true;
                    }
                    Some(need) => chain[index] = chain[index].max(chain[need] + 1),
                    None => {
                        state[index] = State::Done;
                        self.order.push(index);
                        open.pop();
                        if let Some((user, ..)) = open.last() {
                            chain[*user] = chain[*user].max(chain[index] + 1);
                        }
                    }
                }
            }
        }
        self.refuse_long_chain(&chain, diagnostics);
    }

    /// Reports a circle. None of its names can be used.
    fn refuse_circle(&mut self, circle: &[usize], diagnostics: &mut Vec<Diagnostic>) {
        for &index in circle {
            self.list[index].poisoned = true;
        }
        self.circles += 1;
        // A circle of a thousand names is told by its first few.
        const SHOWN: usize = 8;
        let mut way: Vec<String> =
            circle.iter().take(SHOWN).map(|&i| format!("`{}`", cut(&self.list[i].name.text))).collect();
        if circle.len() > SHOWN {
            way.push("...".to_owned());
        }
        way.extend(way.first().cloned());
        let first = &self.list[circle[0]];
        let error = if circle.len() == 1 && first.as_function().is_some() {
            let message = format!("the function `{}` calls itself", cut(&first.name.text));
            Diagnostic::error(first.name.span, message).help("a formula has no recursion; `sum(k = 1..n, ...)` repeats")
        } else if circle.len() == 1 {
            let message = format!("`{}` is defined by itself", cut(&first.name.text));
            let help =
                format!("for the surface where both sides are equal write `{0} - (...) = 0`", cut(&first.name.text));
            Diagnostic::error(first.name.span, message).help(help)
        } else {
            let message = format!("these definitions need each other in a circle: {}", way.join(" → "));
            let error = Diagnostic::error(first.name.span, message).help("one of them must stand without the others");
            let others = circle[1..].iter().take(SHOWN - 1);
            others.fold(error, |error, &index| error.also(self.list[index].name.span, "needed here on the way"))
        };
        diagnostics.push(error);
    }

    fn refuse_long_chain(&mut self, chain: &[u32], diagnostics: &mut Vec<Diagnostic>) {
        let mut said = false;
        for index in 0..self.list.len() {
            if chain[index] > MAX_CHAIN && !self.list[index].poisoned {
                self.list[index].poisoned = true;
                if chain[index] == MAX_CHAIN + 1 && !std::mem::replace(&mut said, true) {
                    let message = format!("more than {MAX_CHAIN} definitions stand on each other here");
                    let error = Diagnostic::error(self.list[index].name.span, message);
                    diagnostics.push(error.help("write some of them out, or use `sum` and `product`"));
                }
            }
        }
    }
}

/// The name a statement declares, and as what.
fn declaration(statement: &Statement) -> Option<(&Name, DeclarationKind<'_>)> {
    match &statement.kind {
        StatementKind::Definition { name, value } => Some((name, DeclarationKind::Value(value))),
        StatementKind::Function { name, parameters, body } => Some((name, DeclarationKind::Function(parameters, body))),
        StatementKind::Parameter { name, value, low, high, step } => {
            let step = step.as_ref();
            Some((name, DeclarationKind::Parameter { value, low, high, step, span: statement.span }))
        }
        StatementKind::Surface { .. } | StatementKind::Block { .. } | StatementKind::Include { .. } => None,
    }
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    Open,
    Done,
}

/// Reading `r` as the program's own name is worth a note, since it has a meaning without one.
fn note_of_ready_name(name: &Name) -> Option<Diagnostic> {
    let meaning = meanings::ready_meaning(&name.text)?;
    let message = format!("`{0}` is read as the program's own {0}, not as `{meaning}`", name.text);
    Some(Diagnostic::note(name.span, message).help(format!("write `{meaning}`, or take another name for your own")))
}

/// Calls `look` with every name of an expression that is not bound by a series or by `bound`.
fn each_name<'e>(expr: &'e Expr, bound: &mut Vec<&'e str>, look: &mut dyn FnMut(&str)) {
    match &expr.kind {
        ExprKind::Number(_) | ExprKind::Invalid => {}
        ExprKind::Name(name) => {
            if !bound.contains(&name.as_str()) {
                look(name);
            }
        }
        ExprKind::Unary(_, a) | ExprKind::Bars(a) | ExprKind::Component(a, _) => each_name(a, bound, look),
        ExprKind::Sum(terms) => terms.iter().for_each(|term| each_name(&term.value, bound, look)),
        ExprKind::Product(factors) => factors.iter().for_each(|factor| each_name(&factor.value, bound, look)),
        ExprKind::Power(a, b) => {
            each_name(a, bound, look);
            each_name(b, bound, look);
        }
        ExprKind::Call(name, args) => {
            if !functions::is_of_attributes(&name.text) {
                look(&name.text);
            }
            args.iter().for_each(|arg| each_name(arg, bound, look));
        }
        ExprKind::And(items)
        | ExprKind::Or(items)
        | ExprKind::Chain(items, _)
        | ExprKind::Vector(items)
        | ExprKind::List(items) => items.iter().for_each(|item| each_name(item, bound, look)),
        ExprKind::Series { variable, over, body, .. } => {
            match over {
                SeriesRange::Integers(low, high) => {
                    each_name(low, bound, look);
                    each_name(high, bound, look);
                }
                SeriesRange::List(list) => each_name(list, bound, look),
            }
            bound.push(&variable.text);
            each_name(body, bound, look);
            bound.pop();
        }
    }
}
