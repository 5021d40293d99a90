//! What a number type must be able to do so that closures can compute with it.
//!
//! One value of a [`Number`] is a whole batch: 64 points, 16 intervals. Every operation reads batches and
//! writes one; it is written once and compiled for every [`Level`].

use super::interval::Interval;
use super::level::Level;

/// A constant as every number type may want it.
#[derive(Clone, Copy, Debug)]
pub struct Constant {
    /// The nearest f64.
    pub point: f64,
    /// An interval that contains the exact value.
    pub range: Interval,
}

/// One of the three operations that [`Pair`] joins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basic {
    /// a + b
    Add,
    /// a − b
    Sub,
    /// a · b
    Mul,
}

/// Two operations in one pass, each rounded as if it stood alone: what is saved is writing and reading the batch between them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pair {
    /// Of a and b.
    pub first: Basic,
    /// Of that and c.
    pub second: Basic,
    /// Whether c is the left operand of the second.
    pub reversed: bool,
}

/// A batch of numbers of one kind.
///
/// Every method computes its operation for all lanes; without value (NaN) in, without value out. The
/// meaning of each is that of the operation of the same name in the expression graph.
pub trait Number: Clone + Send + Sync + 'static {
    /// The batch with the same number in every lane.
    fn constant(value: Constant) -> Self;
    /// −a
    fn neg<L: Level>(a: &Self, out: &mut Self);
    /// |a|
    fn abs<L: Level>(a: &Self, out: &mut Self);
    /// −1, 0, 1
    fn sign<L: Level>(a: &Self, out: &mut Self);
    /// √a
    fn sqrt<L: Level>(a: &Self, out: &mut Self);
    /// e^a
    fn exp<L: Level>(a: &Self, out: &mut Self);
    /// natural logarithm
    fn ln<L: Level>(a: &Self, out: &mut Self);
    /// logarithm to base 2
    fn log2<L: Level>(a: &Self, out: &mut Self);
    /// logarithm to base 10
    fn log10<L: Level>(a: &Self, out: &mut Self);
    /// sine
    fn sin<L: Level>(a: &Self, out: &mut Self);
    /// cosine
    fn cos<L: Level>(a: &Self, out: &mut Self);
    /// sine and cosine at the cost of little more than one
    fn sin_cos<L: Level>(a: &Self, sin: &mut Self, cos: &mut Self);
    /// tangent
    fn tan<L: Level>(a: &Self, out: &mut Self);
    /// arcsine
    fn asin<L: Level>(a: &Self, out: &mut Self);
    /// arccosine
    fn acos<L: Level>(a: &Self, out: &mut Self);
    /// arctangent
    fn atan<L: Level>(a: &Self, out: &mut Self);
    /// hyperbolic sine
    fn sinh<L: Level>(a: &Self, out: &mut Self);
    /// hyperbolic cosine
    fn cosh<L: Level>(a: &Self, out: &mut Self);
    /// hyperbolic tangent
    fn tanh<L: Level>(a: &Self, out: &mut Self);
    /// inverse hyperbolic sine
    fn asinh<L: Level>(a: &Self, out: &mut Self);
    /// inverse hyperbolic cosine
    fn acosh<L: Level>(a: &Self, out: &mut Self);
    /// inverse hyperbolic tangent
    fn atanh<L: Level>(a: &Self, out: &mut Self);
    /// error function
    fn erf<L: Level>(a: &Self, out: &mut Self);
    /// largest whole number ≤ a
    fn floor<L: Level>(a: &Self, out: &mut Self);
    /// a²
    fn square<L: Level>(a: &Self, out: &mut Self);
    /// a^n by repeated squaring, n ≠ 0
    fn power<L: Level>(a: &Self, n: i64, out: &mut Self);
    /// real root of odd order n ≥ 3
    fn root<L: Level>(a: &Self, n: u32, out: &mut Self);
    /// a + b
    fn add<L: Level>(a: &Self, b: &Self, out: &mut Self);
    /// a − b
    fn sub<L: Level>(a: &Self, b: &Self, out: &mut Self);
    /// a · b
    fn mul<L: Level>(a: &Self, b: &Self, out: &mut Self);
    /// a / b
    fn div<L: Level>(a: &Self, b: &Self, out: &mut Self);
    /// largest whole number ≤ n·a / b, n in 1…2^53
    fn floor_div<L: Level>(a: &Self, b: &Self, n: i64, out: &mut Self);
    /// the smaller
    fn min<L: Level>(a: &Self, b: &Self, out: &mut Self);
    /// the larger
    fn max<L: Level>(a: &Self, b: &Self, out: &mut Self);
    /// a^b, a > 0 or (a = 0 and b > 0)
    fn pow<L: Level>(a: &Self, b: &Self, out: &mut Self);
    /// a^a, which is known more closely than a^b where both happen to be the same
    #[inline(always)]
    fn self_power<L: Level>(a: &Self, out: &mut Self) {
        Self::pow::<L>(a, a, out);
    }
    /// angle of (x = b, y = a)
    fn atan2<L: Level>(a: &Self, b: &Self, out: &mut Self);
    /// Two operations, the second on the result of the first and c.
    #[inline(always)]
    fn pair<L: Level>(pair: Pair, a: &Self, b: &Self, c: &Self, out: &mut Self) {
        let mut first = a.clone();
        basic::<Self, L>(pair.first, a, b, &mut first);
        let (left, right) = if pair.reversed { (c, &first) } else { (&first, c) };
        basic::<Self, L>(pair.second, left, right, out);
    }
    /// a·b + c·d, or a·b − c·d
    #[inline(always)]
    fn products<L: Level>(minus: bool, [a, b, c, d]: [&Self; 4], out: &mut Self) {
        let (mut left, mut right) = (a.clone(), c.clone());
        Self::mul::<L>(a, b, &mut left);
        Self::mul::<L>(c, d, &mut right);
        basic::<Self, L>(if minus { Basic::Sub } else { Basic::Add }, &left, &right, out);
    }
    /// a, of which `size` is the size: where that is not zero a has no root, though it may jump from one sign to the other, and counts
    /// as if it had no value. Only enclosures need that.
    #[inline(always)]
    fn sized(a: &Self, _size: &Self, out: &mut Self) {
        out.clone_from(a);
    }
    /// a where c ≤ 0, else b
    fn choose<L: Level>(c: &Self, a: &Self, b: &Self, out: &mut Self);
}

#[inline(always)]
fn basic<T: Number, L: Level>(operation: Basic, a: &T, b: &T, out: &mut T) {
    match operation {
        Basic::Add => T::add::<L>(a, b, out),
        Basic::Sub => T::sub::<L>(a, b, out),
        Basic::Mul => T::mul::<L>(a, b, out),
    }
}
