//! Squares of pixels, single rays by forms and single rays by intervals are three ways to the same proofs: they must not
//! contradict each other.
//!
//! In: the scenes of `tests/data/scenes.toml` and other formulas, seen from random places. Out: nothing but failures.
//! Separate from the known depths because here only the agreement is known, of many more pictures.

use super::truth_case::{Case, Way};
use glam::DVec3;
use implicit::scene::camera::{Camera, Projection};
use implicit::surface::{Hit, Method, Ray, Shape, Side, Tracer};
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

/// How many pixels all ways prove; they must prove the same.
fn agreed(case: &Case) -> usize {
    let ways = [(Method::Intervals, Way::Rays), (Method::Faithful, Way::Rays), (Method::Faithful, Way::Squares)];
    let [intervals, forms, squares] = ways.map(|(method, way)| case.trace(method, way).unwrap());
    for (k, (a, b)) in forms.iter().zip(&squares).enumerate() {
        assert!(agree(a, b, case.size()), "{} from {}, pixel {k}: {a:?}\n{b:?}", case.name, case.eye);
    }
    for (k, (a, b)) in intervals.iter().zip(&forms).enumerate() {
        assert!(agree(a, b, case.size()), "{} from {}, pixel {k}: {a:?}\n{b:?}", case.name, case.eye);
    }
    let proven = |k: &usize| [&intervals, &forms, &squares].iter().all(|hits| hits[*k].proven);
    (0..forms.len()).filter(proven).count()
}

/// Whether two answers can both be true.
fn agree(a: &Hit, b: &Hit, size: f64) -> bool {
    !(a.proven && b.proven) || same(a, b, size)
}

fn same(a: &Hit, b: &Hit, size: f64) -> bool {
    let near = (a.t - b.t).abs() <= 2e-9 * size.max(a.t);
    a.outcome == b.outcome && (a.t == b.t || near)
}

/// Sums of forty terms around random places, most of which do not change in most of space: Gaussians, waves, and others among
/// them that have kinks, jumps, poles and edges.
fn long_sums(random: &mut Random) -> Vec<String> {
    let forms: [&[&str]; 4] = [
        &["exp(-9*((x - A)^2 + (y - B)^2 + (z - C)^2))"],
        &[
            "exp(-9*((x - A)^2 + (y - B)^2 + (z - C)^2))",
            "0.05*abs(x - B)",
            "0.1*tanh(20*(y - A))",
            "-0.02*floor(2*(z - C))",
        ],
        &["0.1*sin(A*9*x + B)*cos(C*7*z)", "0.01*(y - B)^3"],
        &["0.5*exp(-9*((x - A)^2 + (y - B)^2))", "0.001/(z - C)", "0.01*sqrt(x + 2 + A/2)", "-0.05"],
    ];
    let mut sum = |terms: &[&str]| {
        let terms: Vec<String> = (0..40)
            .map(|k| {
                let mut place = || format!("({:.3})", 2.4 * random.unit() - 1.2);
                terms[k % terms.len()].replace('A', &place()).replace('B', &place()).replace('C', &place())
            })
            .collect();
        format!("{} = 0.6", terms.join(" + "))
    };
    forms.iter().map(|terms| sum(terms)).collect()
}

/// Unions of objects at random places, few and many, smooth and cut; the reference takes all of them everywhere.
fn unions(random: &mut Random) -> Vec<String> {
    let ball = "sqrt((x - A)^2 + (y - B)^2 + (z - C)^2) - 0.2";
    let cube = "max(abs(x - A), abs(y - B), abs(z - C)) - 0.2";
    let ring = "(sqrt((x - A)^2 + (y - B)^2) - 0.3)^2 + (z - C)^2 - 0.01";
    let wall = "abs(x - A) + 0.001/(y - B)^2 - 0.05";
    let small = "(x - A)^2 + (y - B)^2 + (z - C)^2 - 0.01";
    let mut union = |objects: &[&str], count: usize| {
        let one = |k: usize| {
            let mut place = || format!("({:.3})", 2.4 * random.unit() - 1.2);
            objects[k % objects.len()].replace('A', &place()).replace('B', &place()).replace('C', &place())
        };
        format!("min({})", (0..count).map(one).collect::<Vec<_>>().join(", "))
    };
    let (mixed, many, balls) = (union(&[ball, cube, ring], 12), union(&[small], 150), union(&[ball], 30));
    vec![
        format!("{mixed} = 0"),
        format!("{} = 0", union(&[ball, wall, ring], 9)),
        format!("{many} = 0"),
        format!("max({many}, z) = 0"),
        format!("0.5*({balls} + z + sqrt(({balls} - z)^2 + 0.01)) = 0"),
        format!("sin(2*{balls}) = 0.1"),
        format!("{} = 0", layers(random, 9)),
    ]
}

/// Bumpy balls of which each is seen in a layer of its own.
fn layers(random: &mut Random, count: usize) -> String {
    (0..count).fold("x + 2".to_owned(), |rest, k| {
        let mut wave = || {
            format!(
                "sin({:.2}*x + {:.2}*y)*cos({:.2}*z)/20",
                5.0 * random.unit(),
                5.0 * random.unit(),
                5.0 * random.unit()
            )
        };
        let bumps = (0..5).map(|_| wave()).collect::<Vec<_>>().join(" + ");
        let edge = 1.2 - 0.3 * k as f64;
        format!("if(z + 0.1*x < {edge:.2}, {rest}, x^2 + y^2 + z^2 - 1.{k} + {bumps})")
    })
}

