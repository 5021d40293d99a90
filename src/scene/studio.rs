//! The lights a scene has when nobody gave it any.
//!
//! In: the camera. Out: directions towards far lights, and the studio: a key light with the size of a lamp and a sky.
//! They follow the camera, so that what is seen is lit.

use super::camera::Camera;
use glam::DVec3;

/// Towards the light over the camera's left shoulder, of the modes that teach.
pub fn shoulder(camera: &Camera) -> DVec3 {
    (camera.right * -0.4 + camera.up * 0.5 - camera.forward).normalize()
}

/// The sine of half the angle under which the key light is seen: a lamp a step away, whose shadows have soft edges.
const KEY_SINE: f64 = 0.13;

/// What the key light sends onto a surface that faces it, over π; a little warm.
const KEY_STRENGTH: DVec3 = DVec3::new(1.22, 1.14, 1.02);

/// The sky's radiance at the height of the eye: the mean of its two ends.
const SKY_MIDDLE: DVec3 = DVec3::new(0.31, 0.33, 0.365);

/// What the sky gains from there to the top, and loses to the bottom: cool above, warm below.
const SKY_SLOPE: DVec3 = DVec3::new(0.14, 0.155, 0.18);

/// The lights of mode `studio`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Studio {
    /// From the upper left, far enough aside that forms turn into shade.
    pub key: Key,
    /// All around.
    pub sky: Sky,
}

impl Studio {
    /// The lights as they stand around this camera. In the three-quarter view from above that is taken when nobody
    /// says, the sky's top is nearly the world's.
    pub fn around(camera: &Camera) -> Self {
        let direction = (camera.right * -0.75 + camera.up * 0.80 - camera.forward * 0.55).normalize();
        let across = direction.cross(camera.up).normalize();
        Studio {
            key: Key { direction, across, along: across.cross(direction), sine: KEY_SINE, strength: KEY_STRENGTH },
            sky: Sky {
                top: (camera.up * 0.91 - camera.forward * 0.41).normalize(),
                middle: SKY_MIDDLE,
                slope: SKY_SLOPE,
            },
        }
    }
}

/// A far disc of even radiance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Key {
    /// Towards its middle.
    pub direction: DVec3,
    across: DVec3,
    along: DVec3,
    /// The sine of half the angle under which it is seen.
    pub sine: f64,
    /// Its irradiance over π on a surface that faces it: what a white matte surface would show.
    pub strength: DVec3,
}

impl Key {
    /// The direction of the point (u, v) of the unit disc, even in solid angle where the points are even in the disc.
    pub fn toward(&self, [u, v]: [f64; 2]) -> DVec3 {
        // Shirley, Wang and Zimmerman 1996, "Monte Carlo techniques for direct lighting calculations", section 3.3:
        // a cap of solid angle grows with 1 − cosθ as a disc grows with its radius squared.
        let squared = (u * u + v * v).min(1.0);
        let cap = 1.0 - (1.0 - self.sine * self.sine).sqrt();
        let cosine = 1.0 - squared * cap;
        let stretch = (cap * (1.0 + cosine)).sqrt();
        (self.direction * cosine + (self.across * u + self.along * v) * stretch).normalize()
    }

    /// The share of [`Key::strength`] that arrives on an open surface whose normal has this cosine to the light's middle:
    /// the cosine above the surface's horizon; a parabola while the light rises, which meets it with the same slope.
    pub fn share(&self, cosine: f64) -> f64 {
        match () {
            () if cosine >= self.sine => cosine,
            () if cosine <= -self.sine => 0.0,
            () => (cosine + self.sine) * (cosine + self.sine) / (4.0 * self.sine),
        }
    }
}

/// A sky whose radiance rises evenly with the height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sky {
    /// Towards its brightest point.
    pub top: DVec3,
    /// The radiance halfway.
    pub middle: DVec3,
    /// The radiance gained from halfway to the top.
    pub slope: DVec3,
}

impl Sky {
    /// The radiance from direction d.
    pub fn radiance(&self, d: DVec3) -> DVec3 {
        self.middle + self.slope * self.top.dot(d)
    }

    /// The irradiance over π on an open surface of normal n: the mean of a direction, weighted by its cosine, is ⅔n.
    pub fn irradiance(&self, n: DVec3) -> DVec3 {
        self.middle + self.slope * (self.top.dot(n) * (2.0 / 3.0))
    }
}
