//! The mesh files of MuJoCo, which also end in `.msh`: binary, little-endian.
//!
//! Four 32-bit integers give the numbers of vertices, normals, texture coordinates and triangles.
//! Positions, normals and texture coordinates are 3, 3 and 2 floats, triangles three indices. Such
//! a file is recognized only by its length, which must match these numbers.

use glam::{DVec2, DVec3};

use crate::mesh::attribute::Value;
use crate::mesh::file::contents::{Contents, FileColumn};
use crate::mesh::file::kept::MISSING;
use crate::mesh::id::ElementKind;
use crate::mesh::polygons::Polygons;

const HEAD: usize = 16;

/// True if a file is a MuJoCo file.
pub(in crate::mesh::file) fn is_of_mujoco(text: &[u8]) -> bool {
    read(text).is_some()
}

/// Reads a file; `None` if it is not a MuJoCo file.
pub(super) fn read(text: &[u8]) -> Option<Contents> {
    let (head, body) = text.split_first_chunk::<HEAD>()?;
    let (counts, _) = head.as_chunks::<4>();
    let size = |at: usize, width: usize| {
        usize::try_from(i32::from_le_bytes(counts[at])).ok()?.checked_mul(4 * width)
    };
    let [positions, normals, texture, triangles] =
        [size(0, 3)?, size(1, 3)?, size(2, 2)?, size(3, 3)?];
    let (positions, rest) = body.split_at_checked(positions)?;
    let (normals, rest) = rest.split_at_checked(normals)?;
    let (texture, rest) = rest.split_at_checked(texture)?;
    if rest.len() != triangles {
        return None;
    }
    let mut contents = Contents::default();
    let reals = |bytes: &[u8]| -> Vec<f64> {
        bytes.as_chunks::<4>().0.iter().map(|&it| f64::from(f32::from_le_bytes(it))).collect()
    };
    let (rows, columns) = (reals(positions), [reals(normals), reals(texture)]);
    contents.positions = rows.as_chunks::<3>().0.iter().copied().map(DVec3::from_array).collect();
    let vertices = contents.positions.len();
    let attributes =
        [("normal", Value::Vec3(DVec3::ZERO)), ("uv", Value::Vec2(DVec2::ZERO))].into_iter();
    for ((name, default), reals) in attributes.zip(columns) {
        let count = reals.len() / default.reals().len();
        if count == vertices && count > 0 {
            contents.columns.push(FileColumn::new(ElementKind::Vertex, name, default, reals));
        } else {
            let what = ["row of `{}` that is no vertex's", "rows of `{}` that are no vertex's"];
            contents.kept.note_count(what.map(|words| words.replace("{}", name)), count);
        }
    }
    let mut corners = Vec::with_capacity(rest.len() / 4);
    for &index in rest.as_chunks::<4>().0 {
        let index = i32::from_le_bytes(index);
        let vertex = u32::try_from(index).ok().filter(|&v| (v as usize) < vertices);
        if vertex.is_none() {
            contents.bad_indices.add_vertex(None, index.into(), vertices);
        }
        corners.push(vertex.unwrap_or(MISSING));
    }
    let ends = (1..=corners.len() / 3).map(|end| end * 3).collect();
    contents.polygons = Polygons::of_parts(corners, ends);
    Some(contents)
}
