//! grammar.md: every example does what the page says, and its tables are those of the code.
//!
//! In: grammar.md. Out: passed or failed. A block `implicit` is one program that is accepted without a word; of
//! `implicit-note` and `implicit-error` each line is a program, with a part of what is said about it behind `//`.

use implicit::diag::{Diagnostic, render};
use implicit::expr::lower::limits;
use implicit::session::Program;
use implicit::syntax::{
    self,
    functions::{FUNCTIONS, OF_SURFACE, PAINTS},
};

fn page() -> String {
    std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/grammar.md")).expect("grammar.md stands at the root")
}

/// The contents of all blocks of one language.
fn blocks(page: &str, language: &str) -> Vec<String> {
    let mut blocks = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if let Some(found) = line.strip_prefix("```") {
            let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
            if found == language {
                blocks.push(block.join("\n"));
            }
        }
    }
    blocks
}

/// The lines of all blocks of one language, with what stands behind `//`.
fn rows(page: &str, language: &str) -> Vec<(String, String)> {
    let rows: Vec<(String, String)> = blocks(page, language)
        .iter()
        .flat_map(|block| block.lines())
        .map(|line| line.split_once(" // ").expect("each line says what is said about it"))
        .map(|(program, said)| (program.to_owned(), said.to_owned()))
        .collect();
    assert!(!rows.is_empty(), "no rows of {language}");
    rows
}

#[test]
fn examples_are_accepted_without_a_word() {
    let programs = blocks(&page(), "implicit");
    assert!(programs.len() >= 2);
    for text in programs {
        let program = Program::from_text(&text);
        let said = render(&program.diagnostics, &program.sources, false);
        assert!(said.is_empty(), "{text}\n{said}");
        assert!(!program.lowered.surfaces.is_empty(), "{text}");
    }
}

#[test]
fn notes_are_given_as_the_page_says() {
    for (text, said) in rows(&page(), "implicit-note") {
        let program = Program::from_text(&text);
        let shown = render(&program.diagnostics, &program.sources, false);
        assert!(!program.has_errors(), "{text}\n{shown}");
        assert!(program.diagnostics.iter().any(|note| note.message.contains(&said)), "{text} // {said}\n{shown}");
    }
}

#[test]
fn wrong_programs_are_refused_as_the_page_says() {
    for (text, said) in rows(&page(), "implicit-error") {
        let program = Program::from_text(&text);
        let errors: Vec<&Diagnostic> = program.diagnostics.iter().filter(|d| d.is_error()).collect();
        let shown = render(&program.diagnostics, &program.sources, false);
        assert!(errors.len() == 1 && errors[0].message.contains(&said), "{text} // {said}\n{shown}");
    }
}

/// The formula in the first backticks of a cell.
fn formula(cell: &str) -> Option<&str> {
    cell.trim().strip_prefix('`')?.split('`').next()
}

#[test]
fn traps_are_read_as_the_page_says() {
    let page = page();
    let section = page.split("## Traps").nth(1).and_then(|rest| rest.split("## ").next()).expect("the traps");
    let mut count = 0;
    for row in section.lines().filter(|line| line.starts_with("| `") && !line.contains("\\|")) {
        let cells: Vec<&str> = row.split('|').collect();
        let (Some(text), Some(here)) = (formula(cells[1]), formula(cells[2])) else { continue };
        let program = Program::from_text(&format!("{text}; {here}"));
        let shown = render(&program.diagnostics, &program.sources, false);
        assert!(!program.has_errors(), "{row}\n{shown}");
        assert_eq!(program.lowered.surfaces[0].f, program.lowered.surfaces[1].f, "{row}");
        count += 1;
    }
    assert!(count >= 10, "{count} rows");
}

#[test]
fn the_table_of_functions_is_that_of_the_code() {
    let page = page();
    for function in FUNCTIONS {
        let derivative =
            if function.derivative.is_empty() { String::new() } else { format!("`{}`", function.derivative) };
        let (signature, about, domain) = (function.signature, function.about, function.domain);
        let row = format!("| `{signature}` | {about} | {domain} | {derivative} |");
        assert!(page.contains(&row), "grammar.md lacks the row\n{row}");
    }
}

#[test]
fn the_functions_and_maps_of_colours_are_those_of_the_code() {
    let page = page();
    for function in PAINTS {
        let row = format!("| `{}` | {} |", function.signature.replace(" or ", "` or `"), function.about);
        assert!(page.contains(&row), "grammar.md lacks the row\n{row}");
    }
    let maps = format!("Maps: {}.", implicit::expr::lower::PALETTES.join(", "));
    assert!(page.contains(&maps), "grammar.md lacks\n{maps}");
    for word in OF_SURFACE {
        assert!(page.contains(&format!("`{word}`")), "grammar.md lacks `{word}`");
    }
}

#[test]
fn the_limits_are_those_of_the_code() {
    let page = page();
    let limits = [
        ("nesting of brackets, signs, powers, bars and functions", syntax::MAX_NESTING),
        ("bytes of a program text", syntax::MAX_TEXT),
        ("bytes of a file, and of standard input", implicit::cli::files::MAX_BYTES as usize),
        ("characters of a name", syntax::MAX_NAME),
        ("characters of a number", syntax::MAX_NUMBER),
        ("decimal exponent of a number", implicit::num::rational::MAX_EXPONENT as usize),
        ("parameters of a function", syntax::MAX_PARAMETERS),
        ("nodes of all formulas together, terms of sums included", limits::MAX_NODES),
        ("brackets and calls in one another, those of functions included", limits::MAX_DEPTH as usize),
        ("operations in a row from a formula to its leaf", limits::MAX_GRAPH_DEPTH as usize),
        ("steps to build the formulas", limits::MAX_STEPS as usize),
        ("definitions that stand on each other in a row", limits::MAX_CHAIN as usize),
        ("levels of `include`", implicit::session::include::MAX_LEVELS),
        ("files in one program", implicit::session::include::MAX_FILES),
        ("pixels of a picture", implicit::film::size::MAX_PIXELS as usize),
        ("lights of a program", implicit::expr::lower::MAX_LIGHTS),
        ("threads", implicit::cli::values::MAX_THREADS),
        ("errors that are shown, and notes", syntax::MAX_REPORTED),
    ];
    for (what, most) in limits {
        assert!(page.contains(&format!("| {what} | {most} |")), "grammar.md lacks | {what} | {most} |");
    }
}
