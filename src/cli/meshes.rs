//! Reading meshes from files, and writing them.

use std::io::{self, ErrorKind, Read, stdin};
use std::path::{Path, PathBuf};

use strsim::damerau_levenshtein;

use super::failure::Failure;
use super::option_groups::{EncodingArguments, RepairArguments};
use super::output::{eprint_line, is_standard, write_stdout};
use super::program::{Program, is_mesh};
use super::{files, interrupt};
use crate::analysis::{Analysis, is_program};
use crate::diagnostic::all_of;
use crate::mesh::{
    BareFaces, Dump, FileError, FileFormat, FileReason, Loss, LostValues, Mesh, MeshFile, Places,
    Repair, Unset, WrittenNumbers, expect_writable, open_file, read_dump, read_mesh,
    read_mesh_from, read_mesh_reordered, write_mesh_to, write_mesh_unless,
};
use crate::resolve::{TestMesh, is_shape};
use crate::run;

/// True if a file holds tables of halfedges, by its name.
pub(super) fn is_tables(path: &Path) -> bool {
    FileFormat::of(path).is_ok_and(|format| format == FileFormat::Halfedges)
}

/// Reads a mesh, repairing it if that is asked for, or makes the shape that is named in place of a
/// file: `torus(12, 8)`.
pub(super) fn read(path: &Path, arguments: &RepairArguments) -> Result<MeshFile, Failure> {
    if let Some(shape) = shape(path) {
        return match arguments.merge {
            Some(_) => Err(Failure::usage("`--merge` is for files, and not for shapes")),
            None => shape,
        };
    }
    let read = match is_standard_input(path) {
        true => read_standard_input(arguments.repair())?,
        false => read_mesh(path, arguments.repair()),
    };
    expect_read(path, read)
}

/// The shape that is named in place of a file, as in tests; `None` if it is none, or a file.
fn shape(path: &Path) -> Option<Result<MeshFile, Failure>> {
    let text = path.to_str()?;
    let is_written_so = |c: char| c.is_ascii_alphanumeric() || "_(), -.".contains(c);
    if !text.ends_with(')') || !text.chars().all(is_written_so) || path.exists() {
        return None;
    }
    let test = format!("test \"\" {{ mesh = {text} }}");
    let Analysis { program, diagnostics, .. } = Program::of("MESH".to_owned(), test).analysis;
    Some(match (program.tests.first().map(|test| &test.begin), diagnostics.first()) {
        (Some(TestMesh::Made { constructor, sizes }), None) => {
            Ok(MeshFile::from_polygons(run::constructed(constructor, sizes)))
        }
        (_, error) => {
            let why = error.map_or("this is not a shape", |error| error.message.as_str());
            let more = error.and_then(|error| error.notes.first());
            let more = more.map_or(String::new(), |more| format!("; {more}"));
            Err(Failure::usage(format!("`{text}`: {why}{more}")))
        }
    })
}

/// True if a mesh is read from standard input.
fn is_standard_input(path: &Path) -> bool {
    path == Path::new("-")
}

/// Reads a mesh from standard input, whose first bytes tell the format.
fn read_standard_input(repair: Option<Repair>) -> Result<Result<MeshFile, FileError>, Failure> {
    let mut bytes = Vec::new();
    stdin()
        .read_to_end(&mut bytes)
        .map_err(|error| Failure::usage(format!("cannot read standard input: {error}")))?;
    Ok(read_mesh_from("-", FileFormat::of_bytes(&bytes), &bytes, repair))
}

/// As [`read`], with neighbors near each other in memory.
pub(super) fn read_reordered(
    path: &Path,
    arguments: &RepairArguments,
) -> Result<MeshFile, Failure> {
    let message = if is_standard_input(path) {
        "`--reorder` is for files, and not for standard input"
    } else if shape(path).is_some() {
        "`--reorder` is for files, and not for shapes"
    } else if is_tables(path) {
        "`--reorder` is for files of polygons; tables of halfedges have their order"
    } else {
        return expect_read(path, read_mesh_reordered(path, arguments.repair()));
    };
    Err(Failure::usage(message))
}

