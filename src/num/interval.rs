//! One interval, rounded outward, with what is known of the function on it.
//!
//! In: the range of each argument over a box and what is known of it. Out: the range of the operation's result
//! and what is known of that. Natural extension, tight to an ulp or two; the arrays of `interval_lanes` fall back
//! on it. Separate because it may take branches where they may not.
//!
//! - [`Interval`]: bounds alone. An operation on it takes the box itself as its argument.
//! - [`Enclosure`]: an interval with [`Defined`] and `continuous`. An operation on it composes.
//! - [`Pieces`]: one interval on each side of a jump or a pole.

mod arithmetic;
mod elementary;
mod pieces;
mod round;
#[cfg(test)]
mod tests;
mod trigonometric;

pub use pieces::Pieces;
pub(super) use trigonometric::TURN_ERROR;

/// The closed set of reals between two bounds, which may be infinite; empty when both are NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower bound; −∞ when there is none.
    pub lo: f64,
    /// Upper bound; +∞ when there is none.
    pub hi: f64,
}

/// Where a function is known to have a value on a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Defined {
    /// At every point: proven.
    Everywhere,
    /// Not proven either way.
    Somewhere,
    /// At no point: proven.
    Nowhere,
}

/// The range of a function over a box, with what is known of the function there (a reduced form of the
/// decorations of IEEE 1788-2015, section 11).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// Contains every value that the function takes; empty exactly when it is defined nowhere.
    pub range: Interval,
    /// Where it has a value.
    pub defined: Defined,
    /// True only if it is defined everywhere on the box and its restriction to the box is continuous.
    pub continuous: bool,
}

impl Interval {
    /// No number.
    pub const EMPTY: Interval = Interval { lo: f64::NAN, hi: f64::NAN };

    /// Every number.
    pub const WHOLE: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// From lo to hi, lo ≤ hi.
    pub const fn new(lo: f64, hi: f64) -> Self {
        Interval { lo, hi }
    }

    /// One number.
    pub const fn point(x: f64) -> Self {
        Interval { lo: x, hi: x }
    }

    /// Whether it holds no number.
    pub fn is_empty(self) -> bool {
        !(self.lo <= self.hi)
    }

    /// Whether both bounds are finite.
    pub fn is_bounded(self) -> bool {
        self.lo.is_finite() && self.hi.is_finite()
    }

    /// Whether x is in it.
    pub fn contains(self, x: f64) -> bool {
        self.lo <= x && x <= self.hi
    }

    /// hi − lo, rounded to nearest; NaN when empty.
    pub fn width(self) -> f64 {
        self.hi - self.lo
    }

