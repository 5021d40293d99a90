//! Nothing that can be typed takes long, overflows the stack or grows without bound.
//!
//! Tests run on threads of 2 MiB, the smallest stack a worker has.

use super::{errors, lowered};
use std::fmt::Write;

/// Nodes that the first surface is made of.
fn size(text: &str) -> usize {
    let lowered = lowered(text);
    assert!(errors(&lowered).is_empty(), "{:?}", errors(&lowered)[0]);
    lowered.graph.reachable(&[lowered.surfaces[0].f]).len()
}

/// `head`, then `line` for each k from 1 with `{k}` and `{j}` (k − 1) filled in, then `tail`.
fn chain(head: &str, line: &str, count: usize, tail: &str) -> String {
    let mut text = head.to_owned();
    for k in 1..=count {
        let line = line.replace("{k}", &k.to_string()).replace("{j}", &(k - 1).to_string());
        let _ = write!(text, "; {line}");
    }
    text + "; " + tail
}

#[test]
fn doubling_stays_small_because_what_is_equal_is_shared() {
    assert!(size(&chain("a_0 = sin(x)", "a_{k} = a_{j} + a_{j}*y", 60, "a_60 - 1")) < 200);
    assert!(size(&chain("f_0(u) = sin(u)", "f_{k}(u) = f_{j}(u) + f_{j}(u)*y", 60, "f_60(x) = 1")) < 200);
    assert!(size(&chain("f_0(u) = u^2 + x", "f_{k}(u) = f_{j}(f_{j}(u))", 6, "f_6(y) = 1")) < 200);
    assert!(size(&chain("v_0 = p", "v_{k} = v_{j} + cross(v_{j}, p)", 60, "v_60.x = 1")) < 3000);
    assert!(size(&chain("A_0 = x < 1", "A_{k} = A_{j} or not A_{j}", 60, "A_60")) < 200);
    assert!(size("x^1000000000 = ((y^9)^9)^9") < 10);
    assert!(size("chebyshev(1000000000, x)") < 200);
}

#[test]
fn long_flat_text_makes_a_shallow_graph() {
    for (head, repeated, tail) in [("x", " + x*2 - y", " = 0"), ("x", "*y", " = 1"), ("x < 1", " or y < x", "")] {
        let text = head.to_owned() + &repeated.repeat(10_000) + tail;
        assert!(size(&text) < 100_000, "{head}{repeated}");
    }
    assert!(size("sum(k = 1..5000, sin(k x))") > 10_000);
}

#[test]
fn limits_are_errors_with_a_place() {
    let deep = |count: usize| "f(".repeat(count) + "x" + &")".repeat(count);
    let rows = [
        ("sum(k = 1..1000000000, x)".to_owned(), "more terms than the 100000 nodes"),
        ("sum(k = -9223372036854775807..9223372036854775807, x)".to_owned(), "more terms than the 100000 nodes"),
        ("sum(k = 1..99999, sin(k x))".to_owned(), "too large"),
        ("sum(k = 1..99999, sum(j = 1..99999, x))".to_owned(), "too large"),
        ("product(k = 1..99999, product(j = 1..99999, 1)) = x".to_owned(), "too large"),
        ("legendre(1000000000, x)".to_owned(), "more terms than the 100000 nodes"),
        ("legendre(90000, x)".to_owned(), "too large"),
        ("x^100000000000000000000 = 1".to_owned(), "this exponent is too large"),
        ("x^(1/100000000000001) = 1".to_owned(), "the order of this root is too large"),
        (chain("a_0 = x", "a_{k} = a_{j} + 1", 1500, "a_1500"), "more than 1000 definitions"),
        (chain("f_0(u) = u", "f_{k}(u) = f_{j}(sin(u)) + 1", 900, "f_900(x) = 0"), "nested too deep"),
        (format!("f(u) = sin(u + 1); {} = 0", deep(200)), ""),
        (chain("a_0 = x", "a_{k} = sin(cos(sin(cos(sin(cos(a_{j}))))))", 900, "a_900"), "too deep in one another"),
    ];
    for (text, words) in rows {
        let start = std::time::Instant::now();
        let lowered = lowered(&text);
        let said: Vec<&String> = errors(&lowered).iter().map(|error| &error.message).collect();
        let head = &text[..text.len().min(60)];
        if words.is_empty() {
            assert!(said.is_empty(), "{head}: {said:?}");
        } else {
            assert!(said.len() == 1 && said[0].contains(words), "{head}: {said:?}");
        }
        assert!(start.elapsed().as_secs() < 10, "{head} took {:?}", start.elapsed());
    }
}

#[test]
fn chains_within_the_limits_work() {
    assert!(size(&chain("a_0 = x", "a_{k} = a_{j}*x + 1", 900, "a_900")) > 900);
    assert!(size(&chain("f_0(u) = u", "f_{k}(u) = f_{j}(u)*u + 1", 150, "f_150(x) = 0")) > 150);
    assert!(size(&("sin(".repeat(100) + "x" + &")".repeat(100) + " = 0")) > 100);
}

#[test]
fn many_wrong_statements_do_not_take_long() {
    let rows = [
        "r = 1;".repeat(20_000),
        "a = 1;".repeat(20_000),
        (0..20_000).map(|k| format!("a_{k} = a_{};", (k + 1) % 20_000)).collect(),
        (0..5_000).map(|k| format!("a_{k} = a_{} + a_{};", (k + 1) % 5_000, k / 2)).collect(),
        (0..5_000).map(|k| format!("sin({k}, x);")).collect(),
    ];
    for text in rows {
        let start = std::time::Instant::now();
        let lowered = lowered(&text);
        assert!(lowered.diagnostics.iter().filter(|diagnostic| diagnostic.is_error()).count() <= 20_000);
        assert!(start.elapsed().as_secs() < 10, "{} took {:?}", &text[..20], start.elapsed());
    }
}

#[test]
fn lights_have_a_limit_of_their_own() {
    // Short enough for a text each, and together one too many.
    let quarter = "light{at:(1,2,3),power:1}\n".repeat(crate::expr::lower::MAX_LIGHTS / 4);
    let texts = [&quarter, &quarter, &quarter, &quarter].map(String::as_str);
    let last = "x = 1; light { at: (1, 2, 3), power: 1 }";
    let sources: Vec<(crate::diag::SourceId, &str)> =
        texts.into_iter().chain([last]).enumerate().map(|(k, text)| (crate::diag::SourceId(k as u32), text)).collect();
    for (sources, is_too_much) in [(&sources[1..], false), (&sources[..], true)] {
        let parsed = crate::syntax::parse(sources);
        assert!(!parsed.has_errors(), "{:?}", parsed.diagnostics.first());
        let lowered = super::lower(&parsed.program, &super::Settings::default());
        let said: Vec<&str> = super::errors(&lowered).iter().map(|error| error.message.as_str()).collect();
        assert_eq!(said.contains(&"a program has at most 100000 lights"), is_too_much, "{said:?}");
        assert_eq!(said.len(), usize::from(is_too_much));
    }
}
