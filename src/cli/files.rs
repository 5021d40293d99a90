//! Files with programs, and which of them a program may include.
//!
//! In: paths. Out: texts; never one from outside the folder of the first file.

use super::console;
use super::programs::is_program_file;
use crate::session::{Loaded, Loader};
use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::io::Read;
use std::path::{Component, Path, PathBuf};

/// The largest file that is read: 4 MiB.
pub const MAX_BYTES: u64 = 4 << 20;

/// A folder whose files may be included.
#[derive(Clone, Debug)]
pub struct Folder {
    /// Its true path.
    pub root: PathBuf,
}

impl Loader for Folder {
    fn load(&self, from: &str, path: &str) -> Result<Loaded, String> {
        let base = Path::new(from).parent().filter(|_| !from.is_empty()).unwrap_or(&self.root);
        let outside = || "it is outside the folder of the first file".to_owned();
        let Some(named) = plain(&base.join(path)).filter(|named| named.starts_with(&self.root)) else {
            return Err(outside());
        };
        let file = fs::canonicalize(named).map_err(|error| console::reason(&error))?;
        let inside = file.strip_prefix(&self.root).map_err(|_| outside())?;
        let mut loaded = read(&file)?;
        loaded.name = shown(inside.as_os_str());
        Ok(loaded)
    }
}

/// A path without `.` and `..`, by its text alone; `None` if it leads out of its root.
fn plain(path: &Path) -> Option<PathBuf> {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => {
                if !plain.pop() {
                    return None;
                }
            }
            Component::CurDir => {}
            Component::Prefix(_) | Component::RootDir | Component::Normal(_) => plain.push(part),
        }
    }
    Some(plain)
}

/// The folder of the first program that is a file; without one, the current folder.
pub fn root_of(programs: &[OsString]) -> PathBuf {
    let first = programs.iter().find(|program| is_program_file(program));
    let folder = first.map(Path::new).and_then(Path::parent).filter(|folder| *folder != Path::new(""));
    let folder = folder.unwrap_or(Path::new("."));
    fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned())
}

/// Reads a file with a program.
///
/// # Errors
/// Why not.
pub fn read(path: &Path) -> Result<Loaded, String> {
    let reason = |error: std::io::Error| console::reason(&error);
    let file = File::open(path).map_err(reason)?;
    if file.metadata().map_err(reason)?.is_dir() {
        return Err("it is a directory".into());
    }
    let mut bytes = Vec::new();
    file.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(reason)?;
    let key = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    Ok(Loaded { key: key.to_string_lossy().into_owned(), name: shown(path.as_os_str()), text: text_of(bytes)? })
}

/// Bytes as a program's text.
///
/// # Errors
/// If there are too many, or they are no UTF-8.
pub fn text_of(bytes: Vec<u8>) -> Result<String, String> {
    if bytes.len() as u64 > MAX_BYTES {
        return Err(format!("it is larger than {} MiB", MAX_BYTES >> 20));
    }
    String::from_utf8(bytes).map_err(|error| {
        let line = error.as_bytes()[..error.utf8_error().valid_up_to()].iter().filter(|&&b| b == b'\n').count() + 1;
        format!("it is no text in UTF-8 (line {line})")
    })
}

/// A path in a message.
pub fn shown(path: &OsStr) -> String {
    crate::diag::printable(&path.to_string_lossy(), 200)
}
