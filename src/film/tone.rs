//! From linear light to what is shown: with a curve where light was computed, as it is where data is shown.
//!
//! In: linear light that may exceed 1, or values of 0..=1. Out: bytes for the screen.

use super::srgb::byte_from_linear;
use crate::num::func;
use crate::num::level::Portable;

/// How values become bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tone {
    /// Linear light of 0..=1, encoded in sRGB.
    #[default]
    Linear,
    /// Linear light of any strength through a curve that keeps hues and rolls highlights off, then sRGB.
    Neutral,
    /// Linear light of any strength through a curve like that of film, in which bright colours become pale, then sRGB.
    Agx,
    /// Values that are what the screen is to show: no encoding.
    Data,
}

impl Tone {
    /// The curves that can be asked for, with the words that name them.
    pub const CURVES: [(&'static str, Tone); 3] =
        [("neutral", Tone::Neutral), ("agx", Tone::Agx), ("none", Tone::Linear)];

    /// The curve of a name.
    pub fn from_name(name: &str) -> Option<Tone> {
        Tone::CURVES.into_iter().find(|(word, _)| *word == name).map(|(_, tone)| tone)
    }

    /// The bytes of one pixel.
    #[inline]
    pub fn bytes(self, pixel: [f32; 3]) -> [u8; 3] {
        match self {
            Tone::Linear | Tone::Neutral | Tone::Agx => {
                // Written out: a map over an array stays a call, and there are millions of pixels.
                let [r, g, b] = self.light(pixel);
                [byte_from_linear(r), byte_from_linear(g), byte_from_linear(b)]
            }
            Tone::Data => pixel.map(|value| (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8),
        }
    }

    /// The light that a screen is to show, of 0..=1.
    #[inline]
    pub fn light(self, pixel: [f32; 3]) -> [f32; 3] {
        match self {
            Tone::Linear | Tone::Data => {
                let [r, g, b] = pixel;
                [r.clamp(0.0, 1.0), g.clamp(0.0, 1.0), b.clamp(0.0, 1.0)]
            }
            Tone::Neutral => neutral(pixel),
            Tone::Agx => agx(pixel),
        }
    }
}

/// The matrices of AgX, by rows: into the space where the curve acts on each part alone, and back.
const AGX_INSET: [[f64; 3]; 3] = [
    [0.842479062253094, 0.0784335999999992, 0.0792237451477643],
    [0.0423282422610123, 0.878468636469772, 0.0791661274605434],
    [0.0423756549057051, 0.0784336, 0.879142973793104],
];
const AGX_OUTSET: [[f64; 3]; 3] = [
    [1.19687900512017, -0.0980208811401368, -0.0990297440797205],
    [-0.0528968517574562, 1.15190312990417, -0.0989611768448433],
    [-0.0529716355144438, -0.0980434501171241, 1.15107367264116],
];

/// The darkest and the brightest light that the curve tells apart, in stops.
const AGX_STOPS: (f64, f64) = (-12.47393, 4.026069);

/// Its contrast as a polynomial of the place between them, the constant first.
const AGX_CONTRAST: [f64; 7] = [-0.00232, 0.1191, 0.4298, -6.868, 31.96, -40.14, 15.5];

/// The AgX curve (Troy Sobotka 2022), by the matrices and the polynomial that Benjamin Wrensch published for it ("Minimal AgX
/// Implementation", 2023): base contrast, no look.
fn agx(pixel: [f32; 3]) -> [f32; 3] {
    let times = |matrix: &[[f64; 3]; 3], v: [f64; 3]| matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
    let inset = times(&AGX_INSET, pixel.map(|light| f64::from(light.max(0.0))));
    let curved = inset.map(|light| {
        let (darkest, brightest) = AGX_STOPS;
        let stops = if light > 0.0 { func::log2::<Portable>(light).clamp(darkest, brightest) } else { darkest };
        let place = (stops - darkest) / (brightest - darkest);
        AGX_CONTRAST.iter().rev().fold(0.0, |sum, coefficient| sum * place + coefficient)
    });
    let shown = times(&AGX_OUTSET, curved);
    // The result is meant for a screen of exponent 2.2.
    shown.map(|value| if value > 0.0 { func::pow::<Portable>(value.min(1.0), 2.2) as f32 } else { 0.0 })
}

/// The "PBR Neutral" tone curve, from the formula and constants that the Khronos Group published in 2024
/// (Khronos PBR Neutral Tone Mapper, specification version 1.0).
fn neutral(pixel: [f32; 3]) -> [f32; 3] {
    const FRESNEL: f32 = 0.04;
    const START: f32 = 0.8 - FRESNEL;
    const DESATURATION: f32 = 0.15;
    let [r, g, b] = pixel.map(|light| light.max(0.0));
    let least = r.min(g).min(b);
    let offset = if least < 2.0 * FRESNEL { least - least * least / (4.0 * FRESNEL) } else { FRESNEL };
    let shifted = [r - offset, g - offset, b - offset];
    let peak = shifted[0].max(shifted[1]).max(shifted[2]);
    if peak < START {
        return shifted;
    }
    let rest = 1.0 - START;
    let new_peak = 1.0 - rest * rest / (peak + rest - START);
    let white = 1.0 - 1.0 / (DESATURATION * (peak - new_peak) + 1.0);
    shifted.map(|light| {
        let scaled = light * (new_peak / peak);
        scaled + (new_peak - scaled) * white
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_is_the_published_one() {
        // Below the compression only the offset is taken away; far above, everything tends to white.
        assert_eq!(neutral([0.5, 0.5, 0.5]), [0.46, 0.46, 0.46]);
        assert_eq!(neutral([0.0, 0.0, 0.0]), [0.0, 0.0, 0.0]);
        let [r, g, b] = neutral([1000.0, 500.0, 0.0]);
        assert!(r > 0.999 && r <= 1.0 && g > 0.95 && b > 0.95, "{r} {g} {b}");
    }

    #[test]
    fn brighter_light_never_becomes_darker() {
        for (name, tone) in Tone::CURVES {
            let mut last = 0;
            for k in 0..4000u16 {
                let byte = tone.bytes([f32::from(k) / 200.0; 3])[0];
                assert!(byte >= last, "{name}: {k}");
                last = byte;
            }
        }
    }

    #[test]
    fn agx_keeps_greys_grey_and_lets_bright_colours_fade() {
        // Middle grey comes out near the middle of the screen's scale, as AgX is made for.
        let [r, g, b] = Tone::Agx.bytes([0.18; 3]);
        assert!(r.abs_diff(g) <= 1 && g.abs_diff(b) <= 1 && (110..=130).contains(&g), "{r} {g} {b}");
        assert!(Tone::Agx.bytes([0.0; 3]).into_iter().all(|byte| byte <= 1));
        assert!(Tone::Agx.bytes([16.3; 3]).into_iter().all(|byte| byte >= 252));
        let (dim, bright) = (Tone::Agx.bytes([0.2, 0.0, 0.0]), Tone::Agx.bytes([200.0, 0.0, 0.0]));
        assert!(dim[1] < 60 && bright[1] > 120, "{dim:?} {bright:?}");
        assert_eq!(Tone::Agx.bytes([f32::NAN, -1.0, f32::INFINITY]).len(), 3);
    }

    #[test]
    fn data_is_shown_as_it_is() {
        assert_eq!(Tone::Data.bytes([0.0, 0.5, 1.0]), [0, 128, 255]);
        assert_eq!(Tone::Data.bytes([-1.0, f32::NAN, 7.0]), [0, 0, 255]);
    }
}
