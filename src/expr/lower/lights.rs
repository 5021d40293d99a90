//! The statements that light a scene: `light`, `sun`, `sky`.
//!
//! In: their entries. Out: plain numbers in the units they were written in: watts, W/m², W/(m² sr), degrees. What they mean as
//! light is the scene's business.

use super::paints::{Amount, Color};
use super::{Lowerer, Reporting};
use crate::diag::{Diagnostic, Span};
use crate::syntax::ast::Attribute;

/// Most lights of a program: each is looked at when light is gathered, and picked from a table that is built before.
pub const MAX_LIGHTS: usize = 100_000;

/// A light that is no surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// `light { … }`: a point, or a ball if its radius is more than 0.
    Lamp {
        /// Its middle.
        at: [f64; 3],
        /// Its power in watts, >= 0.
        power: f64,
        /// What the power is multiplied by.
        color: Color,
        /// Its radius, >= 0.
        radius: f64,
    },
    /// `sun { … }`.
    Sun {
        /// Where it is seen; not 0, of any length.
        from: [f64; 3],
        /// Irradiance of what faces it in W/m², >= 0.
        irradiance: f64,
        /// What the irradiance is multiplied by.
        color: Color,
        /// The angle under which it is seen, in degrees, of 0..180.
        angle: f64,
    },
}

/// `sky { … }` and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sky {
    /// What it says.
    pub kind: SkyKind,
    /// The block.
    pub span: Span,
}

/// The three forms of a sky.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SkyKind {
    /// The same radiance, >= 0, from everywhere.
    Uniform {
        /// The radiance.
        radiance: f64,
        /// What it is multiplied by.
        color: Color,
    },
    /// Radiances by height.
    Gradient {
        /// Straight above.
        top: Color,
        /// At the horizon.
        horizon: Color,
        /// From below.
        ground: Color,
    },
    /// Clear daylight.
    Daylight {
        /// Where the sun is; not below the horizon, of any length.
        sun: [f64; 3],
        /// How hazy the air is.
        turbidity: f64,
    },
}

/// Turbidities for which the sky's formulas were fitted (Preetham, Shirley, Smits 1999, section 3).
pub const TURBIDITIES: (f64, f64) = (2.0, 10.0);

/// Of a clear day, where none is given.
const DEFAULT_TURBIDITY: f64 = 3.0;

const OF_LAMP: [&str; 4] = ["at", "power", "color", "radius"];
const OF_SUN: [&str; 4] = ["from", "irradiance", "color", "angle"];
const OF_SKY: [&str; 7] = ["radiance", "color", "top", "horizon", "ground", "sun", "turbidity"];

/// The keys of each form of a sky.
const UNIFORM: [&str; 2] = ["radiance", "color"];
const GRADIENT: [&str; 3] = ["top", "horizon", "ground"];
const DAYLIGHT: [&str; 2] = ["sun", "turbidity"];

/// A sky in words.
const FORMS: &str =
    "write `sky { radiance: 1 }`, `sky { top: white, horizon: skyblue, ground: gray }` or `sky { sun: (1, -1, 2) }`";

const WHITE: Color = Color::Linear([1.0; 3]);

impl<'a> Lowerer<'a> {
    /// `light { … }`
    pub(super) fn lamp(&mut self, attributes: &'a [Attribute], span: Span) {
        self.check_keys(attributes, "a light", &OF_LAMP);
        let at = self.entry(attributes, "at").map(|attribute| self.point(attribute));
        let power =
            self.entry(attributes, "power").map(|attribute| self.not_negative(attribute, "a power in watts", "60"));
        let color = self.light_color(attributes);
        let radius = self.entry(attributes, "radius").map(|attribute| self.not_negative(attribute, "a length", "0.4"));
        let at = self.required(at, "a light", "at: (4, -3, 5)", span);
        let power = self.required(power, "a light", "power: 60", span);
        let (Ok(at), Ok(power), Ok(color), Ok(radius)) = (at, power, color, radius.unwrap_or(Ok(0.0))) else { return };
        // The radiance of a ball is P/(4π²r²).
        if radius > 0.0 && !(power.max(1.0) / (radius * radius)).is_finite() {
            let error = Diagnostic::error(span, "this light is too small to be computed with");
            self.report(error.help("`radius: 0` is a point"));
            return;
        }
        self.add_light(Light::Lamp { at, power, color, radius }, span);
    }

