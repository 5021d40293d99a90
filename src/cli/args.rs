//! What was typed: the only place that knows clap.
//!
//! In: the process's arguments. Out: plain values, each checked on its own; or the message and exit status that the
//! command line deserves. The doc comments are the help.

pub mod teaching;

use super::values::{
    ball, box_bounds, exposure, field_of_view, filter, mode, numbers, on_line, orbit, positive, setting, threads,
    tonemap, whole,
};
use crate::film::{Size, Tone};
use crate::num::rational::Rational;
use crate::render::filter::Filter;
use crate::render::{Background, Mode};
use crate::session::settings::read_background;
use clap::{ArgAction, Args, Parser, ValueEnum, ValueHint};
use clap_complete::Shell;
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

/// The most samples a pixel.
const MAX_SAMPLES: u64 = 65_536;

/// The most scattering events of a path: more than any path has before its light is below a byte's step.
const MAX_BOUNCES: u64 = 1 << 16;

/// Everything on one screen of 80 columns, examples first; `{options}` is clap's list.
const HELP: &str = "\
Type an equation and see its surface, exactly.

  implicit 'x^2 + y^2 + z^2 = 1' -o sphere.png
  implicit 'z = sin x cos y' --box -6,6,-6,6,-2,2 --size 1600x1200 -o waves.jpg
  implicit 'x^2 + y^2 = a^2; a = 1 in [0, 2]' 'z = 0' --set a=0.5 -o two.png

{usage-heading} implicit [OPTIONS] PROGRAM...   draw: PROGRAM is text, a file.imp, or -
       implicit check PROGRAM...       print errors and notes, draw nothing
       implicit eval PROGRAM... --at X,Y,Z | --over BOX    value or bounds of f
       implicit explain | ray | compare PROGRAM...         the mathematics of it
       implicit lesson [N]             the same in order, for a first course
       implicit import PICTURE.png     print the program that drew a picture
       implicit completions SHELL      for bash, zsh, fish, ...; man: the manual

{options}

The whole language: grammar.md. More on the options: implicit completions man";

/// What the help of a command shows.
const COMMAND_HELP: &str = "{about}\n\n{usage-heading} {usage}\n\n{all-args}{after-help}";

/// Which programs, and how to read them: the same in every command.
#[derive(Args, Debug)]
pub struct ProgramArgs {
    /// Text, a file that ends in .imp, or - for standard input
    ///
    /// Several are joined, as if they were the statements of one program. One that starts with a minus needs `--`
    /// before it.
    #[arg(value_name = "PROGRAM", required = true, value_hint = ValueHint::FilePath)]
    pub programs: Vec<OsString>,
    /// A parameter's value; repeatable
    ///
    /// A parameter is written `a = 0.5 in [0, 1]`.
    #[arg(long, value_name = "NAME=VALUE", value_parser = setting, allow_hyphen_values = true)]
    pub set: Vec<(String, Rational)>,
    /// No progress, no notes
    #[arg(long)]
    pub quiet: bool,
    /// Notes are errors
    #[arg(long)]
    pub strict: bool,
    /// This text
    #[arg(short, long, action = ArgAction::HelpShort)]
    help: Option<bool>,
}

