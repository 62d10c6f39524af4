//! Phase 3 of an operation, reassign: the pointers that `after` gives to named elements, and which
//! of them change.
//!
//! The writers of the phase, as code for the machine, as C++ or Rust, or as a table, spell this
//! list and decide nothing.

use super::{Drawing, Edge, Kind, Loop, LoopItem, LoopKind, NameId, Pointer};

/// Writes in order: once, or at each index of the cycle.
#[derive(Clone, Debug)]
pub struct Reassignment {
    pub at_each_index: bool,
    pub writes: Vec<Write>,
}

/// A write to a pointer, or to those of a run of halfedges.
#[derive(Clone, Debug)]
pub enum Write {
    /// A pointer of a halfedge; one that does not change provably has the value before.
    Halfedge { pointer: Pointer, of: Operand, value: Operand, changes: bool },
    /// A pointer of a halfedge that keeps its value, whatever that is.
    AsItWas { pointer: Pointer, of: NameId },
    /// The halfedge of a vertex, an edge or a face. One that is kept stays valid, but need not be
    /// the value.
    Anchor { pointer: Pointer, of: NameId, value: Option<Operand>, keeps: bool },
    /// The face of all halfedges of a path.
    FaceAlong { path: NameId, face: NameId, changes: bool },
    /// The vertex of all spokes of a fan.
    VertexAround { fan: NameId, vertex: NameId, changes: bool },
    /// Whether a face is a hole. A new face is not one by default.
    Hole { face: NameId, is_hole: bool, changes: bool },
    /// `next` and `prev` between the paths of a loop with `each`, all of which may be empty: the
    /// nonempty ones are linked in order. Matching has tested that there is one.
    LinkPaths { face: NameId, period: Vec<NameId> },
}

/// An element that is written to, or that a pointer is set to.
#[derive(Clone, Debug)]
pub enum Operand {
    Named(NameId),
    /// The first halfedge of the first of these that is not empty; a halfedge is never empty.
    First(Vec<NameId>),
    /// The last halfedge of the first of these that is not empty.
    Last(Vec<NameId>),
    /// The first halfedge of the first nonempty path in a loop of [`Write::LinkPaths`].
    FirstLinked {
        face: NameId,
        path: NameId,
    },
    /// The first halfedge of some nonempty member of a family of paths.
    FirstOfSome(NameId),
}

impl Operand {
    /// The name that represents it: the first of those that it may be.
    pub fn name(&self) -> NameId {
        match self {
            Self::Named(name) | Self::FirstOfSome(name) => *name,
            Self::FirstLinked { path, .. } => *path,
            Self::First(items) | Self::Last(items) => items[0],
        }
    }
}

