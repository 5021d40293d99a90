//! What is asked and what is known about one ray.

use glam::DVec3;

/// Half a line, or a piece of it: the points `origin + t·direction`, 0 ≤ t ≤ end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: DVec3,
    /// Where it goes; of length 1, so that t is a distance.
    pub direction: DVec3,
    /// How far it is looked at; +∞ for all of it.
    pub end: f64,
}

impl Ray {
    /// All of half a line; `direction` is of length 1.
    pub fn new(origin: DVec3, direction: DVec3) -> Self {
        Ray { origin, direction, end: f64::INFINITY }
    }

    /// The point at distance t.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + self.direction * t
    }
}

/// What became of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// No root inside the region.
    Miss,
    /// f changes sign here.
    Hit,
    /// An extremum of f that cannot be told from zero; drawn as a hit, never proven.
    Touch,
    /// The limit of width or work was reached; drawn as a hit, never proven.
    Undecided,
}

/// The first root on a ray, or that there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// What is known.
    pub outcome: Outcome,
    /// Whether the outcome is a proof: always for none but [`Outcome::Miss`] and [`Outcome::Hit`].
    pub proven: bool,
    /// Distance to the root; +∞ for a miss.
    pub t: f64,
    /// How far the true root can be from `t`.
    pub width: f64,
    /// Which surface.
    pub surface: u32,
    /// Which of the surface's sheets: the factor of its equation that is 0 here.
    pub sheet: u32,
    /// Unit gradient of the equation as rewritten, turned against the ray; NaN where there is none.
    pub normal: DVec3,
    /// Whether the gradient itself pointed along the ray (the ray met the side where f is negative),
    /// so that `normal` was turned.
    pub flipped: bool,
    /// How many enclosures of f this ray took.
    pub cost: u32,
}

impl Hit {
    /// No root, not proven yet.
    pub const NONE: Hit = Hit {
        outcome: Outcome::Miss,
        proven: false,
        t: f64::INFINITY,
        width: 0.0,
        surface: 0,
        sheet: 0,
        normal: DVec3::NAN,
        flipped: false,
        cost: 0,
    };

    /// The distance in front of the root, `width` from it, ≥ 0: rays that stay on this side start from there.
    pub fn near(&self) -> f64 {
        (self.t - self.width).max(0.0)
    }

    /// The distance behind the root, `width` from it: rays that pass through start from there.
    pub fn far(&self) -> f64 {
        self.t + self.width
    }

    /// Whether there is something to draw.
    pub fn is_drawn(&self) -> bool {
        self.outcome != Outcome::Miss
    }
}

/// How much was computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Rays asked.
    pub rays: u64,
    /// Evaluations of f alone at a point.
    pub points: u64,
    /// Evaluations of f with its gradient at a point.
    pub gradients: u64,
    /// Enclosures of f (with or without its derivative) over a piece of a ray.
    pub cells: u64,
    /// Rays of rectangles that squares of the screen did not settle, counted for each sheet of a surface.
    pub singles: u64,
}

impl Counts {
    /// Adds another count to this one.
    pub fn add(&mut self, other: &Counts) {
        self.rays += other.rays;
        self.points += other.points;
        self.gradients += other.gradients;
        self.cells += other.cells;
        self.singles += other.singles;
    }
}
