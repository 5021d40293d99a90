//! Rays that leave a surface in all directions, one thread, in processor time: what shadows, mirrors and paths ask.
//!
//! `cargo bench --bench bounces` takes the scenes of `tests/data/scenes.toml` and some unions of spheres; `cargo bench --bench bounces --
//! sphere barth6` some of them. From the hits of 256 x 256 pixels rays go about the normal, evenly by cosine, 4096 at once. A row: ns a
//! ray of the first and of the second bounce (the least of five runs), their enclosures a ray, the share of rays that hit, the share of all that is proven;
//! and the same for the rays of the camera, each traced by itself.
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, clippy::disallowed_methods)]

use glam::DVec3;
use implicit::diag::Sources;
use implicit::expr::lower::{self, lower};
use implicit::num::level::Simd;
use implicit::scene::camera::{Camera, Projection};
use implicit::surface::{Clip, Hit, Kind, Method, Ray, Shape, Surface, Tracer};
use rustix::time::{ClockId, clock_gettime};

/// Pixels across of the picture whose hits the rays leave from.
const SIZE: u32 = 256;

/// Rays asked at once: as many as paths are followed at once in a picture.
const BATCH: usize = 4096;

/// Runs of each scene; the least counts.
const RUNS: usize = 5;

/// Unions of so many spheres.
const UNIONS: [usize; 4] = [10, 30, 100, 1000];

struct Scene {
    name: String,
    formula: String,
    shape: Shape,
    eye: DVec3,
}

/// What one generation of rays took.
#[derive(Clone, Copy, Default)]
struct Bounce {
    nanoseconds: f64,
    cells: f64,
    hits: f64,
    proven: f64,
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    println!(
        "{:14} {:>8} {:>7} {:>6} | {:>8} {:>7} {:>6} | {:>8} {:>7} {:>6} {:>9}",
        "", "camera", "cells", "hit %", "first", "cells", "hit %", "second", "cells", "hit %", "proven %"
    );
    for scene in scenes().iter().filter(|scene| words.is_empty() || words.contains(&scene.name)) {
        measure(scene);
    }
}

fn scenes() -> Vec<Scene> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/scenes.toml");
    let table: toml::Table = std::fs::read_to_string(path).unwrap().parse().unwrap();
    let known = table["scene"].as_array().unwrap().iter().map(|scene| {
        let eye = scene["eye"].as_array().unwrap().iter().map(|c| c.as_float().unwrap()).collect::<Vec<_>>();
        let shape = match scene["clip"].get("ball") {
            Some(radius) => Shape::Ball { center: DVec3::ZERO, radius: radius.as_float().unwrap() },
            None => {
                let half = DVec3::splat(scene["clip"]["box"].as_float().unwrap());
                Shape::Box { min: -half, max: half }
            }
        };
        let text = |key: &str| scene[key].as_str().unwrap().to_owned();
        Scene { name: text("name"), formula: text("formula"), shape, eye: DVec3::from_slice(&eye) }
    });
    known.chain(UNIONS.into_iter().map(union)).collect()
}

/// Spheres with r² = 1/n, so that as many cover as much.
fn union(count: usize) -> Scene {
    let mut random = Random(0);
    let mut next = || ((2.0 * random.part() - 1.0) * 1e4).round() / 1e4;
    let radius2 = 1.0 / count as f64;
    let sphere = |x: f64, y: f64, z: f64| format!("(x - ({x}))^2 + (y - ({y}))^2 + (z - ({z}))^2 - {radius2}");
    let all: Vec<String> = (0..count).map(|_| sphere(next(), next(), next())).collect();
    Scene {
        name: format!("{count}spheres"),
        formula: format!("min({})", all.join(", ")),
        shape: Shape::Ball { center: DVec3::ZERO, radius: 2.5 },
        eye: DVec3::new(2.785521, -4.244603, 2.254945),
    }
}

fn measure(scene: &Scene) {
    let mut sources = Sources::new();
    sources.add("scene", &scene.formula);
    let mut lowered = lower(&implicit::syntax::parse(&sources.texts()).program, &lower::Settings::default());
    let (f, clip) = (lowered.surfaces[0].f, Clip::shape(scene.shape));
    let surfaces = [Surface::new(&mut lowered.graph, f, Kind::Equation, &clip, Simd::best())];
    let camera = Camera::new(scene.eye, DVec3::ZERO, Projection::Perspective { fov: 40.0 }).unwrap();
    let mut best = [Bounce { nanoseconds: f64::INFINITY, ..Bounce::default() }; 3];
    for _ in 0..RUNS {
        for (best, run) in best.iter_mut().zip(run(&camera, &surfaces)) {
            *best = Bounce { nanoseconds: best.nanoseconds.min(run.nanoseconds), ..run };
        }
    }
    let cells = best.map(|b| format!("{:>8.0} {:>7.1} {:>6.1}", b.nanoseconds, b.cells, 100.0 * b.hits));
    let proven = best.iter().map(|b| b.proven).fold(1.0, f64::min);
    println!("{:14} {} {:>9.3}", scene.name, cells.join(" | "), 100.0 * proven);
}

/// The camera's rays, and two bounces.
fn run(camera: &Camera, surfaces: &[Surface]) -> [Bounce; 3] {
    let mut tracer = Tracer::new(surfaces, Method::Faithful);
    let mut random = Random(0);
    let pixels = (0..SIZE * SIZE).map(|k| (f64::from(k % SIZE) + 0.5, f64::from(k / SIZE) + 0.5));
    let mut rays: Vec<Ray> = pixels.map(|(across, down)| camera.ray(SIZE, SIZE, across, down)).collect();
    let mut hits: Vec<Hit> = Vec::new();
    [0, 1, 2].map(|generation| {
        if generation > 0 {
            rays = rays.iter().zip(&hits).filter_map(|(ray, hit)| bounce(ray, hit, &mut random)).collect();
        }
        hits.clear();
        let mut batch = Vec::new();
        let (cells, start) = (tracer.counts.cells, processor_seconds());
        for rays in rays.chunks(BATCH) {
            if generation == 0 {
                tracer.trace(rays, &mut batch);
            } else {
                tracer.trace_from_surface(rays, &mut batch);
            }
            hits.extend_from_slice(&batch);
        }
        let (seconds, count) = (processor_seconds() - start, rays.len() as f64);
        let share = |is: fn(&Hit) -> bool| hits.iter().filter(|hit| is(hit)).count() as f64 / count;
        Bounce {
            nanoseconds: seconds * 1e9 / count,
            cells: (tracer.counts.cells - cells) as f64 / count,
            hits: share(Hit::is_drawn),
            proven: share(|hit| hit.proven),
        }
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

/// SplitMix64: Steele, Lea, Flood, Fast splittable pseudorandom number generators, OOPSLA 2014; from 0 to 1.
struct Random(u64);

impl Random {
    fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (mixed ^ (mixed >> 31)) as f64 / 2f64.powi(64)
    }
}

fn processor_seconds() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}
