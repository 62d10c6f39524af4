//! The contents of a file, and the mesh built from them.

use std::collections::HashMap;

use glam::DVec3;

use super::error::{BAD_INDICES, BadIndices, Damage, Failure, FileFaults, FileReason};
use super::format::{Encoding, MshVersion};
use super::kept::{Kept, MISSING};
use super::mesh_file::MeshFile;
use crate::mesh::attribute::{AttributeType, ColumnId, Value};
use crate::mesh::build_error::BuildError;
use crate::mesh::connectivity::Mesh;
use crate::mesh::faults::Faults;
use crate::mesh::id::{EdgeId, ElementKind};
use crate::mesh::polygons::Polygons;
use crate::mesh::repair::{Repair, RepairReport, Repaired};

/// The contents of a file.
#[derive(Default)]
pub(super) struct Contents {
    pub(super) positions: Vec<DVec3>,
    /// A corner with an invalid index is [`MISSING`], and counted in `bad_indices`.
    pub(super) polygons: Polygons,
    pub(super) columns: Vec<FileColumn>,
    /// The edges that the file has beside its faces, by their vertices.
    pub(super) edges: Vec<[u32; 2]>,
    pub(super) kept: Kept,
    pub(super) bad_indices: BadIndices,
    /// The parts that could not be read.
    pub(super) damage: Damage,
    /// The lines of vertices and faces; empty if the file has no lines.
    pub(super) vertex_lines: Vec<u32>,
    pub(super) face_lines: Vec<u32>,
    pub(super) encoding: Encoding,
    pub(super) msh_version: MshVersion,
}

/// A column of a file: values of vertices, polygons, corners (as halfedges) or edges, in file
/// order.
pub(super) struct FileColumn {
    kind: ElementKind,
    name: String,
    default: Value,
    /// The reals of the values, one after the other; one for each bool or int.
    reals: Vec<f64>,
}

impl FileColumn {
    pub(super) fn new(kind: ElementKind, name: &str, default: Value, reals: Vec<f64>) -> Self {
        Self { kind, name: name.to_owned(), default, reals }
    }

    /// True if the column has the given kind and name.
    pub(super) fn is(&self, kind: ElementKind, name: &str) -> bool {
        self.kind == kind && self.name == name
    }

    fn value(&self, at: u32) -> Option<Value> {
        let ty = self.default.attribute_type();
        let width = ty.width();
        let reals = self.reals.get(at as usize * width..(at as usize + 1) * width)?;
        match ty {
            AttributeType::Bool => Some(Value::Bool(reals[0] != 0.0)),
            AttributeType::Int => Some(Value::Int(reals[0] as i64)),
            _ => Value::from_reals(ty, reals),
        }
    }

    /// Adds the column to a mesh, without its values. A name that another has gets underscores.
    fn add(&self, mesh: &mut Mesh, kind: ElementKind, kept: &mut Kept) -> Option<ColumnId> {
        let mut name = self.name.clone();
        while mesh.find_column(kind, &name).is_some() {
            name.push('_');
        }
        if name != self.name {
            let what =
                format!("{kind} attribute that is `{name}` now, since another is `{}`", self.name);
            kept.note_count([&what; 2], 1);
        }
        mesh.add_column(kind, &name, self.default).ok()
    }

    /// Sets the values of the elements, from id 0 on, to those at the given places of the file.
    fn give(
        &self,
        mesh: &mut Mesh,
        kind: ElementKind,
        kept: &mut Kept,
        places: impl Iterator<Item = u32>,
    ) {
        let Some(column) = self.add(mesh, kind, kept) else { return };
        for (index, place) in (0..).zip(places) {
            if let Some(value) = self.value(place) {
                mesh.put_value(column, index, value);
            }
        }
    }
}

impl Contents {
    /// Builds the mesh. `repair` says what to repair; with `reorder`, neighbors are placed near
    /// each other in memory.
    pub(super) fn build(
        mut self,
        repair: Option<Repair>,
        reorder: bool,
    ) -> Result<MeshFile, Failure> {
        let Damage { count: damaged_places, first: damage } = std::mem::take(&mut self.damage);
        if let (None, Some((line, words))) = (repair, damage.clone()) {
            return Err((line, FileReason::Damaged(words)));
        }
        let mut file = self.build_undamaged(repair, reorder)?;
        if let Some(report) = &mut file.repaired {
            report.damaged_places = damaged_places;
        }
        file.damage = damage;
        Ok(file)
    }

