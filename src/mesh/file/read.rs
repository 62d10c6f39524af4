//! Reading a file.

use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

use glam::DVec3;
use tobj::LoadError;

use super::error::{FileError, FileReason};
use super::filter::Filter;
use super::mesh_file::MeshFile;
use crate::mesh::connectivity::Mesh;
use crate::mesh::polygons::Polygons;

/// Reads the file at `path`.
pub fn read_obj(path: &Path) -> Result<MeshFile, FileError> {
    let name = path.display().to_string();
    match File::open(path) {
        Ok(file) => read_obj_from(&name, BufReader::with_capacity(1 << 16, file)),
        Err(error) => Err(FileError { file: name, line: None, reason: FileReason::Io(error) }),
    }
}

/// Reads a file that is open already, or no file at all; messages call it `name`.
pub fn read_obj_from(name: &str, input: impl BufRead) -> Result<MeshFile, FileError> {
    read(input).map_err(|(line, reason)| FileError { file: name.to_owned(), line, reason })
}

type Failure = (Option<u32>, FileReason);

fn read(input: impl BufRead) -> Result<MeshFile, Failure> {
    let mut filter = Filter::new(input);
    let parsed = parse(&mut filter)?;
    filter.finish();
    let (positions, polygons) = renumber(parsed, &filter)?;
    let mesh = Mesh::from_owned_polygons(positions, &polygons).map_err(|error| {
        FileReason::from_build(&error, &filter.vertex_lines, &filter.face_lines)
    })?;
    let Filter { mut kept, colors, .. } = filter;
    if !(kept.corner_texture.is_empty() && kept.corner_normals.is_empty()) {
        kept.corner_vertices = polygons.into_corners();
    }
    Ok(MeshFile::from_file(mesh, kept, &colors))
}

fn parse<R: BufRead>(filter: &mut Filter<R>) -> Result<tobj::Mesh, Failure> {
    // Points and lines are rolls here, those of the file have been left out.
    let options = tobj::LoadOptions {
        single_index: false,
        triangulate: false,
        ignore_points: false,
        ignore_lines: false,
    };
    let loaded = tobj::load_obj_buf(filter, &options, |_| Err(LoadError::GenericFailure));
    if let Some(failure) = filter.failure.take().or_else(|| filter.index_out_of_range()) {
        return Err(failure);
    }
    match loaded {
        Ok((mut models, _)) => match (models.pop(), models.pop()) {
            (Some(model), None) => Ok(model.mesh),
            _ => Err((None, FileReason::Garbled)),
        },
        Err(LoadError::PositionParseError) => {
            let reason = FileReason::NotNumbers { statement: "v", needs: "three numbers" };
            Err((Some(filter.line()), reason))
        }
        Err(_) => Err((Some(filter.line()), FileReason::Garbled)),
    }
}

/// Vertices under the numbers of the file, and its faces without the rolls.
fn renumber<R>(parsed: tobj::Mesh, filter: &Filter<R>) -> Result<(Vec<DVec3>, Polygons), Failure> {
    let tobj::Mesh { positions: given, indices, face_arities, .. } = parsed;
    let (placed, _) = given.as_chunks::<3>();
    let garbled = || (None, FileReason::Garbled);
    // An empty list of arities stands for triangles throughout.
    let triangles = vec![3; if face_arities.is_empty() { indices.len() / 3 } else { 0 }];
    let arities = if face_arities.is_empty() { &triangles } else { &face_arities };

    let mut ours = vec![u32::MAX; placed.len()];
    let mut positions = Vec::with_capacity(placed.len());
    let mut rolls = filter.rolls.iter().copied().peekable();
    let mut rest = indices.as_slice();
    for (face, &arity) in arities.iter().enumerate() {
        let (corners, after) = rest.split_at_checked(arity as usize).ok_or_else(garbled)?;
        rest = after;
        if rolls.next_if_eq(&face).is_some() {
            for &theirs in corners {
                let theirs = theirs as usize;
                *ours.get_mut(theirs).ok_or_else(garbled)? = positions.len() as u32;
                positions.push(DVec3::from_array(placed[theirs]));
            }
        }
    }

    let mut polygons = Polygons::with_capacity(filter.face_lines.len(), indices.len());
    let mut rolls = filter.rolls.iter().copied().peekable();
    let mut rest = indices.as_slice();
    let mut polygon = Vec::new();
    for (face, &arity) in arities.iter().enumerate() {
        let (corners, after) = rest.split_at_checked(arity as usize).ok_or_else(garbled)?;
        rest = after;
        if rolls.next_if_eq(&face).is_none() {
            polygon.clear();
            for &theirs in corners {
                polygon.push(*ours.get(theirs as usize).ok_or_else(garbled)?);
            }
            polygons.push(&polygon);
        }
    }
    let complete =
        positions.len() == filter.vertex_lines.len() && polygons.len() == filter.face_lines.len();
    if complete { Ok((positions, polygons)) } else { Err(garbled()) }
}
