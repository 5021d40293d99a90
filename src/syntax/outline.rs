//! Where statements begin and end.
//!
//! In: the words of a text. Out: the words of each statement, line ends left out. A newline or `;` ends a statement,
//! except inside brackets, after an operator or a comma, and before `{`; a bracket that is never closed holds nothing
//! together, so that one forgotten bracket costs one statement.

use super::token::{Bracket, Token, TokenKind};

/// The words of each statement.
pub(super) fn statements(tokens: &[Token]) -> Vec<Vec<Token>> {
    let (paired, before_brace) = (paired(tokens), before_brace(tokens));
    let mut statements = Vec::new();
    let mut words: Vec<Token> = Vec::new();
    let mut depth = 0usize;
    for (i, &token) in tokens.iter().enumerate() {
        match token.kind {
            TokenKind::Open(_) if paired[i] => depth += 1,
            TokenKind::Close(_) if paired[i] => depth -= 1,
            TokenKind::Newline if depth > 0 => continue,
            TokenKind::Newline if words.last().is_some_and(|last| before_brace[i] || last.kind.continues_line()) => {
                continue;
            }
            TokenKind::Newline | TokenKind::Semicolon if depth == 0 => {
                if !words.is_empty() {
                    statements.push(std::mem::take(&mut words));
                }
                continue;
            }
            _ => {}
        }
        words.push(token);
    }
    if !words.is_empty() {
        statements.push(words);
    }
    statements
}

/// For each word, whether `{` is the first word behind it that is no newline.
fn before_brace(tokens: &[Token]) -> Vec<bool> {
    let mut before = vec![false; tokens.len()];
    let mut brace = false;
    for (i, token) in tokens.iter().enumerate().rev() {
        before[i] = brace;
        match token.kind {
            TokenKind::Newline => {}
            kind => brace = kind == TokenKind::Open(Bracket::Curly),
        }
    }
    before
}

/// For each word, whether it is a bracket that has its partner.
fn paired(tokens: &[Token]) -> Vec<bool> {
    let mut paired = vec![false; tokens.len()];
    let mut open: Vec<(usize, Bracket)> = Vec::new();
    let mut counts = [0usize; 3];
    for (i, token) in tokens.iter().enumerate() {
        match token.kind {
            TokenKind::Open(bracket) => {
                counts[bracket as usize] += 1;
                open.push((i, bracket));
            }
            TokenKind::Close(bracket) if counts[bracket as usize] > 0 => {
                while let Some((start, other)) = open.pop() {
                    counts[other as usize] -= 1;
                    if other == bracket {
                        (paired[start], paired[i]) = (true, true);
                        break;
                    }
                }
            }
            _ => {}
        }
    }
    paired
}
