//! The operations as the tests of this folder try them.
//!
//! In: nothing. Out: one row an operation: on arrays of points, of balls, of intervals, of forms, on one enclosure, and the
//! correctly rounded value. Separate because several tests walk the same table; compiled for tests alone.

use super::affine_lanes::AffineLanes;
use super::ball_lanes::BallLanes;
use super::func;
use super::interval::Enclosure;
use super::interval_lanes::IntervalLanes;
use super::lanes::Lanes;
use super::level::{Simd, for_each_level};
use super::number::Number;
use super::rational::Rational;
use std::hint::black_box;

/// Runs an operation so many times at a level.
pub(super) type Runner<T> = fn(Simd, u32, &T, &T, &mut T);

/// One operation; the second argument is ignored where there is one.
pub(super) struct Trial {
    pub(super) name: &'static str,
    pub(super) points: Runner<Lanes<64>>,
    pub(super) cells: Runner<IntervalLanes<16>>,
    pub(super) forms: Runner<AffineLanes<16>>,
    pub(super) balls: Runner<BallLanes<64>>,
    pub(super) along: Runner<AffineLanes<16, 1>>,
    pub(super) enclosure: fn(Enclosure, Enclosure) -> Enclosure,
    pub(super) exact: fn(f64, f64) -> f64,
}

macro_rules! runner {
    ($name:ident: $op:ident($a:ident $(, $b:ident)?) $(, $n:literal)?) => {
        for_each_level! {
            fn $name[L, T: Number](repeat: u32, left: &T, right: &T, out: &mut T) {
                for _ in 0..repeat {
                    let ($a, _right) = (black_box(left), black_box(right));
                    $(let $b = _right;)?
                    T::$op::<L>($a, $($b,)? $($n,)? &mut *out);
                    black_box(&mut *out);
                }
            }
        }
    };
}

runner!(neg: neg(a));
runner!(abs: abs(a));
runner!(sign: sign(a));
runner!(square: square(a));
runner!(sqrt: sqrt(a));
runner!(exp: exp(a));
runner!(ln: ln(a));
runner!(log2: log2(a));
runner!(log10: log10(a));
runner!(sin: sin(a));
runner!(cos: cos(a));
runner!(tan: tan(a));
runner!(asin: asin(a));
runner!(acos: acos(a));
runner!(atan: atan(a));
runner!(sinh: sinh(a));
runner!(cosh: cosh(a));
runner!(tanh: tanh(a));
runner!(asinh: asinh(a));
runner!(acosh: acosh(a));
runner!(atanh: atanh(a));
runner!(erf: erf(a));
runner!(floor: floor(a));
runner!(add: add(a, b));
runner!(sub: sub(a, b));
runner!(mul: mul(a, b));
runner!(div: div(a, b));
runner!(floor_div: floor_div(a, b), 3);
runner!(min: min(a, b));
runner!(max: max(a, b));
runner!(pow: pow(a, b));
runner!(atan2: atan2(a, b));
runner!(self_power: self_power(a));
for_each_level! {
    fn choose[L, T: Number](repeat: u32, left: &T, right: &T, out: &mut T) {
        for _ in 0..repeat {
            T::choose::<L>(black_box(left), left, black_box(right), &mut *out);
            black_box(&mut *out);
        }
    }
}

runner!(power_4: power(a), 4);
runner!(power_2: power(a), 2);
runner!(power_3: power(a), 3);
runner!(power_7: power(a), 7);
runner!(power_minus_1: power(a), -1);
runner!(power_minus_2: power(a), -2);
runner!(power_minus_5: power(a), -5);
runner!(power_large: power(a), 1_000_001);
runner!(root_3: root(a), 3);

fn positive(a: f64, f: fn(f64) -> f64) -> f64 {
    if a > 0.0 { f(a) } else { f64::NAN }
}

fn inside(a: f64, f: fn(f64) -> f64) -> f64 {
    if a.abs() < 1.0 { f(a) } else { f64::NAN }
}

/// ⌊n·a/b⌋ in fractions.
fn whole_quotient(n: i64, a: f64, b: f64) -> f64 {
    let quotient = |a: &Rational, b: &Rational| Rational::from_integer(n).times(a)?.over(b);
    match (Rational::from_f64(a), Rational::from_f64(b)) {
        (Some(a), Some(b)) => quotient(&a, &b).map_or(f64::NAN, |q| q.floor().to_f64()),
        _ => (func::div(n as f64 * a, b)).floor(),
    }
}

