//! This tracer beside its peers: fidget in the same process, surf-alggeo and POV-Ray as whole processes.
//!
//! `cargo run --release --manifest-path benches/peers/Cargo.toml` prints the tables; `… -- sphere barth6` those of some
//! scenes; `… -- growth` measures cost as the work grows and writes `docs/charts/`. `--rounds N` (3) repeats more.
//!
//! A crate of its own, because fidget's licence (MPL-2.0) has no place among the dependencies of `implicit`.

mod agreement;
mod chart;
mod clock;
mod closures;
mod formula;
mod growth;
#[path = "../../closures/native.rs"]
mod native;
mod native_cost;
mod ours;
mod picture;
mod povray;
mod process;
mod program;
mod random;
mod scenes;
mod secondary;
mod surf;
mod table;
mod threads;
mod voxels;

use scenes::Scene;
use std::error::Error;
use table::{Bench, Folder};

/// What can fail: a file, a program that is not there.
type Outcome<T = ()> = Result<T, Box<dyn Error>>;

fn main() -> Outcome {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let mut rounds = 3;
    if let Some(at) = words.iter().position(|word| word == "--rounds") {
        rounds = words.get(at + 1).and_then(|word| word.parse().ok()).filter(|&n| n > 0).ok_or("--rounds N")?;
        words.drain(at..at + 2);
    }
    let set = scenes::load()?;
    let folder = Folder::new()?;
    let bench = Bench {
        program: program::build()?,
        surf: surf::program(),
        has_povray: povray::is_installed(),
        rounds,
        folder: folder.path().into(),
    };
    if words == ["growth"] {
        return growth::all(&bench, &set);
    }
    let known = |word: &String| set.iter().any(|scene| scene.name == *word);
    if let Some(word) = words.iter().find(|word| !known(word)) {
        let names: Vec<&str> = set.iter().map(|scene| scene.name.as_str()).collect();
        return Err(format!("no scene is called {word}; there are {}, and growth", names.join(", ")).into());
    }
    let chosen: Vec<&Scene> = set.iter().filter(|scene| words.is_empty() || words.contains(&scene.name)).collect();
    for (name, is_there) in [("surf-alggeo", bench.surf.is_some()), ("povray", bench.has_povray)] {
        if !is_there {
            println!("{name} is not installed: its columns are empty.\n");
        }
    }
    println!("Primary visibility and normals at 1024 x 1024, one thread, processor time\n");
    println!("{}", table::visibility(&bench, &chosen)?);
    println!("Whole processes with the picture at 512 x 512, one thread, user time\n");
    println!("{}", table::processes(&bench, &chosen)?);
    println!("Diffuse bounces, one thread, processor time\n\n{}", secondary::table(&bench, &chosen));
    println!("Closures against the formula compiled by rustc\n\n{}", native_cost::table());
    Ok(())
}
