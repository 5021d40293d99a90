//! Text → words, by nom.
//!
//! In: a program's text. Out: its tokens, and an error for every character that is none of the language.
//! Never fails: what it cannot read it reports and passes on as [`TokenKind::Invalid`].

use super::letters;
use super::token::{Bracket, Token, TokenKind};
use crate::diag::{Diagnostic, SourceId, Span};
use nom::branch::alt;
use nom::bytes::complete::{tag, take_till, take_while, take_while1};
use nom::character::complete::{anychar, char, digit0, digit1, one_of, satisfy};
use nom::combinator::{map, not, opt, peek, recognize, value};
use nom::sequence::{pair, terminated};
use nom::{IResult, Parser};

/// Longer names are refused: nobody can read them, and they are compared with others for suggestions.
pub const MAX_NAME: usize = 64;

/// Longer numbers are refused: exact decimals of this length are beyond every f64, and reading takes the square of it.
pub const MAX_NUMBER: usize = 1000;

/// What a piece of text is.
#[derive(Clone)]
enum Piece {
    Blank,
    Token(TokenKind),
}

/// All words of a text in order, line ends included; errors are added to `errors`.
pub(super) fn tokens(source: SourceId, text: &str, errors: &mut Vec<Diagnostic>) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut rest = text;
    while let Ok((next, found)) = piece(rest) {
        let start = text.len() - rest.len();
        let span = Span::new(source, start, text.len() - next.len());
        if let Piece::Token(kind) = found {
            let written = &text[span.range()];
            let kind = check(kind, written, span, errors);
            tokens.push(Token { kind, span });
        }
        rest = next;
    }
    tokens
}

fn piece(input: &str) -> IResult<&str, Piece> {
    let blank = alt((take_while1(is_blank), recognize(pair(tag("//"), take_till(|c| c == '\n')))));
    alt((
        value(Piece::Blank, blank),
        map(alt((word, number, text, operator, punctuation)), Piece::Token),
        map(foreign, Piece::Token),
    ))
    .parse(input)
}

/// Blanks as people paste them: no-break and thin spaces, a byte order mark.
fn is_blank(c: char) -> bool {
    matches!(
        c,
        ' ' | '\t' | '\r' | '\u{a0}' | '\u{feff}' | '\u{2000}'..='\u{200b}' | '\u{202f}' | '\u{205f}' | '\u{3000}'
    )
}

fn is_letter(c: char) -> bool {
    c.is_ascii_alphabetic() || is_false_letter(c)
}

/// A letter or digit that only looks like one of the language.
fn is_false_letter(c: char) -> bool {
    letters::look_alike(c).is_some_and(|(c, _)| c.is_ascii_alphanumeric())
}

fn word(input: &str) -> IResult<&str, TokenKind> {
    let name = recognize(pair(satisfy(is_letter), take_while(|c| is_letter(c) || c.is_ascii_digit() || c == '_')));
    alt((
        map(name, |name: &str| match name {
            "and" => TokenKind::And,
            "or" => TokenKind::Or,
            "not" => TokenKind::Not,
            "in" => TokenKind::In,
            _ => TokenKind::Name,
        }),
        value(TokenKind::Symbol, satisfy(|c| letters::symbol(c).is_some())),
        value(TokenKind::Raised, take_while1(|c| letters::raised(c).is_some())),
    ))
    .parse(input)
}

/// `2`, `.5`, `2.`, `1e-3`; the first dot of `..` is not part of it, and `2e` without digits is `2` before `e`.
fn number(input: &str) -> IResult<&str, TokenKind> {
    let point = || terminated(char('.'), not(char('.')));
    let mantissa = alt((recognize((digit1, opt((point(), digit0)))), recognize((point(), digit1))));
    let exponent = opt(recognize((one_of("eE"), opt(one_of("+-")), digit1)));
    value(TokenKind::Number, recognize(pair(mantissa, exponent))).parse(input)
}

fn is_quote(c: char) -> bool {
    matches!(c, '"' | '“' | '”' | '„')
}

/// `"…"` on one line, or a colour.
fn text(input: &str) -> IResult<&str, TokenKind> {
    let quoted = recognize((satisfy(is_quote), take_till(|c| is_quote(c) || c == '\n'), opt(satisfy(is_quote))));
    let color = recognize(pair(char('#'), take_while(|c: char| c.is_ascii_alphanumeric())));
    alt((value(TokenKind::Text, quoted), value(TokenKind::Color, color))).parse(input)
}

fn operator(input: &str) -> IResult<&str, TokenKind> {
    use TokenKind::*;
    let several = alt((
        value(Caret, alt((tag("**"), tag("^")))),
        value(NotEqual, alt((tag("!="), tag("≠"), tag("<>")))),
        value(LessEqual, alt((tag("<="), tag("≤"), tag("⩽")))),
        value(GreaterEqual, alt((tag(">="), tag("≥"), tag("⩾")))),
        value(Equal, alt((tag("=="), terminated(tag("="), peek(not(one_of("<>"))))))),
        value(Ampersand, alt((tag("&&"), tag("&")))),
        value(Range, alt((tag(".."), tag("…")))),
    ));
    let single = alt((
        value(Star, one_of("*×·⋅∙∗")),
        value(Slash, one_of("/÷∕⁄")),
        value(Minus, one_of("-−–‐")),
        value(Plus, char('+')),
        value(Percent, char('%')),
        value(Less, char('<')),
        value(Greater, char('>')),
        value(Bang, char('!')),
        value(Bar, one_of("|∣")),
        value(SquareRoot, char('√')),
        value(CubeRoot, char('∛')),
    ));
    alt((several, single)).parse(input)
}

