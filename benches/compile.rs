//! What it takes to make a formula ready, by its length; and the whole program on a picture of one pixel.
//!
//! `cargo bench --bench compile`; `-- 1000` for one length alone. A row: nodes of the graph as it was read, then processor time
//! of reading, of lowering with simplification, and of making the surface ready (rewriting, derivatives, closures of all kinds),
//! medians. The goal is 1 ms for 100 nodes.
#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout, clippy::disallowed_methods)]

use glam::DVec3;
use implicit::diag::Sources;
use implicit::expr::lower::{self, lower};
use implicit::num::level::Simd;
use implicit::surface::{Clip, Kind, Shape, Surface};
use implicit::syntax::parse;
use rustix::time::{ClockId, clock_gettime};
use std::process::{Command, Stdio};

/// Nodes that formulas have about.
const LENGTHS: [usize; 3] = [100, 1000, 10_000];

/// Runs of a formula; the median counts.
const RUNS: usize = 5;

/// Runs of the whole program; the mean counts, for the system tells the time of many better than that of one.
const STARTS: u32 = 100;

/// A family of formulas, and the nodes of a term.
type Family = (&'static str, fn(usize) -> String, usize);

const FAMILIES: [Family; 4] = [
    ("polynomial", |terms| sum(terms, |k| format!("{}*x^{}*y^{}*z^{}", k % 7 + 2, k % 5, k / 5 % 5, k / 25 % 400)), 4),
    ("sines", |terms| sum(terms, |k| format!("sin({}*x + y*{})*cos({}*z)", k + 1, k + 2, k + 3)), 8),
    ("Gaussians", |terms| sum(terms, |k| format!("exp(-3*({}))", ball(k))), 13),
    ("spheres by min", |terms| format!("min({})", listed(terms, |k| format!("sqrt({}) - 0.1", ball(k)))), 13),
];

fn listed(terms: usize, term: impl Fn(usize) -> String) -> String {
    (0..terms).map(term).collect::<Vec<_>>().join(", ")
}

fn sum(terms: usize, term: impl Fn(usize) -> String) -> String {
    (0..terms).map(term).collect::<Vec<_>>().join(" + ") + " - 1"
}

/// The square of the distance from a point that is another for each number.
fn ball(k: usize) -> String {
    let place = |step: f64| (k as f64 * step).fract() * 2.0 - 1.0;
    format!("(x - ({:.6}))^2 + (y - ({:.6}))^2 + (z - ({:.6}))^2", place(0.819_173), place(0.671_044), place(0.549_7))
}

fn main() {
    let words: Vec<usize> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    println!(
        "| formula | nodes | read, ms | lower, ms | surface, ms | ms for 100 nodes |\n| --- | --- | --- | --- | --- | --- |"
    );
    for (name, formula, per_term) in FAMILIES {
        for length in LENGTHS.into_iter().filter(|length| words.is_empty() || words.contains(length)) {
            measure(name, &formula(length / per_term));
        }
    }
    if words.is_empty() {
        start();
    }
}

fn measure(name: &str, formula: &str) {
    let mut runs: Vec<(f64, [f64; 3], usize)> = (0..RUNS).map(|_| run(formula)).collect();
    runs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (all, stages, nodes) = runs[RUNS / 2];
    let [read, lower, surface] = stages.map(|seconds| seconds * 1e3);
    println!("| {name} | {nodes} | {read:.2} | {lower:.2} | {surface:.2} | {:.3} |", all * 1e5 / nodes as f64);
}

/// Seconds in all and of each stage, and the nodes.
fn run(formula: &str) -> (f64, [f64; 3], usize) {
    let clip = Clip::shape(Shape::Ball { center: DVec3::ZERO, radius: 2.0 });
    let mut times = [seconds(); 4];
    let mut sources = Sources::new();
    sources.add("formula", formula);
    let parsed = parse(&sources.texts());
    times[1] = seconds();
    let mut lowered = lower(&parsed.program, &lower::Settings::default());
    times[2] = seconds();
    let (nodes, f) = (lowered.graph.len(), lowered.surfaces[0].f);
    let surface = Surface::new(&mut lowered.graph, f, Kind::Equation, &clip, Simd::best());
    times[3] = seconds();
    assert!(surface.steps() > 0);
    (times[3] - times[0], [0, 1, 2].map(|k| times[k + 1] - times[k]), nodes)
}

fn seconds() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

/// Processor time of the whole program, from its start to its end.
fn start() {
    let picture = std::env::temp_dir().join(format!("implicit-{}.png", std::process::id()));
    let view = ["--ball=0,0,0,2", "--eye=4,-6,3"];
    for (name, view) in [("all is found", &[][..]), ("region and eye are given", &view)] {
        let before = of_children();
        for _ in 0..STARTS {
            let mut command = Command::new(env!("CARGO_BIN_EXE_implicit"));
            command.args(["x^2 + y^2 + z^2 = 1", "--size=1x1", "--quiet"]).args(view).arg("-o").arg(&picture);
            assert!(command.stdout(Stdio::null()).status().unwrap().success());
        }
        match before.zip(of_children()) {
            Some((before, after)) => {
                println!("\nsphere, 1 x 1, {name}: {:.2} ms", (after - before) * 1e3 / f64::from(STARTS));
            }
            None => println!("\nsphere, 1 x 1, {name}: no /proc/self/stat, no time"),
        }
    }
    std::fs::remove_file(&picture).unwrap();
}

/// User and system seconds of all children that have ended: the 16th and 17th field of the table, in hundredths.
fn of_children() -> Option<f64> {
    let table = std::fs::read_to_string("/proc/self/stat").ok()?;
    let fields: Vec<&str> = table.rsplit_once(')')?.1.split_whitespace().collect();
    let hundredths: Option<Vec<f64>> = [13, 14].into_iter().map(|k| fields.get(k)?.parse().ok()).collect();
    Some(hundredths?.iter().sum::<f64>() / 100.0)
}
