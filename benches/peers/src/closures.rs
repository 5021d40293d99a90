//! f with its gradient by the closures of this tracer, away from any ray.
//!
//! In: a formula. Out: values at 64 points at once. Serves the largest gradient that POV-Ray must be told, and the cost
//! of an evaluation beside the native one.

use crate::ours::graph;
use crate::scenes::Clip;
use glam::DVec3;
use implicit::closure::{Kernel, Tape};
use implicit::expr::derivative::gradient;
use implicit::num::lanes::Lanes;
use implicit::num::level::Simd;

/// Points evaluated at once.
pub const POINTS: usize = 64;

/// Points along an edge of the grid on which the largest gradient is looked for.
const GRID: usize = 129;

/// f and its gradient, ready to run.
pub struct Closures {
    kernel: Kernel<Lanes<POINTS>>,
    registers: Vec<Lanes<POINTS>>,
}

impl Closures {
    pub fn new(formula: &str) -> Self {
        let mut lowered = graph(formula);
        let f = lowered.surfaces[0].f;
        let [x, y, z] = gradient(&mut lowered.graph, f);
        let kernel = Kernel::new(&Tape::for_points(&lowered.graph, &[f, x, y, z]), Simd::best());
        Closures { registers: kernel.registers(), kernel }
    }

    pub fn set(&mut self, points: &[[f64; POINTS]; 3]) {
        for (axis, coordinates) in points.iter().enumerate() {
            self.registers[axis] = Lanes(*coordinates);
        }
    }

    pub fn run(&mut self) {
        self.kernel.run(std::hint::black_box(&mut self.registers));
    }

    fn gradient(&self, lane: usize) -> DVec3 {
        DVec3::from_array([1, 2, 3].map(|k| self.kernel.output(&self.registers, k).0[lane]))
    }
}

/// The largest length of the gradient on a grid over the clip; points outside a ball are brought to its surface.
pub fn largest_gradient(formula: &str, clip: Clip) -> f64 {
    let mut closures = Closures::new(formula);
    let half = match clip {
        Clip::Ball(half) | Clip::Box(half) => half,
    };
    let coordinate = |k: usize| half * (2.0 * k as f64 / (GRID - 1) as f64 - 1.0);
    let (mut largest, mut count, mut points) = (0f64, 0, [[0.0; POINTS]; 3]);
    for k in 0..GRID * GRID * GRID {
        let p = DVec3::new(coordinate(k % GRID), coordinate(k / GRID % GRID), coordinate(k / GRID / GRID));
        let p = if let Clip::Ball(radius) = clip { p.clamp_length_max(radius) } else { p };
        (points[0][count], points[1][count], points[2][count]) = (p.x, p.y, p.z);
        count += 1;
        if count == POINTS {
            closures.set(&points);
            closures.run();
            largest = (0..POINTS).map(|lane| closures.gradient(lane).length()).fold(largest, f64::max);
            count = 0;
        }
    }
    largest
}
