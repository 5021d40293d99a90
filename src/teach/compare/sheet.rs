//! Pictures and their differences side by side, with the varied number above each.
//!
//! In: drawings, and what became of their pixels. Out: one layer of values as a screen shows them. The numbers are drawn with
//! seven strokes, as on a pocket calculator: a film has no letters.

use super::{Change, Shot};
use crate::film::{Layer, Size, Tone};

/// Pixels between pictures, and those of the line of numbers.
const GAP: u32 = 6;

/// A digit in pixels: width, height, thickness, distance to the next.
const DIGIT: [u32; 4] = [8, 14, 2, 4];

const PAPER: [f32; 3] = [1.0, 1.0, 1.0];
const INK: [f32; 3] = [0.1, 0.12, 0.14];

/// The sheet; `None` if it would be larger than a picture may be.
pub fn sheet(shots: &[Shot], changes: &[Layer<Change>], tone: Tone) -> Option<Layer<[f32; 3]>> {
    let size = shots.first()?.drawing.picture.size;
    let head = DIGIT[1] + 2 * GAP;
    let count = shots.len() as u32;
    let width = count.checked_mul(size.width() + GAP)? + GAP;
    let height = head + 2 * (size.height() + GAP);
    let mut sheet = Layer::filled(Size::new(width.into(), height.into()).ok()?, PAPER);
    for (k, (shot, changes)) in shots.iter().zip(changes).enumerate() {
        let left = GAP + k as u32 * (size.width() + GAP);
        number(&mut sheet, left, GAP, &label(shot.value));
        for j in 0..size.height() {
            for i in 0..size.width() {
                let shown = tone.bytes(shot.drawing.picture.at(i, j)).map(|byte| f32::from(byte) / 255.0);
                sheet.set(left + i, head + j, shown);
                sheet.set(left + i, head + size.height() + GAP + j, changed(changes.at(i, j), shown));
            }
        }
    }
    Some(sheet)
}

/// A pixel of a difference: red missed, blue not there, yellow elsewhere, orange in another colour; else the picture, faint.
fn changed(change: Change, shown: [f32; 3]) -> [f32; 3] {
    match change {
        Change::Missed => [0.90, 0.10, 0.10],
        Change::Extra => [0.05, 0.35, 0.95],
        Change::Moved => [0.95, 0.85, 0.10],
        Change::Recoloured => [0.95, 0.55, 0.10],
        Change::Same => {
            let grey = 0.72 + 0.22 * (shown[0] + shown[1] + shown[2]) / 3.0;
            [grey; 3]
        }
    }
}

fn label(value: Option<f64>) -> String {
    value.map_or("F".into(), crate::teach::page::shown)
}

// table: top, upper left, upper right, middle, lower left, lower right, bottom.
fn strokes(letter: char) -> [bool; 7] {
    let on = match letter {
        '0' => "1110111",
        '1' => "0010010",
        '2' => "1011101",
        '3' => "1011011",
        '4' => "0111010",
        '5' => "1101011",
        '6' => "1101111",
        '7' => "1010010",
        '8' => "1111111",
        '9' => "1111011",
        'F' => "1101100",
        'e' => "1101101",
        '-' => "0001000",
        _ => "0000000",
    };
    let mut out = [false; 7];
    out.iter_mut().zip(on.chars()).for_each(|(stroke, bit)| *stroke = bit == '1');
    out
}

fn number(sheet: &mut Layer<[f32; 3]>, left: u32, top: u32, text: &str) {
    let [w, h, thick, apart] = DIGIT;
    let half = h / 2;
    let mut x = left;
    for letter in text.chars() {
        if letter == '.' {
            area(sheet, [x, top + h - thick, thick, thick]);
            x += thick + apart;
            continue;
        }
        let places = [
            [x, top, w, thick],
            [x, top, thick, half],
            [x + w - thick, top, thick, half],
            [x, top + half - thick / 2, w, thick],
            [x, top + half, thick, half],
            [x + w - thick, top + half, thick, half],
            [x, top + h - thick, w, thick],
        ];
        for (place, is_on) in places.into_iter().zip(strokes(letter)) {
            if is_on {
                area(sheet, place);
            }
        }
        x += w + apart;
    }
}

fn area(sheet: &mut Layer<[f32; 3]>, [x, y, w, h]: [u32; 4]) {
    for j in y..(y + h).min(sheet.size.height()) {
        for i in x..(x + w).min(sheet.size.width()) {
            sheet.set(i, j, INK);
        }
    }
}
