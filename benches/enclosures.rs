//! Enclosures of single operations beside the tightest ones, by the vectors of the interval test framework ITF1788.
//!
//! In: a folder with its `.itl` files (`cargo bench --bench enclosures -- FOLDER`; public as oheim/ITF1788, folder `itl`). Out: a table
//! by operation, and an exit status that is not 0 where an enclosure does not contain the tightest one, or says more of the
//! operation than is true; with the word `wide` also what is not tight. Each vector is tried alone and in the arrays that the tracer uses.

#![allow(clippy::print_stdout)]

#[path = "enclosures/vectors.rs"]
mod vectors;

use implicit::num::interval::{Defined, Enclosure, Interval};
use implicit::num::interval_lanes::IntervalLanes;
use implicit::num::level::Portable;
use implicit::num::number::Number;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;
use vectors::{Known, Vector};

/// What the goal calls tight, in steps of doubles.
const TIGHT: u64 = 2;

/// Lanes of the arrays.
const LANES: usize = 16;

type Lanes = IntervalLanes<LANES>;

/// Both ways of an operation: alone, and in an array. Every level gives the bits of the portable one.
type Both = (Enclosure, Enclosure);

fn in_lanes(arguments: [Enclosure; 2], operation: impl Fn(&Lanes, &Lanes, &mut Lanes)) -> Enclosure {
    let [a, b] = arguments.map(Lanes::splat);
    let mut out = Lanes::default();
    operation(&a, &b, &mut out);
    out.get(0)
}

/// The vector's operation, by our means; `None` if there is none like it.
fn compute(vector: &Vector) -> Option<Both> {
    let (&a, b) = (vector.arguments.first()?, vector.arguments.get(1).copied());
    let pair = [a, b.unwrap_or(a)];
    macro_rules! unary {
        ($alone:ident, $lanes:ident) => {
            b.is_none().then(|| (a.$alone(), in_lanes(pair, |a, _, out| Lanes::$lanes::<Portable>(a, out))))
        };
    }
    macro_rules! binary {
        ($alone:ident, $lanes:ident) => {
            b.map(|b| (a.$alone(b), in_lanes(pair, |a, b, out| Lanes::$lanes::<Portable>(a, b, out))))
        };
    }
    let power = |n: i64| (a.power(n), in_lanes(pair, |a, _, out| Lanes::power::<Portable>(a, n, out)));
    let root = |n: u32| (a.root(n), in_lanes(pair, |a, _, out| Lanes::root::<Portable>(a, n, out)));
    match (vector.operation.as_str(), vector.number) {
        ("pown", Some(n)) if n != 0 => Some(power(n)),
        ("rootn", Some(n)) if n >= 3 && n % 2 == 1 => Some(root(u32::try_from(n).ok()?)),
        (_, Some(_)) => None,
        ("recip", _) => Some(power(-1)),
        ("cbrt", _) => Some(root(3)),
        ("neg", _) => unary!(negated, neg),
        ("abs", _) => unary!(abs, abs),
        ("sign", _) => unary!(sign, sign),
        ("floor", _) => unary!(floor, floor),
        ("sqr", _) => unary!(square, square),
        ("sqrt", _) => unary!(sqrt, sqrt),
        ("exp", _) => unary!(exp, exp),
        ("log", _) => unary!(ln, ln),
        ("log2", _) => unary!(log2, log2),
        ("log10", _) => unary!(log10, log10),
        ("sin", _) => unary!(sin, sin),
        ("cos", _) => unary!(cos, cos),
        ("tan", _) => unary!(tan, tan),
        ("asin", _) => unary!(asin, asin),
        ("acos", _) => unary!(acos, acos),
        ("atan", _) => unary!(atan, atan),
        ("sinh", _) => unary!(sinh, sinh),
        ("cosh", _) => unary!(cosh, cosh),
        ("tanh", _) => unary!(tanh, tanh),
        ("asinh", _) => unary!(asinh, asinh),
        ("acosh", _) => unary!(acosh, acosh),
        ("atanh", _) => unary!(atanh, atanh),
        ("add", _) => binary!(plus, add),
        ("sub", _) => binary!(minus, sub),
        ("mul", _) => binary!(times, mul),
        ("div", _) => binary!(over, div),
        ("min", _) => binary!(min, min),
        ("max", _) => binary!(max, max),
        ("pow", _) => binary!(pow, pow),
        ("atan2", _) => binary!(atan2, atan2),
        _ => None,
    }
}

