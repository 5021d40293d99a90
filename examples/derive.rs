//! The gradient of a formula, as text that can be typed again and as LaTeX.
#![allow(clippy::print_stdout)]

use implicit::expr::derivative::gradient;
use implicit::expr::print::{latex, text};
use implicit::session::Program;

fn main() {
    let written = std::env::args().nth(1).unwrap_or_else(|| "z = sin(x)*cos(y)".into());
    let mut program = Program::from_text(&written);
    let Some(surface) = program.lowered.surfaces.first() else {
        println!("{}", implicit::diag::render(&program.diagnostics, &program.sources, false));
        return;
    };
    let f = surface.f;
    let graph = &mut program.lowered.graph;
    let [x, y, z] = gradient(graph, f);
    let limit = 10_000;
    for (name, latex_name, node) in [
        ("f", "f", f),
        ("f_x", r"\partial f/\partial x", x),
        ("f_y", r"\partial f/\partial y", y),
        ("f_z", r"\partial f/\partial z", z),
    ] {
        println!("{name} = {}", text(graph, node, limit).unwrap_or_else(|| "too long".into()));
        println!("    {latex_name} = {}", latex(graph, node, limit).unwrap_or_else(|| "too long".into()));
    }
}
