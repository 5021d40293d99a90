//! One value of an option: what was typed, as numbers and names.
//!
//! In: the words behind an option. Out: plain values, or what is wrong with them and how they are written. Separate
//! from the list of options because the lines of standard input are read by the same rules.

use super::args::teaching::Steps;
use super::args::{BallArg, BoxArg, OrbitArg, Place};
use crate::expr::lower::MAX_EXPOSURE;
use crate::film::Tone;
use crate::num::rational::Rational;
use crate::render::Mode;
use crate::render::filter::Filter;

/// The most threads that are started, whatever is asked for.
pub const MAX_THREADS: usize = 1024;

/// The most steps that are compared: a sheet of more columns is not read.
const MAX_STEPS: usize = 8;

/// A value is shown in messages up to this many characters.
const LONGEST_SHOWN: usize = 60;

/// What was typed, in a message.
fn shown(text: &str) -> String {
    crate::diag::printable(text.trim(), LONGEST_SHOWN)
}

fn number(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| format!("'{}' is no number", shown(text)))
}

fn finite(text: &str) -> Result<f64, String> {
    match number(text)? {
        value if value.is_finite() => Ok(value),
        _ => Err(format!("'{}' is not finite", shown(text))),
    }
}

/// N numbers with commas or blanks between them.
///
/// # Errors
/// What is wrong with the text.
pub fn listed<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let parts: Vec<&str> = match text.contains(',') {
        true => text.split(',').collect(),
        false => text.split_whitespace().collect(),
    };
    let values = parts.iter().map(|part| number(part)).collect::<Result<Vec<f64>, String>>()?;
    values.try_into().map_err(|values: Vec<f64>| wrong_count(N, values.len()))
}

/// N finite numbers with commas between them.
///
/// # Errors
/// What is wrong with the text, and how it is written.
pub fn numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let parts = || text.split(',');
    if parts().any(|part| number(part).is_err())
        && let Some(mended) = with_commas(text)
    {
        return Err(match mended.split(',').count() {
            count if count == N => count_needed(N) + ": write " + &mended,
            count => wrong_count(N, count),
        });
    }
    let values = parts().map(finite).collect::<Result<Vec<f64>, String>>()?;
    values.try_into().map_err(|values: Vec<f64>| wrong_count(N, values.len()))
}

fn wrong_count(wanted: usize, count: usize) -> String {
    let are = if count == 1 { "is" } else { "are" };
    let example = ["1", "2", "3", "4", "5", "6"][..wanted.min(6)].join(",");
    format!("{}, as in {example}; here {are} {count}", count_needed(wanted))
}

fn count_needed(count: usize) -> String {
    format!("{count} numbers with commas between them are needed")
}

/// Numbers that stand in brackets, or with blanks or semicolons between them, as this command line has them.
pub fn with_commas(text: &str) -> Option<String> {
    let inside = text.trim().trim_start_matches(['(', '[', '{']).trim_end_matches([')', ']', '}']);
    let parts: Vec<&str> =
        inside.split(|c: char| c == ',' || c == ';' || c.is_whitespace()).filter(|part| !part.is_empty()).collect();
    let are_numbers = parts.iter().all(|part| finite(part).is_ok());
    (are_numbers && parts.len() > 1).then(|| parts.join(","))
}

/// Numbers, or `-` for the lines of standard input.
///
/// # Errors
/// What is wrong with the text.
pub fn on_line<const N: usize>(text: &str) -> Result<Place<N>, String> {
    if text == "-" {
        return Ok(Place::Lines);
    }
    match (listed(text), with_commas(text)) {
        (Ok(values), _) => Ok(Place::Here(values)),
        (Err(_), Some(mended)) if mended.split(',').count() == N => Err(count_needed(N) + ": write " + &mended),
        (Err(why), _) => Err(why),
    }
}

/// A pixel, counted from the left and from the top, from 0.
///
/// # Errors
/// What is wrong with the text.
pub fn pixel(text: &str) -> Result<[u32; 2], String> {
    let parts: Vec<Option<u32>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
    match parts[..] {
        [Some(i), Some(j)] => Ok([i, j]),
        _ => {
            Err("a pixel is two whole numbers with a comma between them, from the left and from the top, as in 400,300"
                .into())
        }
    }
}

