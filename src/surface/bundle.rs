//! The rays of a rectangle of pixels, a number of each in an array.
//!
//! In: a screen and a rectangle. Out: origins, directions and lengths, and between which distances each ray is inside the
//! clip. Separate from [`Ray`] because what is done to all of them becomes vector instructions.
//!
//! The rays stand in blocks of 16 x 16 pixels, row by row, and in a block by the curve that goes through all four quarters of a square
//! one after the other, and so through each of them (Morton, A Computer Oriented Geodetic Data Base, 1966): the rays of every
//! square whose side is a power of two stand together.

use super::hit::{Hit, Ray};
use super::region::{self, Shape};
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
    size: [u32; 2],
}

/// The rays that are asked about, by their numbers.
#[derive(Clone, Copy)]
pub(crate) enum Asked<'a> {
    List(&'a [Ray]),
    /// The pixels of a rectangle, row by row.
    Bundle(&'a Bundle),
}

/// Where each ray of a bundle enters what is looked at, and where it leaves it: upside down if it never does.
#[derive(Debug, Default)]
pub(crate) struct Spans {
    pub(crate) near: Column,
    pub(crate) far: Column,
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

impl Spans {
    /// What of each ray is inside all shapes, from `least` to `most` from its start.
    pub(crate) fn fill(&mut self, bundle: &Bundle, shapes: &[Shape], (least, most): (f64, f64), simd: Simd) {
        for (column, value) in [(&mut self.near, least), (&mut self.far, most)] {
            column.clear();
            column.resize(bundle.pixel.len(), value);
            column.resize(bundle.pixel.len() + BEYOND, f64::NAN);
        }
        for shape in shapes {
            cut(simd, self, bundle, shape);
        }
        let [width, height] = bundle.size;
        if width % BLOCK != 0 || height % BLOCK != 0 {
            for (far, _) in self.far.iter_mut().zip(&bundle.pixel).filter(|(_, pixel)| **pixel == ABSENT) {
                *far = f64::NEG_INFINITY;
            }
        }
    }

    /// Ends each ray where it meets something already.
    pub(crate) fn end_at(&mut self, bundle: &Bundle, hits: &[Hit]) {
        for (far, &pixel) in self.far.iter_mut().zip(&bundle.pixel) {
            if let Some(hit) = hits.get(pixel as usize) {
                *far = far.min(hit.t);
            }
        }
    }

    /// Between which depths any of `count` rays from some place on is looked at, give or take roundings.
    pub(crate) fn depths(&self, bundle: &Bundle, first: usize, count: usize, simd: Simd) -> Option<(f64, f64)> {
        let rays = first..first + count;
        let mut found = [[f64::INFINITY; LANES], [f64::NEG_INFINITY; LANES]];
        widen(simd, &self.near[rays.clone()], &self.far[rays.clone()], &bundle.length[rays], &mut found);
        let a = found[0].into_iter().fold(f64::INFINITY, f64::min);
        let end = found[1].into_iter().fold(f64::NEG_INFINITY, f64::max);
        (a <= end).then_some((a * SHORTENED, end * LENGTHENED))
    }
}

/// What a distance along a ray and a depth may be off by, being products of a few roundings; a hundred times too much.
pub(crate) const SHORTENED: f64 = 1.0 - 1e-13;
pub(crate) const LENGTHENED: f64 = 1.0 + 1e-13;

/// How many rays are asked at once for their depths.
const LANES: usize = 8;

for_each_level! {
    /// Takes the depths of some rays into the least and largest that are known.
    fn widen[L](near: &[f64], far: &[f64], length: &[f64], found: &mut [[f64; LANES]; 2]) {
        let [mut least, mut most] = *found;
        let (near, far, length) = (near.as_chunks::<LANES>(), far.as_chunks::<LANES>(), length.as_chunks::<LANES>());
        for ((near, far), length) in near.0.iter().zip(far.0).zip(length.0) {
            for i in 0..LANES {
                let per_length = 1.0 / length[i];
                let (a, end) = (near[i] * per_length, far[i] * per_length);
                let is_open = near[i] <= far[i];
                least[i] = if is_open & (a < least[i]) { a } else { least[i] };
                most[i] = if is_open & (end > most[i]) { end } else { most[i] };
            }
        }
        for ((near, far), length) in near.1.iter().zip(far.1).zip(length.1) {
            if near <= far {
                least[0] = least[0].min(near / length);
                most[0] = most[0].max(far / length);
            }
        }
        *found = [least, most];
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
