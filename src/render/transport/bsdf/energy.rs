//! What rough interfaces reflect and lose.
//!
//! In: roughness, relative refractive index, an angle. Out, of light that meets one facet and no other:
//! - the share that is reflected ([`Place::reflected`]),
//! - the share that neither leaves above nor below, because other facets are in the way ([`Place::lost`]),
//! - their means over all directions.
//!
//! Made by integration at first use, with sums, products and square roots alone, so the same on every machine; separate because
//! metal, plastic and glass all stand on it.

use super::SMOOTH_ALPHA;
use super::direction::{reflected, refracted};
use super::fresnel::{cosine_beyond, dielectric};
use super::ggx::Slopes;
use glam::DVec3;
use std::sync::OnceLock;

/// Nodes of the refractive index from equal to infinitely different, even in the fourth root of the reflectance at a right angle.
const INDICES: usize = 41;

/// Nodes of the roughness, even in it.
const ROUGHNESSES: usize = 16;

/// Parts between two nodes of the roughness that have means over all angles; closer, for the least means change fast.
const MEANS: usize = 4;

/// Nodes of the angle, even in [`Warp::of_cosine`].
const ANGLES: usize = 48;

/// The roughness at a part of 0..=1 of what there is.
fn roughness(part: f64) -> f64 {
    let least = SMOOTH_ALPHA.sqrt();
    least + (1.0 - least) * part
}

/// The inverse, of its square.
fn position_of(alpha: f64) -> f64 {
    let least = SMOOTH_ALPHA.sqrt();
    (alpha.sqrt() - least) / (1.0 - least)
}

/// The shares of light at one refractive index and roughness, by angle, light arriving on one side.
struct Shares {
    reflected: [f64; ANGLES],
    lost: [f64; ANGLES],
}

/// Their means over all directions, from one node of the roughness to the next.
struct Means {
    reflected: [f64; MEANS + 1],
    /// Over α², with which it falls.
    lost: [f64; MEANS + 1],
}

/// Of both sides of an interface: on arrival from the thinner medium, from the denser.
type Sides<T> = [T; 2];

/// By refractive index and roughness, made where they are asked for: a scene has few of each.
static SHARES: [[OnceLock<Sides<Shares>>; ROUGHNESSES]; INDICES] =
    [const { [const { OnceLock::new() }; ROUGHNESSES] }; INDICES];

static MEAN_SHARES: [[OnceLock<Sides<Means>>; ROUGHNESSES - 1]; INDICES] =
    [const { [const { OnceLock::new() }; ROUGHNESSES - 1] }; INDICES];

/// Where in the tables an interface is.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    warp: Warp,
    is_denser_before: bool,
    index: Step,
    roughness: Step,
    mean: Step,
}

/// Between node `at` and the next.
#[derive(Clone, Copy, Debug)]
struct Step {
    at: usize,
    share: f64,
}

impl Step {
    /// `position` in steps, among so many nodes.
    fn new(position: f64, nodes: usize) -> Self {
        let at = (position.max(0.0) as usize).min(nodes - 2);
        Step { at, share: (position - at as f64).clamp(0.0, 1.0) }
    }

    fn of<const N: usize>(self, row: &[f64; N]) -> f64 {
        between(row[self.at], row[self.at + 1], self.share)
    }
}

fn between(a: f64, b: f64, share: f64) -> f64 {
    a + (b - a) * share
}

impl Place {
    /// `ior` is the refractive index beyond over that before; 0 and infinity reflect all.
    pub fn new(ior: f64, alpha: f64) -> Self {
        let contrast = if ior < 1.0 { (1.0 - ior) / (1.0 + ior) } else { 1.0 - 2.0 / (1.0 + ior) };
        let part = position_of(alpha);
        let roughness = Step::new(part * (ROUGHNESSES - 1) as f64, ROUGHNESSES);
        Place {
            warp: Warp { alpha },
            is_denser_before: ior < 1.0,
            index: Step::new(contrast.max(0.0).sqrt() * (INDICES - 1) as f64, INDICES),
            roughness,
            mean: Step::new((part * (ROUGHNESSES - 1) as f64 - roughness.at as f64) * MEANS as f64, MEANS + 1),
        }
    }

