//! Start of matching: a parameter that `before` draws.
//!
//! It is tested before the laws: where the parameter is missing in the drawing, much else is
//! missing with it, and would be reported instead.

use super::problem::{Problem, keyword};
use crate::diagnostic::{Diagnostic, Edit, Fix, all_of};
use crate::diagram::{Drawing, Kind, NameId, Op, Type};

/// Reports that no parameter is drawn, if anything is.
pub(super) fn test(op: &Op, drawing: &Drawing) -> Vec<Problem> {
    let rule = drawing.rule;
    let drawn = |name: &NameId| drawing.before.mention(*name).is_some();
    let before = &rule.before;
    let is_empty = before.loops.is_empty() && before.edges.is_empty() && before.stars.is_empty();
    if is_empty || rule.params.iter().flatten().any(drawn) {
        return Vec::new();
    }
    let elements: Vec<_> = op.params.iter().filter(|param| param.ty.is_element()).collect();
    let [first, ..] = elements.as_slice() else {
        let message = format!("`{}` has no parameter from which matching starts", op.name);
        let problem = Diagnostic::error("unreachable-name", message, op.name_span)
            .note("matching follows pointers from an element that it is given, and never searches")
            .note(format!("name one that `before` draws: `op {}(e: edge)`", op.name));
        return vec![problem.into()];
    };
    let words = all_of(elements.iter().map(|param| format!("`{}`", param.name)));
    let (parameter, it) = match elements.len() {
        1 => ("the parameter", "it"),
        _ => ("any of the parameters", "one"),
    };
    let message = format!("`before` does not draw {parameter} {words}");
    let mut problem = Diagnostic::error("unreachable-name", message, first.span)
        .saying("matching starts here")
        .label(keyword(&drawing.rule.before, "before"), "drawn nowhere here");
    let edge = |edge: &str, [one, two]: [NameId; 2]| {
        let [one, two] = [one, two].map(|half| &rule.name(half).text);
        format!("edge {edge}: {one} | {two}")
    };
    match (first.ty, opposite(drawing).as_slice()) {
        (Type::Edge, &[pair]) => {
            let statement = edge(&first.name, pair);
            problem = problem.note(format!("an edge statement draws {it}: `{statement}`"));
            let end = drawing.before.end_of_statements();
            problem.fixes.extend(end.map(|span| Fix {
                title: format!("insert `{statement}`"),
                edits: vec![Edit { span, text: format!("\n    {statement}") }],
            }));
        }
        (ty, _) => problem = problem.note(format!("draw {it}: `{}`", example(&first.name, ty))),
    }
    vec![problem.into()]
}

/// The note about the first element parameter that `before` does not draw.
pub(super) fn undrawn(op: &Op, drawing: &Drawing) -> Option<String> {
    let drawn = |name: &Option<NameId>| name.is_some_and(|n| drawing.before.mention(n).is_some());
    let params = op.params.iter().zip(&drawing.rule.params);
    let undrawn = params.filter(|(param, name)| param.ty.is_element() && !drawn(name));
    let (param, _) = undrawn.into_iter().next()?;
    Some(format!(
        "`before` does not draw the parameter `{0}`: `{1}`",
        param.name,
        example(&param.name, param.ty)
    ))
}

/// A statement that draws a parameter.
pub(super) fn example(word: &str, ty: Type) -> String {
    match ty {
        Type::Edge => format!("edge {word}: a | b"),
        Type::Vertex => format!("vertex {word}: a *S"),
        Type::Halfedge => format!("face f: v0 -{word}-> v1 =P=> v0"),
        _ => format!("face {word}: v0 -a-> v1 =P=> v0"),
    }
}

/// The pairs of halfedges without an edge statement that run between the same vertices, in
/// opposite directions.
fn opposite(drawing: &Drawing) -> Vec<[NameId; 2]> {
    let view = &drawing.before;
    let halves = drawing.rule.names_of(Kind::Halfedge);
    let open: Vec<_> = halves
        .filter(|&half| view.pairing(half).is_none())
        .filter_map(|half| Some((half, view.loop_ends(half)?)))
        .collect();
    let mut pairs = Vec::new();
    for (at, one) in open.iter().enumerate() {
        let others = open[at + 1..].iter();
        let fitting = others.filter(|other| other.1 == [one.1[1], one.1[0]]);
        pairs.extend(fitting.map(|other| [one.0, other.0]));
    }
    pairs
}
