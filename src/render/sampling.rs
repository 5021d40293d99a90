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

/// Whether the samples of a pixel still differ, so that their mean is not to be trusted yet.
pub fn is_torn(samples: &[[f32; 3]]) -> bool {
    samples.windows(2).any(|pair| !look_alike(pair[0], pair[1]))
}

/// The mean, summed in the samples' order.
pub fn mean(samples: &[[f32; 3]]) -> [f32; 3] {
    let mut sum = [0.0f64; 3];
    for sample in samples {
        for channel in 0..3 {
            sum[channel] += f64::from(sample[channel]);
        }
    }
    sum.map(|s| (s / samples.len() as f64) as f32)
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
    fn means_are_means() {
        assert_eq!(mean(&[[0.0, 1.0, 2.0], [1.0, 1.0, 4.0]]), [0.5, 1.0, 3.0]);
    }
}
