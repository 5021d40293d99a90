//! PNG: eight bits a channel, sRGB, with notes on what it shows.
//!
//! In: a layer, how its values are to be shown, notes. Out: the bytes of a PNG file, the same for the same layer; and
//! from such bytes the notes.

use super::{EncodeError, Print};
use ::png::text_metadata::ITXtChunk;
use ::png::{BitDepth, ColorType, Compression, DecodeOptions, Decoder, Encoder, Limits, SrgbRenderingIntent};
use std::fmt;
use std::io::{Cursor, Write};

/// A note of a picture has at most so many bytes: a program text of the longest that are read, and some more.
pub const MAX_NOTE: usize = (1 << 20) + (1 << 12);

/// What a file's reader may allocate: notes and one line of the largest picture.
const READ_LIMIT: usize = 1 << 28;

/// The first bytes of every PNG file.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Encodes a picture as a PNG file.
///
/// # Errors
/// If the encoder refuses; it has no reason to, the size being checked.
pub fn encode(print: &Print<'_>) -> Result<Vec<u8>, EncodeError> {
    encode_with(print, &[])
}

/// Encodes a picture as a PNG file that carries notes, each a keyword (1 to 79 letters) and a text.
///
/// # Errors
/// If a keyword is none.
pub fn encode_with(print: &Print<'_>, notes: &[(&str, String)]) -> Result<Vec<u8>, EncodeError> {
    let mut bytes = Vec::new();
    write(print, notes, &mut bytes).map_err(|e| EncodeError { message: e.to_string() })?;
    Ok(bytes)
}

fn write(print: &Print<'_>, notes: &[(&str, String)], bytes: &mut Vec<u8>) -> Result<(), ::png::EncodingError> {
    let mut encoder = Encoder::new(bytes, print.picture.size.width(), print.picture.size.height());
    encoder.set_color(if print.is_clear() { ColorType::Rgba } else { ColorType::Rgb });
    encoder.set_depth(BitDepth::Eight);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    encoder.set_compression(Compression::Fast);
    for (keyword, text) in notes {
        encoder.add_itxt_chunk((*keyword).to_owned(), text.clone())?;
    }
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer()?;
    let mut row = Vec::new();
    for j in 0..print.picture.size.height() as usize {
        print.row(j, &mut row);
        stream.write_all(&row)?;
    }
    stream.finish()?;
    writer.finish()
}

/// Why a file's notes cannot be read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ReadError {
    /// It does not start as a PNG file does.
    NotPng,
    /// It is cut off, or its check sums are wrong.
    Damaged,
    /// The note is longer than [`MAX_NOTE`].
    TooLong,
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ReadError::NotPng => f.write_str("it is no PNG file"),
            ReadError::Damaged => f.write_str("it is a damaged PNG file, or only the beginning of one"),
            ReadError::TooLong => write!(f, "its note is longer than {MAX_NOTE} bytes"),
        }
    }
}

impl std::error::Error for ReadError {}

/// The note with this keyword in a PNG file, if it has one; the whole file must be sound.
///
/// # Errors
/// If it is no PNG file, or a damaged one.
pub fn note(bytes: &[u8], keyword: &str) -> Result<Option<String>, ReadError> {
    if !bytes.starts_with(SIGNATURE) {
        return Err(ReadError::NotPng);
    }
    let mut options = DecodeOptions::default();
    options.set_skip_ancillary_crc_failures(false);
    let mut decoder = Decoder::new_with_options(Cursor::new(bytes), options);
    decoder.set_limits(Limits { bytes: READ_LIMIT });
    let mut reader = decoder.read_info().map_err(|_| ReadError::Damaged)?;
    reader.finish().map_err(|_| ReadError::Damaged)?;
    reader.info().utf8_text.iter().find(|note| note.keyword == keyword).map(text).transpose()
}

fn text(note: &ITXtChunk) -> Result<String, ReadError> {
    let mut note = note.clone();
    note.decompress_text_with_limit(MAX_NOTE).map_err(|_| ReadError::TooLong)?;
    let text = note.get_text().map_err(|_| ReadError::Damaged)?;
    if text.len() > MAX_NOTE { Err(ReadError::TooLong) } else { Ok(text) }
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
        let mut reader = Decoder::new(Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height, info.color_type), (70, 41, ColorType::Rgb));
        let expected = Print::new(&picture, Tone::Linear).bytes();
        assert_eq!(pixels[..expected.len()], expected);
    }

    #[test]
    fn clear_pixels_stay_clear() {
        Print::half_clear(|print| {
            let mut reader = Decoder::new(Cursor::new(encode(print).unwrap())).read_info().unwrap();
            let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
            assert_eq!(reader.next_frame(&mut pixels).unwrap().color_type, ColorType::Rgba);
            assert_eq!(pixels[..print.bytes().len()], print.bytes());
        });
    }

    #[test]
    fn notes_read_back_from_whole_files_only() {
        let picture = Layer::sample(Size::new(9, 5).unwrap());
        let said = "x² + y² = 1 // ∛\n".to_owned();
        let bytes =
            encode_with(&Print::new(&picture, Tone::Linear), &[("implicit", said.clone()), ("b", "c".into())]).unwrap();
        assert_eq!(note(&bytes, "implicit"), Ok(Some(said)));
        assert_eq!(note(&bytes, "b"), Ok(Some("c".into())));
        assert_eq!(note(&bytes, "d"), Ok(None));
        assert_eq!(note(&encode(&Print::new(&picture, Tone::Linear)).unwrap(), "implicit"), Ok(None));
        for length in 0..SIGNATURE.len() {
            assert_eq!(note(&bytes[..length], "implicit"), Err(ReadError::NotPng), "{length}");
        }
        for length in SIGNATURE.len()..bytes.len() {
            assert_eq!(note(&bytes[..length], "implicit"), Err(ReadError::Damaged), "{length}");
        }
    }

    #[test]
    fn notes_that_unpack_to_too_much_are_refused() {
        let mut bytes = Vec::new();
        let mut encoder = Encoder::new(&mut bytes, 1, 1);
        encoder.set_color(ColorType::Rgb);
        let mut writer = encoder.write_header().unwrap();
        let mut bomb = ITXtChunk::new("implicit", "x".repeat(MAX_NOTE + 1));
        bomb.compressed = true;
        bomb.compress_text().unwrap();
        writer.write_text_chunk(&bomb).unwrap();
        writer.write_image_data(&[0; 3]).unwrap();
        writer.finish().unwrap();
        assert!(bytes.len() < 10_000);
        assert_eq!(note(&bytes, "implicit"), Err(ReadError::TooLong));
    }
}
