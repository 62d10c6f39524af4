//! Law 5: nothing outside dangles.
//!
//! Whatever points at an erased element must be drawn: an erased halfedge has its loop and its edge
//! in `before`, an erased edge its two halfedges, an erased face its whole loop. That an erased
//! vertex has its whole star drawn, or moved in fans, is part of law 7.

use super::problem::{Problem, enumerate};
use super::repairs::{draw_edge_of, draw_edges_of};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId};
use crate::source::Span;

/// Tests the law.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let rule = drawing.rule;
    let view = &drawing.before;
    let mut problems = Vec::new();
    let mut alone = Vec::new();
    for erased in &rule.erased {
        let name = erased.name;
        let Some(drawn) = view.mention(name) else { continue };
        let text = rule.quoted(name);
        let mut dangles = |what: String, note: String| {
            let message = format!("{text} is erased, but {what}");
            let problem = Diagnostic::error("dangling-outside", message, erased.span)
                .saying("erased here")
                .label(drawn, "drawn here");
            problems.push(problem.note(note).into());
        };
        match rule.kind(name) {
            Kind::Halfedge => {
                if view.loop_of_item(name).is_none() {
                    dangles(
                        "its loop is not drawn".into(),
                        format!(
                            "whatever precedes {text} outside of the drawing would still have {text} as its `next`"
                        ),
                    );
                } else if view.pairing(name).is_none() {
                    alone.push((erased.span, drawn, name));
                }
            }
            Kind::Edge if view.edge_statement(name).is_none() => dangles(
                "its two halfedges are not drawn".into(),
                format!("they would still say that their edge is {text}"),
            ),
            Kind::Face if view.loop_of_face(name).is_none() => dangles(
                "its loop is not drawn".into(),
                format!("its halfedges would still say that their face is {text}"),
            ),
            _ => {}
        }
    }
    problems.extend(without_twins(drawing, &alone));
    problems
}

/// The problem of erased halfedges whose twins are not drawn, each with the places where it is
/// erased and drawn.
fn without_twins(drawing: &Drawing, alone: &[(Span, Span, NameId)]) -> Option<Problem> {
    let rule = drawing.rule;
    let &(erased, drawn, first) = alone.first()?;
    let halves: Vec<_> = alone.iter().map(|(_, _, half)| *half).collect();
    let halves: Vec<_> = halves.into_iter().filter(|&half| rule.is_first(half)).collect();
    let (text, several) = (enumerate(rule, &halves), halves.len() > 1);
    let message = match several {
        true => format!("{text} are erased, but their twins are not drawn"),
        false => format!("{text} is erased, but its twin is not drawn"),
    };
    let mut diagnostic = Diagnostic::error("dangling-outside", message, erased)
        .saying("erased here")
        .label(drawn, "drawn here");
    for span in alone[1..].iter().flat_map(|(erased, drawn, _)| [*drawn, *erased]) {
        if diagnostic.labels.iter().all(|label| label.span != span) {
            diagnostic = diagnostic.label(span, "");
        }
    }
    diagnostic = match several {
        true => diagnostic.note(draw_edges_of(drawing, &halves)),
        false => diagnostic.note(draw_edge_of(drawing, first)),
    };
    Some(diagnostic.into())
}
