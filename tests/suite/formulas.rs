//! Two thousand random formulas: printed and read they are the same, and their values and gradients are mpmath's.
//!
//! In: tests/data/random-formulas.tsv, made by tests/tools/random_formulas.py. Out: passed or failed. Apart from the tables
//! written by hand because here chance finds the pairs of rules that nobody thought of.

use glam::DVec3;
use implicit::closure::{Formula, Kernel, Tape};
use implicit::diag::SourceId;
use implicit::expr::derivative;
use implicit::expr::graph::{Graph, NodeId};
use implicit::expr::print;
use implicit::num::ball_lanes::BallLanes;
use implicit::num::interval::{Defined, Interval};
use implicit::num::lanes::Lanes;
use implicit::num::level::Simd;
use implicit::session::{NoFiles, Program, Text};
use implicit::syntax;

/// Printed formulas are followed up to this many bytes.
const LONGEST: usize = 100_000;

/// Where a formula is well conditioned: some forty operations, each good to a few units in the last place.
const TOLERANCE: f64 = 1e-12;

struct Row<'t> {
    text: &'t str,
    point: DVec3,
    value: f64,
    gradient: DVec3,
}

fn numbers(text: &str) -> Vec<f64> {
    text.split(' ').map(|number| number.parse().unwrap()).collect()
}

fn row(line: &str) -> Row<'_> {
    let [text, point, value, gradient] = line.split('\t').collect::<Vec<_>>()[..] else {
        panic!("a broken row: {line}")
    };
    let slopes = if gradient == "nan" { vec![f64::NAN; 3] } else { numbers(gradient) };
    let (point, gradient) = (DVec3::from_slice(&numbers(point)), DVec3::from_slice(&slopes));
    Row { text, point, value: value.parse().unwrap(), gradient }
}

fn rows(table: &str) -> Vec<Row<'_>> {
    table.lines().filter(|line| !line.starts_with('#')).map(row).collect()
}

fn table() -> String {
    std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/random-formulas.tsv")).unwrap()
}

/// The graph of a program and its formula.
fn read(text: &str) -> (Graph, NodeId) {
    let program = Program::from_text(text);
    let errors: Vec<_> = program.diagnostics.iter().filter(|d| d.is_error()).map(|d| &d.message).collect();
    assert!(errors.is_empty(), "{text}: {errors:?}");
    (program.lowered.graph, program.lowered.surfaces[0].f)
}

/// Whether two texts, read as one program, are one node: equal graphs are one graph.
fn are_one(first: &str, second: &str) -> bool {
    let text = |text: &str| Text { name: String::new(), key: String::new(), text: text.to_owned() };
    let program = Program::read(vec![text(first), text(second)], Vec::new(), &NoFiles);
    let surfaces = &program.lowered.surfaces;
    !program.has_errors() && surfaces.len() == 2 && surfaces[0].f == surfaces[1].f
}

#[test]
fn printed_and_read_again_a_formula_is_the_same() {
    let table = table();
    let rows = rows(&table);
    assert!(rows.len() >= 2000);
    let mut wrong = Vec::new();
    for Row { text, .. } in rows {
        let (graph, f) = read(text);
        let mut shown = vec![print::text(&graph, f, LONGEST).unwrap()];
        let parsed = syntax::parse(&[(SourceId(0), text)]).program;
        let printed = syntax::print::program(&parsed);
        let again = syntax::parse(&[(SourceId(0), &printed)]).program;
        if syntax::print::program(&again) != printed {
            wrong.push(format!("{text}\n    {printed}"));
        }
        // What is defined cannot be defined a second time.
        if parsed.statements.len() == 1 {
            shown.extend([printed, syntax::print::bracketed_statement(&parsed.statements[0])]);
        }
        wrong.extend(shown.iter().filter(|shown| !are_one(text, shown)).map(|shown| format!("{text}\n    {shown}")));
    }
    assert!(wrong.is_empty(), "{} differ:\n{}", wrong.len(), wrong.join("\n"));
}

