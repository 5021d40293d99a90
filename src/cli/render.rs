//! The main job: programs to pictures.
//!
//! In: the arguments. Out: the files they ask for, and on standard error what was found and what it took.

use super::args::{MethodArg, RenderArgs};
use super::clock::Clock;
use super::complaint::Complaint;
use super::destination::{self, Destination};
use super::import::KEYWORD;
use super::output::Outputs;
use super::progress::{Keep, Progress};
use super::stats::{self, Stages};
use super::terminal::Terminal;
use super::{console, programs};
use crate::diag::{Diagnostic, Severity, render};
use crate::film::{Format, exr};
use crate::num::level::Simd;
use crate::render::{Background, Drawing, Pass, Passes, Settings};
use crate::scene::{Orbit, View};
use crate::session::recipe::{recipe, region_option};
use crate::session::{Method, Plan, Program, Refusal, Wishes};
use crate::surface::Shape;
use glam::DVec3;

/// Renders.
///
/// # Errors
/// What is wrong with the command line, the program or a file.
pub fn run(args: RenderArgs) -> Result<(), Complaint> {
    let clock = Clock::start();
    let destination = destination::of(&args)?;
    let mut stages = Stages::default();
    let mut program = programs::load(&args.program)?;
    stages.parsed = clock.now();
    let terminal = (destination == Destination::Terminal).then(Terminal::of_stdout);
    let is_size_said = args.size.is_some() || program.lowered.render.as_ref().is_some_and(|block| block.size.is_some());
    let own_size = terminal.as_ref().filter(|_| !is_size_said).and_then(Terminal::size);
    let wishes = Wishes { size: args.size.or(own_size), ..wishes(&args) };
    let plan = Plan::new(&mut program, &wishes).map_err(|refusal| refused(refusal, &program))?;
    check_format(&destination, &plan.settings)?;
    say_notes(&args, &program, &plan)?;
    say_region(&args, &plan);
    let notes = notes(&destination, &program, &wishes, &plan);
    stages.compiled = clock.now();
    let keep = |drawing: &Drawing| write_picture(&destination, &plan, drawing, &notes, Outputs::default())?.commit();
    let keep: Option<Keep> = if args.progressive { Some(&keep) } else { None };
    let progress = Progress::new(clock, args.program.quiet, args.time_budget, keep);
    let drawing = plan.draw(&progress);
    progress.end()?;
    let drawing = drawing.map_err(Complaint::program)?;
    stages.drawn = clock.now();
    if let Some(terminal) = terminal {
        terminal.show(&plan.settings.print(&drawing))?;
    }
    write(&args, &destination, &plan, &drawing, &notes, &mut stages, clock)?;
    say_pass(&args, &plan, drawing.pass);
    say_emptiness(&args, &drawing);
    Ok(())
}

/// What a picture says of itself: who drew it, and the program that draws it again.
fn notes(destination: &Destination, program: &Program, wishes: &Wishes, plan: &Plan) -> Vec<(&'static str, String)> {
    let mut notes = vec![("Software", format!("implicit {}", env!("CARGO_PKG_VERSION")))];
    if matches!(destination, Destination::File(_, Format::Png)) {
        notes.extend(recipe(program, wishes, plan).map(|text| (KEYWORD, text)));
    }
    notes
}

