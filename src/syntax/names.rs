//! The names of a program: which are declared, and as what.
//!
//! In: the heads of all statements and the words behind them. Out: what a name means to the parser: a value, a
//! function, or nothing. Separate because calls, products and split names are told apart by it while reading.

use super::functions;
use super::heads::{Head, HeadKind};
use super::token::{Bracket, Token, TokenKind};
use std::collections::{BTreeMap, BTreeSet};

/// The coordinates.
pub(super) const COORDINATES: [&str; 3] = ["x", "y", "z"];

/// Numbers that have a name.
pub const CONSTANTS: [&str; 4] = ["pi", "tau", "e", "golden"];

/// Names ready for use that a program may define itself.
pub const READY: [&str; 5] = ["r", "theta", "rho", "phi", "p"];

/// What a name was declared as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Declared {
    /// A number or a formula, which a one-letter name in a longer one can stand for.
    Scalar,
    /// A vector, a list or a region.
    Other,
    /// A function of so many arguments.
    Function(usize),
}

/// What a name means.
#[derive(Clone, Copy, Debug)]
pub(super) enum Meaning {
    Value,
    /// A function of the table.
    Builtin(&'static functions::Function),
    /// A function of the program with so many arguments.
    Function(usize),
    Unknown,
}

/// The declared names of a whole program.
#[derive(Debug, Default)]
pub(super) struct Names {
    declared: BTreeMap<String, Declared>,
}

/// Whether no program may define the name.
pub(super) fn is_fixed(name: &str) -> bool {
    let function = functions::find(name).is_some() && !functions::is_of_attributes(name);
    COORDINATES.contains(&name) || CONSTANTS.contains(&name) || function
}

impl Names {
    pub(super) fn declare(&mut self, name: &str, as_what: Declared) {
        self.declared.entry(name.to_owned()).or_insert(as_what);
    }

    pub(super) fn forget(&mut self, name: &str) {
        self.declared.remove(name);
    }

    pub(super) fn declared(&self, name: &str) -> Option<Declared> {
        self.declared.get(name).copied()
    }

    /// What the name means outside of any function or sum.
    pub(super) fn meaning(&self, name: &str) -> Meaning {
        match self.declared(name) {
            Some(Declared::Function(count)) => Meaning::Function(count),
            Some(_) => Meaning::Value,
            None => match functions::find(name) {
                Some(function) => Meaning::Builtin(function),
                None if COORDINATES.contains(&name) || CONSTANTS.contains(&name) || READY.contains(&name) => {
                    Meaning::Value
                }
                None => Meaning::Unknown,
            },
        }
    }

    /// Whether a letter may be split off a longer name: a coordinate, e, or a defined scalar.
    pub(super) fn splits(&self, letter: &str) -> bool {
        match self.declared(letter) {
            Some(found) => found == Declared::Scalar,
            None => COORDINATES.contains(&letter) || letter == "e",
        }
    }

    /// All names that could have been meant, the program's own first.
    pub(super) fn known(&self) -> impl Iterator<Item = &str> {
        let own = self.declared.keys().map(String::as_str);
        let ready = COORDINATES.into_iter().chain(CONSTANTS).chain(READY);
        own.chain(ready).chain(functions::FUNCTIONS.iter().map(|function| function.name))
    }

    /// Whether a name without brackets behind it means a vector, as far as names tell.
    fn is_vector(&self, name: &str) -> bool {
        match self.declared(name) {
            Some(found) => found == Declared::Other,
            None => name == "p",
        }
    }
}

/// Whether a value, by its words, is a number or a formula rather than a vector, list or region.
///
/// Words inside calls and bars do not count, since those turn vectors into numbers.
pub(super) fn is_scalar(words: &[Token], text: &str, names: &Names) -> bool {
    let mut closers: Vec<bool> = Vec::new();
    let (mut bars, mut hidden) = (0usize, 0usize);
    for (i, word) in words.iter().enumerate() {
        let previous = i.checked_sub(1).and_then(|i| words.get(i));
        let name = |token: &Token| canonical(token, text);
        match word.kind {
            TokenKind::Bar => bars += 1,
            TokenKind::Open(Bracket::Square) if hidden == 0 => return false,
            TokenKind::Open(_) => {
                let number = previous.is_some_and(|word| gives_number(name(word), names));
                closers.push(number);
                hidden += usize::from(number);
            }
            TokenKind::Close(_) => hidden -= usize::from(closers.pop().unwrap_or(false)),
            _ if hidden > 0 || bars % 2 == 1 => {}
            TokenKind::Comma | TokenKind::And | TokenKind::Or | TokenKind::Not => return false,
            kind if kind.comparison().is_some() => return false,
            TokenKind::Name => {
                let component = words.get(i + 1).is_some_and(|next| next.kind == TokenKind::Dot);
                let function = functions::find(name(word));
                let other =
                    function.is_some_and(|f| matches!(f.gives, functions::Gives::Vector | functions::Gives::Region));
                if other || (names.is_vector(name(word)) && !component) {
                    return false;
                }
            }
            _ => {}
        }
    }
    true
}

/// Whether a bracket behind this name is a call that gives a number, whatever stands in it.
fn gives_number(name: &str, names: &Names) -> bool {
    matches!(names.declared(name), Some(Declared::Function(_)))
        || functions::find(name).is_some_and(|f| matches!(f.gives, functions::Gives::Number | functions::Gives::Either))
}

/// The name a word stands for: `θ` is theta. Empty for what is no name.
pub(super) fn canonical<'a>(token: &Token, text: &'a str) -> &'a str {
    let written = &text[token.span.range()];
    match token.kind {
        TokenKind::Name => written,
        TokenKind::Symbol => written.chars().next().and_then(super::letters::symbol).unwrap_or(written),
        _ => "",
    }
}

