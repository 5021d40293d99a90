//! Metals whose refractive indices are measured.
//!
//! In: nothing, it is a table. Out: n and k at 650, 550 and 450 nm for red, green and blue, between the rows of the papers by
//! straight lines in the wavelength. Separate because the numbers are not ours.

use super::material::Conductor;
use glam::DVec3;

/// Gold: Johnson and Christy 1972, "Optical constants of the noble metals", table I.
pub const GOLD: Conductor = Conductor { n: DVec3::new(0.156, 0.424, 1.383), k: DVec3::new(3.602, 2.472, 1.915) };

/// Silver: the same table.
pub const SILVER: Conductor = Conductor { n: DVec3::new(0.052, 0.060, 0.040), k: DVec3::new(4.409, 3.597, 2.648) };

/// Copper: the same table.
pub const COPPER: Conductor = Conductor { n: DVec3::new(0.238, 1.007, 1.240), k: DVec3::new(3.626, 2.582, 2.393) };

/// Aluminium: Rakić 1995, "Algorithm for the determination of intrinsic optical constants of metal films: application to
/// aluminum", table II.
pub const ALUMINIUM: Conductor = Conductor { n: DVec3::new(1.558, 1.015, 0.633), k: DVec3::new(7.712, 6.627, 5.454) };

/// Iron: Johnson and Christy 1974, "Optical constants of transition metals", table I.
pub const IRON: Conductor = Conductor { n: DVec3::new(2.911, 2.950, 2.584), k: DVec3::new(3.089, 2.932, 2.767) };

impl Conductor {
    /// The share of light that is reflected at a right angle, seen from air.
    pub fn normal_reflectance(&self) -> DVec3 {
        let (above, below) = (self.n - DVec3::ONE, self.n + DVec3::ONE);
        let square = self.k * self.k;
        (above * above + square) / (below * below + square)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metals_have_the_colours_that_people_know() {
        let [gold, silver, copper, aluminium, iron] =
            [GOLD, SILVER, COPPER, ALUMINIUM, IRON].map(|metal| metal.normal_reflectance());
        assert!(gold.x > 0.9 && gold.x > gold.y && gold.y > 1.9 * gold.z, "{gold}");
        assert!(silver.min_element() > 0.95 && aluminium.min_element() > 0.9, "{silver} {aluminium}");
        assert!(copper.x > 0.9 && copper.y < 0.7 && copper.z < 0.6, "{copper}");
        assert!(iron.max_element() < 0.6 && iron.max_element() - iron.min_element() < 0.05, "{iron}");
    }
}
