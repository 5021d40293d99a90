//! The textbook method: step along the ray, see the sign change, close in with Newton.
//!
//! In: rays and a step H. Out: the first change of sign of f between samples at t = k·H inside the clip (and
//! at its two ends), refined by Newton's method from the middle of the step with
//! g'(t) = a·f_x + b·f_y + c·f_z, kept inside its bracket. Roots without a change of sign, and pairs of roots
//! between two samples, are missed: that is what the faithful method is for.

use super::bundle::Asked;
use super::hit::{Counts, Hit, Outcome, Ray};
use super::sheet::{POINTS, Points, Surface};
use glam::DVec3;

/// Newton's steps after which the bracket is taken as it is; halving alone reaches an ulp in 60.
const MOST_STEPS: usize = 80;

/// The most samples on one ray: what is further is not looked at.
const MOST_SAMPLES: u64 = 1 << 24;

/// Working memory of one thread.
pub(crate) struct Marcher {
    files: Vec<(Vec<Points>, Vec<Points>)>,
}

impl Marcher {
    pub(crate) fn new(surfaces: &[Surface]) -> Self {
        let files = surfaces.iter().map(|s| (s.written.point.registers(), s.written.gradient.registers())).collect();
        Marcher { files }
    }

    /// Replaces each hit by the first root found on its ray.
    pub(crate) fn run(
        &mut self,
        surfaces: &[Surface],
        step: f64,
        skipped: f64,
        rays: Asked,
        hits: &mut [Hit],
        counts: &mut Counts,
    ) {
        for (index, surface) in surfaces.iter().enumerate() {
            for (number, hit) in hits.iter_mut().enumerate() {
                let ray = &rays.ray(number as u32);
                let Some((t0, t1)) = surface.span(ray) else { continue };
                let (t0, t1) = (t0.max(skipped * surface.size), t1.min(hit.t).min(ray.end));
                let mut march = March { surface, ray, files: &mut self.files[index], counts };
                if let Some((a, b)) = march.bracket(t0, t1, step) {
                    *hit = march.close_in(a, b, index as u32);
                }
            }
        }
    }
}

/// One ray and one surface.
struct March<'a> {
    surface: &'a Surface,
    ray: &'a Ray,
    files: &'a mut (Vec<Points>, Vec<Points>),
    counts: &'a mut Counts,
}

impl March<'_> {
    /// The first two neighbouring samples between which f changes sign.
    fn bracket(&mut self, t0: f64, t1: f64, step: f64) -> Option<(f64, f64)> {
        let first = (t0 / step).floor() + 1.0;
        let samples = (((t1 - t0) / step) as u64 + 2).min(MOST_SAMPLES);
        let sample = |k: u64| if k == 0 { t0 } else { ((first + (k - 1) as f64) * step).min(t1) };
        let mut before = (t0, f64::NAN);
        for start in (0..=samples).step_by(POINTS) {
            let t: [f64; POINTS] = std::array::from_fn(|i| sample(start + i as u64));
            let f = self.values(&t);
            for (t, f) in t.into_iter().zip(f) {
                if f == 0.0 && t > t0 {
                    return Some((t, t));
                }
                if before.1 * f < 0.0 {
                    return Some((before.0, t));
                }
                before = (t, f);
                if t >= t1 {
                    return None;
                }
            }
        }
        None
    }

    fn values(&mut self, t: &[f64; POINTS]) -> [f64; POINTS] {
        for axis in 0..3 {
            let (o, d) = (self.ray.origin[axis], self.ray.direction[axis]);
            for i in 0..POINTS {
                self.files.0[axis].0[i] = o + t[i] * d;
            }
        }
        self.surface.written.point.run(&mut self.files.0);
        self.counts.points += POINTS as u64;
        self.surface.written.point.output(&self.files.0, 0).0
    }

    /// f and its gradient at t.
    fn gradient(&mut self, t: f64) -> (f64, DVec3) {
        let point = self.ray.at(t);
        for axis in 0..3 {
            self.files.1[axis].0 = [point[axis]; POINTS];
        }
        let kernel = &self.surface.written.gradient;
        kernel.run(&mut self.files.1);
        self.counts.gradients += 1;
        let [f, x, y, z] = [0, 1, 2, 3].map(|k| kernel.output(&self.files.1, k).0[0]);
        (f, DVec3::new(x, y, z))
    }

    /// Newton's method from the middle of [a, b], halving where a step would leave it.
    fn close_in(&mut self, a: f64, b: f64, surface: u32) -> Hit {
        let (mut a, mut b) = (a, b);
        let front = self.gradient(a).0;
        let mut t = 0.5 * (a + b);
        let mut gradient = DVec3::NAN;
        for _ in 0..MOST_STEPS {
            let f;
            (f, gradient) = self.gradient(t);
            if f == 0.0 || a == b {
                break;
            }
            if (f < 0.0) == (front < 0.0) {
                a = t;
            } else {
                b = t;
            }
            let newton = t - f / gradient.dot(self.ray.direction);
            // A step within the rounding of t leads nowhere, inside the bracket or out of it.
            if (newton - t).abs() <= 4.0 * f64::EPSILON * t {
                break;
            }
            let next = if newton > a && newton < b { newton } else { 0.5 * (a + b) };
            if (next - t).abs() <= 2.0 * f64::EPSILON * t {
                break;
            }
            t = next;
        }
        let normal = gradient.try_normalize().unwrap_or(DVec3::NAN);
        let flipped = normal.dot(self.ray.direction) > 0.0;
        let width = 4.0 * f64::EPSILON * t;
        Hit {
            outcome: Outcome::Hit,
            t,
            width,
            surface,
            normal: if flipped { -normal } else { normal },
            flipped,
            ..Hit::NONE
        }
    }
}