fn expect_read(path: &Path, read: Result<MeshFile, FileError>) -> Result<MeshFile, Failure> {
    let file = read.map_err(|error| match error.is_mendable() {
        true => {
            let mut help =
                "`--repair` cuts, turns and drops what it must, and says what it did".to_owned();
            if error.reason.is_pinched() {
                help += "; where vertices only nearly coincide, `--merge DISTANCE` makes them one";
            }
            let gap = if error.to_string().contains('\n') { "\n  " } else { "; " };
            Failure::usage(format!("{error}{gap}{help}"))
        }
        false => unreadable(path, error),
    })?;
    let shown = path.display();
    if let Some(report) = file.repaired.filter(|report| report.is_changed()) {
        let mut steps = report.steps();
        if let (Some(first), Some((line, words))) = (steps.first_mut(), &file.damage) {
            let line = line.map(|line| format!("line {line}: ")).unwrap_or_default();
            *first += &format!(" ({line}{words})");
        }
        eprint_line(&format!("{shown}: repaired: {}", steps.join(", ")));
    }
    Ok(file)
}

/// The failure to read a file, with what was probably meant.
fn unreadable(path: &Path, error: FileError) -> Failure {
    let shown = path.display();
    match &error.reason {
        FileReason::UnknownEnding(_) if is_program(path) => {
            Failure::usage(format!("`{shown}` is a program; a mesh is wanted here"))
        }
        FileReason::Io(reason) if path.is_dir() || reason.kind() == ErrorKind::NotFound => {
            unopened(path, reason)
        }
        _ => Failure::usage(error),
    }
}

/// The failure to open a file, with what was probably meant.
fn unopened(path: &Path, error: &io::Error) -> Failure {
    let shown = path.display();
    Failure::usage(match error.kind() {
        _ if path.is_dir() => format!("`{shown}` is a folder; a mesh is wanted here"),
        ErrorKind::NotFound => {
            let advice = if let Ok(target) = path.read_link() {
                format!("; it is a link to `{}`", target.display())
            } else if shown.to_string().contains('=') {
                format!("; the value of a parameter is given by `--set {shown}`")
            } else if path.to_str().is_some_and(is_shape) {
                format!("; a shape has parentheses: `{shown}(…)`")
            } else if let Some(near) = near(path) {
                format!("; did you mean `{}`?", near.display())
            } else {
                String::new()
            };
            format!("cannot read `{shown}`: there is no such file{advice}")
        }
        _ => format!("cannot read `{shown}`: {error}"),
    })
}

/// The mesh beside a path with a similar name, or with the same name and an extension.
fn near(path: &Path) -> Option<PathBuf> {
    let wanted = path.file_name()?.to_str()?;
    let folder = path.parent()?;
    let here = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let entries = std::fs::read_dir(here).ok()?.flatten();
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    let meshes = names.filter(|name| is_mesh(Path::new(name)));
    let stem = |name: &str| name.rsplit_once('.').map_or(name, |(stem, _)| stem).to_owned();
    let distance = |name: &str| {
        damerau_levenshtein(wanted, name).min(damerau_levenshtein(wanted, &stem(name)))
    };
    let near = meshes.map(|name| (distance(&name), name)).min()?;
    let most = (stem(wanted).chars().count() / 3).max(1);
    (near.0 <= most).then(|| folder.join(near.1))
}

impl RepairArguments {
    /// The repairs that are asked for.
    fn repair(&self) -> Option<Repair> {
        (self.repair || self.merge.is_some()).then_some(Repair { merge: self.merge })
    }
}

/// Reads tables as they stand, whether they are meshes or not.
pub(super) fn read_tables(path: &Path, arguments: &RepairArguments) -> Result<Dump, Failure> {
    let shown = path.display();
    if arguments.merge.is_some() {
        return Err(Failure::usage(format!("{shown}: {}", FileReason::MergedTables)));
    }
    let text = open_file(path)
        .and_then(std::io::read_to_string)
        .map_err(|error| unopened(path, &error))?;
    read_dump(&text).map_err(|error| Failure::usage(format!("{shown}: {error}")))
}

/// The mesh of a file that has exactly one table.
pub(super) fn only_table(path: &Path, mut dump: Dump) -> Result<Mesh, Failure> {
    match (dump.meshes.pop(), dump.meshes.len()) {
        (Some((_, mesh)), 0) => Ok(mesh),
        (_, others) => {
            let count = if others == 0 { 0 } else { others + 1 };
            let shown = path.display();
            let message = format!("{shown}: a file with one `mesh` is wanted; this has {count}");
            Err(Failure::usage(message))
        }
    }
}

