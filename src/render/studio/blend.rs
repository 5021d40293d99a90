//! Light shared between neighbours on one piece of surface.
//!
//! In: what the rays through the centres of a tile and of the pixels around it remember. Out: the light at a point of
//! the surface, the mean of its neighbours' within two pixels. Every 4 × 4 pixels have all patterns of rays, and the
//! window is four pixels wide wherever its middle is, so that on a smooth surface the mean has no noise.

use super::glimpse::{Glimpse, Light, Remembered, point};
use crate::film::Layer;
use crate::scene::Camera;
use glam::{DVec3, Vec3};

/// How far the window reaches to each side of its middle's pixel.
pub const REACH: u32 = 2;

/// The cosine at which neighbours' normals are too different, and at which they are near enough to count fully.
const NORMALS: [f32; 2] = [0.55, 0.92];

/// How far from the tangent plane, in pixels, a neighbour may be.
const FLATNESS: f64 = 3.0;

/// The least weight, of 16, on which a mean is trusted.
const LEAST_WEIGHT: f32 = 1.5;

/// The pixels of a tile and those within [`REACH`] around it.
#[derive(Debug, Default)]
pub struct Window {
    left: u32,
    top: u32,
    width: u32,
    remembered: Vec<Remembered>,
    points: Vec<DVec3>,
}

impl Window {
    /// Looks at the pixels `left..left + width`, `top..top + height` and around them.
    pub fn look(&mut self, camera: &Camera, memory: &Layer<Remembered>, [left, top, width, height]: [u32; 4]) {
        let size = memory.size;
        (self.left, self.top) = (left.saturating_sub(REACH), top.saturating_sub(REACH));
        let right = (left + width + REACH).min(size.width());
        let bottom = (top + height + REACH).min(size.height());
        self.width = right - self.left;
        self.remembered.clear();
        self.points.clear();
        for j in self.top..bottom {
            for i in self.left..right {
                let kept = memory.at(i, j);
                let place = (f64::from(i) + 0.5, f64::from(j) + 0.5);
                self.points.push(if kept.glimpse.is_drawn() {
                    point(&camera.ray(size.width(), size.height(), place.0, place.1), &kept.glimpse)
                } else {
                    DVec3::ZERO
                });
                self.remembered.push(kept);
            }
        }
    }

    /// What the centre of pixel (i, j) remembers.
    pub fn at(&self, i: u32, j: u32) -> &Remembered {
        &self.remembered[((j - self.top) * self.width + (i - self.left)) as usize]
    }

    /// The light at a point of the surface seen at `place` in the picture, where a pixel is `footprint` wide in the world;
    /// `None` if too few neighbours are on the same piece of surface.
    pub fn light(&self, place: [f64; 2], at: DVec3, glimpse: &Glimpse, footprint: f64) -> Option<Light> {
        if self.remembered.is_empty() {
            return None;
        }
        let (across, down) = (Span::around(place[0], self.left, self.width), self.span_down(place[1]));
        let mut sum = Sum::default();
        for (j, down) in down.pixels() {
            let row = (j * self.width) as usize;
            for (i, across) in across.pixels() {
                let k = row + i as usize;
                let kept = &self.remembered[k];
                if kept.glimpse.side == glimpse.side {
                    let weight = across * down * likeness(glimpse, at, &kept.glimpse, self.points[k], footprint);
                    sum.add(weight, &kept.light());
                }
            }
        }
        (sum.weight >= LEAST_WEIGHT).then(|| sum.mean())
    }

    fn span_down(&self, place: f64) -> Span {
        Span::around(place, self.top, self.remembered.len() as u32 / self.width)
    }
}

/// How much two points are of one piece of surface, of 0..=1.
fn likeness(a: &Glimpse, at: DVec3, b: &Glimpse, other: DVec3, footprint: f64) -> f32 {
    let turned = ((a.normal.dot(b.normal) - NORMALS[0]) / (NORMALS[1] - NORMALS[0])).clamp(0.0, 1.0);
    let away = (a.normal.as_dvec3().dot(other - at) / (FLATNESS * footprint)) as f32;
    let flat = (1.0 - away * away).max(0.0);
    turned * flat
}

/// Pixels of a row or column with the share of each in a window four pixels wide.
struct Span {
    first: u32,
    shares: [f32; 5],
    inside: [bool; 5],
}

impl Span {
    fn around(place: f64, start: u32, length: u32) -> Self {
        let middle = place.floor();
        let offset = (place - middle - 0.5) as f32;
        let shares = [0.5 - offset, 1.0, 1.0, 1.0, 0.5 + offset];
        let first = middle as i64 - i64::from(REACH) - i64::from(start);
        let inside = std::array::from_fn(|n| (0..i64::from(length)).contains(&(first + n as i64)));
        Span { first: first as u32, shares, inside }
    }

    fn pixels(&self) -> impl Iterator<Item = (u32, f32)> {
        (0..5).filter(|&n| self.inside[n as usize]).map(|n| (self.first.wrapping_add(n), self.shares[n as usize]))
    }
}

#[derive(Default)]
struct Sum {
    weight: f32,
    key: f32,
    open: f32,
    hidden_height: f32,
    bounce: Vec3,
}

impl Sum {
    fn add(&mut self, weight: f32, light: &Light) {
        self.weight += weight;
        self.key += weight * light.key;
        self.open += weight * light.open;
        self.hidden_height += weight * light.hidden_height;
        self.bounce += light.bounce * weight;
    }

    fn mean(&self) -> Light {
        let share = 1.0 / self.weight;
        Light {
            key: self.key * share,
            open: self.open * share,
            hidden_height: self.hidden_height * share,
            bounce: self.bounce * share,
        }
    }
}
