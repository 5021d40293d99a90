//! What a drawing took, and what is proven of it.
//!
//! In: moments between the stages, the report of the drawing. Out: an object for programs, sentences for people.

use super::clock::Moment;
use crate::render::transport::losses::losses;
use crate::render::{Drawing, Pass, Report};
use crate::session::Plan;
use crate::surface::{Method, Shape};
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

/// The same for people.
pub fn sentences(stages: &Stages, plan: &Plan, drawing: &Drawing) -> String {
    let report = &drawing.report;
    let wall = Seconds::new(stages, report, |m| m.wall);
    let cpu = Seconds::new(stages, report, |m| m.cpu);
    let counts = report.counts;
    let milliseconds = |seconds: f64| format!("{:.1} ms", seconds * 1e3);
    let size = plan.settings.size;
    let mut text = proven_sentence(report, plan.method);
    text += &format!("{size} pixels, {}, {} threads\n", samples(plan, drawing.pass), plan.settings.threads);
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
    for loss in losses(plan.settings.mode, &plan.scene) {
        text += &format!("warning: {loss}\n");
    }
    text
}

/// How many samples a pixel there are in the picture.
pub fn samples(plan: &Plan, pass: Pass) -> String {
    let (most, is_transport) = (plan.settings.samples, plan.settings.mode.is_transport());
    let plural = |count: u32| if count == 1 { "" } else { "s" };
    match pass {
        Pass::Squares(side) => format!("one ray for each square of {side}x{side} pixels"),
        Pass::Samples(count) if is_transport => format!("{count} of {most} samples a pixel"),
        Pass::Last if is_transport => format!("{most} sample{} a pixel", plural(most)),
        Pass::Samples(1) => "one ray a pixel, edges are not smooth yet".into(),
        Pass::Samples(count) => format!("at most {count} samples a pixel"),
        Pass::Last if most == 1 => "one ray a pixel".into(),
        Pass::Last => format!("at most {most} samples a pixel"),
    }
}

/// What is proven, in one plain sentence on a line.
fn proven_sentence(report: &Report, method: Method) -> String {
    let pixels = report.hits + report.misses + report.touch + report.undecided;
    let open = pixels - report.proven;
    let what = "the surface is where it is drawn and nothing is in front of it, or there is none";
    match (method, open) {
        (Method::March { .. }, _) => {
            "Nothing is proven: the method march samples each ray and can miss what is between two samples.\n".into()
        }
        (Method::Faithful | Method::Intervals, 0) => {
            format!("All {pixels} pixels are proven at their centres: {what}.\n")
        }
        (Method::Faithful | Method::Intervals, _) => format!(
            "{} of {pixels} pixels are proven at their centres ({:.3} %): {what}; {open} {} not.\n",
            report.proven,
            (report.proven as f64 / pixels as f64 * 100_000.0).floor() / 1000.0,
            if open == 1 { "is" } else { "are" }
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

    #[test]
    fn one_sentence_says_what_is_proven() {
        let report = |proven| Report { hits: 999_999, misses: 1, proven, ..Report::default() };
        let rows = [
            (report(1_000_000), Method::Faithful, "All 1000000 pixels are proven"),
            (report(999_999), Method::Faithful, "999999 of 1000000 pixels are proven at their centres (99.999 %)"),
            (report(0), Method::Faithful, "0 of 1000000 pixels are proven at their centres (0.000 %)"),
            (report(0), Method::March { step: 0.1 }, "Nothing is proven: the method march samples"),
        ];
        for (report, method, start) in rows {
            let sentence = proven_sentence(&report, method);
            assert!(sentence.starts_with(start) && sentence.ends_with(".\n"), "{sentence}");
        }
        assert!(proven_sentence(&report(999_999), Method::Faithful).ends_with("; 1 is not.\n"));
    }
}
