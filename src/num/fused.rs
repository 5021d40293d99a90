//! a·b + c with one rounding, in software.

/// a·b + c, correctly rounded.
pub fn mul_add(a: f64, b: f64, c: f64) -> f64 {
    a.mul_add(b, c)
}
