//! The part of each ray of a bundle that is looked at.
//!
//! In: a bundle, shapes, what is hit already. Out: between which distances each ray is inside, and between which depths any of some
//! rays is. Separate from the bundle because it changes while roots are found.

use super::bundle::{ABSENT, BEYOND, BLOCK, Bundle, Column};
use super::hit::Hit;
use super::region::{self, Shape};
use crate::num::level::{Simd, for_each_level};

/// Where each ray of a bundle enters what is looked at, and where it leaves it: upside down if it never does.
#[derive(Debug, Default)]
pub(crate) struct Spans {
    pub(crate) near: Column,
    pub(crate) far: Column,
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
