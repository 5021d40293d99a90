//! The speed of the closures against the same formulas written by hand.
//!
//! In: nothing. Out: ns a point for f with its gradient and ns for a batch of 16 enclosures of f and its slope, by
//! criterion; then a table of the medians of the same run with the ratio to the formula written by hand, and a
//! failure where the batches are not much faster than one point at a time. Separate because `cargo test` must not
//! depend on the load of the machine. `cargo bench --bench closures`; the figures are in docs/performance.md.

#![allow(clippy::print_stdout)]

#[path = "closures/native.rs"]
mod native;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion};
use implicit::closure::{Kernel, Tape};
use implicit::expr::derivative::{along_ray, gradient};
use implicit::num::interval::{Enclosure, Interval};
use implicit::num::interval_lanes::IntervalLanes;
use implicit::num::lanes::Lanes;
use implicit::num::level::Simd;
use implicit::num::number::Number;
use implicit::session::Program;
use native::{CASES, Case};
use rustix::time::{ClockId, clock_gettime};
use std::hint::black_box;
use std::time::Duration;

/// How many points are evaluated at once: as in the tracer.
const POINTS: usize = 64;

/// How many boxes are enclosed at once: as in the tracer.
const CELLS: usize = 16;

/// Batches must be this many times as fast as the same closures one point at a time.
const LEAST_GAIN: f64 = 4.0;

/// How far values may be apart that were added up in another order.
const AGREEMENT: f64 = 1e-9;

/// The numbers of a formula and its derivatives, ready to run.
struct Formula {
    batch: Kernel<Lanes<POINTS>>,
    single: Kernel<Lanes<1>>,
    cells: Kernel<IntervalLanes<CELLS>>,
}

impl Formula {
    fn new(case: &Case) -> Self {
        let mut program = Program::from_text(&(case.text)());
        assert!(program.diagnostics.is_empty(), "{} is not understood", case.name);
        let f = program.lowered.surfaces[0].f;
        let graph = &mut program.lowered.graph;
        let [x, y, z] = gradient(graph, f);
        let slope = along_ray(graph, &[f])[0];
        let tape = Tape::for_points(graph, &[f, x, y, z]);
        let simd = Simd::best();
        Formula {
            batch: Kernel::new(&tape, simd),
            single: Kernel::new(&tape, simd),
            cells: Kernel::new(&Tape::new(graph, &[f, slope]), simd),
        }
    }
}

/// Coordinate `axis` of the i-th point: spread over the cube of side 3.
fn coordinate(axis: usize, i: usize) -> f64 {
    let step = [0.618, 0.382, 0.271][axis];
    3.0 * ((0.31 + step * i as f64) % 1.0) - 1.5
}

/// What this thread has used of a processor: other work on the machine does not count.
fn processor_time() -> Duration {
    let now = clock_gettime(ClockId::ThreadCPUTime);
    Duration::new(now.tv_sec as u64, now.tv_nsec as u32)
}

/// Runs one measurement under criterion and returns the median of its samples in ns.
fn median(group: &mut BenchmarkGroup<'_, WallTime>, name: &str, mut run: impl FnMut()) -> f64 {
    let mut samples = Vec::new();
    group.bench_function(name, |bencher| {
        bencher.iter_custom(|count| {
            let start = processor_time();
            for _ in 0..count {
                run();
            }
            let elapsed = processor_time().saturating_sub(start);
            samples.push(elapsed.as_secs_f64() * 1e9 / count as f64);
            elapsed
        });
    });
    samples.sort_by(f64::total_cmp);
    samples.get(samples.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Runs a kernel on registers that hold the variables.
fn run<T: Number>(kernel: &Kernel<T>, registers: &mut [T]) {
    kernel.run(black_box(registers));
}

/// The medians of one formula, ns.
struct Row {
    name: &'static str,
    point: f64,
    native: f64,
    single: f64,
    cells: f64,
    goal: f64,
}

fn measure(criterion: &mut Criterion, case: &Case) -> Row {
    let formula = Formula::new(case);
    let mut group = criterion.benchmark_group(case.name);
    let points: [[f64; POINTS]; 3] = std::array::from_fn(|axis| std::array::from_fn(|i| coordinate(axis, i)));
    let mut by_hand = [[0.0; POINTS]; 4];
    let native = median(&mut group, "native", || native::run(case, black_box(&points), black_box(&mut by_hand)));
    let mut registers = formula.batch.registers();
    for axis in 0..3 {
        registers[axis] = Lanes(points[axis]);
    }
    let batch = median(&mut group, "points", || run(&formula.batch, &mut registers));
    for k in 0..4 {
        check(case.name, &formula.batch.output(&registers, k).0, &by_hand[k]);
    }
    let mut registers = formula.single.registers();
    for axis in 0..3 {
        registers[axis] = Lanes([coordinate(axis, 7)]);
    }
    let single = median(&mut group, "single", || run(&formula.single, &mut registers));
    let mut registers = formula.cells.registers();
    fill_cells(&mut registers);
    let cells = median(&mut group, "cells", || run(&formula.cells, &mut registers));
    group.finish();
    let points = POINTS as f64;
    Row { name: case.name, point: batch / points, native: native / points, single, cells, goal: case.goal }
}

/// Stretches of rays a fiftieth long, through the same points.
fn fill_cells(registers: &mut [IntervalLanes<CELLS>]) {
    for i in 0..CELLS {
        for axis in 0..3 {
            let x = coordinate(axis, i);
            registers[axis].set(i, Enclosure::total(Interval::new(x, x + 0.02)));
            let direction = [0.48, 0.6, 0.64][axis];
            registers[axis + 3].set(i, Enclosure::total(Interval::point(direction)));
        }
    }
}

/// Both ways must compute the same function, or their speeds do not compare.
fn check(name: &str, ours: &[f64], by_hand: &[f64]) {
    for (a, b) in ours.iter().zip(by_hand) {
        assert!((a - b).abs() <= AGREEMENT * (1.0 + b.abs()), "{name}: {a} by closures, {b} by hand");
    }
}

fn main() {
    let mut criterion = Criterion::default()
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(400))
        .sample_size(30)
        .without_plots()
        .configure_from_args();
    let rows: Vec<Row> = CASES.iter().map(|case| measure(&mut criterion, case)).collect();
    println!("| formula | ns/point | native ns/point | ratio | goal | one at a time, ns | 16 cells, ns |");
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for row in &rows {
        let ratio = row.point / row.native;
        println!(
            "| {} | {:.2} | {:.2} | {ratio:.1} | {:.0} | {:.0} | {:.0} |",
            row.name, row.point, row.native, row.goal, row.single, row.cells
        );
    }
    for row in rows.iter().filter(|_| Simd::best() != Simd::Portable) {
        let gain = row.single / row.point;
        assert!(!(gain < LEAST_GAIN), "{}: batches are only {gain:.1} times as fast as single points", row.name);
    }
    criterion.final_summary();
}