/// A statement before it is read: its head and its words, with the text they are of.
pub(super) struct Outline<'t> {
    pub(super) text: &'t str,
    pub(super) words: &'t [Token],
    pub(super) head: Head,
}

/// The names that the outlines of a program declare. Heads that turn out to declare nothing become surfaces.
pub(super) fn declare(outlines: &mut [Outline<'_>]) -> Names {
    let mut names = Names::default();
    let assigned: BTreeSet<String> = outlines
        .iter()
        .filter(|o| matches!(o.head.kind, HeadKind::Definition | HeadKind::Parameter))
        .map(|o| canonical(&o.head.name, o.text).to_owned())
        .collect();
    for outline in outlines.iter_mut() {
        let name = canonical(&outline.head.name, outline.text);
        if outline.head.kind == HeadKind::Function {
            if assigned.contains(name) || is_fixed(name) || is_product(name) {
                outline.head.kind = HeadKind::Surface;
            } else {
                names.declare(name, Declared::Function(outline.head.parameters.len()));
            }
        }
    }
    let keep = kept_definitions(outlines);
    for (outline, keep) in outlines.iter_mut().zip(keep) {
        let name = canonical(&outline.head.name, outline.text);
        match outline.head.kind {
            HeadKind::Definition if !keep => outline.head.kind = HeadKind::Surface,
            HeadKind::Definition | HeadKind::Parameter if !is_fixed(name) => names.declare(name, Declared::Scalar),
            _ => {}
        }
    }
    find_vectors(outlines, &mut names);
    unsplit(outlines, &mut names);
    names
}

/// Which definitions stay ones: `r = 1` and its like only if another statement uses the name.
fn kept_definitions(outlines: &[Outline<'_>]) -> Vec<bool> {
    let mut used: BTreeMap<&str, BTreeSet<usize>> = BTreeMap::new();
    for (i, outline) in outlines.iter().enumerate() {
        for word in &outline.words[outline.head.length.min(outline.words.len())..] {
            used.entry(canonical(word, outline.text)).or_default().insert(i);
        }
    }
    let is_used = |name: &str, i: usize| used.get(name).is_some_and(|places| places.iter().any(|&other| other != i));
    let decide = |(i, outline): (usize, &Outline<'_>)| {
        let name = canonical(&outline.head.name, outline.text);
        let ambiguous = ["r", "theta", "rho", "phi"].contains(&name) || is_product(name);
        !ambiguous || is_used(name, i)
    };
    outlines.iter().enumerate().map(decide).collect()
}

/// Whether a name reads as a product of coordinates.
pub(super) fn is_product(name: &str) -> bool {
    name.len() > 1 && name.bytes().all(|b| matches!(b, b'x' | b'y' | b'z'))
}

/// Marks the definitions that are vectors, lists or regions; repeated, since one may be made of another.
fn find_vectors(outlines: &[Outline<'_>], names: &mut Names) {
    // Each round settles at least one more level of definitions; deeper chains are rare and harmless.
    for _ in 0..8 {
        let mut changed = false;
        for outline in outlines.iter().filter(|o| o.head.kind == HeadKind::Definition) {
            let name = canonical(&outline.head.name, outline.text);
            let value = &outline.words[outline.head.length..];
            if names.declared(name) == Some(Declared::Scalar) && !is_scalar(value, outline.text, names) {
                names.declared.insert(name.to_owned(), Declared::Other);
                changed = true;
            }
        }
        if !changed {
            return;
        }
    }
}

/// Leaves definitions such as `ax = 1`, used nowhere, that split into a coordinate and known letters, to be surfaces.
fn unsplit(outlines: &mut [Outline<'_>], names: &mut Names) {
    if outlines.iter().all(|o| o.head.kind != HeadKind::Definition) {
        return;
    }
    // Words are put in one by one: there are many, and few different ones.
    let mut used: BTreeSet<String> = BTreeSet::new();
    for word in outlines
        .iter()
        .flat_map(|o| o.words[o.head.length.min(o.words.len())..].iter().map(|word| canonical(word, o.text)))
    {
        if !used.contains(word) {
            used.insert(word.to_owned());
        }
    }
    for outline in outlines.iter_mut().filter(|o| o.head.kind == HeadKind::Definition) {
        let name = canonical(&outline.head.name, outline.text);
        let splits = name.len() > 1 && name.is_ascii() && (0..name.len()).all(|i| names.splits(&name[i..=i]));
        if splits && !is_fixed(name) && !used.contains(name) && name.contains(['x', 'y', 'z']) {
            outline.head.kind = HeadKind::Surface;
            names.forget(name);
        }
    }
}
