//! The public set of surfaces: `tests/data/scenes.toml`, the file that the tests read too.
//!
//! In: that file. Out: formulas, clips and cameras. Separate because every peer needs the same ones.

use crate::Outcome;
use glam::DVec3;
use implicit::scene::camera::{Camera, Projection};
use implicit::surface::Shape;

/// Vertical field of view of every scene, degrees: the file's default.
pub const FIELD_OF_VIEW: f64 = 40.0;

/// The part of space that is shown.
#[derive(Clone, Copy)]
pub enum Clip {
    /// |p| ≤ r.
    Ball(f64),
    /// |x|, |y|, |z| ≤ h.
    Box(f64),
}

impl Clip {
    /// The radius of the ball about the origin that holds it.
    pub fn radius(self) -> f64 {
        match self {
            Clip::Ball(radius) => radius,
            Clip::Box(half) => half * 3f64.sqrt(),
        }
    }

    pub fn shape(self) -> Shape {
        match self {
            Clip::Ball(radius) => Shape::Ball { center: DVec3::ZERO, radius },
            Clip::Box(half) => Shape::Box { min: DVec3::splat(-half), max: DVec3::splat(half) },
        }
    }

    /// A function that is negative inside, as text.
    pub fn formula(self) -> String {
        match self {
            Clip::Ball(radius) => format!("x^2 + y^2 + z^2 - {radius}^2"),
            Clip::Box(half) => format!("max(abs(x) - {half}, abs(y) - {half}, abs(z) - {half})"),
        }
    }
}

/// One surface of the set.
pub struct Scene {
    pub name: String,
    pub formula: String,
    /// The same function as fidget can express it.
    fidget: Option<String>,
    pub clip: Clip,
    pub eye: DVec3,
    /// Total degree of a polynomial; 0: no polynomial.
    pub degree: i64,
    /// Whether f is positive inside the solid.
    is_positive_inside: bool,
}

impl Scene {
    pub fn camera(&self) -> Camera {
        camera(self.eye)
    }

    /// The surface as the boundary of a solid cut by its clip: what a program that draws solids can draw of it.
    pub fn solid(&self) -> String {
        let sign = if self.is_positive_inside { "-" } else { "" };
        let f = self.fidget.as_ref().unwrap_or(&self.formula);
        format!("max({sign}({f}), {})", self.clip.formula())
    }
}

/// The camera at `eye`, looking at the origin.
pub fn camera(eye: DVec3) -> Camera {
    Camera::new(eye, DVec3::ZERO, Projection::Perspective { fov: FIELD_OF_VIEW }).expect("an eye away from the origin")
}

/// All scenes of the file.
pub fn load() -> Outcome<Vec<Scene>> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/data/scenes.toml");
    let table: toml::Table = std::fs::read_to_string(path)?.parse()?;
    let list = table.get("scene").and_then(toml::Value::as_array).ok_or("the file has no scenes")?;
    list.iter().map(|entry| scene(entry).ok_or_else(|| format!("not a scene: {entry}").into())).collect()
}

fn scene(entry: &toml::Value) -> Option<Scene> {
    let text = |key: &str| entry.get(key).and_then(toml::Value::as_str).map(str::to_string);
    let clip = entry.get("clip")?;
    let eye: Option<Vec<f64>> = entry.get("eye")?.as_array()?.iter().map(toml::Value::as_float).collect();
    Some(Scene {
        name: text("name")?,
        formula: text("formula")?,
        fidget: text("fidget"),
        clip: match clip.get("ball") {
            Some(radius) => Clip::Ball(radius.as_float()?),
            None => Clip::Box(clip.get("box")?.as_float()?),
        },
        eye: DVec3::from_slice(&eye?),
        degree: entry.get("degree")?.as_integer()?,
        is_positive_inside: entry.get("inside")?.as_integer()? > 0,
    })
}
