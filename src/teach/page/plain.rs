//! A page on a terminal.
//!
//! In: a page. Out: text of at most [`WIDTH`] columns, where formulas and tables allow it.

use super::{Block, Page};
use crate::teach::notation::text;

/// Columns that sentences fill.
const WIDTH: usize = 96;

/// The page as text.
pub fn write(page: &Page) -> String {
    let mut out = format!("{}\n", page.title);
    for block in &page.blocks {
        out.push('\n');
        match block {
            Block::Heading(title) => {
                out += &format!("{title}\n{}\n", "-".repeat(title.chars().count()));
            }
            Block::Paragraph(sentences) => out += &wrapped(sentences, WIDTH),
            Block::Formulas(list) => {
                for (form, note) in list {
                    out += &format!("  {}\n", text::write(form));
                    if !note.is_empty() {
                        out += &format!("      [{note}]\n");
                    }
                }
            }
            Block::Table { head, rows } => out += &table(head, rows),
            Block::Figure { drawing, caption, .. } => {
                out += &format!("{}\n{}", drawing.trim_end(), wrapped(caption, WIDTH))
            }
            Block::Picture { caption, .. } => out += &wrapped(&format!("[{caption}]"), WIDTH),
            Block::Code(code) => code.lines().for_each(|line| out += &format!("  {line}\n")),
        }
    }
    out
}

/// Words in lines.
fn wrapped(text: &str, width: usize) -> String {
    let (mut out, mut column) = (String::new(), 0);
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if column > 0 && column + 1 + length > width {
            out.push('\n');
            column = 0;
        } else if column > 0 {
            out.push(' ');
            column += 1;
        }
        out += word;
        column += length;
    }
    out + "\n"
}

/// Columns as wide as their widest cell.
pub fn table(head: &[String], rows: &[Vec<String>]) -> String {
    let width = |k: usize| {
        let cells = rows.iter().filter_map(|row| row.get(k)).chain(head.get(k));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    let line = |row: &[String]| {
        let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, &w)| format!("{cell:<w$}")).collect();
        format!("  {}\n", cells.join("  ").trim_end())
    };
    let rule: Vec<String> = widths.iter().map(|&w| "-".repeat(w)).collect();
    let body: String = rows.iter().map(|row| line(row)).collect();
    line(head) + &line(&rule) + &body
}
