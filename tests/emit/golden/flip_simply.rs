use std::collections::HashMap;
use hedgerow::mesh::{EdgeId, FaceId, HalfedgeId, Mesh, VertexId};

/// The same, and edges stay told by their ends.
#[allow(non_snake_case)]
pub fn flip_simply(mesh: &mut Mesh, e: EdgeId) -> bool {
    // 1. Collect: nothing is written before all of this has passed.
    // Both directions of e are tried.
    for a in [mesh.edge_halfedge(e), mesh.twin(mesh.edge_halfedge(e))] {
        let b = mesh.next(a);
        let d = mesh.twin(a);
        let g = mesh.next(d);
        let f0 = mesh.face(a);
        let v0 = mesh.vertex(a);
        let v1 = mesh.vertex(d);
        let v2 = mesh.vertex(mesh.next(b));
        let f1 = mesh.face(d);
        let v3 = mesh.vertex(mesh.next(g));
        let P_first = mesh.next(b);
        let P_last = mesh.prev(a);
        let Q_first = mesh.next(g);
        let Q_last = mesh.prev(d);
        if mesh.is_hole(f0) {
            continue; // `f0` is a hole
        }
        if mesh.is_hole(f1) {
            continue; // `f1` is a hole
        }
        if v0 == v1 {
            continue; // `v0` and `v1` are one vertex
        }
        if v0 == v2 {
            continue; // `v0` and `v2` are one vertex
        }
        if v0 == v3 {
            continue; // `v0` and `v3` are one vertex
        }
        if v1 == v2 {
            continue; // `v1` and `v2` are one vertex
        }
        if v1 == v3 {
            continue; // `v1` and `v3` are one vertex
        }
        if f0 == f1 {
            continue; // `f0` and `f1` are one face
        }
        // The guard looks at what there would be, on a preview of the mesh.
        {
            let mut preview = Preview::new(mesh);
            preview.set_next(a, P_first);
            preview.set_vertex(a, v3);
            preview.set_next(b, d);
            preview.set_face(b, f1);
            preview.set_next(P_last, g);
            preview.set_next(d, Q_first);
            preview.set_vertex(d, v2);
            preview.set_next(g, a);
            preview.set_face(g, f0);
            preview.set_next(Q_last, b);
            preview.set_vertex_halfedge(v0, g);
            preview.set_vertex_halfedge(v1, b);
            preview.set_face_halfedge(f0, a);
            preview.set_face_halfedge(f1, d);
            if !preview.two_spokes(v0) {
                continue; // `v0` would keep a single edge
            }
            if !preview.two_spokes(v1) {
                continue; // `v1` would keep a single edge
            }
            if !preview.corner_once(f0, v3) {
                continue; // `f0` would meet `v3` twice
            }
            if !preview.corner_once(f1, v2) {
                continue; // `f1` would meet `v2` twice
            }
            if !preview.single_edge(a) {
                continue; // two edges would join `v2` and `v3`
            }
            if !preview.corners_own(f0, v3) {
                continue; // another face has the corners that `f0` would have
            }
            if !preview.corners_own(f1, v2) {
                continue; // another face has the corners that `f1` would have
            }
            if !preview.meets_once(f0) {
                continue; // `f0` would meet a vertex twice
            }
            if !preview.meets_once(f1) {
                continue; // `f1` would meet a vertex twice
            }
            if !preview.corners_own(f0, v2) {
                continue; // another face has the corners that `f0` would have
            }
        }

        // 3. Reassign every pointer that changes.
        mesh.set_next(a, P_first);
        mesh.set_prev(a, g);
        mesh.set_vertex(a, v3);
        mesh.set_next(b, d);
        mesh.set_prev(b, Q_last);
        mesh.set_face(b, f1);
        mesh.set_next(P_last, g);
        mesh.set_prev(P_first, a);
        mesh.set_next(d, Q_first);
        mesh.set_prev(d, b);
        mesh.set_vertex(d, v2);
        mesh.set_next(g, a);
        mesh.set_prev(g, P_last);
        mesh.set_face(g, f0);
        mesh.set_next(Q_last, b);
        mesh.set_prev(Q_first, d);
        mesh.set_vertex_halfedge(v0, g);
        mesh.set_vertex_halfedge(v1, b);
        mesh.set_face_halfedge(f0, a);
        mesh.set_face_halfedge(f1, d);
        return true;
    }
    false
}

