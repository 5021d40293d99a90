//! A picture in characters of a terminal.
//!
//! In: a layer, how its values are to be shown, how many characters there are, which colours. Out: lines of text.
//! A character is two pixels: an upper half block in the colour of the upper on the colour of the lower. Without
//! colours, characters that cover more or less stand for light.

use super::{Layer, Size, Tone};
use std::fmt::Write;

/// Which colours a terminal has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colours {
    /// None: light alone, by characters.
    None,
    /// The 256 of xterm.
    Palette,
    /// 24 bits.
    True,
}

/// Characters by how much of their place they cover, as most type faces have them.
const COVERING: &[u8] = b" .:-=+*#%@";

/// The lines of a picture of `size` pixels, two of them a character from top to bottom, with the ends of lines.
/// Light is multiplied by `gain` before it is shown.
pub fn draw(picture: &Layer<[f32; 3]>, tone: Tone, gain: f32, size: Size, colours: Colours) -> String {
    let small = shrunk(picture, size);
    let row = |row: u32| {
        let small = &small;
        (0..size.width()).map(move |i| {
            let bytes = |j: u32| tone.bytes(small.at(i, j).map(|light| light * gain));
            let upper = bytes(2 * row);
            let lower = if 2 * row + 1 < size.height() { bytes(2 * row + 1) } else { upper };
            (upper, lower)
        })
    };
    let rows = (0..size.height().div_ceil(2)).map(|j| row(j).collect::<Vec<_>>());
    match colours {
        Colours::None => covering(&rows.collect::<Vec<_>>()),
        Colours::Palette | Colours::True => rows.map(|row| painted(&row, colours)).collect(),
    }
}

/// Half blocks in the colours of their pixels.
fn painted(row: &[([u8; 3], [u8; 3])], colours: Colours) -> String {
    let mut text = String::new();
    let mut before = None;
    for &(upper, lower) in row {
        if before != Some((upper, lower)) {
            text += &paint("38", upper, colours);
            text += &paint("48", lower, colours);
            before = Some((upper, lower));
        }
        text.push('▀');
    }
    text + "\x1b[0m\n"
}

/// Characters by light, from the darkest of the picture to its lightest.
fn covering(rows: &[Vec<([u8; 3], [u8; 3])>]) -> String {
    // The light of sRGB's primaries (IEC 61966-2-1), in thousandths.
    let light = |[r, g, b]: [u8; 3]| 213 * usize::from(r) + 715 * usize::from(g) + 72 * usize::from(b);
    let of_cell = |&(upper, lower): &([u8; 3], [u8; 3])| light(upper) + light(lower);
    let all = || rows.iter().flatten().map(of_cell);
    let (least, most) = (all().min().unwrap_or(0), all().max().unwrap_or(0));
    let range = (most - least).max(1);
    let character = |cell| COVERING[((of_cell(cell) - least) * (COVERING.len() - 1) + range / 2) / range] as char;
    rows.iter().map(|row| row.iter().map(character).chain(['\n']).collect::<String>()).collect()
}

/// The largest picture of the shape `of` that fits into so many characters of two pixels each.
pub fn fitting(of: Size, columns: u32, rows: u32) -> Size {
    let (width, height) = (u64::from(of.width()), u64::from(of.height()));
    let (across, down) = (u64::from(columns.max(1)), u64::from(rows.max(1)) * 2);
    let (w, h) = if across * height <= down * width {
        (across, (across * height / width).max(1))
    } else {
        ((down * width / height).max(1), down)
    };
    Size::new(w, h).unwrap_or(of)
}

/// The picture in fewer pixels, each the mean of those it stands for.
fn shrunk(picture: &Layer<[f32; 3]>, size: Size) -> Layer<[f32; 3]> {
    let mut small = Layer::filled(size, [0.0; 3]);
    let part = |k: u32, of: u32, all: u32| {
        let start = |k: u32| (u64::from(k) * u64::from(all) / u64::from(of)) as u32;
        start(k)..start(k + 1).max(start(k) + 1).min(all)
    };
    for j in 0..size.height() {
        let rows = part(j, size.height(), picture.size.height());
        for i in 0..size.width() {
            let columns = part(i, size.width(), picture.size.width());
            let mut sum = [0.0f64; 3];
            for (x, y) in rows.clone().flat_map(|y| columns.clone().map(move |x| (x, y))) {
                sum.iter_mut().zip(picture.at(x, y)).for_each(|(sum, light)| *sum += f64::from(light));
            }
            let count = (rows.len() * columns.len()) as f64;
            small.set(i, j, sum.map(|sum| (sum / count) as f32));
        }
    }
    small
}

