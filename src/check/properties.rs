//! What a proved rule keeps besides validity, and how degrees and sizes change.
//!
//! Properties are inferred for every rule; what `keeps` declares must be among them. Each is
//! read off the drawing: that every face stays a triangle, given that all were, is a count of
//! halfedges, in which the length of a path follows from the loop it comes from.

use super::facts::Change;
use super::keeps;
use super::problem::{Problem, join};
use crate::diagnostic::Diagnostic;
use crate::diagram::{Drawing, Kind, Loop, LoopKind, NameId, Op, Property};

/// The change of a degree or a size: a constant, and the runs that come and go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SizeChange {
    /// The vertex, or the face.
    pub element: String,
    /// What the drawn halfedges make of it.
    pub constant: i64,
    /// The fans or paths that come.
    pub gains: Vec<String>,
    /// The fans or paths that go.
    pub loses: Vec<String>,
}

impl SizeChange {
    /// Whether it stays what it is.
    pub fn is_nothing(&self) -> bool {
        self.constant == 0 && self.gains.is_empty() && self.loses.is_empty()
    }
}

/// Everything that the rule keeps, given what its time grows with.
pub(super) fn kept(drawing: &Drawing, change: Change, grows_with: &[String]) -> Vec<Property> {
    let keeps = |property: &Property| match property {
        Property::Triangles => keeps_size(drawing, 3),
        Property::Quads => keeps_size(drawing, 4),
        Property::Euler => change.euler() == 0,
        Property::Boundary => keeps_boundary(drawing),
        Property::ConstantTime => grows_with.is_empty(),
        Property::Level(level) => keeps::left_to_test(drawing, *level).is_empty(),
    };
    Property::ALL.into_iter().filter(keeps).collect()
}

/// What `keeps` declares and the rule does not keep.
pub(super) fn broken_claims(
    op: &Op,
    drawing: &Drawing,
    kept: &[Property],
    change: Change,
    grows_with: &[String],
) -> Vec<Problem> {
    let broken = op
        .keeps
        .iter()
        .filter(|(property, _)| !kept.contains(property));
    broken
        .map(|&(property, span)| {
            let word = property.word();
            let rule = drawing.rule.label.as_ref();
            let who = rule.map_or_else(
                || format!("`{}`", op.name),
                |rule| format!("the rule `{rule}`"),
            );
            let message = format!("{who} does not keep `{word}`");
            let diagnostic = Diagnostic::error("property-not-kept", message, span);
            let why = match property {
                Property::Level(level) => {
                    return keeps::not_kept(drawing, diagnostic, level).into();
                }
                Property::Triangles => wrong_size(drawing, 3),
                Property::Quads => wrong_size(drawing, 4),
                Property::Euler => Some(format!("V - E + F changes by {:+}", change.euler())),
                Property::Boundary => {
                    Some("a hole may lose or gain vertices, or come or go".into())
                }
                Property::ConstantTime => Some(format!(
                    "its time grows with {}",
                    join(grows_with.iter().cloned())
                )),
            };
            match why {
                Some(why) => diagnostic.note(why).into(),
                None => diagnostic.into(),
            }
        })
        .collect()
}

/// The number of halfedges of a loop of `after`, if it follows from all faces before having
/// `size` of them.
fn size_after(drawing: &Drawing, orbit: &Loop, size: i64) -> Option<i64> {
    orbit.items.iter().try_fold(0, |sum, item| {
        let name = item.item.name;
        let length = match drawing.rule.kind(name) {
            Kind::Path => path_length(drawing, name, orbit, size)?,
            _ => 1,
        };
        Some(sum + length)
    })
}

/// The length of a path, given that the face it comes from had `size` halfedges. Of a loop
/// that may be a hole nothing follows, unless the path stays in it: then the loop counts only
/// if it is a face.
fn path_length(drawing: &Drawing, path: NameId, after: &Loop, size: i64) -> Option<i64> {
    let before = drawing.before.loop_of_item(path)?;
    let stays = before.face.name == after.face.name && after.kind == LoopKind::Any;
    let is_face = before.kind == LoopKind::Face || (before.kind == LoopKind::Any && stays);
    let is_path = |name: NameId| drawing.rule.kind(name) == Kind::Path;
    let paths = before
        .items
        .iter()
        .filter(|item| is_path(item.item.name))
        .count();
    let drawn = (before.items.len() - paths) as i64;
    (is_face && paths == 1).then_some(size - drawn)
}

fn keeps_size(drawing: &Drawing, size: i64) -> bool {
    wrong_size(drawing, size).is_none()
}

