//! A clear sky by day.
//!
//! In: where the sun is, how hazy the air. Out: the radiance from each direction, without that of the sun's own disc. Separate
//! because the numbers are fitted to a simulation of air and not ours: Preetham, Shirley and Smits 1999, "A practical analytic model
//! for daylight", appendix A.2.

use crate::num::func;
use crate::num::level::Portable;
use glam::DVec3;
use std::f64::consts::PI;

/// Lumens of a watt of white light over the visible wavelengths (Ward 1994, "The RADIANCE lighting simulation and rendering
/// system", section 2): the model gives luminances, and a scene is lit by radiances.
const LUMENS_PER_WATT: f64 = 179.0;

/// The five coefficients of the distribution of luminance Y and of the chromaticities x and y: the turbidity times the first, and the
/// second.
const DISTRIBUTION: [[(f64, f64); 5]; 3] = [
    [(0.1787, -1.4630), (-0.3554, 0.4275), (-0.0227, 5.3251), (0.1206, -2.5771), (-0.0670, 0.3703)],
    [(-0.0193, -0.2592), (-0.0665, 0.0008), (-0.0004, 0.2125), (-0.0641, -0.8989), (-0.0033, 0.0452)],
    [(-0.0167, -0.2608), (-0.0950, 0.0092), (-0.0079, 0.2102), (-0.0441, -1.6537), (-0.0109, 0.0529)],
];

/// The chromaticities x and y straight above: rows for the square of the turbidity, the turbidity and 1; columns for the third power
/// of the sun's angle to the zenith down to 1.
const ZENITH: [[[f64; 4]; 3]; 2] = [
    [[0.00166, -0.00375, 0.00209, 0.0], [-0.02903, 0.06377, -0.03202, 0.00394], [0.11693, -0.21196, 0.06052, 0.25886]],
    [[0.00275, -0.00610, 0.00317, 0.0], [-0.04214, 0.08970, -0.04153, 0.00516], [0.15346, -0.26756, 0.06670, 0.26688]],
];

/// Linear sRGB of CIE XYZ, by rows (IEC 61966-2-1).
const SRGB: [DVec3; 3] =
    [DVec3::new(3.2406, -1.5372, -0.4986), DVec3::new(-0.9689, 1.8758, 0.0415), DVec3::new(0.0557, -0.2040, 1.0570)];

/// A clear sky.
#[derive(Clone, Debug, PartialEq)]
pub struct Daylight {
    toward_sun: DVec3,
    /// Of luminance and the two chromaticities.
    distribution: [[f64; 5]; 3],
    /// Their values straight above, over those of the distribution there.
    scale: [f64; 3],
}

impl Daylight {
    /// The sky with the sun in this direction, of length 1 and not below the horizon, through air of this turbidity, of 2..=10: 2 is
    /// very clear, 3 clear, 6 hazy.
    pub fn new(toward_sun: DVec3, turbidity: f64) -> Self {
        let distribution = DISTRIBUTION.map(|row| row.map(|(slope, constant)| slope * turbidity + constant));
        let angle = func::acos::<Portable>(toward_sun.z.clamp(0.0, 1.0));
        let powers = [angle * angle * angle, angle * angle, angle, 1.0];
        let [x, y] = ZENITH.map(|rows| {
            let [second, first, constant] = rows.map(|row| row.iter().zip(powers).map(|(a, b)| a * b).sum::<f64>());
            (second * turbidity + first) * turbidity + constant
        });
        let chi = (4.0 / 9.0 - turbidity / 120.0) * (PI - 2.0 * angle);
        let kilo = (4.0453 * turbidity - 4.9710) * func::tan::<Portable>(chi) - 0.2155 * turbidity + 2.4192;
        let zenith = [kilo * 1000.0, x, y];
        let scale = std::array::from_fn(|k| zenith[k] / perez(&distribution[k], 1.0, angle, toward_sun.z));
        Daylight { toward_sun, distribution, scale }
    }

