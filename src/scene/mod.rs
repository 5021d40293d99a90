//! What there is to see, and from where.
//!
//! In: what the program and the command line say of the view, and which boxes are proven empty. Out: the camera, the
//! colours of the surfaces' two sides, the lights. Separate from drawing, because every way of drawing looks at the
//! same scene.
//!
//! - `angle`: degrees.
//! - [`camera`]: the ray of a pixel.
//! - [`cells`]: boxes that may hold a surface; `extreme`: how far they reach.
//! - [`colour`]: sRGB as linear light; the palette.
//! - [`fit`]: where the eye stands so that what there is to see fills the picture.
//! - [`framing`]: the ball around what there is to see.
//! - [`light`]: lights and surroundings; [`daylight`]: the clear sky.
//! - [`material`]: what surfaces are made of; [`metals`]: measured ones; [`texture`]: colours that change from point to point; [`palette`]:
//!   maps of colours.
//! - [`slab`]: where in a box a surface can be.
//! - [`studio`]: the lights of a scene without lights.
//! - [`view`]: what was asked of the camera, and the camera that it means.

pub mod angle;
pub mod camera;
pub mod cells;
pub mod colour;
pub mod daylight;
mod extreme;
pub mod fit;
pub mod framing;
pub mod light;
pub mod material;
pub mod metals;
pub mod palette;
pub mod slab;
pub mod studio;
pub mod texture;
pub mod view;

pub use camera::{Camera, CameraError, Projection};
pub use colour::Sides;
pub use framing::Framing;
pub use light::{Light, Sky};
pub use material::Material;
pub use texture::Texture;
pub use view::{Orbit, View};

use crate::surface::Shape;
use glam::DVec3;

/// All that drawing needs to know besides where the surfaces are.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The eye.
    pub camera: Camera,
    /// The point it looks at.
    pub look_at: DVec3,
    /// The colours of each surface, in the surfaces' order.
    pub sides: Vec<Sides>,
    /// The shapes that cut each surface off, in the surfaces' order.
    pub clips: Vec<Vec<Shape>>,
    /// A ball around what is seen of each surface, in the surfaces' order: its middle and its radius.
    pub bounds: Vec<(DVec3, f64)>,
    /// What each surface is made of, in the surfaces' order.
    pub materials: Vec<Material>,
    /// The lights that are no surfaces.
    pub lights: Vec<Light>,
    /// What is seen where there is nothing; `None`: darkness.
    pub sky: Option<Sky>,
    /// The middle of what is seen.
    pub center: DVec3,
    /// How far from there it reaches.
    pub radius: f64,
}

impl Scene {
    /// Draws the balls closer around surfaces that glow: light is sought all over them. `classify` says of a surface what is proven of a
    /// box; it need not know the balls.
    pub fn tighten(&mut self, classify: impl Fn(usize, &[cells::Cube], &mut [cells::Cell])) {
        let glowing = (0..self.materials.len()).filter(|&surface| self.materials[surface].is_glowing());
        for surface in glowing {
            let (center, radius) = self.bounds[surface];
            let whole = [center - DVec3::splat(radius), center + DVec3::splat(radius)];
            let closer = cells::ball_around(&|cubes, found| classify(surface, cubes, found), whole[0], whole[1]);
            if let Some(ball) = closer.filter(|ball| ball.1 < radius) {
                self.bounds[surface] = ball;
            }
        }
    }
}
