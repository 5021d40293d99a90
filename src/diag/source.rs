//! Texts that were typed or read, and places in them.
//!
//! In: names and contents. Out: line and column of a byte offset.
//! Separate from the messages so that a tree can carry places without knowing how they are shown.

/// Which text of a [`Sources`] a place is in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SourceId(pub u32);

/// A half-open range of bytes in one text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// The text.
    pub source: SourceId,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

/// One text with the name it is shown under (`<argument 1>`, a file's name, `<stdin>`).
#[derive(Clone, Debug)]
pub struct Source {
    /// The name shown behind `-->`.
    pub name: String,
    /// The whole text.
    pub text: String,
}

/// All texts of one run, in the order in which they were given.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    /// The texts; a [`SourceId`] is an index into this list.
    pub list: Vec<Source>,
}

/// A line and a column, both counted from 1, the column in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
}

impl Span {
    /// The bytes from `start` up to `end` of a text. Texts are at most 4 GiB: places beyond are moved to the end.
    pub fn new(source: SourceId, start: usize, end: usize) -> Self {
        let place = |at: usize| u32::try_from(at).unwrap_or(u32::MAX);
        Span { source, start: place(start), end: place(end.max(start)) }
    }

    /// The span from the start of this one to the end of a later one of the same text.
    pub fn to(self, later: Span) -> Self {
        Span { source: self.source, start: self.start.min(later.start), end: self.end.max(later.end) }
    }

    /// The empty span at the end of this one.
    pub fn after(self) -> Self {
        Span { start: self.end, ..self }
    }

    /// The bytes as a range.
    pub fn range(self) -> std::ops::Range<usize> {
        self.start as usize..self.end as usize
    }
}

impl Sources {
    /// No texts.
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes in one more text and says how spans refer to it.
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<String>) -> SourceId {
        let id = u32::try_from(self.list.len()).unwrap_or(u32::MAX);
        self.list.push(Source { name: name.into(), text: text.into() });
        SourceId(id)
    }

    /// The text behind an id, if there is one.
    pub fn get(&self, id: SourceId) -> Option<&Source> {
        self.list.get(id.0 as usize)
    }

    /// The id and the text of each, as the parser takes them.
    pub fn texts(&self) -> Vec<(SourceId, &str)> {
        self.list.iter().enumerate().map(|(i, source)| (SourceId(i as u32), source.text.as_str())).collect()
    }

    /// What a span covers; empty if the span is not of these texts.
    pub fn text(&self, span: Span) -> &str {
        self.get(span.source).and_then(|source| source.text.get(span.range())).unwrap_or("")
    }

    /// Where a span starts.
    pub fn position(&self, span: Span) -> Position {
        self.get(span.source).map_or(Position { line: 1, column: 1 }, |source| source.position(span.start as usize))
    }
}

impl Source {
    /// Line and column of a byte; that of the end for a byte beyond it.
    pub fn position(&self, byte: usize) -> Position {
        let line = self.line_range(byte);
        let before = &self.text.as_bytes()[..line.start];
        let number = 1 + before.iter().filter(|&&b| b == b'\n').count();
        let inside = self.text[line.clone()].char_indices().take_while(|(i, _)| line.start + i < byte).count();
        Position { line: number, column: 1 + inside }
    }

    /// The bytes of the line that a byte is in, without the line's end.
    pub fn line_range(&self, byte: usize) -> std::ops::Range<usize> {
        let bytes = self.text.as_bytes();
        let byte = byte.min(bytes.len());
        let start = bytes[..byte].iter().rposition(|&b| b == b'\n').map_or(0, |i| i + 1);
        let mut end = bytes[byte..].iter().position(|&b| b == b'\n').map_or(bytes.len(), |i| byte + i);
        if end > start && bytes[end - 1] == b'\r' {
            end -= 1;
        }
        start..end
    }
}
