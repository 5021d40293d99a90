//! Where in space which arguments of a formula's long minima and maxima matter.
//!
//! In: a sheet's kernels and the box it is seen in. Out: for a ray, one piece after the other with the [`Program`] that is enough on
//! it; what is between the pieces is proven empty. Cells are cut into 4 × 4 × 4 when a ray first comes to them, and a cell
//! is settled by affine forms of (x, y, z) over it. A piece is given the program of a cell only if enclosures of its ends are in the
//! cell, which is a little larger than its share of the box: so nothing depends on how a ray finds its way.
//! Separate from [`super::isolate`], which finds roots in one formula.

use super::hit::Ray;
use super::kernels::{Kernels, Program};
use super::region::Shape;
use super::tile::Forms;
use crate::closure::specialise::{SLABS, Slabs};
use crate::num::interval_lanes::NOWHERE;
use crate::num::level::Simd;
use glam::DVec3;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// A cell is cut into so many along each axis, so that all lanes have one.
const SIDE: usize = 4;

/// How often a cell of the box is cut: 64 cells across in the end.
const LEVELS: u32 = 3;

/// Cells across at the last level.
const FINEST: usize = SIDE.pow(LEVELS);

/// Where no more arguments than this matter a cell is not cut.
const FEW: usize = 2;

/// With fewer arguments than this rays go through the whole formula: lanes that share a piece's formula are not full. Measured for
/// bounces of 10, 27 (`csg27`) and 100 spheres, without and with an index: 621, 1856, 8243 and 833, 2600, 3100 ns a ray.
const FEWEST: usize = 64;

/// How much a cell reaches beyond its share on each side, as a part of the box: far more than what rays and cells are rounded.
const OVERLAP: f64 = 1e-7;

/// How far behind the beginning of a piece it is decided in which cell it is, as a part of the box.
const AHEAD: f64 = 1e-8;

/// The cells of a box.
pub(crate) struct Index {
    corner: DVec3,
    /// From side to side.
    extent: DVec3,
    /// Cells of the last level in a unit of length.
    per_cell: DVec3,
    top: OnceLock<Children>,
    /// All programs made so far, by the arguments that are live.
    programs: Mutex<HashMap<Box<[u32]>, Arc<Program>>>,
    all: Vec<u32>,
    simd: Simd,
}

type Children = Box<[Cell]>;

/// What is known of a cell.
enum Cell {
    /// No root is in it.
    Empty,
    /// So much of the formula matters.
    Leaf(Arc<Program>),
    /// The same, with cells of its own.
    Inner(Arc<Program>, OnceLock<Children>),
}

/// Registers that an index computes with.
pub(crate) struct Scratch<'a> {
    pub(crate) leaves: &'a mut [Slabs],
    pub(crate) value: &'a mut [Forms],
}

/// A piece of a ray and what is enough on it; all of the formula, if no program is named.
pub(crate) struct Piece {
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) program: Option<Arc<Program>>,
}

impl Piece {
    /// A number that pieces of one program have in common.
    pub(crate) fn place(&self) -> usize {
        self.program.as_ref().map_or(0, |program| Arc::as_ptr(program).addr())
    }
}

/// A cell by its number along each axis, at the last level, with the cells it is made of.
struct Place {
    first: [usize; 3],
    across: usize,
}

impl Index {
    /// The index of a function seen in these shapes; `None` if it is not worth it.
    pub(crate) fn new(kernels: &Kernels, shapes: &[Shape], simd: Simd) -> Option<Index> {
        let arguments = kernels.parts.as_ref()?.choices.arguments();
        if arguments < FEWEST || shapes.is_empty() {
            return None;
        }
        let (mut least, mut most) = (DVec3::NEG_INFINITY, DVec3::INFINITY);
        for shape in shapes {
            let (min, max) = match *shape {
                Shape::Box { min, max } => (min, max),
                Shape::Ball { center, radius } => (center - radius, center + radius),
            };
            (least, most) = (least.max(min), most.min(max));
        }
        let extent = most - least;
        let is_solid = extent.min_element() > 0.0 && extent.is_finite();
        is_solid.then(|| Index {
            corner: least,
            extent,
            per_cell: extent.recip() * FINEST as f64,
            top: OnceLock::new(),
            programs: Mutex::default(),
            all: (0..arguments as u32).collect(),
            simd,
        })
    }

