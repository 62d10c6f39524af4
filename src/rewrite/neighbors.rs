//! Loops over the neighbors of a vertex.
//!
//! Such a loop walks around the vertex, or it reads a list. The neighbors of all vertices may be
//! listed ([`Adjacency`]) when a loop over the mesh is run in parts, which only read. To list them
//! takes about as long as to walk around all vertices: it is done where no operation has been
//! applied since another such loop, or where the loop visits most vertices and reads no pointers
//! besides.

use std::sync::Arc;

use super::access::{gone, load, load_halfedge};
use super::window::Window;
use super::{Code, Count, ElementField, Fault, HalfedgeField, Inst, Reg};
use crate::mesh::{Adjacency, ElementKind, HalfedgeId, Mesh};

/// The registers in which a loop keeps its place: the first spoke, the current one, and the number of
/// steps; or, with lists, an unused one, the index of the current neighbor, and the end of the
/// list.
pub(super) fn of_loop(slots: Reg) -> [Reg; 3] {
    [0, 1, 2].map(|slot| Reg(slots.0.wrapping_add(slot)))
}

/// Begins a loop; returns the first neighbor, if there is one.
#[inline]
pub(super) fn begin(
    mesh: &Mesh,
    lists: Option<&Adjacency>,
    w: &mut Window,
    [vertex, slots]: [Reg; 2],
) -> Result<Option<u32>, Fault> {
    let vertex = w.id(vertex);
    let spoke = load_halfedge(mesh, ElementField::Vertex, vertex)?;
    let [first, at, steps] = of_loop(slots);
    if let Some(lists) = lists {
        let [start, end] = lists.bounds(vertex);
        w.set_id(at, start);
        w.set_id(steps, end);
        return Ok(if start < end { lists.neighbor(start) } else { None });
    }
    if spoke == HalfedgeId::NONE.0 {
        return Ok(None);
    }
    w.set_id(first, spoke);
    w.set_id(at, spoke);
    w.set_int(steps, 0);
    let twin = load(mesh, HalfedgeField::Twin, spoke)?;
    load(mesh, HalfedgeField::Vertex, twin).map(Some)
}

/// Advances a loop; returns the next neighbor, if the loop goes on.
#[inline]
pub(super) fn next(
    mesh: &Mesh,
    lists: Option<&Adjacency>,
    w: &mut Window,
    slots: Reg,
) -> Result<Option<u32>, Fault> {
    let [first, at, steps] = of_loop(slots);
    if let Some(lists) = lists {
        let next = w.id(at).wrapping_add(1);
        w.set_id(at, next);
        return Ok(if next < w.id(steps) { lists.neighbor(next) } else { None });
    }
    let before = load(mesh, HalfedgeField::Prev, w.id(at))?;
    let Some(record) = mesh.get_halfedge(HalfedgeId(before)) else {
        return Err(gone(ElementKind::Halfedge, before));
    };
    if record.twin.0 == w.id(first) {
        return Ok(None);
    }
    let step = w.int(steps).wrapping_add(1);
    if step >= mesh.capacity(ElementKind::Halfedge) as i64 {
        return Err(Fault::Endless);
    }
    w.set_id(at, record.twin.0);
    w.set_int(steps, step);
    // The twin of the next spoke is this halfedge.
    Ok(Some(record.vertex.0))
}

/// Whether a code has such a loop.
pub(super) fn are_read_by(code: &Code) -> bool {
    code.insts.iter().any(|inst| matches!(inst, Inst::NeighborsBegin { .. }))
}

/// Whether a code reads no pointers but those of such loops.
pub(super) fn are_all_that_is_read_by(code: &Code) -> bool {
    !code.insts.iter().any(|inst| {
        matches!(
            inst,
            Inst::LoadHalfedge { .. }
                | Inst::Load { .. }
                | Inst::WalkBegin { .. }
                | Inst::Ask { .. }
                | Inst::Collect { .. }
                | Inst::CollectEars { .. }
                | Inst::Meets { .. }
                | Inst::MeetsAll { .. }
                | Inst::Try { .. }
        )
    })
}

/// The lists of neighbors of a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Listed {
    /// The number of operations that had been applied when a loop last wanted the lists.
    applied: Option<u64>,
    /// Whether making the lists has been tried since then.
    are_made: bool,
    lists: Option<Arc<Adjacency>>,
}

impl Listed {
    /// The lists of a mesh, if there are any, or if they are made now: `at_once`, or if a loop wants
    /// them a second time without an operation applied in between (as the counts of the run tell).
    /// They take no more than half of `room` bytes.
    pub(super) fn wanted(
        &mut self,
        mesh: &Mesh,
        counts: &[Count],
        room: usize,
        at_once: bool,
    ) -> Option<Arc<Adjacency>> {
        let applied = Some(counts.iter().map(|count| count.applied).sum());
        let is_of_mesh =
            |lists: &Arc<Adjacency>| lists.vertices() == mesh.capacity(ElementKind::Vertex);
        let are_new = self.applied != applied || !self.lists.as_ref().is_none_or(is_of_mesh);
        if are_new {
            *self = Self { applied, ..Self::default() };
        }
        if (at_once || !are_new) && !self.are_made {
            self.are_made = true;
            let has_room = Adjacency::bytes(mesh) <= room / 2;
            self.lists = has_room.then(|| Adjacency::of(mesh)).flatten().map(Arc::new);
        }
        self.lists.clone()
    }

    /// Whether the lists could be made.
    pub(super) fn may_be_made(&self) -> bool {
        self.applied.is_some() && !self.are_made
    }
}
