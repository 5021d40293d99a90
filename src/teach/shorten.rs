//! How a person tidies a formula up, one habit at a time.
//!
//! In: a term. Out: the same with zeros left out, numbers in front, like factors and like terms together. Separate from
//! `expr::simplify`, whose rules keep every condition under which f has a value: a derivation holds where f has one.

use super::term::Term;
use crate::expr::op::Op;
use crate::num::rational::Rational;

/// A habit: its key in the texts, and what it makes of a term whose parts are tidy.
pub type Habit = (&'static str, fn(Term) -> Term);

/// In the order in which they are tried.
pub const HABITS: [Habit; 4] = [
    ("tidy.zeros", zeros_and_ones),
    ("tidy.numbers", numbers_in_front),
    ("tidy.factors", like_factors),
    ("tidy.terms", like_terms),
];

/// A habit applied to every part, innermost first.
pub fn everywhere(term: Term, habit: fn(Term) -> Term) -> Term {
    habit(term.map(&mut |part| everywhere(part, habit)))
}

fn sum_of(mut list: Vec<Term>) -> Term {
    match list.len() {
        0 => Term::integer(0),
        1 => list.remove(0),
        _ => Term::Sum(list),
    }
}

fn product_of(mut list: Vec<Term>) -> Term {
    match list.len() {
        0 => Term::integer(1),
        1 => list.remove(0),
        _ => Term::Product(list),
    }
}

/// u + 0 = u, 0·u = 0, 1·u = u, u/1 = u, u^1 = u, 0/u = 0.
fn zeros_and_ones(term: Term) -> Term {
    match term {
        Term::Sum(list) => {
            let flat = list.into_iter().flat_map(|t| if let Term::Sum(inner) = t { inner } else { vec![t] });
            sum_of(flat.filter(|t| !t.is_integer(0)).collect())
        }
        Term::Negative(a) if a.is_integer(0) => Term::integer(0),
        Term::Negative(a) => match *a {
            Term::Negative(inner) => *inner,
            Term::Sum(list) if list.len() == 1 => sum_of(list).negated(),
            other => other.negated(),
        },
        Term::Product(list) if list.iter().any(|t| t.is_integer(0)) => Term::integer(0),
        Term::Product(list) => product_of(list.into_iter().filter(|t| !t.is_integer(1)).collect()),
        Term::Quotient(a, b) if a.is_integer(0) || b.is_integer(1) => *a,
        Term::Power(a, 1) => *a,
        Term::Power(_, 0) => Term::integer(1),
        Term::Apply(Op::Choose, list) if list[1] == list[2] => list[1].clone(),
        other => other,
    }
}

/// The number a term is a multiple of, with its sign, and the rest.
fn parted(term: Term) -> (Rational, Term) {
    let one = Rational::from_integer(1);
    match term {
        Term::Number(value) => (value, Term::integer(1)),
        Term::Negative(a) => {
            let (c, rest) = parted(*a);
            (c.negated(), rest)
        }
        Term::Product(list) => {
            let mut number = one;
            let mut rest = Vec::new();
            for factor in list {
                let (c, inner) = parted(factor);
                match number.times(&c) {
                    Some(product) => number = product,
                    None => rest.push(Term::Number(c)),
                }
                match inner {
                    Term::Product(inner) => rest.extend(inner),
                    inner if inner.is_integer(1) => {}
                    inner => rest.push(inner),
                }
            }
            (number, product_of(rest))
        }
        Term::Quotient(a, b) => {
            let ((c, a), (d, b)) = (parted(*a), parted(*b));
            match c.over(&d) {
                Some(ratio) if b.is_integer(1) => (ratio, a),
                Some(ratio) => (ratio, a.over(b)),
                None => (one, Term::Product(vec![Term::Number(c), a]).over(Term::Product(vec![Term::Number(d), b]))),
            }
        }
        other => (one, other),
    }
}

/// A number in front of the rest.
fn multiple(number: &Rational, rest: Term) -> Term {
    let size = number.absolute();
    let whole = size.is_integer();
    let shown = match rest {
        rest if rest.is_integer(1) => Term::Number(size),
        rest if size.is_one() => rest,
        // 3/2 of u/v is (3u)/(2v), and 1/3 of u is u/3.
        Term::Quotient(a, b) => {
            let (p, q) = (
                Rational::from_big_integer(size.numerator().clone()),
                Rational::from_big_integer(size.denominator().clone()),
            );
            match (p, q) {
                (Some(p), Some(q)) => multiple(&p, *a).over(multiple(&q, *b)),
                _ => Term::Product(vec![Term::Number(size), a.over(*b)]),
            }
        }
        Term::Product(mut list) => {
            list.insert(0, Term::Number(size));
            Term::Product(list)
        }
        rest if !whole && size.numerator() == &num_bigint::BigInt::from(1) && !size.to_string().contains('.') => {
            match size.reciprocal() {
                Some(divisor) => rest.over(Term::Number(divisor)),
                None => rest,
            }
        }
        rest => Term::Product(vec![Term::Number(size), rest]),
    };
    if number.is_negative() { shown.negated() } else { shown }
}

/// 2·(3·u) = 6·u, u·2 = 2·u, (−u)·v = −u·v, u·(v/w) = (u·v)/w; simple factors before brackets.
fn numbers_in_front(term: Term) -> Term {
    match term {
        Term::Product(list) => {
            let (number, rest) = parted(Term::Product(list));
            let mut factors = if let Term::Product(list) = rest { list } else { vec![rest] };
            factors.sort_by_key(|factor| (rank(factor), factor.first_variable()));
            let mut divisors = Vec::new();
            for factor in &mut factors {
                if let Term::Quotient(a, b) = factor {
                    divisors.push((**b).clone());
                    *factor = (**a).clone();
                }
            }
            let above = product_of(factors.into_iter().filter(|t| !t.is_integer(1)).collect());
            let rest = if divisors.is_empty() { above } else { above.over(product_of(divisors)) };
            multiple(&number, rest)
        }
        Term::Quotient(a, b) => {
            let (number, rest) = parted(a.over(*b));
            multiple(&number, rest)
        }
        Term::Negative(a) => {
            let (number, rest) = parted(*a);
            multiple(&number.negated(), rest)
        }
        Term::Sum(list) => {
            let numbers: Vec<Rational> = list.iter().filter_map(number_of).collect();
            if numbers.len() < 2 {
                return Term::Sum(list);
            }
            let total = numbers.iter().try_fold(Rational::from_integer(0), |sum, n| sum.plus(n));
            let Some(total) = total else { return Term::Sum(list) };
            let mut rest: Vec<Term> = list.into_iter().filter(|t| number_of(t).is_none()).collect();
            rest.push(multiple(&total, Term::integer(1)));
            sum_of(rest)
        }
        other => other,
    }
}

fn number_of(term: &Term) -> Option<Rational> {
    match term {
        Term::Number(value) => Some(value.clone()),
        Term::Negative(a) => number_of(a).map(|value| value.negated()),
        _ => None,
    }
}

/// Where a factor stands in a product.
fn rank(factor: &Term) -> u32 {
    match factor {
        Term::Number(_) => 0,
        Term::Letter(Op::Pi | Op::E) => 1,
        Term::Letter(_) => 2,
        Term::Power(a, _) if matches!(**a, Term::Letter(_)) => 2,
        Term::Sum(_) => 4,
        Term::Power(a, _) if matches!(**a, Term::Sum(_)) => 4,
        Term::Negative(_) | Term::Product(_) | Term::Quotient(..) => 3,
        Term::Power(..) | Term::Apply(..) | Term::Derivative(..) => 3,
    }
}

/// u·u² = u³.
fn like_factors(term: Term) -> Term {
    let Term::Product(list) = term else { return term };
    let mut found: Vec<(Term, i64)> = Vec::new();
    for factor in list {
        let (base, n) = if let Term::Power(a, n) = factor { (*a, n) } else { (factor, 1) };
        let is_number = matches!(base, Term::Number(_));
        let same = found
            .iter_mut()
            .find(|(other, m)| !is_number && *other == base && m.checked_add(n).is_some() && *m > 0 && n > 0);
        match same {
            Some((_, m)) => *m += n,
            None => found.push((base, n)),
        }
    }
    product_of(found.into_iter().map(|(base, n)| if n == 1 { base } else { base.to_power(n) }).collect())
}

/// 2·u + 3·u = 5·u.
fn like_terms(term: Term) -> Term {
    let Term::Sum(list) = term else { return term };
    let mut found: Vec<(Rational, Term, Term)> = Vec::new();
    for member in list {
        let (number, rest) = parted(member.clone());
        match found.iter_mut().find(|(_, other, _)| *other == rest) {
            Some(same) => match same.0.plus(&number) {
                Some(total) => {
                    same.2 = multiple(&total, rest);
                    same.0 = total;
                }
                None => found.push((number, rest, member)),
            },
            None => found.push((number, rest, member)),
        }
    }
    sum_of(found.into_iter().filter(|(number, ..)| !number.is_zero()).map(|(.., member)| member).collect())
}
