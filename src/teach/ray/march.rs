//! The textbook method, told: samples at t = k·H, changes of sign, Newton from the middle of each.
//!
//! In: g with its derivative. Out: every sample and every step. What `surface::march` does for pictures, with nothing left out.

use crate::num::func;
use crate::num::level::Portable;

/// The most samples that are taken: more say nothing new and take long.
pub const MAX_SAMPLES: usize = 100_000;

/// Newton's steps after which the bracket is taken as it is.
const MOST_STEPS: usize = 80;

/// g and g' at t.
pub type Slope<'a> = &'a dyn Fn(f64) -> (f64, f64);

/// One of Newton's steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Iterate {
    /// Where it stands.
    pub t: f64,
    /// g there.
    pub g: f64,
    /// g' there.
    pub slope: f64,
    /// Where the tangent is 0.
    pub aim: f64,
    /// Whether that is outside the bracket, so that the bracket was halved instead.
    pub left: bool,
    /// The observed order of convergence, from |g| of this step and the two before it.
    pub order: Option<f64>,
}

/// A change of sign between two samples, and the way to its root.
#[derive(Clone, Debug, PartialEq)]
pub struct Bracket {
    /// The sample before.
    pub a: f64,
    /// The sample behind; the same where a sample is a root.
    pub b: f64,
    /// Newton's steps.
    pub iterates: Vec<Iterate>,
}

impl Bracket {
    /// Where the method ends.
    pub fn end(&self) -> f64 {
        self.iterates.last().map_or(self.a, |last| last.t)
    }
}

/// The samples: the span's ends, and t = k·H between them.
pub fn samples(g: Slope, (t0, t1): (f64, f64), step: f64) -> Vec<(f64, f64)> {
    let first = (t0 / step).floor() + 1.0;
    let inner = (0..MAX_SAMPLES).map(|k| (first + k as f64) * step).take_while(|&t| t < t1);
    std::iter::once(t0).chain(inner).chain([t1]).map(|t| (t, g(t).0)).collect()
}

/// The changes of sign between neighbouring samples.
pub fn brackets(g: Slope, samples: &[(f64, f64)]) -> Vec<Bracket> {
    let mut found = Vec::new();
    for (k, pair) in samples.windows(2).enumerate() {
        let [(a, ga), (b, gb)] = [pair[0], pair[1]];
        if gb == 0.0 || k == 0 && ga == 0.0 && a > 0.0 {
            let t = if gb == 0.0 { b } else { a };
            found.push(Bracket { a: t, b: t, iterates: newton(g, t, t) });
        } else if ga * gb < 0.0 {
            found.push(Bracket { a, b, iterates: newton(g, a, b) });
        }
    }
    found
}

/// Newton's method from the middle of [a, b], halving where a step would leave it.
fn newton(g: Slope, a: f64, b: f64) -> Vec<Iterate> {
    let (mut a, mut b) = (a, b);
    let front = g(a).0;
    let mut t = 0.5 * (a + b);
    let mut list: Vec<Iterate> = Vec::new();
    for _ in 0..MOST_STEPS {
        let (value, slope) = g(t);
        let aim = t - value / slope;
        // A step within the rounding of t leads nowhere, inside the bracket or out of it.
        let is_end = value == 0.0 || a == b || (aim - t).abs() <= 4.0 * f64::EPSILON * t.abs();
        if (value < 0.0) == (front < 0.0) {
            a = t;
        } else {
            b = t;
        }
        let is_inside = aim > a && aim < b;
        let left = !is_end && !is_inside;
        let order = order(&list, value);
        list.push(Iterate { t, g: value, slope, aim, left, order });
        let next = if left { 0.5 * (a + b) } else { aim };
        if is_end || (next - t).abs() <= 2.0 * f64::EPSILON * t.abs() {
            break;
        }
        t = next;
    }
    list
}

/// p in |g_(k+1)| ≈ C·|g_k|^p, from three values in a row that all came by Newton's own steps.
fn order(list: &[Iterate], value: f64) -> Option<f64> {
    let [.., before, last] = list else { return None };
    let ln = |ratio: f64| func::ln::<Portable>(ratio);
    let (first, second) = ((last.g / before.g).abs(), (value / last.g).abs());
    let is_falling = first < 1.0 && second < 1.0 && second > 0.0 && !last.left && !before.left;
    is_falling.then(|| ln(second) / ln(first)).filter(|p| p.is_finite())
}
