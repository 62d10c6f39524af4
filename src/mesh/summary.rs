//! A mesh in numbers: counts, topology, sizes.

use glam::DVec3;
use serde::Serialize;

use super::connectivity::Mesh;
use super::id::{ElementKind, FaceId};
use super::level::{Level, highest_level, validate_level};

/// A summary of a mesh at a glance.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    pub vertices: usize,
    pub halfedges: usize,
    pub edges: usize,
    /// Faces that are not holes.
    pub faces: usize,
    /// Boundary loops.
    pub holes: usize,
    pub isolated_vertices: usize,
    /// The law that the mesh breaks, if any.
    pub invalid: Option<String>,
    pub level: Option<Level>,
    /// The reason why the mesh does not have the next level.
    pub below_next_level: Option<String>,
    /// Missing when the mesh is invalid.
    pub measures: Option<Measures>,
    pub attributes: Vec<AttributeSummary>,
}

/// A column that a program can name.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct AttributeSummary {
    pub name: String,
    /// The kind of the elements that have it.
    pub of: &'static str,
    #[serde(rename = "type")]
    pub ty: &'static str,
}

/// The measures of a valid mesh. Isolated vertices are left out, except from the bounds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measures {
    /// V - E + F, holes not counted.
    pub euler_characteristic: i64,
    pub components: usize,
    /// The number of handles, summed over components, every hole closed by a disk.
    pub genus: usize,
    /// The numbers of vertices by degree.
    pub degrees: Vec<Bin>,
    /// The numbers of faces by their number of sides. Holes are left out.
    pub face_sizes: Vec<Bin>,
    /// Missing when there are no edges.
    pub edge_lengths: Option<Lengths>,
    pub area: f64,
    /// The [enclosed volume](Mesh::volume); missing when there is a hole or no face.
    pub volume: Option<f64>,
    /// The corners of the bounding box; missing when there are no vertices.
    pub bounds: Option<[[f64; 3]; 2]>,
}

/// One bar of a histogram.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Bin {
    pub size: usize,
    pub count: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Lengths {
    pub min: f64,
    pub mean: f64,
    pub max: f64,
    pub standard_deviation: f64,
    /// The standard deviation as a share of the mean; 0 if all have length 0.
    pub spread: f64,
}

impl Summary {
    pub fn of(mesh: &Mesh) -> Self {
        let (level, invalid) = match highest_level(mesh) {
            Ok(level) => (Some(level), None),
            Err(invalid) => (None, Some(invalid.to_string())),
        };
        let next_level = level.and_then(|level| Level::ALL.into_iter().find(|&l| l > level));
        let below = next_level.and_then(|next| validate_level(mesh, next).err());
        Self {
            vertices: mesh.vertex_count(),
            halfedges: mesh.halfedge_count(),
            edges: mesh.edge_count(),
            faces: mesh.face_count(),
            holes: mesh.hole_count(),
            isolated_vertices: isolated_vertices(mesh),
            invalid,
            level,
            below_next_level: below.map(|reason| reason.to_string()),
            measures: level.map(|_| Measures::of(mesh)),
            attributes: attributes(mesh),
        }
    }
}

fn attributes(mesh: &Mesh) -> Vec<AttributeSummary> {
    let told = mesh.public_columns().map(|(id, column)| AttributeSummary {
        name: column.name().to_owned(),
        of: id.kind.name(),
        ty: column.attribute_type().name(),
    });
    told.collect()
}

fn isolated_vertices(mesh: &Mesh) -> usize {
    mesh.vertices().filter(|&v| mesh.vertex_halfedge(v).is_none()).count()
}

impl Mesh {
    /// V - E + F; holes and isolated vertices are not counted.
    pub fn euler_characteristic(&self) -> i64 {
        let surface_vertices = self.vertex_count() - isolated_vertices(self);
        surface_vertices as i64 - self.edge_count() as i64 + self.face_count() as i64
    }

    /// The sum of the areas of all faces; holes have none.
    pub fn surface_area(&self) -> f64 {
        // The sum of nothing, as `sum` has it, is -0.
        self.real_faces().map(|f| self.area(f)).fold(0.0, |sum, area| sum + area)
    }

    /// The enclosed volume, negative if the surface is inside out; `None` if there is a hole or no
    /// face. Faces with more than three sides are cut into triangles from their first corner.
    pub fn volume(&self) -> Option<f64> {
        let is_closed = self.hole_count() == 0 && self.face_count() > 0;
        let [apex, _] = self.bounds().filter(|_| is_closed)?;
        Some(self.real_faces().map(|f| cone_volume(self, f, apex)).sum())
    }

    /// The corners of the bounding box; `None` if there are no vertices.
    pub fn bounds(&self) -> Option<[DVec3; 2]> {
        let mut places = self.vertices().map(|v| self.position(v));
        let first = places.next()?;
        let (low, high) =
            places.fold((first, first), |(low, high), place| (low.min(place), high.max(place)));
        Some([low, high])
    }

    fn real_faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.faces().filter(|&f| !self.is_hole(f))
    }
}

impl Measures {
    fn of(mesh: &Mesh) -> Self {
        let euler_characteristic = mesh.euler_characteristic();
        let components = mesh.component_count();
        // Each component has V - E + F = 2 - 2g once its holes are faces.
        let closed = euler_characteristic + mesh.hole_count() as i64;
        let genus = components as i64 - closed / 2;
        let degrees = mesh.vertices().map(|v| mesh.degree(v)).filter(|&degree| degree > 0);
        Self {
            euler_characteristic,
            components,
            genus: usize::try_from(genus).unwrap_or(0),
            degrees: histogram(degrees),
            face_sizes: histogram(mesh.real_faces().map(|f| mesh.face_size(f))),
            edge_lengths: Lengths::of(mesh),
            area: mesh.surface_area(),
            volume: mesh.volume(),
            bounds: mesh.bounds().map(|corners| corners.map(|corner| corner.to_array())),
        }
    }
}

/// The signed volume between a face and a point.
fn cone_volume(mesh: &Mesh, face: FaceId, apex: DVec3) -> f64 {
    let corner = mesh.face_vertices(face).next().map_or(apex, |v| mesh.position(v));
    mesh.vector_area(face).dot(corner - apex) / 3.0
}

fn histogram(sizes: impl Iterator<Item = usize>) -> Vec<Bin> {
    let mut counts = std::collections::BTreeMap::new();
    for size in sizes {
        *counts.entry(size).or_insert(0) += 1;
    }
    counts.into_iter().map(|(size, count)| Bin { size, count }).collect()
}

impl Lengths {
    fn of(mesh: &Mesh) -> Option<Self> {
        let count = mesh.count(ElementKind::Edge);
        if count == 0 {
            return None;
        }
        let lengths = || mesh.edges().map(|e| mesh.length(e));
        let mean = lengths().sum::<f64>() / count as f64;
        let variance = lengths().map(|x| (x - mean) * (x - mean)).sum::<f64>() / count as f64;
        let standard_deviation = variance.sqrt();
        Some(Self {
            min: lengths().fold(f64::INFINITY, f64::min),
            mean,
            max: lengths().fold(0.0, f64::max),
            standard_deviation,
            spread: if mean > 0.0 { standard_deviation / mean } else { 0.0 },
        })
    }
}
