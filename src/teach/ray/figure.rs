//! g(t) drawn: the curve, the samples, the brackets, Newton's tangents, what is proven.
//!
//! In: a story. Out: SVG, and characters for a terminal.

use super::Story;
use super::proof::Finding;
use crate::teach::page::{digits, shown};
use crate::teach::svg::{Svg, ink};

/// Pixels of a figure.
const SIZE: (f64, f64) = (760.0, 380.0);

/// Pixels around the plot: left, top, right, bottom.
const MARGIN: [f64; 4] = [64.0, 16.0, 16.0, 58.0];

/// Characters of a plot on a terminal.
const CHARACTERS: (usize, usize) = (88, 17);

/// The share of values that the plot's height is made for: poles would flatten all else.
const SHARE: f64 = 0.9;

/// The most samples that are drawn as dots.
const MOST_DOTS: usize = 400;

/// The largest |g| that is shown.
fn height(curve: &[(f64, f64)]) -> f64 {
    let mut sizes: Vec<f64> = curve.iter().map(|(_, g)| g.abs()).filter(|size| size.is_finite()).collect();
    sizes.sort_by(f64::total_cmp);
    let largest = sizes.last().copied().unwrap_or(1.0);
    let usual = sizes.get((sizes.len() as f64 * SHARE) as usize).copied().unwrap_or(largest);
    let height = largest.min(3.0 * usual) * 1.1;
    if height > 0.0 && height.is_finite() { height } else { 1.0 }
}

/// A window of the plane, onto pixels.
struct Window {
    span: (f64, f64),
    height: f64,
}

impl Window {
    fn x(&self, t: f64) -> f64 {
        let (a, b) = self.span;
        MARGIN[0] + (t - a) / (b - a) * (SIZE.0 - MARGIN[0] - MARGIN[2])
    }

    fn y(&self, g: f64) -> f64 {
        MARGIN[1] + (0.5 - 0.5 * g / self.height) * (SIZE.1 - MARGIN[1] - MARGIN[3])
    }

    /// The curve, broken where it leaves the window.
    fn points(&self, curve: &[(f64, f64)]) -> Vec<(f64, f64)> {
        let place = |&(t, g): &(f64, f64)| (self.x(t), if g.abs() <= self.height { self.y(g) } else { f64::NAN });
        curve.iter().map(place).collect()
    }

    fn axes(&self, svg: &mut Svg) {
        let (left, right) = (self.x(self.span.0), self.x(self.span.1));
        svg.line((left, self.y(0.0)), (right, self.y(0.0)), ink::BLACK, 1.2);
        svg.line((left, self.y(self.height)), (left, self.y(-self.height)), ink::BLACK, 1.2);
        let bottom = SIZE.1 - MARGIN[3] + 18.0;
        for k in 0..=4 {
            let t = self.span.0 + (self.span.1 - self.span.0) * f64::from(k) / 4.0;
            svg.line((self.x(t), self.y(0.0) - 4.0), (self.x(t), self.y(0.0) + 4.0), ink::BLACK, 1.0);
            let anchor = ["start", "middle", "middle", "middle", "end"][k as usize];
            svg.words((self.x(t), bottom), &shown(t), anchor, ink::BLACK);
        }
        for share in [-0.9, 0.9] {
            svg.words(
                (left - 6.0, self.y(share * self.height) + 4.0),
                &digits(share * self.height, 2),
                "end",
                ink::BLACK,
            );
        }
        svg.words((left - 6.0, self.y(0.0) + 4.0), "0", "end", ink::BLACK);
        svg.words((right, bottom + 16.0), "t", "end", ink::BLACK);
    }
}

/// The whole stretch: curve, samples, changes of sign, and below what is proven piece by piece.
pub fn whole(story: &Story, title: &str) -> String {
    let window = Window { span: story.question.span, height: height(&story.curve.whole) };
    let mut svg = Svg::new(SIZE.0, SIZE.1);
    for bracket in &story.brackets {
        let (a, b) = (window.x(bracket.a), window.x(bracket.b));
        svg.area((a, MARGIN[1]), ((b - a).max(1.5), SIZE.1 - MARGIN[1] - MARGIN[3]), ink::RED, 0.16);
    }
    window.axes(&mut svg);
    svg.curve(&window.points(&story.curve.whole), ink::BLUE, 2.0);
    if story.samples.len() <= MOST_DOTS {
        for &(t, g) in &story.samples {
            let y = if g.abs() <= window.height { window.y(g) } else { window.y(0.0) };
            svg.dot((window.x(t), y), 2.6, if g.abs() <= window.height { ink::BLACK } else { ink::GREY });
        }
    }
    let strip = SIZE.1 - 22.0;
    for piece in &story.proof.pieces {
        let colour = match piece.finding {
            Finding::Empty | Finding::MonotoneEmpty | Finding::Excluded => ink::GREEN,
            Finding::Undefined => ink::GREY,
            Finding::Pole => ink::PURPLE,
            Finding::Root => ink::BLUE,
            Finding::Undecided => ink::RED,
        };
        let (a, b) = (window.x(piece.a), window.x(piece.b));
        svg.area((a, strip), ((b - a - 0.6).max(0.8), 12.0), colour, 0.65);
    }
    for root in &story.proof.roots {
        svg.dot((window.x(root.t), window.y(0.0)), 4.5, ink::GREEN);
    }
    svg.finish(title)
}

