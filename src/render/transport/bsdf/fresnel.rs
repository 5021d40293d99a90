//! How much a smooth interface reflects (Fresnel 1823).
//!
//! In: the cosine of the angle of arrival, refractive indices. Out: the share of unpolarised light that is reflected; the angle
//! beyond.

use crate::scene::material::Conductor;
use glam::DVec3;

/// The cosine of the angle to the normal beyond an interface of relative index `ior` (beyond over before); 0 where all is
/// reflected (Snell).
pub fn cosine_beyond(cosine: f64, ior: f64) -> f64 {
    (1.0 - (1.0 - cosine * cosine) / (ior * ior)).max(0.0).sqrt()
}

/// The share reflected of the parts polarised across the plane of incidence (s) and in it (p).
pub fn polarised(cosine: f64, ior: f64) -> [f64; 2] {
    let beyond = cosine_beyond(cosine, ior);
    let s = (cosine - ior * beyond) / (cosine + ior * beyond);
    let p = (ior * cosine - beyond) / (ior * cosine + beyond);
    [s * s, p * p]
}

/// The share that clear media reflect; `ior` is the refractive index beyond over that before.
pub fn dielectric(cosine: f64, ior: f64) -> f64 {
    if cosine <= 0.0 {
        return 1.0;
    }
    let [s, p] = polarised(cosine, ior);
    0.5 * (s + p)
}

/// Gauss's nodes and weights for ∫ 2x·f(x) dx over 0..1, exact for polynomials of degree 11 (Abramowitz and Stegun, section 25.4.33 with
/// k = 1): means over all directions x, weighted by their cosine.
const MEAN: [(f64, f64); 6] = [
    (0.073_054_328_680_258_88, 0.017_476_603_627_219_065),
    (0.230_766_137_969_945_5, 0.087_910_331_101_017_95),
    (0.441_328_481_228_449_86, 0.197_322_301_781_310_52),
    (0.663_015_309_718_845_7, 0.281_585_107_576_397_9),
    (0.851_921_400_331_515_8, 0.271_084_994_463_037_24),
    (0.970_683_572_840_215_1, 0.144_620_661_451_017_37),
];

/// The mean share that clear media reflect over all directions, weighted by their cosine.
pub fn average_dielectric(ior: f64) -> f64 {
    if ior < 1.0 {
        // What leaves the denser side is what enters there, over the square of the index: the cone is so much narrower.
        return 1.0 - (1.0 - average_dielectric(1.0 / ior)) * ior * ior;
    }
    MEAN.iter().map(|&(cosine, weight)| dielectric(cosine, ior) * weight).sum()
}

/// The share that a metal reflects, of one colour (Born and Wolf, "Principles of Optics", section 14.2, in real numbers as in
/// Lagarde 2013, "Memo on Fresnel equations").
pub fn conductor(cosine: f64, n: f64, k: f64) -> f64 {
    let (cos2, sin2) = (cosine * cosine, 1.0 - cosine * cosine);
    let real = n * n - k * k - sin2;
    let length = (real * real + 4.0 * n * n * k * k).sqrt();
    let twice = 2.0 * cosine * (0.5 * (length + real)).max(0.0).sqrt();
    let s = (length + cos2 - twice) / (length + cos2 + twice);
    let (sum, difference) = (length * cos2 + sin2 * sin2, twice * sin2);
    0.5 * s * (1.0 + (sum - difference) / (sum + difference))
}

/// The share that a metal reflects.
#[derive(Clone, Copy, Debug)]
pub enum Metallic {
    /// Of known refractive index.
    Measured(Conductor),
    /// Of this colour where light arrives at a right angle (Schlick 1994, "An inexpensive BRDF model for physically-based
    /// rendering").
    Tint(DVec3),
}

impl Metallic {
    /// The share reflected at this angle.
    pub fn share(&self, cosine: f64) -> DVec3 {
        match self {
            Metallic::Measured(Conductor { n, k }) => {
                let of = |n: f64, k: f64| conductor(cosine, n, k);
                DVec3::new(of(n.x, k.x), of(n.y, k.y), of(n.z, k.z))
            }
            Metallic::Tint(tint) => {
                let rest = (1.0 - cosine).max(0.0);
                let square = rest * rest;
                *tint + (DVec3::ONE - *tint) * (square * square * rest)
            }
        }
    }