fn punctuation(input: &str) -> IResult<&str, TokenKind> {
    use TokenKind::*;
    alt((
        value(Newline, char('\n')),
        value(Semicolon, char(';')),
        value(Comma, char(',')),
        value(Colon, terminated(char(':'), peek(not(char('='))))),
        value(Dot, char('.')),
        value(Open(Bracket::Round), char('(')),
        value(Close(Bracket::Round), char(')')),
        value(Open(Bracket::Square), char('[')),
        value(Close(Bracket::Square), char(']')),
        value(Open(Bracket::Curly), char('{')),
        value(Close(Bracket::Curly), char('}')),
    ))
    .parse(input)
}

/// What is no word of the language: one error for a run of it.
fn foreign(input: &str) -> IResult<&str, TokenKind> {
    let mistaken = alt((tag(":="), tag("=<"), tag("=>")));
    let run = take_while1(|c: char| !c.is_ascii() && !is_blank(c) && !starts_word(c));
    value(TokenKind::Invalid, alt((mistaken, run, recognize(anychar)))).parse(input)
}

/// Whether a character beyond ASCII begins a word.
fn starts_word(c: char) -> bool {
    let mut buffer = [0; 4];
    alt((word, operator, text)).parse(c.encode_utf8(&mut buffer)).is_ok()
}

/// Reports what is wrong with a word by itself.
fn check(kind: TokenKind, written: &str, span: Span, errors: &mut Vec<Diagnostic>) -> TokenKind {
    let error = match kind {
        TokenKind::Name if written.len() > MAX_NAME => {
            let many = written.len();
            let error = Diagnostic::error(span, format!("this name has {many} characters; the limit is {MAX_NAME}"));
            error.help("take a shorter name")
        }
        TokenKind::Name if !written.is_ascii() => false_letter(written, span),
        TokenKind::Number if written.len() > MAX_NUMBER => {
            let many = written.len();
            Diagnostic::error(span, format!("this number has {many} characters; the limit is {MAX_NUMBER}"))
        }
        TokenKind::Text if written.chars().filter(|&c| is_quote(c)).count() < 2 => {
            Diagnostic::error(span, "this text is not closed").help("end it with `\"` on the same line")
        }
        TokenKind::Color if color(written).is_none() => {
            Diagnostic::error(span, "this is no colour").help("write `#rgb` or `#rrggbb` with digits 0-9 and a-f")
        }
        TokenKind::Invalid => foreign_text(written, span),
        _ => return kind,
    };
    errors.push(error);
    match written {
        ":=" => TokenKind::Equal,
        "=<" => TokenKind::LessEqual,
        "=>" => TokenKind::GreaterEqual,
        _ => TokenKind::Invalid,
    }
}

/// The error for a name with letters that are not what they seem.
fn false_letter(written: &str, span: Span) -> Diagnostic {
    let place = written.char_indices().find_map(|(i, c)| letters::look_alike(c).map(|found| (i, c, found)));
    let Some((i, c, (meant, script))) = place else { return Diagnostic::error(span, "unknown letter") };
    let start = span.start as usize + i;
    let here = Span::new(span.source, start, start + c.len_utf8());
    let code = c as u32;
    let mend: String = written.chars().map(|c| letters::look_alike(c).map_or(c, |(meant, _)| meant)).collect();
    Diagnostic::error(here, format!("`{c}` is a {script} letter (U+{code:04X}) that only looks like `{meant}`"))
        .help(format!("write `{mend}`"))
}

fn foreign_text(written: &str, span: Span) -> Diagnostic {
    let mend = match written {
        ":=" => Some("="),
        "=<" => Some("<="),
        "=>" => Some(">="),
        "∧" | "∩" => Some("and"),
        "∨" | "∪" => Some("or"),
        "¬" => Some("not"),
        _ => None,
    };
    let error = Diagnostic::error(span, format!("`{}` is not part of the language", cut(written)));
    let first = written.chars().next();
    let sentence = match written {
        "∞" => "there is no infinity: write a number, such as `1e9`",
        "±" => "write two surfaces, one with `+` and one with `-`",
        _ => "",
    };
    if !sentence.is_empty() {
        return error.help(sentence);
    }
    match (mend, first.and_then(letters::look_alike)) {
        (Some(mend), _) => error.help(format!("write `{mend}`")),
        (None, Some((meant, script))) => error.help(format!("this is a {script} character: write `{meant}`")),
        _ => error,
    }
}

/// At most this many characters of a foreign text are repeated.
const MAX_QUOTED: usize = 20;

fn cut(text: &str) -> String {
    crate::diag::printable(text, MAX_QUOTED)
}

/// Red, green, blue of `#rgb` or `#rrggbb`.
pub(super) fn color(written: &str) -> Option<[u8; 3]> {
    let digits: Option<Vec<u8>> = written.chars().skip(1).map(|c| c.to_digit(16).map(|d| d as u8)).collect();
    match *digits?.as_slice() {
        [r, g, b] => Some([r * 17, g * 17, b * 17]),
        [r, s, g, h, b, c] => Some([r * 16 + s, g * 16 + h, b * 16 + c]),
        _ => None,
    }
}

/// The number that raised digits stand for, as its sign and its digits; `None` if the minus is misplaced.
pub(super) fn raised_digits(written: &str) -> Option<(bool, String)> {
    let plain: String = written.chars().filter_map(letters::raised).collect();
    let (minus, digits) = plain.strip_prefix('-').map_or((false, plain.as_str()), |rest| (true, rest));
    let valid = !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) && digits.len() <= MAX_NUMBER;
    valid.then(|| (minus, digits.to_owned()))
}

/// The content of a text without its quotes.
pub(super) fn unquoted(written: &str) -> &str {
    written.trim_start_matches(is_quote).trim_end_matches(is_quote)
}
