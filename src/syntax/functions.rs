//! THE table of functions: names, signatures, domains, in the words that messages and grammar.md use.
//!
//! In: nothing. Out: what a name before a bracket means. Separate so that parser, lowering, documentation and
//! suggestions cannot disagree.

/// What a function gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gives {
    /// A number.
    Number,
    /// A vector.
    Vector,
    /// A region.
    Region,
    /// Whatever its arguments are: `if`, `sum`.
    Either,
}

/// A function of the language.
#[derive(Clone, Copy, Debug)]
pub struct Function {
    /// Its name.
    pub name: &'static str,
    /// How it is called, for messages: `atan2(y, x)`.
    pub signature: &'static str,
    /// The least number of arguments.
    pub least: usize,
    /// The greatest number of arguments; `None` for any number.
    pub most: Option<usize>,
    /// What it gives.
    pub gives: Gives,
    /// Where it has a value, in words; empty for everywhere.
    pub domain: &'static str,
    /// The derivative, for one argument u of derivative u'; empty where there is no closed rule worth a line.
    pub derivative: &'static str,
    /// What it is.
    pub about: &'static str,
}

impl Function {
    /// Whether it can be applied without brackets: it takes one argument and gives a number.
    pub fn applies_bare(&self) -> bool {
        self.least == 1 && self.gives != Gives::Region && !matches!(self.name, "min" | "max" | "hypot")
    }
}

const fn number(
    name: &'static str,
    signature: &'static str,
    (least, most): (usize, usize),
    domain: &'static str,
    derivative: &'static str,
    about: &'static str,
) -> Function {
    let most = if most == MANY { None } else { Some(most) };
    Function { name, signature, least, most, gives: Gives::Number, domain, derivative, about }
}

const fn other(
    name: &'static str,
    signature: &'static str,
    (least, most): (usize, usize),
    gives: Gives,
    about: &'static str,
) -> Function {
    let most = if most == MANY { None } else { Some(most) };
    Function { name, signature, least, most, gives, domain: "", derivative: "", about }
}

/// Any number of arguments.
const MANY: usize = usize::MAX;
const ONE: (usize, usize) = (1, 1);
const TWO: (usize, usize) = (2, 2);

