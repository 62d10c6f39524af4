//! Meshes as bytes: all tables as they are, so that later operations allocate the same ids.
//!
//! A dump is readable text, and does not keep the order in which erased slots are reused; this
//! format is for programs that send a mesh to another process or store it.
//!
//! ```text
//! magic, version, checksum of all that follows
//! numbers of slots: vertices, halfedges, edges, faces
//! halfedges: next, prev, twin, vertex, edge, face each
//! vertices: halfedge each     edges: halfedge each     faces: halfedge, then hole each
//! positions
//! for each kind: free slots, erased slots (each a number and so many)
//! number of columns; each: kind, name, type, default, values
//! ```
//!
//! Numbers are little-endian. The input is not trusted: any bytes give a valid mesh or an error,
//! and take memory in proportion to their length.

use std::fmt;

use glam::DVec3;

use super::attribute::{AttributeType, Value};
use super::connectivity::Mesh;
use super::id::{EdgeId, ElementKind, FaceId, HalfedgeId, ID_SPACE, VertexId};
use super::invalid::Invalid;
use super::records::{FaceState, HalfedgeRecord};
use super::validate::validate;

const MAGIC: [u8; 8] = *b"hedgemsh";

/// The version that is written, and the only one that is read.
const VERSION: u32 = 1;

/// The greatest number of attributes that are read.
const MOST_COLUMNS: u32 = 1 << 12;

/// The reason why bytes are not a mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum BinaryError {
    /// They do not begin with the magic number.
    NotAMesh,
    /// They have this version of the format, which cannot be read.
    Version(u32),
    /// They end too early, or their checksum does not match.
    Damaged,
    /// Their content is inconsistent; the text says how.
    Malformed(&'static str),
    /// The tables can be read, but are not a valid mesh.
    Invalid(Invalid),
}

impl fmt::Display for BinaryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAMesh => f.write_str("these bytes are not a mesh"),
            Self::Version(version) => {
                write!(f, "this mesh is in version {version}, and only {VERSION} can be read")
            }
            Self::Damaged => f.write_str("the bytes of this mesh are damaged or cut off"),
            Self::Malformed(words) => write!(f, "the bytes of this mesh make no sense: {words}"),
            Self::Invalid(invalid) => write!(f, "these bytes are not a valid mesh: {invalid}"),
        }
    }
}

impl std::error::Error for BinaryError {}

/// A checksum that detects damage: Fletcher's, over words of four bytes (J. Fletcher, "An
/// Arithmetic Checksum for Serial Transmissions", 1982). It does not protect against forgery.
fn checksum(bytes: &[u8]) -> u64 {
    let (words, rest) = bytes.as_chunks::<4>();
    let mut last = [0; 4];
    last[..rest.len()].copy_from_slice(rest);
    let (mut sum, mut sums) = (bytes.len() as u64, 0_u64);
    for &word in words.iter().chain([&last]) {
        sum = sum.wrapping_add(u64::from(u32::from_le_bytes(word)));
        sums = sums.wrapping_add(sum);
    }
    sum ^ sums.rotate_left(32)
}

/// The bytes of a mesh. Open journals are not included.
pub fn write_bytes(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(64 + 32 * mesh.halfedges.len() + 32 * mesh.vertices.len());
    bytes.extend(MAGIC);
    bytes.extend(VERSION.to_le_bytes());
    bytes.extend(0_u64.to_le_bytes());
    let start = bytes.len();
    for kind in ElementKind::ALL {
        put(&mut bytes, mesh.capacity(kind) as u32);
    }
    for record in &mesh.halfedges {
        record.pointers().into_iter().for_each(|number| put(&mut bytes, number));
    }
    mesh.vertices.iter().for_each(|halfedge| put(&mut bytes, halfedge.0));
    mesh.edges.iter().for_each(|halfedge| put(&mut bytes, halfedge.0));
    mesh.faces.iter().for_each(|halfedge| put(&mut bytes, halfedge.0));
    bytes.extend(mesh.face_states.iter().map(|&state| u8::from(state == FaceState::Hole)));
    for position in &mesh.positions {
        position.to_array().iter().for_each(|x| bytes.extend(x.to_le_bytes()));
    }
    for slots in &mesh.slots {
        for list in [&slots.free, &slots.pending] {
            put(&mut bytes, list.len() as u32);
            list.iter().for_each(|&slot| put(&mut bytes, slot));
        }
    }
    let columns = ElementKind::ALL.map(|kind| mesh.columns(kind).count()).iter().sum::<usize>();
    put(&mut bytes, columns as u32);
    for kind in ElementKind::ALL {
        for (_, column) in mesh.columns(kind) {
            bytes.push(kind as u8);
            put(&mut bytes, column.name().len() as u32);
            bytes.extend(column.name().bytes());
            let ty = column.attribute_type();
            let place = AttributeType::ALL.iter().position(|&known| known == ty);
            bytes.push(place.unwrap_or(0) as u8);
            put_value(&mut bytes, column.default_value());
            column.data().each(|value| put_value(&mut bytes, value));
        }
    }
    let sum = checksum(&bytes[start..]);
    bytes[start - 8..start].copy_from_slice(&sum.to_le_bytes());
    bytes
}

