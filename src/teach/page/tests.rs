//! One small page in every form.

use super::*;
use crate::teach::notation::Sign;

fn page() -> Page {
    let mut page = Page::new("A & <B>");
    page.heading("First_1");
    page.say("It is 50 % of 2 π > 6 | and more");
    page.formula(Form::equation(
        Form::name("f"),
        Form::Fraction(Box::new(Form::Number("1".into())), Box::new(Form::name("x"))),
    ));
    page.table(&["t", "g_1"], vec![vec!["1".into(), "<2>".into()]]);
    page.blocks.push(Block::Figure { svg: "<svg></svg>".into(), drawing: "+--".into(), caption: "a figure".into() });
    page.blocks.push(Block::Picture { png: vec![1, 2, 3], caption: "a \"picture\"".into() });
    page.blocks.push(Block::Code("implicit 'x' # <b>".into()));
    page
}

#[test]
fn every_form_says_everything_and_escapes_it() {
    let rows: [(String, &[&str]); 4] = [
        (
            plain::write(&page()),
            &["A & <B>", "First_1\n-------", "  f = 1/x", "  t  g_1", "  1  <2>", "+--", "[a \"picture\"]"],
        ),
        (
            markdown::write(&page()),
            &["# A & \\<B\\>", "$$ f = \\frac{1}{x} $$", "| 1 | \\<2\\> |", "data:image/png;base64,AQID"],
        ),
        (
            latex::write(&page()),
            &["A \\& \\textless{}B\\textgreater{}", "First\\_1", "50 \\% of 2 $\\pi$", "\\begin{verbatim}\n+--"],
        ),
        (
            html::document(&page(), "en", ""),
            &[
                "<h1>A &amp; &lt;B&gt;</h1>",
                "<mfrac><mn>1</mn><mi>x</mi></mfrac>",
                "<td>&lt;2&gt;</td>",
                "alt=\"a &quot;picture&quot;\"",
                "&lt;b&gt;",
            ],
        ),
    ];
    for (text, parts) in rows {
        for part in parts {
            assert!(text.contains(part), "{part} is not in\n{text}");
        }
    }
}

#[test]
fn numbers_are_short_and_right() {
    let rows = [
        (0.0, "0"),
        (1.0, "1"),
        (-2.5, "-2.5"),
        (1.0 / 3.0, "0.333333"),
        (123_456.7, "123457"),
        (1e-5, "1e-5"),
        (1.234_567_89e-10, "1.23457e-10"),
        (2e12, "2e12"),
        (f64::NAN, "nan"),
        (f64::INFINITY, "inf"),
        (0.1 + 0.2, "0.3"),
        (99.9999999, "100"),
        (0.000_123_4, "0.0001234"),
    ];
    for (value, expected) in rows {
        assert_eq!(shown(value), expected);
    }
}

#[test]
fn a_form_of_signs_alone_can_be_set() {
    assert_eq!(crate::teach::notation::text::write(&Form::Sign(Sign::AtMost)), " <= ");
}
