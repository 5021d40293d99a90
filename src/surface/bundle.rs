//! The rays of a rectangle of pixels, a number of each in an array.
//!
//! In: a screen and a rectangle. Out: origins, directions and lengths. Separate from [`Ray`] because what is done to all of them becomes vector instructions.
//!
//! The rays stand in blocks of 16 x 16 pixels, row by row, and in a block by the curve that goes through all four quarters of a square
//! one after the other, and so through each of them (Morton, A Computer Oriented Geodetic Data Base, 1966): the rays of every
//! square whose side is a power of two stand together.

use super::hit::Ray;
use super::screen::{Rectangle, Screen};
use crate::num::level::{Simd, for_each_level};
use glam::DVec3;

/// A number of each ray.
pub(crate) type Column = Vec<f64>;

/// The side of a block, in pixels.
pub(crate) const BLOCK: u32 = 16;

/// The rays of a block.
const AREA: usize = (BLOCK * BLOCK) as usize;

/// Vectors may read so far beyond the last ray.
pub(crate) const BEYOND: usize = 8;

/// The pixel of a place of a block that reaches out of the rectangle.
pub(crate) const ABSENT: u32 = u32::MAX;

/// The column and the row of each place of a block, and of each smaller square.
pub(crate) const PLACES: [[f64; AREA]; 2] = places();

/// All rays of a rectangle.
#[derive(Debug, Default)]
pub(crate) struct Bundle {
    /// Where each starts.
    pub(crate) origin: [Column; 3],
    /// Where each goes, of length 1.
    pub(crate) direction: [Column; 3],
    /// How much longer its way is than its depth.
    pub(crate) length: Column,
    /// Which pixel of the rectangle, row by row, it goes through.
    pub(crate) pixel: Vec<u32>,
    /// Pixels across and down.
    pub(super) size: [u32; 2],
}

/// The rays that are asked about, by their numbers.
#[derive(Clone, Copy)]
pub(crate) enum Asked<'a> {
    List(&'a [Ray]),
    /// The pixels of a rectangle, row by row.
    Bundle(&'a Bundle),
}

const fn places() -> [[f64; AREA]; 2] {
    let mut places = [[0.0; AREA]; 2];
    let mut k = 0;
    while k < AREA {
        let [mut column, mut row] = [0, 0];
        let mut bit = 0;
        while 1 << bit < BLOCK {
            column |= (k >> (2 * bit) & 1) << bit;
            row |= (k >> (2 * bit + 1) & 1) << bit;
            bit += 1;
        }
        (places[0][k], places[1][k]) = (column as f64, row as f64);
        k += 1;
    }
    places
}

impl Bundle {
    /// Takes the rays through the centres of a rectangle's pixels.
    pub(crate) fn fill(&mut self, screen: &Screen, rectangle: Rectangle, simd: Simd) {
        self.arrange([rectangle.width, rectangle.height]);
        fill(simd, self, screen, [rectangle.left, rectangle.top]);
    }

    /// Makes room for a rectangle of this size, and says which ray is where.
    fn arrange(&mut self, size: [u32; 2]) {
        if self.size == size {
            return;
        }
        self.size = size;
        let [across, down] = size.map(|side| side.div_ceil(BLOCK));
        let count = (across * down) as usize * AREA;
        let columns = self.origin.iter_mut().chain(&mut self.direction);
        for column in columns.chain([&mut self.length]) {
            // What is beyond the last ray is read, but never looked at.
            column.resize(count + BEYOND, 1.0);
        }
        self.pixel.clear();
        for block in 0..across * down {
            let corner = [block % across * BLOCK, block / across * BLOCK];
            self.pixel.extend((0..AREA).map(|k| {
                let [i, j] = [corner[0] + PLACES[0][k] as u32, corner[1] + PLACES[1][k] as u32];
                if i < size[0] && j < size[1] { j * size[0] + i } else { ABSENT }
            }));
        }
    }

    /// Where the rays of a square stand whose corner is pixel (i, j) of the rectangle, both multiples of its side.
    pub(crate) fn first(&self, [i, j]: [u32; 2]) -> usize {
        let block = (j / BLOCK * self.size[0].div_ceil(BLOCK) + i / BLOCK) as usize;
        let spread = |c: u32| (0..BLOCK.ilog2()).map(|bit| (c >> bit & 1) << (2 * bit)).sum::<u32>() as usize;
        block * AREA + spread(i % BLOCK) + 2 * spread(j % BLOCK)
    }

    /// Where the ray through a pixel stands.
    pub(crate) fn place_of(&self, pixel: u32) -> usize {
        self.first([pixel % self.size[0], pixel / self.size[0]])
    }

    /// The ray at a place.
    pub(crate) fn ray(&self, place: usize) -> Ray {
        let of = |columns: &[Column; 3]| DVec3::new(columns[0][place], columns[1][place], columns[2][place]);
        Ray::new(of(&self.origin), of(&self.direction))
    }

    /// All rays, row by row of pixels; what `rays` held is gone.
    pub(crate) fn list(&self, rays: &mut Vec<Ray>) {
        rays.clear();
        rays.resize(self.size[0] as usize * self.size[1] as usize, Ray::new(DVec3::ZERO, DVec3::ZERO));
        for (place, &pixel) in self.pixel.iter().enumerate() {
            if pixel != ABSENT {
                rays[pixel as usize] = self.ray(place);
            }
        }
    }
}

impl Asked<'_> {
    /// How many there are.
    pub(crate) fn len(self) -> usize {
        match self {
            Asked::List(rays) => rays.len(),
            Asked::Bundle(bundle) => bundle.size[0] as usize * bundle.size[1] as usize,
        }
    }

    /// One of them.
    pub(crate) fn ray(self, number: u32) -> Ray {
        match self {
            Asked::List(rays) => rays[number as usize],
            Asked::Bundle(bundle) => bundle.ray(bundle.place_of(number)),
        }
    }
}

