//! Scene → film.
//!
//! In: a scene ([`crate::scene::Scene`]), someone who traces rays ([`Trace`]), what to draw ([`Settings`]). Out: the
//! picture and the layers of what the centre rays know ([`Drawing`]), the same for any number of threads.
//!
//! - [`settings`]: the modes, and what else can be chosen.
//! - [`watch`]: who looks on: progress, cancelling, the clock.
//! - [`trace`]: who traces rays.
//! - [`tiles`]: the picture in squares and passes; [`canvas`]: what all threads draw on.
//! - [`knowledge`]: what the centre ray of a pixel knows, in four bytes, and where neighbours differ.
//! - [`worker`]: one thread with its tracer, and what it does with a tile.
//! - [`exposure`]: samples of light, added up in pixels.
//! - [`filter`]: how much a place counts in a pixel.
//! - [`sampling`]: where in a pixel the rays go, and when they are enough.
//! - [`integrator`]: from hits to light, by mode: [`cosine`], [`mirror`], [`studio`], [`data`].
//! - [`trails`]: what becomes of rays among mirrors.
//! - [`transport`]: whole paths of light.

pub mod canvas;
pub mod cosine;
pub mod data;
pub mod exposure;
pub mod filter;
pub mod integrator;
pub mod knowledge;
pub mod mirror;
pub mod sampling;
pub mod settings;
pub mod studio;
pub mod tiles;
pub mod trace;
pub mod trails;
pub mod transport;
pub mod watch;
pub mod worker;

pub use settings::{Background, Mode, Passes, Settings};
pub use tiles::{Drawing, Failure, Pass, Report, draw};
pub use trace::Trace;
pub use watch::{Silent, Watch};
