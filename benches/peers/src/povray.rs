//! POV-Ray's isosurface, as a whole process.
//!
//! In: a scene. Out: what one picture took, and its pixels. Its `max_gradient` is the largest gradient in the whole
//! clip: with less it leaves out parts of the surface, with its default most of it.

use crate::Outcome;
use crate::closures::largest_gradient;
use crate::formula::{Algebra, translate};
use crate::picture;
use crate::process::{Usage, run};
use crate::scenes::{Clip, FIELD_OF_VIEW, Scene};
use glam::DVec3;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

/// What the gradient on a grid is raised by, for what lies between its points.
const SAFETY: f64 = 1.05;

/// POV-Ray is stopped after so much wall time.
const LIMIT: Duration = Duration::from_secs(60);

pub fn is_installed() -> bool {
    Command::new("povray").arg("--version").output().is_ok()
}

/// Writes the scene for [`draw`]; without an object it is empty.
pub fn prepare(scene: &Scene, has_object: bool, folder: &Path) -> Outcome {
    let object = if has_object { object(scene).ok_or("not a formula in POV-Ray's notation")? } else { String::new() };
    let (camera, width) = (scene.camera(), 2.0 * (FIELD_OF_VIEW / 2.0).to_radians().tan());
    let light = camera.right * 0.4 + camera.up * 0.5 - camera.forward;
    let text = format!(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1.0 max_trace_level 1 }}\nbackground {{ rgb <0, 0, 1> }}\n\
         camera {{ perspective location {} direction {} right {} up {} }}\n\
         light_source {{ {} rgb 1 parallel point_at 0 shadowless }}\n{object}\n",
        vector(camera.eye),
        vector(camera.forward),
        vector(camera.right * width),
        vector(camera.up * width),
        vector(light * 1e3),
    );
    Ok(std::fs::write(folder.join("scene.pov"), text)?)
}

/// One picture: what it took, and which pixels it hit; no pixels where it was stopped.
pub fn draw(size: u32, folder: &Path) -> Outcome<(Usage, Option<Vec<bool>>)> {
    let pixmap = folder.join("povray.ppm");
    let mut command = Command::new("povray");
    command.current_dir(folder).args(["+Iscene.pov", "+Opovray.ppm", "+FP8", "+WT1", "-D", "-A", "-GR", "-GS", "-V"]);
    let usage = run(command.args([format!("+W{size}"), format!("+H{size}")]).arg("File_Gamma=1.0"), LIMIT)?;
    let hits = if usage.is_done { picture::hits(&pixmap, size) } else { None };
    Ok((usage, hits))
}

fn object(scene: &Scene) -> Option<String> {
    let body = match scene.clip {
        Clip::Ball(radius) => format!("sphere {{ 0, {radius} }}"),
        Clip::Box(half) => format!("box {{ -{half}, {half} }}"),
    };
    Some(format!(
        "isosurface {{ function {{ {} }} contained_by {{ {body} }} threshold 0 accuracy 1e-4 max_gradient {} open\n\
         pigment {{ rgb 1 }} finish {{ ambient 0.15 diffuse 0.85 }} }}",
        translate(&scene.formula, &Notation)?,
        SAFETY * largest_gradient(&scene.formula, scene.clip)
    ))
}

fn vector(v: DVec3) -> String {
    format!("<{:?}, {:?}, {:?}>", v.x, v.y, v.z)
}

/// Functions as POV-Ray writes them: it has no power sign.
struct Notation;

/// Bases up to this many characters are multiplied out: that is faster there than `pow`.
const SHORT: usize = 16;

impl Algebra for Notation {
    type Value = String;

    fn number(&self, value: f64) -> String {
        format!("{value:?}")
    }

    fn coordinate(&self, axis: usize) -> String {
        ["x", "y", "z"][axis].into()
    }

    fn negated(&self, a: String) -> String {
        format!("(-{a})")
    }

    fn plus(&self, a: String, b: String) -> String {
        format!("({a} + {b})")
    }

    fn minus(&self, a: String, b: String) -> String {
        format!("({a} - {b})")
    }

    fn times(&self, a: String, b: String) -> String {
        format!("({a} * {b})")
    }

    fn over(&self, a: String, b: String) -> String {
        format!("({a} / {b})")
    }

    fn power(&self, a: String, exponent: f64) -> Option<String> {
        let is_short = a.len() <= SHORT && [2.0, 3.0, 4.0].contains(&exponent);
        Some(if is_short {
            format!("({})", vec![a; exponent as usize].join("*"))
        } else {
            format!("pow({a}, {exponent:?})")
        })
    }

    fn call(&self, name: &str, arguments: Vec<String>) -> Option<String> {
        let known = ["sin", "cos", "exp", "sqrt", "abs", "min", "max"];
        known.contains(&name).then(|| format!("{name}({})", arguments.join(", ")))
    }
}
