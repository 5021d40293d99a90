//! Runs the program as a person does.
//!
//! In: arguments, standard input, environment. Out: what it printed and its exit status. A folder for each test, so
//! that what is left behind can be seen.

use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};

/// The program.
pub(crate) const PROGRAM: &str = env!("CARGO_BIN_EXE_implicit");

/// A folder of its own, gone at the end.
pub(crate) struct Folder {
    pub(crate) path: PathBuf,
}

/// What a run said.
#[derive(Debug)]
pub(crate) struct Said {
    pub(crate) status: i32,
    pub(crate) out: Vec<u8>,
    pub(crate) err: String,
}

impl Folder {
    pub(crate) fn new() -> Self {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("implicit-test-{}-{number}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Folder { path }
    }

    pub(crate) fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        let path = self.path.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path.join(name)).unwrap()
    }

    /// The names of all that is in it, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let mut names: Vec<String> =
            fs::read_dir(&self.path).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    pub(crate) fn run<S: AsRef<OsStr>>(&self, args: &[S]) -> Said {
        self.run_with(args, "", &[])
    }

    pub(crate) fn run_with<S: AsRef<OsStr>>(&self, args: &[S], input: &str, environment: &[(&str, &str)]) -> Said {
        let mut command = Command::new(PROGRAM);
        command.args(args).current_dir(&self.path).envs(environment.iter().copied());
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        // A program that reads nothing may close its input first.
        let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
        said(child.wait_with_output().unwrap())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.path);
    }
}

pub(crate) fn said(output: Output) -> Said {
    let status = output.status.code().unwrap_or(-1);
    Said { status, out: output.stdout, err: String::from_utf8_lossy(&output.stderr).into_owned() }
}

/// A channel of an EXR file, rows from the top.
pub(crate) fn exr_channel(path: &Path, name: &str) -> Vec<f32> {
    let image = exr::prelude::read_first_flat_layer_from_file(path).unwrap();
    let channels = &image.layer_data.channel_data.list;
    let channel = channels.iter().find(|channel| channel.name.to_string() == name).unwrap();
    channel.sample_data.values_as_f32().collect()
}
