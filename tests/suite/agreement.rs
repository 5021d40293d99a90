//! Squares of pixels and single rays are two ways to the same proofs: they must not contradict each other.
//!
//! In: the scenes of `tests/data/scenes.toml` and other formulas, seen from random places. Out: nothing but failures.
//! Separate from the known depths because here only the agreement is known, of many more pictures.

use super::truth_case::{Case, Way};
use glam::DVec3;
use implicit::surface::{Hit, Method, Shape};
use std::path::PathBuf;

/// Formulas that the scenes lack: jumps, poles, edges of the domain, roots without change of sign, long minima.
const FORMULAS: &[&str] = &[
    "z = tan(x)",
    "z = floor(2x) + y/3",
    "x*y = 1/z",
    "z = sqrt(1 - x^2 - y^2)",
    "z = ln(x^2 + y^2)",
    "z = x^x",
    "(x^2 + y^2 + z^2 - 1)^2 = 0",
    "(x^2 + y^2 + z^2 - 1)^2 = 1e-9",
    "abs(x) + abs(y) + abs(z) = 1",
    "max(x^2 + y^2, y^2 + z^2, z^2 + x^2) = 1",
    "min(sin(3x), cos(3y), sin(3z), x + y) = 0.2",
    "cbrt(x) + cbrt(y) + cbrt(z) = 0.5",
    "x^5 + y^5 + z^5 = x*y*z",
    "exp(x)*sin(4y) = z",
    "erf(3x) + tanh(3y) = z",
    "x^3.5 + y^2 + z^2 = 1",
    "atan2(y, x) = z",
    "cosh(x) - sinh(y)*z = 1.2",
    "z = asin(x) + acos(y)",
    "x^-2 + y^-2 + z^-2 = 9",
];

/// A linear congruential generator (Knuth, TAOCP 2, section 3.3.4).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn case(formula: &str, shape: Shape, random: &mut Random) -> Case {
    let direction = DVec3::from_array(std::array::from_fn(|_| random.unit() - 0.5)).normalize_or(DVec3::X);
    // Far, near and inside.
    let distance = shape.size() * [3.0, 1.4, 0.4][(random.unit() * 3.0) as usize];
    let aside = DVec3::from_array(std::array::from_fn(|_| (random.unit() - 0.5) * 0.3 * shape.size()));
    Case {
        name: formula.to_owned(),
        formula: formula.to_owned(),
        shape,
        eye: direction * distance,
        look_at: aside,
        fov: 40.0,
        width: 50,
        height: 38,
        depths: PathBuf::new(),
    }
}

/// How many pixels both ways prove; they must prove the same.
fn agreed(case: &Case) -> usize {
    let [rays, squares] = [Way::Rays, Way::Squares].map(|way| case.trace(Method::Faithful, way).unwrap());
    let mut count = 0;
    for (k, (a, b)) in rays.iter().zip(&squares).enumerate().filter(|(_, (a, b))| a.proven && b.proven) {
        assert!(same(a, b, case.size()), "{} from {}, pixel {k}: {a:?}\n{b:?}", case.name, case.eye);
        count += 1;
    }
    count
}

fn same(a: &Hit, b: &Hit, size: f64) -> bool {
    let near = (a.t - b.t).abs() <= 2e-9 * size.max(a.t);
    a.outcome == b.outcome && (a.t == b.t || near)
}

#[test]
fn squares_and_single_rays_prove_the_same_from_anywhere() {
    let table: toml::Table = include_str!("../data/scenes.toml").parse().unwrap();
    let mut random = Random(2026);
    let mut cases = Vec::new();
    for scene in table["scene"].as_array().unwrap() {
        let clip = &scene["clip"];
        let shape = match clip.get("ball") {
            Some(radius) => Shape::Ball { center: DVec3::ZERO, radius: radius.as_float().unwrap() },
            None => {
                let half = DVec3::splat(clip["box"].as_float().unwrap());
                Shape::Box { min: -half, max: half }
            }
        };
        let formula = scene["formula"].as_str().unwrap();
        cases.extend((0..2).map(|_| case(formula, shape, &mut random)));
    }
    let ball = Shape::Ball { center: DVec3::new(0.1, 0.0, -0.1), radius: 2.5 };
    let cube = Shape::Box { min: DVec3::new(-1.5, -1.7, -2.0), max: DVec3::new(1.9, 1.5, 1.4) };
    for formula in FORMULAS {
        cases.extend([ball, cube].map(|shape| case(formula, shape, &mut random)));
    }
    let all: usize = cases.iter().map(|case| (case.width * case.height) as usize).sum();
    let proven: usize = cases.iter().map(agreed).sum();
    assert!(proven * 100 > all * 98, "only {proven} of {all} pixels are proven in both ways");
}
