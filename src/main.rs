//! The program: arguments in, files and messages out. All it does is in [`implicit::cli`].

use implicit::cli::{self, console, fault, signals};
use std::process::ExitCode;

fn main() -> ExitCode {
    signals::watch();
    match fault::guard(|| cli::run(std::env::args_os().collect())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(complaint) => {
            console::say(&complaint.text);
            ExitCode::from(complaint.status as u8)
        }
    }
}
