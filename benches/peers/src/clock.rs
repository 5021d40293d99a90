//! Processor time and medians: what other work on the machine disturbs least.

use nix::time::{ClockId, clock_gettime};

/// Seconds this process has used of all processors.
pub fn processor_seconds() -> f64 {
    let time = clock_gettime(ClockId::CLOCK_PROCESS_CPUTIME_ID).expect("Linux has this clock");
    time.tv_sec() as f64 + time.tv_nsec() as f64 * 1e-9
}

/// What `work` gives, and the processor seconds it took.
pub fn timed<R>(work: impl FnOnce() -> R) -> (R, f64) {
    let start = processor_seconds();
    let result = work();
    (result, processor_seconds() - start)
}

/// The middle one; NaN of none.
pub fn median(samples: &[f64]) -> f64 {
    let mut sorted = samples.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN)
}
