//! TIFF: eight bits a channel, sRGB, uncompressed: what every reader knows.
//!
//! In: a layer and how its values are to be shown. Out: the bytes of a TIFF file, the same for the same layer.

use super::{EncodeError, Print};
use ::image::codecs::tiff::TiffEncoder;
use ::image::{ExtendedColorType, ImageEncoder};
use std::io::Cursor;

/// Encodes a picture as a TIFF file.
///
/// # Errors
/// If the encoder refuses; it has no reason to, the size being checked.
pub fn encode(print: &Print<'_>) -> Result<Vec<u8>, EncodeError> {
    let mut file = Cursor::new(Vec::new());
    let size = print.picture.size;
    let channels = if print.is_clear() { ExtendedColorType::Rgba8 } else { ExtendedColorType::Rgb8 };
    TiffEncoder::new(&mut file)
        .write_image(&print.bytes(), size.width(), size.height(), channels)
        .map_err(|e| EncodeError { message: e.to_string() })?;
    Ok(file.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::{Layer, Size, Tone};

    /// A file of little-endian numbers, read as TIFF 6.0 describes it (Adobe 1992, sections 2, 3 and 6).
    struct Reader<'a>(&'a [u8]);

    impl Reader<'_> {
        fn number(&self, at: usize, bytes: usize) -> usize {
            self.0[at..at + bytes].iter().rev().fold(0, |n, &byte| n << 8 | usize::from(byte))
        }

        /// The values of a field in the first directory.
        fn field(&self, tag: usize) -> Vec<usize> {
            let directory = self.number(4, 4);
            let entries = (0..self.number(directory, 2)).map(|k| directory + 2 + 12 * k);
            let entry = entries.into_iter().find(|&at| self.number(at, 2) == tag).unwrap();
            let width = [0, 1, 1, 2, 4][self.number(entry + 2, 2)];
            let count = self.number(entry + 4, 4);
            let place = if width * count <= 4 { entry + 8 } else { self.number(entry + 8, 4) };
            (0..count).map(|k| self.number(place + k * width, width)).collect()
        }
    }

    #[test]
    fn what_is_written_reads_back() {
        let picture = Layer::sample(Size::new(70, 41).unwrap());
        let bytes = encode(&Print::new(&picture, Tone::Linear)).unwrap();
        assert_eq!(bytes, encode(&Print::new(&picture, Tone::Linear)).unwrap());
        assert!(bytes.starts_with(b"II*\0"));
        let reader = Reader(&bytes);
        let [width, length, compression, photometric] = [256, 257, 259, 262].map(|tag| reader.field(tag)[0]);
        assert_eq!((width, length, compression, photometric), (70, 41, 1, 2));
        assert_eq!(reader.field(258), [8, 8, 8]);
        let strips = reader.field(273).into_iter().zip(reader.field(279));
        let pixels: Vec<u8> = strips.flat_map(|(at, length)| bytes[at..at + length].to_vec()).collect();
        assert_eq!(pixels, Print::new(&picture, Tone::Linear).bytes());
    }
}