/// Writes a mesh, and warns about what the file cannot hold. `blame` says what may have made a mesh
/// that no list of polygons can hold.
pub(super) fn write(
    path: &Path,
    file: &mut MeshFile,
    encoding: &EncodingArguments,
    blame: impl FnOnce(&Mesh) -> Option<String>,
) -> Result<(), Failure> {
    let shown = path.display();
    let format = format(path)?;
    interrupt::listen();
    interrupt::expect_none()?;
    let bare = match format {
        FileFormat::Obj | FileFormat::Ply | FileFormat::Halfedges => file.bare_faces(),
        // They hold neither texture coordinates nor normals of corners.
        FileFormat::Stl | FileFormat::Off | FileFormat::Msh => [BareFaces::default(); 2],
    };
    match format {
        FileFormat::Obj => {}
        FileFormat::Ply => file.bring_colors(),
        _ => file.bring_all(),
    }
    let gathered = file.gather(format);
    if let Some(encoding) = encoding.encoding {
        file.encoding = encoding;
    }
    if let Some(version) = encoding.msh {
        file.msh_version = version;
    }
    let written = if is_standard(path) {
        let mut bytes = Vec::new();
        write_mesh_to(&mut bytes, format, file).map(|()| bytes).map_err(|reason| FileError {
            file: path.display().to_string(),
            line: None,
            reason,
        })
    } else {
        files::expect_waiting(path);
        write_mesh_unless(path, file, &interrupt::is_asked).map(|()| Vec::new())
    };
    if written.is_err() {
        interrupt::expect_none()?;
    }
    let bytes = written.map_err(|error| match error.reason {
        FileReason::NotPolygons(_) => {
            let other = path.with_extension("halfedges");
            let blame = blame(&file.mesh).map(|blame| format!("; {blame}")).unwrap_or_default();
            Failure::usage(format!("{error}{blame}; write it to `{}`", other.display()))
        }
        _ => Failure::usage(error),
    })?;
    if is_standard(path) {
        write_stdout(&bytes)?;
    }
    for name in gathered {
        eprint_line(&format!(
            "{shown}: `{name}` is written for each vertex, whose corners all have the same"
        ));
    }
    tell_unheld(path, format, file);
    tell_lost_values(path, format, file);
    tell_lost_vertices(path, format, file);
    tell_bare(path, format, bare);
    let lost = file.lost_groups(format);
    if !lost.is_empty() {
        eprint_line(&format!(
            "warning: {shown} cannot hold the {} of the mesh; {} file can",
            all_of(lost.clone()),
            if lost.contains(&"texture files") { "a .ply" } else { "an .obj or .ply" }
        ));
    }
    tell_overruled(path, format, file);
    for loss in file.losses() {
        eprint_line(&format!("warning: {shown}: of the mesh that was read: {loss}"));
    }
    Ok(())
}

/// Warns about attributes that a file cannot hold.
fn tell_unheld(path: &Path, format: FileFormat, file: &MeshFile) {
    let unheld = file.unheld(format).into_iter();
    let told: Vec<_> = unheld.map(|(kind, name, ty)| format!("`{name}` ({kind} {ty})")).collect();
    if !told.is_empty() {
        let (shown, told) = (path.display(), told.join(", "));
        eprint_line(&format!("warning: {shown} cannot hold {told}; a .ply or .halfedges file can"));
    }
}

/// Warns about values that a file does not hold as they are.
fn tell_lost_values(path: &Path, format: FileFormat, file: &MeshFile) {
    let shown = path.display();
    for LostValues { kind, name, count, loss } in file.lost_values(format) {
        let (values, are) = if count == 1 { ("value", "is") } else { ("values", "are") };
        let what = match loss {
            Loss::AtHoles => format!("on holes {are} not in it"),
            Loss::Rounded => format!("beyond 2^53 {are} rounded"),
            Loss::NoColours => format!("with parts that are not from 0 to 1 {are} read otherwise"),
        };
        let other = if loss == Loss::NoColours { ".ply or .halfedges" } else { ".halfedges" };
        eprint_line(&format!(
            "warning: {shown}: {count} {values} of `{name}` ({kind}) {what}; a {other} file holds {}",
            if count == 1 { "it" } else { "them" },
            kind = kind.name(),
        ));
    }
}

/// Warns about vertices that a file loses.
fn tell_lost_vertices(path: &Path, format: FileFormat, file: &MeshFile) {
    let (shown, [merged, left_out]) = (path.display(), file.lost_vertices(format));
    if merged > 0 {
        let lie = if merged == 1 { "vertex lies" } else { "vertices lie" };
        eprint_line(&format!(
            "warning: {shown} knows vertices by their places alone: {merged} {lie} where another \
             does, and will be one with it; an .obj or .ply file can hold both"
        ));
    }
    if left_out > 0 {
        let are =
            if left_out == 1 { "vertex without a face is" } else { "vertices without a face are" };
        eprint_line(&format!(
            "warning: {shown} holds triangles alone: {left_out} {are} left out; an .obj or .ply file \
             can hold them"
        ));
    }
}

