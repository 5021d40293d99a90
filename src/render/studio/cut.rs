//! Where the clip cuts a surface off: a thin line, so that an edge made by the clip is told from one of the surface.
//!
//! In: a point of a surface and the shapes that clip it. Out: how much of the line is there.

use crate::surface::Shape;
use glam::DVec3;

/// The line's width in pixels.
const WIDTH: f64 = 2.0;

/// Less than this sine of the angle between surface and clip, and the surface lies along the clip: no line.
const ALONG: f64 = 0.05;

/// The line's share at a point of a surface of normal n, of 0..=1; a pixel is `footprint` wide there.
pub fn line(shapes: &[Shape], at: DVec3, n: DVec3, footprint: f64) -> f64 {
    let width = WIDTH * footprint;
    let mut most = 0.0f64;
    for shape in shapes {
        match *shape {
            Shape::Ball { center, radius } => {
                let from_center = at - center;
                let distance = from_center.length();
                most = most.max(share(radius - distance, from_center / distance, n, width));
            }
            Shape::Box { min, max } => {
                for (axis, wall) in DVec3::AXES.into_iter().enumerate() {
                    let inside = (at[axis] - min[axis]).min(max[axis] - at[axis]);
                    most = most.max(share(inside, wall, n, width));
                }
            }
        }
    }
    most
}

/// By the distance to a wall of normal `wall`, measured along the surface.
fn share(distance: f64, wall: DVec3, n: DVec3, width: f64) -> f64 {
    let sine = n.cross(wall).length();
    let fall = distance.max(0.0) / (sine * width);
    if sine > ALONG && fall < 1.0 { 1.0 - fall * fall } else { 0.0 }
}
