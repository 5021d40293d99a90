//! What was typed: the only place that knows clap.
//!
//! In: the process's arguments. Out: plain values, each checked on its own; or the message and exit status that the
//! command line deserves. The doc comments are the help.

use crate::film::Size;
use crate::num::rational::Rational;
use crate::render::Mode;
use crate::session::plan::LATER_MODES;
use clap::{Args, Parser, ValueEnum};
use std::ffi::{OsStr, OsString};
use std::path::PathBuf;

/// The most threads that are started, whatever is asked for.
pub const MAX_THREADS: usize = 1024;

/// The most samples a pixel.
const MAX_SAMPLES: u32 = 65_536;

const COMMANDS: &str = "\
Commands (the first argument):
  check PROGRAM...   read programs, print notes and errors, draw nothing
  eval PROGRAM...    print f and its gradient at a point, or an enclosure of f over a box

Programs:
  implicit 'x^2 + y^2 + z^2 = 1' -o sphere.png
  implicit 'z = sin(x)*cos(y)' --box -6,6,-6,6,-2,2 -o waves.png
  implicit scene.imp --size 1600x1200 -o scene.png";

/// Which programs, and how to read them: the same in every command.
#[derive(Args, Debug)]
pub struct ProgramArgs {
    /// A program: its text, or a file that ends in .imp, or - for standard input; several are joined
    #[arg(value_name = "PROGRAM", required = true)]
    pub programs: Vec<OsString>,
    /// A parameter's value; repeatable
    #[arg(long, value_name = "NAME=VALUE", value_parser = setting, allow_hyphen_values = true)]
    pub set: Vec<(String, Rational)>,
    /// No progress, no notes
    #[arg(long)]
    pub quiet: bool,
    /// Notes are errors
    #[arg(long)]
    pub strict: bool,
}

/// Type an equation and see its surface, exactly.
#[derive(Parser, Debug)]
#[command(name = "implicit", version, after_help = COMMANDS, max_term_width = 100)]
#[command(override_usage = "implicit [OPTIONS] PROGRAM...\n       implicit COMMAND ...")]
pub struct RenderArgs {
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
    /// The picture, by its ending: png or exr (linear light); - is PNG on standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Width and height in pixels [default: 800x600]
    #[arg(short, long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Where the eye is [default: found]
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true)]
    pub eye: Option<[f64; 3]>,
    /// Where it looks [default: the middle of what there is to see]
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true)]
    pub look_at: Option<[f64; 3]>,
    /// Vertical field of view in degrees [default: 40]
    #[arg(long, value_name = "DEG", value_parser = field_of_view)]
    pub fov: Option<f64>,
    /// The eye by azimuth, elevation (degrees) and distance around where it looks
    #[arg(long, value_name = "AZ,EL[,DIST]", value_parser = orbit, allow_hyphen_values = true, conflicts_with = "eye")]
    pub orbit: Option<OrbitArg>,
    /// Parallel rays, the picture HEIGHT world units high
    #[arg(long, value_name = "HEIGHT", value_parser = positive)]
    pub ortho: Option<f64>,
    /// Show only what is in this box
    #[arg(long = "box", value_name = "X0,X1,Y0,Y1,Z0,Z1", value_parser = box_bounds, allow_hyphen_values = true)]
    pub clip_box: Option<BoxArg>,
    /// Show only what is in this ball
    #[arg(long, value_name = "X,Y,Z,R", value_parser = ball, allow_hyphen_values = true)]
    pub ball: Option<BallArg>,
    /// What the colours say
    #[arg(long, value_name = "MODE", value_parser = mode)]
    pub mode: Option<Mode>,
    /// How roots are found: faithful never misses one, march is the textbook method
    #[arg(long, value_enum, default_value = "faithful")]
    pub method: MethodArg,
    /// Step of --method march [default: the region's diameter / 256]
    #[arg(long, value_name = "H", value_parser = positive)]
    pub step: Option<f64>,
    /// The most samples a pixel, taken where neighbours differ [default: by mode]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_SAMPLES)))]
    pub samples: Option<u32>,
    /// The most scattering events of a path [default: 8]
    #[arg(long, value_name = "N")]
    pub bounces: Option<u32>,
    /// Seed of random numbers [default: 0]
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Distances to the first hit, as an EXR of one channel Z
    #[arg(long, value_name = "FILE.exr")]
    pub depth: Option<PathBuf>,
    /// Normals at the first hit, as an EXR of channels X Y Z
    #[arg(long, value_name = "FILE.exr")]
    pub normals: Option<PathBuf>,
    /// Print what is proven and what it took
    #[arg(long)]
    pub stats: bool,
    /// The same for programs
    #[arg(long, value_name = "FILE")]
    pub stats_json: Option<PathBuf>,
    /// Threads [default: all cores]
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
    /// Stop after S seconds with the last whole pass
    #[arg(long, value_name = "S", value_parser = positive, hide = true)]
    pub time_budget: Option<f64>,
    /// Replace the file after every pass
    #[arg(long, hide = true)]
    pub progressive: bool,
}

