//! Transport of light: what the modes that follow whole paths are made of.
//!
//! In: a scene, someone who traces rays, the numbers of a pixel's samples. Out: estimates of the light that arrives. Nothing is
//! displaced by an epsilon: rays leave surfaces by [`crate::surface::Tracer::starts`].
//!
//! - [`sobol`]: the numbers that choose; [`warp`]: directions and places from them.
//! - [`media`]: what a ray is inside of.
//! - [`lights`]: where light comes from, and how it is sought; [`sky`]: the surroundings as a table;
//!   [`balls`]: one among many.
//! - [`world`]: what flights meet: surfaces, balls of light, nothing.
//! - [`vertex`]: where a path scatters; [`bsdf`]: how.
//! - [`path`]: paths from the camera.
//! - [`light`]: paths from the lights; [`bidirectional`]: both, joined, weighed by [`balance`].
//! - [`whitted`]: sharp rays only, none by chance.
//! - [`losses`]: what a mode cannot find.
//! - [`estimate`]: samples of pixels, by whichever of them.

pub mod balance;
pub mod balls;
pub mod bidirectional;
pub mod bsdf;
pub mod estimate;
pub mod light;
pub mod lights;
pub mod losses;
pub mod media;
pub mod path;
pub mod sky;
pub mod sobol;
pub mod vertex;
pub mod warp;
pub mod whitted;
pub mod world;
