//! Tests of lowering: typed programs with their values, wrong programs with their messages, limits.

mod errors;
mod evaluate;
mod limits;
mod statements;
mod value_table;

use super::{Lowered, Setting, Settings, lower};
use crate::diag::{Diagnostic, SourceId};
use crate::num::rational::Rational;
use crate::syntax;

/// A program's mathematics; a program that does not parse fails the test.
fn lowered(text: &str) -> Lowered {
    lowered_with(text, &[])
}

/// The same with parameters set.
fn lowered_with(text: &str, set: &[(&str, &str)]) -> Lowered {
    let parsed = syntax::parse(&[(SourceId(0), text)]);
    let errors: Vec<&Diagnostic> = parsed.diagnostics.iter().filter(|diagnostic| diagnostic.is_error()).collect();
    assert!(errors.is_empty(), "{text}: {errors:?}");
    let setting = |&(name, value): &(&str, &str)| {
        let (sign, digits) = if let Some(digits) = value.strip_prefix('-') { (true, digits) } else { (false, value) };
        let value = Rational::from_decimal(digits).expect("a decimal");
        Setting { name: name.to_owned(), value: if sign { value.negated() } else { value } }
    };
    lower(&parsed.program, &Settings { set: set.iter().map(setting).collect(), incomplete: false })
}

/// The errors alone.
fn errors(lowered: &Lowered) -> Vec<&Diagnostic> {
    lowered.diagnostics.iter().filter(|diagnostic| diagnostic.is_error()).collect()
}
