//! `implicit explain`: a surface as mathematics.
//!
//! In: programs. Out: a page about each of their surfaces, or of one definition.

use super::args::teaching::ExplainArgs;
use super::complaint::Complaint;
use super::{eval, pages, programs, render};
use crate::expr::graph::NodeId;
use crate::expr::lower::Kind;
use crate::expr::print;
use crate::scene::Framing;
use crate::session::{Plan, Program, Wishes};
use crate::syntax::{self, ast::Statement};
use crate::teach::derivation::Derivation;
use crate::teach::explain::{Explanation, explain};
use crate::teach::notation::{self, Form, reading};
use crate::teach::page::Page;
use crate::teach::texts::Texts;
use serde_json::{Value, json};

/// Explains.
///
/// # Errors
/// Errors of the programs, or a file that cannot be written.
pub fn run(args: ExplainArgs) -> Result<(), Complaint> {
    pages::check(&args.page)?;
    let mut program = programs::load(&args.program)?;
    let (page, found) = build(&args, &mut program)?;
    pages::deliver(&page, || found, &args.page)
}

/// The page, and the same as JSON.
///
/// # Errors
/// If there is nothing to explain.
pub fn build(args: &ExplainArgs, program: &mut Program) -> Result<(Page, Value), Complaint> {
    let texts = args.page.texts();
    let chosen = chosen(program, args.of.as_deref())?;
    let framing = framing(program);
    let read = syntax::parse(&program.sources.texts()).program.statements;
    let forms: Vec<Form> = read.iter().map(reading::statement).collect();
    let title = read.first().map_or_else(String::new, |first| shown(program, first));
    let mut page = Page::new(texts.with("explain.title", &[&title]));
    page.heading(texts.get("explain.read"));
    page.blocks
        .push(crate::teach::page::Block::Formulas(forms.iter().map(|form| (form.clone(), String::new())).collect()));
    let mut list = Vec::new();
    for (k, &(f, is_solid)) in chosen.iter().enumerate() {
        if chosen.len() > 1 {
            page.heading(texts.with("explain.surface", &[&(k + 1).to_string(), &chosen.len().to_string()]));
        }
        let graph = &mut program.lowered.graph;
        let explanation = explain(graph, f, is_solid, framing.filter(|_| chosen.len() == 1), &texts);
        if let Some(term) = &explanation.f {
            page.formula(Form::equation(Form::name("f"), Form::of(term)));
        }
        explanation.write(&texts, &mut page);
        list.push(as_json(&explanation, &texts, print::text(graph, f, syntax::MAX_TEXT)));
    }
    let read: Vec<Value> = forms.iter().map(form_as_json).collect();
    Ok((page, json!({ "read": read, "surfaces": list })))
}

/// What is explained: nodes, and whether each is the function of a solid.
fn chosen(program: &Program, of: Option<&str>) -> Result<Vec<(NodeId, bool)>, Complaint> {
    if let Some(name) = of {
        return Ok(vec![(eval::definition(program, name)?, false)]);
    }
    let list: Vec<(NodeId, bool)> =
        program.lowered.surfaces.iter().map(|surface| (surface.f, surface.kind == Kind::Solid)).collect();
    match list.is_empty() {
        true => Err(Complaint::diagnostics(&program.lowered.nothing_to_draw, &program.sources)),
        false => Ok(list),
    }
}

/// The ball around all there is, if the program leaves it to be found.
fn framing(program: &mut Program) -> Option<Framing> {
    let wishes = Wishes { simd: render::simd(), ..Wishes::default() };
    Plan::new(program, &wishes).ok()?.found
}

fn shown(program: &Program, statement: &Statement) -> String {
    let source = program.sources.list.get(statement.span.source.0 as usize);
    let text = source.map_or("", |source| &source.text[statement.span.range()]);
    crate::diag::printable(&text.split_whitespace().collect::<Vec<&str>>().join(" "), 120)
}

fn form_as_json(form: &Form) -> Value {
    json!({
        "text": notation::text::write(form),
        "latex": notation::latex::write(form),
        "mathml": notation::mathml::write(form, false),
    })
}

fn as_json(explanation: &Explanation, texts: &Texts, f: Option<String>) -> Value {
    let facts = &explanation.facts;
    let names = |list: &[crate::expr::op::Variable]| list.iter().map(|v| notation::letter(*v)).collect::<Vec<&str>>();
    let slopes: Vec<Value> = explanation
        .slopes
        .iter()
        .map(|slope| slope.derivation.as_ref().map_or(Value::Null, |d| steps(d, texts)))
        .collect();
    let evaluation = &explanation.evaluation;
    json!({
        "f": f,
        "degree": facts.degree,
        "quadric": facts.quadric.as_ref().map(|quadric| quadric.kind.trim_start_matches("quadric.")),
        "graph_in": facts.graphs.iter().map(|(v, _)| notation::letter(*v)).collect::<Vec<&str>>(),
        "absent": names(&facts.absent),
        "revolution_about": names(&facts.axes),
        "symmetries": facts.symmetries.iter().map(|key| key.trim_start_matches("symmetry.")).collect::<Vec<&str>>(),
        "bounded": facts.is_bounded,
        "facts": explanation.sentences,
        "derivatives": slopes,
        "steps": evaluation.steps,
        "registers": evaluation.registers,
        "gradient_steps": evaluation.gradient_steps,
        "nodes_shared": evaluation.shared,
        "nodes_written_out": evaluation.written_out,
    })
}

fn steps(derivation: &Derivation, texts: &Texts) -> Value {
    let line = |line: &crate::teach::derivation::Line| {
        let mut value = form_as_json(&Form::of(&line.term));
        value["rule"] = json!(line.rule);
        value["rule_text"] = json!(texts.get(line.rule));
        value
    };
    Value::Array(derivation.lines.iter().map(line).collect())
}