/// A preview of the mesh after an operation: the changes noted here, on top of the mesh. The
/// operation tests its result on it before anything is written.
struct Preview<'m> {
    mesh: &'m Mesh,
    new: u32,
    next: Notes<HalfedgeId, HalfedgeId>,
    twin: Notes<HalfedgeId, HalfedgeId>,
    vertex: Notes<HalfedgeId, VertexId>,
    face: Notes<HalfedgeId, FaceId>,
    vertex_halfedge: Notes<VertexId, HalfedgeId>,
    face_halfedge: Notes<FaceId, HalfedgeId>,
    holes: Notes<FaceId, bool>,
}

#[allow(dead_code)]
impl<'m> Preview<'m> {
    fn new(mesh: &'m Mesh) -> Self {
        Self {
            mesh,
            new: u32::MAX,
            next: Notes::new(),
            twin: Notes::new(),
            vertex: Notes::new(),
            face: Notes::new(),
            vertex_halfedge: Notes::new(),
            face_halfedge: Notes::new(),
            holes: Notes::new(),
        }
    }

    /// A number from the top of the range, which no element of the mesh has.
    fn number(&mut self) -> u32 {
        self.new -= 1;
        self.new
    }

    fn add_vertex(&mut self) -> VertexId {
        VertexId(self.number())
    }

    fn add_halfedge(&mut self) -> HalfedgeId {
        HalfedgeId(self.number())
    }

    /// A new face, which is not a hole.
    fn add_face(&mut self) -> FaceId {
        let face = FaceId(self.number());
        self.set_hole(face, false);
        face
    }

    fn set_next(&mut self, h: HalfedgeId, to: HalfedgeId) {
        self.next.set(h, to);
    }

    fn set_twin(&mut self, h: HalfedgeId, to: HalfedgeId) {
        self.twin.set(h, to);
    }

    fn set_vertex(&mut self, h: HalfedgeId, to: VertexId) {
        self.vertex.set(h, to);
    }

    fn set_face(&mut self, h: HalfedgeId, to: FaceId) {
        self.face.set(h, to);
    }

    fn set_vertex_halfedge(&mut self, v: VertexId, to: HalfedgeId) {
        self.vertex_halfedge.set(v, to);
    }

    fn set_face_halfedge(&mut self, f: FaceId, to: HalfedgeId) {
        self.face_halfedge.set(f, to);
    }

    fn set_hole(&mut self, f: FaceId, hole: bool) {
        self.holes.set(f, hole);
    }

    fn next(&self, h: HalfedgeId) -> HalfedgeId {
        self.next.get(h).unwrap_or_else(|| self.mesh.next(h))
    }

    fn twin(&self, h: HalfedgeId) -> HalfedgeId {
        self.twin.get(h).unwrap_or_else(|| self.mesh.twin(h))
    }

    fn vertex(&self, h: HalfedgeId) -> VertexId {
        self.vertex.get(h).unwrap_or_else(|| self.mesh.vertex(h))
    }

    fn face(&self, h: HalfedgeId) -> FaceId {
        self.face.get(h).unwrap_or_else(|| self.mesh.face(h))
    }

    fn is_hole(&self, f: FaceId) -> bool {
        self.holes.get(f).unwrap_or_else(|| self.mesh.is_hole(f))
    }

    fn first_of(&self, v: VertexId) -> HalfedgeId {
        self.vertex_halfedge.get(v).unwrap_or_else(|| self.mesh.vertex_halfedge(v))
    }

    /// The halfedges that start at a vertex.
    fn star(&self, v: VertexId) -> Vec<HalfedgeId> {
        let first = self.first_of(v);
        let mut around = Vec::new();
        let mut h = first;
        while !h.is_none() {
            around.push(h);
            h = self.next(self.twin(h));
            if h == first {
                break;
            }
        }
        around
    }

    fn first_along(&self, f: FaceId) -> HalfedgeId {
        self.face_halfedge.get(f).unwrap_or_else(|| self.mesh.face_halfedge(f))
    }

    /// The corners of a face.
    fn corners(&self, f: FaceId) -> Vec<VertexId> {
        let first = self.first_along(f);
        let mut around = vec![self.vertex(first)];
        let mut h = self.next(first);
        while h != first {
            around.push(self.vertex(h));
            h = self.next(h);
        }
        around
    }