fn reciprocal(a: f64, n: f64) -> f64 {
    if a == 0.0 { f64::NAN } else { core_math::pow(a, n) }
}

fn power_of(a: f64, b: f64) -> f64 {
    if a > 0.0 || (a == 0.0 && b > 0.0) { core_math::pow(a.abs(), b) } else { f64::NAN }
}

fn angle(a: f64, b: f64) -> f64 {
    // Adding 0 makes −0 a plain 0: its sign means nothing here.
    if a == 0.0 && b == 0.0 { f64::NAN } else { core_math::atan2(a + 0.0, b + 0.0) }
}

macro_rules! trial {
    ($name:ident, $a:ident, $b:ident, $enclosure:expr, $exact:expr) => {
        Trial {
            name: stringify!($name),
            points: $name,
            cells: $name,
            forms: $name,
            balls: $name,
            along: $name,
            enclosure: |$a, $b| {
                let _ = $b;
                $enclosure
            },
            exact: |$a, $b| {
                let _ = $b;
                $exact
            },
        }
    };
}

/// Every operation but the pair of sine and cosine; the condition of choose is its first branch.
pub(super) fn trials() -> Vec<Trial> {
    vec![
        trial!(neg, a, b, a.negated(), -a),
        trial!(abs, a, b, a.abs(), a.abs()),
        trial!(sign, a, b, a.sign(), func::sign(a)),
        trial!(square, a, b, a.square(), a * a),
        trial!(sqrt, a, b, a.sqrt(), a.sqrt()),
        trial!(exp, a, b, a.exp(), core_math::exp(a)),
        trial!(ln, a, b, a.ln(), positive(a, core_math::log)),
        trial!(log2, a, b, a.log2(), positive(a, core_math::log2)),
        trial!(log10, a, b, a.log10(), positive(a, core_math::log10)),
        trial!(sin, a, b, a.sin(), core_math::sin(a)),
        trial!(cos, a, b, a.cos(), core_math::cos(a)),
        trial!(tan, a, b, a.tan(), core_math::tan(a)),
        trial!(asin, a, b, a.asin(), core_math::asin(a)),
        trial!(acos, a, b, a.acos(), core_math::acos(a)),
        trial!(atan, a, b, a.atan(), core_math::atan(a)),
        trial!(sinh, a, b, a.sinh(), core_math::sinh(a)),
        trial!(cosh, a, b, a.cosh(), core_math::cosh(a)),
        trial!(tanh, a, b, a.tanh(), core_math::tanh(a)),
        trial!(asinh, a, b, a.asinh(), core_math::asinh(a)),
        trial!(acosh, a, b, a.acosh(), core_math::acosh(a)),
        trial!(atanh, a, b, a.atanh(), inside(a, core_math::atanh)),
        trial!(erf, a, b, a.erf(), core_math::erf(a)),
        trial!(floor, a, b, a.floor(), a.floor()),
        trial!(add, a, b, a.plus(b), a + b),
        trial!(sub, a, b, a.minus(b), a - b),
        trial!(mul, a, b, a.times(b), a * b),
        trial!(div, a, b, a.over(b), func::div(a, b)),
        trial!(floor_div, a, b, a.floor_over(3, b), whole_quotient(3, a, b)),
        trial!(min, a, b, a.min(b), a.min(b)),
        trial!(max, a, b, a.max(b), a.max(b)),
        trial!(pow, a, b, a.pow(b), power_of(a, b)),
        trial!(self_power, a, b, a.self_power(), power_of(a, a)),
        trial!(atan2, a, b, a.atan2(b), angle(a, b)),
        trial!(power_2, a, b, a.power(2), core_math::pow(a, 2.0)),
        trial!(power_3, a, b, a.power(3), core_math::pow(a, 3.0)),
        trial!(power_4, a, b, a.power(4), core_math::pow(a, 4.0)),
        trial!(choose, a, b, Enclosure::choose(a, a, b), func::choose(a, a, b)),
        trial!(power_7, a, b, a.power(7), core_math::pow(a, 7.0)),
        trial!(power_minus_1, a, b, a.power(-1), reciprocal(a, -1.0)),
        trial!(power_minus_2, a, b, a.power(-2), reciprocal(a, -2.0)),
        trial!(power_minus_5, a, b, a.power(-5), reciprocal(a, -5.0)),
        trial!(power_large, a, b, a.power(1_000_001), core_math::pow(a, 1_000_001.0)),
        trial!(root_3, a, b, a.root(3), core_math::cbrt(a)),
    ]
}
