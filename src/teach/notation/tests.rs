//! What is set reads back: text as the same formula, MathML as well-formed elements with the right number of children.

use super::*;
use crate::closure::Formula;
use crate::expr::formula::typed;
use crate::num::level::Simd;
use crate::teach::chance::Points;
use crate::teach::classify::COORDINATES;
use crate::teach::derivation::derive;

const FORMULAS: [&str; 14] = [
    "x^2+y^2+z^2-1",
    "(x^2+y^2+z^2+0.84)^2-4*(x^2+y^2)",
    "z-sin(x)*cos(y)",
    "(x+y)/(x-y)/(z+3)",
    "(x/y)^3 - (-x)^2*z",
    "1/(x/y) - x*(y/z)",
    "exp(-(x^2+y^2))-z",
    "sqrt(x^2+1)*cbrt(y)-root(5, z)",
    "abs(x)+floor(y)+min(x, y, z)-max(x, 1)",
    "if(x <= y, sin(z), cos(z)) + atan2(y, x)",
    "asinh(x)*acosh(y+4)-atanh(z/3)+erf(x)",
    "log2(x^2+1)-log10(y^2+2)+ln(z^2+3)",
    "2^x*x^(y/2)-z",
    "pi*x/3 - 5/7*y + e^z",
];

#[test]
fn text_reads_back_with_the_same_values() {
    for program in FORMULAS {
        let (mut graph, f) = typed(program);
        let shown = text::write(&Form::of(&Term::of(&graph, f).unwrap()));
        let (mut again, g) = typed(&shown);
        let (f, g) = (Formula::new(&mut graph, f, Simd::best()), Formula::new(&mut again, g, Simd::best()));
        for point in Points::new().take(20) {
            let (a, b) = (f.value(point), g.value(point));
            assert!(
                (a - b).abs() <= 1e-12 * (1.0 + a.abs()) || a.is_nan() && b.is_nan(),
                "{program} as {shown}: {a} {b}"
            );
        }
    }
}

/// All forms of a formula: its reading, itself, all lines of its derivations.
fn forms(program: &str) -> Vec<Form> {
    let (graph, f) = typed(program);
    let term = Term::of(&graph, f).unwrap();
    let read = crate::syntax::parse(&[(crate::diag::SourceId(0), program)]).program.statements;
    let mut all: Vec<Form> = read.iter().map(reading::statement).collect();
    all.push(Form::of(&term));
    for v in COORDINATES {
        all.extend(derive(&term, v).unwrap().lines.iter().map(|line| Form::of(&line.term)));
    }
    all
}

/// How many children an element of presentation MathML takes (MathML Core, section 3); none: letters alone.
fn children(name: &str) -> Option<std::ops::RangeInclusive<usize>> {
    match name {
        "mi" | "mn" | "mo" | "mtext" => Some(0..=0),
        "mfrac" | "msup" | "msub" | "mroot" => Some(2..=2),
        "math" | "mrow" | "msqrt" | "mtd" => Some(1..=usize::MAX),
        "mtable" | "mtr" => Some(1..=usize::MAX),
        _ => None,
    }
}

/// What is wrong with an element, if anything.
pub(crate) fn fault(markup: &str) -> Option<String> {
    // The open elements: name, children so far, whether letters were seen.
    let mut open: Vec<(String, usize, bool)> = vec![("root".into(), 0, false)];
    let mut rest = markup;
    while let Some(at) = rest.find('<') {
        let letters = &rest[..at];
        let top = open.last_mut()?;
        if !letters.is_empty() {
            if letters.contains(['>', '"'])
                || letters.replace("&amp;", "").replace("&lt;", "").replace("&gt;", "").contains('&')
            {
                return Some(format!("letters not escaped: {letters}"));
            }
            top.2 = true;
        }
        let Some(end) = rest.find('>') else { return Some("a tag without end".into()) };
        let tag = &rest[at + 1..end];
        rest = &rest[end + 1..];
        match tag.strip_prefix('/') {
            Some(name) => {
                let (opened, count, letters) = open.pop()?;
                if opened != name {
                    return Some(format!("<{opened}> ends as </{name}>"));
                }
                let Some(allowed) = children(name) else { return Some(format!("there is no element {name}")) };
                if !allowed.contains(&count) {
                    return Some(format!("{name} with {count} children"));
                }
                if letters != (allowed == (0..=0)) {
                    return Some(format!("{name} with letters: {letters}"));
                }
            }
            None => {
                let name = tag.split(' ').next()?;
                let (parent, count, _) = open.last_mut()?;
                *count += 1;
                let is_placed = match name {
                    "mtr" => parent == "mtable",
                    "mtd" => parent == "mtr",
                    "math" => parent == "root",
                    _ => !matches!(parent.as_str(), "mtable" | "mtr" | "root"),
                };
                if !is_placed {
                    return Some(format!("{name} inside {parent}"));
                }
                open.push((name.to_owned(), 0, false));
            }
        }
    }
    (open.len() != 1 || !rest.is_empty() || open[0].1 != 1).then(|| "not one whole element".into())
}

#[test]
fn mathml_is_well_formed_and_every_element_has_its_children() {
    let mut count = 0;
    for program in FORMULAS {
        for form in forms(program) {
            let markup = mathml::write(&form, false);
            assert_eq!(fault(&markup), None, "{program}: {markup}");
            count += 1;
        }
    }
    assert!(count > 200, "{count}");
}

#[test]
fn the_checker_finds_faults() {
    let rows = [
        "<math><mfrac><mi>x</mi></mfrac></math>",
        "<math><mi>x</mo></math>",
        "<math><mi>x</mi>",
        "<math><mi>a<b</mi></math>",
        "<math>x</math>",
        "<math><mi></mi></math>",
        "<math><div><mi>x</mi></div></math>",
        "<math><mtd><mi>x</mi></mtd></math>",
        "<mi>x</mi>",
    ];
    for row in rows {
        assert!(fault(row).is_some(), "{row}");
    }
}

#[test]
fn braces_and_environments_of_latex_are_balanced() {
    for program in FORMULAS {
        for form in forms(program) {
            let set = latex::write(&form);
            let count = |what: &str| set.matches(what).count();
            assert_eq!(count("{"), count("}"), "{set}");
            assert_eq!(count("\\left"), count("\\right"), "{set}");
            assert_eq!(count("\\begin"), count("\\end"), "{set}");
        }
    }
}

#[test]
fn what_is_read_is_fully_bracketed() {
    let rows = [
        ("1/2x = y", "(1/2)*x = y"),
        ("x + y - z", "(x + y) - z"),
        ("-x^2 = sin x cos y", "-(x^2) = sin(x)*cos(y)"),
        ("2 x y = z", "(2*x)*y = z"),
        ("f(u) = u^2; f(x) = 1", "f(u) = u^2"),
        ("x^2 <= 1 and not y >= z", "(x^2 <= 1) and  (not  (y >= z))"),
    ];
    for (program, expected) in rows {
        let read = crate::syntax::parse(&[(crate::diag::SourceId(0), program)]).program.statements;
        let shown = text::write(&reading::statement(&read[0]));
        let plain = |text: &str| text.split_whitespace().collect::<Vec<&str>>().join(" ").replace("( ", "(");
        assert_eq!(plain(&shown), plain(expected));
    }
}
