//! Rows of what is known and of the ranges, where a person can tell.

#![allow(clippy::approx_constant, clippy::type_complexity)]

use super::{Defined, Enclosure, Interval};
use Defined::{Everywhere, Nowhere, Somewhere};

const INF: f64 = f64::INFINITY;

fn range(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi)
}

/// name, result, least and most value (exact ones, or those that a bound may pass by 1e-15), defined, continuous
type Row = (&'static str, Enclosure, (f64, f64), Defined, bool);

#[track_caller]
fn check(rows: &[Row]) {
    for &(name, got, (lo, hi), defined, continuous) in rows {
        assert_eq!((got.defined, got.continuous), (defined, continuous), "{name}: {got:?}");
        if defined == Nowhere {
            assert!(got.range.is_empty(), "{name}: {got:?}");
            continue;
        }
        let near = |x: f64, y: f64| x == y || (x - y).abs() <= 1e-15 * y.abs();
        assert!(got.range.lo <= lo && got.range.hi >= hi, "{name}: {got:?}");
        assert!(near(got.range.lo, lo) && near(got.range.hi, hi), "{name}: {got:?}");
    }
}

#[test]
fn what_is_known_is_as_in_the_contract() {
    check(&[
        ("floor without a jump", range(0.2, 0.8).floor(), (0.0, 0.0), Everywhere, true),
        ("floor up to a jump", range(0.5, 1.0).floor(), (0.0, 1.0), Everywhere, false),
        ("floor from a jump on", range(1.0, 1.5).floor(), (1.0, 1.0), Everywhere, true),
        ("sqrt from its edge on", range(0.0, 1.0).sqrt(), (0.0, 1.0), Everywhere, true),
        ("sqrt across its edge", range(-1.0, 4.0).sqrt(), (0.0, 2.0), Somewhere, false),
        ("sqrt outside", range(-2.0, -1.0).sqrt(), (0.0, 0.0), Nowhere, false),
        ("sign above", range(0.5, 1.0).sign(), (1.0, 1.0), Everywhere, true),
        ("sign from 0 on", range(0.0, 1.0).sign(), (0.0, 1.0), Everywhere, false),
        ("abs across 0", range(-3.0, 1.0).abs(), (0.0, 3.0), Everywhere, true),
        ("square across 0", range(-3.0, 1.0).square(), (0.0, 9.0), Everywhere, true),
        ("ln from 0 on", range(0.0, 1.0).ln(), (-INF, 0.0), Somewhere, false),
        ("ln outside", range(-1.0, 0.0).ln(), (0.0, 0.0), Nowhere, false),
        ("asin inside", range(-1.0, 1.0).asin(), (-1.5707963267948968, 1.5707963267948968), Everywhere, true),
        ("acosh outside", range(0.0, 0.5).acosh(), (0.0, 0.0), Nowhere, false),
        ("atanh at its edges", range(-1.0, 1.0).atanh(), (-INF, INF), Somewhere, false),
        ("tan across a pole", range(1.5, 1.6).tan(), (-INF, INF), Somewhere, false),
        ("tan without a pole", range(-0.5, 0.0).tan(), (-0.5463024898437905, 0.0), Everywhere, true),
        ("sin over a crest", range(1.0, 2.0).sin(), (0.8414709848078965, 1.0), Everywhere, true),
        ("cos of everything", Interval::WHOLE.cos(), (-1.0, 1.0), Everywhere, true),
        ("exp of everything", Interval::WHOLE.exp(), (0.0, INF), Everywhere, true),
        ("0 times everything", range(0.0, 0.0).times(Interval::WHOLE).to_owned(), (0.0, 0.0), Everywhere, true),
        ("exact sum", range(1.0, 2.0).plus(range(3.0, 4.0)), (4.0, 6.0), Everywhere, true),
        ("exact product", range(-1.0, 2.0).times(range(3.0, 4.0)), (-4.0, 8.0), Everywhere, true),
        ("division across 0", range(1.0, 2.0).over(range(-1.0, 1.0)), (-INF, INF), Somewhere, false),
        ("division up to 0", range(1.0, 2.0).over(range(0.0, 4.0)), (0.25, INF), Somewhere, false),
        ("division by 0", range(1.0, 2.0).over(range(0.0, 0.0)), (0.0, 0.0), Nowhere, false),
        ("0 by what has 0", range(0.0, 0.0).over(range(-1.0, 1.0)), (0.0, 0.0), Somewhere, false),
        ("x^-2 across 0", range(-1.0, 2.0).power(-2), (0.25, INF), Somewhere, false),
        ("x^-1 of 0", range(0.0, 0.0).power(-1), (0.0, 0.0), Nowhere, false),
        ("x^3", range(-2.0, 3.0).power(3), (-8.0, 27.0), Everywhere, true),
        ("x^y from 0 on", range(0.0, 4.0).pow(range(0.5, 0.5)), (0.0, 2.0), Everywhere, true),
        ("x^y at exponent 0", range(0.0, 4.0).pow(range(0.0, 0.5)), (0.0, 2.0), Somewhere, false),
        ("x^y outside", range(-2.0, -1.0).pow(range(2.0, 2.0)), (0.0, 0.0), Nowhere, false),
        ("0^-1", range(0.0, 0.0).pow(range(-1.0, -1.0)), (0.0, 0.0), Nowhere, false),
        (
            "angle to the right",
            range(-1.0, 1.0).atan2(range(1.0, 2.0)),
            (-0.7853981633974484, 0.7853981633974484),
            Everywhere,
            true,
        ),
        (
            "angle on the cut",
            range(0.0, 0.0).atan2(range(-2.0, -1.0)),
            (3.141592653589793, 3.1415926535897936),
            Everywhere,
            true,
        ),
        (
            "angle across the cut",
            range(-1.0, 1.0).atan2(range(-2.0, -1.0)),
            (-3.1415926535897936, 3.1415926535897936),
            Everywhere,
            false,
        ),
        ("angle about the origin", range(0.0, 1.0).atan2(range(0.0, 1.0)), (0.0, 1.5707963267948968), Somewhere, false),
        ("angle of the origin", range(0.0, 0.0).atan2(range(0.0, 0.0)), (0.0, 0.0), Nowhere, false),
        ("cube root", range(-8.0, 27.0).root(3), (-2.0, 3.0), Everywhere, true),
    ]);
}

#[test]
fn choose_takes_the_branch_that_is_decided() {
    let total = |lo, hi| Enclosure::total(range(lo, hi));
    let (a, b) = (total(1.0, 2.0), total(5.0, 6.0));
    let jumping = Enclosure { continuous: false, ..total(-2.0, -1.0) };
    let partial = Enclosure { defined: Somewhere, continuous: false, range: range(-2.0, -1.0) };
    check(&[
        ("c ≤ 0", Enclosure::choose(total(-1.0, 0.0), a, Enclosure::NOWHERE), (1.0, 2.0), Everywhere, true),
        ("c > 0", Enclosure::choose(total(0.5, 1.0), Enclosure::NOWHERE, b), (5.0, 6.0), Everywhere, true),
        ("c open", Enclosure::choose(total(-1.0, 1.0), a, b), (1.0, 6.0), Everywhere, false),
        (
            "c open, b without value",
            Enclosure::choose(total(-1.0, 1.0), a, Enclosure::NOWHERE),
            (1.0, 2.0),
            Somewhere,
            false,
        ),
        ("c jumps below 0", Enclosure::choose(jumping, a, b), (1.0, 2.0), Everywhere, true),
        ("c partly without value", Enclosure::choose(partial, a, b), (1.0, 2.0), Somewhere, false),
        ("c without value", Enclosure::choose(Enclosure::NOWHERE, a, b), (0.0, 0.0), Nowhere, false),
        (
            "branch without value",
            Enclosure::choose(total(-1.0, 0.0), Enclosure::NOWHERE, b),
            (0.0, 0.0),
            Nowhere,
            false,
        ),
    ]);
}

#[test]
fn knowledge_spreads() {
    let partial = range(-1.0, 4.0).sqrt();
    check(&[
        ("sum with a part", partial.plus(Enclosure::total(range(1.0, 1.0))), (1.0, 3.0), Somewhere, false),
        ("sum with nothing", partial.plus(Enclosure::NOWHERE), (0.0, 0.0), Nowhere, false),
        ("sine of a jump", range(0.5, 1.0).floor().exp(), (1.0, std::f64::consts::E), Everywhere, false),
        ("floor of a jump", range(0.5, 1.0).floor().sqrt().sign(), (0.0, 1.0), Everywhere, false),
    ]);
}

#[test]
fn pieces_lie_on_each_side_of_a_jump() {
    let rows: [(&str, Vec<Interval>, &[(f64, f64)]); 14] = [
        ("floor", range(0.9, 1.1).floor_pieces().as_slice().to_vec(), &[(0.0, 0.0), (1.0, 1.0)]),
        ("floor of much", range(0.9, 100.0).floor_pieces().as_slice().to_vec(), &[(0.0, 100.0)]),
        ("floor of all", Interval::WHOLE.floor_pieces().as_slice().to_vec(), &[(-INF, INF)]),
        ("sign", range(-1.0, 1.0).sign_pieces().as_slice().to_vec(), &[(-1.0, -1.0), (0.0, 0.0), (1.0, 1.0)]),
        ("sign from 0", range(0.0, 1.0).sign_pieces().as_slice().to_vec(), &[(0.0, 0.0), (1.0, 1.0)]),
        ("1/x", range(1.0, 1.0).over_pieces(range(-0.5, 0.25)).as_slice().to_vec(), &[(-INF, -2.0), (4.0, INF)]),
        ("1/x above", range(1.0, 1.0).over_pieces(range(0.0, 0.25)).as_slice().to_vec(), &[(4.0, INF)]),
        ("0/x", range(0.0, 0.0).over_pieces(range(-0.5, 0.25)).as_slice().to_vec(), &[(0.0, 0.0), (0.0, 0.0)]),
        ("1/0", range(1.0, 1.0).over_pieces(range(0.0, 0.0)).as_slice().to_vec(), &[]),
        ("x^-1", range(-0.5, 0.25).power_pieces(-1).as_slice().to_vec(), &[(-INF, -2.0), (4.0, INF)]),
        ("x^-2", range(-0.5, 0.25).power_pieces(-2).as_slice().to_vec(), &[(4.0, INF), (16.0, INF)]),
        (
            "tan",
            range(1.5, 1.6).tan_pieces().as_slice().to_vec(),
            &[(14.101419947171719, INF), (-INF, -34.232532735557314)],
        ),
        ("tan without a pole", range(0.0, 0.0).tan_pieces().as_slice().to_vec(), &[(0.0, 0.0)]),
        (
            "angle",
            range(-1.0, 0.0).atan2_pieces(range(-1.0, -1.0)).as_slice().to_vec(),
            &[(-3.1415926535897936, -2.356194490192345), (3.141592653589793, 3.1415926535897936)],
        ),
    ];
    for (name, got, wanted) in rows {
        assert_eq!(got.len(), wanted.len(), "{name}: {got:?}");
        let near = |x: f64, y: f64| x == y || (x - y).abs() <= 1e-14 * y.abs();
        for (piece, &(lo, hi)) in got.iter().zip(wanted) {
            assert!(near(piece.lo, lo) && near(piece.hi, hi), "{name}: {got:?}");
            assert!(piece.lo <= lo.next_up() && piece.hi >= hi.next_down(), "{name}: {got:?}");
        }
    }
}
