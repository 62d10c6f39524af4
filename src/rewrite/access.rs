//! Checked reads and writes of the mesh through registers.
//!
//! A number in a register may be that of an element that is erased or never existed. Reading or
//! writing through it traps; neither can panic.

use glam::DVec3;

use super::drain::Drains;
use super::{ElementField, Elements, Fault, HalfedgeField, Walk};
use crate::mesh::{EdgeId, ElementKind, FaceId, HalfedgeId, Mesh, VertexId};

/// The fault of an element that does not exist.
#[cold]
pub(super) fn gone(kind: ElementKind, id: u32) -> Fault {
    if id == u32::MAX { Fault::Missing(kind) } else { Fault::Gone(kind) }
}

/// Fails unless the element exists.
#[inline]
pub(super) fn expect_alive(mesh: &Mesh, kind: ElementKind, id: u32) -> Result<(), Fault> {
    if mesh.is_alive(kind, id) { Ok(()) } else { Err(gone(kind, id)) }
}

/// The living vertex with this number.
#[inline]
pub(super) fn vertex(mesh: &Mesh, id: u32) -> Result<VertexId, Fault> {
    expect_alive(mesh, ElementKind::Vertex, id).map(|()| VertexId(id))
}

#[inline]
fn halfedge(mesh: &Mesh, id: u32) -> Result<HalfedgeId, Fault> {
    expect_alive(mesh, ElementKind::Halfedge, id).map(|()| HalfedgeId(id))
}

/// The living edge with this number.
#[inline]
pub(super) fn edge(mesh: &Mesh, id: u32) -> Result<EdgeId, Fault> {
    expect_alive(mesh, ElementKind::Edge, id).map(|()| EdgeId(id))
}

/// The living face with this number.
#[inline]
pub(super) fn face(mesh: &Mesh, id: u32) -> Result<FaceId, Fault> {
    expect_alive(mesh, ElementKind::Face, id).map(|()| FaceId(id))
}

/// A pointer of a halfedge; a fault if the halfedge does not live.
#[inline]
pub(super) fn load(mesh: &Mesh, field: HalfedgeField, id: u32) -> Result<u32, Fault> {
    pointer_of(mesh, field, id).ok_or_else(|| gone(ElementKind::Halfedge, id))
}

/// A pointer of a halfedge, if the halfedge lives.
#[inline]
pub(super) fn pointer_of(mesh: &Mesh, field: HalfedgeField, id: u32) -> Option<u32> {
    // Loading all six pointers is faster than a jump to one of six loads.
    Some(mesh.get_halfedge(HalfedgeId(id))?.pointers()[field as usize])
}

/// The halfedge of an element.
#[inline]
pub(super) fn load_halfedge(mesh: &Mesh, of: ElementField, id: u32) -> Result<u32, Fault> {
    let (kind, halfedge) = match of {
        ElementField::Vertex => (ElementKind::Vertex, mesh.get_vertex_halfedge(VertexId(id))),
        ElementField::Edge => (ElementKind::Edge, mesh.get_edge_halfedge(EdgeId(id))),
        ElementField::Face => (ElementKind::Face, mesh.get_face_halfedge(FaceId(id))),
    };
    halfedge.map(|h| h.0).ok_or_else(|| gone(kind, id))
}

/// Whether an element lives and, if `of` is faces or holes, is one of these.
#[inline]
pub(super) fn lives(mesh: &Mesh, of: Elements, id: u32) -> bool {
    match of {
        Elements::Vertices => mesh.vertex_alive(VertexId(id)),
        Elements::Halfedges => mesh.halfedge_alive(HalfedgeId(id)),
        Elements::Edges => mesh.edge_alive(EdgeId(id)),
        Elements::Faces => mesh.get_is_hole(FaceId(id)) == Some(false),
        Elements::Holes => mesh.get_is_hole(FaceId(id)) == Some(true),
    }
}

/// The first living element from `id` on.
#[inline]
pub(super) fn next_living(mesh: &Mesh, of: Elements, id: u64) -> Option<u32> {
    // Every id is below the capacity, which is below `u32::MAX`.
    let capacity = mesh.capacity(of.kind()) as u64;
    (id..capacity).map(|id| id as u32).find(|&id| lives(mesh, of, id))
}

