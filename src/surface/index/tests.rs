//! Rays by way of an index, and the pieces themselves, against all of the formula.

use super::*;
use crate::expr::formula::formula;
use crate::expr::graph::Graph;
use crate::surface::bundle::Asked;
use crate::surface::isolate::Open;
use crate::surface::{Clip, Kind, Method, Ray, Surface, Tracer};

/// A linear congruential generator (Knuth, TAOCP 2, section 3.3.4), from −1 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

fn objects(random: &mut Random, op: &str, object: impl Fn(&str, f64) -> String) -> String {
    let one = |random: &mut Random| {
        let [x, y, z] = [0; 3].map(|_| format!("{:.3}", 2.0 + random.next()));
        let square = format!("((x+2-{x})^2+(y+2-{y})^2+(z+2-{z})^2)");
        object(&square, 0.02 + 0.01 * random.next())
    };
    let all: Vec<String> = (0..70).map(|_| one(random)).collect();
    all.into_iter().reduce(|a, b| format!("{op}({a},{b})")).unwrap()
}

/// Seven bumpy balls, each in a layer of its own.
fn layers() -> String {
    (0..7).fold("x+2".to_owned(), |rest, k| {
        let ball = format!("(x-{k}/9)^2+y^2+z^2-0.8-{k}/20");
        let bumps: Vec<String> = (1..9).map(|n| format!("sin({n}*x+{k})*cos({n}*y)*exp(z*{n}/9)/40")).collect();
        format!("if(z+{k}/3-1+x/9<=0,{rest},{ball}+{})", bumps.join("+"))
    })
}

#[test]
fn rays_meet_the_same_with_an_index_and_without() {
    let mut random = Random(27);
    let spheres = objects(&mut random, "min", |square, r| format!("{square}-{r:.4}"));
    let holes = objects(&mut random, "max", |square, r| format!("{r:.4}-{square}"));
    let distances = objects(&mut random, "min", |square, r| format!("sqrt({square})-{r:.4}"));
    let rows = [
        spheres.clone(),
        format!("max({holes},x^2+y^2+z^2-0.8)"),
        format!("0.5*({distances}+z+sqrt(({distances}-z)^2+0.01))"),
        format!("max({spheres},x)"),
        layers(),
    ];
    for text in rows {
        let mut graph = Graph::new();
        let f = formula(&mut graph, &text);
        let clip = Clip::shape(Shape::Ball { center: DVec3::splat(0.1), radius: 1.6 });
        let mut surfaces = [Surface::new(&mut graph, f, Kind::Equation, &clip, Simd::best())];
        assert!(surfaces[0].sheets.iter().all(|sheet| sheet.index.is_some()), "{text}");
        let rays = rays(&mut random, 1500);
        let [mut with, mut without] = [Vec::new(), Vec::new()];
        Tracer::new(&surfaces, Method::Faithful).trace(&rays, &mut with);
        surfaces[0].sheets.iter_mut().for_each(|sheet| sheet.index = None);
        Tracer::new(&surfaces, Method::Faithful).trace(&rays, &mut without);
        assert!(with.iter().any(|hit| hit.is_drawn()) && with.iter().any(|hit| !hit.is_drawn()));
        for (a, b) in with.iter().zip(&without) {
            let same = a.t == b.t || (a.t - b.t).abs() <= 4e-10 * 4.0;
            assert!(a.outcome == b.outcome && a.proven == b.proven && same, "{a:?} {b:?}");
        }
    }
}

/// Rays in all directions, some along the axes and through corners of cells.
fn rays(random: &mut Random, count: usize) -> Vec<Ray> {
    let cell = 3.2 / FINEST as f64;
    let mut point = |k: usize| {
        let p = DVec3::new(random.next(), random.next(), random.next());
        if k.is_multiple_of(3) { (p / cell).round() * cell } else { p }
    };
    let ray = |k: usize| {
        let origin = DVec3::splat(0.1) + point(k) * if k.is_multiple_of(2) { 0.8 } else { 3.0 };
        let axis = [DVec3::X, DVec3::NEG_Y, DVec3::Z, DVec3::new(1.0, 1.0, 0.0), DVec3::new(-1.0, 1.0, 1.0)];
        let to = point(k) * 0.7 - origin;
        Ray::new(origin, axis.get(k % 9).copied().unwrap_or(to).normalize())
    };
    (0..count).map(ray).collect()
}