/// All functions, in the order of grammar.md.
pub const FUNCTIONS: [Function; 53] = [
    number("sin", "sin(x)", ONE, "", "cos(u)*u'", "sine of an angle in radians"),
    number("cos", "cos(x)", ONE, "", "-sin(u)*u'", "cosine of an angle in radians"),
    number("tan", "tan(x)", ONE, "x not an odd multiple of pi/2", "(1 + tan(u)^2)*u'", "tangent"),
    number("asin", "asin(x)", ONE, "-1 <= x <= 1", "u'/sqrt(1 - u^2)", "the angle in [-pi/2, pi/2] with this sine"),
    number("acos", "acos(x)", ONE, "-1 <= x <= 1", "-u'/sqrt(1 - u^2)", "the angle in [0, pi] with this cosine"),
    number("atan", "atan(x)", ONE, "", "u'/(1 + u^2)", "the angle in (-pi/2, pi/2) with this tangent"),
    number("atan2", "atan2(y, x)", TWO, "not at (0, 0)", "(v*u' - u*v')/(u^2 + v^2)", "the angle of the point (x, y)"),
    number("sinh", "sinh(x)", ONE, "", "cosh(u)*u'", "hyperbolic sine"),
    number("cosh", "cosh(x)", ONE, "", "sinh(u)*u'", "hyperbolic cosine"),
    number("tanh", "tanh(x)", ONE, "", "(1 - tanh(u)^2)*u'", "hyperbolic tangent"),
    number("asinh", "asinh(x)", ONE, "", "u'/sqrt(u^2 + 1)", "inverse of sinh"),
    number("acosh", "acosh(x)", ONE, "x >= 1", "u'/sqrt(u^2 - 1)", "inverse of cosh, >= 0"),
    number("atanh", "atanh(x)", ONE, "-1 < x < 1", "u'/(1 - u^2)", "inverse of tanh"),
    number("exp", "exp(x)", ONE, "", "exp(u)*u'", "e^x"),
    number("ln", "ln(x)", ONE, "x > 0", "u'/u", "natural logarithm"),
    number("log10", "log10(x)", ONE, "x > 0", "u'/(u*ln(10))", "logarithm to base 10"),
    number("log2", "log2(x)", ONE, "x > 0", "u'/(u*ln(2))", "logarithm to base 2"),
    number(
        "log",
        "log(b, x) or log(x)",
        (1, 2),
        "x > 0, b > 0, b != 1",
        "u'/(u*ln(b))",
        "logarithm to base b; alone to base 10",
    ),
    number("sqrt", "sqrt(x)", ONE, "x >= 0", "u'/(2*sqrt(u))", "the square root that is not negative"),
    number("cbrt", "cbrt(x)", ONE, "", "u'/(3*cbrt(u)^2)", "the real cube root"),
    number("root", "root(n, x)", TWO, "x >= 0 when n is even", "root(n,u)*u'/(n*u)", "the real n-th root, n a literal"),
    number("abs", "abs(x)", ONE, "", "sign(u)*u'", "the value without its sign"),
    number("sign", "sign(x)", ONE, "", "0", "-1, 0 or 1"),
    number("floor", "floor(x)", ONE, "", "0", "the largest whole number <= x"),
    number("ceil", "ceil(x)", ONE, "", "0", "the smallest whole number >= x"),
    number("round", "round(x)", ONE, "", "0", "the nearest whole number, halves away from zero"),
    number("frac", "frac(x)", ONE, "", "u'", "x - floor(x)"),
    number("mod", "mod(a, b)", TWO, "b not 0", "u' - floor(u/v)*v'", "a - b*floor(a/b), the same as a % b"),
    number("min", "min(a, b, ...)", (1, MANY), "", "of the smallest", "the smallest"),
    number("max", "max(a, b, ...)", (1, MANY), "", "of the largest", "the largest"),
    number("clamp", "clamp(x, low, high)", (3, 3), "", "of the one taken", "min(max(x, low), high)"),
    number("hypot", "hypot(a, b, ...)", (1, MANY), "", "(u*u' + v*v')/hypot(u,v)", "sqrt(a^2 + b^2 + ...)"),
    number("step", "step(edge, x)", TWO, "", "0", "0 for x < edge, else 1"),
    number(
        "smoothstep",
        "smoothstep(low, high, x)",
        (3, 3),
        "",
        "6*t*(1 - t)*t'",
        "3t^2 - 2t^3, t = (x-low)/(high-low) in 0..1",
    ),
    number("erf", "erf(x)", ONE, "", "2*exp(-u^2)*u'/sqrt(pi)", "the error function"),
    number("chebyshev", "chebyshev(n, x)", TWO, "", "of the polynomial", "Chebyshev polynomial T_n, n a literal"),
    number("legendre", "legendre(n, x)", TWO, "", "of the polynomial", "Legendre polynomial P_n, n a literal"),
    number("dot", "dot(a, b)", TWO, "", "", "the scalar product of two vectors"),
    other("cross", "cross(a, b)", TWO, Gives::Vector, "the vector product"),
    number("length", "length(v)", ONE, "", "", "the length of a vector, the same as bars around it"),
    other("normalize", "normalize(v)", ONE, Gives::Vector, "the vector of length 1 in the same direction"),
    other("if", "if(condition, a, b)", (3, 3), Gives::Either, "a where the condition holds, else b"),
    other("sum", "sum(k = 1..n, term) or sum(k in list, term)", TWO, Gives::Either, "the sum of the terms"),
    other(
        "product",
        "product(k = 1..n, term) or product(k in list, term)",
        TWO,
        Gives::Either,
        "the product of the terms",
    ),
    other("union", "union(a, b, ...)", (1, MANY), Gives::Region, "what is in one of them"),
    other("intersection", "intersection(a, b, ...)", (1, MANY), Gives::Region, "what is in all of them"),
    other(
        "difference",
        "difference(a, b, ...)",
        (1, MANY),
        Gives::Region,
        "what is in the first and in none of the others",
    ),
    other("smooth_union", "smooth_union(k, a, b, ...)", (2, MANY), Gives::Region, "union with seams rounded by k"),
    other("box", "box(x0..x1, y0..y1, z0..z1)", (3, 3), Gives::Region, "a clip: all points between"),
    other("ball", "ball(x, y, z, r)", (4, 4), Gives::Region, "a clip: all points within r of (x, y, z)"),
    other("rgb", "rgb(red, green, blue)", (3, 3), Gives::Vector, "a colour of parts from 0 to 1"),
    other("hsl", "hsl(hue, saturation, lightness)", (3, 3), Gives::Vector, "a colour by its hue in degrees"),
    other("hsv", "hsv(hue, saturation, value)", (3, 3), Gives::Vector, "a colour by its hue in degrees"),
];

/// The function of that name.
pub fn find(name: &str) -> Option<&'static Function> {
    FUNCTIONS.iter().find(|function| function.name == name)
}