    /// The same interface, met from the other side.
    pub fn swapped(self) -> Self {
        Place { is_denser_before: !self.is_denser_before, ..self }
    }

    /// The share of light from this angle that is reflected after meeting one facet.
    pub fn reflected(&self, cosine: f64) -> f64 {
        let angle = self.angle(cosine);
        self.of_shares(|shares| angle.of(&shares.reflected))
    }

    /// The share of light from this angle that is lost after meeting one facet.
    pub fn lost(&self, cosine: f64) -> f64 {
        let angle = self.angle(cosine);
        self.of_shares(|shares| angle.of(&shares.lost))
    }

    /// The mean of [`Place::reflected`] over all directions, weighted by their cosine.
    pub fn mean_reflected(&self) -> f64 {
        self.of_means(|means| self.mean.of(&means.reflected))
    }

    /// The mean of [`Place::lost`] over all directions, weighted by their cosine.
    pub fn mean_lost(&self) -> f64 {
        self.of_means(|means| self.mean.of(&means.lost)) * (self.warp.alpha * self.warp.alpha)
    }

    fn angle(&self, cosine: f64) -> Step {
        Step::new(self.warp.of_cosine(cosine) * (ANGLES - 1) as f64, ANGLES)
    }

    fn of_shares(&self, value: impl Fn(&Shares) -> f64) -> f64 {
        let Step { at, share } = self.roughness;
        let side = usize::from(self.is_denser_before);
        let of = |node: usize, row: usize| value(&shares_at(node, row)[side]);
        self.over_indices(|node| between(of(node, at), of(node, at + 1), share))
    }

    fn of_means(&self, value: impl Fn(&Means) -> f64) -> f64 {
        let side = usize::from(self.is_denser_before);
        self.over_indices(|node| value(&means_at(node, self.roughness.at)[side]))
    }

    fn over_indices(&self, of: impl Fn(usize) -> f64) -> f64 {
        match self.index {
            // No table for nothing.
            Step { at, share: 1.0 } => of(at + 1),
            Step { at, share } => between(of(at), of(at + 1), share),
        }
    }
}

/// Angles on a scale of 0..=1 on which everything is smooth: half of it for what changes where the cosine is about as small as the
/// slopes, half for what changes with Fresnel's law.
#[derive(Clone, Copy, Debug)]
struct Warp {
    alpha: f64,
}

/// The cosine up to which Fresnel's law bends most.
const BEND: f64 = 0.25;

impl Warp {
    fn of_cosine(self, cosine: f64) -> f64 {
        let hyperbola = |a: f64| (1.0 + a) * cosine / (cosine + a);
        0.5 * (hyperbola(BEND) + hyperbola(self.alpha))
    }

    /// The inverse: the positive root of a quadratic.
    fn cosine(self, warped: f64) -> f64 {
        let (a, b, s) = (self.alpha, BEND, 2.0 * warped);
        let square = 2.0 + a + b - s;
        let linear = a * (1.0 + b) + b * (1.0 + a) - s * (a + b);
        let root = (linear * linear + 4.0 * square * s * a * b).sqrt();
        // Whichever way does not subtract nearly equal numbers.
        if linear > 0.0 { 2.0 * s * a * b / (linear + root) } else { (root - linear) / (2.0 * square) }.min(1.0)
    }
}

/// The refractive indices beyond over before of a node, on arrival from the thinner medium, and from the denser.
fn indices(node: usize) -> Sides<f64> {
    let root = node as f64 / (INDICES - 1) as f64;
    let contrast = root * root;
    let ior = (1.0 + contrast) / (1.0 - contrast);
    [ior, 1.0 / ior]
}

fn shares_at(node: usize, row: usize) -> &'static Sides<Shares> {
    SHARES[node][row].get_or_init(|| {
        let roughness = roughness(row as f64 / (ROUGHNESSES - 1) as f64);
        let warp = Warp { alpha: roughness * roughness };
        indices(node).map(|ior| {
            let mut all = Shares { reflected: [0.0; ANGLES], lost: [0.0; ANGLES] };
            for angle in 0..ANGLES {
                let cosine = warp.cosine(angle as f64 / (ANGLES - 1) as f64).max(LEAST_COSINE);
                [all.reflected[angle], all.lost[angle]] = shares(cosine, ior, warp.alpha);
            }
            all
        })
    })
}

