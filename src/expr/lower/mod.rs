//! Names, functions, parameters, lists and regions become nodes.
//!
//! In: a whole program's tree and the values that were set from outside. Out: a [`Lowered`]: one graph, the function
//! of every surface in it, what was defined, and the blocks with their numbers worked out. Separate from the parser
//! because here names get their meaning, and from the scene because nothing here knows what a camera is for.
//!
//! - [`names`]: what is declared, in which order it can be lowered; circles.
//! - [`values`]: numbers, vectors, lists and their arithmetic.
//! - [`meanings`]: what a name stands for.
//! - [`expressions`], [`powers`], [`functions`], [`regions`], [`series`]: the expressions, by kind.
//! - [`parameters`], [`surfaces`], [`blocks`], [`lights`], [`matter`]: the statements, by kind.
//! - [`entries`], [`clips`], [`paints`], [`textures`], [`colours`]: the values in their blocks.
//! - [`constants`]: the f64 of a node that hangs on no variable.
//! - [`limits`]: what no text may exceed.

mod blocks;
mod clips;
mod colours;
mod constants;
mod entries;
mod expressions;
mod functions;
mod lights;
pub mod limits;
mod matter;
mod meanings;
mod names;
mod paints;
mod parameters;
mod powers;
mod regions;
mod series;
mod surfaces;
#[cfg(test)]
mod tests;
mod textures;
mod values;

pub use blocks::{Background, Camera, MAX_EXPOSURE, Render, Word};
pub use clips::{Clip, ClipShape};
pub use colours::{color_of_text, parts_of_lightness, parts_of_value};
pub use lights::{Light, MAX_LIGHTS, Sky, SkyKind, TURBIDITIES};
pub use matter::{Conductor, Inside, Matter, MatterKind, Metal};
pub use paints::{Color, Paint};
pub use parameters::{Parameter, Setting};
pub use regions::{Edge, Region};
pub use surfaces::{Kind, SurfaceFormula};
pub use textures::{Lines, PALETTES};
pub use values::Value;

use super::graph::{Graph, NodeId};
use crate::diag::{Diagnostic, Severity, Span};
use crate::syntax::ast::{Attribute, Program};
use names::{DeclarationKind, Names};
use std::collections::{BTreeMap, HashMap};

/// What is said from outside the program.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// Values of parameters; of two for one name the last counts.
    pub set: Vec<Setting>,
    /// Whether the parser has reported errors: statements may be missing, so unknown names are not reported again.
    pub incomplete: bool,
}

/// A name that the program defines, with its value.
#[derive(Clone, Debug)]
pub struct Definition {
    /// The name.
    pub name: String,
    /// Its value.
    pub value: Value,
    /// Where it is defined.
    pub span: Span,
}

/// A program's mathematics.
#[derive(Clone, Debug, Default)]
pub struct Lowered {
    /// The graph that all nodes are of.
    pub graph: Graph,
    /// What is to be drawn, in the order of the statements.
    pub surfaces: Vec<SurfaceFormula>,
    /// Every definition and parameter that has a value, in the order in which they were lowered.
    pub definitions: Vec<Definition>,
    /// The parameters, in the order of the statements.
    pub parameters: Vec<Parameter>,
    /// The lights that are no surfaces, in the order of the statements.
    pub lights: Vec<Light>,
    /// The sky block.
    pub sky: Option<Sky>,
    /// The camera block.
    pub camera: Option<Camera>,
    /// The render block.
    pub render: Option<Render>,
    /// Errors and notes, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// What hinders drawing but not evaluating: a number alone, no surface at all.
    pub nothing_to_draw: Vec<Diagnostic>,
}

impl Lowered {
    /// Whether there is an error, so that the program cannot be used.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }

    /// The definition of a name.
    pub fn definition(&self, name: &str) -> Option<&Definition> {
        self.definitions.iter().find(|definition| definition.name == name)
    }
}

/// The mark of an error that was reported: what stands on it is silent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Reported;

type Reporting<T> = Result<T, Reported>;

/// Text from the user in messages is cut to this many characters.
const LONGEST_QUOTE: usize = 60;

/// Makes the graph of a program.
///
/// # Errors
/// None in the type: errors and notes are in [`Lowered::diagnostics`], all independent ones of the program, and what
/// could be lowered is there beside them.
pub fn lower(program: &Program, settings: &Settings) -> Lowered {
    let (names, diagnostics) = Names::collect(program);
    let mut lowerer = Lowerer::new(names, settings, diagnostics);
    lowerer.definitions();
    lowerer.check_settings();
    lowerer.name_materials(program);
    lowerer.statements(program);
    lowerer.check_uncalled();
    let mut lowered = lowerer.finish();
    lowered.diagnostics.sort_by_key(|diagnostic| diagnostic.labels.first().map(|label| label.span));
    lowered
}

