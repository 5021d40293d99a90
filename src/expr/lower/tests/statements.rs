//! What programs say beside their formulas: kinds, attributes, blocks, parameters, notes.

use super::evaluate::value_at;
use super::{errors, lowered, lowered_with};
use crate::expr::lower::{Clip, ClipShape, Color, Kind, Paint, Value};

#[test]
fn surfaces_are_equations_solids_or_numbers() {
    let rows: [(&str, &[Kind]); 10] = [
        ("x = 1", &[Kind::Equation]),
        ("x^2 + y^2", &[Kind::Equation]),
        ("x < 1", &[Kind::Solid]),
        ("x = 1; y < 2; z", &[Kind::Equation, Kind::Solid, Kind::Equation]),
        ("2 + 3", &[Kind::Number]),
        ("r = 1; rho = 2", &[Kind::Equation, Kind::Equation]),
        ("r = 1; x = r", &[Kind::Equation]),
        ("A = x < 1; A; not A", &[Kind::Solid, Kind::Solid]),
        ("f(x, y) = x^2 + y^2 < 1", &[Kind::Solid]),
        ("f(x, y, z) = x^2 + y^2 + z; f(x, y, z) = 0; f(z, y, x) = 2", &[Kind::Equation, Kind::Equation]),
    ];
    for (text, kinds) in rows {
        let lowered = lowered(text);
        assert!(errors(&lowered).is_empty(), "{text}: {:?}", lowered.diagnostics);
        assert_eq!(lowered.surfaces.iter().map(|surface| surface.kind).collect::<Vec<_>>(), kinds, "{text}");
    }
}

#[test]
fn what_hinders_drawing_does_not_hinder_evaluating() {
    let rows = [
        ("2 + 3", "this is a number"),
        ("x = 1; 7", "this is a number"),
        ("0 = 0", "this holds everywhere"),
        ("x = x", "this holds everywhere"),
        ("1 = 2", "this holds nowhere"),
        ("a = 2", "the program has no surface"),
        ("w = x + 1", "the program has no surface"),
        ("f(u) = u", "the program has no surface"),
        ("f(x, y) = x; g(x, y) = y", "the program has no surface"),
        ("", "the program has no surface"),
        ("camera { fov: 40 }", "the program has no surface"),
    ];
    for (text, message) in rows {
        let lowered = lowered(text);
        assert!(errors(&lowered).is_empty(), "{text}: {:?}", lowered.diagnostics);
        let said = lowered.nothing_to_draw.first().unwrap_or_else(|| panic!("{text}: nothing said"));
        assert!(said.message.contains(message), "{text}: {}", said.message);
    }
    let lowered = lowered("2 + 3");
    assert_eq!(value_at(&lowered.graph, lowered.surfaces[0].f, [0.0; 3]), 5.0);
}

#[test]
fn attributes_are_kept() {
    let text = "x = 1 { color: #4af, name: \"wall\", clip: box(-1..1, -2..2*1, 0..pi) }
        y < 1 { color: orange, clip: ball(0, 0, 1/2, 2) }
        z = 1 { color: rgb(1, 0.5, 0), clip: x^2 + y^2 < 1 }";
    let lowered = lowered(text);
    assert!(errors(&lowered).is_empty(), "{:?}", lowered.diagnostics);
    let [wall, solid, plane] = &lowered.surfaces[..] else { panic!("three surfaces") };
    assert_eq!(
        (wall.matter.color.clone(), wall.name.as_deref()),
        (Some(Paint::Plain(Color::Srgb([0x44, 0xaa, 0xff]))), Some("wall"))
    );
    let shape = |clip: Option<Clip>| clip.expect("a clip").shape;
    let high = [1.0, 2.0, std::f64::consts::PI];
    assert_eq!(shape(wall.clip), ClipShape::Box { low: [-1.0, -2.0, 0.0], high });
    assert_eq!(solid.matter.color, Some(Paint::Plain(Color::Srgb([255, 165, 0]))));
    assert_eq!(shape(solid.clip), ClipShape::Ball { centre: [0.0, 0.0, 0.5], radius: 2.0 });
    assert_eq!(plane.matter.color, Some(Paint::Plain(Color::Linear([1.0, 0.5, 0.0]))));
    let ClipShape::Region(side) = shape(plane.clip) else { panic!("a region") };
    assert!(value_at(&lowered.graph, side, [0.5, 0.5, 9.0]) < 0.0);
    assert!(value_at(&lowered.graph, side, [1.5, 0.5, 9.0]) > 0.0);
}

