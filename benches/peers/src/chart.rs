//! Charts: lines over two axes, as plain SVG.
//!
//! In: named series of points. Out: the text of a picture that can be read on light and on dark ground.

/// Which steps an axis has.
#[derive(Clone, Copy, PartialEq)]
pub enum Scale {
    /// Equal factors.
    Logarithmic,
    /// Equal differences.
    Linear,
}

impl Scale {
    /// 0 at `least`, 1 at `most`.
    fn part(self, value: f64, least: f64, most: f64) -> f64 {
        match self {
            Scale::Logarithmic => (value / least).ln() / (most / least).ln(),
            Scale::Linear => (value - least) / (most - least),
        }
    }
}

/// A line and its name.
pub struct Series {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

pub struct Chart<'a> {
    pub title: &'a str,
    pub across: &'a str,
    pub up: &'a str,
    pub scale_across: Scale,
    /// From 0 where linear.
    pub scale_up: Scale,
    pub series: Vec<Series>,
}

/// The picture and the field inside it, in pixels.
const SIZE: (f64, f64) = (640.0, 360.0);
const FIELD: (f64, f64, f64, f64) = (60.0, 56.0, 470.0, 310.0);

/// The least distance of two names at the right edge.
const LINE: f64 = 16.0;

/// Colours of middling lightness: they stand out from white and from black.
const COLOURS: [&str; 5] = ["#2f7fd8", "#cf5a1c", "#2f9a48", "#a45bd6", "#b28a00"];

const STYLE: &str = "text{font:12px sans-serif;fill:#333}.t{font-size:14px}.g{stroke:#8884}.e{text-anchor:end}.m{text-anchor:middle}\
                     path{fill:none;stroke-width:2}@media(prefers-color-scheme:dark){text{fill:#ccc}}";

impl Chart<'_> {
    pub fn svg(&self) -> String {
        let (left, top, right, bottom) = FIELD;
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n\
             <style>{STYLE}</style>\n<text class=\"t\" x=\"{left}\" y=\"20\">{2}</text>\n\
             <text class=\"m\" x=\"{3}\" y=\"350\">{4}</text>\n<text x=\"{left}\" y=\"{5}\">{6}</text>\n",
            SIZE.0,
            SIZE.1,
            self.title,
            (left + right) / 2.0,
            self.across,
            top - 16.0,
            self.up,
        );
        for value in self.ticks_up() {
            let y = self.y(value);
            text += &format!(
                "<path class=\"g\" d=\"M{left} {y:.1}H{right}\"/><text class=\"e\" x=\"{}\" y=\"{:.1}\">{value}</text>\n",
                left - 6.0,
                y + 4.0
            );
        }
        for value in self.ticks_across() {
            text += &format!("<text class=\"m\" x=\"{:.1}\" y=\"{}\">{value}</text>\n", self.x(value), bottom + 18.0);
        }
        text + &self.lines() + "</svg>\n"
    }

    fn lines(&self) -> String {
        let mut text = String::new();
        for (series, colour) in self.series.iter().zip(COLOURS.iter().cycle()) {
            let places: Vec<(f64, f64)> = series.points.iter().map(|&(x, y)| (self.x(x), self.y(y))).collect();
            let steps: Vec<String> = places.iter().map(|(x, y)| format!("{x:.1} {y:.1}")).collect();
            text += &format!("<path stroke=\"{colour}\" d=\"M{}\"/>", steps.join("L"));
            for (x, y) in places {
                text += &format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{colour}\"/>");
            }
            text.push('\n');
        }
        for (k, y) in self.names() {
            let (colour, name) = (COLOURS[k % COLOURS.len()], &self.series[k].name);
            text += &format!("<text x=\"{}\" y=\"{y:.1}\" style=\"fill:{colour}\">{name}</text>\n", FIELD.2 + 10.0);
        }
        text
    }

    /// Where each series' name stands: beside its last point, but clear of the others.
    fn names(&self) -> Vec<(usize, f64)> {
        let mut places: Vec<(usize, f64)> = self
            .series
            .iter()
            .enumerate()
            .filter_map(|(k, series)| Some((k, self.y(series.points.last()?.1) + 4.0)))
            .collect();
        places.sort_by(|a, b| a.1.total_cmp(&b.1));
        for k in 1..places.len() {
            places[k].1 = places[k].1.max(places[k - 1].1 + LINE);
        }
        places
    }

    fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.series.iter().flat_map(|series| series.points.iter().copied())
    }

    fn x(&self, value: f64) -> f64 {
        let least = self.points().map(|p| p.0).fold(f64::INFINITY, f64::min);
        let most = self.points().map(|p| p.0).fold(0.0, f64::max);
        FIELD.0 + 14.0 + (FIELD.2 - FIELD.0 - 28.0) * self.scale_across.part(value, least, most)
    }

    fn y(&self, value: f64) -> f64 {
        let (least, most) = self.bounds_up();
        FIELD.3 - (FIELD.3 - FIELD.1) * self.scale_up.part(value, least, most)
    }

    /// The values at the lower and upper edge: powers of ten, their doubles and fivefolds.
    fn bounds_up(&self) -> (f64, f64) {
        let least = self.points().map(|p| p.1).fold(f64::INFINITY, f64::min);
        let most = self.points().map(|p| p.1).fold(0.0, f64::max);
        let below = steps().filter(|&step| step <= least).fold(f64::NAN, f64::max);
        let above = steps().filter(|&step| step >= most).fold(f64::NAN, f64::min);
        (if self.scale_up == Scale::Linear { 0.0 } else { below }, above)
    }

    fn ticks_up(&self) -> Vec<f64> {
        let (least, most) = self.bounds_up();
        match self.scale_up {
            Scale::Logarithmic => steps().filter(|step| (least..=most).contains(step)).collect(),
            Scale::Linear => (0..=4).map(|k| most * f64::from(k) / 4.0).collect(),
        }
    }

    fn ticks_across(&self) -> Vec<f64> {
        let mut values: Vec<f64> = self.points().map(|p| p.0).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    }
}

/// 1, 2, 5, 10, 20 … from a hundredth to ten millions.
fn steps() -> impl Iterator<Item = f64> {
    (-2..8).flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * 10f64.powi(power)))
}