/// Encodes the picture and puts it with the other files.
fn write_picture(
    destination: &Destination,
    plan: &Plan,
    drawing: &Drawing,
    notes: &[(&'static str, String)],
    mut outputs: Outputs,
) -> Result<Outputs, Complaint> {
    if let Destination::File(path, format) = destination {
        let bytes = format.encode(&plan.settings.print(drawing), notes).map_err(Complaint::program)?;
        outputs.stage(path, bytes)?;
    }
    Ok(outputs)
}

fn write(
    args: &RenderArgs,
    destination: &Destination,
    plan: &Plan,
    drawing: &Drawing,
    notes: &[(&'static str, String)],
    stages: &mut Stages,
    clock: Clock,
) -> Result<(), Complaint> {
    let mut outputs = write_picture(destination, plan, drawing, notes, Outputs::default())?;
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
        console::say(&stats::sentences(stages, plan, drawing));
    }
    Ok(())
}

/// Says what the plan had to assume.
fn say_notes(args: &RenderArgs, program: &Program, plan: &Plan) -> Result<(), Complaint> {
    if plan.notes.is_empty() || args.program.quiet {
        return Ok(());
    }
    if args.program.strict {
        let errors: Vec<Diagnostic> =
            plan.notes.iter().cloned().map(|note| Diagnostic { severity: Severity::Error, ..note }).collect();
        return Err(Complaint::diagnostics(&errors, &program.sources));
    }
    let text = render(&plan.notes, &program.sources, console::has_colour());
    console::say(&format!("{}\n", text.trim_end()));
    Ok(())
}

/// Says which region was found.
fn say_region(args: &RenderArgs, plan: &Plan) {
    if let (Some(found), false) = (plan.found, args.program.quiet) {
        let whole = if found.is_all { "around all there is" } else { "around what is nearest to the origin" };
        console::say(&format!("note: no region was given; seen {whole}: {}\n", region_option(&found.shape())));
    }
}

/// Says what a picture lacks that the time did not suffice for.
fn say_pass(args: &RenderArgs, plan: &Plan, pass: Pass) {
    if pass != Pass::Last && !args.program.quiet {
        console::say(&format!("note: the time was up; the picture has {}\n", stats::samples(plan, pass)));
    }
}

/// Says so if no ray met a surface, and what may be the reason.
fn say_emptiness(args: &RenderArgs, drawing: &Drawing) {
    let report = drawing.report;
    let is_empty = report.misses > 0 && report.hits + report.touch + report.undecided == 0;
    if !is_empty || args.program.quiet {
        return;
    }
    let given = [
        ("--box", args.clip_box.is_some()),
        ("--ball", args.ball.is_some()),
        ("--eye", args.eye.is_some()),
        ("--look-at", args.look_at.is_some()),
        ("--orbit", args.orbit.is_some()),
    ];
    let names: Vec<&str> = given.into_iter().filter(|(_, is_given)| *is_given).map(|(name, _)| name).collect();
    let mend = match names[..] {
        [] => "a larger --size may show what is smaller than a pixel".into(),
        _ => format!("without {} the program finds what there is to see", names.join(" and ")),
    };
    console::say(&format!("note: the picture is empty, no pixel's ray meets a surface; {mend}\n"));
}

/// Refuses a picture that is larger than its file's format allows, or clear where its format is not.
fn check_format(destination: &Destination, settings: &Settings) -> Result<(), Complaint> {
    let size = settings.size;
    match destination {
        Destination::File(_, format) if settings.background == Background::Clear && !format.has_alpha() => Err(
            Complaint::usage("a jpg has no clear pixels for a transparent background; png, webp, tiff and exr have"),
        ),
        Destination::File(_, format) if size.width().max(size.height()) > format.max_side() => {
            let longest = format.max_side();
            Err(Complaint::usage(format!(
                "{size}: a file of this kind has at most {longest} pixels a side; png has more"
            )))
        }
        _ => Ok(()),
    }
}

fn wishes(args: &RenderArgs) -> Wishes {
    let in_box = args.clip_box.map(|b| Shape::Box { min: b.min.into(), max: b.max.into() });
    let in_ball = args.ball.map(|b| Shape::Ball { center: b.center.into(), radius: b.radius });
    let orbit = args.orbit.map(|o| Orbit { azimuth: o.azimuth, elevation: o.elevation, distance: o.distance });
    Wishes {
        size: args.size,
        mode: args.mode,
        samples: args.samples.and_then(|samples| u32::try_from(samples).ok()),
        bounces: args.bounces.and_then(|bounces| u32::try_from(bounces).ok()),
        seed: args.seed,
        exposure: args.exposure,
        tone: args.tonemap,
        background: args.background,
        filter: args.filter,
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
        passes: passes(args),
        simd: simd(),
    }
}

/// Coarse squares come first only if nothing is asked for that one ray a pixel has to answer.
fn passes(args: &RenderArgs) -> Passes {
    let needs_centres = args.depth.is_some() || args.normals.is_some() || args.stats_json.is_some() || args.stats;
    match (args.progressive || args.time_budget.is_some(), needs_centres) {
        (false, _) => Passes::Few,
        (true, true) => Passes::Many,
        (true, false) => Passes::CoarseFirst,
    }
}

/// The fastest instructions of this machine, or those that every machine has if `IMPLICIT_SIMD=off` asks for them.
pub fn simd() -> Simd {
    if std::env::var_os("IMPLICIT_SIMD").is_some_and(|value| value == "off") { Simd::Portable } else { Simd::best() }
}

/// What a refusal says, and its exit status.
pub fn refused(refusal: Refusal, program: &Program) -> Complaint {
    match refusal {
        Refusal::Program(diagnostics) => Complaint::diagnostics(&diagnostics, &program.sources),
        Refusal::NothingToSee(message) => Complaint::program(message),
        Refusal::Wishes(message) => Complaint::usage(message),
    }
}
