//! Scene → film.
//!
//! In: a scene ([`crate::scene::Scene`]), someone who traces rays ([`Trace`]), what to draw ([`Settings`]). Out: the
//! picture and the layers of what the centre rays know ([`Drawing`]), the same for any number of threads.
//!
//! - [`settings`]: the modes, and what else can be chosen.
//! - [`watch`]: who looks on: progress, cancelling, the clock.
//! - [`trace`]: who traces rays.
//! - [`tiles`]: the picture in squares; `worker`: the thread that draws one.
//! - [`knowledge`]: what the centre ray of a pixel knows, in four bytes, and where neighbours differ.
//! - [`sampling`]: where in a pixel the rays go, and when they are enough.
//! - [`integrator`]: from hits to light, by mode: [`cosine`], [`mirror`], [`studio`], [`data`].

pub mod cosine;
pub mod data;
pub mod integrator;
pub mod knowledge;
pub mod mirror;
pub mod sampling;
pub mod settings;
pub mod studio;
pub mod tiles;
pub mod trace;
pub mod watch;
mod worker;

pub use settings::{Mode, Settings};
pub use tiles::{Drawing, Failure, Report, draw};
pub use trace::Trace;
pub use watch::{Silent, Watch};
