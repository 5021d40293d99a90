//! Linear light to the eight bits a screen shows.
//!
//! In: linear light of 0..=1. Out: the byte whose light is nearest in sRGB steps. The encoding searches a table of
//! thresholds made by the decoding, so that the two are inverse by construction and no power is taken a pixel.

use crate::scene::colour::linear_from_srgb;
use std::sync::LazyLock;

/// The light halfway between byte k and byte k + 1 on sRGB's own scale.
static THRESHOLDS: LazyLock<[f32; 255]> =
    LazyLock::new(|| std::array::from_fn(|k| linear_from_srgb((k as f64 + 0.5) / 255.0) as f32));

/// How many slots the start table has; the light of a slot is at most two bytes wide but in the darkest ones.
const SLOTS: usize = 1024;

/// The first byte that light in a slot can have.
static STARTS: LazyLock<[u8; SLOTS + 1]> =
    LazyLock::new(|| std::array::from_fn(|slot| byte_by_search(slot as f32 / SLOTS as f32)));

fn byte_by_search(light: f32) -> u8 {
    THRESHOLDS.partition_point(|&threshold| threshold < light) as u8
}

/// The byte of a linear light; what is outside 0..=1 is clamped, NaN is black.
pub fn byte_from_linear(light: f32) -> u8 {
    let slot = (light * SLOTS as f32).max(0.0).min(SLOTS as f32) as usize;
    let mut byte = STARTS[slot] as usize;
    while byte < 255 && THRESHOLDS[byte] < light {
        byte += 1;
    }
    byte as u8
}

#[cfg(test)]
mod tests {
    use super::*;

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
