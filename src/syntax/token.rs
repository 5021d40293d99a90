//! The words of a program: numbers, names, operators, brackets, each with its place.
//!
//! In: nothing, it is plain data. Out: what the lexer makes and the parser reads. Separate because both need it.

use crate::diag::Span;

/// A word of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Token {
    pub(super) kind: TokenKind,
    pub(super) span: Span,
}

/// Round, square or curly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bracket {
    Round,
    Square,
    Curly,
}

impl Bracket {
    /// Opening and closing character.
    pub(super) fn pair(self) -> (char, char) {
        match self {
            Bracket::Round => ('(', ')'),
            Bracket::Square => ('[', ']'),
            Bracket::Curly => ('{', '}'),
        }
    }
}

/// What kind of word it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TokenKind {
    Number,
    Name,
    /// A letter that is a name by itself, such as `π` or `θ`.
    Symbol,
    /// Raised digits: `²`, `⁻¹⁰`.
    Raised,
    Text,
    /// `#4af`.
    Color,
    Newline,
    Semicolon,
    Plus,
    Minus,
    Star,
    Slash,
    Percent,
    Caret,
    Bar,
    Open(Bracket),
    Close(Bracket),
    Comma,
    Colon,
    Dot,
    /// `..`
    Range,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    /// `√`
    SquareRoot,
    /// `∛`
    CubeRoot,
    Bang,
    /// `&` or `&&`
    Ampersand,
    And,
    Or,
    Not,
    In,
    /// What the lexer has reported already: stands for anything.
    Invalid,
    /// After the last word of a statement.
    End,
}

impl TokenKind {
    /// Whether a line that ends in this word goes on: an operator or a comma.
    pub(super) fn continues_line(self) -> bool {
        use TokenKind::*;
        matches!(
            self,
            Plus | Minus | Star | Slash | Percent | Caret | Comma | Colon | Range | Equal | NotEqual | Less | LessEqual
        ) || matches!(self, Greater | GreaterEqual | SquareRoot | CubeRoot | Bang | Ampersand | And | Or | Not | In)
    }

    /// The comparison it is, if it is one.
    pub(super) fn comparison(self) -> Option<super::ast::Comparison> {
        use super::ast::Comparison;
        match self {
            TokenKind::Less => Some(Comparison::Less),
            TokenKind::LessEqual => Some(Comparison::LessEqual),
            TokenKind::Greater => Some(Comparison::Greater),
            TokenKind::GreaterEqual => Some(Comparison::GreaterEqual),
            _ => None,
        }
    }
}
