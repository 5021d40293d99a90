//! What the centre ray of a pixel knows, small enough to keep for every pixel.
//!
//! In: hits. Out: four bytes a pixel, and which pixels differ from a neighbour so much that one ray is not enough.

use crate::film::Layer;
use crate::surface::Hit;

/// Neighbours whose normals turn by more than this share an edge: the cosine of about 25 degrees.
const SAME_NORMAL: f32 = 0.906;

/// Distances are kept as their exponent and two bits of mantissa; neighbours that differ by more steps than this
/// are on different sheets.
const SAME_DEPTH_STEPS: u32 = 1;

/// How far two colours may be apart, per channel, on a scale that steps about as the eye does.
const SAME_COLOUR: f32 = 0.05;

/// What a centre ray knows: the surface, the normal and the distance, coarsely; 0 for a miss.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Knowledge(u32);

impl Knowledge {
    /// Nothing was hit.
    pub const MISS: Knowledge = Knowledge(0);

    /// Of a hit: 6 bits of surface, 8 + 8 of normal (its x and y, z by its sign), 10 of distance.
    pub fn of(hit: &Hit) -> Self {
        if !hit.is_drawn() {
            return Knowledge::MISS;
        }
        let surface = hit.surface % 63 + 1;
        let distance = (hit.t as f32).to_bits() >> 21 & 0x3ff;
        let [u, v] = octahedral(hit.normal.as_vec3().to_array());
        Knowledge(surface << 26 | u32::from(u) << 18 | u32::from(v) << 10 | distance)
    }

    fn surface(self) -> u32 {
        self.0 >> 26
    }

    fn distance(self) -> u32 {
        self.0 & 0x3ff
    }

    fn normal(self) -> glam::Vec3 {
        from_octahedral([(self.0 >> 18) as u8, (self.0 >> 10) as u8])
    }

    /// Whether both know about the same piece of surface, or both of none.
    pub fn agrees(self, other: Knowledge) -> bool {
        if self == other {
            return true;
        }
        self.surface() == other.surface()
            && self.distance().abs_diff(other.distance()) <= SAME_DEPTH_STEPS
            && self.normal().dot(other.normal()) > SAME_NORMAL
    }
}

/// A direction on the unfolded octahedron (Meyer et al. 2010, "On floating-point normal vectors"), eight bits each way.
fn octahedral([x, y, z]: [f32; 3]) -> [u8; 2] {
    let sum = x.abs() + y.abs() + z.abs();
    let (u, v) = (x / sum, y / sum);
    let folded = if z < 0.0 { ((1.0 - v.abs()).copysign(u), (1.0 - u.abs()).copysign(v)) } else { (u, v) };
    [folded.0, folded.1].map(|c| ((c * 0.5 + 0.5) * 255.0 + 0.5) as u8)
}

fn from_octahedral(bytes: [u8; 2]) -> glam::Vec3 {
    let [u, v] = bytes.map(|byte| f32::from(byte) / 255.0 * 2.0 - 1.0);
    let z = 1.0 - u.abs() - v.abs();
    let (x, y) = if z < 0.0 { ((1.0 - v.abs()).copysign(u), (1.0 - u.abs()).copysign(v)) } else { (u, v) };
    glam::Vec3::new(x, y, z).normalize_or_zero()
}

/// Whether two colours look the same; compared by their roots, which is near to how the eye steps.
pub fn look_alike(a: [f32; 3], b: [f32; 3]) -> bool {
    a.into_iter().zip(b).all(|(a, b)| (a.max(0.0).sqrt() - b.max(0.0).sqrt()).abs() <= SAME_COLOUR)
}

/// Which pixels differ from a neighbour beside, above or below.
pub fn edges(picture: &Layer<[f32; 3]>, known: &Layer<Knowledge>) -> Layer<bool> {
    let (width, height) = (picture.size.width(), picture.size.height());
    let mut edges = Layer::filled(picture.size, false);
    let differ = |a: (u32, u32), b: (u32, u32)| {
        !known.at(a.0, a.1).agrees(known.at(b.0, b.1)) || !look_alike(picture.at(a.0, a.1), picture.at(b.0, b.1))
    };
    for j in 0..height {
        for i in 0..width {
            for other in [(i + 1, j), (i, j + 1)] {
                if other.0 < width && other.1 < height && differ((i, j), other) {
                    edges.set(i, j, true);
                    edges.set(other.0, other.1, true);
                }
            }
        }
    }
    edges
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::Outcome;
    use glam::DVec3;

    fn hit(surface: u32, t: f64, normal: DVec3) -> Hit {
        Hit { outcome: Outcome::Hit, surface, t, normal: normal.normalize(), ..Hit::NONE }
    }

    #[test]
    fn normals_survive_their_sixteen_bits() {
        for k in 0..1000 {
            let (a, b) = (f64::from(k) * 0.7, f64::from(k) * 0.013);
            let n = DVec3::new(a.cos() * b.sin(), a.sin() * b.sin(), b.cos());
            let back = from_octahedral(octahedral(n.as_vec3().to_array()));
            assert!(n.as_vec3().dot(back) > 0.9995, "{n} {back}");
        }
    }

    #[test]
    fn neighbours_agree_only_on_one_piece_of_surface() {
        let rows = [
            (hit(0, 5.0, DVec3::Z), hit(0, 5.1, DVec3::new(0.1, 0.0, 1.0)), true),
            (hit(0, 5.0, DVec3::Z), hit(1, 5.0, DVec3::Z), false),
            (hit(0, 5.0, DVec3::Z), hit(0, 9.0, DVec3::Z), false),
            (hit(0, 5.0, DVec3::Z), hit(0, 5.0, DVec3::X), false),
            (hit(0, 5.0, DVec3::Z), Hit::NONE, false),
            (Hit::NONE, Hit::NONE, true),
        ];
        for (a, b, same) in rows {
            assert_eq!(Knowledge::of(&a).agrees(Knowledge::of(&b)), same, "{a:?} {b:?}");
        }
    }
}
