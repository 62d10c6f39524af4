//! Law 8: what is new is placed.
//!
//! A new element receives every attribute that has no default: a new vertex its `position`.

use super::problem::Problem;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Access, Drawing, Kind};

/// Tests the law.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let rule = drawing.rule;
    let mut problems = Vec::new();
    for created in rule
        .created
        .iter()
        .filter(|created| rule.kind(created.name) == Kind::Vertex)
    {
        let placed = rule.assignments.iter().any(|assignment| {
            assignment.target.name == created.name && assignment.attribute == Access::Position
        });
        if !placed {
            let text = rule.quoted(created.name);
            let word = &rule.name(created.name).text;
            let message = format!("the new vertex {text} has no position");
            let problem = Diagnostic::error("missing-attribute", message, created.span)
                .saying("created here")
                .note(format!("set it in `after`: `{word}.position = …`"));
            problems.push(problem.into());
        }
    }
    problems
}
