//! Texts of a megabyte, and of ten: read or refused at once, whatever they repeat.
//!
//! In: a few characters, repeated. Out: passed or failed. Apart from the parser's own tests because only tests of the whole
//! look at the clock.

use implicit::diag::{Diagnostic, SourceId};
use implicit::syntax::{MAX_REPORTED, MAX_TEXT, Parsed, parse};
use std::time::{Duration, Instant};

/// Far more than any text below takes on a busy machine, far less than a hang.
const PATIENCE: Duration = Duration::from_secs(20);

fn read(text: &str) -> Parsed {
    parse(&[(SourceId(0), text)])
}

fn errors(parsed: &Parsed) -> Vec<&Diagnostic> {
    parsed.diagnostics.iter().filter(|diagnostic| diagnostic.is_error()).collect()
}

#[test]
fn long_texts_are_read_or_refused_at_once() {
    let parts = [
        "1+",
        "x*",
        "xy",
        "x y ",
        "2x+",
        "(",
        ")",
        "|",
        "|x|",
        "sin ",
        "q1+",
        "\n",
        ";",
        "x;",
        "x\n",
        "{",
        "}",
        "[1,",
        "√",
        "x^",
        "-",
        "\"",
        "#",
        "1e",
        "é",
        "²",
        ".",
        "..",
        "a=1;",
        "f(x)=x;",
        "x{",
        "x{a:1}\n",
        "&&",
        "q q1 ",
        "(]",
        "x=1\n\n\n",
        "/2x",
        "sin x y ",
        "x²",
        "//",
        ",",
        "1,",
        "q0=q;",
    ];
    let mut slow = Vec::new();
    for part in parts {
        for size in [MAX_TEXT, 10 << 20] {
            let text = part.repeat(size / part.len());
            let start = Instant::now();
            let parsed = read(&text);
            let taken = start.elapsed();
            assert!(parsed.diagnostics.len() <= 2 * MAX_REPORTED + 2, "{part}");
            if taken > if size > MAX_TEXT { PATIENCE / 20 } else { PATIENCE } {
                slow.push((part, taken));
            }
        }
    }
    assert!(slow.is_empty(), "{slow:?}");
}

#[test]
fn many_different_names_are_no_burden() {
    let start = Instant::now();
    let defined: String = (0..40_000).map(|i| format!("name{i} = {i}\n")).collect();
    assert!(errors(&read(&defined)).is_empty());
    let unknown: String = (0..40_000).map(|i| format!("nane{i} + unknown{i}\n")).collect();
    let parsed = parse(&[(SourceId(0), &defined), (SourceId(1), &unknown)]);
    assert_eq!(errors(&parsed).len(), MAX_REPORTED + 1);
    assert!(errors(&parsed)[MAX_REPORTED].message.contains("more errors"));
    assert!(start.elapsed() < PATIENCE, "{:?}", start.elapsed());
}
