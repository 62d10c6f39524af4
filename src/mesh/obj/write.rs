//! Writing a file: all of it, or not at all.
//!
//! The text goes to a new file in the same folder, which takes the place of the old one
//! when it is complete. Coordinates are printed with the fewest digits that read back
//! as the same number.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use glam::DVec3;
use tempfile::NamedTempFile;

use super::attributes::{Corners, OfCorner};
use super::error::{ObjError, ObjReason};
use super::kept::State;
use super::numbers::{Obj, WrittenNumbers};
use crate::mesh::id::FaceId;

/// Writes `obj` to `path`. A symbolic link stays one: what it leads to is replaced. The
/// permissions of an old file are kept.
pub fn write_obj(path: &Path, obj: &Obj) -> Result<(), ObjError> {
    replace_file(path, |mut output| write_obj_to(&mut output, obj)).map_err(|reason| ObjError {
        file: path.display().to_string(),
        line: None,
        reason,
    })
}

/// Writes the text of `obj`. The output should be buffered.
pub fn write_obj_to(output: &mut impl Write, obj: &Obj) -> Result<(), ObjReason> {
    let numbers = obj.written_numbers();
    check_positions(obj, &numbers)?;
    write_text(output, obj, &numbers).map_err(ObjReason::Io)
}

/// Writes a file: all of it, or not at all. What is to stand in it is written by `write`.
///
/// # Errors
/// [`ObjReason::NoFolder`], [`ObjReason::ReadOnly`] and [`ObjReason::Io`], and what `write` fails with; the old file, if
/// there was one, is as it was.
pub fn replace_file(
    path: &Path,
    write: impl Fn(&mut dyn Write) -> Result<(), ObjReason>,
) -> Result<(), ObjReason> {
    // A device or a pipe cannot be replaced, only written to. What leads to a pipe need not be a
    // path: `/dev/stdout`.
    if fs::metadata(path).is_ok_and(|old| !old.is_file()) {
        let file = fs::OpenOptions::new().write(true).open(path).map_err(ObjReason::Io)?;
        let mut output = BufWriter::new(file);
        write(&mut output)?;
        return output.flush().map_err(ObjReason::Io);
    }
    let target = followed(path).map_err(ObjReason::Io)?;
    let old = fs::metadata(&target).ok();
    expect_writable(path)?;
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    if !folder.is_dir() {
        return Err(ObjReason::NoFolder(folder.display().to_string()));
    }
    let mut file = new_file(folder).map_err(ObjReason::Io)?;
    {
        let mut output = BufWriter::with_capacity(1 << 16, file.as_file_mut());
        write(&mut output)?;
        output.flush().map_err(ObjReason::Io)?;
    }
    // The name is to lead to the whole text even if the power fails right behind.
    file.as_file().sync_all().map_err(ObjReason::Io)?;
    if let Some(old) = old {
        file.as_file().set_permissions(old.permissions()).map_err(ObjReason::Io)?;
    }
    file.persist(&target).map_err(|failed| ObjReason::Io(failed.error))?;
    Ok(())
}

/// Whether a file may be written, if it is there. It could be replaced even so, which is not what
/// who protected it has meant.
///
/// # Errors
/// [`ObjReason::ReadOnly`] and [`ObjReason::Io`].
pub fn expect_writable(path: &Path) -> Result<(), ObjReason> {
    let Some(old) = fs::metadata(path).ok().filter(fs::Metadata::is_file) else {
        return Ok(());
    };
    if old.permissions().readonly() {
        return Err(ObjReason::ReadOnly);
    }
    match fs::OpenOptions::new().write(true).open(path) {
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => Err(ObjReason::ReadOnly),
        Err(error) => Err(ObjReason::Io(error)),
        Ok(_) => Ok(()),
    }
}

/// Where the links from `path` lead, whether something is there or not.
fn followed(path: &Path) -> io::Result<PathBuf> {
    let mut at = path.to_owned();
    // As many links as Linux follows.
    for _ in 0..40 {
        match fs::read_link(&at) {
            // A relative link starts from the folder of the link.
            Ok(link) => at = at.parent().unwrap_or(Path::new("")).join(link),
            Err(_) => return Ok(at),
        }
    }
    Err(io::Error::other("too many symbolic links"))
}

/// A file that will be readable by whom a new file usually is: the process's mask
/// applies to the mode.
#[cfg(unix)]
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    use std::os::unix::fs::PermissionsExt;
    tempfile::Builder::new()
        .prefix(".hedgerow-")
        .permissions(fs::Permissions::from_mode(0o666))
        .tempfile_in(folder)
}

#[cfg(not(unix))]
fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    tempfile::Builder::new().prefix(".hedgerow-").tempfile_in(folder)
}

fn check_positions(obj: &Obj, numbers: &WrittenNumbers) -> Result<(), ObjReason> {
    let stray = numbers.vertex_order.iter().position(|&v| !obj.mesh.position(v).is_finite());
    match stray {
        Some(place) => Err(ObjReason::NotFinite { vertex: place as u32 + 1 }),
        None => Ok(()),
    }
}

fn write_text(output: &mut impl Write, obj: &Obj, numbers: &WrittenNumbers) -> io::Result<()> {
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
fn state_of(obj: &Obj, f: FaceId) -> Option<State> {
    if obj.kept.states.is_empty() {
        return None;
    }
    let across = obj.mesh.face_halfedges(f).filter_map(|h| obj.mesh.get_face(obj.mesh.twin(h)));
    let number = std::iter::once(f).chain(across).find_map(|f| obj.face_number(f))?;
    Some(obj.kept.state(number - 1))
}

fn write_state(
    output: &mut impl Write,
    obj: &Obj,
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
    obj: &Obj,
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
