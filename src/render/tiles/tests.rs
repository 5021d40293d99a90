//! Drawing proved on a sphere whose hits are known in closed form.

use super::*;
use crate::film::Size;
use crate::render::{Mode, Silent};
use crate::scene::{Camera, Material, Projection, Sides};
use crate::surface::Ray;
use glam::DVec3;

/// The unit sphere around the origin.
#[derive(Default)]
struct UnitSphere(Counts);

impl Trace for UnitSphere {
    fn trace(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        self.0.rays += rays.len() as u64;
        hits.clear();
        hits.extend(rays.iter().map(first_hit));
    }

    fn trace_from_surface(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        self.trace(rays, hits);
    }

    fn counts(&self) -> Counts {
        self.0
    }
}

fn first_hit(ray: &Ray) -> Hit {
    let middle = -ray.origin.dot(ray.direction);
    let half_squared = 1.0 - (ray.origin + ray.direction * middle).length_squared();
    let t = middle - half_squared.max(0.0).sqrt();
    if half_squared < 0.0 || t <= 0.0 {
        return Hit { proven: true, ..Hit::NONE };
    }
    Hit { outcome: Outcome::Hit, proven: true, t, width: 1e-12, normal: ray.at(t), ..Hit::NONE }
}

fn scene() -> Scene {
    let camera = Camera::new(DVec3::new(0.0, -3.0, 0.0), DVec3::ZERO, Projection::Perspective { fov: 50.0 }).unwrap();
    Scene {
        camera,
        look_at: DVec3::ZERO,
        sides: vec![Sides::by_default(0, 1)],
        clips: vec![Vec::new()],
        bounds: vec![(DVec3::ZERO, 1.0)],
        materials: vec![Material::matte(DVec3::splat(0.8))],
        lights: Vec::new(),
        sky: None,
        center: DVec3::ZERO,
        radius: 1.0,
    }
}

fn settings(mode: Mode, samples: u32) -> Settings {
    let size = Size::new(75, 50).unwrap();
    Settings { size, mode, samples, keep_depth: true, keep_normals: true, ..Settings::default() }
}

fn drawn(settings: &Settings) -> Drawing {
    draw(&scene(), settings, &UnitSphere::default, &Silent).unwrap()
}

#[test]
fn every_pixel_is_drawn_and_counted_once() {
    let drawing = drawn(&settings(Mode::Normal, 1));
    let report = drawing.report;
    assert_eq!(report.hits + report.misses, 75 * 50);
    assert_eq!(report.proven, 75 * 50);
    assert_eq!(report.counts.rays, 75 * 50);
    let (depth, normals) = (drawing.depth.unwrap(), drawing.normals.unwrap());
    for j in 0..50 {
        for i in 0..75 {
            let ray = scene().camera.ray(75, 50, f64::from(i) + 0.5, f64::from(j) + 0.5);
            let hit = first_hit(&ray);
            assert_eq!(depth.at(i, j), hit.t as f32);
            assert_eq!(normals.at(i, j)[0].is_nan(), !hit.is_drawn());
            assert_eq!(drawing.picture.at(i, j) == [0.0; 3], !hit.is_drawn());
        }
    }
}

#[test]
fn any_number_of_threads_draws_the_same_picture() {
    for (_, mode) in Mode::ALL {
        let one = drawn(&settings(mode, 16));
        for threads in [2, 3, 7] {
            let many = drawn(&Settings { threads, ..settings(mode, 16) });
            assert_eq!(one.picture, many.picture, "{mode:?}");
            assert_eq!(one.depth, many.depth);
            assert_eq!(one.report.counts, many.report.counts);
        }
    }
}

#[test]
fn only_edges_take_more_samples_and_depth_stays_that_of_the_centre() {
    let (one, many) = (drawn(&settings(Mode::Proof, 1)), drawn(&settings(Mode::Proof, 16)));
    assert_eq!(one.depth, many.depth);
    assert_eq!((one.report.hits, one.report.proven), (many.report.hits, many.report.proven));
    assert!(many.report.counts.rays > 75 * 50 && many.report.counts.rays < 5 * 75 * 50);
    let changed = one.picture.values.iter().zip(&many.picture.values).filter(|(a, b)| a != b).count();
    assert!((50..400).contains(&changed), "{changed}");
}

#[test]
fn smoothed_edges_cover_what_the_disc_covers() {
    // In mode proof a miss is one colour; the sphere's outline is a circle, so its area is known.
    let size = Size::new(64, 64).unwrap();
    let camera = Camera::new(DVec3::new(0.0, -3.0, 0.0), DVec3::ZERO, Projection::Parallel { height: 3.0 }).unwrap();
    let scene = Scene { camera, ..scene() };
    let area = |samples| {
        let settings = Settings { size, ..settings(Mode::Depth, samples) };
        let drawing = draw(&scene, &settings, &UnitSphere::default, &Silent).unwrap();
        drawing.picture.values.iter().filter(|p| p[0] > 0.0).count()
    };
    let exact = std::f64::consts::PI * (64.0f64 / 3.0).powi(2);
    assert!((area(1) as f64 - exact).abs() < 0.02 * exact);
    assert!(area(16) > area(1), "pixels that are covered in part are not empty");
}

