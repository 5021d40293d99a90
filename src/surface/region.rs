//! The clip: what part of space is seen, and what part of a ray is in it.

use super::hit::Ray;
use crate::expr::graph::NodeId;
use glam::DVec3;

/// A convex piece of space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// min ≤ (x, y, z) ≤ max.
    Box {
        /// The least corner.
        min: DVec3,
        /// The greatest corner.
        max: DVec3,
    },
    /// At most `radius` from `center`.
    Ball {
        /// The centre.
        center: DVec3,
        /// The radius.
        radius: f64,
    },
}

/// The part of space in which a surface is seen: what is in all shapes and where all fields are ≤ 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clip {
    /// Boxes and balls; empty: everywhere.
    pub shapes: Vec<Shape>,
    /// Regions written as formulas, negative inside.
    pub fields: Vec<NodeId>,
}

impl Shape {
    /// The middle.
    pub fn center(&self) -> DVec3 {
        match *self {
            Shape::Box { min, max } => (min + max) * 0.5,
            Shape::Ball { center, .. } => center,
        }
    }

    /// Half the diagonal, or the radius: the length that tolerances are measured by.
    pub fn size(&self) -> f64 {
        match *self {
            Shape::Box { min, max } => (max - min).length() * 0.5,
            Shape::Ball { radius, .. } => radius,
        }
    }

    /// The distances between which the ray is inside, t ≥ 0; `None` if it never is.
    pub fn span(&self, ray: &Ray) -> Option<(f64, f64)> {
        let (t0, t1) = match *self {
            Shape::Box { min, max } => box_span(ray, min, max)?,
            Shape::Ball { center, radius } => ball_span(ray, center, radius)?,
        };
        let t0 = t0.max(0.0);
        (t0 <= t1).then_some((t0, t1))
    }
}

impl Clip {
    /// One shape and no more.
    pub fn shape(shape: Shape) -> Self {
        Clip { shapes: vec![shape], fields: Vec::new() }
    }

    /// The size of the smallest shape: the length that tolerances are measured by; 1 without any.
    pub fn size(&self) -> f64 {
        self.shapes.iter().map(Shape::size).reduce(f64::min).unwrap_or(1.0)
    }

    /// The distances between which the ray is inside all shapes; `None` if it never is.
    pub fn span(&self, ray: &Ray) -> Option<(f64, f64)> {
        span(&self.shapes, ray)
    }
}

/// The distances between which the ray is inside all shapes; `None` if it never is.
pub(crate) fn span(shapes: &[Shape], ray: &Ray) -> Option<(f64, f64)> {
    let (mut t0, mut t1) = (0.0f64, f64::INFINITY);
    for shape in shapes {
        let (a, b) = shape.span(ray)?;
        (t0, t1) = (t0.max(a), t1.min(b));
    }
    (t0 <= t1).then_some((t0, t1))
}

/// The slab method (Kay and Kajiya 1986).
fn box_span(ray: &Ray, min: DVec3, max: DVec3) -> Option<(f64, f64)> {
    let (mut t0, mut t1) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let (o, d) = (ray.origin[axis], ray.direction[axis]);
        if d == 0.0 {
            if o < min[axis] || o > max[axis] {
                return None;
            }
            continue;
        }
        let (a, b) = ((min[axis] - o) / d, (max[axis] - o) / d);
        t0 = t0.max(a.min(b));
        t1 = t1.min(a.max(b));
    }
    Some((t0, t1))
}

/// Both roots of the quadratic, measured from the point nearest to the centre so that nothing cancels.
fn ball_span(ray: &Ray, center: DVec3, radius: f64) -> Option<(f64, f64)> {
    let to_center = center - ray.origin;
    let middle = to_center.dot(ray.direction);
    let nearest = to_center - ray.direction * middle;
    let half_squared = radius * radius - nearest.length_squared();
    if half_squared < 0.0 {
        return None;
    }
    let half = half_squared.sqrt();
    Some((middle - half, middle + half))
}
