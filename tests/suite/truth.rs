//! Depths from the program against depths decided by independent mathematics.
//!
//! In: `tests/data/truth` (20 pictures) and `tests/data/exact` (what `tests/tools/truth.py` decided). Out: a table of the
//! cases that are not right. The rays are traced in memory, so that the depths are compared as doubles.

use super::npy;
use super::truth_case::{Case, Way, cases};
use implicit::surface::{Hit, Method, Outcome};
use rayon::prelude::*;
use std::fmt::Write;

/// How far a depth may be from the truth, as a part of the depth or of the region's size, whichever is more.
const NEAR_ENOUGH: f64 = 1e-9;

/// The steps of the textbook method through half of the region's diagonal.
const MARCH_STEPS: f64 = 2000.0;

/// How many of the decided pixels the textbook method has to get right at that step.
const MARCH_SHARE: f64 = 0.999;

/// A pixel that is not as it should be.
struct Fault {
    pixel: (usize, usize),
    truth: f64,
    hit: Hit,
}

/// What became of one case's pixels.
struct Report {
    name: String,
    decided: usize,
    proven: usize,
    touch: usize,
    undecided: usize,
    faults: Vec<Fault>,
}

/// Traces a case and compares every pixel that is decided.
fn report(case: &Case, method: Method, way: Way) -> Report {
    let truth = npy::matrix(&std::fs::read(&case.depths).unwrap()).unwrap();
    assert_eq!((truth.rows, truth.columns), (case.height as usize, case.width as usize), "{}", case.name);
    let hits = case.trace(method, way).unwrap_or_else(|error| panic!("{}: {error}", case.name));
    assert_eq!(hits.len(), truth.numbers.len(), "{}", case.name);
    let count = |outcome| hits.iter().filter(|hit| hit.outcome == outcome).count();
    let mut report = Report {
        name: case.name.clone(),
        decided: 0,
        proven: hits.iter().filter(|hit| hit.proven).count(),
        touch: count(Outcome::Touch),
        undecided: count(Outcome::Undecided),
        faults: Vec::new(),
    };
    for (k, (&truth, &hit)) in truth_pairs(&truth.numbers, &hits) {
        report.decided += 1;
        if !is_right(truth, &hit, case.size()) {
            let pixel = (k % case.width as usize, k / case.width as usize);
            report.faults.push(Fault { pixel, truth, hit });
        }
    }
    report
}

/// Pixel numbers with truth and hit, where the truth is decided.
fn truth_pairs<'a>(truth: &'a [f64], hits: &'a [Hit]) -> impl Iterator<Item = (usize, (&'a f64, &'a Hit))> {
    truth.iter().zip(hits).enumerate().filter(|(_, (truth, _))| !truth.is_nan())
}

fn is_right(truth: f64, hit: &Hit, size: f64) -> bool {
    match (truth.is_finite(), hit.is_drawn()) {
        (true, true) => (hit.t - truth).abs() <= NEAR_ENOUGH * truth.max(size),
        (truth, drawn) => truth == drawn,
    }
}

fn reports(cases: &[Case], way: Way, method: impl Fn(&Case) -> Method + Sync) -> Vec<Report> {
    cases.par_iter().map(|case| report(case, method(case), way)).collect()
}

/// One line a case, and its first fault.
fn table(reports: &[Report]) -> String {
    let mut text = String::from("\ncase                              decided   wrong  (proven)   touch  undecided\n");
    for report in reports.iter().filter(|report| !report.faults.is_empty()) {
        let proven = report.faults.iter().filter(|fault| fault.hit.proven).count();
        let Report { name, decided, touch, undecided, .. } = report;
        let wrong = report.faults.len();
        writeln!(text, "{name:32} {decided:8} {wrong:7} {proven:9} {touch:7} {undecided:10}").unwrap();
        if let Some(Fault { pixel: (i, j), truth, hit }) = report.faults.first() {
            writeln!(text, "    pixel {i},{j}: {:?} at {:?}, truth {truth:?}", hit.outcome, hit.t).unwrap();
        }
    }
    let sum = |part: fn(&Report) -> usize| reports.iter().map(part).sum::<usize>();
    let (proven, touch, undecided) = (sum(|r| r.proven), sum(|r| r.touch), sum(|r| r.undecided));
    writeln!(text, "in all: {proven} proven, {touch} touch, {undecided} undecided").unwrap();
    text
}

fn all_are_right(cases: &[Case]) {
    for way in [Way::Rays, Way::Squares] {
        all_are_right_by(way, cases);
    }
}

fn all_are_right_by(way: Way, cases: &[Case]) {
    let reports = reports(cases, way, |_| Method::Faithful);
    let proven = reports.iter().flat_map(|report| &report.faults).filter(|fault| fault.hit.proven).count();
    assert_eq!(proven, 0, "{way:?}: proven and wrong{}", table(&reports));
    assert!(reports.iter().all(|report| report.faults.is_empty()), "{way:?}: {}", table(&reports));
    assert!(reports.iter().map(|report| report.decided).sum::<usize>() > 100_000, "too little was decided");
}

#[test]
fn faithful_is_right_at_every_decided_pixel_of_the_twenty_pictures() {
    let cases = cases("truth");
    assert_eq!(cases.len(), 20);
    all_are_right(&cases);
}

#[test]
fn faithful_is_right_at_every_decided_pixel_of_the_hard_cases() {
    let cases = cases("exact");
    assert!(cases.len() >= 200, "only {} cases", cases.len());
    all_are_right(&cases);
}

#[test]
fn march_is_right_at_nearly_every_pixel_of_the_twenty_pictures() {
    let reports = reports(&cases("truth"), Way::Rays, |case| Method::March { step: case.size() / MARCH_STEPS });
    let decided: usize = reports.iter().map(|report| report.decided).sum();
    let wrong: usize = reports.iter().map(|report| report.faults.len()).sum();
    assert!(reports.iter().all(|report| report.proven == 0), "march proves nothing");
    assert!(wrong as f64 <= (1.0 - MARCH_SHARE) * decided as f64, "{wrong} of {decided} wrong{}", table(&reports));
    eprintln!("march: {wrong} of {decided} wrong{}", table(&reports));
}

#[test]
fn the_comparison_can_say_no() {
    let hit = |t| Hit { outcome: Outcome::Hit, t, ..Hit::NONE };
    for (truth, hit, right) in [
        (2.0, hit(2.0), true),
        (2.0, hit(2.0 + 1e-9), true),
        (2.0, hit(2.0 + 3e-9), false),
        (2.0, Hit::NONE, false),
        (f64::INFINITY, hit(2.0), false),
        (f64::INFINITY, Hit::NONE, true),
        (2.0, hit(f64::NAN), false),
    ] {
        assert_eq!(is_right(truth, &hit, 1.0), right, "{truth} {hit:?}");
    }
}
