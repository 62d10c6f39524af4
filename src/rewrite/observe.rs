//! Observation of the reads and writes of an instruction, so that drains know which keys may have
//! changed.
//!
//! This runs before an instruction is executed, and only while a drain runs. Reads are noted while
//! a key is computed that has no [paths](super::paths); more may be noted than is read. Every
//! instruction is listed, so that a new one is not forgotten.

use super::access::{load, load_halfedge};
use super::attribute::{self, Held};
use super::drain::{Drains, existing};
use super::inst::group;
use super::paths::Fields;
use super::preview::Looked;
use super::readers::Place;
use super::window::Window;
use super::{ElementField, HalfedgeField, Inst, List, Question, Walk, families};
use crate::mesh::{
    ColumnId, EdgeId, ElementKind, FaceId, Footprint, HalfedgeId, HalfedgeRecord, Mesh, Orbits,
    VertexId,
};

/// The state on which an instruction is about to operate.
pub(super) struct Scene<'a, 'w> {
    pub(super) mesh: &'a Mesh,
    pub(super) w: &'a Window<'w>,
    /// The buffers of the running call.
    pub(super) buffers: &'a [List],
    pub(super) columns: &'a [Option<ColumnId>],
}

impl ElementField {
    /// The kind of the element.
    pub(super) fn kind(self) -> ElementKind {
        match self {
            ElementField::Vertex => ElementKind::Vertex,
            ElementField::Edge => ElementKind::Edge,
            ElementField::Face => ElementKind::Face,
        }
    }
}

impl Drains {
    /// Notes the writes of an instruction.
    pub(super) fn observe_write(&mut self, inst: &Inst, scene: &Scene) {
        let (mesh, w) = (scene.mesh, scene.w);
        match *inst {
            Inst::Store { field, halfedge, value } => {
                self.pointer_set(mesh, field, w.id(halfedge), w.id(value))
            }
            Inst::StoreAll { field, buffer, value } => {
                for &halfedge in
                    scene.buffers.get(usize::from(buffer)).into_iter().flat_map(|list| &**list)
                {
                    self.pointer_set(mesh, field, halfedge as u32, w.id(value));
                }
            }
            Inst::StoreSpan { field, span, index, value } => {
                let [all, ends] = [span.buffer, span.ends]
                    .map(|buffer| scene.buffers.get(usize::from(buffer)).map(|list| &**list));
                let all = all.unwrap_or_default();
                let part = families::part(all, ends.unwrap_or_default(), w.int(index), span);
                for &halfedge in part.into_iter().flatten() {
                    self.pointer_set(mesh, field, halfedge as u32, w.id(value));
                }
            }
            Inst::StoreHalfedge { of, element, value } => {
                self.first_set(mesh, of, w.id(element), w.id(value));
            }
            Inst::StoreHole { face, hole }
                if mesh.get_is_hole(FaceId(w.id(face))) != Some(hole) =>
            {
                self.flipped(mesh, w.id(face));
            }
            Inst::StorePosition { vertex, .. } => self.position_set(mesh, w.id(vertex)),
            Inst::StoreAttribute { attribute, element, .. } => {
                if let Ok(column) = attribute::column(scene.columns, attribute) {
                    self.attribute_set(mesh, (attribute, column.kind), w.id(element));
                }
            }
            Inst::WriteDeferred { buffer } => {
                let held = scene.buffers.get(usize::from(buffer)).map_or(&[][..], |list| &**list);
                for (target, id, _) in Held::new(scene.columns, held) {
                    let (kind, fields) = match target {
                        None => (ElementKind::Vertex, Fields::POSITION),
                        Some(column) => (column.kind, Fields::ATTRIBUTES),
                    };
                    self.write(mesh, kind, id, fields);
                }
            }
            Inst::Erase { kind, element } => self.erased(mesh, kind, w.id(element)),
            // Created elements are noted when they have their numbers.
            _ => {}
        }
    }

