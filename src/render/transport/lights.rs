//! Where light comes from, and how it is sought.
//!
//! In: a scene. Out: its emitters; from a point towards one of them ([`Lights::toward`]) with the density of doing so; what a ray sees
//! of them; rays that leave them ([`Lights::emit`]). Surfaces that glow are sought in the cone of a ball around them: what such a ray
//! meets is what it sees, so that any shape can be sought.

use super::balls::{self, Ball, Balls};
use super::sky::SkyTable;
use super::warp::{Frame, ON_SPHERE, by_cosine, cone_density, in_cone, on_disc, on_sphere};
use crate::num::func::native;
use crate::scene::{Light, Scene};
use crate::surface::Ray;
use glam::DVec3;
use std::f64::consts::PI;

/// What light comes from.
#[derive(Clone, Debug)]
pub enum Emitter {
    /// A point, by its intensity.
    Point {
        /// Where.
        at: DVec3,
        /// In W/sr.
        intensity: DVec3,
    },
    /// A ball of even radiance.
    Ball {
        /// Its middle.
        center: DVec3,
        /// Its radius.
        radius: f64,
        /// In W/(m² sr).
        radiance: DVec3,
    },
    /// Parallel rays.
    Parallel {
        /// Towards the light.
        toward: DVec3,
        /// On what faces it.
        irradiance: DVec3,
    },
    /// A far disc.
    Disc {
        /// Around the direction to its middle.
        frame: Frame,
        /// 1 − the cosine of half the angle it is seen under.
        cap: f64,
        /// In W/(m² sr).
        radiance: DVec3,
    },
    /// All around.
    Sky(SkyTable),
    /// A surface that glows, inside this ball.
    Glow {
        /// Which surface.
        surface: u32,
        /// The ball's middle.
        center: DVec3,
        /// The ball's radius.
        radius: f64,
    },
}

/// A way from a point towards an emitter.
#[derive(Clone, Copy, Debug)]
pub struct Toward {
    /// Which emitter.
    pub emitter: usize,
    /// Where to.
    pub direction: DVec3,
    /// How far a point is; +∞ for what is far, and for balls and surfaces, which the ray has to find.
    pub distance: f64,
    /// The radiance, or for points and parallel rays the irradiance on what faces them; 0 for surfaces: what the ray finds.
    pub radiance: DVec3,
    /// The density per solid angle, the choice of the emitter included; the choice alone for points and parallel rays.
    pub pdf: f64,
    /// Whether no other way finds this light.
    pub is_delta: bool,
    /// The density of [`Lights::emit`] for the same ray, the choice included; per area, and per solid angle where it is no delta; to be
    /// multiplied by the length of the ray in the ball for surfaces.
    pub emission_pdf: f64,
    /// The cosine at the emitter; 1 for points and what is far.
    pub cosine: f64,
}

/// A ray that leaves an emitter.
#[derive(Clone, Copy, Debug)]
pub struct Emitted {
    /// Which emitter.
    pub emitter: usize,
    /// The ray. For surfaces a ray whose far end has to be found on the surface first, and whose light goes back along it.
    pub ray: Ray,
    /// Radiance times cosine over the density: the power that the ray stands for. For surfaces: over the density times the radiance
    /// and the length of the ray in the ball.
    pub power: DVec3,
    /// The density, as in [`Toward::emission_pdf`].
    pub emission_pdf: f64,
    /// The cosine at the emitter.
    pub cosine: f64,
}

/// All emitters of a scene.
#[derive(Clone, Debug)]
pub struct Lights {
    /// The emitters: the scene's lights in their order, then surfaces, then the sky.
    pub list: Vec<Emitter>,
    /// The sum of the choices up to each.
    sums: Vec<f64>,
    balls: Balls,
    /// What is seen where there is nothing: the sky and far discs.
    far: Vec<usize>,
    /// By surface, its emitter.
    of_surface: Vec<Option<usize>>,
    /// The ball that all of the scene is in: far light comes in through it.
    center: DVec3,
    radius: f64,
}

/// The share of choices that all emitters have alike, however weak: a weak one may be near.
const ALIKE: f64 = 0.5;

