//! What keeps the house tidy: which module may know which, what stays in its room, and what no file goes without.
//!
//! In: the sources. Out: a failed test that names file, line and rule. The plan it keeps is in ARCHITECTURE.md.

use super::tidy_scan::{code_only, heads, without_tests, words};
use std::fs;
use std::path::{Path, PathBuf};

/// The stages, ground first; a module uses only modules before it.
const ORDER: [&str; 12] =
    ["num", "diag", "syntax", "expr", "closure", "surface", "scene", "film", "render", "teach", "session", "cli"];

/// Modules that stand beside each other on the ground: neither knows the other.
const STRANGERS: [(&str, &str); 1] = [("diag", "num")];

/// Crates that only some modules may name; `main` is `main.rs`.
const ROOMS: [(&str, &[&str]); 15] = [
    ("nom", &["syntax"]),
    ("clap", &["cli", "main"]),
    ("clap_complete", &["cli"]),
    ("clap_mangen", &["cli"]),
    ("image", &["film"]),
    ("png", &["film"]),
    ("exr", &["film"]),
    ("annotate_snippets", &["diag"]),
    ("colorous", &["scene"]),
    ("rayon", &["surface", "render"]),
    ("indicatif", &["cli"]),
    ("tempfile", &["cli"]),
    ("signal_hook", &["cli", "main"]),
    ("rustix", &["cli"]),
    ("serde_json", &["cli"]),
];

/// The world outside the program: only `cli` and `main.rs` touch it.
const OUTSIDE: [&str; 17] = [
    "println!",
    "eprintln!",
    "print!",
    "eprint!",
    "process::exit",
    "process::abort",
    "std::env",
    "env::var",
    "std::fs",
    "fs::read",
    "fs::write",
    "File::open",
    "File::create",
    "Instant",
    "SystemTime",
    "io::stdin",
    "io::stdout",
];

/// Methods of f64 that call the system's mathematics library, or whose last bits the language leaves open.
const SYSTEM_MATHEMATICS: [&str; 27] = [
    "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "sin_cos",
    "exp", "exp2", "exp_m1", "ln", "ln_1p", "log", "log2", "log10", "powf", "powi", "cbrt", "hypot", "mul_add",
];

/// The one file with an unsafe call.
const LEVELS: &str = "src/num/level.rs";

/// The files that may ask std for a·b + c: they are what the rest calls.
const FUSED: [&str; 2] = [LEVELS, "src/num/fused.rs"];

/// Intervals have methods of their own with these names; there clippy, which sees types, keeps watch alone.
const INTERVALS: &str = "src/num/interval";

/// Everything wrong with one file, as `path:line: what`.
fn faults(path: &str, text: &str, is_test: bool) -> Vec<String> {
    let code = without_tests(&code_only(text));
    let room = room(path);
    let mut found = Vec::new();
    if !text.starts_with("//!") {
        found.push((0, "no //! header".to_string()));
    }
    if !is_test {
        arrows(path, &code, &mut found);
        outside(room, &code, &mut found);
        system_mathematics(path, &code, &mut found);
    }
    foreign(room, &code, &mut found);
    if path != LEVELS {
        found.extend(words(&code, "unsafe").map(|at| (at, "unsafe".to_string())));
    }
    found.sort();
    found.into_iter().map(|(at, what)| format!("{path}:{}: {what}", text[..at].matches('\n').count() + 1)).collect()
}

/// `src/num/lanes.rs` → `num`, `src/session.rs` → `session`.
fn room(path: &str) -> &str {
    let inside = path.strip_prefix("src/").unwrap_or(path);
    inside.split(['/', '.']).next().unwrap_or(inside)
}

/// The files of the modules that a file declares for tests alone.
fn test_modules(path: &str, text: &str) -> Vec<String> {
    let code = code_only(text);
    let folder = match path.strip_suffix("/mod.rs").or(path.strip_suffix("/lib.rs")) {
        Some(folder) => folder,
        None => path.trim_end_matches(".rs"),
    };
    let declared = code.match_indices("#[cfg(test)]").filter_map(|(at, mark)| {
        let item = code[at + mark.len()..].split_once(';')?.0.trim();
        let name = item.rsplit_once("mod ")?.1.trim();
        name.chars().all(|c| c.is_alphanumeric() || c == '_').then_some(name)
    });
    declared.flat_map(|name| [format!("{folder}/{name}.rs"), format!("{folder}/{name}/mod.rs")]).collect()
}

/// How many folders below the crate's root a file's module is.
fn depth(path: &str) -> usize {
    path.matches('/').count() - usize::from(path.ends_with("/mod.rs"))
}

