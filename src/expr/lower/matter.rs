//! What surfaces are made of: `material NAME { … }`, and the same entries behind a surface.
//!
//! In: entries; those of a surface win over those of the material that it names. Out: a [`Matter`]: which kind it is, even where
//! nobody said, and the values. What scatters how is the scene's business.

use super::paints::{Amount, Color, Paint};
use super::surfaces::Kind;
use super::textures::{Field, Lines};
use super::{Lowerer, Reporting, cut};
use crate::diag::{Diagnostic, Span, nearest, one_of};
use crate::syntax::ast::{Attribute, BlockKind, Program, StatementKind};

/// What a surface is made of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Matter {
    /// How it scatters.
    pub kind: MatterKind,
    /// Albedo or tint.
    pub color: Option<Paint>,
    /// Of 0..=1.
    pub roughness: Option<Paint>,
    /// Radiance in W/(m² sr).
    pub emission: Option<Paint>,
    /// The share of light that meets the surface.
    pub opacity: Option<Paint>,
    /// Whether it is closed where a clip cuts it.
    pub cap: bool,
    /// Contour lines.
    pub lines: Option<Lines>,
    /// The refractive index, > 0.
    pub ior: Option<f64>,
    /// What a way of length 1 inside takes, >= 0.
    pub absorption: Option<Color>,
    /// The complex refractive index of a metal.
    pub conductor: Option<Conductor>,
    /// Which of several glasses fills a place.
    pub priority: Option<u32>,
    /// Which sign of f is the inside.
    pub inside: Option<Inside>,
}

/// The kinds of scattering.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MatterKind {
    /// Evenly.
    #[default]
    Matte,
    /// Matte under a clear coat.
    Plastic,
    /// Metal.
    Metal,
    /// A perfect mirror.
    Mirror,
    /// Clear.
    Glass,
}

/// The complex refractive index n + ik.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Conductor {
    /// Of a known metal.
    Measured(Metal),
    /// As written.
    Written {
        /// The real part for red, green and blue.
        n: Color,
        /// The imaginary part.
        k: Color,
    },
}

/// Metals whose refractive indices are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Metal {
    /// Au.
    Gold,
    /// Ag.
    Silver,
    /// Cu.
    Copper,
    /// Al.
    Aluminium,
    /// Fe.
    Iron,
}

/// The sign of f inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inside {
    /// f < 0.
    Negative,
    /// f > 0.
    Positive,
}

const KINDS: [(&str, MatterKind); 5] = [
    ("matte", MatterKind::Matte),
    ("plastic", MatterKind::Plastic),
    ("metal", MatterKind::Metal),
    ("mirror", MatterKind::Mirror),
    ("glass", MatterKind::Glass),
];

/// Clear things that are no kinds, with their refractive indices (at 589 nm and 20 °C; ice at 0 °C): CRC Handbook of Chemistry
/// and Physics, 95th edition, sections 4 and 10.
const CLEAR: [(&str, f64); 4] = [("water", 1.333), ("ice", 1.31), ("diamond", 2.417), ("air", 1.0003)];

const METALS: [(&str, Metal); 6] = [
    ("gold", Metal::Gold),
    ("silver", Metal::Silver),
    ("copper", Metal::Copper),
    ("aluminium", Metal::Aluminium),
    ("aluminum", Metal::Aluminium),
    ("iron", Metal::Iron),
];

const OF_MATERIAL: [&str; 12] =
    ["lines", "kind", "color", "roughness", "ior", "metal", "n", "k", "absorption", "emission", "opacity", "priority"];

/// The entries that one kind or another does not use.
const OF_KINDS: [&str; 9] = ["color", "roughness", "ior", "metal", "n", "k", "absorption", "priority", "inside"];

/// Those of them that a kind does use.
fn uses(kind: MatterKind) -> &'static [&'static str] {
    match kind {
        MatterKind::Matte | MatterKind::Mirror => &["color"],
        MatterKind::Plastic => &["color", "roughness", "ior"],
        MatterKind::Metal => &["color", "roughness", "metal", "n", "k"],
        MatterKind::Glass => &["roughness", "ior", "absorption", "priority", "inside"],
    }
}

/// The entries of a surface and of its material, each key once.
struct Entries<'a>(Vec<&'a Attribute>);

impl<'a> Entries<'a> {
    fn get(&self, key: &str) -> Option<&'a Attribute> {
        self.0.iter().copied().find(|attribute| attribute.key.text == key)
    }

    fn place(&self, key: &str) -> Option<Span> {
        self.get(key).map(|attribute| attribute.key.span)
    }
}