/// Read programs, print notes and errors, draw nothing.
#[derive(Parser, Debug)]
#[command(name = "implicit check", max_term_width = 100)]
pub struct CheckArgs {
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
    /// Check that this definition exists
    #[arg(long, value_name = "NAME")]
    pub of: Option<String>,
}

/// Print f and its gradient at a point, or an enclosure of f over a box; one line a surface.
#[derive(Parser, Debug)]
#[command(name = "implicit eval", max_term_width = 100)]
#[command(group = clap::ArgGroup::new("where").required(true).args(["at", "over"]))]
pub struct EvalArgs {
    /// The programs.
    #[command(flatten)]
    pub program: ProgramArgs,
    /// The point, or - for one a line on standard input
    #[arg(long, value_name = "X,Y,Z", value_parser = on_line::<3>, allow_hyphen_values = true)]
    pub at: Option<Place<3>>,
    /// The box, or - for one a line on standard input; inf is allowed
    #[arg(long, value_name = "X0,X1,Y0,Y1,Z0,Z1", value_parser = on_line::<6>, allow_hyphen_values = true)]
    pub over: Option<Place<6>>,
    /// This definition instead of the surfaces
    #[arg(long, value_name = "NAME")]
    pub of: Option<String>,
    /// One JSON object a line
    #[arg(long)]
    pub json: bool,
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
    if let Some(text) = super::dashes::complaint(&T::command(), argv) {
        return Err(Refusal { text, is_answer: false });
    }
    T::try_parse_from(argv)
        .map_err(|error| Refusal { text: error.render().to_string(), is_answer: !error.use_stderr() })
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

fn number(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| format!("'{}' is no number", text.trim().escape_debug()))
}

fn finite(text: &str) -> Result<f64, String> {
    match number(text)? {
        value if value.is_finite() => Ok(value),
        _ => Err(format!("'{}' is not finite", text.trim().escape_debug())),
    }
}

/// N numbers with commas or blanks between them.
///
/// # Errors
/// What is wrong with the text.
pub fn listed<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let parts: Vec<&str> = match text.contains(',') {
        true => text.split(',').collect(),
        false => text.split_whitespace().collect(),
    };
    let values = parts.iter().map(|part| number(part)).collect::<Result<Vec<f64>, String>>()?;
    values
        .try_into()
        .map_err(|v: Vec<f64>| format!("{N} numbers with commas between them are needed, here are {}", v.len()))
}

fn numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let values = listed::<N>(text)?;
    for part in text.split(',') {
        finite(part)?;
    }
    Ok(values)
}

fn on_line<const N: usize>(text: &str) -> Result<Place<N>, String> {
    if text == "-" { Ok(Place::Lines) } else { listed(text).map(Place::Here) }
}

fn positive(text: &str) -> Result<f64, String> {
    match finite(text)? {
        value if value > 0.0 => Ok(value),
        _ => Err("it must be more than 0".into()),
    }
}

fn field_of_view(text: &str) -> Result<f64, String> {
    match finite(text)? {
        value if value > 0.0 && value < 180.0 => Ok(value),
        _ => Err("it must be more than 0 and less than 180 degrees".into()),
    }
}

