//! Wrong programs: each row has the column of the error, words of its message and words of the way out.

use super::{errors, lowered, lowered_with};

/// Program, column of the first error counted from 1, part of its message, part of its help.
const WRONG: &[(&str, u32, &str, &str)] = &[
    // Numbers of arguments.
    ("sin(x, y)", 1, "`sin` was given 2 arguments", "sin(x)"),
    ("atan2(x)", 1, "`atan2` was given 1 argument", "atan2(y, x)"),
    ("z = 2 + clamp(x, 1)", 9, "`clamp` was given 2 arguments", "clamp(x, low, high)"),
    ("smoothstep(x)", 1, "`smoothstep` was given 1 argument", "smoothstep(low, high, x)"),
    ("if(x < 0, 1)", 1, "`if` was given 2 arguments", "if(condition, a, b)"),
    ("mod(x, y, z)", 1, "`mod` was given 3 arguments", "mod(a, b)"),
    ("log(x, y, z)", 1, "`log` was given 3 arguments", "log(b, x)"),
    ("f(u, v) = u*v; f(x)", 16, "`f` was given 1 argument", "f(u, v)"),
    ("f(u) = u; f(x, y) = 1", 11, "`f` was given 2 arguments", "f(u)"),
    ("smooth_union(x < 0)", 1, "`smooth_union` was given 1 argument", "smooth_union(k, a, b"),
    ("cross(p)", 1, "`cross` was given 1 argument", "cross(a, b)"),
    // Regions, numbers, vectors, lists where another kind is wanted.
    ("x^2 <= 1 + (y<0)", 12, "a region stands where a number is wanted", "if(y < 0, 1, 0)"),
    ("sin(x < 0)", 5, "a region stands where a number is wanted", "if("),
    ("2*(x < 0)", 3, "a region stands where a number is wanted", "if("),
    ("-(x < 0) + y", 2, "a region stands where a number is wanted", "if("),
    ("|x < 0|", 2, "a region stands where a number is wanted", "if("),
    ("(x<0)^2", 1, "a region stands where a number is wanted", "if("),
    ("x^(y<0)", 3, "a region stands where a number is wanted", "if("),
    ("x < 0 and y", 11, "a number stands where a region is wanted", "comparison"),
    ("not x", 5, "a number stands where a region is wanted", "comparison"),
    ("x or y", 1, "a number stands where a region is wanted", "comparison"),
    ("if(x, 1, 2)", 4, "the condition of `if` is a number", "x < 0"),
    ("if(x < 0, 1, y < 0)", 1, "the two branches of `if` are not of one kind", "both"),
    ("if(x < 0, p, 1)", 1, "the two branches of `if` are not of one kind", "both"),
    ("if(x < 0, (x,y), p)", 1, "different lengths", "three"),
    ("union(x < 0, y)", 1, "regions and numbers cannot be combined", "f <= 0"),
    ("union(p, y < 0)", 7, "a vector stands where a region is wanted", "comparison"),
    ("A = x < 0; A + 1", 12, "a region stands where a number is wanted", "if("),
    ("A = x < 0; A = x", 12, "`A` is defined twice", ""),
    ("p + 1", 1, "a number and a vector", "(1, 1, 1)"),
    ("x - p", 1, "a number and a vector", "|p|"),
    ("p * p", 1, "two vectors have no product", "dot(p, q)"),
    ("x + p*(1,2,3)", 5, "two vectors have no product", "cross(p, q)"),
    ("x / p", 5, "nothing can be divided by a vector", "|p|"),
    ("p^2", 1, "a vector has no powers", "dot(p, p)"),
    ("2^p", 3, "a vector stands where a number is wanted", "p.x"),
    ("sin(p)", 5, "a vector stands where a number is wanted", "p.x"),
    ("abs(p)", 5, "a vector stands where a number is wanted", "|p|"),
    ("p < 1", 1, "a vector stands where a number is wanted", "p.x"),
    ("dot(x, p)", 5, "a number stands where a vector is wanted", "(a, b, c)"),
    ("dot((1,2), p)", 1, "different lengths", "three"),
    ("(1,2) + p", 1, "different lengths", "three"),
    ("cross((1,2), (3,4)).z", 1, "`cross` wants two vectors of three", "(a, b, 0)"),
    ("v = (x, y); v.z", 15, "a vector of 2 numbers has no component `z`", ".y"),
    ("p", 1, "a vector is no surface", "="),
    ("[x, y]", 1, "a list is no surface", "="),
    ("p - (1,2,3) = (0,0,0)", 1, "a vector stands in an equation", "|p - c|"),
    ("(x < 0) = 1", 1, "a region stands in an equation", "if("),
    ("y = [1, 2]", 5, "a list stands in an equation", "sum("),
    ("(1, 2, 3, 4) = x", 1, "a vector has two or three numbers", "[a, b, c, d]"),
    ("L = [1, 2]; L + x", 13, "a list stands where a number is wanted", "sum("),
    ("L = [[1], [2]]; x", 6, "a list cannot stand in a list", "one by one"),
    ("(x < 0, 1, 2).x", 2, "a region stands where a number is wanted", ""),
    // Series.
    ("sum(k = 1..2.5, x)", 12, "a bound is a whole number, and this is 2.5", ""),
    ("sum(k = x..3, x)", 9, "known before drawing", "cannot hang on x, y or z"),
    ("sum(k = 1..pi, x)", 12, "a bound is a whole number", "floor"),
    ("sum(c in 3, c*x)", 10, "a number stands where a list is wanted", "[a, b, c]"),
    ("product(c in [(1,2,3)], c)", 25, "a vector stands where a number is wanted", ""),
    ("sum(k = 1..3, x < k)", 15, "a region stands where a number is wanted", ""),
    ("chebyshev(x, y)", 11, "known before drawing", "x, y or z"),
    ("chebyshev(2.5, y)", 11, "the degree is a whole number", ""),
    ("legendre(-1, y)", 10, "the degree is 0 or more", ""),
    ("root(0, x)", 6, "the order of a root is 1 or more", ""),
    ("root(x, y)", 6, "known before drawing", ""),
    // Names.
    ("a = 1; a = 2; x = a", 8, "`a` is defined twice", "another name"),
    ("q = x^2 + y^2 - z; q = 0.02; z", 20, "`q` is defined twice", "write `0.02 = q`"),
    ("f(u) = u; f(v) = 3; x", 11, "`f` is defined twice", "another name"),
    ("f(u) = u; f(x, y) = 3; x", 11, "`f` was given 2 arguments", "f(u)"),
    ("a = 1 in [0, 2]; a = 2; x", 18, "`a` is defined twice", "another name"),
    ("a = b; b = a; x = a", 1, "circle: `a` → `b` → `a`", "without the others"),
    ("a = b + 1; b = c; c = 2a; x = 1", 1, "circle: `a` → `b` → `c` → `a`", ""),
    ("a = a + 1; x = a", 1, "`a` is defined by itself", ""),
    ("f(u) = f(u - 1); f(x)", 1, "the function `f` calls itself", "sum("),
    ("f(u) = g(u); g(u) = f(u); f(x)", 1, "circle: `f` → `g` → `f`", ""),
    // Parameters.
    ("a = 0.5 in [1, 0]; x = a", 13, "this range is empty", "[0, 1]"),
    ("a = 2 in [0, 1]; x = a", 5, "the value 2 lies outside of the range [0, 1]", "widen"),
    ("a = 0.5 in [0, 1] step 0; x = a", 24, "the step of a parameter is more than 0", ""),
    ("a = x in [0, 1]; y = a", 5, "known before drawing", "x, y or z"),
    ("a = 1 in [0, x]; y = a", 14, "known before drawing", "x, y or z"),
    ("a = 1 in [0, 1/0]; y = a", 14, "no value", ""),
    // Attributes and blocks.
    ("x = 1 { colour: red }", 9, "no attribute `colour`", "did you mean `color`?"),
    ("x = 1 { banana: 1 }", 9, "no attribute `banana`", "takes"),
    ("x = 1 { material: gold }", 19, "there is no material `gold`", "metal: \"gold\""),
    (
        "material red_ball { color: red }; x = 1 { material: red_bal }",
        53,
        "there is no material `red_bal`",
        "`red_ball`",
    ),
    ("x = 1 { material: glass }", 19, "there is no material `glass`", "kind: glass"),
    (
        "material a { color: red }; material a { color: blue }; x = 1",
        37,
        "material `a` is defined twice",
        "another name",
    ),
    ("material a { colr: red }; x = 1", 14, "a material has no attribute `colr`", "did you mean `color`?"),
    ("material a { inside: negative }; x = 1", 14, "a material has no attribute `inside`", ""),
    ("x = 1 { kind: glas }", 15, "there is no kind `glas`", "did you mean `glass`?"),
    ("x = 1 { kind: water }", 15, "there is no kind `water`", "kind: glass, ior: 1.333"),
    ("x = 1 { kind: wood }", 15, "there is no kind `wood`", "`matte`"),
    ("x = 1 { kind: glass, ior: 0 }", 27, "`ior` wants a number more than 0", "ior: 1.5"),
    ("x = 1 { kind: glass, ior: -1.5 }", 27, "`ior` wants a number more than 0", ""),
    ("x = 1 { kind: glass, ior: z }", 27, "known before drawing", ""),
    ("x = 1 { kind: glass, absorption: -1 }", 34, "`absorption` wants a number that is not negative", ""),
    ("x = 1 { kind: glass, absorption: rgb(0, -1, 0) }", 41, "a part of a light's colour is not negative", ""),
    ("x = 1 { kind: glass, priority: 1.5 }", 32, "`priority` is a whole number", ""),
    ("x = 1 { kind: glass, priority: -1 }", 32, "`priority` wants a whole number from 0", ""),
    ("x = 1 { kind: glass, inside: out }", 30, "`inside` wants `negative` or `positive`", ""),
    ("x = 1 { roughness: 2, kind: metal }", 20, "`roughness` wants a number from 0 to 1", "0.3"),
    ("x = 1 { roughness: -0.1, kind: metal }", 20, "`roughness` wants a number from 0 to 1", ""),
    ("x = 1 { opacity: 1.5 }", 18, "`opacity` wants a number from 0 to 1", ""),
    ("x = 1 { emission: -2 }", 19, "`emission` wants a number that is not negative", ""),
    ("x = 1 { metal: \"gild\" }", 16, "the metal `gild` is not known", "did you mean `gold`?"),
    ("x = 1 { metal: \"unobtainium\" }", 16, "the metal `unobtainium` is not known", "`gold`"),
    ("x = 1 { kind: matte, metal: \"gold\" }", 22, "`metal` belongs to metals, and this is matte", "kind: metal"),
    ("x = 1 { kind: metal, n: 1.5 }", 22, "a metal with `n` needs `k` too", "k: rgb"),
    ("x = 1 { kind: metal, k: 1.5 }", 22, "a metal with `k` needs `n` too", ""),
    ("x = 1 { metal: gold, n: 1, k: 2 }", 22, "a known metal has an n and a k of its own", "leave out"),
    ("x = 1 { color: 3 }", 16, "`color` wants a colour", "#4af"),
    ("x = 1 { color: z }", 16, "`color` wants a colour", "palette"),
    ("x = 1 { color: sin(x) }", 16, "`color` wants a colour", "palette"),
    ("x = 1 { color: palette(\"virids\", z) }", 24, "there is no palette `virids`", "did you mean `viridis`?"),
    ("x = 1 { color: palette(z) }", 16, "`palette` was given 1 argument", "value, low, high"),
    ("x = 1 { color: palette(z, 1) }", 24, "there is no palette `z`", "`viridis`"),
    ("x = 1 { color: palette(viridis, red) }", 33, "a colour stands where a number is wanted", "2*r"),
    ("x = 1 { color: checker(0, red, blue) }", 24, "the size of a checker is more than 0", ""),
    ("x = 1 { color: checker(z, red, blue) }", 24, "known before drawing", ""),
    ("x = 1 { color: checker(1, red, bleu) }", 32, "there is no colour `bleu`", "did you mean `blue`?"),
    ("x = 1 { color: checker(1, red) }", 16, "`checker` was given 2 arguments", "checker(size, a, b)"),
    ("x = 1 { color: checker(1, rgb(2, 0, 0), blue) }", 31, "lies between 0 and 1", ""),
    ("x = 1 { color: mix(red, blue, green) }", 31, "a colour stands where a number is wanted", ""),
    ("x = 1 { color: every(1, z) }", 16, "`every` draws lines and is no colour", "lines: every(0.25, z)"),
    ("x = 1 { lines: z }", 16, "`lines` wants lines", "every(0.25, z)"),
    ("x = 1 { lines: every(0, z) }", 22, "the step from line to line is more than 0", ""),
    ("x = 1 { lines: every(1, z, -1) }", 28, "the width of a line is more than 0", ""),
    ("x = 1 { lines: every(1) }", 16, "`every` was given 1 argument", "every(step, f)"),
    ("x = 1 { color: rgb(z, 2, 0) }", 23, "lies between 0 and 1", ""),
    ("x = 1 { cap: 1 }", 14, "`cap` wants `true` or `false`", "cap: true"),
    ("x = 1; light { at: (0,0,3), power: 1, color: rgb(z, 0, 0) }", 46, "the same everywhere", ""),
    ("x = 1 { color: rgb(1, 2) }", 16, "a colour has three numbers, and this has 2", "rgb(red, green, blue)"),
    ("x = 1 { color: rgb(1, 2, 0) }", 23, "lies between 0 and 1", ""),
    ("x = 1 { color: \"gren\" }", 16, "there is no colour `gren`", "did you mean `green`?"),
    ("x = 1 { name: 3 }", 15, "`name` wants a text", "\""),
    ("x = 1 { clip: 3 }", 15, "`clip` wants a box, a ball or a region", "ball(0, 0, 0, 2)"),
    ("x = 1 { clip: ball(0, 0, 0) }", 15, "a ball has four numbers, and this has 3", "ball(x, y, z, radius)"),
    ("x = 1 { clip: ball(0, 0, 0, -1) }", 29, "the radius of a ball is more than 0", ""),
    ("x = 1 { clip: ball(0, 0, x, 1) }", 26, "known before drawing", ""),
    ("x = 1 { clip: box(0..1, 2..1, 0..1) }", 25, "the range 2..1 is empty", "first"),
    ("x = 1; camera { eye: (0,0,1), zoom: 3 }", 31, "a camera has no attribute `zoom`", "takes"),
    ("x = 1; camera { eye: 3 }", 22, "`eye` wants a point", "(4, -3, 2)"),
    ("x = 1; camera { eye: (x, 0, 1) }", 22, "known before drawing", ""),
    ("x = 1; camera { fov: 190 }", 22, "`fov` wants an angle between 0 and 180", "40"),
    ("x = 1; camera { eye: (1,2,3), look_at: (1,2,3) }", 8, "looks at its own eye", ""),
    ("x = 1; camera { fov: 40 }; camera { fov: 50 }", 28, "a program has one camera", "one of them"),
    ("x = 1; render { size: 3 }", 23, "`size` wants a width and a height", "800x600"),
    ("x = 1; render { samples: 0 }", 26, "`samples` wants a whole number from 1", ""),
    ("x = 1; render { samples: 1.5 }", 26, "`samples` is a whole number, and this is 1.5", ""),
    ("x = 1; render { seed: -1 }", 23, "`seed` wants a whole number from 0", ""),
    ("x = 1; render { exposure: 1000 }", 27, "a number of stops from -100 to 100", ""),
    ("x = 1; render { background: rgb(2, 0, 0) }", 33, "lies between 0 and 1", ""),
    ("x = 1; render { background: transparant }", 29, "there is no colour `transparant`", ""),
    ("x = 1; render { tonemap: 3 }", 26, "`tonemap` wants the name of a tone curve", "neutral"),
    ("x = 1; render { sise: 8x8 }", 17, "no attribute `sise`", "did you mean `size`?"),
    ("x = 1; light { at: (1,2,3) }", 8, "a light has no `power`", "power: 60"),
    ("x = 1; light { power: 60 }", 8, "a light has no `at`", "at: (4, -3, 5)"),
    ("x = 1; light { at: (1,2,3), power: -1 }", 36, "`power` wants a power in watts, 0 or more", "60"),
    ("x = 1; light { at: (1,2,3), power: 1, radius: -1 }", 47, "`radius` wants a length, 0 or more", ""),
    ("x = 1; light { at: (1,2,3), power: 1, radius: 1e-200 }", 8, "too small to be computed with", "point"),
    ("x = 1; light { at: 3, power: 1 }", 20, "`at` wants a point", ""),
    (
        "x = 1; light { at: (1,2,3), power: 1, radus: 1 }",
        39,
        "a light has no attribute `radus`",
        "did you mean `radius`?",
    ),
    ("x = 1; light { at: (1,2,3), power: 1, color: 3 }", 46, "`color` wants a colour", ""),
    ("x = 1; sun { from: (0,0,0), irradiance: 3 }", 20, "(0, 0, 0) has none", "(1, -1, 2)"),
    ("x = 1; sun { from: (0,0,1) }", 8, "a sun has no `irradiance`", "irradiance: 3"),
    ("x = 1; sun { irradiance: 1 }", 8, "a sun has no `from`", ""),
    ("x = 1; sun { from: (0,0,1), irradiance: -1 }", 41, "`irradiance` wants an irradiance in W/m^2, 0 or more", ""),
    ("x = 1; sun { from: (0,0,1), irradiance: 1, angle: 180 }", 51, "0 or more and less than 180", "0.53"),
    ("x = 1; sun { from: (0,0,1), irradiance: 1, angle: 1e-200 }", 8, "too small to be computed with", "parallel"),
    ("x = 1; sky { radiance: -1 }", 24, "`radiance` wants a radiance in W/(m^2 sr), 0 or more", ""),
    ("x = 1; sky { color: red }", 8, "a sky with a `color` has no `radiance`", "radiance: 1"),
    ("x = 1; sky { }", 8, "this sky says nothing", "sky { radiance: 1 }"),
    ("x = 1; sky { top: white }", 8, "a sky of three colours has no `horizon`", ""),
    ("x = 1; sky { top: white, radiance: 1 }", 8, "different kinds of skies", ""),
    ("x = 1; sky { sun: (1,1,-1) }", 19, "not below the horizon", ""),
    ("x = 1; sky { sun: (0,0,0) }", 19, "(0, 0, 0) has none", ""),
    ("x = 1; sky { sun: (1,1,1), turbidity: 1 }", 39, "a number from 2 (very clear) to 10 (hazy)", ""),
    ("x = 1; sky { turbidity: 3 }", 8, "a sky with a `turbidity` has no `sun`", ""),
    ("x = 1; sky { radiance: 1 }; sky { radiance: 2 }", 29, "a program has one sky", "one of them"),
];

