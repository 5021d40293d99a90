//! Colours and other values that may change from point to point of a surface.
//!
//! In: points. Out: three numbers at each: a tree of colours over formulas, which run 64 points at once.

use super::colour::linear_from_srgb;
use super::palette::Palette;
use crate::closure::Kernel;
use crate::expr::lower::{parts_of_lightness, parts_of_value};
use crate::num::func;
use crate::num::lanes::Lanes;
use crate::num::level::Portable;
use glam::DVec3;
use std::fmt;
use std::sync::Arc;

/// How many points are computed at once.
const POINTS: usize = 64;

/// The share of light that a contour line takes.
const LINE_DARKNESS: f64 = 0.88;

/// Within this share of half its width, to both sides of its edge, a line fades.
const LINE_FADE: f64 = 0.25;

/// A product of curvature and square of the scene's radius at which the colour of curvature is full.
const FULL_CURVATURE: f64 = 30.0;

/// Three numbers at every point.
#[derive(Clone, Debug)]
pub enum Texture {
    /// The same everywhere.
    Constant(DVec3),
    /// By formulas.
    Varying(Arc<Varying>),
}

/// Values by formulas.
pub struct Varying {
    /// What the formulas give, in their order.
    pub kernel: Kernel<Lanes<POINTS>>,
    /// What is made of it.
    pub shade: Shade,
    /// The most that each part may be; what is less than 0 becomes 0.
    pub most: f64,
}

/// A colour, made of the formulas' values, which are known by their numbers.
#[derive(Clone, Debug)]
pub enum Shade {
    /// The same everywhere.
    Plain(DVec3),
    /// Linear red, green, blue.
    Rgb([usize; 3]),
    /// Hue in degrees, saturation, lightness.
    Hsl([usize; 3]),
    /// Hue in degrees, saturation, value.
    Hsv([usize; 3]),
    /// The colour of a map at this place.
    Palette(Palette, usize),
    /// The first where the value is 0, the second where it is 1, in between a mixture.
    Mix(Box<Shade>, Box<Shade>, usize),
    /// A colour under contour lines.
    Lined(Box<Shade>, Lines),
    /// A Gauss curvature, and what it is multiplied by: the map's middle where it is 0, its first colour where it is great.
    Curvature(Palette, usize, f64),
}

/// Contour lines of a formula.
#[derive(Clone, Copy, Debug)]
pub struct Lines {
    /// The formula's value.
    pub value: usize,
    /// How fast it changes along the surface.
    pub slope: usize,
    /// From line to line.
    pub step: f64,
    /// How wide a line is on the surface.
    pub width: f64,
}

impl fmt::Debug for Varying {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} of {} steps", self.shade, self.kernel.len())
    }
}

impl Texture {
    /// The value, if it is the same everywhere.
    pub fn constant(&self) -> Option<DVec3> {
        match self {
            Texture::Constant(value) => Some(*value),
            Texture::Varying(_) => None,
        }
    }

    /// The values at these points of the surface; `out` is replaced. What has no value is 0.
    pub fn values(&self, points: &[DVec3], out: &mut Vec<DVec3>) {
        out.clear();
        match self {
            Texture::Constant(value) => out.resize(points.len(), *value),
            Texture::Varying(varying) => varying.values(points, out),
        }
    }
}

impl Varying {
    fn values(&self, points: &[DVec3], out: &mut Vec<DVec3>) {
        let mut registers = self.kernel.registers();
        for chunk in points.chunks(POINTS) {
            for (axis, register) in registers.iter_mut().enumerate().take(3) {
                register.0.iter_mut().zip(chunk).for_each(|(lane, point)| *lane = point[axis]);
            }
            self.kernel.run(&mut registers);
            let colour = |lane: usize| {
                let value = |k: usize| defined(self.kernel.output(&registers, k).0[lane]);
                let colour = self.shade.colour(&value);
                // A maximum with 0 is 0 of what has no value, too.
                DVec3::from_array(colour.to_array().map(|part| part.max(0.0).min(self.most)))
            };
            out.extend((0..chunk.len()).map(colour));
        }
    }
}

/// What has no value counts as 0.
fn defined(value: f64) -> f64 {
    if value.is_nan() { 0.0 } else { value }
}

impl Shade {
    /// The colour, by the values of the formulas.
    fn colour(&self, value: &dyn Fn(usize) -> f64) -> DVec3 {
        match self {
            Shade::Plain(colour) => *colour,
            Shade::Rgb(parts) => DVec3::from_array(parts.map(value)),
            Shade::Hsl([hue, saturation, lightness]) => {
                linear(parts_of_lightness(value(*hue), share(value(*saturation)), share(value(*lightness))))
            }
            Shade::Hsv([hue, saturation, most]) => {
                linear(parts_of_value(value(*hue), share(value(*saturation)), share(value(*most))))
            }
            Shade::Palette(palette, place) => palette.at(value(*place)),
            Shade::Mix(a, b, t) => match share(value(*t)) {
                0.0 => a.colour(value),
                1.0 => b.colour(value),
                t => a.colour(value).lerp(b.colour(value), t),
            },
            Shade::Lined(under, lines) => under.colour(value) * (1.0 - LINE_DARKNESS * lines.cover(value)),
            Shade::Curvature(palette, curvature, scale) => {
                let full = func::asinh::<Portable>(FULL_CURVATURE);
                let place = func::asinh::<Portable>(value(*curvature) * scale) / full;
                palette.at(0.5 - 0.5 * place.clamp(-1.0, 1.0))
            }
        }
    }
}

impl Lines {
    /// The share of light that a line takes at a point, over the most it takes.
    fn cover(&self, value: &dyn Fn(usize) -> f64) -> f64 {
        let height = value(self.value);
        let away = (height - (height / self.step).round() * self.step).abs();
        let half = self.width / 2.0 * value(self.slope);
        // Where nothing changes along the surface there is no line, or all of it would be one.
        if half > 0.0 { share((half * (1.0 + LINE_FADE) - away) / (2.0 * LINE_FADE * half)) } else { 0.0 }
    }
}

fn share(value: f64) -> f64 {
    value.clamp(0.0, 1.0)
}

fn linear(srgb: [f64; 3]) -> DVec3 {
    DVec3::from_array(srgb.map(linear_from_srgb))
}
