//! Expressions as people type them, and the fully bracketed reading of each.

use super::{errors, read, readings};

/// Names that all rows may use: numbers, a vector, functions of one and two arguments.
const DECLARED: &str = "a = 2; b = 3; c = 4; k = 5; n = 6; R = 2; w = x + 1; v = (1, 2, 3); f(u) = u; g(s, t) = s*t;\n";

fn check(rows: &[(&str, &str)]) {
    let declared = readings(&read(DECLARED)).len();
    for (text, expected) in rows {
        let parsed = read(&format!("{DECLARED}{text}"));
        assert!(errors(&parsed).is_empty(), "{text}: {:?}", parsed.diagnostics);
        let found = readings(&parsed)[declared..].join("; ");
        assert_eq!(found, *expected, "{text}");
    }
}

#[test]
fn operators_bind_as_in_school() {
    check(&[
        ("x + y", "x + y"),
        ("x - y - z", "(x - y) - z"),
        ("x - y + z", "(x - y) + z"),
        ("x - (y + z)", "x - (y + z)"),
        ("x + y*z", "x + (y*z)"),
        ("x*y + z", "(x*y) + z"),
        ("x/y/z", "(x/y)/z"),
        ("x/(y/z)", "x/(y/z)"),
        ("x*y/z", "(x*y)/z"),
        ("x/y*z", "(x/y)*z"),
        ("x % 2", "x%2"),
        ("x % 2*y", "(x%2)*y"),
        ("x + y % 2", "x + (y%2)"),
        ("7 % x % 2", "(7%x)%2"),
        ("x^2", "x^2"),
        ("x**2", "x^2"),
        ("2^3^2", "2^(3^2)"),
        ("x^y^z", "x^(y^z)"),
        ("(x^y)^z", "(x^y)^z"),
        ("-x^2", "-(x^2)"),
        ("(-x)^2", "(-x)^2"),
        ("x^-2", "x^(-2)"),
        ("x^-2^2", "x^(-(2^2))"),
        ("x^+2", "x^(+2)"),
        ("2^-x", "2^(-x)"),
        ("-x*y", "(-x)*y"),
        ("-x + y", "(-x) + y"),
        ("x*-y", "x*(-y)"),
        ("x - -y", "x - (-y)"),
        ("--x", "-(-x)"),
        ("+x", "+x"),
        ("-x % 2", "(-x)%2"),
        ("x^1/2", "(x^1)/2"),
        ("x^(1/2)", "x^(1/2)"),
        ("x^(-2/3)", "x^((-2)/3)"),
        ("x^2*y^2", "(x^2)*(y^2)"),
        ("x^2 + y^2 + z^2 = 1", "((x^2) + (y^2)) + (z^2) = 1"),
        ("x^2 == 1", "x^2 = 1"),
        ("z = sin(x)*cos(y)", "z = sin(x)*cos(y)"),
        ("x = 1", "x = 1"),
        ("y = x^2", "y = x^2"),
        ("((x))", "x"),
        ("(x + 1)*(y - 2)", "(x + 1)*(y - 2)"),
    ]);
}

#[test]
fn factors_may_stand_without_a_sign() {
    check(&[
        ("2x", "2*x"),
        ("2 x", "2*x"),
        ("3(x+1)", "3*(x + 1)"),
        ("(x+1)(y-2)", "(x + 1)*(y - 2)"),
        ("(x+1) (y-2)", "(x + 1)*(y - 2)"),
        ("x y", "x*y"),
        ("x y z", "(x*y)*z"),
        ("2 sin(x)", "2*sin(x)"),
        ("x(y+1)", "x*(y + 1)"),
        ("x (y+1)", "x*(y + 1)"),
        ("a(x+1)", "a*(x + 1)"),
        ("1/2x", "(1/2)*x"),
        ("1/2 x", "(1/2)*x"),
        ("1/(2x)", "1/(2*x)"),
        ("a/b c", "(a/b)*c"),
        ("a/b c/k", "((a/b)*c)/k"),
        ("2x^2", "2*(x^2)"),
        ("2x^2y", "(2*(x^2))*y"),
        ("x^2y", "(x^2)*y"),
        ("x^2(y+1)", "(x^2)*(y + 1)"),
        ("2^2x", "(2^2)*x"),
        ("e^2x", "(e^2)*x"),
        ("e^x y", "(e^x)*y"),
        ("-2x", "(-2)*x"),
        ("x - 2y", "x - (2*y)"),
        ("2x + 3y - 4z", "((2*x) + (3*y)) - (4*z)"),
        ("2pi x", "(2*pi)*x"),
        ("2(3)(4)", "(2*3)*4"),
        ("(x)(y)(z)", "(x*y)*z"),
        ("2x*3y", "((2*x)*3)*y"),
        ("x sin(y)", "x*sin(y)"),
        ("sin(x)cos(y)", "sin(x)*cos(y)"),
        ("sin(x)y", "sin(x)*y"),
        ("f(x)y", "f(x)*y"),
        ("x f(y)", "x*f(y)"),
        ("g(x,y)(z)", "g(x, y)*z"),
        ("2|x|", "2*|x|"),
        ("x√2", "x*sqrt(2)"),
        ("x(1,2,3)", "x*(1, 2, 3)"),
        ("7 % 2x", "(7%2)*x"),
    ]);
}

