//! Where in a pixel the rays go, and when they are enough.
//!
//! In: which pixels are edges. Out: offsets in a pixel, the first its centre; whether more of them are needed.

use super::knowledge::look_alike;

/// Samples of an edge before it is judged again: the centre and four more.
pub const FIRST_SAMPLES: u32 = 5;

/// Fractions of the plastic number, whose multiples fill the square evenly at every count
/// (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences").
const STEP: [f64; 2] = [0.754_877_666_246_692_7, 0.569_840_290_998_053_2];

/// Where the sample of this index is in its pixel, of 0..1 each way; the first is at the centre.
pub fn offset(index: u32) -> (f64, f64) {
    let place = |step: f64| {
        let position = 0.5 + step * f64::from(index);
        position - position.floor()
    };
    (place(STEP[0]), place(STEP[1]))
}

/// Whether a pixel's first sample and the next ones still differ, so that their mean is not to be trusted yet.
pub fn is_torn(first: [f32; 3], next: &[[f32; 3]]) -> bool {
    let before = std::iter::once(&first).chain(next);
    before.zip(next).any(|(&a, &b)| !look_alike(a, b))
}

/// The mean of so many samples, added up in their order.
pub fn mean(sum: [f64; 3], count: u32) -> [f32; 3] {
    sum.map(|s| (s / f64::from(count)) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_start_at_the_centre_and_fill_the_pixel_evenly() {
        assert_eq!(offset(0), (0.5, 0.5));
        for count in [16u32, 64, 256] {
            for quarter in 0..4u32 {
                let inside = (0..count).filter(|&k| {
                    let (a, b) = offset(k);
                    u32::from(a >= 0.5) + 2 * u32::from(b >= 0.5) == quarter
                });
                let share = inside.count() as f64 / f64::from(count);
                assert!((share - 0.25).abs() < 2.5 / f64::from(count), "{count} {quarter} {share}");
            }
        }
    }

    #[test]
    fn samples_differ_if_any_differs_from_the_one_before() {
        let (dark, light) = ([0.1; 3], [0.9; 3]);
        assert!(!is_torn(dark, &[]) && !is_torn(dark, &[dark, dark]));
        assert!(is_torn(light, &[dark, dark]) && is_torn(dark, &[dark, light]));
        assert_eq!(mean([1.0, 2.0, 6.0], 2), [0.5, 1.0, 3.0]);
    }
}