    /// How the faces count vertices, of which there are some, if they seem to count from another
    /// number than the format does: all indices would be right then.
    fn wrong_start(&self, vertices: usize) -> Option<&'static str> {
        let uses = |vertex: usize| self.polygons.corners().contains(&(vertex as u32));
        match self.bad_indices.shifted_from()? {
            // Not only texture coordinates and normals have the index 0.
            1 if uses(MISSING as usize) && !uses(vertices.checked_sub(1)?) => {
                Some("from 0, and the format counts from 1")
            }
            0 if !uses(0) => Some("from 1, and the format counts from 0"),
            _ => None,
        }
    }

    fn build_undamaged(
        mut self,
        repair: Option<Repair>,
        reorder: bool,
    ) -> Result<MeshFile, Failure> {
        let positions = std::mem::take(&mut self.positions);
        let merge = repair.and_then(|repair| repair.merge);
        let is_sound = self.bad_indices.count() == 0 && merge.is_none();
        if reorder
            && is_sound
            && let Some(reordered) = Repaired::in_order(&positions, &self.polygons, positions.len())
        {
            let corners = std::mem::take(&mut self.polygons).into_corners();
            let mut file = self.finish_repaired(reordered, positions.len(), &corners);
            file.repaired = repair.map(|_| RepairReport::default());
            return Ok(file);
        }
        let positions = match is_sound {
            false => positions,
            true => match Mesh::build(positions, &self.polygons) {
                Ok(mesh) => {
                    let mut file = self.finish(mesh);
                    file.repaired = repair.map(|_| RepairReport::default());
                    return Ok(file);
                }
                Err((BuildError::TooLarge { kind }, _)) => {
                    return Err((None, FileReason::TooLarge { kind }));
                }
                Err((_, positions)) => positions,
            },
        };
        let Some(repair) = repair else {
            let faults = Faults::of(&positions, &self.polygons);
            let lines = [&self.vertex_lines[..], &self.face_lines[..]];
            let wrong_start = self.wrong_start(positions.len());
            let mut faults = FileFaults::new(&faults, self.bad_indices, lines);
            faults.wrong_start = wrong_start;
            return Err((faults.line(), FileReason::Faults(faults)));
        };
        self.kept.note_count(BAD_INDICES, self.bad_indices.count());
        let count = positions.len();
        let corners = self.polygons.corners().to_vec();
        let polygons = std::mem::take(&mut self.polygons);
        let repaired = Repaired::new(positions, polygons, repair).map_err(|error| {
            let kind = match error {
                BuildError::TooLarge { kind } => kind,
                _ => ElementKind::Vertex, // all else is mended
            };
            (None, FileReason::TooLarge { kind })
        })?;
        let repaired = if reorder { repaired.reordered() } else { repaired };
        Ok(self.finish_repaired(repaired, count, &corners))
    }

    /// Finishes a mesh whose elements are those of the file.
    fn finish(mut self, mut mesh: Mesh) -> MeshFile {
        self.give_edges(&mut mesh, |v| v);
        for column in &self.columns {
            let count = match column.kind {
                ElementKind::Vertex => mesh.vertex_count(),
                ElementKind::Face => self.polygons.len(),
                ElementKind::Halfedge => self.polygons.corners().len(),
                ElementKind::Edge => continue,
            };
            column.give(&mut mesh, column.kind, &mut self.kept, 0..count as u32);
        }
        if self.kept.needs_polygons() {
            self.kept.corners = self.polygons;
        }
        let mut file = MeshFile::from_file(mesh, self.kept);
        (file.encoding, file.msh_version) = (self.encoding, self.msh_version);
        file
    }

    /// Finishes a repaired mesh; `corners` are the vertices that the corners of the file had.
    fn finish_repaired(mut self, repaired: Repaired, count: usize, corners: &[u32]) -> MeshFile {
        let Repaired { mut mesh, vertices, kept_vertices, faces, corners: places, report } =
            repaired;
        let mut numbers = vec![MISSING; count];
        for (slot, &vertex) in (0..).zip(&vertices[..kept_vertices]) {
            numbers[vertex as usize] = slot;
        }
        self.give_edges(&mut mesh, |v| numbers.get(v as usize).copied().unwrap_or(MISSING));
        let kept = &mut self.kept;
        for column in &self.columns {
            match column.kind {
                ElementKind::Vertex if !column.is_alike(&places, corners, &vertices, &mesh) => {
                    // Vertices with different values have become one: the corners keep the values.
                    let places = places.iter().map(|&place| corners[place as usize]);
                    column.give(&mut mesh, ElementKind::Halfedge, kept, places);
                    let what =
                        format!("vertex attribute `{}`, which the corners have now", column.name);
                    kept.note_count([&what; 2], 1);
                }
                ElementKind::Vertex => {
                    column.give(&mut mesh, column.kind, kept, vertices.iter().copied());
                }
                ElementKind::Face => {
                    column.give(&mut mesh, column.kind, kept, faces.iter().copied());
                }
                ElementKind::Halfedge => {
                    column.give(&mut mesh, column.kind, kept, places.iter().copied());
                }
                ElementKind::Edge => {}
            }
        }
        if self.kept.needs_polygons() {
            for table in [&mut self.kept.corner_texture, &mut self.kept.corner_normals] {
                if !table.is_empty() {
                    *table = places.iter().map(|&place| table[place as usize]).collect();
                }
            }
            let vertices = mesh.halfedges().take(places.len()).map(|h| mesh.vertex(h).0).collect();
            let ends = mesh.faces().take(faces.len()).scan(0, |end, f| {
                *end += mesh.face_halfedges(f).count();
                Some(*end)
            });
            self.kept.corners = Polygons::of_parts(vertices, ends.collect());
        }
        let mut file = MeshFile::from_file(mesh, self.kept);
        (file.encoding, file.msh_version) = (self.encoding, self.msh_version);
        file.renumber(vertices[..kept_vertices].to_vec(), faces);
        file.repaired = Some(report);
        file
    }

    /// Gives the edges of the file their values; `slot` maps a vertex of the file to its slot.
    fn give_edges(&mut self, mesh: &mut Mesh, slot: impl Fn(u32) -> u32) {
        if self.edges.is_empty() {
            return;
        }
        let sorted = |v: u32, w: u32| [v.min(w), v.max(w)];
        let known = mesh.edges().map(|edge| {
            let h = mesh.edge_halfedge(edge);
            (sorted(mesh.vertex(h).0, mesh.target(h).0), edge)
        });
        let known: HashMap<[u32; 2], EdgeId> = known.collect();
        let find = |&[v, w]: &[u32; 2]| known.get(&sorted(slot(v), slot(w))).copied();
        let edges: Vec<Option<EdgeId>> = self.edges.iter().map(find).collect();
        for column in self.columns.iter().filter(|column| column.kind == ElementKind::Edge) {
            let Some(id) = column.add(mesh, ElementKind::Edge, &mut self.kept) else { continue };
            for (place, edge) in (0..).zip(&edges) {
                if let (Some(edge), Some(value)) = (edge, column.value(place)) {
                    mesh.put_value(id, edge.0, value);
                }
            }
        }
        if let Some(first) = edges.iter().position(Option::is_none) {
            let what = ["edge", "edges"]
                .map(|word| format!("{word} that no face has, first in row {}", first + 1));
            self.kept.note_count(what, edges.iter().filter(|edge| edge.is_none()).count());
        }
    }
}

impl FileColumn {
    /// True if all corners that were moved to another vertex had the value of that vertex.
    fn is_alike(&self, places: &[u32], corners: &[u32], vertices: &[u32], mesh: &Mesh) -> bool {
        let same = |place: u32, vertex: u32| {
            let was = corners[place as usize];
            was == vertex
                || match (self.value(was), self.value(vertex)) {
                    (Some(a), Some(b)) => a.is_identical(b),
                    _ => true,
                }
        };
        let mut halfedges = mesh.halfedges().zip(places);
        halfedges.all(|(h, &place)| same(place, vertices[mesh.vertex(h).index()]))
    }
}
