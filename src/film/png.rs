//! PNG: eight bits a channel, sRGB.
//!
//! In: a layer and how its values are to be shown. Out: the bytes of a PNG file, the same for the same layer.

use super::{EncodeError, Layer, Tone};
use ::png::{BitDepth, ColorType, Compression, Encoder, SrgbRenderingIntent};
use std::io::Write;

/// Encodes a picture as a PNG file.
///
/// # Errors
/// If the encoder refuses; it has no reason to, the size being checked.
pub fn encode(picture: &Layer<[f32; 3]>, tone: Tone) -> Result<Vec<u8>, EncodeError> {
    let mut bytes = Vec::new();
    write(picture, tone, &mut bytes).map_err(|e| EncodeError { message: e.to_string() })?;
    Ok(bytes)
}

fn write(picture: &Layer<[f32; 3]>, tone: Tone, bytes: &mut Vec<u8>) -> Result<(), ::png::EncodingError> {
    let mut encoder = Encoder::new(bytes, picture.size.width(), picture.size.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    encoder.set_compression(Compression::Fast);
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer()?;
    let mut line = Vec::with_capacity(picture.size.width() as usize * 3);
    for row in picture.rows() {
        line.clear();
        line.extend(row.iter().flat_map(|&pixel| tone.bytes(pixel)));
        stream.write_all(&line)?;
    }
    stream.finish()?;
    writer.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Size;

    #[test]
    fn what_is_written_reads_back() {
        let size = Size::new(70, 41).unwrap();
        let mut picture = Layer::filled(size, [0.0; 3]);
        for j in 0..41 {
            for i in 0..70 {
                picture.set(i, j, [i as f32 / 69.0, j as f32 / 40.0, 0.5]);
            }
        }
        let bytes = encode(&picture, Tone::Linear).unwrap();
        assert_eq!(bytes, encode(&picture, Tone::Linear).unwrap());
        let mut reader = ::png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height, info.color_type), (70, 41, ColorType::Rgb));
        let expected: Vec<u8> = picture.values.iter().flat_map(|&p| Tone::Linear.bytes(p)).collect();
        assert_eq!(pixels[..expected.len()], expected);
    }
}
