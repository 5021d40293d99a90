//! The language as a person meets it: through the program, from check to a picture.
//!
//! In: programs, in arguments, files and on standard input. Out: passed or failed. Apart from the tests of the
//! parser and of lowering because what is judged here is what a command does with the whole.

use crate::command::{Folder, Said};
use glam::DVec3;
use implicit::closure::Formula;
use implicit::diag::Severity;
use implicit::num::interval::{Defined, Interval};
use implicit::num::level::Simd;
use implicit::session::Program;
use serde_json::Value;

/// A tiny picture with its statistics.
const TINY: [&str; 7] = ["--size", "12x9", "--samples", "1", "--stats-json", "s.json", "--quiet"];

fn drawn(folder: &Folder, program: &str, more: &[&str]) -> (Said, Value) {
    let args: Vec<&str> = TINY.iter().chain(more).copied().chain(["-o", "p.png", "--", program]).collect();
    let said = folder.run(&args);
    let statistics = if said.status == 0 { folder.read("s.json") } else { b"null".to_vec() };
    (said, serde_json::from_slice(&statistics).unwrap())
}

#[test]
fn a_region_draws_only_where_it_changes_sign() {
    let everywhere_or_nowhere = [
        "(x^2+y^2+z^2-1)^2 >= 0",
        "(x^2+y^2+z^2-1)^2 <= 0",
        "x<=0 or x>=0",
        "x<0 and x>0",
        "not (x<=0 or x>=0)",
        "x^2+y^2+z^2<=1 or x^2+y^2+z^2>=1",
        "x^2+y^2+z^2<=1 and x^2+y^2+z^2>=1",
        "difference(x^2+y^2+z^2<=1, x^2+y^2+z^2<=1)",
        "smooth_union(0.2, x<=0, x>=0)",
        "|x| >= 0",
        "A = x^2+y^2+z^2 <= 1; A or not A",
        "A = x^2+y^2+z^2 <= 1; A and not A",
        "1 <= x^2+y^2+z^2 <= 1",
    ];
    let folder = Folder::new();
    for program in everywhere_or_nowhere {
        let (said, s) = drawn(&folder, program, &["--ball", "0,0,0,1.5"]);
        assert_eq!(said.status, 0, "{program}: {}", said.err);
        assert_eq!((&s["hits"], &s["touch"], &s["undecided"]), (&0.into(), &0.into(), &0.into()), "{program}");
    }
    for program in ["x^2+y^2+z^2<=1", "x^2+y^2+z^2 >= 1", "union(x^2+y^2+z^2<=1, x^2+y^2+z^2<=1)"] {
        let (_, s) = drawn(&folder, program, &["--ball", "0,0,0,1.5"]);
        assert!(s["hits"].as_u64().unwrap() > 20, "{program}: {s}");
        assert_eq!(s["undecided"], 0, "{program}");
    }
}

