//! Levels: conditions on a valid mesh beyond the laws of its tables.
//!
//! `map` requires nothing more than the laws of `validate`. `surface` is what other mesh libraries
//! check. `simple` is what makes triangles and edges sets of vertices, as in a simplicial complex.
//! An isolated vertex is not part of the surface and is allowed at every level.

use std::fmt;
use std::ops::Range;

use super::build_error::repeated;
use super::connectivity::Mesh;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
use super::invalid::Invalid;
use super::parallel;
use super::polygon_sides::{EachSide, Sides};
use super::validate::validate;

/// The conditions on a mesh. Each level includes the ones before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Level {
    /// Every orbit is in order, but a face may have two sides and an edge may end where it begins.
    Map,
    /// Faces and holes have 3 halfedges or more. Vertices have 2 spokes or more, a face around
    /// them and at most one corner in a hole. Edges have a face on one side at least.
    /// No face or hole meets a vertex twice.
    Surface,
    /// No edge ends where it begins, no two edges have the same ends, no two faces have
    /// the same set of corners.
    Simple,
}

impl Level {
    pub const ALL: [Self; 3] = [Self::Map, Self::Surface, Self::Simple];

    pub fn name(self) -> &'static str {
        match self {
            Self::Map => "map",
            Self::Surface => "surface",
            Self::Simple => "simple",
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The reason why a mesh does not have a level.
#[derive(Clone, Debug, PartialEq)]
pub enum BelowLevel {
    Invalid(Invalid),
    SmallLoop { face: FaceId, hole: bool, size: usize },
    MeetsTwice { face: FaceId, hole: bool, vertex: VertexId },
    SingleSpoke { vertex: VertexId },
    NoFaceAround { vertex: VertexId },
    Pinched { vertex: VertexId, holes: [FaceId; 2] },
    NoFaceAlong { edge: EdgeId },
    EndsWhereItBegins { edge: EdgeId, vertex: VertexId },
    DoubleEdge { edges: [EdgeId; 2], ends: [VertexId; 2] },
    SameCorners { faces: [FaceId; 2] },
}

/// A face or a hole in words.
fn words(face: FaceId, is_hole: bool) -> String {
    if is_hole { format!("hole {}", face.0) } else { face.to_string() }
}

impl fmt::Display for BelowLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Invalid(invalid) => invalid.fmt(f),
            Self::SmallLoop { face, hole, size } => {
                let sides = if *size == 1 { "side" } else { "sides" };
                write!(f, "{} has only {size} {sides}", words(*face, *hole))
            }
            Self::MeetsTwice { face, hole, vertex } => {
                write!(f, "{} meets {vertex} twice", words(*face, *hole))
            }
            Self::SingleSpoke { vertex } => write!(f, "{vertex} has a single edge"),
            Self::NoFaceAround { vertex } => write!(f, "{vertex} has holes only around it"),
            Self::Pinched { vertex, holes: [a, b] } if a == b => {
                write!(f, "the surface is pinched at {vertex}, which hole {} meets twice", a.0)
            }
            Self::Pinched { vertex, holes } => {
                let [a, b] = holes.map(|hole| hole.0);
                write!(f, "the surface is pinched at {vertex}, where holes {a} and {b} meet")
            }
            Self::NoFaceAlong { edge } => write!(f, "{edge} has a hole on both sides"),
            Self::EndsWhereItBegins { edge, vertex } => {
                write!(f, "{edge} begins and ends at {vertex}")
            }
            Self::DoubleEdge { edges: [a, b], ends: [v, w] } => {
                write!(f, "{a} and {b} both join {v} and {w}")
            }
            Self::SameCorners { faces: [a, b] } => write!(f, "{a} and {b} have the same corners"),
        }
    }
}

impl std::error::Error for BelowLevel {}

/// Checks that the mesh is valid and has the level; the error is the first reason found.
pub fn validate_level(mesh: &Mesh, level: Level) -> Result<(), BelowLevel> {
    validate(mesh).map_err(BelowLevel::Invalid)?;
    validate_level_of_valid(mesh, level)
}

/// As [`validate_level`], for a mesh known to be valid.
pub(crate) fn validate_level_of_valid(mesh: &Mesh, level: Level) -> Result<(), BelowLevel> {
    // Most meshes pass, and that is found sooner than why one does not.
    if level >= Level::Simple && is_surface_of_single_edges(mesh) {
        return faces_differ_in_corners(mesh);
    }
    if level >= Level::Surface {
        is_surface(mesh)?;
    }
    if level >= Level::Simple {
        edges_have_two_ends(mesh)?;
        edges_are_single(mesh)?;
        faces_differ_in_corners(mesh)?;
    }
    Ok(())
}

