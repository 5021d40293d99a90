//! Bounds: the arithmetic of f64 rounded down or up, and results with a known error pushed outward.
//!
//! In: f64 and the error bound of how they were computed. Out: an f64 that is surely not above (below) the exact
//! value. The sums, products, quotients and roots are the tightest bounds: the rounding error itself is computed
//! and its sign read. Separate because every operation of an interval ends here.

use crate::num::func::bound::steps;
use crate::num::fused;

/// Where results are smaller than this, rounding errors of products may themselves be rounded away.
const EXACT_ERRORS: f64 = 1e-280;

/// A few of the smallest f64: what rounding below the normal range may lose, doubled.
const SUBNORMAL: f64 = 8e-323;

/// Results below this may have lost more than a rounding.
const TINY: f64 = 1e-290;

/// Up to this error bound, the outward steps are counted; above, they are a part of the number.
const FEW_ULPS: f64 = 4.0;

/// Lower bound of the exact value of a result r computed within `ulps`, and of the results computed at other
/// points of a box that r is the least value on; 0 is exact.
pub(super) fn below(r: f64, ulps: f64) -> f64 {
    if r == 0.0 {
        return 0.0;
    }
    if r == f64::INFINITY {
        return f64::MAX;
    }
    if ulps > FEW_ULPS {
        return r - (2.5 * ulps * f64::EPSILON * r.abs() + SUBNORMAL);
    }
    if r.abs() < TINY {
        return r - SUBNORMAL - r.abs() * (4.0 * ulps * f64::EPSILON);
    }
    (0..steps(ulps)).fold(r, |r, _| r.next_down())
}

/// Upper bound, as [`below`].
pub(super) fn above(r: f64, ulps: f64) -> f64 {
    -below(-r, ulps)
}

/// As [`above`], for a result that is 0 because it is too small.
pub(super) fn above_vanishing(r: f64, ulps: f64) -> f64 {
    if r == 0.0 { SUBNORMAL } else { above(r, ulps) }
}

/// The rounded result, or the f64 below it if the exact value is below.
fn settle_down(r: f64, error: f64) -> f64 {
    if error < 0.0 { r.next_down() } else { r }
}

/// a + b, rounded down.
pub(super) fn sum_down(a: f64, b: f64) -> f64 {
    let s = a + b;
    if s.is_infinite() {
        // An overflow of finite numbers lies above the largest f64 or below any.
        return if a.is_infinite() || b.is_infinite() { s } else { s.next_down() };
    }
    let t = s - a;
    settle_down(s, (a - (s - t)) + (b - t))
}

/// a + b, rounded up.
pub(super) fn sum_up(a: f64, b: f64) -> f64 {
    -sum_down(-a, -b)
}

/// a · b, rounded down; 0 · ∞ is 0.
pub(super) fn product_down(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    let p = a * b;
    if p.is_infinite() {
        return if a.is_infinite() || b.is_infinite() { p } else { p.next_down() };
    }
    if p.abs() < EXACT_ERRORS {
        let lower = p.next_down();
        return if (a > 0.0) == (b > 0.0) { lower.max(0.0) } else { lower };
    }
    settle_down(p, fused::mul_add(a, b, -p))
}

/// a · b, rounded up; 0 · ∞ is 0.
pub(super) fn product_up(a: f64, b: f64) -> f64 {
    -product_down(-a, b)
}

/// a / b, rounded down, b ≠ 0; a/∞ is 0, ∞/∞ too.
pub(super) fn quotient_down(a: f64, b: f64) -> f64 {
    if a == 0.0 || b.is_infinite() {
        return 0.0;
    }
    let q = a / b;
    if q.is_infinite() {
        return if a.is_infinite() { q } else { q.next_down() };
    }
    if q.abs() < EXACT_ERRORS || a.abs() < EXACT_ERRORS {
        let lower = q.next_down();
        return if (a > 0.0) == (b > 0.0) { lower.max(0.0) } else { lower };
    }
    let remainder = fused::mul_add(-q, b, a);
    settle_down(q, if b > 0.0 { remainder } else { -remainder })
}

/// a / b, rounded up, b ≠ 0.
pub(super) fn quotient_up(a: f64, b: f64) -> f64 {
    -quotient_down(-a, b)
}

/// √a, rounded down, a ≥ 0.
pub(super) fn root_down(a: f64) -> f64 {
    let s = a.sqrt();
    if a == 0.0 || a.is_infinite() {
        return s;
    }
    if a < EXACT_ERRORS {
        return s.next_down();
    }
    settle_down(s, fused::mul_add(-s, s, a))
}

/// √a, rounded up, a ≥ 0.
pub(super) fn root_up(a: f64) -> f64 {
    let s = a.sqrt();
    if a == 0.0 || a.is_infinite() {
        return s;
    }
    if a < EXACT_ERRORS || fused::mul_add(-s, s, a) > 0.0 { s.next_up() } else { s }
}
