//! How much light at a place counts in a pixel.
//!
//! In: a filter, how far a place is from a pixel's centre. Out: its weight there. A sample counts in every pixel that the filter reaches from
//! it, so that all samples of the neighbourhood make a pixel.

use crate::num::func::native;

/// The filters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Filter {
    /// Every place of the pixel alike.
    Box,
    /// A bell of standard deviation 0.5, cut at 2 pixels.
    Gaussian,
    /// Mitchell and Netravali's, B = C = 1/3: sharp, with little ringing ("Reconstruction Filters in Computer Graphics", 1988).
    #[default]
    Mitchell,
}

/// The standard deviation of the bell in pixels.
const DEVIATION: f64 = 0.5;

/// The steps in which the integral of the bell is taken.
const STEPS: usize = 256;

impl Filter {
    /// All filters with the words that name them.
    pub const ALL: [(&'static str, Filter); 3] =
        [("box", Filter::Box), ("gaussian", Filter::Gaussian), ("mitchell", Filter::Mitchell)];

    /// The filter of a name.
    pub fn from_name(name: &str) -> Option<Filter> {
        Filter::ALL.into_iter().find(|(word, _)| *word == name).map(|(_, filter)| filter)
    }

    /// How far it reaches, in pixels.
    pub fn radius(self) -> f64 {
        match self {
            Filter::Box => 0.5,
            Filter::Gaussian | Filter::Mitchell => 2.0,
        }
    }

    /// Its value at a distance from the centre along one axis; the integral is 1 for box and Mitchell, and as it is for the bell.
    fn value(self, x: f64) -> f64 {
        match self {
            // A place on the line between two pixels is one's alone.
            Filter::Box => f64::from(u8::from(x > -0.5 && x <= 0.5)),
            Filter::Gaussian | Filter::Mitchell if x.abs() >= 2.0 => 0.0,
            Filter::Gaussian => {
                let bell = |x: f64| native::exp(-x * x / (2.0 * DEVIATION * DEVIATION));
                bell(x) - bell(2.0)
            }
            Filter::Mitchell => {
                let x = x.abs();
                let cubic = if x < 1.0 {
                    (7.0 * x - 12.0) * x * x + 16.0 / 3.0
                } else {
                    ((-7.0 / 3.0 * x + 12.0) * x - 20.0) * x + 32.0 / 3.0
                };
                cubic / 6.0
            }
        }
    }
}

/// A filter of integral 1.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    filter: Filter,
    scale: f64,
}

impl Weights {
    /// The weights of a filter.
    pub fn new(filter: Filter) -> Self {
        let width = 2.0 * filter.radius() / STEPS as f64;
        let values = (0..STEPS).map(|k| filter.value((k as f64 + 0.5) * width - filter.radius()));
        Weights { filter, scale: 1.0 / (width * values.sum::<f64>()) }
    }

    /// How many pixels beyond its own a place may count in.
    pub fn reach(&self) -> u32 {
        self.filter.radius().ceil() as u32
    }

    /// The pixels of a row of `count` that a place counts in, with the weight of each along this axis.
    pub fn along(&self, place: f64, count: u32) -> impl Iterator<Item = (u32, f64)> + Clone {
        let (filter, scale) = (self.filter, self.scale);
        let first = (place - 0.5 - filter.radius()).ceil().max(0.0) as u32;
        let end = ((place - 0.5 + filter.radius()).floor() + 1.0).max(0.0) as u32;
        (first..end.min(count)).map(move |k| (k, filter.value(f64::from(k) + 0.5 - place) * scale))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_of_every_filter_have_an_integral_of_one() {
        for (name, filter) in Filter::ALL {
            let weights = Weights::new(filter);
            let n = 1000;
            let sum = |pixel: u32| -> f64 {
                let places = (0..10 * n).map(|k| (f64::from(k) + 0.5) / f64::from(n));
                places.flat_map(|place| weights.along(place, 10)).filter(|(k, _)| *k == pixel).map(|(_, w)| w).sum()
            };
            assert!((sum(5) / f64::from(n) - 1.0).abs() < 1e-3, "{name}: {}", sum(5));
        }
    }

    #[test]
    fn mitchell_is_the_published_cubic() {
        // (6 − 2B)/6 in the middle, B/6 at 1, 0 at 2.
        let at = |x| Filter::Mitchell.value(x);
        assert!((at(0.0) - 16.0 / 18.0).abs() < 1e-15 && (at(1.0) - 1.0 / 18.0).abs() < 1e-15 && at(2.0) == 0.0);
        assert!((Weights::new(Filter::Mitchell).scale - 1.0).abs() < 1e-4);
    }

    #[test]
    fn a_box_gives_a_place_to_one_pixel() {
        let weights = Weights::new(Filter::Box);
        for (place, pixel) in [(3.0, 3), (3.999, 3), (0.0, 0), (3.5, 3)] {
            let pixels: Vec<u32> =
                weights.along(place, 9).filter(|(_, weight)| *weight > 0.0).map(|(k, _)| k).collect();
            assert_eq!(pixels, [pixel], "{place}");
        }
    }
}
