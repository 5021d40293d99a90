//! Blocks of attributes: behind a surface, and those of the camera and the render settings.
//!
//! In: `key: value` pairs. Out: plain numbers with their places, for the scene to read. What keys mean is the
//! scene's business; here they are known by name, and their values are worked out.

use super::surfaces::{Kind, SurfaceFormula};
use super::values::Value;
use super::{Lowerer, Reporting, colours, cut};
use crate::diag::{Diagnostic, Span, nearest, one_of};
use crate::expr::graph::NodeId;
use crate::syntax::ast::{Attribute, AttributeValue, BlockKind, Expr, ExprKind};

/// A colour as it was written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Color {
    /// Red, green, blue of 0..=255, sRGB: `#rgb`, `#rrggbb`, `red`.
    Srgb([u8; 3]),
    /// Linear red, green, blue: `rgb(1, 0.5, 0)`.
    Linear([f64; 3]),
}

/// A part of space to which something is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip {
    /// Which part.
    pub shape: ClipShape,
    /// The place of the value.
    pub span: Span,
}

/// The kinds of clips.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClipShape {
    /// `box(x0..x1, y0..y1, z0..z1)`, each low < high.
    Box {
        /// The least x, y, z.
        low: [f64; 3],
        /// The greatest.
        high: [f64; 3],
    },
    /// `ball(x, y, z, r)`, r > 0.
    Ball {
        /// The centre.
        centre: [f64; 3],
        /// The radius.
        radius: f64,
    },
    /// Any region: where this node is negative.
    Region(NodeId),
}

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
    pub mode: Option<Mode>,
    /// Samples a pixel, > 0.
    pub samples: Option<u32>,
    /// Bounces.
    pub bounces: Option<u32>,
    /// The seed.
    pub seed: Option<u32>,
    /// The clip region of everything.
    pub clip: Option<Clip>,
    /// The block.
    pub span: Span,
}

/// The name of a mode and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// The name.
    pub name: String,
    /// Where.
    pub span: Span,
}

/// The attributes of a surface that are read.
const OF_SURFACE: [&str; 3] = ["color", "clip", "name"];

/// The attributes of a surface that are known and cannot be used yet.
const OF_SURFACE_LATER: [&str; 16] = [
    "material",
    "kind",
    "roughness",
    "opacity",
    "ior",
    "absorption",
    "metal",
    "emission",
    "n",
    "k",
    "lines",
    "cap",
    "inside",
    "back",
    "bump",
    "texture",
];

const OF_CAMERA: [&str; 3] = ["eye", "look_at", "fov"];
const OF_RENDER: [&str; 6] = ["size", "mode", "samples", "bounces", "seed", "clip"];

impl<'a> Lowerer<'a> {
    /// A statement that is a word and a block.
    pub(super) fn block(&mut self, kind: BlockKind, attributes: &'a [Attribute], span: Span) {
        let later = match kind {
            BlockKind::Camera => return self.camera(attributes, span),
            BlockKind::Render => return self.render(attributes, span),
            BlockKind::Material => "materials",
            BlockKind::Light => "lights",
            BlockKind::Sun => "suns",
            BlockKind::Sky => "skies",
        };
        let error = Diagnostic::error(span, format!("{later} are not built yet"));
        self.report(error.help("leave the block out; `color` works"));
    }

    /// The attributes of a surface, in a formula whose other fields are to be filled in.
    pub(super) fn surface_attributes(&mut self, attributes: &'a [Attribute]) -> SurfaceFormula {
        let mut out = SurfaceFormula::plain(NodeId(0), Kind::Equation, Span::default());
        self.check_keys(attributes, "a surface", &OF_SURFACE, &OF_SURFACE_LATER);
        for attribute in attributes {
            match attribute.key.text.as_str() {
                "color" => out.color = self.color(attribute).ok(),
                "clip" => out.clip = self.clip(attribute).ok(),
                "name" => out.name = self.text(attribute).ok(),
                _ => {}
            }
        }
        out
    }

    fn camera(&mut self, attributes: &'a [Attribute], span: Span) {
        if let Some(first) = self.out.camera {
            let error = Diagnostic::error(span, "a program has one camera").also(first.span, "the first");
            self.report(error.help("leave one of them out"));
            return;
        }
        self.check_keys(attributes, "a camera", &OF_CAMERA, &[]);
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
        self.check_keys(attributes, "a render block", &OF_RENDER, &[]);
        let mut render = Render { size: None, mode: None, samples: None, bounces: None, seed: None, clip: None, span };
        for attribute in attributes {
            match attribute.key.text.as_str() {
                "size" => render.size = self.size(attribute).ok(),
                "mode" => render.mode = self.mode(attribute).ok(),
                "samples" => render.samples = self.count(attribute, 1).ok(),
                "bounces" => render.bounces = self.count(attribute, 0).ok(),
                "seed" => render.seed = self.count(attribute, 0).ok(),
                "clip" => render.clip = self.clip(attribute).ok(),
                _ => {}
            }
        }
        self.out.render = Some(render);
    }

