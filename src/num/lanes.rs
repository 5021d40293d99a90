//! A fixed-size array of f64: the batch that points are computed in.
//!
//! In: arrays. Out: an array, lane by lane, NaN where there is no value. Separate from the functions of one
//! number because the loops here are what becomes vector instructions.

use super::func::trigonometric::{self, REDUCIBLE};
use super::func::{self, power};
use super::level::Level;
use super::number::{Basic, Constant, Number, Pair};

/// N numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct Lanes<const N: usize>(pub [f64; N]);

impl<const N: usize> Lanes<N> {
    /// The same number in every lane.
    pub const fn splat(x: f64) -> Self {
        Lanes([x; N])
    }
}

impl<const N: usize> Default for Lanes<N> {
    fn default() -> Self {
        Self::splat(0.0)
    }
}

/// Repairs the lanes whose angle is too large for the straight reduction.
#[cold]
#[inline(never)]
fn patch_large<const N: usize>(a: &[f64; N], out: &mut [f64; N], f: fn(f64) -> f64) {
    for i in 0..N {
        if a[i].abs() > REDUCIBLE {
            out[i] = f(a[i]);
        }
    }
}

/// Whether any angle is too large for the straight reduction.
#[inline(always)]
fn any_large<const N: usize>(a: &[f64; N]) -> bool {
    let mut large = 0u64;
    for i in 0..N {
        large |= u64::from(a[i].abs() > REDUCIBLE);
    }
    large != 0
}

macro_rules! each {
    ($name:ident, $a:ident => $value:expr) => {
        #[inline(always)]
        fn $name<L: Level>(a: &Self, out: &mut Self) {
            for i in 0..N {
                let $a = a.0[i];
                out.0[i] = $value;
            }
        }
    };
    ($name:ident, $a:ident, $b:ident => $value:expr) => {
        #[inline(always)]
        fn $name<L: Level>(a: &Self, b: &Self, out: &mut Self) {
            for i in 0..N {
                let ($a, $b) = (a.0[i], b.0[i]);
                out.0[i] = $value;
            }
        }
    };
}

impl<const N: usize> Number for Lanes<N> {
    #[inline(always)]
    fn constant(value: Constant) -> Self {
        Self::splat(value.point)
    }

    each!(neg, a => -a);
    each!(abs, a => a.abs());
    each!(sign, a => func::sign(a));
    each!(sqrt, a => a.sqrt());
    each!(exp, a => func::exp::<L>(a));
    each!(ln, a => func::ln::<L>(a));
    each!(log2, a => func::log2::<L>(a));
    each!(log10, a => func::log10::<L>(a));
    each!(asin, a => func::asin::<L>(a));
    each!(acos, a => func::acos::<L>(a));
    each!(atan, a => func::atan::<L>(a));
    each!(sinh, a => func::sinh::<L>(a));
    each!(cosh, a => func::cosh::<L>(a));
    each!(tanh, a => func::tanh::<L>(a));
    each!(asinh, a => func::asinh::<L>(a));
    each!(acosh, a => func::acosh::<L>(a));
    each!(atanh, a => func::atanh::<L>(a));
    each!(erf, a => func::erf::<L>(a));
    each!(floor, a => a.floor());
    each!(square, a => a * a);
    each!(add, a, b => a + b);
    each!(sub, a, b => a - b);
    each!(mul, a, b => a * b);
    each!(div, a, b => func::div(a, b));
    each!(min, a, b => func::min(a, b));
    each!(max, a, b => func::max(a, b));
    each!(pow, a, b => func::pow::<L>(a, b));
    each!(atan2, a, b => func::atan2::<L>(a, b));

    #[inline(always)]
    fn sin<L: Level>(a: &Self, out: &mut Self) {
        for i in 0..N {
            out.0[i] = trigonometric::sin_reducible::<L>(a.0[i]);
        }
        if any_large(&a.0) {
            patch_large(&a.0, &mut out.0, |a| trigonometric::sin_cos_of_large(a).0);
        }
    }

    #[inline(always)]
    fn cos<L: Level>(a: &Self, out: &mut Self) {
        for i in 0..N {
            out.0[i] = trigonometric::cos_reducible::<L>(a.0[i]);
        }
        if any_large(&a.0) {
            patch_large(&a.0, &mut out.0, |a| trigonometric::sin_cos_of_large(a).1);
        }
    }

    #[inline(always)]
    fn sin_cos<L: Level>(a: &Self, sin: &mut Self, cos: &mut Self) {
        for i in 0..N {
            (sin.0[i], cos.0[i]) = trigonometric::sin_cos_reducible::<L>(a.0[i]);
        }
        if any_large(&a.0) {
            patch_large(&a.0, &mut sin.0, |a| trigonometric::sin_cos_of_large(a).0);
            patch_large(&a.0, &mut cos.0, |a| trigonometric::sin_cos_of_large(a).1);
        }
    }

