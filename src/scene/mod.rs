//! What there is to see, and from where.
//!
//! In: what the program and the command line say of the view, and which boxes are proven empty. Out: the camera, the
//! colours of the surfaces' two sides, the lights. Separate from drawing, because every way of drawing looks at the
//! same scene.
//!
//! - `angle`: degrees.
//! - [`camera`]: the ray of a pixel.
//! - [`cells`]: boxes that may hold a surface, and how far they reach.
//! - [`colour`]: sRGB as linear light; the palette.
//! - [`fit`]: where the eye stands so that what there is to see fills the picture.
//! - [`framing`]: the ball around what there is to see.
//! - [`light`]: the lights of a scene without lights.
//! - [`view`]: what was asked of the camera, and the camera that it means.

pub mod angle;
pub mod camera;
pub mod cells;
pub mod colour;
pub mod fit;
pub mod framing;
pub mod light;
pub mod view;

pub use camera::{Camera, CameraError, Projection};
pub use colour::Sides;
pub use framing::Framing;
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
    /// The middle of what is seen.
    pub center: DVec3,
    /// How far from there it reaches.
    pub radius: f64,
}
