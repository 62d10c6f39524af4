//! Walks along paths and over fans, and what they set: the face along a path that changes its
//! loop, the vertex around a fan that changes its vertex. While a walk runs, nothing that it follows
//! is written.

use super::names::Names;
use super::routine::{Block, Statement};
use super::value::{Precedence, Term};
use crate::diagram::{Drawing, NameId, Pointer, Spoke, Type};

/// The walk along a path, from its first halfedge up to the item after it in `before`, that sets
/// its face.
pub(super) fn path_walk(drawing: &Drawing, names: &mut Names, path: NameId) -> Option<Statement> {
    let face = drawing.after.face(path)?;
    let next = drawing.before.item_after(path)?;
    let (first, language) = (names.term(path), names.language);
    let sets = (Pointer::Face, face);
    if next == path {
        let face = language.follow(Pointer::Face, &first);
        return Some(over(names, sets, [("LoopFrom", first), ("FaceHalfedges", face)]));
    }
    let until = names.term(next);
    Some(up_to(names, sets, &[Pointer::Next], [first, until]))
}

/// The walk over the spokes of a fan, clockwise, from after the spoke that follows it up to the
/// spoke that precedes it, that sets their vertex.
pub(super) fn fan_walk(drawing: &Drawing, names: &mut Names, fan: NameId) -> Option<Statement> {
    let after = drawing.after.star_of_spoke(fan)?;
    let vertex = drawing.before.star_of_spoke(fan)?;
    let spokes = &drawing.before.star(vertex)?.spokes;
    let is_fan = |spoke: &Spoke| matches!(spoke, Spoke::Fan(name) if name.name == fan);
    let at = spokes.iter().position(is_fan)?;
    let half = |at: usize| spokes[at % spokes.len()].halfedge();
    let (sets, language) = ((Pointer::Vertex, after), names.language);
    let (Some(previous), Some(following)) = (half(at + spokes.len() - 1), half(at + 1)) else {
        // The fan is the whole star.
        let vertex = names.term(vertex);
        let first = language.follow(Pointer::VertexHalfedge, &vertex);
        return Some(over(names, sets, [("SpokesFrom", first), ("VertexHalfedges", vertex)]));
    };
    let twin = match drawing.before.twin(following) {
        Some(twin) => names.term(twin),
        None => language.follow(Pointer::Twin, &names.term(following)),
    };
    let ends = [language.follow(Pointer::Next, &twin), names.term(previous)];
    // Clockwise, which needs no `prev`.
    Some(up_to(names, sets, &[Pointer::Twin, Pointer::Next], ends))
}

/// The name of the halfedge of a walk, and the statement that sets a pointer of it.
fn setting(names: &mut Names, (pointer, value): (Pointer, NameId)) -> (String, Vec<Statement>) {
    let halfedge = names.fresh("h");
    names.taken.remove(&halfedge);
    let set = Statement::set(pointer, Term::name(&halfedge), names.term(value));
    (halfedge, vec![set])
}

/// A walk over all halfedges of an orbit, by a call in Rust and one in C++.
fn over(names: &mut Names, sets: (Pointer, NameId), calls: [(&str, Term); 2]) -> Statement {
    let (h, body) = setting(names, sets);
    let (call, of) = &calls[usize::from(!names.language.is_rust())];
    let all = names.language.call(call, [of]);
    Statement::block(names.language.over(Type::Halfedge, &h, &all), body)
}

/// A walk from a halfedge up to another.
fn up_to(
    names: &mut Names,
    sets: (Pointer, NameId),
    step: &[Pointer],
    [from, until]: [Term; 2],
) -> Statement {
    let (h, body) = setting(names, sets);
    let language = names.language;
    let next = step.iter().fold(Term::name(&h), |at, pointer| language.follow(*pointer, &at));
    let (ty, first, next) = (language.ty(Type::Halfedge), &from.text, &next.text);
    let end = &until.text;
    let head = say!(
        language,
        "while {h} != {end}",
        "for ({ty} {h} = {first}; {h} != {end}; {h} = {next})"
    );
    let head = Term::of(head, Precedence::Choice, [&from, &until]);
    let (first, last) = match language.is_rust() {
        true => (format!("let mut {h} = {first};"), format!("{h} = {next};")),
        false => Default::default(),
    };
    Statement::Block(Block { first, head, body, last, ..Block::default() })
}
