//! Pixels, and how they become bytes.
//!
//! In: numbers a pixel, in linear light or in the units of what was measured. Out: the bytes of a file.
//! Separate because a film knows no formula, and the encoders' types stay in here.
//!
//! - [`size`]: how many pixels there are, and the limit.
//! - [`layer`]: one value a pixel.
//! - [`srgb`]: linear light to the eight bits a screen shows.
//! - [`tone`]: how light or data is shown; [`mod@print`]: a picture with all that is said of how it is shown.
//! - [`mod@format`]: which file it becomes; [`png`], [`jpeg`], [`webp`], [`tiff`], [`exr`]: the files.
//! - [`blocks`]: the picture in characters of a terminal.

pub mod blocks;
pub mod exr;
pub mod format;
pub mod jpeg;
pub mod layer;
pub mod png;
pub mod print;
pub mod size;
pub mod srgb;
pub mod tiff;
pub mod tone;
pub mod webp;

pub use format::Format;
pub use layer::Layer;
pub use print::Print;
pub use size::Size;
pub use tone::Tone;

/// Why a film could not become a file's bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EncodeError {
    /// What the encoder said.
    pub message: String,
}

impl std::fmt::Display for EncodeError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "the picture could not be encoded: {}", self.message)
    }
}

impl std::error::Error for EncodeError {}
