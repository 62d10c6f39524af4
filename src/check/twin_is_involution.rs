//! Law 4: `twin` stays a pairing without fixed points.
//!
//! The halfedges paired in `after` are the survivors of those paired in `before`, and the
//! new ones; each once, none with itself. (That none is missing is law 2.)

use super::problem::Problem;
use super::repairs::draw_edge_of;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Side};

/// Tests the law.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let mut problems = Vec::new();
    sides_are_pairings(drawing, &drawing.rule.before, "before", &mut problems);
    sides_are_pairings(drawing, &drawing.rule.after, "after", &mut problems);
    undrawn_twins(drawing, &mut problems);
    problems
}

fn sides_are_pairings(drawing: &Drawing, side: &Side, word: &str, problems: &mut Vec<Problem>) {
    let rule = drawing.rule;
    let mut first = vec![None; rule.names.len()];
    for edge in &side.edges {
        let [left, right] = edge.halfedges;
        if left.name == right.name {
            let text = rule.quoted(left.name);
            let message = format!("{text} is paired with itself in `{word}`");
            let problem = Diagnostic::error("twin-of-itself", message, right.span)
                .label(left.span, "")
                .note("an edge is a pair of two halfedges, one along each side");
            problems.push(problem.into());
            continue;
        }
        for half in edge.halfedges {
            let text = rule.quoted(half.name);
            if let Some(span) = first[half.name.index()] {
                let message = format!("{text} stands in two edges of `{word}`");
                let problem = Diagnostic::error("twin-twice", message, half.span)
                    .saying("here again")
                    .label(span, "here")
                    .note(format!("`{}.twin` can have one value", rule.name(half.name).text));
                problems.push(problem.into());
            } else {
                first[half.name.index()] = Some(half.span);
            }
        }
    }
}

/// Reports halfedges that get a twin though the one they have is not drawn.
fn undrawn_twins(drawing: &Drawing, problems: &mut Vec<Problem>) {
    let rule = drawing.rule;
    for half in rule.after.edges.iter().flat_map(|edge| edge.halfedges) {
        let drawn = drawing.before.mention(half.name);
        let Some(before) = drawn.filter(|_| drawing.before.pairing(half.name).is_none()) else {
            continue;
        };
        let text = rule.quoted(half.name);
        let message = format!("{text} gets a twin, but the twin it has is not drawn in `before`");
        let word = &rule.name(half.name).text;
        let problem = Diagnostic::error("twin-not-drawn", message, half.span)
            .saying(format!("this would set `{word}.twin`"))
            .label(before, format!("no edge statement of `before` names {text}"))
            .note(draw_edge_of(drawing, half.name));
        problems.push(problem.into());
    }
}
