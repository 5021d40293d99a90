//! Random trees print as text that reads back as the same tree, and so does every row of every table.

use super::{errors, read};
use crate::diag::Span;
use crate::num::rational::Rational;
use crate::syntax::ast::*;
use crate::syntax::print;
use proptest::prelude::*;

fn expr(kind: ExprKind) -> Expr {
    Expr { kind, span: Span::default() }
}

fn name(text: &str) -> Name {
    Name { text: text.to_owned(), span: Span::default() }
}

fn leaf() -> impl Strategy<Value = Expr> {
    let names = prop::sample::select(vec!["x", "y", "z", "pi", "e", "a", "radius", "theta", "p", "α"]);
    prop_oneof![
        names.prop_map(|text| expr(ExprKind::Name(text.to_owned()))),
        (0i64..1000, 0u32..40).prop_map(|(n, places)| {
            let text = format!("{n}e-{places}");
            expr(ExprKind::Number(Rational::from_decimal(&text).expect("a decimal")))
        }),
    ]
}

fn compound(inner: impl Strategy<Value = Expr> + Clone + 'static) -> impl Strategy<Value = Expr> {
    let boxed = inner.clone().prop_map(Box::new);
    let list = |least, most| prop::collection::vec(inner.clone(), least..=most);
    let operator = prop::sample::select(vec![UnaryOp::Neg, UnaryOp::Plus, UnaryOp::Not]);
    let factor = prop::sample::select(vec![FactorOp::Mul, FactorOp::Div, FactorOp::Mod]);
    let function = prop::sample::select(vec!["sin", "max", "f", "union", "if", "sqrt"]);
    prop_oneof![
        (operator, boxed.clone()).prop_map(|(op, a)| expr(ExprKind::Unary(op, a))),
        prop::collection::vec((any::<bool>(), inner.clone()), 2..4).prop_map(|terms| {
            let term = |(i, (minus, value)): (usize, (bool, Expr))| Term { minus: minus && i > 0, value };
            expr(ExprKind::Sum(terms.into_iter().enumerate().map(term).collect()))
        }),
        prop::collection::vec((factor, inner.clone()), 2..4).prop_map(|factors| {
            let factor = |(i, (operator, value)): (usize, (FactorOp, Expr))| Factor {
                operator: if i == 0 { FactorOp::Mul } else { operator },
                value,
            };
            expr(ExprKind::Product(factors.into_iter().enumerate().map(factor).collect()))
        }),
        (boxed.clone(), boxed.clone()).prop_map(|(a, b)| expr(ExprKind::Power(a, b))),
        list(2, 3).prop_map(|list| expr(ExprKind::And(list))),
        list(2, 3).prop_map(|list| expr(ExprKind::Or(list))),
        (list(2, 3), any::<bool>()).prop_map(|(list, rising)| {
            let sign = if rising { Comparison::LessEqual } else { Comparison::Greater };
            let signs = vec![sign; list.len() - 1];
            expr(ExprKind::Chain(list, signs))
        }),
        boxed.clone().prop_map(|a| expr(ExprKind::Bars(a))),
        (function, list(1, 3)).prop_map(|(text, list)| expr(ExprKind::Call(name(text), list))),
        list(2, 3).prop_map(|list| expr(ExprKind::Vector(list))),
        list(0, 3).prop_map(|list| expr(ExprKind::List(list))),
        boxed.clone().prop_map(|a| expr(ExprKind::Component(a, name("y")))),
        (any::<bool>(), boxed.clone(), boxed.clone(), boxed.clone()).prop_map(|(product, a, b, body)| {
            let over = SeriesRange::Integers(a, b);
            expr(ExprKind::Series { product, variable: name("k"), over, body })
        }),
        (boxed.clone(), boxed).prop_map(|(a, body)| {
            let over = SeriesRange::List(a);
            expr(ExprKind::Series { product: false, variable: name("k"), over, body })
        }),
    ]
}

/// The tree without places: printed with all brackets, two trees are equal if their texts are.
fn shape(value: &Expr) -> String {
    let text = format!("{value:?}");
    let mut out = String::new();
    let mut rest = text.as_str();
    while let Some(at) = rest.find("span: Span {") {
        out.push_str(&rest[..at]);
        let close = rest[at..].find('}').expect("a span ends");
        rest = &rest[at + close + 1..];
    }
    out + rest
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn a_printed_tree_reads_back(tree in leaf().prop_recursive(5, 40, 3, compound)) {
        let text = print::expression(&tree);
        let again = value_of(&text);
        prop_assert_eq!(again.as_ref().map(shape), Some(shape(&tree)), "{}", text);
        let full = print::bracketed(&tree);
        prop_assert_eq!(value_of(&full).as_ref().map(print::bracketed), Some(full));
    }
}

/// What a text reads as in a program that knows the names used above.
fn value_of(text: &str) -> Option<Expr> {
    let parsed = read(&format!("a = 1; radius = 2; α = 3; f(u) = u; dot({text}, x)"));
    assert!(errors(&parsed).is_empty(), "{text}: {:?}", parsed.diagnostics);
    match parsed.program.statements.into_iter().next_back()?.kind {
        StatementKind::Surface { left: Expr { kind: ExprKind::Call(_, list), .. }, .. } => list.into_iter().next(),
        _ => None,
    }
}

#[test]
fn printed_statements_read_back() {
    let texts = [
        "x^2 + y^2 = 1 { color: #4af, clip: box(-2..2, -a..a, 0..1), name: \"ball\", size: 3x4 }\na = 1",
        "f(u, v) = u*v\nz = f(x, y)",
        "a = 0.5 in [0, 1] step 0.05\nx = a",
        "material gold { kind: metal, tint: rgb(1, 0.8, 0.3) }\nlight { at: (1, 2, 3) }\nsun {}\nsky { radiance: 1 }",
        "z = x { color: checker(0.5, white, mix(#fff, rgb(nx, xy, 0), gauss/2)), lines: every(1, z, 0.1), cap: true }",
        "material m { color: palette(\"viridis\", mean*x, -1, 1), roughness: xy }",
        "camera { eye: (4, -3, 2) }\nrender { size: 800x600 }\ninclude \"a.imp\"",
    ];
    for text in texts {
        let first = read(text);
        assert!(errors(&first).is_empty(), "{text}: {:?}", first.diagnostics);
        let printed = print::program(&first.program);
        assert_eq!(print::program(&read(&printed).program), printed);
    }
}
