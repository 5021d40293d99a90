//! Which kind of file a picture becomes.
//!
//! In: a file's ending, a picture, what it should say of itself. Out: the bytes of a file. Separate from the encoders,
//! which know one format each.

use super::{EncodeError, Print, exr, jpeg, png, tiff, webp};

/// The kinds of files that hold a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Eight bits a channel, lossless; the only one that says what it shows.
    Png,
    /// Eight bits a channel, small and lossy.
    Jpeg,
    /// Eight bits a channel, lossless.
    Webp,
    /// Eight bits a channel, uncompressed.
    Tiff,
    /// 32-bit floats of linear light.
    Exr,
}

impl Format {
    /// All endings of files with the format that each stands for.
    pub const ENDINGS: [(&'static str, Format); 7] = [
        ("png", Format::Png),
        ("jpg", Format::Jpeg),
        ("jpeg", Format::Jpeg),
        ("webp", Format::Webp),
        ("tiff", Format::Tiff),
        ("tif", Format::Tiff),
        ("exr", Format::Exr),
    ];

    /// The format of an ending, in capitals or not.
    pub fn from_ending(ending: &str) -> Option<Format> {
        Format::ENDINGS.into_iter().find(|(name, _)| name.eq_ignore_ascii_case(ending)).map(|(_, format)| format)
    }

    /// The bytes of a file with the picture; `notes` are kept in a PNG and by no other format.
    ///
    /// # Errors
    /// If the picture is larger than the format allows, or the encoder refuses.
    pub fn encode(self, print: &Print<'_>, notes: &[(&str, String)]) -> Result<Vec<u8>, EncodeError> {
        match self {
            Format::Png => png::encode_with(print, notes),
            Format::Jpeg => jpeg::encode(print),
            Format::Webp => webp::encode(print),
            Format::Tiff => tiff::encode(print),
            Format::Exr => exr::encode_colour(print),
        }
    }

    /// Whether pixels can be clear in it.
    pub fn has_alpha(self) -> bool {
        self != Format::Jpeg
    }

    /// The longest side in pixels that a picture of this format can have.
    pub fn max_side(self) -> u32 {
        match self {
            Format::Jpeg => jpeg::MAX_SIDE,
            Format::Webp => webp::MAX_SIDE,
            Format::Png | Format::Tiff | Format::Exr => u32::MAX,
        }
    }
}