fn paint(layer: &str, [r, g, b]: [u8; 3], colours: Colours) -> String {
    let mut text = String::new();
    let _ = match colours {
        Colours::True => write!(text, "\x1b[{layer};2;{r};{g};{b}m"),
        Colours::Palette | Colours::None => write!(text, "\x1b[{layer};5;{}m", palette([r, g, b])),
    };
    text
}

/// The nearest of xterm's colours 16 to 255: a cube of six steps a channel and a row of greys.
fn palette(colour: [u8; 3]) -> u8 {
    const STEPS: [u8; 6] = [0, 95, 135, 175, 215, 255];
    let nearest = |c: u8| (0..6).min_by_key(|&k| STEPS[k].abs_diff(c)).unwrap_or(0);
    let cube = colour.map(nearest);
    let mean = colour.iter().map(|&c| u32::from(c)).sum::<u32>() / 3;
    let grey = ((mean.saturating_sub(3)) / 10).min(23) as u8;
    let distance =
        |other: [u8; 3]| -> u32 { colour.iter().zip(other).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum() };
    if distance([8 + 10 * grey; 3]) < distance(cube.map(|k| STEPS[k])) {
        232 + grey
    } else {
        (16 + 36 * cube[0] + 6 * cube[1] + cube[2]) as u8
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_have_the_colours_of_their_pixels() {
        let mut picture = Layer::filled(Size::new(2, 2).unwrap(), [0.0; 3]);
        picture.set(0, 0, [1.0, 0.0, 0.0]);
        picture.set(1, 1, [1.0, 1.0, 1.0]);
        let text = |colours| draw(&picture, Tone::Data, 1.0, picture.size, colours);
        let expected = "\x1b[38;2;255;0;0m\x1b[48;2;0;0;0m▀\x1b[38;2;0;0;0m\x1b[48;2;255;255;255m▀\x1b[0m\n";
        assert_eq!(text(Colours::True), expected);
        let expected = "\x1b[38;5;196m\x1b[48;5;16m▀\x1b[38;5;16m\x1b[48;5;231m▀\x1b[0m\n";
        assert_eq!(text(Colours::Palette), expected);
        assert_eq!(text(Colours::None), " @\n");
    }

    #[test]
    fn pictures_fit_and_keep_their_shape() {
        let rows = [
            ((800, 600), (80, 22), (58, 44)),
            ((800, 600), (20, 50), (20, 15)),
            ((1, 1000), (80, 22), (1, 44)),
            ((1000, 1), (80, 22), (80, 1)),
            ((8, 6), (0, 0), (1, 1)),
        ];
        for ((width, height), (columns, lines), expected) in rows {
            let size = fitting(Size::new(width, height).unwrap(), columns, lines);
            assert_eq!((size.width(), size.height()), expected);
        }
    }

    #[test]
    fn smaller_pictures_are_means() {
        let mut picture = Layer::filled(Size::new(5, 3).unwrap(), [0.0; 3]);
        picture.set(1, 1, [1.0; 3]);
        assert_eq!(shrunk(&picture, picture.size), picture);
        let one = shrunk(&picture, Size::new(1, 1).unwrap());
        assert!((one.at(0, 0)[0] - 1.0 / 15.0).abs() < 1e-7);
    }

    #[test]
    fn every_colour_of_the_palette_is_its_own_nearest() {
        for (colour, index) in [([0, 0, 0], 16), ([255, 255, 255], 231), ([95, 135, 175], 67), ([118, 118, 118], 243)] {
            assert_eq!(palette(colour), index, "{colour:?}");
        }
    }
}
