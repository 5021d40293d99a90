//! The studio's light against closed forms.

use super::blend::Window;
use super::cut;
use super::directions::{on_disc, on_sphere, pattern};
use super::gather::{Sample, Scratch, gather};
use super::glimpse::{Glimpse, Light, Remembered};
use super::lacquer::Lacquer;
use crate::film::{Layer, Size};
use crate::render::Trace;
use crate::scene::studio::Studio;
use crate::scene::{Camera, Material, Projection, Scene, Sides};
use crate::surface::{Counts, Hit, Outcome, Ray, Shape};
use glam::{DVec3, Vec3};

/// A tracer that knows one closed form.
struct Known<F: FnMut(&Ray) -> Option<f64>>(F);

impl<F: FnMut(&Ray) -> Option<f64>> Trace for Known<F> {
    fn trace(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        hits.clear();
        hits.extend(rays.iter().map(|ray| match (self.0)(ray) {
            Some(t) => hit(ray, t, -ray.direction),
            None => Hit::NONE,
        }));
    }

    fn trace_from_surface(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        self.trace(rays, hits);
    }

    fn counts(&self) -> Counts {
        Counts::default()
    }
}

fn hit(_: &Ray, t: f64, normal: DVec3) -> Hit {
    Hit { outcome: Outcome::Hit, t, normal, ..Hit::NONE }
}

fn scene() -> Scene {
    let camera = Camera::new(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, Projection::Parallel { height: 2.0 }).unwrap();
    let sides = vec![Sides::by_default(0, 1)];
    let materials = vec![Material::matte(DVec3::splat(0.8))];
    let (look_at, center, clips) = (DVec3::ZERO, DVec3::ZERO, vec![Vec::new()]);
    let bounds = vec![(DVec3::ZERO, 1.0)];
    Scene { camera, look_at, sides, clips, bounds, materials, lights: Vec::new(), sky: None, center, radius: 1.0 }
}

/// The mean light over the sixteen patterns at the origin, of a surface of this normal among what the tracer knows.
fn light_at_origin(normal: DVec3, known: impl FnMut(&Ray) -> Option<f64>) -> Light {
    let scene = scene();
    let lights = Studio::around(&scene.camera);
    let ray = Ray::new(DVec3::Z, DVec3::NEG_Z);
    let samples: Vec<Sample> = (0..16).map(|k| (k & 3, k >> 2, 0)).collect();
    let (rays, hits) = (vec![ray; 16], vec![hit(&ray, 1.0, normal); 16]);
    let (mut scratch, mut light) = (Scratch::default(), Vec::new());
    gather(&scene, &lights, &mut Known(known), (&samples, &rays, &hits), &mut scratch, &mut light);
    let sum = light.iter().fold([0.0f32; 3], |s, l| [s[0] + l.key, s[1] + l.open, s[2] + l.hidden_height]);
    let bounce = light.iter().map(|l| l.bounce).sum::<Vec3>() / 16.0;
    Light { key: sum[0] / 16.0, open: sum[1] / 16.0, hidden_height: sum[2] / 16.0, bounce }
}

#[test]
fn every_four_by_four_pixels_have_all_patterns_and_so_have_sixteen_samples_of_one() {
    for (left, top) in [(0, 0), (3, 1), (6, 7)] {
        let square = (0..16).map(|n| pattern(left + n % 4, top + n / 4, 0));
        let pixel = (0..16).map(|k| pattern(left, top, k));
        assert_eq!(square.map(|p| 1 << p).sum::<u32>(), 0xffff);
        assert_eq!(pixel.map(|p| 1 << p).sum::<u32>(), 0xffff);
    }
}