/// The first change of sign, with Newton's tangents.
pub fn newton(story: &Story, title: &str) -> Option<String> {
    let bracket = story.brackets.first().filter(|bracket| bracket.b > bracket.a)?;
    let window = Window { span: (bracket.a, bracket.b), height: height(&story.curve.bracket) };
    let mut svg = Svg::new(SIZE.0, SIZE.1);
    window.axes(&mut svg);
    svg.curve(&window.points(&story.curve.bracket), ink::BLUE, 2.0);
    let inside = |t: f64| t.clamp(bracket.a, bracket.b);
    for (k, iterate) in bracket.iterates.iter().take(5).enumerate() {
        if iterate.g.abs() > window.height {
            continue;
        }
        let here = (window.x(iterate.t), window.y(iterate.g));
        // The tangent as far as the window reaches.
        let aim = inside(iterate.aim);
        let colour = if iterate.left { ink::RED } else { ink::PURPLE };
        svg.line(here, (window.x(aim), window.y(iterate.g + iterate.slope * (aim - iterate.t))), colour, 1.6);
        svg.line(here, (here.0, window.y(0.0)), ink::GREY, 0.8);
        svg.dot(here, 3.5, colour);
        svg.words((here.0 + 5.0, here.1 - 7.0), &format!("t{k}"), "start", colour);
    }
    Some(svg.finish(title))
}

/// The plot in characters: `*` the curve, `o` samples, `|` changes of sign, `#` proven roots, below what is proven.
pub fn characters(story: &Story) -> String {
    let (columns, rows) = CHARACTERS;
    let (span, height) = (story.question.span, height(&story.curve.whole));
    let column = |t: f64| (((t - span.0) / (span.1 - span.0) * (columns - 1) as f64 + 0.5) as usize).min(columns - 1);
    let row = |g: f64| (((0.5 - 0.5 * g / height) * (rows - 1) as f64) + 0.5) as usize;
    let mut grid = vec![vec![' '; columns]; rows];
    grid[rows / 2].fill('-');
    for bracket in &story.brackets {
        for line in &mut grid {
            (column(bracket.a)..=column(bracket.b)).for_each(|k| line[k] = if line[k] == ' ' { ':' } else { line[k] });
        }
    }
    for &(t, g) in story.curve.whole.iter().filter(|(_, g)| g.abs() <= height) {
        grid[row(g).min(rows - 1)][column(t)] = '*';
    }
    if story.samples.len() <= columns {
        for &(t, g) in story.samples.iter().filter(|(_, g)| g.abs() <= height) {
            grid[row(g).min(rows - 1)][column(t)] = 'o';
        }
    }
    for root in &story.proof.roots {
        grid[rows / 2][column(root.t)] = '#';
    }
    let mut out = String::new();
    for (k, line) in grid.iter().enumerate() {
        let label = match k {
            0 => shown(height),
            k if k == rows / 2 => "0".into(),
            k if k + 1 == rows => shown(-height),
            _ => String::new(),
        };
        out += format!("{label:>9} {}", line.iter().collect::<String>()).trim_end();
        out.push('\n');
    }
    let mut strip = vec![' '; columns];
    for piece in &story.proof.pieces {
        let mark = match piece.finding {
            Finding::Empty | Finding::MonotoneEmpty | Finding::Excluded => '=',
            Finding::Undefined => '.',
            Finding::Pole => 'x',
            Finding::Root => '#',
            Finding::Undecided => '?',
        };
        for k in column(piece.a)..=column(piece.b) {
            if strip[k] == ' ' || mark != '=' {
                strip[k] = mark;
            }
        }
    }
    let ends = format!("{:<width$}{}", shown(span.0), shown(span.1), width = columns - shown(span.1).len());
    out + &format!("{:>9} {}\n{:>9} {ends}\n", "", strip.iter().collect::<String>(), "t")
}
