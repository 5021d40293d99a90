//! A form in MathML Core, as browsers show it.
//!
//! In: a form. Out: an element `math` with presentation markup (<https://www.w3.org/TR/mathml-core/>).

use super::latex::starts_with_digit;
use super::{Form, Sign};
use crate::teach::svg::escaped;

/// The form as a whole element; `is_block` sets it on a line of its own.
pub fn write(form: &Form, is_block: bool) -> String {
    let display = if is_block { " display=\"block\"" } else { "" };
    format!("<math xmlns=\"http://www.w3.org/1998/Math/MathML\"{display}>{}</math>", inner(form))
}

fn inner(form: &Form) -> String {
    match form {
        Form::Number(text) => format!("<mn>{}</mn>", escaped(text)),
        Form::Name(name) => format!("<mi>{}</mi>", escaped(&named(name))),
        Form::Word(word) => format!("<mtext>\u{a0}{}\u{a0}</mtext>", escaped(word)),
        Form::Sign(sign) => operator(sign_text(*sign)),
        Form::Row(_, list) => row(list),
        Form::Fraction(a, b) => format!("<mfrac>{}{}</mfrac>", inner(a), inner(b)),
        Form::Raised(a, b) => format!("<msup>{}{}</msup>", inner(a), inner(b)),
        Form::Lowered(a, b) => format!("<msub>{}{}</msub>", inner(a), inner(b)),
        Form::Root(None, a) => format!("<msqrt>{}</msqrt>", inner(a)),
        Form::Root(Some(n), a) => format!("<mroot>{}<mn>{n}</mn></mroot>", inner(a)),
        Form::Bars(a) => fenced("|", &inner(a), "|"),
        Form::Floor(a) => fenced("\u{230a}", &inner(a), "\u{230b}"),
        Form::Brackets(a) => fenced("(", &inner(a), ")"),
        Form::Call(name, list) => match (name.as_str(), &list[..]) {
            ("exp", [a]) => format!("<msup><mi>e</mi>{}</msup>", inner(a)),
            ("sqrt", [a]) => format!("<msqrt>{}</msqrt>", inner(a)),
            ("", list) => fenced("(", &listed(list), ")"),
            (name, list) => {
                let arguments = fenced("(", &listed(list), ")");
                format!("<mrow><mi>{}</mi><mo>\u{2061}</mo>{arguments}</mrow>", escaped(name))
            }
        },
        Form::Cases(parts) => cases(parts),
        Form::Derivative(v, a) => {
            let below = format!("<mrow><mo>\u{2202}</mo><mi>{v}</mi></mrow>");
            format!("<mrow><mfrac><mo>\u{2202}</mo>{below}</mfrac>{}</mrow>", fenced("(", &inner(a), ")"))
        }
    }
}

fn cases([c, a, b]: &[Form; 3]) -> String {
    let line = |value: &Form, sign: &str| {
        let condition = format!("<mrow>{}<mo>{sign}</mo><mn>0</mn></mrow>", inner(c));
        format!("<mtr><mtd>{}</mtd><mtd>{condition}</mtd></mtr>", inner(value))
    };
    let table = format!("<mtable>{}{}</mtable>", line(a, "\u{2264}"), line(b, "&gt;"));
    format!("<mrow><mo stretchy=\"true\">{{</mo>{table}</mrow>")
}

fn listed(list: &[Form]) -> String {
    list.iter().map(inner).collect::<Vec<String>>().join("<mo>,</mo>")
}

fn fenced(open: &str, inside: &str, close: &str) -> String {
    format!("<mrow>{}<mrow>{inside}</mrow>{}</mrow>", operator(open), operator(close))
}

fn row(list: &[Form]) -> String {
    let mut text = String::from("<mrow>");
    for (i, part) in list.iter().enumerate() {
        text += &match part {
            Form::Sign(Sign::Times) if list.get(i + 1).is_some_and(starts_with_digit) => operator("\u{b7}"),
            other => inner(other),
        };
    }
    text + "</mrow>"
}

fn operator(sign: &str) -> String {
    format!("<mo>{}</mo>", escaped(sign))
}

fn named(name: &str) -> String {
    match name {
        "pi" => "π".into(),
        "tau" => "τ".into(),
        "theta" => "θ".into(),
        "rho" => "ρ".into(),
        "phi" => "φ".into(),
        other => other.to_owned(),
    }
}

fn sign_text(sign: Sign) -> &'static str {
    match sign {
        Sign::Equal => "=",
        Sign::Plus => "+",
        Sign::Minus | Sign::Negative => "\u{2212}",
        Sign::Times => "\u{2062}",
        Sign::AtMost => "\u{2264}",
        Sign::AtLeast => "\u{2265}",
        Sign::Less => "<",
        Sign::Greater => ">",
        Sign::Comma => ",",
    }
}
