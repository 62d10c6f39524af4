//! Checks of the levels only where a mesh has changed.
//!
//! If a mesh had a level and only the pointers of known elements have been written since, it still
//! has the level if its conditions hold at those elements. For a violation shows in an orbit that
//! has changed: a face that now meets a vertex twice does so with a halfedge that was written, a
//! vertex that has lost its spokes has a neighbor whose `next` was, and so on. So it is enough to
//! check all orbits of what was written.

use super::connectivity::Mesh;
use super::id::{EdgeId, FaceId, HalfedgeId, VertexId};
use super::level::{BelowLevel, Level};

/// Elements that were written since a mesh was known to have a level. Some may be listed twice, and
/// some may have been erased.
#[derive(Clone, Debug, Default)]
pub struct Footprint {
    pub vertices: Vec<VertexId>,
    pub halfedges: Vec<HalfedgeId>,
    pub edges: Vec<EdgeId>,
    pub faces: Vec<FaceId>,
}

impl Footprint {
    /// The number of elements that are listed.
    pub fn len(&self) -> usize {
        self.vertices.len() + self.halfedges.len() + self.edges.len() + self.faces.len()
    }

    /// True if no element is listed.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds what was written later.
    pub fn append(&mut self, mut later: Self) {
        self.vertices.append(&mut later.vertices);
        self.halfedges.append(&mut later.halfedges);
        self.edges.append(&mut later.edges);
        self.faces.append(&mut later.faces);
    }
}

/// Checks that a valid mesh that had the level still has it after the elements of the footprint
/// were written; if not, the first reason found.
pub fn validate_level_near(
    mesh: &Mesh,
    level: Level,
    footprint: &Footprint,
) -> Result<(), BelowLevel> {
    if level == Level::Map {
        return Ok(());
    }
    let Footprint { vertices, edges, faces, .. } = orbits(mesh, footprint);
    for &face in &faces {
        loop_is_sound(mesh, face)?;
    }
    for &vertex in &vertices {
        star_is_sound(mesh, vertex)?;
    }
    for &edge in &edges {
        let h = mesh.edge_halfedge(edge);
        if mesh.is_boundary_halfedge(h) && mesh.is_boundary_halfedge(mesh.twin(h)) {
            return Err(BelowLevel::NoFaceAlong { edge });
        }
    }
    if level >= Level::Simple {
        for &vertex in &vertices {
            neighbors_differ(mesh, vertex)?;
        }
        for &face in faces.iter().filter(|&&face| !mesh.is_hole(face)) {
            corners_differ_nearby(mesh, face)?;
        }
    }
    Ok(())
}

/// The living vertices, edges and faces in whose orbits something was written, each once.
fn orbits(mesh: &Mesh, written: &Footprint) -> Footprint {
    // A large face may be listed many times, and is walked once.
    let mut near = each_once(written.clone());
    // A face that becomes a hole is written itself, which affects all elements along it.
    let on_faces = near.faces.iter().flat_map(|&f| mesh.face_halfedges(f)).collect();
    for h in [std::mem::take(&mut near.halfedges), on_faces].concat() {
        near.vertices.extend(mesh.get_vertex(h));
        near.vertices.extend(mesh.get_target(h));
        near.edges.extend(mesh.get_edge(h));
        near.faces.extend(mesh.get_face(h));
        near.faces.extend(mesh.get_twin(h).and_then(|twin| mesh.get_face(twin)));
    }
    near.vertices.retain(|&v| mesh.get_vertex_halfedge(v).is_some_and(|h| !h.is_none()));
    near.edges.retain(|&e| mesh.get_edge_halfedge(e).is_some());
    near.faces.retain(|&f| mesh.get_face_halfedge(f).is_some());
    each_once(near)
}

/// The footprint without the repetitions in its lists.
fn each_once(footprint: Footprint) -> Footprint {
    fn distinct<T: Ord>(mut list: Vec<T>) -> Vec<T> {
        list.sort_unstable();
        list.dedup();
        list
    }
    let Footprint { vertices, halfedges, edges, faces } = footprint;
    Footprint {
        vertices: distinct(vertices),
        halfedges: distinct(halfedges),
        edges: distinct(edges),
        faces: distinct(faces),
    }
}

/// A loop has three sides, and meets no vertex twice.
fn loop_is_sound(mesh: &Mesh, face: FaceId) -> Result<(), BelowLevel> {
    let corners = sorted_corners(mesh, face);
    let hole = mesh.is_hole(face);
    if let Some(pair) = corners.windows(2).find(|pair| pair[0] == pair[1]) {
        let vertex = pair[0];
        return Err(BelowLevel::MeetsTwice { face, hole, vertex });
    }
    let size = corners.len();
    match size < 3 {
        true => Err(BelowLevel::SmallLoop { face, hole, size }),
        false => Ok(()),
    }
}

/// A vertex has two spokes, a face around it, and one hole at most.
fn star_is_sound(mesh: &Mesh, vertex: VertexId) -> Result<(), BelowLevel> {
    let around = || mesh.spokes(vertex).map(|h| mesh.face(h));
    let spokes = around().count();
    let holes: Vec<_> = around().filter(|&face| mesh.is_hole(face)).collect();
    match holes.as_slice() {
        holes if holes.len() == spokes => Err(BelowLevel::NoFaceAround { vertex }),
        &[first, second, ..] => Err(BelowLevel::Pinched { vertex, holes: [first, second] }),
        _ if spokes < 2 => Err(BelowLevel::SingleSpoke { vertex }),
        _ => Ok(()),
    }
}

/// The spokes of a vertex lead to different vertices, none of them back to it.
fn neighbors_differ(mesh: &Mesh, vertex: VertexId) -> Result<(), BelowLevel> {
    let mut reached: Vec<_> = mesh.spokes(vertex).map(|h| (mesh.target(h), mesh.edge(h))).collect();
    reached.sort_unstable();
    if let Some(&(_, edge)) = reached.iter().find(|(target, _)| *target == vertex) {
        return Err(BelowLevel::EndsWhereItBegins { edge, vertex });
    }
    match reached.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        Some(&[(target, first), (_, second)]) => {
            Err(BelowLevel::DoubleEdge { edges: [first, second], ends: [vertex, target] })
        }
        _ => Ok(()),
    }
}

/// No other face around a corner of a face has the same corners.
fn corners_differ_nearby(mesh: &Mesh, face: FaceId) -> Result<(), BelowLevel> {
    let corners = sorted_corners(mesh, face);
    let Some(&corner) = corners.first() else {
        return Ok(());
    };
    let around = mesh.spokes(corner).map(|h| mesh.face(h));
    for other in around.filter(|&other| other != face && !mesh.is_hole(other)) {
        if sorted_corners(mesh, other) == corners {
            let faces = [face, other];
            return Err(BelowLevel::SameCorners { faces });
        }
    }
    Ok(())
}

fn sorted_corners(mesh: &Mesh, face: FaceId) -> Vec<VertexId> {
    let mut corners: Vec<_> = mesh.face_vertices(face).collect();
    corners.sort_unstable();
    corners
}
