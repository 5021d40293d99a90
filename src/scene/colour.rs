//! Colours as linear light, and those of surfaces that were given none.
//!
//! In: bytes of sRGB, or which of how many surfaces it is. Out: red, green, blue of linear light with sRGB primaries.

use crate::num::func;
use crate::num::level::Portable;
use glam::DVec3;

/// The colours of Okabe and Ito, "Color Universal Design" (2008), which people of every kind of colour vision
/// tell apart; black left out, the most distant first.
const PALETTE: [[u8; 3]; 7] =
    [[86, 180, 233], [230, 159, 0], [0, 158, 115], [204, 121, 167], [240, 228, 66], [213, 94, 0], [0, 114, 178]];

/// How much of the front's light the back of a coloured surface keeps: enough to tell the hue, too little to mix them up.
const BACK_SHARE: f64 = 0.45;

/// How far the back of a coloured surface goes towards grey.
const BACK_GREY: f64 = 0.35;

/// The two sides of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sides {
    /// Where f is positive: the outside.
    pub front: DVec3,
    /// Where f is negative.
    pub back: DVec3,
}

impl Sides {
    /// The sides of a surface of one colour: its back is the same hue, darker and greyer.
    pub fn of(front: DVec3) -> Self {
        let grey = DVec3::splat((front.x + front.y + front.z) / 3.0);
        Sides { front, back: front.lerp(grey, BACK_GREY) * BACK_SHARE }
    }

    /// The sides of the surface of this index where none of `count` was given a colour: alone it is blue outside
    /// and orange inside, in company each has a hue of its own.
    pub fn by_default(index: usize, count: usize) -> Self {
        if count == 1 {
            return Sides { front: from_bytes([86, 158, 212]), back: from_bytes([240, 172, 80]) };
        }
        Sides::of(from_bytes(PALETTE[index % PALETTE.len()]))
    }
}

/// The linear light of an sRGB value of 0..=1 (IEC 61966-2-1).
pub fn linear_from_srgb(value: f64) -> f64 {
    if value <= 0.04045 { value / 12.92 } else { func::pow::<Portable>((value + 0.055) / 1.055, 2.4) }
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

    #[test]
    fn neighbours_in_the_palette_differ() {
        for count in 2..=7 {
            for a in 0..count {
                for b in 0..a {
                    let (a, b) = (Sides::by_default(a, count).front, Sides::by_default(b, count).front);
                    assert!((a - b).length() > 0.15);
                }
            }
        }
    }
}
