//! Formulas to what is drawn: surfaces with their clips, a camera, settings.
//!
//! In: a program without errors and the wishes of the command line, which win over it. Out: a [`Plan`], or why there
//! is none. Here what was left open is found: the region, the eye, the colours.

use super::cap;
use super::matter;
use super::outlook::{Outlook, Place};
use super::paint::Painter;
use super::program::Program;
use super::proofs::{Prover, classify_all, frame};
use super::settings::{settings, without_use};
use crate::closure::Formula;
use crate::diag::Diagnostic;
use crate::expr::curvature;
use crate::expr::equation::whole;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::lower::{Clip as WrittenClip, ClipShape, Kind as WrittenKind, Lowered, SurfaceFormula};
use crate::film::{Size, Tone};
use crate::num::level::Simd;
use crate::render::filter::Filter;
use crate::render::{Background, Drawing, Failure, Mode, Passes, Settings, Watch};
use crate::scene::cells::Cell;
use crate::scene::framing::{self, MAX_POWER};
use crate::scene::{Framing, Scene, Sides, View};
use crate::surface::{self, Clip, Shape, Surface, Tracer};
use glam::DVec3;
use std::cell::RefCell;

/// The march's step, as a share of the region's diameter, where none is asked for.
const MARCH_SHARE: f64 = 1.0 / 256.0;

/// How far outside the region the sign of f is read, in radii: anywhere outside a bounded surface has the same.
const OUTSIDE: DVec3 = DVec3::new(1.9, 1.7, 1.3);

/// How roots are found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Method {
    /// None is missed.
    #[default]
    Faithful,
    /// Steps of this length, or of a share of the region.
    March(Option<f64>),
}

/// What is asked for besides the program; `None` and empty leave it to the program.
#[derive(Clone, Debug, Default)]
pub struct Wishes {
    /// Pixels.
    pub size: Option<Size>,
    /// What the colours say.
    pub mode: Option<Mode>,
    /// The most samples a pixel.
    pub samples: Option<u32>,
    /// The most scattering events of a path.
    pub bounces: Option<u32>,
    /// Which set of random numbers.
    pub seed: Option<u64>,
    /// By how many stops light is made brighter.
    pub exposure: Option<f64>,
    /// The tone curve, where light is shown.
    pub tone: Option<Tone>,
    /// What is behind everything.
    pub background: Option<Background>,
    /// How much a place counts in a pixel.
    pub filter: Option<Filter>,
    /// The camera.
    pub view: View,
    /// What is seen of everything: all of these; replaces the program's.
    pub clip: Vec<Shape>,
    /// How roots are found.
    pub method: Method,
    /// Threads, at least 1.
    pub threads: usize,
    /// Whether distances are kept.
    pub keep_depth: bool,
    /// Whether normals are kept.
    pub keep_normals: bool,
    /// In which passes it is drawn.
    pub passes: Passes,
    /// Which instructions are used.
    pub simd: Simd,
}

/// What is drawn.
pub struct Plan {
    /// The surfaces with their clips.
    pub surfaces: Vec<Surface>,
    /// Camera and colours.
    pub scene: Scene,
    /// Pixels, mode, threads.
    pub settings: Settings,
    /// How roots are found.
    pub method: surface::Method,
    /// What is seen of everything.
    pub region: Vec<Shape>,
    /// The region, if it was found because none was given.
    pub found: Option<Framing>,
    /// What was asked of the camera.
    pub view: View,
    /// What had to be assumed.
    pub notes: Vec<Diagnostic>,
}

/// Why nothing can be drawn.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Refusal {
    /// Something in the program.
    Program(Vec<Diagnostic>),
    /// There is no surface; the words say what is proven instead.
    NothingToSee(String),
    /// The wishes contradict each other.
    Wishes(String),
}

