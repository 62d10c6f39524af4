//! Validation of the tables of a mesh: one function per law.
//!
//! A mesh is in order when no pointer dangles, `next` is a permutation with `prev` its
//! inverse, `twin` pairs every halfedge with another, and faces, edges and vertices are
//! exactly the orbits of `next`, `twin` and next-spoke, each with a halfedge of its own
//! orbit. A vertex may also be isolated: no halfedge starts at it and it has none.
//!
//! Every law can be checked on any table, however broken, in linear time. A law about orbits relies
//! on the laws before it only for the meaning of its result. Stronger conditions on surfaces are in
//! `level`.

use super::connectivity::Mesh;
use super::id::{Element, ElementKind, HalfedgeId};
use super::invalid::Invalid;

type Law = fn(&Mesh) -> Result<(), Invalid>;

/// The laws, in the order in which they are checked.
pub const LAWS: [(&str, Law); 7] = [
    ("nothing_points_at_the_dead", nothing_points_at_the_dead),
    ("next_is_permutation", next_is_permutation),
    ("twin_is_involution", twin_is_involution),
    ("faces_are_orbits", faces_are_orbits),
    ("edges_are_orbits", edges_are_orbits),
    ("vertices_are_orbits", vertices_are_orbits),
    ("positions_are_finite", positions_are_finite),
];

/// Checks all laws; the error is the first one found broken.
pub fn validate(mesh: &Mesh) -> Result<(), Invalid> {
    if mesh.is_in_order() { Ok(()) } else { LAWS.iter().try_for_each(|(_, law)| law(mesh)) }
}

/// Every pointer of a living element leads to a living element. Only the `halfedge` of
/// a vertex may be missing.
pub fn nothing_points_at_the_dead(mesh: &Mesh) -> Result<(), Invalid> {
    let check =
        |of: Element, pointer: &'static str, to: Element| match mesh.is_alive(to.kind, to.index) {
            true => Ok(()),
            false => Err(Invalid::Dangling { of, pointer, to }),
        };
    for h in mesh.halfedges() {
        let record = mesh.halfedge(h);
        check(h.into(), "next", record.next.into())?;
        check(h.into(), "prev", record.prev.into())?;
        check(h.into(), "twin", record.twin.into())?;
        check(h.into(), "vertex", record.vertex.into())?;
        check(h.into(), "edge", record.edge.into())?;
        check(h.into(), "face", record.face.into())?;
    }
    for v in mesh.vertices() {
        let h = mesh.vertex_halfedge(v);
        if !h.is_none() {
            check(v.into(), "halfedge", h.into())?;
        }
    }
    for e in mesh.edges() {
        check(e.into(), "halfedge", mesh.edge_halfedge(e).into())?;
    }
    for f in mesh.faces() {
        check(f.into(), "halfedge", mesh.face_halfedge(f).into())?;
    }
    Ok(())
}

/// `prev` undoes `next`, and `next` undoes `prev`.
pub fn next_is_permutation(mesh: &Mesh) -> Result<(), Invalid> {
    for halfedge in mesh.halfedges() {
        let next = mesh.next(halfedge);
        let back = mesh.get_prev(next).unwrap_or(HalfedgeId::NONE);
        if back != halfedge {
            return Err(Invalid::NotInverse { halfedge, pointer: "next", to: next, back });
        }
        let prev = mesh.prev(halfedge);
        let back = mesh.get_next(prev).unwrap_or(HalfedgeId::NONE);
        if back != halfedge {
            return Err(Invalid::NotInverse { halfedge, pointer: "prev", to: prev, back });
        }
    }
    Ok(())
}

/// `twin` undoes itself and maps no halfedge to itself.
pub fn twin_is_involution(mesh: &Mesh) -> Result<(), Invalid> {
    for halfedge in mesh.halfedges() {
        let twin = mesh.twin(halfedge);
        if twin == halfedge {
            return Err(Invalid::TwinOfItself { halfedge });
        }
        let back = mesh.get_twin(twin).unwrap_or(HalfedgeId::NONE);
        if back != halfedge {
            return Err(Invalid::TwinNotMutual { halfedge, twin, back });
        }
    }
    Ok(())
}

