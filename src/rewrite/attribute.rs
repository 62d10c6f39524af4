//! Declared attributes through registers, and deferred writes, which are kept back in a buffer.
//!
//! A column is a dense array of values of one type. A value in the window takes one slot for each
//! component, matrices column by column, as the language lays them out.

use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};

use super::access::gone;
use super::window::Window;
use super::{Fault, Reg};
use crate::mesh::{ColumnData, ColumnId, Mesh, VertexId};

/// In place of an attribute's number: a position is kept back.
pub(super) const POSITION: u32 = u32::MAX;

/// The header of a value that is kept back: its number of slots, and its attribute.
pub(super) fn header(attribute: u32, width: u16) -> u64 {
    u64::from(width) << 32 | u64::from(attribute)
}

/// Keeps a position back: appends a header, the vertex and the slots.
pub(super) fn hold_position(vertex: VertexId, position: DVec3, held: &mut Vec<u64>) {
    held.extend([header(POSITION, 3), u64::from(vertex.0)]);
    held.extend(position.to_array().map(f64::to_bits));
}

/// The column of an attribute in the mesh.
#[inline]
pub(super) fn column(columns: &[Option<ColumnId>], attribute: u16) -> Result<ColumnId, Fault> {
    let column = columns.get(usize::from(attribute)).copied().flatten();
    column.ok_or(Fault::Malformed)
}

/// The number of slots that a value takes.
#[inline]
fn width(data: &ColumnData) -> u16 {
    data.attribute_type().width() as u16
}

/// The index of a living element in its column.
#[inline]
fn index(mesh: &Mesh, column: ColumnId, id: u32) -> Result<usize, Fault> {
    match mesh.is_alive(column.kind, id) {
        true => Ok(id as usize),
        false => Err(gone(column.kind, id)),
    }
}

/// Reads the value of a living element.
#[inline]
pub(super) fn load(
    mesh: &Mesh,
    column: ColumnId,
    id: u32,
    w: &mut Window,
    to: Reg,
) -> Result<(), Fault> {
    let at = index(mesh, column, id)?;
    let data = mesh.column(column).ok_or(Fault::Malformed)?.data();
    // A column is as long as the table of its kind.
    let beyond = Fault::Malformed;
    match data {
        ColumnData::Bool(all) => w.set_truth(to, *all.get(at).ok_or(beyond)?),
        ColumnData::Int(all) => w.set_int(to, *all.get(at).ok_or(beyond)?),
        ColumnData::Real(all) => w.set_real(to, *all.get(at).ok_or(beyond)?),
        ColumnData::Vec2(all) => w.set_reals(to, all.get(at).ok_or(beyond)?.as_ref()),
        ColumnData::Vec3(all) => w.set_vector(to, *all.get(at).ok_or(beyond)?),
        ColumnData::Vec4(all) => w.set_reals(to, all.get(at).ok_or(beyond)?.as_ref()),
        ColumnData::Mat3(all) => w.set_reals(to, all.get(at).ok_or(beyond)?.as_ref()),
        ColumnData::Mat4(all) => w.set_reals(to, all.get(at).ok_or(beyond)?.as_ref()),
    }
    Ok(())
}

/// Writes the value of a living element.
#[inline]
pub(super) fn store(
    mesh: &mut Mesh,
    column: ColumnId,
    id: u32,
    w: &Window,
    value: Reg,
) -> Result<(), Fault> {
    let at = index(mesh, column, id)?;
    put(mesh, column, at, |part| w.bits(Reg(value.0.wrapping_add(part))))
}

