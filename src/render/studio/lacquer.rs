//! The surface's finish: matte colour under a rough, clear coat.
//!
//! In: colour, normal, direction to the eye, the light that arrives. Out: the light that leaves towards the eye.

use super::glimpse::Light;
use crate::scene::studio::Studio;
use glam::DVec3;

/// Light from the eye, so that no shade is flat, over π.
const EYE: f64 = 0.07;

/// The share of light that a coat of refractive index 1.5 reflects at a right angle.
const NORMAL_REFLECTANCE: f64 = 0.04;

/// The same at a grazing angle: less than all, since a rough coat hides parts of itself there.
const GRAZING_REFLECTANCE: f64 = 0.3;

/// The roughness α of the coat's two parts: a broad sheen, and a highlight within it. Each includes the lamp's own width.
const ROUGHNESS: [f64; 2] = [0.36, 0.11];

/// The share of the coat that each part is.
const PARTS: [f64; 2] = [0.7, 0.3];

/// Below this open share, what hides the sky is itself in the dark.
const DARK: f64 = 0.12;

/// A surface in the studio, seen from direction `view`.
#[derive(Clone, Copy, Debug)]
pub struct Lacquer {
    /// The share of light that leaves the matte ground, of 0..=1.
    pub albedo: DVec3,
    /// The normal, turned to the eye.
    pub normal: DVec3,
    /// Towards the eye.
    pub view: DVec3,
}

impl Lacquer {
    /// The light towards the eye.
    pub fn lit(&self, lights: &Studio, light: &Light) -> DVec3 {
        let (n, v, l) = (self.normal, self.view, lights.key.direction);
        let cos_view = n.dot(v).clamp(0.0, 1.0);
        let key = lights.key.strength * (lights.key.share(n.dot(l)) * f64::from(light.key));
        let reflectance = fresnel(cos_view);
        let diffuse = self.albedo * (key + sky(lights, n, light) + DVec3::splat(EYE * cos_view));
        let mirrored = n * (2.0 * n.dot(v)) - v;
        // The coat looks the way the surface turns: what hides half of the sky from the surface hides more of it there.
        let sheen = lights.sky.radiance(mirrored) * (reflectance * f64::from(light.open * light.open));
        diffuse * (1.0 - reflectance) + sheen + key * self.highlight(l, cos_view)
    }

    /// The coat's share of the key light, over that of a white matte surface.
    fn highlight(&self, l: DVec3, cos_view: f64) -> f64 {
        let half = (l + self.view).normalize_or_zero();
        let (cos_half, cos_turn) = (self.normal.dot(half).max(0.0), half.dot(l).clamp(0.0, 1.0));
        let distribution: f64 =
            ROUGHNESS.iter().zip(PARTS).map(|(&alpha, part)| part * trowbridge(cos_half, alpha)).sum();
        // Kelemen and Szirmay-Kalos 2001, "A microfacet based coupled specular-matte BRDF model", eq. 4: shadowing of one
        // facet by another, and the two cosines, together 1/(4 cos² of half the angle between light and eye).
        let fades = (cos_view * 4.0).min(1.0);
        distribution * fresnel(cos_turn) / (4.0 * (cos_turn * cos_turn).max(0.1)) * fades
    }
}

/// The irradiance over π from sky and from what hides it.
fn sky(lights: &Studio, n: DVec3, light: &Light) -> DVec3 {
    let (open, height) = (f64::from(light.open), f64::from(light.hidden_height));
    let hidden = lights.sky.middle * (1.0 - open) + lights.sky.slope * height;
    let bounce = light.bounce.as_dvec3() * (open * (1.0 + DARK) / (open + DARK));
    (lights.sky.irradiance(n) - hidden).max(DVec3::ZERO) + bounce
}

/// Schlick 1994, "An inexpensive BRDF model for physically-based rendering", eq. 15.
fn fresnel(cosine: f64) -> f64 {
    let rest = 1.0 - cosine;
    let squared = rest * rest;
    NORMAL_REFLECTANCE + (GRAZING_REFLECTANCE - NORMAL_REFLECTANCE) * squared * squared * rest
}

/// π times the distribution of Trowbridge and Reitz 1975, known as GGX (Walter et al. 2007, eq. 33).
fn trowbridge(cos_half: f64, alpha: f64) -> f64 {
    let squared = alpha * alpha;
    let spread = cos_half * cos_half * (squared - 1.0) + 1.0;
    squared / (spread * spread)
}
