//! How a statement begins, by nom over its words: what kind of statement it is and what it names.
//!
//! In: the words of one statement. Out: its [`Head`]. Separate because all heads are read before any value, so that
//! names can be used before they are defined.

use super::token::{Bracket, Token, TokenKind};
use nom::combinator::{map, verify};
use nom::error::{Error, ErrorKind};
use nom::multi::separated_list0;
use nom::sequence::{delimited, terminated};
use nom::{IResult, Input, Needed, Parser};
use std::iter::{Copied, Enumerate};
use std::slice::Iter;

/// What kind of statement the head announces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum HeadKind {
    Surface,
    Definition,
    Parameter,
    Function,
    Block(super::ast::BlockKind),
    Include,
}

/// The beginning of a statement.
#[derive(Clone, Debug)]
pub(super) struct Head {
    pub(super) kind: HeadKind,
    /// The name declared; the first word where there is none.
    pub(super) name: Token,
    /// The parameters of a function.
    pub(super) parameters: Vec<Token>,
    /// How many words the head takes, `=` or the word before `{` included.
    pub(super) length: usize,
}

/// Words as nom takes them.
#[derive(Clone, Copy, Debug)]
struct Words<'t>(&'t [Token]);

impl<'t> Input for Words<'t> {
    type Item = Token;
    type Iter = Copied<Iter<'t, Token>>;
    type IterIndices = Enumerate<Self::Iter>;

    fn input_len(&self) -> usize {
        self.0.len()
    }
    fn take(&self, index: usize) -> Self {
        Words(&self.0[..index])
    }
    fn take_from(&self, index: usize) -> Self {
        Words(&self.0[index..])
    }
    fn take_split(&self, index: usize) -> (Self, Self) {
        (self.take_from(index), self.take(index))
    }
    fn position<P: Fn(Token) -> bool>(&self, predicate: P) -> Option<usize> {
        self.0.iter().position(|&word| predicate(word))
    }
    fn iter_elements(&self) -> Self::Iter {
        self.0.iter().copied()
    }
    fn iter_indices(&self) -> Self::IterIndices {
        self.iter_elements().enumerate()
    }
    fn slice_index(&self, count: usize) -> Result<usize, Needed> {
        if self.0.len() >= count { Ok(count) } else { Err(Needed::new(count - self.0.len())) }
    }
}

type Found<'t, T> = IResult<Words<'t>, T>;

fn any(input: Words<'_>) -> Found<'_, Token> {
    match input.0.split_first() {
        Some((&first, rest)) => Ok((Words(rest), first)),
        None => Err(nom::Err::Error(Error::new(input, ErrorKind::Eof))),
    }
}

fn word<'t>(kind: TokenKind) -> impl Parser<Words<'t>, Output = Token, Error = Error<Words<'t>>> {
    verify(any, move |token: &Token| token.kind == kind)
}

fn name(input: Words<'_>) -> Found<'_, Token> {
    verify(any, |token: &Token| matches!(token.kind, TokenKind::Name | TokenKind::Symbol)).parse(input)
}

fn assignment(input: Words<'_>) -> Found<'_, (HeadKind, Token, Vec<Token>)> {
    map(terminated(name, word(TokenKind::Equal)), |name| (HeadKind::Definition, name, Vec::new())).parse(input)
}

fn function(input: Words<'_>) -> Found<'_, (HeadKind, Token, Vec<Token>)> {
    let open = word(TokenKind::Open(Bracket::Round));
    let close = word(TokenKind::Close(Bracket::Round));
    let parameters = delimited(open, separated_list0(word(TokenKind::Comma), name), close);
    let parameters = verify(parameters, |list: &Vec<Token>| !list.is_empty());
    map(terminated((name, parameters), word(TokenKind::Equal)), |(name, list)| (HeadKind::Function, name, list))
        .parse(input)
}

/// `light {`, `material gold {`; a newline may stand before the brace.
fn block<'t>(text: &str, input: Words<'t>) -> Found<'t, (HeadKind, Token, Vec<Token>)> {
    use super::ast::BlockKind;
    let (rest, first) = name(input)?;
    let kind = match &text[first.span.range()] {
        "material" => BlockKind::Material,
        "light" => BlockKind::Light,
        "sun" => BlockKind::Sun,
        "sky" => BlockKind::Sky,
        "camera" => BlockKind::Camera,
        "render" => BlockKind::Render,
        _ => return Err(nom::Err::Error(Error::new(input, ErrorKind::Tag))),
    };
    let (rest, named) = if kind == BlockKind::Material { name(rest)? } else { (rest, first) };
    nom::combinator::peek(word(TokenKind::Open(Bracket::Curly))).parse(rest)?;
    Ok((rest, (HeadKind::Block(kind), named, Vec::new())))
}

fn include<'t>(text: &str, input: Words<'t>) -> Found<'t, (HeadKind, Token, Vec<Token>)> {
    let (rest, first) = verify(name, |token: &Token| &text[token.span.range()] == "include").parse(input)?;
    nom::combinator::peek(word(TokenKind::Text)).parse(rest)?;
    Ok((rest, (HeadKind::Include, first, Vec::new())))
}

/// How a statement begins. `words` must not be empty.
pub(super) fn head(words: &[Token], text: &str) -> Head {
    let input = Words(words);
    let found = include(text, input)
        .or_else(|_| block(text, input))
        .or_else(|_| function(input))
        .or_else(|_| assignment(input));
    let surface = Head { kind: HeadKind::Surface, name: words[0], parameters: Vec::new(), length: 0 };
    let Ok((rest, (kind, name, parameters))) = found else { return surface };
    let length = words.len() - rest.input_len();
    let coordinate = super::names::COORDINATES.contains(&&text[name.span.range()]);
    let ranged = kind == HeadKind::Definition && has_range(&words[length..]);
    match kind {
        HeadKind::Definition if ranged => Head { kind: HeadKind::Parameter, name, parameters, length },
        HeadKind::Definition if coordinate => surface,
        _ => Head { kind, name, parameters, length },
    }
}

/// Whether `in` stands outside all brackets.
fn has_range(words: &[Token]) -> bool {
    let mut depth = 0i64;
    words.iter().any(|word| {
        match word.kind {
            TokenKind::Open(_) => depth += 1,
            TokenKind::Close(_) => depth -= 1,
            _ => {}
        }
        word.kind == TokenKind::In && depth == 0
    })
}
