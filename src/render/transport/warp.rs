//! From two numbers of 0..1 to places and directions, evenly; and the frames they are told in.
//!
//! In: numbers of 0..1. Out: points of the sphere, of a cone, of the disc, of the hemisphere by its cosine. Each is a map that keeps
//! areas in proportion, so that evenly spread numbers give evenly spread places.

use crate::num::func::native;
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// Three axes at right angles, the third of them given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The first axis.
    pub x: DVec3,
    /// The second.
    pub y: DVec3,
    /// The third: the normal.
    pub n: DVec3,
}

impl Frame {
    /// The frame around n, of length 1 (Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1), listing 3).
    pub fn around(n: DVec3) -> Self {
        let sign = if n.z < 0.0 { -1.0 } else { 1.0 };
        let a = -1.0 / (sign + n.z);
        let b = n.x * n.y * a;
        let x = DVec3::new(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
        let y = DVec3::new(b, sign + n.y * n.y * a, -n.y);
        Frame { x, y, n }
    }

    /// A direction of the world in this frame.
    pub fn local_from_world(&self, d: DVec3) -> DVec3 {
        DVec3::new(d.dot(self.x), d.dot(self.y), d.dot(self.n))
    }

    /// A direction of this frame in the world.
    pub fn world_from_local(&self, d: DVec3) -> DVec3 {
        self.x * d.x + self.y * d.y + self.n * d.z
    }
}

/// An even point of the unit sphere; its density is 1/(4π).
pub fn on_sphere([u, v]: [f64; 2]) -> DVec3 {
    let z = 1.0 - 2.0 * u;
    around_axis(z, v)
}

/// The density of [`on_sphere`].
pub const ON_SPHERE: f64 = 1.0 / (4.0 * PI);

/// An even direction of the cone around z whose half angle has a cosine of 1 − `cap`; its density is 1/(2π·cap).
pub fn in_cone(cap: f64, [u, v]: [f64; 2]) -> DVec3 {
    let low = u * cap;
    let sine = (low * (2.0 - low)).max(0.0).sqrt();
    let (s, c) = turn(v);
    DVec3::new(sine * c, sine * s, 1.0 - low)
}

/// The density of [`in_cone`].
pub fn cone_density(cap: f64) -> f64 {
    1.0 / (TAU * cap)
}

/// An even point of the unit disc (Shirley and Chiu 1997, "A low distortion map between disk and square").
pub fn on_disc([u, v]: [f64; 2]) -> [f64; 2] {
    let (a, b) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    if a == 0.0 && b == 0.0 {
        return [0.0, 0.0];
    }
    let (radius, angle) =
        if a.abs() > b.abs() { (a, FRAC_PI_4 * (b / a)) } else { (b, FRAC_PI_2 - FRAC_PI_4 * (a / b)) };
    [radius * native::cos(angle), radius * native::sin(angle)]
}

/// A direction of the hemisphere around z, as likely as its cosine; its density is cos/π (Malley's method).
pub fn by_cosine(u: [f64; 2]) -> DVec3 {
    let [x, y] = on_disc(u);
    DVec3::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt())
}

/// The direction at height z that is turned by v of a full turn.
fn around_axis(z: f64, v: f64) -> DVec3 {
    let radius = (1.0 - z * z).max(0.0).sqrt();
    let (s, c) = turn(v);
    DVec3::new(radius * c, radius * s, z)
}

fn turn(v: f64) -> (f64, f64) {
    (native::sin(TAU * v), native::cos(TAU * v))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The means of a warp over a fine grid of numbers.
    fn mean(warp: impl Fn([f64; 2]) -> f64) -> f64 {
        let n = 600;
        let number = |k: usize| (k as f64 + 0.5) / n as f64;
        (0..n * n).map(|k| warp([number(k / n), number(k % n)])).sum::<f64>() / (n * n) as f64
    }

    #[test]
    fn warps_have_the_moments_of_what_they_fill() {
        let rows: [(&str, f64, f64); 8] = [
            ("sphere z", mean(|u| on_sphere(u).z), 0.0),
            ("sphere z²", mean(|u| on_sphere(u).z * on_sphere(u).z), 1.0 / 3.0),
            ("sphere x²", mean(|u| on_sphere(u).x * on_sphere(u).x), 1.0 / 3.0),
            ("disc r²", mean(|u| on_disc(u).map(|c| c * c).iter().sum()), 0.5),
            ("disc x²", mean(|u| on_disc(u)[0] * on_disc(u)[0]), 0.25),
            ("cosine z", mean(|u| by_cosine(u).z), 2.0 / 3.0),
            ("cone z", mean(|u| in_cone(0.5, u).z), 0.75),
            ("cone x²", mean(|u| in_cone(1.0, u).x * in_cone(1.0, u).x), 1.0 / 3.0),
        ];
        for (name, found, expected) in rows {
            assert!((found - expected).abs() < 1e-4, "{name}: {found}, not {expected}");
        }
    }

    #[test]
    fn frames_are_right_handed_and_of_length_one() {
        for k in 0..200 {
            let n = on_sphere([(f64::from(k) + 0.5) / 200.0, f64::from(k) * 0.381_966 % 1.0]);
            for n in [n, DVec3::Z, -DVec3::Z] {
                let Frame { x, y, n } = Frame::around(n);
                assert!(
                    (x.cross(y) - n).length() < 1e-12 && x.dot(y).abs() < 1e-12 && (x.length() - 1.0).abs() < 1e-12
                );
                let d = on_sphere([0.3, 0.7]);
                let frame = Frame { x, y, n };
                assert!((frame.world_from_local(frame.local_from_world(d)) - d).length() < 1e-12);
            }
        }
    }
}
