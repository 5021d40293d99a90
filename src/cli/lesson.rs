//! `implicit lesson`: the lessons, on the terminal or as pages.
//!
//! In: a number, a language, a folder. Out: the lesson with what its commands show; or HTML files that need no others.

use super::args::teaching::{CompareArgs, ExplainArgs, LessonArgs, RayArgs};
use super::args::{self, RenderArgs};
use super::complaint::{Complaint, Status};
use super::output::Outputs;
use super::{compare, console, explain, programs, ray, render};
use crate::film::{Size, png};
use crate::render::Silent;
use crate::scene::{Orbit, View};
use crate::session::{Plan, Wishes};
use crate::teach::lessons::{LESSONS, Lesson, PROGRAM};
use crate::teach::page::{Block, Page, html, plain};
use crate::teach::svg::escaped;
use crate::teach::texts::Texts;
use std::ffi::OsString;
use std::fs;
use std::path::Path;

/// Shows lessons.
///
/// # Errors
/// If a folder cannot be written to.
pub fn run(args: LessonArgs) -> Result<(), Complaint> {
    let texts = Texts::of(&args.language).unwrap_or_else(Texts::english);
    let chosen: Vec<&Lesson> = match args.number {
        Some(number) => LESSONS.iter().skip(number as usize - 1).take(1).collect(),
        None => LESSONS.iter().collect(),
    };
    match (&args.html, args.number) {
        (Some(folder), _) => write(folder, &chosen, &texts),
        (None, Some(_)) => {
            let pages = chosen.iter().map(|lesson| page(lesson, &texts)).collect::<Result<Vec<Page>, Complaint>>()?;
            console::print(pages.iter().map(plain::write).collect::<String>().as_bytes())
        }
        (None, None) => console::print(list(&texts).as_bytes()),
    }
}

fn list(texts: &Texts) -> String {
    let line = |lesson: &Lesson| format!("  {}  {}\n", lesson.number(), lesson.title(texts));
    let lines: String = LESSONS.iter().map(line).collect();
    format!("{}\n\n{lines}\n{}\n", texts.get("lesson.all"), texts.get("lesson.how"))
}

fn page(lesson: &Lesson, texts: &Texts) -> Result<Page, Complaint> {
    lesson.page(texts, |command| shown(lesson, command, texts))
}

/// What a command of a lesson shows.
fn shown(lesson: &Lesson, command: &str, texts: &Texts) -> Result<Vec<Block>, Complaint> {
    let words: Vec<&str> = command.split(' ').collect();
    let (name, rest) = match words.split_first() {
        Some((&name, rest)) if name != PROGRAM => (name, rest),
        _ => ("", &words[..]),
    };
    let text = |word: &&str| OsString::from(if *word == PROGRAM { lesson.program } else { word });
    let language = ["--language", texts.code].map(OsString::from);
    let argv: Vec<OsString> = std::iter::once("implicit".into()).chain(rest.iter().map(text)).collect();
    let spoken: Vec<OsString> = argv.iter().cloned().chain(language).collect();
    match name {
        "explain" => {
            let args: ExplainArgs = read(&spoken)?;
            Ok(explain::build(&args, &mut programs::load(&args.program)?)?.0.blocks)
        }
        "ray" => {
            let args: RayArgs = read(&spoken)?;
            Ok(ray::build(&args, &mut programs::load(&args.program)?)?.0.blocks)
        }
        "compare" => {
            let args: CompareArgs = read(&spoken)?;
            Ok(compare::build(&args, &mut programs::load(&args.program)?)?.0.blocks)
        }
        _ => picture(&read(&argv)?, texts),
    }
}

fn read<T: clap::Parser>(argv: &[OsString]) -> Result<T, Complaint> {
    args::read(argv).map_err(|refusal| Complaint::worded(Status::Fault, refusal.text))
}

fn picture(args: &RenderArgs, texts: &Texts) -> Result<Vec<Block>, Complaint> {
    let mut program = programs::load(&args.program)?;
    let size = args.size.or_else(|| Size::new(480, 360).ok());
    let orbit = args.orbit.map(|o| Orbit { azimuth: o.azimuth, elevation: o.elevation, distance: o.distance });
    let view = View { orbit, ..View::default() };
    let wishes = Wishes { size, mode: args.mode, view, threads: 2, simd: render::simd(), ..Wishes::default() };
    let plan = Plan::new(&mut program, &wishes).map_err(|refusal| render::refused(refusal, &program))?;
    let drawing = plan.draw(&Silent).map_err(Complaint::program)?;
    let png = png::encode(&plan.settings.print(&drawing)).map_err(Complaint::program)?;
    Ok(vec![Block::Picture { png, caption: texts.get("lesson.picture").into() }])
}

/// Writes the pages, and one that lists them if they are all there.
fn write(folder: &Path, chosen: &[&Lesson], texts: &Texts) -> Result<(), Complaint> {
    let mut outputs = Outputs::default();
    let pages = chosen.iter().map(|lesson| page(lesson, texts)).collect::<Result<Vec<Page>, Complaint>>()?;
    fs::create_dir_all(folder).map_err(|error| {
        Complaint::program(format!("cannot make '{}': {}", super::output::shown(folder), console::reason(&error)))
    })?;
    let is_all = chosen.len() == LESSONS.len();
    for (lesson, page) in chosen.iter().zip(&pages) {
        let navigation = if is_all { navigation(lesson, texts) } else { String::new() };
        let text = html::document(page, texts.code, &navigation);
        outputs.stage(&folder.join(format!("{}.html", lesson.name)), text.into_bytes())?;
    }
    if is_all {
        outputs.stage(&folder.join("index.html"), index(texts).into_bytes())?;
    }
    outputs.commit()
}

fn link(lesson: &Lesson, texts: &Texts) -> String {
    format!("<a href=\"{}.html\">{}</a>", lesson.name, escaped(&lesson.title(texts)))
}

/// The lessons before and behind.
fn navigation(lesson: &Lesson, texts: &Texts) -> String {
    let place = LESSONS.iter().position(|other| other.name == lesson.name).unwrap_or(0);
    let all = format!("<a href=\"index.html\">{}</a>", escaped(texts.get("lesson.all")));
    let before = place.checked_sub(1).map(|k| format!("← {}", link(&LESSONS[k], texts)));
    let behind = LESSONS.get(place + 1).map(|next| format!("{} →", link(next, texts)));
    let list: Vec<String> = before.into_iter().chain([all]).chain(behind).collect();
    format!("<nav>{}</nav>\n", list.join(" · "))
}

fn index(texts: &Texts) -> String {
    let list: String =
        LESSONS.iter().map(|lesson| format!("<p>{} {}</p>\n", lesson.number(), link(lesson, texts))).collect();
    let page = Page::new(texts.get("lesson.all"));
    html::document(&page, texts.code, "").replace("</body>", &format!("{list}</body>"))
}