    /// The corners of a face, sorted, so that those of two faces can be compared.
    fn sorted_corners(&self, f: FaceId) -> Vec<VertexId> {
        let mut corners = self.corners(f);
        corners.sort_unstable();
        corners
    }

    fn differ<T: Ord>(mut all: Vec<T>) -> bool {
        all.sort_unstable();
        all.windows(2).all(|two| two[0] != two[1])
    }

    /// Whether a face or hole has three sides or more.
    fn three_sides(&self, f: FaceId) -> bool {
        let first = self.first_along(f);
        let second = self.next(first);
        second != first && self.next(second) != first
    }

    /// Whether no vertex is two corners of a face.
    fn meets_once(&self, f: FaceId) -> bool {
        Self::differ(self.corners(f))
    }

    /// Whether a face has no more than one corner at a vertex.
    fn corner_once(&self, f: FaceId, v: VertexId) -> bool {
        self.star(v).into_iter().filter(|&h| self.face(h) == f).count() <= 1
    }

    /// Whether a vertex has two edges or more, or none.
    fn two_spokes(&self, v: VertexId) -> bool {
        let first = self.first_of(v);
        first.is_none() || self.next(self.twin(first)) != first
    }

    /// Whether no more than one corner of a vertex lies in a hole.
    fn one_hole(&self, v: VertexId) -> bool {
        self.star(v).into_iter().filter(|&h| self.is_hole(self.face(h))).count() <= 1
    }

    /// Whether `one_hole` is true where the halfedges of the mesh from `first` up to `until`
    /// start; of the whole loop if these are the same.
    fn one_hole_along(&self, first: HalfedgeId, until: HalfedgeId) -> bool {
        let mut h = first;
        loop {
            if !self.one_hole(self.vertex(h)) {
                return false;
            }
            h = self.mesh.next(h);
            if h == until {
                return true;
            }
        }
    }

    /// Whether no face has two corners at a vertex.
    fn faces_differ(&self, v: VertexId) -> bool {
        Self::differ(self.star(v).into_iter().map(|h| self.face(h)).collect())
    }

    fn target(&self, h: HalfedgeId) -> VertexId {
        self.vertex(self.twin(h))
    }

    /// Whether no two edges lead from a vertex to one neighbor.
    fn neighbors_differ(&self, v: VertexId) -> bool {
        Self::differ(self.star(v).into_iter().map(|h| self.target(h)).collect())
    }

    /// Whether no other edge joins the ends of a halfedge.
    fn single_edge(&self, h: HalfedgeId) -> bool {
        let (star, end) = (self.star(self.vertex(h)), self.target(h));
        star.into_iter().filter(|&h| self.target(h) == end).count() <= 1
    }

    /// Whether no two faces around a vertex have the same corners.
    fn corners_differ(&self, v: VertexId) -> bool {
        let faces = self.star(v).into_iter().map(|h| self.face(h));
        let faces = faces.filter(|&f| !self.is_hole(f));
        Self::differ(faces.map(|f| self.sorted_corners(f)).collect())
    }

    /// Whether no other face around a vertex has the same corners as a face.
    fn corners_own(&self, f: FaceId, v: VertexId) -> bool {
        let others = self.star(v).into_iter().map(|h| self.face(h));
        let mut others = others.filter(|&other| other != f && !self.is_hole(other));
        self.is_hole(f) || others.all(|other| self.sorted_corners(other) != self.sorted_corners(f))
    }
}

/// Values noted for elements: the first few in a list, the others in a map.
struct Notes<K, V> {
    few: Vec<(K, V)>,
    more: HashMap<K, V>,
}

impl<K: Copy + Eq + std::hash::Hash, V: Copy> Notes<K, V> {
    fn new() -> Self {
        Self { few: Vec::new(), more: HashMap::new() }
    }

    fn set(&mut self, of: K, value: V) {
        if let Some(known) = self.few.iter_mut().find(|known| known.0 == of) {
            known.1 = value;
        } else if self.few.len() < 16 {
            self.few.push((of, value));
        } else {
            self.more.insert(of, value);
        }
    }

    fn get(&self, of: K) -> Option<V> {
        let known = self.few.iter().find(|known| known.0 == of);
        known.map(|known| known.1).or_else(|| self.more.get(&of).copied())
    }
}
