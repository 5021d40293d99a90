//! One picture with known depths: what is drawn, from where, and the rays of its pixels.
//!
//! In: `cases.toml` of a folder of `tests/data`. Out: cases, and what the library answers to their rays. Apart from the
//! comparison because this is the only place that knows how a formula becomes hits.

use glam::DVec3;
use implicit::diag::Sources;
use implicit::expr::lower::{self, lower};
use implicit::num::level::Simd;
use implicit::scene::camera::{Camera, Projection};
use implicit::surface::{Clip, Hit, Method, Rectangle, Shape, Surface, Tracer};
use implicit::syntax;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// The side of the rectangles that are traced at once.
const SIDE: usize = 64;

/// How the rays of a picture are settled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Way {
    /// Each by itself.
    Rays,
    /// In squares of pixels, where that can be.
    Squares,
}

/// A picture with known depths.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) formula: String,
    pub(crate) shape: Shape,
    pub(crate) eye: DVec3,
    pub(crate) look_at: DVec3,
    pub(crate) fov: f64,
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// The file of depths.
    pub(crate) depths: PathBuf,
}

/// The cases of a folder of `tests/data`.
pub(crate) fn cases(folder: &str) -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(folder);
    let table: Table = std::fs::read_to_string(folder.join("cases.toml")).unwrap().parse().unwrap();
    table["case"].as_array().unwrap().iter().map(|value| case(value.as_table().unwrap(), &folder)).collect()
}

fn case(table: &Table, folder: &Path) -> Case {
    let text = |key: &str| table[key].as_str().unwrap().to_string();
    let whole = |key: &str| u32::try_from(table[key].as_integer().unwrap()).unwrap();
    Case {
        name: text("name"),
        formula: text("formula"),
        shape: shape(table["clip"].as_table().unwrap()),
        eye: vector(&table["eye"]),
        look_at: vector(&table["look_at"]),
        fov: table["fov"].as_float().unwrap(),
        width: whole("width"),
        height: whole("height"),
        depths: folder.join(format!("{}.npy", text("name"))),
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_float().unwrap()).collect()
}

fn vector(value: &Value) -> DVec3 {
    DVec3::from_slice(&numbers(value))
}

fn shape(clip: &Table) -> Shape {
    if let Some(ball) = clip.get("ball") {
        let ball = numbers(ball);
        return Shape::Ball { center: DVec3::from_slice(&ball), radius: ball[3] };
    }
    let side = numbers(&clip["box"]);
    Shape::Box { min: DVec3::new(side[0], side[2], side[4]), max: DVec3::new(side[1], side[3], side[5]) }
}

impl Case {
    /// The length that tolerances are measured by.
    pub(crate) fn size(&self) -> f64 {
        self.shape.size()
    }

    /// The formula ready for rays.
    pub(crate) fn surfaces(&self) -> Result<Vec<Surface>, String> {
        let mut sources = Sources::new();
        let source = sources.add(self.name.as_str(), self.formula.as_str());
        let parsed = syntax::parse(&[(source, &self.formula)]);
        let lowered = lower(&parsed.program, &lower::Settings::default());
        if lowered.has_errors() || lowered.surfaces.is_empty() {
            return Err(format!("{:?} {:?}", parsed.diagnostics, lowered.diagnostics));
        }
        let (mut graph, clip) = (lowered.graph, Clip::shape(self.shape));
        let formulas = lowered.surfaces.iter();
        let kind = implicit::surface::Kind::Equation;
        Ok(formulas.map(|formula| Surface::new(&mut graph, formula.f, kind, &clip, Simd::best())).collect())
    }

    /// What is hit in the centre of each pixel, row by row.
    pub(crate) fn trace(&self, method: Method, way: Way) -> Result<Vec<Hit>, String> {
        let camera = Camera::new(self.eye, self.look_at, Projection::Perspective { fov: self.fov });
        let camera = camera.map_err(|error| error.to_string())?;
        let surfaces = self.surfaces()?;
        let (width, height) = (self.width, self.height);
        let mut tracer = Tracer::new(&surfaces, method);
        let mut all = vec![Hit::NONE; (width * height) as usize];
        let mut hits = Vec::new();
        for (left, top) in (0..height).step_by(SIDE).flat_map(|j| (0..width).step_by(SIDE).map(move |i| (i, j))) {
            let side = SIDE as u32;
            let rectangle = Rectangle { left, top, width: side.min(width - left), height: side.min(height - top) };
            let pixels = (0..rectangle.height).flat_map(|j| (0..rectangle.width).map(move |i| (left + i, top + j)));
            let pixels: Vec<(u32, u32)> = pixels.collect();
            let ray = |&(i, j): &(u32, u32)| camera.ray(width, height, f64::from(i) + 0.5, f64::from(j) + 0.5);
            let rays: Vec<_> = pixels.iter().map(ray).collect();
            match way {
                Way::Rays => tracer.trace(&rays, &mut hits),
                Way::Squares => tracer.trace_rectangle(&camera.screen(width, height), rectangle, &mut hits),
            }
            for (&(i, j), hit) in pixels.iter().zip(&hits) {
                all[(j * width + i) as usize] = *hit;
            }
        }
        Ok(all)
    }
}
