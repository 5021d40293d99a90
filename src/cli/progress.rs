//! The bar that shows how far a drawing is.
//!
//! In: what a drawing tells. Out: a bar on standard error, only on a terminal and only for the patient; the time.

use super::clock::Clock;
use crate::render::Watch;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

/// Looks on and shows a bar.
#[derive(Debug)]
pub struct Progress {
    clock: Clock,
    bar: ProgressBar,
}

impl Progress {
    /// A bar on standard error, if that is a terminal and nobody asked for quiet.
    pub fn new(clock: Clock, quiet: bool) -> Self {
        let is_shown = !quiet && std::io::stderr().is_terminal();
        let target = if is_shown { ProgressDrawTarget::stderr_with_hz(10) } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(None, target);
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} % {elapsed} (left: {eta})") {
            bar.set_style(style);
        }
        Progress { clock, bar }
    }

    /// Takes the bar away.
    pub fn clear(&self) {
        self.bar.finish_and_clear();
    }
}

impl Watch for Progress {
    fn advanced(&self, done: usize, total: usize) {
        if !self.bar.is_hidden() {
            self.bar.set_length(total as u64);
            self.bar.set_position(done as u64);
        }
    }

    fn seconds(&self) -> f64 {
        self.clock.wall()
    }
}
