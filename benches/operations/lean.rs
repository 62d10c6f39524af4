//! A minimal halfedge mesh: arrays of numbers, with the twin of `h` at `h ^ 1`.
//!
//! It supports no boundary, never reuses a number, and tests only what each operation needs.

use glam::DVec3;
use hedgerow::mesh::Mesh;

const NONE: u32 = u32::MAX;

#[derive(Clone)]
pub struct Lean {
    next: Vec<u32>,
    prev: Vec<u32>,
    vertex: Vec<u32>,
    face: Vec<u32>,
    vertex_halfedge: Vec<u32>,
    face_halfedge: Vec<u32>,
    positions: Vec<DVec3>,
    /// By vertex: the edge whose collapse visited it last.
    met: Vec<u32>,
}

impl Lean {
    /// Edge `e` of the mesh has the halfedges `2 e` and `2 e + 1`.
    pub fn new(mesh: &Mesh) -> Self {
        let mut number = vec![NONE; mesh.halfedge_count()];
        for (e, edge) in (0..).zip(mesh.edges()) {
            let h = mesh.edge_halfedge(edge);
            number[h.index()] = 2 * e;
            number[mesh.twin(h).index()] = 2 * e + 1;
        }
        let mut lean = Self {
            next: vec![NONE; number.len()],
            prev: vec![NONE; number.len()],
            vertex: vec![NONE; number.len()],
            face: vec![NONE; number.len()],
            vertex_halfedge: vec![NONE; mesh.vertex_count()],
            face_halfedge: vec![NONE; mesh.face_count()],
            positions: mesh.vertices().map(|v| mesh.position(v)).collect(),
            met: vec![NONE; mesh.vertex_count()],
        };
        for h in mesh.halfedges() {
            let at = number[h.index()];
            lean.link(at, number[mesh.next(h).index()]);
            lean.vertex[at as usize] = mesh.vertex(h).0;
            lean.face[at as usize] = mesh.face(h).0;
            lean.vertex_halfedge[mesh.vertex(h).index()] = at;
            lean.face_halfedge[mesh.face(h).index()] = at;
        }
        lean
    }

    fn next(&self, h: u32) -> u32 {
        self.next[h as usize]
    }

    fn prev(&self, h: u32) -> u32 {
        self.prev[h as usize]
    }

    fn vertex(&self, h: u32) -> u32 {
        self.vertex[h as usize]
    }

    fn link(&mut self, from: u32, to: u32) {
        self.next[from as usize] = to;
        self.prev[to as usize] = from;
    }

    fn set(&mut self, h: u32, vertex: u32, face: u32) {
        self.vertex[h as usize] = vertex;
        self.face[h as usize] = face;
        self.vertex_halfedge[vertex as usize] = h;
        self.face_halfedge[face as usize] = h;
    }

