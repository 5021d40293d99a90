//! A form in LaTeX, for mathematics mode with the package amsmath.
//!
//! In: a form. Out: LaTeX.

use super::{Form, Sign};

/// The form in LaTeX.
pub fn write(form: &Form) -> String {
    match form {
        Form::Number(text) => text.clone(),
        Form::Name(name) => named(name),
        Form::Word(word) => format!("\\text{{ {} }}", escaped(word)),
        Form::Sign(sign) => sign_text(*sign).to_owned(),
        Form::Row(_, list) => row(list),
        Form::Fraction(a, b) => format!("\\frac{{{}}}{{{}}}", write(a), write(b)),
        // A power of a fraction or of a power would be read otherwise without braces around its base.
        Form::Raised(a, b) => format!("{{{}}}^{{{}}}", write(a), write(b)),
        Form::Lowered(a, b) => format!("{{{}}}_{{{}}}", write(a), write(b)),
        Form::Root(None, a) => format!("\\sqrt{{{}}}", write(a)),
        Form::Root(Some(n), a) => format!("\\sqrt[{n}]{{{}}}", write(a)),
        Form::Bars(a) => format!("\\left|{}\\right|", write(a)),
        Form::Floor(a) => format!("\\left\\lfloor {}\\right\\rfloor ", write(a)),
        Form::Brackets(a) => format!("\\left({}\\right)", write(a)),
        Form::Call(name, list) => match (name.as_str(), &list[..]) {
            ("exp", [a]) => format!("e^{{{}}}", write(a)),
            ("sqrt", [a]) => format!("\\sqrt{{{}}}", write(a)),
            ("", list) => format!("\\left({}\\right)", listed(list)),
            (name, list) => format!("{}\\left({}\\right)", function(name), listed(list)),
        },
        Form::Cases(parts) => {
            let [c, a, b] = &**parts;
            format!(
                "\\begin{{cases}}{} & {} \\le 0\\\\{} & {} > 0\\end{{cases}}",
                write(a),
                write(c),
                write(b),
                write(c)
            )
        }
        Form::Derivative(v, a) => format!("\\frac{{\\partial}}{{\\partial {v}}}\\left({}\\right)", write(a)),
    }
}

fn listed(list: &[Form]) -> String {
    list.iter().map(write).collect::<Vec<String>>().join(", ")
}

/// Factors side by side; a dot before a number.
fn row(list: &[Form]) -> String {
    let mut text = String::new();
    for (i, part) in list.iter().enumerate() {
        text += &match part {
            Form::Sign(Sign::Times) if list.get(i + 1).is_some_and(starts_with_digit) => " \\cdot ".to_owned(),
            other => write(other),
        };
    }
    text
}

/// Whether the first thing set is a digit.
pub(super) fn starts_with_digit(form: &Form) -> bool {
    match form {
        Form::Number(_) => true,
        Form::Raised(a, _) => starts_with_digit(a),
        Form::Row(_, list) => list.first().is_some_and(starts_with_digit),
        _ => false,
    }
}

fn named(name: &str) -> String {
    let greek = ["pi", "tau", "theta", "rho", "phi"];
    match name {
        name if greek.contains(&name) => format!("\\{name} "),
        name if name.chars().count() == 1 => escaped(name),
        name => format!("\\mathrm{{{}}}", escaped(name)),
    }
}

/// The name of a function of the language.
fn function(name: &str) -> String {
    match name {
        "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" | "ln" | "min" | "max" => format!("\\{name}"),
        "asin" | "acos" | "atan" => format!("\\arc{}", &name[1..]),
        "log2" => "\\log_{2}".into(),
        "log10" => "\\log_{10}".into(),
        "sign" => "\\operatorname{sgn}".into(),
        "asinh" | "acosh" | "atanh" => format!("\\operatorname{{ar{}}}", &name[1..]),
        other => format!("\\operatorname{{{}}}", escaped(other)),
    }
}

fn sign_text(sign: Sign) -> &'static str {
    match sign {
        Sign::Equal => " = ",
        Sign::Plus => " + ",
        Sign::Minus => " - ",
        Sign::Negative => "-",
        Sign::Times => "\\,",
        Sign::AtMost => " \\le ",
        Sign::AtLeast => " \\ge ",
        Sign::Less => " < ",
        Sign::Greater => " > ",
        Sign::Comma => ",\\; ",
    }
}

/// Words in LaTeX: what means something there, and the signs that its usual fonts lack, are written out.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => out += "\\textbackslash{}",
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => {
                out.push('\\');
                out.push(c);
            }
            '^' => out += "\\textasciicircum{}",
            '~' => out += "\\textasciitilde{}",
            '<' => out += "\\textless{}",
            '>' => out += "\\textgreater{}",
            '|' => out += "\\textbar{}",
            '·' => out += "$\\cdot$",
            '−' => out += "$-$",
            '≤' => out += "$\\le$",
            '≥' => out += "$\\ge$",
            '≠' => out += "$\\ne$",
            'π' => out += "$\\pi$",
            'θ' => out += "$\\theta$",
            'ρ' => out += "$\\rho$",
            'φ' => out += "$\\varphi$",
            '√' => out += "$\\surd$",
            '²' => out += "$^2$",
            '³' => out += "$^3$",
            '°' => out += "$^\\circ$",
            '→' => out += "$\\to$",
            '×' => out += "$\\times$",
            '±' => out += "$\\pm$",
            '∞' => out += "$\\infty$",
            '≈' => out += "$\\approx$",
            c if c.is_ascii() || ('\u{a0}'..'\u{180}').contains(&c) || "–—“”‘’…„".contains(c) => {
                out.push(c)
            }
            _ => out.push('?'),
        }
    }
    out
}