fn means_at(node: usize, row: usize) -> &'static Sides<Means> {
    MEAN_SHARES[node][row].get_or_init(|| {
        let (these, next) = (shares_at(node, row), shares_at(node, row + 1));
        std::array::from_fn(|side| {
            let (a, b) = (&these[side], &next[side]);
            Means {
                reflected: std::array::from_fn(|part| averaged([&a.reflected, &b.reflected], row, part)[0]),
                lost: std::array::from_fn(|part| averaged([&a.lost, &b.lost], row, part)[1]),
            }
        })
    })
}

/// What stands for a cosine of 0.
const LEAST_COSINE: f64 = 1e-6;

/// The visible facets are taken at the points (k/F_n, k·F_(n−1)/F_n) of a lattice by two of Fibonacci's numbers, which are even in all
/// directions and cross the edges of what leaves and what does not aslant (Sloan and Joe 1994, "Lattice Methods for Multiple
/// Integration", section 4.8).
const LATTICE: [u32; 2] = [1597, 987];

/// The shares of light from this angle that are reflected, and lost, after meeting one facet.
fn shares(cosine: f64, ior: f64, alpha: f64) -> [f64; 2] {
    let slopes = Slopes { alpha };
    let wo = DVec3::new((1.0 - cosine * cosine).max(0.0).sqrt(), 0.0, cosine);
    let (mut reflected, mut lost) = (0.0, 0.0);
    for k in 0..LATTICE[0] {
        let part = |k: u32| (f64::from(k) + 0.5) / f64::from(LATTICE[0]);
        // Half a turn is enough, the other half being its mirror image.
        let u = part(k) * 0.5;
        // Closer together towards the ends, of which one has the few steep facets that lead far away.
        let t = part(k * LATTICE[1] % LATTICE[0]);
        let (along, share) = (t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) / f64::from(LATTICE[0]));
        let m = slopes.visible_normal(wo, [u, along]);
        let [up, down] = leaving(slopes, wo, m, ior);
        reflected += share * up;
        lost += share * (1.0 - up - down);
    }
    [reflected, lost.max(0.0)]
}

/// The shares of light from wo on a facet of normal m that leave above and below.
fn leaving(slopes: Slopes, wo: DVec3, m: DVec3, ior: f64) -> [f64; 2] {
    let facing = wo.dot(m);
    let reflectance = if ior > 0.0 && ior.is_finite() { dielectric(facing, ior) } else { 1.0 };
    let up = reflected(wo, m).z;
    let above = if up > 0.0 { reflectance * slopes.leaving_reflected(wo.z, up) } else { 0.0 };
    if reflectance >= 1.0 {
        return [above, 0.0];
    }
    let down = -refracted(wo, m, ior, cosine_beyond(facing, ior)).z;
    let below = if down > 0.0 { (1.0 - reflectance) * slopes.leaving_refracted(wo.z, down) } else { 0.0 };
    [above, below]
}

/// Parts that the mean over all angles is taken in.
const MEAN_PARTS: usize = 256;

/// The mean of what [`Place`] says of single angles, at a part of the way from one row to the next, weighted by their cosine; and that
/// over α².
fn averaged(rows: [&[f64; ANGLES]; 2], row: usize, part: usize) -> [f64; 2] {
    let share = part as f64 / MEANS as f64;
    let roughness = roughness((row as f64 + share) / (ROUGHNESSES - 1) as f64);
    let warp = Warp { alpha: roughness * roughness };
    let edge = |part: usize| {
        let cosine = warp.cosine(part as f64 / MEAN_PARTS as f64);
        cosine * cosine
    };
    let value = |part: usize| {
        let angle = Step::new((part as f64 + 0.5) / MEAN_PARTS as f64 * (ANGLES - 1) as f64, ANGLES);
        between(angle.of(rows[0]), angle.of(rows[1]), share)
    };
    let mean = (0..MEAN_PARTS).map(|part| value(part) * (edge(part + 1) - edge(part))).sum::<f64>();
    [mean, mean / (warp.alpha * warp.alpha)]
}
