//! What light a mode cannot find in a scene.
//!
//! In: a mode, a scene. Out: sentences. A way of seeking light misses the paths that it would have to guess exactly: those between a light
//! without size, or the eye, and a mirror.

use super::bsdf::SMOOTH_ALPHA;
use crate::render::settings::Mode;
use crate::scene::material::Kind;
use crate::scene::{Light, Material, Scene};

/// What of the scene's light the mode does not find; empty if it finds all.
pub fn losses(mode: Mode, scene: &Scene) -> Vec<&'static str> {
    let is_small = |light: &Light| match *light {
        Light::Point { .. } => true,
        Light::Sun { half_angle, .. } => half_angle == 0.0,
        Light::Ball { .. } => false,
    };
    let (has_small, has_mirrors) = (scene.lights.iter().any(is_small), scene.materials.iter().any(is_mirror_like));
    match mode {
        Mode::Path if has_small && has_mirrors => vec![
            "mode path finds no light that goes from a light without size to a mirror or glass and then to what is seen: caustics \
             are missing; give the light a size, or use mode light or bidirectional",
        ],
        Mode::Light if has_mirrors => vec![
            "mode light cannot connect mirrors and smooth glass to the eye: they are black, and smooth coats have no gloss; mode \
             bidirectional shows them",
        ],
        Mode::Bidirectional if has_small && has_mirrors => vec![
            "a caustic of a light without size is not seen in a mirror or through glass in any mode; give the light a size",
        ],
        _ => Vec::new(),
    }
}

/// Whether part of what a surface scatters goes into one direction alone.
fn is_mirror_like(material: &Material) -> bool {
    let is_smooth = material.roughness.constant().is_none_or(|roughness| roughness.x * roughness.x < SMOOTH_ALPHA);
    match material.kind {
        Kind::Matte => false,
        Kind::Mirror => true,
        Kind::Plastic { .. } | Kind::Metal(_) | Kind::Glass(_) => is_smooth,
    }
}
