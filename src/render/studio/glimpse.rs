//! What is kept of the ray through each pixel's centre, so that neighbours can share their light.
//!
//! In: a hit and the light that was gathered there. Out: 32 bytes a pixel.

use super::super::integrator::{Place, facing_normal};
use crate::surface::{Hit, Ray};
use glam::{DVec3, Vec3};

/// The surface at the first hit of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glimpse {
    /// The distance.
    pub t: f32,
    /// The normal, turned to the eye.
    pub normal: Vec3,
    /// Twice the surface's number, and one more for its back; [`Glimpse::NONE`] has the largest.
    pub side: u32,
}

impl Glimpse {
    /// Of a ray that hits nothing.
    pub const NONE: Glimpse = Glimpse { t: f32::INFINITY, normal: Vec3::ZERO, side: u32::MAX };

    /// Of a ray and its hit.
    pub fn of(ray: &Ray, hit: &Hit) -> Self {
        if !hit.is_drawn() {
            return Glimpse::NONE;
        }
        let normal = facing_normal(ray, hit).as_vec3();
        Glimpse { t: hit.t as f32, normal, side: hit.surface * 2 + u32::from(hit.flipped) }
    }

    /// Which surface it is.
    pub fn surface(&self) -> usize {
        (self.side / 2) as usize
    }

    /// Where it is on its ray, if there is a surface.
    pub fn place(&self, ray: &Ray) -> Option<Place> {
        let place = || Place { surface: self.surface(), point: point(ray, self), is_negative: self.side & 1 == 1 };
        self.is_drawn().then(place)
    }

    /// Whether there is a surface.
    pub fn is_drawn(&self) -> bool {
        self.side != u32::MAX
    }
}

/// The light that arrives at a point but for what can be computed without rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// The share of the key light that is not hidden, of 0..=1.
    pub key: f32,
    /// The share of the sky that is not hidden, each direction by its cosine, of 0..=1.
    pub open: f32,
    /// The mean height of hidden directions, each by its cosine, of −1..=1: whether the sky's top or bottom is hidden.
    pub hidden_height: f32,
    /// The irradiance over π from what hides the sky.
    pub bounce: Vec3,
}

impl Light {
    /// Nothing is hidden.
    pub const OPEN: Light = Light { key: 1.0, open: 1.0, hidden_height: 0.0, bounce: Vec3::ZERO };
}

/// A glimpse with its light, packed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Remembered {
    /// The surface.
    pub glimpse: Glimpse,
    light: [i16; 6],
}

/// The largest irradiance that is kept of bounced light; more than any that lamp and sky give.
const MOST_BOUNCE: f32 = 2.0;

impl Remembered {
    /// Nothing.
    pub const NONE: Remembered = Remembered { glimpse: Glimpse::NONE, light: [0; 6] };

    /// Packs.
    pub fn new(glimpse: Glimpse, light: &Light) -> Self {
        let bounce = light.bounce / MOST_BOUNCE;
        let parts = [light.key, light.open, light.hidden_height, bounce.x, bounce.y, bounce.z];
        Remembered { glimpse, light: parts.map(|part| (part.clamp(-1.0, 1.0) * 32767.0).round() as i16) }
    }

    /// Unpacks the light.
    pub fn light(&self) -> Light {
        let [key, open, hidden_height, x, y, z] = self.light.map(|part| f32::from(part) / 32767.0);
        Light { key, open, hidden_height, bounce: Vec3::new(x, y, z) * MOST_BOUNCE }
    }
}

/// The point of a glimpse on its ray.
pub fn point(ray: &Ray, glimpse: &Glimpse) -> DVec3 {
    ray.at(f64::from(glimpse.t))
}
