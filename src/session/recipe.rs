//! The program that draws a picture again.
//!
//! In: a program, what was wished besides, the plan that came of both. Out: one text without includes, in which the
//! camera, the region and the settings are statements. Read and planned again it gives the same picture, and the same
//! recipe.

use super::plan::{Method, Plan, Wishes};
use super::program::Program;
use crate::diag::{Source, Span};
use crate::expr::lower::ClipShape;
use crate::film::Tone;
use crate::render::filter::Filter;
use crate::render::{Background, Mode, Settings};
use crate::scene::view::DEFAULT_FOV;
use crate::surface::Shape;
use crate::syntax::ast::{BlockKind, Expr, Statement, StatementKind};
use crate::syntax::{MAX_TEXT, parse};
use glam::DVec3;
use std::fmt::Write;

/// What comes before the options that no statement can say.
const OPTIONS: &str = "// drawn with: ";

/// The text, or `None` if it is longer than a program may be.
pub fn recipe(program: &Program, wishes: &Wishes, plan: &Plan) -> Option<String> {
    let mut text = options(wishes, plan);
    if !text.is_empty() {
        text = format!("{OPTIONS}{}\n", text.trim_start());
    }
    let statements = parse(&program.sources.texts()).program.statements;
    for (index, source) in program.sources.list.iter().enumerate() {
        let own = statements.iter().filter(|statement| statement.span.source.0 as usize == index);
        let kept = kept(source, own, program);
        if !kept.is_empty() {
            text += &kept;
            text.push('\n');
        }
    }
    text += &camera(plan);
    text += &render(program, wishes, plan);
    (text.len() <= MAX_TEXT).then_some(text)
}

/// A text without the statements that are said anew, and with the values that were set.
fn kept<'a>(source: &Source, statements: impl Iterator<Item = &'a Statement>, program: &Program) -> String {
    let mut kept = String::new();
    let mut next = 0;
    for statement in statements {
        let replaced = match &statement.kind {
            StatementKind::Block { kind: BlockKind::Camera | BlockKind::Render, .. }
            | StatementKind::Include { .. } => Some((statement.span, String::new())),
            StatementKind::Parameter { name, value, .. } => set_value(&name.text, value, program),
            _ => None,
        };
        if let Some((span, new)) = replaced {
            kept += &source.text[next..span.start as usize];
            kept += &new;
            next = span.end as usize;
        }
    }
    kept += &source.text[next..];
    let lines = kept.lines().filter(|line| !line.starts_with(OPTIONS));
    lines.map(clean).collect::<Vec<String>>().join("\n").trim().to_owned()
}

fn set_value(name: &str, value: &Expr, program: &Program) -> Option<(Span, String)> {
    let setting = program.set.iter().rev().find(|setting| setting.name == name)?;
    Some((value.span, setting.value.to_string()))
}

/// A line without control characters, which only comments can have.
fn clean(line: &str) -> String {
    line.chars().map(|c| if c.is_control() && c != '\t' { '\u{fffd}' } else { c }).collect()
}

fn camera(plan: &Plan) -> String {
    let fov = plan.view.fov.unwrap_or(DEFAULT_FOV);
    let (eye, look_at) = (point(plan.scene.camera.eye), point(plan.scene.look_at));
    format!("camera {{ eye: {eye}, look_at: {look_at}, fov: {} }}\n", number(fov))
}

fn render(program: &Program, wishes: &Wishes, plan: &Plan) -> String {
    let mode = Mode::ALL.into_iter().find(|(_, mode)| *mode == plan.settings.mode).map_or("studio", |(name, _)| name);
    let mut text = format!("render {{ size: {}, mode: {mode}, samples: {}", plan.settings.size, plan.settings.samples);
    text += &of_light(&plan.settings);
    if let Some(clip) = clip(program, wishes, plan) {
        let _ = write!(text, ", clip: {clip}");
    }
    text + " }\n"
}