/// Appends all living elements.
pub(super) fn collect_living(mesh: &Mesh, of: Elements, into: &mut Vec<u64>) {
    match of {
        Elements::Vertices => into.extend(mesh.vertices().map(|v| u64::from(v.0))),
        Elements::Halfedges => into.extend(mesh.halfedges().map(|h| u64::from(h.0))),
        Elements::Edges => into.extend(mesh.edges().map(|e| u64::from(e.0))),
        Elements::Faces | Elements::Holes => {
            let is_hole = of == Elements::Holes;
            let faces = mesh.faces().filter(|&face| mesh.is_hole(face) == is_hole);
            into.extend(faces.map(|face| u64::from(face.0)));
        }
    }
}

/// Fails unless a pointer may have this value: the number of any slot, or of no element.
#[inline]
fn pointer(mesh: &Mesh, kind: ElementKind, value: u32) -> Result<(), Fault> {
    match value == u32::MAX || (value as usize) < mesh.capacity(kind) {
        true => Ok(()),
        false => Err(Fault::WildPointer(kind)),
    }
}

/// Sets a pointer of a living halfedge.
#[inline]
pub(super) fn store(
    mesh: &mut Mesh,
    field: HalfedgeField,
    id: u32,
    value: u32,
) -> Result<(), Fault> {
    let h = halfedge(mesh, id)?;
    match field {
        HalfedgeField::Next | HalfedgeField::Prev | HalfedgeField::Twin => {
            pointer(mesh, ElementKind::Halfedge, value)?;
            let value = HalfedgeId(value);
            match field {
                HalfedgeField::Next => mesh.set_next(h, value),
                HalfedgeField::Prev => mesh.set_prev(h, value),
                _ => mesh.set_twin(h, value),
            }
        }
        HalfedgeField::Vertex => {
            pointer(mesh, ElementKind::Vertex, value)?;
            mesh.set_vertex(h, VertexId(value));
        }
        HalfedgeField::Edge => {
            pointer(mesh, ElementKind::Edge, value)?;
            mesh.set_edge(h, EdgeId(value));
        }
        HalfedgeField::Face => {
            pointer(mesh, ElementKind::Face, value)?;
            mesh.set_face(h, FaceId(value));
        }
    }
    Ok(())
}

/// Sets the halfedge of a living element.
#[inline]
pub(super) fn store_halfedge(
    mesh: &mut Mesh,
    of: ElementField,
    id: u32,
    value: u32,
) -> Result<(), Fault> {
    pointer(mesh, ElementKind::Halfedge, value)?;
    let value = HalfedgeId(value);
    match of {
        ElementField::Vertex => mesh.set_vertex_halfedge(vertex(mesh, id)?, value),
        ElementField::Edge => mesh.set_edge_halfedge(edge(mesh, id)?, value),
        ElementField::Face => mesh.set_face_halfedge(face(mesh, id)?, value),
    }
    Ok(())
}

/// Sets a pointer of every halfedge in a buffer.
pub(super) fn store_all(
    mesh: &mut Mesh,
    field: HalfedgeField,
    halfedges: &[u64],
    value: u32,
) -> Result<(), Fault> {
    halfedges.iter().try_for_each(|&id| store(mesh, field, id as u32, value))
}

/// Checks that a vertex lives and that a position is finite.
#[inline]
pub(super) fn place(mesh: &Mesh, id: u32, position: DVec3) -> Result<(VertexId, DVec3), Fault> {
    let v = vertex(mesh, id)?;
    if position.is_finite() { Ok((v, position)) } else { Err(Fault::NotFinite) }
}

#[inline]
fn add(mesh: &mut Mesh, kind: ElementKind) -> Result<u32, Fault> {
    if mesh.capacity(kind) >= u32::MAX as usize - 1 && !room_for_one(mesh, kind) {
        return Err(Fault::NoRoom(kind));
    }
    Ok(match kind {
        ElementKind::Vertex => mesh.add_vertex().0,
        ElementKind::Halfedge => mesh.add_halfedge().0,
        ElementKind::Edge => mesh.add_edge().0,
        ElementKind::Face => mesh.add_face().0,
    })
}

