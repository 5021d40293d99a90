//! `implicit eval`: f and its gradient at points, enclosures of f over boxes.
//!
//! In: programs, points or boxes on the command line or on standard input. Out: a line a surface, as text or JSON.

use super::args::{EvalArgs, Place};
use super::complaint::Complaint;
use super::values::listed;
use super::{console, programs};
use crate::closure::Formula;
use crate::diag::{nearest, printable};
use crate::expr::graph::NodeId;
use crate::expr::lower::Value;
use crate::num::interval::{Defined, Enclosure, Interval};
use crate::session::Program;
use glam::DVec3;
use std::io::BufRead;

/// Evaluates.
///
/// # Errors
/// Errors of the programs, or what is wrong with a point.
pub fn run(args: EvalArgs) -> Result<(), Complaint> {
    let reads_lines = args.at == Some(Place::Lines) || args.over == Some(Place::Lines);
    if reads_lines && args.program.programs.iter().any(|program| program == programs::STDIN) {
        return Err(Complaint::usage("the program and the places cannot both come on standard input"));
    }
    if let Some(Place::Here(values)) = args.at {
        point(values).map_err(Complaint::usage)?;
    }
    if let Some(Place::Here(values)) = args.over {
        cell(values).map_err(Complaint::usage)?;
    }
    let mut program = programs::load(&args.program)?;
    let formulas = formulas(&mut program, args.of.as_deref())?;
    match (args.at, args.over) {
        (Some(place), _) => each(place, |values| Ok(print_values(&formulas, point(values)?, args.json))),
        (None, Some(place)) => each(place, |values| Ok(print_enclosures(&formulas, cell(values)?, args.json))),
        (None, None) => Ok(()),
    }
}

/// The node of the definition that `--of` names.
///
/// # Errors
/// If there is none, or it is no number.
pub fn definition(program: &Program, name: &str) -> Result<NodeId, Complaint> {
    let Some(definition) = program.lowered.definition(name) else {
        let names: Vec<&str> = program.lowered.definitions.iter().map(|d| d.name.as_str()).collect();
        let near = nearest(name, names.iter().copied());
        let hint = near.first().map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
        return Err(Complaint::program(format!("the program defines no '{}'{hint}", printable(name, 60))));
    };
    match &definition.value {
        Value::Number(node) => Ok(*node),
        Value::Region(region) => Ok(region.side),
        other => Err(Complaint::program(format!("'{}' is {}, not a number", printable(name, 60), other.kind()))),
    }
}

fn formulas(program: &mut Program, of: Option<&str>) -> Result<Vec<Formula>, Complaint> {
    let nodes: Vec<NodeId> = match of {
        Some(name) => vec![definition(program, name)?],
        None => program.lowered.surfaces.iter().map(|surface| surface.f).collect(),
    };
    if nodes.is_empty() {
        return Err(Complaint::diagnostics(&program.lowered.nothing_to_draw, &program.sources));
    }
    let simd = super::render::simd();
    Ok(nodes.into_iter().map(|node| Formula::new(&mut program.lowered.graph, node, simd)).collect())
}

/// Calls `answer` for the place on the command line, or for every line of standard input, and prints its answers.
fn each<const N: usize>(place: Place<N>, answer: impl Fn([f64; N]) -> Result<String, String>) -> Result<(), Complaint> {
    let values = match place {
        Place::Here(values) => return console::print(answer(values).map_err(Complaint::usage)?.as_bytes()),
        Place::Lines => std::io::stdin().lock().lines(),
    };
    for (index, line) in values.enumerate() {
        let fail = |why: String| Complaint::program(format!("{why}\n --> <stdin>:{}:1", index + 1));
        let line = line.map_err(|error| fail(console::reason(&error)))?;
        if !line.trim().is_empty() {
            let text = listed(&line).and_then(&answer).map_err(fail)?;
            console::print(text.as_bytes())?;
        }
    }
    Ok(())
}

fn point(values: [f64; 3]) -> Result<DVec3, String> {
    match values.iter().all(|value| value.is_finite()) {
        true => Ok(values.into()),
        false => Err("the numbers of a point must be finite".into()),
    }
}

