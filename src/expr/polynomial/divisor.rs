//! Exact division, greatest common divisors and square-free factors.
//!
//! In: polynomials. Out: polynomials, each result verified by exact arithmetic, or nothing where the work would be
//! too much. The greatest common divisor is found by evaluation at one large number, digit by digit back: the
//! heuristic algorithm of Char, Geddes, Gonnet, "GCDHEU", J. Symbolic Computation 7 (1989) 31–48; when the result
//! divides both, it is the greatest.

use super::{Exponents, MAX_BITS, MAX_LETTERS, MAX_PRODUCTS, Polynomial};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// How many numbers are tried: the paper's six.
const ATTEMPTS: usize = 6;

/// The largest number, in bits, that a polynomial may be evaluated to: its gcd takes about 0.1 s.
const MAX_VALUE_BITS: u64 = 80_000;

/// a / b if that is a polynomial with whole coefficients.
pub fn quotient(a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
    let (lead, factor) = b.leading()?;
    let (mut rest, mut result, mut work) = (a.clone(), Polynomial::default(), 0);
    let cost = b.len().saturating_mul(a.cost_per_term(b));
    while let Some((exponents, coefficient)) = rest.leading() {
        let mut difference: Exponents = [0; MAX_LETTERS];
        for (d, (e, f)) in difference.iter_mut().zip(exponents.iter().zip(lead)) {
            *d = e.checked_sub(*f)?;
        }
        let (digit, remainder) = coefficient.div_rem(factor);
        work += cost;
        if !remainder.is_zero() || work > MAX_PRODUCTS {
            return None;
        }
        for (e, c) in b.terms() {
            let mut exponents = *e;
            for (e, d) in exponents.iter_mut().zip(difference) {
                *e = e.checked_add(d)?;
            }
            rest.add_term(exponents, -(c * &digit));
        }
        result.add_term(difference, digit);
    }
    Some(result)
}

/// The greatest common divisor, its last coefficient > 0; `None` where it is too much work or was not found.
pub fn gcd(a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
    if a.is_empty() || b.is_empty() {
        return None;
    }
    let content = a.content().gcd(&b.content());
    let (a, b) = (a.primitive(), b.primitive());
    let letter = (0..MAX_LETTERS).rev().find(|&i| a.degrees()[i] > 0 || b.degrees()[i] > 0);
    let Some(letter) = letter else { return Some(Polynomial::constant(content)) };
    let height = |p: &Polynomial| p.terms().map(|(_, c)| c.abs()).max().unwrap_or_default();
    // Different letters must not get the same number: x − y would vanish.
    let mut point: BigInt = height(&a).min(height(&b)) * 2 + 29 + 12 * letter;
    let degree = u64::from(a.degrees()[letter].max(b.degrees()[letter]));
    for _ in 0..ATTEMPTS {
        if point.bits() * degree + a.bits().max(b.bits()) > MAX_VALUE_BITS {
            return None;
        }
        let (value, other) = (at(&a, letter, &point), at(&b, letter, &point));
        if !value.is_empty() && !other.is_empty() {
            let candidate = digits(&gcd(&value, &other)?, letter, &point)?.primitive();
            if quotient(&a, &candidate).is_some() && quotient(&b, &candidate).is_some() {
                return Some(candidate.scaled(&content));
            }
        }
        // The paper's step: a ratio near 2.73 that shares no structure with small numbers.
        point = point * 73794 / 27011;
    }
    None
}

/// The polynomial with a number for one letter.
fn at(p: &Polynomial, letter: usize, point: &BigInt) -> Polynomial {
    let mut powers = vec![BigInt::one()];
    for i in 0..usize::from(p.degrees()[letter]) {
        powers.push(&powers[i] * point);
    }
    let mut value = Polynomial::default();
    for (e, c) in p.terms() {
        let mut exponents = *e;
        exponents[letter] = 0;
        value.add_term(exponents, c * &powers[usize::from(e[letter])]);
    }
    value
}

/// The polynomial in `letter` whose value at `point` this is, with coefficients of at most point/2.
fn digits(value: &Polynomial, letter: usize, point: &BigInt) -> Option<Polynomial> {
    let (mut p, half) = (Polynomial::default(), point / 2);
    for (e, c) in value.terms() {
        let (mut rest, mut exponents) = (c.clone(), *e);
        while !rest.is_zero() {
            let mut digit = rest.mod_floor(point);
            if digit > half {
                digit -= point;
            }
            rest = (rest - &digit) / point;
            p.add_term(exponents, digit);
            exponents[letter] = exponents[letter].checked_add(1)?;
        }
    }
    Some(p)
}

