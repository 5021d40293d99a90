//! Whole processes: their user time, their peak of memory, an end to those that take too long.
//!
//! In: a command. Out: what it took. One child at a time: the times are those of all children that have ended.

use crate::Outcome;
use nix::sys::resource::{UsageWho, getrusage};
use nix::sys::time::TimeValLike;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// How often a child is looked at: seldom enough to cost nothing.
const PAUSE: Duration = Duration::from_millis(2);

/// What a process took.
#[derive(Clone, Copy)]
pub struct Usage {
    /// Seconds of processor time outside the kernel.
    pub user: f64,
    /// The most memory it held, bytes, as last seen before its end.
    pub peak: u64,
    /// Whether it ended by itself, without an error.
    pub is_done: bool,
}

/// Runs the command to its end, or stops it after `limit` of wall time.
pub fn run(command: &mut Command, limit: Duration) -> Outcome<Usage> {
    let before = user_seconds()?;
    let start = Instant::now();
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn()?;
    let mut peak = 0;
    let is_done = loop {
        peak = memory(&child).unwrap_or(peak);
        if let Some(status) = child.try_wait()? {
            break status.success();
        }
        if start.elapsed() > limit {
            child.kill()?;
            child.wait()?;
            break false;
        }
        std::thread::sleep(PAUSE);
    };
    Ok(Usage { user: user_seconds()? - before, peak, is_done })
}

/// User time of all children that have ended.
fn user_seconds() -> Outcome<f64> {
    Ok(getrusage(UsageWho::RUSAGE_CHILDREN)?.user_time().num_microseconds() as f64 * 1e-6)
}

/// The peak so far, from the kernel's table.
fn memory(child: &Child) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().trim_end_matches("kB").trim().parse::<u64>().ok()? * 1024)
}
