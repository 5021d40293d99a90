//! What an expression can be, and the arithmetic of it.
//!
//! In: values of operands with their places. Out: the value of the operation, or an error that says which
//! kind stood where which was wanted. Separate because vectors and lists end here: the graph knows numbers alone.

use super::regions::Region;
use super::{Lowerer, Reported, Reporting};
use crate::diag::{Diagnostic, Span};
use crate::expr::graph::NodeId;
use crate::expr::op::Op;
use std::sync::Arc;

/// What an expression stands for.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Value {
    /// A number or a formula of x, y, z.
    Number(NodeId),
    /// A set of points.
    Region(Region),
    /// Two or three numbers: a point or a direction.
    Vector(Vec<NodeId>),
    /// Numbers, vectors or regions in a row.
    List(Arc<[Value]>),
}

impl Value {
    /// The kind in the words of messages, with its article.
    pub fn kind(&self) -> &'static str {
        match self {
            Value::Number(_) => "a number",
            Value::Region(_) => "a region",
            Value::Vector(_) => "a vector",
            Value::List(_) => "a list",
        }
    }

    /// The nodes the value is made of; of a region the function that is negative inside.
    pub fn nodes(&self) -> Vec<NodeId> {
        match self {
            Value::Number(id) => vec![*id],
            Value::Region(region) => vec![region.side],
            Value::Vector(items) => items.clone(),
            Value::List(items) => items.iter().flat_map(Value::nodes).collect(),
        }
    }
}

/// A value and the text it came from, for messages.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub(super) value: Value,
    pub(super) span: Span,
}

/// The sign in front of a term of a sum, or whether a factor divides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// `+` or `*`
    Over,
    /// `-` or `/`
    Under,
}

