//! Test vectors of the interval test framework ITF1788 (Kiesner, Nehmeier, Wolff von Gudenberg 2015), as its `.itl` files have them.
//!
//! In: the text of such a file. Out: its statements `operation argument … = result;`, as far as arguments and result are intervals
//! and whole numbers. Separate because it knows the language of the files and nothing of our operations.

use implicit::num::interval::{Defined, Enclosure, Interval};

/// One statement.
pub(crate) struct Vector {
    /// The operation's name there.
    pub(crate) operation: String,
    /// Intervals.
    pub(crate) arguments: Vec<Enclosure>,
    /// A whole number behind them.
    pub(crate) number: Option<i64>,
    /// The tightest interval of doubles, and what is known of the operation there if that is said too.
    pub(crate) result: Interval,
    pub(crate) known: Option<Known>,
    /// As it was written.
    pub(crate) text: String,
}

/// The decorations of IEEE 1788-2015, section 11.2, as far as they say something of the function.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Known {
    /// trv
    Nothing,
    /// def
    Defined,
    /// dac, com
    Continuous,
}

/// All statements of a file that can be read so, and how many cannot.
pub(crate) fn read(text: &str) -> (Vec<Vector>, usize) {
    let text = without_comments(text);
    let statements = text.split([';', '{', '}']).map(str::trim).filter(|statement| statement.contains('='));
    let (mut vectors, mut others) = (Vec::new(), 0);
    for statement in statements {
        match vector(statement) {
            Some(vector) => vectors.push(vector),
            None => others += 1,
        }
    }
    (vectors, others)
}

fn without_comments(text: &str) -> String {
    let mut kept = String::new();
    for (k, part) in text.split("/*").enumerate() {
        kept += if k == 0 { part } else { part.split_once("*/").map_or("", |(_, rest)| rest) };
    }
    kept.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

fn vector(statement: &str) -> Option<Vector> {
    let (left, right) = statement.split_once('=')?;
    let (operation, mut rest) = left.trim().split_once(|c: char| c.is_whitespace() || c == '[')?;
    if left.trim()[operation.len()..].starts_with('[') {
        rest = &left.trim()[operation.len()..];
    }
    let (mut arguments, mut number) = (Vec::new(), None);
    let mut rest = rest.trim();
    while !rest.is_empty() {
        if rest.starts_with('[') {
            let (range, known, behind) = interval(rest)?;
            arguments.push(enclosure(range, known));
            rest = behind;
        } else {
            let (word, behind) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
            number = Some(word.parse().ok()?);
            rest = behind.trim();
        }
    }
    let (result, known, behind) = interval(right.trim())?;
    let (operation, text) = (operation.to_owned(), statement.split_whitespace().collect::<Vec<_>>().join(" "));
    behind.is_empty().then_some(Vector { operation, arguments, number, result, known, text })
}

/// An interval at the beginning of a text, its decoration, and what is behind it.
fn interval(text: &str) -> Option<(Interval, Option<Known>, &str)> {
    let (inside, mut behind) = text.strip_prefix('[')?.split_once(']')?;
    let range = match inside.trim() {
        "empty" => Interval::EMPTY,
        "entire" => Interval::WHOLE,
        inside => {
            let (lo, hi) = inside.split_once(',').unwrap_or((inside, inside));
            let bound = |text: &str, none: f64| if text.trim().is_empty() { Some(none) } else { number(text.trim()) };
            Interval { lo: bound(lo, f64::NEG_INFINITY)?, hi: bound(hi, f64::INFINITY)? }
        }
    };
    let mut known = None;
    if let Some(decoration) = behind.strip_prefix('_') {
        known = Some(match decoration.get(..3)? {
            "com" | "dac" => Known::Continuous,
            "def" => Known::Defined,
            "trv" => Known::Nothing,
            _ => return None,
        });
        behind = &decoration[3..];
    }
    Some((range, known, behind.trim()))
}

fn enclosure(range: Interval, known: Option<Known>) -> Enclosure {
    if range.is_empty() {
        return Enclosure::NOWHERE;
    }
    match known {
        None | Some(Known::Continuous) => Enclosure::total(range),
        Some(Known::Defined) => Enclosure { range, defined: Defined::Everywhere, continuous: false },
        Some(Known::Nothing) => Enclosure { range, defined: Defined::Somewhere, continuous: false },
    }
}

/// A decimal or hexadecimal number that is a double.
fn number(text: &str) -> Option<f64> {
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => (-1.0, digits),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    let lower = digits.to_lowercase();
    let Some(hexadecimal) = lower.strip_prefix("0x") else {
        return if lower == "infinity" { Some(sign * f64::INFINITY) } else { Some(sign * lower.parse::<f64>().ok()?) };
    };
    let (digits, exponent) = hexadecimal.split_once('p').unwrap_or((hexadecimal, "0"));
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let mut value = u128::from_str_radix(&format!("{whole}{fraction}"), 16).ok()? as f64;
    // One step by a power of two at a time, so that nothing is rounded that need not be.
    let mut exponent = exponent.parse::<i32>().ok()? - 4 * fraction.len() as i32;
    while exponent != 0 {
        let step = exponent.clamp(-900, 900);
        value *= f64::from_bits(((step + 1023) as u64) << 52);
        exponent -= step;
    }
    Some(sign * value)
}