impl Lights {
    /// The emitters of a scene.
    pub fn new(scene: &Scene) -> Self {
        let (center, radius) = surroundings(scene);
        let mut list: Vec<Emitter> = scene.lights.iter().map(emitter).collect();
        let mut of_surface = vec![None; scene.materials.len()];
        let is_glowing = |surface: &usize| scene.materials[*surface].is_glowing();
        for surface in (0..scene.materials.len()).filter(is_glowing) {
            of_surface[surface] = Some(list.len());
            let (center, radius) = scene.bounds[surface];
            list.push(Emitter::Glow { surface: surface as u32, center, radius });
        }
        list.extend(scene.sky.as_ref().map(|sky| Emitter::Sky(SkyTable::new(sky))));
        let powers: Vec<f64> = list.iter().map(|emitter| power(emitter, scene, radius)).collect();
        let (total, count) = (powers.iter().sum::<f64>(), list.len() as f64);
        let mut sum = 0.0;
        let choice = |power: f64| match total > 0.0 && total.is_finite() {
            true => ALIKE / count + (1.0 - ALIKE) * power / total,
            false => 1.0 / count,
        };
        let mut sums: Vec<f64> = Vec::with_capacity(list.len());
        for power in powers {
            sum += choice(power);
            sums.push(sum);
        }
        if let Some(last) = sums.last_mut() {
            *last = 1.0;
        }
        let of_kind = |kind: fn(&Emitter) -> bool| (0..list.len()).filter(|&k| kind(&list[k])).collect();
        let balls = list.iter().enumerate().filter_map(|(emitter, kind)| match *kind {
            Emitter::Ball { center, radius, .. } => Some(Ball { emitter, center, radius }),
            _ => None,
        });
        let balls = Balls::new(balls.collect());
        let far = of_kind(|emitter| matches!(emitter, Emitter::Disc { .. } | Emitter::Sky(_)));
        Lights { list, sums, balls, far, of_surface, center, radius }
    }

    /// The emitter that is this surface.
    pub fn of_surface(&self, surface: u32) -> Option<usize> {
        self.of_surface[surface as usize]
    }

    /// What is seen far away, in direction d: emitters with their radiance.
    pub fn far(&self, d: DVec3) -> impl Iterator<Item = (usize, DVec3)> {
        self.far.iter().map(move |&k| (k, far_radiance(&self.list[k], d)))
    }

    /// The first ball that a ray meets before `end`: the distance and the emitter. From inside, a ball is dark and still hides.
    pub fn first_ball(&self, ray: &Ray, end: f64) -> Option<(f64, usize)> {
        self.balls.first(ray, end)
    }

    /// The radiance of a ball towards a ray that meets it, and the cosine there.
    pub fn ball_radiance(&self, emitter: usize, ray: &Ray, t: f64) -> (DVec3, f64) {
        let Emitter::Ball { center, radius, radiance } = self.list[emitter] else { return (DVec3::ZERO, 1.0) };
        let cosine = -(ray.at(t) - center).dot(ray.direction) / radius;
        if cosine > 0.0 { (radiance, cosine.min(1.0)) } else { (DVec3::ZERO, 1.0) }
    }

    /// How likely an emitter is chosen.
    pub fn choice(&self, emitter: usize) -> f64 {
        self.sums[emitter] - if emitter == 0 { 0.0 } else { self.sums[emitter - 1] }
    }

    /// An emitter by a number, and the number made fresh.
    fn choose(&self, u: f64) -> Option<(usize, f64)> {
        let k = self.sums.partition_point(|&sum| sum <= u).min(self.sums.len().checked_sub(1)?);
        let before = if k == 0 { 0.0 } else { self.sums[k - 1] };
        Some((k, ((u - before) / (self.sums[k] - before)).clamp(0.0, 1.0 - f64::EPSILON)))
    }