fn threads(text: &str) -> Result<usize, String> {
    let digits = text.trim();
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(format!("'{}' is no whole number", digits.escape_debug()));
    }
    Ok(digits.parse().unwrap_or(MAX_THREADS).clamp(1, MAX_THREADS))
}

fn orbit(text: &str) -> Result<OrbitArg, String> {
    if let Ok([azimuth, elevation]) = numbers::<2>(text) {
        return Ok(OrbitArg { azimuth, elevation, distance: None });
    }
    let [azimuth, elevation, distance] = numbers::<3>(text)
        .map_err(|_| "azimuth and elevation, and a distance if you like, are needed: 30,20,5".to_owned())?;
    if distance <= 0.0 {
        return Err("the distance must be more than 0".into());
    }
    Ok(OrbitArg { azimuth, elevation, distance: Some(distance) })
}

fn box_bounds(text: &str) -> Result<BoxArg, String> {
    let [x0, x1, y0, y1, z0, z1] = numbers::<6>(text)?;
    for (name, low, high) in [("x", x0, x1), ("y", y0, y1), ("z", z0, z1)] {
        if low >= high {
            return Err(format!("in {name} the lower end {low} is not below the upper end {high}"));
        }
    }
    Ok(BoxArg { min: [x0, y0, z0], max: [x1, y1, z1] })
}

fn ball(text: &str) -> Result<BallArg, String> {
    let [x, y, z, radius] = numbers::<4>(text)?;
    if radius <= 0.0 {
        return Err("the radius must be more than 0".into());
    }
    Ok(BallArg { center: [x, y, z], radius })
}

fn setting(text: &str) -> Result<(String, Rational), String> {
    let (name, value) = text.split_once('=').ok_or("write NAME=VALUE, as in a=0.7")?;
    let negative = value.trim().strip_prefix('-');
    let digits = negative.unwrap_or(value).trim();
    let rational = Rational::from_decimal(digits).ok_or_else(|| format!("'{}' is no number", value.escape_debug()))?;
    Ok((name.trim().to_owned(), if negative.is_some() { rational.negated() } else { rational }))
}

/// The mode of a name.
///
/// # Errors
/// That there is none, with those there are.
pub fn mode(name: &str) -> Result<Mode, String> {
    if let Some(mode) = Mode::from_name(name) {
        return Ok(mode);
    }
    let names: Vec<&str> = Mode::ALL.iter().map(|(name, _)| *name).collect();
    let known = names.join(", ");
    match LATER_MODES.contains(&name) {
        true => Err(format!("the mode '{name}' is not built yet; there are {known}")),
        false => Err(format!("there is no mode '{}'; there are {known}", name.escape_debug())),
    }
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
    }

    #[test]
    fn values_are_read_and_refused() {
        assert_eq!(numbers::<3>("-1, 2,3e-1"), Ok([-1.0, 2.0, 0.3]));
        assert!(numbers::<3>("1,2").is_err() && numbers::<3>("1,2,inf").is_err() && numbers::<3>("a,b,c").is_err());
        assert_eq!(listed::<3>("1 2\t3"), Ok([1.0, 2.0, 3.0]));
        assert_eq!(threads("0"), Ok(1));
        assert_eq!(threads("99999999999999999999999"), Ok(1024));
        assert!(threads("-1").is_err() && threads("two").is_err());
        assert_eq!(orbit("10,-20"), Ok(OrbitArg { azimuth: 10.0, elevation: -20.0, distance: None }));
        assert!(orbit("10,20,-3").is_err() && orbit("10").is_err());
        assert!(box_bounds("1,0,0,1,0,1").unwrap_err().contains("in x"));
        assert!(ball("0,0,0,0").is_err());
        let half = Rational::from_fraction(-1, 2).unwrap();
        assert_eq!(setting("a=-0.5"), Ok(("a".into(), half)));
        assert!(setting("a").is_err() && setting("a=b").is_err());
        assert!(mode("path").unwrap_err().contains("not built yet"));
    }
}
