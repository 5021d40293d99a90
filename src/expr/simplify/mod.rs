//! The named rules that every new node goes through; none changes where f is defined, nor any value.
//!
//! In: an operation and its arguments, themselves simplified. Out: the simplest node known to be equal.
//! Separate from the arena so that each rule can be named, shown and tested. A power is never expanded: the cost of a
//! rule does not depend on the size of an exponent, nor, beyond a fixed depth, on that of the arguments.
//!
//! - [`constants`]: exact folding. - [`terms`]: sums and multiples. - [`factors`]: products, quotients, powers.
//! - [`functions`]: parity, inverse functions. - [`branches`]: least, greatest, chosen.

mod branches;
mod constants;
mod factors;
mod functions;
mod terms;
#[cfg(test)]
mod tests;

use super::graph::{Graph, NodeId};
use super::op::Op;

/// What a rule does: the better node, or `None` where it does not apply.
type Rewrite = fn(&mut Graph, Op, &[NodeId]) -> Option<NodeId>;

/// One rule, as a person may be told it.
#[derive(Clone, Copy, Debug)]
pub struct Rule {
    /// A short name.
    pub name: &'static str,
    /// What it says, in the language of formulas.
    pub statement: &'static str,
    rewrite: Rewrite,
}

const fn rule(name: &'static str, statement: &'static str, rewrite: Rewrite) -> Rule {
    Rule { name, statement, rewrite }
}

/// The rules in the order in which they are tried; the first that applies wins.
pub static RULES: [Rule; 35] = [
    rule("trivial power", "u^1 = u; u^0 = 1 where u is defined; u^-1 = 1/u", factors::trivial_power),
    rule("exact arithmetic", "2 + 3*4 = 14, sqrt(9/4) = 3/2, in fractions", constants::arithmetic),
    rule("exact function value", "sin(0) = 0, exp(0) = 1, ln(e) = 1, log2(8) = 3, ...", constants::function_value),
    rule("angle", "sin and cos of pi/6, pi/2, ... and tan of pi/4, ... where they are rational", constants::angle),
    rule(
        "powers of constants",
        "8^0.5 = sqrt(8), u^1.5 = sqrt(u)^3, 0.008^(1/3) = 0.2, e^u = exp(u)",
        constants::power,
    ),
    rule("double negation", "-(-u) = u, -(a - b) = b - a, -(2*u) = -2*u", terms::negation),
    rule("constants together", "(u + 1) + 2 = u + 3, u - 1 = u + (-1), u + 0 = u", terms::constants_of_sum),
    rule("like terms", "2*u + 3*u = 5*u, u - u = 0 where u is defined", terms::like_terms),
    rule("squares of sine and cosine", "sin(u)^2 + cos(u)^2 = 1 where u is defined", terms::sine_and_cosine),
    rule("signs of terms", "a + (-b) = a - b, a - (-b) = a + b, -a - b = -(a + b)", terms::signs_of_terms),
    rule("constant factor", "2*(3*u) = 6*u, 1*u = u, 0*u = 0 where u is defined", factors::constant_factor),
    rule("factors out in front", "(2*u)*(3*v) = 6*(u*v), (-u)*v = -(u*v)", factors::factors_in_front),
    rule("constant divisor", "u/4 = 0.25*u, (6*u)/3 = 2*u", factors::constant_divisor),
    rule("constants of a quotient", "(6*u)/(2*v) = 3*(u/v), 0/u = 0 where u is not 0", factors::constants_of_quotient),
    rule("product with a reciprocal", "u*(1/v) = u/v", factors::reciprocal_factor),
    rule("like factors", "u*u = u^2, u^2*u^3 = u^5; not u^2*u^-1", factors::like_factors),
    rule("product of exponentials", "exp(u)*exp(v) = exp(u + v)", factors::exponentials),
    rule("power of a power", "(u^2)^3 = u^6, (1/u)^2 = u^-2; not (u^-1)^-1", factors::power_of_power),
    rule(
        "power of a root",
        "root(3, u)^3 = u; sqrt(u)^2 = u where u >= 0 is known; exp(u)^2 = exp(2*u), e^2 = exp(2)",
        factors::power_of_root,
    ),
    rule("even power", "(-u)^2 = u^2, |u|^2 = u^2, (-u)^3 = -u^3", factors::parity),
    rule(
        "root of a power",
        "sqrt(u^2) = |u|, root(3, u^3) = u, root(3, root(5, u)) = root(15, u)",
        factors::root_of_power,
    ),
    rule("absolute value", "|-u| = |u|, |2*u| = 2*|u|, |u| = u where u >= 0 is known", functions::absolute),
    rule("odd function", "sin(-u) = -sin(u), and so tan asin atan sinh tanh asinh atanh erf sign root", functions::odd),
    rule("even function", "cos(-u) = cos(u), cos(|u|) = cos(u), cosh too", functions::even),
    rule("logarithm of an exponential", "ln(exp(u)) = u; exp(ln(u)) = u only where u > 0 is known", functions::inverse),
    rule("known sign", "sign(u) = 1 where u > 0 is known", functions::known_sign),
    rule("floor of a whole number", "floor(floor(u)) = floor(u), floor(u + 2) = floor(u) + 2", functions::whole),
    rule(
        "floor of a quotient",
        "floor(2*u/(3*v)) is one operation, of the quotient before rounding",
        functions::floor_of_quotient,
    ),
    rule("least of equals", "min(u, u) = u, max(u, u) = u", branches::equals),
    rule("least of constants", "min(2, 3) = 2, min(min(u, 2), 3) = min(u, 2)", branches::constants),
    rule("repeated least", "min(min(u, v), v) = min(u, v)", branches::repeated),
    rule("both sides", "max(u, -u) = |u|, min(u, -u) = -|u|", branches::both_sides),
    rule("least of opposites", "min(-u, -v) = -max(u, v)", branches::opposites),
    rule(
        "decided condition",
        "if(1 <= 0, a, b) = b: the branch that is never taken need have no value",
        branches::decided,
    ),
    rule("equal branches", "if(c, u, u) = u where c is defined", branches::equal_branches),
];

