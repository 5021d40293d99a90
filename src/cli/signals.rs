//! What an interruption leaves behind: nothing.
//!
//! In: signals, and the files that are being written. Out: at a signal those files are removed and the process ends
//! with 128 + the signal's number. A thread of its own waits for signals, so that any stage can be interrupted.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Files that are written and not in their place yet.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// The files that are being written; no signal is answered while this is held.
pub struct Pending(MutexGuard<'static, Vec<PathBuf>>);

impl Pending {
    /// Holds off signals.
    pub fn hold() -> Self {
        Pending(PENDING.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Notes that a file is to be removed when a signal comes.
    pub fn add(&mut self, path: &Path) {
        self.0.push(path.to_owned());
    }

    /// Notes that a file is in its place, or gone.
    pub fn forget(&mut self, path: &Path) {
        self.0.retain(|pending| pending != path);
    }
}

/// Starts to wait for signals. Where that fails, they end the process as they always do.
pub fn watch() {
    #[cfg(unix)]
    {
        use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
        if let Ok(mut signals) = signal_hook::iterator::Signals::new([SIGINT, SIGTERM, SIGHUP]) {
            let wait = move || {
                if let Some(signal) = signals.forever().next() {
                    end(128 + signal);
                }
            };
            let _ = std::thread::Builder::new().name("signals".into()).spawn(wait);
        }
    }
}

#[cfg(unix)]
#[allow(clippy::exit)]
fn end(status: i32) {
    // The lock is never given back: nothing may start to be written between here and the end.
    let pending = Pending::hold();
    for path in pending.0.iter() {
        let _ = fs::remove_file(path);
    }
    std::process::exit(status);
}
