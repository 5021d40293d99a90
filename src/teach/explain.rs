//! A surface explained: what was read, what it is, its derivatives by rule, its graph, its evaluation.
//!
//! In: a graph and the node of a surface's function. Out: an [`Explanation`], and the page it makes. Separate from the
//! command, which adds the program and says in which form it is wanted.

use super::classify::{COORDINATES, Facts, facts};
use super::derivation::{Derivation, derive};
use super::evaluation::{Evaluation, MAX_LISTED, evaluation, shared_parts};
use super::notation::{Form, letter};
use super::page::{Block, Page};
use super::term::Term;
use super::texts::Texts;
use super::{drawing, page};
use crate::expr::equation;
use crate::expr::graph::{Graph, NodeId};
use crate::expr::print;
use crate::num::level::Simd;
use crate::scene::Framing;

/// Formulas longer than this, in bytes, are named by their parts.
const LONGEST: usize = 2000;

/// The derivation of one derivative, and what comparing its lines at points says.
#[derive(Clone, Debug, PartialEq)]
pub struct Slope {
    /// The lines; none if they would be too long.
    pub derivation: Option<Derivation>,
    /// The line that does not have the value of the one before, if any; it would be a mistake of ours.
    pub wrong: Option<usize>,
    /// At how many points the lines were compared.
    pub points: usize,
}

/// A surface explained.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// f, written out; none if it is too long.
    pub f: Option<Term>,
    /// What f = 0 is.
    pub facts: Facts,
    /// The same as sentences.
    pub sentences: Vec<String>,
    /// f_x, f_y, f_z.
    pub slopes: Vec<Slope>,
    /// The graph in characters and as SVG; none if it is too large.
    pub drawing: Option<(String, String)>,
    /// The parts used more than once, and how often.
    pub shared: Vec<(String, usize)>,
    /// What runs.
    pub evaluation: Evaluation,
}

/// Explains f = 0, or the region where f ≤ 0.
pub fn explain(graph: &mut Graph, f: NodeId, is_solid: bool, framing: Option<Framing>, texts: &Texts) -> Explanation {
    let term = Term::of(graph, f);
    let found = facts(graph, f);
    let mut sentences = Vec::new();
    if is_solid {
        sentences.push(texts.get("fact.solid").to_owned());
    }
    say_facts(graph, &found, texts, &mut sentences);
    if !is_solid {
        say_rewriting(graph, f, texts, &mut sentences);
    }
    say_framing(&found, framing, texts, &mut sentences);
    let slopes = COORDINATES
        .into_iter()
        .map(|v| {
            let derivation = term.as_ref().and_then(|f| derive(f, v));
            let (wrong, points) =
                derivation.as_ref().map_or((None, 0), |derivation| derivation.compared(graph, Simd::best()));
            Slope { derivation, wrong, points }
        })
        .collect();
    let drawing = drawing::characters(graph, f).zip(drawing::svg(graph, f, texts.get("explain.graph")));
    let shared = shared_parts(graph, f);
    let evaluation = evaluation(graph, f);
    Explanation { f: term, facts: found, sentences, slopes, drawing, shared, evaluation }
}

fn say_facts(graph: &Graph, facts: &Facts, texts: &Texts, out: &mut Vec<String>) {
    match facts.degree {
        Some(degree) => out.push(texts.with("fact.degree", &[&degree.to_string()])),
        None => out.push(texts.get("fact.no_polynomial").into()),
    }
    if facts.degree == Some(1) {
        out.push(texts.get("fact.plane").into());
    }
    if let Some(quadric) = &facts.quadric {
        let signs = |s: [usize; 3]| format!("{}, {}, {}", s[0], s[1], s[2]);
        let name = texts.get(quadric.kind);
        out.push(texts.with("fact.quadric", &[name, &signs(quadric.signs), &signs(quadric.all_signs)]));
        if let Some([x, y, z]) = &quadric.centre {
            out.push(texts.with("fact.centre", &[&format!("({x}, {y}, {z})")]));
        }
    }
    for &(v, u) in &facts.graphs {
        let u = print::text(graph, u, LONGEST).unwrap_or_else(|| "…".into());
        out.push(texts.with("fact.graph", &[&format!("{} = {u}", letter(v))]));
    }
    for &v in &facts.absent {
        out.push(texts.with("fact.absent", &[letter(v)]));
    }
    for &axis in &facts.axes {
        out.push(texts.with("fact.axis", &[letter(axis)]));
    }
    if !facts.symmetries.is_empty() {
        let names: Vec<&str> = facts.symmetries.iter().map(|key| texts.get(key)).collect();
        out.push(texts.with("fact.symmetries", &[&names.join(", ")]));
    }
    match facts.is_bounded {
        Some(true) => out.push(texts.get("fact.bounded").into()),
        Some(false) => out.push(texts.get("fact.unbounded").into()),
        None => {}
    }
}

