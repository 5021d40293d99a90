//! Arctangent, the angle of a point, arcsine and arccosine.
//!
//! In: a slope, a point, a sine, a cosine. Out: the angle. The arctangent is reduced to |t| ≤ tan(π/8) by one
//! quotient, its rounding error kept; arcsine and arccosine to |x| ≤ 1/2 by the half angle (Muller, Elementary
//! Functions, 3rd ed., sections 11.5 and 11.6).

use super::coefficients::{ASIN, ATAN, HALF_PI, PI, QUARTER_PI};
use super::double_double::fast_two_sum;
use super::polynomial;
use crate::num::level::Level;

/// tan(π/8) and tan(3π/8), near enough: any split near them serves.
const LOW_SLOPE: f64 = 0.41421356237309503;
const HIGH_SLOPE: f64 = 2.414213562373095;

/// Powers of two that bring a point of any size where neither sum nor quotient overflows or vanishes.
const DOWN: f64 = f64::from_bits((1023 - 100) << 52);
const UP: f64 = f64::from_bits((1023 + 200) << 52);

/// arctangent
#[inline(always)]
pub fn atan<L: Level>(a: f64) -> f64 {
    let (h, l) = angle::<L>(a.abs(), 1.0);
    let value = h + l;
    let finite = if a.abs() == f64::INFINITY { HALF_PI[0] } else { value };
    finite.copysign(a)
}

/// The angle of the point (x = b, y = a) in (−π, π]; NaN at (0, 0) and at infinite points.
#[inline(always)]
pub fn atan2<L: Level>(a: f64, b: f64) -> f64 {
    let (y, x) = (a.abs(), b.abs());
    let larger = if y > x { y } else { x };
    let down = if larger > 1e300 { DOWN } else { 1.0 };
    let scale = if larger < 1e-250 { UP } else { down };
    let (h, l) = angle::<L>(y * scale, x * scale);
    let (mirrored, rest) = fast_two_sum(PI[0], -h);
    let value = if b < 0.0 { mirrored + (rest + (PI[1] - l)) } else { h + l };
    let signed = if a < 0.0 { -value } else { value };
    if larger > 0.0 { signed } else { f64::NAN }
}

/// arctan(y/x) for y, x ≥ 0 as a sum of two.
#[inline(always)]
fn angle<L: Level>(y: f64, x: f64) -> (f64, f64) {
    let steep = y > HIGH_SLOPE * x;
    let middle = y > LOW_SLOPE * x;
    let (sum, difference) = (x + y, y - x);
    let numerator = if middle { difference } else { y };
    let numerator = if steep { -x } else { numerator };
    let denominator = if middle { sum } else { x };
    let denominator = if steep { y } else { denominator };
    let base = if middle { QUARTER_PI[0] } else { 0.0 };
    let base = if steep { HALF_PI[0] } else { base };
    let base_low = if middle { QUARTER_PI[1] } else { 0.0 };
    let base_low = if steep { HALF_PI[1] } else { base_low };
    // What the sum and the difference of the coordinates lost; 0 in the other cases.
    let (sum_lost, difference_lost) = lost(y, x, sum, difference);
    let between = middle & !steep;
    let denominator_lost = if between { sum_lost } else { 0.0 };
    let numerator_lost = if between { difference_lost } else { 0.0 };
    let t = numerator / denominator;
    let remainder = L::fma(-t, denominator, numerator) + (numerator_lost - t * denominator_lost);
    let correction = remainder / denominator;
    let w = t * t;
    let (s, e) = fast_two_sum(base, t);
    (s, e + (L::fma(w * t, polynomial::<L, _>(&ATAN, w), base_low) + correction))
}

/// The rounding errors of x + y and y − x.
#[inline(always)]
fn lost(y: f64, x: f64, sum: f64, difference: f64) -> (f64, f64) {
    let t = sum - x;
    let sum_lost = (x - (sum - t)) + (y - t);
    let u = difference - y;
    (sum_lost, (y - (difference - u)) - (x + u))
}

/// arcsine, |a| ≤ 1
#[inline(always)]
pub fn asin<L: Level>(a: f64) -> f64 {
    let x = a.abs();
    let outer = x > 0.5;
    let half = 0.5 * (1.0 - x);
    let z = if outer { half } else { x * x };
    let (s, s_low) = root::<L>(z);
    let p = z * polynomial::<L, _>(&ASIN, z);
    let near = L::fma(x, p, x);
    let (h, l) = fast_two_sum(HALF_PI[0], -2.0 * s);
    let far = h + (l + L::fma(-2.0, L::fma(s, p, s_low), HALF_PI[1]));
    if outer { far } else { near }.copysign(a)
}

/// arccosine, |a| ≤ 1
#[inline(always)]
pub fn acos<L: Level>(a: f64) -> f64 {
    let x = a.abs();
    let outer = x > 0.5;
    let half = 0.5 * (1.0 - x);
    let z = if outer { half } else { x * x };
    let (s, s_low) = root::<L>(z);
    let p = z * polynomial::<L, _>(&ASIN, z);
    let (m, m_low) = fast_two_sum(HALF_PI[0], -a);
    let middle = m + (m_low + L::fma(-a, p, HALF_PI[1]));
    let positive = 2.0 * (s + L::fma(s, p, s_low));
    let (h, l) = fast_two_sum(PI[0], -2.0 * s);
    let negative = h + (l + L::fma(-2.0, L::fma(s, p, s_low), PI[1]));
    let outside = if a > 0.0 { positive } else { negative };
    if outer { outside } else { middle }
}

/// √z as a sum of two, (0, 0) for 0.
#[inline(always)]
fn root<L: Level>(z: f64) -> (f64, f64) {
    let s = z.sqrt();
    let low = L::fma(-s, s, z) / (2.0 * s);
    (s, if z > 0.0 { low } else { z })
}
