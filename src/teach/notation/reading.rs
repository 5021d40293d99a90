//! A program's statement as it was read: all brackets, nothing left to precedence.
//!
//! In: the tree of a statement. Out: its form. Separate from terms, because here stand names, functions of the program's
//! own, regions, vectors and lists, as they were typed.

use super::{Binding, Form, Sign, number};
use crate::syntax::ast::{Comparison, Expr, ExprKind, FactorOp, Statement, StatementKind, UnaryOp};
use crate::syntax::print;

/// The form of a statement; what is no formula (a block, an include) is its text.
pub fn statement(statement: &Statement) -> Form {
    match &statement.kind {
        StatementKind::Surface { left, right: Some(right), .. } => Form::equation(bare(left), bare(right)),
        StatementKind::Surface { left, right: None, .. } => bare(left),
        StatementKind::Definition { name, value } => Form::equation(Form::name(&name.text), bare(value)),
        StatementKind::Function { name, parameters, body } => {
            let list = parameters.iter().map(|parameter| Form::name(&parameter.text)).collect();
            Form::equation(Form::Call(name.text.clone(), list), bare(body))
        }
        StatementKind::Parameter { name, value, .. } => Form::equation(Form::name(&name.text), bare(value)),
        StatementKind::Block { .. } | StatementKind::Include { .. } => {
            Form::Word(print::bracketed_statement(statement))
        }
    }
}

/// An operand: in brackets unless it is a name, a number or a call.
fn operand(value: &Expr) -> Form {
    bare(value).within(Binding::Atom)
}

fn bare(value: &Expr) -> Form {
    match &value.kind {
        ExprKind::Number(value) => number(value),
        ExprKind::Name(name) => Form::name(name),
        ExprKind::Unary(UnaryOp::Neg, a) => Form::Row(Binding::Sum, vec![Form::Sign(Sign::Negative), operand(a)]),
        ExprKind::Unary(UnaryOp::Plus, a) => operand(a),
        ExprKind::Unary(UnaryOp::Not, a) => Form::Row(Binding::Statement, vec![Form::Word("not".into()), operand(a)]),
        ExprKind::Sum(terms) => {
            let sign = |minus: bool| if minus { Sign::Minus } else { Sign::Plus };
            let list = terms.iter().map(|term| (Form::Sign(sign(term.minus)), operand(&term.value)));
            nested(Binding::Sum, list, terms.first().is_some_and(|term| term.minus))
        }
        ExprKind::Product(_) => product(value),
        ExprKind::Power(a, b) => Form::Raised(Box::new(operand(a)), Box::new(bare(b))),
        ExprKind::And(list) => words(list, "and"),
        ExprKind::Or(list) => words(list, "or"),
        ExprKind::Chain(list, signs) => chain(list, signs),
        ExprKind::Bars(a) => Form::Bars(Box::new(bare(a))),
        ExprKind::Call(name, list) => Form::Call(name.text.clone(), list.iter().map(bare).collect()),
        ExprKind::Vector(list) => Form::Call(String::new(), list.iter().map(bare).collect()),
        ExprKind::List(_) | ExprKind::Component(..) | ExprKind::Series { .. } | ExprKind::Invalid => {
            Form::Word(print::bracketed(value))
        }
    }
}

/// Brackets around each two members from the left.
fn nested(binding: Binding, list: impl Iterator<Item = (Form, Form)>, is_negative: bool) -> Form {
    let mut row = Vec::new();
    for (i, (sign, member)) in list.enumerate() {
        if i > 1 {
            row = vec![Form::Brackets(Box::new(Form::Row(binding, row)))];
        }
        match i {
            0 if is_negative => row.push(Form::Sign(Sign::Negative)),
            0 => {}
            _ => row.push(sign),
        }
        row.push(member);
    }
    Form::Row(binding, row)
}

fn product(value: &Expr) -> Form {
    let ExprKind::Product(factors) = &value.kind else { return bare(value) };
    let mut left: Option<Form> = None;
    for factor in factors {
        left = Some(match (left, factor.operator) {
            (None, _) => operand(&factor.value),
            (Some(left), FactorOp::Mul) => Form::Row(
                Binding::Product,
                vec![left.within(Binding::Atom), Form::Sign(Sign::Times), operand(&factor.value)],
            ),
            (Some(left), FactorOp::Div) => Form::Fraction(Box::new(left), Box::new(bare(&factor.value))),
            (Some(left), FactorOp::Mod) => Form::Call("mod".into(), vec![left, bare(&factor.value)]),
        });
    }
    left.unwrap_or(Form::Number("1".into()))
}

fn words(list: &[Expr], word: &str) -> Form {
    let mut row = Vec::new();
    for (i, member) in list.iter().enumerate() {
        if i > 0 {
            row.push(Form::Word(word.into()));
        }
        row.push(operand(member));
    }
    Form::Row(Binding::Statement, row)
}

fn chain(list: &[Expr], signs: &[Comparison]) -> Form {
    let mut row = Vec::new();
    for (i, member) in list.iter().enumerate() {
        row.push(bare(member));
        row.extend(signs.get(i).map(|sign| {
            Form::Sign(match sign {
                Comparison::Less => Sign::Less,
                Comparison::LessEqual => Sign::AtMost,
                Comparison::Greater => Sign::Greater,
                Comparison::GreaterEqual => Sign::AtLeast,
            })
        }));
    }
    Form::Row(Binding::Statement, row)
}
