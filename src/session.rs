//! One program's life: load, check, build, draw.
//!
//! In: texts, a [`Loader`] for those they include, what the command line adds. Out: the program with everything there
//! is to say about it ([`Program`]), then what is to be drawn ([`Plan`]), then the drawing. Separate from the command
//! line, so that a library or a server lives the same life: nothing here prints, reads a file or a clock.
//!
//! - `cap`: solids closed where they are cut.
//! - [`mod@include`]: programs that include others.
//! - `matter`: materials and lights as the scene has them; `inside`: which side of glass is its
//!   inside; `paint`: colours by formulas.
//! - `outlook`: where the eye goes when nobody said.
//! - [`program`]: texts to formulas.
//! - [`plan`]: formulas to surfaces, a camera and settings; `proofs`: where surfaces cannot be.
//! - `settings`: how well it is drawn.
//! - [`mod@recipe`]: the program that draws a picture again.

mod cap;
pub mod include;
mod inside;
mod matter;
mod outlook;
mod paint;
pub mod plan;
pub mod program;
mod proofs;
pub mod recipe;
pub mod settings;

pub use include::{Loaded, Loader, NoFiles};
pub use plan::{Method, Plan, Refusal, Wishes};
pub use program::{Program, Text};
pub use recipe::recipe;
