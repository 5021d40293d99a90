//! Measurements of the lanes: that loops over arrays did become vector instructions.
//!
//! In: nothing. Out: a table of ns per batch, and a failure where a batch of points is not much faster than the
//! same function one number at a time. Separate because it is compiled for tests alone and looks at the clock.
//! The whole table: `cargo test --lib num::speed -- --ignored --nocapture`.

use super::interval::{Enclosure, Interval};
use super::interval_lanes::IntervalLanes;
use super::lanes::Lanes;
use super::level::{Simd, for_each_level};
use super::number::Number;
use std::hint::black_box;
use std::time::Instant;

type Runner<T> = fn(Simd, u32, &T, &T, &mut T);

macro_rules! runner {
    ($name:ident, $a:ident $(, $b:ident)?) => {
        for_each_level! {
            fn $name[L, T: Number](repeat: u32, left: &T, right: &T, out: &mut T) {
                for _ in 0..repeat {
                    let ($a, _right) = (black_box(left), black_box(right));
                    $(let $b = _right;)?
                    T::$name::<L>($a, $($b,)? &mut *out);
                    black_box(&mut *out);
                }
            }
        }
    };
}

runner!(neg, a);
runner!(abs, a);
runner!(square, a);
runner!(sqrt, a);
runner!(exp, a);
runner!(ln, a);
runner!(log2, a);
runner!(sin, a);
runner!(cos, a);
runner!(tan, a);
runner!(asin, a);
runner!(acos, a);
runner!(atan, a);
runner!(sinh, a);
runner!(cosh, a);
runner!(tanh, a);
runner!(asinh, a);
runner!(acosh, a);
runner!(atanh, a);
runner!(erf, a);
runner!(floor, a);
runner!(add, a, b);
runner!(sub, a, b);
runner!(mul, a, b);
runner!(div, a, b);
runner!(min, a, b);
runner!(pow, a, b);
runner!(atan2, a, b);

for_each_level! {
    fn cube[L, T: Number](repeat: u32, left: &T, _right: &T, out: &mut T) {
        for _ in 0..repeat {
            T::power::<L>(black_box(left), 3, &mut *out);
            black_box(&mut *out);
        }
    }
}

fn runners<T: Number>() -> Vec<(&'static str, Runner<T>)> {
    vec![
        ("cube", cube),
        ("neg", neg),
        ("abs", abs),
        ("square", square),
        ("sqrt", sqrt),
        ("exp", exp),
        ("ln", ln),
        ("log2", log2),
        ("sin", sin),
        ("cos", cos),
        ("tan", tan),
        ("asin", asin),
        ("acos", acos),
        ("atan", atan),
        ("sinh", sinh),
        ("cosh", cosh),
        ("tanh", tanh),
        ("asinh", asinh),
        ("acosh", acosh),
        ("atanh", atanh),
        ("erf", erf),
        ("floor", floor),
        ("add", add),
        ("sub", sub),
        ("mul", mul),
        ("div", div),
        ("min", min),
        ("pow", pow),
        ("atan2", atan2),
    ]
}

/// The least time of one run, ns, over a few tries.
fn nanoseconds<T: Number>(runner: Runner<T>, simd: Simd, a: &T, b: &T, out: &mut T) -> f64 {
    const REPEAT: u32 = 300;
    (0..15)
        .map(|_| {
            let start = Instant::now();
            runner(simd, REPEAT, a, b, out);
            start.elapsed().as_secs_f64() * 1e9 / f64::from(REPEAT)
        })
        .fold(f64::INFINITY, f64::min)
}

/// Numbers that every function has a value at, but for acosh.
fn number(i: usize) -> f64 {
    0.1 + 0.012 * i as f64
}

fn points() -> (Lanes<64>, Lanes<64>) {
    (Lanes(std::array::from_fn(number)), Lanes(std::array::from_fn(|i| number(63 - i) - 0.05)))
}

fn cells() -> (IntervalLanes<16>, IntervalLanes<16>) {
    let (mut a, mut b) = (IntervalLanes::default(), IntervalLanes::default());
    for i in 0..16 {
        a.set(i, Enclosure::total(Interval::new(number(i), number(i + 3))));
        b.set(i, Enclosure::total(Interval::new(number(20 - i), number(22 - i))));
    }
    (a, b)
}

#[test]
#[ignore = "prints a table"]
fn table() {
    let simd = Simd::best();
    let ((a, b), (p, q)) = (points(), cells());
    let (mut out, mut box_out) = (a, p.clone());
    let cells = runners::<IntervalLanes<16>>();
    println!("{:>8} {:>12} {:>12}", "", "64 points", "16 intervals");
    for ((name, run), (_, run_cells)) in runners::<Lanes<64>>().into_iter().zip(cells) {
        let point = nanoseconds(run, simd, &a, &b, &mut out);
        let cell = nanoseconds(run_cells, simd, &p, &q, &mut box_out);
        println!("{name:>8} {point:12.1} {cell:12.1}");
    }
}
