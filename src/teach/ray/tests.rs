//! The ray tells the truth where marching does not.

use super::*;
use crate::expr::formula::typed;
use crate::surface::{Clip, Kind, Method, Outcome, Ray, Shape, Surface, Tracer};

/// A story along a ray inside a ball around the origin, with the tracer's own verdict.
fn story(program: &str, origin: DVec3, direction: DVec3, reach: f64, step: f64) -> Story {
    let (mut graph, f) = typed(program);
    let length = direction.length();
    let clip = Clip::shape(Shape::Ball { center: DVec3::ZERO, radius: reach });
    let ray = Ray::new(origin, direction / length);
    let span = clip.span(&ray).map(|(a, b)| (a / length, b / length)).unwrap();
    let surfaces = [Surface::new(&mut graph, f, Kind::Equation, &clip, Simd::best())];
    let mut hits = Vec::new();
    Tracer::new(&surfaces, Method::Faithful).trace(&[ray], &mut hits);
    let hit = hits[0];
    let outcome = if hit.outcome == Outcome::Hit { "verdict.hit" } else { "verdict.miss" };
    let verdict =
        Verdict { outcome, is_proven: hit.proven, t: hit.t / length, normal: hit.normal, is_flipped: hit.flipped };
    let question = Question { origin, direction, span, step, ior: 1.5, light: DVec3::X, is_solid: false };
    Story::tell(&mut graph, f, question, verdict)
}

/// Program; start; direction; radius of the region; step; proven roots; how many are missed; how many are no roots.
type Row = (&'static str, [f64; 3], [f64; 3], f64, f64, &'static [f64], usize, usize);

#[test]
fn roots_are_proven_and_what_the_march_misses_is_told() {
    let down = [0.0, 0.0, -1.0];
    const HALF_TURN: f64 = std::f64::consts::PI - 0.1;
    let rows: [Row; 9] = [
        ("x^2+y^2+z^2-1", [0.0, 0.0, 3.0], down, 2.0, 0.3, &[2.0, 4.0], 0, 0),
        // A double root has no change of sign; the rewritten equation has one.
        ("(x^2+y^2+z^2-1)^2", [0.0, 0.0, 3.0], down, 2.0, 0.13, &[2.0, 4.0], 2, 0),
        // A shell thinner than the step: both roots are between two samples.
        ("(x^2+y^2+z^2-1)*(x^2+y^2+z^2-1.002001)", [0.0, 0.0, 3.0], down, 2.0, 0.3, &[1.999, 2.0, 4.0, 4.001], 4, 0),
        // The tangent along x at height 0.5: its roots, and its poles that change sign.
        ("z=tan(x)", [-2.5, 0.0, 0.0], [1.0, 0.0, 0.0], 3.0, 0.11, &[2.5], 0, 2),
        ("z=1/x", [-2.0, 0.0, 0.5], [1.0, 0.0, 0.0], 3.0, 0.11, &[4.0], 0, 1),
        ("z=floor(x)", [-1.0, 0.0, 0.5], [1.0, 0.0, 0.0], 3.0, 0.11, &[], 0, 1),
        // A direction of length 2: t counts its lengths.
        ("x^2+y^2+z^2-1", [0.0, 0.0, 3.0], [0.0, 0.0, -2.0], 2.0, 0.1, &[1.0, 2.0], 0, 0),
        ("x^2+y^2+z^2+1", [0.0, 0.0, 3.0], down, 2.0, 0.1, &[], 0, 0),
        ("sin(x)-z", [0.1, 0.0, 0.0], [1.0, 0.0, 0.0], 4.0, 0.2, &[HALF_TURN], 0, 0),
    ];
    for (program, origin, direction, reach, step, roots, missed, mistaken) in rows {
        let story = story(program, origin.into(), direction.into(), reach, step);
        assert!(story.proof.is_complete, "{program}: {:?}", story.proof.pieces);
        let found: Vec<f64> = story.proof.roots.iter().map(|root| root.t).collect();
        assert_eq!(found.len(), roots.len(), "{program}: {found:?}");
        for (t, expected) in found.iter().zip(roots) {
            assert!((t - expected).abs() < 2e-7, "{program}: {t} {expected}");
        }
        assert_eq!(
            (story.missed().len(), story.mistaken().len()),
            (missed, mistaken),
            "{program}: {:?}",
            story.brackets
        );
        assert_eq!(story.keeps_sign, program.starts_with("(x^2+y^2+z^2-1)^2"), "{program}");
        // The re-run and the tracer agree.
        let first = found.first().copied().unwrap_or(f64::INFINITY);
        assert!(
            first == story.verdict.t || (first - story.verdict.t).abs() < 1e-9,
            "{program}: {first} {:?}",
            story.verdict
        );
        assert!(story.verdict.is_proven, "{program}");
    }
}