#[test]
fn names_that_nobody_defined_fall_apart_into_letters() {
    check(&[
        ("xy", "x*y"),
        ("xyz", "(x*y)*z"),
        ("xx", "x*x"),
        ("2xy", "(2*x)*y"),
        ("axy", "(a*x)*y"),
        ("abx", "(a*b)*x"),
        ("xe", "x*e"),
        ("ex", "e*x"),
        ("wx", "w*x"),
        ("Rx", "R*x"),
        ("xy(x+y)", "(x*y)*(x + y)"),
        ("xy^2", "x*(y^2)"),
        ("xyz^2", "(x*y)*(z^2)"),
        ("1/xy", "(1/x)*y"),
        ("x²y(z+1)", "((x^2)*y)*(z + 1)"),
        ("x^xy", "(x^x)*y"),
        ("-xy", "(-x)*y"),
        ("xy = 1", "x*y = 1"),
        ("xyz = 1", "(x*y)*z = 1"),
        ("ax = 1", "a*x = 1"),
        ("xy(z) = 1", "(x*y)*z = 1"),
        ("sin xy", "sin(x*y)"),
        ("sin axy", "sin((a*x)*y)"),
        ("|xy|", "|x*y|"),
        ("sum(k = 1..3, kx)", "sum(k = 1..3, k*x)"),
        ("sum(j = 1..3, jx)", "sum(j = 1..3, j*x)"),
        ("h(s, t) = st; h(x, y)", "h(s, t) = s*t; h(x, y)"),
        ("h(s, t) = sxt; h(x, y)", "h(s, t) = (s*x)*t; h(x, y)"),
        ("xy = 3; z = xy", "xy = 3; z = xy"),
        ("2e", "2*e"),
        ("2e-x", "(2*e) - x"),
        ("2ex", "(2*e)*x"),
        ("2exy", "((2*e)*x)*y"),
    ]);
}

#[test]
fn bars_pair_up() {
    check(&[
        ("|x|", "|x|"),
        ("|x||y|", "|x|*|y|"),
        ("||x|-1|", "||x| - 1|"),
        ("||x||", "||x||"),
        ("|x| + |y|", "|x| + |y|"),
        ("|x|*|y|", "|x|*|y|"),
        ("|x|y", "|x|*y"),
        ("y|x|", "y*|x|"),
        ("2|x|+1", "(2*|x|) + 1"),
        ("|x|^2", "|x|^2"),
        ("-|x|", "-|x|"),
        ("||x|-|y||", "||x| - |y||"),
        ("|x + |y||", "|x + |y||"),
        ("|sin x|", "|sin(x)|"),
        ("sin|x|", "sin(|x|)"),
        ("|p|", "|p|"),
        ("|p-v|", "|p - v|"),
        ("|x|<1", "|x| < 1"),
        ("|x|y + 2|z|", "(|x|*y) + (2*|z|)"),
        ("2||x|-1|", "2*||x| - 1|"),
        ("|x||y||z|", "(|x|*|y|)*|z|"),
    ]);
}