/// Type an equation and see its surface, exactly.
#[derive(Parser, Debug)]
#[command(name = "implicit", version, disable_help_flag = true, help_template = HELP, term_width = 80)]
#[command(override_usage = "implicit [OPTIONS] PROGRAM...\n       implicit COMMAND ...")]
pub struct RenderArgs {
    /// png jpg webp tiff exr, or - for stdout (terminal)
    ///
    /// The ending says which kind of file it is: png, jpg, webp, tiff, or exr with linear light; `-` is PNG on standard
    /// output. A PNG carries the program that draws it again (`implicit import`). Without this and without
    /// `--depth`, `--normals` and `--stats-json` the picture is shown in the terminal.
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub output: Option<PathBuf>,
    /// Width and height in pixels (800x600)
    ///
    /// At most 2^26 pixels.
    #[arg(short, long, value_name = "WxH", allow_hyphen_values = true)]
    pub size: Option<Size>,
    /// Where the eye is (found)
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true)]
    pub eye: Option<[f64; 3]>,
    /// Where it looks (the middle of it all)
    ///
    /// Without it, at the middle of the clip region, given or found.
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true)]
    pub look_at: Option<[f64; 3]>,
    /// Vertical field of view in degrees (40)
    #[arg(long, value_name = "DEG", value_parser = field_of_view, allow_hyphen_values = true)]
    pub fov: Option<f64>,
    /// Eye by azimuth, elevation, distance (found)
    ///
    /// In degrees around where it looks: azimuth from x towards y, elevation upward. From above: 0,90.
    #[arg(long, value_name = "AZ,EL[,DIST]", value_parser = orbit, allow_hyphen_values = true, conflicts_with = "eye")]
    pub orbit: Option<OrbitArg>,
    /// Parallel rays, the picture so high in the world
    #[arg(long, value_name = "HEIGHT", value_parser = positive, allow_hyphen_values = true)]
    pub ortho: Option<f64>,
    /// Show only what is in X0,X1,Y0,Y1,Z0,Z1 (found)
    ///
    /// The clip region of all surfaces: it replaces the program's own. Without one the program finds what there is to
    /// see and prints what it chose.
    #[arg(long = "box", value_name = "BOX", value_parser = box_bounds, allow_hyphen_values = true)]
    pub clip_box: Option<BoxArg>,
    /// Show only what is in a ball (found)
    ///
    /// As `--box`; both together show what is in both.
    #[arg(long, value_name = "X,Y,Z,R", value_parser = ball, allow_hyphen_values = true)]
    pub ball: Option<BallArg>,
    /// studio path cosine mirror normal depth proof ...
    ///
    /// What the colours say. `studio`: a look that flatters any surface (the default). `cosine`: the cosine of the angle
    /// between normal and light; `mirror`: the same after a mirror; `angle`, `end`, `bounces`: what becomes of rays where all is
    /// a mirror. `whitted`, `path`, `light`, `bidirectional`: light, followed. `normal`, `depth`, `cost`, `proof`: what the
    /// tracer knows. `curvature`: eggs red, saddles blue.
    #[arg(long, value_name = "MODE", value_parser = mode)]
    pub mode: Option<Mode>,
    /// faithful (the default, misses no root) or march
    ///
    /// How roots are found: `faithful` proves where no root is; `march` is the textbook's method, which samples the ray.
    #[arg(long, value_enum, default_value = "faithful", hide_possible_values = true, hide_default_value = true)]
    pub method: MethodArg,
    /// Step of march (diameter / 256)
    #[arg(long, value_name = "H", value_parser = positive, allow_hyphen_values = true)]
    pub step: Option<f64>,
    /// Most samples a pixel, where it pays
    ///
    /// More than one are taken where neighbours differ. The default depends on the mode.
    #[arg(long, value_name = "N", value_parser = whole::<1, MAX_SAMPLES>, allow_hyphen_values = true)]
    pub samples: Option<u64>,
    /// Most scattering events of a path (8)
    #[arg(long, value_name = "N", value_parser = whole::<0, MAX_BOUNCES>, allow_hyphen_values = true)]
    pub bounces: Option<u64>,
    /// Seed of random numbers (0)
    #[arg(long, value_name = "N", value_parser = whole::<0, { u64::MAX }>, allow_hyphen_values = true)]
    pub seed: Option<u64>,
    /// Make light brighter by EV stops (0)
    ///
    /// Light is multiplied by 2^EV before the tone curve; EXR keeps it as it is.
    #[arg(long, value_name = "EV", value_parser = exposure, allow_hyphen_values = true)]
    pub exposure: Option<f64>,
    /// Tone curve: neutral, agx or none
    ///
    /// How light of any strength becomes what a screen can show. `neutral` (Khronos PBR Neutral) keeps hues and is the
    /// default in `studio` and where light is followed; `agx` lets bright colours fade, as film does; `none` cuts off.
    #[arg(long, value_name = "CURVE", value_parser = tonemap)]
    pub tonemap: Option<Tone>,
    /// COLOR, transparent or sky, behind it all
    ///
    /// In studio, cosine and mirror: a name, #rrggbb or rgb(1, 0.5, 0), which is shown as it is; nothing, with smooth edges, in png, webp,
    /// tiff and exr; or the program's sky.
    #[arg(long, value_name = "BEHIND", value_parser = read_background)]
    pub background: Option<Background>,
    /// Pixel filter: mitchell, gaussian or box
    ///
    /// How much a place counts in a pixel, in path, light and bidirectional.
    #[arg(long, value_name = "FILTER", value_parser = filter)]
    pub filter: Option<Filter>,
    /// Distances to the first hit, channel Z
    ///
    /// As an EXR file of one channel Z: from the eye through each pixel's centre, +inf where nothing is hit.
    #[arg(long, value_name = "FILE.exr", value_hint = ValueHint::FilePath)]
    pub depth: Option<PathBuf>,
    /// Unit normals there, channels X Y Z
    ///
    /// As an EXR file of channels X Y Z, turned to the eye; NaN where nothing is hit.
    #[arg(long, value_name = "FILE.exr", value_hint = ValueHint::FilePath)]
    pub normals: Option<PathBuf>,
    /// Say what is proven, and what it took
    #[arg(long)]
    pub stats: bool,
    /// The same for programs
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub stats_json: Option<PathBuf>,
    /// Threads (all cores)
    ///
    /// From 1 to 1024; the picture is the same for any number.
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
    /// Stop after S seconds with the last whole pass
    ///
    /// The first pass is always finished: coarse squares, or one ray a pixel if `--depth`, `--normals` or statistics are
    /// asked for.
    #[arg(long, value_name = "S", value_parser = positive, allow_hyphen_values = true)]
    pub time_budget: Option<f64>,
    /// Replace the file after every pass
    ///
    /// Coarse squares first, then one ray a pixel, then more samples where they are needed.
    #[arg(long)]
    pub progressive: bool,
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
}