fn shape(scene: &toml::Value) -> Shape {
    let clip = &scene["clip"];
    match clip.get("ball") {
        Some(radius) => Shape::Ball { center: DVec3::ZERO, radius: radius.as_float().unwrap() },
        None => {
            let half = DVec3::splat(clip["box"].as_float().unwrap());
            Shape::Box { min: -half, max: half }
        }
    }
}

/// All scenes and formulas, seen from random places.
fn all_cases(random: &mut Random) -> Vec<Case> {
    let table: toml::Table = include_str!("../data/scenes.toml").parse().unwrap();
    let mut cases = Vec::new();
    for scene in table["scene"].as_array().unwrap() {
        let shape = shape(scene);
        let formula = scene["formula"].as_str().unwrap();
        cases.extend((0..2).map(|_| case(formula, shape, random)));
    }
    let ball = Shape::Ball { center: DVec3::new(0.1, 0.0, -0.1), radius: 2.5 };
    let cube = Shape::Box { min: DVec3::new(-1.5, -1.7, -2.0), max: DVec3::new(1.9, 1.5, 1.4) };
    let sums = long_sums(random);
    let unions = unions(random);
    for formula in FORMULAS.iter().copied().chain(sums.iter().chain(&unions).map(String::as_str)) {
        cases.extend([ball, cube].map(|shape| case(formula, shape, random)));
    }
    cases
}

#[test]
fn squares_and_single_rays_prove_the_same_from_anywhere() {
    let cases = all_cases(&mut Random(2026));
    let all: usize = cases.iter().map(|case| (case.width * case.height) as usize).sum();
    let proven: usize = cases.iter().map(agreed).sum();
    assert!(proven * 100 > all * 98, "only {proven} of {all} pixels are proven in all ways");
}

#[test]
fn rays_that_leave_surfaces_prove_the_same_by_forms_and_by_intervals() {
    let mut random = Random(27);
    let (mut all, mut proven) = (0, 0);
    for case in all_cases(&mut random) {
        let surfaces = case.surfaces().unwrap();
        let [mut forms, mut intervals] =
            [Method::Faithful, Method::Intervals].map(|method| Tracer::new(&surfaces, method));
        let camera = Camera::new(case.eye, case.look_at, Projection::Perspective { fov: case.fov }).unwrap();
        let pixels = (0..case.width * case.height).map(|k| (f64::from(k % case.width), f64::from(k / case.width)));
        let rays: Vec<Ray> = pixels.map(|(i, j)| camera.ray(case.width, case.height, i + 0.5, j + 0.5)).collect();
        let mut hits = Vec::new();
        forms.trace(&rays, &mut hits);
        let drawn = rays.iter().zip(&hits).filter(|(_, hit)| hit.is_drawn());
        let departures: Vec<(Ray, Hit, Side)> =
            drawn.enumerate().map(|(k, (ray, hit))| (*ray, *hit, [Side::Near, Side::Far][k % 2])).collect();
        let mut points = Vec::new();
        forms.starts(&departures, &mut points);
        let mut direction = || DVec3::from_array(std::array::from_fn(|_| random.unit() - 0.5)).normalize_or(DVec3::X);
        let rays: Vec<Ray> = points.iter().map(|point| Ray::new(*point, direction())).collect();
        let [mut by_forms, mut by_intervals] = [Vec::new(), Vec::new()];
        forms.trace_from_surface(&rays, &mut by_forms);
        intervals.trace_from_surface(&rays, &mut by_intervals);
        for ((a, b), ray) in by_forms.iter().zip(&by_intervals).zip(&rays) {
            assert!(agree(a, b, case.size()), "{} along {ray:?}: {a:?}\n{b:?}", case.name);
            all += 1;
            proven += usize::from(a.proven && b.proven);
        }
    }
    assert!(proven * 100 > all * 97 && all > 20_000, "only {proven} of {all} rays are proven in both ways");
}

/// As they are looked at in the set: surfaces whose sheets cross the rays, and some that only touch or end.
#[test]
fn every_pixel_of_the_scenes_is_proven() {
    let table: toml::Table = include_str!("../data/scenes.toml").parse().unwrap();
    for scene in table["scene"].as_array().unwrap() {
        let eye: Vec<f64> = scene["eye"].as_array().unwrap().iter().map(|c| c.as_float().unwrap()).collect();
        let (formula, shape) = (scene["formula"].as_str().unwrap().to_owned(), shape(scene));
        let eye = DVec3::from_slice(&eye);
        let case =
            Case { eye, look_at: DVec3::ZERO, width: 160, height: 120, ..self::case(&formula, shape, &mut Random(1)) };
        let hits = case.trace(Method::Faithful, Way::Squares).unwrap();
        let count = hits.iter().filter(|hit| !hit.proven).count();
        assert_eq!(count, 0, "{}: {count} pixels are not proven", scene["name"]);
    }
}
