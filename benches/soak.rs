//! The long run over the elementary functions.
//!
//! In: how many points a range (`cargo bench --bench soak -- 100000`). Out: one line a value, `name a b result`, the
//! numbers as the bits of f64 in hexadecimal, for `tests/tools/errors.py`, which knows the exact values and
//! prints the table of docs/error-bounds.md. Separate because `cargo test` holds the quick form.

#![allow(clippy::print_stdout)]

use implicit::num::func::native;
use std::io::{BufWriter, Write};

type Range = (f64, f64);

const ANGLES: &[Range] = &[(-0.8, 0.8), (0.7, 0.9), (-7.0, 7.0), (1.57, 1.5716), (-1e6, 1e6), (1e6, 1e300)];
const ALL: &[Range] = &[(-1.1, 1.1), (0.2, 4.0), (1e-300, 1e300)];
const POSITIVE: &[Range] = &[(0.7, 1.42), (0.99, 1.01), (1e-300, 1e300), (2.3e-308, 1e-300)];
const UNIT: &[Range] = &[(-1.0, 1.0), (0.48, 0.52), (0.99, 1.0), (1e-300, 1.0), (-1.0, -0.99)];

type Unary = (&'static str, fn(f64) -> f64, &'static [Range]);
type Binary = (&'static str, fn(f64, f64) -> f64, Range, Range);

const UNARY: &[Unary] = &[
    ("sin", native::sin, ANGLES),
    ("cos", native::cos, ANGLES),
    ("tan", native::tan, ANGLES),
    ("exp", native::exp, &[(-0.4, 0.4), (-6.0, 6.0), (-708.0, 709.0), (1e-20, 0.1)]),
    ("ln", native::ln, POSITIVE),
    ("log2", native::log2, POSITIVE),
    ("log10", native::log10, POSITIVE),
    ("atan", native::atan, ALL),
    ("asin", native::asin, UNIT),
    ("acos", native::acos, UNIT),
    ("sinh", native::sinh, &[(-1.1, 1.1), (0.9, 3.0), (-710.0, 710.0), (1e-300, 1.0)]),
    ("cosh", native::cosh, &[(-1.1, 1.1), (0.9, 3.0), (-710.0, 710.0)]),
    ("tanh", native::tanh, &[(-1.1, 1.1), (0.9, 22.0), (1e-300, 1.0)]),
    ("asinh", native::asinh, &[(-2.0, 2.0), (1e-5, 1e-3), (1e-300, 1e300)]),
    ("acosh", native::acosh, &[(1.0, 2.0), (1.0, 1.0001), (1.0, 1e300)]),
    ("atanh", native::atanh, &[(-1.0, 1.0), (1e-5, 1e-3), (0.999, 1.0), (1e-300, 1.0)]),
    ("erf", native::erf, &[(-1.1, 1.1), (0.9, 6.5), (1e-300, 1.0)]),
    ("cbrt", |a| native::root(a, 3), &[(-8.0, 8.0), (1e-300, 1e300)]),
    ("root5", |a| native::root(a, 5), &[(-8.0, 8.0), (1e-300, 1e300)]),
    ("power3", |a| native::power(a, 3), &[(-8.0, 8.0), (1e-90, 1e90)]),
    ("power7", |a| native::power(a, 7), &[(-8.0, 8.0), (1e-40, 1e40)]),
    ("power-5", |a| native::power(a, -5), &[(-8.0, 8.0), (1e-50, 1e50)]),
    ("power1000001", |a| native::power(a, 1_000_001), &[(0.9994, 1.0006)]),
];

const BINARY: &[Binary] = &[
    ("pow", native::pow, (0.01, 5.0), (-20.0, 20.0)),
    ("pow", native::pow, (0.5, 1.5), (-900.0, 900.0)),
    ("pow", native::pow, (1e-300, 1e300), (-1.0, 1.0)),
    ("atan2", native::atan2, (-3.0, 3.0), (-3.0, 3.0)),
    ("atan2", native::atan2, (1e-200, 1e200), (1e-100, 1e100)),
];

/// A linear congruential generator (Knuth, TAOCP 2, section 3.3.4), its high bits mixed into the low.
struct Random(u64);

impl Random {
    /// Evenly spread, or by exponent where the range spans many.
    fn within(&mut self, (lo, hi): Range) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let part = ((self.0 ^ (self.0 >> 31)) >> 11) as f64 / (1u64 << 53) as f64;
        if lo > 0.0 && hi / lo > 1e3 {
            f64::from_bits(lo.to_bits() + (part * (hi.to_bits() - lo.to_bits()) as f64) as u64)
        } else {
            lo + part * (hi - lo)
        }
    }
}

fn main() -> std::io::Result<()> {
    let count = std::env::args().filter_map(|arg| arg.parse().ok()).next().unwrap_or(1000u32);
    let mut random = Random(20);
    let mut out = BufWriter::new(std::io::stdout().lock());
    for (name, f, ranges) in UNARY {
        for &range in *ranges {
            for _ in 0..count {
                let a = random.within(range);
                writeln!(out, "{name} {:016x} 0 {:016x}", a.to_bits(), f(a).to_bits())?;
            }
        }
    }
    for (name, f, first, second) in BINARY {
        for _ in 0..count {
            let (a, b) = (random.within(*first), random.within(*second));
            writeln!(out, "{name} {:016x} {:016x} {:016x}", a.to_bits(), b.to_bits(), f(a, b).to_bits())?;
        }
    }
    out.flush()
}
