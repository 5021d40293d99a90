//! Cost as the work grows: pixels, objects, terms, degree, threads.
//!
//! In: nothing, the formulas are made here. Out: a chart of each in `docs/charts/` and its figures in Markdown.

use crate::chart::{Chart, Scale, Series};
use crate::clock::median;
use crate::ours;
use crate::scenes::{self, Clip, Scene};
use crate::table::Bench;
use crate::threads;
use glam::DVec3;
use std::error::Error;
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

/// Measures everything, writes the charts, prints the tables.
pub fn all(bench: &Bench, scenes: &[Scene]) -> Result<(), Box<dyn Error>> {
    let by_name = |name: &str| scenes.iter().find(|scene| scene.name == name).ok_or("a scene is missing");
    let some = ["sphere", "tanglecube", "barth6", "gyroid"].map(by_name);
    let some: Vec<&Scene> = some.into_iter().collect::<Result<_, _>>()?;
    let lines = some.iter().map(|scene| (scene.name.clone(), resolutions(scene))).collect();
    chart(bench, "resolution", "ns a pixel as the picture grows", "pixels across", lines)?;
    let counts = [1, 3, 10, 30, 100, 300, 1000];
    let line = vec![("spheres by min".to_string(), counts.map(spheres).into())];
    chart(bench, "objects", "ns a pixel with more objects", "spheres, 256 x 256 pixels", line)?;
    let line = vec![("sum of Gaussians".to_string(), [10, 20, 50, 100, 200].map(gaussians).into())];
    chart(bench, "gaussians", "ns a pixel with more terms", "Gaussians, 256 x 256 pixels", line)?;
    let eye = by_name("chmutov8")?.eye;
    let line = vec![("Chmutov".to_string(), (1..=10).map(|half| chmutov(2 * half, eye)).collect())];
    chart(bench, "degree", "ns a pixel with rising degree", "degree, 512 x 512 pixels", line)?;
    threads::chart(bench, &some)
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

/// Spheres with r² = 1/(2n): as many cover as much of the picture.
fn spheres(count: usize) -> Picture {
    let radius2 = 0.5 / count as f64;
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

/// Chmutov's surface of that degree (Arnold, Gusein-Zade, Varchenko: Singularities of Differentiable Maps II, p. 419).
fn chmutov(degree: u32, eye: DVec3) -> Picture {
    let terms = ["x", "y", "z"].map(|axis| format!("chebyshev({degree}, {axis})"));
    let formula = format!("{} + 1", terms.join(" + "));
    Picture { across: f64::from(degree), formula, clip: Clip::Box(1.1), eye, size: 512 }
}

/// Pseudo-random points of the cube of side 2: Steele, Lea, Flood, Fast splittable pseudorandom number generators (2014).
fn centers(count: usize) -> Vec<DVec3> {
    let mut state = 0u64;
    let mut next = || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        let part = (mixed ^ (mixed >> 31)) as f64 / 2f64.powi(64);
        ((2.0 * part - 1.0) * 1e4).round() / 1e4
    };
    (0..count).map(|_| DVec3::new(next(), next(), next())).collect()
}

/// |p − c|² as text.
fn distance2(c: &DVec3) -> String {
    format!("((x - ({}))^2 + (y - ({}))^2 + (z - ({}))^2)", c.x, c.y, c.z)
}

/// Measures the pictures of all lines in turn, writes the chart and prints its figures.
fn chart(
    bench: &Bench,
    name: &str,
    title: &str,
    across: &str,
    lines: Vec<(String, Vec<Picture>)>,
) -> Result<(), Box<dyn Error>> {
    let ready: Vec<_> = lines
        .iter()
        .flat_map(|(_, pictures)| pictures)
        .map(|picture| (picture, ours::surfaces(&picture.formula, picture.clip), scenes::camera(picture.eye)))
        .collect();
    let mut runs: Vec<Vec<ours::Run>> = ready.iter().map(|_| Vec::new()).collect();
    for round in 0..bench.rounds {
        eprintln!("{name}: round {} of {}", round + 1, bench.rounds);
        for ((picture, surfaces, camera), runs) in ready.iter().zip(&mut runs) {
            if runs.first().is_none_or(|run| run.seconds < SLOW) {
                runs.push(ours::trace(surfaces, camera, picture.size));
            }
        }
    }
    let mut medians = runs.iter().map(|runs| {
        let seconds: Vec<f64> = runs.iter().map(|run| run.seconds).collect();
        median(&seconds) * 1e9 / runs[0].pixels as f64
    });
    let mut shares = runs.iter().map(|runs| (runs[0].hits as f64, runs[0].proven as f64, runs[0].pixels as f64));
    println!("| {across} | | ns/pixel | pixels hit | proven |\n| --- | --- | --- | --- | --- |");
    let mut series = Vec::new();
    for (line, pictures) in &lines {
        let mut points = Vec::new();
        for (picture, (hits, proven, pixels)) in pictures.iter().zip(&mut shares) {
            let cost = medians.next().unwrap_or(f64::NAN);
            let (hit, proven) = (100.0 * hits / pixels, 100.0 * proven / pixels);
            println!("| {} | {line} | {cost:.0} | {hit:.1} % | {proven:.3} % |", picture.across);
            points.push((picture.across, cost));
        }
        series.push(Series { name: line.clone(), points });
    }
    println!();
    write(name, &Chart { title, across, up: "ns/pixel, one thread", scale: Scale::Logarithmic, series })
}

/// Writes a chart into the documentation.
pub fn write(name: &str, chart: &Chart) -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/charts"));
    std::fs::create_dir_all(&folder)?;
    Ok(std::fs::write(folder.join(format!("{name}.svg")), chart.svg())?)
}
