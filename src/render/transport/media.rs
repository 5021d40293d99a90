//! What a ray is inside of.
//!
//! In: the clear solids of a scene, and which of them hold a point. Out: which one fills the place there, its refractive index, what it
//! takes of the light. One bit a solid is all a ray carries: where solids overlap the one of the highest priority fills the place, and
//! the boundaries of others inside it are not there (Schmidt and Budge 2002, "Simple Nested Dielectrics in Ray Traced Images").

use crate::num::func::native;
use crate::scene::Material;
use crate::scene::material::{Dielectric, Kind};
use glam::DVec3;

/// The solids that a point is inside of, a bit each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Media(u128);

/// So many clear solids are told apart at one point.
pub const MOST_SOLIDS: usize = 128;

/// The clear solids of a scene.
#[derive(Clone, Debug, Default)]
pub struct Solids {
    /// By rising priority: the highest bit that is set fills the place.
    list: Vec<(u32, Dielectric)>,
    /// Which of them a surface bounds.
    of_surface: Vec<Option<u8>>,
}

/// A boundary between two media.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Boundary {
    /// On the side a ray comes from.
    pub before: Media,
    /// On the other side.
    pub after: Media,
    /// The refractive index behind it over that in front; `None`: the same solid fills both sides, and nothing is there.
    pub relative_ior: Option<f64>,
}

impl Solids {
    /// The clear solids among these surfaces.
    pub fn new(materials: &[Material]) -> Self {
        let glass = |(index, material): (usize, &Material)| match material.kind {
            Kind::Glass(dielectric) => Some((index as u32, dielectric)),
            Kind::Matte | Kind::Plastic { .. } | Kind::Metal(_) | Kind::Mirror => None,
        };
        let mut list: Vec<(u32, Dielectric)> = materials.iter().enumerate().filter_map(glass).collect();
        list.sort_by_key(|(surface, dielectric)| (dielectric.priority, *surface));
        list.truncate(MOST_SOLIDS);
        let mut of_surface = vec![None; materials.len()];
        for (bit, (surface, _)) in list.iter().enumerate() {
            of_surface[*surface as usize] = u8::try_from(bit).ok();
        }
        Solids { list, of_surface }
    }

    /// The surfaces that bound a clear solid, and whether its inside is where their function is negative.
    pub fn surfaces(&self) -> impl Iterator<Item = (u32, bool)> {
        self.list.iter().map(|(surface, dielectric)| (*surface, dielectric.inside_is_negative))
    }

    /// What fills the place.
    pub fn filling(&self, media: Media) -> Option<&(u32, Dielectric)> {
        self.list.get((u128::BITS - media.0.leading_zeros()).checked_sub(1)? as usize)
    }

    /// The refractive index there; 1 of air.
    pub fn ior(&self, media: Media) -> f64 {
        self.filling(media).map_or(1.0, |(_, dielectric)| dielectric.ior)
    }

    /// These media with one more or one less; the same if the surface bounds no clear solid.
    pub fn with(&self, media: Media, surface: u32, is_inside: bool) -> Media {
        let Some(bit) = self.of_surface[surface as usize] else { return media };
        let mask = 1u128 << bit;
        Media(if is_inside { media.0 | mask } else { media.0 & !mask })
    }

    /// What a ray in these media meets at a surface, on whose negative side it comes or not; `None` if the surface bounds no
    /// clear solid.
    pub fn boundary(&self, media: Media, surface: u32, from_negative: bool) -> Option<Boundary> {
        let bit = self.of_surface[surface as usize]?;
        let is_inside = from_negative == self.list[bit as usize].1.inside_is_negative;
        // The surface itself knows better than the bit: a ray may have come in through an open cut.
        let before = self.with(media, surface, is_inside);
        let after = self.with(media, surface, !is_inside);
        let is_there = self.filling(before).map(|f| f.0) != self.filling(after).map(|f| f.0);
        Some(Boundary { before, after, relative_ior: is_there.then(|| self.ior(after) / self.ior(before)) })
    }
}

/// The share of light that is left after a way through a medium (Beer and Lambert).
pub fn transmittance(absorption: DVec3, length: f64) -> DVec3 {
    if absorption == DVec3::ZERO || length <= 0.0 {
        return DVec3::ONE;
    }
    let left = |a: f64| if a == 0.0 { 1.0 } else { native::exp(-a * length) };
    DVec3::new(left(absorption.x), left(absorption.y), left(absorption.z))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn glass(ior: f64, priority: u32) -> Material {
        let dielectric = Dielectric { ior, absorption: DVec3::ZERO, inside_is_negative: true, priority };
        Material { kind: Kind::Glass(dielectric), ..Material::matte(DVec3::ONE) }
    }

    #[test]
    fn the_solid_of_highest_priority_fills_the_place() {
        let solids = Solids::new(&[glass(1.5, 2), Material::matte(DVec3::ONE), glass(1.33, 1)]);
        let outside = Media::default();
        assert_eq!(solids.boundary(outside, 1, false), None);
        let into_water = solids.boundary(outside, 2, false).unwrap();
        assert_eq!(into_water.relative_ior, Some(1.33));
        let into_glass = solids.boundary(into_water.after, 0, false).unwrap();
        assert_eq!(into_glass.relative_ior, Some(1.5 / 1.33));
        // Inside the glass the water's surface is not there.
        let out_of_water = solids.boundary(into_glass.after, 2, true).unwrap();
        assert_eq!(out_of_water.relative_ior, None);
        let out_of_glass = solids.boundary(out_of_water.after, 0, true).unwrap();
        assert_eq!((out_of_glass.relative_ior, out_of_glass.after), (Some(1.0 / 1.5), outside));
    }

    #[test]
    fn light_falls_by_a_power_of_e_a_unit() {
        let left = transmittance(DVec3::new(0.0, 1.0, 2.0), 0.5);
        assert!((left - DVec3::new(1.0, 0.606_530_659_712_633_4, 0.367_879_441_171_442_33)).length() < 1e-15);
    }
}
