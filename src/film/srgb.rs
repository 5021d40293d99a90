//! Linear light to the eight bits a screen shows.
//!
//! In: linear light of 0..=1. Out: the byte whose light is nearest in sRGB steps. The encoding looks into a table of
//! thresholds made by the decoding, so that the two are inverse by construction and no power is taken a pixel.

use crate::num::level::{Simd, for_each_level};
use crate::scene::colour::linear_from_srgb_by;
use std::sync::LazyLock;

/// Light up to this is black: it is darker than the first threshold.
const DARKEST: f32 = 1.0 / 8192.0;

/// How many of the last bits of a light do not tell its slot: there are 128 slots from one power of two to the next, each so
/// narrow that it holds one threshold at most.
const SHIFT: u32 = 16;

/// How many slots there are.
const SLOTS: usize = slot(1.0) + 1;

/// Lights that are nearly the same.
#[derive(Clone, Copy, Debug)]
struct Slot {
    /// The byte of its darkest light.
    byte: u8,
    /// The light halfway to the next byte on sRGB's own scale; +∞ behind the last.
    threshold: f32,
}

static TABLE: LazyLock<[Slot; SLOTS]> = LazyLock::new(|| {
    let thresholds = thresholds(Simd::best());
    let mut byte = 0;
    std::array::from_fn(|k| {
        let darkest = f32::from_bits(DARKEST.to_bits() + ((k as u32) << SHIFT));
        while byte < 255 && thresholds[byte] < darkest {
            byte += 1;
        }
        Slot { byte: byte as u8, threshold: thresholds.get(byte).copied().unwrap_or(f32::INFINITY) }
    })
});

for_each_level! {
    /// The light halfway between byte k and byte k + 1 on sRGB's own scale.
    fn thresholds[L]() -> [f32; 255] {
        std::array::from_fn(|k| linear_from_srgb_by::<L>((k as f64 + 0.5) / 255.0) as f32)
    }
}

/// The slot of a light of [`DARKEST`]..=1.
const fn slot(light: f32) -> usize {
    ((light.to_bits() - DARKEST.to_bits()) >> SHIFT) as usize
}

/// The byte of a linear light; what is outside 0..=1 is clamped, NaN is black.
#[inline]
pub fn byte_from_linear(light: f32) -> u8 {
    // What is no number is not above anything.
    let light = if light > DARKEST { light.min(1.0) } else { DARKEST };
    let Slot { byte, threshold } = TABLE[slot(light)];
    byte + u8::from(threshold < light)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::colour::linear_from_srgb;

    fn byte_by_search(light: f32) -> u8 {
        thresholds(Simd::best()).partition_point(|&threshold| threshold < light) as u8
    }

    #[test]
    fn encoding_changes_at_the_thresholds_only() {
        for (byte, threshold) in (0..=255).zip(thresholds(Simd::best())) {
            assert_eq!((byte_from_linear(threshold), byte_from_linear(threshold.next_up())), (byte, byte + 1));
        }
        let edges = (0..SLOTS as u32).map(|k| f32::from_bits(DARKEST.to_bits() + (k << SHIFT)));
        for edge in edges {
            assert_eq!(byte_from_linear(edge), byte_by_search(edge), "{edge}");
            assert_eq!(byte_from_linear(edge.next_down()), byte_by_search(edge.next_down()), "{edge}");
        }
    }

    #[test]
    fn encoding_inverts_decoding() {
        for byte in 0..=255u8 {
            assert_eq!(byte_from_linear(linear_from_srgb(f64::from(byte) / 255.0) as f32), byte);
        }
    }

    #[test]
    fn encoding_is_the_nearest_byte() {
        for k in 0..=100_000u32 {
            let light = k as f32 / 100_000.0;
            let l = f64::from(light);
            let s = if l <= 0.003_130_8 { 12.92 * l } else { 1.055 * l.powf(1.0 / 2.4) - 0.055 };
            assert!((f64::from(byte_from_linear(light)) - s * 255.0).abs() < 0.501, "{light}");
            assert_eq!(byte_from_linear(light), byte_by_search(light));
        }
    }

    #[test]
    fn light_outside_the_range_is_clamped() {
        for (light, byte) in [(-1.0, 0), (2.0, 255), (f32::INFINITY, 255), (f32::NEG_INFINITY, 0), (f32::NAN, 0)] {
            assert_eq!(byte_from_linear(light), byte);
        }
    }
}