/// A program with blocks, and the flags that say the same.
#[test]
fn blocks_say_what_flags_say_and_a_flag_wins() {
    let sphere = "x^2+y^2+z^2 = 1";
    let rows: [(&str, &[&str]); 8] = [
        ("camera { eye: (3,-2,1) }", &["--eye", "3,-2,1"]),
        ("camera { eye: (3,-2,1), look_at: (0,0,1/2) }", &["--eye", "3,-2,1", "--look-at", "0,0,0.5"]),
        ("d = 2; camera { eye: (d,d,d), fov: 20*d }", &["--eye", "2,2,2", "--fov", "40"]),
        ("camera { fov: 70 }", &["--fov", "70"]),
        ("render { size: 20x10 }", &["--size", "20x10"]),
        ("render { mode: normal, samples: 4 }", &["--mode", "normal", "--samples", "4"]),
        ("render { clip: box(-1..1, -1..1, 0..2) }", &["--box=-1,1,-1,1,0,2"]),
        ("render { clip: ball(0,0,1,1.5) }", &["--ball", "0,0,1,1.5"]),
    ];
    let folder = Folder::new();
    let picture = |program: &str, flags: &[&str]| {
        let args: Vec<&str> = ["-o", "p.webp", "--quiet"].iter().chain(flags).copied().chain(["--", program]).collect();
        let said = folder.run(&args);
        assert_eq!(said.status, 0, "{program} {flags:?}: {}", said.err);
        folder.read("p.webp")
    };
    let size = |flags: &[&'static str]| if flags.contains(&"--size") { vec![] } else { vec!["--size", "16x12"] };
    for (block, flags) in rows {
        let plain: Vec<&str> = size(flags);
        let with_flags: Vec<&str> = plain.iter().chain(flags).copied().collect();
        let program = format!("{sphere}; {block}");
        let by_block = picture(&program, &plain);
        assert!(by_block == picture(sphere, &with_flags), "{block} is not {flags:?}");
        assert!(by_block != picture(sphere, &["--size", "16x12"]), "{block} changes nothing");
        let other = ["--eye", "5,1,1", "--look-at", "0,0,0", "--fov", "33", "--size", "18x9", "--mode", "depth"];
        let other: Vec<&str> = other.into_iter().chain(["--samples", "1", "--ball", "0,0,0,1.2"]).collect();
        assert!(picture(&program, &other) == picture(sphere, &other), "a flag does not win over {block}");
    }
}

#[test]
fn a_mode_of_the_program_that_is_unknown_is_refused_in_its_place() {
    let folder = Folder::new();
    for (mode, words) in [("nonsense", "there is no mode"), ("radiosity", "there is no mode 'radiosity'")] {
        let said = folder.run(&["-o", "p.webp", &format!("z = x*y; render {{ mode: {mode} }}")]);
        assert!(said.status == 1 && said.err.contains(words) && said.err.contains("<argument 1>:1:25"), "{said:?}");
    }
}

#[test]
fn words_of_attributes_are_names_elsewhere() {
    let folder = Folder::new();
    let rows = [
        ("ball = x^2+y^2+z^2 <= 1; ball and x > 0 { clip: ball(0,0,0,3) }", "2,0,0", "f = 3 "),
        ("ball = ball(0,0,0,2) and x > 0; ball", "1,0,0", "f = -1 "),
        ("box = 3; rgb = 2; x = box*rgb { color: rgb(1,0,0) }", "0,0,0", "f = -6 "),
        ("light = 2; sun = 3; sky = 4; camera = 5; render = 6; material = 7; x = light*sun*sky", "0,0,0", "f = -24 "),
        ("color = 2; clip = 3; name = 4; include = 1; x = color*clip*name*include", "0,0,0", "f = -24 "),
    ];
    for (program, at, answer) in rows {
        let said = folder.run(&["eval", "--at", at, "--", program]);
        let out = String::from_utf8(said.out).unwrap();
        assert!(out.starts_with(answer), "{program}: {out}{}", said.err);
    }
}

/// Some forty operations, each good to a few units in the last place.
const TOLERANCE: f64 = 1e-12;

#[test]
fn closures_give_the_values_of_the_table_and_enclosures_hold_them() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/language-values.tsv");
    let table = std::fs::read_to_string(path).unwrap();
    let (mut rows, mut wrong) = (0, Vec::new());
    for line in table.lines().filter(|line| !line.starts_with('#')) {
        let [text, point, expected] = line.split('\t').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let point: Vec<f64> = point.split(' ').map(|number| number.parse().unwrap()).collect();
        let expected: f64 = expected.parse().unwrap();
        let mut program = Program::from_text(text);
        let f = program.lowered.surfaces[0].f;
        let formula = Formula::new(&mut program.lowered.graph, f, Simd::best());
        let found = formula.value(DVec3::from_slice(&point));
        let over = formula.enclosure([0, 1, 2].map(|k| Interval::point(point[k])));
        let near = (found - expected).abs() <= TOLERANCE * expected.abs().max(1.0);
        let slack = expected.abs() * f64::EPSILON;
        let holds = over.range.lo <= expected + slack && expected - slack <= over.range.hi;
        let nothing = found.is_nan() && expected.is_nan() && over.defined != Defined::Everywhere;
        rows += 1;
        if !(near && holds || nothing) {
            wrong.push(format!("{text} at {point:?}: {expected}, found {found} in {over:?}"));
        }
    }
    assert!(rows >= 700, "{rows} rows");
    assert!(wrong.is_empty(), "{} of {rows}:\n{}", wrong.len(), wrong.join("\n"));
}

/// What is said about a program: texts of its notes, or those of its errors.
fn said(program: &Program, severity: Severity) -> Vec<String> {
    program.diagnostics.iter().filter(|d| d.severity == severity).map(|d| d.message.clone()).collect()
}

#[test]
fn notes_are_those_of_the_table() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/language-notes.tsv");
    let table = std::fs::read_to_string(path).unwrap();
    let (mut rows, mut wrong) = (0, Vec::new());
    for line in table.lines().filter(|line| !line.starts_with('#')) {
        let (text, expected) = line.split_once('\t').unwrap();
        let expected: Vec<&str> = expected.split(" & ").filter(|note| *note != "none").collect();
        let program = Program::from_text(text);
        let (notes, errors) = (said(&program, Severity::Note), said(&program, Severity::Error));
        rows += 1;
        if notes != expected || !errors.is_empty() {
            wrong.push(format!("{text}\n    expected {expected:?}\n    found    {notes:?} {errors:?}"));
        }
    }
    assert!(rows >= 60, "{rows} rows");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn strict_makes_errors_of_notes_and_quiet_drops_them() {
    let folder = Folder::new();
    for command in ["check", "eval", "render"] {
        let run = |flags: &[&str]| {
            let place: &[&str] = match command {
                "check" => &["check"],
                "eval" => &["eval", "--at", "1,1,1"],
                _ => &["--size", "4x3", "-o", "p.png", "--ball", "0,0,0,9"],
            };
            let args: Vec<&str> = place.iter().chain(flags).copied().chain(["z = 1/2x"]).collect();
            folder.run(&args)
        };
        let (plain, quiet, strict) = (run(&[]), run(&["--quiet"]), run(&["--strict"]));
        assert!(plain.status == 0 && plain.err.contains("note: read as (1/2)*x; write 1/(2x)"), "{plain:?}");
        assert!(quiet.status == 0 && quiet.err.is_empty(), "{quiet:?}");
        assert!(strict.status == 1 && strict.err.contains("error: read as (1/2)*x"), "{strict:?}");
        assert!(strict.err.contains("--> <argument 1>:1:5"), "{strict:?}");
        assert_eq!(run(&["--strict", "--quiet"]).status, 1);
    }
}
