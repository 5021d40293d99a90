//! A page in Markdown, with formulas between dollar signs as most readers show them.
//!
//! In: a page. Out: Markdown. Figures are SVG in the text, pictures data in it.

use super::{Block, Page, base64};
use crate::teach::notation::latex;

/// The page in Markdown.
pub fn write(page: &Page) -> String {
    let mut out = format!("# {}\n", escaped(&page.title));
    for block in &page.blocks {
        out.push('\n');
        match block {
            Block::Heading(title) => out += &format!("## {}\n", escaped(title)),
            Block::Paragraph(sentences) => out += &format!("{}\n", escaped(sentences)),
            Block::Formulas(list) => {
                for (form, note) in list {
                    out += &format!("$$ {} $$\n", latex::write(form));
                    if !note.is_empty() {
                        out += &format!("\n*{}*\n\n", escaped(note));
                    }
                }
            }
            Block::Table { head, rows } => {
                let line = |row: &[String]| {
                    format!("| {} |\n", row.iter().map(|cell| escaped(cell)).collect::<Vec<String>>().join(" | "))
                };
                out += &line(head);
                out += &format!("|{}\n", " --- |".repeat(head.len()));
                rows.iter().for_each(|row| out += &line(row));
            }
            Block::Figure { svg, caption, .. } => {
                out += &format!("{}\n\n*{}*\n", svg.replace("\n\n", "\n"), escaped(caption))
            }
            Block::Picture { png, caption } => {
                out += &format!("![{}](data:image/png;base64,{})\n", escaped(caption), base64::encode(png));
            }
            Block::Code(code) => out += &format!("```text\n{}\n```\n", code.trim_end()),
        }
    }
    out
}

fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        if "\\`*_{}[]<>#|$".contains(c) {
            out.push('\\');
        }
        out.push(c);
    }
    out
}
