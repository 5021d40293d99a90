//! Who looks on while a picture is drawn.
//!
//! In: how far the drawing is. Out: whether to go on, and what time it is. Separate because drawing itself
//! neither prints nor reads a clock.

use super::tiles::Drawing;

/// Told of progress, asked for the time and whether to stop. Called from several threads.
pub trait Watch: Sync {
    /// `done` of `total` pieces of work are done.
    fn advanced(&self, done: usize, total: usize) {
        let _ = (done, total);
    }

    /// A whole pass is done and another will follow: the drawing as it is now.
    fn passed(&self, drawing: &Drawing) {
        let _ = drawing;
    }

    /// Whether to stop drawing.
    fn is_cancelled(&self) -> bool {
        false
    }

    /// Seconds since any fixed moment; always 0 where times are of no interest.
    fn seconds(&self) -> f64 {
        0.0
    }
}

/// Looks on without a word.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Watch for Silent {}
