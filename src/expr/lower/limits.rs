//! Limits, so that no text, however short, long or deep, makes the program hang or crash.
//!
//! In: what is being built. Out: one located error, after which nothing more is built or said.

use super::{Lowerer, Reported, Reporting};
use crate::diag::{Diagnostic, Span};

/// Most nodes of a program's graph; the terms of sums and products count as nodes too. A formula at this limit
/// still compiles in about a second and costs about 0.1 ms a point.
pub const MAX_NODES: usize = 100_000;

/// Most definitions that may stand on each other in a row: more than any hand writes, and each may add
/// its own depth to the graph.
pub const MAX_CHAIN: u32 = 1000;

/// Deepest nest of brackets and calls together. One level takes about 1 KiB of stack in a build without
/// optimisation, and the smallest stacks have 2 MiB.
pub const MAX_DEPTH: u32 = 800;

/// Longest way from a formula's root to a leaf: closures are as deep as the graph, at about 200 bytes of stack a level.
pub const MAX_GRAPH_DEPTH: u32 = 4000;

/// Most steps of lowering: terms that make no new node still take time. About a second.
pub const MAX_STEPS: u64 = 3_000_000;

/// Levels that a call of a program's own function takes of [`MAX_DEPTH`], beside those of its body.
pub(super) const CALL_WEIGHT: u32 = 1;

impl Lowerer<'_> {
    /// Enters an expression; every `enter` that succeeds has its `leave`.
    pub(super) fn enter(&mut self, span: Span, weight: u32) -> Reporting<()> {
        self.steps += 1;
        if self.depth + weight > MAX_DEPTH {
            return Err(self.stop(span, "this is nested too deep", "brackets and calls", u64::from(MAX_DEPTH)));
        }
        if self.steps > MAX_STEPS {
            return Err(self.stop(span, "this takes too many steps to build", "steps", MAX_STEPS));
        }
        self.check_size(span)?;
        self.depth += weight;
        Ok(())
    }

    /// Leaves an expression.
    pub(super) fn leave(&mut self, weight: u32) {
        self.depth -= weight;
    }

    /// Counts terms of a series toward the limit of nodes.
    pub(super) fn count_terms(&mut self, count: u64, span: Span) -> Reporting<()> {
        if count > MAX_NODES as u64 {
            let message = format!("this has more terms than the {MAX_NODES} nodes a program may have");
            return Err(self.fail(Diagnostic::error(span, message).help("take fewer terms")));
        }
        if count == 1 {
            self.terms += 1;
        }
        self.check_size(span)
    }

    /// Refuses to go on when the program has grown too large.
    pub(super) fn check_size(&mut self, span: Span) -> Reporting<()> {
        if self.stopped {
            return Err(Reported);
        }
        if self.graph.len() + self.terms > MAX_NODES {
            return Err(self.stop(
                span,
                "here the program has grown too large",
                "nodes, terms of sums included",
                MAX_NODES as u64,
            ));
        }
        Ok(())
    }

    /// Refuses a formula whose graph is deeper than closures may be.
    pub(super) fn check_graph_depth(&mut self, root: crate::expr::graph::NodeId, span: Span) -> Reporting<()> {
        while self.depths.len() < self.graph.len() {
            let id = crate::expr::graph::NodeId(self.depths.len() as u32);
            let below = self.graph.args(id).iter().map(|a| self.depths[a.0 as usize]).max();
            self.depths.push(below.map_or(0, |depth| depth + 1));
        }
        if self.depths[root.0 as usize] > MAX_GRAPH_DEPTH {
            let message = "the operations of this formula stand too deep in one another";
            return Err(self.stop(span, message, "operations in a row", u64::from(MAX_GRAPH_DEPTH)));
        }
        Ok(())
    }

    fn stop(&mut self, span: Span, message: &str, what: &str, limit: u64) -> Reported {
        self.fail(Diagnostic::error(span, message).help(format!("the limit is {limit} {what}")))
    }

    /// Reports an error after which nothing more is built or said.
    fn fail(&mut self, diagnostic: Diagnostic) -> Reported {
        let reported = self.report(diagnostic);
        self.stopped = true;
        reported
    }
}
