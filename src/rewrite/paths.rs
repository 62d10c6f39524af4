//! The paths along which a key reaches its reads, and the walk back along them.
//!
//! A key is an expression in one element: each read is at the end of a path of pointers and of
//! loops around orbits that begins at that element. On a valid mesh each step can be inverted:
//!
//! ```text
//! h.next  <- its prev         h.vertex <- the spokes of the vertex    v.halfedge <- its vertex
//! h.prev  <- its next         h.face   <- the loop of the face        f.halfedge <- its face
//! h.twin  <- its twin         h.edge   <- both halves of the edge     e.halfedge <- its edge
//! a loop around an orbit <- the orbit
//! ```
//!
//! So from an element in which a field was written, the walk back along each path that ends at that
//! field finds the elements whose keys may have changed. All other keys are unchanged.
//!
//! This is complete although the walk uses the mesh after the writes. Proof: take a key that
//! changes, and the first of its reads that returns another value than before. All earlier reads
//! returned the same values, so the path up to this read is the same before and after the writes:
//! on the current mesh it leads to the element that is read, and the walk back from there finds the
//! key. An erased element is reached by no path except that of a variable that still holds it, and
//! a created element counts as written in every field.
//!
//! The paths of a key form a tree: its root is the element, its nodes are sets of elements, and
//! each step leads from one node to another. A step and its inverse cancel. Repeating `next`, or
//! turning around a vertex, stays in one orbit, and so in one node. A key that otherwise follows
//! pointers without bound has no tree.
//!
//! All this also holds for the question whether an operation would be applied, in place of a key.

use std::fmt;

use super::distinct::Seen;
use super::{ElementField, HalfedgeField, Reg, Walk};
use crate::mesh::{EdgeId, ElementKind, FaceId, HalfedgeId, Mesh, VertexId};

/// The greatest number of steps of a path.
const MOST_STEPS: u16 = 32;

/// The greatest number of nodes of a tree.
const MOST_NODES: usize = 500;

/// The reason why a key has no tree of paths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unbounded {
    /// It follows pointers in a loop with a condition, or along too many paths.
    Endless,
    /// It reads the whole mesh.
    WholeMesh,
    /// A function in it calls itself.
    Recursion,
    /// It takes random numbers.
    Random,
    /// It asks an operation that consists of steps.
    Steps,
    /// It does more than compute a value.
    Effects,
}

impl fmt::Display for Unbounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Endless => "the key follows pointers without bound",
            Self::WholeMesh => "the key reads all of the mesh",
            Self::Recursion => "a function in the key calls itself",
            Self::Random => "the key takes random numbers",
            Self::Steps => "the key asks an op that consists of steps",
            Self::Effects => "the key does more than to compute a value",
        })
    }
}

/// A set of fields of an element of some kind, one bit for each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Fields(u32);

impl Fields {
    pub(super) const NONE: Self = Self(0);
    pub(super) const ALL: Self = Self(u32::MAX);
    /// The `halfedge` of a vertex, an edge or a face.
    pub(super) const FIRST: Self = Self(1 << 6);
    pub(super) const HOLE: Self = Self(1 << 7);
    pub(super) const POSITION: Self = Self(1 << 8);
    /// Whether the element exists.
    pub(super) const LIFE: Self = Self(1 << 9);
    /// All declared attributes.
    pub(super) const ATTRIBUTES: Self = Self(!0 << Self::BEFORE_ATTRIBUTES);
    const BEFORE_ATTRIBUTES: u16 = 10;

    /// The bits of the set.
    #[cfg(feature = "native")]
    pub(super) fn bits(self) -> u32 {
        self.0
    }

    /// A pointer of a halfedge.
    pub(super) fn pointer(field: HalfedgeField) -> Self {
        Self(1 << field as u32)
    }

    /// Whether the set is not empty and has attributes only.
    pub(super) fn are_attributes(self) -> bool {
        self.0 != 0 && self.0 & !Self::ATTRIBUTES.0 == 0
    }

    /// A declared attribute. Attributes with high numbers share a bit.
    pub(super) fn attribute(number: u16) -> Self {
        Self(1 << number.saturating_add(Self::BEFORE_ATTRIBUTES).min(31))
    }

    #[inline]
    pub(super) fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    #[inline]
    pub(super) fn add(&mut self, other: Self) {
        self.0 |= other.0;
    }
}

/// A step of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// The element whose key is computed.
    Start,
    /// The element that a variable holds.
    Variable(Reg),
    Pointer(HalfedgeField),
    /// To the `halfedge` of an element.
    First(ElementField),
    /// To each halfedge of the loop or star.
    Orbit(Walk),
}

impl HalfedgeField {
    /// The pointer of the inverse step, if that is a single pointer.
    fn inverse(self) -> Option<Self> {
        match self {
            Self::Next => Some(Self::Prev),
            Self::Prev => Some(Self::Next),
            Self::Twin => Some(Self::Twin),
            Self::Vertex | Self::Edge | Self::Face => None,
        }
    }
}

/// The number of a node.
pub(super) type Node = u16;