fn arrows(path: &str, code: &str, found: &mut Vec<(usize, String)>) {
    let (room, climb) = (room(path), "super::".repeat(depth(path)));
    let Some(place) = ORDER.iter().position(|&module| module == room) else { return };
    for prefix in ["crate::", "implicit::", climb.as_str()] {
        for at in words_before_path(code, prefix) {
            for head in heads(code[at + prefix.len()..].trim_start()) {
                let down = ORDER.iter().position(|&module| module == head).is_some_and(|other| other > place);
                if down || STRANGERS.contains(&(room, head)) {
                    found.push((at, format!("{room} must not know {head}")));
                }
            }
        }
    }
}

/// Where a prefix starts a path, rather than goes on with one.
fn words_before_path<'a>(code: &'a str, prefix: &'a str) -> impl Iterator<Item = usize> + 'a {
    code.match_indices(prefix).map(|(at, _)| at).filter(|&at| starts_path(code, at))
}

fn starts_path(code: &str, at: usize) -> bool {
    let before = &code[..at];
    !before.ends_with(|c: char| c.is_alphanumeric() || c == '_') && !before.trim_end().ends_with("::")
}

fn foreign(room: &str, code: &str, found: &mut Vec<(usize, String)>) {
    for (name, rooms) in ROOMS {
        if rooms.contains(&room) {
            continue;
        }
        for at in words(code, name).filter(|&at| starts_path(code, at) || code[..at].ends_with("(::")) {
            let used = code[at + name.len()..].starts_with("::") && !is_imported(code, name);
            let named = code[..at].trim_end().ends_with("use") && !code[..at].ends_with("::");
            if used || named {
                found.push((at, format!("{name} outside {}", rooms.join(", "))));
            }
        }
    }
}

/// Whether a module of ours with this name is imported, so that paths start with it.
fn is_imported(code: &str, name: &str) -> bool {
    let imports = code.split("use ").skip(1).filter_map(|rest| rest.split_once(';')).map(|(import, _)| import);
    let mut ours = imports.filter(|import| import.starts_with("crate::") || import.starts_with("super::"));
    ours.any(|import| words(import, name).next().is_some())
}

fn outside(room: &str, code: &str, found: &mut Vec<(usize, String)>) {
    if matches!(room, "cli" | "main") {
        return;
    }
    for name in OUTSIDE {
        for at in words(code, name.trim_end_matches('!')) {
            if code[at..].starts_with(name) {
                found.push((at, format!("{name} outside cli")));
            }
        }
    }
}

fn system_mathematics(path: &str, code: &str, found: &mut Vec<(usize, String)>) {
    for name in SYSTEM_MATHEMATICS {
        if name == "mul_add" && FUSED.contains(&path) {
            continue;
        }
        for at in words(code, name) {
            let before = &code[..at];
            let called = before.trim_end().ends_with('.') && code[at + name.len()..].starts_with('(');
            let method = called && !path.starts_with(INTERVALS);
            if method || before.ends_with("f64::") || before.ends_with("f32::") {
                found.push((at, format!("{name} of std: use num::func")));
            }
        }
    }
}

/// All Rust files below a folder, by name.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    let mut found = Vec::new();
    for path in entries {
        // What cargo has generated for a crate of its own is not ours.
        if path.is_dir() && !path.ends_with("target") {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
    found
}

#[test]
fn the_sources_are_tidy() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = sources(&root.join("src"));
    assert!(files.len() > 20, "only {} files found", files.len());
    let read = |file: &PathBuf| {
        let path = file.strip_prefix(root).unwrap().to_str().unwrap().replace('\\', "/");
        (path, fs::read_to_string(file).unwrap())
    };
    let texts: Vec<(String, String)> = files.iter().map(read).collect();
    let tests: Vec<String> = texts.iter().flat_map(|(path, text)| test_modules(path, text)).collect();
    let found: Vec<String> = texts.iter().flat_map(|(path, text)| faults(path, text, tests.contains(path))).collect();
    assert!(found.is_empty(), "\n{}", found.join("\n"));
}

#[test]
fn every_module_has_its_place_in_the_order() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for entry in fs::read_dir(root).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let module = name.trim_end_matches(".rs");
        assert!(matches!(module, "lib" | "main") || ORDER.contains(&module), "{module} is not in the order");
    }
}

#[test]
fn tests_and_benches_have_headers() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for folder in ["tests", "benches", "examples"].map(|name| root.join(name)).iter().filter(|path| path.exists()) {
        for file in sources(folder) {
            assert!(fs::read_to_string(&file).unwrap().starts_with("//!"), "no header: {}", file.display());
        }
    }
}

