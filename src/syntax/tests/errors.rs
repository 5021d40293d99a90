//! Programs that are refused: where, with what words, with which mend.

use super::{errors, place, read};
use crate::diag::Diagnostic;

/// Each row: a program, line and column of its only error, a part of its message, a part of its help.
fn check(rows: &[(&str, (usize, usize), &str, &str)]) {
    let mut wrong = Vec::new();
    for (text, expected, message, help) in rows {
        let parsed = read(text);
        let found = errors(&parsed);
        let right = |error: &&Diagnostic| {
            place(text, error) == *expected
                && error.message.contains(message)
                && error.help.as_deref().unwrap_or("").contains(help)
        };
        if found.len() != 1 || !found.iter().all(right) {
            let seen: Vec<_> = found.iter().map(|error| (place(text, error), &error.message, &error.help)).collect();
            wrong.push(format!("{text}\n    expected {expected:?} {message} / {help}\n    found {seen:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_misfit_is_placed_and_mended() {
    check(&[
        ("(x+1", (1, 5), "missing `)`", ""),
        ("sin(x", (1, 6), "missing `)`", ""),
        ("max(x, [1, 2)", (1, 13), "missing `]`", ""),
        ("x+1)", (1, 4), "this `)` closes nothing", ""),
        (")x", (1, 1), "closes nothing", ""),
        ("x = 1,5", (1, 5), "a decimal comma", "write `1.5`"),
        ("x, y", (1, 2), "a comma stands only", ""),
        ("x=1=2", (1, 4), "one `=` at most", "`;`"),
        ("sin^-1 x", (1, 1), "can mean two things", "asin(x)"),
        ("sin^-1(x)", (1, 1), "can mean two things", "1/sin(x)"),
        ("sin⁻¹ x", (1, 1), "can mean two things", "asin"),
        ("cos^(-1) x", (1, 1), "can mean two things", "acos"),
        ("tan^-2 x", (1, 1), "can mean two things", "1/tan(x)"),
        ("x != 1", (1, 3), "there is no `!=`", "a < b or a > b"),
        ("x ≠ 1", (1, 3), "there is no `≠`", ""),
        ("!(x > 1)", (1, 1), "there is no `!`", "write `not`"),
        ("x!", (1, 2), "there is no `!`", "not"),
        ("x>0 && y>0", (1, 5), "there is no `&&`", "write `and`"),
        ("x>0 || y>0", (1, 5), "`||`", "write `or`"),
        ("5 3", (1, 3), "directly behind `5`", "write `5*3`"),
        ("x 3", (1, 3), "directly behind `x`", "`x^3`"),
        ("(x+1)2", (1, 6), "directly behind", "`*2` or `^2`"),
        ("1.5.2", (1, 4), "directly behind", ""),
        ("|x|y|z|", (1, 5), "opens or closes", "abs()"),
        ("|x|y|", (1, 5), "opens or closes", "abs()"),
        ("|x", (1, 1), "no partner", "`|x|`; or write `abs(x)`"),
        ("x|", (1, 3), "missing behind `|`", ""),
        ("|x|+|", (1, 6), "missing behind `|`", ""),
        ("x +", (1, 4), "missing behind `+`", ""),
        ("x + * y", (1, 5), "missing between `+` and `*`", ""),
        ("* x", (1, 1), "cannot begin with `*`", ""),
        ("= 1", (1, 1), "nothing stands left of `=`", ""),
        ("x =", (1, 4), "missing behind `=`", ""),
        ("()", (1, 1), "nothing in these brackets", ""),
        ("max(x,)", (1, 7), "missing between `,` and `)`", ""),
        ("sin", (1, 1), "`sin` needs an argument", "sin(x)"),
        ("sin * x", (1, 1), "`sin` needs an argument", ""),
        ("atan2 x y", (1, 1), "takes its arguments in brackets", "atan2(y, x)"),
        ("g(u,v) = u*v; g x", (1, 15), "takes its arguments in brackets", ""),
        ("0 < x > 1", (1, 7), "two directions", "and"),
        ("x => 1", (1, 3), "`=>` is not part of the language", "`>=`"),
        ("x =< 1", (1, 3), "`=<` is not part", "`<=`"),
        ("a := 1", (1, 3), "`:=` is not part", "`=`"),
        ("x § y", (1, 3), "`§` is not part", ""),
        ("x + $", (1, 5), "`$` is not part", ""),
        ("x^2 + y² ∧ z", (1, 10), "`∧` is not part", "and"),
        ("p.w", (1, 2), "a component", ".x"),
        ("p.5", (1, 2), "directly behind", ""),
        ("1..3", (1, 2), "a range stands only", "sum"),
        ("sum(k, x)", (1, 5), "a running name", "k = 1..3"),
        ("sum(k = 1, x)", (1, 10), "expected `..`", "1..3"),
        ("sum(k = 1..3)", (1, 13), "expected `,` and the term", ""),
        ("(x = 1) + 2", (1, 4), "an equation cannot stand inside brackets", ""),
        ("a = 1 in 3", (1, 10), "the range of a parameter", "[0, 2]"),
        ("a = 1 in [0, 1, 2]", (1, 10), "a range has two ends", ""),
        ("a = 1 in [0, 2] stop 3", (1, 17), "`stop` does not fit", ""),
        ("x^2 and", (1, 8), "missing behind `and`", ""),
        ("and x", (1, 1), "cannot begin with `and`", ""),
        ("x [1]", (1, 3), "`[` does not fit", ""),
        ("x { color red }", (1, 5), "expected `key: value`", "color: red"),
        ("x { color: red name: \"a\" }", (1, 16), "expected `,` before `name`", ""),
        ("x { color: }", (1, 11), "the value is missing", ""),
        ("x { color: #12 }", (1, 12), "this is no colour", "#rgb"),
        ("x { name: \"a }", (1, 11), "not closed", ""),
        ("x { color: red", (1, 15), "missing `}`", ""),
        ("x { a: 1, a: 2 }", (1, 11), "`a` stands twice", ""),
        ("x { clip: box(0..1, 0..1) }", (1, 11), "a box has three ranges", ""),
        ("R = 1 { color: red }", (1, 7), "a block stands only behind a surface", ""),
        ("x { color: red; name: \"a\" }", (1, 15), "`;`", "`,`"),
        ("²x", (1, 1), "nothing is raised", ""),
        ("2 + ²", (1, 5), "nothing is raised", ""),
        ("f(u, u) = u", (1, 6), "stands twice", ""),
        ("f(sin) = 1", (1, 3), "a function of the language", ""),
        ("ball(u) = 2u", (1, 1), "a function of clips and colours", ""),
        ("sin = 2", (1, 1), "a function of the language and cannot be defined", ""),
        ("e = 2", (1, 1), "a constant and cannot", ""),
        ("x = 1 in [0, 2]", (1, 1), "a coordinate and cannot", ""),
        ("x + 1e999", (1, 5), "too large", ""),
        ("x: 1", (1, 2), "only between key and value", "="),
    ]);
}

#[test]
fn unknown_names_are_met_with_near_ones() {
    check(&[
        ("foo(x)", (1, 1), "unknown function `foo`", ""),
        ("sine(x)", (1, 1), "unknown function `sine`", "`sin`"),
        ("sqr(x)", (1, 1), "unknown function `sqr`", "`sqrt`"),
        ("radius = 2; x = raduis", (1, 17), "unknown name `raduis`", "`radius`"),
        ("a x", (1, 1), "unknown name `a`", "a = 1 in [0, 2]"),
        ("a*x + a*y", (1, 1), "unknown name `a`", "--set a=1"),
        ("a(x+1)", (1, 1), "unknown name `a`", "--set a=1"),
        ("sinx", (1, 1), "unknown name `sinx`", "write `sin x`"),
        ("2cosxy", (1, 2), "unknown name `cosxy`", "write `cos xy`"),
        ("log10x", (1, 1), "unknown name `log10x`", "write `log10 x`"),
        ("foo(u) = u; foox", (1, 13), "unknown name `foox`", "write `foo x`"),
        ("axy", (1, 1), "unknown name `axy`", "with `a = 1` it is read as `a*x*y`"),
        ("x2", (1, 1), "unknown name `x2`", "`x^2` or `x*2`"),
        ("y + 2z3", (1, 6), "unknown name `z3`", "`z^3` or `z*3`"),
        ("SIN(x)", (1, 1), "upper and lower case", "`sin`"),
        ("SIN x", (1, 1), "upper and lower case", "`sin`"),
        ("X + 1", (1, 1), "upper and lower case", "`x`"),
        ("2Pi x", (1, 2), "upper and lower case", "`pi`"),
        ("R = 2; x = 3 r + Q; r = 4", (1, 18), "unknown name `Q`", ""),
        ("pix", (1, 1), "unknown name `pix`", "pi"),
        ("thetax", (1, 1), "unknown name `thetax`", "theta"),
        ("gamma(x)", (1, 1), "`gamma` is not built yet", ""),
        ("gamma(x) = z", (1, 1), "`gamma` is not built yet", "another name"),
        ("z = besselj(x); besselj(u) = 2u", (1, 17), "`besselj` is not built yet", ""),
        ("besselj(0, x)", (1, 1), "`besselj` is not built yet", ""),
        ("arcsin(x)", (1, 1), "unknown function `arcsin`", "`asin`"),
        ("pow(x, 2)", (1, 1), "unknown function `pow`", "`a^b`"),
        ("cot(x)", (1, 1), "unknown function", "1/tan(x)"),
        ("rx", (1, 1), "unknown name `rx`", ""),
        ("xyq", (1, 1), "unknown name `xyq`", ""),
        ("v = (1,2,3); vx", (1, 14), "unknown name `vx`", ""),
        ("f(u) = u; fx", (1, 11), "unknown name `fx`", ""),
        ("f(u) = u + t; f(x)", (1, 12), "unknown name `t`", ""),
        ("f(u) = u; x = u + f(x)", (1, 15), "unknown name `u`", ""),
        ("sum(k = 1..3, k x) + k", (1, 22), "unknown name `k`", ""),
        ("x { clip: zz > q }", (1, 16), "unknown name `q`", ""),
        ("х + 1", (1, 1), "Cyrillic", "`x`"),
        ("ｘ + 1", (1, 1), "full-width", "`x`"),
        ("𝑥 + 1", (1, 1), "mathematical", "`x`"),
        ("sіn(x)", (1, 2), "Cyrillic", "`sin`"),
        ("x₁ + 1", (1, 2), "lowered", "`x1`"),
        ("（x+1)", (1, 1), "is not part", "`(`"),
    ]);
}

#[test]
fn all_independent_errors_are_found() {
    let rows: [(&str, &[(usize, usize)]); 8] = [
        ("x + * 1\ny = (2\nz = 3,5", &[(1, 5), (2, 7), (3, 5)]),
        ("x + ; y + ; z", &[(1, 4), (1, 10)]),
        ("x = q\ny = t", &[(1, 5), (2, 5)]),
        ("q + t + q", &[(1, 1), (1, 5)]),
        ("x { color: , name: 5 5, clip: q }", &[(1, 11), (1, 22), (1, 31)]),
        ("a = (1 + 2\nx^2 + a = (1)\ny + q", &[(1, 11), (3, 5)]),
        ("a = 1 +* 2\nx = a", &[(1, 8)]),
        ("f(u) = u +* 2\nx = f(y) + f 2", &[(1, 11)]),
    ];
    for (text, expected) in rows {
        let parsed = read(text);
        let found: Vec<(usize, usize)> = errors(&parsed).into_iter().map(|error| place(text, error)).collect();
        let said: Vec<&String> = errors(&parsed).into_iter().map(|error| &error.message).collect();
        assert_eq!(found, expected, "{text}: {said:?}");
    }
}

#[test]
fn a_missing_bracket_shows_where_its_partner_opened() {
    let parsed = read("y = max(x, (x + 1)");
    let error = errors(&parsed)[0];
    assert_eq!(error.labels[1].span.range(), 7..8);
}
