//! Elementary functions of affine forms: the tangent at the centre, and how far the function can be from it.
//!
//! In: forms. Out: f(m) + f'(m)·(x − m), widened by a bound of the rest over the form's range [m − r, m + r], halved by moving
//! the centre where the rest has one sign. Where the range is too wide for that, or leaves the domain, intervals answer.
//! Separate from sums and products because each function has a bound of its own.

use super::{AffineLanes, ROUNDING, TINY, arithmetic, repair};
use crate::num::func;
use crate::num::func::trigonometric::{self, REDUCIBLE};
use crate::num::level::Level;
use crate::num::mask::{Mask, any, word};
use crate::num::number::Number;

/// A line with what it leaves over: f(x) is in `value` + `slope`·(x − m) + [`least`, `most`].
#[derive(Clone, Copy)]
struct Tangent {
    value: f64,
    slope: f64,
    least: f64,
    most: f64,
    /// What roundings of value and slope are a part of.
    size: f64,
    /// Whether the bounds hold.
    holds: bool,
}

/// The form of a function from its tangent at (m, r); marks the lanes where it does not hold.
#[inline(always)]
fn along<const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
    tangent: impl Fn(f64, f64) -> Tangent,
) -> Mask<N> {
    let mut odd = [0; N];
    for i in 0..N {
        let radius = a.radius(i);
        let t = tangent(a.center[i], radius);
        let rest = 0.5 * (t.most - t.least);
        let center = t.value + 0.5 * (t.most + t.least);
        let error = t.slope.abs() * a.error[i] + rest + ROUNDING * (t.size + t.slope.abs() * radius + rest) + TINY;
        out.center[i] = center;
        out.error[i] = error;
        for k in 0..S {
            out.slope[k][i] = t.slope * a.slope[k][i];
        }
        odd[i] = word(!(t.holds & (center.abs() + error < f64::INFINITY)));
    }
    out.flags = a.flags;
    odd
}

macro_rules! tangents {
    ($($name:ident($m:ident, $r:ident) = $tangent:expr;)*) => { $(
        #[inline(always)]
        pub(super) fn $name<L: Level, const N: usize, const S: usize>(a: &AffineLanes<N, S>, out: &mut AffineLanes<N, S>) {
            let odd = along(a, out, |$m, $r| $tangent);
            if any(&odd) {
                repair!(odd, out, $name::<L>(a));
            }
        }
    )* };
}

/// Half of the largest |f''| of each function: arctan (at 1/√3), tanh (at artanh(1/√3)), erf (at 1/√2).
const HALF_BEND_ATAN: f64 = 0.325;
const HALF_BEND_TANH: f64 = 0.385;
const HALF_BEND_ERF: f64 = 0.485;

/// e^r − 1 − r is at most r²·(1/2 + r·0.22) up to here (0.7183 < 0.72 at 1).
const SHORT_EXPONENT: f64 = 1.0;

/// Ranges of an angle up to this half width are told from [−1, 1].
const SHORT_ANGLE: f64 = 1.5;

tangents! {
    sqrt(m, r) = root_tangent(m, r);
    exp(m, r) = exponential(func::exp::<L>(m), r);
    ln(m, r) = logarithm(func::ln::<L>(m), 1.0, m, r);
    log2(m, r) = logarithm(func::log2::<L>(m), std::f64::consts::LOG2_E, m, r);
    log10(m, r) = logarithm(func::log10::<L>(m), std::f64::consts::LOG10_E, m, r);
    sin(m, r) = {
        let (s, c) = trigonometric::sin_cos_reducible::<L>(m);
        wave(s, c, m, r)
    };
    cos(m, r) = {
        let (s, c) = trigonometric::sin_cos_reducible::<L>(m);
        wave(c, -s, m, r)
    };
    tan(m, r) = {
        let f = trigonometric::tan_reducible::<L>(m);
        tangent_of_tangent(f, m, r)
    };
    atan(m, r) = bent(func::atan::<L>(m), 1.0 / (1.0 + m * m), HALF_BEND_ATAN, r);
    tanh(m, r) = {
        let f = func::tanh::<L>(m);
        bent(f, 1.0 - f * f, HALF_BEND_TANH, r)
    };
    erf(m, r) = bent(func::erf::<L>(m), std::f64::consts::FRAC_2_SQRT_PI * func::exp::<L>(-(m * m)), HALF_BEND_ERF, r);
    sinh(m, r) = hyperbolic(func::sinh::<L>(m), func::cosh::<L>(m), r);
    cosh(m, r) = hyperbolic(func::cosh::<L>(m), func::sinh::<L>(m), r);
}