impl Plan {
    /// Plans the drawing of a program without errors.
    ///
    /// # Errors
    /// If there is nothing to draw, or no camera sees it.
    pub fn new(program: &mut Program, wishes: &Wishes) -> Result<Plan, Refusal> {
        if !program.lowered.nothing_to_draw.is_empty() {
            return Err(Refusal::Program(program.lowered.nothing_to_draw.clone()));
        }
        let settings = settings(program, wishes)?;
        let mut objects = objects(program, wishes);
        let mut region = wishes.clip.clone();
        let is_bounded = |o: &Object| !o.clip.shapes.is_empty();
        let mut found = None;
        if region.is_empty() {
            region = shared_shapes(program);
        }
        if region.is_empty() {
            let provers: Vec<Prover> = objects.iter().map(Object::prover).collect();
            let framing = frame(&provers).map_err(nothing_to_see)?;
            if !objects.iter().all(is_bounded) {
                found = Some(framing);
                objects.iter_mut().for_each(|o| o.clip.shapes.push(framing.shape()));
            }
            region = vec![framing.shape()];
        }
        check_region(program, wishes, &region)?;
        let graph = &mut program.lowered.graph;
        objects
            .iter_mut()
            .filter(|object| object.formula.matter.cap)
            .for_each(|object| object.close(graph, wishes.simd));
        let surfaces: Vec<Surface> = objects
            .iter()
            .map(|o| Surface::new(graph, o.formula.f, kind_of(&o.formula), &o.clip, wishes.simd))
            .collect();
        let mut scene = scene(program, wishes, &objects, &surfaces, &region, found, &settings)?;
        paint(&mut scene, &mut program.lowered, &objects, &smallest(&region), settings.mode, wishes.simd);
        let formulas: Vec<&SurfaceFormula> = objects.iter().map(|object| &object.formula).collect();
        let mut notes = matter::furnish(&mut scene, &mut program.lowered, &formulas, wishes.simd);
        let provers: Vec<Prover> = objects.iter().map(Object::prover).collect();
        scene.tighten(|surface, cubes, cells| provers[surface].classify(cubes, cells));
        notes.extend(without_use(program, wishes, settings.mode));
        let method = match wishes.method {
            Method::Faithful => surface::Method::Faithful,
            Method::March(Some(step)) => surface::Method::March { step },
            Method::March(None) => surface::Method::March { step: smallest(&region).size() * 2.0 * MARCH_SHARE },
        };
        let view = wishes.view.or(written_view(program));
        Ok(Plan { surfaces, scene, settings, method, region, found, view, notes })
    }

    /// Draws it.
    ///
    /// # Errors
    /// If the watch cancels.
    pub fn draw(&self, watch: &dyn Watch) -> Result<Drawing, Failure> {
        crate::render::draw(&self.scene, &self.settings, &|| Tracer::new(&self.surfaces, self.method), watch)
    }
}

/// A surface on its way: its formula, its clip, and what decides whether it can be in a box.
struct Object {
    formula: SurfaceFormula,
    clip: Clip,
    f: Formula,
    fields: Vec<Formula>,
}

impl Object {
    /// What is known of where it can be.
    fn prover(&self) -> Prover<'_> {
        Prover::new(&self.f, &self.clip.shapes, &self.fields)
    }

    /// Closes it where its clip cuts it.
    fn close(&mut self, graph: &mut Graph, simd: Simd) {
        cap::close(graph, &mut self.formula, &mut self.clip);
        self.f = Formula::new(graph, self.formula.f, simd);
        self.fields.clear();
    }
}

fn objects(program: &mut Program, wishes: &Wishes) -> Vec<Object> {
    let shared = program.lowered.render.as_ref().and_then(|render| render.clip).filter(|_| wishes.clip.is_empty());
    let formulas = program.lowered.surfaces.clone();
    let graph = &mut program.lowered.graph;
    let mut objects = Vec::new();
    for formula in formulas {
        let mut clip = Clip { shapes: wishes.clip.clone(), fields: Vec::new() };
        for written in [shared, formula.clip].into_iter().flatten() {
            match shape_of(&written) {
                Ok(shape) => clip.shapes.push(shape),
                Err(field) => clip.fields.push(field),
            }
        }
        let f = Formula::new(graph, formula.f, wishes.simd);
        let fields = clip.fields.iter().map(|&field| Formula::new(graph, field, wishes.simd)).collect();
        objects.push(Object { formula, clip, f, fields });
    }
    objects
}

/// The shape of a clip as written, or the function that is negative inside.
fn shape_of(written: &WrittenClip) -> Result<Shape, crate::expr::graph::NodeId> {
    match written.shape {
        ClipShape::Box { low, high } => Ok(Shape::Box { min: low.into(), max: high.into() }),
        ClipShape::Ball { centre, radius } => Ok(Shape::Ball { center: centre.into(), radius }),
        ClipShape::Region(field) => Err(field),
    }
}

/// The shape of the program's own clip of everything.
fn shared_shapes(program: &Program) -> Vec<Shape> {
    let clip = program.lowered.render.as_ref().and_then(|render| render.clip);
    clip.and_then(|clip| shape_of(&clip).ok()).into_iter().collect()
}

fn kind_of(formula: &SurfaceFormula) -> surface::Kind {
    match formula.kind {
        WrittenKind::Solid => surface::Kind::Solid,
        WrittenKind::Equation | WrittenKind::Number => surface::Kind::Equation,
    }
}

fn smallest(region: &[Shape]) -> Shape {
    let smaller = |a: Shape, b: Shape| if b.size() < a.size() { b } else { a };
    region.iter().copied().reduce(smaller).unwrap_or(Shape::Ball { center: DVec3::ZERO, radius: 1.0 })
}

/// Refuses a region that the square of a distance in it overflows for.
fn check_region(program: &Program, wishes: &Wishes, region: &[Shape]) -> Result<(), Refusal> {
    let shape = smallest(region);
    if (shape.size() * shape.size()).is_finite() && shape.center().length_squared().is_finite() {
        return Ok(());
    }
    let message = "the region is too large to be computed with";
    let written = program.lowered.render.as_ref().and_then(|render| render.clip);
    Err(match written.filter(|_| wishes.clip.is_empty()) {
        Some(clip) => Refusal::Program(vec![Diagnostic::error(clip.span, message)]),
        None => Refusal::Wishes(message.into()),
    })
}

