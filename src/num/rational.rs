//! Exact fractions: the literals of a formula, and what folding makes of them.
//!
//! In: decimal text and whole numbers. Out: exact arithmetic that declines what would grow too large, and the
//! f64 and the interval nearest to a value. Separate because a literal is what was typed, not its nearest f64.

use super::interval::Interval;
use num_bigint::{BigInt, BigUint, Sign};
use num_rational::Ratio;
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;
use std::fmt;

/// Folding stops at fractions with more bits than this in numerator or denominator: above it exact
/// arithmetic costs more than it saves (any f64 needs at most 2098).
pub const MAX_BITS: u64 = 4096;

/// The largest decimal exponent a literal may have, either sign: f64 ends at 1e±308.
pub const MAX_EXPONENT: i64 = 400;

/// An exact fraction in lowest terms.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Rational(Ratio<BigInt>);

impl Rational {
    /// The whole number n.
    pub fn from_integer(n: i64) -> Self {
        Rational(Ratio::from_integer(BigInt::from(n)))
    }

    /// The whole number n; `None` when too large.
    pub fn from_big_integer(n: BigInt) -> Option<Self> {
        Self::limited(Ratio::from_integer(n))
    }

    /// p/q; `None` for q = 0.
    pub fn from_fraction(p: i64, q: i64) -> Option<Self> {
        (q != 0).then(|| Rational(Ratio::new(BigInt::from(p), BigInt::from(q))))
    }

    /// Exactly the value of a finite f64; `None` for others.
    pub fn from_f64(x: f64) -> Option<Self> {
        if !x.is_finite() {
            return None;
        }
        let (mantissa, power) = parts(x);
        let sign = if x < 0.0 { Sign::Minus } else { Sign::Plus };
        let whole = BigInt::from_biguint(if mantissa == 0 { Sign::NoSign } else { sign }, BigUint::from(mantissa));
        Some(Rational(if power >= 0 {
            Ratio::from_integer(whole << power as u64)
        } else {
            Ratio::new(whole, BigInt::one() << (-power) as u64)
        }))
    }