/// Steps, each > 0, with commas between them.
///
/// # Errors
/// What is wrong with the text.
pub fn steps(text: &str) -> Result<Steps, String> {
    let list = text.split(',').map(positive).collect::<Result<Vec<f64>, String>>()?;
    match list.len() {
        1..=MAX_STEPS => Ok(Steps(list)),
        _ => Err(format!("at most {MAX_STEPS} steps are compared")),
    }
}

/// A whole number.
///
/// # Errors
/// What is wrong with the text.
pub fn whole<const LEAST: u64, const MOST: u64>(text: &str) -> Result<u64, String> {
    let value = text.trim().parse().ok().filter(|value| (LEAST..=MOST).contains(value));
    value.ok_or_else(|| format!("a whole number from {LEAST} to {MOST} is needed"))
}

/// A number > 0.
///
/// # Errors
/// What is wrong with the text.
pub fn positive(text: &str) -> Result<f64, String> {
    match finite(text)? {
        value if value > 0.0 => Ok(value),
        _ => Err("it must be more than 0".into()),
    }
}

/// An angle between 0 and 180 degrees.
///
/// # Errors
/// What is wrong with the text.
pub fn field_of_view(text: &str) -> Result<f64, String> {
    match finite(text)? {
        value if value > 0.0 && value < 180.0 => Ok(value),
        _ => Err("it must be more than 0 and less than 180 degrees".into()),
    }
}

/// A number of threads, moved into what can be started.
///
/// # Errors
/// What is wrong with the text.
pub fn threads(text: &str) -> Result<usize, String> {
    let digits = text.trim();
    if digits.is_empty() || !digits.bytes().all(|b| b.is_ascii_digit()) {
        return Err(format!("'{}' is no whole number", shown(text)));
    }
    Ok(digits.parse().unwrap_or(MAX_THREADS).clamp(1, MAX_THREADS))
}

/// Azimuth, elevation and perhaps a distance.
///
/// # Errors
/// What is wrong with the text.
pub fn orbit(text: &str) -> Result<OrbitArg, String> {
    if let Ok([azimuth, elevation]) = numbers::<2>(text) {
        return Ok(OrbitArg { azimuth, elevation, distance: None });
    }
    let example = "azimuth and elevation, and a distance if you like, are needed, as in 30,20 or 30,20,5";
    let mended = with_commas(text).filter(|mended| mended != text && mended.split(',').count() <= 3);
    let [azimuth, elevation, distance] = numbers::<3>(text).map_err(|_| match mended {
        Some(mended) => format!("{example}: write {mended}"),
        None => example.to_owned(),
    })?;
    if distance <= 0.0 {
        return Err("the distance must be more than 0".into());
    }
    Ok(OrbitArg { azimuth, elevation, distance: Some(distance) })
}

/// The ends of a box in x, y and z.
///
/// # Errors
/// What is wrong with the text.
pub fn box_bounds(text: &str) -> Result<BoxArg, String> {
    let [x0, x1, y0, y1, z0, z1] = numbers::<6>(text)?;
    for (name, low, high) in [("x", x0, x1), ("y", y0, y1), ("z", z0, z1)] {
        if low >= high {
            return Err(format!("in {name} the lower end {low} is not below the upper end {high}"));
        }
    }
    Ok(BoxArg { min: [x0, y0, z0], max: [x1, y1, z1] })
}

/// A centre and a radius.
///
/// # Errors
/// What is wrong with the text.
pub fn ball(text: &str) -> Result<BallArg, String> {
    let [x, y, z, radius] = numbers::<4>(text)?;
    if radius <= 0.0 {
        return Err("the radius must be more than 0".into());
    }
    Ok(BallArg { center: [x, y, z], radius })
}

/// A name and its exact value.
///
/// # Errors
/// What is wrong with the text.
pub fn setting(text: &str) -> Result<(String, Rational), String> {
    let (name, value) = text.split_once('=').ok_or("write NAME=VALUE, as in a=0.7")?;
    let negative = value.trim().strip_prefix('-');
    let digits = negative.unwrap_or(value).trim();
    let rational = Rational::from_decimal(digits).ok_or_else(|| format!("'{}' is no number", shown(value)))?;
    let name = name.trim();
    let is_name = name.starts_with(char::is_alphabetic) && name.chars().all(|c| c.is_alphanumeric() || c == '_');
    if !is_name {
        return Err(format!("'{}' is no name; write NAME=VALUE, as in a=0.7", shown(name)));
    }
    Ok((name.to_owned(), if negative.is_some() { rational.negated() } else { rational }))
}