#[test]
fn directions_have_the_means_of_disc_and_sphere() {
    let disc: Vec<[f64; 2]> = (0..16).flat_map(on_disc).collect();
    let sphere: Vec<DVec3> = (0..16).flat_map(on_sphere).collect();
    let second = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>() / disc.len() as f64;
    for axis in 0..2 {
        assert!(disc.iter().map(|p| p[axis]).sum::<f64>().abs() / 64.0 < 0.01);
        assert!((second(&mut disc.iter().map(|p| p[axis])) - 0.25).abs() < 0.01);
    }
    for axis in 0..3 {
        assert!(sphere.iter().map(|p| p[axis]).sum::<f64>().abs() / 64.0 < 0.01);
        assert!((second(&mut sphere.iter().map(|p| p[axis])) - 1.0 / 3.0).abs() < 0.01);
    }
}

#[test]
fn light_on_an_open_surface_is_what_directions_add_up_to() {
    let lights = Studio::around(&scene().camera);
    for n in [DVec3::Z, DVec3::X, DVec3::NEG_Y, DVec3::new(-0.4, 0.3, -0.5).normalize(), lights.key.direction] {
        let key: f64 = (0..16).flat_map(on_disc).map(|p| lights.key.toward(p).dot(n).max(0.0)).sum::<f64>() / 64.0;
        assert!((lights.key.share(n.dot(lights.key.direction)) - key).abs() < 0.008, "{n}: {key}");
        let sky = (0..16).flat_map(on_sphere).map(|s| lights.sky.radiance((n + s).normalize())).sum::<DVec3>() / 64.0;
        assert!((lights.sky.irradiance(n) - sky).abs().max_element() < 0.002, "{n}: {sky}");
    }
}

#[test]
fn an_open_plane_has_the_shade_of_the_formula() {
    let n = DVec3::new(0.2, -0.1, 0.97).normalize();
    let light = light_at_origin(n, |_| None);
    assert_eq!(light, Light::OPEN);
    let lights = Studio::around(&scene().camera);
    let albedo = DVec3::new(0.1, 0.3, 0.6);
    let black = Lacquer { albedo: DVec3::ZERO, normal: n, view: n }.lit(&lights, &light);
    let matte = Lacquer { albedo, normal: n, view: n }.lit(&lights, &light) - black;
    let arriving = lights.key.strength * n.dot(lights.key.direction)
        + lights.sky.middle
        + lights.sky.slope * (2.0 / 3.0 * n.dot(lights.sky.top))
        + DVec3::splat(0.07);
    assert!((matte - albedo * arriving * 0.96).abs().max_element() < 1e-12, "{matte}");
}

#[test]
fn an_enclosed_point_is_dark() {
    let light = light_at_origin(DVec3::Z, |_| Some(0.01));
    assert!(light.key == 0.0 && light.open < 0.001, "{light:?}");
    let lights = Studio::around(&scene().camera);
    let lacquer = Lacquer { albedo: DVec3::splat(0.8), normal: DVec3::Z, view: DVec3::Z };
    let (open, enclosed) = (lacquer.lit(&lights, &Light::OPEN), lacquer.lit(&lights, &light));
    assert!(enclosed.max_element() < 0.08 * open.min_element(), "{enclosed} {open}");
}

/// The share of a disc of radius b that a disc of radius a covers at a distance d between their middles: two segments
/// (Weisstein, "Circle-Circle Intersection", MathWorld, eq. 14).
fn covered(a: f64, b: f64, d: f64) -> f64 {
    if d >= a + b {
        return 0.0;
    }
    if d <= (a - b).abs() {
        return (a / b).min(1.0).powi(2);
    }
    let part = |r: f64, s: f64| r * r * ((d * d + r * r - s * s) / (2.0 * d * r)).acos();
    let kite = ((-d + a + b) * (d + a - b) * (d - a + b) * (d + a + b)).sqrt() / 2.0;
    (part(a, b) + part(b, a) - kite) / (std::f64::consts::PI * b * b)
}

