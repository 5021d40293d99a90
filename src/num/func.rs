//! The only home of sin, exp, pow…: the elementary functions of one f64, with proven or measured error bounds.
//!
//! In: one f64. Out: the value, NaN where there is none. Every function is a straight line of selects, bit
//! operations and fused products, generic over the [`Level`], so that a loop over an array becomes vector
//! instructions and every level gives the same bits. The few that need another way for some arguments (sin,
//! cos, tan beyond [`trigonometric::REDUCIBLE`]) say so. Separate because no other place may call a libm.
//!
//! The error bounds ([`bound`]) are in units of the last place: |computed − exact| ≤ E·ulp(exact) wherever the
//! result is a normal f64, and a few subnormal units else.

mod coefficients;
mod double_double;
pub mod error_function;
pub mod exponential;
pub mod hyperbolic;
pub mod inverse;
pub mod logarithm;
pub mod native;
pub mod power;
pub mod trigonometric;

pub use error_function::erf;
pub use exponential::exp;
pub use hyperbolic::{acosh, asinh, atanh, cosh, sinh, tanh};
pub use inverse::{acos, asin, atan, atan2};
pub use logarithm::{ln, log2, log10};
pub use power::{pow, power, root};
pub use trigonometric::{cos, sin, sin_cos, tan};

use super::level::Level;

/// Largest errors in units of the last place: what the soak measured (docs/error-bounds.md), with a margin of
/// at least a twentieth of an ulp. Measured on random numbers, not proven.
pub mod bound {
    /// sin, cos.
    pub const SIN: f64 = 0.8;
    /// tan.
    pub const TAN: f64 = 0.9;
    /// e^a.
    pub const EXP: f64 = 0.7;
    /// All three logarithms.
    pub const LN: f64 = 0.6;
    /// arctan and the angle of a point.
    pub const ATAN: f64 = 0.74;
    /// arcsin.
    pub const ASIN: f64 = 0.72;
    /// arccos.
    pub const ACOS: f64 = 0.7;
    /// sinh.
    pub const SINH: f64 = 0.9;
    /// cosh.
    pub const COSH: f64 = 0.9;
    /// tanh.
    pub const TANH: f64 = 0.9;
    /// arsinh, arcosh, artanh.
    pub const ASINH: f64 = 0.6;
    /// The error function.
    pub const ERF: f64 = 1.1;
    /// a^b and odd roots.
    pub const POW: f64 = 0.7;
    /// a^n for |n| ≤ [`MOST_POWER`].
    pub const POWER: f64 = 0.6;
    /// Up to this exponent [`POWER`] holds.
    pub const MOST_POWER: u64 = 1 << 40;

    /// How many f64 outward of a computed end lie both the exact value there and whatever is computed at other
    /// points of a box. Computed points miss their exact values by E ulp as well, so that 2·E must be covered; both
    /// being f64, for E < 3/4 that is one step even where the ulp halves between them.
    pub const fn steps(ulps: f64) -> u32 {
        let mut steps = 1;
        while ulps >= 0.75 && (steps as f64) < 2.0 * ulps {
            steps += 1;
        }
        steps
    }
}

/// 1.5·2^52: adding it to |x| < 2^51 leaves the nearest whole number, two's complement, in the low bits.
const ROUNDER: f64 = 6755399441055744.0;

/// The polynomial with the given coefficients, lowest power first, by Horner's rule.
#[inline(always)]
fn polynomial<L: Level, const N: usize>(coefficients: &[f64; N], x: f64) -> f64 {
    let mut value = coefficients[N - 1];
    let mut i = N - 1;
    while i > 0 {
        i -= 1;
        value = L::fma(value, x, coefficients[i]);
    }
    value
}

/// −1, 0 or 1.
#[inline(always)]
pub fn sign(a: f64) -> f64 {
    let positive = if a > 0.0 { 1.0 } else { a };
    if a < 0.0 { -1.0 } else { positive }
}

/// a / b, NaN for b = 0.
#[inline(always)]
pub fn div(a: f64, b: f64) -> f64 {
    let quotient = a / b;
    if b == 0.0 { f64::NAN } else { quotient }
}

/// Below this quotients of f64 have two bits behind the point, so that the nearest whole number is known: 2^51.
pub const EXACT_WHOLE: f64 = 2251799813685248.0;

/// The largest whole number ≤ n·a / b for a whole n, NaN for b = 0; of the exact quotient while it is below
/// [`EXACT_WHOLE`]. The whole number nearest to the rounded quotient is it, or lies just above: what is left over,
/// n·a − b·whole, has the sign that tells. Both products are used with what their rounding lost (by fused
/// multiplication; Muller et al., "Handbook of Floating-Point Arithmetic", 2nd ed., section 4.4).
#[inline(always)]
pub fn floor_div<L: Level>(n: f64, a: f64, b: f64) -> f64 {
    let high = n * a;
    let low = L::fma(n, a, -high);
    let quotient = div(high, b);
    let nearest = (quotient + 0.5).floor();
    let left = L::fma(-nearest, b, high) + low;
    let is_above = (left != 0.0) & ((left < 0.0) == (b > 0.0)) & left.is_finite();
    let whole = if is_above { nearest - 1.0 } else { nearest };
    if quotient.abs() < EXACT_WHOLE { whole } else { quotient.floor() }
}

/// The smaller; NaN if either is.
#[inline(always)]
pub fn min(a: f64, b: f64) -> f64 {
    let smaller = if a < b { a } else { b };
    if a.is_nan() { a } else { smaller }
}

/// The larger; NaN if either is.
#[inline(always)]
pub fn max(a: f64, b: f64) -> f64 {
    let larger = if a > b { a } else { b };
    if a.is_nan() { a } else { larger }
}

/// a where c ≤ 0, b where c > 0, NaN where c is NaN.
#[inline(always)]
pub fn choose(c: f64, a: f64, b: f64) -> f64 {
    // By masks: of two loads the compiler would make only the one that is needed, one lane after the other.
    let first = u64::from(c <= 0.0).wrapping_neg();
    let none = u64::from(c.is_nan()).wrapping_neg();
    f64::from_bits((a.to_bits() & first) | (b.to_bits() & !first) | none)
}

#[cfg(test)]
mod tests;
