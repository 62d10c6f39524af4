//! Checks of the levels only where a mesh has changed.
//!
//! If a mesh had a level and only known halfedges and faces have changed since, it still has the
//! level if its conditions hold at those elements. For a violation shows in an orbit that has
//! changed: a face that now meets a vertex twice does so with a halfedge that has changed, a vertex
//! that has lost its spokes has a neighbor whose `next` has, and so on. So it is enough to check all
//! orbits of what has changed.

use super::connectivity::Mesh;
use super::id::{EdgeId, FaceId, HalfedgeId, VertexId};
use super::level::{BelowLevel, Level, edges_have_a_face};

/// The changes to a mesh since it was known to have a level. Some elements may be listed twice, and
/// some may have been erased.
#[derive(Clone, Debug, Default)]
pub struct Footprint {
    /// The halfedges with other pointers than before.
    pub halfedges: Vec<HalfedgeId>,
    /// The faces that were created or erased, and those that have become holes or no longer are.
    pub faces: Vec<FaceId>,
}

impl Footprint {
    /// The number of elements that are listed.
    pub fn len(&self) -> usize {
        self.halfedges.len() + self.faces.len()
    }

    /// True if no element is listed.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Adds later changes.
    pub fn append(&mut self, mut later: Self) {
        self.halfedges.append(&mut later.halfedges);
        self.faces.append(&mut later.faces);
    }
}

/// Checks that a valid mesh that had the level still has it after these changes; if not, the first
/// reason found.
pub fn validate_level_near(
    mesh: &Mesh,
    level: Level,
    footprint: &Footprint,
) -> Result<(), BelowLevel> {
    if level == Level::Map {
        return Ok(());
    }
    let Orbits { vertices, edges, faces } = Orbits::near(mesh, footprint);
    let mut corners = Vec::new();
    for &face in &faces {
        sort_corners(mesh, face, &mut corners);
        loop_is_sound(mesh, face, &corners)?;
    }
    for &vertex in &vertices {
        star_is_sound(mesh, vertex)?;
    }
    edges_have_a_face(mesh, edges.into_iter())?;
    if level >= Level::Simple {
        let mut reached = Vec::new();
        for &vertex in &vertices {
            neighbors_differ(mesh, vertex, &mut reached)?;
        }
        for &face in faces.iter().filter(|&&face| !mesh.is_hole(face)) {
            sort_corners(mesh, face, &mut corners);
            corners_differ_nearby(mesh, face, &corners)?;
        }
    }
    Ok(())
}

/// Living vertices, edges and faces, each listed once.
pub(crate) struct Orbits {
    pub(crate) vertices: Vec<VertexId>,
    pub(crate) edges: Vec<EdgeId>,
    pub(crate) faces: Vec<FaceId>,
}

impl Orbits {
    /// The orbits in which something has changed: those that [`validate_level_near`] checks. It also
    /// looks at the faces around a corner of each face.
    pub(crate) fn near(mesh: &Mesh, changes: &Footprint) -> Self {
        // A face that becomes a hole affects all elements along it. It may be large and listed many
        // times, and is walked once.
        let mut halfedges = changes.halfedges.clone();
        let faces = each_once(changes.faces.clone());
        halfedges.extend(faces.iter().flat_map(|&f| mesh.face_halfedges(f)));
        let halfedges = each_once(halfedges);
        let mut vertices = Vec::with_capacity(2 * halfedges.len());
        let mut edges = Vec::with_capacity(halfedges.len());
        let mut faces = Vec::with_capacity(2 * halfedges.len());
        for h in halfedges {
            vertices.extend(mesh.get_vertex(h));
            vertices.extend(mesh.get_target(h));
            edges.extend(mesh.get_edge(h));
            faces.extend(mesh.get_face(h));
            faces.extend(mesh.get_twin(h).and_then(|twin| mesh.get_face(twin)));
        }
        Self { vertices: each_once(vertices), edges: each_once(edges), faces: each_once(faces) }
    }
}

/// The list without repetitions.
fn each_once<T: Ord>(mut list: Vec<T>) -> Vec<T> {
    list.sort_unstable();
    list.dedup();
    list
}

/// A loop has three sides, and meets no vertex twice.
fn loop_is_sound(mesh: &Mesh, face: FaceId, corners: &[VertexId]) -> Result<(), BelowLevel> {
    let hole = mesh.is_hole(face);
    if let Some(&[vertex, _]) = corners.windows(2).find(|pair| pair[0] == pair[1]) {
        return Err(BelowLevel::MeetsTwice { face, hole, vertex });
    }
    let size = corners.len();
    if size < 3 { Err(BelowLevel::SmallLoop { face, hole, size }) } else { Ok(()) }
}

/// A vertex has two spokes, a face around it, and one hole at most.
fn star_is_sound(mesh: &Mesh, vertex: VertexId) -> Result<(), BelowLevel> {
    let mut spokes = 0;
    let around = mesh.spokes(vertex).map(|h| mesh.face(h)).inspect(|_| spokes += 1);
    let holes: Vec<_> = around.filter(|&face| mesh.is_hole(face)).collect();
    match holes.as_slice() {
        holes if holes.len() == spokes => Err(BelowLevel::NoFaceAround { vertex }),
        &[first, second, ..] => Err(BelowLevel::Pinched { vertex, holes: [first, second] }),
        _ if spokes < 2 => Err(BelowLevel::SingleSpoke { vertex }),
        _ => Ok(()),
    }
}

/// The spokes of a vertex lead to different vertices, none of them back to it. The list is
/// overwritten.
fn neighbors_differ(
    mesh: &Mesh,
    vertex: VertexId,
    reached: &mut Vec<(VertexId, EdgeId)>,
) -> Result<(), BelowLevel> {
    reached.clear();
    reached.extend(mesh.spokes(vertex).map(|h| (mesh.target(h), mesh.edge(h))));
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
fn corners_differ_nearby(
    mesh: &Mesh,
    face: FaceId,
    corners: &[VertexId],
) -> Result<(), BelowLevel> {
    let Some(&corner) = corners.first() else { return Ok(()) };
    // No loop meets a vertex twice, so it is enough to count those that are met.
    let are_same = |other: FaceId| {
        let mut size = 0;
        let mut met = mesh.face_vertices(other).inspect(|_| size += 1);
        met.all(|v| corners.binary_search(&v).is_ok()) && size == corners.len()
    };
    let around = mesh.spokes(corner).map(|h| mesh.face(h));
    let mut others = around.filter(|&other| other != face && !mesh.is_hole(other));
    match others.find(|&other| are_same(other)) {
        Some(other) => Err(BelowLevel::SameCorners { faces: [face, other] }),
        None => Ok(()),
    }
}

/// Overwrites a list with the corners of a face, in the order of their numbers.
fn sort_corners(mesh: &Mesh, face: FaceId, corners: &mut Vec<VertexId>) {
    corners.clear();
    corners.extend(mesh.face_vertices(face));
    corners.sort_unstable();
}
