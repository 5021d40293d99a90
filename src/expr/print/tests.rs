//! Tests of printing: text reads back as the same node; brackets and LaTeX by table.

use super::{definitions, latex, text};
use crate::expr::estimate::Random;
use crate::expr::formula::{formula, typed};
use crate::expr::graph::{Graph, NodeId};
use crate::expr::op::Op;

/// A random simplified node.
fn random_node(graph: &mut Graph, random: &mut Random) -> NodeId {
    let mut pool: Vec<NodeId> = (0..4).map(|_| random.leaf(graph)).collect();
    for _ in 0..2 + random.below(9) {
        let op = if random.below(2) == 0 {
            [Op::Neg, Op::Add, Op::Sub, Op::Mul, Op::Div, Op::Power(2)][random.below(6)]
        } else {
            random.operation()
        };
        let args: Vec<NodeId> = (0..op.arity()).map(|_| pool[random.below(pool.len())]).collect();
        pool.push(graph.apply(op, &args));
    }
    pool[pool.len() - 1]
}

#[test]
fn text_reads_back_as_the_same_node() {
    let mut random = Random(11);
    for _ in 0..20_000 {
        let mut graph = Graph::new();
        let id = random_node(&mut graph, &mut random);
        let Some(shown) = text(&graph, id, 2000) else { continue };
        let again = formula(&mut graph, &shown);
        assert_eq!(again, id, "{shown} became {:?}", text(&graph, again, 2000));
    }
}

#[test]
fn a_simplified_node_is_simplified() {
    let mut random = Random(12);
    for _ in 0..20_000 {
        let mut graph = Graph::new();
        let root = random_node(&mut graph, &mut random);
        for id in graph.reachable(&[root]) {
            let node = graph.node(id);
            if node.op.arity() > 0 {
                let again = graph.apply(node.op, &node.args[..node.op.arity()]);
                assert_eq!(again, id, "{:?} became {:?}", text(&graph, id, 500), text(&graph, again, 500));
            }
        }
    }
}

#[test]
fn text_has_the_fewest_brackets() {
    let rows = [
        ("x + y - z", "x + y - z"),
        ("x - (y - z)", "x - (y - z)"),
        ("x*y/(x*z)", "x*y/(x*z)"),
        ("-(x + y)^2", "-(x + y)^2"),
        ("-((x - y)*sin(z))", "-((x - y)*sin(z))"),
        ("-(x*y)/z", "-x*y/z"),
        ("2*x - 3", "2*x - 3"),
        ("x/3", "x/3"),
        ("x*(2/3)", "2/3*x"),
        ("-3*x*y", "-3*x*y"),
        ("(x^2)^-1", "1/x^2"),
        ("(x/y)^2", "(x/y)^2"),
        ("x^0.3", "x^(0*x + 0.3)"),
        ("x^y", "x^(y)"),
        ("if(x <= 0, y, z)", "if(x <= 0, y, z)"),
        ("root(5, x) + cbrt(y)", "root(5, x) + cbrt(y)"),
    ];
    for (input, expected) in rows {
        let mut graph = Graph::new();
        for name in ["x", "y", "z"] {
            formula(&mut graph, name);
        }
        let id = formula(&mut graph, input);
        assert_eq!(text(&graph, id, 100).as_deref(), Some(expected), "{input}");
    }
}

#[test]
fn latex_of_what_people_write() {
    let rows = [
        ("x^2 + y^2 - 1", "x^{2} + y^{2} - 1"),
        ("x/(y + 1)", "\\frac{x}{y + 1}"),
        ("-(x + y)*z", "-z \\left(x + y\\right)"),
        ("x*0.5", "0.5 x"),
        ("x*(2/3)", "\\frac{2}{3} x"),
        ("sqrt(x) + cbrt(y)", "\\sqrt{x} + \\sqrt[3]{y}"),
        ("exp(-x^2)", "e^{-x^{2}}"),
        ("sin(x)*cos(y)", "\\sin\\left(x\\right) \\cos\\left(y\\right)"),
        ("sin(x)^2", "\\sin\\left(x\\right)^{2}"),
        ("abs(x) - floor(y)", "\\left|x\\right| - \\left\\lfloor y\\right\\rfloor "),
        ("(x/y)^2", "\\left(\\frac{x}{y}\\right)^{2}"),
        ("exp(x)^y", "\\left(e^{x}\\right)^{y}"),
        ("asinh(pi*x)", "\\operatorname{arsinh}\\left(\\pi x\\right)"),
        ("if(x <= 0, y, z)", "\\begin{cases}y & x \\le 0\\\\z & \\text{otherwise}\\end{cases}"),
    ];
    for (input, expected) in rows {
        let mut graph = Graph::new();
        for name in ["pi", "x", "y", "z"] {
            formula(&mut graph, name);
        }
        let id = formula(&mut graph, input);
        assert_eq!(latex(&graph, id, 200).as_deref(), Some(expected), "{input}");
    }
}

#[test]
fn what_is_shared_is_named_once() {
    let mut graph = Graph::new();
    let mut u = formula(&mut graph, "x + y");
    for _ in 0..60 {
        let sine = graph.apply(Op::Sin, &[u]);
        u = graph.apply(Op::Mul, &[sine, u]);
    }
    assert_eq!(text(&graph, u, 10_000), None);
    assert_eq!(latex(&graph, u, 10_000), None);
    let (list, last) = definitions(&graph, u);
    assert_eq!(list.len(), 60);
    assert_eq!(list[0], ("t1".to_string(), "x + y".to_string()));
    assert_eq!(list[1].1, "t1*sin(t1)");
    assert_eq!(last, "t60*sin(t60)");
}

/// The node made again in another graph.
fn transplanted(from: &Graph, root: NodeId, to: &mut Graph) -> NodeId {
    let mut all = vec![NodeId(0); from.len()];
    for id in from.reachable(&[root]) {
        let args: Vec<NodeId> = from.args(id).iter().map(|a| all[a.0 as usize]).collect();
        all[id.0 as usize] = match from.constant(id) {
            Some(c) => to.number(c.clone()),
            None => to.apply(from.op(id), &args),
        };
    }
    all[root.0 as usize]
}

#[test]
fn text_reads_back_by_the_language_itself() {
    let mut random = Random(13);
    let mut compared = 0;
    for _ in 0..4000 {
        let mut graph = Graph::new();
        let id = random_node(&mut graph, &mut random);
        let nodes = graph.reachable(&[id]);
        let whole = |id: &NodeId| {
            graph.op(*id) == Op::Pow && graph.constant(graph.args(*id)[1]).is_some_and(|c| c.is_integer())
        };
        let varies = nodes.iter().any(|id| matches!(graph.op(*id), Op::Variable(_)));
        if nodes.iter().any(whole) || !varies || matches!(graph.op(id), Op::Variable(_)) {
            continue;
        }
        let Some(shown) = text(&graph, id, 1000) else { continue };
        let (mut read, f) = typed(&format!("{shown} = 0"));
        let expected = transplanted(&graph, id, &mut read);
        assert_eq!(f, expected, "{shown} became {:?}", text(&read, f, 2000));
        compared += 1;
    }
    assert!(compared > 2000, "{compared}");
}
