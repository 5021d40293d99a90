//! Type an equation and see its surface, exactly.
//!
//! The modules are the stages of one way, and a module uses only those before it: text becomes a tree
//! ([`syntax`]), the tree a graph ([`expr`]), the graph closures ([`closure`]), closures answer where a ray meets the
//! surface ([`surface`]), a scene says what there is to see ([`scene`]), drawing it ([`render`]) fills a film
//! ([`film`]). [`session`] walks the whole way; [`cli`] is the program `implicit`. Under all of them are numbers that
//! know no formula ([`num`]) and messages ([`diag`]).
//!
//! # The whole way at once
//!
//! ```
//! use implicit::film::{Size, png};
//! use implicit::render::Silent;
//! use implicit::session::{Plan, Program, Wishes};
//!
//! let mut program = Program::from_text("x^2 + y^2 + z^2 = 1");
//! let wishes = Wishes { size: Size::new(32, 24).ok(), ..Wishes::default() };
//! let plan = Plan::new(&mut program, &wishes).expect("a sphere is there to be seen");
//! let drawing = plan.draw(&Silent).expect("nobody cancels");
//! assert_eq!(drawing.report.proven, 32 * 24);
//! let bytes = png::encode(&plan.settings.print(&drawing)).expect("pictures can be encoded");
//! assert!(bytes.starts_with(b"\x89PNG"));
//! ```
//!
//! # Stage by stage
//!
//! Text becomes a tree, with all its errors at once:
//!
//! ```
//! use implicit::diag::Sources;
//! let mut sources = Sources::new();
//! sources.add("mine", "z = sin(x");
//! let parsed = implicit::syntax::parse(&sources.texts());
//! assert_eq!(parsed.diagnostics.len(), 1);
//! let position = sources.position(parsed.diagnostics[0].span());
//! assert_eq!(position.line, 1);
//! ```
//!
//! The tree becomes a graph, in which equal subexpressions are one node and every operation has its derivative; the
//! graph becomes functions of points and of boxes:
//!
//! ```
//! use glam::DVec3;
//! use implicit::closure::Formula;
//! use implicit::num::interval::Interval;
//! use implicit::num::level::Simd;
//! use implicit::session::Program;
//!
//! let mut program = Program::from_text("x^2 + y^2 + z^2 = 1");
//! let f = program.lowered.surfaces[0].f;
//! let formula = Formula::new(&mut program.lowered.graph, f, Simd::best());
//! let (value, gradient) = formula.gradient(DVec3::new(1.0, 1.0, 1.0));
//! assert_eq!((value, gradient), (2.0, DVec3::splat(2.0)));
//! let far = [Interval { lo: 2.0, hi: 3.0 }; 3];
//! assert!(formula.enclosure(far).range.lo > 0.0, "no surface in this box: proven");
//! ```
//!
//! A surface answers rays, and says what it proved:
//!
//! ```
//! # use glam::DVec3;
//! # use implicit::num::level::Simd;
//! # use implicit::session::Program;
//! use implicit::surface::{Clip, Kind, Method, Outcome, Ray, Shape, Surface, Tracer};
//! let mut program = Program::from_text("x^2 + y^2 + z^2 = 1");
//! let f = program.lowered.surfaces[0].f;
//! let clip = Clip::shape(Shape::Ball { center: DVec3::ZERO, radius: 2.0 });
//! let sphere = Surface::new(&mut program.lowered.graph, f, Kind::Equation, &clip, Simd::best());
//! let surfaces = [sphere];
//! let mut tracer = Tracer::new(&surfaces, Method::Faithful);
//! let ray = Ray::new(DVec3::new(0.0, 0.0, 5.0), -DVec3::Z);
//! let mut hits = Vec::new();
//! tracer.trace(&[ray], &mut hits);
//! assert!(hits[0].outcome == Outcome::Hit && hits[0].proven);
//! assert!((hits[0].t - 4.0).abs() < 1e-9);
//! ```

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests compare with the functions of std"))]

pub mod num;
pub mod diag;
pub mod syntax;
pub mod expr;
pub mod closure;
pub mod surface;
pub mod scene;
pub mod film;
pub mod render;
pub mod teach;
pub mod session;
pub mod cli;
