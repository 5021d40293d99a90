//! Pictures from the command line, judged by numbers: depths of a sphere in closed form, the same bytes however they
//! are computed, everything that is shown as an example.
//!
//! In: the program, `examples`, `README.md`. Out: passed or failed.

use super::command::{Folder, PROGRAM, exr_channel};
use std::ffi::OsStr;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The bytes of a picture of the gallery's page, at most: a page that is looked at over a slow line has twelve.
const LARGEST_PICTURE_OF_PAGE: u64 = 60 * 1024;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn scaled(a: Vector, s: f64) -> Vector {
    a.map(|c| c * s)
}

fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn normalized(a: Vector) -> Vector {
    scaled(a, 1.0 / dot(a, a).sqrt())
}

/// A camera as the reference of the command line describes it.
struct Camera {
    eye: Vector,
    look_at: Vector,
    fov: f64,
    ortho: Option<f64>,
    size: (usize, usize),
}

impl Camera {
    fn ray(&self, i: usize, j: usize) -> (Vector, Vector) {
        let f = normalized(plus(self.look_at, scaled(self.eye, -1.0)));
        let side = cross(f, [0.0, 0.0, 1.0]);
        let r = if dot(side, side).sqrt() < 1e-9 { normalized(cross(f, [0.0, 1.0, 0.0])) } else { normalized(side) };
        let u = cross(r, f);
        let (w, h) = (self.size.0 as f64, self.size.1 as f64);
        let half = self.ortho.map_or_else(|| (self.fov.to_radians() / 2.0).tan(), |height| height / 2.0);
        let sx = ((i as f64 + 0.5) / w * 2.0 - 1.0) * (w / h) * half;
        let sy = (1.0 - (j as f64 + 0.5) / h * 2.0) * half;
        let offset = plus(scaled(r, sx), scaled(u, sy));
        match self.ortho {
            Some(_) => (plus(self.eye, offset), f),
            None => (self.eye, normalized(plus(f, offset))),
        }
    }

    fn arguments(&self) -> Vec<String> {
        let triple = |v: Vector| v.map(|c| c.to_string()).join(",");
        let mut arguments = vec!["--eye".into(), triple(self.eye), "--look-at".into(), triple(self.look_at)];
        arguments.extend([
            "--fov".into(),
            self.fov.to_string(),
            "-s".into(),
            format!("{}x{}", self.size.0, self.size.1),
        ]);
        arguments.extend(self.ortho.into_iter().flat_map(|height| ["--ortho".into(), height.to_string()]));
        arguments
    }
}

/// Distance to the sphere of this radius around a centre; +∞ beside it.
fn sphere_depth((o, d): (Vector, Vector), center: Vector, radius: f64) -> f64 {
    let m = plus(center, scaled(o, -1.0));
    let b = dot(m, d);
    let q = b * b - dot(m, m) + radius * radius;
    let (near, far) = (b - q.sqrt(), b + q.sqrt());
    match () {
        () if q >= 0.0 && near > 0.0 => near,
        () if q >= 0.0 && far > 0.0 => far,
        () => f64::INFINITY,
    }
}

