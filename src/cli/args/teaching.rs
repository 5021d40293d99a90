//! What was typed to the commands that teach: `explain`, `ray`, `compare`, `lesson`.
//!
//! In: their arguments. Out: plain values. Separate from the other commands, because these share how a page is wanted.

use super::{BallArg, BoxArg, COMMAND_HELP, OrbitArg, ProgramArgs};
use crate::cli::values::{ball, box_bounds, field_of_view, numbers, orbit, pixel, positive, steps, whole};
use crate::film::Size;
use crate::scene::{Orbit, View};
use crate::session::Wishes;
use crate::surface::Shape;
use crate::teach::lessons::LESSONS;
use crate::teach::texts::{LANGUAGES, Texts};
use clap::{Args, Parser, ValueEnum, ValueHint};
use glam::DVec3;
use std::path::PathBuf;

/// In which form a page is wanted.
#[derive(Args, Clone, Debug, Default)]
pub struct PageArgs {
    /// As a LaTeX document
    #[arg(long, group = "form")]
    pub latex: bool,
    /// In Markdown
    #[arg(long, group = "form")]
    pub markdown: bool,
    /// As one HTML file that needs no other
    #[arg(long, group = "form")]
    pub html: bool,
    /// The figure alone, as SVG
    #[arg(long, group = "form")]
    pub svg: bool,
    /// One JSON object
    #[arg(long, group = "form")]
    pub json: bool,
    /// To this file instead of standard output
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// en or sl
    #[arg(long, value_name = "CODE", default_value = "en", value_parser = language)]
    pub language: String,
}

impl PageArgs {
    /// The sentences of the language that is wanted.
    pub fn texts(&self) -> Texts {
        Texts::of(&self.language).unwrap_or_else(Texts::english)
    }
}

fn language(code: &str) -> Result<String, String> {
    let codes: Vec<&str> = LANGUAGES.iter().map(|(code, _)| *code).collect();
    match codes.contains(&code) {
        true => Ok(code.to_owned()),
        false => Err(format!("there are texts in {}", codes.join(", "))),
    }
}

/// Explain a surface: how it was read, what it is, its derivatives by rule, its graph.
#[derive(Parser, Debug)]
#[command(name = "implicit explain", bin_name = "implicit explain", disable_help_flag = true, help_template = COMMAND_HELP, term_width = 80)]
#[command(
    after_help = "  implicit explain 'z = sin x cos y'\n  implicit explain 'x^2 + 4y^2 = z^2 + 1' --html -o hyperboloid.html"
)]
pub struct ExplainArgs {
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
    /// This definition instead of the surfaces
    #[arg(long, value_name = "NAME")]
    pub of: Option<String>,
    /// The page.
    #[command(flatten)]
    pub page: PageArgs,
}

/// From where a scene is seen, and which part of it: as for drawing.
#[derive(Args, Clone, Debug)]
pub struct SceneArgs {
    /// Width and height in pixels
    #[arg(short, long, value_name = "WxH", allow_hyphen_values = true)]
    pub size: Option<Size>,
    /// Where the eye is
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true)]
    pub eye: Option<[f64; 3]>,
    /// Where it looks
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true)]
    pub look_at: Option<[f64; 3]>,
    /// Vertical field of view in degrees
    #[arg(long, value_name = "DEG", value_parser = field_of_view, allow_hyphen_values = true)]
    pub fov: Option<f64>,
    /// Eye by azimuth, elevation, distance
    #[arg(long, value_name = "AZ,EL[,DIST]", value_parser = orbit, allow_hyphen_values = true, conflicts_with = "eye")]
    pub orbit: Option<OrbitArg>,
    /// Only what is in X0,X1,Y0,Y1,Z0,Z1
    #[arg(long = "box", value_name = "BOX", value_parser = box_bounds, allow_hyphen_values = true)]
    pub clip_box: Option<BoxArg>,
    /// Only what is in a ball
    #[arg(long, value_name = "X,Y,Z,R", value_parser = ball, allow_hyphen_values = true)]
    pub ball: Option<BallArg>,
}