impl Graph {
    /// The simplest node known to equal `op` of `args` wherever that has a value, and to have none elsewhere.
    pub fn apply(&mut self, op: Op, args: &[NodeId]) -> NodeId {
        self.apply_named(op, args).0
    }

    /// As [`Graph::apply`], with the rule that made the result; `None` if the node is just what was asked for.
    pub fn apply_named(&mut self, op: Op, args: &[NodeId]) -> (NodeId, Option<&'static Rule>) {
        let mut ordered = [NodeId(0); 3];
        let args = self.in_order(op, args, &mut ordered);
        for rule in &RULES {
            if let Some(id) = (rule.rewrite)(self, op, args) {
                return (id, Some(rule));
            }
        }
        (self.intern(op, args), None)
    }

    /// The arguments in the order in which equal sums and products become one node: constants first in a product
    /// and last elsewhere, else in the order of their making.
    fn in_order<'a>(&self, op: Op, args: &[NodeId], ordered: &'a mut [NodeId; 3]) -> &'a [NodeId] {
        ordered[..args.len()].copy_from_slice(args);
        if matches!(op, Op::Add | Op::Mul | Op::Min | Op::Max) {
            let key = |id: NodeId| (self.constant(id).is_some() != (op == Op::Mul), id);
            if key(ordered[0]) > key(ordered[1]) {
                ordered.swap(0, 1);
            }
        }
        &ordered[..args.len()]
    }

    /// 0 wherever `u` has a value.
    fn zero_where_defined(&mut self, u: NodeId) -> NodeId {
        let zero = self.integer(0);
        if self.is_total(u) { zero } else { self.intern(Op::Mul, &[zero, u]) }
    }
}
