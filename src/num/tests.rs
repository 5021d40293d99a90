//! Claims about all operations together.
//!
//! In: the table of trials, random boxes. Out: nothing but failures. Separate because each claim holds for every
//! operation, and every form of it.

#![allow(clippy::print_stdout)]

use super::ball_lanes::BallLanes;
use super::interval::{Defined, Enclosure, Interval};
use super::interval_lanes::IntervalLanes;
use super::lanes::Lanes;
use super::level::{Level, Portable, Simd};
use super::number::Number;
use super::trial::{Trial, trials};

/// Cases of each operation: a box for each pair of arguments, and points in it.
const CASES: usize = 10_000;

/// A linear congruential generator (Knuth, TAOCP 2, section 3.3.4), its high bits mixed into the low.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        self.0 ^ (self.0 >> 29)
    }

    pub(super) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(super) fn number(&mut self) -> f64 {
        const SPECIAL: [f64; 12] =
            [0.0, 1.0, -1.0, 0.5, 2.0, 1e-310, 5e-324, f64::MAX, 1e9, std::f64::consts::FRAC_PI_2, 3.0, -0.0];
        let signed = |x: f64, negative: bool| if negative { -x } else { x };
        match self.bits() >> 5 & 15 {
            0 => signed(SPECIAL[(self.bits() >> 7) as usize % SPECIAL.len()], self.bits() & 64 == 0),
            1 => (self.unit() * 20.0 - 10.0).round(),
            2 => signed(f64::from_bits(self.bits() >> 1), self.bits() & 64 == 0),
            3 => signed((self.unit() * 100.0 - 50.0).exp2(), self.bits() & 64 == 0),
            4..=8 => self.unit() * 2.4 - 1.2,
            _ => self.unit() * 20.0 - 10.0,
        }
    }

    fn interval(&mut self) -> Interval {
        let a = match self.number() {
            a if a.is_finite() => a,
            _ => 1.5,
        };
        let width = match self.bits() >> 9 & 7 {
            0 => 0.0,
            1 => a.abs() * 1e-15,
            2 => a.abs() * 1e-6,
            3 => f64::INFINITY,
            4 => self.unit() * 1e3,
            _ => self.unit(),
        };
        let b = a + width;
        match self.bits() >> 9 & 1 {
            0 => Interval::new(a, b),
            _ => Interval::new(-b, -a),
        }
    }

    fn inside(&mut self, range: Interval) -> f64 {
        let (lo, hi) = (range.lo.max(-1e300), range.hi.min(1e300));
        let candidate = match self.bits() >> 9 & 7 {
            0 => range.lo,
            1 => range.hi,
            2 => self.number().round(),
            3 => range.lo.next_up(),
            _ => lo + self.unit() * (hi - lo),
        };
        let fallback = if range.lo.is_finite() { range.lo } else { range.hi };
        if range.contains(candidate) && candidate.is_finite() { candidate } else { fallback }
    }
}

fn check(trial: &Trial, form: &str, boxes: [Interval; 2], args: [f64; 2], value: f64, all: Enclosure) {
    let sound = if value.is_nan() {
        all.defined != Defined::Everywhere
    } else {
        all.defined != Defined::Nowhere && all.range.contains(value)
    };
    assert!(sound, "{} {form}: {args:?} in {boxes:?} gives {value:e}, outside {all:?}", trial.name);
}

#[test]
fn values_never_escape_their_enclosure() {
    let simd = Simd::best();
    for trial in trials() {
        let mut random = Random(0x1234_5678_9abc_def0);
        for _ in 0..CASES / 16 {
            let boxes: [[Interval; 2]; 16] = std::array::from_fn(|_| [random.interval(), random.interval()]);
            let (mut a, mut b) = (IntervalLanes::<16>::default(), IntervalLanes::default());
            for (i, [x, y]) in boxes.iter().enumerate() {
                a.set(i, Enclosure::total(*x));
                b.set(i, Enclosure::total(*y));
            }
            let mut out = IntervalLanes::default();
            (trial.cells)(simd, 1, &a, &b, &mut out);
            let args: [[f64; 2]; 64] = std::array::from_fn(|i| boxes[i / 4].map(|range| random.inside(range)));
            let (x, y) = (Lanes(args.map(|p| p[0])), Lanes(args.map(|p| p[1])));
            let mut values = Lanes::splat(0.0);
            (trial.points)(simd, 1, &x, &y, &mut values);
            for (i, &[p, q]) in args.iter().enumerate() {
                let exact = (trial.exact)(p, q);
                let one = (trial.enclosure)(a.get(i / 4), b.get(i / 4));
                for (form, all) in [("alone", one), ("in lanes", out.get(i / 4))] {
                    check(&trial, form, boxes[i / 4], [p, q], exact, all);
                    // A computed value that overflowed stands for no number.
                    if values.0[i].is_finite() {
                        check(&trial, form, boxes[i / 4], [p, q], values.0[i], all);
                    }
                }
                assert_eq!(values.0[i].is_nan(), exact.is_nan(), "{} at {p:e}, {q:e}", trial.name);
            }
        }
    }
}