    /// The mean share over all directions, weighted by their cosine.
    pub fn average(&self) -> DVec3 {
        match self {
            Metallic::Measured(_) => MEAN.iter().map(|&(cosine, weight)| self.share(cosine) * weight).sum(),
            // ∫ 2x(1 − x)⁵ dx = 1/21.
            Metallic::Tint(tint) => *tint + (DVec3::ONE - *tint) / 21.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::func;
    use crate::num::level::Portable;

    #[test]
    fn a_right_angle_brewsters_angle_and_total_reflection() {
        for ior in [1.33, 1.5, 2.42, 1.0 / 1.5, 0.4] {
            let plain = (ior - 1.0) / (ior + 1.0);
            assert!((dielectric(1.0, ior) - plain * plain).abs() < 1e-15, "{ior}");
            // At Brewster's angle, whose tangent is n, nothing polarised in the plane is reflected.
            let brewster = 1.0 / (1.0 + ior * ior).sqrt();
            let [s, p] = polarised(brewster, ior);
            let across = (1.0 - ior * ior) / (1.0 + ior * ior);
            assert!(p < 1e-28 && (s - across * across).abs() < 1e-14, "{ior}: {s} {p}");
            assert!((dielectric(brewster, ior) - 0.5 * s).abs() < 1e-15, "{ior}");
            assert!((dielectric(1e-9, ior) - 1.0).abs() < 1e-7, "{ior}");
        }
        let critical = (1.0 - 1.0 / 2.25f64).sqrt();
        assert_eq!([dielectric(critical - 1e-9, 1.0 / 1.5), cosine_beyond(critical - 1e-9, 1.0 / 1.5)], [1.0, 0.0]);
        assert!(dielectric(critical + 1e-4, 1.0 / 1.5) < 0.95);
    }

    /// Both sides of an interface reflect alike along one way.
    #[test]
    fn the_way_back_reflects_alike() {
        for (cosine, ior) in [(0.9, 1.5), (0.3, 1.5), (0.05, 2.4), (0.7, 1.02)] {
            let back = dielectric(cosine_beyond(cosine, ior), 1.0 / ior);
            assert!((back - dielectric(cosine, ior)).abs() < 1e-12, "{cosine} {ior}");
        }
    }

    type Complex = [f64; 2];

    fn times(a: Complex, b: Complex) -> Complex {
        [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
    }

    fn over(a: Complex, b: Complex) -> Complex {
        let norm = b[0] * b[0] + b[1] * b[1];
        times(a, [b[0] / norm, -b[1] / norm])
    }

    fn root(a: Complex) -> Complex {
        let length = (a[0] * a[0] + a[1] * a[1]).sqrt();
        let real = (0.5 * (length + a[0])).sqrt();
        [real, 0.5 * a[1] / real]
    }

    /// |(a − b)/(a + b)|².
    fn contrast(a: Complex, b: Complex) -> f64 {
        let [x, y] = over([a[0] - b[0], a[1] - b[1]], [a[0] + b[0], a[1] + b[1]]);
        x * x + y * y
    }

    #[test]
    fn metals_reflect_as_complex_numbers_say() {
        for (n, k) in [(0.14, 3.98), (0.37, 2.39), (1.44, 1.6), (2.9, 3.1), (1.5, 1e-9), (0.05, 4.0)] {
            for cosine in [1.0, 0.9, 0.5, 0.2, 0.01] {
                let index = [n, k];
                let sine = [(1.0 - cosine * cosine), 0.0];
                let quotient = over(sine, times(index, index));
                let beyond = root([1.0 - quotient[0], -quotient[1]]);
                let s = contrast([cosine, 0.0], times(index, beyond));
                let p = contrast(times(index, [cosine, 0.0]), beyond);
                let found = conductor(cosine, n, k);
                assert!((found - 0.5 * (s + p)).abs() < 1e-9, "{n} {k} {cosine}: {found} {}", 0.5 * (s + p));
            }
        }
        for cosine in [1.0, 0.4] {
            assert!((conductor(cosine, 1.5, 0.0) - dielectric(cosine, 1.5)).abs() < 1e-12);
        }
    }

    /// The closed form of Walsh 1926, "The reflection factor of a polished glass surface for diffused light".
    fn walsh(n: f64) -> f64 {
        let ln = func::ln::<Portable>;
        let (n2, n4) = (n * n, n * n * n * n);
        let plus = n2 + 1.0;
        0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0) * (n + 1.0))
            + n2 * (n2 - 1.0) * (n2 - 1.0) / (plus * plus * plus) * ln((n - 1.0) / (n + 1.0))
            - 2.0 * n * n2 * (n2 + 2.0 * n - 1.0) / (plus * (n4 - 1.0))
            + 8.0 * n4 * (n4 + 1.0) / (plus * (n4 - 1.0) * (n4 - 1.0)) * ln(n)
    }

    #[test]
    fn means_over_all_directions_are_those_of_closed_forms() {
        for (ior, error) in [(1.05, 3e-6), (1.33, 1e-6), (1.5, 1e-6), (2.42, 3e-6), (4.0, 2e-5)] {
            assert!(
                (average_dielectric(ior) - walsh(ior)).abs() < error,
                "{ior}: {}",
                average_dielectric(ior) - walsh(ior)
            );
            let inside = 1.0 - (1.0 - walsh(ior)) / (ior * ior);
            assert!((average_dielectric(1.0 / ior) - inside).abs() < error, "{ior}");
        }
        assert!(average_dielectric(1.0) < 1e-30);
        let tint = DVec3::new(0.9, 0.5, 0.0);
        for metal in [Metallic::Tint(tint), Metallic::Measured(Conductor { n: tint, k: DVec3::new(4.0, 2.0, 1.0) })] {
            let parts = 4000;
            let middle = |k: i32| (f64::from(k) + 0.5) / f64::from(parts);
            let sum: DVec3 = (0..parts).map(|k| metal.share(middle(k)) * (2.0 * middle(k))).sum();
            assert!((metal.average() - sum / f64::from(parts)).abs().max_element() < 1e-5, "{metal:?}");
        }
    }
}
