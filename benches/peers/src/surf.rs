//! surf-alggeo, polynomials only, as a whole process.
//!
//! In: a polynomial scene. Out: what one picture took, and its pixels. surf looks along its own z axis at the plane
//! z = 0, ±10 wide, and cuts by a ball: the polynomial is turned and scaled into that frame.

use crate::Outcome;
use crate::formula::{Algebra, translate};
use crate::picture;
use crate::process::{Usage, run};
use crate::scenes::{FIELD_OF_VIEW, Scene};
use glam::DVec3;
use std::path::Path;
use std::process::Command;
use std::time::Duration;

/// The names of the program without and with a window.
const PROGRAMS: [&str; 2] = ["surf-alggeo-nox", "surf-alggeo"];

/// Half of the width that surf shows in the plane through the origin.
const HALF_WIDTH: f64 = 10.0;

/// No polynomial of the set takes so long.
const LIMIT: Duration = Duration::from_secs(120);

/// The program's name, if it is installed.
pub fn program() -> Option<&'static str> {
    let is_there = |name: &&str| Command::new(name).arg("--version").output().is_ok();
    PROGRAMS.iter().find(|name| is_there(name)).copied()
}

/// One picture: what it took, and which pixels it hit.
pub fn draw(program: &str, scene: &Scene, size: u32, folder: &Path) -> Outcome<(Usage, Vec<bool>)> {
    let (script, pixmap) = (folder.join("scene.pic"), folder.join("surf.ppm"));
    std::fs::write(&script, text(scene, size, &pixmap).ok_or("not a polynomial in surf's notation")?)?;
    let usage = run(Command::new(program).arg("-q").arg(&script), LIMIT)?;
    Ok((usage, picture::hits(&pixmap, size).ok_or("surf has not drawn")?))
}

fn text(scene: &Scene, size: u32, pixmap: &Path) -> Option<String> {
    let camera = scene.camera();
    let distance = scene.eye.length();
    let scale = distance * (FIELD_OF_VIEW / 2.0).to_radians().tan() / HALF_WIDTH;
    let axes = [("qx", DVec3::X), ("qy", DVec3::Y), ("qz", DVec3::Z)];
    let definitions: String = axes
        .iter()
        .map(|(name, axis)| {
            let along = |v: DVec3| decimal(scale * v.dot(*axis));
            let (u, v, w) = (along(camera.right), along(camera.up), along(-camera.forward));
            format!("poly {name} = {u}*x + {v}*y + {w}*z;\n")
        })
        .collect();
    let colours: String = ["surface", "inside", "background"]
        .iter()
        .flat_map(|what| ["red", "green", "blue"].map(|channel| (what, channel)))
        .map(|(what, channel)| {
            let value = if *what == "background" && channel != "blue" { 0 } else { 255 };
            format!("{what}_{channel} = {value};\n")
        })
        .collect();
    Some(format!(
        "width = {size}; height = {size};\n{definitions}surface = {};\n\
         perspective = central; spec_z = {}; clip = sphere; radius = {};\n\
         root_finder = bezier_all_roots; epsilon = 0.00001; iterations = 100;\n\
         illumination = ambient_light + diffuse_light; ambient = 15; diffuse = 85;\n{colours}\
         light1_x = 400; light1_y = 500; light1_z = 1000; light1_vol = 100;\n\
         clear_screen; draw_surface;\nfilename = \"{}\"; color_file_format = ppm; save_color_image;\n",
        translate(&scene.formula, &Notation)?,
        decimal(distance / scale),
        decimal(scene.clip.radius() / scale),
        pixmap.display()
    ))
}

/// surf's numbers have no exponent.
fn decimal(value: f64) -> String {
    format!("({value:.17})")
}

/// Polynomials as surf writes them, in the turned coordinates.
struct Notation;

impl Algebra for Notation {
    type Value = String;

    fn number(&self, value: f64) -> String {
        decimal(value)
    }

    fn coordinate(&self, axis: usize) -> String {
        ["qx", "qy", "qz"][axis].into()
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
        (exponent.fract() == 0.0).then(|| format!("({a}^{exponent})"))
    }

    fn call(&self, _name: &str, _arguments: Vec<String>) -> Option<String> {
        None
    }
}
