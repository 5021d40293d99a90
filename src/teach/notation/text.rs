//! A form in the program's own language: what is printed can be typed.
//!
//! In: a form. Out: text of one line. Only a derivative that is still to be taken has no place in the language: it is
//! written `d/dx(...)`.

use super::{Binding, Form, Sign};

/// The form as text.
pub fn write(form: &Form) -> String {
    match form {
        Form::Number(text) | Form::Name(text) => text.clone(),
        Form::Word(text) => format!(" {text} "),
        Form::Sign(sign) => sign_text(*sign).to_owned(),
        Form::Row(binding, list) => row(*binding, list),
        Form::Fraction(a, b) => format!("{}/{}", within(a, Binding::Product), within(b, Binding::Power)),
        Form::Raised(a, b) => format!("{}^{}", within(a, Binding::Atom), within(b, Binding::Atom)),
        Form::Lowered(a, b) => format!("{}_{}", write(a), write(b)),
        Form::Root(None, a) => format!("sqrt({})", write(a)),
        Form::Root(Some(3), a) => format!("cbrt({})", write(a)),
        Form::Root(Some(n), a) => format!("root({n}, {})", write(a)),
        Form::Bars(a) => format!("abs({})", write(a)),
        Form::Floor(a) => format!("floor({})", write(a)),
        Form::Brackets(a) => format!("({})", write(a)),
        Form::Call(name, list) => format!("{name}({})", list.iter().map(write).collect::<Vec<String>>().join(", ")),
        Form::Cases(parts) => {
            let [c, a, b] = &**parts;
            format!("if({} <= 0, {}, {})", write(c), write(a), write(b))
        }
        Form::Derivative(v, a) => format!("d/d{v}({})", write(a)),
    }
}

/// Factors behind the first: a fraction there stands in brackets, so that it is read as it is set.
fn row(binding: Binding, list: &[Form]) -> String {
    let mut text = String::new();
    for (i, part) in list.iter().enumerate() {
        let is_late_fraction = binding == Binding::Product && i > 0 && matches!(part, Form::Fraction(..));
        text += &if is_late_fraction { format!("({})", write(part)) } else { write(part) };
    }
    text
}

fn within(form: &Form, least: Binding) -> String {
    if form.binding() < least { format!("({})", write(form)) } else { write(form) }
}

fn sign_text(sign: Sign) -> &'static str {
    match sign {
        Sign::Equal => " = ",
        Sign::Plus => " + ",
        Sign::Minus => " - ",
        Sign::Negative => "-",
        Sign::Times => "*",
        Sign::AtMost => " <= ",
        Sign::AtLeast => " >= ",
        Sign::Less => " < ",
        Sign::Greater => " > ",
        Sign::Comma => ", ",
    }
}
