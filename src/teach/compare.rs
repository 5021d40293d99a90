//! What a choice costs and changes: the march's step, the number of samples, the number of objects.
//!
//! In: drawings of one scene, the best one first. Out: counts of pixels that differ, pictures of the differences, one
//! sheet of all, and the page about it. Separate from drawing, which knows of one picture at a time.

pub mod sheet;

use super::page::{Block, Page, digits};
use super::texts::Texts;
use crate::film::{Layer, Tone};
use crate::render::Drawing;

/// Depths that differ by more than this part are different: a depth is kept in 24 bits.
const SAME_DEPTH: f32 = 1e-5;

/// Neighbours whose depths differ by more than this part belong to a silhouette.
const SILHOUETTE: f32 = 0.05;

/// Colours that differ by more than this, of 255, look different.
const SAME_COLOUR: u8 = 8;

/// What is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Varied {
    /// The march's step; the first drawing is the faithful method's.
    Step,
    /// The samples a pixel; the first drawing has the most.
    Samples,
    /// The number of objects; the first drawing has all.
    Objects,
    /// The scattering events of a path; the first drawing has the most.
    Bounces,
}

/// One drawing.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The number that was varied; none for the faithful method.
    pub value: Option<f64>,
    /// The drawing, with depths.
    pub drawing: Drawing,
    /// How long it took, in seconds on the wall.
    pub seconds: f64,
}

/// How a drawing differs from the first, in pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Difference {
    /// Where the first has a hit.
    pub hits: usize,
    /// Hits of the first that this one does not have.
    pub missed: usize,
    /// Those of them that lie at a silhouette.
    pub at_silhouettes: usize,
    /// Hits that the first does not have.
    pub extra: usize,
    /// Hits of both at different depths.
    pub moved: usize,
    /// Pixels that look different.
    pub recoloured: usize,
}

/// What became of one pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Nothing.
    Same,
    /// A hit was missed.
    Missed,
    /// A hit where there is none.
    Extra,
    /// Another depth.
    Moved,
    /// Another colour.
    Recoloured,
}

/// What became of every pixel; colours are compared only where depths cannot differ.
pub fn changes(best: &Drawing, other: &Drawing, tone: Tone, varied: Varied) -> Layer<Change> {
    let mut layer = Layer::filled(best.picture.size, Change::Same);
    for j in 0..layer.size.height() {
        for i in 0..layer.size.width() {
            let depth = |drawing: &Drawing| drawing.depth.as_ref().map_or(f32::INFINITY, |depth| depth.at(i, j));
            let (a, b) = (depth(best), depth(other));
            let bytes = |drawing: &Drawing| tone.bytes(drawing.picture.at(i, j));
            let far = bytes(best).into_iter().zip(bytes(other)).any(|(x, y)| x.abs_diff(y) > SAME_COLOUR);
            let change = match (a.is_finite(), b.is_finite()) {
                (true, false) => Change::Missed,
                (false, true) => Change::Extra,
                (true, true) if (a - b).abs() > SAME_DEPTH * a.max(b) => Change::Moved,
                _ if varied != Varied::Step && far => Change::Recoloured,
                _ => Change::Same,
            };
            layer.set(i, j, change);
        }
    }
    layer
}

/// Counts the changes.
pub fn difference(best: &Drawing, changes: &Layer<Change>) -> Difference {
    let mut found = Difference::default();
    for j in 0..changes.size.height() {
        for i in 0..changes.size.width() {
            let is_hit = best.depth.as_ref().is_some_and(|depth| depth.at(i, j).is_finite());
            found.hits += usize::from(is_hit);
            match changes.at(i, j) {
                Change::Same => {}
                Change::Missed => {
                    found.missed += 1;
                    found.at_silhouettes += usize::from(is_silhouette(best, i, j));
                }
                Change::Extra => found.extra += 1,
                Change::Moved => found.moved += 1,
                Change::Recoloured => found.recoloured += 1,
            }
        }
    }
    found
}

/// Whether a neighbour of a hit misses, or lies much nearer or farther; so at the picture's edge.
fn is_silhouette(best: &Drawing, i: u32, j: u32) -> bool {
    let Some(depth) = &best.depth else { return false };
    let here = depth.at(i, j);
    let (right, bottom) = ((i + 1).min(depth.size.width() - 1), (j + 1).min(depth.size.height() - 1));
    let near = (i.saturating_sub(1)..=right).flat_map(|x| (j.saturating_sub(1)..=bottom).map(move |y| (x, y)));
    near.into_iter().any(|(x, y)| !((depth.at(x, y) - here).abs() <= SILHOUETTE * here))
}

/// What comparing says.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// What was varied.
    pub varied: Varied,
    /// The drawings' numbers, times, and evaluations of f (points, enclosures).
    pub shots: Vec<(Option<f64>, f64, [u64; 2])>,
    /// How each differs from the first; the first not at all.
    pub differences: Vec<Difference>,
    /// All pictures and differences.
    pub sheet: Layer<[f32; 3]>,
}

