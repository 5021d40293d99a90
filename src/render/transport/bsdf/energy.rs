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
const INDICES: usize = 21;

/// Nodes of the roughness, even in it.
const ROUGHNESSES: usize = 16;

/// Nodes of the means over all angles, even in the roughness; closer, for the least means change fast.
const MEANS: usize = 4 * (ROUGHNESSES - 1) + 1;

/// Nodes of the angle, even in [`Warp::of_cosine`].
const ANGLES: usize = 32;

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

type Grid = [[f64; ANGLES]; ROUGHNESSES];

/// The tables of one refractive index, light arriving on one side.
struct Side {
    reflected: Grid,
    lost: Grid,
    mean_reflected: [f64; MEANS],
    /// Over α², with which it falls.
    mean_lost: [f64; MEANS],
}

/// Both sides of the interfaces: on arrival from the thinner medium, from the denser.
static TABLES: [OnceLock<[Side; 2]>; INDICES] = [const { OnceLock::new() }; INDICES];

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
        Place {
            warp: Warp { alpha },
            is_denser_before: ior < 1.0,
            index: Step::new(contrast.max(0.0).sqrt() * (INDICES - 1) as f64, INDICES),
            roughness: Step::new(part * (ROUGHNESSES - 1) as f64, ROUGHNESSES),
            mean: Step::new(part * (MEANS - 1) as f64, MEANS),
        }
    }

    /// The same interface, met from the other side.
    pub fn swapped(self) -> Self {
        Place { is_denser_before: !self.is_denser_before, ..self }
    }

    /// The share of light from this angle that is reflected after meeting one facet.
    pub fn reflected(&self, cosine: f64) -> f64 {
        let angle = self.angle(cosine);
        self.over_indices(|side| self.over_grid(&side.reflected, angle))
    }

    /// The share of light from this angle that is lost after meeting one facet.
    pub fn lost(&self, cosine: f64) -> f64 {
        let angle = self.angle(cosine);
        self.over_indices(|side| self.over_grid(&side.lost, angle))
    }

    /// The mean of [`Place::reflected`] over all directions, weighted by their cosine.
    pub fn mean_reflected(&self) -> f64 {
        self.over_indices(|side| self.mean.of(&side.mean_reflected))
    }

    /// The mean of [`Place::lost`] over all directions, weighted by their cosine.
    pub fn mean_lost(&self) -> f64 {
        self.over_indices(|side| self.mean.of(&side.mean_lost)) * (self.warp.alpha * self.warp.alpha)
    }

    fn angle(&self, cosine: f64) -> Step {
        Step::new(self.warp.of_cosine(cosine) * (ANGLES - 1) as f64, ANGLES)
    }

    fn over_grid(&self, grid: &Grid, angle: Step) -> f64 {
        let Step { at, share } = self.roughness;
        between(angle.of(&grid[at]), angle.of(&grid[at + 1]), share)
    }

    fn over_indices(&self, value: impl Fn(&Side) -> f64) -> f64 {
        let of = |node: usize| value(&sides(node)[usize::from(self.is_denser_before)]);
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

fn sides(node: usize) -> &'static [Side; 2] {
    TABLES[node].get_or_init(|| {
        let root = node as f64 / (INDICES - 1) as f64;
        let contrast = root * root;
        let ior = (1.0 + contrast) / (1.0 - contrast);
        [integrated(ior), integrated(1.0 / ior)]
    })
}

/// The tables of a refractive index.
fn integrated(ior: f64) -> Side {
    let (mut reflected, mut lost) = ([[0.0; ANGLES]; ROUGHNESSES], [[0.0; ANGLES]; ROUGHNESSES]);
    for row in 0..ROUGHNESSES {
        let roughness = roughness(row as f64 / (ROUGHNESSES - 1) as f64);
        let warp = Warp { alpha: roughness * roughness };
        for angle in 0..ANGLES {
            let cosine = warp.cosine(angle as f64 / (ANGLES - 1) as f64).max(LEAST_COSINE);
            [reflected[row][angle], lost[row][angle]] = shares(cosine, ior, warp.alpha);
        }
    }
    let mean_reflected = std::array::from_fn(|mean| averaged(&reflected, mean)[0]);
    let mean_lost = std::array::from_fn(|mean| averaged(&lost, mean)[1]);
    Side { reflected, lost, mean_reflected, mean_lost }
}

/// What stands for a cosine of 0.
const LEAST_COSINE: f64 = 1e-6;

/// Parts around the normal, and away from it, that the visible facets are taken in.
const PARTS: [usize; 2] = [12, 24];

/// The shares of light from this angle that are reflected, and lost, after meeting one facet.
fn shares(cosine: f64, ior: f64, alpha: f64) -> [f64; 2] {
    let slopes = Slopes { alpha };
    let wo = DVec3::new((1.0 - cosine * cosine).max(0.0).sqrt(), 0.0, cosine);
    // Closer together towards the ends, of which one has the few steep facets that lead far away.
    let edge = |along: f64| {
        let t = along / PARTS[1] as f64;
        t * t * (3.0 - 2.0 * t)
    };
    let (mut reflected, mut lost) = (0.0, 0.0);
    for (across, along) in (0..PARTS[0]).flat_map(|a| (0..PARTS[1]).map(move |b| (a as f64, b as f64))) {
        let share = (edge(along + 1.0) - edge(along)) / PARTS[0] as f64;
        // Half a turn is enough, the other half being its mirror image.
        let u = (across + 0.5) / PARTS[0] as f64 * 0.5;
        let m = slopes.visible_normal(wo, [u, edge(along + 0.5)]);
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

/// The mean of what [`Place`] says of single angles, at a node of the means, weighted by their cosine; and that over α².
fn averaged(grid: &Grid, mean: usize) -> [f64; 2] {
    let part = mean as f64 / (MEANS - 1) as f64;
    let row = Step::new(part * (ROUGHNESSES - 1) as f64, ROUGHNESSES);
    let roughness = roughness(part);
    let warp = Warp { alpha: roughness * roughness };
    let edge = |part: usize| {
        let cosine = warp.cosine(part as f64 / MEAN_PARTS as f64);
        cosine * cosine
    };
    let value = |part: usize| {
        let angle = Step::new((part as f64 + 0.5) / MEAN_PARTS as f64 * (ANGLES - 1) as f64, ANGLES);
        between(angle.of(&grid[row.at]), angle.of(&grid[row.at + 1]), row.share)
    };
    let mean = (0..MEAN_PARTS).map(|part| value(part) * (edge(part + 1) - edge(part))).sum::<f64>();
    [mean, mean / (warp.alpha * warp.alpha)]
}
