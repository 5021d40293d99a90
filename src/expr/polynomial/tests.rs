//! Tests of the exact algebra: random products come apart again, and what would grow is declined.

use super::Polynomial;
use super::divisor::{coprime_part, gcd, quotient, square_free_factors};
use super::expand::{Letters, expanded, node_of, total_degree};
use super::modular::{may_have_common_factor, may_have_repeated_factor};
use crate::expr::estimate::Random;
use crate::expr::formula::formula;
use crate::expr::graph::Graph;
use num_bigint::BigInt;

/// A random polynomial in the first letters that is no number.
fn random_polynomial(random: &mut Random, letters: usize) -> Polynomial {
    loop {
        let mut p = Polynomial::default();
        for _ in 0..1 + random.below(4) {
            let mut exponents = [0; super::MAX_LETTERS];
            for e in exponents.iter_mut().take(letters) {
                *e = random.below(3) as u16;
            }
            p.add_term(exponents, BigInt::from(random.below(19) as i64 - 9));
        }
        if !p.is_constant() {
            return p;
        }
    }
}

#[test]
fn quotient_undoes_the_product() {
    let mut random = Random(7);
    for _ in 0..3000 {
        let (a, b) = (random_polynomial(&mut random, 3), random_polynomial(&mut random, 3));
        let product = a.times(&b).unwrap();
        assert_eq!(quotient(&product, &b), Some(a.clone()));
        let more = product.plus(&Polynomial::constant(BigInt::from(1))).unwrap();
        assert_eq!(quotient(&more, &b), None, "{a:?} {b:?}");
    }
}

#[test]
fn greatest_common_divisor_divides_both_and_leaves_nothing_common() {
    let mut random = Random(8);
    for _ in 0..600 {
        let [a, b, c] = [(); 3].map(|()| random_polynomial(&mut random, 3));
        let (p, q) = (a.times(&c).unwrap(), b.times(&c).unwrap());
        let g = gcd(&p, &q).unwrap_or_else(|| panic!("{p:?} {q:?}"));
        assert!(quotient(&g, &c.primitive()).is_some(), "{c:?} does not divide {g:?}");
        let (left, right) = (quotient(&p, &g).unwrap(), quotient(&q, &g).unwrap());
        assert!(
            gcd(&left, &right).unwrap_or_else(|| panic!("{left:?} {right:?}")) == Polynomial::constant(BigInt::from(1))
        );
        let rest = coprime_part(&p, &c).unwrap();
        assert!(gcd(&rest, &c).unwrap_or_else(|| panic!("{rest:?} {c:?}")).is_constant());
    }
}

#[test]
fn square_free_factors_of_random_products() {
    let mut random = Random(9);
    for _ in 0..300 {
        let [a, b] = [(); 2].map(|()| random_polynomial(&mut random, 3));
        let n = 1 + random.below(3) as u32;
        let p = a.to_power(n).unwrap().times(&b).unwrap();
        let factors = square_free_factors(&p).unwrap();
        for (i, (factor, _)) in factors.iter().enumerate() {
            let again = square_free_factors(factor).unwrap();
            assert!(again.iter().all(|f| f.1 == 1), "{factor:?}");
            for (other, _) in &factors[i + 1..] {
                assert!(gcd(factor, other).unwrap_or_else(|| panic!("{factor:?} {other:?}")).is_constant());
            }
        }
        // The product of the powers is verified inside; a's factors must have at least its power.
        assert!(n == 1 || factors.iter().any(|f| f.1 >= n));
    }
}

const BARTH_DECIC: &str = "8*(x^2 - 6.854101966249685*y^2)*(y^2 - 6.854101966249685*z^2)*(z^2 - 6.854101966249685*x^2)\
    *(x^4 + y^4 + z^4 - 2*x^2*y^2 - 2*x^2*z^2 - 2*y^2*z^2)\
    + 11.090169943749475*(x^2 + y^2 + z^2 - 1)^2*(x^2 + y^2 + z^2 - 0.3819660112501051)^2";

#[test]
fn cheap_test_finds_the_repeated_and_the_common() {
    let rows = [
        ("x^2+y^2+z^2-1", false),
        (BARTH_DECIC, false),
        ("x^2-2*x*y+y^2", true),
        ("z^2-2*z*sin(x)+sin(x)^2", true),
        ("x^2*y+x^2", true),
        ("x^1000000000-y", false),
        ("(x+y)^3*(x-y)", true),
        ("x/3-y", false),
    ];
    for (text, expected) in rows {
        let mut graph = Graph::new();
        let f = formula(&mut graph, text);
        assert_eq!(may_have_repeated_factor(&graph, f), expected, "{text}");
    }
    for (a, b, expected) in [("x^2-1", "x-1", true), ("x^2-1", "x-2", false), ("x*y+x", "y+1", true), ("x", "y", false)]
    {
        let mut graph = Graph::new();
        let (a, b) = (formula(&mut graph, a), formula(&mut graph, b));
        assert_eq!(may_have_common_factor(&graph, a, b), expected);
    }
}

#[test]
fn square_of_a_large_polynomial_is_seen_through() {
    let mut graph = Graph::new();
    let sextic = "4*(2.618*x^2 - y^2)*(2.618*y^2 - z^2)*(2.618*z^2 - x^2) - 4.236*(x^2 + y^2 + z^2 - 1)^2";
    let f = formula(&mut graph, sextic);
    let mut letters = Letters::default();
    let (p, _) = expanded(&graph, f, &mut letters).unwrap();
    let factors = square_free_factors(&p.times(&p).unwrap()).unwrap();
    assert_eq!(factors, [(p.primitive(), 2)]);
}

#[test]
fn node_of_a_polynomial_expands_to_it() {
    let mut random = Random(10);
    for _ in 0..300 {
        let mut graph = Graph::new();
        let letters = Letters { nodes: ["x", "sin(y)", "z"].map(|t| formula(&mut graph, t)).to_vec() };
        let p = random_polynomial(&mut random, 3);
        let id = node_of(&mut graph, &p, &letters).unwrap();
        assert_eq!(expanded(&graph, id, &mut letters.clone()).unwrap().0, p);
    }
}

#[test]
fn total_degrees() {
    let rows = [
        ("x^2*y+z", Some(3)),
        ("(x+y^2)^3-pi", Some(6)),
        ("sin(x)", None),
        ("1/x", None),
        ("7", Some(0)),
        (BARTH_DECIC, Some(10)),
    ];
    for (text, degree) in rows {
        let mut graph = Graph::new();
        let f = formula(&mut graph, text);
        assert_eq!(total_degree(&graph, f), degree, "{text}");
    }
}

#[test]
fn what_would_grow_is_declined() {
    for text in ["(x+y+z+sin(x)+1)^400", "((x+y)^1000)^1000+1", "x^100000*y+2"] {
        let mut graph = Graph::new();
        let f = formula(&mut graph, text);
        assert!(expanded(&graph, f, &mut Letters::default()).is_none(), "{text}");
    }
}
