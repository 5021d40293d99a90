//! Where a picture goes, and what else is written.
//!
//! In: the arguments. Out: a destination; or, before any work is done, why there is none: options that contradict each
//! other, endings that no format has, files that cannot be written.

use super::args::{MethodArg, RenderArgs};
use super::complaint::Complaint;
use super::output::{self, STDOUT};
use crate::film::Format;
use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};

/// Where the picture goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Destination {
    /// Nowhere: only data or statistics are asked for.
    Nowhere,
    /// To the terminal on standard output.
    Terminal,
    /// To a file, or `-`.
    File(PathBuf, Format),
}

/// The destination that the arguments mean.
///
/// # Errors
/// If they contradict each other, or a file cannot be written.
pub fn of(args: &RenderArgs) -> Result<Destination, Complaint> {
    let outputs: Vec<&PathBuf> =
        [&args.output, &args.depth, &args.normals, &args.stats_json].into_iter().flatten().collect();
    contradictions(args)?;
    let format = args.output.as_deref().map(format_of).transpose()?;
    for path in [&args.depth, &args.normals].into_iter().flatten() {
        if path.as_os_str() == STDOUT || !is_device(path) && format_of(path)? != Format::Exr {
            return Err(Complaint::usage(format!("'{}' must end in .exr", output::shown(path))));
        }
    }
    for (index, path) in outputs.iter().enumerate() {
        if !is_device(path) && outputs[..index].iter().any(|other| place(other) == place(path)) {
            let path = output::shown(path);
            return Err(Complaint::usage(format!("'{path}' is asked for twice; every output needs a file of its own")));
        }
    }
    for path in &outputs {
        output::check(path)?;
    }
    match (&args.output, format) {
        (Some(path), Some(format)) => Ok(Destination::File(path.clone(), format)),
        _ if !outputs.is_empty() => Ok(Destination::Nowhere),
        _ if std::io::stdout().is_terminal() => Ok(Destination::Terminal),
        _ => Err(Complaint::usage(
            "there is nowhere to draw to, for standard output is no terminal: add -o picture.png (or -o - for PNG \
             there)",
        )),
    }
}

fn contradictions(args: &RenderArgs) -> Result<(), Complaint> {
    if args.step.is_some() && args.method != MethodArg::March {
        return Err(Complaint::usage("--step belongs to --method march; the faithful method takes no steps"));
    }
    match &args.output {
        None if args.progressive => {
            Err(Complaint::usage("--progressive replaces the picture's file after every pass: add -o picture.png"))
        }
        Some(path) if args.progressive && (path.as_os_str() == STDOUT || is_device(path)) => {
            let path = output::shown(path);
            Err(Complaint::usage(format!("--progressive replaces a file after every pass, and '{path}' is none")))
        }
        _ => Ok(()),
    }
}

/// Whether a path is a device or a pipe, which has no ending.
fn is_device(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|metadata| !metadata.is_file() && !metadata.is_dir())
}

/// What a path names, however it is written.
fn place(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| {
        let folder = fs::canonicalize(output::directory_of(path)).unwrap_or_default();
        folder.join(path.file_name().unwrap_or(path.as_os_str()))
    })
}

fn format_of(path: &Path) -> Result<Format, Complaint> {
    if path.as_os_str() == STDOUT || is_device(path) {
        return Ok(Format::Png);
    }
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    Format::from_ending(ending).ok_or_else(|| {
        Complaint::usage(format!("'{}' must end in .png, .jpg, .webp, .tiff or .exr", output::shown(path)))
    })
}
