//! Slopes of a rough surface: the microfacets of Trowbridge and Reitz 1975, called GGX by Walter, Marschner, Li and Torrance 2007,
//! "Microfacet models for refraction through rough surfaces", with the shadows of Smith 1967.
//!
//! In: directions, the width α of the slopes. Out: densities of normals and directions, visible shares. Shares are written so that
//! no grazing direction divides by its cosine.

use super::direction::on_circle;
use glam::DVec3;
use std::f64::consts::PI;

/// Slopes of one width in all directions.
#[derive(Clone, Copy, Debug)]
pub struct Slopes {
    /// α.
    pub alpha: f64,
}

impl Slopes {
    /// How densely facets have normal m, per solid angle.
    fn density(self, m: DVec3) -> f64 {
        let a2 = self.alpha * self.alpha;
        let stretched = m.x * m.x + m.y * m.y + a2 * m.z * m.z;
        a2 / (PI * stretched * stretched)
    }

    /// cosθ·(1 + 2Λ), where 1/(1 + Λ) is the share of facets that is visible from a direction of this cosine.
    fn spread(self, cosine: f64) -> f64 {
        let a2 = self.alpha * self.alpha;
        (cosine * cosine + a2 * (1.0 - cosine * cosine)).sqrt()
    }

    /// A normal of a facet visible from wo, by two numbers of 0..1: those of the half sphere seen from there are a cap (Dupuy and
    /// Benyoub 2023, "Sampling visible GGX normals with spherical caps").
    pub fn visible_normal(self, wo: DVec3, [u, v]: [f64; 2]) -> DVec3 {
        let view = DVec3::new(self.alpha * wo.x, self.alpha * wo.y, wo.z).normalize();
        let z = (1.0 - v) * (1.0 + view.z) - view.z;
        let radius = (1.0 - z * z).max(0.0).sqrt();
        let [x, y] = on_circle(u);
        let half = DVec3::new(radius * x, radius * y, z) + view;
        DVec3::new(self.alpha * half.x, self.alpha * half.y, half.z.max(0.0)).normalize()
    }

    /// The density of [`Slopes::visible_normal`] per solid angle (Heitz 2018, "Sampling the GGX distribution of visible normals",
    /// JCGT 7(4)), over 4·(wo·m).
    pub fn quarter_pdf(self, wo: DVec3, m: DVec3) -> f64 {
        0.5 * self.density(m) / (wo.z + self.spread(wo.z))
    }

    /// Of the light from wo that facets mirror towards wi, the share that leaves: shadow and masking together, correlated by the
    /// facets' height (Heitz 2014, "Understanding the masking-shadowing function", section 6.3), given that wo sees them. The
    /// cosines are of 0..=1.
    pub fn leaving_reflected(self, cosine_o: f64, cosine_i: f64) -> f64 {
        cosine_i * self.masked(cosine_o, cosine_i)
    }

    /// The same over the cosine of wi.
    pub fn masked(self, cosine_o: f64, cosine_i: f64) -> f64 {
        let (spread_o, spread_i) = (self.spread(cosine_o), self.spread(cosine_i));
        (cosine_o + spread_o) / (cosine_o * spread_i + cosine_i * spread_o)
    }

    /// The same for light that facets refract towards wi. Of two ways through, the more hidden one counts: nearly straight ways see
    /// the same facets from both sides (Ashikhmin, Premože and Shirley 2000, "A microfacet-based BRDF generator", section 3), so that
    /// a surface of equal media hides nothing.
    pub fn leaving_refracted(self, cosine_o: f64, cosine_i: f64) -> f64 {
        (cosine_i * self.masked_beyond(cosine_o, cosine_i)).min(1.0)
    }

    /// The same over the cosine of wi.
    pub fn masked_beyond(self, cosine_o: f64, cosine_i: f64) -> f64 {
        let hidden = (cosine_o + self.spread(cosine_o)) / (cosine_o * (cosine_i + self.spread(cosine_i)));
        hidden.min(1.0 / cosine_i)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_those_of_smith_s_lambda() {
        // Λ = (−1 + √(1 + α²tan²θ))/2, from Walter and others 2007, equation 34: seen from one side 1/(1 + Λ); from both, given one,
        // (1 + Λo)/(1 + Λo + Λi) where the heights are one surface's (Heitz 2014, equation 99).
        for alpha in [0.01, 0.2, 0.7, 1.0f64] {
            let slopes = Slopes { alpha };
            let lambda = |cosine: f64| 0.5 * ((1.0 + alpha * alpha * (1.0 / (cosine * cosine) - 1.0)).sqrt() - 1.0);
            for o in [0.02, 0.3, 0.8, 1.0] {
                for i in [0.02, 0.3, 0.8, 1.0] {
                    let expected = (1.0 + lambda(o)) / (1.0 + lambda(o) + lambda(i));
                    let found = slopes.leaving_reflected(o, i);
                    assert!((found - expected).abs() < 1e-12, "{alpha} {o} {i}: {found}, not {expected}");
                    // Through the surface the more hidden way counts: min(G1(o), G1(i)) over G1(o).
                    let expected = ((1.0 + lambda(o)) / (1.0 + lambda(i))).min(1.0);
                    let found = slopes.leaving_refracted(o, i);
                    assert!((found - expected).abs() < 1e-12, "{alpha} {o} {i}: {found} beyond, not {expected}");
                }
                // D(m)·G1/(4 cos) of m = z, where D is 1/(πα²).
                let wo = DVec3::new((1.0 - o * o).sqrt(), 0.0, o);
                let expected = 1.0 / (PI * alpha * alpha) / (1.0 + lambda(o)) / (4.0 * o);
                let found = slopes.quarter_pdf(wo, DVec3::Z);
                assert!((found / expected - 1.0).abs() < 1e-12, "{alpha} {o}: {found}, not {expected}");
            }
        }
    }
}