#[test]
fn every_dependency_comes_from_the_registry() {
    let lock = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.lock")).unwrap();
    for line in lock.lines().filter(|line| line.starts_with("source = ")) {
        assert_eq!(line, r#"source = "registry+https://github.com/rust-lang/crates.io-index""#);
    }
}

/// One planted fault of each kind, and what the rules say to it; an empty answer means tidy.
const PLANTED: [(&str, &str, &str); 36] = [
    ("src/num/interval/pieces.rs", "let a = self.tan(); f64::tan(a);", "tan of std: use num::func"),
    ("src/expr/op.rs", "use crate::closure::Tape;", "expr must not know closure"),
    ("src/expr/op.rs", "use crate::{num::a, surface::Hit};", "expr must not know surface"),
    ("src/expr/op.rs", "fn f() { crate::cli::run(); }", "expr must not know cli"),
    ("src/expr/op.rs", "use super::super::film::Film;", "expr must not know film"),
    ("src/expr/mod.rs", "use super::film::Film;", "expr must not know film"),
    ("src/session.rs", "use super::cli::Args;", "session must not know cli"),
    ("src/num/mod.rs", "use crate::diag::Span;", "num must not know diag"),
    ("src/diag/mod.rs", "use crate::num::Interval;", "diag must not know num"),
    ("src/expr/op.rs", "use crate::num::x; use super::film::y; use crate::diag::z;", ""),
    ("src/expr/op.rs", "// crate::cli::run\nconst S: &str = \"crate::cli::run\";", ""),
    ("src/expr/op.rs", "#[cfg(test)]\nmod tests { use crate::cli::x; }", ""),
    ("src/expr/op.rs", "use nom::IResult;", "nom outside syntax"),
    ("src/scene/mod.rs", "fn f(a: clap::ArgMatches) {}", "clap outside cli, main"),
    ("src/render/mod.rs", "use image;", "image outside film"),
    ("src/render/mod.rs", "use exr::prelude::*;", "exr outside film"),
    ("src/cli/mod.rs", "use annotate_snippets::Level;", "annotate_snippets outside diag"),
    ("src/expr/mod.rs", "use rayon::prelude::*;", "rayon outside surface, render"),
    ("src/session.rs", "let f = tempfile::tempfile();", "tempfile outside cli"),
    ("src/session.rs", "use crate::film::png::write; film::image::save();", ""),
    ("src/cli/mod.rs", "use crate::film::{exr, png}; png::encode();", ""),
    ("src/cli/mod.rs", "use crate::film::{exr, png}; use image::A;", "image outside film"),
    ("src/render/tile.rs", "unsafe { f() }", "unsafe"),
    ("src/num/level.rs", "unsafe { f() }", ""),
    ("src/render/tile.rs", "#![deny(unsafe_code)]", ""),
    ("src/render/tile.rs", "println!();", "println! outside cli"),
    ("src/session.rs", "std::process::exit(1);", "process::exit outside cli"),
    ("src/session.rs", "let t = Instant::now();", "Instant outside cli"),
    ("src/session.rs", "let t = std::env::var(a);", "std::env outside cli|env::var outside cli"),
    ("src/session.rs", "let t = env!(a); writeln!(f, a);", ""),
    ("src/cli/mod.rs", "println!(); std::fs::read(a);", ""),
    ("src/scene/camera.rs", "let a = b.sin();", "sin of std: use num::func"),
    ("src/scene/camera.rs", "let a = b\n    .powf(2.0);", "powf of std: use num::func"),
    ("src/scene/camera.rs", "let a = c.map(f64::exp);", "exp of std: use num::func"),
    ("src/scene/camera.rs", "let a = func::sin(b) + x.sqrt() + T::sin(a) + s.sin;", ""),
    ("src/num/lanes.rs", "let a = b.mul_add(c, d);", "mul_add of std: use num::func"),
];

#[test]
fn planted_faults_are_found_and_nothing_else() {
    for (path, line, expect) in PLANTED {
        let said = faults(path, &format!("//! Header.\n{line}\n"), false);
        let said: Vec<&str> = said.iter().map(|fault| fault.split_once(": ").unwrap().1).collect();
        assert_eq!(said.join("|"), expect, "{path}: {line}");
    }
    assert_eq!(faults("src/num/a.rs", "/// Not a header.\n", true), ["src/num/a.rs:1: no //! header"]);
    assert_eq!(faults("src/render/a.rs", "//! Header.\n\nunsafe {}", true), ["src/render/a.rs:3: unsafe"]);
}

#[test]
fn modules_for_tests_alone_are_known() {
    let text = "#[cfg(test)]\nmod tests;\n#[cfg(test)] pub(crate) mod a;\n#[cfg(test)]\nmod b { x; }\nmod c;";
    let expect = ["src/expr/tests.rs", "src/expr/tests/mod.rs", "src/expr/a.rs", "src/expr/a/mod.rs"];
    assert_eq!(test_modules("src/expr/mod.rs", text), expect);
    assert_eq!(test_modules("src/expr.rs", text), expect);
    assert!(faults("src/expr/tests.rs", "//! Header.\nuse crate::cli::x; a.sin();", true).is_empty());
}
