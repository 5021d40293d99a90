//! Closures → where a ray meets f = 0.
//!
//! In: formulas ([`Surface`]), rays ([`Ray`]) and a region that cuts them ([`Clip`]). Out: for every ray
//! the first root inside the region ([`Hit`]), and whether that is proven. Nothing here knows a pixel or a
//! colour: this is mathematics, and a library of its own.
//!
//! - [`tracer`]: the one door: rays in, hits out, by any method.
//! - [`memory`]: what a tracer keeps for one sheet between batches.
//! - [`kernels`]: the function of a sheet, and so much of it as some part of space needs.
//! - [`index`]: which part of it matters where.
//! - [`sheet`]: a formula made ready: the sheets of its zero set and their kernels.
//! - [`sum`]: which terms of a long sum matter where.
//! - [`hit`]: what is known about a ray.
//! - [`region`]: the clip, and the part of a ray inside it.
//! - [`screen`]: the rays of a picture as a whole.
//! - [`bundle`]: the rays of a rectangle of it, a number of each in an array.
//! - [`spans`]: what of each of them is looked at.
//! - [`tile`]: the fast way of the faithful method: squares of pixels settled at once.
//! - [`stream`]: the roots of those squares, certified in batches.
//! - [`start`]: where rays start that leave a surface.
//! - [`march`]: the textbook method: steps, a change of sign, Newton.
//! - [`isolate`]: the faithful method: intervals that prove where no root is, batches of rays at once.
//! - [`contract`]: the same by forms, which know where along the ray a root can be.
//! - [`refine`]: Newton's method inside a bracket, and the certificate of its result.
//! - [`careful`]: one hard ray at a time: roots without sign change, poles, jumps, edges of the domain.

mod bundle;
mod careful;
mod contract;
pub mod hit;
mod index;
mod isolate;
mod kernels;
mod march;
mod memory;
mod refine;
pub mod region;
pub mod screen;
pub mod sheet;
mod spans;
pub mod start;
mod stream;
mod sum;
mod tile;
pub mod tracer;

pub use hit::{Counts, Hit, Outcome, Ray};
pub use region::{Clip, Shape};
pub use screen::{Rectangle, Screen};
pub use sheet::{Kind, Surface};
pub use start::Side;
pub use tracer::{Method, Tracer};
