//! Writing a dump.

use std::io::{self, Write};

use glam::DVec3;

use super::Dump;
use crate::mesh::attribute::{Column, ColumnId, Value};
use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{Element, ElementKind};

/// The text of a dump.
pub fn write_dump(dump: &Dump) -> String {
    let mut text = Vec::new();
    match write_parts(&mut text, dump) {
        Ok(()) => String::from_utf8_lossy(&text).into_owned(),
        Err(_) => String::new(), // memory takes every text
    }
}

fn write_parts(output: &mut dyn Write, dump: &Dump) -> io::Result<()> {
    for line in dump.remarks.iter().flat_map(|remark| remark.lines()) {
        writeln!(output, "# {line}")?;
    }
    for (name, mesh) in &dump.meshes {
        write_table(output, name, mesh)?;
    }
    for (name, elements) in &dump.names {
        let kind = elements.first().map_or(ElementKind::Halfedge, |first| first.kind);
        let ids: String = elements.iter().map(|of| format!(" {}", of.index)).collect();
        writeln!(output, "name {name} {kind}{ids}")?;
    }
    Ok(())
}

/// Writes the table of a mesh. The output should be buffered.
pub(in crate::mesh) fn write_table(
    output: &mut dyn Write,
    name: &str,
    mesh: &Mesh,
) -> io::Result<()> {
    writeln!(output, "mesh {name}")?;
    let id = |element: Element| match element.index {
        u32::MAX => "-".into(),
        index => index.to_string(),
    };
    for vertex in mesh.vertices() {
        let half = id(mesh.vertex_halfedge(vertex).into());
        let DVec3 { x, y, z } = mesh.position(vertex);
        writeln!(output, "vertex {} halfedge {half} at {x} {y} {z}", vertex.0)?;
    }
    for half in mesh.halfedges() {
        let record = mesh.halfedge(half);
        writeln!(
            output,
            "halfedge {} next {} prev {} twin {} vertex {} edge {} face {}",
            half.0,
            id(record.next.into()),
            id(record.prev.into()),
            id(record.twin.into()),
            id(record.vertex.into()),
            id(record.edge.into()),
            id(record.face.into()),
        )?;
    }
    for edge in mesh.edges() {
        let half = id(mesh.edge_halfedge(edge).into());
        writeln!(output, "edge {} halfedge {half}", edge.0)?;
    }
    for face in mesh.faces() {
        let half = id(mesh.face_halfedge(face).into());
        let word = if mesh.is_hole(face) { "hole" } else { "face" };
        writeln!(output, "{word} {} halfedge {half}", face.0)?;
    }
    let mut columns = mesh.public_columns();
    columns.try_for_each(|(id, column)| write_column(output, mesh, id, column))
}

/// A column, with a line for each living element whose value is not the default.
fn write_column(
    output: &mut dyn Write,
    mesh: &Mesh,
    id: ColumnId,
    column: &Column,
) -> io::Result<()> {
    let (name, ty) = (column.name(), column.attribute_type());
    let default = column.default_value();
    writeln!(output, "attribute {} {name} {ty} {}", id.kind, words(default))?;
    for index in 0..mesh.capacity(id.kind) as u32 {
        let value = mesh.value(id, index);
        if let Some(value) = value.filter(|value| !value.is_identical(default)) {
            writeln!(output, "value {index} {}", words(value))?;
        }
    }
    Ok(())
}

/// A value as its numbers, matrices column by column.
fn words(value: Value) -> String {
    match value {
        Value::Bool(truth) => truth.to_string(),
        Value::Int(number) => number.to_string(),
        _ => value.reals().iter().map(f64::to_string).collect::<Vec<_>>().join(" "),
    }
}