    /// Notes that a pointer of a halfedge is about to be set, if this changes it.
    pub(super) fn pointer_set(
        &mut self,
        mesh: &Mesh,
        field: HalfedgeField,
        halfedge: u32,
        value: u32,
    ) {
        if load(mesh, field, halfedge) != Ok(value) {
            self.write(mesh, ElementKind::Halfedge, halfedge, Fields::pointer(field));
        }
    }

    /// Notes that the halfedge of an element is about to be set, if this changes it.
    pub(super) fn first_set(&mut self, mesh: &Mesh, of: ElementField, element: u32, value: u32) {
        if load_halfedge(mesh, of, element) != Ok(value) {
            self.write(mesh, of.kind(), element, Fields::FIRST);
        }
    }

    /// Notes that a position is about to be set.
    pub(super) fn position_set(&mut self, mesh: &Mesh, vertex: u32) {
        self.write(mesh, ElementKind::Vertex, vertex, Fields::POSITION);
    }

    /// Notes that an attribute of an element is about to be set.
    pub(super) fn attribute_set(
        &mut self,
        mesh: &Mesh,
        (attribute, kind): (u16, ElementKind),
        element: u32,
    ) {
        self.write(mesh, kind, element, Fields::attribute(attribute));
    }

    fn read_element(&mut self, mesh: &Mesh, kind: ElementKind, id: u32) {
        if let Some(place) = existing(mesh, Place::of(kind, id)) {
            self.read(place);
        }
    }

    fn read_halfedge(&mut self, mesh: &Mesh, id: u32) {
        self.read_element(mesh, ElementKind::Halfedge, id);
    }