/// What else is said of the picture, where it is not as usual.
fn of_light(settings: &Settings) -> String {
    let usual = Settings::default();
    let mut text = String::new();
    if settings.bounces != usual.bounces {
        let _ = write!(text, ", bounces: {}", settings.bounces);
    }
    if settings.seed != usual.seed && i64::try_from(settings.seed).is_ok() {
        let _ = write!(text, ", seed: {}", settings.seed);
    }
    if settings.exposure != usual.exposure {
        let _ = write!(text, ", exposure: {}", number(settings.exposure));
    }
    if let (true, Some(name)) = (settings.tone != settings.mode.tone(), name_of(&Tone::CURVES, settings.tone)) {
        let _ = write!(text, ", tonemap: {name}");
    }
    if let (true, Some(name)) = (settings.filter != usual.filter, name_of(&Filter::ALL, settings.filter)) {
        let _ = write!(text, ", filter: {name}");
    }
    match settings.background {
        Background::Own => {}
        Background::Clear => text += ", background: transparent",
        Background::Sky => text += ", background: sky",
        Background::Plain(colour) => {
            let [r, g, b] = colour.to_array().map(number);
            let _ = write!(text, ", background: rgb({r}, {g}, {b})");
        }
    }
    text
}

fn name_of<T: PartialEq>(all: &[(&'static str, T)], value: T) -> Option<&'static str> {
    all.iter().find(|(_, other)| *other == value).map(|(name, _)| *name)
}

/// The region of everything: as wished, as written, or as found.
fn clip(program: &Program, wishes: &Wishes, plan: &Plan) -> Option<String> {
    if let [shape] = wishes.clip[..] {
        return Some(shape_text(&shape));
    }
    let written = program.lowered.render.as_ref().and_then(|block| block.clip).filter(|_| wishes.clip.is_empty());
    match written.map(|clip| (clip.shape, clip.span)) {
        Some((ClipShape::Box { low, high }, _)) => Some(shape_text(&Shape::Box { min: low.into(), max: high.into() })),
        Some((ClipShape::Ball { centre, radius }, _)) => {
            Some(shape_text(&Shape::Ball { center: centre.into(), radius }))
        }
        Some((ClipShape::Region(_), span)) => {
            let source = program.sources.list.get(span.source.0 as usize)?;
            let lines = source.text[span.range()].lines().map(clean);
            Some(lines.collect::<Vec<String>>().join("\n"))
        }
        None => plan.found.map(|found| shape_text(&found.shape())),
    }
}

/// A region as the option that asks for it.
pub fn region_option(shape: &Shape) -> String {
    match *shape {
        Shape::Box { min, max } => {
            let [x0, y0, z0, x1, y1, z1] = [min.x, min.y, min.z, max.x, max.y, max.z].map(number);
            format!("--box {x0},{x1},{y0},{y1},{z0},{z1}")
        }
        Shape::Ball { center, radius } => {
            let [x, y, z] = center.to_array().map(number);
            format!("--ball {x},{y},{z},{}", number(radius))
        }
    }
}

fn shape_text(shape: &Shape) -> String {
    match *shape {
        Shape::Box { min, max } => {
            let range = |k: usize| format!("{}..{}", number(min[k]), number(max[k]));
            format!("box({}, {}, {})", range(0), range(1), range(2))
        }
        Shape::Ball { center, radius } => {
            let [x, y, z] = center.to_array().map(number);
            format!("ball({x}, {y}, {z}, {})", number(radius))
        }
    }
}

/// What no statement can say, as options.
fn options(wishes: &Wishes, plan: &Plan) -> String {
    let mut text = String::new();
    if let Some(height) = plan.view.parallel_height {
        let _ = write!(text, " --ortho {}", number(height));
    }
    if i64::try_from(plan.settings.seed).is_err() {
        let _ = write!(text, " --seed {}", plan.settings.seed);
    }
    match wishes.method {
        Method::Faithful => {}
        Method::March(None) => text += " --method march",
        Method::March(Some(step)) => {
            let _ = write!(text, " --method march --step {}", number(step));
        }
    }
    if wishes.clip.len() > 1 {
        for shape in &wishes.clip {
            text.push(' ');
            text += &region_option(shape);
        }
    }
    text
}

fn point(point: DVec3) -> String {
    let [x, y, z] = point.to_array().map(number);
    format!("({x}, {y}, {z})")
}

/// The shortest digits that read back as the same number; there is one zero.
fn number(value: f64) -> String {
    let text = format!("{:?}", value + 0.0);
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Passes;
    use crate::render::Silent;
    use crate::scene::{Orbit, View};

    fn read(text: &str) -> Program {
        let program = Program::from_text(text);
        assert!(!program.has_errors(), "{text}: {:?}", program.diagnostics);
        program
    }

    fn drawn(program: &mut Program, wishes: &Wishes) -> (String, crate::render::Drawing) {
        let plan = Plan::new(program, wishes).unwrap();
        (recipe(program, wishes, &plan).unwrap(), plan.draw(&Silent).unwrap())
    }

    #[test]
    fn a_recipe_draws_the_same_picture_and_is_its_own_recipe() {
        let small = Wishes { size: crate::film::Size::new(24, 18).ok(), samples: Some(1), ..Wishes::default() };
        let orbit = View { orbit: Some(Orbit { azimuth: 10.0, elevation: 80.0, distance: None }), ..View::default() };
        let ball = Shape::Ball { center: DVec3::new(-0.5, 0.1, 1e-7), radius: 0.75 };
        let cut = Shape::Box { min: DVec3::splat(-0.8), max: DVec3::new(0.8, 1e3, 0.5) };
        let programs = [
            "x^2 + y^2 + z^2 = 1",
            "1 - x^2 - y^2 - z^2 = 0 // f < 0 outside",
            "z = sin x cos y",
            "x^2+y^2+z^2 <= 1 and not x^2+y^2 <= 0.3; camera { eye: (3, 1, 2) }; z = 2 x { clip: ball(0,0,0,1) }",
            "render { mode: depth, clip: z < 0.3 and x < 0.5 }\n\nx^2 + y^2 + z^2 = 1\n",
            "(x-50)^2 + y^2 + z^2 = 1e-6",
            "x = 0.3 { clip: box(-1..1, -1..1, -1..1) }",
        ];
        for text in programs {
            for mode in [None, Some(Mode::Depth), Some(Mode::Normal)] {
                for (view, clip) in [
                    (View::default(), vec![]),
                    (orbit, vec![]),
                    (View::default(), vec![ball]),
                    (View { fov: Some(20.0), ..View::default() }, vec![cut]),
                ] {
                    let wishes = Wishes { mode, view, clip, ..small.clone() };
                    let Ok(_) = Plan::new(&mut read(text), &wishes) else { continue };
                    let (first, picture) = drawn(&mut read(text), &wishes);
                    let (second, again) = drawn(&mut read(&first), &Wishes::default());
                    assert_eq!(first, second);
                    assert!(picture.picture == again.picture, "{text}:\n{first}");
                }
            }
        }
    }

    #[test]
    fn what_no_statement_says_is_said_as_options() {
        let view = View { parallel_height: Some(3.0), ..View::default() };
        let wishes = Wishes { view, method: Method::March(Some(0.5)), passes: Passes::Few, ..Wishes::default() };
        let mut program = read("x^2 + y^2 + z^2 = 1");
        let plan = Plan::new(&mut program, &wishes).unwrap();
        let text = recipe(&program, &wishes, &plan).unwrap();
        assert!(text.starts_with("// drawn with: --ortho 3 --method march --step 0.5\n"), "{text}");
        let mut program = read(&text);
        let plan = Plan::new(&mut program, &wishes).unwrap();
        assert_eq!(recipe(&program, &wishes, &plan).unwrap(), text);
    }

    #[test]
    fn set_values_are_written_down_and_control_characters_are_not() {
        let set = vec![crate::expr::lower::Setting {
            name: "a".into(),
            value: crate::num::rational::Rational::from_decimal("0.25").unwrap(),
        }];
        let text = "x^2+y^2+z^2 = a; // \u{1b}[31m red\r\na = 1/2 in [0, 1]".to_owned();
        let texts = vec![crate::session::Text { name: "t".into(), key: String::new(), text }];
        let mut program = Program::read(texts, set, &crate::session::NoFiles);
        let wishes = Wishes::default();
        let plan = Plan::new(&mut program, &wishes).unwrap();
        let text = recipe(&program, &wishes, &plan).unwrap();
        assert!(text.starts_with("x^2+y^2+z^2 = a; // \u{fffd}[31m red\na = 0.25 in [0, 1]\ncamera {"), "{text}");
    }
}
