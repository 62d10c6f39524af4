//! The link condition: which edges of a triangle mesh may be collapsed.
//!
//! After T. K. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, *Topology preserving edge
//! contraction*, 1999: contracting the edge `ab` keeps the topology exactly if the
//! links of its ends meet in the link of `ab` only, `Lk a ∩ Lk b = Lk ab`, a boundary
//! being coned off to one further vertex.

use super::connectivity::Mesh;
use super::id::{EdgeId, FaceId, HalfedgeId, VertexId};

/// Stars up to this size are compared without sorting.
const SMALL_STAR: usize = 24;

impl Mesh {
    /// Whether merging the ends of `e`, and with them the edges of each triangle at
    /// `e`, turns a simple triangle mesh into a simple triangle mesh.
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
    /// * each side of `e` is a triangle or a hole, and one at least is a triangle;
    /// * the vertices that neighbor both ends are exactly the tips of the triangles at
    ///   `e`, one for each;
    /// * both ends lie on a boundary only if `e` does;
    /// * no edge lies in the links of both ends: of simple meshes only a tetrahedron,
    ///   and a triangle on its own, pass the above and fail here.
    ///
    /// It is false for an edge that does not live.
    pub fn link_condition(&self, e: EdgeId) -> bool {
        self.collapse_tips(e).is_some()
    }

    /// The tips of the triangles at `e` if the link condition holds.
    fn collapse_tips(&self, e: EdgeId) -> Option<[Option<VertexId>; 2]> {
        let h = self.get_edge_halfedge(e)?;
        let twin = self.get_twin(h)?;
        let (a, b) = (self.get_vertex(h)?, self.get_vertex(twin)?);
        let tips = [self.tip(h)?, self.tip(twin)?];
        let wanted = tips.iter().flatten().count();
        if wanted == 0 || a == b || tips[0] == tips[1] {
            return None;
        }
        let boundary = wanted == 1;
        if !boundary && self.is_boundary_vertex(a) && self.is_boundary_vertex(b) {
            return None;
        }
        if self.common_neighbors(a, b, wanted) != wanted {
            return None;
        }
        let closed_up = match tips {
            // a, b, x, y is a tetrahedron if both ends have these three neighbors only
            // and no hole.
            [Some(_), Some(_)] => {
                let lonely = |v| self.degree(v) == 3 && !self.is_boundary_vertex(v);
                lonely(a) && lonely(b)
            }
            // The hole at e would shrink to two sides: by the neighbors counted above
            // the third corner is the tip, and the triangle stands alone.
            _ => {
                let hole = if tips[0].is_none() { h } else { twin };
                self.loop_from(hole).take(4).count() < 4
            }
        };
        (!closed_up).then_some(tips)
    }

    /// The corner opposite `h` in its triangle; `Some(None)` in a hole, `None` in a
    /// face that is no triangle.
    fn tip(&self, h: HalfedgeId) -> Option<Option<VertexId>> {
        let face: FaceId = self.get_face(h)?;
        if self.get_is_hole(face)? {
            return Some(None);
        }
        let last = self.get_prev(h)?;
        let triangle = self.get_next(self.get_next(h)?)? == last && self.get_next(last)? == h;
        triangle.then(|| self.get_vertex(last))
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
        let common = self.neighbors(b).filter(|v| around_a.contains(v));
        common.take(enough + 1).count()
    }

    #[cold]
    fn common_neighbors_of_large_stars(&self, a: VertexId, b: VertexId) -> usize {
        let mut around_a: Vec<VertexId> = self.neighbors(a).collect();
        around_a.sort_unstable();
        self.neighbors(b).filter(|v| around_a.binary_search(v).is_ok()).count()
    }
}

#[cfg(test)]
mod tests {
    use crate::mesh::{Mesh, shape};

    fn collapsible(mesh: &Mesh) -> usize {
        mesh.edges().filter(|&e| mesh.link_condition(e)).count()
    }

    #[test]
    fn known_counts() {
        assert_eq!(collapsible(&shape::tetrahedron()), 0);
        assert_eq!(collapsible(&shape::single_polygon(3)), 0);
        assert_eq!(collapsible(&shape::pillow(3)), 0);
        assert_eq!(collapsible(&shape::octahedron()), 12);
        assert_eq!(collapsible(&shape::icosahedron()), 30);
        assert_eq!(collapsible(&shape::cube()), 0);
        // The outer edge of two triangles: yes; the diagonal would pinch: no.
        assert_eq!(collapsible(&shape::triangle_grid(1, 1)), 4);
    }

    #[test]
    fn large_stars_count_alike() {
        // A spoke of a wide fan has both ends on the boundary only at its rim.
        let mesh = shape::fan(100);
        let spokes = 100;
        let rim = 100;
        assert_eq!(collapsible(&mesh), spokes + rim);
        assert_eq!(collapsible(&shape::fan(5)), 10);
    }
}