fn put(bytes: &mut Vec<u8>, number: u32) {
    bytes.extend(number.to_le_bytes());
}

fn put_value(bytes: &mut Vec<u8>, value: Value) {
    match value {
        Value::Bool(value) => bytes.push(value.into()),
        Value::Int(value) => bytes.extend(value.to_le_bytes()),
        _ => value.reals().iter().for_each(|x| bytes.extend(x.to_le_bytes())),
    }
}

/// Reads a mesh from its bytes.
///
/// # Errors
/// The bytes are not those of a valid mesh: see [`BinaryError`].
pub fn read_bytes(bytes: &[u8]) -> Result<Mesh, BinaryError> {
    let mut reader = Reader(bytes);
    if reader.take::<8>().is_none_or(|magic| magic != MAGIC) {
        return Err(BinaryError::NotAMesh);
    }
    match reader.number() {
        Some(VERSION) => {}
        Some(version) => return Err(BinaryError::Version(version)),
        None => return Err(BinaryError::Damaged),
    }
    let sum = reader.take().map(u64::from_le_bytes);
    if sum != Some(checksum(reader.0)) {
        return Err(BinaryError::Damaged);
    }
    let mesh = reader.mesh()?;
    if !reader.0.is_empty() {
        return Err(BinaryError::Malformed("there is something behind the end"));
    }
    validate(&mesh).map_err(BinaryError::Invalid)?;
    Ok(mesh)
}

/// The bytes that are still to be read.
struct Reader<'b>(&'b [u8]);

impl<'b> Reader<'b> {
    fn take<const COUNT: usize>(&mut self) -> Option<[u8; COUNT]> {
        let (first, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*first)
    }

    fn number(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    fn bytes(&mut self, count: usize) -> Option<&'b [u8]> {
        let (first, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(first)
    }

    /// The next `values` values, of `COUNT` bytes each.
    fn all<const COUNT: usize>(&mut self, values: usize) -> Result<&'b [[u8; COUNT]], BinaryError> {
        let length = values.checked_mul(COUNT).ok_or(BinaryError::Damaged)?;
        Ok(self.bytes(length).ok_or(BinaryError::Damaged)?.as_chunks().0)
    }

    fn numbers(&mut self, count: usize) -> Result<Vec<u32>, BinaryError> {
        Ok(self.all(count)?.iter().map(|&four| u32::from_le_bytes(four)).collect())
    }

