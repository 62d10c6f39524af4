//! Properties that a proved rule keeps besides validity, and how degrees and sizes change.
//!
//! Properties are inferred for every rule; what `keeps` declares must be among them. Each is read
//! off the drawing: whether every face stays a triangle, given that all were, is found by counting
//! halfedges, where the length of a path follows from the loop it comes from.

use super::change::Change;
use super::guard::Obligation;
use super::keeps;
use super::sizes::Sizes;
use crate::diagram::{Drawing, Kind, Loop, LoopKind, NameId, Property, Rule};

/// The change of a degree or a size: a constant, and the runs that are gained and lost.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SizeChange {
    /// The vertex, or the face.
    pub element: String,
    /// The change by drawn halfedges.
    pub constant: i64,
    /// The change by halfedges of families, for each index.
    pub per_index: i64,
    /// The fans or paths that are gained.
    pub gains: Vec<String>,
    /// The fans or paths that are lost.
    pub loses: Vec<String>,
    /// True if it may be another where names of an `alias` are one.
    pub varies: bool,
}

impl SizeChange {
    /// True if nothing changes.
    pub fn is_nothing(&self) -> bool {
        self.constant == 0 && self.per_index == 0 && self.gains.is_empty() && self.loses.is_empty()
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

/// Everything that a rule with families keeps, whatever the size of the cycle.
pub(super) fn kept_by_families(sizes: &Sizes, grows_with: &[String]) -> Vec<Property> {
    let all: Vec<_> = std::iter::once(&sizes.large)
        .chain(&sizes.small)
        .map(|one| (Drawing::new(&one.rule), Change::of(&one.rule)))
        .collect();
    let at_all = |holds: &dyn Fn(&Drawing, Change) -> bool| {
        all.iter().all(|(drawing, change)| holds(drawing, *change))
    };
    // Where all faces have this size, the rule may not match at all on some cycles.
    let of_size = |size: i64| {
        let fits = |drawing: &Drawing| matches_faces_of(drawing, size);
        all.iter().any(|(drawing, _)| fits(drawing))
            && at_all(&|drawing, _| !fits(drawing) || keeps_size(drawing, size))
    };
    let keeps = |property: &Property| match property {
        Property::Triangles => of_size(3),
        Property::Quads => of_size(4),
        Property::Euler => at_all(&|_, change| change.euler() == 0),
        Property::Boundary => at_all(&|drawing, _| keeps_boundary(drawing)),
        Property::ConstantTime => grows_with.is_empty(),
        Property::Level(level) => {
            let guarded = sizes.large.rule.guard.is_some_and(|(guard, _)| guard >= *level);
            guarded || !sizes.obligations(*level).iter().any(Obligation::is_test)
        }
    };
    Property::ALL.into_iter().filter(keeps).collect()
}

/// Changes of degrees or sizes on cycles of any size: they grow linearly, so two sizes determine
/// them.
pub(super) fn evenly(
    sizes: &Sizes,
    changes: impl Fn(&Drawing) -> Vec<SizeChange>,
) -> Vec<SizeChange> {
    let large = &sizes.large.rule;
    let Some([shorter, longer]) = sizes.small.last_chunk() else { return Vec::new() };
    let [shorter, longer] =
        [shorter, longer].map(|one| (i64::from(one.size()), changes(&Drawing::new(&one.rule))));
    let mut found = changes(&Drawing::new(large));
    for (at, change) in found.iter_mut().enumerate() {
        let constant = |changes: &[SizeChange]| changes.get(at).map_or(0, |change| change.constant);
        let (less, more) = (constant(&shorter.1), constant(&longer.1));
        change.per_index = (more - less) / (longer.0 - shorter.0);
        change.constant = less - change.per_index * shorter.0;
        // All members of a family are gained or lost together.
        for runs in [&mut change.gains, &mut change.loses] {
            let counts: Vec<_> = runs.iter().map(|run| family_of(large, run)).collect();
            let mut at = 0;
            runs.retain(|_| {
                let whole = counts.iter().filter(|family| **family == counts[at]).count() > 2;
                let first = !counts[..at].contains(&counts[at]);
                at += 1;
                !whole || first
            });
        }
    }
    found
}

/// The family that a member belongs to, by its word.
fn family_of(rule: &Rule, word: &str) -> Option<NameId> {
    let mut members = rule.ids().filter(|&name| rule.is_member(name));
    let member = members.find(|&name| rule.name(name).text == word)?;
    Some(rule.first_member(member))
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

/// The length of a path, given that the face it comes from had `size` halfedges. Nothing follows
/// from a loop that may be a hole, unless the path stays in it: then the loop counts only if it is
/// a face.
fn path_length(drawing: &Drawing, path: NameId, after: &Loop, size: i64) -> Option<i64> {
    let before = drawing.before.loop_of_item(path)?;
    let stays = before.face.name == after.face.name && after.kind == LoopKind::Any;
    let is_face = before.kind == LoopKind::Face || (before.kind == LoopKind::Any && stays);
    let is_path = |name: NameId| drawing.rule.kind(name) == Kind::Path;
    let paths = before.items.iter().filter(|item| is_path(item.item.name)).count();
    let drawn = (before.items.len() - paths) as i64;
    (is_face && paths == 1).then_some(size - drawn)
}

fn keeps_size(drawing: &Drawing, size: i64) -> bool {
    wrong_size(drawing, size).is_none()
}

/// True if the drawing matches where all faces have `size` halfedges.
fn matches_faces_of(drawing: &Drawing, size: i64) -> bool {
    drawing.rule.before.loops.iter().all(|orbit| {
        let paths =
            orbit.items.iter().filter(|item| drawing.rule.kind(item.item.name) == Kind::Path);
        let paths = paths.count();
        let drawn = (orbit.items.len() - paths) as i64;
        orbit.kind != LoopKind::Face || (drawn <= size && (paths > 0 || drawn == size))
    })
}

/// A face of `after` that may not have `size` halfedges, in words.
pub(super) fn wrong_size(drawing: &Drawing, size: i64) -> Option<String> {
    if !matches_faces_of(drawing, size) {
        return Some(format!("the drawing does not match where all faces have {size} sides"));
    }
    let faces = drawing.rule.after.loops.iter().filter(|orbit| orbit.kind != LoopKind::Hole);
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

/// True if no hole changes: none is created or erased, each that is drawn has its vertices and
/// paths as before, and no fan and no outer halfedge gets another vertex, for a hole may be there.
fn keeps_boundary(drawing: &Drawing) -> bool {
    let rule = drawing.rule;
    let may_be_hole = |orbit: &&Loop| orbit.kind != LoopKind::Face;
    let content = |orbit: &Loop| {
        let mut content: Vec<NameId> = orbit.corners().collect();
        let paths = orbit.item_names();
        content.extend(paths.filter(|&item| rule.kind(item) == Kind::Path));
        content.sort();
        content
    };
    let same = |orbit: &Loop| {
        let after = drawing.after.loop_of_face(orbit.face.name);
        after.is_some_and(|after| after.kind == orbit.kind && content(after) == content(orbit))
    };
    let none_created = rule.after.loops.iter().filter(may_be_hole).all(|orbit| {
        drawing.before.loop_of_face(orbit.face.name).is_some_and(|before| before.kind == orbit.kind)
    });
    let stays = |outer| drawing.origin_before(outer) == drawing.origin_after(outer);
    none_created
        && rule.before.loops.iter().filter(may_be_hole).all(same)
        && drawing.moved_fans().next().is_none()
        && rule.names_of(Kind::Halfedge).filter(|&name| drawing.is_outer(name)).all(stays)
}

/// The change of the degree of each vertex that survives.
pub(super) fn degree_changes(drawing: &Drawing) -> Vec<SizeChange> {
    let rule = drawing.rule;
    let vertices = rule
        .names_of(Kind::Vertex)
        .filter(|&vertex| drawing.survives(vertex) && rule.is_first(vertex));
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
            let moved: Vec<_> = drawing.moved_fans().collect();
            let named = |at: Option<NameId>| at == Some(vertex);
            let gains = moved.iter().filter(|&&fan| named(drawing.after.star_of_spoke(fan)));
            let loses = moved.iter().filter(|&&fan| named(drawing.before.star_of_spoke(fan)));
            SizeChange {
                element: rule.name(vertex).text.clone(),
                constant,
                per_index: 0,
                gains: gains.map(|&fan| rule.name(fan).text.clone()).collect(),
                loses: loses.map(|&fan| rule.name(fan).text.clone()).collect(),
                varies: false,
            }
        })
        .collect()
}

/// The change of the size of each face that survives.
pub(super) fn size_changes(drawing: &Drawing) -> Vec<SizeChange> {
    let rule = drawing.rule;
    let faces =
        rule.names_of(Kind::Face).filter(|&face| drawing.survives(face) && rule.is_first(face));
    faces
        .filter_map(|face| {
            let before = drawing.before.loop_of_face(face)?;
            let after = drawing.after.loop_of_face(face)?;
            let is_path = |name: &NameId| rule.kind(*name) == Kind::Path;
            let items = |orbit: &Loop| orbit.item_names().collect::<Vec<_>>();
            let (before, after) = (items(before), items(after));
            let drawn =
                |items: &[NameId]| items.iter().filter(|name| !is_path(name)).count() as i64;
            let only_in = |these: &[NameId], others: &[NameId]| {
                let paths = these.iter().filter(|name| is_path(name) && !others.contains(name));
                paths.map(|&path| rule.name(path).text.clone()).collect()
            };
            Some(SizeChange {
                element: rule.name(face).text.clone(),
                constant: drawn(&after) - drawn(&before),
                per_index: 0,
                gains: only_in(&after, &before),
                loses: only_in(&before, &after),
                varies: false,
            })
        })
        .collect()
}
