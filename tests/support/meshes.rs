//! Many small meshes, with different choices of the `halfedge` pointers of their elements.

use glam::DVec3;
use hedgerow::mesh::{EdgeId, HalfedgeId, Level, Mesh, Polygons, shape, validate_level};

/// A small pseudorandom generator (splitmix64; S. Vigna, 2015): the same in every run.
#[derive(Clone, Debug)]
pub struct Dice(pub u64);

impl Dice {
    pub fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) % end.max(1) as u64) as usize
    }
}

fn shapes() -> Vec<Mesh> {
    let mut meshes = vec![
        shape::tetrahedron(),
        shape::cube(),
        shape::octahedron(),
        shape::icosahedron(),
        shape::torus(3, 3),
        shape::torus(3, 4),
        shape::triangle_torus(3, 3),
        shape::triangle_torus(3, 4),
    ];
    for n in 3..6 {
        meshes.extend([shape::single_polygon(n), shape::pillow(n), shape::fan(n)]);
        meshes.extend([shape::tube(n, 1), shape::tube(n, 2)]);
    }
    for (n, m) in [(1, 1), (1, 2), (2, 2), (1, 3), (2, 3), (3, 3)] {
        meshes.extend([shape::grid(n, m), shape::triangle_grid(n, m)]);
    }
    meshes
}

fn polygons(mesh: &Mesh) -> Vec<Vec<u32>> {
    let faces = mesh.faces().filter(|&face| !mesh.is_hole(face));
    faces.map(|face| mesh.face_vertices(face).map(|v| v.0).collect()).collect()
}

/// The mesh of these faces; `None` if they do not form one.
fn of_polygons(polygons: &[Vec<u32>]) -> Option<Mesh> {
    // Vertices without a face are left out.
    let mut used: Vec<u32> = polygons.iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    let renumbered = |&v: &u32| used.binary_search(&v).expect("it is used") as u32;
    let polygons: Polygons =
        polygons.iter().map(|polygon| polygon.iter().map(renumbered).collect::<Vec<_>>()).collect();
    let place = |v: usize| DVec3::new(v as f64, (v * v % 7) as f64, (v * v % 5) as f64);
    let positions: Vec<_> = (0..used.len()).map(place).collect();
    Mesh::from_polygons(&positions, &polygons).ok()
}

/// The mesh of a random subset of the faces of a mesh, if they form one.
fn parts(mesh: &Mesh, dice: &mut Dice) -> Option<Mesh> {
    let mut chosen = polygons(mesh);
    let keep = 1 + dice.below(chosen.len());
    while chosen.len() > keep {
        let at = dice.below(chosen.len());
        chosen.swap_remove(at);
    }
    of_polygons(&chosen)
}

/// Meshes of the level: the shapes and parts of them.
pub fn meshes(level: Level, dice: &mut Dice) -> Vec<Mesh> {
    let shapes = shapes();
    let mut meshes = Vec::new();
    for mesh in &shapes {
        meshes.extend((0..6).filter_map(|_| parts(mesh, dice)));
    }
    meshes.extend(shapes);
    meshes.retain(|mesh| validate_level(mesh, level).is_ok());
    meshes
}

/// Lets every element point to a random one of its halfedges.
pub fn shuffle_pointers(mesh: &mut Mesh, dice: &mut Dice) {
    for v in mesh.vertices().collect::<Vec<_>>() {
        let spokes: Vec<HalfedgeId> = mesh.spokes(v).collect();
        if !spokes.is_empty() {
            mesh.set_vertex_halfedge(v, spokes[dice.below(spokes.len())]);
        }
    }
    for e in mesh.edges().collect::<Vec<EdgeId>>() {
        let h = mesh.edge_halfedge(e);
        let choice = [h, mesh.twin(h)][dice.below(2)];
        mesh.set_edge_halfedge(e, choice);
    }
    for f in mesh.faces().collect::<Vec<_>>() {
        let sides: Vec<HalfedgeId> = mesh.face_halfedges(f).collect();
        mesh.set_face_halfedge(f, sides[dice.below(sides.len())]);
    }
}