#[derive(Clone, Copy, Debug)]
struct Place {
    parent: Node,
    step: Step,
    depth: u16,
    /// The kind of the elements; `None` if it is not known: a variable may hold any kind.
    kind: Option<ElementKind>,
    /// The fields of the elements at the node that are read.
    reads: Fields,
}

/// The tree of the paths of a key, or of a question.
#[derive(Clone, Debug, Default)]
pub(super) struct Paths {
    places: Vec<Place>,
    /// The nodes where something is read, by kind.
    readers: [Vec<Node>; 4],
    /// All fields that are read, by kind.
    read: [Fields; 4],
}

/// The root of the tree.
pub(super) const START: Node = 0;

impl Paths {
    /// The paths of a key of an element of the given kind that reads nothing so far.
    pub(super) fn new(kind: ElementKind) -> Self {
        let (kind, reads) = (Some(kind), Fields::NONE);
        let start = Place { parent: START, step: Step::Start, depth: 0, kind, reads };
        Self { places: vec![start], readers: Default::default(), read: Default::default() }
    }

    /// The node to which a step leads from `parent`.
    pub(super) fn child(&mut self, parent: Node, step: Step) -> Result<Node, Unbounded> {
        // A step and its inverse cancel.
        let from = self.places[usize::from(parent)];
        if let (Step::Pointer(there), Step::Pointer(back)) = (from.step, step)
            && there.inverse() == Some(back)
        {
            return Ok(from.parent);
        }
        let (parent, step) = match self.orbit_of(parent, step) {
            Some((orbit, None)) => return Ok(orbit),
            Some((start, Some(walk))) => (start, Step::Orbit(walk)),
            None => (parent, step),
        };
        let known = |place: &Place| place.parent == parent && place.step == step;
        if let Some(known) = self.places.iter().skip(1).position(known) {
            return Ok(known as Node + 1);
        }
        let from = self.places[usize::from(parent)];
        let kind = match step {
            Step::Pointer(HalfedgeField::Vertex) => Some(ElementKind::Vertex),
            Step::Pointer(HalfedgeField::Edge) => Some(ElementKind::Edge),
            Step::Pointer(HalfedgeField::Face) => Some(ElementKind::Face),
            Step::Pointer(_) | Step::First(_) | Step::Orbit(_) => Some(ElementKind::Halfedge),
            Step::Start | Step::Variable(_) => None,
        };
        if from.depth >= MOST_STEPS || self.places.len() >= MOST_NODES {
            return Err(Unbounded::Endless);
        }
        self.places.push(Place { parent, step, depth: from.depth + 1, kind, reads: Fields::NONE });
        Ok(self.places.len() as Node - 1)
    }

    /// If a step from a node stays in an orbit: the node of the orbit, or, when the same steps have
    /// been taken three times, the node where the walk around the orbit starts.
    fn orbit_of(&self, parent: Node, step: Step) -> Option<(Node, Option<Walk>)> {
        use HalfedgeField::{Next, Prev, Twin};
        let turns: [(Walk, &[HalfedgeField]); 4] = [
            (Walk::Loop, &[Next]),
            (Walk::Loop, &[Prev]),
            (Walk::Star, &[Prev, Twin]),
            (Walk::Star, &[Twin, Next]),
        ];
        let at = |node: Node| self.places[usize::from(node)];
        turns.into_iter().find_map(|(walk, fields)| {
            let (last, before) = fields.split_last()?;
            let back = |from: Node, fields: &[HalfedgeField]| {
                fields.iter().rev().try_fold(from, |node, &field| {
                    (at(node).step == Step::Pointer(field)).then(|| at(node).parent)
                })
            };
            let once = back(parent, before).filter(|_| step == Step::Pointer(*last))?;
            match at(once).step == Step::Orbit(walk) {
                true => Some((once, None)),
                false => Some((back(back(once, fields)?, fields)?, Some(walk))),
            }
        })
    }

    /// The node of the element that a variable holds.
    pub(super) fn variable(&mut self, variable: Reg) -> Result<Node, Unbounded> {
        self.child(START, Step::Variable(variable))
    }

    /// Notes that fields are read of the elements at a node.
    pub(super) fn read(&mut self, node: Node, fields: Fields) {
        self.places[usize::from(node)].reads.add(fields);
    }

    /// Indexes the nodes by the kinds of the elements that are read; no read is noted after that.
    pub(super) fn finish(&mut self) {
        for (node, place) in (0..).zip(&self.places) {
            let of = |kind: &ElementKind| place.kind.is_none_or(|this| this == *kind);
            for kind in ElementKind::ALL.into_iter().filter(of) {
                if place.reads != Fields::NONE {
                    self.readers[kind as usize].push(node);
                    self.read[kind as usize].add(place.reads);
                }
            }
        }
    }

    /// All fields that are read, by kind.
    #[cfg(feature = "native")]
    pub(super) fn all_read(&self) -> [Fields; 4] {
        self.read
    }

    /// Whether any of the fields is read of any element of the kind.
    #[inline]
    pub(super) fn concern(&self, kind: ElementKind, fields: Fields) -> bool {
        self.read[kind as usize].meets(fields)
    }
}

