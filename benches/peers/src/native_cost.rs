//! What f with its gradient costs when rustc compiles the formula, and what the closures take for the same.
//!
//! In: the formulas of `benches/closures/native.rs`. Out: ns a point of both, and the table of their ratio. The native
//! cost of one evaluation a hit is what no tracer can go below.

use crate::clock::{median, timed};
use crate::closures::{Closures, POINTS};
use crate::native::{self, CASES, Case};
use crate::table::mark;
use std::hint::black_box;
use std::sync::OnceLock;

/// Calls in one sample, and samples.
const CALLS: usize = 20_000;
const SAMPLES: usize = 9;

/// Which formula by hand stands for which scene. csg27's is without the ball cut out, so its limit is too low.
const SCENES: [(&str, &str); 7] = [
    ("sphere", "sphere"),
    ("eggcrate", "z - sin x cos y"),
    ("barth6", "Barth sextic"),
    ("tanglecube", "tanglecube"),
    ("gyroid", "gyroid"),
    ("metaballs", "20 Gaussians"),
    ("csg27", "27 spheres by min"),
];

/// ns a point.
struct Cost {
    closures: f64,
    native: f64,
}

/// ns of one native evaluation of the scene's formula, where it is written by hand.
pub fn of_scene(name: &str) -> Option<f64> {
    let (_, formula) = SCENES.iter().find(|(scene, _)| *scene == name)?;
    let index = CASES.iter().position(|case| case.name == *formula)?;
    Some(costs()[index].native)
}

fn costs() -> &'static [Cost] {
    static COSTS: OnceLock<Vec<Cost>> = OnceLock::new();
    COSTS.get_or_init(|| CASES.iter().map(cost).collect())
}

fn cost(case: &Case) -> Cost {
    let points: [[f64; POINTS]; 3] = std::array::from_fn(|axis| std::array::from_fn(|i| coordinate(axis, i)));
    let mut by_hand = [[0.0; POINTS]; 4];
    let mut closures = Closures::new(&(case.text)());
    closures.set(&points);
    let mut samples = [Vec::new(), Vec::new()];
    for _ in 0..SAMPLES {
        let ((), seconds) = timed(|| (0..CALLS).for_each(|_| closures.run()));
        samples[0].push(seconds);
        let native = || (0..CALLS).for_each(|_| native::run(case, black_box(&points), black_box(&mut by_hand)));
        samples[1].push(timed(native).1);
    }
    let [closures, native] = samples.map(|seconds| median(&seconds) * 1e9 / (CALLS * POINTS) as f64);
    Cost { closures, native }
}

/// Coordinate `axis` of the i-th point: spread over the cube of side 3.
fn coordinate(axis: usize, i: usize) -> f64 {
    3.0 * ((0.31 + [0.618, 0.382, 0.271][axis] * i as f64) % 1.0) - 1.5
}

/// The table of closures against native code.
pub fn table() -> String {
    let mut text = String::from(
        "| f with gradient | closures, ns/point | native, ns/point | ratio | goal |\n| --- | --- | --- | --- | --- |\n",
    );
    for (case, cost) in CASES.iter().zip(costs()) {
        let ratio = cost.closures / cost.native;
        let numbers = format!(
            "{:.2} | {:.2} | {} | ≤ {:.0}",
            cost.closures,
            cost.native,
            mark(format!("{ratio:.1}"), ratio <= case.goal),
            case.goal
        );
        text += &format!("| {} | {numbers} |\n", case.name);
    }
    text
}