    /// `sun { … }`
    pub(super) fn sun(&mut self, attributes: &'a [Attribute], span: Span) {
        self.check_keys(attributes, "a sun", &OF_SUN);
        let from = self.entry(attributes, "from").map(|attribute| self.direction(attribute));
        let irradiance = self
            .entry(attributes, "irradiance")
            .map(|attribute| self.not_negative(attribute, "an irradiance in W/m^2", "3"));
        let color = self.light_color(attributes);
        let angle = self.entry(attributes, "angle").map(|attribute| {
            let is_allowed = |angle: f64| (0.0..180.0).contains(&angle);
            self.number_that(attribute, is_allowed, "an angle in degrees, 0 or more and less than 180", "0.53")
        });
        let from = self.required(from, "a sun", "from: (1, -1, 2)", span);
        let irradiance = self.required(irradiance, "a sun", "irradiance: 3", span);
        let (Ok(from), Ok(irradiance), Ok(color), Ok(angle)) = (from, irradiance, color, angle.unwrap_or(Ok(0.0)))
        else {
            return;
        };
        // The radiance of a disc is E/(π sin²(angle/2)), and one radian has less than 60 degrees.
        if angle > 0.0 && !(irradiance.max(1.0) * 3600.0 / (angle * angle)).is_finite() {
            let error = Diagnostic::error(span, "this sun is too small to be computed with");
            self.report(error.help("`angle: 0` has parallel rays"));
            return;
        }
        self.add_light(Light::Sun { from, irradiance, color, angle }, span);
    }

    fn add_light(&mut self, light: Light, span: Span) {
        self.out.lights.push(light);
        if self.out.lights.len() == MAX_LIGHTS + 1 {
            let error = Diagnostic::error(span, format!("a program has at most {MAX_LIGHTS} lights"));
            self.report(error.help("a glowing surface is one light however large it is"));
        }
    }

    /// `sky { … }`
    pub(super) fn sky(&mut self, attributes: &'a [Attribute], span: Span) {
        if let Some(first) = self.first_sky {
            let error = Diagnostic::error(span, "a program has one sky").also(first, "the first");
            self.report(error.help("leave one of them out"));
            return;
        }
        self.first_sky = Some(span);
        self.check_keys(attributes, "a sky", &OF_SKY);
        let has = |keys: &[&str]| attributes.iter().any(|attribute| keys.contains(&attribute.key.text.as_str()));
        let kind = match (has(&UNIFORM), has(&GRADIENT), has(&DAYLIGHT)) {
            (true, false, false) => self.uniform(attributes, span),
            (false, true, false) => self.gradient(attributes, span),
            (false, false, true) => self.daylight(attributes, span),
            (false, false, false) => {
                self.report(Diagnostic::error(span, "this sky says nothing").help(FORMS));
                return;
            }
            _ => {
                self.report(Diagnostic::error(span, "these entries belong to different kinds of skies").help(FORMS));
                return;
            }
        };
        if let Ok(kind) = kind {
            self.out.sky = Some(Sky { kind, span });
        }
    }

    fn uniform(&mut self, attributes: &'a [Attribute], span: Span) -> Reporting<SkyKind> {
        let radiance = self
            .entry(attributes, "radiance")
            .map(|attribute| self.not_negative(attribute, "a radiance in W/(m^2 sr)", "1"));
        let color = self.light_color(attributes);
        let radiance = self.required(radiance, "a sky with a `color`", "radiance: 1", span)?;
        Ok(SkyKind::Uniform { radiance, color: color? })
    }

    fn gradient(&mut self, attributes: &'a [Attribute], span: Span) -> Reporting<SkyKind> {
        let [top, horizon, ground] = GRADIENT.map(|key| {
            let color = self.entry(attributes, key).map(|attribute| self.color_or_grey(attribute, Amount::Light));
            self.required(color, "a sky of three colours", &format!("{key}: rgb(0.3, 0.4, 0.6)"), span)
        });
        Ok(SkyKind::Gradient { top: top?, horizon: horizon?, ground: ground? })
    }

    fn daylight(&mut self, attributes: &'a [Attribute], span: Span) -> Reporting<SkyKind> {
        let sun = self.entry(attributes, "sun").map(|attribute| {
            let sun = self.direction(attribute)?;
            if sun[2] < 0.0 {
                return self.wrong_value(attribute, "a direction that is not below the horizon", "(1, -1, 2)");
            }
            Ok(sun)
        });
        let turbidity = self.entry(attributes, "turbidity").map(|attribute| {
            let (least, most) = TURBIDITIES;
            let wanted = format!("a number from {least} (very clear) to {most} (hazy)");
            self.number_that(attribute, |turbidity| (least..=most).contains(&turbidity), &wanted, "3")
        });
        let sun = self.required(sun, "a sky with a `turbidity`", "sun: (1, -1, 2)", span)?;
        Ok(SkyKind::Daylight { sun, turbidity: turbidity.unwrap_or(Ok(DEFAULT_TURBIDITY))? })
    }

    /// What light is multiplied by.
    fn light_color(&mut self, attributes: &'a [Attribute]) -> Reporting<Color> {
        let color = self.entry(attributes, "color").map(|attribute| self.color(attribute, Amount::Light));
        color.unwrap_or(Ok(WHITE))
    }

    /// The value, or an error that says which entry is missing.
    fn required<T>(&mut self, value: Option<Reporting<T>>, owner: &str, example: &str, span: Span) -> Reporting<T> {
        match value {
            Some(value) => value,
            None => {
                let key = example.split(':').next().unwrap_or_default();
                let error = Diagnostic::error(span, format!("{owner} has no `{key}`"));
                Err(self.report(error.help(format!("write for example `{example}` into it"))))
            }
        }
    }
}