    /// The first piece of a ray between two distances on which anything can be.
    pub(crate) fn piece(
        &self,
        kernels: &Kernels,
        ray: &Ray,
        (mut a, end): (f64, f64),
        scratch: &mut Scratch,
    ) -> Option<Piece> {
        let ahead = AHEAD * self.extent.max_element();
        let inverse = ray.direction.recip();
        let mut piece: Option<Piece> = None;
        loop {
            let (place, cell) = self.find(kernels, ray.at(a + ahead), scratch);
            let sides = self.sides(&place);
            let b = leave(sides, ray.origin, inverse).max(a + ahead).min(end);
            if !self.holds(sides, ray, a, b) {
                return Some(piece.unwrap_or(Piece { a, b: end, program: None }));
            }
            match (cell.program(), &mut piece) {
                (None, Some(_)) => return piece,
                (None, None) => {}
                (Some(program), None) => piece = Some(Piece { a, b, program: Some(program.clone()) }),
                (Some(program), Some(so_far)) => {
                    if !so_far.program.as_ref().is_some_and(|before| Arc::ptr_eq(before, program)) {
                        return piece;
                    }
                    so_far.b = b;
                }
            }
            if b >= end {
                return piece;
            }
            a = b;
        }
    }

    /// The cell at a point, or the nearest one to it.
    fn find<'a>(&'a self, kernels: &Kernels, point: DVec3, scratch: &mut Scratch) -> (Place, &'a Cell) {
        let part = (point - self.corner) * self.per_cell;
        let at: [usize; 3] = part.to_array().map(|c| (c.max(0.0) as usize).min(FINEST - 1));
        let (mut across, mut first) = (FINEST, [0; 3]);
        let mut children = self.top.get_or_init(|| self.cut(kernels, &self.all, &first, across, scratch));
        loop {
            across /= SIDE;
            let shift = across.trailing_zeros();
            let along = [0, 1, 2].map(|axis| (at[axis] - first[axis]) >> shift);
            first = [0, 1, 2].map(|axis| first[axis] + (along[axis] << shift));
            let cell = &children[(along[2] * SIDE + along[1]) * SIDE + along[0]];
            let Cell::Inner(program, inner) = cell else { return (Place { first, across }, cell) };
            children = inner.get_or_init(|| self.cut(kernels, &program.live, &first, across, scratch));
        }
    }

    /// Where the sides of a cell are: those of its share of the box.
    fn sides(&self, place: &Place) -> (DVec3, DVec3) {
        let at = |offset: usize| {
            let part = place.first.map(|first| (first + offset) as f64);
            self.corner + self.extent * (1.0 / FINEST as f64) * DVec3::from_array(part)
        };
        (at(0), at(place.across))
    }

    /// Whether all of a piece is in a cell; as [`super::isolate::place`] encloses it.
    fn holds(&self, (min, max): (DVec3, DVec3), ray: &Ray, a: f64, b: f64) -> bool {
        const PER_DISTANCE: f64 = 1.0 / (1u64 << 50) as f64;
        let overlap = OVERLAP * self.extent;
        let (p, q) = (ray.at(a), ray.at(b));
        let error = DVec3::splat(4.0 * b * PER_DISTANCE) + 4.0 * f64::EPSILON * ray.origin.abs();
        (p.min(q) - error).cmpge(min - overlap).all() && (p.max(q) + error).cmple(max + overlap).all()
    }

    /// Cuts a cell where these arguments matter.
    fn cut(
        &self,
        kernels: &Kernels,
        live: &[u32],
        first: &[usize; 3],
        across: usize,
        scratch: &mut Scratch,
    ) -> Children {
        let Some(parts) = &kernels.parts else { return Box::default() };
        let steps = parts.steps_of(live);
        let (leaves, parent) = (parts.leaves(&steps), Program::new(live));
        let value = kernels.only(&parent).value_form();
        let (mut bits, mut children) = (Vec::new(), Vec::with_capacity(SIDE.pow(3)));
        let part = across / SIDE;
        for plane in 0..SIDE {
            let places: [Place; SLABS] = std::array::from_fn(|k| {
                let along = [k % SIDE, k / SIDE, plane];
                Place { first: [0, 1, 2].map(|axis| first[axis] + along[axis] * part), across: part }
            });
            self.fill(&places, scratch.leaves);
            leaves.run(scratch.leaves);
            parts.choices.live(self.simd, &leaves, scratch.leaves, live, &mut bits);
            self.fill(&places, scratch.value);
            value.run(scratch.value);
            let g = value.output(scratch.value, 0);
            for lane in 0..SLABS {
                let is_empty = g.center[lane].abs() > g.radius(lane) * (1.0 + 1e-12) || g.flags[lane] & NOWHERE != 0;
                let here: Vec<u32> =
                    live.iter().zip(&bits).filter(|(_, bits)| **bits >> lane & 1 == 1).map(|(&k, _)| k).collect();
                children.push(if is_empty || here.is_empty() { Cell::Empty } else { self.cell(here, part) });
            }
        }
        children.into()
    }

    fn cell(&self, live: Vec<u32>, across: usize) -> Cell {
        // What another thread was doing when it panicked does not matter: programs are whole when they get in.
        let mut programs = self.programs.lock().unwrap_or_else(PoisonError::into_inner);
        let is_small = live.len() <= FEW || across == 1;
        let program = programs.entry(live.as_slice().into()).or_insert_with(|| Arc::new(Program::new(&live))).clone();
        if is_small { Cell::Leaf(program) } else { Cell::Inner(program, OnceLock::new()) }
    }

    /// Puts the points of cells into the registers of the coordinates.
    fn fill(&self, places: &[Place; SLABS], forms: &mut [Forms]) {
        for (lane, place) in places.iter().enumerate() {
            let (min, max) = self.sides(place);
            let (middle, half) = (0.5 * (min + max), 0.5 * (max - min) + 2.0 * OVERLAP * self.extent);
            for axis in 0..3 {
                let form = &mut forms[axis];
                form.center[lane] = middle[axis];
                for symbol in 0..3 {
                    form.slope[symbol][lane] = if symbol == axis { half[axis] } else { 0.0 };
                }
                (form.error[lane], form.flags[lane]) = (0.0, 0);
            }
        }
    }
}

