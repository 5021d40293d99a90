//! WebP: eight bits a channel, sRGB, lossless.
//!
//! In: a layer and how its values are to be shown. Out: the bytes of a WebP file, the same for the same layer.

use super::{EncodeError, Print};
use ::image::ExtendedColorType;
use ::image::codecs::webp::WebPEncoder;

/// A side less one has 14 bits in the file (RFC 9649, section 3.4).
pub const MAX_SIDE: u32 = 1 << 14;

/// Encodes a picture as a WebP file.
///
/// # Errors
/// If a side is longer than [`MAX_SIDE`].
pub fn encode(print: &Print<'_>) -> Result<Vec<u8>, EncodeError> {
    let mut bytes = Vec::new();
    let size = print.picture.size;
    let channels = if print.is_clear() { ExtendedColorType::Rgba8 } else { ExtendedColorType::Rgb8 };
    WebPEncoder::new_lossless(&mut bytes)
        .encode(&print.bytes(), size.width(), size.height(), channels)
        .map_err(|e| EncodeError { message: e.to_string() })?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::{Layer, Size, Tone};

    #[test]
    fn what_is_written_reads_back() {
        let picture = Layer::sample(Size::new(70, 41).unwrap());
        let bytes = encode(&Print::new(&picture, Tone::Linear)).unwrap();
        assert_eq!(bytes, encode(&Print::new(&picture, Tone::Linear)).unwrap());
        let read = ::image::load_from_memory(&bytes).unwrap().into_rgb8();
        assert_eq!(read.dimensions(), (70, 41));
        assert_eq!(read.into_raw(), Print::new(&picture, Tone::Linear).bytes());
    }

    #[test]
    fn clear_pixels_stay_clear() {
        Print::half_clear(|print| {
            let read = ::image::load_from_memory(&encode(print).unwrap()).unwrap().into_rgba8();
            assert_eq!(read.into_raw(), print.bytes());
        });
    }

    #[test]
    fn sides_that_do_not_fit_are_refused() {
        let picture = Layer::filled(Size::new(u64::from(MAX_SIDE) + 1, 1).unwrap(), [0.0; 3]);
        assert!(encode(&Print::new(&picture, Tone::Linear)).is_err());
    }
}
