//! This tracer beside its peers, scene by scene.
//!
//! In: scenes, and the peers that are installed. Out: the tables, in Markdown. Everything of a scene runs in turn,
//! round after round, so that what else the machine does falls on all alike; medians count.

use crate::Outcome;
use crate::clock::median;
use crate::ours::{self, Run};
use crate::process::Usage;
use crate::scenes::{Clip, Scene};
use crate::voxels::{Engine, Voxels};
use crate::{agreement, native_cost, povray, program, surf};
use std::path::{Path, PathBuf};

/// Pixels across of the pictures in this process, and of those of whole processes.
const SIZE: u32 = 1024;
const PROCESS_SIZE: u32 = 512;

/// Where POV-Ray's whole picture would take too long, a picture this size stands for it.
const SMALL_SIZE: u32 = 128;

/// Seconds after which a measurement is not repeated.
const SLOW: f64 = 4.0;

/// Everything a measurement needs.
pub struct Bench {
    pub program: PathBuf,
    pub surf: Option<&'static str>,
    pub has_povray: bool,
    pub rounds: usize,
    pub folder: PathBuf,
}

/// What fidget took and how much of it is right.
struct Peer {
    seconds: [f64; 2],
    right: f64,
}

/// How many times faster the tracer is to be than the better engine of fidget, and than surf's whole process.
const FIDGET_GOAL: f64 = 10.0;
const SURF_GOAL: f64 = 8.0;

/// The goal beside fidget for the many objects of csg27.
const OBJECTS_GOAL: f64 = 3.0;

/// How many evaluations of f with gradient a hit may take.
const EVALUATIONS_GOAL: f64 = 2.1;

/// How many times less user time the program is to take than surf, and than POV-Ray.
const SURF_PROCESS_GOAL: f64 = 4.0;
const POVRAY_GOAL: f64 = 20.0;

/// A column that is not there.
const NONE: &str = "–";

fn cell<T>(value: Option<T>, show: impl FnOnce(T) -> String) -> String {
    value.map_or(NONE.into(), show)
}

fn ratio(value: f64) -> String {
    if value < 100.0 { format!("{value:.1}") } else { format!("{value:.0}") }
}

/// Bold where a goal is missed.
pub fn mark(text: String, is_met: bool) -> String {
    if is_met { text } else { format!("**{text}**") }
}

/// A ratio that is to be `goal` or more.
fn speedup(value: f64, goal: f64) -> String {
    mark(ratio(value), value >= goal)
}

fn percent(share: f64) -> String {
    format!("{:.2} %", 100.0 * share)
}

/// The table of primary visibility and normals.
pub fn visibility(bench: &Bench, scenes: &[&Scene]) -> Outcome<String> {
    let mut text = String::from(
        "| scene | ns/pixel | ns/hit | f,g/hit | enclosures/pixel | by squares | proven | × native | fidget JIT, ns/pixel | fidget VM, \
         ns/pixel | fidget right | × fidget | surf, ns/pixel | × surf |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for scene in scenes {
        eprintln!("{}: in this process, {SIZE} x {SIZE}", scene.name);
        text += &visibility_row(bench, scene)?;
    }
    Ok(text)
}

fn visibility_row(bench: &Bench, scene: &Scene) -> Outcome<String> {
    let (surfaces, camera, voxels) = (ours::surfaces(&scene.formula, scene.clip), scene.camera(), Voxels::new(scene));
    let surf = bench.surf.filter(|_| scene.degree > 0);
    let (mut runs, mut process) = (Vec::new(), Vec::new());
    let (mut times, mut images) = ([Vec::new(), Vec::new()], [None, None]);
    for _ in 0..bench.rounds {
        runs.push(ours::trace(&surfaces, &camera, SIZE));
        for (k, engine) in [Engine::Compiled, Engine::Interpreted].into_iter().enumerate() {
            if let Some(voxels) = voxels.as_ref().filter(|_| is_quick(&times[k])) {
                let (image, seconds) = voxels.draw(engine, SIZE);
                times[k].push(seconds);
                images[k] = Some(image);
            }
        }
        if let Some(surf) = surf {
            process.push(surf::draw(surf, scene, SIZE, &bench.folder)?.0.user);
        }
    }
    runs.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let peer = voxels.map(|voxels| {
        let seconds = [median(&times[0]), median(&times[1])];
        let better = usize::from(seconds[1] < seconds[0]);
        Peer { seconds, right: images[better].as_ref().map_or(0.0, |image| voxels.agreement(image, SIZE)) }
    });
    Ok(visibility_line(scene, runs[runs.len() / 2], peer.as_ref(), surf.map(|_| median(&process))))
}

fn is_quick(times: &[f64]) -> bool {
    times.first().is_none_or(|&first| first < SLOW)
}

