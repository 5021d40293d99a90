//! Every row of the table of typed programs has the value that mpmath found.

use super::evaluate::value_at;
use super::{errors, lowered};

const TABLE: &str = include_str!("../../../../tests/data/language-values.tsv");

/// Some forty operations at f64, each good to a few units in the last place.
const TOLERANCE: f64 = 1e-12;

#[test]
fn typed_programs_have_the_values_of_the_table() {
    let mut wrong = Vec::new();
    let mut rows = 0;
    for line in TABLE.lines().filter(|line| !line.starts_with('#')) {
        let [text, point, expected] = line.split('\t').collect::<Vec<_>>()[..] else { panic!("a broken row: {line}") };
        let point: Vec<f64> = point.split(' ').map(|number| number.parse().expect("a number")).collect();
        let expected: f64 = expected.parse().expect("a number");
        rows += 1;
        if let Err(found) = check(text, [point[0], point[1], point[2]], expected) {
            wrong.push(format!("{text} at {point:?}: expected {expected}, found {found}"));
        }
    }
    assert!(rows >= 250, "only {rows} rows");
    assert!(wrong.is_empty(), "{} of {rows} rows are wrong:\n{}", wrong.len(), wrong.join("\n"));
}

fn check(text: &str, point: [f64; 3], expected: f64) -> Result<(), String> {
    let parsed = crate::syntax::parse(&[(crate::diag::SourceId(0), text)]);
    if let Some(error) = parsed.diagnostics.iter().find(|diagnostic| diagnostic.is_error()) {
        return Err(format!("the parser's error: {}", error.message));
    }
    let lowered = super::lower(&parsed.program, &super::Settings::default());
    if let Some(error) = errors(&lowered).first() {
        return Err(format!("the error: {}", error.message));
    }
    let Some(surface) = lowered.surfaces.first() else { return Err("no surface".to_owned()) };
    let found = value_at(&lowered.graph, surface.f, point);
    let near = (found - expected).abs() <= TOLERANCE * expected.abs().max(1.0);
    if near || (found.is_nan() && expected.is_nan()) { Ok(()) } else { Err(found.to_string()) }
}

#[test]
fn a_wrong_value_would_be_found() {
    assert!(check("x + 1", [1.0, 0.0, 0.0], 2.0).is_ok());
    assert!(check("x + 1", [1.0, 0.0, 0.0], 2.0001).is_err());
    assert!(check("ln(x)", [-1.0, 0.0, 0.0], 0.0).is_err());
    assert_eq!(errors(&lowered("x + 1")).len(), 0);
}