#[test]
fn pieces_cover_the_ray_without_gaps() {
    let story = story("x^2+y^2+z^2-1", DVec3::new(0.1, 0.2, 3.0), -DVec3::Z, 2.0, 0.3);
    let pieces = &story.proof.pieces;
    assert_eq!((pieces[0].a, pieces[pieces.len() - 1].b), story.question.span);
    assert!(pieces.windows(2).all(|pair| pair[0].b == pair[1].a));
}

#[test]
fn newton_converges_with_order_two_and_says_when_it_leaves() {
    let story = story("x^2+y^2+z^2-1", DVec3::new(0.0, 0.0, 3.0), -DVec3::Z, 2.0, 0.7);
    let orders: Vec<f64> = story.brackets[0].iterates.iter().filter_map(|iterate| iterate.order).collect();
    assert!(orders.iter().any(|p| (p - 2.0).abs() < 0.2), "{orders:?}");
    let flat = self::story("z=atan(20x)", DVec3::new(-1.9, 0.0, 0.0), DVec3::X, 2.0, 1.2);
    assert!(flat.brackets[0].iterates.iter().any(|iterate| iterate.left));
    assert!((flat.brackets[0].end() - 1.9).abs() < 1e-12);
}

#[test]
fn a_root_at_the_start_is_named() {
    let on = story("x^2+y^2+z^2-1", DVec3::Z, -DVec3::Z, 2.0, 0.3);
    assert!(on.starts_on_surface && on.is_start(on.proof.roots[0].t), "{:?}", on.proof.roots);
    assert!((on.verdict.t - 2.0).abs() < 1e-9);
    assert!(!story("x^2+y^2+z^2-1", DVec3::new(0.0, 0.0, 1.5), -DVec3::Z, 2.0, 0.3).starts_on_surface);
}

#[test]
fn light_obeys_snell_and_fresnel() {
    let at = |angle: f64, ior: f64, is_flipped: bool| {
        let direction = DVec3::new(angle.sin(), 0.0, -angle.cos());
        light::optics(direction, DVec3::Z, is_flipped, ior, DVec3::Z)
    };
    // Straight down: (n − 1)²/(n + 1)².
    let straight = at(0.0, 1.5, false);
    assert!((straight.exact - 0.04).abs() < 1e-15 && (straight.schlick - 0.04).abs() < 1e-15);
    // Snell: sin 30° / 1.5 = 1/3.
    let (inside, angle) = at(30f64.to_radians(), 1.5, false).refracted.unwrap();
    assert!((inside.x - 1.0 / 3.0).abs() < 1e-15 && (angle - (1.0f64 / 3.0).asin().to_degrees()).abs() < 1e-12);
    // Brewster's angle: what is polarised along is not reflected, half of the rest is.
    let brewster = 1.5f64.atan();
    let across = (brewster - (brewster.sin() / 1.5).asin()).sin();
    assert!((at(brewster, 1.5, false).exact - 0.5 * across * across).abs() < 1e-14);
    // From inside beyond the critical angle of 41.8°: all is reflected.
    let total = at(45f64.to_radians(), 1.5, true);
    assert!(total.refracted.is_none() && total.exact == 1.0 && total.schlick == 1.0);
    // Light takes the same way back.
    let out = at((1.0f64 / 3.0).asin(), 1.5, true);
    assert!((out.refracted.unwrap().0.x - 0.5).abs() < 1e-15);
    assert!((out.exact - at(30f64.to_radians(), 1.5, false).exact).abs() < 1e-15);
    assert!((straight.cosine - 1.0).abs() < 1e-15 && (straight.mirror - 1.0).abs() < 1e-15);
}
