//! The page of a ray.
//!
//! In: a story and the texts. Out: blocks on a page.

use super::proof::Finding;
use super::{Story, figure};
use crate::teach::classify::COORDINATES;
use crate::teach::notation::{Form, letter};
use crate::teach::page::{Block, Page, digits, shown};
use crate::teach::texts::Texts;
use glam::DVec3;

/// The most rows of a table.
const MOST_ROWS: usize = 40;

/// The most of Newton's steps that are listed; the last one is listed always.
const MOST_STEPS: usize = 12;

/// The most changes of sign whose Newton steps are listed.
const MOST_BRACKETS: usize = 3;

fn vector(v: DVec3) -> String {
    let [x, y, z] = v.to_array().map(shown);
    format!("({x}, {y}, {z})")
}

impl Story {
    /// Adds what is told to a page.
    pub fn write(&self, texts: &Texts, page: &mut Page) {
        let question = &self.question;
        page.say(texts.with(
            "ray.line",
            &[&vector(question.origin), &vector(question.direction), &shown(question.span.0), &shown(question.span.1)],
        ));
        if let Some(g) = &self.g {
            let name = Form::Call("g".into(), vec![Form::name("t")]);
            page.formula(Form::equation(name, with_t(Form::of(g))));
        }
        page.say(texts.get("ray.chain"));
        if self.starts_on_surface {
            page.say(texts.get("ray.start"));
        }
        page.blocks.push(Block::Figure {
            svg: figure::whole(self, texts.get("ray.figure")),
            drawing: figure::characters(self),
            caption: texts.get("ray.figure.caption").into(),
        });
        self.write_march(texts, page);
        self.write_proof(texts, page);
        self.write_missed(texts, page);
        self.write_hit(texts, page);
    }

    fn write_march(&self, texts: &Texts, page: &mut Page) {
        page.heading(texts.with("ray.march", &[&shown(self.question.step)]));
        page.say(texts.with("ray.samples", &[&self.samples.len().to_string(), &self.brackets.len().to_string()]));
        if self.samples.len() > 2 && self.samples.len() <= MOST_ROWS {
            let rows = self.samples.iter().map(|&(t, g)| vec![shown(t), shown(g), sign(g)]).collect();
            page.table(&["t", "g(t)", texts.get("ray.sign")], rows);
        }
        for (k, bracket) in self.brackets.iter().take(MOST_BRACKETS).enumerate() {
            page.say(texts.with("ray.newton", &[&shown(bracket.a), &shown(bracket.b)]));
            let row = |(n, i): (usize, &super::march::Iterate)| {
                let done = if i.left { texts.with("ray.left", &[&shown(i.aim)]) } else { String::new() };
                let order = i.order.map_or(String::new(), |p| digits(p, 3));
                vec![n.to_string(), digits(i.t, 12), digits(i.g.abs(), 3), shown(i.slope), order, done]
            };
            let last = bracket.iterates.len().saturating_sub(1);
            let shown_steps = bracket.iterates.iter().enumerate().filter(|&(n, _)| n < MOST_STEPS || n == last);
            let rows: Vec<Vec<String>> = shown_steps.map(row).collect();
            page.table(&["n", "t", "|g|", "g'", texts.get("ray.order"), texts.get("ray.done")], rows);
            if k == 0
                && let Some(svg) = figure::newton(self, texts.get("ray.newton.figure"))
            {
                let caption = texts.get("ray.newton.caption").to_owned();
                page.blocks.push(Block::Figure { svg, drawing: String::new(), caption });
            }
        }
    }

    fn write_proof(&self, texts: &Texts, page: &mut Page) {
        page.heading(texts.get("ray.proof"));
        if !self.proof.rewritten.is_empty() {
            page.say(texts.with("ray.rewritten", &[&self.proof.rewritten.join(", ")]));
        }
        let finding = |finding: Finding| match finding {
            Finding::Empty => "proof.empty",
            Finding::Undefined => "proof.undefined",
            Finding::MonotoneEmpty => "proof.monotone",
            Finding::Root => "proof.root",
            Finding::Pole => "proof.pole",
            Finding::Excluded => "proof.excluded",
            Finding::Undecided => "proof.undecided",
        };
        let pieces = &self.proof.pieces;
        let rows = pieces.iter().take(MOST_ROWS).map(|p| {
            let range =
                if p.range.is_empty() { "-".into() } else { format!("[{}, {}]", shown(p.range.lo), shown(p.range.hi)) };
            vec![digits(p.a, 9), digits(p.b, 9), p.count.to_string(), range, texts.get(finding(p.finding)).to_owned()]
        });
        let rows: Vec<Vec<String>> = rows.collect();
        page.table(
            &[
                texts.get("proof.from"),
                texts.get("proof.to"),
                texts.get("proof.count"),
                texts.get("proof.range"),
                texts.get("proof.known"),
            ],
            rows,
        );
        if pieces.len() > MOST_ROWS {
            page.say(texts.with("ray.more", &[&(pieces.len() - MOST_ROWS).to_string()]));
        }
        for root in self.proof.roots.iter().take(MOST_ROWS) {
            page.say(
                texts
                    .with("ray.root", &[&digits(root.t, 15), &digits(root.bracket.0, 15), &digits(root.bracket.1, 15)]),
            );
        }
        if self.proof.roots.is_empty() && self.proof.is_complete {
            page.say(texts.get("ray.no_root"));
        }
        let verdict = &self.verdict;
        let proven = texts.get(if verdict.is_proven { "verdict.proven" } else { "verdict.not_proven" });
        page.say(texts.with("ray.verdict", &[texts.get(verdict.outcome), &digits(verdict.t, 10), proven]));
    }