/// Read programs, print notes and errors, draw nothing.
#[derive(Parser, Debug)]
#[command(name = "implicit check", bin_name = "implicit check", disable_help_flag = true, help_template = COMMAND_HELP, term_width = 80)]
pub struct CheckArgs {
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
    /// Check that this definition exists
    #[arg(long, value_name = "NAME")]
    pub of: Option<String>,
}

/// Print f and its gradient at a point, or bounds of f over a box; one line a surface.
#[derive(Parser, Debug)]
#[command(name = "implicit eval", bin_name = "implicit eval", disable_help_flag = true, help_template = COMMAND_HELP, term_width = 80)]
#[command(group = clap::ArgGroup::new("where").required(true).args(["at", "over"]))]
pub struct EvalArgs {
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
    /// The point, or - for one a line on standard input
    #[arg(long, value_name = "X,Y,Z", value_parser = on_line::<3>, allow_hyphen_values = true)]
    pub at: Option<Place<3>>,
    /// X0,X1,Y0,Y1,Z0,Z1 (inf is allowed), or - for lines of input
    #[arg(long, value_name = "BOX", value_parser = on_line::<6>, allow_hyphen_values = true)]
    pub over: Option<Place<6>>,
    /// This definition instead of the surfaces
    #[arg(long, value_name = "NAME")]
    pub of: Option<String>,
    /// One JSON object a line
    #[arg(long)]
    pub json: bool,
}

/// Print the program that draws a PNG picture again, with its camera and region.
#[derive(Parser, Debug)]
#[command(name = "implicit import", bin_name = "implicit import", help_template = COMMAND_HELP, term_width = 80)]
#[command(after_help = "  implicit import sphere.png > again.imp\n  implicit again.imp -o same.png")]
pub struct ImportArgs {
    /// A picture that this program wrote
    #[arg(value_name = "PICTURE.png", value_hint = ValueHint::FilePath)]
    pub picture: PathBuf,
}

/// Print what a shell needs to complete our options, or the manual page.
#[derive(Parser, Debug)]
#[command(name = "implicit completions", bin_name = "implicit completions", help_template = COMMAND_HELP, term_width = 80)]
#[command(after_help = "\
  bash:  implicit completions bash > ~/.local/share/bash-completion/completions/implicit
  zsh:   implicit completions zsh > _implicit     in a folder of $fpath
  fish:  implicit completions fish > ~/.config/fish/completions/implicit.fish
  man:   implicit completions man | man -l -")]
