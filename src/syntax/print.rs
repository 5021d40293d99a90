//! Tree → text: a program that reads back as the same tree.
//!
//! In: a tree. Out: its text, either with no more brackets than needed, or with all of them, so that
//! no rule of precedence is left to know. Separate because `explain` and tests print and nothing else does.

use super::ast::{
    Attribute, AttributeValue, BlockKind, Comparison, Expr, ExprKind, Factor, FactorOp, Program, SeriesRange,
    Statement, StatementKind, Term, UnaryOp,
};
use crate::num::rational::{MAX_EXPONENT, Rational};
use num_bigint::BigInt;
use num_traits::{One, Pow, Zero};

/// A program, one statement a line.
///
/// ```
/// use implicit::{diag::SourceId, syntax};
/// let parsed = syntax::parse(&[(SourceId(0), "1/2x + sin y = |z|")]);
/// assert_eq!(syntax::print::program(&parsed.program), "1/2*x + sin(y) = |z|\n");
/// ```
pub fn program(program: &Program) -> String {
    let lines = program.statements.iter().map(|statement| self::statement(statement, Brackets::Needed) + "\n");
    lines.collect()
}

/// An expression with no more brackets than needed.
pub fn expression(value: &Expr) -> String {
    write(value, Brackets::Needed)
}

/// An expression with brackets around all that is not a name, a number or a call: how it was read.
pub fn bracketed(value: &Expr) -> String {
    write(value, Brackets::All)
}

/// A statement with all brackets.
pub fn bracketed_statement(value: &Statement) -> String {
    statement(value, Brackets::All)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Brackets {
    Needed,
    All,
}

/// How tightly an expression holds together, from `or` to what never needs brackets.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Or,
    And,
    Not,
    Chain,
    Sum,
    Product,
    Unary,
    Power,
    Atom,
}

fn binding(value: &Expr) -> Binding {
    match &value.kind {
        ExprKind::Or(_) => Binding::Or,
        ExprKind::And(_) => Binding::And,
        ExprKind::Unary(UnaryOp::Not, _) => Binding::Not,
        ExprKind::Chain(..) => Binding::Chain,
        ExprKind::Sum(_) => Binding::Sum,
        ExprKind::Product(_) => Binding::Product,
        ExprKind::Unary(UnaryOp::Neg | UnaryOp::Plus, _) => Binding::Unary,
        ExprKind::Power(..) => Binding::Power,
        ExprKind::Number(value) if value.is_negative() || decimal(value).is_none() => Binding::Product,
        ExprKind::Number(_)
        | ExprKind::Name(_)
        | ExprKind::Bars(_)
        | ExprKind::Call(..)
        | ExprKind::Vector(_)
        | ExprKind::List(_)
        | ExprKind::Component(..)
        | ExprKind::Series { .. }
        | ExprKind::Invalid => Binding::Atom,
    }
}

/// An operand, in brackets if it holds together less tightly than `least`.
fn operand(value: &Expr, least: Binding, brackets: Brackets) -> String {
    let text = write(value, brackets);
    let found = binding(value);
    let all = brackets == Brackets::All && found != Binding::Atom;
    if found < least || all { format!("({text})") } else { text }
}