#[test]
fn depths_and_normals_are_those_of_the_camera_by_hand() {
    let camera = |eye, look_at, fov, ortho, size| Camera { eye, look_at, fov, ortho, size };
    let cameras = [
        camera([3.0, -4.0, 2.0], [0.5, 0.0, 0.25], 40.0, None, (24, 18)),
        camera([0.5, 0.0, 9.0], [0.5, 0.0, 0.0], 30.0, None, (17, 23)),
        camera([-5.0, 1.0, 0.25], [0.0, 0.0, 0.0], 70.0, None, (30, 10)),
        camera([0.5, 0.0, 0.25], [0.5, 5.0, 0.25], 90.0, None, (8, 8)),
        camera([0.5, -6.0, 1.0], [0.5, 0.0, 0.25], 40.0, Some(3.0), (20, 15)),
    ];
    let (center, radius) = ([0.5, 0.0, 0.25], 1.0);
    let folder = Folder::new();
    for (index, camera) in cameras.iter().enumerate() {
        let mut args = camera.arguments();
        args.extend(
            [
                "(x-0.5)^2+y^2+(z-0.25)^2=1",
                "--ball",
                "0.5,0,0.25,20",
                "--depth",
                "d.exr",
                "--normals",
                "n.exr",
                "--mode",
                "cost",
            ]
            .map(String::from),
        );
        let said = folder.run(&args);
        assert_eq!(said.status, 0, "{}", said.err);
        let depth = exr_channel(&folder.path.join("d.exr"), "Z");
        let normals = ["X", "Y", "Z"].map(|name| exr_channel(&folder.path.join("n.exr"), name));
        for j in 0..camera.size.1 {
            for i in 0..camera.size.0 {
                let at = j * camera.size.0 + i;
                let ray = camera.ray(i, j);
                let expected = sphere_depth(ray, center, radius);
                let found = f64::from(depth[at]);
                assert!(
                    found == expected || (found - expected).abs() < 1e-6 * expected,
                    "{index} {i} {j}: {found} {expected}"
                );
                let normal = [0, 1, 2].map(|c| f64::from(normals[c][at]));
                if expected.is_finite() {
                    let point = plus(ray.0, scaled(ray.1, expected));
                    let outward = scaled(plus(point, scaled(center, -1.0)), 1.0 / radius);
                    let turned = scaled(outward, -dot(outward, ray.1).signum());
                    assert!(dot(normal, turned) > 1.0 - 1e-5, "{index} {i} {j}: {normal:?} {turned:?}");
                } else {
                    assert!(normal.iter().all(|c| c.is_nan()));
                }
            }
        }
    }
}

#[test]
fn orbits_and_regions_mean_what_they_say() {
    let folder = Folder::new();
    let depth = |args: &[&str]| {
        let all = [&["-s", "9x9", "--depth", "d.exr", "--quiet"], args].concat();
        let said = folder.run(&all);
        assert_eq!(said.status, 0, "{args:?}: {}", said.err);
        f64::from(exr_channel(&folder.path.join("d.exr"), "Z")[40])
    };
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-5 * expected, "{found} {expected}");
    let sphere = "x^2+y^2+z^2=1";
    near(depth(&[sphere, "--orbit", "-30,20,5"]), 4.0);
    near(depth(&[sphere, "--orbit", "0,90,7", "--ball", "0,0,0,2"]), 6.0);
    // The region's middle is looked at, and what is outside of it is not there.
    near(depth(&["x=0", "--box", "-1,1,4,6,-1,1", "--eye", "3,5,0"]), 3.0);
    near(depth(&[sphere, "--eye", "0,-5,0", "--look-at", "0,0,0", "--box", "-2,2,0,2,-2,2"]), 6.0);
    assert!(depth(&["x=0", "--eye", "3,5,0", "--look-at", "0,5,0", "--ball", "0,0,0,1"]).is_infinite());
    // Flags win over the program; the program's region holds where there is no flag.
    let program = "render { clip: ball(0,0,0,2) }; camera { eye: (0,-5,0), look_at: (0,0,0) }";
    near(depth(&[program, sphere]), 4.0);
    near(depth(&[program, sphere, "--eye", "0,-9,0"]), 8.0);
    near(depth(&[program, "y=-3", "z=1+y/9", "--box", "-4,4,-4,4,-4,4"]), 2.0);
    // A surface's own region meets the one of all.
    near(depth(&["x^2+y^2+z^2=1 { clip: box(-2..2, 0..2, -2..2) }", "--ball", "0,0,0,3", "--orbit", "-90,0,5"]), 6.0);
}

#[test]
fn the_same_program_gives_the_same_bytes_on_any_number_of_threads_and_any_instructions() {
    let folder = Folder::new();
    let rows: [&[&str]; 5] = [
        &["sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)=0", "--ball", "0,0,0,4"],
        &["x^2+y^2+z^2=1", "z=0.3*exp(-x^2)", "--mode", "mirror"],
        &["(x^2+y^2+z^2+0.84)^2=4(x^2+y^2)", "--mode", "cosine"],
        &["x^2+y^2<=1 and |z|<=1 and not x^2+z^2<=0.3", "--mode", "proof"],
        &["z=tan(x)", "--mode", "normal", "--samples", "16", "--method", "march"],
    ];
    for program in rows {
        let run = |threads: &str, simd: &str| {
            let args = [
                program,
                &["-s", "40x36", "--threads", threads, "-o", "a.png", "--depth", "d.exr", "--normals", "n.exr"],
            ]
            .concat();
            let said = folder.run_with(&args, "", &[("IMPLICIT_SIMD", simd)]);
            assert_eq!(said.status, 0, "{program:?}: {}", said.err);
            ["a.png", "d.exr", "n.exr"].map(|name| folder.read(name))
        };
        let one = run("1", "on");
        for (threads, simd) in [("2", "on"), ("3", "on"), ("2", "off")] {
            assert!(run(threads, simd) == one, "{program:?} with {threads} threads, SIMD {simd}");
        }
    }
}

