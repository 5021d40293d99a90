//! The formulas of the bench, each as text and by hand.
//!
//! In: coordinates of 64 points. Out: f, f_x, f_y, f_z there. Written as loops over arrays with the elementary
//! functions of the crate, so that what is compared is the closures and not the mathematics.

use implicit::num::func::exponential::exp;
use implicit::num::func::trigonometric::sin_cos_reducible;
use implicit::num::level::{Fused, Level, Portable};

type Points = [[f64; 64]; 3];
type Values = [[f64; 64]; 4];

/// A formula written in two ways.
pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) text: fn() -> String,
    fused: unsafe fn(&Points, &mut Values),
    portable: fn(&Points, &mut Values),
    /// How many times slower than by hand the closures may be.
    pub(crate) goal: f64,
}

/// Runs the formula as written by hand, with the best instructions of the machine.
pub(crate) fn run(case: &Case, points: &Points, out: &mut Values) {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
        #[allow(unsafe_code, reason = "the function needs what was just detected")]
        // SAFETY: the machine has AVX2 and FMA, all that the function was compiled for.
        return unsafe { (case.fused)(points, out) };
    }
    (case.portable)(points, out);
}

/// The table of formulas: name, goal, text, function by hand.
macro_rules! cases {
    ($($name:literal, $goal:literal, $text:expr, $function:ident;)*) => {
        pub(crate) const CASES: &[Case] = &[$(Case {
            name: $name,
            text: || $text,
            goal: $goal,
            fused: {
                #[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2,fma"))]
                fn fused(points: &Points, out: &mut Values) {
                    $function::<Fused>(points, out);
                }
                fused
            },
            portable: $function::<Portable>,
        }),*];
    };
}

/// Functions of 64 points from an expression of one.
macro_rules! pointwise {
    ($($name:ident |$level:ident, $x:ident, $y:ident, $z:ident| $body:block)*) => { $(
        #[inline(always)]
        #[allow(clippy::extra_unused_type_parameters, reason = "polynomials are the same at every level")]
        fn $name<$level: Level>(points: &Points, out: &mut Values) {
            for i in 0..64 {
                let ($x, $y, $z) = (points[0][i], points[1][i], points[2][i]);
                let [f, fx, fy, fz]: [f64; 4] = $body;
                (out[0][i], out[1][i], out[2][i], out[3][i]) = (f, fx, fy, fz);
            }
        }
    )* };
}

const BARTH: &str = "g = golden
4*(g^2*x^2 - y^2)*(g^2*y^2 - z^2)*(g^2*z^2 - x^2) = (1 + 2*g)*(x^2 + y^2 + z^2 - 1)^2";

/// (1 + √5)/2 and its square.
const PHI: f64 = 1.618033988749895;
const PHI2: f64 = PHI + 1.0;

/// Coordinate `axis` of the k-th centre: spread over the cube of side 2, with three decimals.
const fn center(k: usize, axis: usize) -> f64 {
    let spread = [617, 331, 787][axis] * (k + 1) % 2000;
    (spread as f64 - 1000.0) / 1000.0
}

const fn centers<const N: usize>() -> [[f64; 3]; N] {
    let mut all = [[0.0; 3]; N];
    let mut k = 0;
    while k < N {
        all[k] = [center(k, 0), center(k, 1), center(k, 2)];
        k += 1;
    }
    all
}

static GAUSSIANS: [[f64; 3]; 20] = centers();
static SPHERES: [[f64; 3]; 27] = centers();

/// |p − c|² as text.
fn distance(c: &[f64; 3]) -> String {
    format!("(x - ({}))^2 + (y - ({}))^2 + (z - ({}))^2", c[0], c[1], c[2])
}

fn gaussians() -> String {
    let terms: Vec<String> = GAUSSIANS.iter().map(|c| format!("exp(-4*({}))", distance(c))).collect();
    format!("{} = 0.5", terms.join(" + "))
}

