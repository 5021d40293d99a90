//! What a form promises: whatever the symbols are, the value is within its error of the linear part.

use super::{AffineLanes, SYMBOLS};
use crate::num::interval_lanes::{JUMP, NOWHERE, PARTIAL};
use crate::num::level::Simd;
use crate::num::tests::Random;
use crate::num::trial::{Runner, Trial, trials};

/// Batches of each operation: 16 forms, each asked at 5 places.
const BATCHES: usize = 625;

/// What the test's own sums round off, as a part of all magnitudes.
const SLACK: f64 = 4.0 * f64::EPSILON;

/// A form of everyday or odd size, sometimes of one point, with what each ε is at some places.
fn form<const S: usize>(random: &mut Random, out: &mut AffineLanes<16, S>, lane: usize) {
    let scale = [1.0, 1e-3, 1e-6, 0.0, 0.3, 10.0, 1e-9, 1e3][random.bits() as usize >> 8 & 7];
    let center = match random.number() {
        c if c.abs() < 1e100 => c,
        _ => 0.7,
    };
    out.center[lane] = center;
    let mut size = center.abs();
    for slope in &mut out.slope {
        slope[lane] = (random.unit() - 0.5) * scale;
        size += slope[lane].abs();
    }
    let error = if random.bits() & 64 == 0 { 0.0 } else { random.unit() * 0.1 * scale };
    // The places asked are rounded.
    out.error[lane] = error + SLACK * size;
}

fn at<const S: usize>(form: &AffineLanes<16, S>, lane: usize, e: [f64; S]) -> f64 {
    (0..S).map(|k| form.slope[k][lane] * e[k]).sum::<f64>() + form.center[lane]
}

#[track_caller]
fn check<const S: usize>(
    trial: &Trial,
    out: &AffineLanes<16, S>,
    lane: usize,
    e: [f64; S],
    value: f64,
    inputs: (f64, f64),
) {
    let (center, error, flags) = (out.center[lane], out.error[lane], out.flags[lane]);
    if value.is_nan() {
        assert!(flags & PARTIAL != 0, "{} at {inputs:?} has no value, but is said to be defined", trial.name);
        return;
    }
    assert!(flags & NOWHERE == 0, "{} at {inputs:?} has a value, but is said to have none", trial.name);
    let linear = at(out, lane, e);
    let size = center.abs() + out.slope.iter().map(|s| s[lane].abs()).sum::<f64>();
    let far = (value - linear).abs() > error + SLACK * (size + value.abs());
    assert!(!far, "{} at {inputs:?}: {value:e} is not within {error:e} of {linear:e}", trial.name);
}

#[test]
fn values_are_within_the_error_of_the_linear_part() {
    values_are_within::<SYMBOLS>(|trial| trial.forms);
    values_are_within::<1>(|trial| trial.along);
}

fn values_are_within<const S: usize>(runner: fn(&Trial) -> Runner<AffineLanes<16, S>>) {
    for trial in trials() {
        let mut random = Random(0xfeed_5eed);
        let (mut known, mut finite) = (0, 0);
        for _ in 0..BATCHES {
            let mut a = AffineLanes::<16, S>::splat(0.0, 0.0);
            let mut b = a;
            for lane in 0..16 {
                form(&mut random, &mut a, lane);
                form(&mut random, &mut b, lane);
            }
            let mut out = a;
            runner(&trial)(Simd::best(), 1, &a, &b, &mut out);
            for lane in 0..16 {
                known += u32::from(out.flags[lane] & (PARTIAL | JUMP) == 0);
                finite += u32::from(out.error[lane] < f64::INFINITY);
                for _ in 0..5 {
                    let e = [0; S].map(|_| match random.bits() >> 9 & 3 {
                        0 => -1.0,
                        1 => 1.0,
                        _ => random.unit() * 2.0 - 1.0,
                    });
                    let inside = |form: &AffineLanes<16, S>, random: &mut Random| {
                        let rest = form.error[lane] - SLACK * (form.center[lane].abs() + form.radius(lane));
                        at(form, lane, e) + rest.max(0.0) * (random.unit() * 2.0 - 1.0)
                    };
                    let (x, y) = (inside(&a, &mut random), inside(&b, &mut random));
                    let value = (trial.exact)(x, y);
                    if value.is_infinite() || value.abs() > 1e290 {
                        continue;
                    }
                    check(&trial, &out, lane, e, value, (x, y));
                }
            }
        }
        let share = |count: u32| f64::from(count) / (BATCHES * 16) as f64;
        assert!(share(finite) > 0.1 && share(known) > 0.05, "{}: {} {}", trial.name, share(finite), share(known));
    }
}

#[test]
fn all_levels_give_the_same_forms() {
    levels_agree::<SYMBOLS>(|trial| trial.forms);
    levels_agree::<1>(|trial| trial.along);
}

fn levels_agree<const S: usize>(runner: fn(&Trial) -> Runner<AffineLanes<16, S>>) {
    for trial in trials() {
        let mut random = Random(11);
        for _ in 0..BATCHES / 8 {
            let mut a = AffineLanes::<16, S>::splat(0.0, 0.0);
            let mut b = a;
            for lane in 0..16 {
                form(&mut random, &mut a, lane);
                form(&mut random, &mut b, lane);
            }
            let outs: Vec<AffineLanes<16, S>> = Simd::all()
                .into_iter()
                .map(|simd| {
                    let mut out = a;
                    runner(&trial)(simd, 1, &a, &b, &mut out);
                    out
                })
                .collect();
            let bits = |form: &AffineLanes<16, S>, lane: usize| {
                (
                    form.center[lane].to_bits(),
                    form.slope.map(|slope| slope[lane].to_bits()),
                    form.error[lane].to_bits(),
                    form.flags[lane],
                )
            };
            for lane in (0..16).filter(|&lane| outs[0].error[lane] < f64::INFINITY) {
                assert!(outs.iter().all(|o| bits(o, lane) == bits(&outs[0], lane)), "{} {:?}", trial.name, outs);
            }
        }
    }
}
