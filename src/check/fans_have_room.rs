//! Room for fans: a fan of `before` lies where a spoke can be.
//!
//! The loops draw some spokes as neighbors. A fan that is listed between two of these is empty
//! on every mesh: the op is sound, but applies almost nowhere, and so is not what was meant.

use super::problem::Problem;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, NameId, Spoke};

/// Reports each fan without room.
pub(super) fn test(drawing: &Drawing) -> Vec<Problem> {
    let rule = drawing.rule;
    let mut problems = Vec::new();
    for star in &rule.before.stars {
        let count = star.spokes.len();
        for (at, &spoke) in star.spokes.iter().enumerate() {
            let (text, span) = match spoke {
                Spoke::Halfedge(_) => continue,
                Spoke::Fan(fan) => (rule.quoted(fan.name), fan.span),
                Spoke::Rest(span) => ("this fan".to_owned(), span),
            };
            let neighbors = [at + count - 1, at + 1].map(|at| star.spokes[at % count]);
            let Some(pair) = drawn_as_neighbors(drawing, neighbors) else { continue };
            let [first, second] = pair.map(|spoke| rule.quoted(spoke));
            let message =
                format!("{text} is always empty: in the loops {second} comes right behind {first}");
            let told = Diagnostic::error("empty-fan", message, span)
                .saying("no spoke can lie here")
                .note("list the fan where there is room between two spokes, counterclockwise");
            problems.push(told.into());
        }
    }
    problems
}

/// Two spokes that the loops draw side by side, the second right behind the first counterclockwise;
/// one of them is a neighbor of the fan.
fn drawn_as_neighbors(drawing: &Drawing, [left, right]: [Spoke; 2]) -> Option<[NameId; 2]> {
    let view = &drawing.before;
    let clockwise = |spoke: NameId| {
        view.spoke_ahead(spoke).filter(|&next| drawing.rule.kind(next) == Kind::Halfedge)
    };
    let behind = left.halfedge().and_then(|left| Some([left, view.spoke_behind(left)?]));
    behind.or_else(|| right.halfedge().and_then(|right| Some([clockwise(right)?, right])))
}