    /// The exact value of a decimal literal such as `2`, `.5`, `2.`, `1e-3`, `1E+2`; `None` if it is not
    /// one or its exponent is beyond [`MAX_EXPONENT`].
    pub fn from_decimal(text: &str) -> Option<Self> {
        let (mantissa, exponent) = match text.find(['e', 'E']) {
            Some(at) => (&text[..at], text[at + 1..].parse::<i64>().ok()?),
            None => (text, 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: String = [whole, fraction].concat();
        if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) || exponent.abs() > MAX_EXPONENT {
            return None;
        }
        let value = BigInt::parse_bytes(digits.as_bytes(), 10)?;
        let power = exponent - fraction.len() as i64;
        let scale = BigInt::from(10).pow(power.unsigned_abs());
        Some(Rational(if power >= 0 { Ratio::from_integer(value * scale) } else { Ratio::new(value, scale) }))
    }

    /// Whether it is 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// Whether it is 1.
    pub fn is_one(&self) -> bool {
        self.0.is_one()
    }

    /// Whether it is < 0.
    pub fn is_negative(&self) -> bool {
        self.0.is_negative()
    }

    /// Whether it is > 0.
    pub fn is_positive(&self) -> bool {
        self.0.is_positive()
    }

    /// Whether it is a whole number.
    pub fn is_integer(&self) -> bool {
        self.0.is_integer()
    }

    /// The whole number it is, if it is one that fits.
    pub fn to_i64(&self) -> Option<i64> {
        if self.0.is_integer() { self.0.numer().to_i64() } else { None }
    }

    /// Numerator and denominator (> 0, lowest terms), if both fit.
    pub fn to_fraction(&self) -> Option<(i64, i64)> {
        Some((self.0.numer().to_i64()?, self.0.denom().to_i64()?))
    }

    /// Numerator of the lowest terms.
    pub fn numerator(&self) -> &BigInt {
        self.0.numer()
    }

    /// Denominator of the lowest terms, > 0.
    pub fn denominator(&self) -> &BigInt {
        self.0.denom()
    }

    /// −a.
    pub fn negated(&self) -> Self {
        Rational(-&self.0)
    }

    /// |a|.
    pub fn absolute(&self) -> Self {
        Rational(self.0.abs())
    }

    /// 1/a; `None` for 0.
    pub fn reciprocal(&self) -> Option<Self> {
        (!self.is_zero()).then(|| Rational(self.0.recip()))
    }

    /// The largest whole number ≤ a.
    pub fn floor(&self) -> Self {
        Rational(self.0.floor())
    }

    /// a + b; `None` when too large.
    pub fn plus(&self, other: &Self) -> Option<Self> {
        Self::limited(&self.0 + &other.0)
    }

    /// a − b; `None` when too large.
    pub fn minus(&self, other: &Self) -> Option<Self> {
        Self::limited(&self.0 - &other.0)
    }

    /// a · b; `None` when too large.
    pub fn times(&self, other: &Self) -> Option<Self> {
        // Most factors are 1 or whole, where there is nothing to be reduced.
        match (self.is_integer(), other.is_integer()) {
            (true, _) if self.is_one() => Some(other.clone()),
            (_, true) if other.is_one() => Some(self.clone()),
            (true, true) => Self::from_big_integer(self.0.numer() * other.0.numer()),
            _ => Self::limited(&self.0 * &other.0),
        }
    }

    /// a / b; `None` when too large or b = 0.
    pub fn over(&self, other: &Self) -> Option<Self> {
        if other.is_zero() { None } else { Self::limited(&self.0 / &other.0) }
    }

    /// a^n; `None` when too large or 0 to a negative power.
    pub fn to_power(&self, n: i64) -> Option<Self> {
        if self.is_zero() && n < 0 {
            return None;
        }
        let bits = self.0.numer().bits().max(self.0.denom().bits());
        let trivial = bits <= 1;
        if !trivial && bits.saturating_mul(n.unsigned_abs()) > MAX_BITS + bits {
            return None;
        }
        let base = if n < 0 { self.0.recip() } else { self.0.clone() };
        let n = if trivial { 2 - n.unsigned_abs() % 2 } else { n.unsigned_abs() };
        let (p, q) = base.into_raw();
        Self::limited(Ratio::new(Pow::pow(p, n), Pow::pow(q, n)))
    }

    /// The exact n-th root if it is rational (n ≥ 1; a ≥ 0 when n is even).
    pub fn exact_root(&self, n: u32) -> Option<Self> {
        if self.is_negative() && n.is_multiple_of(2) {
            return None;
        }
        let (p, q) = (self.0.numer().nth_root(n), self.0.denom().nth_root(n));
        (Pow::pow(&p, n) == *self.0.numer() && Pow::pow(&q, n) == *self.0.denom()).then(|| Rational(Ratio::new(p, q)))
    }

    fn limited(value: Ratio<BigInt>) -> Option<Self> {
        (value.numer().bits() <= MAX_BITS && value.denom().bits() <= MAX_BITS).then_some(Rational(value))
    }

    /// The nearest f64, ties to even; ±∞ beyond the range.
    pub fn to_f64(&self) -> f64 {
        let (p, q) = (self.0.numer().magnitude(), self.0.denom().magnitude());
        if p.is_zero() {
            return 0.0;
        }
        let value = nearest_quotient(p, q);
        if self.0.is_negative() { -value } else { value }
    }

    /// The narrowest interval of f64 that contains the value.
    pub fn enclosure(&self) -> Interval {
        let near = self.to_f64();
        if !near.is_finite() {
            let (lo, hi) = if near > 0.0 { (f64::MAX, f64::INFINITY) } else { (f64::NEG_INFINITY, -f64::MAX) };
            return Interval { lo, hi };
        }
        match self.compared_with(near) {
            Ordering::Greater => Interval { lo: near, hi: near.next_up() },
            Ordering::Less => Interval { lo: near.next_down(), hi: near },
            Ordering::Equal => Interval { lo: near, hi: near },
        }
    }

    /// How it compares with a finite f64 m·2^e of the same sign: as p with m·2^e·q, without a fraction that would have to be reduced.
    fn compared_with(&self, near: f64) -> Ordering {
        let (mantissa, power) = parts(near);
        let (p, q) = (self.0.numer().magnitude(), self.0.denom().magnitude());
        let product = q * mantissa;
        let order = if power >= 0 {
            p.cmp(&(product << power.unsigned_abs()))
        } else {
            (p << power.unsigned_abs()).cmp(&product)
        };
        if self.0.is_negative() { order.reverse() } else { order }
    }
}

/// |x| = m·2^e of a finite f64.
fn parts(x: f64) -> (u64, i64) {
    let bits = x.to_bits();
    let exponent = ((bits >> 52) & 0x7ff) as i64;
    let fraction = bits & ((1 << 52) - 1);
    if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) }
}