/// What is wrong with a number, if anything: it is the exact one, up to what the enclosure shows rounding to cost.
fn judged(found: f64, exact: f64, over: &implicit::num::interval::Enclosure) -> Result<bool, String> {
    if found.is_nan() || exact.is_nan() {
        let open = over.defined != Defined::Everywhere;
        return if found.is_nan() && open { Ok(exact.is_nan()) } else { Err(format!("{found}, {over:?}")) };
    }
    let Interval { lo, hi } = over.range;
    // The exact value was rounded to 17 digits; differences of 120 digits tell no slope below 1e-70 from 0.
    let slack = exact.abs() * f64::EPSILON + 1e-60;
    if !(lo <= exact + slack && exact - slack <= hi) {
        return Err(format!("{exact} is not in {over:?}"));
    }
    let size = exact.abs().max(1.0);
    let allowed = (TOLERANCE * size).max(hi - lo);
    if (found - exact).abs() <= allowed { Ok(hi - lo <= 1e-6 * size) } else { Err(format!("{found}, {over:?}")) }
}

#[test]
fn values_and_gradients_are_those_of_another_program() {
    let table = table();
    let (mut wrong, mut count, mut loose) = (Vec::new(), 0, 0);
    for row in rows(&table) {
        let (mut graph, f) = read(row.text);
        let slopes = derivative::gradient(&mut graph, f);
        let (value, gradient) = Formula::new(&mut graph, f, Simd::best()).gradient(row.point);
        let place = row.point.to_array().map(Interval::point);
        let found = [value, gradient.x, gradient.y, gradient.z];
        let exact = [row.value, row.gradient.x, row.gradient.y, row.gradient.z];
        for (k, node) in [f].into_iter().chain(slopes).enumerate() {
            if k > 0 && row.value.is_nan() {
                break;
            }
            count += 1;
            let over = Formula::new(&mut graph, node, Simd::best()).enclosure(place);
            match judged(found[k], exact[k], &over) {
                // A value that is there is found; its slope may be hidden where a root's own slope is infinite.
                Ok(false) if k == 0 && found[k].is_nan() => wrong.push(format!("{}: no value", row.text)),
                Ok(tight) => loose += usize::from(!tight),
                Err(why) => wrong.push(format!("{} at {}: {k}: {}, not {why}", row.text, row.point, exact[k])),
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {count} are wrong:\n{}", wrong.len(), wrong.join("\n"));
    assert!(loose * 100 < count, "of {loose} of {count} numbers nothing is known");
}

/// What a chain of operations does to a point is within what its ball says.
#[test]
fn balls_contain_the_values_of_random_formulas() {
    let table = table();
    let (mut all, mut narrow) = (0, 0);
    for Row { text, point, value, .. } in rows(&table) {
        let (graph, f) = read(text);
        let kernel: Kernel<BallLanes<64>> = Kernel::new(&Tape::for_points(&graph, &[f]), Simd::best());
        let mut registers = kernel.registers();
        for axis in 0..3 {
            registers[axis] = BallLanes { center: Lanes::splat(point[axis]), radius: Lanes::splat(0.0) };
        }
        kernel.run(&mut registers);
        let ball = kernel.output(&registers, 0);
        let (center, radius) = (ball.center.0[63], ball.radius.0[63]);
        if value.is_finite() && center.is_finite() {
            all += 1;
            narrow += u32::from(radius <= 1e-11 * (1.0 + value.abs()));
            // The table's values are rounded.
            let ulp = value.abs().next_up() - value.abs();
            assert!(
                !radius.is_finite() || (center - value).abs() <= radius + ulp,
                "{text} at {point}: {center:e} ± {radius:e}, not {value:e}"
            );
        }
    }
    assert!(all > 1500 && narrow * 10 > all * 9, "{narrow} of {all} balls are narrow");
}