/// Functions of other programs, and how they are written here.
const ELSEWHERE: [(&str, &str); 31] = [
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("arcsinh", "asinh"),
    ("arccosh", "acosh"),
    ("arctanh", "atanh"),
    ("arsinh", "asinh"),
    ("arcosh", "acosh"),
    ("artanh", "atanh"),
    ("sgn", "sign"),
    ("signum", "sign"),
    ("fabs", "abs"),
    ("tg", "tan"),
    ("sh", "sinh"),
    ("ch", "cosh"),
    ("th", "tanh"),
    ("lg", "log10"),
    ("lb", "log2"),
    ("ceiling", "ceil"),
    ("fract", "frac"),
    ("fmod", "mod"),
    ("norm", "length"),
    ("magnitude", "length"),
    ("pow", "a^b"),
    ("cot", "1/tan(x)"),
    ("ctg", "1/tan(x)"),
    ("sec", "1/cos(x)"),
    ("csc", "1/sin(x)"),
    ("mix", "a + (b - a)*t"),
    ("lerp", "a + (b - a)*t"),
];

/// How a function of other programs is written here.
pub fn elsewhere(name: &str) -> Option<&'static str> {
    ELSEWHERE.iter().find(|(other, _)| *other == name).map(|(_, here)| *here)
}

/// A function of colours and lines: its arguments may be colours, and it stands behind a key alone.
#[derive(Clone, Copy, Debug)]
pub struct PaintFunction {
    /// Its name.
    pub name: &'static str,
    /// How it is called, for messages.
    pub signature: &'static str,
    /// What it is.
    pub about: &'static str,
}

/// All functions of colours and lines, in the order of grammar.md.
pub const PAINTS: [PaintFunction; 4] = [
    PaintFunction {
        name: "palette",
        signature: "palette(\"viridis\", value) or palette(\"viridis\", value, low, high)",
        about: "the colour of a map: its first where the value is low (0), its last where it is high (1)",
    },
    PaintFunction {
        name: "checker",
        signature: "checker(size, a, b) or checker(size, a, b, u, v)",
        about: "cubes of x, y and z, or squares of u and v, in turn of two colours",
    },
    PaintFunction {
        name: "mix",
        signature: "mix(a, b, t)",
        about: "the first colour where t <= 0, the second where t >= 1, in between both",
    },
    PaintFunction {
        name: "every",
        signature: "every(step, f) or every(step, f, width)",
        about: "of `lines`: dark where f is a multiple of the step, so wide on the surface",
    },
];

/// Whether it is a function of colours and lines.
pub fn is_paint(name: &str) -> bool {
    PAINTS.iter().any(|function| function.name == name)
}

/// Names that stand for the surface itself, where it says what it is made of: the unit normal, the mean and the Gauss curvature.
pub const OF_SURFACE: [&str; 5] = ["nx", "ny", "nz", "mean", "gauss"];

/// Functions of clips and colours: with a bracket behind them they are these, alone a program may give them a value.
const OF_ATTRIBUTES: [&str; 5] = ["ball", "box", "rgb", "hsl", "hsv"];

/// Whether it is a function of clips and colours.
pub fn is_of_attributes(name: &str) -> bool {
    OF_ATTRIBUTES.contains(&name)
}

/// Special functions that people will ask for and that are not built.
const NOT_YET: [&str; 24] = [
    "gamma",
    "lgamma",
    "beta",
    "digamma",
    "zeta",
    "besselj",
    "bessely",
    "besseli",
    "besselk",
    "airy",
    "airyai",
    "airybi",
    "erfc",
    "erfi",
    "erfinv",
    "lambertw",
    "ellipk",
    "ellipe",
    "factorial",
    "hermite",
    "laguerre",
    "jacobi",
    "noise",
    "random",
];

/// Whether it is a known function that this language does not have yet.
pub fn is_not_yet(name: &str) -> bool {
    NOT_YET.contains(&name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_there_once_and_signatures_begin_with_them() {
        for (i, function) in FUNCTIONS.iter().enumerate() {
            assert!(FUNCTIONS[..i].iter().all(|other| other.name != function.name), "{}", function.name);
            assert!(function.signature.starts_with(&format!("{}(", function.name)), "{}", function.name);
            assert!(function.most.is_none_or(|most| most >= function.least));
            assert!(elsewhere(function.name).is_none() && !is_not_yet(function.name));
        }
    }

    #[test]
    fn what_other_programs_call_it_is_there_under_our_name() {
        for (_, here) in ELSEWHERE {
            assert!(find(here).is_some() || here.contains(['(', '^']), "{here}");
        }
    }
}
