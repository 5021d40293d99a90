//! Programs that want to break it, through check, eval and a tiny picture: right, or refused with a place.
//!
//! In: texts that are long, deep, or small and expensive. Out: passed or failed; a crash, a panic and a run that does not
//! end all fail. Apart from `language` because here the answer matters less than that there is one.

use crate::command::{Folder, Said};

/// What is to become of a program.
enum End {
    /// This value at (0.5, -0.25, 0.125), and a picture.
    Value(f64),
    /// An error with these words, which names the file and, where there is one, the place.
    Refused(&'static str),
}
use End::{Refused, Value};

fn chain(first: &str, count: usize, next: impl Fn(usize) -> String) -> String {
    std::iter::once(first.to_owned()).chain((1..=count).map(next)).collect::<Vec<_>>().join("\n")
}

fn balls(count: usize) -> String {
    let ball = |i: usize| format!("(x-{})^2 + (y-{})^2 + (z-{})^2 <= 0.1", i % 10, i / 10 % 10, i / 100);
    (0..count).map(ball).collect::<Vec<_>>().join(", ")
}

/// Parts of a solid, each made of the one before.
fn nested_parts(count: usize) -> String {
    let part = |i: usize| {
        let kind = if i.is_multiple_of(2) { "difference" } else { "union" };
        format!("A{i} = {kind}(A{}, |p - (cos({i}), sin({i}), {i}/1000)| <= 0.1)", i - 1)
    };
    format!("{}\nA{count}", chain("A0 = x^2+y^2+z^2 <= 1", count, part))
}

/// The same nested in brackets.
fn nested_calls(count: usize) -> String {
    let wrap = |inner: String, i: usize| match i % 3 {
        0 => format!("union({inner}, x <= {i}/1000)"),
        1 => format!("difference({inner}, x^2+y^2 <= 0.001)"),
        _ => format!("intersection({inner}, z <= 2)"),
    };
    (0..count).fold("x^2+y^2+z^2 <= 1".to_owned(), wrap)
}

fn programs() -> Vec<(&'static str, String, End)> {
    let at_once = |text: &str, count: usize| text.repeat(count);
    let around = |open: &str, count: usize, close: &str| open.repeat(count) + "x" + &close.repeat(count);
    let doubling = |i: usize| format!("d{i} = d{0} + d{0}", i - 1);
    vec![
        ("a union of 1000 parts", format!("union({})", balls(1000)), Value(0.25 + 0.0625 + 0.015625 - 0.1)),
        ("1000 parts made of one another", nested_parts(999), Value(f64::NAN)),
        (
            "1001 parts made of one another",
            nested_parts(1001),
            Refused("more than 1000 definitions stand on each other"),
        ),
        ("200 calls in one another", nested_calls(200), Value(f64::NAN)),
        ("300 calls in one another", nested_calls(300), Refused("nested more than 256 levels")),
        ("a sum of 500 terms", "sum(k = 1..500, (-1)^k*x^k)".to_owned(), Value(-1.0 / 3.0)),
        ("a sum of 10^18 terms", "sum(k = 1..1e18, k*x)".to_owned(), Refused("more terms than")),
        (
            "a sum of sums of sums",
            "sum(i=1..999, sum(j=1..999, sum(k=1..999, i*j*k*x)))".to_owned(),
            Refused("too large"),
        ),
        ("60 doublings", chain("d0 = x", 60, doubling) + "\n(d60) = 0", Value(0.5 * 2f64.powi(60))),
        (
            "60 sums of the two before",
            chain("f0 = sin(x)\nf1 = cos(y)", 60, |i| format!("f{} = f{i} + f{}", i + 1, i - 1)) + "\n(f61) = z",
            Value(f64::NAN),
        ),
        (
            "60 doublings of a sine",
            chain("d0 = sin(x)", 60, |i| format!("d{i} = sin(d{0})*cos(d{0}) + d{0}", i - 1)) + "\n(d60) = 1",
            Value(f64::NAN),
        ),
        (
            "60 functions, each the one before twice",
            chain("f0(u) = sin(u)", 60, |i| format!("f{i}(u) = f{0}(f{0}(u))", i - 1)) + "\nz = f60(x)",
            Refused("too large"),
        ),
        ("a large power", "x^1000000000".to_owned(), Value(0.0)),
        ("a larger power", "x^1000000000000000000000".to_owned(), Refused("exponent is too large")),
        ("powers of powers", "((x^9)^9)^9".to_owned(), Value(0.5f64.powi(729))),
        ("a tower", "2^2^2^2^2^2^2*x".to_owned(), Value(f64::NAN)),
        ("a root of high order", "x^(1/4294967297)".to_owned(), Refused("order of this root is too large")),
        ("a polynomial of high degree", "chebyshev(1000000000, x)".to_owned(), Value(-0.5)),
        ("a recurrence without end", "legendre(1000000000, x)".to_owned(), Refused("more terms than")),
        ("five megabytes of sums", at_once("1+", 5 << 20) + "x", Refused("larger than 4 MiB")),
        ("more than a megabyte of sums", at_once("1+", 600 << 10) + "x", Refused("the limit is 1048576")),
        ("less than a megabyte of sums", at_once("1+", 500 << 10) + "x", Value(512_000.5)),
        ("brackets to the limit", around("(", 250, ")"), Value(0.5)),
        ("brackets beyond it", around("(", 257, ")"), Refused("nested more than 256 levels")),
        ("brackets without end", around("(", 400_000, ")"), Refused("nested more than 256 levels")),
        ("bars without end", around("|", 400_000, "|"), Refused("nested more than 256 levels")),
        ("minus signs without end", at_once("-", 400_000) + "x", Refused("nested more than 256 levels")),
        ("functions without end", at_once("sin ", 200_000) + "x", Refused("nested more than 256 levels")),
        ("powers without end", "x".to_owned() + &at_once("^x", 200_000), Refused("nested more than 256 levels")),
        ("roots without end", at_once("√", 200_000) + "x", Refused("nested more than 256 levels")),
        ("not without end", at_once("not ", 200_000) + "x < 1", Refused("nested more than 256 levels")),
        ("components without end", "p".to_owned() + &at_once(".x", 200_000), Refused("nested more than 256 levels")),
        ("many components", at_once("p.x + ", 2000) + "((x))", Value(1000.5)),
        ("quotients without end", "x".to_owned() + &at_once("/(x+y)", 100_000), Refused("too deep")),
        ("comparisons without end", "x".to_owned() + &at_once("<1", 200_000), Value(f64::NAN)),
        ("braces without end", at_once("{", 400_000), Refused("cannot begin with `{`")),
        ("a number without end", at_once("9", 900_000), Refused("the limit is 1000")),
        ("a name without end", at_once("q", 900_000), Refused("the limit is 64")),
        ("no program", String::new(), Refused("the program has no surface")),
        ("no letters", "x = 1\0".to_owned(), Refused("is not part of the language")),
    ]
}

fn check(what: &str, run: &str, said: &Said, end: &End) {
    let shown = format!("{what}, {run}: {} {}", said.status, said.err.chars().take(400).collect::<String>());
    match end {
        Value(value) => {
            assert_eq!(said.status, 0, "{shown}");
            let found = String::from_utf8_lossy(&said.out);
            if run == "eval" && value.is_finite() {
                let found: f64 = found.trim_start_matches("f = ").split(' ').next().unwrap().parse().unwrap();
                assert!((found - value).abs() <= 1e-12 * value.abs(), "{shown}: {found}");
            }
        }
        Refused(words) => {
            assert_eq!(said.status, 1, "{shown}");
            assert!(said.err.contains(words) && said.err.contains("hostile.imp"), "{shown}");
            assert!(said.err.len() < 60_000, "{what}, {run}: {} bytes of messages", said.err.len());
        }
    }
}

#[test]
fn hostile_programs_end_with_a_picture_or_a_place() {
    let folder = Folder::new();
    for (what, text, end) in programs() {
        folder.write("hostile.imp", &text);
        let runs: [(&str, &[&str]); 3] = [
            ("check", &["check", "--quiet", "hostile.imp"]),
            ("eval", &["eval", "--quiet", "hostile.imp", "--at", "0.5,-0.25,0.125"]),
            ("render", &["--quiet", "hostile.imp", "-o", "p.png", "-s", "4x3", "--samples", "1", "--ball", "0,0,0,2"]),
        ];
        for (run, args) in runs {
            check(what, run, &folder.run(args), &end);
            if matches!(end, Refused(_)) {
                assert_eq!(folder.names(), ["hostile.imp"], "{what}, {run}");
            }
        }
        let _ = std::fs::remove_file(folder.path.join("p.png"));
    }
}

#[test]
fn ten_megabytes_on_standard_input_are_refused() {
    let folder = Folder::new();
    let text = "1+".repeat(5 << 20);
    for args in [&["check", "-"][..], &["eval", "-", "--at", "0,0,0"], &["-", "-o", "p.png"]] {
        let said = folder.run_with(args, &text, &[]);
        assert!(said.status == 1 && said.err.contains("standard input: it is larger than 4 MiB"), "{said:?}");
    }
    // An argument cannot be as long; the longest that most systems pass on is 128 KiB.
    let said = folder.run(&["eval", "--at", "0.5,0,0", &("1+".repeat(60_000) + "x")]);
    assert!(said.status == 0 && said.out.starts_with(b"f = 60000.5 "), "{said:?}");
}

#[test]
fn includes_stay_in_their_folder_and_end() {
    let folder = Folder::new();
    folder.write("outside.imp", "x = 1");
    folder.write("in/circle.imp", "include \"round.imp\"");
    folder.write("in/round.imp", "x = 1\ninclude \"circle.imp\"");
    folder.write("in/itself.imp", "include \"itself.imp\"");
    folder.write("in/up.imp", "include \"../outside.imp\"");
    folder.write("in/root.imp", "include \"/etc/hostname\"");
    folder.write("in/missing.imp", "y = 2; include \"nothing.imp\"");
    folder.write("in/lost.imp", "include \"../nowhere/at_all.imp\"");
    folder.write("in/folder.imp", "include \"sub\"");
    folder.write("in/sub/back.imp", "include \"../good.imp\"");
    folder.write("in/good.imp", "R = 2; x = R");
    folder.write("in/twice.imp", "include \"good.imp\"; include \"sub/back.imp\"; include \"./sub/../good.imp\"");
    for level in 0..20 {
        folder.write(&format!("in/level{level}.imp"), format!("include \"level{}.imp\"", level + 1));
    }
    let many: String = (0..120).map(|i| format!("include \"many{i}.imp\"\n")).collect();
    folder.write("in/many.imp", many);
    (0..120).for_each(|i| folder.write(&format!("in/many{i}.imp"), "x = 1"));
    let rows = [
        ("circle", "includes itself", "in/round.imp:2:9"),
        ("itself", "includes itself", "in/itself.imp:1:9"),
        ("up", "outside the folder of the first file", "in/up.imp:1:9"),
        ("root", "outside the folder of the first file", "in/root.imp:1:9"),
        ("lost", "outside the folder of the first file", "in/lost.imp:1:9"),
        ("missing", "cannot include 'nothing.imp'", "in/missing.imp:1:16"),
        ("folder", "cannot include 'sub'", "in/folder.imp:1:9"),
        ("level0", "nested more than 16 levels", "in/level15.imp:1:9"),
        ("many", "made of more than 100 files", "in/many.imp:100:9"),
        ("sub/back", "outside the folder of the first file", "in/sub/back.imp:1:9"),
    ];
    for (name, words, place) in rows {
        let said = folder.run(&["check", &format!("in/{name}.imp")]);
        let place = place.strip_prefix("in/").unwrap();
        assert!(said.status == 1 && said.err.contains(words) && said.err.contains(place), "{name}: {}", said.err);
    }
    let said = folder.run(&["eval", "in/twice.imp", "--at", "5,0,0"]);
    assert_eq!(String::from_utf8_lossy(&said.out), "f = 3  gradient = (1, 0, 0)\n", "{}", said.err);
}
