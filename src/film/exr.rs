//! OpenEXR: 32-bit floats, linear light or measured values.
//!
//! In: a layer. Out: the bytes of an EXR file with losslessly compressed scan lines, the same for the same layer.

use super::{EncodeError, Layer, Print, Size};
use ::exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, Layer as ExrLayer, LayerAttributes,
    LineOrder, SmallVec, WritableImage,
};
use std::io::Cursor;

/// Scan lines in blocks of 16, zip: what every reader knows.
const ENCODING: Encoding =
    Encoding { compression: Compression::ZIP16, blocks: Blocks::ScanLines, line_order: LineOrder::Increasing };

/// Linear light as channels `R G B`, and `A` if the picture is clear in parts; then the light is that of the covered share.
///
/// # Errors
/// If the encoder refuses.
pub fn encode_colour(print: &Print<'_>) -> Result<Vec<u8>, EncodeError> {
    let light = Layer { size: print.picture.size, values: print.light() };
    let mut channels: Vec<(&str, Vec<f32>)> =
        ["R", "G", "B"].iter().enumerate().map(|(k, name)| (*name, column(&light, k))).collect();
    channels.extend(print.alpha.filter(|_| print.is_clear()).map(|alpha| ("A", alpha.values.clone())));
    encode(light.size, channels)
}

/// Unit normals as channels `X Y Z`.
///
/// # Errors
/// If the encoder refuses.
pub fn encode_normals(normals: &Layer<[f32; 3]>) -> Result<Vec<u8>, EncodeError> {
    encode(normals.size, ["X", "Y", "Z"].iter().enumerate().map(|(k, name)| (*name, column(normals, k))).collect())
}

/// Distances as one channel `Z`.
///
/// # Errors
/// If the encoder refuses.
pub fn encode_depth(depth: &Layer<f32>) -> Result<Vec<u8>, EncodeError> {
    encode(depth.size, vec![("Z", depth.values.clone())])
}

fn column(layer: &Layer<[f32; 3]>, k: usize) -> Vec<f32> {
    layer.values.iter().map(|value| value[k]).collect()
}

fn encode(size: Size, channels: Vec<(&str, Vec<f32>)>) -> Result<Vec<u8>, EncodeError> {
    let channels: SmallVec<[AnyChannel<FlatSamples>; 4]> =
        channels.into_iter().map(|(name, values)| AnyChannel::new(name, FlatSamples::F32(values))).collect();
    let extent = (size.width() as usize, size.height() as usize);
    let layer = ExrLayer::new(extent, LayerAttributes::default(), ENCODING, AnyChannels::sort(channels));
    let mut file = Cursor::new(Vec::new());
    Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut file)
        .map_err(|e| EncodeError { message: e.to_string() })?;
    Ok(file.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::exr::prelude::read_first_flat_layer_from_file;

    #[test]
    fn depth_reads_back_with_infinities() {
        let size = Size::new(19, 7).unwrap();
        let mut depth = Layer::filled(size, f32::INFINITY);
        depth.set(3, 2, 1.25);
        let file = std::env::temp_dir().join(format!("implicit-depth-{}.exr", std::process::id()));
        std::fs::write(&file, encode_depth(&depth).unwrap()).unwrap();
        let image = read_first_flat_layer_from_file(&file).unwrap();
        std::fs::remove_file(&file).unwrap();
        let channel = &image.layer_data.channel_data.list[0];
        assert_eq!(channel.name.to_string(), "Z");
        let values: Vec<f32> = channel.sample_data.values_as_f32().collect();
        assert_eq!(values, depth.values);
    }

    #[test]
    fn clear_pixels_have_a_channel_of_their_own() {
        Print::half_clear(|print| {
            let file = std::env::temp_dir().join(format!("implicit-alpha-{}.exr", std::process::id()));
            std::fs::write(&file, encode_colour(print).unwrap()).unwrap();
            let image = read_first_flat_layer_from_file(&file).unwrap();
            std::fs::remove_file(&file).unwrap();
            let channels = &image.layer_data.channel_data.list;
            let names: Vec<String> = channels.iter().map(|channel| channel.name.to_string()).collect();
            assert_eq!(names, ["A", "B", "G", "R"]);
            let first = |k: usize| channels[k].sample_data.values_as_f32().next();
            assert_eq!((first(0), first(3)), (Some(0.5), Some(0.25)));
        });
    }

    #[test]
    fn the_same_layer_gives_the_same_bytes() {
        let picture = Layer::filled(Size::new(33, 40).unwrap(), [0.25, 0.5, f32::NAN]);
        let print = Print::new(&picture, crate::film::Tone::Linear);
        assert_eq!(encode_colour(&print).unwrap(), encode_colour(&print).unwrap());
        assert_eq!(encode_normals(&picture).unwrap(), encode_normals(&picture).unwrap());
    }
}
