//! Declared attributes through registers, and deferred writes, which are kept back in a buffer.
//!
//! A column is a dense array of values of one type. A value in the window takes one slot for each
//! component, matrices column by column, as the language lays them out.

use std::ops::Range;

use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};

use super::access::gone;
use super::window::Window;
use super::{Fault, Reg};
use crate::mesh::parallel;
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
    if mesh.is_alive(column.kind, id) { Ok(id as usize) } else { Err(gone(column.kind, id)) }
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
    put(mesh, column, at, |part| w.bits(Reg(value.0.wrapping_add(part as u16))))
}

/// A value that can be made of its slots.
trait OfSlots: Send {
    fn of_slots(slot: impl Fn(usize) -> u64) -> Self;
}

impl OfSlots for bool {
    #[inline]
    fn of_slots(slot: impl Fn(usize) -> u64) -> Self {
        slot(0) != 0
    }
}

impl OfSlots for i64 {
    #[inline]
    fn of_slots(slot: impl Fn(usize) -> u64) -> Self {
        slot(0) as Self
    }
}

impl OfSlots for f64 {
    #[inline]
    fn of_slots(slot: impl Fn(usize) -> u64) -> Self {
        Self::from_bits(slot(0))
    }
}

macro_rules! made_of_reals {
    ($($type:ident $from:ident $count:literal;)*) => {
        $(impl OfSlots for $type {
            #[inline]
            fn of_slots(slot: impl Fn(usize) -> u64) -> Self {
                let reals: [f64; $count] = std::array::from_fn(|part| f64::from_bits(slot(part)));
                Self::$from(&reals)
            }
        })*
    };
}

made_of_reals! {
    DVec2 from_slice 2;
    DVec3 from_slice 3;
    DVec4 from_slice 4;
    DMat3 from_cols_slice 9;
    DMat4 from_cols_slice 16;
}

/// Evaluates an expression with the values of a column, whatever their type.
macro_rules! with_values {
    ($data:expr, $all:ident => $result:expr) => {
        match $data {
            ColumnData::Bool($all) => $result,
            ColumnData::Int($all) => $result,
            ColumnData::Real($all) => $result,
            ColumnData::Vec2($all) => $result,
            ColumnData::Vec3($all) => $result,
            ColumnData::Vec4($all) => $result,
            ColumnData::Mat3($all) => $result,
            ColumnData::Mat4($all) => $result,
        }
    };
}

/// Writes a value; `slot` returns its slots.
#[inline]
fn put(
    mesh: &mut Mesh,
    column: ColumnId,
    at: usize,
    slot: impl Fn(usize) -> u64,
) -> Result<(), Fault> {
    mesh.note_value(column, at as u32);
    let data = mesh.column_data_mut(column).ok_or(Fault::Malformed)?;
    with_values!(data, all => *all.get_mut(at).ok_or(Fault::Malformed)? = OfSlots::of_slots(slot));
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
                put(mesh, column, id as usize, |part| slots[part])?;
            }
            _ => {}
        }
    }
    held.clear();
    Ok(())
}

/// Writes the values that are kept back, a list for each of the ranges, which cover the slots of a
/// kind in order; each list has values of the elements in its range alone, of these attributes
/// (`None` for a position). Ranges are written on all cores: no journal may be open.
pub(super) fn release_ranges(
    mesh: &mut Mesh,
    columns: &[Option<ColumnId>],
    attributes: &[Option<u16>],
    lists: &[(Range<usize>, Vec<u64>)],
) -> Result<(), Fault> {
    for &attribute in attributes {
        let target = attribute.map(|attribute| column(columns, attribute)).transpose()?;
        let held = |list| Held::new(columns, list).filter(move |(of, ..)| *of == target);
        match target {
            None => write_ranges(mesh.positions_mut(), lists, held)?,
            Some(column) => {
                let data = mesh.column_data_mut(column).ok_or(Fault::Malformed)?;
                with_values!(data, all => write_ranges(all, lists, held)?);
            }
        }
    }
    Ok(())
}

/// Writes what is held for the elements in each range, on all cores.
fn write_ranges<'h, T: OfSlots, H: Iterator<Item = (Option<ColumnId>, u32, &'h [u64])>>(
    all: &mut [T],
    lists: &'h [(Range<usize>, Vec<u64>)],
    held: impl Fn(&'h [u64]) -> H + Sync,
) -> Result<(), Fault> {
    let values = parallel::split(all, lists.iter().map(|(range, _)| range.len()));
    let write = |(values, (range, list)): (&mut [T], &'h (Range<usize>, Vec<u64>))| {
        for (_, id, slots) in held(list) {
            let value = (id as usize).checked_sub(range.start).and_then(|at| values.get_mut(at));
            *value.ok_or(Fault::Malformed)? = T::of_slots(|part| slots[part]);
        }
        Ok(())
    };
    parallel::map(values.zip(lists).collect(), write).into_iter().collect()
}