    #[inline(always)]
    fn tan<L: Level>(a: &Self, out: &mut Self) {
        for i in 0..N {
            out.0[i] = trigonometric::tan_reducible::<L>(a.0[i]);
        }
        if any_large(&a.0) {
            patch_large(&a.0, &mut out.0, trigonometric::tan_of_large);
        }
    }

    #[inline(always)]
    fn power<L: Level>(a: &Self, n: i64, out: &mut Self) {
        match n {
            3 => each_lane(a, out, |a| a * a * a),
            4 => each_lane(a, out, |a| (a * a) * (a * a)),
            _ => {
                out.0 = a.0;
                power_all::<L, N>(&mut out.0, n);
            }
        }
    }

    #[inline(always)]
    fn floor_div<L: Level>(a: &Self, b: &Self, n: i64, out: &mut Self) {
        for i in 0..N {
            out.0[i] = func::floor_div::<L>(n as f64, a.0[i], b.0[i]);
        }
    }

    #[inline(always)]
    fn root<L: Level>(a: &Self, n: u32, out: &mut Self) {
        for i in 0..N {
            out.0[i] = func::root::<L>(a.0[i], n);
        }
    }

    #[inline(always)]
    fn pair<L: Level>(pair: Pair, a: &Self, b: &Self, c: &Self, out: &mut Self) {
        match pair.first {
            Basic::Add => second(pair, |i| a.0[i] + b.0[i], c, out),
            Basic::Sub => second(pair, |i| a.0[i] - b.0[i], c, out),
            Basic::Mul => second(pair, |i| a.0[i] * b.0[i], c, out),
        }
    }

    #[inline(always)]
    fn products<L: Level>(minus: bool, [a, b, c, d]: [&Self; 4], out: &mut Self) {
        if minus {
            for i in 0..N {
                out.0[i] = a.0[i] * b.0[i] - c.0[i] * d.0[i];
            }
        } else {
            for i in 0..N {
                out.0[i] = a.0[i] * b.0[i] + c.0[i] * d.0[i];
            }
        }
    }

    #[inline(always)]
    fn choose<L: Level>(c: &Self, a: &Self, b: &Self, out: &mut Self) {
        for i in 0..N {
            out.0[i] = func::choose(c.0[i], a.0[i], b.0[i]);
        }
    }
}

/// The second operation of a pair, a loop each.
#[inline(always)]
fn second<const N: usize>(pair: Pair, first: impl Fn(usize) -> f64, c: &Lanes<N>, out: &mut Lanes<N>) {
    macro_rules! each {
        ($i:ident => $value:expr) => {
            for $i in 0..N {
                out.0[$i] = $value;
            }
        };
    }
    match (pair.second, pair.reversed) {
        (Basic::Add, _) => each!(i => first(i) + c.0[i]),
        (Basic::Mul, _) => each!(i => first(i) * c.0[i]),
        (Basic::Sub, false) => each!(i => first(i) - c.0[i]),
        (Basic::Sub, true) => each!(i => c.0[i] - first(i)),
    }
}

#[inline(always)]
fn each_lane<const N: usize>(a: &Lanes<N>, out: &mut Lanes<N>, f: impl Fn(f64) -> f64) {
    for i in 0..N {
        out.0[i] = f(a.0[i]);
    }
}

#[inline(always)]
fn square_all<L: Level, const N: usize>(high: &mut [f64; N], low: &mut [f64; N]) {
    for i in 0..N {
        let a = (high[i], low[i]);
        (high[i], low[i]) = power::times::<L>(a, a);
    }
}

/// x^n in every lane: the same steps as [`func::power`], each for all lanes.
#[inline(always)]
pub(super) fn power_all<L: Level, const N: usize>(x: &mut [f64; N], n: i64) {
    let (mut square, mut square_low) = (*x, [0.0; N]);
    if n < 0 {
        for i in 0..N {
            (square[i], square_low[i]) = power::reciprocal::<L>(x[i]);
        }
    }
    let mut rest = n.unsigned_abs();
    while rest & 1 == 0 && rest > 0 {
        square_all::<L, N>(&mut square, &mut square_low);
        rest >>= 1;
    }
    let (mut value, mut value_low) = (square, square_low);
    rest >>= 1;
    while rest > 0 {
        square_all::<L, N>(&mut square, &mut square_low);
        if rest & 1 == 1 {
            for i in 0..N {
                (value[i], value_low[i]) = power::times::<L>((value[i], value_low[i]), (square[i], square_low[i]));
            }
        }
        rest >>= 1;
    }
    *x = value;
}
