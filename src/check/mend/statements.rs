//! Statements as they are written, and the places for new ones.

use crate::diagnostic::Edit;
use crate::diagram::{Drawing, Kind, Loop, LoopKind, NameId, Ref, Rule, Spoke, Star};
use crate::source::Span;

/// A loop statement as it is written; `None` if some item of it has no name.
pub(super) fn loop_statement(rule: &Rule, orbit: &Loop) -> Option<String> {
    let word = |mention: Ref| &rule.name(mention.name).text;
    let kind = match orbit.kind {
        LoopKind::Face => "face",
        LoopKind::Hole => "hole",
        LoopKind::Any => "loop",
    };
    if orbit.each || orbit.items.iter().any(|item| !rule.name(item.item.name).named) {
        return None;
    }
    let mut drawn = String::new();
    for item in &orbit.items {
        drawn.push_str(&format!("{} {} ", word(item.from), arrow(rule, item.item.name)));
    }
    Some(format!("{kind} {}: {drawn}{}", word(orbit.face), word(orbit.end)))
}

/// An edge statement as it is written.
pub(super) fn edge_statement(rule: &Rule, edge: NameId, halfedges: [NameId; 2]) -> String {
    let [left, right] = halfedges.map(|half| &rule.name(half).text);
    format!("edge {}: {left} | {right}", rule.name(edge).text)
}

/// An item of a loop as it is written.
pub(super) fn arrow(rule: &Rule, item: NameId) -> String {
    let word = &rule.name(item).text;
    match rule.kind(item) {
        Kind::Path => format!("={word}=>"),
        _ => format!("-{word}->"),
    }
}

/// A vertex statement as it is written.
pub(super) fn star_statement(rule: &Rule, star: &Star) -> String {
    let word = |mention: &Ref| &rule.name(mention.name).text;
    let spokes = star.spokes.iter().map(|spoke| match spoke {
        Spoke::Halfedge(half) => word(half).clone(),
        Spoke::Fan(fan) => format!("*{}", word(fan)),
        Spoke::Rest(_) => "*".to_owned(),
    });
    let spokes = spokes.collect::<Vec<_>>().join(" ");
    format!("vertex {}: {spokes}", word(&star.vertex))
}

/// The edit that lists names in `new`, which comes first in `after`.
pub(super) fn list_in_new(rule: &Rule, words: &str) -> Option<Edit> {
    if let Some(last) = rule.created.iter().max_by_key(|created| created.span.end) {
        return Some(Edit { span: last.span.after(), text: format!(" {words}") });
    }
    let side = &rule.after;
    let loops = side.loops.iter().map(|orbit| orbit.span);
    let edges = side.edges.iter().map(|edge| edge.span);
    let stars = side.stars.iter().map(|star| star.span);
    let first = loops.chain(edges).chain(stars).min_by_key(|s| s.start)?;
    if side.kept.iter().any(|kept| kept.span.start <= first.start) {
        // The span of a kept statement is that of its name, behind the word `keep`.
        return Some(Edit { span: end_of_after(rule)?, text: format!("\n    new {words}") });
    }
    Some(Edit { span: first.before(), text: format!("new {words}\n    ") })
}

/// The place where one more statement can be written: behind the last one of `after`.
pub(super) fn end_of_after(rule: &Rule) -> Option<Span> {
    let side = Drawing::new(rule).after.end_of_statements();
    let lists = rule.created.iter().chain(&rule.erased).map(|mention| mention.span.after());
    let stars = rule.after.stars.iter().flat_map(|star| &star.spokes).map(|spoke| match spoke {
        Spoke::Rest(span) => span.after(),
        Spoke::Halfedge(name) | Spoke::Fan(name) => name.span.after(),
    });
    let assignments = rule.assignments.iter().map(|assignment| assignment.span.after());
    let inside = |span: &Span| span.start <= rule.after.span.end;
    side.into_iter()
        .chain(lists)
        .chain(stars)
        .chain(assignments)
        .filter(inside)
        .max_by_key(|span| span.end)
}