    /// A way from a point towards some emitter.
    pub fn toward(&self, from: DVec3, [pick, _]: [f64; 2], u: [f64; 2]) -> Option<Toward> {
        let (emitter, _) = self.choose(pick)?;
        let choice = self.choice(emitter);
        let far = 1.0 / (PI * self.radius * self.radius);
        let found = |direction: DVec3, distance: f64, radiance: DVec3, pdf: f64| Toward {
            emitter,
            direction,
            distance,
            radiance,
            pdf: choice * pdf,
            is_delta: false,
            emission_pdf: choice * pdf * far,
            cosine: 1.0,
        };
        Some(match &self.list[emitter] {
            Emitter::Point { at, intensity } => {
                let way = *at - from;
                let squared = way.length_squared();
                let distance = squared.sqrt();
                let toward = found(way / distance, distance, *intensity / squared, 1.0);
                Toward { is_delta: true, emission_pdf: choice * ON_SPHERE, ..toward }
            }
            Emitter::Parallel { toward, irradiance } => {
                Toward { is_delta: true, ..found(*toward, f64::INFINITY, *irradiance, 1.0) }
            }
            Emitter::Disc { frame, cap, radiance } => {
                let direction = frame.world_from_local(in_cone(*cap, u));
                found(direction, f64::INFINITY, *radiance, cone_density(*cap))
            }
            Emitter::Sky(table) => {
                let direction = table.sample(u);
                found(direction, f64::INFINITY, table.radiance(direction), table.pdf(direction))
            }
            Emitter::Ball { center, radius, radiance } => {
                let (direction, pdf) = toward_ball(from, *center, *radius, u)?;
                let ray = Ray::new(from, direction);
                // A ray of the cone's very edge may miss the ball by rounding; it is as good as one that touches it.
                let distance = balls::meet(&ray, *center, *radius).unwrap_or((*center - from).dot(direction));
                let cosine = (-(ray.at(distance) - *center).dot(direction) / *radius).clamp(0.0, 1.0);
                let area = 4.0 * PI * radius * radius;
                Toward {
                    cosine,
                    emission_pdf: choice * cosine / (PI * area),
                    ..found(direction, f64::INFINITY, *radiance, pdf)
                }
            }
            Emitter::Glow { center, radius, .. } => {
                let (direction, pdf) = toward_ball(from, *center, *radius, u)?;
                found(direction, f64::INFINITY, DVec3::ZERO, pdf)
            }
        })
    }

    /// The density with which [`Lights::toward`] takes a direction from a point, for light of this emitter.
    pub fn pdf_toward(&self, emitter: usize, from: DVec3, direction: DVec3) -> f64 {
        let pdf = match &self.list[emitter] {
            Emitter::Point { .. } | Emitter::Parallel { .. } => 0.0,
            Emitter::Disc { cap, .. } => cone_density(*cap),
            Emitter::Sky(table) => table.pdf(direction),
            Emitter::Ball { center, radius, .. } | Emitter::Glow { center, radius, .. } => {
                cap_of_ball(from, *center, *radius).map_or(0.0, cone_density)
            }
        };
        self.choice(emitter) * pdf
    }

    /// The density of [`Lights::emit`] for light that leaves an emitter in −`direction`, by the cosine there; for surfaces
    /// `length` is the length of the ray in the ball.
    pub fn emission_pdf(&self, emitter: usize, direction: DVec3, cosine: f64, length: f64) -> f64 {
        let far = 1.0 / (PI * self.radius * self.radius);
        let pdf = match &self.list[emitter] {
            Emitter::Point { .. } => ON_SPHERE,
            Emitter::Parallel { .. } => far,
            Emitter::Disc { cap, .. } => cone_density(*cap) * far,
            Emitter::Sky(table) => table.pdf(direction) * far,
            Emitter::Ball { radius, .. } => cosine / (PI * 4.0 * PI * radius * radius),
            Emitter::Glow { radius, .. } => cosine * length * ON_SPHERE / volume(*radius),
        };
        self.choice(emitter) * pdf
    }

    /// How far a ray goes inside the ball around a surface that glows, at most `t`.
    pub fn length_in_ball(&self, emitter: usize, ray: &Ray, t: f64) -> f64 {
        let Emitter::Glow { center, radius, .. } = self.list[emitter] else { return t };
        let ball = crate::surface::Shape::Ball { center, radius };
        ball.span(ray).map_or(0.0, |(a, b)| (b.min(t) - a).max(0.0))
    }

