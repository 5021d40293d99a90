//! A formula to a picture: `cargo run --release --example hello -- "x^2+y^2=z^2" cone.png`.

use implicit::film::png;
use implicit::render::Silent;
use implicit::session::{Plan, Program, Wishes};

fn main() -> Result<(), String> {
    let mut arguments = std::env::args().skip(1);
    let text = arguments.next().unwrap_or_else(|| "x^2 + y^2 + z^2 = 1".into());
    let file = arguments.next().unwrap_or_else(|| "hello.png".into());

    let mut program = Program::from_text(&text);
    if program.has_errors() {
        return Err(implicit::diag::render(&program.diagnostics, &program.sources, false));
    }
    let plan = Plan::new(&mut program, &Wishes::default()).map_err(|refusal| format!("{refusal:?}"))?;
    let drawing = plan.draw(&Silent).map_err(|failure| failure.to_string())?;
    let bytes = png::encode(&plan.settings.print(&drawing)).map_err(|error| error.to_string())?;
    std::fs::write(file, bytes).map_err(|error| error.to_string())
}