    /// Notes reads of a halfedge and of its origin.
    fn read_start<'m>(&mut self, mesh: &'m Mesh, id: HalfedgeId) -> Option<&'m HalfedgeRecord> {
        self.read_halfedge(mesh, id.0);
        let record = mesh.get_halfedge(id)?;
        self.read(Place::Vertex(record.vertex.0));
        Some(record)
    }

    /// Notes reads of a vertex and of its spokes with their ends, but not of the positions of the
    /// ends.
    fn read_spokes(&mut self, mesh: &Mesh, id: u32) {
        self.read(Place::Vertex(id));
        self.read(Place::VertexHalfedge(id));
        for spoke in mesh.spokes(VertexId(id)) {
            self.read_halfedge(mesh, spoke.0);
            if let Some(record) = mesh.get_halfedge(spoke) {
                for near in [record.prev, record.twin, record.next] {
                    self.read_halfedge(mesh, near.0);
                }
            }
        }
    }

    /// Notes reads of a vertex with its spokes, their ends and whether the loops around it are
    /// holes; returns these loops.
    fn read_star(&mut self, mesh: &Mesh, id: u32) -> Vec<u32> {
        self.read(Place::Vertex(id));
        self.read(Place::VertexHalfedge(id));
        let mut loops = Vec::new();
        for spoke in mesh.spokes(VertexId(id)) {
            let Some(record) = mesh.get_halfedge(spoke) else { continue };
            self.read_halfedge(mesh, spoke.0);
            self.read(Place::Face(record.face.0));
            loops.push(record.face.0);
            for near in [record.twin, record.prev, record.next] {
                self.read_start(mesh, near);
            }
        }
        loops
    }

    /// Notes reads of a loop with its corners.
    fn read_loop(&mut self, mesh: &Mesh, id: u32) {
        self.read(Place::Face(id));
        self.read(Place::FaceHalfedge(id));
        for half in mesh.face_halfedges(FaceId(id)) {
            self.read_start(mesh, half);
        }
    }

    /// Notes reads of the loops around a vertex, with their corners.
    fn read_loops_around(&mut self, mesh: &Mesh, id: u32) {
        for around in self.read_star(mesh, id) {
            self.read_loop(mesh, around);
        }
    }

    /// Notes reads of an edge with its ends and whether the loops beside it are holes; returns the
    /// ends.
    fn read_edge(&mut self, mesh: &Mesh, id: u32) -> Vec<u32> {
        self.read(Place::Edge(id));
        let half = mesh.get_edge_halfedge(EdgeId(id));
        let twin = half.and_then(|half| Some(mesh.get_halfedge(half)?.twin));
        let mut ends = Vec::new();
        for half in half.into_iter().chain(twin) {
            if let Some(record) = self.read_start(mesh, half) {
                let (vertex, face) = (record.vertex.0, record.face.0);
                self.read(Place::Face(face));
                ends.push(vertex);
            }
        }
        ends
    }

    /// Notes reads of a walk from a halfedge until one of `until`, or once around.
    fn read_walk(&mut self, mesh: &Mesh, walk: Walk, from: u32, until: [u32; 2]) {
        let mut at = from;
        for _ in 0..mesh.capacity(ElementKind::Halfedge) {
            self.read_halfedge(mesh, at);
            let Some(record) = mesh.get_halfedge(HalfedgeId(at)) else { return };
            at = match walk {
                Walk::Loop => record.next.0,
                Walk::Star => {
                    self.read_halfedge(mesh, record.prev.0);
                    match mesh.get_halfedge(record.prev) {
                        Some(prev) => prev.twin.0,
                        None => return,
                    }
                }
            };
            if at == from || until.contains(&at) {
                return;
            }
        }
    }

    /// Notes the reads of an instruction.
    pub(super) fn observe_read(&mut self, inst: &Inst, scene: &Scene) {
        let (mesh, w) = (scene.mesh, scene.w);
        match *inst {
            Inst::Load { halfedge, .. } => self.read_halfedge(mesh, w.id(halfedge)),
            Inst::LoadHalfedge { of, element, .. } => {
                self.read(Place::first_of(of.kind(), w.id(element)))
            }
            Inst::LoadHole { face, .. } => self.read(Place::Face(w.id(face))),
            Inst::LoadPosition { vertex, .. } => self.read(Place::Vertex(w.id(vertex))),
            Inst::LoadAttribute { attribute, element, .. } => {
                if let Ok(column) = attribute::column(scene.columns, attribute)
                    && let Some(place) =
                        existing(mesh, Place::attributes_of(column.kind, w.id(element)))
                {
                    self.read(place);
                }
            }
            Inst::JumpUnlessLiving { of, element, .. } => {
                self.read_living(mesh, of.kind(), w.id(element));
            }
            Inst::Alive { kind, element, .. } => self.read_living(mesh, kind, w.id(element)),
            // The result also depends on which vertices are adjacent.
            Inst::CollectEars { .. }
            | Inst::Capacity { .. }
            | Inst::NextLiving { .. }
            | Inst::BufferLiving { .. }
            | Inst::Spread { .. }
            | Inst::Count { .. }
            | Inst::CountHoles { .. } => self.read(Place::Whole),
            Inst::Ask { question, elements: [first, second], .. } => {
                self.read_for(question, mesh, [w.id(first), w.id(second)])
            }
            Inst::Collect { walk, from, until, .. } => {
                let until = w.id(until);
                self.read_walk(mesh, walk, w.id(from), [until, until]);
            }
            Inst::WalkBegin { walk, from, .. } => {
                let from = w.id(from);
                if from != u32::MAX {
                    self.read_walk(mesh, walk, from, [from; 2]);
                }
            }
            Inst::NeighborsBegin { vertex, .. } => {
                let vertex = VertexId(w.id(vertex));
                self.read(Place::first_of(ElementKind::Vertex, vertex.0));
                match mesh.get_vertex_halfedge(vertex) {
                    None | Some(HalfedgeId::NONE) => {}
                    Some(HalfedgeId(from)) => self.read_walk(mesh, Walk::Star, from, [from; 2]),
                }
            }
            Inst::Meets { walk, from, goal, stop, .. } => {
                self.read_walk(mesh, walk, w.id(from), [w.id(goal), w.id(stop)])
            }
            Inst::MeetsAll { walk, buffer, .. } => {
                let walked = scene.buffers.get(usize::from(buffer));
                if let Some(&from) = walked.and_then(|all| all.first()) {
                    self.read_walk(mesh, walk, from as u32, [from as u32; 2]);
                }
            }
            // The preview records its own reads.
            Inst::Foresee { .. } | Inst::ForeseeAlong { .. } => {}
            // These use registers, buffers and output only, write, or occur in ops only.
            #[rustfmt::skip]
            group!(computes) | group!(expects) | group!(previews) | group!(writes)
            | group!(defers) | group!(prints) | group!(scripts) | Inst::Const { .. }
            | Inst::Copy { .. } | Inst::Select { .. } | Inst::Refuse | Inst::Return { .. }
            | Inst::BufferClear { .. } | Inst::BufferPush { .. } | Inst::BufferLength { .. }
            | Inst::BufferFree { .. } | Inst::Keep { .. } | Inst::BufferGet { .. }
            | Inst::BufferNext { .. } | Inst::Prefetch { .. } | Inst::Recycle | Inst::Try { .. }
            | Inst::Random { .. } | Inst::RandomInt { .. } | Inst::BufferShuffle { .. }
            | Inst::Iteration { .. } | Inst::Tick | Inst::ExpectAlive { .. } | Inst::Call { .. }
            | Inst::NextIndex { .. } | Inst::Member { .. } | Inst::BufferGetWide { .. }
            | Inst::BufferAppend { .. } | Inst::BufferStride { .. } | Inst::WalkNext { .. }
            | Inst::NeighborsNext { .. } => {}
        }
    }

    /// Notes the reads of a preview.
    pub(super) fn foreseen(&mut self, mesh: &Mesh, looked: &[Looked]) {
        for &looked in looked {
            match looked {
                Looked::Halfedge(id) => self.read_halfedge(mesh, id),
                Looked::HalfedgeOf(of, id) => self.read(Place::first_of(of.kind(), id)),
                Looked::Hole(face) => self.read(Place::Face(face)),
            }
        }
    }

    /// Notes the reads of the check that a mesh still has its level after these changes.
    pub(super) fn read_level(&mut self, mesh: &Mesh, changes: &Footprint) {
        let Orbits { vertices, edges, faces } = Orbits::near(mesh, changes);
        for vertex in vertices {
            self.read_star(mesh, vertex.0);
        }
        for edge in edges {
            self.read_edge(mesh, edge.0);
        }
        for face in faces {
            self.read_loop(mesh, face.0);
            if let Some(corner) = mesh.face_vertices(face).min() {
                self.read_loops_around(mesh, corner.0);
            }
        }
    }

    fn read_for(&mut self, question: Question, mesh: &Mesh, [first, second]: [u32; 2]) {
        match question {
            Question::Degree => self.read_spokes(mesh, first),
            Question::BoundaryVertex => {
                self.read_star(mesh, first);
            }
            Question::Adjacent => {
                self.read_spokes(mesh, first);
                self.read_spokes(mesh, second);
            }
            Question::NormalVertex => self.read_loops_around(mesh, first),
            Question::BoundaryEdge | Question::LengthEdge => {
                self.read_edge(mesh, first);
            }
            Question::LinkCondition | Question::StarShaped | Question::KernelCentroid => {
                for end in self.read_edge(mesh, first) {
                    self.read_loops_around(mesh, end);
                }
            }
            Question::FaceSize | Question::Area | Question::NormalFace | Question::CentroidFace => {
                self.read_loop(mesh, first)
            }
        }
    }

    /// Notes a read of whether an element lives; an erased element has no place of its own.
    fn read_living(&mut self, mesh: &Mesh, kind: ElementKind, id: u32) {
        match mesh.is_alive(kind, id) {
            true => self.read_element(mesh, kind, id),
            false => self.read(Place::Whole),
        }
    }
}