    /// A ray that leaves some emitter.
    pub fn emit(&self, [pick, _]: [f64; 2], place: [f64; 2], aim: [f64; 2], depth: f64) -> Option<Emitted> {
        let (emitter, _) = self.choose(pick)?;
        let choice = self.choice(emitter);
        let far = |toward: DVec3| {
            let frame = Frame::around(toward);
            let [a, b] = on_disc(place);
            let origin = self.center + (frame.x * a + frame.y * b + toward) * self.radius;
            Ray::new(origin, -toward)
        };
        let out = |ray: Ray, energy: DVec3, emission_pdf: f64, cosine: f64| Emitted {
            emitter,
            ray,
            power: energy / emission_pdf,
            emission_pdf,
            cosine,
        };
        let pdf = |direction: DVec3, cosine: f64| self.emission_pdf(emitter, direction, cosine, 1.0);
        Some(match &self.list[emitter] {
            Emitter::Point { at, intensity } => {
                let direction = on_sphere(aim);
                out(Ray::new(*at, direction), *intensity, pdf(-direction, 1.0), 1.0)
            }
            Emitter::Parallel { toward, irradiance } => out(far(*toward), *irradiance, pdf(*toward, 1.0), 1.0),
            Emitter::Disc { frame, cap, radiance } => {
                let toward = frame.world_from_local(in_cone(*cap, aim));
                out(far(toward), *radiance, pdf(toward, 1.0), 1.0)
            }
            Emitter::Sky(table) => {
                let toward = table.sample(aim);
                out(far(toward), table.radiance(toward), pdf(toward, 1.0), 1.0)
            }
            Emitter::Ball { center, radius, radiance } => {
                let n = on_sphere(place);
                let local = by_cosine(aim);
                let direction = Frame::around(n).world_from_local(local);
                let cosine = local.z.max(f64::MIN_POSITIVE);
                out(Ray::new(*center + n * *radius, direction), *radiance * cosine, pdf(-direction, cosine), cosine)
            }
            Emitter::Glow { center, radius, .. } => {
                // From an even point of the ball back to the surface: a place of it is as likely as its ray is long in the ball.
                let distance = native::pow(depth, 1.0 / 3.0) * radius;
                let origin = *center + on_sphere(place) * distance;
                let power = DVec3::splat(volume(*radius) / (ON_SPHERE * choice));
                Emitted { emitter, ray: Ray::new(origin, -on_sphere(aim)), power, emission_pdf: 0.0, cosine: 1.0 }
            }
        })
    }
}

fn volume(radius: f64) -> f64 {
    4.0 / 3.0 * PI * radius * radius * radius
}

fn emitter(light: &Light) -> Emitter {
    let strength = light.strength();
    match *light {
        Light::Point { at, .. } => Emitter::Point { at, intensity: strength },
        Light::Ball { center, radius, .. } => Emitter::Ball { center, radius, radiance: strength },
        Light::Sun { toward, half_angle, .. } if half_angle > 0.0 => {
            let half = native::sin(half_angle * 0.5);
            Emitter::Disc { frame: Frame::around(toward), cap: 2.0 * half * half, radiance: strength }
        }
        Light::Sun { toward, .. } => Emitter::Parallel { toward, irradiance: strength },
    }
}

/// About how much light an emitter sends into a scene of this radius, in watts.
fn power(emitter: &Emitter, scene: &Scene, scene_radius: f64) -> f64 {
    let section = PI * scene_radius * scene_radius;
    match emitter {
        Emitter::Point { intensity, .. } => 4.0 * PI * intensity.max_element(),
        Emitter::Ball { radius, radiance, .. } => 4.0 * PI * PI * radius * radius * radiance.max_element(),
        Emitter::Parallel { irradiance, .. } => irradiance.max_element() * section,
        Emitter::Disc { cap, radiance, .. } => radiance.max_element() / cone_density(*cap) * section,
        Emitter::Sky(table) => 4.0 * PI * section * table.mean.max_element(),
        Emitter::Glow { surface, radius, .. } => {
            let emission = scene.materials[*surface as usize].emission.constant().unwrap_or(DVec3::ONE);
            4.0 * PI * PI * radius * radius * emission.max_element()
        }
    }
}

/// A ball around all surfaces.
fn surroundings(scene: &Scene) -> (DVec3, f64) {
    let mut all = (scene.center, scene.radius);
    for &(center, radius) in &scene.bounds {
        let away = center.distance(all.0);
        if away + radius > all.1 {
            all.1 = away + radius;
        }
    }
    all
}

