//! What is taught as a page: headings, sentences, formulas, tables, figures.
//!
//! In: blocks, in order. Out: the same page for a terminal ([`plain`]), in [`markdown`], [`latex`] and [`html`]. Separate so
//! that every command says what it has to say once.

pub mod base64;
pub mod html;
pub mod latex;
pub mod markdown;
pub mod plain;

use super::notation::Form;

/// A piece of a page.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A heading.
    Heading(String),
    /// Sentences.
    Paragraph(String),
    /// Formulas below each other, each with what is said about it.
    Formulas(Vec<(Form, String)>),
    /// Rows below a head.
    Table {
        /// What the columns are.
        head: Vec<String>,
        /// Their cells.
        rows: Vec<Vec<String>>,
    },
    /// A line drawing.
    Figure {
        /// As one SVG element.
        svg: String,
        /// In characters of ASCII, for a terminal.
        drawing: String,
        /// What it shows.
        caption: String,
    },
    /// A picture.
    Picture {
        /// The bytes of a PNG file.
        png: Vec<u8>,
        /// What it shows.
        caption: String,
    },
    /// Text as it is typed.
    Code(String),
}

/// A page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Page {
    /// What it is about.
    pub title: String,
    /// What it says.
    pub blocks: Vec<Block>,
}

impl Page {
    /// An empty page.
    pub fn new(title: impl Into<String>) -> Page {
        Page { title: title.into(), blocks: Vec::new() }
    }

    /// Adds a heading.
    pub fn heading(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Heading(text.into()));
    }

    /// Adds sentences.
    pub fn say(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Paragraph(text.into()));
    }

    /// Adds one formula without a word.
    pub fn formula(&mut self, form: Form) {
        self.blocks.push(Block::Formulas(vec![(form, String::new())]));
    }

    /// Adds a table.
    pub fn table(&mut self, head: &[&str], rows: Vec<Vec<String>>) {
        self.blocks.push(Block::Table { head: head.iter().map(|&cell| cell.to_owned()).collect(), rows });
    }

    /// The line drawings, in order.
    pub fn figures(&self) -> impl Iterator<Item = &str> {
        self.blocks
            .iter()
            .filter_map(|block| if let Block::Figure { svg, .. } = block { Some(svg.as_str()) } else { None })
    }
}

/// A number for people: six digits, without zeros that say nothing.
pub fn shown(value: f64) -> String {
    digits(value, 6)
}

/// A number with so many digits.
pub fn digits(value: f64, count: usize) -> String {
    let size = value.abs();
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() || !(1e-4..1e9).contains(&size) {
        let text = format!("{value:.*e}", count.saturating_sub(1));
        return match text.split_once('e') {
            Some((mantissa, exponent)) if mantissa.contains('.') => {
                format!("{}e{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
            }
            _ => text.to_lowercase(),
        };
    }
    // The exponent by its text: exact, and no logarithm.
    let exponent: i32 = format!("{size:e}").split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    let behind = usize::try_from(count as i32 - 1 - exponent).unwrap_or(0);
    let text = format!("{value:.behind$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests;
