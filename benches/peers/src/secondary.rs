//! Rays that leave a surface: diffuse bounces from what the camera sees.
//!
//! In: scenes. Out: ns a ray of the first and of the second bounce. Directions are cosine-distributed about the normal,
//! in batches of neighbours, as a path tracer asks them.

use crate::clock::{median, timed};
use crate::ours;
use crate::random::Random;
use crate::scenes::Scene;
use crate::table::{Bench, mark};
use glam::DVec3;
use implicit::surface::{Hit, Method, Ray, Tracer};

/// Pixels across of the picture whose hits the rays leave from.
const SIZE: u32 = 256;

/// Rays asked at once.
const BATCH: usize = 4096;

/// How many times the first bounce a deeper one may take.
const DEEP_GOAL: f64 = 2.0;

/// ns a ray that the first bounce may take.
const GOALS: [(&str, f64); 7] = [
    ("sphere", 600.0),
    ("eggcrate", 600.0),
    ("tanglecube", 600.0),
    ("gyroid", 900.0),
    ("barth6", 1100.0),
    ("csg27", 700.0),
    ("metaballs", 2200.0),
];

/// The table of bounces.
pub fn table(bench: &Bench, scenes: &[&Scene]) -> String {
    let mut text = String::from(
        "| secondary rays | first bounce, ns/ray | goal | that hit | second bounce, ns/ray |\n| --- | --- | --- | --- | --- |\n",
    );
    for scene in scenes {
        let Some((_, goal)) = GOALS.iter().find(|(name, _)| *name == scene.name) else { continue };
        let surfaces = ours::surfaces(&scene.formula, scene.clip);
        let runs: Vec<[(f64, f64); 2]> = (0..bench.rounds).map(|_| bounces(scene, &surfaces)).collect();
        let cost = |k: usize| median(&runs.iter().map(|run| run[k].0).collect::<Vec<_>>());
        let first = mark(format!("{:.0}", cost(0)), cost(0) <= *goal);
        let is_met = cost(1) <= DEEP_GOAL * cost(0);
        let second = if cost(1).is_finite() { mark(format!("{:.0}", cost(1)), is_met) } else { "–".into() };
        let hit = 100.0 * runs[0][0].1;
        text += &format!("| {} | {first} | ≤ {goal:.0} | {hit:.0} % | {second} |\n", scene.name);
    }
    text
}

/// ns a ray and the share of rays that hit, for two bounces.
fn bounces(scene: &Scene, surfaces: &[implicit::surface::Surface]) -> [(f64, f64); 2] {
    let camera = scene.camera();
    let mut tracer = Tracer::new(surfaces, Method::Faithful);
    let mut random = Random::default();
    let pixels = (0..SIZE * SIZE).map(|k| (f64::from(k % SIZE) + 0.5, f64::from(k / SIZE) + 0.5));
    let mut rays: Vec<Ray> = pixels.map(|(across, down)| camera.ray(SIZE, SIZE, across, down)).collect();
    let mut hits = Vec::new();
    tracer.trace(&rays, &mut hits);
    [0, 1].map(|_| {
        rays = rays.iter().zip(&hits).filter_map(|(ray, hit)| bounce(ray, hit, &mut random)).collect();
        let mut all = Vec::with_capacity(rays.len());
        let mut batch = Vec::new();
        let ((), seconds) = timed(|| {
            for rays in rays.chunks(BATCH) {
                tracer.trace_from_surface(rays, &mut batch);
                all.extend_from_slice(&batch);
            }
        });
        hits = std::mem::take(&mut all);
        let count = rays.len() as f64;
        (seconds * 1e9 / count, hits.iter().filter(|hit| hit.is_drawn()).count() as f64 / count)
    })
}

/// A ray from the hit, about its normal; `None` where there is none.
fn bounce(ray: &Ray, hit: &Hit, random: &mut Random) -> Option<Ray> {
    if !hit.is_drawn() || hit.normal.is_nan() {
        return None;
    }
    let height = 2.0 * random.part() - 1.0;
    let (sine, cosine) = (std::f64::consts::TAU * random.part()).sin_cos();
    let ring = (1.0 - height * height).sqrt();
    let direction = hit.normal + DVec3::new(ring * cosine, ring * sine, height);
    Some(Ray::new(ray.at(hit.near()), direction.try_normalize()?))
}
