//! Differences between two meshes, in the order in which a person would look for them: the numbers
//! of elements, the positions of vertices, the edges and faces between these.

use std::collections::{HashMap, HashSet};
use std::fmt;

use glam::DVec3;

use super::connectivity::Mesh;
use super::id::{EdgeId, FaceId, VertexId};

/// A position, with as many digits as a person reads.
fn place(position: DVec3) -> String {
    let [x, y, z] = position.to_array().map(|at| (at * 1e6).round() / 1e6 + 0.0);
    format!("({x}, {y}, {z})")
}

/// The first difference between two meshes, in terms of the first mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum Difference {
    /// The numbers of some elements differ.
    Counts(Vec<Count>),
    /// Vertices lie where the other mesh has none.
    Elsewhere {
        /// The number of these vertices.
        vertices: usize,
        /// The first of them.
        first: VertexId,
        /// Its position.
        position: DVec3,
    },
    /// A vertex of the other mesh lies where this one has none.
    Missing {
        /// The first of them.
        first: VertexId,
        /// Its position.
        position: DVec3,
    },
    /// The other mesh has no edge between the corresponding vertices.
    Edge(EdgeId, [VertexId; 2]),
    /// The other mesh has no such face, or hole, with the corresponding corners.
    Face(FaceId, Vec<VertexId>),
    /// Vertices, edges and faces are the same, but connected differently; or vertices coincide, so
    /// that elements cannot be told apart by position.
    Connected,
}

/// The numbers of some elements in the two meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    what: &'static str,
    ours: usize,
    theirs: usize,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Counts(counts) => {
                let each = counts.iter().map(|Count { what, ours, theirs }| {
                    format!("the mesh has {ours} {what}, the other {theirs}")
                });
                f.write_str(&each.collect::<Vec<_>>().join("; "))
            }
            Self::Elsewhere { vertices, first, position } => {
                let place = place(*position);
                let them = match vertices {
                    1 => "a vertex lies".to_owned(),
                    several => format!("{several} vertices lie"),
                };
                let first = first.0;
                write!(
                    f,
                    "{them} where the other mesh has none; the first is vertex {first}, at {place}"
                )
            }
            Self::Missing { first, position } => {
                let (first, place) = (first.0, place(*position));
                write!(f, "no vertex lies where the other mesh has vertex {first}, at {place}")
            }
            Self::Edge(edge, [v, w]) => write!(
                f,
                "the other mesh has no edge where edge {} is, between vertices {} and {}",
                edge.0, v.0, w.0
            ),
            Self::Face(face, corners) => {
                let corners: Vec<_> = corners.iter().map(|v| v.0.to_string()).collect();
                write!(
                    f,
                    "the other mesh has no such face as face {}, around vertices {}",
                    face.0,
                    corners.join(", ")
                )
            }
            Self::Connected => f.write_str("the meshes are connected differently"),
        }
    }
}

/// The first difference between two meshes that are known not to be the same, where each coordinate
/// may be off by `tolerance`.
pub fn difference(ours: &Mesh, theirs: &Mesh, tolerance: f64) -> Difference {
    let counts = [
        ("vertices", Mesh::vertex_count as fn(&Mesh) -> usize),
        ("edges", Mesh::edge_count),
        ("faces", Mesh::face_count),
        ("holes", Mesh::hole_count),
    ];
    let counts =
        counts.map(|(what, count)| Count { what, ours: count(ours), theirs: count(theirs) });
    let differ: Vec<_> = counts.into_iter().filter(|c| c.ours != c.theirs).collect();
    if !differ.is_empty() {
        return Difference::Counts(differ);
    }
    let cells = Cells::of(theirs, tolerance);
    let pairs: Vec<_> = ours.vertices().map(|v| (v, cells.near(ours.position(v)))).collect();
    let mut alone = pairs.iter().filter(|(_, near)| near.is_none());
    if let Some(&(first, _)) = alone.next() {
        let (vertices, position) = (1 + alone.count(), ours.position(first));
        return Difference::Elsewhere { vertices, first, position };
    }
    let partner: HashMap<_, _> =
        pairs.into_iter().filter_map(|(v, near)| Some((v, near?))).collect();
    let taken: HashSet<_> = partner.values().collect();
    if taken.len() < partner.len() {
        let here = Cells::of(ours, tolerance);
        let is_missing = |v: &VertexId| here.near(theirs.position(*v)).is_none();
        return match theirs.vertices().find(is_missing) {
            Some(first) => Difference::Missing { first, position: theirs.position(first) },
            None => Difference::Connected,
        };
    }
    other_edge(ours, theirs, &partner)
        .or_else(|| other_face(ours, theirs, &partner))
        .unwrap_or(Difference::Connected)
}