#[test]
fn lanes_know_what_the_scalar_knows() {
    for trial in trials() {
        let mut random = Random(77);
        for _ in 0..CASES / 16 {
            let (mut a, mut b) = (IntervalLanes::<16>::default(), IntervalLanes::default());
            for i in 0..16 {
                let any = |random: &mut Random| match random.bits() >> 7 & 15 {
                    0 => Enclosure::NOWHERE,
                    1 => Enclosure { defined: Defined::Somewhere, continuous: false, range: random.interval() },
                    2 => Enclosure { continuous: false, ..Enclosure::total(random.interval()) },
                    _ => Enclosure::total(random.interval()),
                };
                a.set(i, any(&mut random));
                b.set(i, any(&mut random));
            }
            let outs = Simd::all().into_iter().map(|simd| {
                let mut out = IntervalLanes::default();
                (trial.cells)(simd, 1, &a, &b, &mut out);
                out
            });
            let outs: Vec<IntervalLanes<16>> = outs.collect();
            let out = &outs[0];
            for i in 0..16 {
                let (one, lane) = ((trial.enclosure)(a.get(i), b.get(i)), out.get(i));
                let context = (trial.name, a.get(i), b.get(i), one, lane);
                assert_eq!((one.defined, one.continuous), (lane.defined, lane.continuous), "{context:?}");
                assert_eq!(lane.range.is_empty(), lane.defined == Defined::Nowhere, "{context:?}");
                assert_eq!(out.lo[i].is_nan(), lane.range.is_empty(), "{context:?}");
                let same = |x: f64, y: f64| x.to_bits() == y.to_bits() || (x.is_nan() && y.is_nan());
                let all_same = |o: &IntervalLanes<16>| same(o.lo[i], out.lo[i]) && same(o.hi[i], out.hi[i]);
                assert!(outs.iter().all(all_same), "{context:?}");
            }
            assert!(outs.iter().all(|o| o.flags == out.flags));
        }
    }
}

#[test]
fn levels_give_the_same_bits() {
    for trial in trials() {
        let mut random = Random(5);
        for _ in 0..CASES / 64 {
            let (a, b) =
                (Lanes(std::array::from_fn(|_| random.number())), Lanes(std::array::from_fn(|_| random.number())));
            let mut slow = Lanes::splat(0.0);
            (trial.points)(Simd::Portable, 1, &a, &b, &mut slow);
            for simd in Simd::all() {
                let mut fast = Lanes::splat(0.0);
                (trial.points)(simd, 1, &a, &b, &mut fast);
                for i in 0..64 {
                    let same = fast.0[i].to_bits() == slow.0[i].to_bits() || (fast.0[i].is_nan() && slow.0[i].is_nan());
                    assert!(same, "{} {:e} {:e}: {:e} {:e}", trial.name, a.0[i], b.0[i], fast.0[i], slow.0[i]);
                }
            }
        }
    }
}

/// On boxes of one point, where the width is that of the rounding alone.
#[test]
fn enclosures_are_tight() {
    for trial in trials() {
        let mut random = Random(9);
        let (mut count, mut wide, mut wide_lanes) = (0, 0, 0);
        for _ in 0..CASES / 16 {
            let points: [[f64; 2]; 16] = std::array::from_fn(|_| [random.number(), random.number()]);
            let (mut a, mut b) = (IntervalLanes::<16>::default(), IntervalLanes::default());
            for i in 0..16 {
                a.set(i, Enclosure::total(Interval::point(points[i][0])));
                b.set(i, Enclosure::total(Interval::point(points[i][1])));
            }
            let mut out = IntervalLanes::default();
            (trial.cells)(Simd::best(), 1, &a, &b, &mut out);
            for i in 0..16 {
                let exact = (trial.exact)(points[i][0], points[i][1]);
                if !exact.is_finite() || exact.abs() < 1e-300 || points[i][0].abs() > 1e6 {
                    continue;
                }
                let ulp = exact.abs().next_up() - exact.abs();
                // The error bound of erf takes one step more.
                let limit = if trial.name == "erf" { 4.0 } else { 3.0 };
                let far = |r: Interval| ((exact - r.lo) / ulp).max((r.hi - exact) / ulp) > limit;
                count += 1;
                wide += u32::from(far((trial.enclosure)(a.get(i), b.get(i)).range));
                wide_lanes += u32::from(far(out.get(i).range));
            }
        }
        println!("{}: {wide} and {wide_lanes} of {count} wider than 3 ulp", trial.name);
        assert!(count > 100 && wide * 100 <= count, "{}: {wide} of {count} are wide", trial.name);
    }
}

#[test]
fn the_pair_of_sine_and_cosine_is_both() {
    let mut random = Random(3);
    for _ in 0..200 {
        let a: Lanes<8> = Lanes(std::array::from_fn(|_| random.number()));
        let [mut s, mut c, mut sin, mut cos] = [Lanes::splat(0.0); 4];
        Lanes::sin_cos::<Portable>(&a, &mut s, &mut c);
        Lanes::sin::<Portable>(&a, &mut sin);
        Lanes::cos::<Portable>(&a, &mut cos);
        assert_eq!((s.0.map(f64::to_bits), c.0.map(f64::to_bits)), (sin.0.map(f64::to_bits), cos.0.map(f64::to_bits)));
    }
}

