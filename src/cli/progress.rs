//! Looking on while a picture is drawn: the bar, the clock, the end of the time, the file after every pass.
//!
//! In: what a drawing tells. Out: a bar on standard error, only on a terminal; whether to go on.

use super::clock::Clock;
use super::complaint::Complaint;
use crate::render::{Drawing, Watch};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

/// What is done with the drawing after a pass.
pub type Keep<'a> = &'a (dyn Fn(&Drawing) -> Result<(), Complaint> + Sync);

/// Looks on.
pub struct Progress<'a> {
    clock: Clock,
    bar: ProgressBar,
    /// Seconds after which the last whole pass is enough.
    budget: Option<f64>,
    keep: Option<Keep<'a>>,
    has_passed: AtomicBool,
    failure: Mutex<Option<Complaint>>,
}

impl<'a> Progress<'a> {
    /// A bar on standard error, if that is a terminal and nobody asked for quiet.
    pub fn new(clock: Clock, quiet: bool, budget: Option<f64>, keep: Option<Keep<'a>>) -> Self {
        let is_shown = !quiet && std::io::stderr().is_terminal();
        let target = if is_shown { ProgressDrawTarget::stderr_with_hz(10) } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(None, target);
        if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} % {elapsed} (left: {eta})") {
            bar.set_style(style);
        }
        Progress { clock, bar, budget, keep, has_passed: AtomicBool::new(false), failure: Mutex::new(None) }
    }

    /// Takes the bar away.
    ///
    /// # Errors
    /// If a pass could not be kept.
    pub fn end(self) -> Result<(), Complaint> {
        self.bar.finish_and_clear();
        let failure = self.failure.into_inner().unwrap_or_else(PoisonError::into_inner);
        failure.map_or(Ok(()), Err)
    }

    fn failure(&self) -> std::sync::MutexGuard<'_, Option<Complaint>> {
        self.failure.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Watch for Progress<'_> {
    fn advanced(&self, done: usize, total: usize) {
        if !self.bar.is_hidden() {
            self.bar.set_length(total as u64);
            // Threads report in any order; the bar never goes back.
            self.bar.set_position(self.bar.position().max(done as u64));
        }
    }

    fn passed(&self, drawing: &Drawing) {
        self.has_passed.store(true, Ordering::Relaxed);
        if let Some(Err(complaint)) = self.keep.map(|keep| keep(drawing)) {
            *self.failure() = Some(complaint);
        }
    }

    fn is_cancelled(&self) -> bool {
        if !self.has_passed.load(Ordering::Relaxed) {
            return false;
        }
        self.budget.is_some_and(|budget| self.clock.wall() > budget) || self.failure().is_some()
    }

    fn seconds(&self) -> f64 {
        self.clock.wall()
    }
}