#[test]
fn every_formula_file_draws() {
    let folder = Folder::new();
    let gallery = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/gallery");
    let mut files: Vec<_> = fs::read_dir(gallery).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let files: Vec<_> = files.into_iter().filter(|file| file.extension().is_some_and(|e| e == "imp")).collect();
    assert!(files.len() >= 10);
    for file in files {
        let options = ["-s", "32x32", "--samples", "2", "-o", "a.png", "--stats-json", "s.json"].map(OsStr::new);
        let said = folder.run(&[&[file.as_os_str()][..], &options].concat());
        assert_eq!(said.status, 0, "{}: {}", file.display(), said.err);
        assert!(!said.err.contains("warning"), "{}: {}", file.display(), said.err);
        let stats: serde_json::Value = serde_json::from_slice(&folder.read("s.json")).unwrap();
        assert!(stats["misses"].as_u64().unwrap() < 32 * 32 * 9 / 10, "{} shows next to nothing", file.display());
    }
}

#[test]
fn the_page_of_the_gallery_shows_every_scene_with_its_program_as_it_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(root.join("docs/gallery.md")).unwrap();
    let scenes: Vec<&str> = page.split("\n## ").skip(1).collect();
    assert_eq!(scenes.len(), 12);
    for scene in scenes {
        let between = |before: &str, after: &str| {
            let (_, rest) = scene.split_once(before).unwrap_or_else(|| panic!("no {before} in {scene}"));
            rest.split_once(after).unwrap_or_else(|| panic!("no {after} in {scene}")).0
        };
        let name = between("implicit examples/gallery/", ".imp");
        let program = fs::read_to_string(root.join(format!("examples/gallery/{name}.imp"))).unwrap();
        assert_eq!(between("```implicit\n", "```"), program, "{name}");
        let picture = fs::metadata(root.join("docs").join(between("](", ")"))).unwrap();
        assert!(
            between("](", ")").contains(name) && picture.len() <= LARGEST_PICTURE_OF_PAGE,
            "{name}: {}",
            picture.len()
        );
    }
}

#[test]
fn the_library_examples_run() {
    let folder = Folder::new();
    let built = Path::new(PROGRAM).parent().unwrap().join("examples");
    let run = |name: &str, args: &[&str]| {
        let output = Command::new(built.join(name)).args(args).current_dir(&folder.path).output();
        let output = output.unwrap_or_else(|error| panic!("{name}: {error}; `cargo test` builds the examples first"));
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    run("hello", &["x^2+y^2+z^2=1", "s.png"]);
    assert!(folder.read("s.png").starts_with(b"\x89PNG"));
    assert!(run("probe", &[]).contains('#'));
    assert!(run("derive", &["z = x*sin(y)"]).contains(r"\sin"));
}

#[test]
fn the_commands_of_the_documents_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (document, least) in [("README.md", 15), ("docs/tasks.md", 12), ("docs/gallery.md", 12)] {
        let folder = Folder::new();
        let text = fs::read_to_string(root.join(document)).unwrap();
        let mut count = 0;
        for line in text.lines().map(str::trim) {
            let Some(rest) = line.strip_prefix("cargo run --release -- ").or(line.strip_prefix("implicit ")) else {
                continue;
            };
            // `# 1: words` behind a command: it ends with this status and says so.
            let (rest, status, words) = match rest.split_once(" # 1: ") {
                Some((rest, words)) => (rest, 1, words),
                None => (rest, 0, ""),
            };
            let rest = rest.replace("examples/", &format!("{}/examples/", root.display()));
            let small = if rest.contains("-o ") && !rest.contains("--size") { "-s 32x24" } else { "" };
            let few = if document == "docs/gallery.md" { "--samples 2" } else { "" };
            let output = Command::new("sh")
                .args(["-c", &format!("'{PROGRAM}' {rest} {small} {few}")])
                .current_dir(&folder.path)
                .output()
                .unwrap();
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.code() == Some(status) && said.contains(words), "{document}: {line}: {said}");
            count += 1;
        }
        assert!(count >= least, "{document} shows commands");
    }
}