    /// Refuses keys that are not known or not possible yet.
    fn check_keys(&mut self, attributes: &'a [Attribute], owner: &str, known: &[&str], later: &[&str]) {
        for attribute in attributes {
            let key = &attribute.key;
            if later.contains(&key.text.as_str()) {
                let error = Diagnostic::error(key.span, format!("`{}` is not built yet", key.text));
                self.report(error.help(format!("{owner} takes {}", one_of(known))));
            } else if !known.contains(&key.text.as_str()) {
                let near = nearest(&key.text, known.iter().copied());
                let help = match near.first() {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("{owner} takes {}", one_of(known)),
                };
                let message = format!("{owner} has no attribute `{}`", cut(&key.text));
                self.report(Diagnostic::error(key.span, message).help(help));
            }
        }
    }

    fn wrong_value<T>(&mut self, attribute: &Attribute, wanted: &str, example: &str) -> Reporting<T> {
        let message = format!("`{}` wants {wanted}", attribute.key.text);
        let help = format!("for example `{}: {example}`", attribute.key.text);
        Err(self.report(Diagnostic::error(place(&attribute.value), message).help(help)))
    }

    fn text(&mut self, attribute: &Attribute) -> Reporting<String> {
        match &attribute.value {
            AttributeValue::Text(text, _) => Ok(text.clone()),
            _ => self.wrong_value(attribute, "a text in quotes", "\"ball\""),
        }
    }

    fn mode(&mut self, attribute: &Attribute) -> Reporting<Mode> {
        match &attribute.value {
            AttributeValue::Text(name, span) => Ok(Mode { name: name.clone(), span: *span }),
            AttributeValue::Expr(Expr { kind: ExprKind::Name(name), span }) => {
                Ok(Mode { name: name.clone(), span: *span })
            }
            _ => self.wrong_value(attribute, "the name of a mode", "studio"),
        }
    }

    fn size(&mut self, attribute: &Attribute) -> Reporting<(u32, u32)> {
        match attribute.value {
            AttributeValue::Size(width, height, _) if width > 0 && height > 0 => Ok((width, height)),
            _ => self.wrong_value(attribute, "a width and a height in pixels", "800x600"),
        }
    }

