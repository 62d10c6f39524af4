//! Obligations of `simple` beyond `surface`: edges and faces are determined by their vertices.

use std::collections::BTreeSet;

use super::evidence;
use super::obligation::{Obligation, Statement};
use super::sketch::Sketch;
use crate::diagram::{Loop, LoopKind, NameId};
use crate::mesh::OrbitCondition as Orbit;

/// The obligations of `simple` beyond `surface`.
pub(super) fn obligations(sketch: &Sketch) -> Vec<Obligation> {
    let mut obligations = Vec::new();
    // The vertices around which all edges, or all faces, are compared.
    let mut by_edges = Vec::new();
    let mut by_faces = Vec::new();
    for vertex in sketch.vertices() {
        let from = sketch.arcs(vertex);
        if gathers(sketch, vertex, &from) {
            by_edges.push(vertex);
            let because = evidence::neighbors(sketch, vertex, &from);
            let statement = Statement::new(Orbit::NeighborsDiffer, vertex).telling(from);
            obligations.push(Obligation::new(statement, because));
        }
    }
    for halfedge in sketch.halfedges().filter(|&half| is_changed(sketch, half)) {
        obligations.extend(single_edge(sketch, halfedge, &by_edges));
    }
    for vertex in sketch.vertices() {
        if gathers(sketch, vertex, &sketch.outside(vertex)) {
            by_faces.push(vertex);
            let statement = Statement::new(Orbit::CornersDiffer, vertex);
            obligations.push(Obligation::new(statement, None));
        }
    }
    for orbit in sketch.loops() {
        let seen = by_faces.iter().any(|&vertex| Sketch::draws(orbit, vertex));
        if !seen && has_other_corners(sketch, orbit) {
            obligations.push(corners_own(sketch, orbit));
        }
    }
    obligations
}

/// True if a vertex gathers pieces of several stars, or has a piece of another star besides its
/// own.
fn gathers(sketch: &Sketch, vertex: NameId, from: &[NameId]) -> bool {
    let foreign = from.iter().any(|&source| source != vertex);
    foreign && (sketch.drawing.survives(vertex) || from.len() > 1)
}

/// True if the edge of a halfedge is new, or has moved an end; only for one of two drawn twins.
fn is_changed(sketch: &Sketch, half: NameId) -> bool {
    let drawing = sketch.drawing;
    let moved = |half: NameId| drawing.origin_before(half) != drawing.origin_after(half);
    match drawing.after.twin(half) {
        Some(twin) if twin < half => false,
        Some(twin) => drawing.before.twin(half) != Some(twin) || moved(half) || moved(twin),
        None => moved(half),
    }
}

fn single_edge(sketch: &Sketch, halfedge: NameId, by_edges: &[NameId]) -> Option<Obligation> {
    let drawing = sketch.drawing;
    let ends = [drawing.origin_after(halfedge)?, drawing.target_after(halfedge)?];
    if ends.iter().any(|end| by_edges.contains(end)) {
        return None;
    }
    let drawn = sketch.drawn_edges_between(ends[0], ends[1]);
    let alone = drawn == 1;
    let named = ends.iter().any(|&end| sketch.neighbors_are_named(end));
    let because = match alone {
        true if named => Some("all edges of one of its ends are drawn"),
        true => evidence::not_adjacent(sketch, ends),
        false => None,
    };
    let statement = Statement::new(Orbit::SingleEdge, halfedge).telling(ends.to_vec());
    let obligation = Obligation::new(statement, because);
    Some(obligation.or_never(drawn > 1))
}

/// True if a loop is new or has other corners than before.
fn has_other_corners(sketch: &Sketch, orbit: &Loop) -> bool {
    let Some(before) = sketch.drawing.before.loop_of_face(orbit.face.name) else { return true };
    let parts = |orbit: &Loop| {
        let mut parts: Vec<_> = orbit.corners().chain(sketch.paths(orbit)).collect();
        parts.sort_unstable();
        parts.dedup();
        parts
    };
    let becomes_a_face = before.kind != orbit.kind;
    orbit.kind != LoopKind::Hole && (becomes_a_face || parts(before) != parts(orbit))
}