    fn mesh(&mut self) -> Result<Mesh, BinaryError> {
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = self.number().ok_or(BinaryError::Damaged)? as usize;
            if *count > ID_SPACE {
                return Err(BinaryError::Malformed("there are more elements than can be numbered"));
            }
        }
        let [vertices, halfedges, edges, faces] = counts;
        let mut mesh = Mesh::default();
        let records = self.all::<24>(halfedges)?.iter();
        let record = |bytes: &[u8; 24]| {
            let (words, _) = bytes.as_chunks();
            let word = |at: usize| u32::from_le_bytes(words[at]);
            HalfedgeRecord {
                next: HalfedgeId(word(0)),
                prev: HalfedgeId(word(1)),
                twin: HalfedgeId(word(2)),
                vertex: VertexId(word(3)),
                edge: EdgeId(word(4)),
                face: FaceId(word(5)),
            }
        };
        mesh.halfedges = records.map(record).collect();
        mesh.vertices = self.numbers(vertices)?.into_iter().map(HalfedgeId).collect();
        mesh.edges = self.numbers(edges)?.into_iter().map(HalfedgeId).collect();
        mesh.faces = self.numbers(faces)?.into_iter().map(HalfedgeId).collect();
        let holes = self.bytes(faces).ok_or(BinaryError::Damaged)?;
        if holes.iter().any(|&hole| hole > 1) {
            return Err(BinaryError::Malformed("a face is neither a hole nor none"));
        }
        for (&halfedge, &hole) in mesh.faces.iter().zip(holes) {
            mesh.face_states.push(match (halfedge == HalfedgeId::DEAD, hole == 1) {
                (false, hole) => FaceState::of_living(hole),
                (true, false) => FaceState::Dead,
                (true, true) => return Err(BinaryError::Malformed("an erased face is a hole")),
            });
        }
        mesh.holes = mesh.holes().count();
        let position = |bytes: &[u8; 24]| {
            let (words, _) = bytes.as_chunks();
            DVec3::from_array(std::array::from_fn(|at| f64::from_le_bytes(words[at])))
        };
        mesh.positions = self.all::<24>(vertices)?.iter().map(position).collect();
        for kind in ElementKind::ALL {
            self.slots(&mut mesh, kind)?;
        }
        let columns = self.number().ok_or(BinaryError::Damaged)?;
        if columns > MOST_COLUMNS {
            return Err(BinaryError::Malformed("there are too many attributes"));
        }
        for _ in 0..columns {
            self.column(&mut mesh)?;
        }
        Ok(mesh)
    }

    /// Reads the slots of a kind that have no element; together the lists must have each of them
    /// once.
    fn slots(&mut self, mesh: &mut Mesh, kind: ElementKind) -> Result<(), BinaryError> {
        let wrong =
            || BinaryError::Malformed("the lists of free slots are not those without elements");
        let mut is_dead = vec![false; mesh.capacity(kind)];
        let mut lists = [Vec::new(), Vec::new()];
        for list in &mut lists {
            let count = self.number().ok_or(BinaryError::Damaged)?;
            *list = self.numbers(count as usize)?;
            for &slot in &*list {
                let place = is_dead.get_mut(slot as usize).ok_or_else(wrong)?;
                if mesh.is_alive(kind, slot) || std::mem::replace(place, true) {
                    return Err(wrong());
                }
            }
        }
        let dead = mesh.capacity(kind) - mesh.elements(kind).count();
        if dead != lists[0].len() + lists[1].len() {
            return Err(wrong());
        }
        let [free, pending] = lists;
        mesh.slots[kind as usize].free = free;
        mesh.slots[kind as usize].pending = pending;
        Ok(())
    }

    fn column(&mut self, mesh: &mut Mesh) -> Result<(), BinaryError> {
        let [kind] = self.take().ok_or(BinaryError::Damaged)?;
        let kind = ElementKind::ALL.get(usize::from(kind)).copied();
        let kind = kind.ok_or(BinaryError::Malformed("there is no such kind of elements"))?;
        let length = self.number().ok_or(BinaryError::Damaged)?;
        let name = self.bytes(length as usize).ok_or(BinaryError::Damaged)?;
        let name = std::str::from_utf8(name);
        let name =
            name.map_err(|_| BinaryError::Malformed("the name of an attribute is not a text"))?;
        let [ty] = self.take().ok_or(BinaryError::Damaged)?;
        let ty = AttributeType::ALL.get(usize::from(ty)).copied();
        let ty = ty.ok_or(BinaryError::Malformed("there is no such type of attributes"))?;
        let default = self.value(ty)?;
        let bytes_of_one = if ty == AttributeType::Bool { 1 } else { 8 * ty.width() };
        let count = mesh.capacity(kind);
        if self.0.len() < count.saturating_mul(bytes_of_one) {
            return Err(BinaryError::Damaged);
        }
        if mesh.find_column(kind, name).is_some() {
            return Err(BinaryError::Malformed("two attributes have the same name"));
        }
        let column = mesh.add_column(kind, name, default);
        let column =
            column.map_err(|_| BinaryError::Malformed("two attributes have the same name"))?;
        for slot in 0..count as u32 {
            mesh.put_value(column, slot, self.value(ty)?);
        }
        Ok(())
    }

    fn value(&mut self, ty: AttributeType) -> Result<Value, BinaryError> {
        match ty {
            AttributeType::Bool => match self.take().ok_or(BinaryError::Damaged)? {
                [0] => Ok(Value::Bool(false)),
                [1] => Ok(Value::Bool(true)),
                _ => Err(BinaryError::Malformed("a bool is neither 0 nor 1")),
            },
            AttributeType::Int => {
                let value = self.take().ok_or(BinaryError::Damaged)?;
                Ok(Value::Int(i64::from_le_bytes(value)))
            }
            _ => {
                let mut reals = [0.0; 16];
                for (real, &bytes) in reals.iter_mut().zip(self.all::<8>(ty.width())?) {
                    *real = f64::from_le_bytes(bytes);
                }
                Value::from_reals(ty, &reals[..ty.width()]).ok_or(BinaryError::Damaged)
            }
        }
    }
}
