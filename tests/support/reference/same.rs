//! Comparison of meshes: exactly, or up to the numbering of new elements.

use std::collections::HashMap;

use hedgerow::mesh::{ElementKind, HalfedgeId, Mesh};

/// Whether all observable data is the same, element by element: every pointer, every position, the
/// living elements and the number of slots.
pub fn identical(a: &Mesh, b: &Mesh) -> bool {
    let capacities = ElementKind::ALL
        .iter()
        .all(|&kind| a.capacity(kind) == b.capacity(kind) && a.count(kind) == b.count(kind));
    let bits = |mesh: &Mesh, v| mesh.get_position(v).map(|p| p.to_array().map(f64::to_bits));
    capacities
        && a.hole_count() == b.hole_count()
        && a.halfedges().eq(b.halfedges())
        && a.vertices().eq(b.vertices())
        && a.edges().eq(b.edges())
        && a.faces().eq(b.faces())
        && a.halfedges().all(|h| a.halfedge(h) == b.halfedge(h))
        && a.vertices().all(|v| a.vertex_halfedge(v) == b.vertex_halfedge(v))
        && a.vertices().all(|v| bits(a, v) == bits(b, v))
        && a.edges().all(|e| a.edge_halfedge(e) == b.edge_halfedge(e))
        && a.faces()
            .all(|f| a.face_halfedge(f) == b.face_halfedge(f) && a.is_hole(f) == b.is_hole(f))
}

/// Whether two meshes derived from `origin` have the same connectivity: elements of `origin` keep
/// their numbers, new ones may be numbered differently. `halfedge` pointers are ignored.
pub fn same_result(origin: &Mesh, a: &Mesh, b: &Mesh) -> bool {
    let counts = ElementKind::ALL.iter().all(|&kind| a.count(kind) == b.count(kind));
    if !counts || a.hole_count() != b.hole_count() {
        return false;
    }
    // Usually the new elements have the same numbers too.
    let plainly = a.halfedges().eq(b.halfedges())
        && a.vertices().eq(b.vertices())
        && a.edges().eq(b.edges())
        && a.faces().eq(b.faces())
        && a.halfedges().all(|h| a.halfedge(h) == b.halfedge(h))
        && a.faces().all(|f| a.is_hole(f) == b.is_hole(f));
    plainly || Renumbering::of(origin, a, b).is_some()
}

/// Whether the vertices of two meshes with the same numbering have the same positions.
pub fn same_positions(a: &Mesh, b: &Mesh) -> bool {
    a.vertices().eq(b.vertices()) && a.vertices().all(|v| a.position(v) == b.position(v))
}

struct Renumbering<'m> {
    a: &'m Mesh,
    b: &'m Mesh,
    to: HashMap<u32, u32>,
    from: HashMap<u32, u32>,
}

impl<'m> Renumbering<'m> {
    fn of(origin: &Mesh, a: &'m Mesh, b: &'m Mesh) -> Option<Self> {
        let mut renumbering = Self { a, b, to: HashMap::new(), from: HashMap::new() };
        for h in a.halfedges().filter(|&h| origin.halfedge_alive(h)) {
            if !b.halfedge_alive(h) {
                return None;
            }
            renumbering.put(h, h)?;
        }
        // New components are not connected to old elements: each is tried against each.
        let renumbering = renumbering.complete()?;
        renumbering.elements_agree(origin).then_some(renumbering)
    }

    /// Maps a halfedge, and everything that follows from it.
    fn put(&mut self, from: HalfedgeId, to: HalfedgeId) -> Option<()> {
        let mut open = vec![(from, to)];
        while let Some((from, to)) = open.pop() {
            match (self.to.get(&from.0), self.from.get(&to.0)) {
                (Some(&known), _) if known == to.0 => continue,
                (None, None) => {}
                _ => return None,
            }
            self.to.insert(from.0, to.0);
            self.from.insert(to.0, from.0);
            open.push((self.a.next(from), self.b.next(to)));
            open.push((self.a.twin(from), self.b.twin(to)));
        }
        Some(())
    }

    fn complete(self) -> Option<Self> {
        let Some(open) = self.a.halfedges().find(|h| !self.to.contains_key(&h.0)) else {
            return Some(self);
        };
        let candidates: Vec<_> =
            self.b.halfedges().filter(|h| !self.from.contains_key(&h.0)).collect();
        candidates.into_iter().find_map(|candidate| {
            let mut attempt =
                Self { a: self.a, b: self.b, to: self.to.clone(), from: self.from.clone() };
            attempt.put(open, candidate)?;
            attempt.complete()
        })
    }

    fn elements_agree(&self, origin: &Mesh) -> bool {
        let mut pairs: [HashMap<u32, u32>; 3] = Default::default();
        let old = [ElementKind::Vertex, ElementKind::Edge, ElementKind::Face];
        for (&from, &to) in &self.to {
            let (a, b) = (self.a.halfedge(HalfedgeId(from)), self.b.halfedge(HalfedgeId(to)));
            let says = [(a.vertex.0, b.vertex.0), (a.edge.0, b.edge.0), (a.face.0, b.face.0)];
            for (place, (x, y)) in says.into_iter().enumerate() {
                let known = *pairs[place].entry(x).or_insert(y);
                let both_old = [x, y].map(|id| origin.is_alive(old[place], id));
                if known != y || both_old[0] != both_old[1] || (both_old[0] && x != y) {
                    return false;
                }
            }
            if self.a.get_is_hole(a.face) != self.b.get_is_hole(b.face) {
                return false;
            }
        }
        let one_to_one = pairs.iter().all(|pairs| {
            let mut images: Vec<_> = pairs.values().collect();
            images.sort();
            images.windows(2).all(|pair| pair[0] != pair[1])
        });
        let isolated = |mesh: &Mesh| {
            let alone = mesh.vertices().filter(|&v| mesh.vertex_halfedge(v).is_none());
            alone.filter(|v| origin.vertex_alive(*v)).collect::<Vec<_>>()
        };
        one_to_one && isolated(self.a) == isolated(self.b)
    }
}
