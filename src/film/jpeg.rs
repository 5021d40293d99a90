//! JPEG: eight bits a channel, sRGB, small and lossy.
//!
//! In: a layer and how its values are to be shown. Out: the bytes of a JPEG file, the same for the same layer.

use super::{EncodeError, Print};
use ::image::ExtendedColorType;
use ::image::codecs::jpeg::JpegEncoder;

/// Of 1 to 100: where edges of surfaces show no rings any more and files are a third of a PNG's.
const QUALITY: u8 = 95;

/// A side has 16 bits in the file (ITU-T T.81, B.2.2).
pub const MAX_SIDE: u32 = u16::MAX as u32;

/// Encodes a picture as a JPEG file.
///
/// # Errors
/// If a side is longer than [`MAX_SIDE`], or the picture is clear in parts.
pub fn encode(print: &Print<'_>) -> Result<Vec<u8>, EncodeError> {
    if print.is_clear() {
        return Err(EncodeError { message: "a JPEG has no clear pixels".into() });
    }
    let mut bytes = Vec::new();
    let size = print.picture.size;
    JpegEncoder::new_with_quality(&mut bytes, QUALITY)
        .encode(&print.bytes(), size.width(), size.height(), ExtendedColorType::Rgb8)
        .map_err(|e| EncodeError { message: e.to_string() })?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::{Layer, Size, Tone};

    #[test]
    fn what_is_written_reads_back_nearly() {
        let picture = Layer::sample(Size::new(70, 41).unwrap());
        let bytes = encode(&Print::new(&picture, Tone::Linear)).unwrap();
        assert_eq!(bytes, encode(&Print::new(&picture, Tone::Linear)).unwrap());
        // The decoder (zune-jpeg) shares no line with the encoder.
        let read = ::image::load_from_memory(&bytes).unwrap().into_rgb8();
        assert_eq!(read.dimensions(), (70, 41));
        let expected = Print::new(&picture, Tone::Linear).bytes();
        let worst = read.as_raw().iter().zip(&expected).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
        assert!(worst <= 12, "{worst}");
    }

    #[test]
    fn clear_pixels_are_refused() {
        Print::half_clear(|print| assert!(encode(print).is_err()));
    }

    #[test]
    fn sides_that_do_not_fit_are_refused() {
        let picture = Layer::filled(Size::new(65_536, 1).unwrap(), [0.0; 3]);
        assert!(encode(&Print::new(&picture, Tone::Linear)).is_err());
    }
}