/// Writes a value; `slot` returns its slots.
#[inline]
fn put(
    mesh: &mut Mesh,
    column: ColumnId,
    at: usize,
    slot: impl Fn(u16) -> u64,
) -> Result<(), Fault> {
    mesh.note_value(column, at as u32);
    let data = mesh.column_data_mut(column).ok_or(Fault::Malformed)?;
    let real = |part: usize| f64::from_bits(slot(part as u16));
    let beyond = Fault::Malformed;
    match data {
        ColumnData::Bool(all) => *all.get_mut(at).ok_or(beyond)? = slot(0) != 0,
        ColumnData::Int(all) => *all.get_mut(at).ok_or(beyond)? = slot(0) as i64,
        ColumnData::Real(all) => *all.get_mut(at).ok_or(beyond)? = real(0),
        ColumnData::Vec2(all) => {
            *all.get_mut(at).ok_or(beyond)? = DVec2::from_array(std::array::from_fn(real));
        }
        ColumnData::Vec3(all) => {
            *all.get_mut(at).ok_or(beyond)? = DVec3::from_array(std::array::from_fn(real));
        }
        ColumnData::Vec4(all) => {
            *all.get_mut(at).ok_or(beyond)? = DVec4::from_array(std::array::from_fn(real));
        }
        ColumnData::Mat3(all) => {
            let parts = std::array::from_fn(real);
            *all.get_mut(at).ok_or(beyond)? = DMat3::from_cols_array(&parts);
        }
        ColumnData::Mat4(all) => {
            let parts = std::array::from_fn(real);
            *all.get_mut(at).ok_or(beyond)? = DMat4::from_cols_array(&parts);
        }
    }
    Ok(())
}

/// Keeps back the value of an attribute of a living element: appends a header, the element and the
/// slots.
pub(super) fn hold(
    mesh: &Mesh,
    column: ColumnId,
    (attribute, id): (u16, u32),
    w: &Window,
    value: Reg,
    held: &mut Vec<u64>,
) -> Result<(), Fault> {
    index(mesh, column, id)?;
    let data = mesh.column(column).ok_or(Fault::Malformed)?.data();
    let width = width(data);
    held.extend([header(attribute.into(), width), u64::from(id)]);
    let slots = 0..width;
    held.extend(slots.map(|part| w.bits(Reg(value.0.wrapping_add(part)))));
    Ok(())
}

/// The values that are kept back, in order: the column, or `None` for a position; the element; the
/// slots.
pub(super) struct Held<'h> {
    columns: &'h [Option<ColumnId>],
    rest: &'h [u64],
}

impl<'h> Held<'h> {
    pub(super) fn new(columns: &'h [Option<ColumnId>], rest: &'h [u64]) -> Self {
        Self { columns, rest }
    }
}

impl<'h> Iterator for Held<'h> {
    type Item = (Option<ColumnId>, u32, &'h [u64]);

    fn next(&mut self) -> Option<Self::Item> {
        let [header, id, values @ ..] = self.rest else {
            return None;
        };
        let target = match *header as u32 {
            POSITION => None,
            number => Some(column(self.columns, number as u16).ok()?),
        };
        let (slots, rest) = values.split_at_checked((header >> 32) as usize)?;
        self.rest = rest;
        Some((target, *id as u32, slots))
    }
}

/// Writes the values that are kept back, in order, and clears the buffer. Erased elements are
/// skipped.
pub(super) fn release(
    mesh: &mut Mesh,
    columns: &[Option<ColumnId>],
    held: &mut Vec<u64>,
) -> Result<(), Fault> {
    let mut rest = held.as_slice();
    while !rest.is_empty() {
        let mut all = Held::new(columns, rest);
        let (target, id, slots) = all.next().ok_or(Fault::Malformed)?;
        rest = all.rest;
        match (target, slots) {
            (None, [x, y, z]) if mesh.vertex_alive(VertexId(id)) => {
                let position = [x, y, z].map(|part| f64::from_bits(*part));
                mesh.set_position(VertexId(id), DVec3::from_array(position));
            }
            (Some(column), slots) if mesh.is_alive(column.kind, id) => {
                put(mesh, column, id as usize, |part| slots[usize::from(part)])?;
            }
            _ => {}
        }
    }
    held.clear();
    Ok(())
}
