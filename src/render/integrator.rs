//! From hits to light.
//!
//! In: rays, what they hit, the scene. Out: a colour a ray. One file a mode; here is what they share.

use super::settings::{Background, Mode};
use super::{cosine, data, mirror};
use crate::scene::{Scene, Sides, studio};
use crate::surface::{Hit, Ray};
use glam::DVec3;

/// The colour of every ray, in `colours`, which is emptied first; none in mode `studio`, which looks at
/// neighbours too, and in those that follow light.
pub fn shade(mode: Mode, scene: &Scene, rays: &[Ray], hits: &[Hit], colours: &mut Vec<[f32; 3]>) {
    colours.clear();
    let sides = if mode.shows_colours() { sides(scene, rays, hits) } else { Vec::new() };
    let sides = sides.into_iter();
    let rays = rays.iter().zip(hits);
    match mode {
        Mode::Studio | Mode::Path | Mode::Light | Mode::Bidirectional => {}
        Mode::Whitted | Mode::Angle | Mode::End | Mode::Bounces => {}
        Mode::Cosine => {
            let light = studio::shoulder(&scene.camera);
            colours.extend(rays.zip(sides).map(|((ray, hit), side)| cosine::colour(light, ray, hit, side)));
        }
        Mode::Mirror => colours.extend(rays.zip(sides).map(|((ray, hit), side)| mirror::colour(scene, ray, hit, side))),
        Mode::Curvature => colours.extend(rays.zip(sides).map(|((ray, hit), side)| data::curvature(ray, hit, side))),
        Mode::Normal => colours.extend(rays.map(|(_, hit)| data::normal(hit))),
        Mode::Depth => colours.extend(rays.map(|(ray, hit)| data::depth(scene, ray, hit))),
        Mode::Cost => colours.extend(rays.map(|(_, hit)| data::cost(hit))),
        Mode::Proof => colours.extend(rays.map(|(ray, hit)| data::proof(ray, hit))),
    }
}

/// The light of what a ray sees behind all surfaces; `None`: what the mode has.
pub fn behind(background: Background, scene: &Scene, ray: &Ray) -> Option<DVec3> {
    match background {
        Background::Own => None,
        Background::Plain(_) | Background::Clear => Some(DVec3::ZERO),
        Background::Sky => Some(scene.sky.as_ref().map_or(DVec3::ZERO, |sky| sky.radiance(ray.direction))),
    }
}

/// The normal turned to the eye; where the surface has none, it faces the eye.
pub fn facing_normal(ray: &Ray, hit: &Hit) -> DVec3 {
    if hit.normal.is_finite() { hit.normal } else { -ray.direction }
}

/// A place on a surface.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Which surface.
    pub surface: usize,
    /// Where.
    pub point: DVec3,
    /// Whether it is seen from where f is negative.
    pub is_negative: bool,
}

/// The colours of the sides that were hit; black where nothing was.
pub fn sides(scene: &Scene, rays: &[Ray], hits: &[Hit]) -> Vec<DVec3> {
    if !scene.sides.iter().any(Sides::is_varying) {
        let side = |hit: &Hit| plain(&scene.sides[hit.surface as usize], hit.flipped);
        return hits.iter().map(|hit| if hit.is_drawn() { side(hit) } else { DVec3::ZERO }).collect();
    }
    colours_of(
        scene,
        rays.iter().zip(hits).map(|(ray, hit)| {
            let place = || Place { surface: hit.surface as usize, point: ray.at(hit.t), is_negative: hit.flipped };
            hit.is_drawn().then(place)
        }),
    )
}

/// The colour of a side, where it is the same everywhere.
fn plain(sides: &Sides, is_negative: bool) -> DVec3 {
    if is_negative { sides.back } else { sides.front }
}

/// The colours of places; black where there is none. Those of one surface are computed together.
pub fn colours_of(scene: &Scene, places: impl Iterator<Item = Option<Place>>) -> Vec<DVec3> {
    let mut varying: Vec<Vec<(usize, Place)>> = vec![Vec::new(); scene.sides.len()];
    let mut colours = Vec::new();
    for (k, place) in places.enumerate() {
        colours.push(match place {
            None => DVec3::ZERO,
            Some(place) => {
                let sides = &scene.sides[place.surface];
                if sides.is_varying() {
                    varying[place.surface].push((k, place));
                }
                plain(sides, place.is_negative)
            }
        });
    }
    let mut out = Vec::new();
    for (sides, places) in scene.sides.iter().zip(&varying).filter(|(_, places)| !places.is_empty()) {
        let (points, is_negative): (Vec<DVec3>, Vec<bool>) =
            places.iter().map(|(_, place)| (place.point, place.is_negative)).unzip();
        sides.colours(&points, &is_negative, &mut out);
        places.iter().zip(&out).for_each(|((k, _), colour)| colours[*k] = *colour);
    }
    colours
}

/// As a film keeps it.
pub fn pixel(colour: DVec3) -> [f32; 3] {
    colour.as_vec3().to_array()
}
