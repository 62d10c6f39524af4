//! Law 5: nothing outside dangles.
//!
//! Whatever points at an erased element must be drawn: an erased halfedge has its loop and its edge
//! in `before`, an erased edge its two halfedges, an erased face its whole loop. That an erased
//! vertex has its whole star drawn, or moved in fans, is part of law 7.

use super::problem::Problem;
use super::remedies::draw_edge_of;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind};

/// Tests the law.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let rule = drawing.rule;
    let view = &drawing.before;
    let mut problems = Vec::new();
    for erased in &rule.erased {
        let name = erased.name;
        let Some(drawn) = view.mention(name) else {
            continue;
        };
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
                    dangles("its twin is not drawn".into(), draw_edge_of(drawing, name));
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
    problems
}
