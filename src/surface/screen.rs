//! The rays of a picture, as a whole: what lets many of them be settled at once.
//!
//! In: an eye with its frame and its pixels. Out: where the rays of a square of pixels are between two depths, as affine
//! forms of (across, down, along). Separate from [`super::Ray`] because these know what rays have in common.

use super::bundle::Bundle;
use super::hit::Ray;
use super::tile::{FORMS, Forms};
use crate::num::level::{Simd, for_each_level};
use glam::DVec3;

/// The rays through the pixels of a picture: through (i, j) it goes along forward + sx·right + sy·up, with
/// sx = first\[0\] + i·step\[0\] and sy = first\[1\] + j·step\[1\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Screen {
    /// Where the rays leave from; with parallel rays, those of sx = sy = 0.
    pub eye: DVec3,
    /// The direction in the middle, of length 1.
    pub forward: DVec3,
    /// To the right, of length 1, across `forward`.
    pub right: DVec3,
    /// Upward, of length 1, across both.
    pub up: DVec3,
    /// Whether all rays go forward, from eye + sx·right + sy·up.
    pub is_parallel: bool,
    /// (sx, sy) of the first pixel's centre.
    pub first: [f64; 2],
    /// What a pixel adds to them.
    pub step: [f64; 2],
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rectangle {
    /// Pixels from the picture's left edge.
    pub left: u32,
    /// Pixels from its upper edge.
    pub top: u32,
    /// Pixels across, > 0.
    pub width: u32,
    /// Pixels down, > 0.
    pub height: u32,
}

impl Rectangle {
    /// Whether the two have a pixel in common.
    pub(crate) fn meets(self, other: Rectangle) -> bool {
        let meet = |a: u32, width: u32, b: u32, other: u32| a < b + other && b < a + width;
        meet(self.left, self.width, other.left, other.width) && meet(self.top, self.height, other.top, other.height)
    }

    /// Squares of this side that it consists of, those at its ends smaller, counted from its corner.
    pub(crate) fn parts(self, side: u32) -> impl Iterator<Item = Rectangle> {
        let starts = move |length: u32| (0..length).step_by(side as usize);
        starts(self.height).flat_map(move |top| {
            starts(self.width).map(move |left| Rectangle {
                left,
                top,
                width: side.min(self.width - left),
                height: side.min(self.height - top),
            })
        })
    }
}

/// What sx and sy may be off by rounding, as a part of the largest of them in the picture; a thousand times too much.
const ROUNDED: f64 = 1e-13;

/// Squares of pixels between two depths, a number of each in an array.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    /// The first pixel of each, across and down, and the first depth.
    pub(crate) start: [[f64; FORMS]; 3],
    /// The last of all three.
    pub(crate) last: [[f64; FORMS]; 3],
}

impl Default for Places {
    fn default() -> Self {
        Places { start: [[0.0; FORMS]; 3], last: [[0.0; FORMS]; 3] }
    }
}

impl Screen {
    /// The rays through the centres of a rectangle's pixels, row by row; what `rays` held is gone.
    pub fn rays(&self, rectangle: Rectangle, rays: &mut Vec<Ray>) {
        let mut bundle = Bundle::default();
        bundle.fill(self, rectangle, Simd::Portable);
        bundle.list(rays);
    }

    /// The width of so many pixels at a depth.
    pub(crate) fn width_at(&self, pixels: u32, depth: f64) -> f64 {
        let width = f64::from(pixels) * self.step[0].abs();
        if self.is_parallel { width } else { width * depth }
    }
}

/// Puts the points of rectangles, each between two depths, into the registers: at most as many as there are lanes, which are at least
/// one; lanes that are left repeat the first.
pub(crate) fn place_cells(simd: Simd, screen: &Screen, cells: &[(Rectangle, (f64, f64))], forms: &mut [Forms]) {
    let mut places = Places::default();
    for i in 0..FORMS {
        let (Rectangle { left, top, width, height }, (a, end)) = cells[if i < cells.len() { i } else { 0 }];
        let [start, last] = [[left, top], [left + width - 1, top + height - 1]].map(|pixel| pixel.map(f64::from));
        for axis in 0..2 {
            (places.start[axis][i], places.last[axis][i]) = (start[axis], last[axis]);
        }
        // The ends of cells overlap by more than they are rounded.
        (places.start[2][i], places.last[2][i]) = (a, end + 2.0 * ROUNDED * end);
    }
    place_forms(simd, screen, &places, forms);
}

for_each_level! {
    /// Puts the points of each place into the registers of the coordinates, and the ways along the rays behind them.
    pub(crate) fn place_forms[L](screen: &Screen, places: &Places, forms: &mut [Forms]) {
        /// 2^-48 and 2^-50: what the points of a ray are off by rounding, as parts of the distance and of the eye's place.
        const PER_DISTANCE: f64 = 1.0 / (1u64 << 48) as f64;
        const PER_ORIGIN: f64 = 1.0 / (1u64 << 50) as f64;
        let Places { start, last } = places;
        let (mut middle, mut half) = ([[0.0; FORMS]; 3], [[0.0; FORMS]; 3]);
        for axis in 0..2 {
            let (first, step) = (screen.first[axis], screen.step[axis]);
            let rounded = ROUNDED * (screen.first[0].abs() + screen.first[1].abs() + screen.step[0].abs());
            for i in 0..FORMS {
                let (p, q) = (first + start[axis][i] * step, first + last[axis][i] * step);
                middle[axis][i] = 0.5 * (p + q);
                half[axis][i] = 0.5 * (q - p).abs() + rounded;
            }
        }
        for i in 0..FORMS {
            middle[2][i] = 0.5 * (start[2][i] + last[2][i]);
            half[2][i] = 0.5 * (last[2][i] - start[2][i]);
        }
        let ([u, v, s], [hu, hv, hs]) = (&middle, &half);
        for axis in 0..3 {
            let (o, f, r, t) = (screen.eye[axis], screen.forward[axis], screen.right[axis], screen.up[axis]);
            let [point, way] = forms.get_disjoint_mut([axis, axis + 3]).expect("two registers");
            for i in 0..FORMS {
                let (across, down) = (r * hu[i], t * hv[i]);
                let aside = r * u[i] + t * v[i];
                let far = s[i] + hs[i];
                let rounding = PER_DISTANCE * (far * (2.0 + u[i].abs() + v[i].abs())) + PER_ORIGIN * o.abs();
                let spread = across.abs() + down.abs();
                if screen.is_parallel {
                    point.center[i] = o + aside + f * s[i];
                    point.slope[0][i] = across;
                    point.slope[1][i] = down;
                    point.slope[2][i] = f * hs[i];
                    point.error[i] = rounding + PER_DISTANCE * (aside.abs() + spread);
                    way.center[i] = f;
                    way.slope[0][i] = 0.0;
                    way.slope[1][i] = 0.0;
                    way.error[i] = PER_DISTANCE;
                } else {
                    let d = f + aside;
                    point.center[i] = o + s[i] * d;
                    point.slope[0][i] = s[i] * across;
                    point.slope[1][i] = s[i] * down;
                    point.slope[2][i] = hs[i] * d;
                    point.error[i] = hs[i] * spread + rounding;
                    way.center[i] = d;
                    way.slope[0][i] = across;
                    way.slope[1][i] = down;
                    way.error[i] = PER_DISTANCE * (2.0 + u[i].abs() + v[i].abs());
                }
                way.slope[2][i] = 0.0;
            }
            point.flags = [0; FORMS];
            way.flags = [0; FORMS];
        }
    }
}
