//! a·b + c with one rounding, in software.
//!
//! In: three f64. Out: the f64 nearest to the exact a·b + c, ties to even. Separate because it is what makes a
//! machine without fused products give the same bits as one with them.

/// The exponent of the smallest f64.
const LOWEST: i32 = -1074;

/// A number m·2^exponent with a sign.
#[derive(Clone, Copy)]
struct Exact {
    negative: bool,
    m: u128,
    exponent: i32,
}

/// a·b + c, correctly rounded.
pub fn mul_add(a: f64, b: f64, c: f64) -> f64 {
    if !(a.is_finite() && b.is_finite()) || a == 0.0 || b == 0.0 {
        return a * b + c;
    }
    if !c.is_finite() {
        return c;
    }
    if c == 0.0 {
        return a * b;
    }
    let (p, q) = (exact(a), exact(b));
    let negative = p.negative != q.negative;
    let product = Exact { negative, m: p.m * q.m, exponent: p.exponent + q.exponent };
    rounded(sum(product, exact(c)))
}

/// A finite f64 as it is.
fn exact(x: f64) -> Exact {
    let bits = x.to_bits();
    let biased = ((bits >> 52) & 0x7ff) as i32;
    let fraction = bits & ((1 << 52) - 1);
    let (m, exponent) = if biased == 0 { (fraction, LOWEST) } else { (fraction | 1 << 52, biased + LOWEST - 1) };
    Exact { negative: bits >> 63 == 1, m: u128::from(m), exponent }
}

/// The sum of two numbers that are not 0, of at most 106 bits each. What the smaller one has below the larger
/// one's 127 bits becomes the last bit: enough to round by, for it is set only where nothing cancels.
fn sum(a: Exact, b: Exact) -> Exact {
    let (a, b) = (normalized(a), normalized(b));
    let (big, small) = if (a.exponent, a.m) >= (b.exponent, b.m) { (a, b) } else { (b, a) };
    let distance = (big.exponent - small.exponent) as u32;
    let kept = small.m.checked_shr(distance).unwrap_or(0);
    let lost = distance >= 128 || kept << distance != small.m;
    let small = kept | u128::from(lost);
    let m = if a.negative == b.negative { big.m + small } else { big.m - small };
    Exact { negative: big.negative && m != 0, m, exponent: big.exponent }
}

/// The same number with its leading bit in place 126.
fn normalized(a: Exact) -> Exact {
    let shift = a.m.leading_zeros() - 1;
    Exact { m: a.m << shift, exponent: a.exponent - shift as i32, ..a }
}

/// The nearest f64, ties to even.
fn rounded(a: Exact) -> f64 {
    let length = 128 - a.m.leading_zeros() as i32;
    let last = (a.exponent + length - 53).max(LOWEST);
    let shift = last - a.exponent;
    let quotient = if shift <= 0 { a.m << -shift } else { a.m.checked_shr(shift as u32).unwrap_or(0) };
    let up = shift > 0 && {
        let half = 1u128.checked_shl(shift as u32 - 1).unwrap_or(0);
        let rest = if shift < 128 { a.m & ((1 << shift) - 1) } else { a.m };
        half != 0 && (rest > half || (rest == half && quotient & 1 == 1))
    };
    // A carry out of the fraction raises the exponent, and out of the exponent gives infinity.
    let carried = (quotient as u64) + u64::from(up);
    let exponent = if quotient == 0 { 0 } else { ((last - LOWEST) as u64) << 52 };
    let bits = (exponent + carried).min(f64::INFINITY.to_bits());
    f64::from_bits(bits | u64::from(a.negative) << 63)
}

#[cfg(test)]
mod tests {
    use super::mul_add;

    /// Signs, zeros, subnormals, the largest, infinities and NaN.
    const NASTY: [f64; 18] = [
        0.0,
        -0.0,
        5e-324,
        -5e-324,
        f64::MIN_POSITIVE.next_down(),
        f64::MIN_POSITIVE,
        1e-300,
        1.0,
        -1.0,
        1.0 + f64::EPSILON,
        1.0 - f64::EPSILON / 2.0,
        3.0,
        1e16,
        -1e300,
        f64::MAX,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
    ];

    #[track_caller]
    fn check(a: f64, b: f64, c: f64) {
        let (soft, hard) = (mul_add(a, b, c), a.mul_add(b, c));
        assert!(
            soft.to_bits() == hard.to_bits() || (soft.is_nan() && hard.is_nan()),
            "{a:e} · {b:e} + {c:e}: {soft:e}, not {hard:e}"
        );
    }

    #[test]
    fn nasty_triples_agree_with_the_hardware() {
        for a in NASTY {
            for b in NASTY {
                for c in NASTY {
                    check(a, b, c);
                }
            }
        }
    }

    #[test]
    fn random_triples_agree_with_the_hardware() {
        let mut state = 1u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            state ^ (state >> 29)
        };
        for i in 0..400_000u32 {
            let any = |bits: u64| f64::from_bits(bits);
            let near = |bits: u64, spread: u64| {
                f64::from_bits((bits & 0x800f_ffff_ffff_ffff) | ((1023 - spread / 2 + (bits >> 52) % spread) << 52))
            };
            let short = |x: f64| f64::from_bits(x.to_bits() & !0x7ff_ffff);
            let (a, b) = (next(), next());
            match i % 5 {
                0 => check(any(a), any(b), any(next())),
                1 => check(near(a, 4), near(b, 4), near(next(), 120)),
                2 => check(near(a, 1040), near(b, 1040), near(next(), 2000)),
                // Cancellation: c is −a·b rounded, and its neighbours.
                3 => check(near(a, 60), near(b, 60), -(near(a, 60) * near(b, 60)).next_up()),
                // Ties: few bits in the factors.
                _ => check(short(near(a, 8)), short(near(b, 8)), near(next(), 110)),
            }
        }
    }
}
