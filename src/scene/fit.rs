//! Where the eye stands so that what there is to see fills the picture.
//!
//! In: how far things reach in the four directions of the picture. Out: how far away the eye is, and how far aside.
//! A ball around everything would do as well, but most things are not round, and the picture is wider than high.

use super::camera::Camera;
use super::cells::{Classify, Cube};
use super::extreme::extreme;
use glam::DVec3;

/// The share of the picture that is filled, across or upright; the rest is air.
const FILLED: f64 = 0.91;

/// How near the eye may come to the middle of what is seen, in radii of the ball around it: nearer, its front looks
/// too large for its back.
const NEAREST: f64 = 1.65;

/// Boxes asked about for each edge of the picture, and the share of everything to which they are measured.
const EDGE_SEARCH: (u32, f64) = (4000, 1.0 / 128.0);

/// Rounds of balancing: the error becomes a tenth in each.
const ROUNDS: u32 = 6;

/// Two slopes of the picture's edges as seen from the eye: across and upright, over the distance.
pub type Slopes = [f64; 2];

/// Where the eye stands: to the right, up and back from the point that is looked at, which moves aside with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// To the right.
    pub right: f64,
    /// Up.
    pub up: f64,
    /// Back.
    pub back: f64,
}

/// How far things reach: for each edge the largest of (distance towards the edge) + slope · (distance towards the eye),
/// from a centre. The eye sees a thing if its own such distance is as large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    edges: [f64; 4],
    slopes: Slopes,
}

/// How far back from the centre the eye has to stay from points that are seen, or from a ball of this radius if none is.
pub fn least_distance(points: &[DVec3], center: DVec3, radius: f64, camera: &Camera) -> f64 {
    if points.is_empty() {
        return NEAREST * radius;
    }
    let middle = points.iter().sum::<DVec3>() / points.len() as f64;
    let spread = points.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
    NEAREST * spread - (middle - center).dot(camera.forward)
}

/// The directions of the four edges (right, left, top, bottom) as the camera sees them, each with its slope's share of
/// the direction towards the eye.
fn edges(camera: &Camera, slopes: Slopes) -> [DVec3; 4] {
    let [across, upright] = slopes;
    [(camera.right, across), (-camera.right, across), (camera.up, upright), (-camera.up, upright)]
        .map(|(edge, slope)| edge - camera.forward * slope)
}

impl Reach {
    /// Of all that the boxes between `min` and `max` may hold; `None` if they are proven empty.
    pub fn of_boxes(
        classify: Classify,
        [min, max]: [DVec3; 2],
        center: DVec3,
        camera: &Camera,
        slopes: Slopes,
    ) -> Option<Self> {
        let slopes = slopes.map(|slope| slope * FILLED);
        let width = (max - min).max_element() * EDGE_SEARCH.1;
        let mut reach = [0.0; 4];
        for (reach, edge) in reach.iter_mut().zip(edges(camera, slopes)) {
            let key = |cube: &Cube| {
                let (middle, half) = ((cube.min + cube.max) * 0.5, (cube.max - cube.min) * 0.5);
                (middle - center).dot(edge) + half.dot(edge.abs())
            };
            *reach = extreme(classify, Cube { min, max }, width, EDGE_SEARCH.0, &key)?;
        }
        Some(Reach { edges: reach, slopes })
    }

    /// Of points; `None` without any.
    pub fn of_points(points: &[DVec3], center: DVec3, camera: &Camera, slopes: Slopes) -> Option<Self> {
        let slopes = slopes.map(|slope| slope * FILLED);
        let farthest = |edge: DVec3| points.iter().map(|&p| (p - center).dot(edge)).reduce(f64::max);
        let [right, left, top, bottom] = edges(camera, slopes).map(farthest);
        Some(Reach { edges: [right?, left?, top?, bottom?], slopes })
    }

    /// The nearest place from which all of it is seen, at least so far back, for an eye that may move aside.
    pub fn stand(&self, least: f64) -> Stand {
        let ([right, left, top, bottom], [across, upright]) = (self.edges, self.slopes);
        let back = ((right + left) / (2.0 * across)).max((top + bottom) / (2.0 * upright));
        Stand { right: (right - left) / 2.0, up: (top - bottom) / 2.0, back: back.max(least) }
    }

    /// The same for one that stays on the line through the centre.
    pub fn stand_centred(&self, least: f64) -> Stand {
        let ([right, left, top, bottom], [across, upright]) = (self.edges, self.slopes);
        let back = (right.max(left) / across).max(top.max(bottom) / upright);
        Stand { right: 0.0, up: 0.0, back: back.max(least) }
    }