type Partners = HashMap<VertexId, VertexId>;

fn other_edge(ours: &Mesh, theirs: &Mesh, partner: &Partners) -> Option<Difference> {
    let sorted = |[v, w]: [VertexId; 2]| [v.min(w), v.max(w)];
    let known: HashSet<_> = theirs.edges().map(|e| sorted(ends(theirs, e))).collect();
    let (edge, between) = ours.edges().map(|e| (e, ends(ours, e))).find(|(_, between)| {
        let there = between.map(|v| partner.get(&v).copied().unwrap_or(v));
        !known.contains(&sorted(there))
    })?;
    Some(Difference::Edge(edge, between))
}

fn ends(mesh: &Mesh, e: EdgeId) -> [VertexId; 2] {
    let h = mesh.edge_halfedge(e);
    [mesh.vertex(h), mesh.vertex(mesh.twin(h))]
}

fn other_face(ours: &Mesh, theirs: &Mesh, partner: &Partners) -> Option<Difference> {
    let known: HashSet<_> =
        theirs.faces().map(|f| from_the_least(theirs.face_vertices(f).collect())).collect();
    let (face, _) = ours.faces().map(|f| (f, ours.face_vertices(f))).find(|(f, _)| {
        let there = ours.face_vertices(*f).map(|v| partner.get(&v).copied().unwrap_or(v));
        !known.contains(&from_the_least(there.collect()))
    })?;
    Some(Difference::Face(face, ours.face_vertices(face).collect()))
}

/// The corners of a face, rotated so that the least comes first.
fn from_the_least(mut corners: Vec<VertexId>) -> Vec<VertexId> {
    let least = (0..corners.len()).min_by_key(|&at| corners[at]);
    corners.rotate_left(least.unwrap_or(0));
    corners
}

/// The vertices of a mesh, by the cells of a grid, to find those near a point.
struct Cells<'m> {
    mesh: &'m Mesh,
    tolerance: f64,
    inside: HashMap<[i64; 3], Vec<VertexId>>,
}

impl<'m> Cells<'m> {
    fn of(mesh: &'m Mesh, tolerance: f64) -> Self {
        let mut cells = Self { mesh, tolerance, inside: HashMap::new() };
        for v in mesh.vertices() {
            cells.inside.entry(cells.cell(mesh.position(v))).or_default().push(v);
        }
        cells
    }

    /// The cell of a point. Cells are wider than the tolerance, so vertices near a point lie in its
    /// cell or an adjacent one.
    fn cell(&self, p: DVec3) -> [i64; 3] {
        let width = 2.0 * self.tolerance.max(f64::MIN_POSITIVE);
        p.to_array().map(|x| (x / width).floor() as i64)
    }

    /// The first vertex, by id, that lies near a point.
    fn near(&self, p: DVec3) -> Option<VertexId> {
        let [x, y, z] = self.cell(p);
        let steps = [-1_i64, 0, 1];
        let beside = steps.into_iter().flat_map(|i| {
            let rows = steps.into_iter().flat_map(move |j| steps.map(|k| (j, k)));
            rows.map(move |(j, k)| [x, y, z].into_iter().zip([i, j, k]))
        });
        let cells = beside.filter_map(|moved| {
            let cell: Vec<_> = moved.map(|(at, by)| at.saturating_add(by)).collect();
            self.inside.get(<&[i64; 3]>::try_from(cell.as_slice()).ok()?)
        });
        let is_near =
            |v: &&VertexId| (self.mesh.position(**v) - p).abs().max_element() <= self.tolerance;
        cells.filter_map(|inside| inside.iter().find(is_near)).min().copied()
    }
}
