//! Which quadric a polynomial of degree 2 is, decided exactly.
//!
//! In: its polynomial in x, y, z. Out: its kind, its centre, whether two or three of its axes are equal. The kind hangs on the
//! signs of the eigenvalues of two symmetric matrices alone: A of the squares and products, and Q of all terms (Sylvester's law of
//! inertia, 1852). All roots of their characteristic polynomials are real, so Descartes' rule of signs counts the positive
//! ones exactly; nothing is computed in floating point.

use crate::expr::polynomial::Polynomial;
use crate::num::rational::Rational;

type Matrix = Vec<Vec<Rational>>;

/// What a quadric is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadric {
    /// The key of its name in the texts.
    pub kind: &'static str,
    /// Its centre, where it has exactly one.
    pub centre: Option<[Rational; 3]>,
    /// How many eigenvalues of A are > 0, < 0, = 0.
    pub signs: [usize; 3],
    /// The same of Q.
    pub all_signs: [usize; 3],
    /// Whether it is proven to be bounded (true), or to reach as far as one likes (false); nothing of what is empty.
    pub is_bounded: Option<bool>,
}

/// The quadric of a polynomial whose letters are the coordinates in `places`; `None` if its degree is not 2.
pub fn quadric(p: &Polynomial, places: &[usize]) -> Option<Quadric> {
    let q = matrix(p, places)?;
    let a: Matrix = (0..3).map(|i| q[i][..3].to_vec()).collect();
    let (signs, all_signs) = (inertia(&a)?, inertia(&q)?);
    if signs[2] == 3 {
        return None;
    }
    // f and −f have the same roots: the majority counts as positive.
    let is_turned = signs[1] > signs[0] || signs[1] == signs[0] && all_signs[1] > all_signs[0];
    let turn = |[p, n, z]: [usize; 3]| if is_turned { [n, p, z] } else { [p, n, z] };
    let kind = kind(turn(signs), turn(all_signs), is_multiple_of_unit(&a), has_equal_axes(&a)?)?;
    let is_bounded = match (turn(signs)[0], signs[2]) {
        _ if kind.starts_with("quadric.empty") => None,
        (3, 0) => Some(true),
        _ => Some(false),
    };
    Some(Quadric { kind, centre: centre(&a, &q), signs, all_signs, is_bounded })
}

/// The symmetric matrix of (x, y, z, 1).
fn matrix(p: &Polynomial, places: &[usize]) -> Option<Matrix> {
    let zero = Rational::from_integer(0);
    let half = Rational::from_fraction(1, 2)?;
    let mut q = vec![vec![zero; 4]; 4];
    for (exponents, coefficient) in p.terms() {
        let c = Rational::from_big_integer(coefficient.clone())?;
        let mut letters = Vec::new();
        for (letter, &place) in places.iter().enumerate() {
            letters.extend(std::iter::repeat_n(place, usize::from(exponents[letter])));
        }
        match letters[..] {
            [] => q[3][3] = c,
            [i] => {
                let c = c.times(&half)?;
                (q[i][3], q[3][i]) = (c.clone(), c);
            }
            [i, j] if i == j => q[i][i] = c,
            [i, j] => {
                let c = c.times(&half)?;
                (q[i][j], q[j][i]) = (c.clone(), c);
            }
            _ => return None,
        }
    }
    Some(q)
}

