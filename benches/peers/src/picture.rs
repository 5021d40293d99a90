//! What a peer's picture shows as hit: everything that is not the blue background.
//!
//! In: a binary portable pixmap. Out: a flag for every pixel.

use std::path::Path;

/// Grey has equal channels; blue differs by more than this even where a peer smooths or rounds.
const GREY: u8 = 8;

/// `None` where there is no such picture, or not of that size.
pub fn hits(path: &Path, size: u32) -> Option<Vec<bool>> {
    let bytes = std::fs::read(path).ok()?;
    let start = bytes.len().checked_sub(3 * (size * size) as usize)?;
    let is_pixmap = bytes.starts_with(b"P6") && header(&bytes[..start])?.contains(&size);
    is_pixmap.then(|| bytes[start..].chunks_exact(3).map(|p| p[0].abs_diff(p[2]) < GREY).collect())
}

/// The numbers of the header, comments left out.
fn header(bytes: &[u8]) -> Option<Vec<u32>> {
    let text = std::str::from_utf8(bytes.get(2..)?).ok()?;
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or(""));
    Some(lines.flat_map(str::split_whitespace).filter_map(|word| word.parse().ok()).collect())
}
