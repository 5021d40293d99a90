//! Facts by the book: every kind of quadric, turned and moved ones too, and what is no quadric.

use super::*;
use crate::expr::formula::typed;

#[test]
fn every_quadric_is_known_by_exact_signs() {
    let rows = [
        ("x^2+y^2+z^2-1", "sphere"),
        ("1-x^2-y^2-z^2-2x", "sphere"),
        ("x^2+y^2+2z^2-1", "spheroid"),
        ("5x^2+5y^2+5z^2+2xy+2yz+2xz-1", "spheroid"),
        ("x^2+2y^2+3z^2-1", "ellipsoid"),
        ("x^2+2y^2+3z^2+1", "empty"),
        ("x^2+2y^2+3z^2", "point"),
        ("(x-1)^2+(y+2)^2+z^2", "point"),
        ("x^2+2y^2-z^2-1", "hyperboloid1"),
        ("x^2+y^2-z^2-1", "hyperboloid1.round"),
        ("x*y+z^2-1", "hyperboloid1"),
        ("x^2+2y^2-z^2+1", "hyperboloid2"),
        ("z^2-x^2-y^2-1", "hyperboloid2.round"),
        ("x^2+2y^2-z^2", "cone"),
        ("x^2+y^2-z^2", "cone.round"),
        ("x*y+y*z+x*z", "cone.round"),
        ("x^2+2y^2-z", "paraboloid"),
        ("z-x^2-y^2", "paraboloid.round"),
        ("x^2+2y^2-1", "cylinder"),
        ("x^2+y^2-1", "cylinder.round"),
        ("x^2+y^2+1", "empty"),
        ("x^2+y^2", "line"),
        ("x*y-z", "saddle"),
        ("x^2-y^2-z", "saddle"),
        ("x*y-1", "cylinder.hyperbolic"),
        ("x^2-y^2+1", "cylinder.hyperbolic"),
        ("x*y", "planes.crossing"),
        ("x^2-2y^2", "planes.crossing"),
        ("x^2-y", "cylinder.parabolic"),
        ("(x+y)^2-z", "cylinder.parabolic"),
        ("x^2-1", "planes.parallel"),
        ("(x+y+z)^2-4", "planes.parallel"),
        ("x^2+1", "empty"),
        ("(x+2y)^2", "plane.double"),
        ("0.1x^2+0.1y^2+0.1z^2-0.001", "sphere"),
    ];
    for (program, expected) in rows {
        let (mut graph, f) = typed(program);
        let found = facts(&mut graph, f).quadric.map(|quadric| quadric.kind);
        assert_eq!(found, Some(format!("quadric.{expected}").as_str()), "{program}");
    }
}

#[test]
fn centres_are_exact() {
    let (mut graph, f) = typed("(x-1/3)^2+2(y+2)^2+3z^2-1");
    let centre = facts(&mut graph, f).quadric.unwrap().centre.unwrap();
    assert_eq!(centre.map(|c| c.to_string()), ["1/3", "-2", "0"]);
    let (mut graph, f) = typed("x^2+y^2-z");
    assert_eq!(facts(&mut graph, f).quadric.unwrap().centre, None);
}

/// Formula; degree; axes; symmetries; bounded; graphs over which coordinate.
type Row = (&'static str, Option<u32>, &'static str, &'static str, Option<bool>, &'static str);

#[test]
fn facts_are_those_of_the_formula() {
    let rows: [Row; 16] = [
        ("x^2+y^2+z^2-1", Some(2), "xyz", "x y z point xy yz xz cycle", Some(true), ""),
        ("(x^2+y^2+z^2+3)^2-16*(x^2+y^2)", Some(4), "z", "x y z point xy", Some(true), ""),
        ("z-sin(x)*cos(y)", None, "", "y point", Some(false), "z"),
        ("z-x^2-y^2", Some(2), "z", "x y xy", Some(false), "z"),
        ("z-exp(-x^2-y^2)", None, "z", "x y xy", Some(false), "z"),
        ("sin(sqrt(x^2+y^2))-z", None, "z", "x y xy", Some(false), "z"),
        ("x^4+y^4+z^4-1", Some(4), "", "x y z point xy yz xz cycle", Some(true), ""),
        ("x^4+y^4-z^4-1", Some(4), "", "x y z point xy", None, ""),
        ("x^3+y^3+z^3-1", Some(3), "", "xy yz xz cycle", Some(false), ""),
        ("x*y*z-1", Some(3), "", "xy yz xz cycle", Some(false), ""),
        ("x+2y+3z-1", Some(1), "", "", Some(false), "xyz"),
        ("sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)", None, "", "point cycle", None, ""),
        ("cos(x)+cos(y)+cos(z)", None, "", "x y z point xy yz xz cycle", None, ""),
        ("ln(x)-z", None, "", "y", None, "z"),
        ("abs(x)+abs(y)+abs(z)-1", None, "", "x y z point xy yz xz cycle", None, ""),
        ("x^2+y^2*z-1", Some(3), "", "x y", Some(false), ""),
    ];
    for (program, degree, axes, symmetries, bounded, graphs) in rows {
        let (mut graph, f) = typed(program);
        let found = facts(&mut graph, f);
        let letters =
            |list: &mut dyn Iterator<Item = Variable>| list.map(crate::teach::notation::letter).collect::<String>();
        let names: Vec<&str> = found.symmetries.iter().map(|key| &key["symmetry.".len()..]).collect();
        assert_eq!(found.degree, degree, "{program}");
        assert_eq!(letters(&mut found.axes.iter().copied()), axes, "{program}");
        assert_eq!(names.join(" "), symmetries, "{program}");
        assert_eq!(found.is_bounded, bounded, "{program}");
        assert_eq!(letters(&mut found.graphs.iter().map(|&(v, _)| v)), graphs, "{program}");
    }
}