/// Adds an element, and notes it: in the list of created elements, if there is one, and for the
/// drains that are told.
#[inline]
pub(super) fn create(
    mesh: &mut Mesh,
    kind: ElementKind,
    created: &mut Option<Vec<(ElementKind, u32)>>,
    drains: Option<&mut Drains>,
) -> Result<u32, Fault> {
    let id = add(mesh, kind)?;
    if let Some(created) = created {
        created.push((kind, id));
    }
    if let Some(drains) = drains {
        drains.created(mesh, kind, id);
    }
    Ok(id)
}

/// Adds elements of a kind as [`create`] does, and appends their ids to a list.
pub(super) fn create_all(
    mesh: &mut Mesh,
    (kind, count): (ElementKind, usize),
    into: &mut Vec<u64>,
    created: &mut Option<Vec<(ElementKind, u32)>>,
    drains: &mut Drains,
) -> Result<(), Fault> {
    if created.is_none() && drains.is_empty() && mesh.can_append(counts_of(kind, count)) {
        let first = u64::from(mesh.append(kind, count));
        into.extend(first..first + count as u64);
        return Ok(());
    }
    for _ in 0..count {
        let id = create(mesh, kind, created, Some(&mut *drains))?;
        into.push(u64::from(id));
    }
    Ok(())
}

/// Whether there is room for `count` new elements of a kind.
pub(super) fn has_room(mesh: &Mesh, kind: ElementKind, count: usize) -> bool {
    let [vertices, halfedges, edges, faces] = counts_of(kind, count);
    mesh.can_add(vertices, halfedges, edges, faces)
}

#[cold]
fn room_for_one(mesh: &Mesh, kind: ElementKind) -> bool {
    has_room(mesh, kind, 1)
}

/// `count` of a kind and none of the others, by kind.
pub(super) fn counts_of(kind: ElementKind, count: usize) -> [usize; 4] {
    ElementKind::ALL.map(|this| if kind == this { count } else { 0 })
}

/// Erases a living element.
#[inline]
pub(super) fn erase(mesh: &mut Mesh, kind: ElementKind, id: u32) -> Result<(), Fault> {
    match kind {
        ElementKind::Vertex => mesh.erase_vertex(vertex(mesh, id)?),
        ElementKind::Halfedge => mesh.erase_halfedge(halfedge(mesh, id)?),
        ElementKind::Edge => mesh.erase_edge(edge(mesh, id)?),
        ElementKind::Face => mesh.erase_face(face(mesh, id)?),
    }
    Ok(())
}

/// The halfedge after `id` on the walk.
#[inline]
pub(super) fn step(mesh: &Mesh, walk: Walk, id: u32) -> Result<u32, Fault> {
    match walk {
        Walk::Loop => load(mesh, HalfedgeField::Next, id),
        Walk::Star => {
            let prev = load(mesh, HalfedgeField::Prev, id)?;
            load(mesh, HalfedgeField::Twin, prev)
        }
    }
}

/// Appends the halfedges from `from` up to, but without, `until`; the whole cycle if both are the
/// same.
pub(super) fn collect(
    mesh: &Mesh,
    walk: Walk,
    [from, until]: [u32; 2],
    into: &mut Vec<u64>,
) -> Result<(), Fault> {
    let mut at = from;
    // No walk that ends is longer than there are halfedges.
    for _ in 0..mesh.capacity(ElementKind::Halfedge) {
        into.push(u64::from(at));
        at = step(mesh, walk, at)?;
        if at == until {
            return Ok(());
        }
        if at == from {
            break;
        }
    }
    // If there are no halfedges at all, the loop has not run.
    halfedge(mesh, from)?;
    Err(Fault::Endless)
}

/// Whether a walk from `from` (included) meets `goal` before it comes to `stop` or back to `from`.
pub(super) fn meets(
    mesh: &Mesh,
    walk: Walk,
    from: u32,
    [goal, stop]: [u32; 2],
) -> Result<bool, Fault> {
    let mut at = from;
    for _ in 0..mesh.capacity(ElementKind::Halfedge) {
        if at == goal {
            return Ok(true);
        }
        at = step(mesh, walk, at)?;
        if at == stop || at == from {
            return Ok(false);
        }
    }
    halfedge(mesh, from)?;
    Err(Fault::Endless)
}
