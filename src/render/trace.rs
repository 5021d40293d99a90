//! Who traces rays.
//!
//! In: rays. Out: hits, in the rays' order. A trait, so that drawing can be proved on surfaces whose hits are known
//! in closed form.

use crate::surface::{Counts, Hit, Ray, Rectangle, Screen, Tracer};

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

    /// How much was computed until now.
    fn counts(&self) -> Counts;
}

impl Trace for Tracer<'_> {
    fn trace(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        Tracer::trace(self, rays, hits);
    }

    fn trace_rectangle(&mut self, screen: &Screen, rectangle: Rectangle, rays: &mut Vec<Ray>, hits: &mut Vec<Hit>) {
        Tracer::trace_rectangle(self, screen, rectangle, hits);
        self.take_rays(rays);
    }

    fn trace_from_surface(&mut self, rays: &[Ray], hits: &mut Vec<Hit>) {
        Tracer::trace_from_surface(self, rays, hits);
    }

    fn counts(&self) -> Counts {
        self.counts
    }
}