    /// The radiance from direction d, of length 1, in W/(m² sr); the horizon's from below.
    pub fn radiance(&self, d: DVec3) -> DVec3 {
        let level = if d.z < 0.0 { DVec3::new(d.x, d.y, 0.0).normalize_or(DVec3::X) } else { d };
        let cosine = level.dot(self.toward_sun).clamp(-1.0, 1.0);
        let angle = func::acos::<Portable>(cosine);
        let [luminance, x, y] =
            std::array::from_fn(|k| self.scale[k] * perez(&self.distribution[k], level.z, angle, cosine));
        let xyz = DVec3::new(x, y, 1.0 - x - y) * (luminance / y);
        DVec3::from_array(SRGB.map(|row| row.dot(xyz).max(0.0))) / LUMENS_PER_WATT
    }
}

/// Perez, Seals and Michalsky 1993, "All-weather model for sky luminance distribution", equation 1: by the cosine of the angle to the
/// zenith, and by the angle to the sun and its cosine.
fn perez([a, b, c, d, e]: &[f64; 5], height: f64, angle: f64, cosine: f64) -> f64 {
    // The exponent's coefficient is < 0: towards the horizon the term fades.
    let falling = if height > 0.0 { func::exp::<Portable>(b / height) } else { 0.0 };
    (1.0 + a * falling) * (1.0 + c * func::exp::<Portable>(d * angle) + e * cosine * cosine)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sun, turbidity, direction, radiance, by tests/tools/daylight.py.
    const ROWS: [([f64; 3], f64, [f64; 3], [f64; 3]); 8] = [
        ([0.6, 0.0, 0.8], 2.5, [0.0, 0.0, 1.0], [25.732797942974567, 39.519814381809205, 76.34527974431768]),
        ([0.6, 0.0, 0.8], 2.5, [-0.6, 0.0, 0.8], [13.485247064111784, 26.67904254267585, 54.78682682828324]),
        ([0.6, 0.0, 0.8], 2.5, [0.5, 0.1, 0.8], [77.17756309258426, 97.61892204915458, 151.65962813120413]),
        ([1.0, -1.0, 2.0], 3.0, [0.3, 0.9, 0.1], [41.53101881021278, 45.61309811274125, 55.45938474929268]),
        ([1.0, -1.0, 2.0], 6.0, [-0.3, 0.2, 0.5], [37.554278877781414, 67.28704406997831, 104.84590258033151]),
        ([0.0, 1.0, 0.05], 2.0, [0.0, 0.9, 0.2], [235.5300866670238, 208.23829782256914, 104.36664432607118]),
        ([0.0, 1.0, 0.05], 10.0, [0.0, -0.9, 0.2], [6.5400822744388005, 3.8369386687429268, 1.9770601016473734]),
        ([0.0, 0.0, 1.0], 4.0, [1.0, 0.0, 0.01], [61.21132394567822, 58.256561055157604, 65.8351704374673]),
    ];

    #[test]
    fn radiances_are_those_of_the_paper() {
        for (sun, turbidity, direction, expected) in ROWS {
            let sky = Daylight::new(DVec3::from(sun).normalize(), turbidity);
            let (found, expected) = (sky.radiance(DVec3::from(direction).normalize()), DVec3::from(expected));
            let difference = (found - expected).abs().max_element();
            assert!(difference < 1e-9 * expected.max_element(), "{sun:?} {turbidity} {direction:?}: {found}");
        }
    }

    #[test]
    fn the_sky_is_blue_brighter_at_the_sun_and_the_same_below_the_horizon() {
        let sky = Daylight::new(DVec3::new(0.6, 0.0, 0.8), 2.5);
        let above = sky.radiance(DVec3::new(-0.6, 0.0, 0.8));
        assert!(above.z > above.y && above.y > above.x, "{above}");
        assert!(sky.radiance(DVec3::new(0.59, 0.0, 0.81).normalize()).y > 3.0 * above.y);
        let below = sky.radiance(DVec3::new(0.0, 0.6, -0.8));
        assert!((below - sky.radiance(DVec3::Y)).abs().max_element() < 1e-12);
        assert!(sky.radiance(DVec3::NEG_Z).is_finite() && Daylight::new(DVec3::X, 10.0).radiance(DVec3::Z).y > 0.0);
    }
}
