//! The main job: programs to pictures.
//!
//! In: the arguments. Out: the files they ask for, and on standard error what was found and what it took.

use super::args::{MethodArg, RenderArgs};
use super::clock::Clock;
use super::complaint::Complaint;
use super::output::{self, Outputs, STDOUT};
use super::progress::Progress;
use super::stats::{self, Stages};
use super::{console, programs};
use crate::film::{exr, png};
use crate::num::level::Simd;
use crate::render::Drawing;
use crate::scene::{Orbit, View};
use crate::session::{Method, Plan, Program, Refusal, Wishes};
use crate::surface::Shape;
use glam::DVec3;
use std::path::{Path, PathBuf};

/// Endings of pictures that the design has and this version does not.
const LATER_ENDINGS: [&str; 5] = ["jpg", "jpeg", "webp", "tiff", "tif"];

/// How a picture becomes bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Png,
    Exr,
}

/// Renders.
///
/// # Errors
/// What is wrong with the command line, the program or a file.
pub fn run(args: RenderArgs) -> Result<(), Complaint> {
    let clock = Clock::start();
    let format = check_wishes(&args)?;
    let mut stages = Stages::default();
    let mut program = programs::load(&args.program)?;
    stages.parsed = clock.now();
    let plan = Plan::new(&mut program, &wishes(&args)).map_err(|refusal| refused(refusal, &program))?;
    if let (Some(found), false) = (plan.found, args.program.quiet) {
        let whole = if found.is_all { "around all there is" } else { "around what is nearest to the origin" };
        console::say(&format!("note: no region was given; seen {whole}: {}\n", stats::region_option(&found.shape())));
    }
    stages.compiled = clock.now();
    let progress = Progress::new(clock, args.program.quiet);
    let drawing = plan.draw(&progress);
    progress.clear();
    let drawing = drawing.map_err(Complaint::program)?;
    stages.drawn = clock.now();
    write(&args, format, &plan, &drawing, &mut stages, clock)
}

fn write(
    args: &RenderArgs,
    format: Option<Format>,
    plan: &Plan,
    drawing: &Drawing,
    stages: &mut Stages,
    clock: Clock,
) -> Result<(), Complaint> {
    let mut outputs = Outputs::default();
    if let (Some(path), Some(format)) = (&args.output, format) {
        let bytes = match format {
            Format::Png => png::encode(&drawing.picture, plan.settings.mode.tone()),
            Format::Exr => exr::encode_colour(&drawing.picture),
        };
        outputs.stage(path, bytes.map_err(Complaint::program)?)?;
    }
    if let (Some(path), Some(depth)) = (&args.depth, &drawing.depth) {
        outputs.stage(path, exr::encode_depth(depth).map_err(Complaint::program)?)?;
    }
    if let (Some(path), Some(normals)) = (&args.normals, &drawing.normals) {
        outputs.stage(path, exr::encode_normals(normals).map_err(Complaint::program)?)?;
    }
    stages.encoded = clock.now();
    if let Some(path) = &args.stats_json {
        outputs.stage(path, stats::json_line(stages, plan, &drawing.report).into_bytes())?;
    }
    outputs.commit()?;
    if args.stats {
        console::say(&stats::sentences(stages, plan, &drawing.report));
    }
    Ok(())
}

/// Refuses what contradicts itself, what is not built, and files that cannot be written, before any work.
fn check_wishes(args: &RenderArgs) -> Result<Option<Format>, Complaint> {
    let outputs: Vec<&PathBuf> =
        [&args.output, &args.depth, &args.normals, &args.stats_json].into_iter().flatten().collect();
    if outputs.is_empty() {
        return Err(Complaint::usage(
            "there is nowhere to draw to: add -o picture.png (or --depth, --normals, --stats-json FILE)",
        ));
    }
    if args.step.is_some() && args.method != MethodArg::March {
        return Err(Complaint::usage("--step belongs to --method march; the faithful method takes no steps"));
    }
    for (name, is_asked) in [("--progressive", args.progressive), ("--time-budget", args.time_budget.is_some())] {
        if is_asked {
            return Err(Complaint::usage(format!("{name} is not built yet: pictures are drawn in one pass")));
        }
    }
    for (index, path) in outputs.iter().enumerate() {
        if outputs[..index].contains(path) {
            let path = output::shown(path);
            return Err(Complaint::usage(format!("'{path}' is asked for twice; every output needs a file of its own")));
        }
    }
    let format = args.output.as_deref().map(format_of).transpose()?;
    for path in [&args.depth, &args.normals].into_iter().flatten() {
        let is_device = path.starts_with("/dev");
        if path.as_os_str() == STDOUT || !is_device && format_of(path)? != Format::Exr {
            return Err(Complaint::usage(format!("'{}' must end in .exr", output::shown(path))));
        }
    }
    for path in outputs {
        output::check(path)?;
    }
    Ok(format)
}

fn format_of(path: &Path) -> Result<Format, Complaint> {
    if path.as_os_str() == STDOUT || path.starts_with("/dev") {
        return Ok(Format::Png);
    }
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    match ending.as_str() {
        "png" => Ok(Format::Png),
        "exr" => Ok(Format::Exr),
        later if LATER_ENDINGS.contains(&later) => {
            Err(Complaint::usage(format!("pictures ending in .{later} are not built yet; there are .png and .exr")))
        }
        _ => Err(Complaint::usage(format!("'{}' must end in .png or .exr", output::shown(path)))),
    }
}

fn wishes(args: &RenderArgs) -> Wishes {
    let in_box = args.clip_box.map(|b| Shape::Box { min: b.min.into(), max: b.max.into() });
    let in_ball = args.ball.map(|b| Shape::Ball { center: b.center.into(), radius: b.radius });
    let orbit = args.orbit.map(|o| Orbit { azimuth: o.azimuth, elevation: o.elevation, distance: o.distance });
    Wishes {
        size: args.size,
        mode: args.mode,
        samples: args.samples,
        view: View {
            eye: args.eye.map(DVec3::from),
            orbit,
            look_at: args.look_at.map(DVec3::from),
            fov: args.fov,
            parallel_height: args.ortho,
        },
        clip: in_box.into_iter().chain(in_ball).collect(),
        method: match args.method {
            MethodArg::Faithful => Method::Faithful,
            MethodArg::March => Method::March(args.step),
        },
        threads: args.threads.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from)),
        keep_depth: args.depth.is_some(),
        keep_normals: args.normals.is_some(),
        simd: simd(),
    }
}

/// The fastest instructions of this machine, or those that every machine has if `IMPLICIT_SIMD=off` asks for them.
pub fn simd() -> Simd {
    if std::env::var_os("IMPLICIT_SIMD").is_some_and(|value| value == "off") { Simd::Portable } else { Simd::best() }
}

fn refused(refusal: Refusal, program: &Program) -> Complaint {
    match refusal {
        Refusal::Program(diagnostics) => Complaint::diagnostics(&diagnostics, &program.sources),
        Refusal::NothingToSee(message) => Complaint::program(message),
        Refusal::Wishes(message) => Complaint::usage(message),
    }
}