/// Square-free factors without common divisors, each with its multiplicity: p is a number times the product of
/// their powers, verified by multiplication. `None` where that is too much work.
pub fn square_free_factors(p: &Polynomial) -> Option<Vec<(Polynomial, u32)>> {
    let (mut factors, rest) = without_letter_factors(&p.primitive());
    let (strides, deflated) = deflated(&rest);
    for (factor, n) in square_free_without_letters(&deflated)? {
        factors.push((inflated(&factor, &strides)?, n));
    }
    let mut product = Polynomial::constant(BigInt::one());
    for (factor, n) in &factors {
        product = product.times(&factor.to_power(*n)?)?;
    }
    (product == p.primitive()).then_some(factors)
}

/// The letters that divide p, and what remains.
fn without_letter_factors(p: &Polynomial) -> (Vec<(Polynomial, u32)>, Polynomial) {
    let mut least = p.degrees();
    for (e, _) in p.terms() {
        for (l, e) in least.iter_mut().zip(e) {
            *l = (*l).min(*e);
        }
    }
    let mut rest = Polynomial::default();
    for (e, c) in p.terms() {
        let mut exponents = *e;
        for (e, l) in exponents.iter_mut().zip(least) {
            *e -= l;
        }
        rest.add_term(exponents, c.clone());
    }
    let letters = (0..MAX_LETTERS).filter(|&i| least[i] > 0);
    (letters.map(|i| (Polynomial::letter(i), u32::from(least[i]))).collect(), rest)
}

/// p with v for v^n wherever a letter occurs only in powers of v^n, and the n of each letter. A square-free
/// polynomial that no letter divides stays so under v → v^n, so nothing is lost, and the numbers are far smaller.
fn deflated(p: &Polynomial) -> (Exponents, Polynomial) {
    let mut strides: Exponents = [0; MAX_LETTERS];
    for (e, _) in p.terms() {
        for (s, e) in strides.iter_mut().zip(e) {
            *s = s.gcd(e);
        }
    }
    let mut q = Polynomial::default();
    for (e, c) in p.terms() {
        let mut exponents = *e;
        for (e, s) in exponents.iter_mut().zip(strides) {
            *e = e.checked_div(s).unwrap_or(0);
        }
        q.add_term(exponents, c.clone());
    }
    (strides, q)
}

fn inflated(p: &Polynomial, strides: &Exponents) -> Option<Polynomial> {
    let mut q = Polynomial::default();
    for (e, c) in p.terms() {
        let mut exponents = *e;
        for (e, s) in exponents.iter_mut().zip(strides) {
            *e = e.checked_mul(*s)?;
        }
        q.add_term(exponents, c.clone());
    }
    Some(q)
}

/// Musser's algorithm (Geddes, Czapor, Labahn, "Algorithms for Computer Algebra", algorithm 8.1) on all letters at
/// once: the gcd of p with all its derivatives holds every irreducible factor once less than p.
fn square_free_without_letters(p: &Polynomial) -> Option<Vec<(Polynomial, u32)>> {
    let mut repeated = p.clone();
    for letter in (0..MAX_LETTERS).filter(|&i| p.degrees()[i] > 0) {
        if repeated.is_constant() {
            break;
        }
        let slope = p.euler_derivative(letter);
        repeated = gcd(&repeated, &slope)?.primitive();
    }
    let mut distinct = quotient(p, &repeated)?.primitive();
    let mut factors = Vec::new();
    let mut multiplicity = 1;
    while !distinct.is_constant() {
        let common = if repeated.is_constant() { repeated.clone() } else { gcd(&distinct, &repeated)?.primitive() };
        let factor = quotient(&distinct, &common)?.primitive();
        if !factor.is_constant() {
            factors.push((factor, multiplicity));
        }
        repeated = quotient(&repeated, &common)?.primitive();
        distinct = common;
        multiplicity += 1;
    }
    Some(factors)
}

/// The largest divisor of a that has no common divisor with b: a without its roots on b = 0. `None` where that is
/// too much work.
pub fn coprime_part(a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
    let mut rest = a.primitive();
    while !rest.is_constant() {
        if rest.bits() > MAX_BITS {
            return None;
        }
        let common = gcd(&rest, b)?.primitive();
        if common.is_constant() {
            break;
        }
        rest = quotient(&rest, &common)?.primitive();
    }
    Some(rest)
}
