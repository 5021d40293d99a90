//! Errors for words that do not fit where they stand, each with the mend.
//!
//! In: the word and what was read before it. Out: an error in the report. Separate so that the grammar stays readable.

use super::reader::{Reader, Stop};
use super::token::{Bracket, Token, TokenKind};
use crate::diag::{Diagnostic, printable};

/// Words are quoted up to this many characters.
const MAX_QUOTED: usize = 20;

impl Reader<'_> {
    fn shown(&self, token: Token) -> String {
        printable(self.written(token.span), MAX_QUOTED)
    }

    /// An operand was expected and something else stands here.
    pub(super) fn missing_operand(&mut self) -> Stop {
        let word = self.peek();
        if let Some(stop) = self.foreign_operator(word) {
            return stop;
        }
        let previous = self.previous();
        let (error, help) = match (word.kind, previous) {
            (TokenKind::Equal, None) => {
                (Diagnostic::error(word.span, "nothing stands left of `=`"), "write `z = x^2` or `x^2 + y^2 = 1`")
            }
            (TokenKind::Equal, Some(before)) if before.kind.comparison().is_some() => (
                Diagnostic::error(before.span.to(word.span), "this is no comparison"),
                "comparisons are `<`, `<=`, `>`, `>=`",
            ),
            (TokenKind::Raised, _) => {
                (Diagnostic::error(word.span, "nothing is raised here"), "put a number or a name before it")
            }
            (TokenKind::Close(_), None) => {
                let closing = self.shown(word);
                (Diagnostic::error(word.span, format!("this `{closing}` closes nothing")), "take it away")
            }
            (_, Some(before)) => {
                let before = self.shown(before);
                let message = match word.kind {
                    TokenKind::End => format!("something is missing behind `{before}`"),
                    _ => format!("something is missing between `{before}` and `{}`", self.shown(word)),
                };
                (Diagnostic::error(word.span, message), "")
            }
            (_, None) => {
                (Diagnostic::error(word.span, format!("a statement cannot begin with `{}`", self.shown(word))), "")
            }
        };
        let error = error.label("expected a number, a name or a bracket");
        self.stop(if help.is_empty() { error } else { error.help(help) })
    }

    /// The error for an operator of other languages, if the word is one.
    pub(super) fn foreign_operator(&mut self, word: Token) -> Option<Stop> {
        let shown = self.shown(word);
        let (message, help) = match word.kind {
            TokenKind::NotEqual => (
                format!("there is no `{shown}`"),
                "write `a < b or a > b`; where both are equal is the surface `a = b`",
            ),
            TokenKind::Bang if self.previous().is_some_and(|before| before.span.end == word.span.start) => {
                ("there is no `!`".to_owned(), "factorials are not built; for regions write `not` in front")
            }
            TokenKind::Bang => ("there is no `!`".to_owned(), "write `not`"),
            TokenKind::Ampersand => (format!("there is no `{shown}`"), "write `and`"),
            _ => return None,
        };
        Some(self.stop(Diagnostic::error(word.span, message).help(help)))
    }

    /// Something stands behind what would have been a whole statement or entry.
    pub(super) fn leftover(&mut self) -> Stop {
        let word = self.peek();
        if let Some(stop) = self.foreign_operator(word) {
            return stop;
        }
        let shown = self.shown(word);
        let error = match word.kind {
            TokenKind::Equal => Diagnostic::error(word.span, "a statement has one `=` at most")
                .help("write two statements with `;` between them"),
            TokenKind::Comma => return self.stray_comma(word),
            TokenKind::Close(Bracket::Round | Bracket::Square | Bracket::Curly) => {
                Diagnostic::error(word.span, format!("this `{shown}` closes nothing"))
                    .help("take it away, or open its bracket before")
            }
            TokenKind::Colon => Diagnostic::error(word.span, "a `:` stands only between key and value in `{ }`")
                .help("for a definition write `=`"),
            TokenKind::Range => Diagnostic::error(word.span, "a range stands only in `sum`, `product` and `box`")
                .help("write `sum(k = 1..3, k*x)`"),
            TokenKind::In => Diagnostic::error(word.span, "`in` stands only behind a parameter's value and in sums")
                .help("write `a = 1 in [0, 2]`"),
            TokenKind::Not => Diagnostic::error(word.span, "`not` stands before a region").help("write `and not`"),
            TokenKind::Dot => {
                Diagnostic::error(word.span, "this dot belongs to no number").help("for a product write `*`")
            }
            TokenKind::Open(Bracket::Curly) => {
                Diagnostic::error(word.span, "a block stands only behind a surface or a solid")
                    .help("give it to the surface that uses this definition")
            }
            TokenKind::Semicolon => Diagnostic::error(word.span, "`;` cannot stand inside brackets").help("write `,`"),
            _ => Diagnostic::error(word.span, format!("`{shown}` does not fit here")).label("expected an operator"),
        };
        self.stop(error)
    }

    /// `1,5` was meant as 1.5.
    fn stray_comma(&mut self, comma: Token) -> Stop {
        let (before, after) = (self.previous(), self.second());
        let number = |token: &Token| token.kind == TokenKind::Number;
        if let Some(before) = before.filter(number)
            && number(&after)
            && before.span.end == comma.span.start
            && comma.span.end == after.span.start
        {
            let (whole, fraction) = (self.shown(before), self.shown(after));
            let error = Diagnostic::error(before.span.to(after.span), "a decimal comma");
            return self.stop(error.help(format!("write `{whole}.{fraction}`")));
        }
        let error = Diagnostic::error(comma.span, "a comma stands only between arguments, components or entries");
        self.stop(error.help("end a statement with `;` or a new line"))
    }
}