impl Lowerer<'_> {
    /// The number, or an error that says what stands there.
    pub(super) fn wanted_number(&mut self, placed: Placed) -> Reporting<NodeId> {
        match placed.value {
            Value::Number(id) => Ok(id),
            other => {
                let kind = other.kind();
                let way_out = match other {
                    Value::Region(_) => "a region such as `y < 0` has no value; `if(y < 0, 1, 0)` makes a number of it",
                    Value::Vector(_) => "take a component such as `p.x`, the length `|p|` or a product `dot(p, q)`",
                    Value::List(_) | Value::Number(_) => "a list is for sums: `sum(c in list, ...)`",
                };
                let message = format!("{kind} stands where a number is wanted");
                Err(self.report(Diagnostic::error(placed.span, message).help(way_out)))
            }
        }
    }

    /// The components, or an error that says what stands there.
    pub(super) fn wanted_vector(&mut self, placed: Placed) -> Reporting<Vec<NodeId>> {
        match placed.value {
            Value::Vector(items) => Ok(items),
            other => {
                let message = format!("{} stands where a vector is wanted", other.kind());
                Err(self.report(Diagnostic::error(placed.span, message).help("a vector is written `(a, b, c)`")))
            }
        }
    }

    /// a + b or a − b of two numbers or two vectors of one length.
    pub(super) fn add_values(&mut self, left: Placed, side: Side, right: Placed, span: Span) -> Reporting<Value> {
        let op = if side == Side::Over { Op::Add } else { Op::Sub };
        match (&left.value, &right.value) {
            (Value::Number(a), Value::Number(b)) => Ok(Value::Number(self.node(op, &[*a, *b], span))),
            (Value::Vector(a), Value::Vector(b)) => {
                self.same_length(a.len(), b.len(), &left, &right, span)?;
                Ok(Value::Vector(a.iter().zip(b).map(|(&a, &b)| self.node(op, &[a, b], span)).collect()))
            }
            (Value::Vector(_), Value::Number(_)) | (Value::Number(_), Value::Vector(_)) => {
                let (verb, preposition) = if side == Side::Over { ("add", "to") } else { ("subtract", "from") };
                let message = "a number and a vector cannot be added or subtracted";
                let help = format!("{verb} a vector {preposition} a vector: `p + (1, 1, 1)`, or use the length `|p|`");
                let error = Diagnostic::error(span, message);
                let error = error.also(left.span, format!("this is {}", left.value.kind()));
                Err(self.report(error.also(right.span, format!("this is {}", right.value.kind())).help(help)))
            }
            (Value::Number(_) | Value::Vector(_), _) => self.wanted_number(right).map(Value::Number),
            (_, Value::Number(_) | Value::Vector(_)) => self.wanted_number(left).map(Value::Number),
            _ => {
                let first = self.wanted_number(left);
                self.wanted_number(right).and(first).map(Value::Number)
            }
        }
    }

    /// a · b or a / b, where one of a product's factors and a quotient's dividend may be a vector.
    pub(super) fn multiply_values(&mut self, left: Placed, side: Side, right: Placed, span: Span) -> Reporting<Value> {
        let op = if side == Side::Over { Op::Mul } else { Op::Div };
        match (&left.value, &right.value) {
            (Value::Number(a), Value::Number(b)) => Ok(Value::Number(self.node(op, &[*a, *b], span))),
            (Value::Vector(v), Value::Number(s)) => {
                Ok(Value::Vector(v.iter().map(|&a| self.node(op, &[a, *s], span)).collect()))
            }
            (Value::Number(s), Value::Vector(v)) if side == Side::Over => {
                Ok(Value::Vector(v.iter().map(|&a| self.node(op, &[*s, a], span)).collect()))
            }
            (Value::Vector(_), Value::Vector(_)) if side == Side::Over => {
                let error = Diagnostic::error(span, "two vectors have no product `*`");
                Err(self.report(error.help("write `dot(p, q)` for the number, `cross(p, q)` for the vector")))
            }
            (_, Value::Vector(_)) if side == Side::Under => {
                let error = Diagnostic::error(right.span, "nothing can be divided by a vector");
                Err(self.report(error.help("divide by its length `|p|` or by a component such as `p.x`")))
            }
            (Value::Number(_) | Value::Vector(_), _) => self.wanted_number(right).map(Value::Number),
            _ => self.wanted_number(left).map(Value::Number),
        }
    }

    /// −a of a number or a vector.
    pub(super) fn negate_value(&mut self, placed: Placed, span: Span) -> Reporting<Value> {
        match placed.value {
            Value::Vector(items) => {
                Ok(Value::Vector(items.into_iter().map(|a| self.node(Op::Neg, &[a], span)).collect()))
            }
            _ => {
                let a = self.wanted_number(placed)?;
                Ok(Value::Number(self.node(Op::Neg, &[a], span)))
            }
        }
    }

    /// |a|: absolute value, or length of a vector.
    pub(super) fn magnitude(&mut self, placed: Placed, span: Span) -> Reporting<Value> {
        match &placed.value {
            Value::Vector(items) => Ok(Value::Number(self.length(items, span))),
            _ => {
                let a = self.wanted_number(placed)?;
                Ok(Value::Number(self.node(Op::Abs, &[a], span)))
            }
        }
    }

    /// √(Σ aᵢ²), remembered so that its square can be taken without the root.
    pub(super) fn length(&mut self, items: &[NodeId], span: Span) -> NodeId {
        let square = self.dot(items, items, span);
        let length = self.node(Op::Sqrt, &[square], span);
        self.squares_of_lengths.insert(length, square);
        length
    }

    /// Σ aᵢ·bᵢ.
    pub(super) fn dot(&mut self, a: &[NodeId], b: &[NodeId], span: Span) -> NodeId {
        let terms: Vec<NodeId> = a
            .iter()
            .zip(b)
            .map(|(&a, &b)| if a == b { self.integer_power(a, 2, span) } else { self.node(Op::Mul, &[a, b], span) })
            .collect();
        self.fold(Op::Add, &terms, span)
    }

    /// a × b of two vectors of three.
    pub(super) fn cross(&mut self, a: &[NodeId], b: &[NodeId], span: Span) -> Value {
        let component = |lowerer: &mut Self, i: usize, j: usize| {
            let (plus, minus) =
                (lowerer.node(Op::Mul, &[a[i], b[j]], span), lowerer.node(Op::Mul, &[a[j], b[i]], span));
            lowerer.node(Op::Sub, &[plus, minus], span)
        };
        Value::Vector(vec![component(self, 1, 2), component(self, 2, 0), component(self, 0, 1)])
    }

    /// `p.x`.
    pub(super) fn component(&mut self, placed: Placed, letter: &str, letter_span: Span) -> Reporting<Value> {
        let items = self.wanted_vector(placed)?;
        let index = ["x", "y", "z"].iter().position(|&known| known == letter);
        match index.and_then(|index| items.get(index)) {
            Some(&id) => Ok(Value::Number(id)),
            None => {
                let known = if items.len() == 2 { "`.x` and `.y`" } else { "`.x`, `.y` and `.z`" };
                let message = format!("a vector of {} numbers has no component `{letter}`", items.len());
                Err(self.report(Diagnostic::error(letter_span, message).help(format!("it has {known}"))))
            }
        }
    }

    /// Refuses two vectors of different length.
    pub(super) fn same_length(
        &mut self,
        a: usize,
        b: usize,
        left: &Placed,
        right: &Placed,
        span: Span,
    ) -> Reporting<()> {
        if a == b {
            return Ok(());
        }
        let error = Diagnostic::error(span, "these vectors have different lengths");
        let error = error.also(left.span, format!("{a} numbers")).also(right.span, format!("{b} numbers"));
        Err(self.report(error.help("give both two or both three numbers")))
    }

    /// `op` over all items: as typed from the left while they are few, in balanced halves when they are many,
    /// so that a long series makes a shallow graph; the empty sum is 0, the empty product 1.
    pub(super) fn fold(&mut self, op: Op, items: &[NodeId], span: Span) -> NodeId {
        match items {
            [] => self.integer(if op == Op::Mul { 1 } else { 0 }, span),
            [one] => *one,
            _ if items.len() <= FOLDED_FROM_THE_LEFT => {
                let mut total = items[0];
                for &item in &items[1..] {
                    total = self.node(op, &[total, item], span);
                }
                total
            }
            _ => {
                let (low, high) = items.split_at(items.len() / 2);
                let (low, high) = (self.fold(op, low, span), self.fold(op, high, span));
                self.node(op, &[low, high], span)
            }
        }
    }

    /// A whole number as a node.
    pub(super) fn integer(&mut self, value: i64, span: Span) -> NodeId {
        self.graph.set_span(Some(span));
        self.graph.integer(value)
    }

    /// The node of an operation, with its text.
    pub(super) fn node(&mut self, op: Op, args: &[NodeId], span: Span) -> NodeId {
        self.graph.set_span(Some(span));
        self.graph.apply(op, args)
    }
}

/// A series of up to this many terms is added in the order it was written.
pub(super) const FOLDED_FROM_THE_LEFT: usize = 16;

/// The value of an error that was already reported.
pub(super) fn reported<T>() -> Reporting<T> {
    Err(Reported)
}