    fn write_missed(&self, texts: &Texts, page: &mut Page) {
        page.heading(texts.get("ray.compared"));
        let (missed, mistaken) = (self.missed(), self.mistaken());
        for &t in missed.iter().take(MOST_ROWS) {
            page.say(texts.with("ray.missed", &[&digits(t, 9)]));
        }
        if !missed.is_empty() && self.keeps_sign {
            page.say(texts.get("ray.double"));
        }
        for (a, b) in mistaken.iter().take(MOST_ROWS) {
            page.say(texts.with("ray.mistaken", &[&shown(*a), &shown(*b)]));
        }
        if missed.is_empty() && mistaken.is_empty() {
            page.say(texts.get(if self.proof.is_complete { "ray.nothing_missed" } else { "ray.not_all_known" }));
        }
    }

    fn write_hit(&self, texts: &Texts, page: &mut Page) {
        let (Some((_, gradient)), Some(optics)) = (self.at_hit, self.optics) else { return };
        page.heading(texts.get("ray.hit"));
        let point = self.question.origin + self.question.direction * self.verdict.t;
        let cell = |key: &str, value: String| vec![texts.get(key).to_owned(), value];
        let products: Vec<String> = (0..3).map(|k| shown(self.question.direction[k] * gradient[k])).collect();
        let names: Vec<String> = COORDINATES.iter().map(|&v| format!("f_{}", letter(v))).collect();
        let none = || texts.get("ray.total").to_owned();
        let mut rows = vec![
            cell("ray.point", vector(point)),
            vec![names.join(", "), vector(gradient)],
            vec![
                "a·f_x + b·f_y + c·f_z".into(),
                format!("{} = {}", products.join(" + "), shown(self.question.direction.dot(gradient))),
            ],
            cell("ray.normal", vector(optics.normal)),
            cell("ray.incidence", format!("{}°", shown(optics.incidence))),
            cell("ray.reflected", vector(optics.reflected)),
            cell(
                "ray.refracted",
                optics.refracted.map_or_else(none, |(d, angle)| format!("{}, {}°", vector(d), shown(angle))),
            ),
        ];
        rows.push(cell("ray.fresnel", format!("{} %", digits(100.0 * optics.exact, 4))));
        rows.push(cell("ray.schlick", format!("{} %", digits(100.0 * optics.schlick, 4))));
        rows.push(cell("ray.cosine", shown(optics.cosine)));
        rows.push(cell("ray.mirror", shown(optics.mirror)));
        page.table(&[texts.get("ray.what"), texts.get("ray.value")], rows);
        page.say(texts.with("ray.sources", &[&shown(self.question.ior), &vector(self.question.light)]));
    }
}

fn sign(g: f64) -> String {
    let sign = if g > 0.0 {
        "+"
    } else if g < 0.0 {
        "-"
    } else if g == 0.0 {
        "0"
    } else {
        ""
    };
    sign.to_owned()
}

/// The variable of g is t.
fn with_t(form: Form) -> Form {
    let all = |list: Vec<Form>| list.into_iter().map(with_t).collect();
    let boxed = |form: Box<Form>| Box::new(with_t(*form));
    match form {
        Form::Name(name) if name == "x" => Form::name("t"),
        Form::Row(binding, list) => Form::Row(binding, all(list)),
        Form::Call(name, list) => Form::Call(name, all(list)),
        Form::Fraction(a, b) => Form::Fraction(boxed(a), boxed(b)),
        Form::Raised(a, b) => Form::Raised(boxed(a), boxed(b)),
        Form::Lowered(a, b) => Form::Lowered(boxed(a), boxed(b)),
        Form::Root(n, a) => Form::Root(n, boxed(a)),
        Form::Bars(a) => Form::Bars(boxed(a)),
        Form::Floor(a) => Form::Floor(boxed(a)),
        Form::Brackets(a) => Form::Brackets(boxed(a)),
        Form::Derivative(v, a) => Form::Derivative(v, boxed(a)),
        Form::Cases(parts) => Form::Cases(Box::new(parts.map(with_t))),
        other @ (Form::Number(_) | Form::Name(_) | Form::Word(_) | Form::Sign(_)) => other,
    }
}
