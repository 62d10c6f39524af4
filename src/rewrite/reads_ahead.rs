//! Reads of the preview that guards query.
//!
//! A pointer of the preview has the value that the operation would set, or that of the mesh. The
//! values that would be set are not tracked per element: a pointer of any element may have any
//! value that is set for that pointer. So the halfedges of an orbit of the preview are in the
//! orbits of the mesh in which the walk begins, or to which such a value leads.

use super::paths::{Fields, Node, Unbounded};
use super::reads::{Nodes, Reads, State, unite};
use super::{ElementField, HalfedgeField, Inst, Walk};
use crate::mesh::OrbitCondition;
use HalfedgeField::{Face, Next, Prev, Twin, Vertex};

/// The number of a pointer of a halfedge in the preview.
fn pointer(field: HalfedgeField) -> u32 {
    field as u32
}

fn first(of: ElementField) -> u32 {
    8 + of as u32
}

impl Reads<'_> {
    /// Notes the values that would be set, and the reads of a question about the result.
    pub(super) fn look_ahead(&mut self, inst: &Inst, state: &mut State) -> Result<(), Unbounded> {
        match *inst {
            Inst::PreviewClear => state.clear_preview(),
            Inst::PreviewNew { to } => state.set(to, Nodes::new()),
            Inst::PreviewStore { field, value, .. }
            | Inst::PreviewStoreAll { field, value, .. }
            | Inst::PreviewStoreSpan { field, value, .. } => {
                let value = self.nodes(state, value)?;
                state.foresee(pointer(field), &value);
            }
            Inst::PreviewStoreHalfedge { of, value, .. } => {
                let value = self.nodes(state, value)?;
                state.foresee(first(of), &value);
            }
            Inst::Foresee { condition, to, element, at } => {
                let (element, at) = (self.nodes(state, element)?, self.nodes(state, at)?);
                self.foresee(state, condition, &element, &at)?;
                state.set(to, Nodes::new());
            }
            Inst::ForeseeAlong { condition, to, buffer } => {
                let along = self.buffered(state, buffer)?;
                let vertices = self.load_ahead(state, &along, Vertex)?;
                self.foresee(state, condition, &vertices, &vertices)?;
                state.set(to, Nodes::new());
            }
            _ => {}
        }
        Ok(())
    }

    fn foresee(
        &mut self,
        state: &State,
        condition: OrbitCondition,
        element: &[Node],
        at: &[Node],
    ) -> Result<(), Unbounded> {
        match condition {
            OrbitCondition::ThreeSides | OrbitCondition::MeetsOnce => {
                drop(self.loop_ahead(state, element)?)
            }
            OrbitCondition::CornerOnce => drop(self.star_ahead(state, at)?),
            OrbitCondition::FacesDiffer | OrbitCondition::NeighborsDiffer => {
                self.star_ahead(state, element)?;
            }
            OrbitCondition::TwoSpokes => {
                let start = self.first_ahead(state, element, ElementField::Vertex)?;
                let before = self.load_ahead(state, &start, Prev)?;
                self.load_ahead(state, &before, Twin)?;
            }
            OrbitCondition::OneHole => {
                let (_, faces) = self.star_ahead(state, element)?;
                self.read(&faces, Fields::HOLE);
            }
            OrbitCondition::SingleEdge => {
                let twin = self.load_ahead(state, element, Twin)?;
                self.load_ahead(state, &twin, Vertex)?;
                let from = self.load_ahead(state, element, Vertex)?;
                self.star_ahead(state, &from)?;
            }
            OrbitCondition::CornersDiffer => {
                let (spokes, faces) = self.star_ahead(state, element)?;
                self.read(&faces, Fields::HOLE);
                let next = self.load_ahead(state, &spokes, Next)?;
                self.load_ahead(state, &next, Next)?;
                self.loop_ahead(state, &faces)?;
            }
            OrbitCondition::CornersOwn => {
                let (_, mut faces) = self.star_ahead(state, at)?;
                unite(&mut faces, element);
                self.read(&faces, Fields::HOLE);
                self.loop_ahead(state, &faces)?;
            }
        }
        Ok(())
    }

    fn load_ahead(
        &mut self,
        state: &State,
        halfedges: &[Node],
        field: HalfedgeField,
    ) -> Result<Nodes, Unbounded> {
        let mut reached = self.load(halfedges, field)?;
        unite(&mut reached, &state.foreseen(pointer(field)));
        Ok(reached)
    }

    fn first_ahead(
        &mut self,
        state: &State,
        elements: &[Node],
        of: ElementField,
    ) -> Result<Nodes, Unbounded> {
        let mut reached = self.first(elements, of)?;
        unite(&mut reached, &state.foreseen(first(of)));
        Ok(reached)
    }

    /// The halfedges of the loops of faces; their origins are noted as read.
    fn loop_ahead(&mut self, state: &State, faces: &[Node]) -> Result<Nodes, Unbounded> {
        let mut starts = self.first_ahead(state, faces, ElementField::Face)?;
        unite(&mut starts, &state.foreseen(pointer(Next)));
        let sides = self.orbit(&starts, Walk::Loop)?;
        self.load_ahead(state, &sides, Vertex)?;
        Ok(sides)
    }

    /// The spokes of vertices and the faces there; the ends of the spokes are noted as read.
    fn star_ahead(
        &mut self,
        state: &State,
        vertices: &[Node],
    ) -> Result<(Nodes, Nodes), Unbounded> {
        let set_before = state.foreseen(pointer(Prev));
        let mut starts = self.first_ahead(state, vertices, ElementField::Vertex)?;
        // This includes all twins that would be set.
        unite(&mut starts, &self.load_ahead(state, &set_before, Twin)?);
        let spokes = self.orbit(&starts, Walk::Star)?;
        let before = self.load_ahead(state, &spokes, Prev)?;
        self.load_ahead(state, &before, Vertex)?;
        let faces = self.load_ahead(state, &spokes, Face)?;
        Ok((spokes, faces))
    }
}