/// The value at a point where a part of the formula, or all of it, is at hand.
fn value_at(kernels: &Kernels, program: Option<&Program>, point: DVec3) -> f64 {
    let formula = program.map_or(kernels.whole(), |program| kernels.only(program));
    let mut registers = formula.point().registers();
    for axis in 0..3 {
        registers[axis].0 = [point[axis]; crate::surface::sheet::POINTS];
    }
    formula.point().run(&mut registers);
    formula.point().output(&registers, 0).0[0]
}

#[test]
fn pieces_have_the_sign_of_the_whole_and_what_is_between_them_has_no_root() {
    let mut random = Random(5);
    let spheres = objects(&mut random, "min", |square, r| format!("{square}-{r:.4}"));
    let rounded = format!("0.5*({spheres}+z+sqrt(({spheres}-z)^2+0.01))");
    for (text, most) in [(spheres, 3), (rounded, 1000), (layers(), 2)] {
        let mut graph = Graph::new();
        let f = formula(&mut graph, &text);
        let clip = Clip::shape(Shape::Ball { center: DVec3::splat(0.1), radius: 1.6 });
        let surface = Surface::new(&mut graph, f, Kind::Equation, &clip, Simd::best());
        let sheet = &surface.sheets[0];
        let (kernels, index) = (&sheet.kernels, sheet.index.as_ref().unwrap());
        let mut memory = crate::surface::memory::Memory::new(sheet);
        let mut scratch = Scratch { leaves: &mut memory.leaves, value: &mut memory.registers.forms.value };
        let rays = rays(&mut random, 600);
        let open = |(k, ray): (usize, &Ray)| {
            let (a, end) = surface.span(ray)?;
            (a < end).then_some(Open { ray: k as u32, a, end, step: end - a, slabs: 0 })
        };
        let all: Vec<Open> = rays.iter().enumerate().filter_map(open).collect();
        let (mut waiting, mut pieces, mut rest) = (all.clone(), Vec::new(), Vec::new());
        while !waiting.is_empty() {
            index.pieces(kernels, Asked::List(&rays), &mut waiting, most, &mut scratch, (&mut pieces, &mut rest));
            waiting.append(&mut rest);
        }
        assert!(all.len() > 200, "{}", all.len());
        assert!(pieces.iter().all(|piece| piece.program.is_some()));
        let mut empty = 0;
        for open in &all {
            let ray = &rays[open.ray as usize];
            let mut signs_between: Vec<(usize, f64)> = Vec::new();
            for k in 0..=400 {
                let t = open.a + (open.end - open.a) * f64::from(k) / 400.0;
                let of_ray = |piece: &&Piece| piece.open.ray == open.ray;
                let here: Vec<&Piece> =
                    pieces.iter().filter(of_ray).filter(|p| p.open.a <= t && t <= p.open.end).collect();
                let whole = value_at(kernels, None, ray.at(t));
                for piece in &here {
                    let program = index.program(piece.program.unwrap());
                    assert_eq!(value_at(kernels, Some(&program), ray.at(t)) > 0.0, whole > 0.0, "{text} {ray:?} {t}");
                }
                if here.is_empty() {
                    let gap = pieces.iter().filter(of_ray).filter(|piece| piece.open.end < t).count();
                    signs_between.push((gap, whole.signum()));
                    empty += 1;
                }
            }
            let differ = |pair: &[(usize, f64)]| pair[0].0 == pair[1].0 && pair[0].1 != pair[1].1;
            assert!(!signs_between.windows(2).any(differ), "{text} {ray:?}");
        }
        assert!(empty > 10_000);
    }
}
