//! A fixed-size array of affine forms: the batch that cells of the screen are computed in.
//!
//! In: c + s₀·ε₀ + … ± error, every ε in [−1, 1]: three symbols for squares of the screen, one along a ray. Out: the same of the function's value, which lies within
//! `error` of the linear part for each choice of the ε. Where an interval knows how large a function gets, a form
//! also knows how it leans, so that differences of what leans alike stay small (Stolfi and de Figueiredo,
//! Self-Validated Numerical Methods and Applications, 1997, chapter 3). Separate from intervals because it is
//! worth its price only where a cell is wide in several directions; what it does not know, `interval_lanes` answers.

mod arithmetic;
mod choice;
mod elementary;

use super::interval_lanes::{IntervalLanes, JUMP, NOWHERE, PARTIAL};
use super::level::Level;
use super::mask::{Mask, any};
use super::number::{Constant, Number};

/// How many symbols the form of a square has: across, down, along.
pub const SYMBOLS: usize = 3;

/// N affine forms of S symbols. A form whose numbers are not finite says nothing; one with [`NOWHERE`] has no value.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct AffineLanes<const N: usize, const S: usize = SYMBOLS> {
    /// The value where every ε is 0.
    pub center: [f64; N],
    /// What each ε adds.
    pub slope: [[f64; N]; S],
    /// How far the function can be from the linear part, ≥ 0.
    pub error: [f64; N],
    /// As those of [`IntervalLanes`].
    pub flags: [u8; N],
}

/// The part of all magnitudes together that covers the roundings of one operation: at most a dozen of 2^-53 each.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// What is added besides, for products too small for their roundings to be a part of them.
const TINY: f64 = 1e-300;

impl<const N: usize, const S: usize> AffineLanes<N, S> {
    /// The same number in every lane, give or take an error.
    pub fn splat(center: f64, error: f64) -> Self {
        AffineLanes { center: [center; N], slope: [[0.0; N]; S], error: [error; N], flags: [0; N] }
    }

    /// How far the value of lane i can be from its centre.
    #[inline(always)]
    pub fn radius(&self, i: usize) -> f64 {
        let mut sum = self.error[i];
        for k in 0..S {
            sum += self.slope[k][i].abs();
        }
        sum * (1.0 + ROUNDING) + TINY
    }

    /// The bounds of lane i; NaN if the form says nothing.
    #[inline(always)]
    pub fn bounds(&self, i: usize) -> (f64, f64) {
        let radius = self.radius(i) + ROUNDING * self.center[i].abs();
        (self.center[i] - radius, self.center[i] + radius)
    }

    /// The forms as intervals.
    #[inline(always)]
    fn to_intervals(self) -> IntervalLanes<N> {
        let mut out = IntervalLanes { lo: [0.0; N], hi: [0.0; N], flags: self.flags };
        for i in 0..N {
            let (lo, hi) = self.bounds(i);
            let (lo, hi) = if lo <= hi { (lo, hi) } else { (f64::NEG_INFINITY, f64::INFINITY) };
            let nowhere = self.flags[i] & NOWHERE != 0;
            out.lo[i] = if nowhere { f64::NAN } else { lo };
            out.hi[i] = if nowhere { f64::NAN } else { hi };
        }
        out
    }

    /// Takes the marked lanes from intervals.
    #[inline(always)]
    fn take(&mut self, from: &IntervalLanes<N>, marked: &Mask<N>) {
        for i in 0..N {
            if marked[i] != 0 {
                let (lo, hi) = (from.lo[i], from.hi[i]);
                let center = 0.5 * lo + 0.5 * hi;
                let error = (hi - center).max(center - lo) * (1.0 + ROUNDING) + TINY;
                let finite = error < f64::INFINITY;
                self.center[i] = if finite { center } else { 0.0 };
                self.error[i] = if finite { error } else { f64::INFINITY };
                for slope in &mut self.slope {
                    slope[i] = 0.0;
                }
                self.flags[i] = from.flags[i];
            }
        }
    }
}

/// Computes the marked lanes by an operation on intervals. A macro, for the operation must be compiled for the level of
/// instructions of the place where it stands.
macro_rules! repair {
    ($marked:expr, $out:expr, $name:ident::<$level:ident>($($a:expr),+ $(; $n:expr)?)) => {{
        let mut result = $crate::num::interval_lanes::IntervalLanes::default();
        $crate::num::interval_lanes::IntervalLanes::$name::<$level>($(&$a.to_intervals(),)+ $($n,)? &mut result);
        $out.take(&result, &$marked);
    }};
}
use repair;

