//! Exact polynomials over nodes as letters: what an expanded formula hides.
//!
//! In: a node. Out: its polynomial in the subexpressions that are none themselves (`sin(x)` is a letter as `x` is),
//! common divisors, square-free factors, and a node again. Separate from the simplifier because nothing here is
//! cheap: everything has a limit, and declines above it.
//!
//! - [`expand`]: node → polynomial → node. - [`divisor`]: exact division, greatest common divisor, square-free
//!   factors. - [`modular`]: the cheap test that spares most formulas all of that.

pub mod divisor;
pub mod expand;
pub mod modular;
#[cfg(test)]
mod tests;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeMap;

/// The most letters a polynomial may have.
pub const MAX_LETTERS: usize = 8;

/// The most terms: the expanded Barth decic has 126, and a thousand terms are no formula that people type.
pub const MAX_TERMS: usize = 4000;

/// The most products of terms in one multiplication or division, long numbers counted as more: about 0.1 s.
const MAX_PRODUCTS: usize = 400_000;

/// Words of two numbers that are multiplied in about the time that a term takes besides.
const CHEAP_WORDS: u64 = 16;

/// The most bits of a coefficient.
const MAX_BITS: u64 = 100_000;

/// The exponent of each letter.
pub type Exponents = [u16; MAX_LETTERS];

/// A polynomial with whole coefficients, none of them 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polynomial {
    /// The coefficient of each product of letters, in lexicographic order.
    terms: BTreeMap<Exponents, BigInt>,
}

impl Polynomial {
    /// The polynomial that is one number.
    pub fn constant(value: BigInt) -> Self {
        let mut p = Self::default();
        p.add_term([0; MAX_LETTERS], value);
        p
    }

    /// The polynomial that is one letter.
    pub fn letter(index: usize) -> Self {
        let mut exponents = [0; MAX_LETTERS];
        exponents[index] = 1;
        let mut p = Self::default();
        p.add_term(exponents, BigInt::one());
        p
    }

    /// Adds one term.
    pub fn add_term(&mut self, exponents: Exponents, coefficient: BigInt) {
        if coefficient.is_zero() {
            return;
        }
        let sum = self.terms.entry(exponents).or_default();
        *sum += coefficient;
        if sum.is_zero() {
            self.terms.remove(&exponents);
        }
    }

    /// The terms, in lexicographic order of their exponents.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Exponents, &BigInt)> {
        self.terms.iter()
    }

    /// How many terms there are.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether it is 0.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether it is a number.
    pub fn is_constant(&self) -> bool {
        self.terms.keys().all(|e| *e == [0; MAX_LETTERS])
    }

    /// The highest exponent of each letter.
    pub fn degrees(&self) -> Exponents {
        let mut degrees = [0; MAX_LETTERS];
        for exponents in self.terms.keys() {
            for (degree, e) in degrees.iter_mut().zip(exponents) {
                *degree = (*degree).max(*e);
            }
        }
        degrees
    }

    /// The term that is last in lexicographic order.
    fn leading(&self) -> Option<(&Exponents, &BigInt)> {
        self.terms.last_key_value()
    }

    /// What multiplying two terms of these costs, in terms with short numbers.
    fn cost_per_term(&self, other: &Self) -> usize {
        let words = (self.bits() / 64 + 1).saturating_mul(other.bits() / 64 + 1);
        usize::try_from(1 + words / CHEAP_WORDS).unwrap_or(usize::MAX)
    }

    /// What multiplying these costs.
    fn cost(&self, other: &Self) -> usize {
        self.len().saturating_mul(other.len()).saturating_mul(self.cost_per_term(other))
    }

    fn bits(&self) -> u64 {
        self.terms.values().map(BigInt::bits).max().unwrap_or(0)
    }

    /// a·factor.
    pub fn scaled(&self, factor: &BigInt) -> Self {
        if factor.is_zero() {
            return Self::default();
        }
        Polynomial { terms: self.terms.iter().map(|(e, c)| (*e, c * factor)).collect() }
    }

    /// a + b.
    pub fn plus(&self, other: &Self) -> Option<Self> {
        let mut sum = self.clone();
        for (e, c) in &other.terms {
            sum.add_term(*e, c.clone());
        }
        (sum.len() <= MAX_TERMS).then_some(sum)
    }

    /// a · b; `None` when too large.
    pub fn times(&self, other: &Self) -> Option<Self> {
        if self.cost(other) > MAX_PRODUCTS || self.bits() + other.bits() > MAX_BITS {
            return None;
        }
        let mut product = Self::default();
        for (a, c) in &self.terms {
            for (b, d) in &other.terms {
                let mut exponents = *a;
                for (e, f) in exponents.iter_mut().zip(b) {
                    *e = e.checked_add(*f)?;
                }
                product.add_term(exponents, c * d);
            }
            if product.len() > 4 * MAX_TERMS {
                return None;
            }
        }
        (product.len() <= MAX_TERMS).then_some(product)
    }

    /// a^n by repeated squaring; `None` when too large.
    pub fn to_power(&self, n: u32) -> Option<Self> {
        let mut power = Self::constant(BigInt::one());
        for bit in (0..32 - n.leading_zeros()).rev() {
            power = power.times(&power)?;
            if n >> bit & 1 == 1 {
                power = power.times(self)?;
            }
        }
        Some(power)
    }

    /// The greatest common divisor of the coefficients, with the sign of the last one; 0 for 0.
    pub fn content(&self) -> BigInt {
        let size = self.terms.values().fold(BigInt::zero(), |gcd, c| if gcd.is_one() { gcd } else { gcd.gcd(c) });
        if self.leading().is_some_and(|(_, c)| c.is_negative()) { -size } else { size }
    }

    /// The polynomial without its content: the last coefficient is > 0.
    pub fn primitive(&self) -> Self {
        let content = self.content();
        Polynomial { terms: self.terms.iter().map(|(e, c)| (*e, c / &content)).collect() }
    }

    /// v·∂/∂v for the letter v: like the derivative, but keeping the parity of every exponent.
    fn euler_derivative(&self, letter: usize) -> Self {
        let mut p = Self::default();
        for (e, c) in self.terms.iter().filter(|(e, _)| e[letter] > 0) {
            p.add_term(*e, c * BigInt::from(e[letter]));
        }
        p
    }
}
