//! The tree of a program: what was written, with nothing left to guess.
//!
//! In: nothing, it is plain data. Out: statements and expressions in which juxtaposition, bars, split names
//! and function application without brackets have become products and calls. Sums and products are flat
//! lists, so that a long line makes a wide tree and never a deep one: a tree is no deeper than the nest limit.

use crate::diag::Span;
use crate::num::rational::Rational;

/// A whole program, statements in the order they were written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// The statements.
    pub statements: Vec<Statement>,
}

/// One statement and the text it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// What it says.
    pub kind: StatementKind,
    /// Its text, without the terminator.
    pub span: Span,
}

/// What a statement can say.
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `f = g`, `f` or a region, with or without a block of attributes: something to draw.
    Surface {
        /// Left of `=`, or all of it.
        left: Expr,
        /// Right of `=`; `None` for a bare expression or a region.
        right: Option<Expr>,
        /// The block behind it.
        attributes: Vec<Attribute>,
    },
    /// `name = value`, where the name is no coordinate. `r = 1` is a definition only if another statement uses `r`.
    Definition {
        /// The name.
        name: Name,
        /// Its value: a number, a formula, a vector, a list or a region.
        value: Expr,
    },
    /// `name(u, v) = body`.
    Function {
        /// The name.
        name: Name,
        /// Its parameters, which shadow other names in the body.
        parameters: Vec<Name>,
        /// What it gives.
        body: Expr,
    },
    /// `a = 0.5 in [0, 1] step 0.1`.
    Parameter {
        /// The name.
        name: Name,
        /// The value without `--set`.
        value: Expr,
        /// The least value.
        low: Expr,
        /// The greatest.
        high: Expr,
        /// The step of a slider.
        step: Option<Expr>,
    },
    /// `material NAME { … }`, `light { … }`, `sun`, `sky`, `camera`, `render`.
    Block {
        /// Which of them.
        kind: BlockKind,
        /// The name of a material.
        name: Option<Name>,
        /// Its entries.
        attributes: Vec<Attribute>,
    },
    /// `include "file.imp"`.
    Include {
        /// The path as written.
        path: String,
        /// The place of the path.
        path_span: Span,
    },
}

/// The statements that are a word and a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockKind {
    /// A material that surfaces name.
    Material,
    /// A point or ball light.
    Light,
    /// A far light.
    Sun,
    /// The surroundings.
    Sky,
    /// The eye.
    Camera,
    /// What a flag can also say.
    Render,
}

/// `key: value` in a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    /// The key.
    pub key: Name,
    /// The value.
    pub value: AttributeValue,
}

/// What can stand behind a key.
#[derive(Clone, Debug, PartialEq)]
pub enum AttributeValue {
    /// An expression, region, vector or call; a bare word (`red`, `glass`) is an [`ExprKind::Name`].
    Expr(Expr),
    /// `#rgb` or `#rrggbb`: red, green, blue of 0..=255, sRGB.
    Color([u8; 3], Span),
    /// `"…"`.
    Text(String, Span),
    /// `800x600`.
    Size(u32, u32, Span),
    /// `checker(0.5, white, navy)`: one of [`super::functions::PAINTS`], whose arguments may be colours and texts.
    Call(Name, Vec<AttributeValue>, Span),
    /// `box(-2..2, -2..2, -2..2)`: the ranges.
    Box(Vec<(Expr, Expr)>, Span),
}

/// A name and its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The letters.
    pub text: String,
    /// Where.
    pub span: Span,
}

/// An expression and the text it takes, brackets included.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where.
    pub span: Span,
}

/// What an expression can be.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// An exact decimal.
    Number(Rational),
    /// A coordinate, constant, definition, parameter; a split name has become a product of these.
    Name(String),
    /// `-a`, `not a`, `+a`.
    Unary(UnaryOp, Box<Expr>),
    /// `a + b - c`, from the left: two terms or more, of which the first is added.
    Sum(Vec<Term>),
    /// `a * b / c % d`, from the left: two factors or more, of which the first multiplies.
    Product(Vec<Factor>),
    /// `a ^ b`, `a ** b` or a raised digit.
    Power(Box<Expr>, Box<Expr>),
    /// `a and b and c`: two or more.
    And(Vec<Expr>),
    /// `a or b or c`: two or more.
    Or(Vec<Expr>),
    /// `a <= b < c`: the operands and the comparisons between them, all in one direction.
    Chain(Vec<Expr>, Vec<Comparison>),
    /// `|a|`: absolute value, or length of a vector.
    Bars(Box<Expr>),
    /// `name(a, b)`: a function of the table, of the program, or `if`, `union`, `box`, `rgb`…
    Call(Name, Vec<Expr>),
    /// `(a, b, c)`.
    Vector(Vec<Expr>),
    /// `[a, b, c]`.
    List(Vec<Expr>),
    /// `p.x`.
    Component(Box<Expr>, Name),
    /// `sum(k = 1..n, body)`, `product(k in list, body)`.
    Series {
        /// Whether the terms are multiplied.
        product: bool,
        /// The running name.
        variable: Name,
        /// What it runs over.
        over: SeriesRange,
        /// The term.
        body: Box<Expr>,
    },
    /// What could not be read; an error has been reported, and whatever uses it should stay silent.
    Invalid,
}

/// What the running name of a sum takes as values.
#[derive(Clone, Debug, PartialEq)]
pub enum SeriesRange {
    /// `k = a..b`, both ends included.
    Integers(Box<Expr>, Box<Expr>),
    /// `c in list`.
    List(Box<Expr>),
}

/// Operators in front.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-`
    Neg,
    /// `+`
    Plus,
    /// `not`
    Not,
}

/// A member of a sum.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Whether it is taken away.
    pub minus: bool,
    /// What.
    pub value: Expr,
}

/// A member of a product.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    /// What is done with it to the product of those before.
    pub operator: FactorOp,
    /// What.
    pub value: Expr,
}

/// How a factor joins those before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FactorOp {
    /// `*`, `×`, `·` or nothing
    Mul,
    /// `/`, `÷`
    Div,
    /// `%`
    Mod,
}

/// Comparisons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
}
