//! A picture as it is to be shown: light made brighter or darker, a tone curve, and what lies behind where it is clear.
//!
//! In: layers of light and of how much of each pixel is covered. Out: bytes, with a channel of alpha if the picture stays clear; or
//! linear light. Separate from the encoders, which write what they are given.

use super::srgb::byte_from_linear;
use super::{Layer, Tone};
use crate::num::func;
use crate::num::level::Portable;

/// A picture and how it is shown.
#[derive(Clone, Copy, Debug)]
pub struct Print<'a> {
    /// Light, or data as the tone says; where a pixel is covered in part, that share of it.
    pub picture: &'a Layer<[f32; 3]>,
    /// The share of each pixel that is covered, of 0..=1; `None`: all of all.
    pub alpha: Option<&'a Layer<f32>>,
    /// How light becomes what is seen.
    pub tone: Tone,
    /// What light is multiplied by before.
    pub gain: f32,
    /// The linear light, of 0..=1, of what lies behind; it has no tone curve. `None`: clear pixels stay clear.
    pub behind: Option<[f32; 3]>,
}

impl<'a> Print<'a> {
    /// A picture that covers all.
    pub fn new(picture: &'a Layer<[f32; 3]>, tone: Tone) -> Self {
        Print { picture, alpha: None, tone, gain: 1.0, behind: None }
    }

    /// Whether there are pixels to see through, so that a file needs a channel for that.
    pub fn is_clear(&self) -> bool {
        self.alpha.is_some() && self.behind.is_none()
    }

    /// How many bytes a pixel has.
    pub fn channels(&self) -> usize {
        if self.is_clear() { 4 } else { 3 }
    }

    /// The bytes of all pixels, row by row from the top: red, green, blue, and alpha if it is clear. Colours are not multiplied
    /// by alpha.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = vec![0; self.picture.values.len() * self.channels()];
        self.develop(0, &mut bytes);
        bytes
    }

    /// The bytes of the j-th row from the top; `bytes` is replaced.
    pub fn row(&self, j: usize, bytes: &mut Vec<u8>) {
        let width = self.picture.size.width() as usize;
        bytes.clear();
        bytes.resize(width * self.channels(), 0);
        self.develop(j * width, bytes);
    }

    /// The bytes of pixels from the k-th on, as many as there is room for.
    fn develop(&self, first: usize, bytes: &mut [u8]) {
        let lights = self.picture.values[first..].iter();
        let Some(alpha) = self.alpha else {
            let mut before = ([0; 3], self.whole([0.0; 3]));
            for (&light, bytes) in lights.zip(bytes.chunks_exact_mut(3)) {
                // Much of most pictures is the same as beside it.
                let bits = [light[0].to_bits(), light[1].to_bits(), light[2].to_bits()];
                if bits != before.0 {
                    before = (bits, self.whole(light));
                }
                bytes.copy_from_slice(&before.1);
            }
            return;
        };
        let pixels = lights.zip(&alpha.values[first..]);
        for ((&light, &alpha), bytes) in pixels.zip(bytes.chunks_exact_mut(self.channels())) {
            bytes.copy_from_slice(&self.covered(light, alpha)[..bytes.len()]);
        }
    }

    /// The bytes of a pixel that is covered.
    #[inline]
    fn whole(&self, light: [f32; 3]) -> [u8; 3] {
        let [r, g, b] = light;
        self.tone.bytes([r * self.gain, g * self.gain, b * self.gain])
    }

    /// The bytes of a pixel of which a share is covered.
    fn covered(&self, light: [f32; 3], alpha: f32) -> [u8; 4] {
        let alpha = alpha.clamp(0.0, 1.0);
        let whole = if alpha > 0.0 { light.map(|light| light / alpha * self.gain) } else { [0.0; 3] };
        match self.behind {
            None => {
                let [r, g, b] = self.tone.bytes(whole);
                [r, g, b, (alpha * 255.0 + 0.5) as u8]
            }
            Some(behind) => {
                let front = self.tone.light(whole);
                let [r, g, b] = std::array::from_fn(|c| byte_from_linear(front[c] * alpha + behind[c] * (1.0 - alpha)));
                [r, g, b, 255]
            }
        }
    }

    /// The linear light of all pixels, without tone curve and gain, before what lies behind.
    pub fn light(&self) -> Vec<[f32; 3]> {
        let (Some(alpha), Some(behind)) = (self.alpha, self.behind) else { return self.picture.values.clone() };
        let over = |(light, alpha): (&[f32; 3], &f32)| std::array::from_fn(|c| light[c] + behind[c] * (1.0 - alpha));
        self.picture.values.iter().zip(&alpha.values).map(over).collect()
    }
}

/// What light is multiplied by for so many stops.
pub fn gain(stops: f64) -> f32 {
    if stops == 0.0 { 1.0 } else { func::pow::<Portable>(2.0, stops) as f32 }
}

#[cfg(test)]
impl Print<'_> {
    /// Gives tests of files a picture that is clear in parts: half covered on the left, whole on the right.
    pub(crate) fn half_clear(draw: impl FnOnce(&Print<'_>)) {
        let Ok(size) = super::Size::new(6, 4) else { return };
        let mut alpha = Layer::filled(size, 1.0);
        (0..4).for_each(|j| alpha.set(0, j, 0.5));
        let picture = Layer::filled(size, [0.25, 0.125, 0.0]);
        draw(&Print { alpha: Some(&alpha), ..Print::new(&picture, Tone::Linear) });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Size;

    #[test]
    fn clear_pixels_keep_their_colour_and_say_how_much_of_them_is_there() {
        let size = Size::new(3, 1).unwrap();
        let picture = Layer { size, values: vec![[0.5, 0.25, 0.0], [0.25, 0.125, 0.0], [0.0; 3]] };
        let alpha = Layer { size, values: vec![1.0, 0.5, 0.0] };
        let clear = Print { alpha: Some(&alpha), ..Print::new(&picture, Tone::Linear) };
        let [r, g, b] = Tone::Linear.bytes([0.5, 0.25, 0.0]);
        assert_eq!(clear.bytes(), [r, g, b, 255, r, g, b, 128, 0, 0, 0, 0]);
        assert_eq!(clear.light(), picture.values);
        let on_white = Print { behind: Some([1.0; 3]), ..clear };
        let middle = Tone::Linear.bytes([0.75, 0.625, 0.5]);
        assert_eq!(on_white.bytes(), [[r, g, b], middle, [255; 3]].concat());
        assert_eq!(on_white.light(), [[0.5, 0.25, 0.0], [0.75, 0.625, 0.5], [1.0; 3]]);
    }

    #[test]
    fn a_stop_is_twice_the_light() {
        let picture = Layer::filled(Size::new(1, 1).unwrap(), [0.1, 0.2, 0.3]);
        let brighter = Print { gain: gain(1.0), ..Print::new(&picture, Tone::Neutral) };
        assert_eq!(brighter.bytes(), Tone::Neutral.bytes([0.2, 0.4, 0.6]));
        assert_eq!((gain(0.0), gain(-2.0)), (1.0, 0.25));
        assert_eq!(brighter.light(), picture.values);
    }
}
