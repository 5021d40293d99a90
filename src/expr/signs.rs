//! Which signs a node's values can have: what makes `sqrt(x^2+y^2)` total and its square free of a condition.
//!
//! In: an operation and the signs of its arguments. Out: a set that contains the sign of every value it has.
//! Separate because it is a small abstract domain of its own, next to the arena that stores it.

use super::op::Op;

/// A set of signs; the empty set belongs to a node that never has a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signs(u8);

const SINGLE: [Signs; 3] = [Signs::NEGATIVE, Signs::ZERO, Signs::POSITIVE];

impl Signs {
    /// Values < 0.
    pub const NEGATIVE: Signs = Signs(1);
    /// The value 0.
    pub const ZERO: Signs = Signs(2);
    /// Values > 0.
    pub const POSITIVE: Signs = Signs(4);
    /// Nothing is known.
    pub const ALL: Signs = Signs(7);
    /// Values ≤ 0.
    pub const NOT_POSITIVE: Signs = Signs(3);
    /// Values ≥ 0.
    pub const NOT_NEGATIVE: Signs = Signs(6);

    /// Whether every sign of this set is in the other.
    pub const fn within(self, other: Signs) -> bool {
        self.0 & !other.0 == 0
    }

    const fn and(self, other: Signs) -> Signs {
        Signs(self.0 & other.0)
    }

    const fn or(self, other: Signs) -> Signs {
        Signs(self.0 | other.0)
    }

    const fn nonzero(self) -> Signs {
        self.and(Signs(5))
    }

    const fn negated(self) -> Signs {
        Signs((self.0 & 1) << 2 | self.0 & 2 | self.0 >> 2)
    }

    const fn absolute(self) -> Signs {
        self.or(self.negated()).and(Signs::NOT_NEGATIVE)
    }

    /// The signs of all results, from the result for one sign each.
    fn combined(self, other: Signs, result: fn(Signs, Signs) -> Signs) -> Signs {
        let mut all = Signs(0);
        for a in SINGLE.into_iter().filter(|a| a.within(self)) {
            for b in SINGLE.into_iter().filter(|b| b.within(other)) {
                all = all.or(result(a, b));
            }
        }
        all
    }

    fn plus(self, other: Signs) -> Signs {
        self.combined(other, |a, b| match (a, b) {
            (Signs::ZERO, s) | (s, Signs::ZERO) => s,
            (a, b) if a == b => a,
            _ => Signs::ALL,
        })
    }

    fn times(self, other: Signs) -> Signs {
        self.combined(other, |a, b| match (a, b) {
            (Signs::ZERO, _) | (_, Signs::ZERO) => Signs::ZERO,
            (a, b) if a == b => Signs::POSITIVE,
            _ => Signs::NEGATIVE,
        })
    }

    fn floored(self) -> Signs {
        if Signs::POSITIVE.within(self) { self.or(Signs::ZERO) } else { self }
    }

    fn power(self, n: i64) -> Signs {
        let values = if n % 2 == 0 { self.absolute() } else { self };
        if n < 0 { values.nonzero() } else { values }
    }

    /// The signs of an operation's values; constants are the caller's.
    pub fn of(op: Op, [a, b, c]: [Signs; 3]) -> Signs {
        match op {
            Op::Constant(_) | Op::Variable(_) => Signs::ALL,
            Op::Pi | Op::E | Op::Exp | Op::Cosh => Signs::POSITIVE,
            Op::Ln | Op::Log2 | Op::Log10 | Op::Sin | Op::Cos | Op::Tan | Op::Atan2 => Signs::ALL,
            Op::Sign | Op::Asin | Op::Atan | Op::Sinh | Op::Tanh | Op::Asinh | Op::Atanh | Op::Erf | Op::Root(_) => a,
            Op::Acos | Op::Acosh => Signs::NOT_NEGATIVE,
            Op::Neg => a.negated(),
            Op::Abs => a.absolute(),
            Op::Sqrt => a.and(Signs::NOT_NEGATIVE),
            Op::Floor => a.floored(),
            Op::FloorDiv(_) => a.times(b.nonzero()).floored(),
            Op::Power(n) => a.power(n),
            Op::Add => a.plus(b),
            Op::Sub => a.plus(b.negated()),
            Op::Mul => a.times(b),
            Op::Div => a.times(b.nonzero()),
            Op::Min => a.combined(b, |a, b| Signs(a.0.min(b.0))),
            Op::Max => a.combined(b, |a, b| Signs(a.0.max(b.0))),
            Op::Pow => a.and(Signs::NOT_NEGATIVE),
            Op::Choose if a.within(Signs::NOT_POSITIVE) => b,
            Op::Choose if a.within(Signs::POSITIVE) => c,
            Op::Choose => b.or(c),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_and_products_of_signs() {
        let (n, z, p) = (Signs::NEGATIVE, Signs::ZERO, Signs::POSITIVE);
        let all = Signs::ALL;
        let rows = [
            (Op::Add, p, p, p),
            (Op::Add, p, n, all),
            (Op::Add, Signs::NOT_NEGATIVE, p, p),
            (Op::Sub, p, n, p),
            (Op::Mul, n, n, p),
            (Op::Mul, all, z, z),
            (Op::Div, p, all, n.or(p)),
            (Op::Min, p, n, n),
            (Op::Max, all, p, p),
            (Op::Power(2), all, z, Signs::NOT_NEGATIVE),
            (Op::Power(-2), all, z, p),
            (Op::Power(3), n, z, n),
            (Op::Abs, n, z, p),
            (Op::Sqrt, n, z, Signs(0)),
            (Op::Floor, p, z, Signs::NOT_NEGATIVE),
            (Op::FloorDiv(3), p, p, Signs::NOT_NEGATIVE),
            (Op::FloorDiv(3), p, n, n),
        ];
        for (op, a, b, expected) in rows {
            assert_eq!(Signs::of(op, [a, b, Signs(0)]), expected, "{op:?} {a:?} {b:?}");
        }
    }
}
