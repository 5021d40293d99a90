//! Measurements of the lanes: that loops over arrays did become vector instructions.
//!
//! In: nothing. Out: a table of ns per batch, and a failure where a batch of points is not much faster than the
//! same function one number at a time. Separate because it is compiled for tests alone and looks at the clock.
//! The whole table: `cargo test --lib num::speed -- --ignored --nocapture`.

#![allow(clippy::print_stdout)]

use super::affine_lanes::AffineLanes;
use super::func::native;
use super::interval::{Enclosure, Interval};
use super::interval_lanes::IntervalLanes;
use super::lanes::Lanes;
use super::level::Simd;
use super::trial::{Runner, trials};
use std::hint::black_box;
use std::time::Instant;

/// The least time of one run, ns, over a few tries.
fn nanoseconds(mut run: impl FnMut(u32)) -> f64 {
    const REPEAT: u32 = 200;
    (0..25)
        .map(|_| {
            let start = Instant::now();
            run(REPEAT);
            start.elapsed().as_secs_f64() * 1e9 / f64::from(REPEAT)
        })
        .fold(f64::INFINITY, f64::min)
}

/// Numbers that every function has a value at, but for acosh.
fn number(i: usize) -> f64 {
    0.1 + 0.012 * i as f64
}

fn time_points(run: Runner<Lanes<64>>) -> f64 {
    let (a, b) = (Lanes(std::array::from_fn(number)), Lanes(std::array::from_fn(|i| number(63 - i) - 0.05)));
    let mut out = a;
    nanoseconds(|repeat| run(Simd::best(), repeat, &a, &b, &mut out))
}

fn time_cells(run: Runner<IntervalLanes<16>>) -> f64 {
    let (mut a, mut b) = (IntervalLanes::default(), IntervalLanes::default());
    for i in 0..16 {
        a.set(i, Enclosure::total(Interval::new(number(i), number(i + 3))));
        b.set(i, Enclosure::total(Interval::new(number(20 - i), number(22 - i))));
    }
    let mut out = a;
    nanoseconds(|repeat| run(Simd::best(), repeat, &a, &b, &mut out))
}

fn time_forms<const S: usize>(run: Runner<AffineLanes<16, S>>) -> f64 {
    let form = |first: usize| AffineLanes {
        center: std::array::from_fn(|i| number(i + first)),
        slope: [[0.02; 16]; S],
        error: [1e-9; 16],
        flags: [0; 16],
    };
    let (a, b) = (form(3), form(20));
    let mut out = a;
    nanoseconds(|repeat| run(Simd::best(), repeat, &a, &b, &mut out))
}

#[test]
#[ignore = "prints a table"]
fn table() {
    println!("{:>13} {:>12} {:>12} {:>12} {:>12}  ns", "", "64 points", "16 intervals", "16 forms", "along a ray");
    for trial in trials() {
        let [points, cells] = [time_points(trial.points), time_cells(trial.cells)];
        let [forms, along] = [time_forms(trial.forms), time_forms(trial.along)];
        println!("{:>13} {points:12.1} {cells:12.1} {forms:12.1} {along:12.1}", trial.name);
    }
}

/// A call through [`native`] costs the same arithmetic without vectors; where AVX2 is there, four lanes at once
/// must show.
#[test]
fn batches_are_vectorised() {
    if Simd::best() == Simd::Portable {
        return;
    }
    type Scalar = (&'static str, fn(f64) -> f64);
    let scalars: [Scalar; 4] = [("sin", native::sin), ("exp", native::exp), ("atan", native::atan), ("ln", native::ln)];
    for (name, f) in scalars {
        let Some(trial) = trials().into_iter().find(|trial| trial.name == name) else { panic!("no {name}") };
        let mut sum = 0.0;
        let scalar = nanoseconds(|repeat| {
            for i in 0..repeat as usize * 64 {
                sum += f(black_box(number(i % 64)));
            }
        });
        let batch = time_points(trial.points);
        assert!(batch * 2.0 < scalar, "{name}: a batch of 64 takes {batch:.0} ns, one by one {scalar:.0} ({sum})");
    }
}
