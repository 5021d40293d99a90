//! How well to draw, and how light is shown: what the command line says, else the program, else what is usual.
//!
//! In: the render block and the wishes. Out: settings; or what is wrong with a name in the block. Separate from the plan, which is
//! about what is seen.

use super::matter;
use super::plan::{Refusal, Wishes};
use super::program::Program;
use crate::diag::{Diagnostic, Severity};
use crate::expr::lower;
use crate::film::{Size, Tone};
use crate::render::filter::Filter;
use crate::render::settings::DEFAULT_BOUNCES;
use crate::render::{Background, Mode, Settings};

/// What to draw, and how well.
///
/// # Errors
/// If a name in the program is none, or its picture is too large.
pub(super) fn settings(program: &Program, wishes: &Wishes) -> Result<Settings, Refusal> {
    let block = program.lowered.render.as_ref();
    let refuse = |message: String| {
        let span = block.map(|render| render.span).unwrap_or_default();
        Refusal::Program(vec![Diagnostic::error(span, message)])
    };
    let size = match (wishes.size, block.and_then(|render| render.size)) {
        (Some(size), _) => size,
        (None, Some((w, h))) => Size::new(w.into(), h.into()).map_err(|e| refuse(e.to_string()))?,
        (None, None) => Size::default(),
    };
    let mode = match (wishes.mode, block.and_then(|render| render.mode.as_ref())) {
        (Some(mode), _) => mode,
        (None, Some(word)) => Mode::from_name(&word.name).ok_or_else(|| unknown(word, "mode", &Mode::ALL))?,
        (None, None) => Mode::default(),
    };
    let tone = match (wishes.tone, block.and_then(|render| render.tonemap.as_ref())) {
        _ if mode.tone() == Tone::Data => Tone::Data,
        (Some(tone), _) => tone,
        (None, Some(word)) => Tone::from_name(&word.name).ok_or_else(|| unknown(word, "tone curve", &Tone::CURVES))?,
        (None, None) => mode.tone(),
    };
    if wishes.filter.is_some() && !mode.is_transport() {
        let name = Mode::ALL.into_iter().find(|(_, other)| *other == mode).map_or("this", |(name, _)| name);
        return Err(Refusal::Wishes(format!("mode {name} makes no use of --filter; {WHERE_FILTERS_COUNT}")));
    }
    let filter = match (wishes.filter, block.and_then(|render| render.filter.as_ref())) {
        (Some(filter), _) => filter,
        (None, Some(word)) => Filter::from_name(&word.name).ok_or_else(|| unknown(word, "filter", &Filter::ALL))?,
        (None, None) => Filter::default(),
    };
    let exposure = wishes.exposure.or(block.and_then(|render| render.exposure)).unwrap_or(0.0);
    let written = block.and_then(|render| render.background).map(background);
    let background = wishes.background.or(written).filter(|_| mode.has_background()).unwrap_or_default();
    let samples = wishes.samples.or(block.and_then(|render| render.samples)).unwrap_or_else(|| mode.default_samples());
    let bounces = wishes.bounces.or(block.and_then(|render| render.bounces)).unwrap_or(DEFAULT_BOUNCES);
    let seed = wishes.seed.or(block.and_then(|render| render.seed)).unwrap_or(0);
    let threads = wishes.threads.max(1);
    let Wishes { keep_depth, keep_normals, passes, .. } = *wishes;
    Ok(Settings {
        size,
        mode,
        samples,
        bounces,
        seed,
        filter,
        tone,
        exposure,
        background,
        threads,
        keep_depth,
        keep_normals,
        passes,
    })
}

fn background(written: lower::Background) -> Background {
    match written {
        lower::Background::Color(color) => Background::Plain(matter::linear(color)),
        lower::Background::Transparent => Background::Clear,
        lower::Background::Sky => Background::Sky,
    }
}

/// A background as `render { background: … }` reads it.
///
/// # Errors
/// What is wrong with it.
pub fn read_background(text: &str) -> Result<Background, String> {
    let other = || "write a name, #rrggbb, rgb(1, 0.5, 0), transparent or sky".to_owned();
    // One value: nothing that ends the entry, the block or the statement or names another entry, and no comment.
    if text.contains(['{', '}', ':', ';', '"', '\n', '\r']) || text.contains("//") {
        return Err(other());
    }
    let program = Program::from_text(&format!("render {{ background: {} }}", text.trim()));
    let wrong = program.diagnostics.iter().find(|diagnostic| diagnostic.severity == Severity::Error);
    match (wrong, program.lowered.render.and_then(|block| block.background)) {
        (None, Some(written)) => Ok(background(written)),
        (Some(wrong), _) => Err(format!("{}; {}", wrong.message, wrong.help.clone().unwrap_or_else(other))),
        (None, None) => Err(other()),
    }
}

/// Says what the program asks for in a mode that makes no use of it.
pub(super) fn without_use(program: &Program, wishes: &Wishes, mode: Mode) -> Vec<Diagnostic> {
    background_without_use(program, wishes, mode).into_iter().chain(filter_without_use(program, mode)).collect()
}

fn filter_without_use(program: &Program, mode: Mode) -> Option<Diagnostic> {
    let block = program.lowered.render.as_ref().filter(|render| render.filter.is_some() && !mode.is_transport())?;
    Some(Diagnostic::note(block.span, "this mode makes no use of `filter`").help(WHERE_FILTERS_COUNT))
}

/// Elsewhere only edges have several samples, which lie all in their own pixel.
const WHERE_FILTERS_COUNT: &str =
    "`path`, `light` and `bidirectional` do; the others smooth only edges, by samples of the pixel itself";

fn background_without_use(program: &Program, wishes: &Wishes, mode: Mode) -> Option<Diagnostic> {
    let block = program.lowered.render.as_ref();
    let is_asked_for = wishes.background.is_some() || block.is_some_and(|render| render.background.is_some());
    if !is_asked_for || mode.has_background() {
        return None;
    }
    let span = block.map(|render| render.span).unwrap_or_default();
    let note = Diagnostic::note(span, "this mode makes no use of `background`");
    let note = note.help("`studio`, `cosine` and `mirror` do; the modes that follow light show the sky");
    Some(if wishes.background.is_some() { Diagnostic { labels: Vec::new(), ..note } } else { note })
}

fn unknown<T>(word: &lower::Word, what: &str, all: &[(&'static str, T)]) -> Refusal {
    let names: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
    let name = crate::diag::printable(&word.name, 40);
    let diagnostic = Diagnostic::error(word.span, format!("there is no {what} '{name}'"));
    Refusal::Program(vec![diagnostic.help(format!("there are {}", names.join(", ")))])
}
