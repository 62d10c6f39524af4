//! Reading a file of any format.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::contents::Contents;
use super::error::{Failure, FileError, FileReason};
use super::format::FileFormat;
use super::mesh_file::MeshFile;
use super::{msh, obj, off, ply, stl};
use crate::mesh::dump::read_dump;
use crate::mesh::repair::Repair;
use crate::mesh::validate::validate;

/// Reads the file at `path`, in the format given by its ending. Polygons that are not a mesh are an
/// error, or are repaired if that is requested. A list of polygons without a vertex is no mesh; tables
/// may be empty.
///
/// # Errors
/// The file cannot be read, violates its format, or is not a mesh.
pub fn read_mesh(path: &Path, repair: Option<Repair>) -> Result<MeshFile, FileError> {
    read_path(path, repair, false)
}

/// As [`read_mesh`], with the elements of the mesh in an order that keeps neighbors near each other
/// in memory: long computations on a large mesh get faster, up to twice as fast where the file has
/// no such order. Vertices follow a Hilbert curve. Vertices and faces are written in the order of
/// the file, and have its numbers in [`MeshFile::vertex_number`] and [`MeshFile::face_number`]. A
/// file of tables keeps its order.
///
/// # Errors
/// As for [`read_mesh`].
pub fn read_mesh_reordered(path: &Path, repair: Option<Repair>) -> Result<MeshFile, FileError> {
    read_path(path, repair, true)
}

fn read_path(path: &Path, repair: Option<Repair>, reorder: bool) -> Result<MeshFile, FileError> {
    let name = path.display().to_string();
    let failed = |reason| FileError { file: name.clone(), line: None, reason };
    let format = FileFormat::of(path).map_err(failed)?;
    let mut file = read_source(&name, (format, path), repair, reorder)
        .map_err(|error| failed(FileReason::Io(error)))??;
    file.folder = path.parent().map(Path::to_owned);
    Ok(file)
}

/// Opens a file or a pipe to read it, but no device: one may never end.
///
/// # Errors
/// It cannot be opened, or is a device.
pub fn open_file(path: &Path) -> io::Result<File> {
    let file = File::open(path)?;
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        let kind = file.metadata()?.file_type();
        if kind.is_char_device() || kind.is_block_device() {
            return Err(io::Error::other("it is a device"));
        }
    }
    Ok(file)
}

/// Reads a file. The text of an OBJ file is not held in memory as a whole, unless it is UTF-16.
fn read_source(
    name: &str,
    (format, path): (FileFormat, &Path),
    repair: Option<Repair>,
    reorder: bool,
) -> io::Result<Result<MeshFile, FileError>> {
    let mut source = open_file(path)?;
    let mut text = Vec::new();
    if format == FileFormat::Obj {
        let bytes = source.metadata()?.len() as usize;
        // A text that does not fit into memory would not fit as a mesh.
        Vec::<u8>::new().try_reserve_exact(bytes)?;
        source.by_ref().take(2).read_to_end(&mut text)?;
        if is_big_endian(format, &text).is_none() && text != GZIP {
            let contents = obj::read(text.as_slice().chain(source), bytes)?;
            return Ok(build((name, format), Ok(contents), repair, reorder));
        }
    }
    source.read_to_end(&mut text)?;
    Ok(read_text(name, (format, &text), repair, reorder))
}

fn build(
    (name, format): (&str, FileFormat),
    contents: Result<Contents, Failure>,
    repair: Option<Repair>,
    reorder: bool,
) -> Result<MeshFile, FileError> {
    let built = contents.and_then(|contents| contents.build(repair, reorder));
    let built = built.and_then(|file| match file.mesh.vertex_count() {
        0 => Err((None, FileReason::NoVertex(format))),
        _ => Ok(file),
    });
    built.map_err(|failure| error(name, failure))
}

/// Reads a file from memory; messages call it `name`.
///
/// # Errors
/// As for [`read_mesh`].
pub fn read_mesh_from(
    name: &str,
    format: FileFormat,
    text: &[u8],
    repair: Option<Repair>,
) -> Result<MeshFile, FileError> {
    read_text(name, (format, text), repair, false)
}

fn read_text(
    name: &str,
    (format, text): (FileFormat, &[u8]),
    repair: Option<Repair>,
    reorder: bool,
) -> Result<MeshFile, FileError> {
    if text.starts_with(GZIP) {
        return Err(error(name, (None, FileReason::Compressed)));
    }
    let decoded = decode(format, text);
    let text = decoded.as_deref().unwrap_or(text);
    let contents = match format {
        FileFormat::Obj => {
            obj::read(text, text.len()).map_err(|error| (None, FileReason::Io(error)))
        }
        FileFormat::Ply => ply::read(text),
        FileFormat::Stl => stl::read(text),
        FileFormat::Off => off::read(text),
        FileFormat::Msh => msh::read(text),
        FileFormat::Halfedges if repair.is_some_and(|repair| repair.merge.is_some()) => {
            Err((None, FileReason::MergedTables))
        }
        FileFormat::Halfedges => return read_tables(text).map_err(|reason| error(name, reason)),
    };
    build((name, format), contents, repair, reorder)
}

/// The first bytes of a file that `gzip` compressed.
const GZIP: &[u8] = &[0x1f, 0x8b];

/// The UTF-8 text of a file in UTF-16, which some programs write; `None` for other files.
fn decode(format: FileFormat, text: &[u8]) -> Option<Vec<u8>> {
    let is_big = is_big_endian(format, text)?;
    let (letters, _) = text[2..].as_chunks::<2>();
    let letters = letters.iter().map(|&letter| match is_big {
        true => u16::from_be_bytes(letter),
        false => u16::from_le_bytes(letter),
    });
    let text: String = char::decode_utf16(letters)
        .map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER))
        .collect();
    let text = text.into_bytes();
    // A binary file may begin with any bytes.
    (format != FileFormat::Stl || stl::is_text(&text)).then_some(text)
}

/// Whether a UTF-16 text is big-endian; `None` for other texts.
fn is_big_endian(format: FileFormat, text: &[u8]) -> Option<bool> {
    match (format, text) {
        (FileFormat::Msh | FileFormat::Halfedges, _) => None,
        (_, [0xfe, 0xff, ..]) => Some(true),
        (_, [0xff, 0xfe, ..]) => Some(false),
        _ => None,
    }
}

fn error(name: &str, (line, reason): Failure) -> FileError {
    FileError { file: name.to_owned(), line, reason }
}

/// The mesh of a file of tables, which must have exactly one.
fn read_tables(text: &[u8]) -> Result<MeshFile, Failure> {
    let malformed = |words: String| (None, FileReason::Malformed(words));
    let text = std::str::from_utf8(text).map_err(|error| malformed(error.to_string()))?;
    // A number that is cut off is another number.
    if !text.is_empty() && !text.ends_with('\n') {
        return Err(malformed("its last line does not end, so the file may be cut off".to_owned()));
    }
    let mut dump = read_dump(text).map_err(|error| malformed(error.to_string()))?;
    match (dump.meshes.pop(), dump.meshes.len()) {
        (Some((_, mesh)), 0) => {
            validate(&mesh).map_err(|law| malformed(format!("this is not a valid mesh: {law}")))?;
            Ok(MeshFile::from_tables(mesh))
        }
        (last, others) => {
            let count = others + usize::from(last.is_some());
            Err(malformed(format!("a file with one `mesh` is wanted; this has {count}")))
        }
    }
}
