//! Names in `new` that `after` does not draw, and edge statements that are missing.
//!
//! A common mistake: an edge is listed and its halfedges are drawn in their loops, but the
//! statement that pairs them is forgotten. Then two halfedges without a twin run between the same
//! vertices in opposite directions.

use crate::diagnostic::{Diagnostic, all_of};
use crate::diagram::{Kind, NameId, Ref, Role, Side};
use crate::source::Span;
use crate::syntax::tree::{self, Statement};

use super::names::Names;
use super::report::Report;

/// Names in `new` that occur nowhere else, and the side that lists them.
pub(super) struct Unused<'a> {
    pub(super) listed: Vec<&'a tree::Name>,
    /// The other names in `new`.
    pub(super) created: &'a [Ref],
    /// The side as written.
    pub(super) written: &'a tree::Side,
    /// The elements that `before` and `after` draw.
    pub(super) drawn: [&'a Side; 2],
}

impl Unused<'_> {
    /// Reports each name with the missing edge statement, if it is unambiguous, or else all together.
    pub(super) fn report(&self, names: &Names, report: &mut Report) {
        let is_new = |half: NameId| self.created.iter().any(|created| created.name == half);
        let open = self.open(names, &is_new);
        let twice = twice(&open);
        let is_family = |pair: &Pair| names.get(pair.halfedges[0].name).role == Role::Family;
        let fit = |pairs: &Vec<Pair>| {
            let mut both = pairs.iter().zip(&self.listed);
            pairs.len() == self.listed.len()
                && both.all(|(pair, name)| is_family(pair) == name.index.is_some())
        };
        let of_new = || pairs(&open, names);
        // A new edge may have one of the halfedges of an old one.
        let of_all =
            || pairs(&self.open(names, &|half| is_new(half) || self.is_freed(half, names)), names);
        let pairs = match twice {
            Some(_) => None,
            None => Some(of_new()).filter(fit).or_else(|| Some(of_all()).filter(fit)),
        };
        let mut others: Vec<&tree::Name> = Vec::new();
        for (at, name) in self.listed.iter().enumerate() {
            let word = &name.ident.text;
            let mut error = unused(&format!("`{word}`"), 1, name.span);
            if self.is_placed(word) {
                error = error.note(format!(
                    "its `position` is set, so it is a vertex: draw it in a loop, or list its spokes, `vertex {name}: h *S`"
                ));
            } else if word == "halfedge" {
                error = error.note("`new` lists names alone: what is drawn tells their kinds");
            } else if let Some([first, second]) = twice.filter(|_| at == 0) {
                error = drawn_twice(error, first, second, names);
            } else if let Some(pair) = pairs.as_ref().and_then(|pairs| pairs.get(at)) {
                error = self.missing_edge(error, name, pair, names);
            } else {
                others.push(name);
                continue;
            }
            report.add(error);
        }
        let Some((first, more)) = others.split_first() else { return };
        let words = all_of(others.iter().map(|name| format!("`{}`", name.ident.text)));
        let error = unused(&words, others.len(), first.span);
        report.add(more.iter().fold(error, |error, name| error.label(name.span, "here, too")));
    }

    /// The halfedges in loops of `after`, but in no edge statement, that are new or freed.
    fn open(&self, names: &Names, is_free: &dyn Fn(NameId) -> bool) -> Vec<Open> {
        let after = self.drawn[1];
        let mut found = Vec::new();
        for orbit in &after.loops {
            for (at, item) in orbit.items.iter().enumerate() {
                let half = item.item;
                if !is_free(half.name) || names.get(half.name).kind != Kind::Halfedge {
                    continue;
                }
                let mut edges = after.edges.iter().flat_map(|edge| edge.halfedges);
                if edges.any(|paired| paired.name == half.name) {
                    continue;
                }
                let to = match orbit.items.get(at + 1) {
                    Some(next) => next.from,
                    // After a period the next one begins.
                    None if orbit.each => shifted(orbit.end, 1),
                    None => orbit.end,
                };
                found.push(Open {
                    half: Ref { shift: 0, ..half },
                    from: shifted(item.from, -half.shift),
                    to: shifted(to, -half.shift),
                });
            }
        }
        found
    }

    /// True if an edge of `before` that `after` does not keep has a halfedge.
    fn is_freed(&self, half: NameId, names: &Names) -> bool {
        let mut edges = self.drawn[0].edges.iter();
        let edge = edges.find(|edge| edge.halfedges.iter().any(|paired| paired.name == half));
        let is_kept = |edge: NameId| {
            self.written.statements.iter().any(|statement| match statement {
                Statement::Keep(listed, _) => {
                    listed.iter().any(|name| names.find(&name.ident.text) == Some(edge))
                }
                _ => false,
            })
        };
        edge.is_some_and(|edge| !is_kept(edge.edge.name))
    }

    /// True if a name is given a position.
    fn is_placed(&self, word: &str) -> bool {
        let mut statements = self.written.statements.iter();
        statements.any(|statement| {
            matches!(statement, Statement::Assign { target, attribute, .. }
                if target.ident.text == word && attribute.text == "position")
        })
    }

    fn missing_edge(
        &self,
        error: Diagnostic,
        name: &tree::Name,
        pair: &Pair,
        names: &Names,
    ) -> Diagnostic {
        let [one, two] = pair.halfedges.map(|half| written(half, names));
        let error = error
            .saying("drawn nowhere")
            .label(pair.halfedges[0].span, "in no edge statement")
            .label(pair.halfedges[1].span, "nor this");
        let statement = format!("edge {name}: {one} | {two}");
        let title = format!("insert `{statement}`");
        error.with(end_of_orbits(self.drawn[1]), |error, place| {
            error.fix(title, place, format!("\n    {statement}"))
        })
    }
}

