//! How many pixels a picture has.
//!
//! In: width and height, as typed or as numbers. Out: a size that is within the limit, so that nothing
//! is allocated before the limit was checked.

use std::fmt;
use std::str::FromStr;

/// The most pixels of one picture: 2^26, which is 8192 × 8192 and takes a gigabyte of memory.
pub const MAX_PIXELS: u64 = 1 << 26;

/// A width and a height in pixels, neither zero, their product at most [`MAX_PIXELS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    width: u32,
    height: u32,
}

/// Why two numbers are no size.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SizeError {
    /// The text is not `WxH`.
    NotASize(String),
    /// A side is zero.
    Empty,
    /// More than [`MAX_PIXELS`].
    TooLarge(u64, u64),
}

impl Size {
    /// A size of `width` × `height` pixels.
    ///
    /// # Errors
    /// If a side is zero, or the picture has more than [`MAX_PIXELS`] pixels.
    pub fn new(width: u64, height: u64) -> Result<Self, SizeError> {
        if width == 0 || height == 0 {
            return Err(SizeError::Empty);
        }
        match width.checked_mul(height) {
            Some(pixels) if pixels <= MAX_PIXELS => Ok(Size { width: width as u32, height: height as u32 }),
            _ => Err(SizeError::TooLarge(width, height)),
        }
    }

    /// Pixels from left to right.
    pub fn width(self) -> u32 {
        self.width
    }

    /// Pixels from top to bottom.
    pub fn height(self) -> u32 {
        self.height
    }

    /// How many pixels there are.
    pub fn pixels(self) -> usize {
        self.width as usize * self.height as usize
    }
}

impl Default for Size {
    fn default() -> Self {
        Size { width: 800, height: 600 }
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for Size {
    type Err = SizeError;

    fn from_str(text: &str) -> Result<Self, SizeError> {
        let error = || SizeError::NotASize(text.chars().take(40).collect());
        let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(error)?;
        let side = |side: &str| {
            let is_whole = !side.is_empty() && side.bytes().all(|b| b.is_ascii_digit());
            is_whole.then(|| side.parse().unwrap_or(u64::MAX)).ok_or_else(error)
        };
        Size::new(side(width)?, side(height)?)
    }
}

impl fmt::Display for SizeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SizeError::NotASize(text) => {
                write!(f, "'{}' is no size; write WIDTHxHEIGHT, as in 800x600", text.escape_debug())
            }
            SizeError::Empty => write!(f, "a picture needs at least one pixel each way"),
            SizeError::TooLarge(w, h) => {
                write!(f, "{w}x{h} is more than the {MAX_PIXELS} pixels (2^26) a picture may have")
            }
        }
    }
}

impl std::error::Error for SizeError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_and_limited() {
        let rows = [
            ("800x600", Ok((800, 600))),
            ("1x1", Ok((1, 1))),
            ("8192x8192", Ok((8192, 8192))),
            ("67108864x1", Ok((1 << 26, 1))),
            ("8192x8193", Err(SizeError::TooLarge(8192, 8193))),
            ("99999999999999999999x2", Err(SizeError::TooLarge(u64::MAX, 2))),
            ("0x5", Err(SizeError::Empty)),
            ("5", Err(SizeError::NotASize("5".into()))),
            ("-5x5", Err(SizeError::NotASize("-5x5".into()))),
            ("+5x5", Err(SizeError::NotASize("+5x5".into()))),
            ("x", Err(SizeError::NotASize("x".into()))),
        ];
        for (text, expected) in rows {
            assert_eq!(text.parse::<Size>().map(|s| (s.width(), s.height())), expected, "{text}");
        }
    }
}
