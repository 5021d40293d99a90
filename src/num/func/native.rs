//! The functions of one number on the fastest level this machine has, for callers that are not compiled per level.
//!
//! In: one f64, or two. Out: the same bits as at any level. Separate because each call asks which level there is:
//! right for one number, wrong for a loop.

use crate::num::level::{Simd, for_each_level};

macro_rules! unary {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => { $(
        $(#[$doc])*
        pub fn $name(a: f64) -> f64 {
            for_each_level! {
                fn stamped[L](a: f64) -> f64 {
                    super::$name::<L>(a)
                }
            }
            stamped(Simd::best(), a)
        }
    )* };
}

macro_rules! binary {
    ($($(#[$doc:meta])* $name:ident($second:ty)),* $(,)?) => { $(
        $(#[$doc])*
        pub fn $name(a: f64, b: $second) -> f64 {
            for_each_level! {
                fn stamped[L](a: f64, b: $second) -> f64 {
                    super::$name::<L>(a, b)
                }
            }
            stamped(Simd::best(), a, b)
        }
    )* };
}

unary! {
    /// e^a
    exp,
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
}

binary! {
    /// a^b
    pow(f64),
    /// angle of the point (x = b, y = a)
    atan2(f64),
    /// a^b for a whole b
    power(i64),
    /// root of odd order b
    root(u32),
}
