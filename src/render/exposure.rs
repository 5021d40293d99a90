//! Samples of light, added up in the pixels they count in.
//!
//! In: estimates with their places, splats of paths from lights. Out: sums a pixel. Sums are whole numbers of small steps, so that they are the
//! same in whatever order threads add them; each thread adds to sums of its own tile first.

use super::filter::Weights;
use super::tiles::Tile;
use super::transport::estimate::Estimate;
use super::transport::light::Splat;
use crate::film::{Layer, Size};

/// The steps in which light is added: 2^−60, and 2^67 at most.
const STEP: f64 = 1.0 / (1u64 << 60) as f64;

/// The least weight of all samples of a pixel, per sample: where few of them fall to its rim, their weights may cancel.
const LEAST_WEIGHT: f64 = 0.05;

/// Light, weight, and weight of what is covered, in steps.
type Sums = [i128; 5];

/// The sums of a picture.
#[derive(Clone, Debug)]
pub struct Exposure {
    seen: Layer<Sums>,
    /// What paths from the lights show; `None` in modes without any.
    shown: Option<Layer<[i128; 3]>>,
}

/// The sums of a tile and of the pixels around it that its samples count in.
#[derive(Clone, Debug)]
pub struct TileExposure {
    left: u32,
    top: u32,
    width: u32,
    sums: Vec<Sums>,
    size: Size,
}

/// What a pixel's sums come to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposed {
    /// Its light.
    pub light: [f32; 3],
    /// How much of it is covered.
    pub alpha: f32,
}

impl Exposure {
    /// Without light; `has_splats` in modes with paths from the lights.
    pub fn new(size: Size, has_splats: bool) -> Self {
        Exposure { seen: Layer::filled(size, [0; 5]), shown: has_splats.then(|| Layer::filled(size, [0; 3])) }
    }

    /// Adds what a thread has of a tile.
    pub fn add(&mut self, tile: &TileExposure) {
        let width = self.seen.size.width();
        for (row, sums) in tile.sums.chunks(tile.width as usize).enumerate() {
            let first = ((tile.top + row as u32) * width + tile.left) as usize;
            for (all, more) in self.seen.values[first..].iter_mut().zip(sums) {
                all.iter_mut().zip(more).for_each(|(all, more)| *all = all.saturating_add(*more));
            }
        }
    }

    /// Adds light that paths from the lights show, for one sample a pixel.
    pub fn add_shown<'s>(&mut self, splats: impl Iterator<Item = &'s Splat>, weights: &Weights) {
        let Some(shown) = &mut self.shown else { return };
        let (width, height) = (shown.size.width(), shown.size.height());
        for Splat { place: [x, y], light } in splats {
            let across = weights.along(*x, width);
            for (j, down) in weights.along(*y, height) {
                for (i, across) in across.clone() {
                    let sums = &mut shown.values[(j * width + i) as usize];
                    let more = (*light * (across * down)).to_array();
                    sums.iter_mut().zip(more).for_each(|(sum, more)| add(sum, more));
                }
            }
        }
    }

    /// The means of so many samples a pixel, row by row.
    pub fn develop(&self, samples: u32) -> impl Iterator<Item = Exposed> {
        self.seen.values.iter().enumerate().map(move |(k, &sums)| {
            let [r, g, b, weight, covered] = sums.map(|sum| sum as f64 * STEP);
            let weight = weight.max(LEAST_WEIGHT * f64::from(samples));
            let shown = self.shown.as_ref().map_or([0; 3], |shown| shown.values[k]);
            let shown = shown.map(|sum| sum as f64 * STEP / f64::from(samples));
            let seen = [r, g, b].map(|sum| sum / weight);
            let light = std::array::from_fn(|c| (seen[c] + shown[c]) as f32);
            Exposed { light, alpha: (covered / weight).clamp(0.0, 1.0) as f32 }
        })
    }
}

impl TileExposure {
    /// Without light.
    pub fn new(tile: Tile, size: Size, weights: &Weights) -> Self {
        let (rectangle, reach) = (tile.rectangle(), weights.reach());
        let (left, top) = (rectangle.left.saturating_sub(reach), rectangle.top.saturating_sub(reach));
        let right = (rectangle.left + rectangle.width + reach).min(size.width());
        let bottom = (rectangle.top + rectangle.height + reach).min(size.height());
        let (width, height) = (right - left, bottom - top);
        TileExposure { left, top, width, sums: vec![[0; 5]; (width * height) as usize], size }
    }

    /// Adds samples of the tile's pixels.
    pub fn add(&mut self, estimates: &[Estimate], weights: &Weights) {
        for Estimate { place: [x, y], light, is_covered } in estimates {
            let across = weights.along(*x, self.size.width());
            for (j, down) in weights.along(*y, self.size.height()) {
                let row = (j - self.top) * self.width;
                for (i, weight) in across.clone().map(|(i, across)| (i, across * down)) {
                    let [r, g, b] = (*light * weight).to_array();
                    let covered = if *is_covered { weight } else { 0.0 };
                    let sums = &mut self.sums[(row + i - self.left) as usize];
                    sums.iter_mut().zip([r, g, b, weight, covered]).for_each(|(sum, more)| add(sum, more));
                }
            }
        }
    }
}

/// Adds in steps.
fn add(sum: &mut i128, more: f64) {
    *sum = sum.saturating_add((more / STEP) as i128);
}