#[test]
fn studio_lights_the_side_of_the_key_and_never_goes_black() {
    let picture = drawn(&settings(Mode::Studio, 1)).picture;
    let light = |i: u32, j: u32| picture.at(i, j).iter().sum::<f32>();
    assert!(light(30, 18) > light(44, 34));
    assert!(picture.values.iter().flatten().all(|&l| l.is_finite() && l > 0.0));
}

#[test]
fn a_cancelled_drawing_is_none() {
    struct Cancelled;
    impl Watch for Cancelled {
        fn is_cancelled(&self) -> bool {
            true
        }
    }
    let result = draw(&scene(), &settings(Mode::Studio, 1), &UnitSphere::default, &Cancelled);
    assert_eq!(result.err(), Some(Failure::Cancelled));
}

/// Looks on and remembers; stops when a number of tiles is done.
struct Onlooker {
    stop_after: usize,
    done: AtomicUsize,
    seen: Mutex<Vec<(Pass, Layer<[f32; 3]>)>>,
}

impl Onlooker {
    fn new(stop_after: usize) -> Self {
        Onlooker { stop_after, done: AtomicUsize::new(0), seen: Mutex::new(Vec::new()) }
    }
}

impl Watch for Onlooker {
    fn advanced(&self, done: usize, total: usize) {
        assert!(done <= total);
        self.done.fetch_add(1, Ordering::Relaxed);
    }

    fn passed(&self, drawing: &Drawing) {
        self.seen.lock().unwrap().push((drawing.pass, drawing.picture.clone()));
    }

    fn is_cancelled(&self) -> bool {
        self.done.load(Ordering::Relaxed) >= self.stop_after
    }
}

fn drawn_before(settings: &Settings, onlooker: &Onlooker) -> Result<Drawing, Failure> {
    draw(&scene(), settings, &UnitSphere::default, onlooker)
}

#[test]
fn passes_end_in_the_picture_that_is_drawn_without_them() {
    for samples in [1, 3, 5, 16, 17, 100] {
        let plain = drawn(&settings(Mode::Studio, samples));
        for passes in [Passes::Many, Passes::CoarseFirst] {
            let onlooker = Onlooker::new(usize::MAX);
            let settings = Settings { passes, threads: 2, ..settings(Mode::Studio, samples) };
            let drawing = drawn_before(&settings, &onlooker).unwrap();
            assert!(drawing.picture == plain.picture, "{samples} {passes:?}");
            assert_eq!((drawing.pass, drawing.report.hits), (Pass::Last, plain.report.hits));
            assert_eq!(onlooker.done.into_inner(), pieces(&settings));
            let mut expected = Vec::new();
            expected.extend(coarse(&settings).iter().map(|&side| Pass::Squares(side)));
            expected.extend([1, 5, 16, 64].into_iter().filter(|&n| n < samples).map(Pass::Samples));
            let seen = onlooker.seen.into_inner().unwrap();
            assert_eq!(seen.iter().map(|(pass, _)| *pass).collect::<Vec<_>>(), expected);
        }
    }
}

#[test]
fn a_stopped_drawing_is_its_last_whole_pass() {
    let settings = Settings { passes: Passes::CoarseFirst, ..settings(Mode::Studio, 64) };
    let all = Onlooker::new(usize::MAX);
    drawn_before(&settings, &all).unwrap();
    let passes = all.seen.into_inner().unwrap();
    let mut last = None;
    for stop_after in 1..pieces(&settings) {
        match drawn_before(&settings, &Onlooker::new(stop_after)) {
            Err(Failure::Cancelled) => assert!(last.is_none()),
            Ok(drawing) => {
                let (_, expected) = passes.iter().find(|(pass, _)| *pass == drawing.pass).unwrap();
                assert!(drawing.picture == *expected, "{stop_after}: {:?}", drawing.pass);
                last = Some(drawing.pass);
            }
        }
    }
    assert_eq!(last, Some(Pass::Samples(16)));
}

#[test]
fn squares_have_the_colour_of_their_middle() {
    let onlooker = Onlooker::new(usize::MAX);
    let settings = Settings { passes: Passes::CoarseFirst, ..settings(Mode::Normal, 1) };
    let plain = drawn_before(&settings, &onlooker).unwrap().picture;
    let seen = onlooker.seen.into_inner().unwrap();
    let coarse = &seen[1].1;
    for (i, j) in [(0, 0), (33, 21), (74, 49), (40, 25)] {
        let middle = |at: u32, end: u32| at / 4 * 4 + (end - at / 4 * 4).min(4) / 2;
        assert_eq!(coarse.at(i, j), plain.at(middle(i, 75), middle(j, 50)));
    }
}