/// A face of `after` that may not have `size` halfedges, in words.
fn wrong_size(drawing: &Drawing, size: i64) -> Option<String> {
    let impossible = drawing.rule.before.loops.iter().any(|orbit| {
        let paths = orbit
            .items
            .iter()
            .filter(|item| drawing.rule.kind(item.item.name) == Kind::Path);
        let paths = paths.count();
        let drawn = (orbit.items.len() - paths) as i64;
        orbit.kind == LoopKind::Face && (drawn > size || (paths == 0 && drawn != size))
    });
    if impossible {
        return Some(format!(
            "the drawing does not match where all faces have {size} sides"
        ));
    }
    let faces = drawing
        .rule
        .after
        .loops
        .iter()
        .filter(|orbit| orbit.kind != LoopKind::Hole);
    faces
        .filter_map(|orbit| {
            let text = drawing.rule.quoted(orbit.face.name);
            match size_after(drawing, orbit, size) {
                Some(found) if found == size => None,
                Some(found) => Some(format!(
                    "{text} would have {found} sides, if all faces have {size} before"
                )),
                None => Some(format!("nothing says how many sides {text} would have")),
            }
        })
        .next()
}

/// Whether no hole changes: none is created or erased, each that is drawn has its vertices
/// and paths as before, and no fan moves, for a hole may lie in it.
fn keeps_boundary(drawing: &Drawing) -> bool {
    let rule = drawing.rule;
    let may_be_hole = |orbit: &&Loop| orbit.kind != LoopKind::Face;
    let content = |orbit: &Loop| {
        let mut content: Vec<NameId> = orbit.items.iter().map(|item| item.from.name).collect();
        let paths = orbit.items.iter().map(|item| item.item.name);
        content.extend(paths.filter(|&item| rule.kind(item) == Kind::Path));
        content.sort();
        content
    };
    let same = |orbit: &Loop| {
        let after = drawing.after.loop_of_face(orbit.face.name);
        after.is_some_and(|after| after.kind == orbit.kind && content(after) == content(orbit))
    };
    let none_created = rule.after.loops.iter().filter(may_be_hole).all(|orbit| {
        drawing
            .before
            .loop_of_face(orbit.face.name)
            .is_some_and(|before| before.kind == orbit.kind)
    });
    none_created
        && rule.before.loops.iter().filter(may_be_hole).all(same)
        && super::facts::moved_fans(drawing).next().is_none()
}

/// How the degree of each vertex that lives on changes.
pub(super) fn degree_changes(drawing: &Drawing) -> Vec<SizeChange> {
    let rule = drawing.rule;
    let vertices = rule
        .names_of(Kind::Vertex)
        .filter(|&vertex| drawing.survives(vertex));
    vertices
        .map(|vertex| {
            let starts_before = |half: &NameId| {
                drawing.before.mention(*half).is_some()
                    && drawing.origin_before(*half) == Some(vertex)
            };
            let starts_after = |half: &NameId| {
                drawing.erased(*half).is_none() && drawing.origin_after(*half) == Some(vertex)
            };
            let halfedges = || rule.names_of(Kind::Halfedge);
            let constant = halfedges().filter(starts_after).count() as i64
                - halfedges().filter(starts_before).count() as i64;
            let moved: Vec<_> = super::facts::moved_fans(drawing).collect();
            let named = |at: Option<NameId>| at == Some(vertex);
            let gains = moved
                .iter()
                .filter(|&&fan| named(drawing.after.star_of_spoke(fan)));
            let loses = moved
                .iter()
                .filter(|&&fan| named(drawing.before.star_of_spoke(fan)));
            SizeChange {
                element: rule.name(vertex).text.clone(),
                constant,
                gains: gains.map(|&fan| rule.name(fan).text.clone()).collect(),
                loses: loses.map(|&fan| rule.name(fan).text.clone()).collect(),
            }
        })
        .collect()
}

/// How the size of each face that lives on changes.
pub(super) fn size_changes(drawing: &Drawing) -> Vec<SizeChange> {
    let rule = drawing.rule;
    let faces = rule
        .names_of(Kind::Face)
        .filter(|&face| drawing.survives(face));
    faces
        .filter_map(|face| {
            let before = drawing.before.loop_of_face(face)?;
            let after = drawing.after.loop_of_face(face)?;
            let is_path = |name: &NameId| rule.kind(*name) == Kind::Path;
            let items = |orbit: &Loop| {
                orbit
                    .items
                    .iter()
                    .map(|item| item.item.name)
                    .collect::<Vec<_>>()
            };
            let (before, after) = (items(before), items(after));
            let drawn =
                |items: &[NameId]| items.iter().filter(|name| !is_path(name)).count() as i64;
            let only_in = |these: &[NameId], others: &[NameId]| {
                let paths = these
                    .iter()
                    .filter(|name| is_path(name) && !others.contains(name));
                paths.map(|&path| rule.name(path).text.clone()).collect()
            };
            Some(SizeChange {
                element: rule.name(face).text.clone(),
                constant: drawn(&after) - drawn(&before),
                gains: only_in(&after, &before),
                loses: only_in(&before, &after),
            })
        })
        .collect()
}
