//! Values of attributes that a file of a format does not hold as they are.

use super::format::FileFormat;
use super::mesh_file::MeshFile;
use crate::mesh::attribute::{AttributeType, Column, ColumnId, Value};
use crate::mesh::id::{ElementKind, FaceId, HalfedgeId};

/// Values of an attribute that a file does not hold as they are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LostValues<'f> {
    /// The kind of the elements.
    pub kind: ElementKind,
    /// The name of the attribute.
    pub name: &'f str,
    /// The number of values.
    pub count: usize,
    /// The reason why the file does not hold them.
    pub loss: Loss,
}

/// The reason why a file does not hold values as they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    /// They belong to holes or to halfedges of holes, which the file does not have.
    AtHoles,
    /// They are integers beyond 2^53, which the file rounds.
    Rounded,
    /// They are colours with components below 0 or above 1, which the file means otherwise.
    NoColours,
}

impl MeshFile {
    /// The values of attributes that a file of a format holds, but not as they are.
    pub fn lost_values(&self, format: FileFormat) -> Vec<LostValues<'_>> {
        if format == FileFormat::Halfedges {
            return Vec::new();
        }
        let unheld = self.unheld(format);
        let mut lost = Vec::new();
        for (id, column) in self.mesh.public_columns() {
            let (kind, name) = (id.kind, column.name());
            if unheld.iter().any(|(of, other, _)| (*of, *other) == (kind, name)) {
                continue;
            }
            let is_colour = ["color", "alpha"].contains(&name) && format == FileFormat::Off;
            let is_int = column.attribute_type() == AttributeType::Int;
            let rounded = if is_int { self.count(id, |_, value| is_rounded(value)) } else { 0 };
            let others =
                if is_colour { self.count(id, |_, value| !is_colour_part(value)) } else { 0 };
            let losses = [
                (Loss::AtHoles, self.count_at_holes(id, column)),
                (Loss::Rounded, rounded),
                (Loss::NoColours, others),
            ];
            let losses = losses.into_iter().filter(|(_, count)| *count > 0);
            lost.extend(losses.map(|(loss, count)| LostValues { kind, name, count, loss }));
        }
        lost
    }

    /// The number of values other than the default at holes and their halfedges; texture
    /// coordinates and normals of halfedges are meant for corners of faces alone.
    fn count_at_holes(&self, id: ColumnId, column: &Column) -> usize {
        let mesh = &self.mesh;
        let is_hole = |face| mesh.get_is_hole(face) == Some(true);
        let is_at_hole = |index: u32| match id.kind {
            ElementKind::Face => is_hole(FaceId(index)),
            ElementKind::Halfedge => {
                mesh.get_halfedge(HalfedgeId(index)).is_some_and(|half| is_hole(half.face))
            }
            ElementKind::Vertex | ElementKind::Edge => false,
        };
        let usual = column.default_value();
        let is_of_corners =
            id.kind == ElementKind::Halfedge && ["uv", "normal"].contains(&column.name());
        if mesh.hole_count() == 0 || is_of_corners {
            return 0;
        }
        self.count(id, |index, value| is_at_hole(index) && !value.is_identical(usual))
    }

    /// The number of living elements whose number and value fulfil a condition.
    fn count(&self, id: ColumnId, is_so: impl Fn(u32, Value) -> bool) -> usize {
        let counts =
            |&index: &u32| self.mesh.value(id, index).is_some_and(|value| is_so(index, value));
        self.mesh.elements(id.kind).filter(counts).count()
    }
}

/// Whether an integer changes when it is written as a real number of 64 bits and read back.
fn is_rounded(value: Value) -> bool {
    matches!(value, Value::Int(n) if n as f64 as i64 != n)
}

/// Whether all components are from 0 to 1.
fn is_colour_part(value: Value) -> bool {
    value.reals().iter().all(|part| (0.0..=1.0).contains(part))
}
