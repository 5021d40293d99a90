//! A formula as a person writes it: flat sums and products, quotients, and derivatives that are still to be taken.
//!
//! In: a node of the graph. Out: a [`Term`], and from a term a node again. Separate from the graph because a
//! derivation shows what the graph's rules would do at once: `1*x`, `0 + 2*x`, and derivatives not yet taken.

use crate::expr::derivative::derivative;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::{Op, Variable};
use crate::num::rational::Rational;

/// The largest formula that is written out: more, and nobody would read the derivation.
pub const MAX_SIZE: usize = 400;

/// A formula, written out.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// An exact number.
    Number(Rational),
    /// π, e or a variable.
    Letter(Op),
    /// a + b + …
    Sum(Vec<Term>),
    /// −a.
    Negative(Box<Term>),
    /// a · b · …
    Product(Vec<Term>),
    /// a / b.
    Quotient(Box<Term>, Box<Term>),
    /// a^n.
    Power(Box<Term>, i64),
    /// Any other operation.
    Apply(Op, Vec<Term>),
    /// The derivative with respect to a variable, still to be taken.
    Derivative(Variable, Box<Term>),
}

impl Term {
    /// The whole number n.
    pub fn integer(n: i64) -> Term {
        Term::Number(Rational::from_integer(n))
    }

    /// An operation on one term.
    pub fn call(op: Op, a: Term) -> Term {
        Term::Apply(op, vec![a])
    }

    /// −a.
    pub fn negated(self) -> Term {
        Term::Negative(Box::new(self))
    }

    /// a / b.
    pub fn over(self, divisor: Term) -> Term {
        Term::Quotient(Box::new(self), Box::new(divisor))
    }

    /// a^n.
    pub fn to_power(self, n: i64) -> Term {
        Term::Power(Box::new(self), n)
    }

    /// The derivative of a, not yet taken.
    pub fn derivative(self, variable: Variable) -> Term {
        Term::Derivative(variable, Box::new(self))
    }

    /// Whether it is the whole number n.
    pub fn is_integer(&self, n: i64) -> bool {
        matches!(self, Term::Number(value) if value.to_i64() == Some(n))
    }

    /// The terms it is made of.
    pub fn parts(&self) -> Vec<&Term> {
        match self {
            Term::Number(_) | Term::Letter(_) => Vec::new(),
            Term::Sum(list) | Term::Product(list) | Term::Apply(_, list) => list.iter().collect(),
            Term::Negative(a) | Term::Power(a, _) | Term::Derivative(_, a) => vec![a],
            Term::Quotient(a, b) => vec![a, b],
        }
    }

    /// The same with every part changed.
    pub fn map(self, change: &mut dyn FnMut(Term) -> Term) -> Term {
        let mut all = |list: Vec<Term>| list.into_iter().map(&mut *change).collect::<Vec<Term>>();
        match self {
            Term::Number(_) | Term::Letter(_) => self,
            Term::Sum(list) => Term::Sum(all(list)),
            Term::Product(list) => Term::Product(all(list)),
            Term::Apply(op, list) => Term::Apply(op, all(list)),
            Term::Negative(a) => Term::Negative(Box::new(change(*a))),
            Term::Power(a, n) => Term::Power(Box::new(change(*a)), n),
            Term::Derivative(v, a) => Term::Derivative(v, Box::new(change(*a))),
            Term::Quotient(a, b) => Term::Quotient(Box::new(change(*a)), Box::new(change(*b))),
        }
    }

    /// How many terms it is made of, itself included.
    pub fn size(&self) -> usize {
        1 + self.parts().iter().map(|part| part.size()).sum::<usize>()
    }

    /// Whether the variable stands in it.
    pub fn contains(&self, variable: Variable) -> bool {
        *self == Term::Letter(Op::Variable(variable)) || self.parts().iter().any(|part| part.contains(variable))
    }

