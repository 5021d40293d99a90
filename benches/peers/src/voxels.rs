//! fidget's heightmap renderer, with its virtual machine or its compiler, in this process.
//!
//! In: a scene. Out: the processor time of one render and what it drew. fidget draws the voxels of a solid: as many of
//! them deep as the picture is wide, in the frustum of the scene's camera.

use crate::agreement;
use crate::clock::timed;
use crate::formula::{Algebra, translate};
use crate::ours;
use crate::scenes::{Clip, FIELD_OF_VIEW, Scene};
use fidget::context::Tree;
use fidget::eval::Function;
use fidget::jit::JitShape;
use fidget::raster::voxel::{EvalConfig, Image, RenderConfig, RenderSize, render};
use fidget::render::{CancelToken, RenderHints};
use fidget::shape::{BoundShape, Shape};
use fidget::vm::VmShape;
use glam::DVec3;
use implicit::scene::camera::Camera;
use nalgebra::{Matrix4, Vector4};

/// The frustum is so much deeper than the ball around the clip, or its first voxels would touch the near end.
const MARGIN: f64 = 1.01;

/// A depth is right within so many voxels: fidget's are whole numbers, of the first sample inside.
const TOLERANCE: f64 = 3.0;

/// A scene made ready for both engines.
pub struct Voxels {
    compiled: JitShape,
    interpreted: VmShape,
    frustum: Frustum,
    solid: String,
}

/// Which engine.
#[derive(Clone, Copy, PartialEq)]
pub enum Engine {
    Compiled,
    Interpreted,
}

impl Voxels {
    /// `None` where fidget cannot express the formula.
    pub fn new(scene: &Scene) -> Option<Self> {
        let solid = scene.solid();
        let tree = translate(&solid, &Trees)?;
        let frustum = Frustum::new(scene.camera(), scene.clip.radius() * MARGIN);
        Some(Voxels { compiled: JitShape::from(tree.clone()), interpreted: VmShape::from(tree), frustum, solid })
    }

    /// One picture and its processor seconds.
    pub fn draw(&self, engine: Engine, size: u32) -> (Image, f64) {
        let settings = RenderConfig { image_size: RenderSize::from(size), world_to_model: self.frustum.matrix(size) };
        match engine {
            Engine::Compiled => timed(|| draw(&self.compiled, &settings)),
            Engine::Interpreted => timed(|| draw(&self.interpreted, &settings)),
        }
    }

    /// The share of pixels that are right, against the same solid traced here.
    pub fn agreement(&self, image: &Image, size: u32) -> f64 {
        let whole = Clip::Ball(self.frustum.radius);
        let depths = ours::depths(&ours::surfaces(&self.solid, whole), &self.frustum.camera, size);
        let voxels: Vec<u32> = image.iter().map(|voxel| voxel.depth).collect();
        agreement::share(
            &depths,
            size,
            |pixel| voxels[pixel] > 0,
            |pixel, depth| {
                let (drawn, thickness) = self.frustum.depth(pixel as u32, voxels[pixel], size);
                (drawn - depth).abs() <= TOLERANCE * thickness
            },
        )
    }
}

fn draw<F: Function + RenderHints>(shape: &Shape<F>, settings: &RenderConfig) -> Image {
    let bound = BoundShape::try_from(shape.clone()).expect("formulas of x, y, z alone");
    let evaluation = EvalConfig { tile_sizes: None, threads: None, cancel: CancelToken::new() };
    render(bound, settings, &evaluation).expect("nobody cancels")
}

/// What the camera sees between two depths, as the cube of side 2 that fidget draws.
struct Frustum {
    camera: Camera,
    radius: f64,
    /// A depth d along the middle ray is 1/(mean + z·half), z from −1 (far) to 1 (near).
    mean: f64,
    half: f64,
}

impl Frustum {
    fn new(camera: Camera, radius: f64) -> Self {
        let distance = camera.eye.length();
        let near = 1.0 / (distance - radius).max(0.02 * distance);
        let far = 1.0 / (distance + radius);
        Frustum { camera, radius, mean: (near + far) / 2.0, half: (near - far) / 2.0 }
    }

    fn tangent() -> f64 {
        (FIELD_OF_VIEW / 2.0).to_radians().tan()
    }

    /// From the cube to the world. fidget samples the corners of pixels: half a pixel brings it to their centres.
    fn matrix(&self, size: u32) -> Matrix4<f32> {
        let column = |v: DVec3, w: f64| Vector4::new(v.x, v.y, v.z, w);
        let (camera, half_pixel) = (&self.camera, 1.0 / f64::from(size));
        let frame = Matrix4::from_columns(&[
            column(camera.right * Self::tangent(), 0.0),
            column(camera.up * Self::tangent(), 0.0),
            column(camera.eye * self.half, self.half),
            column(camera.forward + camera.eye * self.mean, self.mean),
        ]);
        let shift = Matrix4::new_translation(&nalgebra::Vector3::new(half_pixel, half_pixel, 0.0));
        (frame * shift).cast::<f32>()
    }

    /// Distance from the eye to a voxel's sample, and how thick the voxel is there.
    fn depth(&self, pixel: u32, voxel: u32, size: u32) -> (f64, f64) {
        let n = f64::from(size);
        let z = (f64::from(voxel) - 1.0) * 2.0 / n - 1.0;
        let along = 1.0 / (self.mean + z * self.half);
        let sx = ((f64::from(pixel % size) + 0.5) * 2.0 / n - 1.0) * Self::tangent();
        let sy = (1.0 - (f64::from(pixel / size) + 0.5) * 2.0 / n) * Self::tangent();
        let slant = (1.0 + sx * sx + sy * sy).sqrt();
        (along * slant, along * along * self.half * 2.0 / n * slant)
    }
}

/// Formulas as fidget's trees.
struct Trees;

impl Algebra for Trees {
    type Value = Tree;

    fn number(&self, value: f64) -> Tree {
        Tree::constant(value as f32)
    }

    fn coordinate(&self, axis: usize) -> Tree {
        [Tree::x, Tree::y, Tree::z][axis]()
    }

    fn negated(&self, a: Tree) -> Tree {
        a.neg()
    }

    fn plus(&self, a: Tree, b: Tree) -> Tree {
        a + b
    }

    fn minus(&self, a: Tree, b: Tree) -> Tree {
        a - b
    }

    fn times(&self, a: Tree, b: Tree) -> Tree {
        a * b
    }

    fn over(&self, a: Tree, b: Tree) -> Tree {
        a / b
    }

    fn power(&self, a: Tree, exponent: f64) -> Option<Tree> {
        (exponent.fract() == 0.0).then(|| a.pow(exponent as i64))
    }

    fn call(&self, name: &str, arguments: Vec<Tree>) -> Option<Tree> {
        let mut rest = arguments.into_iter();
        let first = rest.next()?;
        Some(match name {
            "sin" => first.sin(),
            "cos" => first.cos(),
            "exp" => first.exp(),
            "sqrt" => first.sqrt(),
            "abs" => first.abs(),
            "min" => rest.fold(first, |a, b| a.min(b)),
            "max" => rest.fold(first, |a, b| a.max(b)),
            _ => return None,
        })
    }
}