/// The level of a mesh, at most `wanted`, if [`Mesh::from_polygons`] made it and nothing has
/// changed it: then it is a surface, and no two edges have the same ends.
pub(crate) fn level_of_polygons(mesh: &Mesh, wanted: Level) -> Level {
    match wanted {
        Level::Simple if faces_differ_in_corners(mesh).is_ok() => Level::Simple,
        _ => wanted.min(Level::Surface),
    }
}

/// True if a mesh, which must be valid, is of level surface and no two edges have the same ends,
/// found in one walk along each loop and two passes over the halfedges. It follows that each edge
/// has a face, that each vertex has one, and that no edge ends where it begins.
pub(super) fn is_surface_of_single_edges(mesh: &Mesh) -> bool {
    let faces = parallel::parts(mesh.capacity(ElementKind::Face), LEAST);
    let meet_once = parallel::map(faces, |part| {
        let (mut met, mut sorted) = (Vec::new(), Vec::new());
        part.map(|face| FaceId(face as u32)).filter(|&f| mesh.face_alive(f)).all(|face| {
            met.clear();
            met.extend(mesh.face_vertices(face).map(|v| v.0));
            met.len() >= 3 && repeated(&met, &mut sorted).is_none()
        })
    });
    if meet_once.contains(&false) {
        return false;
    }
    let mut is_in_hole = vec![false; mesh.capacity(ElementKind::Vertex)];
    let mut in_holes = mesh.holes().flat_map(|hole| mesh.face_vertices(hole));
    if in_holes.any(|v| std::mem::replace(&mut is_in_hole[v.index()], true)) {
        return false;
    }
    let sides = Sides::gather(&Edges(mesh), is_in_hole.len());
    let are_single = parallel::map(parallel::parts(is_in_hole.len(), LEAST), |part| {
        sides.edges_of(part).all(|edge| edge.len() == 1)
    });
    !are_single.contains(&false)
}

/// The edges of a mesh, each as one of its halfedges.
struct Edges<'m>(&'m Mesh);

impl EachSide for Edges<'_> {
    fn groups(&self) -> usize {
        self.0.halfedges.len()
    }

    #[inline]
    fn each_side(&self, halfedges: Range<usize>, mut see: impl FnMut(u32, u32, u32)) {
        for (h, record) in (halfedges.start as u32..).zip(&self.0.halfedges[halfedges]) {
            if record.lives() && HalfedgeId(h) < record.twin {
                // The target: the next halfedge is usually adjacent in memory.
                see(h, record.vertex.0, self.0.vertex(record.next).0);
            }
        }
    }
}

/// The fewest elements that are worth a thread.
const LEAST: usize = 4096;

/// The highest level of a mesh, or what makes it invalid.
pub fn highest_level(mesh: &Mesh) -> Result<Level, Invalid> {
    let mut highest = Level::Map;
    for level in Level::ALL {
        match validate_level(mesh, level) {
            Ok(()) => highest = level,
            Err(BelowLevel::Invalid(invalid)) => return Err(invalid),
            Err(_) => break,
        }
    }
    Ok(highest)
}

// The checks below are for valid meshes only.

fn is_surface(mesh: &Mesh) -> Result<(), BelowLevel> {
    loops_have_three_sides(mesh)?;
    loops_meet_vertices_once(mesh)?;
    vertices_have_one_fan_of_faces(mesh)?;
    edges_have_a_face(mesh, mesh.edges())
}

fn loops_have_three_sides(mesh: &Mesh) -> Result<(), BelowLevel> {
    for face in mesh.faces() {
        let size = mesh.face_halfedges(face).take(3).count();
        if size < 3 {
            return Err(BelowLevel::SmallLoop { face, hole: mesh.is_hole(face), size });
        }
    }
    Ok(())
}

fn loops_meet_vertices_once(mesh: &Mesh) -> Result<(), BelowLevel> {
    let mut seen_by = vec![FaceId::NONE; mesh.capacity(ElementKind::Vertex)];
    for face in mesh.faces() {
        for vertex in mesh.face_vertices(face) {
            if std::mem::replace(&mut seen_by[vertex.index()], face) == face {
                return Err(BelowLevel::MeetsTwice { face, hole: mesh.is_hole(face), vertex });
            }
        }
    }
    Ok(())
}