/// A function with |f''| / 2 at most `half_bend` everywhere, of values and slopes of at most about 1.
#[inline(always)]
fn bent(value: f64, slope: f64, half_bend: f64, r: f64) -> Tangent {
    let rest = half_bend * (r * r);
    Tangent { value, slope, least: -rest, most: rest, size: value.abs() + slope.abs() * r, holds: rest < 2.0 }
}

/// √x is above the line through its ends, l and h, by at most (√h − √l)²/(4·(√h + √l)).
#[inline(always)]
fn root_tangent(m: f64, r: f64) -> Tangent {
    let (l, h) = (m - r, m + r);
    let (least, most) = (l.sqrt(), h.sqrt());
    let slope = 1.0 / (least + most);
    let value = 0.5 * (least + most);
    let above = 0.25 * slope * ((most - least) * (most - least)) * (1.0 + ROUNDING);
    Tangent { value, slope, least: 0.0, most: above, size: most, holds: (l >= 0.0) & (h > 0.0) }
}

/// ln x − (ln m + (x − m)/m) is between −(x − m)²/(2·l²) and 0, l the least x; times `unit`.
#[inline(always)]
fn logarithm(value: f64, unit: f64, m: f64, r: f64) -> Tangent {
    let l = (m - r) * (1.0 - ROUNDING);
    let part = r / l;
    let least = -0.5 * unit * (part * part) * (1.0 + ROUNDING);
    Tangent { value, slope: unit / m, least, most: 0.0, size: value.abs() + unit, holds: (l > 0.0) & (part < 4.0) }
}

/// e^(m + d) − f·(1 + d) = f·(e^d − 1 − d), between 0 and its value at r.
#[inline(always)]
fn exponential(f: f64, r: f64) -> Tangent {
    let most = f * (r * r * (0.5 + 0.22 * r));
    Tangent { value: f, slope: f, least: 0.0, most, size: f, holds: r <= SHORT_EXPONENT }
}

/// sinh or cosh, f, with the other, g = f': the rest is f·(cosh d − 1) + g·(sinh d − d), cosh d − 1 at most
/// r²·(1/2 + 0.06·r²) and sinh d − d at most r³·(1/6 + 0.01·r²).
#[inline(always)]
fn hyperbolic(f: f64, g: f64, r: f64) -> Tangent {
    let bend = f * (r * r * (0.5 + 0.06 * (r * r)));
    let twist = (g * (r * r * r * (1.0 / 6.0 + 0.01 * (r * r)))).abs();
    let (least, most) = (bend.min(0.0) - twist, bend.max(0.0) + twist);
    Tangent { value: f, slope: g, least, most, size: f.abs() + g.abs(), holds: r <= SHORT_EXPONENT }
}

/// sin(m + d) = s + c·d − s·(1 − cos d) − c·(d − sin d), with 1 − cos d in [0, r²/2] and |d − sin d| ≤ r³/6.
#[inline(always)]
fn wave(s: f64, c: f64, m: f64, r: f64) -> Tangent {
    let bend = -s * (0.5 * (r * r));
    let twist = c.abs() * (r * r * r * (1.0 / 6.0));
    let holds = (r <= SHORT_ANGLE) & (m.abs() + r < REDUCIBLE);
    Tangent { value: s, slope: c, least: bend.min(0.0) - twist, most: bend.max(0.0) + twist, size: 1.0, holds }
}

/// tan(m + d) − tan m − (1 + tan² m)·d, from tan(m + d) = (f + τ)/(1 − f·τ), τ = tan d: with q = (1 + f²) it is
/// q·(τ − d) + q·f·τ²/(1 − f·τ); τ − d ≤ d³/2 and τ ≤ 1.21·d for |d| ≤ 0.7.
#[inline(always)]
fn tangent_of_tangent(f: f64, m: f64, r: f64) -> Tangent {
    let q = 1.0 + f * f;
    let tau = 1.21 * r;
    let room = 1.0 - f.abs() * tau;
    let rest = q * (0.5 * (r * r * r)) + q * f.abs() * (tau * tau) / room;
    let holds = (r < 0.7) & (room > 0.25) & (m.abs() + r < REDUCIBLE);
    Tangent { value: f, slope: q, least: -rest, most: rest, size: q, holds }
}

