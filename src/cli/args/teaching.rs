//! What was typed to the commands that teach: `explain`, `ray`, `compare`, `lesson`.
//!
//! In: their arguments. Out: plain values. Separate from the other commands, because these share how a page is wanted.

use super::{COMMAND_HELP, ProgramArgs};
use crate::teach::texts::{LANGUAGES, Texts};
use clap::{Args, Parser, ValueHint};
use std::path::PathBuf;

/// In which form a page is wanted.
#[derive(Args, Clone, Debug, Default)]
pub struct PageArgs {
    /// As a LaTeX document
    #[arg(long, group = "form")]
    pub latex: bool,
    /// In Markdown
    #[arg(long, group = "form")]
    pub markdown: bool,
    /// As one HTML file that needs no other
    #[arg(long, group = "form")]
    pub html: bool,
    /// The figure alone, as SVG
    #[arg(long, group = "form")]
    pub svg: bool,
    /// One JSON object
    #[arg(long, group = "form")]
    pub json: bool,
    /// To this file instead of standard output
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// en or sl
    #[arg(long, value_name = "CODE", default_value = "en", value_parser = language)]
    pub language: String,
}

impl PageArgs {
    /// The sentences of the language that is wanted.
    pub fn texts(&self) -> Texts {
        Texts::of(&self.language).unwrap_or_else(Texts::english)
    }
}

fn language(code: &str) -> Result<String, String> {
    let codes: Vec<&str> = LANGUAGES.iter().map(|(code, _)| *code).collect();
    match codes.contains(&code) {
        true => Ok(code.to_owned()),
        false => Err(format!("there are texts in {}", codes.join(", "))),
    }
}

/// Explain a surface: how it was read, what it is, its derivatives by rule, its graph.
#[derive(Parser, Debug)]
#[command(name = "implicit explain", bin_name = "implicit explain", disable_help_flag = true, help_template = COMMAND_HELP, term_width = 80)]
#[command(
    after_help = "  implicit explain 'z = sin x cos y'\n  implicit explain 'x^2 + 4y^2 = z^2 + 1' --html -o hyperboloid.html"
)]
pub struct ExplainArgs {
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
    /// This definition instead of the surfaces
    #[arg(long, value_name = "NAME")]
    pub of: Option<String>,
    /// The page.
    #[command(flatten)]
    pub page: PageArgs,
}
