//! New halfedges that would lie in loops that are not drawn, or have their twins there.

use crate::diagram::{Drawing, Kind, NameId};

/// The reason why a new halfedge is in no loop: the halfedge that it would be beside is in none
/// either.
pub(super) fn beside(drawing: &Drawing, new: NameId) -> Option<String> {
    undrawn(drawing, new, drawing.rule.quoted(new))
}

/// The reason why a new halfedge has no twin: the halfedge that the twin would be beside is in no
/// loop.
pub(super) fn twin_beside(drawing: &Drawing, new: NameId) -> Option<String> {
    undrawn(drawing, new, format!("a new twin of {}", drawing.rule.quoted(new)))
}

/// The advice to draw the loop of an outer halfedge near a new one, and in `after` with `what`.
fn undrawn(drawing: &Drawing, new: NameId, what: String) -> Option<String> {
    let rule = drawing.rule;
    let after = |half| [drawing.origin_after(half), drawing.target_after(half)];
    let [from, to] = after(new);
    // An outer halfedge that comes to share an end with it, if possible a new one, else any that
    // stays.
    let outer = rule.names_of(Kind::Halfedge).filter(|&half| {
        drawing.is_outer(half) && drawing.erased(half).is_none() && rule.is_first(half)
    });
    let outer: Vec<_> = outer.collect();
    let shared = |half: &NameId| {
        let [start, end] = after(*half);
        let ends = [(start, to), (end, from)].into_iter();
        ends.filter_map(|(one, other)| one.filter(|_| one == other)).collect::<Vec<_>>()
    };
    let is_new = |vertex: &NameId| drawing.created(*vertex).is_some();
    let at_new = outer.iter().find(|half| shared(half).iter().any(is_new));
    let touching = outer.iter().find(|half| !shared(half).is_empty());
    let &beside = at_new.or(touching).or(outer.first())?;
    let text = rule.quoted(beside);
    let lacks = format!("no loop of `before` holds {text}, so nothing can be put beside it");
    if rule.cycle.is_some() {
        return Some(format!("{lacks}: draw the loops of both its sides there"));
    }
    let word = &rule.name(beside).text;
    let [start, end] = [drawing.origin_before(beside), drawing.target_before(beside)];
    let ends = start.zip(end).map(|ends| [ends.0, ends.1]);
    let [start, end] = match ends {
        Some(ends) => ends.map(|end| rule.name(end).text.clone()),
        None => ["v0".to_owned(), "v1".to_owned()],
    };
    Some(format!(
        "{lacks}: draw its loop there, `loop o: {start} -{word}-> {end} =O=> {start}`, and in `after` with {what}"
    ))
}
