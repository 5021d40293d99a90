//! A fixed-size array of enclosures: the batch that cells and stretches of rays are computed in.
//!
//! In: arrays of bounds with what is known. Out: the same, lane by lane: sound always, within an ulp or two of
//! what `interval` gives one by one. Separate from it because these loops become vector instructions; lanes that
//! are unusual (infinite, empty, near underflow, out of the domain) are computed again by `interval`.

mod arithmetic;
mod choice;
mod elementary;

use super::interval::{Defined, Enclosure, Interval};
use super::level::Level;
use super::number::{Constant, Number};

/// Flag: not proven to be defined everywhere on the box.
pub const PARTIAL: u8 = 1;

/// Flag: not proven to be defined everywhere on the box and continuous there.
pub const JUMP: u8 = 2;

/// Flag: proven to be defined nowhere on the box; the bounds are NaN and the other flags are set.
pub const NOWHERE: u8 = 4;

/// N enclosures.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct IntervalLanes<const N: usize> {
    /// Lower bounds.
    pub lo: [f64; N],
    /// Upper bounds.
    pub hi: [f64; N],
    /// [`PARTIAL`], [`JUMP`], [`NOWHERE`].
    pub flags: [u8; N],
}

impl<const N: usize> IntervalLanes<N> {
    /// The same enclosure in every lane.
    pub fn splat(enclosure: Enclosure) -> Self {
        let mut all = IntervalLanes { lo: [0.0; N], hi: [0.0; N], flags: [0; N] };
        for i in 0..N {
            all.set(i, enclosure);
        }
        all
    }

    /// The enclosure in one lane.
    pub fn get(&self, i: usize) -> Enclosure {
        let flags = self.flags[i];
        if flags & NOWHERE != 0 {
            return Enclosure::NOWHERE;
        }
        Enclosure {
            range: Interval { lo: self.lo[i], hi: self.hi[i] },
            defined: if flags & PARTIAL == 0 { Defined::Everywhere } else { Defined::Somewhere },
            continuous: flags & (PARTIAL | JUMP) == 0,
        }
    }

    /// Puts an enclosure into one lane.
    pub fn set(&mut self, i: usize, enclosure: Enclosure) {
        self.lo[i] = enclosure.range.lo;
        self.hi[i] = enclosure.range.hi;
        self.flags[i] = match (enclosure.defined, enclosure.continuous) {
            (Defined::Everywhere, true) => 0,
            (Defined::Everywhere, false) => JUMP,
            (Defined::Somewhere, _) => PARTIAL | JUMP,
            (Defined::Nowhere, _) => PARTIAL | JUMP | NOWHERE,
        };
    }
}

impl<const N: usize> Default for IntervalLanes<N> {
    fn default() -> Self {
        Self::splat(Enclosure::total(Interval::point(0.0)))
    }
}

macro_rules! by_arrays {
    ($($module:ident :: $name:ident($($argument:ident),*) $(<$level:ident>)?;)*) => {
        $(#[inline(always)]
        fn $name<L: Level>($($argument: &Self,)* out: &mut Self) {
            $module::$name$(::<$level, N>)?($($argument,)* out);
        })*
    };
}

impl<const N: usize> Number for IntervalLanes<N> {
    #[inline(always)]
    fn constant(value: Constant) -> Self {
        let nothing = value.range.is_empty();
        Self::splat(if nothing { Enclosure::NOWHERE } else { Enclosure::total(value.range) })
    }

    #[inline(always)]
    fn sized(a: &Self, size: &Self, out: &mut Self) {
        out.clone_from(a);
        for i in 0..N {
            let has_root = !((a.lo[i] > 0.0) | (a.hi[i] < 0.0));
            if has_root && (size.lo[i] > 0.0 || size.hi[i] < 0.0) {
                out.set(i, Enclosure::NOWHERE);
            }
        }
    }

    by_arrays! {
        arithmetic::neg(a);
        arithmetic::abs(a);
        arithmetic::sign(a);
        arithmetic::floor(a);
        arithmetic::sqrt(a)<L>;
        arithmetic::square(a)<L>;
        arithmetic::add(a, b)<L>;
        arithmetic::sub(a, b)<L>;
        arithmetic::mul(a, b)<L>;
        arithmetic::div(a, b)<L>;
        choice::min(a, b);
        choice::max(a, b);
        elementary::exp(a)<L>;
        elementary::ln(a)<L>;
        elementary::log2(a)<L>;
        elementary::log10(a)<L>;
        elementary::sin(a)<L>;
        elementary::cos(a)<L>;
        elementary::tan(a)<L>;
        elementary::asin(a)<L>;
        elementary::acos(a)<L>;
        elementary::atan(a)<L>;
        elementary::sinh(a)<L>;
        elementary::cosh(a)<L>;
        elementary::tanh(a)<L>;
        elementary::asinh(a)<L>;
        elementary::acosh(a)<L>;
        elementary::atanh(a)<L>;
        elementary::erf(a)<L>;
        elementary::pow(a, b)<L>;
    }

    #[inline(always)]
    fn sin_cos<L: Level>(a: &Self, sin: &mut Self, cos: &mut Self) {
        elementary::sin_cos::<L, N>(a, sin, cos);
    }

    #[inline(always)]
    fn power<L: Level>(a: &Self, n: i64, out: &mut Self) {
        arithmetic::power::<L, N>(a, n, out);
    }

    #[inline(always)]
    fn floor_div<L: Level>(a: &Self, b: &Self, n: i64, out: &mut Self) {
        arithmetic::floor_div::<L, N>(a, b, n, out);
    }

    #[inline(always)]
    fn root<L: Level>(a: &Self, n: u32, out: &mut Self) {
        elementary::root::<L, N>(a, n, out);
    }

    #[inline(always)]
    fn self_power<L: Level>(a: &Self, out: &mut Self) {
        for i in 0..N {
            out.set(i, a.get(i).self_power());
        }
    }

    #[inline(always)]
    fn atan2<L: Level>(a: &Self, b: &Self, out: &mut Self) {
        for i in 0..N {
            out.set(i, a.get(i).atan2(b.get(i)));
        }
    }

    #[inline(always)]
    fn choose<L: Level>(c: &Self, a: &Self, b: &Self, out: &mut Self) {
        choice::choose(c, a, b, out);
    }
}
