//! Line drawings as SVG, and what is safe to stand in markup.
//!
//! In: lines, dots, words at places in pixels. Out: one `svg` element that needs nothing else. Separate because every
//! figure is made of the same few strokes.

use std::fmt::Write;

/// Colours that differ also for those who see few (Okabe and Ito 2008, "Color Universal Design").
pub mod ink {
    /// Text and axes.
    pub const BLACK: &str = "#1b1f24";
    /// What stands behind.
    pub const GREY: &str = "#8a9199";
    /// The curve.
    pub const BLUE: &str = "#0072b2";
    /// What is missed or left.
    pub const RED: &str = "#d55e00";
    /// What is proven.
    pub const GREEN: &str = "#009e73";
    /// Newton's tangents.
    pub const PURPLE: &str = "#aa4499";
}

/// A drawing in the making.
#[derive(Clone, Debug)]
pub struct Svg {
    width: f64,
    height: f64,
    body: String,
}

impl Svg {
    /// An empty drawing of so many pixels.
    pub fn new(width: f64, height: f64) -> Svg {
        Svg { width, height, body: String::new() }
    }

    /// A straight line.
    pub fn line(&mut self, from: (f64, f64), to: (f64, f64), colour: &str, width: f64) {
        let ((x0, y0), (x1, y1)) = (from, to);
        let _ = writeln!(
            self.body,
            "<line x1=\"{x0:.1}\" y1=\"{y0:.1}\" x2=\"{x1:.1}\" y2=\"{y1:.1}\" stroke=\"{colour}\" stroke-width=\"{width}\"/>"
        );
    }

    /// A line of many points, broken where a point is not finite.
    pub fn curve(&mut self, points: &[(f64, f64)], colour: &str, width: f64) {
        for run in points.split(|(x, y)| !(x.is_finite() && y.is_finite())).filter(|run| run.len() > 1) {
            let list: Vec<String> = run.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
            let _ = writeln!(
                self.body,
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>",
                list.join(" ")
            );
        }
    }

    /// A dot.
    pub fn dot(&mut self, (x, y): (f64, f64), radius: f64, colour: &str) {
        let _ = writeln!(self.body, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{colour}\"/>");
    }

    /// A filled rectangle.
    pub fn area(&mut self, (x, y): (f64, f64), (w, h): (f64, f64), colour: &str, opacity: f64) {
        let _ = writeln!(
            self.body,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{w:.1}\" height=\"{h:.1}\" fill=\"{colour}\" fill-opacity=\"{opacity}\"/>"
        );
    }

    /// Words; `anchor` is start, middle or end.
    pub fn words(&mut self, (x, y): (f64, f64), text: &str, anchor: &str, colour: &str) {
        let _ = writeln!(
            self.body,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"{colour}\">{}</text>",
            escaped(text)
        );
    }

    /// A node of a graph: words in a rounded box.
    pub fn tag(&mut self, (x, y): (f64, f64), text: &str, width: f64, is_shared: bool) {
        let (fill, stroke) = if is_shared { ("#e3f1fa", ink::BLUE) } else { ("#ffffff", ink::GREY) };
        let _ = writeln!(
            self.body,
            "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{width:.1}\" height=\"22\" rx=\"6\" fill=\"{fill}\" stroke=\"{stroke}\"/>",
            x - width / 2.0,
            y - 15.0
        );
        self.words((x, y), text, "middle", ink::BLACK);
    }

    /// The element; `title` is read aloud to those who do not see it.
    pub fn finish(self, title: &str) -> String {
        let Svg { width, height, body } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" height=\"{height:.0}\" \
             font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" font-size=\"13\" role=\"img\">\n<title>{}</title>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{body}</svg>",
            escaped(title)
        )
    }
}

/// Text that may stand in HTML, SVG and MathML, in attributes too.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out += "&amp;",
            '<' => out += "&lt;",
            '>' => out += "&gt;",
            '"' => out += "&quot;",
            c if c.is_control() && c != '\n' && c != '\t' => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_typed_becomes_markup() {
        assert_eq!(escaped("<script a=\"b\">&\u{1b}"), "&lt;script a=&quot;b&quot;&gt;&amp;\u{fffd}");
    }

    #[test]
    fn curves_break_where_there_is_no_value() {
        let mut svg = Svg::new(10.0, 10.0);
        svg.curve(&[(0.0, 0.0), (1.0, 1.0), (2.0, f64::NAN), (3.0, 3.0), (4.0, 4.0), (5.0, f64::INFINITY)], "red", 1.0);
        assert_eq!(svg.finish("t").matches("<polyline").count(), 2);
    }
}
