//! `implicit compare`: what steps, samples and objects cost and change.
//!
//! In: programs, what is varied. Out: a table, and a sheet of pictures.

use super::args::teaching::{CompareArgs, VaryArg};
use super::clock::Clock;
use super::complaint::Complaint;
use super::output::Outputs;
use super::{console, pages, programs, render};
use crate::film::{Print, Size, Tone, png};
use crate::render::{Mode, Silent};
use crate::scene::View;
use crate::session::{Method, Plan, Program, Wishes};
use crate::teach::compare::{Comparison, Shot, Varied, compare};
use crate::teach::page::{Page, plain};
use serde_json::{Value, json};

/// The size where none is asked for: several pictures stand side by side.
const SIZE: (u64, u64) = (320, 240);

/// Steps as parts of the region's diameter, where none are asked for.
const SHARES: [f64; 3] = [1.0 / 8.0, 1.0 / 32.0, 1.0 / 256.0];

/// Numbers of samples that are compared, the most first.
const SAMPLES: [u32; 4] = [64, 1, 4, 16];

/// Numbers of scattering events that are compared, the most first.
const BOUNCES: [u32; 6] = [16, 0, 1, 2, 4, 8];

/// Compares.
///
/// # Errors
/// Errors of the programs, what cannot be varied, or a file that cannot be written.
pub fn run(args: CompareArgs) -> Result<(), Complaint> {
    pages::check(&args.page)?;
    let mut program = programs::load(&args.program)?;
    let (page, found, sheet) = build(&args, &mut program)?;
    let ending = args.page.output.as_deref().and_then(|path| path.extension()?.to_str().map(str::to_lowercase));
    match (&args.page.output, ending.as_deref()) {
        (Some(path), Some("png")) => {
            let mut outputs = Outputs::default();
            outputs.stage(path, sheet)?;
            outputs.commit()?;
            console::print(plain::write(&page).as_bytes())
        }
        _ => pages::deliver(&page, || found, &args.page),
    }
}

/// The page, the same as JSON, and the sheet as a PNG file.
///
/// # Errors
/// If there is nothing to see or to vary.
pub fn build(args: &CompareArgs, program: &mut Program) -> Result<(Page, Value, Vec<u8>), Complaint> {
    let texts = args.page.texts();
    let size = args.scene.size.or_else(|| Size::new(SIZE.0, SIZE.1).ok());
    let wishes = Wishes { size, samples: Some(1), keep_depth: true, ..args.scene.wishes() };
    let (shots, varied) = match args.vary {
        Some(VaryArg::Bounces) => (bounces(program, &wishes)?, Varied::Bounces),
        Some(VaryArg::Samples) => (samples(program, &wishes)?, Varied::Samples),
        Some(VaryArg::Objects) => (objects(program, &wishes)?, Varied::Objects),
        None => (steps(args, program, &wishes)?, Varied::Step),
    };
    let tone = plan(program, &wishes)?.settings.tone;
    let compared = compare(&shots, tone, varied)
        .ok_or_else(|| Complaint::usage("the sheet of all pictures would be too large; make --size smaller"))?;
    let sheet = png::encode(&Print::new(&compared.sheet, Tone::Data)).map_err(Complaint::program)?;
    let mut page = Page::new(texts.get("compare.title"));
    compared.write(&texts, sheet.clone(), &mut page);
    Ok((page, as_json(&compared), sheet))
}

fn plan(program: &mut Program, wishes: &Wishes) -> Result<Plan, Complaint> {
    Plan::new(program, wishes).map_err(|refusal| render::refused(refusal, program))
}

/// Draws, and takes the time.
fn shot(plan: &Plan, value: Option<f64>) -> Result<Shot, Complaint> {
    let clock = Clock::start();
    let drawing = plan.draw(&Silent).map_err(Complaint::program)?;
    Ok(Shot { value, drawing, seconds: clock.wall() })
}

fn steps(args: &CompareArgs, program: &mut Program, wishes: &Wishes) -> Result<Vec<Shot>, Complaint> {
    let faithful = plan(program, wishes)?;
    let diameter = faithful.region.iter().map(|shape| 2.0 * shape.size()).reduce(f64::min).unwrap_or(1.0);
    let list =
        args.step.as_ref().map_or_else(|| SHARES.map(|share| share * diameter).to_vec(), |steps| steps.0.clone());
    let mut shots = vec![shot(&faithful, None)?];
    for step in list {
        let marched = plan(program, &Wishes { method: Method::March(Some(step)), ..wishes.clone() })?;
        shots.push(shot(&marched, Some(step))?);
    }
    Ok(shots)
}

/// In the program's mode, if it follows light; else in the one that does so without noise.
fn bounces(program: &mut Program, wishes: &Wishes) -> Result<Vec<Shot>, Complaint> {
    let written = plan(program, wishes)?.settings.mode;
    let mode = if written.follows_light() { written } else { Mode::Whitted };
    // Noise would hide what is compared.
    let samples = if mode.is_transport() { None } else { wishes.samples };
    let draw = |count: u32| {
        let bounces = Some(count);
        let drawn = plan(program, &Wishes { mode: Some(mode), bounces, samples, ..wishes.clone() })?;
        shot(&drawn, Some(f64::from(count)))
    };
    BOUNCES.into_iter().map(draw).collect()
}

fn samples(program: &mut Program, wishes: &Wishes) -> Result<Vec<Shot>, Complaint> {
    let draw = |count: u32| {
        let drawn = plan(program, &Wishes { samples: Some(count), ..wishes.clone() })?;
        shot(&drawn, Some(f64::from(count)))
    };
    SAMPLES.into_iter().map(draw).collect()
}

/// All surfaces first, then 1, 2, 4, … of them, seen from the same place in the same region.
fn objects(program: &mut Program, wishes: &Wishes) -> Result<Vec<Shot>, Complaint> {
    let all = program.lowered.surfaces.clone();
    if all.len() < 2 {
        return Err(Complaint::usage("--vary objects needs a program of several surfaces; this one has one"));
    }
    let whole = plan(program, wishes)?;
    let camera = &whole.scene.camera;
    let view = View { eye: Some(camera.eye), look_at: Some(whole.scene.center), orbit: None, ..whole.view };
    let wishes = Wishes { clip: whole.region.clone(), view, ..wishes.clone() };
    let mut shots = vec![shot(&whole, Some(all.len() as f64))?];
    let mut count = 1;
    while count < all.len() {
        program.lowered.surfaces = all[..count].to_vec();
        let drawn = plan(program, &wishes);
        program.lowered.surfaces.clone_from(&all);
        shots.push(shot(&drawn?, Some(count as f64))?);
        count *= 2;
    }
    Ok(shots)
}

fn as_json(compared: &Comparison) -> Value {
    let row = |((value, seconds, [points, cells]), d): (
        &(Option<f64>, f64, [u64; 2]),
        &crate::teach::compare::Difference,
    )| {
        json!({
            "value": value, "seconds": seconds, "points": points, "cells": cells, "hits": d.hits, "missed": d.missed,
            "at_silhouettes": d.at_silhouettes, "extra": d.extra, "moved": d.moved, "recoloured": d.recoloured,
        })
    };
    Value::Array(compared.shots.iter().zip(&compared.differences).map(row).collect())
}