fn spheres() -> String {
    let terms: Vec<String> = SPHERES.iter().map(|c| format!("{} - 0.04", distance(c))).collect();
    format!("min({}) = 0", terms.join(", "))
}

cases! {
    "sphere", 4.0, "x^2 + y^2 + z^2 = 1".into(), sphere;
    "z - sin x cos y", 4.0, "z = sin(x)*cos(y)".into(), eggcrate;
    "Barth sextic", 4.0, BARTH.into(), barth;
    "tanglecube", 6.0, "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8 = 0".into(), tanglecube;
    "gyroid", 4.0, "sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x) = 0".into(), gyroid;
    "20 Gaussians", 4.0, gaussians(), sum_of_gaussians;
    "27 spheres by min", 4.0, spheres(), nearest_sphere;
}

pointwise! {
    sphere |L, x, y, z| {
        [x * x + y * y + z * z - 1.0, 2.0 * x, 2.0 * y, 2.0 * z]
    }
    eggcrate |L, x, y, z| {
        let (sx, cx) = sin_cos_reducible::<L>(x);
        let (sy, cy) = sin_cos_reducible::<L>(y);
        [z - sx * cy, -(cx * cy), sx * sy, 1.0]
    }
    barth |L, x, y, z| {
        let (x2, y2, z2) = (x * x, y * y, z * z);
        let (a, b, c) = (PHI2 * x2 - y2, PHI2 * y2 - z2, PHI2 * z2 - x2);
        let s = x2 + y2 + z2 - 1.0;
        let k = 1.0 + 2.0 * PHI;
        let w = 4.0 * k * s;
        [
            4.0 * a * b * c - k * s * s,
            4.0 * (2.0 * PHI2 * x * b * c - a * b * (2.0 * x)) - w * x,
            4.0 * (2.0 * PHI2 * y * a * c - b * c * (2.0 * y)) - w * y,
            4.0 * (2.0 * PHI2 * z * a * b - a * c * (2.0 * z)) - w * z,
        ]
    }
    tanglecube |L, x, y, z| {
        let (x2, y2, z2) = (x * x, y * y, z * z);
        let f = x2 * (x2 - 5.0) + y2 * (y2 - 5.0) + z2 * (z2 - 5.0) + 11.8;
        [f, x * (4.0 * x2 - 10.0), y * (4.0 * y2 - 10.0), z * (4.0 * z2 - 10.0)]
    }
    gyroid |L, x, y, z| {
        let (sx, cx) = sin_cos_reducible::<L>(x);
        let (sy, cy) = sin_cos_reducible::<L>(y);
        let (sz, cz) = sin_cos_reducible::<L>(z);
        [sx * cy + sy * cz + sz * cx, cx * cy - sz * sx, cy * cz - sx * sy, cz * cx - sy * sz]
    }
    nearest_sphere |L, x, y, z| {
        let mut best = [f64::INFINITY, 0.0, 0.0, 0.0];
        for c in &SPHERES {
            let (u, v, w) = (x - c[0], y - c[1], z - c[2]);
            let f = u * u + v * v + w * w - 0.04;
            let nearer = f < best[0];
            best = if nearer { [f, 2.0 * u, 2.0 * v, 2.0 * w] } else { best };
        }
        best
    }
}

/// Term by term over all points: the other way round it does not become vector instructions.
#[inline(always)]
fn sum_of_gaussians<L: Level>(points: &Points, out: &mut Values) {
    *out = [[-0.5; 64], [0.0; 64], [0.0; 64], [0.0; 64]];
    for c in &GAUSSIANS {
        for i in 0..64 {
            let (u, v, w) = (points[0][i] - c[0], points[1][i] - c[1], points[2][i] - c[2]);
            let e = exp::<L>(-4.0 * (u * u + v * v + w * w));
            let slope = -8.0 * e;
            out[0][i] += e;
            out[1][i] += slope * u;
            out[2][i] += slope * v;
            out[3][i] += slope * w;
        }
    }
}
