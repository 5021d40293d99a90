//! The blocks of the camera and of the render settings, and which block is read where.
//!
//! In: `key: value` pairs. Out: plain numbers with their places, for the scene to read. What keys mean is the
//! scene's business; here they are known by name, and their values are worked out.

use super::clips::Clip;
use super::paints::{Amount, Color};
use super::{Lowerer, Reporting};
use crate::diag::{Diagnostic, Span};
use crate::syntax::ast::{Attribute, AttributeValue, BlockKind, Expr, ExprKind};

/// `camera { … }`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where the eye is.
    pub eye: Option<[f64; 3]>,
    /// Where it looks.
    pub look_at: Option<[f64; 3]>,
    /// The vertical field of view in degrees, between 0 and 180.
    pub fov: Option<f64>,
    /// The block.
    pub span: Span,
}

/// `render { … }`.
#[derive(Clone, Debug, PartialEq)]
pub struct Render {
    /// Width and height in pixels, each > 0.
    pub size: Option<(u32, u32)>,
    /// The mode, not looked up yet.
    pub mode: Option<Word>,
    /// Samples a pixel, > 0.
    pub samples: Option<u32>,
    /// Bounces.
    pub bounces: Option<u32>,
    /// The seed.
    pub seed: Option<u64>,
    /// By how many stops light is made brighter.
    pub exposure: Option<f64>,
    /// The tone curve, not looked up yet.
    pub tonemap: Option<Word>,
    /// What is behind everything.
    pub background: Option<Background>,
    /// The filter, not looked up yet.
    pub filter: Option<Word>,
    /// The clip region of everything.
    pub clip: Option<Clip>,
    /// The block.
    pub span: Span,
}

/// What is seen where no surface is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    /// One colour.
    Color(Color),
    /// Nothing: the picture is clear there.
    Transparent,
    /// The program's sky.
    Sky,
}

/// A name that is looked up later, and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// The name.
    pub name: String,
    /// Where.
    pub span: Span,
}

const OF_CAMERA: [&str; 3] = ["eye", "look_at", "fov"];
const OF_RENDER: [&str; 10] =
    ["size", "mode", "samples", "bounces", "seed", "exposure", "tonemap", "background", "filter", "clip"];

/// The most stops that light is made brighter or darker by: more leaves nothing or everything white.
pub const MAX_EXPOSURE: f64 = 100.0;

impl<'a> Lowerer<'a> {
    /// A statement that is a word and a block.
    pub(super) fn block(&mut self, kind: BlockKind, attributes: &'a [Attribute], span: Span) {
        match kind {
            BlockKind::Camera => self.camera(attributes, span),
            BlockKind::Render => self.render(attributes, span),
            BlockKind::Material => self.check_material(attributes),
            BlockKind::Light => self.lamp(attributes, span),
            BlockKind::Sun => self.sun(attributes, span),
            BlockKind::Sky => self.sky(attributes, span),
        }
    }

    fn camera(&mut self, attributes: &'a [Attribute], span: Span) {
        if let Some(first) = self.out.camera {
            let error = Diagnostic::error(span, "a program has one camera").also(first.span, "the first");
            self.report(error.help("leave one of them out"));
            return;
        }
        self.check_keys(attributes, "a camera", &OF_CAMERA);
        let mut camera = Camera { eye: None, look_at: None, fov: None, span };
        for attribute in attributes {
            match attribute.key.text.as_str() {
                "eye" => camera.eye = self.point(attribute).ok(),
                "look_at" => camera.look_at = self.point(attribute).ok(),
                "fov" => camera.fov = self.field_of_view(attribute).ok(),
                _ => {}
            }
        }
        if let (Some(eye), Some(look_at)) = (camera.eye, camera.look_at)
            && eye == look_at
        {
            self.report(Diagnostic::error(span, "the camera looks at its own eye").help("move one of the two points"));
        }
        self.out.camera = Some(camera);
    }

    fn render(&mut self, attributes: &'a [Attribute], span: Span) {
        if let Some(first) = &self.out.render {
            let error = Diagnostic::error(span, "a program has one render block").also(first.span, "the first");
            self.report(error.help("put everything into one of them"));
            return;
        }
        self.check_keys(attributes, "a render block", &OF_RENDER);
        let entry = |key: &str| attributes.iter().find(|attribute| attribute.key.text == key);
        let render = Render {
            size: entry("size").and_then(|attribute| self.size(attribute).ok()),
            mode: entry("mode").and_then(|attribute| self.later(attribute, "the name of a mode", "studio").ok()),
            samples: entry("samples").and_then(|attribute| self.count(attribute, 1).ok()),
            bounces: entry("bounces").and_then(|attribute| self.count(attribute, 0).ok()),
            seed: entry("seed").and_then(|attribute| self.long_count(attribute).ok()),
            exposure: entry("exposure").and_then(|attribute| self.exposure(attribute).ok()),
            tonemap: entry("tonemap")
                .and_then(|attribute| self.later(attribute, "the name of a tone curve", "neutral").ok()),
            background: entry("background").and_then(|attribute| self.background(attribute).ok()),
            filter: entry("filter")
                .and_then(|attribute| self.later(attribute, "the name of a filter", "mitchell").ok()),
            clip: entry("clip").and_then(|attribute| self.clip(attribute).ok()),
            span,
        };
        self.out.render = Some(render);
    }

    /// A name that is looked up later.
    fn later(&mut self, attribute: &'a Attribute, wanted: &str, example: &str) -> Reporting<Word> {
        let (name, span) = self.word(attribute, wanted, example)?;
        Ok(Word { name: name.to_owned(), span })
    }

    fn exposure(&mut self, attribute: &'a Attribute) -> Reporting<f64> {
        let is_allowed = |stops: f64| stops.abs() <= MAX_EXPOSURE;
        let wanted = format!("a number of stops from -{MAX_EXPOSURE} to {MAX_EXPOSURE}");
        self.number_that(attribute, is_allowed, &wanted, "1")
    }

    fn background(&mut self, attribute: &'a Attribute) -> Reporting<Background> {
        match &attribute.value {
            AttributeValue::Expr(Expr { kind: ExprKind::Name(name), .. }) | AttributeValue::Text(name, _)
                if name == "transparent" =>
            {
                Ok(Background::Transparent)
            }
            AttributeValue::Expr(Expr { kind: ExprKind::Name(name), .. }) | AttributeValue::Text(name, _)
                if name == "sky" =>
            {
                Ok(Background::Sky)
            }
            _ => self.color(attribute, Amount::Share).map(Background::Color),
        }
    }

    fn size(&mut self, attribute: &Attribute) -> Reporting<(u32, u32)> {
        match attribute.value {
            AttributeValue::Size(width, height, _) if width > 0 && height > 0 => Ok((width, height)),
            _ => self.wrong_value(attribute, "a width and a height in pixels", "800x600"),
        }
    }

    fn field_of_view(&mut self, attribute: &'a Attribute) -> Reporting<f64> {
        let AttributeValue::Expr(expr) = &attribute.value else {
            return self.wrong_value(attribute, "an angle in degrees", "40");
        };
        let value = self.known_number(expr, "`fov`")?;
        if 0.0 < value && value < 180.0 {
            return Ok(value);
        }
        self.wrong_value(attribute, "an angle between 0 and 180 degrees", "40")
    }
}
