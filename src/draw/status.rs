//! The status of each name: kept, reassigned, new or erased.

use std::collections::BTreeMap;

use crate::diagram::{Drawing, Kind, LoopKind, NameId, Rule};

/// The status of an element, path or fan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Status {
    /// It is the same on both sides.
    Kept,
    /// It is on both sides, but its connectivity differs or, for a vertex, an attribute is
    /// assigned.
    Reassigned,
    /// It is only in `after`.
    New,
    /// It is only in `before`.
    Erased,
}

/// The statuses of the names of a rule, in words: `kept`, `reassigned`, `new` or `erased`.
pub fn fates(rule: &Rule) -> BTreeMap<&str, &'static str> {
    let drawing = Drawing::new(rule);
    let names = rule.names.iter().zip(0..).map(|(name, at)| (name, NameId(at)));
    names.map(|(name, id)| (name.text.as_str(), Status::of(&drawing, id).word())).collect()
}

impl Status {
    /// All statuses, in the order of a legend.
    pub const ALL: [Status; 4] = [Status::Kept, Status::Reassigned, Status::New, Status::Erased];

    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Status::Kept => "kept",
            Status::Reassigned => "reassigned",
            Status::New => "new",
            Status::Erased => "erased",
        }
    }

    /// The status of a name.
    pub fn of(drawing: &Drawing, name: NameId) -> Self {
        if drawing.created(name).is_some() {
            return Status::New;
        }
        if drawing.erased(name).is_some() {
            return Status::Erased;
        }
        let (before, after) = (&drawing.before, &drawing.after);
        let item = |item| {
            before.item_after(item) != after.item_after(item)
                || before.face(item) != after.face(item)
                || drawing.origin_before(item) != drawing.origin_after(item)
        };
        let changed = match drawing.rule.kind(name) {
            Kind::Halfedge => match &drawing.rule.broken {
                Some(broken) => !broken.unchanged.contains(&name),
                None => {
                    item(name)
                        || before.twin(name) != after.twin(name)
                        || before.edge(name) != after.edge(name)
                }
            },
            Kind::Path => item(name),
            Kind::Fan => before.star_of_spoke(name) != after.star_of_spoke(name),
            Kind::Edge => edge_moves(drawing, name),
            Kind::Face => loop_changes(drawing, name),
            Kind::Vertex => {
                drawing.rule.assignments.iter().any(|assignment| assignment.target.name == name)
            }
        };
        if changed { Status::Reassigned } else { Status::Kept }
    }
}

/// True if an edge gets other halfedges, or these other ends.
fn edge_moves(drawing: &Drawing, edge: NameId) -> bool {
    let ends = |view: &crate::diagram::View, origin: &dyn Fn(NameId) -> Option<NameId>| {
        let statement = view.edge_statement(edge)?;
        let mut ends = statement.halfedges.map(|halfedge| (halfedge.name, origin(halfedge.name)));
        ends.sort();
        Some(ends)
    };
    let before = ends(&drawing.before, &|halfedge| drawing.origin_before(halfedge));
    let after = ends(&drawing.after, &|halfedge| drawing.origin_after(halfedge));
    before != after
}

/// True if the halfedges and paths around a face change, or whether it is a hole.
fn loop_changes(drawing: &Drawing, face: NameId) -> bool {
    let around = |view: &crate::diagram::View| {
        let orbit = view.loop_of_face(face)?;
        let mut items: Vec<_> = orbit.items.iter().map(|item| item.item.name).collect();
        // The loop may be written starting at any of its vertices.
        let first = items.iter().enumerate().min_by_key(|(_, item)| **item).map_or(0, |(at, _)| at);
        items.rotate_left(first);
        Some((orbit.kind == LoopKind::Hole, items))
    };
    around(&drawing.before) != around(&drawing.after)
}