/// The distance at which a ray leaves the space between these corners, from its origin and the inverse of its direction.
#[inline]
fn leave((min, max): (DVec3, DVec3), origin: DVec3, inverse: DVec3) -> f64 {
    // Along an axis on which it does not move both are infinite, or NaN, which `max` passes over.
    let (p, q) = ((min - origin) * inverse, (max - origin) * inverse);
    let far = |axis: usize| p[axis].max(q[axis]);
    far(0).min(far(1)).min(far(2))
}

impl Cell {
    fn program(&self) -> Option<&Arc<Program>> {
        match self {
            Cell::Empty => None,
            Cell::Leaf(program) | Cell::Inner(program, _) => Some(program),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::formula::formula;
    use crate::expr::graph::Graph;
    use crate::surface::{Clip, Kind, Method, Surface, Tracer};

    /// A linear congruential generator (Knuth, TAOCP 2, section 3.3.4), from −1 to 1.
    struct Random(u64);

    impl Random {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        }
    }

    fn objects(random: &mut Random, op: &str, object: impl Fn(&str, f64) -> String) -> String {
        let one = |random: &mut Random| {
            let [x, y, z] = [0; 3].map(|_| format!("{:.3}", 2.0 + random.next()));
            let square = format!("((x+2-{x})^2+(y+2-{y})^2+(z+2-{z})^2)");
            object(&square, 0.02 + 0.01 * random.next())
        };
        let all: Vec<String> = (0..70).map(|_| one(random)).collect();
        all.into_iter().reduce(|a, b| format!("{op}({a},{b})")).unwrap()
    }

    #[test]
    fn rays_meet_the_same_with_an_index_and_without() {
        let mut random = Random(27);
        let spheres = objects(&mut random, "min", |square, r| format!("{square}-{r:.4}"));
        let holes = objects(&mut random, "max", |square, r| format!("{r:.4}-{square}"));
        let distances = objects(&mut random, "min", |square, r| format!("sqrt({square})-{r:.4}"));
        let rows = [
            spheres.clone(),
            format!("max({holes},x^2+y^2+z^2-0.8)"),
            format!("0.5*({distances}+z+sqrt(({distances}-z)^2+0.01))"),
            format!("max({spheres},x)"),
        ];
        for text in rows {
            let mut graph = Graph::new();
            let f = formula(&mut graph, &text);
            let clip = Clip::shape(Shape::Ball { center: DVec3::splat(0.1), radius: 1.6 });
            let mut surfaces = [Surface::new(&mut graph, f, Kind::Equation, &clip, Simd::best())];
            assert!(surfaces[0].sheets.iter().all(|sheet| sheet.index.is_some()), "{text}");
            let mut point = || DVec3::new(random.next(), random.next(), random.next());
            let rays: Vec<Ray> = (0..400)
                .map(|k| {
                    let origin = point() * if k % 2 == 0 { 1.0 } else { 3.0 };
                    Ray::new(origin, (point() * 0.7 - origin).normalize())
                })
                .collect();
            let [mut with, mut without] = [Vec::new(), Vec::new()];
            Tracer::new(&surfaces, Method::Faithful).trace(&rays, &mut with);
            surfaces[0].sheets.iter_mut().for_each(|sheet| sheet.index = None);
            Tracer::new(&surfaces, Method::Faithful).trace(&rays, &mut without);
            assert!(with.iter().any(|hit| hit.is_drawn()) && with.iter().any(|hit| !hit.is_drawn()));
            for (a, b) in with.iter().zip(&without) {
                let same = a.t == b.t || (a.t - b.t).abs() <= 4e-10 * 4.0;
                assert!(a.outcome == b.outcome && a.proven == b.proven && same, "{a:?} {b:?}");
            }
        }
    }
}