/// Operations that are computed on intervals alone, for they are rare where cells are traced.
macro_rules! by_intervals {
    ($($name:ident),*) => {
        $(#[inline(always)]
        fn $name<L: Level>(a: &Self, out: &mut Self) {
            repair!([u64::MAX; N], out, $name::<L>(a));
        })*
    };
}

macro_rules! by_forms {
    ($($module:ident :: $name:ident($($argument:ident),*) $(<$level:ident>)?;)*) => {
        $(#[inline(always)]
        fn $name<L: Level>($($argument: &Self,)* out: &mut Self) {
            $module::$name$(::<$level, N, S>)?($($argument,)* out);
        })*
    };
}

impl<const N: usize, const S: usize> Number for AffineLanes<N, S> {
    fn constant(value: Constant) -> Self {
        let radius = (value.range.hi - value.point).max(value.point - value.range.lo);
        let error = if radius > 0.0 { radius * (1.0 + ROUNDING) } else { 0.0 };
        let mut all = Self::splat(value.point, error);
        if value.range.is_empty() {
            all.flags = [PARTIAL | JUMP | NOWHERE; N];
        }
        all
    }

    #[inline(always)]
    fn sized(a: &Self, size: &Self, out: &mut Self) {
        out.clone_from(a);
        for i in 0..N {
            let ((lo, hi), (least, most)) = (a.bounds(i), size.bounds(i));
            let has_root = !((lo > 0.0) | (hi < 0.0));
            if has_root && (least > 0.0 || most < 0.0) {
                out.flags[i] = PARTIAL | JUMP | NOWHERE;
            }
        }
    }

    by_intervals! { sign, floor, asin, acos, asinh, acosh, atanh, self_power }

    by_forms! {
        arithmetic::neg(a);
        arithmetic::add(a, b);
        arithmetic::sub(a, b);
        arithmetic::mul(a, b);
        arithmetic::square(a);
        choice::abs(a)<L>;
        choice::min(a, b)<L>;
        choice::max(a, b)<L>;
        elementary::sqrt(a)<L>;
        elementary::exp(a)<L>;
        elementary::ln(a)<L>;
        elementary::log2(a)<L>;
        elementary::log10(a)<L>;
        elementary::sin(a)<L>;
        elementary::cos(a)<L>;
        elementary::tan(a)<L>;
        elementary::atan(a)<L>;
        elementary::sinh(a)<L>;
        elementary::cosh(a)<L>;
        elementary::tanh(a)<L>;
        elementary::erf(a)<L>;
    }

    #[inline(always)]
    fn sin_cos<L: Level>(a: &Self, sin: &mut Self, cos: &mut Self) {
        elementary::sin_cos::<L, N, S>(a, sin, cos);
    }

    #[inline(always)]
    fn div<L: Level>(a: &Self, b: &Self, out: &mut Self) {
        let mut inverse = *b;
        let odd = elementary::reciprocal(b, &mut inverse);
        arithmetic::mul(a, &inverse, out);
        if any(&odd) {
            repair!(odd, out, div::<L>(a, b));
        }
    }

    #[inline(always)]
    fn power<L: Level>(a: &Self, n: i64, out: &mut Self) {
        elementary::power::<L, N, S>(a, n, out);
    }

    #[inline(always)]
    fn root<L: Level>(a: &Self, n: u32, out: &mut Self) {
        elementary::root::<L, N, S>(a, n, out);
    }

    #[inline(always)]
    fn pow<L: Level>(a: &Self, b: &Self, out: &mut Self) {
        elementary::pow::<L, N, S>(a, b, out);
    }

    #[inline(always)]
    fn atan2<L: Level>(a: &Self, b: &Self, out: &mut Self) {
        repair!([u64::MAX; N], out, atan2::<L>(a, b));
    }

    #[inline(always)]
    fn floor_div<L: Level>(a: &Self, b: &Self, n: i64, out: &mut Self) {
        repair!([u64::MAX; N], out, floor_div::<L>(a, b; n));
    }

    #[inline(always)]
    fn choose<L: Level>(c: &Self, a: &Self, b: &Self, out: &mut Self) {
        choice::choose::<L, N, S>(c, a, b, out);
    }
}

#[cfg(test)]
mod tests;