    fn count(&mut self, attribute: &'a Attribute, least: u32) -> Reporting<u32> {
        let AttributeValue::Expr(expr) = &attribute.value else {
            return self.wrong_value(attribute, "a whole number", "8");
        };
        let node = self.number(expr)?;
        let value = self.whole(node, expr.span, &format!("`{}`", attribute.key.text))?;
        match u32::try_from(value) {
            Ok(value) if value >= least => Ok(value),
            _ => self.wrong_value(attribute, &format!("a whole number from {least} to {}", u32::MAX), "8"),
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

    fn point(&mut self, attribute: &'a Attribute) -> Reporting<[f64; 3]> {
        let AttributeValue::Expr(expr) = &attribute.value else {
            return self.wrong_value(attribute, "a point", "(4, -3, 2)");
        };
        match self.expr(expr)? {
            Value::Vector(items) if items.len() == 3 => {
                let mut point = [0.0; 3];
                for (coordinate, id) in point.iter_mut().zip(items) {
                    *coordinate = self.known(id, expr.span, &format!("each coordinate of `{}`", attribute.key.text))?;
                }
                Ok(point)
            }
            _ => self.wrong_value(attribute, "a point", "(4, -3, 2)"),
        }
    }

    fn clip(&mut self, attribute: &'a Attribute) -> Reporting<Clip> {
        match &attribute.value {
            AttributeValue::Box(ranges, span) => {
                let shape = self.box_of_ranges(ranges, *span)?;
                Ok(Clip { shape, span: *span })
            }
            AttributeValue::Expr(expr) => {
                let shape = match &expr.kind {
                    ExprKind::Call(name, args) if name.text == "ball" => self.ball(args, expr.span)?,
                    _ => match self.expr(expr)? {
                        Value::Region(region) => {
                            self.check_graph_depth(region.side, expr.span)?;
                            ClipShape::Region(region.side)
                        }
                        _ => return self.wrong_value(attribute, "a box, a ball or a region", "ball(0, 0, 0, 2)"),
                    },
                };
                Ok(Clip { shape, span: expr.span })
            }
            _ => self.wrong_value(attribute, "a box, a ball or a region", "ball(0, 0, 0, 2)"),
        }
    }

    fn box_of_ranges(&mut self, ranges: &'a [(Expr, Expr)], span: Span) -> Reporting<ClipShape> {
        if ranges.len() != 3 {
            let message = format!("a box has three ranges, and this has {}", ranges.len());
            return Err(self.report(Diagnostic::error(span, message).help("write `box(-2..2, -2..2, -2..2)`")));
        }
        let (mut least, mut greatest) = ([0.0; 3], [0.0; 3]);
        for (axis, (low, high)) in ranges.iter().enumerate() {
            let (a, b) = (self.known_number(low, "an end of a range"), self.known_number(high, "an end of a range"));
            (least[axis], greatest[axis]) = (a?, b?);
            if least[axis] >= greatest[axis] {
                let message = format!("the range {}..{} is empty", least[axis], greatest[axis]);
                let error = Diagnostic::error(low.span.to(high.span), message);
                return Err(self.report(error.help("the lower end comes first")));
            }
        }
        Ok(ClipShape::Box { low: least, high: greatest })
    }

    fn ball(&mut self, args: &'a [Expr], span: Span) -> Reporting<ClipShape> {
        let [x, y, z, r] = args else {
            let message = format!("a ball has four numbers, and this has {}", args.len());
            return Err(self.report(Diagnostic::error(span, message).help("it is `ball(x, y, z, radius)`")));
        };
        let centre = [x, y, z].map(|expr| self.known_number(expr, "the centre of a ball"));
        let radius = self.known_number(r, "the radius of a ball")?;
        if radius <= 0.0 {
            return Err(self.report(Diagnostic::error(r.span, "the radius of a ball is more than 0")));
        }
        Ok(ClipShape::Ball { centre: [centre[0]?, centre[1]?, centre[2]?], radius })
    }

    fn color(&mut self, attribute: &'a Attribute) -> Reporting<Color> {
        match &attribute.value {
            AttributeValue::Color(srgb, _) => Ok(Color::Srgb(*srgb)),
            AttributeValue::Text(name, span) => self.named_color(name, *span),
            AttributeValue::Expr(expr) => match &expr.kind {
                ExprKind::Name(name) => self.named_color(name, expr.span),
                ExprKind::Call(name, args) if name.text == "rgb" => self.linear_color(args, expr.span),
                ExprKind::Call(name, args) if matches!(name.text.as_str(), "hsl" | "hsv") => {
                    self.color_by_hue(&name.text, args, expr.span)
                }
                _ => self.wrong_value(attribute, "a colour", "#4af"),
            },
            _ => self.wrong_value(attribute, "a colour", "#4af"),
        }
    }

    fn named_color(&mut self, name: &str, span: Span) -> Reporting<Color> {
        if let Some(srgb) = colours::named(name).or_else(|| colours::hexadecimal(name)) {
            return Ok(Color::Srgb(srgb));
        }
        let help = match nearest(name, colours::names()).first() {
            Some(near) => format!("did you mean `{near}`?"),
            None => "write a name such as `orange`, `#f80` or `rgb(1, 0.25, 0)`".to_owned(),
        };
        Err(self.report(Diagnostic::error(span, format!("there is no colour `{}`", cut(name))).help(help)))
    }

    fn linear_color(&mut self, args: &'a [Expr], span: Span) -> Reporting<Color> {
        let [r, g, b] = self.three_parts(args, "rgb(red, green, blue)", span)?;
        let [r, g, b] = [r, g, b].map(|part| self.part_of_color(part));
        Ok(Color::Linear([r?, g?, b?]))
    }

    /// `hsl(hue, saturation, lightness)` or `hsv(hue, saturation, value)`, the hue in degrees.
    fn color_by_hue(&mut self, model: &str, args: &'a [Expr], span: Span) -> Reporting<Color> {
        let third = if model == "hsl" { "lightness" } else { "value" };
        let [hue, saturation, last] = self.three_parts(args, &format!("{model}(hue, saturation, {third})"), span)?;
        let hue = self.known_number(hue, "the hue of a colour");
        let [saturation, last] = [saturation, last].map(|part| self.part_of_color(part));
        let (hue, saturation, last) = (hue?, saturation?, last?);
        Ok(Color::Srgb(if model == "hsl" {
            colours::of_lightness(hue, saturation, last)
        } else {
            colours::of_value(hue, saturation, last)
        }))
    }

    fn three_parts(&mut self, args: &'a [Expr], signature: &str, span: Span) -> Reporting<[&'a Expr; 3]> {
        match args {
            [a, b, c] => Ok([a, b, c]),
            _ => {
                let message = format!("a colour has three numbers, and this has {}", args.len());
                Err(self.report(Diagnostic::error(span, message).help(format!("it is `{signature}`"))))
            }
        }
    }

    fn part_of_color(&mut self, expr: &'a Expr) -> Reporting<f64> {
        let value = self.known_number(expr, "a part of a colour")?;
        if (0.0..=1.0).contains(&value) {
            return Ok(value);
        }
        let error = Diagnostic::error(expr.span, "a part of a surface's colour lies between 0 and 1");
        Err(self.report(error.help("divide by 255, or write the colour as `#ff8000`")))
    }
}

fn place(value: &AttributeValue) -> Span {
    match value {
        AttributeValue::Expr(expr) => expr.span,
        AttributeValue::Color(_, span)
        | AttributeValue::Text(_, span)
        | AttributeValue::Size(_, _, span)
        | AttributeValue::Box(_, span) => *span,
    }
}