pub struct CompletionsArgs {
    /// bash, zsh, fish, elvish, powershell, or man for the manual page
    #[arg(value_name = "SHELL", value_parser = script)]
    pub script: Script,
}

/// What `completions` prints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Script {
    /// What this shell reads.
    Completions(Shell),
    /// The manual page.
    Manual,
}

fn script(name: &str) -> Result<Script, String> {
    if name == "man" {
        return Ok(Script::Manual);
    }
    let shell = Shell::from_str(name, true).map_err(|_| "there are bash, zsh, fish, elvish, powershell and man")?;
    Ok(Script::Completions(shell))
}

/// Numbers on the command line, or that they come on standard input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place<const N: usize> {
    /// These.
    Here([f64; N]),
    /// One a line.
    Lines,
}

/// `--orbit`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrbitArg {
    /// Degrees.
    pub azimuth: f64,
    /// Degrees.
    pub elevation: f64,
    /// How far, if it was said.
    pub distance: Option<f64>,
}

/// `--box`: least and greatest corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxArg {
    /// The least x, y, z.
    pub min: [f64; 3],
    /// The greatest.
    pub max: [f64; 3],
}

/// `--ball`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallArg {
    /// The centre.
    pub center: [f64; 3],
    /// The radius, > 0.
    pub radius: f64,
}

/// `--method`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum MethodArg {
    /// Never misses a root.
    Faithful,
    /// Steps, a change of sign, Newton.
    March,
}

/// What clap has to say instead of arguments.
#[derive(Debug)]
pub struct Refusal {
    /// The text.
    pub text: String,
    /// Whether it was asked for (help, version).
    pub is_answer: bool,
}

/// Reads the arguments of one command; the first of `argv` is the program's own name.
///
/// # Errors
/// The text of help and version, or what is wrong with the command line.
pub fn read<T: Parser>(argv: &[OsString]) -> Result<T, Refusal> {
    let command = T::command();
    let parsed = T::try_parse_from(argv);
    let corrected = parsed.as_ref().err().and_then(|error| super::mend::corrected(error, &command, argv));
    match corrected.or_else(|| super::dashes::complaint(&command, argv)) {
        Some(text) => Err(Refusal { text, is_answer: false }),
        None => parsed.map_err(|error| Refusal { is_answer: !error.use_stderr(), text: super::mend::plain(error) }),
    }
}

/// How an option of a command takes a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// It takes none.
    Nothing,
    /// One that does not start with a minus, `-` alone excepted.
    Value,
    /// One that may start with a minus.
    AnyValue,
}

/// What the option of this name takes, if the command knows it: `--long` or `-s`.
pub fn option_of(command: &clap::Command, name: &OsStr) -> Option<Takes> {
    let name = name.to_str()?;
    if matches!(name, "-h" | "--help" | "-V" | "--version") {
        return Some(Takes::Nothing);
    }
    let is_it = |arg: &&clap::Arg| match name.strip_prefix("--") {
        Some(long) => arg.get_long() == Some(long),
        None => name.len() == 2 && arg.get_short() == name.chars().nth(1),
    };
    let arg = command.get_arguments().find(is_it)?;
    Some(match (arg.get_action().takes_values(), arg.is_allow_hyphen_values_set()) {
        (false, _) => Takes::Nothing,
        (true, false) => Takes::Value,
        (true, true) => Takes::AnyValue,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definitions_of_all_commands_are_consistent() {
        RenderArgs::command().debug_assert();
        CheckArgs::command().debug_assert();
        EvalArgs::command().debug_assert();
        ImportArgs::command().debug_assert();
        CompletionsArgs::command().debug_assert();
        teaching::ExplainArgs::command().debug_assert();
        teaching::RayArgs::command().debug_assert();
        teaching::CompareArgs::command().debug_assert();
        teaching::LessonArgs::command().debug_assert();
    }

    #[test]
    fn the_help_fits_on_one_screen() {
        let help = RenderArgs::command().render_help().to_string();
        let widest = help.lines().map(|line| line.chars().count()).max();
        assert!(help.lines().count() <= 50 && widest <= Some(80), "{} {widest:?}\n{help}", help.lines().count());
    }
}
