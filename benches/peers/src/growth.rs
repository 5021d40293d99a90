//! Cost as the work grows: pixels, objects, terms, degree, threads.
//!
//! In: nothing, the formulas are made here. Out: a chart of each in `docs/charts/` and its figures in Markdown.

use crate::Outcome;
use crate::chart::{Chart, Scale, Series};
use crate::clock::median;
use crate::ours;
use crate::random::Random;
use crate::scenes::{self, Clip, Scene};
use crate::table::{Bench, mark};
use crate::threads;
use glam::DVec3;
use std::path::PathBuf;

/// Seconds after which a measurement is not repeated.
const SLOW: f64 = 4.0;

/// Where the objects and Gaussians are looked at from: all of the cube they are in is seen.
const EYE: DVec3 = DVec3::new(2.785521, -4.244603, 2.254945);
const AROUND: Clip = Clip::Ball(2.5);

/// One picture whose cost is a point of a chart.
struct Picture {
    across: f64,
    formula: String,
    clip: Clip,
    eye: DVec3,
    size: u32,
}

/// A chart to be measured.
struct Experiment {
    name: &'static str,
    title: &'static str,
    across: &'static str,
    scale_across: Scale,
    /// From the first of these to the second the cost may grow by the third.
    goal: Option<(f64, f64, f64)>,
    lines: Vec<(String, Vec<Picture>)>,
}

/// Measures everything, writes the charts, prints the tables.
pub fn all(bench: &Bench, scenes: &[Scene]) -> Outcome {
    let by_name = |name: &str| scenes.iter().find(|scene| scene.name == name).ok_or("a scene is missing");
    let some = ["sphere", "tanglecube", "barth6", "gyroid"].map(by_name);
    let some: Vec<&Scene> = some.into_iter().collect::<Result<_, _>>()?;
    for experiment in experiments(&some, by_name("chmutov8")?.eye) {
        run(bench, &experiment)?;
    }
    threads::chart(bench, &some)
}

fn experiments(scenes: &[&Scene], eye_of_chmutov: DVec3) -> [Experiment; 4] {
    let one = |name: &str, pictures: Vec<Picture>| vec![(name.to_string(), pictures)];
    [
        Experiment {
            name: "resolution",
            title: "Cost of a pixel as the picture grows",
            across: "pixels across",
            scale_across: Scale::Logarithmic,
            goal: Some((512.0, 2048.0, 1.1)),
            lines: scenes.iter().map(|scene| (scene.name.clone(), resolutions(scene))).collect(),
        },
        Experiment {
            name: "objects",
            title: "Cost of a pixel with more objects",
            across: "spheres, 256 x 256 pixels",
            scale_across: Scale::Logarithmic,
            goal: Some((10.0, 1000.0, 8.0)),
            lines: one("spheres by min", [1, 3, 10, 30, 100, 300, 1000].map(spheres).into()),
        },
        Experiment {
            name: "gaussians",
            title: "Cost of a pixel with more terms",
            across: "Gaussians, 256 x 256 pixels",
            scale_across: Scale::Logarithmic,
            goal: Some((20.0, 200.0, 8.0)),
            lines: one("sum of Gaussians", [10, 20, 50, 100, 200].map(gaussians).into()),
        },
        Experiment {
            name: "degree",
            title: "Cost of a pixel with rising degree",
            across: "degree, 512 x 512 pixels",
            scale_across: Scale::Linear,
            goal: None,
            lines: one("Chmutov", (1..=10).map(|half| chmutov(2 * half, eye_of_chmutov)).collect()),
        },
    ]
}

fn resolutions(scene: &Scene) -> Vec<Picture> {
    let picture = |size: u32| Picture {
        across: f64::from(size),
        formula: scene.formula.clone(),
        clip: scene.clip,
        eye: scene.eye,
        size,
    };
    [256, 512, 1024, 2048, 4096].map(picture).into()
}

/// Spheres with r² = 1/n: as many cover as much of the picture.
fn spheres(count: usize) -> Picture {
    let radius2 = 1.0 / count as f64;
    let terms: Vec<String> = centers(count).iter().map(|c| format!("{} - {radius2}", distance2(c))).collect();
    let formula = if count == 1 { terms.concat() } else { format!("min({})", terms.join(", ")) };
    Picture { across: count as f64, formula, clip: AROUND, eye: EYE, size: 256 }
}

