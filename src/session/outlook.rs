//! Where the eye goes when nobody said.
//!
//! In: what was asked of the camera, the surfaces, the part of space that is seen. Out: the camera. Separate from the
//! plan, because here one looks before drawing: a few rays tell from which side most is seen, and whether what proofs
//! cannot exclude is there at all.

use crate::scene::cells::Classify;
use crate::scene::fit::{self, Reach, Stand};
use crate::scene::{Camera, CameraError, View};
use crate::surface::{self, Rectangle, Shape, Surface, Tracer};
use glam::DVec3;
use std::cell::RefCell;
use std::rc::Rc;

/// Rows of the rays that look around: enough to compare sides by, too few to take time.
const ROWS: u32 = 36;

/// Rows of the rays that look whether the picture is empty but for its middle.
const FINE_ROWS: u32 = 96;

/// How much more another side must show to be preferred to the usual one.
const PREFERRED: f64 = 1.5;

/// If what is seen fits into this share of the picture, the rest is lines and points that no ray meets, and the eye
/// comes nearer.
const LOST: f64 = 0.33;

/// The air around what was found by rays, of which the outermost may be missed.
const LOOSE: f64 = 1.12;

/// Formulas of more operations than this are not looked at: rays through them take longer than a look is worth.
const MOST_STEPS: usize = 300;

/// The fewest rays that tell where something is.
const FEWEST: usize = 8;

/// How often the eye comes nearer: each time at least by [`LOST`].
const APPROACHES: u32 = 5;

/// What is known before the eye has a place.
pub(super) struct Outlook<'a> {
    /// What was asked.
    pub view: View,
    /// Which boxes are proven empty.
    pub classify: Classify<'a>,
    /// What there is to see.
    pub surfaces: &'a [Surface],
    /// The part of space that is seen.
    pub shape: Shape,
    /// The picture's width over its height.
    pub aspect: f64,
    /// Whether the point that is looked at was only found, so that it may move.
    pub may_move_aside: bool,
    /// What has been looked at.
    pub seen: RefCell<Seen<'a>>,
}

/// What looks, once something has been looked at, and what was seen: many questions are asked of one look.
#[derive(Default)]
pub(super) struct Seen<'a> {
    tracer: Option<Tracer<'a>>,
    looks: Vec<(Camera, u32, Rc<[DVec3]>)>,
}

/// The eye, and what it looks at.
pub(super) struct Place {
    /// The eye.
    pub camera: Camera,
    /// The point it looks at.
    pub look_at: DVec3,
    /// The middle of what is seen.
    pub center: DVec3,
    /// How far from there it reaches.
    pub radius: f64,
}