/// What the program says of the camera.
fn written_view(program: &Program) -> View {
    let block = program.lowered.camera;
    View {
        eye: block.and_then(|camera| camera.eye).map(DVec3::from),
        look_at: block.and_then(|camera| camera.look_at).map(DVec3::from),
        fov: block.and_then(|camera| camera.fov),
        ..View::default()
    }
}

fn scene(
    program: &Program,
    wishes: &Wishes,
    objects: &[Object],
    surfaces: &[Surface],
    region: &[Shape],
    found: Option<Framing>,
    settings: &Settings,
) -> Result<Scene, Refusal> {
    let block = program.lowered.camera;
    let provers: Vec<Prover> = objects.iter().map(Object::prover).collect();
    let outlook = Outlook {
        view: wishes.view.or(written_view(program)),
        classify: &|cubes, cells| classify_all(&provers, cubes, cells),
        surfaces,
        shape: smallest(region),
        aspect: f64::from(settings.size.width()) / f64::from(settings.size.height()),
        may_move_aside: found.is_some(),
        seen: RefCell::default(),
    };
    let Place { camera, look_at, center, radius } = outlook.place().map_err(|error| match block {
        Some(block) if wishes.view == View::default() => {
            Refusal::Program(vec![Diagnostic::error(block.span, error.to_string())])
        }
        _ => Refusal::Wishes(error.to_string()),
    })?;
    let sides = Vec::new();
    let clips = objects.iter().map(|object| object.clip.shapes.clone()).collect();
    let whole = smallest(region);
    let bounds = objects.iter().map(|object| {
        let shape = object.clip.shapes.iter().copied().fold(whole, |a, b| if b.size() < a.size() { b } else { a });
        (shape.center(), shape.size())
    });
    let bounds = bounds.collect();
    let (materials, lights, sky) = (Vec::new(), Vec::new(), None);
    Ok(Scene { camera, look_at, sides, clips, bounds, materials, lights, sky, center, radius })
}

/// Whether f is negative all around the region, so that the outside is where f < 0.
fn is_negative_outside(object: &Object, region: &Shape) -> bool {
    let corner = |k: u32| DVec3::select(glam::BVec3::new(k & 1 != 0, k & 2 != 0, k & 4 != 0), OUTSIDE, -OUTSIDE);
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * OUTSIDE.x);
    let mut around = (0..8).map(corner).chain(axes).chain(axes.map(|axis| -axis));
    around.all(|offset| object.f.value(region.center() + offset * region.size()) < 0.0)
}

/// Gives a scene the colours of its surfaces: their own, or what the mode shows instead.
fn paint(scene: &mut Scene, lowered: &mut Lowered, objects: &[Object], region: &Shape, mode: Mode, simd: Simd) {
    let curvatures: Vec<Option<NodeId>> = objects.iter().map(|object| curvature_of(lowered, object, mode)).collect();
    let painter = Painter { graph: &lowered.graph, simd, radius: scene.radius };
    let sides = objects.iter().zip(curvatures).enumerate().map(|(index, (object, curvature))| {
        let default = Sides::by_default(index, objects.len());
        match curvature {
            Some(gauss) => Sides { paint: painter.curvature(gauss), ..default },
            None => matter::sides(&object.formula.matter, default, is_negative_outside(object, region), &painter),
        }
    });
    scene.sides = sides.collect();
}

/// The Gauss curvature of a surface, in the mode that shows it.
fn curvature_of(lowered: &mut Lowered, object: &Object, mode: Mode) -> Option<NodeId> {
    let graph = &mut lowered.graph;
    let f = object.formula.f;
    (mode == Mode::Curvature).then(|| {
        let g = if object.formula.kind == WrittenKind::Solid { f } else { whole(graph, f) };
        curvature::gauss(graph, g)
    })
}

fn nothing_to_see(nothing: framing::Nothing) -> Refusal {
    let what = match nothing.0 {
        Cell::Positive => "f > 0 everywhere",
        Cell::Negative => "f < 0 everywhere",
        Cell::Undefined => "f has no value anywhere",
        Cell::Empty | Cell::Possible => "no surface is anywhere",
    };
    let bound = 1u32 << MAX_POWER;
    Refusal::NothingToSee(format!("there is nothing to see: {what} within |x|, |y|, |z| <= {bound}"))
}

/// The plan of a text, for tests of what it is made of.
#[cfg(test)]
pub(super) fn planned(text: &str) -> Plan {
    let mut program = Program::from_text(text);
    assert!(!program.has_errors(), "{text}: {:?}", program.diagnostics);
    Plan::new(&mut program, &Wishes::default()).unwrap_or_else(|refusal| panic!("{text}: {refusal:?}"))
}
