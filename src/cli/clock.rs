//! What time it is: for the person who waits, and for the machine that worked.
//!
//! In: nothing. Out: seconds.

use std::time::Instant;

/// Seconds on the wall and of the processor.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moment {
    /// Seconds on the wall since the clock was started.
    pub wall: f64,
    /// Seconds of user and system time of all threads since the process was started.
    pub cpu: f64,
}

/// A clock that was started.
#[derive(Clone, Copy, Debug)]
pub struct Clock(Instant);

impl Clock {
    /// Starts it.
    pub fn start() -> Self {
        Clock(Instant::now())
    }

    /// Seconds on the wall since then.
    pub fn wall(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }

    /// Both times.
    pub fn now(&self) -> Moment {
        Moment { wall: self.wall(), cpu: self.cpu() }
    }

    #[cfg(unix)]
    fn cpu(&self) -> f64 {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
    }

    #[cfg(not(unix))]
    fn cpu(&self) -> f64 {
        self.wall()
    }
}