/// Balls around random numbers, and values anywhere in them. Most of those that are as narrow as roundings must be known.
#[test]
fn values_never_escape_their_balls() {
    for trial in trials() {
        let mut random = Random(21);
        let (mut narrow, mut known) = (0, 0);
        for _ in 0..CASES / 64 {
            let mut ball = || {
                let center = Lanes(std::array::from_fn(|_| random.number()));
                let widths = [0.0, 1e-16, 1e-15, 1e-12, 1e-6, 0.1, 2.0];
                let radius = center.0.map(|c| {
                    let scale = if random.bits() >> 9 & 1 == 0 { c.abs() } else { 1.0 };
                    widths[(random.bits() >> 7) as usize % widths.len()] * scale
                });
                BallLanes { center, radius: Lanes(radius) }
            };
            let (a, b) = (ball(), ball());
            let mut out = a;
            (trial.balls)(Simd::best(), 1, &a, &b, &mut out);
            let mut points = a.center;
            (trial.points)(Simd::best(), 1, &a.center, &b.center, &mut points);
            for i in 0..64 {
                let (center, radius) = (out.center.0[i], out.radius.0[i]);
                let same = center.to_bits() == points.0[i].to_bits() || (center.is_nan() && points.0[i].is_nan());
                assert!(same, "{}: the centre {center:e} is not the point {:e}", trial.name, points.0[i]);
                if a.radius.0[i].max(b.radius.0[i]) <= 1e-12 * points.0[i].abs() {
                    narrow += 1;
                    known += u32::from(radius <= 1e-6 * center.abs());
                }
                for _ in 0..8 {
                    let mut inside = |ball: &BallLanes<64>| {
                        let (c, r) = (ball.center.0[i], ball.radius.0[i]);
                        let x = match random.bits() >> 9 & 3 {
                            0 => c - r,
                            1 => c + r,
                            _ => c + r * (2.0 * random.unit() - 1.0),
                        };
                        // Rounding must not lead out of the ball.
                        if (x - c).abs() < r { x } else { c }
                    };
                    let args = [inside(&a), inside(&b)];
                    let exact = (trial.exact)(args[0], args[1]);
                    if radius.is_finite() && center.is_finite() && exact.is_finite() {
                        // The reference is rounded too.
                        let ulp = exact.abs().next_up() - exact.abs();
                        let context = (trial.name, args, exact, (center, radius));
                        assert!((exact - center).abs() <= radius * (1.0 + f64::EPSILON) + ulp, "{context:?}");
                    }
                }
            }
        }
        println!("{}: {known} of {narrow} narrow ones known", trial.name);
        // Whole numbers are at a jump of the floor.
        assert!(known * 4 >= narrow * 3, "{}: {known} of {narrow}", trial.name);
    }
}

/// What one rounding loses, to the last bit (Muller et al., "Handbook of Floating-Point Arithmetic", 2nd ed., chapters 4 and 5), is in the
/// ball; twice as much is not needed.
#[test]
fn balls_of_points_contain_what_rounding_lost() {
    /// What the result c of an operation on a and b misses.
    type Lost = fn(f64, f64, f64) -> f64;
    fn lost_of_sum(a: f64, b: f64, c: f64) -> f64 {
        let b_there = c - a;
        (a - (c - b_there)) + (b - b_there)
    }
    let losses: [(&str, Lost); 6] = [
        ("add", lost_of_sum),
        ("sub", |a, b, c| lost_of_sum(a, -b, c)),
        ("mul", |a, b, c| <Portable as Level>::fma(a, b, -c)),
        ("square", |a, _, c| <Portable as Level>::fma(a, a, -c)),
        ("div", |a, b, c| <Portable as Level>::fma(-c, b, a) / b),
        ("sqrt", |a, _, c| <Portable as Level>::fma(-c, c, a) / (2.0 * c)),
    ];
    let trials = trials();
    for (name, lost) in losses {
        let trial = trials.iter().find(|trial| trial.name == name).unwrap();
        let mut random = Random(8);
        let mut most = 0.0f64;
        for _ in 0..CASES / 64 {
            let mut ball = || {
                let center =
                    Lanes(std::array::from_fn(|_| (1.0 + random.unit()) * (random.unit() * 40.0 - 20.0).exp2()));
                BallLanes { center, radius: Lanes::splat(0.0) }
            };
            let (a, b) = (ball(), ball());
            let mut out = a;
            (trial.balls)(Simd::best(), 1, &a, &b, &mut out);
            for i in 0..64 {
                let lost = lost(a.center.0[i], b.center.0[i], out.center.0[i]).abs();
                assert!(lost <= out.radius.0[i], "{name}: {lost:e} is lost, {:e} is known", out.radius.0[i]);
                most = most.max(lost / out.radius.0[i]);
            }
        }
        assert!(most > 0.2, "{name}: at most {most} of a ball is needed");
    }
}
