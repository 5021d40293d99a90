//! How a formula is set, before it is known where: on a terminal, in LaTeX, in MathML.
//!
//! In: a term, or a statement as it was read. Out: a [`Form`]: rows, fractions, exponents, roots, calls. [`text`] writes
//! it in the program's own language, [`latex`] and [`mathml`] in those. Separate from the term, which knows no brackets.

pub mod latex;
pub mod mathml;
pub mod reading;
pub mod text;

use super::term::Term;
use crate::expr::op::{Op, Variable};
use crate::num::rational::Rational;

/// How tightly a form binds, loosest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Binding {
    /// `a = b`, `a <= b`, `a and b`
    Statement,
    /// `a + b`, `-a`
    Sum,
    /// `a*b`
    Product,
    /// `a^b`
    Power,
    /// `f(a)`, `x`, `2`
    Atom,
}

/// Signs between forms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// =
    Equal,
    /// +
    Plus,
    /// − with something before it.
    Minus,
    /// − in front.
    Negative,
    /// Multiplication.
    Times,
    /// ≤
    AtMost,
    /// ≥
    AtLeast,
    /// <
    Less,
    /// >
    Greater,
    /// A comma.
    Comma,
}

/// A formula as it is set.
#[derive(Clone, Debug, PartialEq)]
pub enum Form {
    /// A number as decimal, ≥ 0.
    Number(String),
    /// A name: a letter, π, or a word.
    Name(String),
    /// A word between formulas, such as `and`.
    Word(String),
    /// A sign.
    Sign(Sign),
    /// Side by side.
    Row(Binding, Vec<Form>),
    /// a over b.
    Fraction(Box<Form>, Box<Form>),
    /// a to the power b.
    Raised(Box<Form>, Box<Form>),
    /// a with the index b.
    Lowered(Box<Form>, Box<Form>),
    /// The root of an order, 2 where none is said.
    Root(Option<u32>, Box<Form>),
    /// |a|.
    Bars(Box<Form>),
    /// ⌊a⌋.
    Floor(Box<Form>),
    /// (a).
    Brackets(Box<Form>),
    /// A function by its name in the language, and its arguments.
    Call(String, Vec<Form>),
    /// a where c ≤ 0, else b: (c, a, b).
    Cases(Box<[Form; 3]>),
    /// d/dv of a.
    Derivative(&'static str, Box<Form>),
}

impl Form {
    /// A letter or a word.
    pub fn name(name: &str) -> Form {
        Form::Name(name.to_owned())
    }

    /// a = b.
    pub fn equation(a: Form, b: Form) -> Form {
        Form::Row(Binding::Statement, vec![a, Form::Sign(Sign::Equal), b])
    }

    /// f with a variable as its index.
    pub fn partial(variable: Variable) -> Form {
        Form::Lowered(Box::new(Form::name("f")), Box::new(Form::name(letter(variable))))
    }

    /// How tightly it binds.
    pub fn binding(&self) -> Binding {
        match self {
            Form::Row(binding, _) => *binding,
            Form::Fraction(..) => Binding::Product,
            Form::Raised(..) => Binding::Power,
            Form::Derivative(..) => Binding::Product,
            Form::Number(_) | Form::Name(_) | Form::Word(_) | Form::Sign(_) | Form::Lowered(..) | Form::Root(..) => {
                Binding::Atom
            }
            Form::Bars(_) | Form::Floor(_) | Form::Brackets(_) | Form::Call(..) | Form::Cases(_) => Binding::Atom,
        }
    }

    /// In brackets if it binds more loosely than this.
    fn within(self, least: Binding) -> Form {
        if self.binding() < least { Form::Brackets(Box::new(self)) } else { self }
    }

    /// A term as it is set.
    pub fn of(term: &Term) -> Form {
        match term {
            Term::Number(value) => number(value),
            Term::Letter(op) => Form::name(letter_of(*op)),
            Term::Sum(list) => sum(list),
            Term::Negative(a) => {
                Form::Row(Binding::Sum, vec![Form::Sign(Sign::Negative), Form::of(a).within(Binding::Product)])
            }
            Term::Product(list) => product(list),
            Term::Quotient(a, b) => Form::Fraction(Box::new(Form::of(a)), Box::new(Form::of(b))),
            Term::Power(a, n) => raised(a, number(&Rational::from_integer(*n))),
            Term::Derivative(v, a) => Form::Derivative(letter(*v), Box::new(Form::of(a))),
            Term::Apply(op, list) => applied(*op, list),
        }
    }
}

/// The name of a variable.
pub fn letter(variable: Variable) -> &'static str {
    match variable {
        Variable::X => "x",
        Variable::Y => "y",
        Variable::Z => "z",
        Variable::DX => "a",
        Variable::DY => "b",
        Variable::DZ => "c",
    }
}