fn corners_own(sketch: &Sketch, orbit: &Loop) -> Obligation {
    let corners: Vec<_> = orbit.corners().collect();
    let is_lonely = |vertex: &&NameId| sketch.faces_are_drawn(**vertex);
    let lonely = corners.iter().find(is_lonely);
    let because = if is_triangle_apart(sketch, orbit) {
        Some("it is a triangle, and what lies across an edge has another corner")
    } else if lonely.is_some_and(|&vertex| others_differ(sketch, orbit, vertex)) {
        Some("one of its corners lies around drawn faces only, which have other corners")
    } else {
        None
    };
    let corner = lonely.copied().unwrap_or(corners[0]);
    let statement = Statement::new(Orbit::CornersOwn, orbit.face.name).at(corner);
    Obligation::new(statement, because).or_never(has_double(sketch, orbit))
}

/// True if another face that is drawn has the corners of this one.
fn has_double(sketch: &Sketch, orbit: &Loop) -> bool {
    let corners = |of: &Loop| {
        let is_whole = of.kind == LoopKind::Face && !of.each && sketch.paths(of).next().is_none();
        is_whole.then(|| of.corners().collect::<BTreeSet<_>>())
    };
    let ours = corners(orbit);
    let is_double = |other: &Loop| other.face.name != orbit.face.name && corners(other) == ours;
    ours.is_some() && sketch.loops().iter().any(is_double)
}

/// True if a triangle has something else than its own corners across one of its edges. A triangle
/// with the same corners would have the same edges, since edges are single, and so would lie across
/// each of them.
fn is_triangle_apart(sketch: &Sketch, orbit: &Loop) -> bool {
    let items: Vec<_> = orbit.item_names().collect();
    if items.len() != 3 || items.iter().any(|&item| sketch.is_path(item)) {
        return false;
    }
    items.iter().any(|&item| {
        let twin = sketch.drawing.after.twin(item);
        let across = twin.and_then(|twin| sketch.drawing.after.loop_of_item(twin));
        across.is_some_and(|across| {
            let mut corners = across.corners();
            across.kind == LoopKind::Hole || corners.any(|corner| !Sketch::draws(orbit, corner))
        })
    })
}

/// True if each other loop around a vertex, all of which are drawn, has a corner that this one
/// lacks, or lacks one that this one has.
fn others_differ(sketch: &Sketch, orbit: &Loop, vertex: NameId) -> bool {
    let has_more = |this: &Loop, than: &Loop| {
        let mut corners = this.corners();
        corners.any(|corner| {
            let mut paths = sketch.paths(than);
            !Sketch::draws(than, corner) && !paths.any(|path| sketch.may_lie_on(corner, path))
        })
    };
    let others = sketch.loops().iter().filter(|other| {
        other.face.name != orbit.face.name
            && other.kind != LoopKind::Hole
            && Sketch::draws(other, vertex)
    });
    others.into_iter().all(|other| {
        has_more(orbit, other) || has_more(other, orbit) || are_changed_alike(sketch, orbit, other)
    })
}

/// True if two loops get the same new corners and lose the same ones: their corners differ, since
/// they did before.
fn are_changed_alike(sketch: &Sketch, one: &Loop, other: &Loop) -> bool {
    let Sketch { drawing, .. } = sketch;
    // Members of families are the same in name only.
    if drawing.rule.cycle.is_some() {
        return false;
    }
    let change = |orbit: &Loop| {
        let before = drawing.before.loop_of_face(orbit.face.name)?;
        let paths = |orbit: &Loop| sketch.paths(orbit).collect::<BTreeSet<_>>();
        if before.kind != orbit.kind || paths(before) != paths(orbit) {
            return None;
        }
        let [was, is] = [before, orbit].map(|orbit| orbit.corners().collect::<BTreeSet<_>>());
        let gained: Vec<_> = is.difference(&was).copied().collect();
        let lost: Vec<_> = was.difference(&is).copied().collect();
        gained.iter().all(|&name| drawing.created(name).is_some()).then_some((gained, lost))
    };
    change(one).is_some_and(|changed| change(other) == Some(changed))
}