impl Outlook<'_> {
    /// The place of the eye. Middle and reach are those of what it sees, so that the same eye has the same, whether it was
    /// found or given.
    ///
    /// # Errors
    /// If the eye has no direction to look in, or the projection shows nothing.
    pub(super) fn place(&self) -> Result<Place, CameraError> {
        let Place { camera, look_at, .. } = self.stand()?;
        let points = self.glances(&camera, ROWS);
        if points.len() < FEWEST {
            return Ok(Place { camera, look_at, center: self.shape.center(), radius: self.shape.size() });
        }
        let center = middle(&points);
        let radius = points.iter().map(|p| p.distance(center)).fold(0.0, f64::max) * LOOSE;
        Ok(Place { camera, look_at, center, radius })
    }

    fn stand(&self) -> Result<Place, CameraError> {
        let center = self.view.look_at.unwrap_or_else(|| self.shape.center());
        let radius = self.shape.size() + (center - self.shape.center()).length();
        let camera = self.view.camera(center, radius, self.aspect)?;
        let usual = Place { camera, look_at: center, center, radius };
        if !self.view.needs_reach() {
            return Ok(usual);
        }
        let usual = self.best_side(usual)?;
        if self.view.parallel_height.is_some() {
            return Ok(usual);
        }
        let slopes = self.view.slopes(self.aspect);
        let bounds = bounds(&self.shape);
        match Reach::of_boxes(self.classify, bounds, center, &usual.camera, slopes) {
            Some(reach) => {
                let points = self.glances(&usual.camera, ROWS);
                self.come_nearer(self.fitted(&usual, &reach, &points)?)
            }
            None => Ok(usual),
        }
    }

    /// The side from which most is seen, if it is much more than from the usual one.
    fn best_side(&self, usual: Place) -> Result<Place, CameraError> {
        let distance = (usual.camera.eye - usual.center).length();
        let mut best = usual;
        let mut most = PREFERRED * self.glances(&best.camera, ROWS).len() as f64;
        for direction in self.view.directions().into_iter().skip(1) {
            let camera = self.view.camera_at(best.center + direction * distance, best.center)?;
            let count = self.glances(&camera, ROWS).len() as f64;
            if count > most {
                (best.camera, most) = (camera, count);
            }
        }
        Ok(best)
    }

    /// Whether the eye may leave the line through the middle.
    fn is_free(&self) -> bool {
        self.may_move_aside && self.view.look_at.is_none() && self.view.orbit.is_none()
    }

    /// Where on the same side all that reaches so far fills the picture.
    fn stand_for(&self, place: &Place, reach: &Reach, points: &[DVec3]) -> Stand {
        let least = fit::least_distance(points, place.center, place.radius, &place.camera);
        if self.is_free() { reach.stand(least) } else { reach.stand_centred(least) }
    }

    /// The place there, with as much air on one side of what is seen as on the other.
    fn fitted(&self, place: &Place, reach: &Reach, points: &[DVec3]) -> Result<Place, CameraError> {
        let old = &place.camera;
        let mut stand = self.stand_for(place, reach, points);
        if self.is_free() {
            let center = place.center + old.right * stand.right + old.up * stand.up;
            let camera = self.view.camera_at(center - old.forward * stand.back, center)?;
            stand = reach.balanced(stand, &self.glances(&camera, ROWS), place.center, old);
        }
        let center = place.center + old.right * stand.right + old.up * stand.up;
        let camera = self.view.camera_at(center - old.forward * stand.back, center)?;
        Ok(Place { camera, look_at: center, center, radius: place.radius })
    }

    /// How far points that are seen from a place reach.
    fn reach_of(&self, points: &[DVec3], place: &Place) -> Option<Reach> {
        let slopes = self.view.slopes(self.aspect).map(|slope| slope / LOOSE);
        Reach::of_points(points, place.center, &place.camera, slopes)
    }

    /// Whether those points are all in a small part of the picture; `None` if they are too few to tell.
    fn is_lost(&self, points: &[DVec3], place: &Place) -> Option<bool> {
        let reach = self.reach_of(points, place).filter(|_| points.len() >= FEWEST)?;
        let camera = &place.camera;
        let depth = |from: DVec3| (middle(points) - from).dot(camera.forward);
        let near = self.stand_for(place, &reach, points).back + depth(place.center);
        Some(near < LOST * depth(camera.eye))
    }

    /// Goes nearer while the picture is empty but for a small part.
    fn come_nearer(&self, mut place: Place) -> Result<Place, CameraError> {
        let mut has_moved = false;
        for _ in 0..APPROACHES {
            // What a few rays find spread over the picture is spread over it, whatever more of them would find.
            if !has_moved && self.is_lost(&self.glances(&place.camera, ROWS), &place) == Some(false) {
                break;
            }
            let points = self.glances(&place.camera, FINE_ROWS);
            let Some(reach) = self.reach_of(&points, &place) else { break };
            let middle = middle(&points);
            let radius = points.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
            let is_lost = self.is_lost(&points, &place) == Some(true);
            if !is_lost && !has_moved {
                break;
            }
            let near = self.fitted(&place, &reach, &points)?;
            // From near, more rays meet it than from far: a last look, and the eye stands where it should.
            place = Place { radius: radius * LOOSE, ..near };
            if !is_lost {
                break;
            }
            has_moved = true;
        }
        Ok(place)
    }

    /// The points that a coarse picture sees.
    fn glances(&self, camera: &Camera, rows: u32) -> Rc<[DVec3]> {
        if self.surfaces.iter().map(Surface::steps).sum::<usize>() > MOST_STEPS {
            return Rc::default();
        }
        let Seen { tracer, looks } = &mut *self.seen.borrow_mut();
        if let Some((.., points)) = looks.iter().find(|(from, of, _)| (from, *of) == (camera, rows)) {
            return points.clone();
        }
        let columns = (f64::from(rows) * self.aspect).clamp(4.0, f64::from(rows * 4)) as u32;
        let whole = Rectangle { left: 0, top: 0, width: columns, height: rows };
        let (mut rays, mut hits) = (Vec::new(), Vec::new());
        let tracer = tracer.get_or_insert_with(|| Tracer::new(self.surfaces, surface::Method::Faithful));
        tracer.trace_rectangle(&camera.screen(columns, rows), whole, &mut hits);
        tracer.rays(&mut rays);
        let drawn = rays.iter().zip(&hits).filter(|(_, hit)| hit.is_drawn());
        let points: Rc<[DVec3]> = drawn.map(|(ray, hit)| ray.at(hit.t)).collect();
        looks.push((*camera, rows, points.clone()));
        points
    }
}

/// The middle of points.
fn middle(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

/// The corners of the box around a shape.
fn bounds(shape: &Shape) -> [DVec3; 2] {
    match *shape {
        Shape::Box { min, max } => [min, max],
        Shape::Ball { center, radius } => [center - DVec3::splat(radius), center + DVec3::splat(radius)],
    }
}
