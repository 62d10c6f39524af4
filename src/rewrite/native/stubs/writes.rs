//! Writes of which a journal or a drain is notified in advance.

use super::Answer;
use crate::mesh::{ElementKind, VertexId};
use crate::rewrite::native::context::{Context, Run};
use crate::rewrite::{ElementField, HalfedgeField, attribute};

/// The pointers to the halfedge of an element, by number.
const FIRST: [ElementField; 3] = [ElementField::Vertex, ElementField::Edge, ElementField::Face];

/// Reports that a pointer of a living halfedge is about to be set to `value`.
pub(super) fn pointer_set(
    _: &mut Context,
    run: &mut Run<'_>,
    field: i64,
    halfedge: i64,
    value: i64,
) -> Answer {
    if let Some(&field) = HalfedgeField::ALL.get(field as usize) {
        let Run { machine, mesh, .. } = run;
        machine.drains.pointer_set(mesh, field, halfedge as u32, value as u32);
        mesh.note_element(ElementKind::Halfedge, halfedge as u32);
    }
    Ok(0)
}

/// Reports that the halfedge of a living element is about to be set to `value`.
pub(super) fn first_set(
    _: &mut Context,
    run: &mut Run<'_>,
    of: i64,
    element: i64,
    value: i64,
) -> Answer {
    if let Some(&of) = FIRST.get(of as usize) {
        let Run { machine, mesh, .. } = run;
        machine.drains.first_set(mesh, of, element as u32, value as u32);
        mesh.note_element(of.kind(), element as u32);
    }
    Ok(0)
}

/// Reports that the position of a living vertex is about to be set.
pub(super) fn position_set(_: &mut Context, run: &mut Run<'_>, vertex: i64) -> Answer {
    let Run { machine, mesh, .. } = run;
    machine.drains.position_set(mesh, vertex as u32);
    mesh.note_place(VertexId(vertex as u32));
    Ok(0)
}

/// Reports that an attribute of a living element is about to be set.
pub(super) fn value_set(_: &mut Context, run: &mut Run<'_>, number: i64, element: i64) -> Answer {
    let Run { machine, mesh, .. } = run;
    if let Ok(column) = attribute::column(&machine.columns, number as u16) {
        machine.drains.attribute_set(mesh, (number as u16, column.kind), element as u32);
        mesh.note_value(column, element as u32);
    }
    Ok(0)
}
