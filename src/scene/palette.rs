//! Colours by a number: named maps from 0..=1.
//!
//! In: a name and numbers. Out: linear light. Only maps that are tables or polynomials: the others call the system's sine, whose
//! last bits differ between machines.

use super::colour::from_bytes;
use colorous::Gradient;
use glam::DVec3;
use std::sync::Arc;

/// How many colours of a map are kept; between them light is mixed.
const COLOURS: usize = 256;

/// The maps by name, as `expr::lower::PALETTES` lists them.
const GRADIENTS: [(&str, Gradient); 12] = [
    ("viridis", colorous::VIRIDIS),
    ("magma", colorous::MAGMA),
    ("inferno", colorous::INFERNO),
    ("plasma", colorous::PLASMA),
    ("cividis", colorous::CIVIDIS),
    ("turbo", colorous::TURBO),
    ("greys", colorous::GREYS),
    ("blues", colorous::BLUES),
    ("reds", colorous::REDS),
    ("spectral", colorous::SPECTRAL),
    ("red_blue", colorous::RED_BLUE),
    ("purple_green", colorous::PURPLE_GREEN),
];

/// A map, tabled.
#[derive(Clone, Debug)]
pub struct Palette(Arc<[DVec3]>);

impl Palette {
    /// The map of a name.
    pub fn named(name: &str) -> Option<Palette> {
        let (_, gradient) = GRADIENTS.into_iter().find(|(known, _)| *known == name)?;
        let colour = |k: usize| {
            let colour = gradient.eval_rational(k, COLOURS);
            from_bytes([colour.r, colour.g, colour.b])
        };
        Some(Palette((0..COLOURS).map(colour).collect()))
    }

    /// The colour at a place, moved into 0..=1; of NaN that of 0.
    pub fn at(&self, place: f64) -> DVec3 {
        let scaled = place.clamp(0.0, 1.0) * (COLOURS - 1) as f64;
        let below = (scaled as usize).min(COLOURS - 2);
        self.0[below].lerp(self.0[below + 1], if scaled.is_nan() { 0.0 } else { scaled - below as f64 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_palette_of_the_language_is_there_and_no_other() {
        assert_eq!(GRADIENTS.map(|(name, _)| name), crate::expr::lower::PALETTES);
    }

    #[test]
    fn viridis_begins_violet_and_ends_yellow() {
        let viridis = Palette::named("viridis").unwrap();
        assert_eq!((viridis.at(0.0), viridis.at(-1.0)), (from_bytes([68, 1, 84]), from_bytes([68, 1, 84])));
        assert_eq!((viridis.at(1.0), viridis.at(9.0)), (from_bytes([253, 231, 37]), from_bytes([253, 231, 37])));
        assert_eq!(viridis.at(f64::NAN), viridis.at(0.0));
    }
}