#[test]
fn wrong_programs_say_where_and_what_and_the_way_out() {
    assert!(WRONG.len() >= 60);
    let mut failures = Vec::new();
    for &(text, column, message, help) in WRONG {
        let parsed = crate::syntax::parse(&[(crate::diag::SourceId(0), text)]);
        if let Some(error) = parsed.diagnostics.iter().find(|diagnostic| diagnostic.is_error()) {
            failures.push(format!("{text}: the parser said: {}", error.message));
            continue;
        }
        let lowered = super::lower(&parsed.program, &super::Settings::default());
        let Some(error) = errors(&lowered).first().copied().cloned() else {
            failures.push(format!("{text}: no error"));
            continue;
        };
        let found = error.labels.first().map_or(0, |label| label.span.start + 1);
        let way_out = error.help.clone().unwrap_or_default();
        if found != column || !error.message.contains(message) || !way_out.contains(help) {
            failures.push(format!("{text}: column {found}: {}; help: {way_out}", error.message));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn independent_errors_are_all_reported_and_nothing_twice() {
    let rows = [
        ("sin(x, y) + cos(x, y) = p^2", 3),
        ("a = sin(1, 2); x = a; y = a + a", 1),
        ("a = b; b = a; x = a; y = b", 1),
        ("f(u) = u + (u < 0); f(x) = 1; f(y) = 2", 1),
        ("x = 1 { colour: 1, nme: 2 }; camera { fv: 3 }", 3),
        ("sum(k = 1..1000, p^2)", 1),
        ("f(u) = u + sin(1, 2); g(u) = u*(1 + (x < 0)); x = 1", 2),
        ("f(u) = u + |u| + u.x; x = 1", 0),
    ];
    for (text, count) in rows {
        let lowered = lowered(text);
        assert_eq!(errors(&lowered).len(), count, "{text}: {:?}", lowered.diagnostics);
    }
}

#[test]
fn an_error_in_a_function_says_which_call_brought_it_up() {
    let lowered = lowered("f(u) = u + 1; f(x) = 0; f(p) = 0");
    let error = errors(&lowered)[0];
    assert_eq!(error.labels[0].span.start, 7);
    assert!(error.labels.iter().any(|label| label.span.start == 24 && label.text == "in this call"), "{error:?}");
}

#[test]
fn settings_of_what_is_no_parameter_are_refused() {
    let rows = [
        ("a = 1 in [0, 2]; x = a", "a", "3", "lies outside of the range [0, 2]", "widen"),
        ("a = 1 in [0, 2]; x = a", "a", "-1", "lies outside of the range [0, 2]", "widen"),
        ("a = 1; x = a", "a", "3", "`a` is no parameter", "a = 3 in"),
        ("f(u) = u; f(x)", "f", "3", "`f` is no parameter", "in ["),
        ("radius = 1 in [0, 2]; x = radius", "raduis", "1", "no parameter `raduis`", "did you mean `radius`?"),
        ("x = 1", "b", "1", "no parameter `b`", "it has none"),
        ("c = 1 in [0, 2]; x = c", "b", "1", "no parameter `b`", "`c`"),
    ];
    for (text, name, value, message, help) in rows {
        let lowered = lowered_with(text, &[(name, value)]);
        let error = errors(&lowered).first().copied().cloned().unwrap_or_else(|| panic!("{text}: no error"));
        assert!(error.message.contains(message), "{text}: {}", error.message);
        assert!(error.help.unwrap_or_default().contains(help), "{text}");
    }
}
