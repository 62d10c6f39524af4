//! Writing a file of any format.

use std::borrow::Cow;
use std::io::Write;
use std::path::Path;

use super::error::{FileError, FileReason};
use super::format::FileFormat;
use super::mesh_file::MeshFile;
use super::replace::replace_file_unless;
use super::{msh, obj, off, ply, stl};
use crate::mesh::connectivity::Mesh;
use crate::mesh::dump::write_table;
use crate::mesh::level::{Level, validate_level};

/// Writes a mesh to `path`, in the format given by its ending, completely or not at all. A symbolic
/// link stays one: its target is replaced. The permissions of an old file are kept.
///
/// # Errors
/// The file cannot be written, or its format cannot hold the mesh.
pub fn write_mesh(path: &Path, file: &MeshFile) -> Result<(), FileError> {
    write_mesh_unless(path, file, &|| false)
}

/// As [`write_mesh`], unless `stops` is true at some time before the old file is replaced: it is
/// asked at intervals.
///
/// # Errors
/// As for [`write_mesh`]; [`FileReason::Io`] if it was stopped.
pub fn write_mesh_unless(
    path: &Path,
    file: &MeshFile,
    stops: &dyn Fn() -> bool,
) -> Result<(), FileError> {
    let format = FileFormat::of(path);
    let written = format.and_then(|format| {
        let file = ready(format, file)?;
        replace_file_unless(path, stops, |mut output| write_ready(&mut output, format, &file))
    });
    written.map_err(|reason| FileError { file: path.display().to_string(), line: None, reason })
}

/// Writes a mesh in a format. The output should be buffered.
///
/// # Errors
/// As for [`write_mesh`].
pub fn write_mesh_to(
    output: &mut dyn Write,
    format: FileFormat,
    file: &MeshFile,
) -> Result<(), FileReason> {
    write_ready(output, format, &*ready(format, file)?)
}

/// The mesh with the columns that the format needs, if the format can hold it.
fn ready(format: FileFormat, file: &MeshFile) -> Result<Cow<'_, MeshFile>, FileReason> {
    if format != FileFormat::Halfedges {
        if let Some(stray) = file.mesh.vertices().find(|&v| !file.mesh.position(v).is_finite()) {
            let vertex = file.written_numbers().vertex(stray).unwrap_or(0);
            return Err(FileReason::NotFinite { vertex });
        }
        if !file.mesh.is_polygons() {
            return Err(FileReason::NotPolygons(below_simple(&file.mesh)));
        }
    }
    Ok(match format == FileFormat::Halfedges && file.kept.has_corners() {
        false => Cow::Borrowed(file),
        true => {
            let mut file = file.clone();
            file.bring_all();
            Cow::Owned(file)
        }
    })
}

/// The reason why a mesh is below level simple, in words.
fn below_simple(mesh: &Mesh) -> String {
    let level = validate_level(mesh, Level::Simple);
    level.map_or_else(|below| format!(", since {below}"), |()| String::new())
}

fn write_ready(
    output: &mut dyn Write,
    format: FileFormat,
    file: &MeshFile,
) -> Result<(), FileReason> {
    let numbers = file.written_numbers();
    match format {
        FileFormat::Obj => obj::write(output, file, &numbers).map_err(FileReason::Io),
        FileFormat::Ply => ply::write(output, file, &numbers).map_err(FileReason::Io),
        FileFormat::Stl => stl::write(output, file, &numbers),
        FileFormat::Off => off::write(output, file, &numbers).map_err(FileReason::Io),
        FileFormat::Msh => msh::write(output, file, &numbers),
        FileFormat::Halfedges => write_table(output, "mesh", &file.mesh).map_err(FileReason::Io),
    }
}
