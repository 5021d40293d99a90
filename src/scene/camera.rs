//! The eye: which ray belongs to which pixel.
//!
//! In: where the eye is, what it looks at, how wide it sees. Out: the ray through any point of the picture.
//! Right-handed world, z up.

use super::angle;
use crate::surface::{Ray, Screen};
use glam::DVec3;
use std::fmt;

/// The shortest `F × up` that still says where right is; below it the view is along z, and y is up instead.
const MIN_RIGHT: f64 = 1e-9;

/// How the rays leave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// From one point; the vertical field of view in degrees, more than 0 and less than 180.
    Perspective {
        /// Degrees from the lower to the upper edge.
        fov: f64,
    },
    /// From a plane, all in one direction.
    Parallel {
        /// Height of the picture in units of the world.
        height: f64,
    },
}

/// So many pixels outside the picture a filter may still reach it.
const MARGIN: f64 = 2.0;

/// How the eye sees a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// In pixels from the picture's upper left corner.
    pub place: [f64; 2],
    /// From the point to the eye, or to the plane that parallel rays come from.
    pub direction: DVec3,
    /// How far that is.
    pub distance: f64,
    /// How many pixels a unit of solid angle around the ray takes; of parallel rays, a unit of area over the square of the distance.
    pub pixels_per_solid_angle: f64,
}

/// An eye with its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where it is.
    pub eye: DVec3,
    /// Where it looks: F.
    pub forward: DVec3,
    /// To the right in the picture: R.
    pub right: DVec3,
    /// Upward in the picture: U = R × F.
    pub up: DVec3,
    /// Half the picture's height: at distance 1 from the eye, or in the world for parallel rays.
    half_height: f64,
    is_parallel: bool,
}

/// Why there is no such camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CameraError {
    /// The eye is at the point it looks at, or nearer than a double can tell.
    NoDirection,
    /// The eye or its distance is no finite number.
    TooFar,
    /// The field of view is not between 0 and 180 degrees.
    FieldOfView,
    /// The height of parallel rays is not positive.
    Height,
}

impl Camera {
    /// The camera at `eye` that looks at `look_at`.
    ///
    /// # Errors
    /// If the two are one point or too far apart, or the projection shows nothing.
    pub fn new(eye: DVec3, look_at: DVec3, projection: Projection) -> Result<Self, CameraError> {
        let toward = look_at - eye;
        let length = toward.length();
        if !(eye.is_finite() && look_at.is_finite() && length.is_finite()) {
            return Err(CameraError::TooFar);
        }
        if length == 0.0 {
            return Err(CameraError::NoDirection);
        }
        let (half_height, is_parallel) = match projection {
            Projection::Perspective { fov } if fov > 0.0 && fov < 180.0 => (angle::tangent(fov / 2.0), false),
            Projection::Perspective { .. } => return Err(CameraError::FieldOfView),
            Projection::Parallel { height } if height > 0.0 && height.is_finite() => (height / 2.0, true),
            Projection::Parallel { .. } => return Err(CameraError::Height),
        };
        let forward = toward / length;
        let sideways = match forward.cross(DVec3::Z) {
            vertical if vertical.length() < MIN_RIGHT => forward.cross(DVec3::Y),
            sideways => sideways,
        };
        let right = sideways / sideways.length();
        Ok(Camera { eye, forward, right, up: right.cross(forward), half_height, is_parallel })
    }

    /// The ray through the point `(across, down)` of a picture of `width` × `height` pixels, counted in pixels from
    /// its upper left corner: pixel (i, j) has its centre at (i + 0.5, j + 0.5).
    pub fn ray(&self, width: u32, height: u32, across: f64, down: f64) -> Ray {
        let (w, h) = (f64::from(width), f64::from(height));
        let sx = (across / w * 2.0 - 1.0) * (w / h) * self.half_height;
        let sy = (1.0 - down / h * 2.0) * self.half_height;
        let offset = self.right * sx + self.up * sy;
        if self.is_parallel {
            return Ray::new(self.eye + offset, self.forward);
        }
        let direction = self.forward + offset;
        Ray::new(self.eye, direction / direction.length())
    }

    /// The rays through the centres of all pixels of such a picture, as a whole.
    pub fn screen(&self, width: u32, height: u32) -> Screen {
        let (w, h) = (f64::from(width), f64::from(height));
        let step = 2.0 * self.half_height / h;
        Screen {
            eye: self.eye,
            forward: self.forward,
            right: self.right,
            up: self.up,
            is_parallel: self.is_parallel,
            first: [(0.5 / w * 2.0 - 1.0) * (w / h) * self.half_height, (1.0 - 0.5 / h * 2.0) * self.half_height],
            step: [step, -step],
        }
    }

    /// Whether all rays have one direction.
    pub fn is_parallel(&self) -> bool {
        self.is_parallel
    }

    /// How the eye sees a point; `None` if it is behind the eye or outside the picture by more than a few pixels.
    pub fn see(&self, width: u32, height: u32, point: DVec3) -> Option<Seen> {
        let (w, h) = (f64::from(width), f64::from(height));
        let from_eye = point - self.eye;
        let depth = from_eye.dot(self.forward);
        if depth <= 0.0 {
            return None;
        }
        let scale = self.half_height * if self.is_parallel { 1.0 } else { depth };
        let (sx, sy) = (from_eye.dot(self.right) / scale, from_eye.dot(self.up) / scale);
        let place = [(sx * (h / w) + 1.0) * 0.5 * w, (1.0 - sy) * 0.5 * h];
        let is_near = |place: f64, end: f64| place > -MARGIN && place < end + MARGIN;
        if !(is_near(place[0], w) && is_near(place[1], h)) {
            return None;
        }
        let pixel = 2.0 * self.half_height / h;
        if self.is_parallel {
            let pixels_per_solid_angle = depth * depth / (pixel * pixel);
            return Some(Seen { place, direction: -self.forward, distance: depth, pixels_per_solid_angle });
        }
        let distance = from_eye.length();
        let cosine = depth / distance;
        // A pixel's area at distance 1 along the axis, seen under the cosine and from 1/cosine away.
        let pixels_per_solid_angle = 1.0 / (pixel * pixel * cosine * cosine * cosine);
        Some(Seen { place, direction: -from_eye / distance, distance, pixels_per_solid_angle })
    }