/// What the tracer solves instead of f = 0, where that is something else.
fn say_rewriting(graph: &mut Graph, f: NodeId, texts: &Texts, out: &mut Vec<String>) {
    let equation = equation::sheets(graph, f);
    if equation.steps.is_empty() {
        return;
    }
    let text = |graph: &Graph, id: NodeId| print::text(graph, id, LONGEST).unwrap_or_else(|| "…".into());
    let list: Vec<String> = equation.sheets.iter().map(|sheet| format!("{} = 0", text(graph, sheet.g))).collect();
    let rules: Vec<&str> = equation.steps.iter().map(|step| step.name).collect();
    match list.is_empty() {
        true => out.push(texts.with("fact.no_sheet", &[&rules.join("; ")])),
        false => out.push(texts.with("fact.rewritten", &[&list.join(", "), &rules.join("; ")])),
    }
    if let [sheet] = &equation.sheets[..] {
        let of_sheet = facts(graph, sheet.g);
        if let Some(quadric) = of_sheet.quadric {
            out.push(texts.with("fact.same_as", &[texts.get(quadric.kind)]));
        }
    }
}

fn say_framing(facts: &Facts, framing: Option<Framing>, texts: &Texts, out: &mut Vec<String>) {
    if let Some(framing) = framing.filter(|framing| framing.is_all && facts.is_bounded != Some(false)) {
        let [x, y, z] = framing.center.to_array().map(page::shown);
        out.push(texts.with("fact.framed", &[&format!("({x}, {y}, {z})"), &page::shown(framing.radius)]));
    }
}

impl Explanation {
    /// Adds what is explained to a page.
    pub fn write(&self, texts: &Texts, page: &mut Page) {
        page.heading(texts.get("explain.is"));
        self.sentences.iter().for_each(|sentence| page.say(sentence.clone()));
        page.heading(texts.get("explain.derivatives"));
        self.write_slopes(texts, page);
        page.heading(texts.get("explain.graph"));
        match &self.drawing {
            Some((drawing, svg)) => page.blocks.push(Block::Figure {
                svg: svg.clone(),
                drawing: drawing.clone(),
                caption: texts.get("explain.graph.caption").into(),
            }),
            None => page.say(texts.with("explain.graph.large", &[&drawing::MAX_DRAWN.to_string()])),
        }
        if !self.shared.is_empty() {
            let rows =
                self.shared.iter().take(MAX_LISTED).map(|(text, uses)| vec![text.clone(), uses.to_string()]).collect();
            page.table(&[texts.get("explain.shared"), texts.get("explain.uses")], rows);
        }
        self.write_evaluation(texts, page);
    }

    fn write_slopes(&self, texts: &Texts, page: &mut Page) {
        if self.f.is_none() {
            page.say(texts.get("explain.long"));
            return;
        }
        for (v, slope) in COORDINATES.into_iter().zip(&self.slopes) {
            let Some(derivation) = &slope.derivation else {
                page.say(texts.with("explain.long.derivation", &[letter(v)]));
                continue;
            };
            let mut lines = Vec::new();
            for line in &derivation.lines {
                let note = if line.rule.is_empty() { String::new() } else { texts.get(line.rule).to_owned() };
                lines.push((Form::equation(Form::partial(v), Form::of(&line.term)), note));
            }
            page.blocks.push(Block::Formulas(lines));
            page.say(match slope.wrong {
                None => texts.with("explain.compared", &[&slope.points.to_string()]),
                Some(k) => texts.with("explain.differs", &[&k.to_string()]),
            });
        }
    }

    fn write_evaluation(&self, texts: &Texts, page: &mut Page) {
        let evaluation = &self.evaluation;
        page.heading(texts.get("explain.evaluation"));
        let count = |n: usize| n.to_string();
        page.say(texts.with(
            "explain.tape",
            &[
                &count(evaluation.steps.len()),
                &count(evaluation.registers),
                &count(evaluation.gradient_steps),
                &count(evaluation.gradient_registers),
            ],
        ));
        page.say(texts.with("explain.sharing", &[&evaluation.written_out.to_string(), &count(evaluation.shared)]));
        if evaluation.steps.len() <= MAX_LISTED {
            page.blocks.push(Block::Code(evaluation.steps.join("\n")));
        }
    }
}