    /// The first of x, y, z that stands in it; `None` comes before all of them.
    pub fn first_variable(&self) -> Option<Variable> {
        [Variable::X, Variable::Y, Variable::Z].into_iter().find(|&v| self.contains(v))
    }

    /// A node written out; `None` if it would be larger than [`MAX_SIZE`].
    pub fn of(graph: &Graph, node: NodeId) -> Option<Term> {
        let mut left = MAX_SIZE;
        written(graph, node, &mut left)
    }

    /// The node of a term; derivatives that are still to be taken are taken by the graph's own rules.
    pub fn node(&self, graph: &mut Graph) -> NodeId {
        let args: Vec<NodeId> = self.parts().iter().map(|part| part.node(graph)).collect();
        let joined = |graph: &mut Graph, op: Op| {
            args.iter().copied().reduce(|a, b| graph.apply(op, &[a, b])).unwrap_or_else(|| graph.integer(0))
        };
        match self {
            Term::Number(value) => graph.number(value.clone()),
            Term::Letter(op) => graph.apply(*op, &[]),
            Term::Sum(_) => joined(graph, Op::Add),
            Term::Product(_) => joined(graph, Op::Mul),
            Term::Negative(_) => graph.apply(Op::Neg, &args),
            Term::Power(_, n) => graph.apply(Op::Power(*n), &args),
            Term::Quotient(..) => graph.apply(Op::Div, &args),
            Term::Apply(op, _) => graph.apply(*op, &args),
            Term::Derivative(variable, _) => {
                let seeds = [Variable::X, Variable::Y, Variable::Z].map(|v| graph.integer(i64::from(v == *variable)));
                derivative(graph, &args, seeds)[0]
            }
        }
    }
}

fn written(graph: &Graph, id: NodeId, left: &mut usize) -> Option<Term> {
    *left = left.checked_sub(1)?;
    if let Some(value) = graph.constant(id) {
        return Some(Term::Number(value.clone()));
    }
    let args = graph.args(id).iter().map(|&a| written(graph, a, left)).collect::<Option<Vec<Term>>>()?;
    let mut args = args.into_iter();
    let mut next = || args.next().unwrap_or(Term::Number(Rational::from_integer(0)));
    Some(match graph.op(id) {
        op @ (Op::Pi | Op::E | Op::Variable(_)) => Term::Letter(op),
        Op::Add => Term::Sum(in_order(joined(next(), next(), true))),
        Op::Sub => {
            let (a, b) = (next(), next());
            Term::Sum(joined(a, opposite(b), true))
        }
        Op::Mul => Term::Product(joined(next(), next(), false)),
        Op::Neg => next().negated(),
        Op::Div => {
            let a = next();
            a.over(next())
        }
        Op::Power(n) => next().to_power(n),
        op => Term::Apply(op, args.collect()),
    })
}

/// −a, written into the members of a sum.
fn opposite(a: Term) -> Term {
    match a {
        Term::Sum(list) => Term::Sum(list.into_iter().map(opposite).collect()),
        Term::Negative(inner) => *inner,
        Term::Number(value) => Term::Number(value.negated()),
        other => other.negated(),
    }
}

/// Two members of a sum or a product as one flat list.
fn joined(a: Term, b: Term, is_sum: bool) -> Vec<Term> {
    let mut list = Vec::new();
    for part in [a, b] {
        match part {
            Term::Sum(inner) if is_sum => list.extend(inner),
            Term::Product(inner) if !is_sum => list.extend(inner),
            other => list.push(other),
        }
    }
    list
}

/// The members of a sum as a person orders them, x before y before z and numbers last; a sum with differences keeps its
/// order, so that it does not start with a minus.
fn in_order(mut list: Vec<Term>) -> Vec<Term> {
    if !list.iter().any(|member| matches!(member, Term::Negative(_))) {
        list.sort_by_key(|member| (matches!(member, Term::Number(_)), member.first_variable()));
    }
    list
}