fn times(a: &Matrix, b: &Matrix) -> Option<Matrix> {
    let n = a.len();
    let entry =
        |i: usize, j: usize| (0..n).try_fold(Rational::from_integer(0), |sum, k| sum.plus(&a[i][k].times(&b[k][j])?));
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

/// The characteristic polynomial λⁿ + c₁λⁿ⁻¹ + … by the method of Faddeev and Le Verrier (Gantmacher, The Theory of
/// Matrices, vol. 1, ch. IV § 5).
fn characteristic(a: &Matrix) -> Option<Vec<Rational>> {
    let n = a.len();
    let mut coefficients = vec![Rational::from_integer(1)];
    let mut b: Matrix = (0..n).map(|i| (0..n).map(|j| Rational::from_integer(i64::from(i == j))).collect()).collect();
    for k in 1..=n {
        let product = times(a, &b)?;
        let trace = (0..n).try_fold(Rational::from_integer(0), |sum, i| sum.plus(&product[i][i]))?;
        let c = trace.over(&Rational::from_integer(-(k as i64)))?;
        b = product;
        for i in 0..n {
            b[i][i] = b[i][i].plus(&c)?;
        }
        coefficients.push(c);
    }
    Some(coefficients)
}

/// How many eigenvalues are > 0, < 0 and = 0.
fn inertia(a: &Matrix) -> Option<[usize; 3]> {
    let coefficients = characteristic(a)?;
    let zeros = coefficients.iter().rev().take_while(|c| c.is_zero()).count();
    let signs: Vec<bool> = coefficients.iter().filter(|c| !c.is_zero()).map(Rational::is_positive).collect();
    let positive = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();
    Some([positive, a.len() - zeros - positive, zeros])
}

// table: one line a kind.
/// The kind by the signs of A and Q, the majority of A's being positive.
fn kind(a: [usize; 3], q: [usize; 3], is_round: bool, has_equal_axes: bool) -> Option<&'static str> {
    let name = |round: &'static str, other: &'static str| if has_equal_axes { round } else { other };
    Some(match (a, q) {
        ([3, 0, 0], [3, 1, 0]) if is_round => "quadric.sphere",
        ([3, 0, 0], [3, 1, 0]) => name("quadric.spheroid", "quadric.ellipsoid"),
        ([3, 0, 0], [4, 0, 0]) => "quadric.empty",
        ([3, 0, 0], [3, 0, 1]) => "quadric.point",
        ([2, 1, 0], [2, 2, 0]) => name("quadric.hyperboloid1.round", "quadric.hyperboloid1"),
        ([2, 1, 0], [3, 1, 0]) => name("quadric.hyperboloid2.round", "quadric.hyperboloid2"),
        ([2, 1, 0], [2, 1, 1]) => name("quadric.cone.round", "quadric.cone"),
        ([2, 0, 1], [3, 1, 0]) => name("quadric.paraboloid.round", "quadric.paraboloid"),
        ([2, 0, 1], [2, 1, 1]) => name("quadric.cylinder.round", "quadric.cylinder"),
        ([2, 0, 1], [3, 0, 1]) => "quadric.empty",
        ([2, 0, 1], [2, 0, 2]) => "quadric.line",
        ([1, 1, 1], [2, 2, 0]) => "quadric.saddle",
        ([1, 1, 1], [2, 1, 1] | [1, 2, 1]) => "quadric.cylinder.hyperbolic",
        ([1, 1, 1], [1, 1, 2]) => "quadric.planes.crossing",
        ([1, 0, 2], [2, 1, 1]) => "quadric.cylinder.parabolic",
        ([1, 0, 2], [1, 1, 2]) => "quadric.planes.parallel",
        ([1, 0, 2], [2, 0, 2]) => "quadric.empty",
        ([1, 0, 2], [1, 0, 3]) => "quadric.plane.double",
        _ => return None,
    })
}

fn is_multiple_of_unit(a: &Matrix) -> bool {
    (0..3).all(|i| (0..3).all(|j| if i == j { a[i][i] == a[0][0] } else { a[i][j].is_zero() }))
}

/// Whether two eigenvalues of one sign other than 0 are equal: the discriminant of the characteristic polynomial is 0, and the
/// equal ones are not the zeros.
fn has_equal_axes(a: &Matrix) -> Option<bool> {
    let c = characteristic(a)?;
    let (b, c, d) = (&c[1], &c[2], &c[3]);
    let whole = |n: i64| Rational::from_integer(n);
    // λ³ + bλ² + cλ + d has a double root where b²c² − 4c³ − 4b³d − 27d² + 18bcd = 0.
    let square = |x: &Rational| x.times(x);
    let cube = |x: &Rational| x.times(x)?.times(x);
    let terms = [
        square(b)?.times(&square(c)?)?,
        cube(c)?.times(&whole(-4))?,
        cube(b)?.times(d)?.times(&whole(-4))?,
        square(d)?.times(&whole(-27))?,
        b.times(c)?.times(d)?.times(&whole(18))?,
    ];
    let discriminant = terms.iter().try_fold(whole(0), |sum, term| sum.plus(term))?;
    let zeros = usize::from(d.is_zero()) + usize::from(d.is_zero() && c.is_zero());
    Some(discriminant.is_zero() && zeros < 2)
}

/// The one point where the gradient is 0, by Cramer's rule.
fn centre(a: &Matrix, q: &Matrix) -> Option<[Rational; 3]> {
    let whole = determinant(a)?;
    let mut point = Vec::new();
    for column in 0..3 {
        let mut replaced = a.clone();
        for row in 0..3 {
            replaced[row][column] = q[row][3].negated();
        }
        point.push(determinant(&replaced)?.over(&whole)?);
    }
    point.try_into().ok()
}

fn determinant(m: &Matrix) -> Option<Rational> {
    let minor = |i: usize, j: usize| m[1][i].times(&m[2][j])?.minus(&m[1][j].times(&m[2][i])?);
    let first = m[0][0].times(&minor(1, 2)?)?;
    let second = m[0][1].times(&minor(0, 2)?)?;
    first.minus(&second)?.plus(&m[0][2].times(&minor(0, 1)?)?)
}
