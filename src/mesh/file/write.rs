//! Writing a file. Coordinates are printed with the fewest digits that read back
//! as the same number.

use std::io::{self, Write};
use std::path::Path;

use glam::DVec3;

use super::attributes::{Corners, OfCorner};
use super::error::{FileError, FileReason};
use super::kept::State;
use super::mesh_file::{MeshFile, WrittenNumbers};
use super::replace::replace_file;
use crate::mesh::id::FaceId;

/// Writes `obj` to `path`. A symbolic link stays one: what it leads to is replaced. The
/// permissions of an old file are kept.
pub fn write_obj(path: &Path, obj: &MeshFile) -> Result<(), FileError> {
    replace_file(path, |mut output| write_obj_to(&mut output, obj)).map_err(|reason| FileError {
        file: path.display().to_string(),
        line: None,
        reason,
    })
}

/// Writes the text of `obj`. The output should be buffered.
pub fn write_obj_to(output: &mut impl Write, obj: &MeshFile) -> Result<(), FileReason> {
    let numbers = obj.written_numbers();
    check_positions(obj, &numbers)?;
    write_text(output, obj, &numbers).map_err(FileReason::Io)
}

fn check_positions(obj: &MeshFile, numbers: &WrittenNumbers) -> Result<(), FileReason> {
    let stray = numbers.vertex_order.iter().position(|&v| !obj.mesh.position(v).is_finite());
    match stray {
        Some(place) => Err(FileReason::NotFinite { vertex: place as u32 + 1 }),
        None => Ok(()),
    }
}

fn write_text(output: &mut impl Write, obj: &MeshFile, numbers: &WrittenNumbers) -> io::Result<()> {
    for library in &obj.kept.libraries {
        write_statement(output, "mtllib", library)?;
    }
    let colors = obj.color();
    let colors = colors.and_then(|column| obj.mesh.values::<DVec3>(column));
    for &v in &numbers.vertex_order {
        let DVec3 { x, y, z } = obj.mesh.position(v);
        write!(output, "v {x} {y} {z}")?;
        if let Some(DVec3 { x, y, z }) = colors.and_then(|colors| colors.get(v.index())) {
            write!(output, " {x} {y} {z}")?;
        }
        output.write_all(b"\n")?;
    }
    let corners = [OfCorner::Texture, OfCorner::Normal];
    let corners = corners.map(|what| Corners::of(obj, what, &numbers.face_order));
    for (keyword, corners) in ["vt", "vn"].into_iter().zip(&corners) {
        let table = corners.rows();
        for row in &table.rows {
            output.write_all(keyword.as_bytes())?;
            for number in &row[..table.width] {
                write!(output, " {number}")?;
            }
            output.write_all(b"\n")?;
        }
    }
    let mut current = State::EMPTY;
    for &f in &numbers.face_order {
        if let Some(state) = state_of(obj, f) {
            write_state(output, obj, &mut current, state)?;
        }
        write_face(output, obj, numbers, &corners, f)?;
    }
    Ok(())
}

/// The statements that should be in force at `f`. A new face takes after the first of
/// its neighbors that came from the file.
fn state_of(obj: &MeshFile, f: FaceId) -> Option<State> {
    if obj.kept.states.is_empty() {
        return None;
    }
    let across = obj.mesh.face_halfedges(f).filter_map(|h| obj.mesh.get_face(obj.mesh.twin(h)));
    let number = std::iter::once(f).chain(across).find_map(|f| obj.face_number(f))?;
    Some(obj.kept.state(number - 1))
}

fn write_state(
    output: &mut impl Write,
    obj: &MeshFile,
    current: &mut State,
    state: State,
) -> io::Result<()> {
    for (i, keyword) in State::KEYWORDS.into_iter().enumerate() {
        if state.0[i] == current.0[i] {
            continue;
        }
        if let Some(name) = obj.kept.names.get(state.0[i] as usize) {
            write_statement(output, keyword, name)?;
        } else if keyword == "s" {
            write_statement(output, keyword, b"off")?;
        } else if keyword == "g" {
            write_statement(output, keyword, b"default")?;
        } else {
            continue; // nothing takes an object or a material back
        }
        current.0[i] = state.0[i];
    }
    Ok(())
}

fn write_statement(output: &mut impl Write, keyword: &str, operand: &[u8]) -> io::Result<()> {
    output.write_all(keyword.as_bytes())?;
    if !operand.is_empty() {
        output.write_all(b" ")?;
        output.write_all(operand)?;
    }
    output.write_all(b"\n")
}

/// A face, with texture coordinates if all its corners have one, and normals likewise.
fn write_face(
    output: &mut impl Write,
    obj: &MeshFile,
    numbers: &WrittenNumbers,
    [texture, normals]: &[Corners; 2],
    f: FaceId,
) -> io::Result<()> {
    let (with_texture, with_normals) = (texture.cover(&obj.mesh, f), normals.cover(&obj.mesh, f));
    let number = |corners: &Corners, h| corners.row(h).map_or(0, |row| row + 1);
    output.write_all(b"f")?;
    for h in obj.mesh.face_halfedges(f) {
        write!(output, " {}", numbers.vertex(obj.mesh.vertex(h)).unwrap_or(0))?;
        match (with_texture, with_normals) {
            (false, false) => {}
            (true, false) => write!(output, "/{}", number(texture, h))?,
            (false, true) => write!(output, "//{}", number(normals, h))?,
            (true, true) => {
                let (texture, normal) = (number(texture, h), number(normals, h));
                write!(output, "/{texture}/{normal}")?;
            }
        }
    }
    output.write_all(b"\n")
}
