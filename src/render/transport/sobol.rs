//! The numbers by which paths choose: evenly spread over the samples of a pixel, unrelated between pixels.
//!
//! In: a pixel, a sample, a dimension, a seed. Out: two numbers of 0..1, a pure function of them, so that any thread may ask
//! in any order. Each dimension is a plane of its own: the (0,2)-sequence of Sobol 1967, its order and both its axes scrambled
//! after Owen by a hash (Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4)). Of the first 2^k samples each box of
//! width 2^−a and height 2^−b, a + b = k, has exactly one.

/// 2^−32.
const STEP: f64 = 1.0 / 4_294_967_296.0;

/// 2^64/φ: multiples of it differ in all their bits (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators").
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Point number `sample` of the plane `dimension` of a pixel. Neither number is ever 0 or 1.
pub fn numbers(pixel: u64, sample: u32, dimension: u32, seed: u64) -> [f64; 2] {
    let order = mixed(mixed(mixed(seed) ^ pixel) ^ u64::from(dimension));
    let axes = mixed(order);
    let index = scrambled(sample.reverse_bits(), order as u32);
    [scrambled(index, axes as u32), scrambled(second_axis(index), (axes >> 32) as u32)]
        .map(|digits| (f64::from(digits) + 0.5) * STEP)
}

/// Sobol's second axis, its first digit in the lowest bit like the index itself: digit i is the parity of the digits j with
/// i ⊆ j as sets of bits, for those are the odd ones of Pascal's triangle (Lucas 1878).
fn second_axis(index: u32) -> u32 {
    let mut x = index;
    x ^= (x >> 1) & 0x5555_5555;
    x ^= (x >> 2) & 0x3333_3333;
    x ^= (x >> 4) & 0x0f0f_0f0f;
    x ^= (x >> 8) & 0x00ff_00ff;
    x ^ (x >> 16)
}

/// Digits, the first in the lowest bit, scrambled after Owen, the first in the highest bit: each is flipped or not by what is
/// before it and the seed. A product and a sum carry from low bits to high ones only, which is what the scrambling asks for; this
/// row of them flips evenly (Vegdahl 2021, "Building a better LK hash").
fn scrambled(digits: u32, seed: u32) -> u32 {
    let mut x = digits;
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^= x.wrapping_mul(0x53a2_2864);
    x.reverse_bits()
}

/// A number that shares no pattern with x (Stafford 2011, "Better bit mixing", variant 13).
fn mixed(x: u64) -> u64 {
    let mut z = x.wrapping_add(GOLDEN);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The numbers as the definition has them, unscrambled: the first axis reverses the index, the second has the direction
    /// numbers v_k+1 = v_k ^ (v_k >> 1) of the polynomial x + 1.
    fn by_definition(index: u32) -> [u32; 2] {
        let mut direction = 1u32 << 31;
        let mut second = 0;
        for digit in 0..32 {
            if index >> digit & 1 == 1 {
                second ^= direction;
            }
            direction ^= direction >> 1;
        }
        [index.reverse_bits(), second]
    }

    #[test]
    fn the_second_axis_is_that_of_sobol() {
        for index in (0..2000).chain([0x8000_0000, 0xffff_ffff, 0x1234_5678]) {
            assert_eq!(second_axis(index).reverse_bits(), by_definition(index)[1], "{index}");
        }
    }

    #[test]
    fn every_box_of_the_first_samples_and_of_any_later_block_has_one() {
        for (pixel, dimension, seed) in [(0, 0, 0), (7, 3, 1), (1 << 40, 900, 12_345)] {
            for log in [4u32, 6, 8] {
                for block in [0u32, 1, 5] {
                    for across in 0..=log {
                        let mut seen = vec![false; 1 << log];
                        for sample in block << log..(block + 1) << log {
                            let [u, v] = numbers(pixel, sample, dimension, seed);
                            let column = (u * f64::from(1u32 << across)) as usize;
                            let row = (v * f64::from(1u32 << (log - across))) as usize;
                            let place = &mut seen[(column << (log - across)) + row];
                            assert!(!*place, "two in a box: {pixel} {dimension} {seed}, {log} {block} {across}");
                            *place = true;
                        }
                    }
                }
            }
        }
    }

    /// χ² of the counts of a 16 × 16 grid.
    fn chi_square(points: impl Iterator<Item = [f64; 2]>) -> f64 {
        let (mut counts, mut total) = ([0u32; 256], 0);
        for [u, v] in points {
            counts[(u * 16.0) as usize * 16 + (v * 16.0) as usize] += 1;
            total += 1;
        }
        let expected = f64::from(total) / 256.0;
        counts.iter().map(|&count| (f64::from(count) - expected) * (f64::from(count) - expected) / expected).sum()
    }

    /// One sample each of many pixels, seeds, dimensions must be even as random numbers are, in its numbers and against the one
    /// before: χ² of 255 degrees has mean 255 and deviation 22.6.
    #[test]
    fn pixels_seeds_and_dimensions_are_unrelated() {
        let count = 25_600u32;
        type Way = fn(u32) -> [f64; 2];
        type Join = fn([f64; 2], [f64; 2]) -> [f64; 2];
        let ways: [(&str, Way); 5] = [
            ("pixels", |k| numbers(u64::from(k), 0, 0, 0)),
            ("seeds", |k| numbers(0, 0, 0, u64::from(k))),
            ("dimensions", |k| numbers(0, 0, k, 0)),
            ("pixels, later sample", |k| numbers(u64::from(k), 77, 5, 3)),
            ("far pixels", |k| numbers(u64::from(k) << 32, 1, 0, 9)),
        ];
        for (name, way) in ways {
            let pairs: [(&str, Join); 3] =
                [("u v", |a, _| a), ("u u'", |a, b| [a[0], b[0]]), ("v u'", |a, b| [a[1], b[0]])];
            for (pair, join) in pairs {
                let chi = chi_square((0..count).map(|k| join(way(k), way(k + 1))));
                assert!((255.0 - chi).abs() < 5.0 * 22.6, "{name} {pair}: {chi}");
            }
        }
    }

    #[test]
    fn the_mean_over_pixels_is_a_half() {
        // Of 20 000 even numbers the mean deviates by 0.29/√20 000 = 0.002.
        for sample in [0, 1, 2, 63] {
            let sum =
                (0..20_000).map(|pixel| numbers(pixel, sample, 1, 0)).fold([0.0; 2], |s, p| [s[0] + p[0], s[1] + p[1]]);
            assert!(sum.iter().all(|s| (s / 20_000.0 - 0.5).abs() < 0.01), "{sample} {sum:?}");
        }
    }
}
