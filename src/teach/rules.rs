//! The rules of differentiation by their school names, one derivative at a time.
//!
//! In: a variable and a term. Out: the rule's key in the files of texts, and what it makes of the derivative: a term in which the
//! derivatives of the parts are still to be taken. Separate from `expr::derivative`, which takes them all at once and
//! shares what it can; the two are compared by values.

use super::term::Term;
use crate::expr::op::{Op, Variable};

/// The derivative of h at u, to be multiplied with that of u, or to be a divisor below it.
enum Outer {
    Times(Term),
    Below(Term),
}

/// What d/dv of u is, and by which rule: a key of the texts.
pub fn taken(v: Variable, u: Term) -> (&'static str, Term) {
    if !u.contains(v) {
        return ("rule.constant", Term::integer(0));
    }
    match u {
        Term::Letter(_) => ("rule.variable", Term::integer(1)),
        Term::Sum(list) => ("rule.sum", Term::Sum(list.into_iter().map(|t| t.derivative(v)).collect())),
        Term::Negative(a) => ("rule.multiple", a.derivative(v).negated()),
        Term::Product(list) => product(v, list),
        Term::Quotient(a, b) => quotient(v, *a, *b),
        Term::Power(a, n) => power(v, *a, n),
        Term::Apply(op, list) => applied(v, op, list),
        Term::Number(_) | Term::Derivative(..) => ("rule.constant", Term::integer(0)),
    }
}

fn product(v: Variable, list: Vec<Term>) -> (&'static str, Term) {
    let (moving, mut fixed): (Vec<Term>, Vec<Term>) = list.into_iter().partition(|t| t.contains(v));
    if !fixed.is_empty() {
        let rest = if moving.len() == 1 { moving[0].clone() } else { Term::Product(moving) };
        fixed.push(rest.derivative(v));
        return ("rule.multiple", Term::Product(fixed));
    }
    let turn = |k: usize| {
        let factor = |(i, t): (usize, &Term)| if i == k { t.clone().derivative(v) } else { t.clone() };
        Term::Product(moving.iter().enumerate().map(factor).collect())
    };
    ("rule.product", Term::Sum((0..moving.len()).map(turn).collect()))
}

fn quotient(v: Variable, a: Term, b: Term) -> (&'static str, Term) {
    if !b.contains(v) {
        return ("rule.multiple", a.derivative(v).over(b));
    }
    let square = b.clone().to_power(2);
    if !a.contains(v) {
        return ("rule.reciprocal", Term::Product(vec![a, b.derivative(v)]).over(square).negated());
    }
    let first = Term::Product(vec![a.clone().derivative(v), b.clone()]);
    let second = Term::Product(vec![a, b.derivative(v)]);
    ("rule.quotient", Term::Sum(vec![first, second.negated()]).over(square))
}

fn power(v: Variable, a: Term, n: i64) -> (&'static str, Term) {
    let lower = if n == 2 { a.clone() } else { a.clone().to_power(n.saturating_sub(1)) };
    let slope = vec![Term::integer(n), lower];
    if a == Term::Letter(Op::Variable(v)) {
        return ("rule.power", Term::Product(slope));
    }
    ("rule.chain.power", chained(v, Outer::Times(Term::Product(slope)), a))
}

/// h'(u) · u'.
fn chained(v: Variable, outer: Outer, a: Term) -> Term {
    let is_bare = a == Term::Letter(Op::Variable(v));
    match outer {
        Outer::Times(slope) if is_bare => slope,
        Outer::Times(slope) => {
            let mut factors = if let Term::Product(list) = slope { list } else { vec![slope] };
            factors.push(a.derivative(v));
            Term::Product(factors)
        }
        Outer::Below(divisor) if is_bare => Term::integer(1).over(divisor),
        Outer::Below(divisor) => a.derivative(v).over(divisor),
    }
}

fn applied(v: Variable, op: Op, list: Vec<Term>) -> (&'static str, Term) {
    let mut list = list.into_iter();
    let mut next = || list.next().unwrap_or(Term::integer(0));
    match op {
        Op::Pow => {
            let a = next();
            general_power(v, a, next())
        }
        Op::Min | Op::Max => {
            let (a, b) = (next(), next());
            let (low, high) = if op == Op::Min { (a.clone(), b.clone()) } else { (b.clone(), a.clone()) };
            let difference = Term::Sum(vec![low, high.negated()]);
            ("rule.branch", Term::Apply(Op::Choose, vec![difference, a.derivative(v), b.derivative(v)]))
        }
        Op::Choose => {
            let (c, a, b) = (next(), next(), next());
            ("rule.branch", Term::Apply(Op::Choose, vec![c, a.derivative(v), b.derivative(v)]))
        }
        Op::Atan2 => {
            let (a, b) = (next(), next());
            let first = Term::Product(vec![b.clone(), a.clone().derivative(v)]);
            let second = Term::Product(vec![a.clone(), b.clone().derivative(v)]);
            let square = Term::Sum(vec![a.to_power(2), b.to_power(2)]);
            ("rule.angle", Term::Sum(vec![first, second.negated()]).over(square))
        }
        Op::Sign | Op::Floor | Op::FloorDiv(_) => ("rule.steps", Term::integer(0)),
        op => {
            let a = next();
            let is_bare = a == Term::Letter(Op::Variable(v));
            let (name, chain, outer) = slope(op, &a);
            (if is_bare { name } else { chain }, chained(v, outer, a))
        }
    }
}

