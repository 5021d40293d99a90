//! The fast tests of the whole: one binary, so that it links once.
//!
//! In: the library, `tests/data`, the files of the project. Out: passed or failed. Apart from the unit tests because what
//! is judged here is more than one module.
#![allow(clippy::unwrap_used, clippy::disallowed_methods, missing_docs, clippy::print_stderr)]

mod again;
mod agreement;
mod cli;
mod closures;
mod command;
mod formulas;
mod framing;
mod grammar;
mod hostile;
mod language;
mod light;
mod long_texts;
mod mistakes;
mod npy;
mod passes;
mod pictures;
mod teaching;
mod terminal;
mod tidy;
mod tidy_scan;
mod truth;
mod truth_case;
