//! The program `implicit` as a whole process.
//!
//! In: a formula, a clip, a camera. Out: the command that draws it, and what the drawing took.

use crate::Outcome;
use crate::process::{Usage, run};
use crate::scenes::{Clip, FIELD_OF_VIEW};
use glam::DVec3;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// No picture of ours takes so long.
const LIMIT: Duration = Duration::from_secs(600);

/// Builds the program and finds it.
pub fn build() -> Outcome<PathBuf> {
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/../../Cargo.toml");
    let words = ["build", "--release", "--locked", "--bin", "implicit", "--message-format", "json"];
    let cargo = std::env::var("CARGO").unwrap_or("cargo".into());
    let output =
        Command::new(cargo).args(words).args(["--manifest-path", manifest]).stderr(Stdio::inherit()).output()?;
    let messages = String::from_utf8(output.stdout)?;
    let mut executables = messages.lines().filter_map(|line| {
        let message: serde_json::Value = serde_json::from_str(line).ok()?;
        message["executable"].as_str().map(PathBuf::from)
    });
    executables.next_back().ok_or("cargo has not built the program".into())
}

/// What is drawn, and how.
#[derive(Clone, Copy)]
pub struct Task<'a> {
    pub formula: &'a str,
    pub clip: Clip,
    pub eye: DVec3,
    pub size: u32,
    pub threads: usize,
}

/// `implicit FORMULA … -o PICTURE`: one sample a pixel, one light without shadow.
pub fn command(program: &Path, task: Task, picture: &Path) -> Command {
    let mut command = Command::new(program);
    let clip = match task.clip {
        Clip::Ball(radius) => format!("--ball=0,0,0,{radius}"),
        Clip::Box(h) => format!("--box=-{h},{h},-{h},{h},-{h},{h}"),
    };
    command.arg(task.formula).args(["--look-at=0,0,0", "--samples=1", "--mode=cosine", "--quiet"]).args([
        clip,
        format!("--eye={},{},{}", task.eye.x, task.eye.y, task.eye.z),
        format!("--fov={FIELD_OF_VIEW}"),
        format!("--size={0}x{0}", task.size),
        format!("--threads={}", task.threads),
    ]);
    command.arg("-o").arg(picture);
    command
}

/// Draws it and throws the picture away.
pub fn draw(program: &Path, task: Task, folder: &Path) -> Outcome<Usage> {
    let usage = run(&mut command(program, task, &folder.join("ours.png")), LIMIT)?;
    if usage.is_done { Ok(usage) } else { Err(format!("implicit did not draw {}", task.formula).into()) }
}

/// Wall and processor seconds of the trace stage.
pub fn trace_stage(program: &Path, task: Task, folder: &Path) -> Outcome<(f64, f64)> {
    let file = folder.join("stats.json");
    let mut command = command(program, task, &folder.join("ours.png"));
    run(command.arg("--stats-json").arg(&file), LIMIT)?;
    let stats: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(file)?)?;
    let seconds = |clock: &str| stats[clock]["trace"].as_f64().ok_or("no time of the trace stage");
    Ok((seconds("seconds")?, seconds("cpu_seconds")?))
}