fn visibility_line(scene: &Scene, run: Run, peer: Option<&Peer>, surf: Option<f64>) -> String {
    let fidget_goal = if scene.name == "csg27" { OBJECTS_GOAL } else { FIDGET_GOAL };
    let (pixels, hits) = (run.pixels as f64, run.hits as f64);
    let per_pixel = |seconds: f64| format!("{:.0}", seconds * 1e9 / pixels);
    let evaluations = run.counts.gradients as f64 / hits;
    let per_hit = run.seconds * 1e9 / hits;
    format!(
        "| {} | {} | {per_hit:.0} | {} | {:.1} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
        scene.name,
        per_pixel(run.seconds),
        mark(format!("{evaluations:.2}"), evaluations <= EVALUATIONS_GOAL),
        run.counts.cells as f64 / pixels,
        percent(1.0 - run.counts.singles as f64 / pixels),
        percent(run.proven as f64 / pixels),
        cell(native_cost::of_scene(&scene.name), |native| ratio(per_hit / native)),
        cell(peer.map(|peer| peer.seconds[0]), per_pixel),
        cell(peer.map(|peer| peer.seconds[1]), per_pixel),
        cell(peer.map(|peer| peer.right), verdict),
        cell(peer, |peer| {
            let value = peer.seconds[0].min(peer.seconds[1]) / run.seconds;
            mark(ratio(value), value >= fidget_goal || peer.right < agreement::RIGHT)
        }),
        cell(surf, per_pixel),
        cell(surf.map(|surf| surf / run.seconds), |value| speedup(value, SURF_GOAL)),
    )
}

fn verdict(share: f64) -> String {
    if share >= agreement::RIGHT { percent(share) } else { format!("**no**, {}", percent(share)) }
}

/// The table of whole processes.
pub fn processes(bench: &Bench, scenes: &[&Scene]) -> Outcome<String> {
    let mut text = String::from(
        "| scene | implicit, s | surf, s | surf right | × surf | implicit, s | POV-Ray, s | POV-Ray right | × POV-Ray |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for scene in scenes {
        eprintln!("{}: whole processes, {PROCESS_SIZE} x {PROCESS_SIZE}", scene.name);
        let surf = match bench.surf.filter(|_| scene.degree > 0) {
            Some(surf) => surf_cells(bench, surf, scene)?,
            None => [NONE, NONE, NONE, NONE].join(" | "),
        };
        let povray = if bench.has_povray { povray_cells(bench, scene)? } else { [NONE, NONE, NONE, NONE].join(" | ") };
        text += &format!("| {} | {surf} | {povray} |\n", scene.name);
    }
    Ok(text)
}

fn ours(bench: &Bench, scene: &Scene, clip: Clip) -> Outcome<Usage> {
    let task = program::Task { formula: &scene.formula, clip, eye: scene.eye, size: PROCESS_SIZE, threads: 1 };
    program::draw(&bench.program, task, &bench.folder)
}

/// Both cut by the ball around the clip: surf knows no box that is turned.
fn surf_cells(bench: &Bench, surf: &str, scene: &Scene) -> Outcome<String> {
    let ball = Clip::Ball(scene.clip.radius());
    let (mut own, mut other, mut hits) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..bench.rounds.max(5) {
        own.push(ours(bench, scene, ball)?.user);
        let (usage, drawn) = surf::draw(surf, scene, PROCESS_SIZE, &bench.folder)?;
        other.push(usage.user);
        hits = drawn;
    }
    let right = mask_share(scene, ball, PROCESS_SIZE, &hits);
    let (own, other) = (median(&own), median(&other));
    Ok(format!("{own:.3} | {other:.3} | {} | {}", verdict(right), speedup(other / own, SURF_PROCESS_GOAL)))
}

fn povray_cells(bench: &Bench, scene: &Scene) -> Outcome<String> {
    povray::prepare(scene, false, &bench.folder)?;
    let empty = povray::draw(SMALL_SIZE, &bench.folder)?.0.user;
    povray::prepare(scene, true, &bench.folder)?;
    let (usage, mut hits) = povray::draw(SMALL_SIZE, &bench.folder)?;
    let growth = f64::from((PROCESS_SIZE / SMALL_SIZE).pow(2));
    let whole = (usage.user - empty).max(0.0) * growth;
    let mut own = vec![ours(bench, scene, scene.clip)?.user];
    if hits.is_none() || whole > SLOW {
        for _ in 1..bench.rounds {
            own.push(ours(bench, scene, scene.clip)?.user);
        }
        let own = median(&own);
        let sign = if hits.is_some() { "~" } else { ">" };
        let right = cell(hits.map(|hits| mask_share(scene, scene.clip, SMALL_SIZE, &hits)), verdict);
        return Ok(format!("{own:.3} | {sign} {whole:.1} | {right} | {sign} {}", speedup(whole / own, POVRAY_GOAL)));
    }
    let mut other = Vec::new();
    for _ in 0..bench.rounds {
        let (usage, drawn) = povray::draw(PROCESS_SIZE, &bench.folder)?;
        other.push(usage.user);
        hits = drawn;
        own.push(ours(bench, scene, scene.clip)?.user);
    }
    let (own, other) = (median(&own), median(&other));
    let right = cell(hits.map(|hits| mask_share(scene, scene.clip, PROCESS_SIZE, &hits)), verdict);
    Ok(format!("{own:.3} | {other:.2} | {right} | {}", speedup(other / own, POVRAY_GOAL)))
}

/// The share of pixels that hit as ours do.
fn mask_share(scene: &Scene, clip: Clip, size: u32, hits: &[bool]) -> f64 {
    let depths = ours::depths(&ours::surfaces(&scene.formula, clip), &scene.camera(), size);
    agreement::share(&depths, size, |pixel| hits[pixel], |_, _| true)
}

/// A folder for scripts and pictures that goes when it is dropped.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new() -> Outcome<Self> {
        let path = std::env::temp_dir().join(format!("implicit-peers-{}", std::process::id()));
        std::fs::create_dir_all(&path)?;
        Ok(Folder(path))
    }

    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        if let Err(error) = std::fs::remove_dir_all(&self.0) {
            eprintln!("{} stays: {error}", self.0.display());
        }
    }
}
