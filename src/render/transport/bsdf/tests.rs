//! Scattering against integrals and closed forms.

mod quadrature;

use super::*;
use crate::render::transport::sobol::numbers;
use crate::scene::material::{Conductor, Dielectric};

const ROUGHNESSES: [f64; 6] = [0.0, 0.05, 0.2, 0.5, 0.8, 1.0];

const COSINES: [f64; 7] = [1.0, 0.8, 0.5, 0.2, 0.05, 0.01, 0.002];

const GLASS: Kind =
    Kind::Glass(Dielectric { ior: 1.5, absorption: DVec3::ZERO, inside_is_negative: true, priority: 0 });

/// About that of gold.
const GOLD: Conductor = Conductor { n: DVec3::new(0.14, 0.37, 1.44), k: DVec3::new(3.98, 2.39, 1.60) };

/// A row of the table: a name, a kind, its colour, the relative refractive index, and whether it must reflect or transmit all.
type Row = (&'static str, Kind, DVec3, f64, bool);

const ROWS: [Row; 17] = [
    ("white matte", Kind::Matte, DVec3::ONE, 1.0, true),
    ("matte", Kind::Matte, DVec3::new(0.2, 0.5, 0.8), 1.0, false),
    ("white mirror", Kind::Mirror, DVec3::ONE, 1.0, true),
    ("white metal", Kind::Metal(None), DVec3::ONE, 1.0, true),
    ("tinted metal", Kind::Metal(None), DVec3::new(0.9, 0.5, 0.1), 1.0, false),
    ("gold", Kind::Metal(Some(GOLD)), DVec3::ONE, 1.0, false),
    ("white plastic", Kind::Plastic { ior: 1.5 }, DVec3::ONE, 1.0, true),
    ("thin white plastic", Kind::Plastic { ior: 1.12 }, DVec3::ONE, 1.0, true),
    ("dense plastic", Kind::Plastic { ior: 2.4 }, DVec3::new(0.9, 0.3, 0.0), 1.0, false),
    ("glass", GLASS, DVec3::ONE, 1.5, true),
    ("glass from inside", GLASS, DVec3::ONE, 1.0 / 1.5, true),
    ("water", GLASS, DVec3::ONE, 1.33, true),
    ("water from inside", GLASS, DVec3::ONE, 1.0 / 1.33, true),
    ("diamond", GLASS, DVec3::ONE, 2.42, true),
    ("diamond from inside", GLASS, DVec3::ONE, 1.0 / 2.42, true),
    ("glass in oil", GLASS, DVec3::ONE, 1.04, true),
    ("nothing", GLASS, DVec3::ONE, 1.0, true),
];

/// Every row at every roughness.
fn cases() -> impl Iterator<Item = (String, Row, Bsdf, f64)> {
    ROWS.into_iter().flat_map(|row| ROUGHNESSES.map(|roughness| (row, roughness))).map(|(row, roughness)| {
        let bsdf = Bsdf::new(&row.1, row.2, roughness, row.3);
        (format!("{}, roughness {roughness}", row.0), row, bsdf, roughness)
    })
}

fn view(cosine: f64) -> DVec3 {
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    DVec3::new(0.6 * sine, -0.8 * sine, cosine)
}

/// What is known of all directions together, by integration or by samples: the probability of a direction with a density, the light
/// that takes it, and three moments.
#[derive(Clone, Copy, Debug, Default)]
struct Totals {
    pdf: f64,
    light: DVec3,
    moments: DVec3,
}

impl Totals {
    fn add(&mut self, wi: DVec3, pdf: f64, light: DVec3) {
        self.pdf += pdf;
        self.light += light;
        self.moments += DVec3::new(wi.x, wi.z, wi.z * wi.z) * pdf;
    }
}

fn integrated(bsdf: &Bsdf, ior: f64, roughness: f64, wo: DVec3) -> Totals {
    let mut totals = Totals::default();
    if bsdf.is_specular() {
        return totals;
    }
    let alpha = (roughness * roughness).max(SMOOTH_ALPHA);
    for is_above in [true, false].into_iter().filter(|above| *above || matches!(bsdf, Bsdf::Glass(_))) {
        for (wi, share) in quadrature::directions(wo, alpha, ior, is_above) {
            totals.add(wi, bsdf.pdf(wo, wi) * share, bsdf.value(wo, wi, Transport::Importance) * (wi.z.abs() * share));
        }
    }
    totals
}

const SAMPLES: u32 = 1 << 14;

fn samples(bsdf: &Bsdf, wo: DVec3, transport: Transport) -> impl Iterator<Item = Option<Sample>> {
    (0..SAMPLES).map(move |k| {
        let ([u, v], [w, _]) = (numbers(1, k, 0, 0), numbers(1, k, 1, 0));
        bsdf.sample(wo, [u, v, w], transport)
    })
}

/// The totals by samples, those of mirror-like parts apart.
fn sampled(bsdf: &Bsdf, wo: DVec3) -> [Totals; 2] {
    let mut totals = [Totals::default(); 2];
    let share = 1.0 / f64::from(SAMPLES);
    for sample in samples(bsdf, wo, Transport::Importance).flatten() {
        totals[usize::from(sample.is_specular)].add(sample.wi, share, sample.weight * share);
    }
    totals
}

/// How far the totals of so many samples may be from integrals: more than twice the deviation of independent samples whose weights
/// deviate by 1.
const NOISE: f64 = 0.02;

#[test]
fn samples_have_the_density_that_is_stated_and_bring_the_light_that_is_integrated() {
    for (name, row, bsdf, roughness) in cases() {
        for cosine in COSINES {
            let wo = view(cosine);
            let (whole, [by_samples, mirrored]) = (integrated(&bsdf, row.3, roughness, wo), sampled(&bsdf, wo));
            let place = format!("{name}, cosine {cosine}:\n{whole:?}\n{by_samples:?}\n{mirrored:?}");
            assert!((whole.pdf - by_samples.pdf).abs() < NOISE, "density of {place}");
            assert!((whole.moments - by_samples.moments).abs().max_element() < NOISE, "moments of {place}");
            assert!((whole.light - by_samples.light).abs().max_element() < NOISE, "light of {place}");
            let all = whole.light + mirrored.light;
            assert!(all.max_element() < 1.01, "gains light: {all} at {place}");
            assert!(!row.4 || (all - 1.0).abs().max_element() < 0.01, "furnace shows {all} at {place}");
        }
    }
}

#[test]
fn samples_agree_with_value_and_density() {
    for (name, row, bsdf, _) in cases() {
        for (cosine, transport) in
            COSINES.into_iter().flat_map(|c| [(c, Transport::Radiance), (c, Transport::Importance)])
        {
            let wo = view(cosine);
            for sample in samples(&bsdf, wo, transport).step_by(64).flatten() {
                let place = format!("{name}, cosine {cosine}, {transport:?}: {sample:?}");
                assert!((sample.wi.length() - 1.0).abs() < 1e-9 && sample.pdf > 0.0, "{place}");
                assert_eq!(sample.is_transmission, sample.wi.z < 0.0, "{place}");
                if sample.is_specular {
                    let sine =
                        DVec3::new(sample.wi.x, sample.wi.y, 0.0) * if sample.is_transmission { row.3 } else { 1.0 };
                    assert!((sine + DVec3::new(wo.x, wo.y, 0.0)).length() < 1e-9, "Snell at {place}");
                    continue;
                }
                let pdf = bsdf.pdf(wo, sample.wi);
                let weight = bsdf.value(wo, sample.wi, transport) * (sample.wi.z.abs() / pdf);
                assert!((pdf / sample.pdf - 1.0).abs() < 1e-6, "density {pdf} at {place}");
                assert!(
                    (weight - sample.weight).abs().max_element() <= 1e-6 * weight.max_element(),
                    "weight {weight} at {place}"
                );
            }
        }
    }
}

#[test]
fn mirror_like_parts_carry_their_share() {
    // Material, relative index, whether through, transport, weight times probability.
    let plain = (1.5f64 - 1.0) / 2.5 * (0.5 / 2.5);
    let rows = [
        (Kind::Mirror, 1.0, false, Transport::Radiance, 0.7),
        (Kind::Metal(None), 1.0, false, Transport::Importance, 0.7),
        (Kind::Plastic { ior: 1.5 }, 1.0, false, Transport::Radiance, plain),
        (GLASS, 1.5, false, Transport::Radiance, plain),
        (GLASS, 1.5, true, Transport::Radiance, (1.0 - plain) / 2.25),
        (GLASS, 1.5, true, Transport::Importance, 1.0 - plain),
        (GLASS, 1.0 / 1.5, true, Transport::Radiance, (1.0 - plain) * 2.25),
        (GLASS, 1.0, true, Transport::Radiance, 1.0),
    ];
    for (kind, ior, is_transmission, transport, expected) in rows {
        let bsdf = Bsdf::new(&kind, DVec3::splat(0.7), 0.0, ior);
        let found = samples(&bsdf, DVec3::Z, transport).flatten();
        let mirrored: Vec<Sample> = found.filter(|s| s.is_specular && s.is_transmission == is_transmission).collect();
        let share = mirrored.len() as f64 / f64::from(SAMPLES);
        let sample = mirrored[0];
        assert!((sample.weight.x * sample.pdf - expected).abs() < 1e-12, "{kind:?} {ior}: {sample:?}");
        assert!((share - sample.pdf).abs() < 1e-3, "{kind:?} {ior}: taken with {share}, stated {}", sample.pdf);
    }
    let beyond_critical = Bsdf::new(&GLASS, DVec3::ONE, 0.0, 1.0 / 1.5);
    let all: Vec<Sample> = samples(&beyond_critical, view(0.74), Transport::Radiance).flatten().collect();
    assert!(all.len() == SAMPLES as usize && all.iter().all(|s| !s.is_transmission && s.weight == DVec3::ONE));
    assert!(samples(&beyond_critical, view(0.75), Transport::Radiance).flatten().any(|s| s.is_transmission));
}

/// Pairs of directions of both sides, at every angle.
fn pairs() -> Vec<(DVec3, DVec3)> {
    let onward = |height: f64| {
        (0..5).map(move |k| {
            let [x, y] = direction::on_circle(0.13 + 0.2 * f64::from(k));
            let flat = (1.0 - height * height).sqrt();
            DVec3::new(flat * x, flat * y, height)
        })
    };
    let heights = [0.99, 0.6, 0.1, 0.01, -0.01, -0.1, -0.6, -0.99];
    COSINES
        .into_iter()
        .flat_map(|cosine| heights.map(|h| (view(cosine), h)))
        .flat_map(|(wo, h)| onward(h).map(move |wi| (wo, wi)))
        .collect()
}

fn near(a: DVec3, b: DVec3) -> bool {
    (a - b).abs().max_element() <= 1e-7 * (a.abs().max_element() + b.abs().max_element())
}

#[test]
fn scattering_is_reciprocal() {
    for (name, row, bsdf, roughness) in cases() {
        let swapped = Bsdf::new(&row.1, row.2, roughness, 1.0 / row.3);
        for (wo, wi) in pairs() {
            let place = format!("{name}: {wo} {wi}");
            let value = bsdf.value(wo, wi, Transport::Importance);
            let radiance = bsdf.value(wo, wi, Transport::Radiance);
            if wi.z > 0.0 {
                assert!(near(value, bsdf.value(wi, wo, Transport::Importance)) && value == radiance, "{place}");
                assert_eq!(bsdf.reverse_pdf(wo, wi), bsdf.pdf(wi, wo), "{place}");
                continue;
            }
            let (back, on) = (turned(wi), turned(wo));
            let reverse = swapped.value(back, on, Transport::Importance);
            assert!(near(value, reverse * (row.3 * row.3)), "{place}: {value} {reverse}");
            assert!(near(radiance, reverse), "{place}: {radiance} {reverse}");
            let (reverse, stated) = (swapped.pdf(back, on), bsdf.reverse_pdf(wo, wi));
            assert!(near(DVec3::splat(reverse), DVec3::splat(stated)), "{place}: {reverse} {stated}");
        }
    }
}

#[test]
fn nothing_comes_from_below_the_surface() {
    for (name, row, bsdf, _) in cases() {
        let (below, wi) = (view(-0.3), view(0.5));
        for wo in [below, view(0.0)] {
            assert_eq!(bsdf.value(wo, wi, Transport::Radiance), DVec3::ZERO, "{name}");
            assert_eq!(bsdf.pdf(wo, wi), 0.0, "{name}");
            assert_eq!(bsdf.sample(wo, [0.5; 3], Transport::Radiance), None, "{name}");
        }
        if !matches!(row.1, Kind::Glass(_)) {
            assert_eq!(bsdf.value(wi, below, Transport::Radiance), DVec3::ZERO, "{name}");
            assert_eq!(bsdf.pdf(wi, below), 0.0, "{name}");
        }
    }
}

#[test]
fn a_coat_over_grey_reflects_what_the_series_below_it_says() {
    // F of the coat; of the rest a(1 − I)/(1 − aI), I the mean share that the coat throws back from below: 1 − (1 − M)/n², M Walsh's
    // mean from above (Saunderson 1942). M is 0.09178 of n = 1.5.
    for albedo in [0.0, 0.2, 0.5, 0.9] {
        let bsdf = Bsdf::new(&Kind::Plastic { ior: 1.5 }, DVec3::splat(albedo), 0.0, 1.0);
        let inner = 1.0 - (1.0 - 0.091_777_96) / 2.25;
        for cosine in [1.0, 0.6, 0.3] {
            let wo = view(cosine);
            let coat = fresnel::dielectric(cosine, 1.5);
            let expected = coat + (1.0 - coat) * albedo * (1.0 - inner) / (1.0 - albedo * inner);
            let [spread, mirrored] = sampled(&bsdf, wo);
            let found = (spread.light + mirrored.light).x;
            assert!((found - expected).abs() < 2e-3, "{albedo} {cosine}: {found}, not {expected}");
        }
    }
}