impl Drawing<'_> {
    /// All of phase 3 except for positions and attributes: loop by loop, then edges, outer
    /// halfedges, fans and vertices. The member of a family at index 0 represents all.
    pub fn reassignments(&self) -> Vec<Reassignment> {
        let rule = self.rule;
        let first = |name: &NameId| rule.is_first(*name);
        let mut list = Vec::new();
        for orbit in rule.after.loops.iter().filter(|orbit| first(&orbit.face.name)) {
            match orbit.each {
                true => self.loop_with_each(orbit, &mut list),
                false => {
                    let items = 0..orbit.items.len();
                    let mut writes: Vec<_> = items.flat_map(|at| self.item(orbit, at)).collect();
                    let items = names(orbit);
                    writes.extend(self.face(orbit, self.first_from(&items, 0)));
                    list.push(self.about(orbit.face.name, writes));
                }
            }
        }
        let edges = rule.after.edges.iter().filter(|edge| first(&edge.edge.name));
        list.extend(edges.map(|edge| self.about(edge.edge.name, self.edge(edge))));
        let outer = rule.names_of(Kind::Halfedge).filter(first);
        let outer = outer.filter(|&half| self.is_outer(half) && self.after.mention(half).is_some());
        list.extend(outer.map(|half| self.about(half, self.outer(half))));
        for fan in rule.names_of(Kind::Fan).filter(first) {
            if let Some(vertex) = self.after.star_of_spoke(fan) {
                let changes = self.before.star_of_spoke(fan) != Some(vertex);
                list.push(self.about(fan, vec![Write::VertexAround { fan, vertex, changes }]));
            }
        }
        let vertices = rule.names_of(Kind::Vertex).filter(first);
        list.extend(
            vertices.filter_map(|vertex| Some(self.about(vertex, vec![self.vertex(vertex)?]))),
        );
        list
    }

    /// Writes about a name, at each index if it is a member of a family.
    fn about(&self, name: NameId, writes: Vec<Write>) -> Reassignment {
        Reassignment { at_each_index: self.rule.is_member(name), writes }
    }

    /// A loop with `each`: the items of a period, at each index.
    fn loop_with_each(&self, orbit: &Loop, list: &mut Vec<Reassignment>) {
        let size = self.rule.size().unwrap_or(1) as usize;
        let period = orbit.items.len() / size.max(1);
        let items = names(orbit);
        let once = |writes| Reassignment { at_each_index: false, writes };
        let each = |writes| Reassignment { at_each_index: true, writes };
        let face = orbit.face.name;
        if items.iter().all(|&item| self.can_be_empty(item)) {
            list.push(once(vec![Write::LinkPaths { face, period: items[..period].to_vec() }]));
            let faces = orbit.items[..period].iter().flat_map(|item| self.lies_in(item, face));
            list.push(each(faces.collect()));
            let head = Operand::FirstLinked { face, path: items[0] };
            list.push(once(self.face(orbit, head).collect()));
        } else {
            list.push(each((0..period).flat_map(|at| self.item(orbit, at)).collect()));
            list.push(once(self.face(orbit, self.first_from(&items, 0)).collect()));
        }
    }

    fn can_be_empty(&self, item: NameId) -> bool {
        self.rule.kind(item) == Kind::Path && self.is_empty_somewhere(item)
    }

    /// The first halfedge from the item at `at` on: its own, or if it is an empty path, that of the
    /// items after it.
    fn first_from(&self, items: &[NameId], at: usize) -> Operand {
        self.there(items, at, 1, Operand::First)
    }

    /// The last halfedge up to the item at `at`.
    fn last_up_to(&self, items: &[NameId], at: usize) -> Operand {
        self.there(items, at, items.len() - 1, Operand::Last)
    }

    fn there(
        &self,
        items: &[NameId],
        at: usize,
        step: usize,
        end: impl Fn(Vec<NameId>) -> Operand,
    ) -> Operand {
        let count = items.len();
        let mut from_here = (0..count).map(|place| items[(at + place * step) % count]);
        let mut there = Vec::new();
        for item in from_here.by_ref() {
            there.push(item);
            if !self.can_be_empty(item) {
                break;
            }
        }
        match there[..] {
            [item] if self.rule.kind(item) == Kind::Halfedge => Operand::Named(item),
            _ => end(there),
        }
    }

    /// The pointers of the item at `at`, and of the start of the next one.
    fn item(&self, orbit: &Loop, at: usize) -> impl Iterator<Item = Write> {
        let items = names(orbit);
        let after = (at + 1) % items.len();
        let changes = self.before.item_after(items[at]) != Some(items[after]);
        let (last, first) = (self.last_up_to(&items, at), self.first_from(&items, after));
        let set = |pointer, of: &Operand, value: &Operand| Write::Halfedge {
            pointer,
            of: of.clone(),
            value: value.clone(),
            changes,
        };
        let links = [set(Pointer::Next, &last, &first), set(Pointer::Prev, &first, &last)];
        links.into_iter().chain(self.lies_in(&orbit.items[at], orbit.face.name))
    }

    /// The origin and the face of an item.
    fn lies_in(&self, item: &LoopItem, face: NameId) -> Vec<Write> {
        let (name, origin) = (item.item.name, item.from.name);
        let changes = self.before.face(name) != Some(face);
        if self.rule.kind(name) == Kind::Path {
            return vec![Write::FaceAlong { path: name, face, changes }];
        }
        let moves = self.before.loop_origin(name) != Some(origin);
        vec![set(Pointer::Vertex, name, origin, moves), set(Pointer::Face, name, face, changes)]
    }

    /// The halfedge of a face, and whether it is a hole. A face keeps its halfedge if nothing has
    /// left its loop.
    fn face(&self, orbit: &Loop, first: Operand) -> impl Iterator<Item = Write> {
        let face = orbit.face.name;
        let before = self.before.loop_of_face(face);
        let stays = |item: &LoopItem| self.after.face(item.item.name) == Some(face);
        let keeps = before.is_some_and(|before| before.items.iter().all(stays));
        let pointer = Pointer::FaceHalfedge;
        let anchor = Write::Anchor { pointer, of: face, value: Some(first), keeps };
        let is_hole = orbit.kind == LoopKind::Hole;
        let was = before.map(|before| before.kind);
        let is_said = orbit.kind != LoopKind::Any && was != Some(orbit.kind);
        let hole = Write::Hole { face, is_hole, changes: is_hole || was.is_some() };
        [Some(anchor), is_said.then_some(hole)].into_iter().flatten()
    }

    /// An edge and its two halfedges. It keeps its halfedge if both of them stay.
    fn edge(&self, statement: &Edge) -> Vec<Write> {
        let edge = statement.edge.name;
        let [left, right] = statement.halfedge_names();
        let mut writes = Vec::new();
        for (half, twin) in [(left, right), (right, left)] {
            let new_twin = self.before.twin(half) != Some(twin);
            writes.push(set(Pointer::Twin, half, twin, new_twin));
            let new_edge = self.before.edge(half) != Some(edge);
            writes.push(set(Pointer::Edge, half, edge, new_edge));
        }
        let keeps = self.before.edge_statement(edge).is_some_and(|before| {
            before.halfedges.iter().all(|half| half.name == left || half.name == right)
        });
        let (pointer, value) = (Pointer::EdgeHalfedge, Some(Operand::Named(left)));
        writes.push(Write::Anchor { pointer, of: edge, value, keeps });
        writes
    }

    /// An outer halfedge starts where its vertex statement, or its drawn twin, says, and stays in
    /// its loop.
    fn outer(&self, half: NameId) -> Vec<Write> {
        let mut writes = Vec::new();
        if let Some(origin) = self.origin_after(half) {
            let changes = self.origin_before(half) != Some(origin);
            writes.push(set(Pointer::Vertex, half, origin, changes));
        }
        // A path may end with it, or contain it.
        if self.rule.names_of(Kind::Path).next().is_none() {
            let pointers = [Pointer::Next, Pointer::Prev, Pointer::Face];
            writes.extend(pointers.map(|pointer| Write::AsItWas { pointer, of: half }));
        }
        writes
    }

    /// A vertex keeps its halfedge if none of its spokes has left.
    fn vertex(&self, vertex: NameId) -> Option<Write> {
        let is_drawn = self.after.mention(vertex).is_some() && self.erased(vertex).is_none();
        let keeps = self.keeps_its_spokes(vertex);
        let value = self.spoke_of(vertex);
        (is_drawn && (keeps || value.is_some())).then_some(Write::Anchor {
            pointer: Pointer::VertexHalfedge,
            of: vertex,
            value,
            keeps,
        })
    }

    /// A halfedge that starts at a vertex after: a named spoke; else the first of a path that
    /// cannot be empty; else the first of a path that may be, or of the items after it.
    fn spoke_of(&self, vertex: NameId) -> Option<Operand> {
        let rule = self.rule;
        if let Some(half) = self.spoke_after(vertex) {
            return Some(Operand::Named(half));
        }
        let path = self.path_after(vertex)?;
        if rule.is_member(path) && !rule.is_member(vertex) && self.can_be_empty(path) {
            return Some(Operand::FirstOfSome(path));
        }
        Some(self.first_from(&self.heads_after(path), 0))
    }
}

fn set(pointer: Pointer, of: NameId, value: NameId, changes: bool) -> Write {
    let (of, value) = (Operand::Named(of), Operand::Named(value));
    Write::Halfedge { pointer, of, value, changes }
}

/// The items of a loop, in order.
fn names(orbit: &Loop) -> Vec<NameId> {
    orbit.item_names().collect()
}
