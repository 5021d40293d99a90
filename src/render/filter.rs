//! How much a place counts in a pixel.
//!
//! In: a filter, two numbers of 0..1. Out: a place around the pixel's centre, as likely as the filter's size there, and its sign: the mean over
//! such places, each with its sign, is what the filter gives (Ernst, Stamminger and Greiner 2006, "Filter importance sampling").

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

/// The steps in which a filter is tabled, to one side.
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
        let x = x.abs();
        match self {
            _ if x >= self.radius() => 0.0,
            Filter::Box => 1.0,
            Filter::Gaussian => {
                let bell = |x: f64| native::exp(-x * x / (2.0 * DEVIATION * DEVIATION));
                bell(x) - bell(2.0)
            }
            Filter::Mitchell if x < 1.0 => ((7.0 * x - 12.0) * x * x + 16.0 / 3.0) / 6.0,
            Filter::Mitchell => (((-7.0 / 3.0 * x + 12.0) * x - 20.0) * x + 32.0 / 3.0) / 6.0,
        }
    }
}

/// A filter, tabled.
#[derive(Clone, Debug)]
pub struct FilterTable {
    filter: Filter,
    /// The sums of the sizes of the steps of one side, of 0..=1.
    sums: Vec<f64>,
    /// For as many even parts of 0..=1, the step that the part begins in.
    first: Vec<usize>,
    /// The signs of the steps.
    signs: Vec<f64>,
    /// 1 over the integral.
    scale: f64,
}

impl FilterTable {
    /// The table of a filter.
    pub fn new(filter: Filter) -> Self {
        let width = filter.radius() / STEPS as f64;
        let values: Vec<f64> = (0..STEPS).map(|k| filter.value((k as f64 + 0.5) * width)).collect();
        let total: f64 = values.iter().map(|value| value.abs()).sum();
        let mut sum = 0.0;
        let mut sums: Vec<f64> = values
            .iter()
            .map(|value| {
                sum += value.abs() / total;
                sum
            })
            .collect();
        sums[STEPS - 1] = 1.0;
        let first = (0..STEPS).map(|part| sums.partition_point(|&sum| sum <= part as f64 / STEPS as f64)).collect();
        let signs = values.iter().map(|&value| if value < 0.0 { -1.0 } else { 1.0 }).collect();
        FilterTable { filter, sums, first, signs, scale: 1.0 / (2.0 * width * values.iter().sum::<f64>()) }
    }

    /// A place around the centre of a pixel, in pixels, and its sign.
    pub fn place(&self, [u, v]: [f64; 2]) -> ([f64; 2], f64) {
        let ((x, a), (y, b)) = (self.along(u), self.along(v));
        ([x, y], a * b)
    }

    fn along(&self, u: f64) -> (f64, f64) {
        let (side, u) = if u < 0.5 { (-1.0, 1.0 - 2.0 * u) } else { (1.0, 2.0 * u - 1.0) };
        if self.filter == Filter::Box {
            return (side * u * 0.5, 1.0);
        }
        let mut step = self.first[((u * STEPS as f64) as usize).min(STEPS - 1)];
        while step < STEPS - 1 && self.sums[step] <= u {
            step += 1;
        }
        let before = if step == 0 { 0.0 } else { self.sums[step - 1] };
        let width = self.sums[step] - before;
        let rest = if width > 0.0 { ((u - before) / width).clamp(0.0, 1.0) } else { 0.5 };
        let x = (step as f64 + rest) * self.filter.radius() / STEPS as f64;
        (side * x, self.signs[step])
    }

    /// What a unit of light at a place gives to a pixel whose centre is (dx, dy) pixels away: the filter there, of integral 1.
    pub fn weight(&self, dx: f64, dy: f64) -> f64 {
        self.filter.value(dx) * self.filter.value(dy) * self.scale * self.scale
    }

    /// How far it reaches, in pixels.
    pub fn radius(&self) -> f64 {
        self.filter.radius()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signed_means_over_places_are_what_the_filter_gives() {
        // The integral of the filter times x² along one axis: 1/12; the bell's; Mitchell's, whose moment is B/3 − … = 0 + 2B·… by sums.
        for (name, filter) in Filter::ALL {
            let table = FilterTable::new(filter);
            let n = 4000;
            let step = 2.0 * filter.radius() / f64::from(n);
            let xs = (0..n).map(|k| (f64::from(k) + 0.5) * step - filter.radius());
            let (mut area, mut moment) = (0.0, 0.0);
            for x in xs {
                area += filter.value(x) * step;
                moment += filter.value(x) * x * x * step;
            }
            let (mut signs, mut seen) = (0.0, 0.0);
            for k in 0..n {
                let ([x, _], sign) = table.place([(f64::from(k) + 0.5) / f64::from(n), 0.5001]);
                signs += sign;
                seen += sign * x * x;
            }
            assert!((seen / signs - moment / area).abs() < 2e-3, "{name}: {} {}", seen / signs, moment / area);
            assert!(
                (table.weight(0.2, 0.0) / (filter.value(0.2) * filter.value(0.0)) - 1.0 / (area * area)).abs() < 1e-3
            );
        }
    }

    #[test]
    fn mitchell_is_the_published_cubic() {
        // (6 − 2B)/6 in the middle, B/6 at 1, 0 at 2; its integral is 1.
        let at = |x| Filter::Mitchell.value(x);
        assert!((at(0.0) - 16.0 / 18.0).abs() < 1e-15 && (at(1.0) - 1.0 / 18.0).abs() < 1e-15 && at(2.0) == 0.0);
        assert!((FilterTable::new(Filter::Mitchell).scale - 1.0).abs() < 1e-4);
    }
}