for_each_level! {
    fn fill[L](bundle: &mut Bundle, screen: &Screen, corner: [u32; 2]) {
        let across = bundle.size[0].div_ceil(BLOCK) as usize;
        let [ox, oy, oz] = &mut bundle.origin;
        let [dx, dy, dz] = &mut bundle.direction;
        for block in 0..bundle.pixel.len() / AREA {
            let rays = block * AREA..(block + 1) * AREA;
            let (ox, oy, oz) = (&mut ox[rays.clone()], &mut oy[rays.clone()], &mut oz[rays.clone()]);
            let (dx, dy, dz) = (&mut dx[rays.clone()], &mut dy[rays.clone()], &mut dz[rays.clone()]);
            let length = &mut bundle.length[rays];
            let [left, top] = [block % across, block / across].map(|at| at as f64 * f64::from(BLOCK));
            let (left, top) = (f64::from(corner[0]) + left, f64::from(corner[1]) + top);
            for i in 0..AREA {
                let sx = screen.first[0] + (left + PLACES[0][i]) * screen.step[0];
                let sy = screen.first[1] + (top + PLACES[1][i]) * screen.step[1];
                if screen.is_parallel {
                    ox[i] = (screen.eye.x + screen.up.x * sy) + screen.right.x * sx;
                    oy[i] = (screen.eye.y + screen.up.y * sy) + screen.right.y * sx;
                    oz[i] = (screen.eye.z + screen.up.z * sy) + screen.right.z * sx;
                    (dx[i], dy[i], dz[i], length[i]) = (screen.forward.x, screen.forward.y, screen.forward.z, 1.0);
                } else {
                    let x = (screen.forward.x + screen.up.x * sy) + screen.right.x * sx;
                    let y = (screen.forward.y + screen.up.y * sy) + screen.right.y * sx;
                    let z = (screen.forward.z + screen.up.z * sy) + screen.right.z * sx;
                    let long = (x * x + y * y + z * z).sqrt();
                    (ox[i], oy[i], oz[i]) = (screen.eye.x, screen.eye.y, screen.eye.z);
                    (dx[i], dy[i], dz[i], length[i]) = (x / long, y / long, z / long, long);
                }
            }
        }
    }
}
