//! Names of `new` that `after` draws nowhere, and the edges that are missing there.
//!
//! An edge is listed, its halfedges are drawn in their loops, and the statement that pairs
//! them is forgotten: then two halfedges lack a twin that run between the same vertices, in
//! opposite directions.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Kind, NameId, Ref, Role, Side};
use crate::source::Span;
use crate::syntax::tree;

use super::names::Names;
use super::report::Report;

/// Reports names of `new` that stand nowhere else.
pub(super) fn report_unused(
    unused: &[&tree::Name],
    created: &[Ref],
    after: &Side,
    names: &Names,
    report: &mut Report,
) {
    let open = Open::find(created, after, names);
    let pairs = pairs(&open, names);
    let is_family = |pair: &Pair| names.get(pair.halfedges[0].name).role == Role::Family;
    let all_fit = pairs.len() == unused.len()
        && pairs
            .iter()
            .zip(unused)
            .all(|(pair, name)| is_family(pair) == name.index.is_some());
    for (at, name) in unused.iter().enumerate() {
        let message = format!(
            "`{}` is listed in `new` but stands nowhere in `after`",
            name.ident.text
        );
        let mut error = Diagnostic::error("unused-new", message, name.span);
        if let Some(pair) = pairs.get(at).filter(|_| all_fit) {
            let [one, two] = pair.halfedges.map(|half| written(half, names));
            error = error
                .saying("drawn nowhere")
                .label(pair.halfedges[0].span, "in no edge statement")
                .label(pair.halfedges[1].span, "nor this");
            let statement = format!("edge {name}: {one} | {two}");
            if let Some(place) = end_of_orbits(after) {
                let title = format!("insert `{statement}`");
                error = error.fix(title, place, format!("\n    {statement}"));
            }
        }
        report.add(match name.ident.text.as_str() {
            "halfedge" => error.note("`new` lists names alone: what is drawn tells their kinds"),
            _ => error,
        });
    }
}

/// A halfedge that stands in a loop of `after` and in no edge statement. Shifts of its ends
/// are relative to its own.
struct Open {
    half: Ref,
    from: Ref,
    to: Ref,
}

/// Two halfedges that are probably twins.
struct Pair {
    halfedges: [Ref; 2],
}

impl Open {
    fn find(created: &[Ref], after: &Side, names: &Names) -> Vec<Self> {
        let mut found = Vec::new();
        for orbit in &after.loops {
            for (at, item) in orbit.items.iter().enumerate() {
                let half = item.item;
                let is_new = created.iter().any(|created| created.name == half.name);
                if !is_new || names.get(half.name).kind != Kind::Halfedge {
                    continue;
                }
                let mut edges = after.edges.iter().flat_map(|edge| edge.halfedges);
                if edges.any(|paired| paired.name == half.name) {
                    continue;
                }
                let to = match orbit.items.get(at + 1) {
                    Some(next) => next.from,
                    // Behind a period the next one begins.
                    None if orbit.each => shifted(orbit.end, 1),
                    None => orbit.end,
                };
                found.push(Self {
                    half: Ref { shift: 0, ..half },
                    from: shifted(item.from, -half.shift),
                    to: shifted(to, -half.shift),
                });
            }
        }
        found
    }
}

fn shifted(mention: Ref, by: i32) -> Ref {
    Ref {
        shift: mention.shift.saturating_add(by),
        ..mention
    }
}

/// The pairs of halfedges that run in opposite directions, if each fits just one other.
fn pairs(open: &[Open], names: &Names) -> Vec<Pair> {
    let mut pairs = Vec::new();
    for (at, one) in open.iter().enumerate() {
        let others = (0..open.len()).filter(|&other| other != at);
        let mut fitting = others.filter_map(|other| Some((other, turn(one, &open[other], names)?)));
        let (Some((other, by)), None) = (fitting.next(), fitting.next()) else {
            return Vec::new();
        };
        if at < other {
            let two = shifted(open[other].half, by);
            pairs.push(Pair {
                halfedges: [one.half, two],
            });
        }
    }
    pairs
}

/// What has to be added to the subscript of `two` so that it runs from where `one` ends to
/// where it starts; nothing if it does not.
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

/// A name as it is written.
fn written(half: Ref, names: &Names) -> String {
    let name = &names.get(half.name);
    match (name.role, half.shift) {
        (Role::Single, _) => name.text.clone(),
        (_, 0) => format!("{}[{}]", name.text, names.letter().unwrap_or("i")),
        (_, by) => format!("{}[{}{by:+}]", name.text, names.letter().unwrap_or("i")),
    }
}

/// Where one more statement can be written: behind the last one.
fn end_of_orbits(after: &Side) -> Option<Span> {
    let loops = after.loops.iter().map(|orbit| orbit.span);
    let edges = after.edges.iter().map(|edge| edge.span);
    let last = loops.chain(edges).max_by_key(|span| span.end)?;
    Some(last.after())
}