/// p/q to the nearest f64, ties to even: 55 or more bits of quotient with the remainder as a sticky bit, then one rounding.
fn nearest_quotient(p: &BigUint, q: &BigUint) -> f64 {
    let exponent = p.bits() as i64 - q.bits() as i64;
    // Subnormal results have fewer bits: never keep more than those above 2^-1074.
    let kept = (exponent + 1074 + 2).clamp(1, 55);
    let shift = kept - exponent;
    let (numerator, denominator) =
        if shift >= 0 { (p << shift as u64, q.clone()) } else { (p.clone(), q << (-shift) as u64) };
    let quotient = &numerator / &denominator;
    let sticky = &quotient * &denominator != numerator;
    let Some(mut bits) = quotient.to_u64() else { return f64::INFINITY };
    let length = 64 - i64::from(bits.leading_zeros());
    // Round by hand to 53 bits, or to the bits a subnormal has, so that the conversion below is exact.
    let spare = (length - 53).max(-1074 + shift).max(0);
    if spare > 0 {
        let (half, low) = (1u64 << (spare - 1), bits & ((1u64 << spare) - 1));
        bits >>= spare;
        if low > half || (low == half && (sticky || bits & 1 == 1)) {
            bits += 1;
        }
    }
    scale_by_power_of_two(bits as f64, spare - shift)
}

/// x · 2^n, exact where the result is an f64.
fn scale_by_power_of_two(mut x: f64, mut n: i64) -> f64 {
    let power = |n: i64| f64::from_bits(((n + 1023) as u64) << 52);
    while n > 1023 {
        (x, n) = (x * power(1023), n - 1023);
        if x.is_infinite() {
            return x;
        }
    }
    while n < -1022 {
        (x, n) = (x * power(-1022), n + 1022);
        if x == 0.0 {
            return x;
        }
    }
    x * power(n)
}

impl fmt::Display for Rational {
    /// A decimal if the value has a short one, else `p/q`; reads back as the same value.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (p, q) = (self.0.numer(), self.0.denom());
        if q.is_one() {
            return write!(f, "{p}");
        }
        for digits in 1..=20u32 {
            let scaled = &self.0 * BigInt::from(10).pow(digits);
            if scaled.is_integer() {
                let text = format!("{:0>width$}", scaled.numer().magnitude(), width = digits as usize + 1);
                let (whole, fraction) = text.split_at(text.len() - digits as usize);
                return write!(f, "{}{whole}.{fraction}", if p.is_negative() { "-" } else { "" });
            }
        }
        write!(f, "{p}/{q}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_double_agrees_with_the_parser_of_the_standard_library() {
        let texts = [
            "0",
            "1",
            ".5",
            "2.",
            "1e-3",
            "1E2",
            "2e+3",
            "0.1",
            "3.141592653589793238462643",
            "1e22",
            "1e23",
            "9007199254740993",
            "4.9e-324",
            "2.4703282292062327e-324",
            "2.4703282292062328e-324",
            "2.2250738585072011e-308",
            "1.7976931348623157e308",
            "1.7976931348623159e308",
            "1e309",
            "5e-324",
            "3e-324",
            "123456789012345678901234567890",
            "0.000000000000000000000001",
        ];
        for text in texts {
            let value = Rational::from_decimal(text).expect(text);
            let standard: f64 = text.parse().expect(text);
            assert_eq!(value.to_f64().to_bits(), standard.to_bits(), "{text}");
            let range = value.enclosure();
            assert!(range.lo <= standard && standard <= range.hi);
            if standard.is_finite() {
                let exact = Rational::from_f64(standard).expect(text);
                let (below, above) = (Rational::from_f64(range.lo), Rational::from_f64(range.hi));
                assert!(below.is_some_and(|lo| lo <= value) && above.is_none_or(|hi| value <= hi), "{text}");
                assert_eq!(range.lo == range.hi, exact == value, "{text}");
                assert_eq!(value.negated().enclosure(), Interval { lo: -range.hi, hi: -range.lo }, "{text}");
            }
        }
    }

    #[test]
    fn f64_round_trips_exactly() {
        let mut bits = 1u64;
        for _ in 0..2000 {
            bits = bits.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let x = f64::from_bits(bits);
            if let Some(exact) = Rational::from_f64(x) {
                assert_eq!(exact.to_f64().to_bits(), if x == 0.0 { 0 } else { x.to_bits() });
            }
        }
    }

    #[test]
    fn powers_that_would_grow_are_declined() {
        let two = Rational::from_integer(2);
        assert_eq!(two.to_power(10), Some(Rational::from_integer(1024)));
        assert_eq!(two.to_power(-1), Rational::from_fraction(1, 2));
        assert_eq!(two.to_power(1_000_000_000), None);
        assert_eq!(Rational::from_integer(-1).to_power(1_000_000_001), Some(Rational::from_integer(-1)));
        assert_eq!(Rational::from_integer(0).to_power(-1), None);
        assert_eq!(Rational::from_decimal("1e99999999999"), None);
    }
}
