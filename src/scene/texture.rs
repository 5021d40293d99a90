//! Colours and other values that may change from point to point of a surface.
//!
//! In: points. Out: three numbers at each.

use glam::DVec3;

/// Three numbers at every point.
#[derive(Clone, Debug)]
pub enum Texture {
    /// The same everywhere.
    Constant(DVec3),
}

impl Texture {
    /// The value, if it is the same everywhere.
    pub fn constant(&self) -> Option<DVec3> {
        match self {
            Texture::Constant(value) => Some(*value),
        }
    }

    /// The values at these points of the surface; `out` is replaced. What has no value is 0.
    pub fn values(&self, points: &[DVec3], out: &mut Vec<DVec3>) {
        out.clear();
        match self {
            Texture::Constant(value) => out.resize(points.len(), *value),
        }
    }
}