    /// How wide a pixel is in the world at distance t on its ray, in a picture of `height` pixels.
    pub fn footprint(&self, height: u32, t: f64) -> f64 {
        let scale = if self.is_parallel { 1.0 } else { t };
        2.0 * self.half_height * scale / f64::from(height)
    }
}

/// The eye around `center` at azimuth and elevation in degrees.
pub fn orbit(center: DVec3, azimuth: f64, elevation: f64, distance: f64) -> DVec3 {
    let (ce, se) = (angle::cosine(elevation), angle::sine(elevation));
    center + distance * DVec3::new(ce * angle::cosine(azimuth), ce * angle::sine(azimuth), se)
}

impl fmt::Display for CameraError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            CameraError::NoDirection => {
                "the eye is at the point it looks at, or nearer to it than can be told; move one of them"
            }
            CameraError::TooFar => "the eye is too far from what it looks at to be computed with; move it nearer",
            CameraError::FieldOfView => "the field of view must be more than 0 and less than 180 degrees",
            CameraError::Height => "the height of the picture in parallel rays must be more than 0",
        })
    }
}

impl std::error::Error for CameraError {}

#[cfg(test)]
mod tests {
    use super::*;

    const FORTY: Projection = Projection::Perspective { fov: 40.0 };

    #[test]
    fn frames_are_right_handed_with_z_up() {
        let rows = [
            (DVec3::new(0.0, -5.0, 0.0), DVec3::X, DVec3::Z),
            (DVec3::new(5.0, 0.0, 0.0), DVec3::Y, DVec3::Z),
            (DVec3::new(0.0, 0.0, 5.0), DVec3::X, DVec3::Y),
            (DVec3::new(0.0, 0.0, -5.0), -DVec3::X, DVec3::Y),
        ];
        for (eye, right, up) in rows {
            let camera = Camera::new(eye, DVec3::ZERO, FORTY).unwrap();
            assert!((camera.right - right).length() < 1e-15 && (camera.up - up).length() < 1e-15, "{eye}");
        }
    }

    #[test]
    fn the_middle_of_the_picture_is_ahead_and_corners_are_where_the_formula_says() {
        let camera = Camera::new(DVec3::new(0.0, -5.0, 0.0), DVec3::ZERO, FORTY).unwrap();
        assert_eq!(camera.ray(8, 6, 4.0, 3.0).direction, DVec3::Y);
        let t = (20.0f64).to_radians().tan();
        let sx = ((0.5 / 8.0) * 2.0 - 1.0) * (8.0 / 6.0) * t;
        let sy = (1.0 - (0.5 / 6.0) * 2.0) * t;
        let expected = DVec3::new(sx, 1.0, sy).normalize();
        assert!((camera.ray(8, 6, 0.5, 0.5).direction - expected).length() < 1e-15);
    }

    #[test]
    fn parallel_rays_start_on_the_plane_of_the_eye() {
        let camera =
            Camera::new(DVec3::new(0.0, -5.0, 0.0), DVec3::ZERO, Projection::Parallel { height: 4.0 }).unwrap();
        let ray = camera.ray(8, 4, 0.0, 0.0);
        assert_eq!((ray.origin, ray.direction), (DVec3::new(-4.0, -5.0, 2.0), DVec3::Y));
    }

    #[test]
    fn orbits_count_from_x_towards_y_and_up() {
        assert_eq!(orbit(DVec3::ONE, 0.0, 0.0, 2.0), DVec3::new(3.0, 1.0, 1.0));
        assert_eq!(orbit(DVec3::ZERO, 90.0, 0.0, 2.0), DVec3::new(0.0, 2.0, 0.0));
        assert_eq!(orbit(DVec3::ZERO, -90.0, 0.0, 2.0), DVec3::new(0.0, -2.0, 0.0));
        assert_eq!(orbit(DVec3::ZERO, 17.0, 90.0, 2.0), DVec3::new(0.0, 0.0, 2.0));
    }

    #[test]
    fn impossible_cameras_are_refused() {
        let eye = DVec3::ONE;
        assert_eq!(Camera::new(eye, eye, FORTY), Err(CameraError::NoDirection));
        for far in [DVec3::splat(1e200), DVec3::splat(f64::MAX), DVec3::splat(f64::INFINITY), DVec3::NAN] {
            assert_eq!(Camera::new(far, DVec3::ZERO, FORTY), Err(CameraError::TooFar), "{far}");
            assert_eq!(Camera::new(DVec3::ZERO, far, FORTY), Err(CameraError::TooFar), "{far}");
        }
        for fov in [0.0, 180.0, -3.0, f64::NAN] {
            assert_eq!(Camera::new(eye, DVec3::ZERO, Projection::Perspective { fov }), Err(CameraError::FieldOfView));
        }
        for height in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(Camera::new(eye, DVec3::ZERO, Projection::Parallel { height }), Err(CameraError::Height));
        }
    }
}
