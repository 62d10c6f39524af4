//! Writing a dump.

use glam::DVec3;

use super::Dump;
use crate::mesh::attribute::{Column, ColumnId, Value};
use crate::mesh::connectivity::Mesh;
use crate::mesh::id::{Element, ElementKind};

/// The text of a dump.
pub fn write_dump(dump: &Dump) -> String {
    let mut lines: Vec<String> = Vec::new();
    let remarks = dump.remarks.iter().flat_map(|remark| remark.lines());
    lines.extend(remarks.map(|line| format!("# {line}")));
    for (name, mesh) in &dump.meshes {
        lines.push(format!("mesh {name}"));
        write_mesh(mesh, &mut lines);
    }
    for (name, elements) in &dump.names {
        let kind = elements.first().map_or(ElementKind::Halfedge, |first| first.kind);
        let ids: String = elements.iter().map(|of| format!(" {}", of.index)).collect();
        lines.push(format!("name {name} {kind}{ids}"));
    }
    lines.push(String::new());
    lines.join("\n")
}

fn write_mesh(mesh: &Mesh, lines: &mut Vec<String>) {
    let id = |element: Element| match element.index {
        u32::MAX => "-".into(),
        index => index.to_string(),
    };
    for vertex in mesh.vertices() {
        let half = id(mesh.vertex_halfedge(vertex).into());
        let DVec3 { x, y, z } = mesh.position(vertex);
        lines.push(format!("vertex {} halfedge {half} at {x} {y} {z}", vertex.0));
    }
    for half in mesh.halfedges() {
        let record = mesh.halfedge(half);
        lines.push(format!(
            "halfedge {} next {} prev {} twin {} vertex {} edge {} face {}",
            half.0,
            id(record.next.into()),
            id(record.prev.into()),
            id(record.twin.into()),
            id(record.vertex.into()),
            id(record.edge.into()),
            id(record.face.into()),
        ));
    }
    for edge in mesh.edges() {
        let half = id(mesh.edge_halfedge(edge).into());
        lines.push(format!("edge {} halfedge {half}", edge.0));
    }
    for face in mesh.faces() {
        let half = id(mesh.face_halfedge(face).into());
        let word = if mesh.is_hole(face) { "hole" } else { "face" };
        lines.push(format!("{word} {} halfedge {half}", face.0));
    }
    for (id, column) in mesh.sayable_columns() {
        write_column(mesh, id, column, lines);
    }
}

/// A column, with a line for each living element whose value is not the default.
fn write_column(mesh: &Mesh, id: ColumnId, column: &Column, lines: &mut Vec<String>) {
    let (name, ty) = (column.name(), column.attribute_type());
    let default = column.default_value();
    lines.push(format!("attribute {} {name} {ty} {}", id.kind, words(default)));
    for index in 0..mesh.capacity(id.kind) as u32 {
        let value = mesh.value(id, index);
        if let Some(value) = value.filter(|value| !value.is_identical(default)) {
            lines.push(format!("value {index} {}", words(value)));
        }
    }
}

/// A value as its numbers, matrices column by column.
fn words(value: Value) -> String {
    match value {
        Value::Bool(truth) => truth.to_string(),
        Value::Int(number) => number.to_string(),
        _ => value.reals().iter().map(f64::to_string).collect::<Vec<_>>().join(" "),
    }
}