/// A number of stops.
///
/// # Errors
/// If it is none, or so large that nothing would be left to see.
pub fn exposure(text: &str) -> Result<f64, String> {
    match finite(text)? {
        stops if stops.abs() <= MAX_EXPOSURE => Ok(stops),
        _ => Err(format!("a number of stops from -{MAX_EXPOSURE} to {MAX_EXPOSURE} is needed")),
    }
}

/// The tone curve of a name.
///
/// # Errors
/// That there is none, with those there are.
pub fn tonemap(name: &str) -> Result<Tone, String> {
    Tone::from_name(name).ok_or_else(|| unknown("tone curve", name, &Tone::CURVES))
}

/// The filter of a name.
///
/// # Errors
/// That there is none, with those there are.
pub fn filter(name: &str) -> Result<Filter, String> {
    Filter::from_name(name).ok_or_else(|| unknown("filter", name, &Filter::ALL))
}

fn unknown<T>(what: &str, name: &str, all: &[(&'static str, T)]) -> String {
    let names: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
    format!("there is no {what} '{}'; there are {}", shown(name), names.join(", "))
}

/// The mode of a name.
///
/// # Errors
/// That there is none, with those there are.
pub fn mode(name: &str) -> Result<Mode, String> {
    Mode::from_name(name).ok_or_else(|| unknown("mode", name, &Mode::ALL))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_read_and_refused() {
        assert_eq!(numbers::<3>("-1, 2,3e-1"), Ok([-1.0, 2.0, 0.3]));
        assert!(numbers::<3>("1,2").is_err() && numbers::<3>("1,2,inf").is_err() && numbers::<3>("a,b,c").is_err());
        assert_eq!(listed::<3>("1 2\t3"), Ok([1.0, 2.0, 3.0]));
        assert_eq!(threads("0"), Ok(1));
        assert_eq!(threads("99999999999999999999999"), Ok(1024));
        assert!(threads("-1").is_err() && threads("two").is_err());
        assert_eq!(orbit("10,-20"), Ok(OrbitArg { azimuth: 10.0, elevation: -20.0, distance: None }));
        assert!(orbit("10,20,-3").is_err() && orbit("10").is_err());
        assert!(box_bounds("1,0,0,1,0,1").unwrap_err().contains("in x"));
        assert!(ball("0,0,0,0").is_err());
        let half = Rational::from_fraction(-1, 2).unwrap();
        assert_eq!(setting("a=-0.5"), Ok(("a".into(), half)));
        assert!(setting("a").is_err() && setting("a=b").is_err() && setting("-a=1").is_err() && setting("=1").is_err());
        assert!(setting("θ_1=2").is_ok());
        assert_eq!((whole::<1, 9>(" 9 "), whole::<0, { u64::MAX }>("0")), (Ok(9), Ok(0)));
        assert!(["", "x", "-1", "1.5", "0", "10"].into_iter().all(|text| whole::<1, 9>(text).is_err()));
        assert!(mode("curvature").is_ok() && mode("radiosity").unwrap_err().contains("no mode 'radiosity'"));
    }
    #[test]
    fn numbers_written_in_another_way_are_shown_in_ours() {
        let rows = [
            ("1 2 3", Some("1,2,3")),
            ("(1, -2, 3)", Some("1,-2,3")),
            ("[1;2;3e2]", Some("1,2,3e2")),
            ("1,2,", Some("1,2")),
            ("1 2 x", None),
            ("1", None),
            ("", None),
        ];
        for (text, expected) in rows {
            assert_eq!(with_commas(text).as_deref(), expected, "{text}");
        }
        assert!(numbers::<3>("1 2 3").unwrap_err().ends_with("write 1,2,3"));
        assert!(numbers::<3>("1 2").unwrap_err().ends_with("here are 2"));
        assert!(numbers::<3>("1").unwrap_err().ends_with("as in 1,2,3; here is 1"));
        assert!(orbit("30 20").unwrap_err().ends_with("write 30,20"));
    }
}
