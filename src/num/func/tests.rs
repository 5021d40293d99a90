//! The quick form of the soak: errors against correctly rounded values.
#![allow(clippy::print_stdout)]

use super::*;
use crate::num::interval::Interval;
use crate::num::level::Portable;
use crate::num::rational::Rational;

/// One function of the table: ours, the correctly rounded one, where to try it, its bound in ulp.
struct Row {
    name: &'static str,
    ours: fn(f64) -> f64,
    exact: fn(f64) -> f64,
    ranges: &'static [(f64, f64)],
    bound: f64,
}

macro_rules! row {
    ($name:ident, $exact:expr, $bound:expr, $ranges:expr) => {
        Row { name: stringify!($name), ours: $name::<Portable>, exact: $exact, ranges: &$ranges, bound: $bound }
    };
}

const TURNS: [(f64, f64); 6] = [(-0.8, 0.8), (0.7, 0.9), (-7.0, 7.0), (1.57, 1.572), (-1e6, 1e6), (1e-300, 1e300)];

const ROWS: [Row; 18] = [
    row!(sin, core_math::sin, bound::SIN, TURNS),
    row!(cos, core_math::cos, bound::SIN, TURNS),
    row!(tan, core_math::tan, bound::TAN, TURNS),
    row!(exp, core_math::exp, bound::EXP, [(-0.4, 0.4), (-5.0, 5.0), (-700.0, 709.0)]),
    row!(ln, core_math::log, bound::LN, [(0.7, 1.4), (0.999, 1.001), (1e-320, 1e-300), (1e-300, 1e300)]),
    row!(log2, core_math::log2, bound::LN, [(0.7, 1.4), (0.999, 1.001), (1e-300, 1e300)]),
    row!(log10, core_math::log10, bound::LN, [(0.7, 1.4), (0.999, 1.001), (1e-300, 1e300)]),
    row!(atan, core_math::atan, bound::ATAN, [(-0.5, 0.5), (0.3, 3.0), (1e-300, 1e300)]),
    row!(asin, core_math::asin, bound::ASIN, [(-1.0, 1.0), (0.49, 0.51), (0.9999, 1.0), (1e-300, 1.0)]),
    row!(acos, core_math::acos, bound::ACOS, [(-1.0, 1.0), (0.49, 0.51), (0.9999, 1.0), (-1.0, -0.9999)]),
    row!(sinh, core_math::sinh, bound::SINH, [(-1.1, 1.1), (0.9, 5.0), (-710.0, 710.0), (1e-300, 1.0)]),
    row!(cosh, core_math::cosh, bound::COSH, [(-1.1, 1.1), (0.9, 5.0), (-710.0, 710.0)]),
    row!(tanh, core_math::tanh, bound::TANH, [(-1.1, 1.1), (0.9, 22.0), (1e-300, 1.0)]),
    row!(asinh, core_math::asinh, bound::ASINH, [(-2.0, 2.0), (1e-5, 1e-3), (1e-300, 1e300)]),
    row!(acosh, core_math::acosh, bound::ASINH, [(1.0, 2.0), (1.0, 1.0001), (1.0, 1e300)]),
    row!(atanh, core_math::atanh, bound::ASINH, [(-1.0, 1.0), (1e-5, 1e-3), (0.999, 1.0), (1e-300, 1.0)]),
    row!(erf, core_math::erf, bound::ERF, [(-1.1, 1.1), (0.9, 7.0), (1e-300, 1.0)]),
    Row {
        name: "cbrt",
        ours: |a| root::<Portable>(a, 3),
        exact: core_math::cbrt,
        ranges: &[(-8.0, 8.0), (1e-320, 1e300)],
        bound: bound::POW,
    },
];

/// Numbers of a range: evenly spread, or by exponent where it spans many.
fn numbers((lo, hi): (f64, f64), count: u32) -> impl Iterator<Item = f64> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    (0..count).map(move |_| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let mixed = state ^ (state >> 31);
        let part = (mixed >> 11) as f64 / (1u64 << 53) as f64;
        if lo > 0.0 && hi / lo > 1e6 {
            f64::from_bits(lo.to_bits() + (part * (hi.to_bits() - lo.to_bits()) as f64) as u64)
        } else {
            lo + part * (hi - lo)
        }
    })
}

/// The distance in ulp of the exact result, rounded though it is: half an ulp is added for its own error.
fn ulps(ours: f64, exact: f64) -> f64 {
    if ours == exact {
        return 0.5;
    }
    let ulp = (exact.abs().next_up() - exact.abs()).max(f64::MIN_POSITIVE * f64::EPSILON);
    (ours - exact).abs() / ulp
}

#[test]
fn errors_stay_within_their_bounds() {
    for row in &ROWS {
        for &range in row.ranges {
            let mut worst = (0.0, 0.0);
            for x in numbers(range, 4000) {
                let error = ulps((row.ours)(x), (row.exact)(x));
                if !(error <= worst.0) {
                    worst = (error, x);
                }
            }
            println!("{} {range:?}: {} ulp at {:e}", row.name, worst.0, worst.1);
            assert!(worst.0 <= row.bound.max(1.0), "{} {range:?}: {} ulp at {:e}", row.name, worst.0, worst.1);
        }
    }
}

/// ⌊n·a/b⌋ in fractions.
fn whole_quotient(n: i64, a: f64, b: f64) -> f64 {
    let [a, b] = [a, b].map(|x| Rational::from_f64(x).unwrap());
    Rational::from_integer(n).times(&a).unwrap().over(&b).unwrap().floor().to_f64()
}

#[test]
fn a_quotient_that_only_rounds_to_a_whole_number_has_its_true_floor() {
    let rows = [(2.0, 0.1, 19.0), (1.0, 0.1, 9.0), (-2.0, 0.1, -20.0), (2.0, -0.1, -20.0), (6.0, 3.0, 2.0)];
    for (a, b, whole) in rows {
        assert_eq!(floor_div::<Portable>(1.0, a, b), whole, "{a}/{b}");
    }
    let (mut near, mut corrected) = (0, 0);
    for b in numbers((-8.0, 8.0), 200) {
        for k in -25..25 {
            let n = 1 + i64::from((k + 25) % 7);
            let at = f64::from(k) * b / n as f64;
            for a in [at.next_down(), at, at.next_up()] {
                let expected = whole_quotient(n, a, b);
                assert_eq!(floor_div::<Portable>(n as f64, a, b), expected, "{n}*{a:e}/{b:e}");
                let known = Interval::point(a).floor_over(n, Interval::point(b)).range;
                assert!(known.lo <= expected && expected <= known.hi, "{a:e}/{b:e} in {known:?}");
                near += 1;
                corrected += u32::from((n as f64 * a / b).floor() != expected);
            }
        }
    }
    assert!(corrected * 20 > near, "{corrected} of {near}: the rows do not show the difference");
}