/// How much an enclosure is wider than the tightest: steps of doubles at the end where it is more; `None` if it does not contain it.
fn excess(tightest: Interval, found: Interval) -> Option<u64> {
    if tightest.is_empty() {
        return Some(if found.is_empty() { 0 } else { u64::MAX });
    }
    (found.lo <= tightest.lo && tightest.hi <= found.hi)
        .then(|| steps(found.lo, tightest.lo).max(steps(tightest.hi, found.hi)))
}

/// How many doubles it is from a to b, a ≤ b.
fn steps(a: f64, b: f64) -> u64 {
    let place = |x: f64| {
        let bits = (x + 0.0).to_bits() as i64;
        if bits < 0 { i64::MIN - bits } else { bits }
    };
    place(b).wrapping_sub(place(a)) as u64
}

/// Whether an enclosure claims no more of the operation than is true.
fn is_honest(known: Option<Known>, found: Enclosure) -> bool {
    let Some(known) = known else { return true };
    (found.defined != Defined::Everywhere || known >= Known::Defined)
        && (!found.continuous || known >= Known::Continuous)
}

/// One operation's vectors, one way.
#[derive(Default)]
struct Tally {
    contained: usize,
    tight: usize,
    worst: u64,
}

impl Tally {
    /// Counts one; whether it is sound.
    fn add(&mut self, vector: &Vector, found: Enclosure, shows_wide: bool) -> bool {
        let excess = excess(vector.result, found.range).filter(|_| is_honest(vector.known, found));
        let Some(excess) = excess else {
            println!("not contained: {}\n    found {found:?}", vector.text);
            return false;
        };
        if excess > TIGHT && shows_wide {
            println!("wide: {}\n    found {:?}", vector.text, found.range);
        }
        self.contained += 1;
        self.tight += usize::from(excess <= TIGHT);
        self.worst = self.worst.max(excess);
        true
    }

    fn worst(&self) -> String {
        if self.worst > 1 << 20 { "far".into() } else { self.worst.to_string() }
    }
}

#[derive(Default)]
struct Row {
    vectors: usize,
    alone: Tally,
    lanes: Tally,
}

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let (folder, shows_wide) = match &words[..] {
        [folder] => (folder, false),
        [folder, wide] if wide == "wide" => (folder, true),
        _ => {
            println!("enclosures: nothing is checked; say cargo bench --bench enclosures -- FOLDER [wide]");
            return ExitCode::SUCCESS;
        }
    };
    match check(Path::new(folder), shows_wide) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            println!("{folder}: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Prints the table; whether all is contained.
fn check(folder: &Path, shows_wide: bool) -> std::io::Result<bool> {
    let mut files: Vec<_> = std::fs::read_dir(folder)?.collect::<Result<_, _>>()?;
    files.retain(|file| file.path().extension().is_some_and(|extension| extension == "itl"));
    files.sort_by_key(std::fs::DirEntry::path);
    if files.is_empty() {
        return Err(std::io::Error::other("no .itl files are there"));
    }
    let (mut rows, mut others, mut is_sound) = (BTreeMap::<String, Row>::new(), 0, true);
    for file in files {
        let (vectors, unread) = vectors::read(&std::fs::read_to_string(file.path())?);
        others += unread;
        for vector in vectors {
            let Some((alone, lanes)) = compute(&vector) else {
                others += 1;
                continue;
            };
            let row = rows.entry(vector.operation.clone()).or_default();
            row.vectors += 1;
            is_sound &= row.alone.add(&vector, alone, shows_wide);
            is_sound &= row.lanes.add(&vector, lanes, shows_wide);
        }
    }
    table(&rows, others);
    Ok(is_sound)
}

fn table(rows: &BTreeMap<String, Row>, others: usize) {
    println!(
        "| operation | vectors | contained, alone | within {TIGHT} ulp | worst, ulp | contained, in lanes | within {TIGHT} ulp | worst, ulp |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- |");
    let cells = |tally: &Tally| format!("{} | {} | {}", tally.contained, tally.tight, tally.worst());
    for (name, row) in rows {
        println!("| {name} | {} | {} | {} |", row.vectors, cells(&row.alone), cells(&row.lanes));
    }
    let sum = |count: fn(&Row) -> usize| rows.values().map(count).sum::<usize>();
    let all = sum(|row| row.vectors);
    let share = |count: usize| 100.0 * count as f64 / all as f64;
    let (alone, lanes) = (sum(|row| row.alone.tight), sum(|row| row.lanes.tight));
    println!(
        "| all | {all} | {} | {alone} | | {} | {lanes} | |",
        sum(|row| row.alone.contained),
        sum(|row| row.lanes.contained)
    );
    println!(
        "\nWithin {TIGHT} ulp: {:.2} % alone, {:.2} % in lanes. {others} statements of the files are of other operations.",
        share(alone),
        share(lanes)
    );
}
