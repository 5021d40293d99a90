//! The rays of a rectangle of pixels, a number of each in an array.
//!
//! In: a screen and a rectangle. Out: origins, directions and lengths, and between which distances each ray is inside the
//! clip. Separate from [`Ray`] because what is done to all of them becomes vector instructions.

use super::hit::Ray;
use super::region::{self, Shape};
use super::screen::{Rectangle, Screen};
use crate::num::level::{Simd, for_each_level};
use glam::DVec3;

/// A number of each ray.
pub(crate) type Column = Vec<f64>;

/// All rays of a rectangle, row by row.
#[derive(Debug, Default)]
pub(crate) struct Bundle {
    /// Where each starts.
    pub(crate) origin: [Column; 3],
    /// Where each goes, of length 1.
    pub(crate) direction: [Column; 3],
    /// How much longer its way is than its depth.
    pub(crate) length: Column,
    /// The same rays one by one.
    pub(crate) rays: Vec<Ray>,
}

/// Where each ray of a bundle enters what is looked at, and where it leaves it: upside down if it never does.
#[derive(Debug, Default)]
pub(crate) struct Spans {
    pub(crate) near: Column,
    pub(crate) far: Column,
}

impl Bundle {
    /// Takes the rays through the centres of a rectangle's pixels.
    pub(crate) fn fill(&mut self, screen: &Screen, rectangle: Rectangle, simd: Simd) {
        let count = rectangle.width as usize * rectangle.height as usize;
        let columns = self.origin.iter_mut().chain(&mut self.direction);
        for column in columns.chain([&mut self.length]) {
            column.resize(count, 0.0);
        }
        fill(simd, self, screen, rectangle);
        self.rays.clear();
        let [ox, oy, oz] = &self.origin;
        let [dx, dy, dz] = &self.direction;
        self.rays
            .extend((0..count).map(|i| Ray::new(DVec3::new(ox[i], oy[i], oz[i]), DVec3::new(dx[i], dy[i], dz[i]))));
    }
}

impl Spans {
    /// What of each ray is inside all shapes, at least `least` from its start.
    pub(crate) fn fill(&mut self, bundle: &Bundle, shapes: &[Shape], least: f64, simd: Simd) {
        for (column, value) in [(&mut self.near, least), (&mut self.far, f64::INFINITY)] {
            column.clear();
            column.resize(bundle.length.len(), value);
        }
        for shape in shapes {
            cut(simd, self, bundle, shape);
        }
    }
}

for_each_level! {
    fn fill[L](bundle: &mut Bundle, screen: &Screen, rectangle: Rectangle) {
        let width = rectangle.width as usize;
        let [ox, oy, oz] = &mut bundle.origin;
        let [dx, dy, dz] = &mut bundle.direction;
        for j in 0..rectangle.height {
            let row = j as usize * width;
            let row = row..row + width;
            let sy = screen.first[1] + f64::from(rectangle.top + j) * screen.step[1];
            let start = screen.forward + screen.up * sy;
            let (ox, oy, oz) = (&mut ox[row.clone()], &mut oy[row.clone()], &mut oz[row.clone()]);
            let (dx, dy, dz) = (&mut dx[row.clone()], &mut dy[row.clone()], &mut dz[row.clone()]);
            let length = &mut bundle.length[row];
            let first = f64::from(rectangle.left);
            if screen.is_parallel {
                let corner = screen.eye + screen.up * sy;
                for i in 0..width {
                    let sx = screen.first[0] + (first + i as f64) * screen.step[0];
                    ox[i] = corner.x + screen.right.x * sx;
                    oy[i] = corner.y + screen.right.y * sx;
                    oz[i] = corner.z + screen.right.z * sx;
                    (dx[i], dy[i], dz[i], length[i]) = (screen.forward.x, screen.forward.y, screen.forward.z, 1.0);
                }
            } else {
                for i in 0..width {
                    let sx = screen.first[0] + (first + i as f64) * screen.step[0];
                    let (x, y, z) = (
                        start.x + screen.right.x * sx,
                        start.y + screen.right.y * sx,
                        start.z + screen.right.z * sx,
                    );
                    let long = (x * x + y * y + z * z).sqrt();
                    (ox[i], oy[i], oz[i]) = (screen.eye.x, screen.eye.y, screen.eye.z);
                    (dx[i], dy[i], dz[i], length[i]) = (x / long, y / long, z / long, long);
                }
            }
        }
    }
}

for_each_level! {
    fn cut[L](spans: &mut Spans, bundle: &Bundle, shape: &Shape) {
        let Spans { near, far } = spans;
        let Bundle { origin: [ox, oy, oz], direction: [dx, dy, dz], .. } = bundle;
        let n = near.len();
        let (ox, oy, oz, dx, dy, dz) = (&ox[..n], &oy[..n], &oz[..n], &dx[..n], &dy[..n], &dz[..n]);
        let far = &mut far[..n];
        for i in 0..n {
            let (o, d) = ([ox[i], oy[i], oz[i]], [dx[i], dy[i], dz[i]]);
            let (a, b) = region::shape_span(shape, o, d);
            near[i] = if a > near[i] { a } else { near[i] };
            far[i] = if b < far[i] { b } else { far[i] };
        }
    }
}
