//! The same operations with the crate `alum`, a halfedge mesh in the style of OpenMesh.

use alum::{DVec3, EH, EditableTopology, HH, HasIterators, PolyMeshF64, VH};
use hedgerow::mesh::Mesh;

pub struct Alum {
    mesh: PolyMeshF64,
    /// For each edge of hedgerow's mesh, by number, the edge of this one.
    edges: Vec<EH>,
    cache: Vec<HH>,
}

impl Alum {
    pub fn new(mesh: &Mesh) -> Self {
        let (positions, polygons) = mesh.to_polygons();
        let mut all =
            PolyMeshF64::with_capacity(positions.len(), mesh.edge_count(), polygons.len());
        for at in positions {
            all.add_vertex(DVec3(at.x, at.y, at.z)).expect("there is room");
        }
        for polygon in polygons.iter() {
            let corners: Vec<VH> = polygon.iter().map(|&v| v.into()).collect();
            all.add_face(&corners).expect("it is a mesh");
        }
        let edges = mesh.edges().map(|edge| {
            let h = mesh.edge_halfedge(edge);
            let [from, to] = [mesh.vertex(h), mesh.target(h)].map(|v| VH::from(v.0));
            all.find_halfedge(from, to).expect("it is the same mesh").edge()
        });
        Self { edges: edges.collect(), mesh: all, cache: Vec::new() }
    }

    fn middle(&self, h: HH) -> DVec3 {
        let [v, w] = [h.tail(&self.mesh), h.head(&self.mesh)]
            .map(|v| self.mesh.point(v).expect("nobody holds it"));
        DVec3((v.0 + w.0) / 2.0, (v.1 + w.1) / 2.0, (v.2 + w.2) / 2.0)
    }

    pub fn flip_raw(&mut self, e: u32) -> bool {
        self.mesh.swap_edge_ccw(self.edges[e as usize]).is_ok()
    }

    pub fn flip(&mut self, e: u32) -> bool {
        let (a, d) = self.edges[e as usize].halfedges();
        let ends = [a, d].map(|h| h.next(&self.mesh).head(&self.mesh));
        self.mesh.find_halfedge(ends[0], ends[1]).is_none() && self.flip_raw(e)
    }

    pub fn split(&mut self, e: u32) -> bool {
        let a = self.edges[e as usize].halfedge(false);
        let middle = self.middle(a);
        let mesh = &mut self.mesh;
        let m = mesh.add_vertex(middle).expect("there is room");
        let before = mesh.split_edge(a, m, false).expect("there is room");
        // Each triangle is now a quad: inserts an edge from the new vertex to the opposite corner.
        for h in [before, a.opposite()] {
            let across = h.next(mesh).next(mesh).next(mesh);
            mesh.insert_edge(h, across, None).expect("there is room");
        }
        true
    }

    pub fn collapse(&mut self, e: u32) -> bool {
        let a = self.edges[e as usize].halfedge(false);
        if !self.mesh.try_check_edge_collapse(a).expect("nobody holds them") {
            return false;
        }
        let (middle, left) = (self.middle(a), a.head(&self.mesh));
        self.mesh.try_collapse_edge(a, &mut self.cache).expect("nobody holds them");
        self.mesh.set_point(left, middle).expect("nobody holds them");
        true
    }
}