#[test]
fn camera_and_render_become_plain_numbers() {
    let text = "a = 2; x = 1
        camera { eye: (a*2, -3, sqrt(4)), look_at: (0, 0, 1/4), fov: 35.5 }
        render { size: 320x200, mode: normal, samples: 2^4, bounces: 0, clip: ball(0, 0, 0, a) }";
    let lowered = lowered(text);
    assert!(errors(&lowered).is_empty(), "{:?}", lowered.diagnostics);
    let camera = lowered.camera.expect("a camera");
    assert_eq!(camera.eye, Some([4.0, -3.0, 2.0]));
    assert_eq!((camera.look_at, camera.fov), (Some([0.0, 0.0, 0.25]), Some(35.5)));
    let render = lowered.render.expect("a render block");
    assert_eq!((render.size, render.samples, render.bounces), (Some((320, 200)), Some(16), Some(0)));
    assert_eq!(render.mode.expect("a mode").name, "normal");
    assert_eq!(render.clip.expect("a clip").shape, ClipShape::Ball { centre: [0.0; 3], radius: 2.0 });
}

#[test]
fn parameters_take_their_value_from_outside() {
    let text = "a = 0.5 in [0, 2*pi] step 0.1; b = a/2; z = b*x";
    for (set, expected) in [(vec![], 0.25), (vec![("a", "3")], 1.5), (vec![("a", "3"), ("a", "1")], 0.5)] {
        let lowered = lowered_with(text, &set);
        assert!(errors(&lowered).is_empty(), "{:?}", lowered.diagnostics);
        assert_eq!(value_at(&lowered.graph, lowered.surfaces[0].f, [1.0, 0.0, 0.0]), -expected);
        let parameter = &lowered.parameters[0];
        assert_eq!((parameter.name.as_str(), parameter.value), ("a", expected * 2.0));
        assert_eq!((parameter.low, parameter.high, parameter.step), (0.0, std::f64::consts::TAU, Some(0.1)));
    }
}

#[test]
fn definitions_are_found_by_name() {
    let lowered = lowered("R = 1.5; c = (1, R, 0); A = x < R; w = x*R; L = [1, 2]; x = 0");
    assert!(errors(&lowered).is_empty(), "{:?}", lowered.diagnostics);
    let value = |name: &str| lowered.definition(name).expect("defined").value.clone();
    assert!(matches!(value("R"), Value::Number(_)));
    assert!(matches!(value("c"), Value::Vector(items) if items.len() == 3));
    assert!(matches!(value("A"), Value::Region(_)));
    assert!(matches!(value("L"), Value::List(items) if items.len() == 2));
    let Value::Number(w) = value("w") else { panic!("a number") };
    assert_eq!(value_at(&lowered.graph, w, [2.0, 0.0, 0.0]), 3.0);
}

#[test]
fn notes_say_what_was_read() {
    let rows = [
        ("r = 1; x = r", "`r` is read as the program's own r, not as `sqrt(x^2 + y^2)`"),
        ("phi = 1.6; f(u) = u*phi; f(x)", "`phi` is read as the program's own phi"),
        ("f(x, y) = x*y", "drawn is `z = f(x, y)`"),
        ("bump(x, y, z) = x*y - z; a = 3", "drawn is `bump(x, y, z) = 0`"),
    ];
    for (text, words) in rows {
        let lowered = lowered(text);
        assert!(errors(&lowered).is_empty(), "{text}: {:?}", lowered.diagnostics);
        let found = lowered.diagnostics.iter().any(|diagnostic| diagnostic.message.contains(words));
        assert!(found, "{text}: {:?}", lowered.diagnostics);
    }
}

#[test]
fn nodes_know_their_text() {
    let text = "w = sin(x) + 1; z = w*cos(y)";
    let lowered = lowered(text);
    let f = lowered.surfaces[0].f;
    let texts: Vec<&str> = lowered
        .graph
        .reachable(&[f])
        .into_iter()
        .filter_map(|id| lowered.graph.span(id))
        .map(|span| &text[span.range()])
        .collect();
    for expected in ["sin(x)", "sin(x) + 1", "cos(y)", "w*cos(y)", "z = w*cos(y)"] {
        assert!(texts.contains(&expected), "{expected} in {texts:?}");
    }
}

#[test]
fn what_is_missing_is_not_reported_again_when_the_parser_failed() {
    let parsed = crate::syntax::parse(&[(crate::diag::SourceId(0), "a = 3; x = a*b_")]);
    let settings = super::Settings { set: Vec::new(), incomplete: true };
    assert!(errors(&super::lower(&parsed.program, &settings)).is_empty());
}

#[test]
fn the_gallery_has_no_errors_and_something_to_draw() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/gallery");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).expect("the gallery") {
        let path = entry.expect("an entry").path();
        let lowered = lowered(&std::fs::read_to_string(&path).expect("a text"));
        assert!(errors(&lowered).is_empty(), "{}: {:?}", path.display(), lowered.diagnostics);
        assert!(!lowered.surfaces.is_empty() && lowered.nothing_to_draw.is_empty(), "{}", path.display());
        count += 1;
    }
    assert!(count >= 10);
}
