//! What becomes of light where a ray meets a surface.
//!
//! In: the ray's direction, the normal, the index of refraction, the light. Out: angles, directions, shares. Reflection, Snell's law and
//! Fresnel's formulas are those of Born and Wolf, Principles of Optics (7th ed.), sections 1.5.1 to 1.5.3; the short form is
//! Schlick's ("An Inexpensive BRDF Model for Physically-Based Rendering", Computer Graphics Forum 13(3), 1994, eq. 15).

use crate::num::func;
use crate::num::level::Portable;
use glam::DVec3;

/// What becomes of light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Optics {
    /// The unit normal, against the ray.
    pub normal: DVec3,
    /// Degrees between the normal and the way the ray came.
    pub incidence: f64,
    /// The direction after a mirror, of length 1.
    pub reflected: DVec3,
    /// The direction inside, of length 1, and its angle to the normal in degrees; none at total reflection.
    pub refracted: Option<(DVec3, f64)>,
    /// The share of unpolarised light that is reflected, by Fresnel.
    pub exact: f64,
    /// The same by Schlick.
    pub schlick: f64,
    /// The cosine between the normal and the light, at least 0: the first shading.
    pub cosine: f64,
    /// The cosine between the reflected ray and the light, at least 0: the second.
    pub mirror: f64,
}

/// Degrees of an angle with this cosine.
pub fn degrees(cosine: f64) -> f64 {
    func::acos::<Portable>(cosine.clamp(-1.0, 1.0)) * (180.0 / std::f64::consts::PI)
}

/// What becomes of light that meets a surface with this normal. A ray that comes from where f > 0 (not flipped) enters; one
/// that comes from where f < 0 leaves.
pub fn optics(direction: DVec3, normal: DVec3, is_flipped: bool, ior: f64, light: DVec3) -> Optics {
    let d = direction.normalize();
    let cos_in = -d.dot(normal);
    // Both indices over that outside.
    let (before, behind) = if is_flipped { (ior, 1.0) } else { (1.0, ior) };
    let eta = before / behind;
    let reflected = d + normal * (2.0 * cos_in);
    let sine_squared = eta * eta * (1.0 - cos_in * cos_in).max(0.0);
    let cos_out = (sine_squared <= 1.0).then(|| (1.0 - sine_squared).sqrt());
    let refracted = cos_out.map(|cos_out| {
        let inside = d * eta + normal * (eta * cos_in - cos_out);
        (inside.normalize(), degrees(cos_out))
    });
    let exact = cos_out.map_or(1.0, |cos_out| {
        let across = (before * cos_in - behind * cos_out) / (before * cos_in + behind * cos_out);
        let along = (behind * cos_in - before * cos_out) / (behind * cos_in + before * cos_out);
        0.5 * (across * across + along * along)
    });
    Optics {
        normal,
        incidence: degrees(cos_in),
        reflected,
        refracted,
        exact,
        schlick: schlick(before, behind, cos_in, cos_out),
        cosine: normal.dot(light).max(0.0),
        mirror: reflected.dot(light).max(0.0),
    }
}

/// R₀ + (1 − R₀)(1 − cos θ)⁵, θ being the angle on the thinner side.
fn schlick(before: f64, behind: f64, cos_in: f64, cos_out: Option<f64>) -> f64 {
    let Some(cos_out) = cos_out else { return 1.0 };
    let root = (before - behind) / (before + behind);
    let start = root * root;
    let rest = 1.0 - if before > behind { cos_out } else { cos_in };
    start + (1.0 - start) * rest * rest * rest * rest * rest
}
