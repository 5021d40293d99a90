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

    /// Whether a point is inside or on the boundary.
    pub fn contains(&self, point: DVec3) -> bool {
        match *self {
            Shape::Box { min, max } => point.cmpge(min).all() && point.cmple(max).all(),
            Shape::Ball { center, radius } => point.distance(center) <= radius,
        }
    }

    /// The distances between which the ray is inside, t ≥ 0; `None` if it never is.
    pub fn span(&self, ray: &Ray) -> Option<(f64, f64)> {
        let (t0, t1) = shape_span(self, ray.origin.to_array(), ray.direction.to_array());
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

/// The distances between which a line is inside; the first is larger than the second if it never is.
#[inline(always)]
pub(crate) fn shape_span(shape: &Shape, origin: [f64; 3], direction: [f64; 3]) -> (f64, f64) {
    match *shape {
        Shape::Box { min, max } => box_span(origin, direction, min.to_array(), max.to_array()),
        Shape::Ball { center, radius } => ball_span(origin, direction, center.to_array(), radius),
    }
}

const NEVER: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);

/// The slab method (Kay and Kajiya 1986).
#[inline(always)]
fn box_span(origin: [f64; 3], direction: [f64; 3], min: [f64; 3], max: [f64; 3]) -> (f64, f64) {
    let (mut t0, mut t1) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let (o, d) = (origin[axis], direction[axis]);
        let (a, b) = ((min[axis] - o) / d, (max[axis] - o) / d);
        let (first, last) = if a < b { (a, b) } else { (b, a) };
        let inside = (o >= min[axis]) & (o <= max[axis]);
        // A line along the slab is inside always or never.
        let first = if d != 0.0 {
            first
        } else if inside {
            f64::NEG_INFINITY
        } else {
            NEVER.0
        };
        let last = if d != 0.0 {
            last
        } else if inside {
            f64::INFINITY
        } else {
            NEVER.1
        };
        t0 = if first > t0 { first } else { t0 };
        t1 = if last < t1 { last } else { t1 };
    }
    (t0, t1)
}

/// Both roots of the quadratic, measured from the point nearest to the centre so that nothing cancels.
#[inline(always)]
fn ball_span(origin: [f64; 3], direction: [f64; 3], center: [f64; 3], radius: f64) -> (f64, f64) {
    let to = [center[0] - origin[0], center[1] - origin[1], center[2] - origin[2]];
    let middle = to[0] * direction[0] + to[1] * direction[1] + to[2] * direction[2];
    let off = [to[0] - direction[0] * middle, to[1] - direction[1] * middle, to[2] - direction[2] * middle];
    let half_squared = radius * radius - (off[0] * off[0] + off[1] * off[1] + off[2] * off[2]);
    let half = half_squared.sqrt();
    let meets = half_squared >= 0.0;
    (if meets { middle - half } else { NEVER.0 }, if meets { middle + half } else { NEVER.1 })
}
