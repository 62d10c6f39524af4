//! Law 3: `next` stays a permutation.
//!
//! Each loop item that survives and each new halfedge occurs exactly once in the loops of `after`.
//! (That none is missing is law 2.) An outer halfedge may not enter a loop: its own `next` is not
//! in the drawing, so what preceded and followed it would be left behind.

use super::problem::Problem;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId, Side};
use crate::source::Span;

/// Tests the law.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let rule = drawing.rule;
    let mut problems = Vec::new();
    twice(drawing, &rule.before, &mut |name, first, second| {
        let text = rule.quoted(name);
        let message = format!("no mesh matches: {text} stands twice in the loops of `before`");
        problems.push(
            Diagnostic::error("impossible-drawing", message, second)
                .saying("here again")
                .label(first, "here")
                .note(format!("{text} has one `next`, so it stands in one place of one loop"))
                .into(),
        );
    });
    twice(drawing, &rule.after, &mut |name, first, second| {
        let text = rule.quoted(name);
        let message = format!("{text} stands twice in the loops of `after`");
        let note = match rule.kind(name) {
            Kind::Path => {
                format!("{text} is one run of halfedges; it lies in one place of one loop")
            }
            _ => format!(
                "`{0}.next` can have one value: {text} stands in one place of one loop",
                rule.name(name).text
            ),
        };
        let problem = Diagnostic::error("next-twice", message, second)
            .saying("here again")
            .label(first, "here");
        problems.push(problem.note(note).into());
    });
    for orbit in &rule.after.loops {
        for item in &orbit.items {
            let name = item.item.name;
            if drawing.is_outer(name) {
                let text = rule.quoted(name);
                let word = &rule.name(name).text;
                let message = format!("the outer halfedge {text} enters a loop");
                let before =
                    drawing.before.mention(name).expect("an outer halfedge is drawn before");
                let problem = Diagnostic::error("outer-in-loop", message, item.item.span)
                    .saying(format!("this would set `{word}.next`"))
                    .label(before, format!("`before` draws {text} only as a twin, in no loop"))
                    .note(format!("whatever follows and precedes {text} outside of the drawing would be left behind: draw its loop in `before`"));
                problems.push(problem.into());
            }
        }
    }
    problems
}

/// Calls back for each loop item that occurs more than once on a side.
fn twice(drawing: &Drawing, side: &Side, tell: &mut impl FnMut(NameId, Span, Span)) {
    let mut first = vec![None; drawing.rule.names.len()];
    for item in side.loops.iter().flat_map(|orbit| &orbit.items) {
        let name = item.item.name;
        match first[name.index()] {
            Some(span) => tell(name, span, item.item.span),
            None => first[name.index()] = Some(item.item.span),
        }
    }
}
