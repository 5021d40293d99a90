//! What a second thread brings, and what it can bring on this machine.
//!
//! In: some scenes. Out: the chart and table of the trace stage with one and two threads, beside an arithmetic loop
//! that shares nothing; the memory of a large picture. Wall time counts here, so the best of the rounds does too.

use crate::Outcome;
use crate::chart::{Chart, Scale, Series};
use crate::growth;
use crate::program::{self, Task};
use crate::scenes::Scene;
use crate::table::{Bench, mark};
use std::hint::black_box;
use std::time::Instant;

/// Steps of the loop that each thread does: some tenths of a second.
const STEPS: u64 = 100_000_000;

/// Pixels across of the pictures that are timed, and of the one whose memory is looked at.
const SIZE: u32 = 2048;
const LARGE: u32 = 4096;

/// The part of the loop's speed with two threads that the trace stage is to have.
const GOAL: f64 = 0.95;

/// Bytes a pixel that a picture may take, over 100 MB.
const BYTES_GOAL: f64 = 16.0;

/// Least wall and processor seconds, with one thread and with two.
#[derive(Clone, Copy)]
struct Best([(f64, f64); 2]);

impl Best {
    fn add(&mut self, threads: usize, wall: f64, processor: f64) {
        let best = &mut self.0[threads - 1];
        *best = (best.0.min(wall), best.1.min(processor));
    }

    /// How much more a second of two threads does.
    fn speedup(&self) -> f64 {
        self.0[0].0 / self.0[1].0
    }

    /// How much more processor time two threads take for the same.
    fn overhead(&self) -> f64 {
        self.0[1].1 / self.0[0].1
    }
}

pub fn chart(bench: &Bench, scenes: &[&Scene]) -> Outcome {
    let mut bests = vec![Best([(f64::INFINITY, f64::INFINITY); 2]); scenes.len() + 1];
    for round in 0..bench.rounds.max(10) {
        eprintln!("threads: round {}", round + 1);
        for threads in [1, 2] {
            for (scene, best) in scenes.iter().zip(&mut bests[1..]) {
                let (wall, processor) =
                    program::trace_stage(&bench.program, task(scene, SIZE, threads), &bench.folder)?;
                best.add(threads, wall, processor);
            }
            let (wall, processor) = arithmetic(threads);
            bests[0].add(threads, wall / threads as f64, processor / threads as f64);
        }
    }
    let names = std::iter::once("arithmetic loop").chain(scenes.iter().map(|scene| scene.name.as_str()));
    println!("| two threads | speed, one thread = 1 | of the loop's | processor time, one thread = 1 |");
    println!("| --- | --- | --- | --- |");
    let mut series = Vec::new();
    for (name, best) in names.zip(&bests) {
        let (speedup, share) = (best.speedup(), best.speedup() / bests[0].speedup());
        let share = mark(format!("{share:.2}"), share >= GOAL);
        println!("| {name} | {speedup:.2} | {share} | {:.2} |", best.overhead());
        series.push(Series { name: name.into(), points: vec![(1.0, 1.0), (2.0, speedup)] });
    }
    println!();
    memory(bench, scenes)?;
    let chart = Chart {
        title: "Speed of the trace stage with more threads",
        across: "threads, 2048 x 2048 pixels",
        up: "one thread = 1",
        scale_across: Scale::Linear,
        scale_up: Scale::Linear,
        series,
    };
    growth::write("threads", &chart)
}

fn task<'a>(scene: &'a Scene, size: u32, threads: usize) -> Task<'a> {
    Task { formula: &scene.formula, clip: scene.clip, eye: scene.eye, size, threads }
}

/// Wall and processor seconds of threads that each do the same chain of additions and multiplications.
fn arithmetic(threads: usize) -> (f64, f64) {
    let start = Instant::now();
    let ((), processor) = crate::clock::timed(|| {
        std::thread::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(|| black_box((0..STEPS).fold(black_box(0.5f64), |x, _| x * 0.999_999 + 1e-7)));
            }
        });
    });
    (start.elapsed().as_secs_f64(), processor)
}

fn memory(bench: &Bench, scenes: &[&Scene]) -> Outcome {
    println!("| memory at {LARGE} x {LARGE}, two threads | MB | bytes a pixel over 100 MB |\n| --- | --- | --- |");
    for scene in scenes {
        let peak = program::draw(&bench.program, task(scene, LARGE, 2), &bench.folder)?.peak as f64;
        let bytes = (peak - 100e6).max(0.0) / f64::from(LARGE).powi(2);
        println!("| {} | {:.0} | {} |", scene.name, peak / 1e6, mark(format!("{bytes:.1}"), bytes <= BYTES_GOAL));
    }
    println!();
    Ok(())
}
