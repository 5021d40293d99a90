//! Pictures that say how they were drawn.
//!
//! In: commands that draw. Out: what a PNG carries draws it again, to the same bytes; and what carries nothing is refused
//! in words.

use super::command::Folder;

/// Arguments with `|` between them. Everything that a statement can say, in flags, in the program, or found.
const ROWS: &[&str] = &[
    "x^2+y^2+z^2=1",
    "1-x^2-y^2-z^2=0 // f < 0 outside",
    "z = sin x cos y|--orbit|20,70",
    "x^2+y^2=1|z=0.2 { color: crimson }|--box|-1,1,-1,1,-1,1.5",
    "x^2+y^2+z^2=a^2; a = 1 in [0, 2] step 0.1|--set|a=0.7|--ball|0,0,0.25,1e1",
    "x^2+y^2+z^2=1; camera { eye: (2, -3, 1) }; z=0|--fov|25|--mode|normal",
    "camera { eye: (2, -3, 1) }; render { samples: 4, clip: x < 0.25 }; x^2+y^2+z^2=1|--look-at|0.1,0,0",
    "parts/ring.imp|x^2+y^2+z^2=0.01",
    "x^2+y^2+z^2=1|--mode|depth|--box|-4,4,-4,4,-4,4",
    "-|--mode|proof",
    "x^2+y^2+z^2 <= 1 { cap: true, color: palette(viridis, gauss*z), lines: every(0.25, z) }|--box|-2,2,-2,2,-2,0.5",
    "material m { color: checker(0.5, white, navy) }; x^2+y^2+z^2=1 { material: m }|--mode|curvature",
    "x^2+y^2+z^2=1|--exposure|-1.5|--tonemap|agx",
    "x^2+y^2+z^2=1; render { exposure: 1/3, tonemap: none, background: #123456 }",
    "x^2+y^2+z^2=1|--background|transparent|--mode|cosine",
    "x^2+y^2+z^2=1; sky { top: blue, horizon: white, ground: gray }|--background|sky|--mode|mirror",
    "x^2+y^2+z^2=1 { kind: metal, roughness: 0.3 }|--mode|path|--samples|2|--bounces|3|--seed|7|--filter|box",
    "x^2+y^2+z^2=1 { metal: gold }; render { mode: path, samples: 1, seed: 5000000000, filter: gaussian, bounces: 2 }",
];

#[test]
fn a_picture_is_drawn_again_to_the_same_bytes() {
    let folder = Folder::new();
    folder.write("parts/ring.imp", "include \"radius.imp\"\n(x^2+y^2+z^2+R^2-0.1)^2 = 4*R^2*(x^2+y^2) // a torus");
    folder.write("parts/radius.imp", "R = 1; render { mode: cosine }\n");
    for row in ROWS {
        let args: Vec<&str> = row.split('|').chain(["-s", "24x18", "-o", "first.png"]).collect();
        let said = folder.run_with(&args, "x^2+y^2 = z^2", &[]);
        assert_eq!(said.status, 0, "{row}: {}", said.err);
        let said = folder.run(&["import", "first.png"]);
        assert_eq!((said.status, said.err.as_str()), (0, ""), "{row}");
        let program = String::from_utf8(said.out).unwrap();
        assert!(
            program.contains("\ncamera { eye: (") && program.contains("\nrender { size: 24x18, mode: "),
            "{program}"
        );
        folder.write("again.imp", &program);
        let said = folder.run(&["again.imp", "-o", "second.png"]);
        assert_eq!(said.status, 0, "{program}: {}", said.err);
        assert!(folder.read("first.png") == folder.read("second.png"), "{row}:\n{program}");
    }
}

#[test]
fn options_that_no_statement_says_are_in_the_first_line() {
    let folder = Folder::new();
    let flags = ["--ortho", "2.5", "--method", "march", "--step", "0.01"];
    let args = [&["x^2+y^2+z^2=1", "-s", "24x18", "-o", "first.png"], &flags[..]].concat();
    assert_eq!(folder.run(&args).status, 0);
    let program = String::from_utf8(folder.run(&["import", "first.png"]).out).unwrap();
    assert_eq!(program.lines().next(), Some("// drawn with: --ortho 2.5 --method march --step 0.01"));
    folder.write("again.imp", &program);
    assert_eq!(folder.run(&[&["again.imp", "-o", "second.png"], &flags[..]].concat()).status, 0);
    assert!(folder.read("first.png") == folder.read("second.png"));
}

#[test]
fn files_without_a_program_are_refused_in_words() {
    let folder = Folder::new();
    assert_eq!(folder.run(&["x^2+y^2+z^2=1", "-s", "24x18", "-o", "whole.png"]).status, 0);
    assert_eq!(folder.run(&["x^2+y^2+z^2=1", "-s", "24x18", "-o", "whole.jpg"]).status, 0);
    let whole = folder.read("whole.png");
    folder.write("cut.png", &whole[..whole.len() - 20]);
    let mut flipped = whole.clone();
    let inside = whole.windows(9).position(|bytes| bytes == b"x^2+y^2+z").unwrap();
    flipped[inside] ^= 1;
    folder.write("flipped.png", &flipped);
    let mut bare = Vec::new();
    let mut encoder = png::Encoder::new(&mut bare, 1, 1);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&[1, 2, 3]).unwrap();
    writer.finish().unwrap();
    folder.write("bare.png", &bare);
    folder.write("empty.png", "");
    let rows = [
        ("cut.png", "only the beginning"),
        ("flipped.png", "damaged"),
        ("bare.png", "carries no program"),
        ("empty.png", "no PNG file"),
        ("whole.jpg", "no PNG file"),
        ("missing.png", "no such file"),
        (".", "directory"),
    ];
    for (name, words) in rows {
        let said = folder.run(&["import", name]);
        assert!(said.status == 1 && said.out.is_empty() && said.err.contains(words), "{name}: {}", said.err);
    }
    assert_eq!(folder.run(&["import"]).status, 2);
}

#[test]
fn a_note_does_nothing_to_a_terminal() {
    let folder = Folder::new();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 1, 1);
    encoder.add_itxt_chunk("implicit program".into(), "x = 1 // \u{1b}[2J\u{9b}31m\r\n".into()).unwrap();
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&[1]).unwrap();
    writer.finish().unwrap();
    folder.write("evil.png", &bytes);
    let said = folder.run(&["import", "evil.png"]);
    assert_eq!(String::from_utf8(said.out).unwrap(), "x = 1 // \u{fffd}[2J\u{fffd}31m\u{fffd}\n");
}
