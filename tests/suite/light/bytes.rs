//! The same bytes whoever draws.
//!
//! In: scenes with something of everything, every mode there is. Out: pictures that may not depend on threads, on instructions, on passes.

use super::Mode;
use implicit::film::Size;
use implicit::num::level::Simd;
use implicit::render::{Passes, Silent};
use implicit::session::{Plan, Program, Wishes};

/// More than one tile in both directions.
const SIZE: (u64, u64) = (70, 66);

const SCENES: [&str; 3] = [
    "x^2+y^2+z^2=1 { kind: glass, absorption: rgb(0.1,0.4,0.9) }; z=-1 { color: checker(0.5, white, navy) }; \
     light { at: (1,-2,3), power: 50, radius: 0.3 }; light { at: (-1,-2,1), power: 20 }; \
     (x-1.2)^2+(y+0.8)^2+(z+0.5)^2=0.2 { metal: \"gold\", roughness: 0.4 }; render { clip: box(-2..2,-2..2,-2..2) }",
    "(sqrt(x^2+y^2)-1)^2+z^2=0.1 { kind: plastic, roughness: 0.3, color: palette(viridis, gauss) }; \
     x^2+y^2+z^2=0.2 { emission: 4, opacity: 0.7 }; z=x*y/4-0.6 { kind: glass, roughness: 0.5, inside: negative, lines: every(0.3, x) }; \
     sun { from: (1,-2,3), irradiance: 2, angle: 4 }; sky { sun: (1,-2,3), turbidity: 3 }; render { clip: ball(0,0,0,2) }",
    "b(u,v,w) = (x-u)^2+(y-v)^2+(z-w)^2-0.09; \
     min(b(1,0,0),b(-1,0,0),b(0,1,0),b(0,-1,0),b(0,0,1),b(0,0,-1),b(0.6,0.6,0.6),b(-0.6,-0.6,0),b(0.5,-0.6,-0.5),b(-0.5,0.5,0.2)) = 0 \
     { metal: \"copper\" }; z = if(x < 0.2*y, -1.1, -1.3) { color: orange }; light { at: (1,-2,3), power: 50, radius: 0.3 }; \
     render { clip: ball(0,0,0,2) }",
];

fn drawn(text: &str, mode: Mode, threads: usize, simd: Simd, passes: Passes) -> Vec<u32> {
    let mut program = Program::from_text(text);
    assert!(!program.has_errors(), "{text}: {:?}", program.diagnostics);
    let size = Some(Size::new(SIZE.0, SIZE.1).unwrap());
    let (samples, bounces, mode) = (Some(3), Some(4), Some(mode));
    let (keep_depth, keep_normals) = (true, true);
    let wishes =
        Wishes { size, mode, samples, bounces, threads, simd, passes, keep_depth, keep_normals, ..Wishes::default() };
    let drawing = Plan::new(&mut program, &wishes).unwrap().draw(&Silent).unwrap();
    let known = drawing.depth.unwrap().values.into_iter().chain(drawing.normals.unwrap().values.into_iter().flatten());
    drawing.picture.values.into_iter().flatten().chain(known).map(f32::to_bits).collect()
}

#[test]
fn the_same_bytes_in_every_mode_for_any_threads_instructions_and_passes() {
    for (name, mode) in Mode::ALL {
        for text in SCENES {
            let one = drawn(text, mode, 1, Simd::Portable, Passes::Few);
            for simd in Simd::all() {
                assert!(one == drawn(text, mode, 3, simd, Passes::Many), "{name} {simd:?}: {text}");
            }
            assert!(one == drawn(text, mode, 2, Simd::best(), Passes::CoarseFirst), "{name}: {text}");
        }
    }
}
