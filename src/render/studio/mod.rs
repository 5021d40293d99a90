//! Mode `studio`: one look that flatters any surface.
//!
//! In: hits. Out: linear light of a warm key light with a soft shadow, of a sky that fills the shade where it is open,
//! of what hides the sky and shines back; a coat with a soft sheen; before a quiet wall. docs/look.md tells why.
//!
//! The centre ray of each pixel sends a few rays on ([`gather`]) and remembers what they met ([`glimpse`]); then each
//! point that is seen takes the mean of its neighbours ([`blend`]) and is shaded ([`lacquer`], [`cut`], [`backdrop`]).

pub mod backdrop;
pub mod blend;
pub mod cut;
pub mod directions;
pub mod gather;
pub mod glimpse;
pub mod lacquer;

use crate::scene::Scene;
use crate::scene::studio::Studio;
use crate::surface::Ray;
use glam::DVec3;
use glimpse::{Glimpse, Light};
use lacquer::Lacquer;

/// How much of its colour a surface keeps where the clip cuts it off.
const CUT_SHARE: f64 = 0.35;

/// What of a surface shines back.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Its own colour.
    pub colour: DVec3,
    /// How wide a pixel is there.
    pub footprint: f64,
}

/// The light of what a ray sees.
pub fn colour(scene: &Scene, lights: &Studio, ray: &Ray, glimpse: &Glimpse, light: &Light, seen: Seen) -> DVec3 {
    let normal = glimpse.normal.as_dvec3();
    let at = glimpse::point(ray, glimpse);
    let line = cut::line(&scene.clips[glimpse.surface()], at, normal, seen.footprint);
    let albedo = seen.colour * (1.0 - line * (1.0 - CUT_SHARE));
    Lacquer { albedo, normal, view: -ray.direction }.lit(lights, light)
}

#[cfg(test)]
mod tests;