fn far_radiance(emitter: &Emitter, d: DVec3) -> DVec3 {
    match emitter {
        Emitter::Disc { frame, cap, radiance } if d.dot(frame.n) >= 1.0 - cap => *radiance,
        Emitter::Sky(table) => table.radiance(d),
        _ => DVec3::ZERO,
    }
}

/// 1 − the cosine of half the angle that a ball is seen under; `None` from inside.
fn cap_of_ball(from: DVec3, center: DVec3, radius: f64) -> Option<f64> {
    let squared = radius * radius / (center - from).length_squared();
    // 1 − √(1 − s²), without cancelling.
    (squared < 1.0).then(|| squared / (1.0 + (1.0 - squared).sqrt()))
}

/// A direction in the cone of a ball, and its density.
fn toward_ball(from: DVec3, center: DVec3, radius: f64, u: [f64; 2]) -> Option<(DVec3, f64)> {
    let cap = cap_of_ball(from, center, radius)?;
    let axis = (center - from).normalize();
    Some((Frame::around(axis).world_from_local(in_cone(cap, u)), cone_density(cap)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::transport::world::Numbers;

    fn lights(emitter: Emitter) -> Lights {
        let (list, sums) = (vec![emitter], vec![1.0]);
        Lights {
            list,
            sums,
            balls: Balls::default(),
            far: vec![0],
            of_surface: Vec::new(),
            center: DVec3::ZERO,
            radius: 5.0,
        }
    }

    /// Light sought from the middle of a small square of the floor, and light sent that meets the square, are the same irradiance.
    #[test]
    fn light_that_is_sought_and_light_that_is_sent_agree() {
        let high = DVec3::new(0.4, -0.3, 1.0).normalize();
        let frame = Frame::around(high);
        let gradient = crate::scene::Sky::Gradient { top: DVec3::splat(3.0), horizon: DVec3::ONE, ground: DVec3::ZERO };
        let at = DVec3::new(0.2, 0.0, 3.0);
        let cubed = 9.04 * 9.04f64.sqrt();
        let rows = [
            ("ball", Emitter::Ball { center: at, radius: 0.5, radiance: DVec3::ONE }, PI * 0.25 * at.z / cubed),
            ("point", Emitter::Point { at, intensity: DVec3::ONE }, at.z / cubed),
            ("parallel", Emitter::Parallel { toward: high, irradiance: DVec3::ONE }, high.z),
            ("disc", Emitter::Disc { frame, cap: 0.01, radiance: DVec3::ONE }, PI * 0.01 * (2.0 - 0.01) * high.z),
            // ∫ (1 + 2 sin)·sin over the hemisphere.
            ("sky", Emitter::Sky(SkyTable::new(&gradient)), 2.0 * PI * (0.5 + 2.0 / 3.0)),
        ];
        for (name, emitter, expected) in rows {
            let lights = lights(emitter);
            let (n, half) = (1 << 18, 0.25);
            let (mut sought, mut sent) = (0.0, 0.0);
            for sample in 0..n {
                let numbers = Numbers { pixel: 1, sample, seed: 0 };
                let toward = lights.toward(DVec3::ZERO, numbers.at(0), numbers.at(1)).unwrap();
                sought += toward.radiance.x * toward.direction.z.max(0.0) / toward.pdf;
                let emitted = lights.emit(numbers.at(2), numbers.at(3), numbers.at(4), 0.5).unwrap();
                let t = -emitted.ray.origin.z / emitted.ray.direction.z;
                let at = emitted.ray.at(t);
                if t > 0.0 && emitted.ray.direction.z < 0.0 && at.x.abs() < half && at.y.abs() < half {
                    sent += emitted.power.x / (4.0 * half * half);
                }
                let again = lights.emission_pdf(0, -emitted.ray.direction, emitted.cosine, 1.0);
                assert!((again / emitted.emission_pdf - 1.0).abs() < 1e-9, "{name}");
            }
            let (sought, sent) = (sought / f64::from(n), sent / f64::from(n));
            assert!((sought / expected - 1.0).abs() < 2e-3, "{name}: sought {sought}, not {expected}");
            assert!((sent / expected - 1.0).abs() < 0.05, "{name}: sent {sent}, not {expected}");
        }
    }
}