/// Faces and holes are the cycles of `next`, each with a halfedge of its own.
pub fn faces_are_orbits(mesh: &Mesh) -> Result<(), Invalid> {
    let own = mesh.faces().map(|f| (f.into(), mesh.face_halfedge(f)));
    let orbits = Orbits { successor: |h| mesh.get_next(h), label: |h| mesh.face(h).into() };
    orbits.are(mesh, own)
}

/// Edges are the pairs of twins, each with a halfedge of its own.
pub fn edges_are_orbits(mesh: &Mesh) -> Result<(), Invalid> {
    let own = mesh.edges().map(|e| (e.into(), mesh.edge_halfedge(e)));
    let orbits = Orbits { successor: |h| mesh.get_twin(h), label: |h| mesh.edge(h).into() };
    orbits.are(mesh, own)
}

/// Vertices are the cycles of next-spoke, each with a halfedge of its own; or isolated.
pub fn vertices_are_orbits(mesh: &Mesh) -> Result<(), Invalid> {
    let own = mesh.vertices().map(|v| (v.into(), mesh.vertex_halfedge(v)));
    let spoke = |h| mesh.get_twin(mesh.get_prev(h)?);
    Orbits { successor: spoke, label: |h| mesh.vertex(h).into() }.are(mesh, own)
}

pub fn positions_are_finite(mesh: &Mesh) -> Result<(), Invalid> {
    for v in mesh.vertices() {
        let position = mesh.position(v);
        if !position.is_finite() {
            return Err(Invalid::NotFinite { vertex: v.into(), position });
        }
    }
    Ok(())
}

/// The orbits of a permutation of halfedges, and the element that each halfedge names.
struct Orbits<S, L> {
    successor: S,
    label: L,
}

impl<S, L> Orbits<S, L>
where
    S: Fn(HalfedgeId) -> Option<HalfedgeId>,
    L: Fn(HalfedgeId) -> Element,
{
    /// Checks that elements and orbits correspond one to one; `own` gives every element with its
    /// halfedge.
    fn are(
        &self,
        mesh: &Mesh,
        own: impl Iterator<Item = (Element, HalfedgeId)> + Clone,
    ) -> Result<(), Invalid> {
        for h in mesh.halfedges() {
            let Some(successor) = (self.successor)(h).filter(|&s| mesh.halfedge_alive(s)) else {
                continue; // a dangling pointer: another law speaks of it
            };
            let says = [(self.label)(h), (self.label)(successor)];
            if says[0] != says[1] {
                return Err(Invalid::Disagree { halfedges: [h, successor], says });
            }
        }
        // Each step marks a halfedge, so the walks end even if the orbits do not close.
        let mut reached = vec![false; mesh.capacity(ElementKind::Halfedge)];
        for (element, halfedge) in own.clone() {
            if !mesh.halfedge_alive(halfedge) {
                continue;
            }
            let says = (self.label)(halfedge);
            if says != element {
                return Err(Invalid::ForeignHalfedge { element, halfedge, says });
            }
            let mut at = Some(halfedge);
            while let Some(h) = at.filter(|&h| mesh.halfedge_alive(h) && !reached[h.index()]) {
                reached[h.index()] = true;
                at = (self.successor)(h);
            }
        }
        match mesh.halfedges().find(|h| !reached[h.index()]) {
            None => Ok(()),
            Some(missed) => {
                let element = (self.label)(missed);
                let first = own.clone().find(|&(x, _)| x == element);
                let first = first.map_or(HalfedgeId::NONE, |(_, h)| h);
                Err(Invalid::SeveralOrbits { element, halfedges: [first, missed] })
            }
        }
    }
}