    /// The one-ring of the origin of a halfedge.
    fn neighbors(&self, start: u32) -> impl Iterator<Item = u32> + '_ {
        let mut at = start;
        let spokes = std::iter::once(start).chain(std::iter::from_fn(move || {
            at = self.next(at ^ 1);
            (at != start).then_some(at)
        }));
        spokes.map(|h| self.vertex(h ^ 1))
    }

    /// Whether an edge joins the origins of two halfedges. Walks around both at once until one is
    /// done, so that the cost depends on the smaller degree.
    fn are_adjacent(&self, h: u32, other: u32) -> bool {
        let [v, w] = [h, other].map(|half| self.vertex(half));
        let mut pairs = self.neighbors(h).zip(self.neighbors(other));
        pairs.any(|(of_v, of_w)| of_v == w || of_w == v)
    }

    pub fn flip_raw(&mut self, e: u32) -> bool {
        self.flip_edge(e, false)
    }

    pub fn flip(&mut self, e: u32) -> bool {
        self.flip_edge(e, true)
    }

    #[inline(always)]
    fn flip_edge(&mut self, e: u32, stays_simple: bool) -> bool {
        let (a, d) = (2 * e, 2 * e + 1);
        let (b, c, g, h) = (self.next(a), self.prev(a), self.next(d), self.prev(d));
        let [v0, v1, v2, v3] = [a, b, c, h].map(|half| self.vertex(half));
        let distinct = v0 != v1 && v0 != v2 && v0 != v3 && v1 != v2 && v1 != v3 && v2 != v3;
        if !distinct || stays_simple && self.are_adjacent(c, h) {
            return false;
        }
        let (f0, f1) = (self.face[a as usize], self.face[d as usize]);
        for (from, to) in [(a, c), (c, g), (g, a), (d, h), (h, b), (b, d)] {
            self.link(from, to);
        }
        self.set(a, v3, f0);
        self.set(d, v2, f1);
        self.set(g, v0, f0);
        self.set(b, v1, f1);
        true
    }

    pub fn split(&mut self, e: u32) -> bool {
        let (a, d) = (2 * e, 2 * e + 1);
        let (b, c, g, h) = (self.next(a), self.prev(a), self.next(d), self.prev(d));
        let [v0, v1, v2, v3] = [a, b, c, h].map(|half| self.vertex(half));
        if v2 == v3 {
            return false;
        }
        let (f0, f1) = (self.face[a as usize], self.face[d as usize]);
        let middle = (self.positions[v0 as usize] + self.positions[v1 as usize]) / 2.0;
        let m = self.positions.len() as u32;
        self.positions.push(middle);
        self.vertex_halfedge.push(NONE);
        let [f2, f3] = [0, 1].map(|i| self.face_halfedge.len() as u32 + i);
        self.face_halfedge.extend([NONE; 2]);
        // `a` and `d` remain the halfedges of `e`, at `v0`: `d` runs from m to v0.
        let first = self.next.len() as u32;
        let [q, u, p, r, s, t] = [0, 1, 2, 3, 4, 5].map(|i| first + i);
        for all in [&mut self.next, &mut self.prev, &mut self.vertex, &mut self.face] {
            all.extend([NONE; 6]);
        }
        // m -q-> v1 -u-> m, m -p-> v2 -r-> m, m -s-> v3 -t-> m
        for [x, y, z] in [[a, p, c], [q, b, r], [u, s, h], [d, g, t]] {
            self.link(x, y);
            self.link(y, z);
            self.link(z, x);
        }
        for (half, vertex, face) in [
            (p, m, f0),
            (q, m, f2),
            (b, v1, f2),
            (r, v2, f2),
            (u, v1, f1),
            (s, m, f1),
            (h, v3, f1),
            (d, m, f3),
            (g, v0, f3),
            (t, v3, f3),
            (a, v0, f0),
        ] {
            self.set(half, vertex, face);
        }
        true
    }

    /// Collapses an edge to its midpoint, unless the mesh would not be simple.
    pub fn collapse(&mut self, e: u32) -> bool {
        let (a, d) = (2 * e, 2 * e + 1);
        if self.next(a) == NONE {
            return false; // it is gone
        }
        let (b, c, g, h) = (self.next(a), self.prev(a), self.next(d), self.prev(d));
        let [v0, v1, v2, v3] = [a, b, c, h].map(|half| self.vertex(half));
        let mut met = std::mem::take(&mut self.met);
        self.neighbors(a).for_each(|v| met[v as usize] = e);
        let common = self.neighbors(b).filter(|&v| met[v as usize] == e).count();
        self.met = met;
        let keeps_three = |half: u32| self.neighbors(half).nth(3).is_some();
        if common != 2 || v2 == v3 || !keeps_three(c) || !keeps_three(h) {
            return false;
        }
        let middle = (self.positions[v0 as usize] + self.positions[v1 as usize]) / 2.0;
        let mut spoke = h ^ 1;
        while spoke != b {
            self.vertex[spoke as usize] = v0;
            spoke = self.prev(spoke) ^ 1;
        }
        // `b` replaces the twin of `c`, and `g` the twin of `h`.
        for (half, gone) in [(b, c ^ 1), (g, h ^ 1)] {
            let (before, behind) = (self.prev(gone), self.next(gone));
            self.link(before, half);
            self.link(half, behind);
            self.set(half, self.vertex(gone), self.face[gone as usize]);
        }
        self.vertex_halfedge[v2 as usize] = b ^ 1;
        self.vertex_halfedge[v3 as usize] = g ^ 1;
        self.positions[v0 as usize] = middle;
        for half in [a, d, c, c ^ 1, h, h ^ 1] {
            self.next[half as usize] = NONE;
        }
        true
    }
}
