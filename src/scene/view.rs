//! What was asked of the camera, by flags or by the program.
//!
//! In: some of eye, target, field of view, orbit, height. Out: one camera, with what was left open filled in so that
//! what there is to see fills the picture.

use super::angle;
use super::camera::{self, Camera, CameraError, Projection};
use super::fit::Slopes;
use glam::DVec3;

/// The vertical field of view where none is asked for, in degrees: that of a lens of 50 mm in front of 36 mm.
pub const DEFAULT_FOV: f64 = 40.0;

/// From where a thing is seen when nobody says: three-quarter views from above, the usual one first, then from the
/// other front and from behind, for what the first sees edge-on.
const THREE_QUARTERS: [DVec3; 4] = [
    DVec3::new(0.5, -0.76, 0.41),
    DVec3::new(-0.5, -0.76, 0.41),
    DVec3::new(0.5, 0.76, 0.41),
    DVec3::new(-0.5, 0.76, 0.41),
];

/// An eye on a sphere around what it looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// Degrees from x towards y.
    pub azimuth: f64,
    /// Degrees upward.
    pub elevation: f64,
    /// How far; `None`: so that what there is to see fills the picture.
    pub distance: Option<f64>,
}

/// What was asked; what is `None` is found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct View {
    /// Where the eye is.
    pub eye: Option<DVec3>,
    /// Where it is, around the target.
    pub orbit: Option<Orbit>,
    /// The target.
    pub look_at: Option<DVec3>,
    /// Vertical field of view in degrees.
    pub fov: Option<f64>,
    /// Parallel rays, and the picture's height in the world.
    pub parallel_height: Option<f64>,
}

impl View {
    /// This view, with what it leaves open taken from another: an orbit leaves no eye open, nor the other way round.
    pub fn or(self, other: View) -> View {
        let says_eye = self.eye.is_some() || self.orbit.is_some();
        View {
            eye: if says_eye { self.eye } else { other.eye },
            orbit: if says_eye { self.orbit } else { other.orbit },
            look_at: self.look_at.or(other.look_at),
            fov: self.fov.or(other.fov),
            parallel_height: self.parallel_height.or(other.parallel_height),
        }
    }

    /// Whether the distance of the eye depends on how far the surfaces reach.
    pub fn needs_reach(&self) -> bool {
        self.eye.is_none() && self.orbit.is_none_or(|orbit| orbit.distance.is_none())
    }

    /// The directions from the target towards the eye that the view leaves open, the best known first.
    pub fn directions(&self) -> Vec<DVec3> {
        match self.orbit {
            Some(orbit) => vec![camera::orbit(DVec3::ZERO, orbit.azimuth, orbit.elevation, 1.0)],
            None => THREE_QUARTERS.map(DVec3::normalize).to_vec(),
        }
    }

    /// The slopes of the picture's edges as seen from the eye, across and upright.
    pub fn slopes(&self, aspect: f64) -> Slopes {
        let upright = angle::tangent(self.fov.unwrap_or(DEFAULT_FOV) / 2.0);
        [upright * aspect, upright]
    }

    /// The camera, for what reaches `radius` far around `look_at`, in a picture `aspect` times as wide as high.
    ///
    /// # Errors
    /// If the eye has no direction to look in, or the projection shows nothing.
    pub fn camera(&self, look_at: DVec3, radius: f64, aspect: f64) -> Result<Camera, CameraError> {
        let distance = || fitting_distance(radius, self.slopes(aspect));
        let eye = match (self.eye, self.orbit) {
            (Some(eye), _) => eye,
            (None, Some(orbit)) => {
                let distance = orbit.distance.unwrap_or_else(distance);
                camera::orbit(look_at, orbit.azimuth, orbit.elevation, distance)
            }
            (None, None) => look_at + self.directions()[0] * distance(),
        };
        self.camera_at(eye, look_at)
    }

    /// The camera at `eye`, with the projection that was asked for.
    ///
    /// # Errors
    /// If the eye has no direction to look in, or the projection shows nothing.
    pub fn camera_at(&self, eye: DVec3, look_at: DVec3) -> Result<Camera, CameraError> {
        let fov = self.fov.unwrap_or(DEFAULT_FOV);
        if !(fov > 0.0 && fov < 180.0) {
            return Err(CameraError::FieldOfView);
        }
        let projection = match self.parallel_height {
            Some(height) => Projection::Parallel { height },
            None => Projection::Perspective { fov },
        };
        Camera::new(eye, look_at, projection)
    }
}

/// From how far a ball just touches the nearer edges of the picture: r / sin of half the smaller field of view.
fn fitting_distance(radius: f64, slopes: Slopes) -> f64 {
    let smaller = slopes[0].min(slopes[1]);
    // sin(atan(s)) = s / √(1 + s²).
    radius * (1.0 + smaller * smaller).sqrt() / smaller
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_framed_ball_touches_the_edge_of_the_picture() {
        for (aspect, edge) in [(2.0, DVec3::Z), (1.0, DVec3::Z), (0.5, DVec3::X)] {
            let view =
                View { orbit: Some(Orbit { azimuth: -90.0, elevation: 0.0, distance: None }), ..View::default() };
            let camera = view.camera(DVec3::ZERO, 2.0, aspect).unwrap();
            let (width, height) = ((1000.0 * aspect) as u32, 1000);
            let (across, down) =
                if edge == DVec3::Z { (f64::from(width) / 2.0, 0.0) } else { (f64::from(width), 500.0) };
            let ray = camera.ray(width, height, across, down);
            let nearest = (ray.origin - ray.direction * ray.origin.dot(ray.direction)).length();
            assert!((nearest - 2.0).abs() < 1e-9, "{aspect}: {nearest}");
        }
    }

    #[test]
    fn flags_win_over_the_program_and_an_orbit_replaces_its_eye() {
        let file = View { eye: Some(DVec3::X), fov: Some(30.0), ..View::default() };
        let orbit = Orbit { azimuth: 1.0, elevation: 2.0, distance: Some(3.0) };
        let flags = View { orbit: Some(orbit), ..View::default() };
        assert_eq!(flags.or(file), View { orbit: Some(orbit), fov: Some(30.0), ..View::default() });
        assert_eq!(View::default().or(file), file);
    }
}