/// Warns about faces without the texture coordinates or normals that others of the file that was
/// read have.
fn tell_bare(path: &Path, format: FileFormat, bare: [BareFaces; 2]) {
    let shown = path.display();
    let kinds = match format {
        FileFormat::Obj => ["texture coordinates (`vt`)", "normals (`vn`)"],
        _ => ["texture coordinates", "normals"],
    };
    let is_zero = format == FileFormat::Halfedges;
    let rest = if is_zero { ": they are zero there" } else { "" };
    for (BareFaces { new, partial, without }, kind) in bare.into_iter().zip(kinds) {
        let tell = |count: usize, which: &str, what: String| {
            let (faces, have) = if count == 1 { ("face", "has") } else { ("faces", "have") };
            if count > 0 {
                eprint_line(&format!("warning: {shown}: {count} {faces}{which} {have} {what}"));
            }
        };
        tell(new, " with new corners", format!("no {kind} any more{rest}"));
        match is_zero {
            true => tell(partial + without, "", format!("no {kind} at some corners{rest}")),
            false => tell(partial, "", format!("{kind} at some corners alone, which are left out")),
        }
    }
}

/// Warns about faces that an OBJ file gives the object or the material of the face before.
fn tell_overruled(path: &Path, format: FileFormat, file: &MeshFile) {
    if format != FileFormat::Obj {
        return;
    }
    for (count, what) in file.overruled_faces().into_iter().zip(["an object", "a material"]) {
        if count > 0 {
            let (shown, faces) = (path.display(), if count == 1 { "face" } else { "faces" });
            eprint_line(&format!(
                "warning: {shown}: {count} {faces} without {what} will have that of the face before; \
                 a .ply file can hold such faces"
            ));
        }
    }
}

/// The format of a file, by its name.
fn format(path: &Path) -> Result<FileFormat, Failure> {
    let shown = path.display();
    FileFormat::of(path).map_err(|reason| Failure::usage(format!("{shown}: {reason}")))
}

/// Warns about attributes of corners that are not those of their corners any more, and about new
/// edges and faces that have none.
pub(super) fn tell_displaced(path: &Path, places: &Places, mesh: &Mesh) {
    for told in places.displaced(mesh) {
        let (shown, attribute) = (path.display(), &told.attribute);
        let [some, all] = told.faces;
        // Other values may have been computed from these.
        let least = if some < all { "at least " } else { "" };
        let corners = |count: usize| if count == 1 { "corner has" } else { "corners have" };
        let mut parts = Vec::new();
        if told.kept > 0 {
            let have = corners(told.kept);
            parts.push(format!("{} {have} kept the value of a place left", told.kept));
        }
        if told.defaulted > 0 {
            let have = corners(told.defaulted);
            parts.push(format!("{} new {have} the default", told.defaulted));
        }
        eprint_line(&format!(
            "warning: {shown}: `{attribute}` is wrong on {least}{some} of {all} faces: {}; operations \
             have to set it at new corners",
            parts.join(", and ")
        ));
    }
    for Unset { kind, attribute, count } in places.unset(mesh) {
        let shown = path.display();
        let elements = if count == 1 {
            format!("new {kind} has")
        } else {
            format!("new {} have", kind.plural())
        };
        eprint_line(&format!(
            "warning: {shown}: {count} {elements} the default of `{attribute}`, which the file that was \
             read has and the program does not name; operations have to set it"
        ));
    }
}

/// The numbers that elements have in a file of this name.
pub(super) fn numbers(path: &Path, file: &MeshFile) -> WrittenNumbers {
    if is_tables(path) { WrittenNumbers::of_tables(&file.mesh) } else { file.written_numbers() }
}

/// Checks that a mesh can be written to a path, whose extension tells the format, in an encoding.
pub(super) fn expect_mesh(path: &Path, encoding: &EncodingArguments) -> Result<(), Failure> {
    encoding.expect(format(path)?)?;
    if is_standard(path) { Ok(()) } else { expect_place(path) }
}

/// Checks that a file can be written to a path, as far as that can be told in advance: called
/// early, so that no result is computed that cannot be written.
pub(super) fn expect_place(path: &Path) -> Result<(), Failure> {
    let shown = path.display();
    let folder = path.parent().unwrap_or(Path::new(""));
    if path.is_dir() {
        Err(Failure::usage(format!("{shown}: this is a folder: write -o with the name of a file")))
    } else if !folder.as_os_str().is_empty() && !folder.is_dir() {
        Err(Failure::usage(format!("{shown}: the folder `{}` does not exist", folder.display())))
    } else {
        expect_writable(path).map_err(|reason| Failure::usage(format!("{shown}: {reason}")))
    }
}