    /// The narrowest interval that contains both.
    pub fn hull(self, other: Self) -> Self {
        if self.is_empty() {
            return other;
        }
        if other.is_empty() {
            return self;
        }
        Interval { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// What is in both.
    pub fn intersection(self, other: Self) -> Self {
        if self.is_empty() || other.is_empty() {
            return Self::EMPTY;
        }
        let both = Interval { lo: self.lo.max(other.lo), hi: self.hi.min(other.hi) };
        if both.is_empty() { Self::EMPTY } else { both }
    }

    /// Whether it is the number x alone.
    fn is_point(self, x: f64) -> bool {
        self.lo == x && self.hi == x
    }
}

impl Enclosure {
    /// Defined nowhere.
    pub const NOWHERE: Enclosure = Enclosure { range: Interval::EMPTY, defined: Defined::Nowhere, continuous: false };

    /// The box itself: a coordinate, a constant.
    pub const fn total(range: Interval) -> Self {
        Enclosure { range, defined: Defined::Everywhere, continuous: true }
    }

    /// Defined everywhere, with a jump that could not be ruled out.
    const fn jumping(range: Interval) -> Self {
        Enclosure { range, defined: Defined::Everywhere, continuous: false }
    }

    /// Not known to be defined everywhere; nowhere when the range is empty.
    fn partial(range: Interval) -> Self {
        let defined = if range.is_empty() { Defined::Nowhere } else { Defined::Somewhere };
        Enclosure { range, defined, continuous: false }
    }

    /// What is known of this after an argument that is defined and continuous as given.
    fn after(self, defined: Defined, continuous: bool) -> Self {
        match (self.defined, defined) {
            (Defined::Nowhere, _) | (_, Defined::Nowhere) => Self::NOWHERE,
            (Defined::Everywhere, Defined::Everywhere) => {
                Enclosure { continuous: self.continuous && continuous, ..self }
            }
            _ => Enclosure { defined: Defined::Somewhere, continuous: false, ..self },
        }
    }

    /// a where c ≤ 0, else b.
    pub fn choose(c: Self, a: Self, b: Self) -> Self {
        let decided = |branch: Self| branch.after(c.defined, true);
        if c.defined == Defined::Nowhere {
            return Self::NOWHERE;
        }
        if c.range.hi <= 0.0 {
            return decided(a);
        }
        if c.range.lo > 0.0 {
            return decided(b);
        }
        let all = [a, b, c].iter().all(|e| e.defined == Defined::Everywhere);
        let range = a.range.hull(b.range);
        if all { Self::jumping(range) } else { Self::partial(range) }
    }
}

macro_rules! compose_unary {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {
        /// Composition: an operation after a function that is already enclosed.
        impl Enclosure {
            $($(#[$doc])* pub fn $name(self) -> Self {
                if self.defined == Defined::Nowhere {
                    return Self::NOWHERE;
                }
                self.range.$name().after(self.defined, self.continuous)
            })*
        }
    };
}

macro_rules! compose_binary {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {
        impl Enclosure {
            $($(#[$doc])* pub fn $name(self, other: Self) -> Self {
                if self.defined == Defined::Nowhere || other.defined == Defined::Nowhere {
                    return Self::NOWHERE;
                }
                self.range
                    .$name(other.range)
                    .after(self.defined, self.continuous)
                    .after(other.defined, other.continuous)
            })*
        }
    };
}

compose_unary! {
    /// −a
    negated,
    /// |a|
    abs,
    /// −1, 0, 1
    sign,
    /// √a
    sqrt,
    /// e^a
    exp,
    /// a^a
    self_power,
    /// natural logarithm
    ln,
    /// logarithm to base 2
    log2,
    /// logarithm to base 10
    log10,
    /// sine
    sin,
    /// cosine
    cos,
    /// tangent
    tan,
    /// arcsine
    asin,
    /// arccosine
    acos,
    /// arctangent
    atan,
    /// hyperbolic sine
    sinh,
    /// hyperbolic cosine
    cosh,
    /// hyperbolic tangent
    tanh,
    /// inverse hyperbolic sine
    asinh,
    /// inverse hyperbolic cosine
    acosh,
    /// inverse hyperbolic tangent
    atanh,
    /// error function
    erf,
    /// largest whole number ≤ a
    floor,
    /// a²
    square,
}

compose_binary! {
    /// a + b
    plus,
    /// a − b
    minus,
    /// a · b
    times,
    /// a / b
    over,
    /// the smaller
    min,
    /// the larger
    max,
    /// a^b
    pow,
    /// angle of the point (x = b, y = a)
    atan2,
}

impl Enclosure {
    /// a^n, n ≠ 0
    pub fn power(self, n: i64) -> Self {
        if self.defined == Defined::Nowhere {
            return Self::NOWHERE;
        }
        self.range.power(n).after(self.defined, self.continuous)
    }

    /// largest whole number ≤ n·a / b, n in 1…2^53
    pub fn floor_over(self, n: i64, other: Self) -> Self {
        if self.defined == Defined::Nowhere || other.defined == Defined::Nowhere {
            return Self::NOWHERE;
        }
        let whole = self.range.floor_over(n, other.range);
        whole.after(self.defined, self.continuous).after(other.defined, other.continuous)
    }

    /// real root of odd order n ≥ 3
    pub fn root(self, n: u32) -> Self {
        if self.defined == Defined::Nowhere {
            return Self::NOWHERE;
        }
        self.range.root(n).after(self.defined, self.continuous)
    }
}
