//! Programs that include others.
//!
//! In: parsed programs and a loader. Out: all texts, each once, or located errors: circles, too many, too deep, what
//! the loader could not read. Separate from the loader, which knows files and no program.

use super::program::Text;
use crate::diag::{Diagnostic, SourceId, Sources, Span};
use crate::syntax::ast::{Program, StatementKind};

/// How deep includes may nest: more than a project has folders.
pub const MAX_LEVELS: usize = 16;

/// How many files one program may be made of.
pub const MAX_FILES: usize = 100;

/// A text that was read.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// What tells this text from all others, however it was named: a file's true path.
    pub key: String,
    /// The name shown in messages.
    pub name: String,
    /// The text.
    pub text: String,
}

/// Reads the texts that programs include.
pub trait Loader {
    /// The text at `path` as written in the text with key `from`; an empty key is a text that is no file.
    ///
    /// # Errors
    /// Why it cannot be read, in a few words without a final dot.
    fn load(&self, from: &str, path: &str) -> Result<Loaded, String>;
}

/// A loader for programs that may include nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Loader for NoFiles {
    fn load(&self, _from: &str, _path: &str) -> Result<Loaded, String> {
        Err("this program may not include files".into())
    }
}

/// A text and the one that included it.
struct Origin {
    key: String,
    parent: Option<usize>,
}

/// The texts of a program, growing by what they include.
pub(super) struct Texts<'a> {
    pub(super) sources: Sources,
    pub(super) diagnostics: Vec<Diagnostic>,
    origins: Vec<Origin>,
    loader: &'a dyn Loader,
    /// Includes that were followed: the place of each.
    followed: Vec<Span>,
}

impl<'a> Texts<'a> {
    pub(super) fn new(texts: Vec<Text>, loader: &'a dyn Loader) -> Self {
        let mut all = Texts {
            sources: Sources::default(),
            diagnostics: Vec::new(),
            origins: Vec::new(),
            loader,
            followed: Vec::new(),
        };
        for text in texts {
            all.sources.add(text.name, text.text);
            all.origins.push(Origin { key: text.key, parent: None });
        }
        all
    }

    /// Loads what the program includes and was not loaded yet; whether there was anything.
    pub(super) fn follow(&mut self, program: &Program) -> bool {
        let before = self.sources.list.len();
        for statement in &program.statements {
            if let StatementKind::Include { path, path_span } = &statement.kind
                && !self.followed.contains(path_span)
            {
                self.followed.push(*path_span);
                if let Err(diagnostic) = self.include(path, *path_span) {
                    self.diagnostics.push(diagnostic);
                }
            }
        }
        self.sources.list.len() > before
    }

    fn include(&mut self, path: &str, span: Span) -> Result<(), Diagnostic> {
        let SourceId(parent) = span.source;
        let parent = parent as usize;
        let from = self.origins.get(parent).map_or("", |origin| origin.key.as_str());
        let loaded = self.loader.load(from, path).map_err(|why| {
            Diagnostic::error(span, format!("cannot include '{}': {why}", crate::diag::printable(path, 80)))
        })?;
        let ancestors: Vec<usize> =
            std::iter::successors(Some(parent), |&at| self.origins.get(at).and_then(|origin| origin.parent)).collect();
        if ancestors.iter().any(|&at| self.origins[at].key == loaded.key) {
            return Err(Diagnostic::error(span, "this file includes itself, by way of what it includes")
                .help("leave one of the includes out"));
        }
        if ancestors.len() >= MAX_LEVELS {
            return Err(Diagnostic::error(span, format!("includes are nested more than {MAX_LEVELS} levels deep")));
        }
        if self.origins.iter().any(|origin| origin.key == loaded.key) {
            return Ok(());
        }
        if self.origins.len() >= MAX_FILES {
            return Err(Diagnostic::error(span, format!("the program is made of more than {MAX_FILES} files")));
        }
        self.sources.add(loaded.name, loaded.text);
        self.origins.push(Origin { key: loaded.key, parent: Some(parent) });
        Ok(())
    }
}
