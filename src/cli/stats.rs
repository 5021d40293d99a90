//! What a drawing took, and what is proven of it.
//!
//! In: moments between the stages, the report of the drawing. Out: an object for programs, sentences for people.

use super::clock::Moment;
use crate::render::Report;
use crate::session::Plan;
use crate::surface::Shape;
use serde_json::{Value, json};

/// The moments at which the stages ended; the first begins with the process.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stages {
    /// Texts are trees.
    pub parsed: Moment,
    /// Trees are surfaces.
    pub compiled: Moment,
    /// Surfaces are a picture.
    pub drawn: Moment,
    /// The picture is a file.
    pub encoded: Moment,
}

/// Seconds of each stage.
struct Seconds {
    parse: f64,
    compile: f64,
    trace: f64,
    shade: f64,
    encode: f64,
}

impl Seconds {
    /// By one of the two times. Tracing and shading take turns on every thread, so the time of both is shared out as
    /// the threads spent it.
    fn new(stages: &Stages, report: &Report, time: fn(Moment) -> f64) -> Self {
        let [parsed, compiled, drawn, encoded] =
            [stages.parsed, stages.compiled, stages.drawn, stages.encoded].map(time);
        let both = report.trace_seconds + report.shade_seconds;
        let share = if both > 0.0 { report.trace_seconds / both } else { 1.0 };
        let drawing = (drawn - compiled).max(0.0);
        let trace = drawing * share;
        Seconds {
            parse: parsed,
            compile: (compiled - parsed).max(0.0),
            trace,
            shade: drawing - trace,
            encode: (encoded - drawn).max(0.0),
        }
    }

    fn total(&self) -> f64 {
        self.parse + self.compile + self.trace + self.shade + self.encode
    }

    fn json(&self) -> Value {
        json!({
            "parse": self.parse, "compile": self.compile, "trace": self.trace,
            "shade": self.shade, "encode": self.encode, "total": self.total(),
        })
    }
}

/// The object for programs, on one line.
pub fn json_line(stages: &Stages, plan: &Plan, report: &Report) -> String {
    let counts = report.counts;
    let size = plan.settings.size;
    let object = json!({
        "seconds": Seconds::new(stages, report, |m| m.wall).json(),
        "cpu_seconds": Seconds::new(stages, report, |m| m.cpu).json(),
        "pixels": size.pixels(),
        "hits": report.hits,
        "misses": report.misses,
        "touch": report.touch,
        "undecided": report.undecided,
        "proven": report.proven,
        "rays": counts.rays,
        "evaluations": { "points": counts.points, "gradients": counts.gradients, "cells": counts.cells },
        "threads": plan.settings.threads,
        "size": [size.width(), size.height()],
        "region": plan.region.iter().map(region_json).collect::<Vec<Value>>(),
        "version": env!("CARGO_PKG_VERSION"),
    });
    format!("{object}\n")
}

fn region_json(shape: &Shape) -> Value {
    match *shape {
        Shape::Box { min, max } => json!({ "box": [min.x, max.x, min.y, max.y, min.z, max.z] }),
        Shape::Ball { center, radius } => json!({ "ball": [center.x, center.y, center.z, radius] }),
    }
}

/// A region as the option that asks for it.
pub fn region_option(shape: &Shape) -> String {
    match *shape {
        Shape::Box { min, max } => format!("--box {},{},{},{},{},{}", min.x, max.x, min.y, max.y, min.z, max.z),
        Shape::Ball { center, radius } => format!("--ball {},{},{},{radius}", center.x, center.y, center.z),
    }
}

/// The same for people.
pub fn sentences(stages: &Stages, plan: &Plan, report: &Report) -> String {
    let wall = Seconds::new(stages, report, |m| m.wall);
    let cpu = Seconds::new(stages, report, |m| m.cpu);
    let counts = report.counts;
    let milliseconds = |seconds: f64| format!("{:.1} ms", seconds * 1e3);
    let size = plan.settings.size;
    let mut text = format!("{size} pixels, {} threads, {}\n", plan.settings.threads, proven_sentence(report));
    text += &format!(
        "hits {}, misses {}, touch {}, undecided {}\n",
        report.hits, report.misses, report.touch, report.undecided
    );
    text += &format!(
        "{} rays; f evaluated at {} points, with gradient at {}, enclosed over {} pieces of rays\n",
        counts.rays, counts.points, counts.gradients, counts.cells
    );
    text += &format!(
        "{} (processor {}): parse {}, compile {}, trace {}, shade {}, encode {}\n",
        milliseconds(wall.total()),
        milliseconds(cpu.total()),
        milliseconds(wall.parse),
        milliseconds(wall.compile),
        milliseconds(wall.trace),
        milliseconds(wall.shade),
        milliseconds(wall.encode)
    );
    text
}

/// What is proven, in one plain sentence.
fn proven_sentence(report: &Report) -> String {
    let pixels = report.hits + report.misses + report.touch + report.undecided;
    let open = pixels - report.proven;
    match (report.proven, open) {
        (0, _) => "nothing is proven: the method samples".into(),
        (_, 0) => "every one is proven at its centre: hit and depth, or empty".into(),
        (_, 1) => "all but 1 are proven at their centres".into(),
        _ => format!(
            "all but {open} are proven at their centres ({:.3} %)",
            report.proven as f64 / pixels as f64 * 100.0
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_sum_to_the_total() {
        let at = |wall, cpu| Moment { wall, cpu };
        let stages =
            Stages { parsed: at(1.0, 0.5), compiled: at(3.0, 2.0), drawn: at(13.0, 21.0), encoded: at(14.0, 22.5) };
        let report = Report { trace_seconds: 3.0, shade_seconds: 1.0, ..Report::default() };
        let wall = Seconds::new(&stages, &report, |m| m.wall);
        assert_eq!((wall.parse, wall.compile, wall.trace, wall.shade, wall.encode), (1.0, 2.0, 7.5, 2.5, 1.0));
        assert_eq!(wall.total(), 14.0);
        assert_eq!(Seconds::new(&stages, &report, |m| m.cpu).total(), 22.5);
    }
}
