//! From linear light to what is shown: with a curve where light was computed, as it is where data is shown.
//!
//! In: linear light that may exceed 1, or values of 0..=1. Out: bytes for the screen.

use super::Layer;
use super::srgb::byte_from_linear;

/// How values become bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tone {
    /// Linear light of 0..=1, encoded in sRGB.
    #[default]
    Linear,
    /// Linear light of any strength through a curve that keeps hues and rolls highlights off, then sRGB.
    Neutral,
    /// Values that are what the screen is to show: no encoding.
    Data,
}

impl Tone {
    /// The bytes of one pixel.
    pub fn bytes(self, pixel: [f32; 3]) -> [u8; 3] {
        match self {
            Tone::Linear => pixel.map(byte_from_linear),
            Tone::Neutral => neutral(pixel).map(byte_from_linear),
            Tone::Data => pixel.map(|value| (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8),
        }
    }

    /// The bytes of all pixels, row by row from the top.
    pub fn all_bytes(self, picture: &Layer<[f32; 3]>) -> Vec<u8> {
        picture.values.iter().flat_map(|&pixel| self.bytes(pixel)).collect()
    }
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
        let mut last = 0;
        for k in 0..2000u16 {
            let byte = Tone::Neutral.bytes([f32::from(k) / 200.0; 3])[0];
            assert!(byte >= last);
            last = byte;
        }
    }

    #[test]
    fn data_is_shown_as_it_is() {
        assert_eq!(Tone::Data.bytes([0.0, 0.5, 1.0]), [0, 128, 255]);
        assert_eq!(Tone::Data.bytes([-1.0, f32::NAN, 7.0]), [0, 0, 255]);
    }
}