#[test]
fn functions_apply_without_brackets() {
    check(&[
        ("sin(x)", "sin(x)"),
        ("sin (x)", "sin(x)"),
        ("sin (x)(y+1)", "sin(x)*(y + 1)"),
        ("sin(x)(y+1)", "sin(x)*(y + 1)"),
        ("sin x", "sin(x)"),
        ("sin 2x", "sin(2*x)"),
        ("sin x y", "sin(x*y)"),
        ("sin x(y+1)", "sin(x*(y + 1))"),
        ("sin x cos y", "sin(x)*cos(y)"),
        ("sin x * y", "sin(x)*y"),
        ("sin x/2", "sin(x)/2"),
        ("sin x + 1", "sin(x) + 1"),
        ("sin -x", "sin(-x)"),
        ("sin +x", "sin(+x)"),
        ("sin -2x", "sin(-(2*x))"),
        ("sin x^2", "sin(x^2)"),
        ("sin 2x^2", "sin(2*(x^2))"),
        ("sin x²", "sin(x^2)"),
        ("sin(x)^2", "sin(x)^2"),
        ("sin^2(x)", "sin(x)^2"),
        ("sin^2 x", "sin(x)^2"),
        ("sin²x", "sin(x)^2"),
        ("sin² x", "sin(x)^2"),
        ("sin²(x)", "sin(x)^2"),
        ("sin^2 x + cos^2 x", "(sin(x)^2) + (cos(x)^2)"),
        ("sin^2 2x", "sin(2*x)^2"),
        ("sin^2(x)y", "(sin(x)^2)*y"),
        ("sin^(2) x", "sin(x)^2"),
        ("sin^n x", "sin(x)^n"),
        ("sin^n(x)", "sin(x)^n"),
        ("sin sqrt x", "sin(sqrt(x))"),
        ("sin sqrt x y", "sin(sqrt(x*y))"),
        ("sin sqrt(x) y", "sin(sqrt(x)*y)"),
        ("sin cos x", "sin(cos(x))"),
        ("sin x cos y sin z", "(sin(x)*cos(y))*sin(z)"),
        ("sin x y cos z", "sin(x*y)*cos(z)"),
        ("2 sin x cos y", "(2*sin(x))*cos(y)"),
        ("sin x - cos y", "sin(x) - cos(y)"),
        ("sin x = cos y", "sin(x) = cos(y)"),
        ("x sin y z", "x*sin(y*z)"),
        ("ln x", "ln(x)"),
        ("ln 2x + 1", "ln(2*x) + 1"),
        ("exp -x^2", "exp(-(x^2))"),
        ("sqrt x", "sqrt(x)"),
        ("abs x", "abs(x)"),
        ("f x", "f(x)"),
        ("f 2x", "f(2*x)"),
        ("f -x", "f(-x)"),
        ("f^2 x", "f(x)^2"),
        ("sin π x", "sin(pi*x)"),
        ("sin 2πx", "sin((2*pi)*x)"),
        ("2^sin x", "2^sin(x)"),
        ("x^sin(y)", "x^sin(y)"),
        ("sin x^2y", "sin((x^2)*y)"),
        ("sin √x", "sin(sqrt(x))"),
        ("-sin x", "-sin(x)"),
        ("log x", "log(x)"),
        ("log(2, x)", "log(2, x)"),
        ("sin x % 2", "sin(x)%2"),
        ("length v", "length(v)"),
        ("min(x, y)", "min(x, y)"),
        ("sin(x)/cos(x)", "sin(x)/cos(x)"),
        ("sin(x + y z)", "sin(x + (y*z))"),
        ("max(x, sin y, 2z)", "max(x, sin(y), 2*z)"),
    ]);
}

#[test]
fn pasted_signs_are_read() {
    check(&[
        ("x − y", "x - y"),
        ("x × y", "x*y"),
        ("x·y", "x*y"),
        ("x ÷ y", "x/y"),
        ("x²", "x^2"),
        ("x¹⁰", "x^10"),
        ("x⁻²", "x^(-2)"),
        ("x²y²", "(x^2)*(y^2)"),
        ("x² + y² + z² = 1", "((x^2) + (y^2)) + (z^2) = 1"),
        ("2x²", "2*(x^2)"),
        ("(x+1)²", "(x + 1)^2"),
        ("x²^3", "x^(2^3)"),
        ("-x²", "-(x^2)"),
        ("√x", "sqrt(x)"),
        ("√2x", "sqrt(2)*x"),
        ("√x²", "sqrt(x^2)"),
        ("√(x)^2", "sqrt(x^2)"),
        ("√(x+1)", "sqrt(x + 1)"),
        ("√xy", "sqrt(x)*y"),
        ("∛x", "cbrt(x)"),
        ("√√x", "sqrt(sqrt(x))"),
        ("√x + 1", "sqrt(x) + 1"),
        ("2√x", "2*sqrt(x)"),
        ("√|x|", "sqrt(|x|)"),
        ("√sin x", "sqrt(sin(x))"),
        ("sqrt(x)^2", "sqrt(x)^2"),
        ("π", "pi"),
        ("2πx", "(2*pi)*x"),
        ("πx", "pi*x"),
        ("xπ", "x*pi"),
        ("τ x", "tau*x"),
        ("θ + φ + ρ", "(theta + phi) + rho"),
        ("θx", "theta*x"),
        ("α = 2; αx", "α = 2; α*x"),
        ("x ≤ 1", "x <= 1"),
        ("x ≥ 1", "x >= 1"),
        ("x\u{a0}+\u{2009}y", "x + y"),
        ("\u{feff}x", "x"),
        ("x ∗ y", "x*y"),
        ("x – y", "x - y"),
    ]);
}

