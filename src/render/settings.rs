//! What to draw, and how well.
//!
//! In: words from a command line or a program. Out: plain settings.

use super::filter::Filter;
use super::tiles::Drawing;
use crate::film::print::gain;
use crate::film::{Print, Size, Tone};
use glam::DVec3;

/// What the colour of a pixel says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mode {
    /// One look that flatters any surface.
    #[default]
    Studio,
    /// The cosine of the angle between the normal and the direction to the light.
    Cosine,
    /// The cosine of the angle between the reflected ray and the direction to the light.
    Mirror,
    /// The normal, (n + 1)/2 as red, green, blue.
    Normal,
    /// The distance: near is light.
    Depth,
    /// How many enclosures the ray took.
    Cost,
    /// What is proven of the pixel.
    Proof,
    /// Gauss curvature.
    Curvature,
    /// Shadows, mirrored and refracted rays.
    Whitted,
    /// The angle at which a ray is mirrored.
    Angle,
    /// What a ray ends on where all surfaces are mirrors.
    End,
    /// How often it is mirrored.
    Bounces,
    /// Transport of light, by paths from the camera.
    Path,
    /// The same by paths from the lights.
    Light,
    /// The same by both.
    Bidirectional,
}

impl Mode {
    /// All modes with the words that name them.
    pub const ALL: [(&'static str, Mode); 15] = [
        ("studio", Mode::Studio),
        ("cosine", Mode::Cosine),
        ("mirror", Mode::Mirror),
        ("normal", Mode::Normal),
        ("depth", Mode::Depth),
        ("cost", Mode::Cost),
        ("proof", Mode::Proof),
        ("curvature", Mode::Curvature),
        ("whitted", Mode::Whitted),
        ("angle", Mode::Angle),
        ("end", Mode::End),
        ("bounces", Mode::Bounces),
        ("path", Mode::Path),
        ("light", Mode::Light),
        ("bidirectional", Mode::Bidirectional),
    ];

    /// The mode of a name.
    pub fn from_name(name: &str) -> Option<Mode> {
        Mode::ALL.into_iter().find(|(word, _)| *word == name).map(|(_, mode)| mode)
    }

    /// How the mode's values are shown on a screen.
    pub fn tone(self) -> Tone {
        match self {
            Mode::Studio | Mode::Whitted | Mode::Path | Mode::Light | Mode::Bidirectional => Tone::Neutral,
            Mode::Cosine | Mode::Mirror | Mode::End | Mode::Curvature => Tone::Linear,
            Mode::Normal | Mode::Depth | Mode::Cost | Mode::Proof | Mode::Angle | Mode::Bounces => Tone::Data,
        }
    }

    /// The most samples a pixel where nobody says: where colours are looked at, edges are smoothed; what one ray knows
    /// is not mixed with its neighbours.
    pub fn default_samples(self) -> u32 {
        match self {
            Mode::Studio
            | Mode::Cosine
            | Mode::Mirror
            | Mode::Normal
            | Mode::Whitted
            | Mode::Angle
            | Mode::End
            | Mode::Curvature => 16,
            Mode::Depth | Mode::Cost | Mode::Proof | Mode::Bounces => 1,
            Mode::Path | Mode::Light | Mode::Bidirectional => 64,
        }
    }

    /// Whether it shows the colours of surfaces, each ray by itself.
    pub fn shows_colours(self) -> bool {
        matches!(self, Mode::Cosine | Mode::Mirror | Mode::Curvature)
    }

    /// Whether what is behind the surfaces can be chosen.
    pub fn has_background(self) -> bool {
        matches!(self, Mode::Studio | Mode::Cosine | Mode::Mirror) || self.is_transport()
    }

    /// Whether it follows light from surface to surface, for so many bounces.
    pub fn follows_light(self) -> bool {
        self.is_transport() || matches!(self, Mode::Whitted | Mode::End | Mode::Bounces)
    }

    /// Whether its pictures are means over paths of light: every pixel has all samples.
    pub fn is_transport(self) -> bool {
        matches!(self, Mode::Path | Mode::Light | Mode::Bidirectional)
    }
}

/// The most scattering events of a path where nobody says.
pub const DEFAULT_BOUNCES: u32 = 8;

/// What to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// How many pixels.
    pub size: Size,
    /// What their colours say.
    pub mode: Mode,
    /// The most samples a pixel; 1: the ray through its centre alone.
    pub samples: u32,
    /// The most scattering events of a path, in the modes that follow light.
    pub bounces: u32,
    /// Which of many equally good sets of random numbers is used there.
    pub seed: u64,
    /// How much a place counts in a pixel.
    pub filter: Filter,
    /// How light becomes what a screen shows.
    pub tone: Tone,
    /// By how many stops light is made brighter before.
    pub exposure: f64,
    /// What is seen where nothing is hit, in the modes that shade surfaces.
    pub background: Background,
    /// How many threads draw; at least 1.
    pub threads: usize,
    /// Whether distances are kept.
    pub keep_depth: bool,
    /// Whether normals are kept.
    pub keep_normals: bool,
    /// In which passes it is drawn; the finished picture is the same.
    pub passes: Passes,
}

/// What is seen where nothing is hit, in modes `studio`, `cosine`, `mirror` and those that follow light.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Background {
    /// What the mode has.
    #[default]
    Own,
    /// This linear light of 0..=1, which no tone curve changes.
    Plain(DVec3),
    /// Nothing: the picture is clear there.
    Clear,
    /// The sky of the scene.
    Sky,
}

impl Background {
    /// Whether it is known of each pixel how much of it is covered.
    pub fn keeps_alpha(self) -> bool {
        matches!(self, Background::Plain(_) | Background::Clear)
    }
}

impl Settings {
    /// A drawing as it is to be shown.
    pub fn print<'a>(&self, drawing: &'a Drawing) -> Print<'a> {
        let behind = match self.background {
            Background::Plain(colour) => Some(colour.as_vec3().to_array()),
            Background::Own | Background::Clear | Background::Sky => None,
        };
        Print {
            picture: &drawing.picture,
            alpha: drawing.alpha.as_ref(),
            tone: self.tone,
            gain: if self.tone == Tone::Data { 1.0 } else { gain(self.exposure) },
            behind,
        }
    }
}

/// In which passes a picture is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Passes {
    /// One ray a pixel, then all samples that are still needed.
    #[default]
    Few,
    /// One ray a pixel, then samples in steps, for those who look on.
    Many,
    /// The same, but coarse squares come first, for those who cannot wait for one ray a pixel.
    CoarseFirst,
}

impl Default for Settings {
    fn default() -> Self {
        let mode = Mode::default();
        let samples = mode.default_samples();
        Settings {
            size: Size::default(),
            mode,
            samples,
            bounces: DEFAULT_BOUNCES,
            seed: 0,
            filter: Filter::default(),
            tone: mode.tone(),
            exposure: 0.0,
            background: Background::Own,
            threads: 1,
            keep_depth: false,
            keep_normals: false,
            passes: Passes::Few,
        }
    }
}
