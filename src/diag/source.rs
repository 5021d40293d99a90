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