fn write(value: &Expr, brackets: Brackets) -> String {
    let inside = |value: &Expr| write(value, brackets);
    match &value.kind {
        ExprKind::Number(value) => number(value),
        ExprKind::Name(name) => name.clone(),
        ExprKind::Unary(UnaryOp::Not, a) => format!("not {}", operand(a, Binding::Not, brackets)),
        ExprKind::Unary(UnaryOp::Neg, a) => format!("-{}", operand(a, Binding::Unary, brackets)),
        ExprKind::Unary(UnaryOp::Plus, a) => format!("+{}", operand(a, Binding::Unary, brackets)),
        ExprKind::Sum(terms) => sum(terms, brackets),
        ExprKind::Product(factors) => product(factors, brackets),
        ExprKind::Power(a, b) => {
            format!("{}^{}", operand(a, Binding::Atom, brackets), operand(b, Binding::Unary, brackets))
        }
        ExprKind::And(list) => joined(list, " and ", Binding::Not, brackets),
        ExprKind::Or(list) => joined(list, " or ", Binding::And, brackets),
        ExprKind::Chain(list, signs) => chain(list, signs, brackets),
        ExprKind::Bars(a) => format!("|{}|", inside(a)),
        ExprKind::Call(name, list) => format!("{}({})", name.text, items(list, brackets)),
        ExprKind::Vector(list) => format!("({})", items(list, brackets)),
        ExprKind::List(list) => format!("[{}]", items(list, brackets)),
        ExprKind::Component(a, name) => component(a, &name.text, brackets),
        ExprKind::Series { product, variable, over, body } => {
            let word = if *product { "product" } else { "sum" };
            let over = match over {
                SeriesRange::Integers(a, b) => format!("= {}", range(a, b, brackets)),
                SeriesRange::List(list) => format!("in {}", inside(list)),
            };
            format!("{word}({} {over}, {})", variable.text, inside(body))
        }
        ExprKind::Invalid => "?".to_owned(),
    }
}

fn component(value: &Expr, name: &str, brackets: Brackets) -> String {
    let text = operand(value, Binding::Atom, brackets);
    // `2.x` would be the number `2.` before x.
    if matches!(value.kind, ExprKind::Number(_)) { format!("({text}).{name}") } else { format!("{text}.{name}") }
}

fn items(list: &[Expr], brackets: Brackets) -> String {
    list.iter().map(|item| write(item, brackets)).collect::<Vec<_>>().join(", ")
}

fn joined(list: &[Expr], word: &str, least: Binding, brackets: Brackets) -> String {
    list.iter().map(|item| operand(item, least, brackets)).collect::<Vec<_>>().join(word)
}

fn chain(list: &[Expr], signs: &[Comparison], brackets: Brackets) -> String {
    let mut text = String::new();
    for (i, item) in list.iter().enumerate() {
        text.push_str(&operand(item, Binding::Sum, brackets));
        text.push_str(match signs.get(i) {
            Some(Comparison::Less) => " < ",
            Some(Comparison::LessEqual) => " <= ",
            Some(Comparison::Greater) => " > ",
            Some(Comparison::GreaterEqual) => " >= ",
            None => "",
        });
    }
    text
}

/// A sum; with all brackets, around each two terms from the left.
fn sum(terms: &[Term], brackets: Brackets) -> String {
    let mut text = String::new();
    for (i, term) in terms.iter().enumerate() {
        if i > 1 && brackets == Brackets::All {
            text = format!("({text})");
        }
        text.push_str(match (i, term.minus) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        });
        text.push_str(&operand(&term.value, Binding::Product, brackets));
    }
    text
}

/// A product; with all brackets, around each two factors from the left.
fn product(factors: &[Factor], brackets: Brackets) -> String {
    let mut text = String::new();
    for (i, factor) in factors.iter().enumerate() {
        if i > 1 && brackets == Brackets::All {
            text = format!("({text})");
        }
        text.push_str(match (i, factor.operator) {
            (0, _) => "",
            (_, FactorOp::Mul) => "*",
            (_, FactorOp::Div) => "/",
            (_, FactorOp::Mod) => "%",
        });
        text.push_str(&operand(&factor.value, Binding::Unary, brackets));
    }
    text
}

fn range(a: &Expr, b: &Expr, brackets: Brackets) -> String {
    // A dot at the end of a number would join the two of the range.
    format!("{}..{}", operand(a, Binding::Sum, brackets), operand(b, Binding::Sum, brackets))
}

/// A number as a decimal, or as a fraction if it is none.
fn number(value: &Rational) -> String {
    let sign = if value.is_negative() { "-" } else { "" };
    let magnitude = value.absolute();
    match decimal(&magnitude) {
        Some(text) => format!("{sign}{text}"),
        None => format!("{sign}{}/{}", magnitude.numerator(), magnitude.denominator()),
    }
}

/// Numbers with more digits behind the point get an exponent: longer ones nobody counts.
const MAX_PLAIN: usize = 20;