impl SceneArgs {
    /// The same as wishes.
    pub fn wishes(&self) -> Wishes {
        let in_box = self.clip_box.map(|b| Shape::Box { min: b.min.into(), max: b.max.into() });
        let in_ball = self.ball.map(|b| Shape::Ball { center: b.center.into(), radius: b.radius });
        let orbit = self.orbit.map(|o| Orbit { azimuth: o.azimuth, elevation: o.elevation, distance: o.distance });
        let (eye, look_at) = (self.eye.map(DVec3::from), self.look_at.map(DVec3::from));
        Wishes {
            size: self.size,
            view: View { eye, orbit, look_at, fov: self.fov, parallel_height: None },
            clip: in_box.into_iter().chain(in_ball).collect(),
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            simd: crate::cli::render::simd(),
            ..Wishes::default()
        }
    }
}

/// Tell the story of one ray: g(t), samples, Newton, what intervals prove, what light does at the hit.
#[derive(Parser, Debug)]
#[command(name = "implicit ray", bin_name = "implicit ray", disable_help_flag = true, help_template = COMMAND_HELP, term_width = 80)]
#[command(group = clap::ArgGroup::new("which").required(true).args(["pixel", "from"]))]
#[command(
    after_help = "  implicit ray '(x^2+y^2+z^2-1)^2' --from 0,0,3 --direction 0,0,-1 --step 0.13\n  implicit ray 'z = tan x' --pixel 400,300 --html -o ray.html"
)]
pub struct RayArgs {
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
    /// The ray through this pixel's centre, from the left and the top, from 0
    #[arg(long, value_name = "I,J", value_parser = pixel)]
    pub pixel: Option<[u32; 2]>,
    /// Where the ray starts
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true, requires = "direction")]
    pub from: Option<[f64; 3]>,
    /// Where it goes; t counts lengths of this
    #[arg(long, value_name = "A,B,C", value_parser = numbers::<3>, allow_hyphen_values = true, requires = "from")]
    pub direction: Option<[f64; 3]>,
    /// The march's step in t (a 32nd of what is looked at)
    #[arg(long, value_name = "H", value_parser = positive, allow_hyphen_values = true)]
    pub step: Option<f64>,
    /// Index of refraction behind the surface
    #[arg(long, value_name = "N", value_parser = positive, default_value = "1.5", allow_hyphen_values = true)]
    pub ior: f64,
    /// The scene.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The page.
    #[command(flatten)]
    pub page: PageArgs,
}

/// Compare steps of the textbook's method with the faithful one; or numbers of samples, of objects.
#[derive(Parser, Debug)]
#[command(name = "implicit compare", bin_name = "implicit compare", disable_help_flag = true, help_template = COMMAND_HELP, term_width = 80)]
#[command(
    after_help = "  implicit compare 'z = sin x cos y' --step 0.5,0.1,0.02 -o sheet.png\n\nThe sheet has the pictures above, the differences below: red is missed, blue is not there, yellow lies elsewhere."
)]
pub struct CompareArgs {
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
    /// Steps with commas between them (the region's diameter / 8, 32, 256)
    #[arg(long, value_name = "H,H,...", value_parser = steps, allow_hyphen_values = true, conflicts_with = "vary")]
    pub step: Option<Steps>,
    /// samples, objects or bounces instead of steps
    #[arg(long, value_enum, value_name = "WHAT", hide_possible_values = true)]
    pub vary: Option<VaryArg>,
    /// The scene.
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The page; -o FILE.png is the sheet alone.
    #[command(flatten)]
    pub page: PageArgs,
}

/// `--step` of `compare`.
#[derive(Clone, Debug, PartialEq)]
pub struct Steps(pub Vec<f64>);

/// `--vary`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum VaryArg {
    /// The number of scattering events of a path.
    Bounces,
    /// The number of samples a pixel.
    Samples,
    /// The number of surfaces.
    Objects,
}

/// Show a lesson, or all of them as pages; without a number, which there are.
#[derive(Parser, Debug)]
#[command(name = "implicit lesson", bin_name = "implicit lesson", help_template = COMMAND_HELP, term_width = 80)]
#[command(after_help = "  implicit lesson 4\n  implicit lesson --html pages --language sl")]
pub struct LessonArgs {
    /// Its number
    #[arg(value_name = "N", value_parser = whole::<1, { LESSONS.len() as u64 }>)]
    pub number: Option<u64>,
    /// Write HTML pages to this folder, which is made if it is not there
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub html: Option<PathBuf>,
    /// en or sl
    #[arg(long, value_name = "CODE", default_value = "en", value_parser = language)]
    pub language: String,
}
