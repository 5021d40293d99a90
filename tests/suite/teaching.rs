//! The commands that teach, run as a person does.
//!
//! In: `explain`, `ray`, `compare`, `lesson` on known surfaces, the lessons and their files. Out: what must be true of what they say.

use super::command::Folder;
use implicit::teach::lessons::{FOLDER, LESSONS};
use implicit::teach::texts::LANGUAGES;
use serde_json::Value;
use std::path::Path;

fn run(line: &str) -> (i32, String, String) {
    let said = Folder::new().run(&line.split('|').collect::<Vec<&str>>());
    (said.status, String::from_utf8(said.out).unwrap(), said.err)
}

fn json(line: &str) -> Value {
    let (status, out, err) = run(line);
    assert_eq!(status, 0, "{line}: {err}");
    serde_json::from_str(&out).unwrap()
}

/// Arguments with `|` between them, and what the page must say.
const PAGES: &[(&str, &[&str])] = &[
    ("explain|x^2+y^2+z^2=1", &["((x^2) + (y^2)) + (z^2) = 1", "a sphere", "f_x = 2*x", "power rule", "It is bounded"]),
    ("explain|x^2+y^2+z^2=1|--language|sl", &["sfera", "odvod potence", "Ploskev je omejena"]),
    ("explain|z = x^2 - y^2|--latex", &["\\documentclass", "\\frac{\\partial}{\\partial x}", "\\end{document}"]),
    ("explain|z = x^2 - y^2|--markdown", &["# z = x^2 - y^2", "$$ ", "hyperbolic paraboloid"]),
    ("explain|z = x^2 - y^2|--html", &["<!DOCTYPE html>", "<math ", "<svg ", "saddle"]),
    ("explain|z = x^2 - y^2|--svg", &["<svg xmlns=\"http://www.w3.org/2000/svg\""]),
    ("explain|x^2+y^2+z^2 <= 1 and z >= 0", &["It is a solid", "(x^2"]),
    ("explain|R = 2|w = x*y + R|x = 1|--of|w", &["f = x*y + 2", "f_y = x"]),
    ("explain|z=x|y=x", &["Surface 1 of 2", "Surface 2 of 2", "The surface is a plane"]),
    ("ray|x^2+y^2+z^2=1|--from|0,0,3|--direction|0,0,-2|--step|0.3", &["t = 1,", "a hit", "proven", "4 %"]),
    ("ray|x^2+y^2+z^2=1|--pixel|20,15|-s|40x30", &["a hit", "cosine"]),
    ("ray|x^2+y^2+z^2=1|--from|0,0,1|--direction|0,0,-1", &["starts on the surface", "t = 2,"]),
    (
        "ray|(x^2+y^2+z^2-1)^2|--from|0,0,3|--direction|0,0,-1|--step|0.13",
        &["was missed", "the same sign on both sides", "a hit"],
    ),
    (
        "ray|z=tan(x)|--from|-2.5,0,0|--direction|1,0,0|--step|0.11|--ball|0,0,0,3",
        &["no root but a pole", "a pole or a jump"],
    ),
    ("ray|z=x|--from|0,0,3|--direction|0,0,-1|--html", &["<svg ", "<table>"]),
];

#[test]
fn pages_say_what_is_true() {
    for (line, parts) in PAGES {
        let (status, out, err) = run(line);
        assert_eq!(status, 0, "{line}: {err}");
        for part in *parts {
            assert!(out.contains(part), "{line}: {part} is not in\n{out}");
        }
    }
}

#[test]
fn the_march_misses_what_the_faithful_method_proves() {
    let double = json("ray|(x^2+y^2+z^2-1)^2|--from|0,0,3|--direction|0,0,-1|--step|0.13|--json");
    assert_eq!((double["brackets"].as_array().unwrap().len(), double["missed"].as_array().unwrap().len()), (0, 2));
    assert!((double["tracer"]["t"].as_f64().unwrap() - 2.0).abs() < 1e-9 && double["tracer"]["proven"] == true);
    let shell = json("ray|(x^2+y^2+z^2-1)(x^2+y^2+z^2-1.002)|--from|0,0,3|--direction|0,0,-1|--step|0.3|--json");
    assert_eq!((shell["missed"].as_array().unwrap().len(), shell["roots"].as_array().unwrap().len()), (4, 4));
    let poles = json("ray|z=tan(x)|--from|-2.5,0,0|--direction|1,0,0|--step|0.11|--ball|0,0,0,3|--json");
    assert_eq!((poles["no_roots"].as_array().unwrap().len(), poles["roots"].as_array().unwrap().len()), (2, 1));
    assert!(poles["complete"] == true && poles["tracer"]["proven"] == true);
}