/// (a^b)' where the exponent is no whole number.
fn general_power(v: Variable, a: Term, b: Term) -> (&'static str, Term) {
    let u = Term::Apply(Op::Pow, vec![a.clone(), b.clone()]);
    if !b.contains(v) {
        let less = Term::Sum(vec![b.clone(), Term::integer(-1)]);
        let slope = Term::Product(vec![b, Term::Apply(Op::Pow, vec![a.clone(), less])]);
        return ("rule.chain.power", chained(v, Outer::Times(slope), a));
    }
    let logarithm = Term::call(Op::Ln, a.clone());
    if !a.contains(v) {
        return ("rule.exponential", Term::Product(vec![u, logarithm, b.derivative(v)]));
    }
    let first = Term::Product(vec![b.clone().derivative(v), logarithm]);
    let second = Term::Product(vec![b, a.clone().derivative(v)]).over(a);
    ("rule.logarithmic", Term::Product(vec![u, Term::Sum(vec![first, second])]))
}

// table: one line a function.
/// The rule of a function of one argument: its name, its name with the chain rule, and its derivative.
fn slope(op: Op, a: &Term) -> (&'static str, &'static str, Outer) {
    let u = || Term::call(op, a.clone());
    let call = |op: Op| Term::call(op, a.clone());
    let one = || Term::integer(1);
    let square = || a.clone().to_power(2);
    let ratio = |n: i64| Outer::Below(Term::Product(vec![a.clone(), Term::call(Op::Ln, Term::integer(n))]));
    let root = |inside: Vec<Term>| Term::call(Op::Sqrt, Term::Sum(inside));
    match op {
        Op::Sin => ("rule.sin", "rule.chain.sin", Outer::Times(call(Op::Cos))),
        Op::Cos => ("rule.cos", "rule.chain.cos", Outer::Times(call(Op::Sin).negated())),
        Op::Tan => ("rule.tan", "rule.chain.tan", Outer::Times(Term::Sum(vec![one(), u().to_power(2)]))),
        Op::Exp => ("rule.exp", "rule.chain.exp", Outer::Times(u())),
        Op::Ln => ("rule.ln", "rule.chain.ln", Outer::Below(a.clone())),
        Op::Log2 => ("rule.log", "rule.chain.log", ratio(2)),
        Op::Log10 => ("rule.log", "rule.chain.log", ratio(10)),
        Op::Sqrt => ("rule.sqrt", "rule.chain.sqrt", Outer::Below(Term::Product(vec![Term::integer(2), u()]))),
        Op::Root(n) => {
            let divisor = Term::Product(vec![Term::integer(i64::from(n)), u().to_power(i64::from(n) - 1)]);
            ("rule.sqrt", "rule.chain.sqrt", Outer::Below(divisor))
        }
        Op::Asin => ("rule.asin", "rule.chain.asin", Outer::Below(root(vec![one(), square().negated()]))),
        Op::Acos => {
            let below = root(vec![one(), square().negated()]).negated();
            ("rule.acos", "rule.chain.acos", Outer::Below(below))
        }
        Op::Atan => ("rule.atan", "rule.chain.atan", Outer::Below(Term::Sum(vec![one(), square()]))),
        Op::Sinh => ("rule.hyperbolic", "rule.chain.hyperbolic", Outer::Times(call(Op::Cosh))),
        Op::Cosh => ("rule.hyperbolic", "rule.chain.hyperbolic", Outer::Times(call(Op::Sinh))),
        Op::Tanh => {
            let slope = Term::Sum(vec![one(), u().to_power(2).negated()]);
            ("rule.hyperbolic", "rule.chain.hyperbolic", Outer::Times(slope))
        }
        Op::Asinh => ("rule.area", "rule.chain.area", Outer::Below(root(vec![square(), one()]))),
        Op::Acosh => ("rule.area", "rule.chain.area", Outer::Below(root(vec![square(), one().negated()]))),
        Op::Atanh => ("rule.area", "rule.chain.area", Outer::Below(Term::Sum(vec![one(), square().negated()]))),
        Op::Erf => {
            let front = Term::integer(2).over(Term::call(Op::Sqrt, Term::Letter(Op::Pi)));
            let bell = Term::call(Op::Exp, square().negated());
            ("rule.erf", "rule.chain.erf", Outer::Times(Term::Product(vec![front, bell])))
        }
        Op::Abs => ("rule.abs", "rule.chain.abs", Outer::Times(call(Op::Sign))),
        // These are written as terms of their own, or have rules of their own.
        Op::Constant(_) | Op::Pi | Op::E | Op::Variable(_) | Op::Neg | Op::Add | Op::Sub | Op::Mul | Op::Div => {
            ("rule.constant", "rule.constant", Outer::Times(Term::integer(0)))
        }
        Op::Power(_)
        | Op::Pow
        | Op::Min
        | Op::Max
        | Op::Choose
        | Op::Atan2
        | Op::Sign
        | Op::Floor
        | Op::FloorDiv(_) => ("rule.constant", "rule.constant", Outer::Times(Term::integer(0))),
    }
}
