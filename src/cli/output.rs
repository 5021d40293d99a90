//! Files that appear whole or not at all.
//!
//! In: paths and bytes. Out: files. All files of a run are written beside their places first, flushed to the disk, and
//! renamed when every one of them is there; until then whatever was in their places stays as it was.

use super::complaint::Complaint;
use super::console;
use super::signals::Pending;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// The name that stands for standard output.
pub const STDOUT: &str = "-";

/// The files of one run, on their way.
#[derive(Debug, Default)]
pub struct Outputs {
    staged: Vec<Staged>,
    /// What goes to standard output.
    stdout: Option<Vec<u8>>,
    /// What goes to devices and pipes, which cannot be renamed onto.
    devices: Vec<(PathBuf, Vec<u8>)>,
}

#[derive(Debug)]
struct Staged {
    file: NamedTempFile,
    target: PathBuf,
    shown: PathBuf,
}

/// Refuses a path that cannot be written to, before any work is done for it.
///
/// # Errors
/// Why not.
pub fn check(path: &Path) -> Result<(), Complaint> {
    let refuse = |why: &str| Err(cannot_write(path, why));
    if path.as_os_str() == STDOUT {
        return Ok(());
    }
    match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => return refuse("it is a directory"),
        Ok(metadata) if metadata.permissions().readonly() => return refuse("it is read-only"),
        _ => {}
    }
    match fs::metadata(directory_of(path)) {
        Ok(metadata) if metadata.is_dir() => Ok(()),
        Ok(_) => refuse("its folder is no directory"),
        Err(error) => refuse(&format!("its folder: {}", console::reason(&error))),
    }
}

impl Outputs {
    /// Writes bytes beside the place of `path`.
    ///
    /// # Errors
    /// If the system refuses; nothing is left behind.
    pub fn stage(&mut self, path: &Path, bytes: Vec<u8>) -> Result<(), Complaint> {
        if path.as_os_str() == STDOUT {
            self.stdout = Some(bytes);
        } else if fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
            self.devices.push((path.to_owned(), bytes));
        } else {
            let staged = stage(path, &bytes).map_err(|error| cannot_write(path, &console::reason(&error)))?;
            self.staged.push(staged);
        }
        Ok(())
    }

    /// Puts every file in its place.
    ///
    /// # Errors
    /// If the system refuses.
    pub fn commit(self) -> Result<(), Complaint> {
        if let Some(bytes) = &self.stdout {
            console::print_file(bytes)?;
        }
        for (path, bytes) in &self.devices {
            let written = File::options().write(true).open(path).and_then(|mut device| device.write_all(bytes));
            written.map_err(|error| cannot_write(path, &console::reason(&error)))?;
        }
        let mut pending = Pending::hold();
        for staged in self.staged {
            let temporary = staged.file.path().to_owned();
            let renamed = staged.file.persist(&staged.target);
            pending.forget(&temporary);
            renamed.map_err(|e| cannot_write(&staged.shown, &console::reason(&e.error)))?;
        }
        Ok(())
    }
}

fn stage(path: &Path, bytes: &[u8]) -> io::Result<Staged> {
    // A link is followed, so that the file it names is replaced and not the link.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let mut file = create_beside(&target)?;
    let written = file.write_all(bytes).and_then(|()| file.as_file().sync_all());
    if let Err(error) = written {
        Pending::hold().forget(file.path());
        return Err(error);
    }
    Ok(Staged { file, target, shown: path.to_owned() })
}

fn create_beside(target: &Path) -> io::Result<NamedTempFile> {
    let mut pending = Pending::hold();
    let mut builder = tempfile::Builder::new();
    builder.prefix(".implicit-").suffix(".part");
    #[cfg(unix)]
    let permissions = {
        use std::os::unix::fs::PermissionsExt;
        fs::metadata(target).map_or_else(|_| fs::Permissions::from_mode(0o666), |metadata| metadata.permissions())
    };
    #[cfg(unix)]
    builder.permissions(permissions);
    let file = builder.tempfile_in(directory_of(target))?;
    pending.add(file.path());
    Ok(file)
}

/// The folder that a file is in.
pub fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    }
}

fn cannot_write(path: &Path, why: &str) -> Complaint {
    Complaint::program(format!("cannot write '{}': {why}", shown(path)))
}

/// A path in a message.
pub fn shown(path: &Path) -> String {
    crate::diag::printable(&path.to_string_lossy(), 200)
}
