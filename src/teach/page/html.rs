//! A page as HTML that needs no other file: MathML, SVG, and pictures as data.
//!
//! In: a page. Out: a fragment, or a whole document with its style.

use super::{Block, Page, base64};
use crate::teach::notation::mathml;
use crate::teach::svg::escaped;

const STYLE: &str = "\
body{font:17px/1.55 Georgia,'DejaVu Serif',serif;max-width:58rem;margin:2rem auto;padding:0 1rem;color:#1b1f24;background:#fff}\
h1{font-size:1.9rem;line-height:1.2}h2{font-size:1.3rem;margin-top:2.2rem}\
table{border-collapse:collapse;font:14px/1.4 'DejaVu Sans',Arial,sans-serif;margin:1rem 0;display:block;overflow-x:auto}\
th,td{text-align:left;padding:.25rem .8rem;border-bottom:1px solid #d6dbe0;white-space:nowrap}td:last-child{white-space:normal}th{border-bottom:2px solid #8a9199}\
pre{white-space:pre-wrap;background:#f4f6f8;padding:.7rem 1rem;overflow-x:auto;font:14px/1.4 'DejaVu Sans Mono',monospace}\
figure{margin:1.4rem 0}figure svg,figure img{max-width:100%;height:auto}figcaption{font-size:.9rem;color:#55606a}\
.line{display:flex;flex-wrap:wrap;gap:.3rem 1.5rem;align-items:center;justify-content:space-between;margin:.45rem 0}\
.line .formula{overflow-x:auto;overflow-y:hidden;max-width:100%;padding:.15rem 0}.note{color:#0072b2;font-size:.9rem}nav{font-size:.95rem}";

/// The page as a whole document in a language; `navigation` is HTML above the title.
pub fn document(page: &Page, language: &str, navigation: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <link rel=\"icon\" href=\"data:,\">\n<style>{STYLE}</style>\n</head>\n<body>\n{navigation}<h1>{title}</h1>\n{body}</body>\n</html>\n",
        title = escaped(&page.title),
        body = fragment(page)
    )
}

/// The page's blocks.
pub fn fragment(page: &Page) -> String {
    page.blocks.iter().map(block).collect()
}

fn block(block: &Block) -> String {
    match block {
        Block::Heading(title) => format!("<h2>{}</h2>\n", escaped(title)),
        Block::Paragraph(sentences) => format!("<p>{}</p>\n", escaped(sentences)),
        Block::Formulas(list) => {
            let line = |(form, note): &(_, String)| {
                format!(
                    "<div class=\"line\"><span class=\"formula\">{}</span><span class=\"note\">{}</span></div>\n",
                    mathml::write(form, false),
                    escaped(note)
                )
            };
            list.iter().map(line).collect()
        }
        Block::Table { head, rows } => {
            let cells = |row: &[String], tag: &str| -> String {
                row.iter().map(|cell| format!("<{tag}>{}</{tag}>", escaped(cell))).collect()
            };
            let body: String = rows.iter().map(|row| format!("<tr>{}</tr>\n", cells(row, "td"))).collect();
            format!("<table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{body}</tbody>\n</table>\n", cells(head, "th"))
        }
        Block::Figure { svg, caption, .. } => {
            format!("<figure>\n{svg}\n<figcaption>{}</figcaption>\n</figure>\n", escaped(caption))
        }
        Block::Picture { png, caption } => format!(
            "<figure>\n<img src=\"data:image/png;base64,{}\" alt=\"{caption}\">\n<figcaption>{caption}</figcaption>\n</figure>\n",
            base64::encode(png),
            caption = escaped(caption)
        ),
        Block::Code(code) => format!("<pre>{}</pre>\n", escaped(code.trim_end())),
    }
}