fn vertices_have_one_fan_of_faces(mesh: &Mesh) -> Result<(), BelowLevel> {
    for vertex in mesh.vertices().filter(|&v| !mesh.vertex_halfedge(v).is_none()) {
        let (mut spokes, mut faces, mut hole) = (0, 0, None);
        for face in mesh.spokes(vertex).map(|h| mesh.face(h)) {
            spokes += 1;
            if !mesh.is_hole(face) {
                faces += 1;
            } else if let Some(other) = hole.replace(face) {
                return Err(BelowLevel::Pinched { vertex, holes: [other, face] });
            }
        }
        if faces == 0 {
            return Err(BelowLevel::NoFaceAround { vertex });
        }
        if spokes < 2 {
            return Err(BelowLevel::SingleSpoke { vertex });
        }
    }
    Ok(())
}

pub(super) fn edges_have_a_face(
    mesh: &Mesh,
    edges: impl Iterator<Item = EdgeId>,
) -> Result<(), BelowLevel> {
    for edge in edges {
        let h = mesh.edge_halfedge(edge);
        if mesh.is_boundary_halfedge(h) && mesh.is_boundary_halfedge(mesh.twin(h)) {
            return Err(BelowLevel::NoFaceAlong { edge });
        }
    }
    Ok(())
}

fn edges_have_two_ends(mesh: &Mesh) -> Result<(), BelowLevel> {
    for edge in mesh.edges() {
        let h = mesh.edge_halfedge(edge);
        let vertex = mesh.vertex(h);
        if vertex == mesh.target(h) {
            return Err(BelowLevel::EndsWhereItBegins { edge, vertex });
        }
    }
    Ok(())
}

fn edges_are_single(mesh: &Mesh) -> Result<(), BelowLevel> {
    // Per vertex, the last spoke that reached it.
    let mut reached = vec![super::HalfedgeId::NONE; mesh.capacity(ElementKind::Vertex)];
    for vertex in mesh.vertices() {
        for h in mesh.spokes(vertex) {
            let target = mesh.target(h);
            let other = std::mem::replace(&mut reached[target.index()], h);
            if !other.is_none() && mesh.vertex(other) == vertex {
                let edges = [mesh.edge(other), mesh.edge(h)];
                return Err(BelowLevel::DoubleEdge { edges, ends: [vertex, target] });
            }
        }
    }
    Ok(())
}

/// For surfaces in which no two edges have the same ends.
fn faces_differ_in_corners(mesh: &Mesh) -> Result<(), BelowLevel> {
    // Two triangles with the same corners have the same edges, since no others join those.
    for edge in mesh.edges() {
        let h = mesh.edge_halfedge(edge);
        let two = [h, mesh.twin(h)];
        let is_triangle =
            |h| mesh.next(mesh.next(h)) == mesh.prev(h) && !mesh.is_boundary_halfedge(h);
        let [here, there] = two.map(|h| mesh.vertex(mesh.prev(h)));
        if here == there && two.into_iter().all(is_triangle) {
            let mut faces = two.map(|h| mesh.face(h));
            faces.sort_unstable();
            return Err(BelowLevel::SameCorners { faces });
        }
    }
    // The others, sorted by a sum over their corners; those with the same sum are compared.
    let mut sums = Vec::new();
    let has_more_sides = |face: FaceId| {
        let h = mesh.face_halfedge(face);
        mesh.next(mesh.next(h)) != mesh.prev(h)
    };
    for face in mesh.faces().filter(|&f| has_more_sides(f) && !mesh.is_hole(f)) {
        let corners = mesh.face_vertices(face).map(|v| scatter(u64::from(v.0)));
        sums.push((corners.fold(0, u64::wrapping_add), face));
    }
    sums.sort_unstable();
    for equal in sums.chunk_by(|a, b| a.0 == b.0).filter(|chunk| chunk.len() > 1) {
        let mut faces: Vec<_> = equal.iter().map(|&(_, f)| (sorted_corners(mesh, f), f)).collect();
        faces.sort_unstable();
        if let Some(pair) = faces.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(BelowLevel::SameCorners { faces: [pair[0].1, pair[1].1] });
        }
    }
    Ok(())
}

fn sorted_corners(mesh: &Mesh, face: FaceId) -> Vec<VertexId> {
    let mut corners: Vec<_> = mesh.face_vertices(face).collect();
    corners.sort_unstable();
    corners
}

/// Spreads numbers over all 64 bits, so that different sums of few rarely agree
/// (the finalizer of splitmix64; S. Vigna, 2015).
pub(super) fn scatter(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}