fn cell(values: [f64; 6]) -> Result<[Interval; 3], String> {
    let [x0, x1, y0, y1, z0, z1] = values;
    for (name, low, high) in [("x", x0, x1), ("y", y0, y1), ("z", z0, z1)] {
        if low.is_nan() || high.is_nan() || low > high || low == f64::INFINITY || high == f64::NEG_INFINITY {
            return Err(format!("in {name} there is nothing between {low} and {high}"));
        }
    }
    Ok([Interval { lo: x0, hi: x1 }, Interval { lo: y0, hi: y1 }, Interval { lo: z0, hi: z1 }])
}

fn print_values(formulas: &[Formula], at: DVec3, json: bool) -> String {
    let line = |formula: &Formula| {
        let (value, g) = formula.gradient(at);
        // Where f has no value it has no derivative, although the formula of the derivative may have one.
        let g = if value.is_nan() { DVec3::NAN } else { g };
        if json {
            let gradient = g.to_array().map(json_number).join(",");
            format!("{{\"value\":{},\"gradient\":[{gradient}]}}\n", json_number(value))
        } else {
            format!("f = {}  gradient = ({})\n", plain_number(value), g.to_array().map(plain_number).join(", "))
        }
    };
    formulas.iter().map(line).collect()
}

fn print_enclosures(formulas: &[Formula], over: [Interval; 3], json: bool) -> String {
    formulas.iter().map(|formula| enclosure_line(formula.enclosure(over), json)).collect()
}

fn enclosure_line(enclosure: Enclosure, json: bool) -> String {
    let Enclosure { range: Interval { lo, hi }, defined, continuous } = enclosure;
    let defined = match defined {
        Defined::Everywhere => "everywhere",
        Defined::Somewhere => "somewhere",
        Defined::Nowhere => "nowhere",
    };
    let is_empty = lo.is_nan();
    if json {
        let bound = |value| if is_empty { "null".into() } else { json_number(value) };
        let (lo, hi) = (bound(lo), bound(hi));
        return format!("{{\"lo\":{lo},\"hi\":{hi},\"defined\":\"{defined}\",\"continuous\":{continuous}}}\n");
    }
    let range = if is_empty { "nothing".into() } else { format!("[{}, {}]", plain_number(lo), plain_number(hi)) };
    let continuous = if continuous { "continuous" } else { "not proven continuous" };
    format!("f in {range}  defined {defined}, {continuous}\n")
}

/// The shortest digits that read back as the same number.
fn plain_number(value: f64) -> String {
    let text = format!("{value:?}").to_lowercase();
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

fn json_number(value: f64) -> String {
    match value {
        value if value.is_finite() => format!("{value:?}"),
        value if value.is_nan() => "\"nan\"".into(),
        value if value > 0.0 => "\"inf\"".into(),
        _ => "\"-inf\"".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back() {
        for value in [0.1, -0.0, 1e300, 5e-324, 1.0 / 3.0, 2.0f64.powi(60), 123_456_789.0] {
            assert_eq!(plain_number(value).parse::<f64>().unwrap().to_bits(), value.to_bits());
            let json: f64 = serde_json::from_str(&json_number(value)).unwrap();
            assert_eq!(json.to_bits(), value.to_bits());
        }
        let rows =
            [(f64::NAN, "nan", "\"nan\""), (f64::INFINITY, "inf", "\"inf\""), (f64::NEG_INFINITY, "-inf", "\"-inf\"")];
        for (value, plain, json) in rows {
            assert_eq!((plain_number(value).as_str(), json_number(value).as_str()), (plain, json));
        }
    }

    #[test]
    fn an_empty_enclosure_has_no_bounds() {
        let range = Interval { lo: f64::NAN, hi: f64::NAN };
        let line = enclosure_line(Enclosure { range, defined: Defined::Nowhere, continuous: false }, true);
        assert_eq!(line, "{\"lo\":null,\"hi\":null,\"defined\":\"nowhere\",\"continuous\":false}\n");
    }
}
