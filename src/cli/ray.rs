//! `implicit ray`: the story of one ray.
//!
//! In: programs, a pixel or a start and a direction. Out: a page.

use super::args::teaching::RayArgs;
use super::complaint::Complaint;
use super::{pages, programs, render};
use crate::expr::lower::Kind;
use crate::scene::studio;
use crate::session::{Plan, Program};
use crate::surface::{Hit, Method, Outcome, Ray, Tracer};
use crate::teach::page::Page;
use crate::teach::ray::march::{Iterate, MAX_SAMPLES};
use crate::teach::ray::{Question, Story, Verdict};
use glam::DVec3;
use serde_json::{Value, json};

/// The march's step, as a part of the stretch that is looked at, where none is asked for.
const STEP_SHARE: f64 = 1.0 / 32.0;

/// Tells the story.
///
/// # Errors
/// Errors of the programs, a ray that meets nothing of the region, or a file that cannot be written.
pub fn run(args: RayArgs) -> Result<(), Complaint> {
    pages::check(&args.page)?;
    let mut program = programs::load(&args.program)?;
    let (page, found) = build(&args, &mut program)?;
    pages::deliver(&page, || found, &args.page)
}

/// The page, and the same as JSON.
///
/// # Errors
/// If there is nothing to see, or the ray does not meet the region.
pub fn build(args: &RayArgs, program: &mut Program) -> Result<(Page, Value), Complaint> {
    let texts = args.page.texts();
    let plan = Plan::new(program, &args.scene.wishes()).map_err(|refusal| render::refused(refusal, program))?;
    let (origin, direction) = given(args, &plan)?;
    let length = direction.length();
    if !(length > 0.0 && length.is_finite() && (length * length).is_normal()) {
        return Err(Complaint::usage(
            "--direction must have a length that is neither 0 nor too large or small to be computed with",
        ));
    }
    let ray = Ray::new(origin, direction / length);
    let (t0, t1) = span(&plan, &ray).ok_or_else(|| {
        Complaint::program("the ray does not meet the region that is seen; --box or --ball say another one")
    })?;
    let span = (t0 / length, t1 / length);
    let step = args.step.unwrap_or((span.1 - span.0) * STEP_SHARE);
    if (span.1 - span.0) / step > MAX_SAMPLES as f64 {
        return Err(Complaint::usage(format!("--step is so small that the ray has more than {MAX_SAMPLES} samples")));
    }
    let hit = traced(&plan, ray);
    let surface = &program.lowered.surfaces[hit.surface as usize];
    let (f, is_solid) = (surface.f, surface.kind == Kind::Solid);
    let light = studio::shoulder(&plan.scene.camera);
    let question = Question { origin, direction, span, step, ior: args.ior, light, is_solid };
    let story = Story::tell(&mut program.lowered.graph, f, question, verdict(&hit, length));
    let mut page = Page::new(texts.get("ray.title"));
    story.write(&texts, &mut page);
    Ok((page, as_json(&story)))
}

/// Start and direction, as given.
fn given(args: &RayArgs, plan: &Plan) -> Result<(DVec3, DVec3), Complaint> {
    if let (Some(from), Some(direction)) = (args.from, args.direction) {
        return Ok((from.into(), direction.into()));
    }
    let [i, j] = args.pixel.unwrap_or_default();
    let size = plan.settings.size;
    if i >= size.width() || j >= size.height() {
        return Err(Complaint::usage(format!("--pixel {i},{j} is outside a picture of {size}; pixels count from 0")));
    }
    let ray = plan.scene.camera.ray(size.width(), size.height(), f64::from(i) + 0.5, f64::from(j) + 0.5);
    Ok((ray.origin, ray.direction))
}

/// The part of the ray that is in the region, t ≥ 0; `None` if it is no more than a point.
fn span(plan: &Plan, ray: &Ray) -> Option<(f64, f64)> {
    let (mut t0, mut t1) = (0.0f64, f64::INFINITY);
    for shape in &plan.region {
        let (a, b) = shape.span(ray)?;
        (t0, t1) = (t0.max(a), t1.min(b));
    }
    (t0 < t1 && t1.is_finite()).then_some((t0, t1))
}

fn traced(plan: &Plan, ray: Ray) -> Hit {
    let mut hits = Vec::new();
    Tracer::new(&plan.surfaces, Method::Faithful).trace(&[ray], &mut hits);
    hits.pop().unwrap_or(Hit::NONE)
}

fn verdict(hit: &Hit, length: f64) -> Verdict {
    let outcome = match hit.outcome {
        Outcome::Miss => "verdict.miss",
        Outcome::Hit => "verdict.hit",
        Outcome::Touch => "verdict.touch",
        Outcome::Undecided => "verdict.undecided",
    };
    Verdict { outcome, is_proven: hit.proven, t: hit.t / length, normal: hit.normal, is_flipped: hit.flipped }
}

/// A number as JSON has them; what it has not, as text.
fn number(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { json!(value.to_string().to_lowercase()) }
}

fn as_json(story: &Story) -> Value {
    let vector = |v: DVec3| Value::Array(v.to_array().into_iter().map(number).collect());
    let iterate = |i: &Iterate| json!({ "t": number(i.t), "g": number(i.g), "slope": number(i.slope), "left": i.left, "order": i.order });
    let brackets: Vec<Value> = story
        .brackets
        .iter()
        .map(|b| json!({ "a": b.a, "b": b.b, "newton": b.iterates.iter().map(iterate).collect::<Vec<Value>>() }))
        .collect();
    let pieces: Vec<Value> = story
        .proof
        .pieces
        .iter()
        .map(|p| json!({ "a": p.a, "b": p.b, "lo": number(p.range.lo), "hi": number(p.range.hi), "finding": format!("{:?}", p.finding).to_lowercase(), "count": p.count }))
        .collect();
    let roots: Vec<Value> =
        story.proof.roots.iter().map(|r| json!({ "t": r.t, "bracket": [r.bracket.0, r.bracket.1] })).collect();
    let light = story.optics.map(|o| {
        json!({
            "normal": vector(o.normal), "incidence": o.incidence, "reflected": vector(o.reflected),
            "refracted": o.refracted.map(|(d, _)| vector(d)), "fresnel": o.exact, "schlick": o.schlick,
            "cosine": o.cosine, "mirror": o.mirror,
        })
    });
    json!({
        "origin": vector(story.question.origin), "direction": vector(story.question.direction),
        "span": [story.question.span.0, story.question.span.1], "step": story.question.step,
        "starts_on_surface": story.starts_on_surface,
        "samples": story.samples.iter().map(|&(t, g)| json!([number(t), number(g)])).collect::<Vec<Value>>(),
        "brackets": brackets, "pieces": pieces, "roots": roots, "complete": story.proof.is_complete,
        "missed": story.missed(), "no_roots": story.mistaken().iter().map(|&(a, b)| json!([a, b])).collect::<Vec<Value>>(),
        "tracer": { "outcome": story.verdict.outcome.trim_start_matches("verdict."), "proven": story.verdict.is_proven, "t": number(story.verdict.t) },
        "light": light,
    })
}
