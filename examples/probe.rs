//! Rays without a picture: how far it is to a gyroid, row by row, as a little map of depths in text.
#![allow(clippy::print_stdout)]

use glam::DVec3;
use implicit::num::level::Simd;
use implicit::session::Program;
use implicit::surface::{Clip, Kind, Method, Ray, Shape, Surface, Tracer};

fn main() {
    let mut program = Program::from_text("sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)");
    let f = program.lowered.surfaces[0].f;
    let clip = Clip::shape(Shape::Box { min: DVec3::splat(-4.0), max: DVec3::splat(4.0) });
    let surfaces = [Surface::new(&mut program.lowered.graph, f, Kind::Equation, &clip, Simd::best())];
    let mut tracer = Tracer::new(&surfaces, Method::Faithful);

    let mut hits = Vec::new();
    for row in 0..24 {
        let z = 4.0 - f64::from(row) / 3.0;
        let from = |column: i32| DVec3::new(f64::from(column) / 6.0 - 4.0, -9.0, z);
        let rays: Vec<Ray> = (0..48).map(|c| Ray::new(from(c), DVec3::Y)).collect();
        tracer.trace(&rays, &mut hits);
        let shade = |t: f64| if t.is_finite() { b"@%#*+=-:."[((t - 5.0) * 1.12) as usize % 9] as char } else { ' ' };
        println!("{}", hits.iter().map(|hit| shade(hit.t)).collect::<String>());
    }
}