#[test]
fn the_soft_shadow_of_a_ball_has_the_share_of_the_lamp_that_it_covers() {
    let lights = Studio::around(&scene().camera);
    let (l, lamp) = (lights.key.direction, lights.key.sine.asin());
    let aside = l.cross(DVec3::Z).normalize();
    for (ball, offset) in [(0.5, 0.0), (0.5, 0.7), (0.8, 0.9), (1.0, 1.0), (2.0, 0.5), (2.0, 2.2), (1.0, 2.5)] {
        let (ball, offset): (f64, f64) = (ball * lamp, offset * lamp);
        let center = l * offset.cos() + aside * offset.sin();
        let light = light_at_origin(l, |ray| (ray.direction.dot(center) > ball.cos()).then_some(1.0));
        // Angles this small are as on a plane, to a part in a hundred; 64 rays see the edge to about two of them.
        let expected = 1.0 - covered(ball, lamp, offset);
        assert!((f64::from(light.key) - expected).abs() < 0.035, "{ball} {offset}: {} {expected}", light.key);
    }
}

#[test]
fn half_a_sky_behind_a_wall_is_half_open() {
    for n in [DVec3::Z, DVec3::Y] {
        let light = light_at_origin(n, |ray| (ray.direction.x > 0.0).then_some(1e-6));
        assert!((light.open - 0.5).abs() < 0.04, "{light:?}");
    }
}

/// What a plane seen from above remembers when the light differs from pattern to pattern.
fn patterned_plane(size: Size) -> Layer<Remembered> {
    let mut memory = Layer::filled(size, Remembered::NONE);
    for (i, j) in (0..size.height()).flat_map(|j| (0..size.width()).map(move |i| (i, j))) {
        let key = pattern(i, j, 0) as f32 / 15.0;
        let glimpse = Glimpse { t: 5.0, normal: Vec3::Z, side: 0 };
        memory.set(i, j, Remembered::new(glimpse, &Light { key, ..Light::OPEN }));
    }
    memory
}

#[test]
fn neighbours_on_a_plane_share_their_light_without_noise() {
    let memory = patterned_plane(Size::new(20, 20).unwrap());
    let mut window = Window::default();
    window.look(&scene().camera, &memory, [8, 8, 4, 4]);
    let glimpse = memory.at(8, 8).glimpse;
    for place in [[8.5, 8.5], [9.1, 10.9], [11.99, 8.0]] {
        let at = scene().camera.ray(20, 20, place[0], place[1]).at(5.0);
        let light = window.light(place, at, &glimpse, 0.1).unwrap();
        assert!((light.key - 0.5).abs() < 1e-4, "{place:?} {}", light.key);
    }
    let other = Glimpse { side: 1, ..glimpse };
    assert_eq!(window.light([9.5, 9.5], DVec3::ZERO, &other, 0.1), None, "another side shares nothing");
    let turned = Glimpse { normal: Vec3::X, ..glimpse };
    assert_eq!(window.light([9.5, 9.5], DVec3::ZERO, &turned, 0.1), None, "neither does what is turned away");
    assert_eq!(window.light([9.5, 9.5], DVec3::Z, &glimpse, 0.1), None, "nor what is far behind");
}

#[test]
fn the_line_at_a_cut_is_along_the_cut_alone() {
    let shape = [Shape::Box { min: DVec3::NEG_ONE, max: DVec3::ONE }];
    assert_eq!(cut::line(&shape, DVec3::new(1.0, 0.0, 0.0), DVec3::Z, 0.01), 1.0);
    assert_eq!(cut::line(&shape, DVec3::new(0.9, 0.0, 0.0), DVec3::Z, 0.01), 0.0);
    assert_eq!(cut::line(&shape, DVec3::new(1.0, 0.0, 0.0), DVec3::X, 0.01), 0.0, "a face along the clip is no edge");
    let ball = [Shape::Ball { center: DVec3::ZERO, radius: 2.0 }];
    assert!(cut::line(&ball, DVec3::new(1.99, 0.0, 0.0), DVec3::Z, 0.01) > 0.5);
    assert_eq!(cut::line(&ball, DVec3::new(1.5, 0.0, 0.0), DVec3::Z, 0.01), 0.0);
}
