//! Lights and surroundings, as the program says.
//!
//! In: nothing, it is plain data. Out: where light comes from: radiance in W/(m² sr), linear red, green, blue. How lights are sampled is
//! `render`'s business.

use super::daylight::Daylight;
use glam::DVec3;
use std::f64::consts::PI;

/// A light that is no surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// A point that radiates evenly into all directions.
    Point {
        /// Where.
        at: DVec3,
        /// Power in watts.
        power: DVec3,
    },
    /// A ball of even radiance. It scatters nothing, and hides what is behind it.
    Ball {
        /// Its centre.
        center: DVec3,
        /// Its radius, > 0.
        radius: f64,
        /// Power in watts.
        power: DVec3,
    },
    /// A light so far away that its rays are parallel, or fill a small cone.
    Sun {
        /// Towards its middle, of length 1.
        toward: DVec3,
        /// What it gives to a surface that faces it, in W/m².
        irradiance: DVec3,
        /// Half the angle under which it is seen, in radians; 0: parallel rays.
        half_angle: f64,
    },
}

/// What is seen where there is nothing else.
#[derive(Clone, Debug, PartialEq)]
pub enum Sky {
    /// The same radiance from everywhere.
    Uniform(DVec3),
    /// By the height above the horizon.
    Gradient {
        /// The radiance straight above.
        top: DVec3,
        /// The radiance of the horizon; between it and the top linear in the sine of the elevation.
        horizon: DVec3,
        /// The radiance from below.
        ground: DVec3,
    },
    /// Clear daylight.
    Daylight(Daylight),
}

impl Light {
    /// The intensity of a point in W/sr, or the radiance of a ball or a sun of some size; a Lambertian ball of power P radiates
    /// P/π from each of its 4πr².
    pub fn strength(&self) -> DVec3 {
        match *self {
            Light::Point { power, .. } => power / (4.0 * PI),
            Light::Ball { power, radius, .. } => power / (4.0 * PI * PI * radius * radius),
            Light::Sun { irradiance, half_angle, .. } if half_angle > 0.0 => {
                let sine = crate::num::func::sin_cos::<crate::num::level::Portable>(half_angle).0;
                irradiance / (PI * sine * sine)
            }
            Light::Sun { irradiance, .. } => irradiance,
        }
    }
}

impl Sky {
    /// The radiance from direction d, of length 1.
    pub fn radiance(&self, d: DVec3) -> DVec3 {
        match self {
            Sky::Uniform(radiance) => *radiance,
            Sky::Gradient { top, horizon, .. } if d.z >= 0.0 => horizon.lerp(*top, d.z),
            Sky::Gradient { ground, .. } => *ground,
            Sky::Daylight(daylight) => daylight.radiance(d),
        }
    }
}
