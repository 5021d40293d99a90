//! One corpus, every family of closures: trees, batches of points, enclosures, at both levels of instructions.

use glam::DVec3;
use implicit::closure::tree::tree;
use implicit::closure::{Formula, Kernel, Tape};
use implicit::diag::Sources;
use implicit::expr::derivative;
use implicit::expr::graph::{Graph, NodeId};
use implicit::expr::lower::{self, lower};
use implicit::num::interval::{Defined, Interval};
use implicit::num::lanes::Lanes;
use implicit::num::level::Simd;

/// The formulas and points of the table of derivatives.
fn corpus() -> Vec<(String, DVec3)> {
    let table = include_str!("../data/derivatives.tsv");
    let rows = table.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    rows.filter_map(|row| {
        let fields: Vec<&str> = row.split('\t').collect();
        let point: Vec<f64> = fields.get(1)?.split(' ').map(|t| t.parse().ok()).collect::<Option<_>>()?;
        Some((fields[0].to_string(), DVec3::from_slice(&point)))
    })
    .collect()
}

fn graph_of(formula: &str) -> (Graph, NodeId) {
    let mut sources = Sources::new();
    sources.add("table", formula);
    let lowered = lower(&implicit::syntax::parse(&sources.texts()).program, &lower::Settings::default());
    (lowered.graph, lowered.surfaces[0].f)
}

#[test]
fn every_family_gives_the_same_value_and_enclosures_contain_it() {
    let corpus = corpus();
    assert!(corpus.len() >= 500, "{}", corpus.len());
    for (formula, p) in corpus {
        let (mut graph, f) = graph_of(&formula);
        let levels: Vec<Formula> = Simd::all().into_iter().map(|simd| Formula::new(&mut graph, f, simd)).collect();
        let (value, gradient) = levels[0].gradient(p);
        for level in &levels {
            assert_eq!(same(level.gradient(p)), same((value, gradient)), "{formula} at {p}: levels differ");
        }
        if let Some(tree) = tree(&graph, f, Simd::best()) {
            let of_tree = tree(&[p.x, p.y, p.z, 0.0, 0.0, 0.0]);
            assert!(close(of_tree, value), "{formula} at {p}: tree {of_tree}, list {value}");
        }
        let [x, y, z] = derivative::gradient(&mut graph, f);
        for tape in [Tape::new, Tape::for_points] {
            let batch = batch_of_64(&tape(&graph, &[f, x, y, z]), p);
            assert_eq!(batch, same((value, gradient)), "{formula} at {p}: batch");
        }
        for half in [0.0, 1e-9, 1e-3, 0.3] {
            let around = p.to_array().map(|c| Interval::new(c - half, c + half));
            let all = levels[0].enclosure(around);
            assert!(levels.iter().all(|level| level.enclosure(around) == all), "{formula} around {p}");
            assert!(all.range.contains(value), "{formula} within {half} of {p}: {value} outside {all:?}");
            assert_ne!(all.defined, Defined::Nowhere);
        }
    }
}

fn same((value, gradient): (f64, DVec3)) -> [u64; 4] {
    [value.to_bits(), gradient.x.to_bits(), gradient.y.to_bits(), gradient.z.to_bits()]
}

/// Constants are folded in the list and computed again in the tree: an ulp or two of the largest term.
fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-13 * (1.0 + a.abs())
}

/// The last lane of f and its gradient, computed in a batch.
fn batch_of_64(tape: &Tape, p: DVec3) -> [u64; 4] {
    let kernel: Kernel<Lanes<64>> = Kernel::new(tape, Simd::best());
    let mut registers = kernel.registers();
    for axis in 0..3 {
        registers[axis] = Lanes::splat(p[axis]);
    }
    kernel.run(&mut registers);
    std::array::from_fn(|k| kernel.output(&registers, k).0[63].to_bits())
}

#[test]
fn a_tree_that_sharing_hides_is_refused_not_built() {
    let doubling: String = (0..60).map(|k| format!("a{} = a{k} + a{k}^2;", k + 1)).collect();
    let (graph, f) = graph_of(&format!("a0 = x; {doubling} a60 + y"));
    assert!(tree(&graph, f, Simd::best()).is_none());
    assert!(Tape::new(&graph, &[f]).steps.len() < 200);
}
