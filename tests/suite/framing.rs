//! What is seen when nobody says where to look, against balls worked out by hand, and whether it fills the picture.
//!
//! In: the program, `tests/data/framing.tsv`. Out: passed or failed.

use super::command::{Folder, exr_channel};

/// Pixels across and down.
const SIZE: (usize, usize) = (80, 60);

struct Row<'a> {
    kind: &'a str,
    surfaces: Vec<&'a str>,
    center: [f64; 3],
    radius: f64,
}

fn rows() -> Vec<Row<'static>> {
    let table = include_str!("../data/framing.tsv");
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    let rows = lines.map(|line| {
        let cells: Vec<&str> = line.split('\t').collect();
        let number = |k: usize| cells[k].parse().unwrap();
        Row {
            kind: cells[0],
            surfaces: cells[1].split(';').collect(),
            center: [number(2), number(3), number(4)],
            radius: number(5),
        }
    });
    rows.collect()
}

/// The ball that is printed, and which pixels show surface.
fn framed(folder: &Folder, surfaces: &[&str]) -> (Vec<f64>, Vec<bool>) {
    let size = format!("{}x{}", SIZE.0, SIZE.1);
    let options = ["-s", &size, "--depth", "d.exr", "--mode", "depth", "--stats-json", "s.json", "--quiet"];
    let said = folder.run(&[surfaces, &options].concat());
    assert_eq!(said.status, 0, "{surfaces:?}: {}", said.err);
    let stats: serde_json::Value = serde_json::from_slice(&folder.read("s.json")).unwrap();
    let ball = stats["region"][0]["ball"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
    (ball, exr_channel(&folder.path.join("d.exr"), "Z").iter().map(|depth| depth.is_finite()).collect())
}

#[test]
fn what_there_is_to_see_is_framed_as_a_person_would() {
    let folder = Folder::new();
    for Row { kind, surfaces, center, radius } in rows() {
        let (ball, _) = framed(&folder, &surfaces);
        let (least, most, aside) = match kind {
            "all" => (radius, 1.1 * radius, 0.02 * radius),
            "point" => (radius, radius, 1e-9),
            // The nearest point is found to a 256th of its distance, and put on a grid.
            _ => (radius, radius, 0.08 + center.iter().map(|c| c.abs()).fold(0.0, f64::max) / 200.0),
        };
        assert!(ball[3] >= least && ball[3] <= most, "{surfaces:?}: {ball:?}");
        assert!((0..3).all(|c| (ball[c] - center[c]).abs() <= aside), "{surfaces:?}: {ball:?}");
    }
}

#[test]
fn what_is_framed_fills_the_picture_and_is_whole() {
    let folder = Folder::new();
    for Row { surfaces, .. } in rows().into_iter().filter(|row| row.kind != "point") {
        let (_, seen) = framed(&folder, &surfaces);
        let columns: Vec<usize> = (0..SIZE.0).filter(|&i| (0..SIZE.1).any(|j| seen[j * SIZE.0 + i])).collect();
        let lines: Vec<usize> = (0..SIZE.1).filter(|&j| (0..SIZE.0).any(|i| seen[j * SIZE.0 + i])).collect();
        let (left, right) = (columns[0], SIZE.0 - 1 - columns[columns.len() - 1]);
        let (top, bottom) = (lines[0], SIZE.1 - 1 - lines[lines.len() - 1]);
        assert!(left.min(right).min(top).min(bottom) > 0, "{surfaces:?} is cut off: {left} {right} {top} {bottom}");
        let filled = (1.0 - (left + right) as f64 / SIZE.0 as f64).max(1.0 - (top + bottom) as f64 / SIZE.1 as f64);
        assert!(filled > 0.7, "{surfaces:?} fills {filled}");
    }
}

#[test]
fn a_given_target_stays_in_the_middle() {
    let folder = Folder::new();
    for view in [["--orbit", "30,20"], ["--look-at", "0,0,0"], ["--box", "-2,2,-2,2,-2,2"]] {
        let args = [&["x^2+y^2+z^2=1", "-s", "61x41", "--depth", "d.exr"][..], &view].concat();
        assert_eq!(folder.run(&args).status, 0);
        let depth = exr_channel(&folder.path.join("d.exr"), "Z");
        let middle = depth[20 * 61 + 30];
        // The sphere's nearest point is on the ray through the middle, and it is as far to the left as to the right.
        assert!(depth.iter().all(|&d| d >= middle), "{view:?}");
        let row = &depth[20 * 61..21 * 61];
        assert_eq!(row.iter().position(|d| d.is_finite()), row.iter().rev().position(|d| d.is_finite()), "{view:?}");
    }
}