#[test]
fn comparing_counts_what_a_step_misses() {
    let rows = json("compare|x^2+y^2+z^2=1|--step|0.7,0.01|-s|40x30|--json");
    let missed = |k: usize| rows[k]["missed"].as_u64().unwrap();
    assert!(missed(0) == 0 && missed(1) >= 5 && missed(2) < missed(1), "{rows}");
    assert!(rows[1]["at_silhouettes"].as_u64().unwrap() <= missed(1) && rows[1]["hits"].as_u64().unwrap() > 100);
    let rows = json("compare|x^2+y^2+z^2=1|--vary|samples|-s|24x18|--json");
    assert_eq!(rows.as_array().unwrap().len(), 4);
    let rows = json("compare|x^2+y^2+z^2=1 {kind: mirror}|z=-1|--vary|bounces|-s|24x18|--json");
    let different = |row: &serde_json::Value| row["recoloured"].as_u64().unwrap();
    assert_eq!(rows.as_array().unwrap().len(), 6);
    assert!(rows[1]["value"] == 0.0 && different(&rows[1]) > 100 && different(&rows[4]) < 10, "{rows:?}");
    let rows = json("compare|x^2+y^2+z^2=1|z=0|y=0|--vary|objects|-s|24x18|--json");
    assert_eq!(
        rows.as_array().unwrap().iter().map(|row| row["value"].as_f64().unwrap()).collect::<Vec<f64>>(),
        [3.0, 1.0, 2.0]
    );
}

#[test]
fn the_sheet_is_a_picture() {
    let folder = Folder::new();
    let said = folder.run(&["compare", "x^2+y^2+z^2=1", "--step", "0.5", "-s", "24x18", "-o", "sheet.png"]);
    assert_eq!((said.status, said.err.as_str()), (0, ""));
    assert!(
        folder.read("sheet.png").starts_with(b"\x89PNG")
            && String::from_utf8(said.out).unwrap().contains("silhouettes")
    );
}

#[test]
fn every_lesson_can_be_built_in_every_language_without_other_files() {
    for (code, _) in LANGUAGES {
        let folder = Folder::new();
        let said = folder.run(&["lesson", "--html", "pages", "--language", code]);
        assert_eq!((said.status, said.err.as_str()), (0, ""), "{code}");
        for name in LESSONS.iter().map(|lesson| lesson.name).chain(["index"]) {
            let page = String::from_utf8(folder.read(&format!("pages/{name}.html"))).unwrap();
            let shown = page.replace("http://www.w3.org/", "");
            for outside in ["http:", "https:", "src=\"/", "<script", "url("] {
                assert!(!shown.contains(outside), "{code} {name}: {outside}");
            }
            for key in ["lesson.", "ray.", "rule.", "fact.", "proof.", "{0}", "{1}"] {
                assert!(!page.contains(&format!(">{key}")), "{code} {name}: {key} is shown instead of its words");
            }
        }
    }
}

#[test]
fn the_commands_of_the_lessons_run_as_they_are_typed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for lesson in &LESSONS {
        let file = root.join(FOLDER).join(format!("{}.imp", lesson.name));
        assert_eq!(std::fs::read_to_string(&file).unwrap(), lesson.program);
        for command in lesson.commands {
            let folder = Folder::new();
            folder.write(&format!("{FOLDER}/{}.imp", lesson.name), lesson.program);
            let typed = lesson.typed(command);
            let words: Vec<&str> = typed.split(' ').skip(1).collect();
            let said = folder.run(&words);
            assert_eq!(said.status, 0, "{typed}: {}", said.err);
        }
    }
}