    /// The stand moved aside so that what is seen has as much air on the one side as on the other; all stays in the
    /// picture.
    pub fn balanced(&self, stand: Stand, points: &[DVec3], center: DVec3, camera: &Camera) -> Stand {
        let ([right, left, top, bottom], [across, upright]) = (self.edges, self.slopes);
        let balance = |direction: DVec3, start: f64, plus: f64, minus: f64, slope: f64| {
            let mut place = start;
            for _ in 0..ROUNDS {
                let seen = points.iter().map(|&p| {
                    let depth = stand.back + (p - center).dot(camera.forward);
                    ((p - center).dot(direction) - place) / depth
                });
                let (least, most) = seen.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), s| (a.min(s), b.max(s)));
                if least <= most {
                    place += (least + most) / 2.0 * stand.back;
                }
            }
            let (low, high) = (plus - slope * stand.back, slope * stand.back - minus);
            place.min(high).max(low)
        };
        Stand {
            right: balance(camera.right, stand.right, right, left, across),
            up: balance(camera.up, stand.up, top, bottom, upright),
            back: stand.back,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::camera::Projection;
    use super::super::cells::{Cell, each};
    use super::*;

    const SLOPES: Slopes = [0.5, 0.4];

    fn camera() -> Camera {
        Camera::new(DVec3::new(0.0, -9.0, 0.0), DVec3::ZERO, Projection::Perspective { fov: 40.0 }).unwrap()
    }

    /// Where a point is in the picture, −1..1 each way, from a stand around the origin.
    fn seen(stand: Stand, p: DVec3) -> [f64; 2] {
        let depth = stand.back + p.y;
        [(p.x - stand.right) / depth / SLOPES[0], (p.z - stand.up) / depth / SLOPES[1]]
    }

    #[test]
    fn the_outermost_points_are_as_far_inside_the_edges_as_the_air_is_wide() {
        let points = [DVec3::new(-3.0, 1.0, 0.0), DVec3::new(1.0, -1.0, 0.5), DVec3::new(0.0, 0.0, -0.25)];
        let reach = Reach::of_points(&points, DVec3::ZERO, &camera(), SLOPES).unwrap();
        let free = points.map(|p| seen(reach.stand(0.1), p));
        let outermost = |edge: fn(&[f64; 2]) -> f64| free.iter().map(edge).fold(f64::NEG_INFINITY, f64::max);
        assert!((outermost(|p| p[0]) - FILLED).abs() < 1e-12 && (outermost(|p| -p[0]) - FILLED).abs() < 1e-12);
        assert!(outermost(|p| p[1]) < FILLED && outermost(|p| -p[1]) < FILLED);
        let centred = points.map(|p| seen(reach.stand_centred(0.1), p));
        assert!(centred.iter().flatten().all(|c| c.abs() < FILLED + 1e-12));
        assert!((centred[0][0] + FILLED).abs() < 1e-12);
    }

    #[test]
    fn boxes_reach_as_far_as_what_is_in_them() {
        // A flat plate, |x| ≤ 2, y = 0, |z| ≤ 1/2.
        let plate = |min: DVec3, max: DVec3| {
            let (low, high) = (DVec3::new(-2.0, 0.0, -0.5), DVec3::new(2.0, 0.0, 0.5));
            if min.cmple(high).all() && max.cmpge(low).all() { Cell::Possible } else { Cell::Empty }
        };
        let bounds = [DVec3::splat(-4.0), DVec3::splat(4.0)];
        let stand = Reach::of_boxes(&each(plate), bounds, DVec3::ZERO, &camera(), SLOPES).unwrap().stand(1.0);
        let expected = 2.0 / (SLOPES[0] * FILLED);
        assert!(stand.back >= expected && stand.back < 1.06 * expected, "{stand:?}");
        assert!(stand.right.abs() < 0.05 && stand.up.abs() < 0.05);
        assert_eq!(Reach::of_boxes(&each(|_, _| Cell::Empty), bounds, DVec3::ZERO, &camera(), SLOPES), None);
    }

    #[test]
    fn the_eye_does_not_come_too_near() {
        let reach = Reach::of_points(&[DVec3::ZERO], DVec3::ZERO, &camera(), SLOPES).unwrap();
        assert_eq!((reach.stand(3.0).back, reach.stand_centred(3.0).back), (3.0, 3.0));
        let pair = [DVec3::new(-1.0, 4.0, 0.0), DVec3::new(1.0, 4.0, 0.0)];
        assert_eq!(least_distance(&pair, DVec3::ZERO, 9.0, &camera()), NEAREST - 4.0);
        assert_eq!(least_distance(&[], DVec3::ZERO, 9.0, &camera()), NEAREST * 9.0);
    }

    #[test]
    fn a_balanced_picture_has_the_same_air_on_both_sides() {
        // A floor, of which the near edge looks wider than the far one.
        let points = [DVec3::new(-3.0, -2.0, 0.0), DVec3::new(3.0, -2.0, 0.0), DVec3::new(0.0, 2.0, 0.4)];
        let reach = Reach::of_points(&points, DVec3::ZERO, &camera(), SLOPES).unwrap();
        let stand = reach.balanced(reach.stand(0.1), &points, DVec3::ZERO, &camera());
        let [a, b, c] = points.map(|p| seen(stand, p));
        assert!((a[0] + b[0]).abs() < 1e-4 && (a[1] + c[1]).abs() < 1e-4, "{a:?} {b:?} {c:?}");
        assert!([a, b, c].iter().flatten().all(|s| s.abs() < FILLED + 1e-6));
    }
}