fn letter_of(op: Op) -> &'static str {
    match op {
        Op::Pi => "pi",
        Op::Variable(variable) => letter(variable),
        _ => "e",
    }
}

/// A number: a decimal where it has a short one, else a fraction.
pub fn number(value: &Rational) -> Form {
    let text = value.absolute().to_string();
    let size = match text.split_once('/') {
        Some((p, q)) => Form::Fraction(Box::new(Form::Number(p.into())), Box::new(Form::Number(q.into()))),
        None => Form::Number(text),
    };
    match value.is_negative() {
        true => Form::Row(Binding::Sum, vec![Form::Sign(Sign::Negative), size]),
        false => size,
    }
}

fn sum(list: &[Term]) -> Form {
    let mut row = Vec::new();
    for (i, member) in list.iter().enumerate() {
        let (sign, shown) = match member {
            Term::Negative(a) => (Sign::Minus, Form::of(a).within(Binding::Product)),
            Term::Number(value) if value.is_negative() => (Sign::Minus, number(&value.negated())),
            other => (Sign::Plus, Form::of(other).within(Binding::Product)),
        };
        match (i, sign) {
            (0, Sign::Minus) => row.push(Form::Sign(Sign::Negative)),
            (0, _) => {}
            _ => row.push(Form::Sign(sign)),
        }
        row.push(shown);
    }
    Form::Row(Binding::Sum, row)
}

fn product(list: &[Term]) -> Form {
    let mut row = Vec::new();
    for (i, factor) in list.iter().enumerate() {
        if i > 0 {
            row.push(Form::Sign(Sign::Times));
        }
        row.push(Form::of(factor).within(Binding::Product));
    }
    Form::Row(Binding::Product, row)
}

fn raised(base: &Term, exponent: Form) -> Form {
    Form::Raised(Box::new(Form::of(base).within(Binding::Atom)), Box::new(exponent))
}

fn applied(op: Op, list: &[Term]) -> Form {
    let form = |k: usize| list.get(k).map_or(Form::Number("0".into()), Form::of);
    let boxed = |k: usize| Box::new(form(k));
    match op {
        Op::Sqrt => Form::Root(None, boxed(0)),
        Op::Root(n) => Form::Root(Some(n), boxed(0)),
        Op::Abs => Form::Bars(boxed(0)),
        Op::Floor => Form::Floor(boxed(0)),
        Op::FloorDiv(n) => {
            let above =
                if n == 1 { form(0) } else { Form::of(&Term::Product(vec![Term::integer(n), list[0].clone()])) };
            Form::Floor(Box::new(Form::Fraction(Box::new(above), boxed(1))))
        }
        Op::Pow => raised(&list[0], form(1)),
        Op::Choose => Form::Cases(Box::new([form(0), form(1), form(2)])),
        op => Form::Call(function(op).to_owned(), list.iter().map(Form::of).collect()),
    }
}

/// The name of a function in the language; empty for what is written otherwise.
pub fn function(op: Op) -> &'static str {
    match op {
        Op::Sign => "sign",
        Op::Exp => "exp",
        Op::Ln => "ln",
        Op::Log2 => "log2",
        Op::Log10 => "log10",
        Op::Sin => "sin",
        Op::Cos => "cos",
        Op::Tan => "tan",
        Op::Asin => "asin",
        Op::Acos => "acos",
        Op::Atan => "atan",
        Op::Sinh => "sinh",
        Op::Cosh => "cosh",
        Op::Tanh => "tanh",
        Op::Asinh => "asinh",
        Op::Acosh => "acosh",
        Op::Atanh => "atanh",
        Op::Erf => "erf",
        Op::Min => "min",
        Op::Max => "max",
        Op::Atan2 => "atan2",
        Op::Abs => "abs",
        Op::Sqrt => "sqrt",
        Op::Root(_) => "root",
        Op::Floor | Op::FloorDiv(_) => "floor",
        Op::Choose => "if",
        Op::Constant(_) | Op::Pi | Op::E | Op::Variable(_) => "",
        Op::Neg | Op::Power(_) | Op::Add | Op::Sub | Op::Mul | Op::Div | Op::Pow => "",
    }
}

#[cfg(test)]
mod tests;