/// The decimal that a number ≥ 0 is, if it is one.
fn decimal(value: &Rational) -> Option<String> {
    let digits = fraction_digits(value.denominator())?;
    let whole = value.numerator() * Pow::pow(BigInt::from(10), digits) / value.denominator();
    let exponent = if digits > MAX_PLAIN { digits.min(MAX_EXPONENT as usize) } else { 0 };
    let point = digits - exponent;
    let mut text = format!("{whole:0>width$}", width = point + 1);
    if point > 0 {
        text.insert(text.len() - point, '.');
    }
    if exponent > 0 {
        text.push_str(&format!("e-{exponent}"));
    }
    Some(text)
}

/// How many digits behind the point 1/q has, for q > 0; `None` if they do not end.
fn fraction_digits(q: &BigInt) -> Option<usize> {
    let mut q = q.clone();
    let mut counts = [0usize; 2];
    for (count, prime) in counts.iter_mut().zip([2u32, 5]) {
        while (&q % prime).is_zero() && !q.is_zero() {
            q /= prime;
            *count += 1;
        }
    }
    q.is_one().then_some(counts[0].max(counts[1]))
}

fn statement(value: &Statement, brackets: Brackets) -> String {
    let inside = |value: &Expr| write(value, brackets);
    match &value.kind {
        StatementKind::Surface { left, right, attributes } => {
            let mut text = inside(left);
            if let Some(right) = right {
                text.push_str(" = ");
                text.push_str(&inside(right));
            }
            if !attributes.is_empty() {
                text.push(' ');
                text.push_str(&block(attributes, brackets));
            }
            text
        }
        StatementKind::Definition { name, value } => format!("{} = {}", name.text, inside(value)),
        StatementKind::Function { name, parameters, body } => {
            let list: Vec<&str> = parameters.iter().map(|parameter| parameter.text.as_str()).collect();
            format!("{}({}) = {}", name.text, list.join(", "), inside(body))
        }
        StatementKind::Parameter { name, value, low, high, step } => {
            let step = step.as_ref().map_or(String::new(), |step| format!(" step {}", inside(step)));
            format!("{} = {} in [{}, {}]{step}", name.text, inside(value), inside(low), inside(high))
        }
        StatementKind::Block { kind, name, attributes } => {
            let name = name.as_ref().map_or(String::new(), |name| format!(" {}", name.text));
            format!("{}{name} {}", block_word(*kind), block(attributes, brackets))
        }
        StatementKind::Include { path, .. } => format!("include \"{path}\""),
    }
}

fn block_word(kind: BlockKind) -> &'static str {
    match kind {
        BlockKind::Material => "material",
        BlockKind::Light => "light",
        BlockKind::Sun => "sun",
        BlockKind::Sky => "sky",
        BlockKind::Camera => "camera",
        BlockKind::Render => "render",
    }
}

fn block(attributes: &[Attribute], brackets: Brackets) -> String {
    let entry = |attribute: &Attribute| format!("{}: {}", attribute.key.text, entry_value(&attribute.value, brackets));
    let entries: Vec<String> = attributes.iter().map(entry).collect();
    if entries.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", entries.join(", ")) }
}

fn entry_value(value: &AttributeValue, brackets: Brackets) -> String {
    match value {
        AttributeValue::Expr(value) => write(value, brackets),
        AttributeValue::Color([r, g, b], _) => format!("#{r:02x}{g:02x}{b:02x}"),
        AttributeValue::Text(text, _) => format!("\"{text}\""),
        AttributeValue::Size(width, height, _) => format!("{width}x{height}"),
        AttributeValue::Call(name, arguments, _) => {
            let arguments: Vec<String> = arguments.iter().map(|argument| entry_value(argument, brackets)).collect();
            format!("{}({})", name.text, arguments.join(", "))
        }
        AttributeValue::Box(ranges, _) => {
            let ranges: Vec<String> = ranges.iter().map(|(a, b)| range(a, b, brackets)).collect();
            format!("box({})", ranges.join(", "))
        }
    }
}
