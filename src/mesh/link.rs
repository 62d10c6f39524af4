//! The link condition: which edges of a mesh may be collapsed.
//!
//! After T. K. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, *Topology preserving edge contraction*,
//! 1999: contracting the edge `ab` keeps the topology exactly if the links of its ends meet in the
//! link of `ab` only, `Lk a ∩ Lk b = Lk ab`, a boundary being coned off to one further vertex. For
//! polygons the condition is stated by its purpose: the result is simple again.

use super::connectivity::Mesh;
use super::id::{EdgeId, FaceId, HalfedgeId, VertexId};

/// Stars up to this size are compared without sorting.
const SMALL_STAR: usize = 24;

/// The elements on one side of an edge.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Hole,
    /// A triangle, by the corner that is not an end of the edge.
    Triangle(VertexId),
    Polygon(FaceId),
}

impl Mesh {
    /// True if merging the ends of `e`, and with them the edges of each triangle at `e`, turns a
    /// simple mesh into a simple mesh.
    ///
    /// ```text
    ///         x                 x
    ///       / | \               |
    ///      a--e--b      ->      ab
    ///       \ | /               |
    ///         y                 y
    /// ```
    ///
    /// It holds when all of these do:
    ///
    /// * the vertices that neighbor both ends are exactly the tips of the triangles at
    ///   `e`, one for each;
    /// * no face but those at `e` has both ends as corners;
    /// * both ends lie on a boundary only if `e` does, and then its hole has more than
    ///   three sides;
    /// * no two faces have the same corners apart from the ends: of triangle meshes only a
    ///   tetrahedron passes the above and fails here.
    ///
    /// It is false for an edge that is not alive.
    pub fn link_condition(&self, e: EdgeId) -> bool {
        self.contracts(e).unwrap_or(false)
    }

    fn contracts(&self, e: EdgeId) -> Option<bool> {
        let h = self.get_edge_halfedge(e)?;
        let twin = self.get_twin(h)?;
        let (a, b) = (self.get_vertex(h)?, self.get_vertex(twin)?);
        let sides = [self.side(h)?, self.side(twin)?];
        let faces = [self.get_face(h)?, self.get_face(twin)?];
        let tips = sides.map(|side| match side {
            Side::Triangle(tip) => Some(tip),
            _ => None,
        });
        let polygons = sides.map(|side| match side {
            Side::Polygon(face) => Some(face),
            _ => None,
        });
        let wanted = tips.iter().flatten().count();
        let closed = !sides.contains(&Side::Hole);
        if a == b || sides[0] == sides[1] {
            return Some(false);
        }
        if closed && self.is_boundary_vertex(a) && self.is_boundary_vertex(b) {
            return Some(false);
        }
        if self.common_neighbors(a, b, wanted) != wanted {
            return Some(false);
        }
        if let [Some(left), Some(right)] = polygons
            && self.same_corners(left, right, [a, b])
        {
            return Some(false);
        }
        let hole = [h, twin].into_iter().zip(sides).find(|(_, side)| *side == Side::Hole);
        if hole.is_some_and(|(hole, _)| self.loop_from(hole).take(4).count() < 4) {
            return Some(false);
        }
        // Each common neighbor of the ends is a tip. So a triangle at an end that has the corners of
        // a face at the other end, apart from the ends, has both tips among its own; if it has those
        // of a polygon at the edge, one of them.
        let is_tip = |v: &VertexId| tips.contains(&Some(*v));
        let least = if polygons == [None; 2] { 2 } else { 1 };
        let concerns = |spoke: HalfedgeId| {
            let far = [self.get_target(spoke), self.last_of(spoke)];
            !self.is_triangle(spoke) || far.iter().flatten().filter(|v| is_tip(v)).count() >= least
        };
        for (end, other) in [(a, b), (b, a)] {
            for spoke in self.spokes(end) {
                let face = self.get_face(spoke)?;
                if faces.contains(&face) || self.get_is_hole(face)? || !concerns(spoke) {
                    continue;
                }
                if !self.is_triangle(spoke) && self.has_corner(face, other) {
                    return Some(false);
                }
                let around_other = self.spokes(other).filter_map(|spoke| self.get_face(spoke));
                let others = around_other.filter(|g| !faces.contains(g) && end == a);
                let mut others = others.chain(polygons.into_iter().flatten());
                if others.any(|other| self.same_corners(face, other, [a, b])) {
                    return Some(false);
                }
            }
        }
        Some(true)
    }

    fn side(&self, h: HalfedgeId) -> Option<Side> {
        let face: FaceId = self.get_face(h)?;
        if self.get_is_hole(face)? {
            return Some(Side::Hole);
        }
        Some(match self.is_triangle(h) {
            true => Side::Triangle(self.last_of(h)?),
            false => Side::Polygon(face),
        })
    }

    fn is_triangle(&self, h: HalfedgeId) -> bool {
        let last = self.get_next(h).and_then(|next| self.get_next(next));
        last.is_some_and(|last| last != h && self.get_next(last) == Some(h))
    }

    /// The corner before `h` in its loop.
    fn last_of(&self, h: HalfedgeId) -> Option<VertexId> {
        self.get_vertex(self.get_prev(h)?)
    }

    /// True if a vertex is a corner of a face. The smaller of the two, walked side by side, decides.
    fn has_corner(&self, face: FaceId, v: VertexId) -> bool {
        let (mut corners, mut spokes) = (self.face_vertices(face), self.spokes(v));
        loop {
            let (Some(corner), Some(spoke)) = (corners.next(), spokes.next()) else { return false };
            if corner == v || self.get_face(spoke) == Some(face) {
                return true;
            }
        }
    }

    /// True if two faces have the same corners, apart from `but`; false if `g` is a hole.
    fn same_corners(&self, f: FaceId, g: FaceId, but: [VertexId; 2]) -> bool {
        if self.get_is_hole(g) != Some(false) {
            return false;
        }
        let others = |face| self.face_vertices(face).filter(move |v| !but.contains(v));
        // Mostly the first corner decides; those of both are counted last.
        others(f).all(|v| self.has_corner(g, v)) && others(f).map(drop).eq(others(g).map(drop))
    }

    /// The number of common neighbors, or some number above `enough`.
    fn common_neighbors(&self, a: VertexId, b: VertexId, enough: usize) -> usize {
        let mut small = [VertexId::NONE; SMALL_STAR];
        let mut held = 0;
        for v in self.neighbors(a) {
            if held == SMALL_STAR {
                return self.common_neighbors_of_large_stars(a, b);
            }
            small[held] = v;
            held += 1;
        }
        let around_a = &small[..held];
        self.neighbors(b).filter(|v| around_a.contains(v)).take(enough + 1).count()
    }

    #[cold]
    fn common_neighbors_of_large_stars(&self, a: VertexId, b: VertexId) -> usize {
        let mut around_a: Vec<VertexId> = self.neighbors(a).collect();
        around_a.sort_unstable();
        self.neighbors(b).filter(|v| around_a.binary_search(v).is_ok()).count()
    }
}