/// Gaussians whose width goes with n^(-1/3), so that they overlap as much; 20 are as wide as the set's metaballs.
fn gaussians(count: usize) -> Picture {
    let steepness = 4.0 * (count as f64 / 20.0).powf(2.0 / 3.0);
    let terms: Vec<String> = centers(count).iter().map(|c| format!("exp(-{steepness}*({}))", distance2(c))).collect();
    let formula = format!("{} - 0.6", terms.join(" + "));
    Picture { across: count as f64, formula, clip: AROUND, eye: EYE, size: 256 }
}

/// Of the kind of Chmutov, Examples of projective surfaces with many singularities, J. Algebraic Geometry 1 (1992), 191–196.
fn chmutov(degree: u32, eye: DVec3) -> Picture {
    let terms = ["x", "y", "z"].map(|axis| format!("chebyshev({degree}, {axis})"));
    let formula = format!("{} + 1", terms.join(" + "));
    Picture { across: f64::from(degree), formula, clip: Clip::Box(1.1), eye, size: 512 }
}

/// Points of the cube of side 2, with four decimals.
fn centers(count: usize) -> Vec<DVec3> {
    let mut random = Random::default();
    let mut next = || ((2.0 * random.part() - 1.0) * 1e4).round() / 1e4;
    (0..count).map(|_| DVec3::new(next(), next(), next())).collect()
}

/// |p − c|² as text.
fn distance2(c: &DVec3) -> String {
    format!("((x - ({}))^2 + (y - ({}))^2 + (z - ({}))^2)", c.x, c.y, c.z)
}

/// Measures the pictures of all lines in turn, writes the chart and prints its figures.
fn run(bench: &Bench, experiment: &Experiment) -> Outcome {
    let Experiment { name, title, across, scale_across, lines, .. } = experiment;
    let runs = measure(bench, experiment);
    let mut runs = runs.iter();
    println!("| {across} | | ns/pixel | pixels hit | proven |\n| --- | --- | --- | --- | --- |");
    let (mut series, mut growth) = (Vec::new(), Vec::new());
    for (line, pictures) in lines {
        let mut points = Vec::new();
        for (picture, runs) in pictures.iter().zip(&mut runs) {
            let seconds: Vec<f64> = runs.iter().map(|run| run.seconds).collect();
            let pixels = runs[0].pixels as f64;
            let cost = median(&seconds) * 1e9 / pixels;
            let [hit, proven] = [runs[0].hits, runs[0].proven].map(|count| 100.0 * count as f64 / pixels);
            println!("| {} | {line} | {cost:.0} | {hit:.1} % | {proven:.3} % |", picture.across);
            points.push((picture.across, cost));
        }
        growth.extend(experiment.goal.and_then(|goal| sentence(line, &points, goal)));
        series.push(Series { name: line.clone(), points });
    }
    println!("\n{}", growth.concat());
    let (scale_across, scale_up) = (*scale_across, Scale::Logarithmic);
    write(name, &Chart { title, across, up: "ns/pixel, one thread", scale_across, scale_up, series })
}

/// By how much the cost grows, and by how much it may.
fn sentence(line: &str, points: &[(f64, f64)], (from, to, goal): (f64, f64, f64)) -> Option<String> {
    let cost = |across: f64| Some(points.iter().find(|point| point.0 == across)?.1);
    let growth = cost(to)? / cost(from)?;
    Some(format!("- {line}, from {from} to {to}: × {}, goal ≤ {goal}\n", mark(format!("{growth:.2}"), growth <= goal)))
}

/// The runs of every picture, line by line.
fn measure(bench: &Bench, experiment: &Experiment) -> Vec<Vec<ours::Run>> {
    let pictures = experiment.lines.iter().flat_map(|(_, pictures)| pictures);
    let ready: Vec<_> = pictures
        .map(|picture| (picture, ours::surfaces(&picture.formula, picture.clip), scenes::camera(picture.eye)))
        .collect();
    let mut all: Vec<Vec<ours::Run>> = ready.iter().map(|_| Vec::new()).collect();
    for round in 0..bench.rounds {
        eprintln!("{}: round {} of {}", experiment.name, round + 1, bench.rounds);
        for ((picture, surfaces, camera), runs) in ready.iter().zip(&mut all) {
            if runs.first().is_none_or(|run| run.seconds < SLOW) {
                runs.push(ours::trace(surfaces, camera, picture.size));
            }
        }
    }
    all
}

/// Writes a chart into the documentation.
pub fn write(name: &str, chart: &Chart) -> Outcome {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/charts"));
    std::fs::create_dir_all(&folder)?;
    Ok(std::fs::write(folder.join(format!("{name}.svg")), chart.svg())?)
}
