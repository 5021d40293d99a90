//! THE table of operations: each is named once, here, and exists in every family of closures, in
//! the derivative and in print; the `match`es have no `_` arm, and the tests walk [`Op::ALL`].

/// An operation of the graph: what a node does with its arguments.
///
/// `None` of the arguments may be without value (NaN), or the result is without value, except in the
/// branch of [`Op::Choose`] that is not taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Op {
    /// An exact rational number: an index into [`super::graph::Graph::constants`].
    Constant(u32),
    /// π.
    Pi,
    /// Euler's number.
    E,
    /// A coordinate, or a component of a ray's direction.
    Variable(Variable),
    /// −a.
    Neg,
    /// |a|.
    Abs,
    /// −1, 0 or 1.
    Sign,
    /// √a for a ≥ 0.
    Sqrt,
    /// e^a.
    Exp,
    /// Natural logarithm, a > 0.
    Ln,
    /// Logarithm to base 2, a > 0.
    Log2,
    /// Logarithm to base 10, a > 0.
    Log10,
    /// sin a.
    Sin,
    /// cos a.
    Cos,
    /// tan a.
    Tan,
    /// arcsin a, |a| ≤ 1.
    Asin,
    /// arccos a, |a| ≤ 1.
    Acos,
    /// arctan a.
    Atan,
    /// sinh a.
    Sinh,
    /// cosh a.
    Cosh,
    /// tanh a.
    Tanh,
    /// arsinh a.
    Asinh,
    /// arcosh a, a ≥ 1.
    Acosh,
    /// artanh a, |a| < 1.
    Atanh,
    /// The error function.
    Erf,
    /// The largest whole number ≤ a.
    Floor,
    /// The largest whole number ≤ n·a / b, b ≠ 0, for a whole n in 1…2^53: of the exact quotient, where the floor of
    /// the rounded one may be one off.
    FloorDiv(i64),
    /// a^n for a whole n ≠ 0, 1, by repeated squaring; a ≠ 0 when n < 0.
    Power(i64),
    /// The real root of odd order n ≥ 3, for every a.
    Root(u32),
    /// a + b.
    Add,
    /// a − b.
    Sub,
    /// a · b.
    Mul,
    /// a / b, b ≠ 0.
    Div,
    /// The smaller of a and b.
    Min,
    /// The larger of a and b.
    Max,
    /// a^b for a > 0, or a = 0 and b > 0.
    Pow,
    /// The angle of the point (x = b, y = a), in (−π, π]; none at (0, 0).
    Atan2,
    /// Of (c, a, b): a where c ≤ 0, else b; the other branch need have no value.
    Choose,
}

/// A quantity that a graph is a function of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Variable {
    /// The coordinate x.
    X,
    /// The coordinate y.
    Y,
    /// The coordinate z.
    Z,
    /// dx/dt along a ray.
    DX,
    /// dy/dt along a ray.
    DY,
    /// dz/dt along a ray.
    DZ,
}

impl Variable {
    /// All six, coordinates first.
    pub const ALL: [Variable; 6] = [Variable::X, Variable::Y, Variable::Z, Variable::DX, Variable::DY, Variable::DZ];
}

impl Op {
    /// One of each operation, with a small sample parameter where it has one.
    pub const ALL: [Op; 38] = [
        Op::Constant(0),
        Op::Pi,
        Op::E,
        Op::Variable(Variable::X),
        Op::Neg,
        Op::Abs,
        Op::Sign,
        Op::Sqrt,
        Op::Exp,
        Op::Ln,
        Op::Log2,
        Op::Log10,
        Op::Sin,
        Op::Cos,
        Op::Tan,
        Op::Asin,
        Op::Acos,
        Op::Atan,
        Op::Sinh,
        Op::Cosh,
        Op::Tanh,
        Op::Asinh,
        Op::Acosh,
        Op::Atanh,
        Op::Erf,
        Op::Floor,
        Op::Power(2),
        Op::Root(3),
        Op::Add,
        Op::Sub,
        Op::Mul,
        Op::Div,
        Op::FloorDiv(3),
        Op::Min,
        Op::Max,
        Op::Pow,
        Op::Atan2,
        Op::Choose,
    ];

    /// How many arguments the operation takes: 0 to 3.
    pub const fn arity(self) -> usize {
        match self {
            Op::Constant(_) | Op::Pi | Op::E | Op::Variable(_) => 0,
            Op::Neg
            | Op::Abs
            | Op::Sign
            | Op::Sqrt
            | Op::Exp
            | Op::Ln
            | Op::Log2
            | Op::Log10
            | Op::Sin
            | Op::Cos
            | Op::Tan
            | Op::Asin
            | Op::Acos
            | Op::Atan
            | Op::Sinh
            | Op::Cosh
            | Op::Tanh
            | Op::Asinh
            | Op::Acosh
            | Op::Atanh
            | Op::Erf
            | Op::Floor
            | Op::Power(_)
            | Op::Root(_) => 1,
            Op::Add | Op::Sub | Op::Mul | Op::Div | Op::FloorDiv(_) | Op::Min | Op::Max | Op::Pow | Op::Atan2 => 2,
            Op::Choose => 3,
        }
    }
}