/// The value of a function's argument, and whether its text hangs on a coordinate.
type Argument = (Value, bool);

/// A name bound by a function or a series.
struct Bound<'a> {
    name: &'a str,
    value: Reporting<Value>,
    /// Whether the text of the value hangs on a coordinate.
    varies: bool,
}

/// The work in hand.
struct Lowerer<'a> {
    graph: Graph,
    names: Names<'a>,
    settings: &'a Settings,
    /// The value of each declaration, once it is lowered, and whether its text hangs on a coordinate.
    values: Vec<Option<(Reporting<Value>, bool)>>,
    /// Names bound by functions and series, the innermost last; of a function that nothing calls without value.
    scope: Vec<Bound<'a>>,
    /// Where in `scope` the names of the current function's body begin.
    frame: usize,
    /// Of each declaration whether it is a function that was called.
    called: Vec<bool>,
    /// Calls of the program's functions that were lowered, by function and arguments.
    calls: HashMap<(usize, Vec<Argument>), (Reporting<Value>, bool)>,
    /// Whether a coordinate was met in the text being lowered: folding may leave nothing of it in the graph.
    met_coordinate: bool,
    /// The materials by name: the name's place and the entries.
    materials: BTreeMap<&'a str, (Span, &'a [Attribute])>,
    /// The surface whose matter is being read.
    field: Option<textures::Field>,
    /// Where the first sky stands.
    first_sky: Option<Span>,
    /// The node under the root of each vector's length.
    squares_of_lengths: HashMap<NodeId, NodeId>,
    /// The depth of each node.
    depths: Vec<u32>,
    depth: u32,
    steps: u64,
    terms: usize,
    stopped: bool,
    out: Lowered,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> Lowerer<'a> {
    fn new(names: Names<'a>, settings: &'a Settings, diagnostics: Vec<Diagnostic>) -> Self {
        Lowerer {
            graph: Graph::new(),
            values: vec![None; names.list.len()],
            called: vec![false; names.list.len()],
            names,
            settings,
            scope: Vec::new(),
            frame: 0,
            calls: HashMap::new(),
            met_coordinate: false,
            materials: BTreeMap::new(),
            field: None,
            first_sky: None,
            squares_of_lengths: HashMap::new(),
            depths: Vec::new(),
            depth: 0,
            steps: 0,
            terms: 0,
            stopped: false,
            out: Lowered::default(),
            diagnostics,
        }
    }

    fn finish(mut self) -> Lowered {
        self.graph.set_span(None);
        Lowered { graph: self.graph, diagnostics: self.diagnostics, ..self.out }
    }

    /// Keeps a diagnostic, unless it was said before or nothing more is to be said.
    fn report(&mut self, diagnostic: Diagnostic) -> Reported {
        let place = |d: &Diagnostic| d.labels.first().map(|label| label.span);
        let said = |known: &Diagnostic| known.message == diagnostic.message && place(known) == place(&diagnostic);
        if !self.stopped && self.diagnostics.len() < MAX_DIAGNOSTICS && !self.diagnostics.iter().any(said) {
            self.diagnostics.push(diagnostic);
        }
        Reported
    }

    /// Does some lowering, and says whether its text hangs on a coordinate.
    fn watched<T>(&mut self, lower: impl FnOnce(&mut Self) -> T) -> (T, bool) {
        let before = std::mem::replace(&mut self.met_coordinate, false);
        let value = lower(self);
        let met = self.met_coordinate;
        self.met_coordinate |= before;
        (value, met)
    }

    /// Lowers every definition, each after those it needs.
    fn definitions(&mut self) {
        for index in std::mem::take(&mut self.names.order) {
            let declaration = &self.names.list[index];
            if declaration.poisoned {
                continue;
            }
            let (name, span) = (declaration.name.text.clone(), declaration.name.span);
            let (value, varies) = match declaration.kind {
                DeclarationKind::Value(value) => self.watched(|lowerer| lowerer.expr(value)),
                DeclarationKind::Parameter { value, low, high, step, span } => {
                    (self.parameter(&name, [value, low, high], step, span).map(Value::Number), false)
                }
                DeclarationKind::Function(..) => continue,
            };
            if let Ok(value) = &value {
                self.out.definitions.push(Definition { name, value: value.clone(), span });
            }
            self.values[index] = Some((value, varies));
        }
    }
}

/// Errors kept at most: nobody reads more, and looking through them takes time.
const MAX_DIAGNOSTICS: usize = 200;

/// Text from the user, short enough for a message.
fn cut(text: &str) -> String {
    if text.chars().count() <= LONGEST_QUOTE {
        return text.to_owned();
    }
    let head: String = text.chars().take(LONGEST_QUOTE).collect();
    format!("{head}…")
}