/// An element in which fields were written.
#[derive(Clone, Copy, Debug)]
pub(super) struct Written {
    pub(super) kind: ElementKind,
    pub(super) id: u32,
    pub(super) fields: Fields,
}

/// The buffers of a walk back, kept for reuse.
#[derive(Debug, Default)]
pub(super) struct WalkBack {
    /// By node, the elements from which the walk continues.
    found: Vec<Vec<u32>>,
    orbits: Vec<u32>,
    seen: Seen,
}

/// Removes duplicates from a list.
fn leave_once(seen: &mut Seen, list: &mut Vec<u32>) {
    if list.len() > 1 {
        seen.clear();
        list.retain(|&id| seen.is_new(id));
    }
}

/// The elements whose keys may have changed.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Candidates<'w> {
    All,
    These(&'w [u32]),
}

impl WalkBack {
    /// Walks back from the written elements. `held` returns the element that a variable holds.
    pub(super) fn candidates(
        &mut self,
        mesh: &Mesh,
        paths: &Paths,
        written: &[Written],
        held: impl Fn(Reg) -> u32,
    ) -> Candidates<'_> {
        self.found.iter_mut().for_each(Vec::clear);
        if self.found.len() < paths.places.len() {
            self.found.resize_with(paths.places.len(), Vec::new);
        }
        for one in written {
            for &node in &paths.readers[one.kind as usize] {
                if paths.places[usize::from(node)].reads.meets(one.fields) {
                    self.found[usize::from(node)].push(one.id);
                }
            }
        }
        // Every node has a greater number than its parent.
        for (node, place) in paths.places.iter().enumerate().skip(1).rev() {
            if self.found[node].is_empty() {
                continue;
            }
            let (before, from) = self.found.split_at_mut(node);
            let from = &mut from[0];
            if let Step::Variable(variable) = place.step {
                if from.contains(&held(variable)) {
                    return Candidates::All;
                }
                continue;
            }
            let to = &mut before[usize::from(place.parent)];
            if place.kind.is_some() {
                leave_once(&mut self.seen, from);
            }
            step_back(mesh, place.step, from, to, (&mut self.orbits, &mut self.seen));
        }
        let start = &mut self.found[usize::from(START)];
        start.sort_unstable();
        start.dedup();
        Candidates::These(start)
    }
}

/// Appends to `to` the elements from which a step leads to those in `from`.
fn step_back(
    mesh: &Mesh,
    step: Step,
    from: &[u32],
    to: &mut Vec<u32>,
    (orbits, seen): (&mut Vec<u32>, &mut Seen),
) {
    let halfedges = || from.iter().filter_map(|&id| Some((id, mesh.get_halfedge(HalfedgeId(id))?)));
    let vertices = |all: &[u32], to: &mut Vec<u32>| {
        for &vertex in all {
            to.extend(mesh.spokes(VertexId(vertex)).map(|h| h.0));
        }
    };
    let faces = |all: &[u32], to: &mut Vec<u32>| {
        for &face in all {
            to.extend(mesh.face_halfedges(FaceId(face)).map(|h| h.0));
        }
    };
    match step {
        Step::Start | Step::Variable(_) => {}
        Step::Pointer(HalfedgeField::Next) => to.extend(halfedges().map(|(_, h)| h.prev.0)),
        Step::Pointer(HalfedgeField::Prev) => to.extend(halfedges().map(|(_, h)| h.next.0)),
        Step::Pointer(HalfedgeField::Twin) => to.extend(halfedges().map(|(_, h)| h.twin.0)),
        Step::Pointer(HalfedgeField::Vertex) => vertices(from, to),
        Step::Pointer(HalfedgeField::Face) => faces(from, to),
        Step::Pointer(HalfedgeField::Edge) => {
            for &edge in from {
                if let Some(half) = mesh.get_edge_halfedge(EdgeId(edge)) {
                    to.push(half.0);
                    to.extend(mesh.get_twin(half).map(|twin| twin.0));
                }
            }
        }
        Step::First(ElementField::Vertex) => to.extend(halfedges().filter_map(|(id, h)| {
            (mesh.get_vertex_halfedge(h.vertex) == Some(HalfedgeId(id))).then_some(h.vertex.0)
        })),
        Step::First(ElementField::Edge) => to.extend(halfedges().filter_map(|(id, h)| {
            (mesh.get_edge_halfedge(h.edge) == Some(HalfedgeId(id))).then_some(h.edge.0)
        })),
        Step::First(ElementField::Face) => to.extend(halfedges().filter_map(|(id, h)| {
            (mesh.get_face_halfedge(h.face) == Some(HalfedgeId(id))).then_some(h.face.0)
        })),
        Step::Orbit(walk) => {
            orbits.clear();
            orbits.extend(halfedges().map(|(_, h)| match walk {
                Walk::Star => h.vertex.0,
                Walk::Loop => h.face.0,
            }));
            leave_once(seen, orbits);
            match walk {
                Walk::Star => vertices(orbits, to),
                Walk::Loop => faces(orbits, to),
            }
        }
    }
}
