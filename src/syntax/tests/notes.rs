//! Where people and programs disagree: what is said, and where nothing is.

use super::{errors, notes, read};

/// Each row: a program, and a part that its only note must contain; empty for no note.
fn check(rows: &[(&str, &str)]) {
    let mut wrong = Vec::new();
    for (text, expected) in rows {
        let parsed = read(text);
        assert!(errors(&parsed).is_empty(), "{text}: {:?}", parsed.diagnostics);
        let found: Vec<&str> = notes(&parsed).iter().map(|note| note.message.as_str()).collect();
        let right = match expected.is_empty() {
            true => found.is_empty(),
            false => found.len() == 1 && found[0].contains(expected),
        };
        if !right {
            wrong.push(format!("{text}\n    expected {expected}\n    found {found:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn doubtful_readings_are_said_with_the_other_one() {
    check(&[
        ("1/2x", "read as (1/2)*x; write 1/(2x) for the other"),
        ("1/2 x", "read as (1/2)*x; write 1/(2 x) for the other"),
        ("y + 1/2x", "read as (1/2)*x; write 1/(2x)"),
        ("a=1;b=2;c=3; a/b c", "read as (a/b)*c; write a/(b c)"),
        ("x/2(y+1)", "read as (x/2)*(y+1); write x/(2(y+1))"),
        ("3x/2y", "read as (3x/2)*y; write 3x/(2y)"),
        ("1/2x y", "read as (1/2)*x y; write 1/(2x y)"),
        ("1/xy", "read as (1/x)*y; write 1/(xy)"),
        ("1/x y", "read as (1/x)*y"),
        ("1/sqrt(2)x", "read as (1/sqrt(2))*x"),
        ("7 % 2x", "read as (7 % 2)*x; write 7%(2x)"),
        ("1/2sin(x)", "read as (1/2)*sin(x)"),
        ("sin x y", "read as sin(x y); write sin(x)*y"),
        ("sin x(y+1)", "read as sin(x(y+1)); write sin(x)*(y+1)"),
        ("sin 2x y", "read as sin(2x y)"),
        ("cos x|y|", "read as cos(x|y|)"),
        ("sin x^2 y", "read as sin(x^2 y)"),
        ("a=1; sin a x", "read as sin(a x)"),
        ("f(u) = u; f x y", "read as f(x y)"),
        ("sin x^2", "read as sin(x^2); write (sin(x))^2"),
        ("sin x²", "read as sin(x²); write (sin(x))²"),
        ("sin 2x^2", "read as sin(2x^2); write (sin(2x))^2"),
        ("exp -x^2", "exp"),
        ("sin x/2", "read as (sin x)/2; write sin(x/2)"),
        ("-sin x/2", "read as (sin x)/2; write sin(x/2)"),
        ("sin 2x/3", "read as (sin 2x)/3; write sin(2x/3)"),
        ("sin^2 x/2", "read as (sin^2 x)/2; write sin^2(x/2)"),
        ("2 sin x/2", "read as (sin x)/2"),
        ("sin x/x", "read as (sin x)/x"),
        ("e^2x", "read as (e^2)*x; write e^(2x)"),
        ("e^x y", "read as (e^x)*y; write e^(x y)"),
        ("e^-2x", "read as (e^-2)*x; write e^(-2x)"),
        ("2e^3x", "write e^(3x)"),
        ("√2x", "read as √2*x; write √(2x)"),
        ("√2(x+1)", "read as √2*(x+1); write √(2(x+1))"),
        ("∛2x", "read as ∛2*x"),
        ("√(x)^2", "read as √((x)^2); write (√(x))^2"),
        ("√(x)²", "read as √((x)²); write (√(x))²"),
        ("x^1/2", "read as (x^1)/2; write x^(1/2)"),
        ("x^1/3", "read as (x^1)/3; write x^(1/3)"),
        ("x^-1/2", "read as (x^-1)/2; write x^(-1/2)"),
        ("-x^1/2", "write x^(1/2)"),
        ("log(x)", "`log` read as the logarithm to base 10; write `ln`"),
        ("log x", "to base 10"),
        ("phi", "`phi` read as the angle acos(z/rho)"),
        ("theta", "`theta` read as the angle atan2(y, x)"),
        ("θ x", "`theta` read as"),
        ("a = 1; axy", "`axy` read as a*x*y"),
        ("ex", "`ex` read as e*x"),
        ("f(s,t) = st; f(x,y)", "`st` read as s*t"),
        ("r = 1", "`r = …` read as a surface"),
        ("rho = 1", "read as a surface"),
        ("xy = 1", "`xy = …` read as a surface"),
        ("xyz = 1", "read as a surface"),
        ("xy(z) = 1", "not as a function"),
        ("1/2x\n1/2x", "read as (1/2)*x"),
        ("1/2x;1/2x;1/2x", "read as (1/2)*x"),
    ]);
}

#[test]
fn what_everybody_reads_alike_has_no_note() {
    check(&[
        ("x^2/4", ""),
        ("x^2/4 + y^2/9 = 1", ""),
        ("2x", ""),
        ("xy", ""),
        ("xyz", ""),
        ("sin 2x", ""),
        ("sin xy", ""),
        ("sin x cos y", ""),
        ("sin x cos y + sin y cos z + sin z cos x", ""),
        ("sin 2πx", ""),
        ("sin 2 pi x", ""),
        ("sin 2(x+1)", ""),
        ("sin x * y", ""),
        ("sin(x)/2", ""),
        ("sin (x)/2", ""),
        ("sin(x)^2", ""),
        ("sin^2 x", ""),
        ("sin²x", ""),
        ("sin -x", ""),
        ("x^2y", ""),
        ("2^2x", ""),
        ("e^(2x)", ""),
        ("e^x*y", ""),
        ("e^2 + x", ""),
        ("√x²", ""),
        ("√2*x", ""),
        ("√(2)x", ""),
        ("√(x)", ""),
        ("(1/2)x", ""),
        ("1/(2x)", ""),
        ("1/2*x", ""),
        ("x/2 + y", ""),
        ("1/x^2", ""),
        ("x^(1/2)", ""),
        ("x^1*2", ""),
        ("log(2, x)", ""),
        ("ln x", ""),
        ("phi = 1.6; x = phi", ""),
        ("theta = 2; x = theta", ""),
        ("f(phi) = phi; f(x)", ""),
        ("r", ""),
        ("rho = 2; x = rho", ""),
        ("p = (1,2,3); dot(p, p) + x", ""),
        ("log2(x) + log10(y)", ""),
        ("sin x / cos x", ""),
    ]);
}

#[test]
fn a_note_points_at_what_it_is_about() {
    let rows = [("y + 1/2x", 5..9), ("x + sin x y", 5..12), ("2 + e^2x", 5..9), ("x + theta", 5..10)];
    for (text, columns) in rows {
        let parsed = read(text);
        let span = notes(&parsed)[0].span().range();
        assert_eq!(span.start + 1..span.end + 1, columns, "{text}");
    }
}

#[test]
fn an_angle_alone_on_the_left_has_two_notes() {
    for text in ["theta = 1", "phi = 1; x = 1"] {
        let parsed = read(text);
        let said: Vec<&str> = notes(&parsed).iter().map(|note| note.message.as_str()).collect();
        assert!(said.len() == 2 && said[0].contains("angle") && said[1].contains("surface"), "{said:?}");
    }
}