impl<'a> Lowerer<'a> {
    /// Finds the program's materials, so that they may stand in any order.
    pub(super) fn name_materials(&mut self, program: &'a Program) {
        for statement in &program.statements {
            let StatementKind::Block { kind: BlockKind::Material, name: Some(name), attributes } = &statement.kind
            else {
                continue;
            };
            if let Some(&(first, _)) = self.materials.get(name.text.as_str()) {
                let message = format!("the material `{}` is defined twice", cut(&name.text));
                let error = Diagnostic::error(name.span, message).also(first, "first defined here");
                self.report(error.help("give one of the two another name"));
            } else {
                self.materials.insert(&name.text, (name.span, attributes));
            }
        }
    }

    /// Reads a material for what is wrong with it; surfaces read it again.
    pub(super) fn check_material(&mut self, attributes: &'a [Attribute]) {
        self.check_keys(attributes, "a material", &OF_MATERIAL);
        // Which surface does not matter for what can be wrong.
        let f = self.coordinates(Span::default())[0];
        self.field = Some(Field::new(f, Kind::Number));
        self.matter(&Entries(attributes.iter().collect()));
        self.field = None;
    }

    /// What a surface is made of, by its own entries and those of the material it names.
    pub(super) fn matter_of_surface(&mut self, attributes: &'a [Attribute]) -> Matter {
        let mut entries: Vec<&'a Attribute> = attributes.iter().collect();
        if let Some(attribute) = self.entry(attributes, "material")
            && let Ok(named) = self.material(attribute)
        {
            let is_own = |key: &str| self.entry(attributes, key).is_some();
            entries.extend(named.iter().filter(|attribute| !is_own(&attribute.key.text)));
        }
        self.matter(&Entries(entries))
    }