#[test]
fn numbers_are_exact_decimals() {
    check(&[
        ("x + .5", "x + 0.5"),
        ("x + 2.", "x + 2"),
        ("x + 1e-3", "x + 0.001"),
        ("x + 2e3", "x + 2000"),
        ("x + 1E2", "x + 100"),
        ("x + 2e+3", "x + 2000"),
        ("2.x", "2*x"),
        ("2.5x", "2.5*x"),
        ("2e3x", "2000*x"),
        ("x + 0.1", "x + 0.1"),
        ("x + 007", "x + 7"),
        ("x^0.5", "x^0.5"),
        ("x + 1e-30", "x + 1e-30"),
        ("x + 0.000000000000000000000000012", "x + 12e-27"),
    ]);
}

#[test]
fn regions_compare_and_combine() {
    check(&[
        ("x^2+y^2+z^2 <= 1 and z >= 0", "((((x^2) + (y^2)) + (z^2)) <= 1) and (z >= 0)"),
        ("x < 1 or y < 1 and z < 1", "(x < 1) or ((y < 1) and (z < 1))"),
        ("not x < 1 and y < 1", "(not (x < 1)) and (y < 1)"),
        ("not not x < 1", "not (not (x < 1))"),
        ("x < 1 or y < 1 or z < 1", "(x < 1) or (y < 1) or (z < 1)"),
        ("(x < 1 or y < 1) and z < 1", "((x < 1) or (y < 1)) and (z < 1)"),
        ("0 <= x < 1", "0 <= x < 1"),
        ("2 > x > y >= 1", "2 > x > y >= 1"),
        ("x + 1 < 2y", "(x + 1) < (2*y)"),
        ("union(x<1, y<1)", "union(x < 1, y < 1)"),
        ("difference(x<1, y<1, z<1)", "difference(x < 1, y < 1, z < 1)"),
        ("smooth_union(0.2, x<1, y<1)", "smooth_union(0.2, x < 1, y < 1)"),
        ("if(x < 0, -x, x)", "if(x < 0, -x, x)"),
        ("if(x<0 and y<0, 1, z)", "if((x < 0) and (y < 0), 1, z)"),
        ("A = x^2+y^2 <= 1; A and z < 1", "A = ((x^2) + (y^2)) <= 1; A and (z < 1)"),
    ]);
}

#[test]
fn vectors_lists_and_sums_are_read() {
    check(&[
        ("dot(v, p) = 1", "dot(v, p) = 1"),
        ("|p - (1,0,0)| = 1", "|p - (1, 0, 0)| = 1"),
        ("p.x + p.y", "p.x + p.y"),
        ("p.x^2", "p.x^2"),
        ("2p.x", "2*p.x"),
        ("(p - v).z", "(p - v).z"),
        ("cross(p, v).x", "cross(p, v).x"),
        ("sum(k = 1..3, sin(k x))", "sum(k = 1..3, sin(k*x))"),
        ("sum(j=1..n, x^j/j)", "sum(j = 1..n, (x^j)/j)"),
        ("product(j = 1..3, x - j)", "product(j = 1..3, x - j)"),
        ("sum(j = -2..2, j x)", "sum(j = (-2)..2, j*x)"),
        ("sum(j = 1..2n, j x)", "sum(j = 1..(2*n), j*x)"),
        ("sum(d in [(0,0,0),(1,0,0)], exp(-4*|p-d|^2))", "sum(d in [(0, 0, 0), (1, 0, 0)], exp((-4)*(|p - d|^2)))"),
        ("L = [1, 2]; sum(j in L, j x)", "L = [1, 2]; sum(j in L, j*x)"),
        ("2sum(j = 1..3, x)", "2*sum(j = 1..3, x)"),
        ("sum(j = 1..3, sum(i = 1..j, i x))", "sum(j = 1..3, sum(i = 1..j, i*x))"),
        ("d = (1,0,0); dot(d, p)", "d = (1, 0, 0); dot(d, p)"),
        ("(x, y, z).x", "(x, y, z).x"),
    ]);
}