/// Compares drawings with the first of them.
pub fn compare(shots: &[Shot], tone: Tone, varied: Varied) -> Option<Comparison> {
    let best = &shots.first()?.drawing;
    let layers: Vec<Layer<Change>> = shots.iter().map(|shot| changes(best, &shot.drawing, tone, varied)).collect();
    let differences = layers.iter().map(|layer| difference(best, layer)).collect();
    let work = |drawing: &Drawing| {
        let counts = drawing.report.counts;
        [counts.points + counts.gradients, counts.cells]
    };
    let rows = shots.iter().map(|shot| (shot.value, shot.seconds, work(&shot.drawing))).collect();
    Some(Comparison { varied, shots: rows, differences, sheet: sheet::sheet(shots, &layers, tone)? })
}

impl Comparison {
    /// Adds a sentence a drawing, the table and the sheet to a page.
    pub fn write(&self, texts: &Texts, png: Vec<u8>, page: &mut Page) {
        let key = match self.varied {
            Varied::Step => "compare.step",
            Varied::Samples => "compare.samples",
            Varied::Objects => "compare.objects",
            Varied::Bounces => "compare.bounces",
        };
        let name =
            |value: Option<f64>| value.map_or(texts.get("compare.faithful").to_owned(), |value| digits(value, 6));
        let percent = |part: usize, whole: usize| digits(100.0 * part as f64 / whole.max(1) as f64, 3);
        for ((value, ..), d) in self.shots.iter().zip(&self.differences).skip(1) {
            let all = d.missed + d.extra + d.moved + d.recoloured;
            page.say(match self.varied {
                Varied::Step => texts.with(
                    "compare.step.says",
                    &[
                        &name(*value),
                        &percent(d.missed, d.hits),
                        &d.missed.to_string(),
                        &d.at_silhouettes.to_string(),
                        &d.extra.to_string(),
                        &d.moved.to_string(),
                    ],
                ),
                Varied::Samples => texts.with("compare.samples.says", &[&name(*value), &all.to_string()]),
                Varied::Objects => texts.with("compare.objects.says", &[&name(*value), &all.to_string()]),
                Varied::Bounces => texts.with("compare.bounces.says", &[&name(*value), &all.to_string()]),
            });
        }
        let columns = [
            "compare.missed",
            "compare.silhouettes",
            "compare.extra",
            "compare.moved",
            "compare.recoloured",
            "compare.points",
            "compare.cells",
            "compare.seconds",
        ];
        let head: Vec<&str> = std::iter::once(texts.get(key)).chain(columns.iter().map(|key| texts.get(key))).collect();
        let rows = self.shots.iter().zip(&self.differences).map(|((value, seconds, [points, cells]), d)| {
            let counts = [d.missed, d.at_silhouettes, d.extra, d.moved, d.recoloured].map(|n| n.to_string());
            let work = [points.to_string(), cells.to_string(), digits(*seconds, 3)];
            std::iter::once(name(*value)).chain(counts).chain(work).collect()
        });
        page.table(&head, rows.collect());
        page.blocks.push(Block::Picture { png, caption: texts.get("compare.sheet").into() });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::Size;
    use crate::render::{Pass, Report};

    fn drawing(depths: [f32; 9]) -> Drawing {
        let size = Size::new(3, 3).unwrap();
        let picture = Layer::filled(size, [0.5; 3]);
        let depth = Some(Layer { size, values: depths.to_vec() });
        Drawing { picture, alpha: None, depth, normals: None, report: Report::default(), pass: Pass::Last }
    }

    #[test]
    fn pixels_are_counted_by_what_became_of_them() {
        let none = f32::INFINITY;
        let best = drawing([none, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0]);
        let other = drawing([2.0, none, 1.0, 1.0, 1.0, 1.5, 1.0, 1.0, none]);
        let layer = changes(&best, &other, Tone::Linear, Varied::Step);
        let found = difference(&best, &layer);
        let expected = Difference { hits: 8, missed: 2, at_silhouettes: 1, extra: 1, moved: 1, recoloured: 0 };
        assert_eq!(found, expected);
        let mut brighter = best.clone();
        brighter.picture.set(2, 2, [0.9; 3]);
        let layer = changes(&best, &brighter, Tone::Linear, Varied::Samples);
        assert_eq!(difference(&best, &layer).recoloured, 1);
    }

    #[test]
    fn a_sheet_has_two_rows_and_a_column_a_drawing() {
        let shot = |value| Shot { value, drawing: drawing([1.0; 9]), seconds: 0.0 };
        let found = compare(&[shot(None), shot(Some(0.5))], Tone::Linear, Varied::Step).unwrap();
        assert!(found.sheet.size.width() >= 2 * 3 && found.sheet.size.height() >= 2 * 3);
        assert!(compare(&[], Tone::Linear, Varied::Step).is_none());
    }
}
