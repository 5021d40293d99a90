//! Who traces rays.
//!
//! In: rays. Out: hits, in the rays' order. A trait, so that drawing can be proved on surfaces whose hits are known
//! in closed form.

use crate::surface::{Counts, Hit, Ray, Rectangle, Screen, Side, Tracer};
use glam::DVec3;

/// Finds the first root on rays; one a thread.
pub trait Trace {
    /// The first hit of each ray after its start; `hits` is emptied first.
    fn trace(&mut self, rays: &[Ray], hits: &mut Vec<Hit>);

    /// The same for the rays through the centres of a rectangle's pixels, row by row; `rays` becomes those.
    fn trace_rectangle(&mut self, screen: &Screen, rectangle: Rectangle, rays: &mut Vec<Ray>, hits: &mut Vec<Hit>) {
        screen.rays(rectangle, rays);
        self.trace(rays, hits);
    }

    /// The same for rays that start in front of a surface that was hit, at [`Hit::near`].
    fn trace_from_surface(&mut self, rays: &[Ray], hits: &mut Vec<Hit>);

    /// Points from which rays can leave what was hit, on the side asked for; `points` is replaced.
    fn starts(&mut self, departures: &[(Ray, Hit, Side)], points: &mut Vec<DVec3>) {
        points.clear();
        points.extend(departures.iter().map(|(ray, hit, side)| match side {
            Side::Near => ray.at(hit.near()),
            Side::Far => ray.at(hit.far()),
        }));
    }

    /// Whether a ray meets a surface on the side where its equation, as rewritten, is negative.
    fn comes_from_negative(&mut self, _ray: &Ray, hit: &Hit) -> bool {
        hit.flipped
    }

    /// Whether a surface's equation, as rewritten, is negative at a point; `None` if it is neither negative nor positive.
    fn is_negative(&mut self, _surface: u32, _point: DVec3) -> Option<bool> {
        None
    }

    /// How much was computed until now.
    fn counts(&self) -> Counts;
}

impl Trace for Tracer<'_> {
    fn trace(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        Tracer::trace(self, rays, hits);
    }

    fn trace_rectangle(&mut self, screen: &Screen, rectangle: Rectangle, rays: &mut Vec<Ray>, hits: &mut Vec<Hit>) {
        Tracer::trace_rectangle(self, screen, rectangle, hits);
        self.rays(rays);
    }

    fn trace_from_surface(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        Tracer::trace_from_surface(self, rays, hits);
    }

    fn starts(&mut self, departures: &[(Ray, Hit, Side)], points: &mut Vec<DVec3>) {
        Tracer::starts(self, departures, points);
    }

    fn comes_from_negative(&mut self, ray: &Ray, hit: &Hit) -> bool {
        Tracer::comes_from_negative(self, ray, hit)
    }

    fn is_negative(&mut self, surface: u32, point: DVec3) -> Option<bool> {
        Tracer::is_negative(self, surface, point)
    }

    fn counts(&self) -> Counts {
        self.counts
    }
}
