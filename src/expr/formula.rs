//! For tests: formulas as text, in a graph of one's own choice.
//!
//! In: text with explicit operators. Out: a node. Separate from the parser so that the algebra can be tested on its
//! own; [`typed`] goes the real way. Knows `+ - * / ^`, brackets, numbers, x y z, pi, e, and the
//! operations under their names; `^` takes whole exponents, else it is `pow`.

use super::graph::{Graph, NodeId};
use super::op::{Op, Variable};
use crate::num::rational::Rational;

/// The node of a formula; panics on anything else.
pub(crate) fn formula(graph: &mut Graph, text: &str) -> NodeId {
    let text: Vec<char> = text.chars().filter(|c| !c.is_whitespace()).collect();
    let mut reader = Reader { graph, text, at: 0 };
    let id = reader.sum();
    assert_eq!(reader.at, reader.text.len(), "unread: {}", reader.text[reader.at..].iter().collect::<String>());
    id
}

/// The graph and the node of a formula by the parser and the lowering.
pub(crate) fn typed(text: &str) -> (Graph, NodeId) {
    let program = crate::syntax::parse(&[(crate::diag::SourceId(0), text)]);
    let lowered = super::lower::lower(&program.program, &super::lower::Settings::default());
    let [surface] = &lowered.surfaces[..] else {
        panic!("{text}: {:?} {:?}", program.diagnostics, lowered.diagnostics)
    };
    let f = surface.f;
    (lowered.graph, f)
}

struct Reader<'a> {
    graph: &'a mut Graph,
    text: Vec<char>,
    at: usize,
}

impl Reader<'_> {
    fn peek(&self) -> char {
        self.text.get(self.at).copied().unwrap_or(' ')
    }

    fn take(&mut self, c: char) -> bool {
        let found = self.peek() == c;
        self.at += usize::from(found);
        found
    }

    fn sum(&mut self) -> NodeId {
        let mut left = self.product();
        loop {
            let op = if self.take('+') {
                Op::Add
            } else if self.take('-') {
                Op::Sub
            } else {
                return left;
            };
            let right = self.product();
            left = self.graph.apply(op, &[left, right]);
        }
    }

    fn product(&mut self) -> NodeId {
        let mut left = self.signed();
        loop {
            let op = if self.take('*') {
                Op::Mul
            } else if self.take('/') {
                Op::Div
            } else {
                return left;
            };
            let right = self.signed();
            left = self.graph.apply(op, &[left, right]);
        }
    }

    fn signed(&mut self) -> NodeId {
        if self.take('-') {
            let a = self.signed();
            return self.graph.apply(Op::Neg, &[a]);
        }
        let base = self.atom();
        if !self.take('^') {
            return base;
        }
        let start = self.at;
        let exponent = self.signed();
        // An exponent with a coordinate in it varies, whatever it folds to.
        let varies = self.text[start..self.at].iter().any(|c| matches!(c, 'x' | 'y' | 'z'));
        match self.graph.constant(exponent).and_then(Rational::to_i64) {
            Some(n) if !varies => self.graph.apply(Op::Power(n), &[base]),
            _ => self.graph.apply(Op::Pow, &[base, exponent]),
        }
    }

    fn atom(&mut self) -> NodeId {
        if self.take('(') {
            let inner = self.sum();
            assert!(self.take(')'), "missing )");
            return inner;
        }
        let start = self.at;
        while self.peek().is_ascii_alphanumeric() || self.peek() == '.' {
            self.at += 1;
        }
        let word: String = self.text[start..self.at].iter().collect();
        if word.starts_with(|c: char| c.is_ascii_digit()) {
            let value = Rational::from_decimal(&word).unwrap_or_else(|| panic!("{word}"));
            return self.graph.number(value);
        }
        match word.as_str() {
            "x" => self.graph.variable(Variable::X),
            "y" => self.graph.variable(Variable::Y),
            "z" => self.graph.variable(Variable::Z),
            "pi" => self.graph.apply(Op::Pi, &[]),
            "e" => self.graph.apply(Op::E, &[]),
            name => self.call(name),
        }
    }

    fn call(&mut self, name: &str) -> NodeId {
        assert!(self.take('('), "{name}");
        let mut args = vec![self.sum()];
        if name == "if" {
            assert!(self.take('<') && self.take('=') && self.take('0'), "if takes <= 0");
        }
        while self.take(',') {
            args.push(self.sum());
        }
        assert!(self.take(')'), "missing )");
        let op = match name {
            "cbrt" => Op::Root(3),
            "if" => Op::Choose,
            "root" => {
                let order = self.graph.constant(args.remove(0)).and_then(Rational::to_i64);
                Op::Root(order.and_then(|n| u32::try_from(n).ok()).expect("the order of a root"))
            }
            name => Op::ALL
                .into_iter()
                .find(|op| op.arity() > 0 && format!("{op:?}").to_lowercase() == name)
                .unwrap_or_else(|| panic!("{name}")),
        };
        self.graph.apply(op, &args)
    }
}