/// Sine and cosine of the same forms.
#[inline(always)]
pub(super) fn sin_cos<L: Level, const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    sin: &mut AffineLanes<N, S>,
    cos: &mut AffineLanes<N, S>,
) {
    let (mut s, mut c) = ([0.0; N], [0.0; N]);
    for i in 0..N {
        (s[i], c[i]) = trigonometric::sin_cos_reducible::<L>(a.center[i]);
    }
    let mut odd = [0; N];
    for i in 0..N {
        let (m, r) = (a.center[i], a.radius(i));
        let rest = ROUNDING * (1.0 + r) + TINY;
        for (out, t) in [(&mut *sin, wave(s[i], c[i], m, r)), (&mut *cos, wave(c[i], -s[i], m, r))] {
            out.center[i] = t.value + 0.5 * (t.most + t.least);
            out.error[i] = t.slope.abs() * a.error[i] + 0.5 * (t.most - t.least) + rest * (1.0 + r * r);
            for k in 0..S {
                out.slope[k][i] = t.slope * a.slope[k][i];
            }
            odd[i] |= word(!t.holds);
        }
    }
    sin.flags = a.flags;
    cos.flags = a.flags;
    if any(&odd) {
        repair!(odd, sin, sin::<L>(a));
        repair!(odd, cos, cos::<L>(a));
    }
}

/// 1/x, for a quotient; marks the lanes where 0 is near: 1/x − (1/m − (x − m)/m²) = (x − m)²/(m²·x).
#[inline(always)]
pub(super) fn reciprocal<const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
) -> Mask<N> {
    along(a, out, |m, r| {
        let least_size = (m.abs() - r) * (1.0 - ROUNDING);
        let value = 1.0 / m;
        let part = r * value;
        let rest = part * part / least_size * (1.0 + ROUNDING);
        let (least, most) = if m > 0.0 { (0.0, rest) } else { (-rest, 0.0) };
        let holds = (least_size > 0.0) & (least_size > 0.1 * m.abs());
        Tangent { value, slope: -(value * value), least, most, size: value.abs(), holds }
    })
}

/// Powers of more than this many factors are e^(n·ln x): products of forms forget too much.
const FEW_FACTORS: u64 = 16;

/// Whole powers by repeated squaring of forms.
#[inline(always)]
pub(super) fn power<L: Level, const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    n: i64,
    out: &mut AffineLanes<N, S>,
) {
    let count = n.unsigned_abs();
    if count == 0 || count > FEW_FACTORS {
        repair!([u64::MAX; N], out, power::<L>(a; n));
        return;
    }
    let mut odd = [0; N];
    let mut base = *a;
    if n < 0 {
        odd = reciprocal(a, &mut base);
    }
    *out = base;
    // From the second binary digit of the exponent down.
    for digit in (0..count.ilog2()).rev() {
        let before = *out;
        arithmetic::square(&before, out);
        if count >> digit & 1 == 1 {
            let before = *out;
            arithmetic::mul(&before, &base, out);
        }
    }
    out.flags = a.flags;
    if any(&odd) {
        repair!(odd, out, power::<L>(a; n));
    }
}

/// The root of odd order of forms beside 0: sign·e^(ln|x|/n).
#[inline(always)]
pub(super) fn root<L: Level, const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    n: u32,
    out: &mut AffineLanes<N, S>,
) {
    let order = f64::from(n);
    let odd = along(a, out, |m, r| {
        let l = (m.abs() - r) * (1.0 - ROUNDING);
        let value = func::root::<L>(m, n);
        let slope = value / (order * m);
        // f'' = −(1 − 1/n)/n · f/x², largest at the end nearest to 0.
        let steep = func::root::<L>(l, n) / (l * l) * (1.0 + ROUNDING);
        let rest = 0.5 / order * steep * (r * r);
        let (least, most) = if m > 0.0 { (-rest, 0.0) } else { (0.0, rest) };
        Tangent { value, slope, least, most, size: value.abs(), holds: (l > 0.0) & (l > 0.1 * m.abs()) }
    });
    if any(&odd) {
        repair!(odd, out, root::<L>(a; n));
    }
}

/// a^b = e^(b·ln a) for a > 0.
#[inline(always)]
pub(super) fn pow<L: Level, const N: usize, const S: usize>(
    a: &AffineLanes<N, S>,
    b: &AffineLanes<N, S>,
    out: &mut AffineLanes<N, S>,
) {
    let mut odd = [0; N];
    for i in 0..N {
        odd[i] = word(!(a.bounds(i).0 > 0.0));
    }
    if odd.iter().all(|&lane| lane != 0) {
        repair!(odd, out, pow::<L>(a, b));
        return;
    }
    let (mut logarithm, mut product) = (*a, *a);
    ln::<L, N, S>(a, &mut logarithm);
    arithmetic::mul(&logarithm, b, &mut product);
    exp::<L, N, S>(&product, out);
    if any(&odd) {
        repair!(odd, out, pow::<L>(a, b));
    }
}
