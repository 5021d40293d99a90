//! A page as a whole LaTeX document that needs no more than the package amsmath.
//!
//! In: a page. Out: LaTeX. Figures are their drawings in characters.

use super::{Block, Page};
use crate::teach::notation::latex::{escaped, write as formula};

const HEAD: &str = "\\documentclass[a4paper]{article}\n\\usepackage[utf8]{inputenc}\n\\usepackage{amsmath}\n\
\\usepackage[margin=25mm]{geometry}\n\\setlength{\\parindent}{0pt}\n\\setlength{\\parskip}{6pt}\n\\allowdisplaybreaks\n\\sloppy\n";

/// Formulas longer than this, in letters of LaTeX, are set small.
const LONG: usize = 160;

/// The page as a document.
pub fn write(page: &Page) -> String {
    let mut out = format!("{HEAD}\\title{{{}}}\n\\date{{}}\n\\begin{{document}}\n\\maketitle\n", escaped(&page.title));
    for block in &page.blocks {
        out.push('\n');
        match block {
            Block::Heading(title) => out += &format!("\\section*{{{}}}\n", escaped(title)),
            Block::Paragraph(sentences) => out += &format!("{}\n", escaped(sentences)),
            Block::Formulas(list) => list.iter().for_each(|(form, note)| out += &line(&formula(form), note)),
            Block::Table { head, rows } => out += &table(head, rows),
            Block::Figure { drawing, caption, .. } => {
                out += &format!("{}\n{}\n", verbatim(drawing), escaped(caption));
            }
            Block::Picture { caption, .. } => out += &format!("[{}]\n", escaped(caption)),
            Block::Code(code) => out += &verbatim(code),
        }
    }
    out + "\\end{document}\n"
}

fn line(formula: &str, note: &str) -> String {
    let size = if formula.len() > LONG { "\\tiny" } else { "\\normalsize" };
    let note = if note.is_empty() { String::new() } else { format!("\\emph{{{}}}\\par\n", escaped(note)) };
    format!("{{{size}\n\\[ {formula} \\]\n}}\n{note}")
}

fn verbatim(text: &str) -> String {
    let ascii: String = text.chars().map(|c| if c.is_ascii() { c } else { '?' }).collect();
    format!(
        "{{\\scriptsize\n\\begin{{verbatim}}\n{}\n\\end{{verbatim}}\n}}\n",
        ascii.trim_end().replace("\\end{verbatim}", "")
    )
}

fn table(head: &[String], rows: &[Vec<String>]) -> String {
    let line = |row: &[String]| {
        let cells: Vec<String> = row.iter().map(|cell| escaped(cell)).collect();
        format!("{} \\\\\n", cells.join(" & "))
    };
    // Short pieces, because a table does not break between pages.
    let piece = |rows: &[Vec<String>]| {
        let body: String = rows.iter().map(|row| line(row)).collect();
        let columns = "l".repeat(head.len());
        format!(
            "{{\\footnotesize\\begin{{tabular}}{{{columns}}}\n{}\\hline\n{body}\\end{{tabular}}\\par}}\n",
            line(head)
        )
    };
    rows.chunks(40).map(piece).collect()
}