#[test]
fn statements_are_told_apart() {
    check(&[
        ("S = 1.5; x = S", "S = 1.5; x = S"),
        ("h(u, v) = exp(-(u^2+v^2)); z = h(x,y)", "h(u, v) = exp(-((u^2) + (v^2))); z = h(x, y)"),
        ("x(y+1) = 2", "x*(y + 1) = 2"),
        ("x(y) = 2", "x*y = 2"),
        ("a(x) = 2", "a*x = 2"),
        ("sin(x) = 0", "sin(x) = 0"),
        ("e(x) = 2", "e*x = 2"),
        ("d = 0.5 in [0, 1]", "d = 0.5 in [0, 1]"),
        ("d = 0.5 in [0, 1] step 0.05", "d = 0.5 in [0, 1] step 0.05"),
        ("d = a/2 in [-1, 2a]; d x", "d = a/2 in [-1, 2*a]; d*x"),
        ("r = 1", "r = 1"),
        ("theta = 1", "theta = 1"),
        ("r = 1; x = r", "r = 1; x = r"),
        ("p = (1,2,3)", "p = (1, 2, 3)"),
        ("x = 1 { color: red }", "x = 1 { color: red }"),
        ("x = 1\n{ color: red }", "x = 1 { color: red }"),
        ("x = 1 { color: #4af, name: \"ball\" }", "x = 1 { color: #44aaff, name: \"ball\" }"),
        ("x = 1 { name: “ball” }", "x = 1 { name: \"ball\" }"),
        ("x = 1 {}", "x = 1"),
        ("x = 1 { clip: box(-2..2, -a..a, 0..1.5) }", "x = 1 { clip: box((-2)..2, (-a)..a, 0..1.5) }"),
        ("x = 1 { clip: ball(0,0,0,2), color: rgb(1,0,0), }", "x = 1 { clip: ball(0, 0, 0, 2), color: rgb(1, 0, 0) }"),
        ("x = 1 { clip: z > 0 and x < 1 }", "x = 1 { clip: (z > 0) and (x < 1) }"),
        ("material water { kind: glass, ior: 1.33 }", "material water { kind: glass, ior: 1.33 }"),
        ("light { at: (4,-3,5), color: white }", "light { at: (4, -3, 5), color: white }"),
        ("sun { from: (1,-1,2) }", "sun { from: (1, -1, 2) }"),
        ("sky { radiance: 1 }", "sky { radiance: 1 }"),
        ("camera {\n eye: (4,-3,2),\n fov: 40\n}", "camera { eye: (4, -3, 2), fov: 40 }"),
        ("render { size: 800x600, mode: studio }", "render { size: 800x600, mode: studio }"),
        ("include \"gold.imp\"", "include \"gold.imp\""),
        ("light = 3; x = light", "light = 3; x = light"),
        ("x = 1; y = 2\nz = 3", "x = 1; y = 2; z = 3"),
        ("x = 1 // a comment; y = 2\ny = 3", "x = 1; y = 3"),
        ("x = (1 +\n2)", "x = 1 + 2"),
        ("x =\n 1", "x = 1"),
        ("x +\n y", "x + y"),
        ("max(x,\n\n y)", "max(x, y)"),
        ("\n\n;;x\n;", "x"),
        ("x\r\ny\r\n", "x; y"),
        ("x < 1 and\n y < 1", "(x < 1) and (y < 1)"),
    ]);
}

#[test]
fn long_and_flat_is_not_deep() {
    let text = format!("x{} = {}x", "+1".repeat(100_000), "2".repeat(3) + &"*y".repeat(50_000) + "*");
    assert!(errors(&read(&text)).is_empty());
}

#[test]
fn names_of_one_text_are_known_in_the_others() {
    use crate::diag::SourceId;
    let parsed = super::parse(&[(SourceId(0), "f(x) + ab"), (SourceId(1), "f(u) = u^2; a = 1; b = 2")]);
    assert!(errors(&parsed).is_empty());
    assert_eq!(readings(&parsed)[0], "f(x) + (a*b)");
    assert_eq!(parsed.program.statements[1].span.source, SourceId(1));
}

#[test]
fn included_files_are_listed_with_their_places() {
    let found = crate::syntax::includes(crate::diag::SourceId(0), "x = 1\ninclude \"a/b.imp\"\n");
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].0.as_str(), found[0].1.range()), ("a/b.imp", 14..23));
}