    /// The entries of the material of a name.
    fn material(&mut self, attribute: &'a Attribute) -> Reporting<&'a [Attribute]> {
        let (name, span) = self.word(attribute, "the name of a material", "gold")?;
        if let Some(&(_, entries)) = self.materials.get(name) {
            return Ok(entries);
        }
        let help = match nearest(name, self.materials.keys().copied()).first() {
            Some(near) => format!("did you mean `{near}`?"),
            None if KINDS.iter().any(|(kind, _)| *kind == name) => format!("for the kind write `kind: {name}`"),
            None if METALS.iter().any(|(metal, _)| *metal == name) => {
                format!("for the metal write `metal: \"{name}\"`")
            }
            None => format!("define it: `material {} {{ kind: matte, color: orange }}`", cut(name)),
        };
        Err(self.report(Diagnostic::error(span, format!("there is no material `{}`", cut(name))).help(help)))
    }

    fn matter(&mut self, entries: &Entries<'a>) -> Matter {
        let conductor = self.conductor(entries);
        let mut matter = Matter { kind: self.kind(entries), conductor, ..Matter::default() };
        let ok = |paint: Option<Reporting<Paint>>| paint.and_then(Result::ok);
        matter.color = ok(entries.get("color").map(|entry| self.paint(entry, Amount::Share)));
        matter.lines = entries.get("lines").and_then(|entry| self.lines(entry).ok());
        matter.roughness = ok(entries.get("roughness").map(|entry| self.share(entry)));
        matter.opacity = ok(entries.get("opacity").map(|entry| self.share(entry)));
        matter.emission = ok(entries.get("emission").map(|entry| self.paint_or_grey(entry, Amount::Light)));
        let ior = entries.get("ior").map(|entry| self.number_that(entry, |n| n > 0.0, "a number more than 0", "1.5"));
        matter.ior = ior.and_then(Result::ok);
        let absorption = entries.get("absorption").map(|entry| self.color_or_grey(entry, Amount::Light));
        matter.absorption = absorption.and_then(Result::ok);
        matter.priority = entries.get("priority").and_then(|entry| self.count(entry, 0).ok());
        matter.cap = entries.get("cap").is_some_and(|entry| self.truth(entry).unwrap_or(false));
        matter.inside = entries.get("inside").and_then(|entry| self.inside(entry).ok());
        self.note_unused(&matter, entries);
        matter
    }

    /// The kind as written, or the one that the other entries speak of.
    fn kind(&mut self, entries: &Entries<'a>) -> MatterKind {
        let has = |keys: &[&str]| keys.iter().any(|key| entries.get(key).is_some());
        let Some(entry) = entries.get("kind") else {
            return match () {
                () if has(&["metal", "n", "k"]) => MatterKind::Metal,
                () if has(&["ior", "absorption", "priority"]) => MatterKind::Glass,
                () => MatterKind::Matte,
            };
        };
        let Ok((name, span)) = self.word(entry, "the kind of a material", "metal") else { return MatterKind::Matte };
        if let Some(&(_, kind)) = KINDS.iter().find(|(known, _)| *known == name) {
            return kind;
        }
        let names = KINDS.map(|(known, _)| known);
        let clear = CLEAR.iter().find(|(known, _)| *known == name);
        let help = match (clear, nearest(name, names).first()) {
            (Some((_, ior)), _) => format!("write `kind: glass, ior: {ior}`"),
            (None, Some(near)) => format!("did you mean `{near}`?"),
            (None, None) if METALS.iter().any(|(metal, _)| *metal == name) => {
                format!("write `kind: metal, metal: \"{name}\"`")
            }
            (None, None) => format!("there are {}", one_of(&names)),
        };
        self.report(Diagnostic::error(span, format!("there is no kind `{}`", cut(name))).help(help));
        MatterKind::Matte
    }

    /// The refractive index of a metal: of a known one, or n with k.
    fn conductor(&mut self, entries: &Entries<'a>) -> Option<Conductor> {
        let color =
            |lowerer: &mut Self, key: &str| entries.get(key).map(|entry| lowerer.color_or_grey(entry, Amount::Light));
        let (n, k) = (color(self, "n"), color(self, "k"));
        if let Some(entry) = entries.get("metal") {
            if let Some(span) = entries.place("n").or(entries.place("k")) {
                let error = Diagnostic::error(span, "a known metal has an n and a k of its own");
                self.report(error.also(entry.key.span, "the metal").help("leave out `metal`, or `n` and `k`"));
            }
            return self.metal(entry).ok().map(Conductor::Measured);
        }
        match (n, k) {
            (Some(n), Some(k)) => Some(Conductor::Written { n: n.ok()?, k: k.ok()? }),
            (None, None) => None,
            (n, _) => {
                let (given, missing) = if n.is_some() { ("n", "k") } else { ("k", "n") };
                let span = entries.place(given).unwrap_or_default();
                let error = Diagnostic::error(span, format!("a metal with `{given}` needs `{missing}` too"));
                self.report(error.help("for example gold: `n: rgb(0.18, 0.42, 1.37), k: rgb(3.4, 2.3, 1.8)`"));
                None
            }
        }
    }

    fn metal(&mut self, entry: &'a Attribute) -> Reporting<Metal> {
        let (name, span) = self.word(entry, "the name of a metal", "gold")?;
        if let Some(&(_, metal)) = METALS.iter().find(|(known, _)| *known == name) {
            return Ok(metal);
        }
        let names = ["gold", "silver", "copper", "aluminium", "iron"];
        let help = match nearest(name, names).first() {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("known are {}; for others write `n` and `k`", one_of(&names)),
        };
        Err(self.report(Diagnostic::error(span, format!("the metal `{}` is not known", cut(name))).help(help)))
    }

    fn truth(&mut self, entry: &'a Attribute) -> Reporting<bool> {
        match self.word(entry, "`true` or `false`", "true")?.0 {
            "true" => Ok(true),
            "false" => Ok(false),
            _ => self.wrong_value(entry, "`true` or `false`", "true"),
        }
    }

    fn inside(&mut self, entry: &'a Attribute) -> Reporting<Inside> {
        match self.word(entry, "`negative` or `positive`", "negative")?.0 {
            "negative" => Ok(Inside::Negative),
            "positive" => Ok(Inside::Positive),
            _ => self.wrong_value(entry, "`negative` or `positive`", "negative"),
        }
    }

    /// Refuses what makes no sense, and says what a kind makes no use of.
    fn note_unused(&mut self, matter: &Matter, entries: &Entries<'a>) {
        let kind = KINDS.iter().find(|(_, kind)| *kind == matter.kind).map_or("", |(name, _)| name);
        let used = uses(matter.kind);
        for key in OF_KINDS {
            // A cap takes its solid from the side that is the inside.
            let is_used = used.contains(&key) || key == "inside" && matter.cap;
            let Some(span) = entries.place(key).filter(|_| !is_used) else { continue };
            if matches!(key, "metal" | "n" | "k") {
                let error = Diagnostic::error(span, format!("`{key}` belongs to metals, and this is {kind}"));
                let error = entries.place("kind").into_iter().fold(error, |error, place| error.also(place, "the kind"));
                self.report(error.help("write `kind: metal`, or leave it out"));
                continue;
            }
            let help = match (matter.kind, key) {
                (MatterKind::Glass, "color") => {
                    "`studio`, `cosine` and `mirror` show it; what tints the light inside is `absorption`".to_owned()
                }
                _ => format!("{kind} uses {}", one_of(used)),
            };
            self.report(Diagnostic::note(span, format!("{kind} makes no use of `{key}`")).help(help));
        }
        if let (Some(_), Some(span)) = (matter.conductor, entries.place("color")) {
            let note = Diagnostic::note(span, "a metal whose n and k are known makes no use of `color`");
            self.report(note.help("leave out the color, or `metal`, `n` and `k` for a metal of this tint"));
        }
    }
}
