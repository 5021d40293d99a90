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
    if print.is_clear() {
        return Ok(with_alpha(print));
    }
    let mut file = Cursor::new(Vec::new());
    let size = print.picture.size;
    TiffEncoder::new(&mut file)
        .write_image(&print.bytes(), size.width(), size.height(), ExtendedColorType::Rgb8)
        .map_err(|e| EncodeError { message: e.to_string() })?;
    Ok(file.into_inner())
}

/// Kinds of values in a directory (TIFF 6.0, section 2).
const SHORT: u16 = 3;
const LONG: u16 = 4;
const RATIONAL: u16 = 5;

/// A file of one strip and four channels. The encoder above writes four channels too, but not what the fourth is, so that readers
/// have to guess.
fn with_alpha(print: &Print<'_>) -> Vec<u8> {
    let (width, height) = (print.picture.size.width(), print.picture.size.height());
    const HEADER: u32 = 8;
    const ENTRIES: u32 = 14;
    // Behind the directory: the bits of four channels, a resolution, the pixels.
    let bits = HEADER + 2 + ENTRIES * 12 + 4;
    let (resolution, pixels) = (bits + 8, bits + 16);
    let entries: [(u16, u16, u32, u32); ENTRIES as usize] = [
        (256, LONG, 1, width),
        (257, LONG, 1, height),
        (258, SHORT, 4, bits),
        (259, SHORT, 1, 1),
        (262, SHORT, 1, 2),
        (273, LONG, 1, pixels),
        (277, SHORT, 1, 4),
        (278, LONG, 1, height),
        (279, LONG, 1, width * height * 4),
        (282, RATIONAL, 1, resolution),
        (283, RATIONAL, 1, resolution),
        (284, SHORT, 1, 1),
        (296, SHORT, 1, 1),
        // Alpha that colours are not multiplied by.
        (338, SHORT, 1, 2),
    ];
    let mut bytes = b"II*\0".to_vec();
    bytes.extend(HEADER.to_le_bytes());
    bytes.extend((ENTRIES as u16).to_le_bytes());
    for (tag, kind, count, value) in entries {
        bytes.extend(tag.to_le_bytes());
        bytes.extend(kind.to_le_bytes());
        bytes.extend(count.to_le_bytes());
        bytes.extend(value.to_le_bytes());
    }
    bytes.extend(0u32.to_le_bytes());
    bytes.extend([8u16; 4].into_iter().flat_map(u16::to_le_bytes));
    bytes.extend([1u32; 2].into_iter().flat_map(u32::to_le_bytes));
    bytes.extend(print.bytes());
    bytes
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

    #[test]
    fn clear_pixels_stay_clear() {
        Print::half_clear(|print| {
            let bytes = encode(print).unwrap();
            let reader = Reader(&bytes);
            // Extra samples of kind 2: alpha that colours are not multiplied by (section 18).
            assert_eq!((reader.field(258), reader.field(338)), (vec![8; 4], vec![2]));
            let strips = reader.field(273).into_iter().zip(reader.field(279));
            let pixels: Vec<u8> = strips.flat_map(|(at, length)| bytes[at..at + length].to_vec()).collect();
            assert_eq!(pixels, print.bytes());
        });
    }
}
