//! The lights a scene has when nobody gave it any.
//!
//! In: the camera. Out: directions towards far lights. They follow the camera, so that what is seen is lit.

use super::camera::Camera;
use glam::DVec3;

/// Towards the light over the camera's left shoulder, of the modes that teach.
pub fn shoulder(camera: &Camera) -> DVec3 {
    (camera.right * -0.4 + camera.up * 0.5 - camera.forward).normalize()
}

/// Towards the key light of the studio: from the upper left, far enough aside that forms turn into shade.
pub fn key(camera: &Camera) -> DVec3 {
    (camera.right * -0.55 + camera.up * 0.8 - camera.forward * 0.65).normalize()
}