/// A halfedge in a loop of `after` and in no edge statement. The shifts of its ends are
/// relative to its own.
struct Open {
    half: Ref,
    from: Ref,
    to: Ref,
}

/// Two halfedges that are probably twins.
struct Pair {
    halfedges: [Ref; 2],
}

/// Two places of one halfedge.
fn twice(open: &[Open]) -> Option<[Ref; 2]> {
    let mut places = open.iter().enumerate();
    places.find_map(|(at, one)| {
        let again = open[at + 1..].iter().find(|other| other.half.name == one.half.name)?;
        Some([one.half, again.half])
    })
}

/// The advice for a halfedge that is drawn on both sides of its edge.
fn drawn_twice(error: Diagnostic, first: Ref, second: Ref, names: &Names) -> Diagnostic {
    let word = written(first, names);
    error.label(first.span, "drawn here").label(second.span, "and here again").note(format!(
        "`{word}` stands in two places, and an edge has two halfedges, one along each side: \
             draw another one in one of them, list it in `new`, and pair the two"
    ))
}

fn shifted(mention: Ref, by: i32) -> Ref {
    Ref { shift: mention.shift.saturating_add(by), ..mention }
}

/// The pairs of halfedges that run in opposite directions, if each fits exactly one other.
fn pairs(open: &[Open], names: &Names) -> Vec<Pair> {
    let mut pairs = Vec::new();
    for (at, one) in open.iter().enumerate() {
        let others = (0..open.len()).filter(|&other| other != at);
        let mut fitting = others.filter_map(|other| Some((other, turn(one, &open[other], names)?)));
        let (Some((other, by)), None) = (fitting.next(), fitting.next()) else { return Vec::new() };
        if at < other {
            let two = shifted(open[other].half, by);
            pairs.push(Pair { halfedges: [one.half, two] });
        }
    }
    pairs
}

/// The shift to add to the subscript of `two` so that it runs from the end of `one` to its start;
/// `None` if it does not.
fn turn(one: &Open, two: &Open, names: &Names) -> Option<i32> {
    let is_family = |name: NameId| names.get(name).role == Role::Family;
    let mut by = None;
    for (end, start) in [(one.to, two.from), (one.from, two.to)] {
        if end.name != start.name {
            return None;
        }
        if is_family(end.name) {
            let wanted = end.shift - start.shift;
            if by.is_some_and(|by| by != wanted) {
                return None;
            }
            by = Some(wanted);
        }
    }
    match is_family(one.half.name) == is_family(two.half.name) {
        true if is_family(one.half.name) => Some(by.unwrap_or(0)),
        true => Some(0),
        false => None,
    }
}

/// A name with its subscript, as written.
fn written(half: Ref, names: &Names) -> String {
    let name = &names.get(half.name);
    match (name.role, half.shift) {
        (Role::Single, _) => name.text.clone(),
        (_, 0) => format!("{}[{}]", name.text, names.letter().unwrap_or("i")),
        (_, by) => format!("{}[{}{by:+}]", name.text, names.letter().unwrap_or("i")),
    }
}

/// The place to insert another statement: after the last one.
fn end_of_orbits(after: &Side) -> Option<Span> {
    let loops = after.loops.iter().map(|orbit| orbit.span);
    let edges = after.edges.iter().map(|edge| edge.span);
    let last = loops.chain(edges).max_by_key(|span| span.end)?;
    Some(last.after())
}

/// The error for a number of names that are listed and not drawn.
fn unused(words: &str, count: usize, span: Span) -> Diagnostic {
    let [are, stand] = if count == 1 { ["is", "stands"] } else { ["are", "stand"] };
    let message = format!("{words} {are} listed in `new` but {stand} nowhere in `after`");
    Diagnostic::error("unused-new", message, span)
}
