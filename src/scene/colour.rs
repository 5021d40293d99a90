//! Colours as linear light, and those of surfaces that were given none.
//!
//! In: bytes of sRGB, or which of how many surfaces it is. Out: red, green, blue of linear light with sRGB primaries.

use super::texture::Texture;
use crate::num::func;
use crate::num::level::{Level, Portable};
use glam::DVec3;

/// Hues after Okabe and Ito, "Color Universal Design" (2008), which people of every kind of colour vision tell apart; a
/// little less pure than theirs, so that light and shade show on them, and lighter where that keeps them apart. The most
/// distant come first; the first two are the sides of a surface that is alone.
const PALETTE: [[u8; 3]; 7] =
    [[86, 158, 212], [240, 172, 80], [48, 208, 140], [170, 88, 132], [200, 84, 40], [26, 92, 152], [240, 234, 92]];

/// How much of the front's light the back of a coloured surface keeps: enough to tell the hue, too little to mix them up.
const BACK_SHARE: f64 = 0.5;

/// How far the back of a coloured surface goes towards grey.
const BACK_GREY: f64 = 0.35;

/// The two sides of a surface.
#[derive(Clone, Debug)]
pub struct Sides {
    /// Where f is positive: the outside.
    pub front: DVec3,
    /// Where f is negative.
    pub back: DVec3,
    /// The colour of the outside, where it changes from point to point.
    pub paint: Option<Texture>,
    /// What is left of the colour under contour lines.
    pub lines: Option<Texture>,
    /// Whether the outside is where f is negative.
    pub is_turned: bool,
}

impl Sides {
    /// The sides of a surface of one colour: its back is the same hue, darker and greyer.
    pub fn of(front: DVec3) -> Self {
        Sides::plain(front, back_of(front))
    }

    fn plain(front: DVec3, back: DVec3) -> Self {
        Sides { front, back, paint: None, lines: None, is_turned: false }
    }

    /// Whether the colours change from point to point.
    pub fn is_varying(&self) -> bool {
        self.paint.is_some() || self.lines.is_some()
    }

    /// The colours at points of the surface, each with whether it is seen from where f is negative; `out` is replaced.
    pub fn colours(&self, points: &[DVec3], is_negative: &[bool], out: &mut Vec<DVec3>) {
        out.clear();
        match &self.paint {
            None => out.extend(is_negative.iter().map(|&negative| if negative { self.back } else { self.front })),
            Some(paint) => {
                paint.values(points, out);
                for (colour, &negative) in out.iter_mut().zip(is_negative) {
                    if negative != self.is_turned {
                        *colour = back_of(*colour);
                    }
                }
            }
        }
        if let Some(lines) = &self.lines {
            let mut left = Vec::new();
            lines.values(points, &mut left);
            out.iter_mut().zip(&left).for_each(|(colour, left)| *colour *= *left);
        }
    }

    /// The sides of the surface of this index where none of `count` was given a colour: alone it is blue outside
    /// and orange inside, in company each has a hue of its own.
    pub fn by_default(index: usize, count: usize) -> Self {
        if count == 1 {
            return Sides::plain(from_bytes(PALETTE[0]), from_bytes(PALETTE[1]));
        }
        Sides::of(from_bytes(PALETTE[index % PALETTE.len()]))
    }
}

/// The back of a coloured surface.
fn back_of(front: DVec3) -> DVec3 {
    let grey = DVec3::splat((front.x + front.y + front.z) / 3.0);
    front.lerp(grey, BACK_GREY) * BACK_SHARE
}

/// The linear light of an sRGB value of 0..=1 (IEC 61966-2-1).
pub fn linear_from_srgb(value: f64) -> f64 {
    linear_from_srgb_by::<Portable>(value)
}

/// The same by the instructions of a level, for who needs many.
#[inline(always)]
pub fn linear_from_srgb_by<L: Level>(value: f64) -> f64 {
    if value <= 0.04045 { value / 12.92 } else { func::pow::<L>((value + 0.055) / 1.055, 2.4) }
}

/// The linear light of three sRGB bytes.
pub fn from_bytes(bytes: [u8; 3]) -> DVec3 {
    DVec3::from_array(bytes.map(|byte| linear_from_srgb(f64::from(byte) / 255.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decoding_follows_the_standard() {
        for k in 0..=1000 {
            let s = f64::from(k) / 1000.0;
            let expected = if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) };
            assert!((linear_from_srgb(s) - expected).abs() < 1e-15);
        }
    }

    /// Linear light as seen by eyes without red, green or blue cones (Machado, Oliveira and Fernandes 2009, "A
    /// physiologically-based model for simulation of color vision deficiency", table 1, severity 1), and by others.
    const VISIONS: [[[f64; 3]; 3]; 4] = [
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    ];

    fn seen(by: &[[f64; 3]; 3], colour: DVec3) -> DVec3 {
        DVec3::from_array(by.map(|row| DVec3::from_array(row).dot(colour))).clamp(DVec3::ZERO, DVec3::ONE)
    }

    /// CIE 1976 L*a*b* under the white of sRGB (CIE 15:2004, section 8.2.1; matrix of IEC 61966-2-1).
    fn lab(colour: DVec3) -> DVec3 {
        let x = DVec3::new(0.4124, 0.3576, 0.1805).dot(colour) / 0.9505;
        let y = DVec3::new(0.2126, 0.7152, 0.0722).dot(colour);
        let z = DVec3::new(0.0193, 0.1192, 0.9505).dot(colour) / 1.0890;
        let f = |t: f64| if t > 216.0 / 24389.0 { t.cbrt() } else { (24389.0 / 27.0 * t + 16.0) / 116.0 };
        DVec3::new(116.0 * f(y) - 16.0, 500.0 * (f(x) - f(y)), 200.0 * (f(y) - f(z)))
    }

    /// The least difference between two of the colours for any vision; 2.3 is just noticeable side by side (Mahy et
    /// al. 1994, "Evaluation of uniform color spaces developed after the adoption of CIELAB and CIELUV").
    fn least_difference(colours: &[DVec3]) -> f64 {
        let mut least = f64::INFINITY;
        for by in &VISIONS {
            for (k, &a) in colours.iter().enumerate() {
                for &b in &colours[..k] {
                    least = least.min(lab(seen(by, a)).distance(lab(seen(by, b))));
                }
            }
        }
        least
    }

    #[test]
    fn lightness_of_white_grey_and_black_is_known() {
        for (light, lightness) in [(0.0, 0.0), (1.0, 100.0), (0.18, 49.5)] {
            assert!((lab(DVec3::splat(light)) - DVec3::X * lightness).length() < 0.1);
        }
    }

    #[test]
    fn the_two_sides_of_a_surface_are_far_apart_for_every_colour_vision() {
        let Sides { front, back, .. } = Sides::by_default(0, 1);
        assert!(least_difference(&[front, back]) > 70.0);
    }

    #[test]
    fn several_surfaces_are_told_apart_with_every_colour_vision() {
        let fronts: Vec<DVec3> = (0..7).map(|index| Sides::by_default(index, 7).front).collect();
        assert!(least_difference(&fronts[..2]) > 70.0);
        assert!(least_difference(&fronts[..4]) > 18.0, "{}", least_difference(&fronts[..4]));
        assert!(least_difference(&fronts) > 16.0, "{}", least_difference(&fronts));
    }
}
