//! Texts made to break a parser: deep, long, random. Each is read or refused, quickly.

use super::{errors, read};
use crate::syntax::{MAX_NESTING, MAX_REPORTED, MAX_TEXT, parse, print};
use proptest::prelude::*;
use std::time::{Duration, Instant};

/// The stack of a worker that is given little.
const SMALL_STACK: usize = 1 << 19;

/// Far more than any text below takes, far less than a hang.
const PATIENCE: Duration = Duration::from_secs(20);

fn nestings(depth: usize) -> Vec<String> {
    let wrap = |open: &str, close: &str| format!("{}x{}", open.repeat(depth), close.repeat(depth));
    vec![
        wrap("(", ")"),
        wrap("sin(", ")"),
        wrap("-", ""),
        wrap("2^", ""),
        wrap("sin ", ""),
        wrap("√", ""),
        wrap("max(1, ", ")"),
        wrap("not ", " > 0"),
        wrap("[", "]"),
        wrap("|", "|"),
        wrap("(1 + 2*", ")"),
        wrap("sum(k = 1..2, ", ")"),
        wrap("if(x > 0, 1, ", ")"),
    ]
}

#[test]
fn sixty_levels_work_on_a_small_stack() {
    let work = || {
        for text in nestings(60).iter().filter(|text| !text.starts_with('[')) {
            let parsed = read(text);
            assert!(errors(&parsed).is_empty(), "{text}: {:?}", parsed.diagnostics);
            assert!(!print::program(&parsed.program).is_empty());
        }
    };
    let worker = std::thread::Builder::new().stack_size(SMALL_STACK).spawn(work).expect("a thread starts");
    assert!(worker.join().is_ok());
}

#[test]
fn deeper_than_the_limit_is_one_error_with_a_place() {
    let work = || {
        for depth in [MAX_NESTING + 1, 20_000] {
            for text in nestings(depth) {
                let start = Instant::now();
                let parsed = read(&text);
                let found = errors(&parsed);
                assert_eq!(found.len(), 1, "{}", &text[..20]);
                assert!(found[0].message.contains("nested more than"), "{}", found[0].message);
                assert!(start.elapsed() < PATIENCE);
            }
        }
    };
    let worker = std::thread::Builder::new().stack_size(1 << 21).spawn(work).expect("a thread starts");
    assert!(worker.join().is_ok());
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
    let parsed = parse(&[(crate::diag::SourceId(0), &defined), (crate::diag::SourceId(1), &unknown)]);
    assert_eq!(errors(&parsed).len(), MAX_REPORTED + 1);
    assert!(errors(&parsed)[MAX_REPORTED].message.contains("more errors"));
    assert!(start.elapsed() < PATIENCE, "{:?}", start.elapsed());
}

#[test]
fn too_long_names_and_numbers_are_refused() {
    for (text, words) in [("x".repeat(2000), "this name has 2000"), ("1".repeat(2000), "this number has 2000")] {
        assert!(errors(&read(&format!("y + {text}")))[0].message.contains(words));
    }
}

const WORDS: [&str; 62] = [
    "x", "y", "z", "e", "a", "r", "p", "pi", "sin", "cos", "sqrt", "max", "sum", "product", "if", "union", "f", "g",
    "xy", "ax", "2", "3.5", ".5", "1e3", "(", ")", "(", ")", "[", "]", "{", "}", "|", "|", "+", "-", "*", "/", "^",
    "%", "=", "==", "<", "<=", ">", ",", ":", ";", "\n", "..", ".", "and", "or", "not", "in", "√", "²", "⁻¹", "π",
    "!=", "#4af", "\"t\"",
];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn no_soup_of_words_breaks_the_parser(picks in prop::collection::vec((0..WORDS.len(), any::<bool>()), 0..60)) {
        let text: String = picks.iter().map(|&(i, blank)| format!("{}{}", WORDS[i], if blank { " " } else { "" })).collect();
        let parsed = read(&text);
        let mut sources = crate::diag::Sources::new();
        sources.add("soup", text);
        crate::diag::render(&parsed.diagnostics, &sources, false);
        print::program(&parsed.program);
    }

    #[test]
    fn no_text_breaks_the_parser(text in any::<String>()) {
        let parsed = read(&text);
        let mut sources = crate::diag::Sources::new();
        sources.add("any", text);
        crate::diag::render(&parsed.diagnostics, &sources, true);
    }

    #[test]
    fn no_bytes_break_the_parser(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        read(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn what_is_accepted_prints_as_what_reads_the_same(picks in prop::collection::vec((0..46usize, any::<bool>()), 1..12)) {
        let soup: String = picks.iter().map(|&(i, blank)| format!("{}{}", WORDS[i], if blank { " " } else { "" })).collect();
        let declared = "a = 2; f(u) = u; g(s, t) = s*t; ";
        let parsed = read(&format!("{declared}{soup}"));
        if errors(&parsed).is_empty() {
            let printed = print::program(&parsed.program);
            let again = read(&printed);
            prop_assert_eq!(super::readings(&parsed), super::readings(&again), "{}", printed);
        }
    }
}
