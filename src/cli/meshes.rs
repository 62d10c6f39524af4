//! Meshes from files, and the files they go to: OBJ, or tables (`.halfedges`).

use std::path::Path;

use super::failure::Failure;
use super::files;
use super::output::{complain, is_standard, pour};
use crate::mesh::{
    Dump, Level, Mesh, Obj, Places, WrittenNumbers, expect_writable, read_dump, read_obj, validate,
    validate_level, write_dump, write_obj, write_obj_to,
};

/// Whether a file holds tables of halfedges, by its name.
pub(super) fn is_tables(path: &Path) -> bool {
    path.extension().is_some_and(|end| end == "halfedges")
}

/// Whether a file can hold an OBJ mesh, by its name; one without an ending can.
fn may_be_obj(path: &Path) -> bool {
    let mut end = path.extension().into_iter();
    end.all(|end| end.eq_ignore_ascii_case("obj"))
}

/// Reads a mesh. A file without a vertex is taken for something else.
pub(super) fn read(path: &Path) -> Result<Obj, Failure> {
    let shown = path.display();
    if is_tables(path) {
        let mesh = only_table(path, read_tables(path)?)?;
        validate(&mesh)
            .map_err(|law| Failure::usage(format!("{shown}: this is no valid mesh: {law}")))?;
        return Ok(Obj::from_tables(mesh));
    }
    let obj = read_obj(path).map_err(Failure::usage)?;
    if obj.mesh.vertex_count() == 0 {
        let message = format!("{shown}: there is no vertex in it: is it an OBJ file?");
        return Err(Failure::usage(message));
    }
    Ok(obj)
}

/// Reads tables as they stand, whether they are meshes or not.
pub(super) fn read_tables(path: &Path) -> Result<Dump, Failure> {
    let shown = path.display();
    let text = std::fs::read_to_string(path)
        .map_err(|error| Failure::usage(format!("cannot read `{shown}`: {error}")))?;
    read_dump(&text).map_err(|error| Failure::usage(format!("{shown}: {error}")))
}

/// The table of a file that has one.
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

/// Writes a mesh, and says in a line what the file cannot hold. `blame` says what may have made
/// a mesh that no list of polygons holds.
pub(super) fn write(
    path: &Path,
    obj: &mut Obj,
    blame: impl FnOnce() -> Option<String>,
) -> Result<(), Failure> {
    if !is_tables(path) {
        if !obj.mesh.is_polygons() {
            let shown = path.display();
            let other = path.with_extension("halfedges");
            return Err(Failure::usage(format!(
                "{shown}: no list of polygons holds this mesh{}{}; write it to `{}`",
                below_simple(&obj.mesh),
                blame().map(|blame| format!("; {blame}")).unwrap_or_default(),
                other.display()
            )));
        }
        if is_standard(path) {
            let mut bytes = Vec::new();
            write_obj_to(&mut bytes, obj).map_err(Failure::usage)?;
            pour(&bytes)?;
        } else {
            files::expect_waiting(path);
            write_obj(path, obj).map_err(Failure::usage)?;
        }
        tell_unheld(path, obj);
        tell_bare(path, obj);
        return Ok(());
    }
    obj.bring_all();
    let tables = Dump { meshes: vec![("mesh".into(), obj.mesh.clone())], ..Dump::default() };
    files::write(path, write_dump(&tables).as_bytes())?;
    if obj.has_groups() {
        let shown = path.display();
        complain(&format!(
            "warning: {shown} cannot hold the groups and materials of the mesh; an .obj file can"
        ));
    }
    Ok(())
}

/// Why a mesh is not of level simple, in words.
fn below_simple(mesh: &Mesh) -> String {
    let level = validate_level(mesh, Level::Simple);
    level.map_or_else(|below| format!(", since {below}"), |()| String::new())
}

/// Says which attributes an OBJ file has no place for.
fn tell_unheld(path: &Path, obj: &Obj) {
    let unheld = obj.unheld().into_iter();
    let told: Vec<_> = unheld.map(|(kind, name, ty)| format!("`{name}` ({kind} {ty})")).collect();
    if !told.is_empty() {
        let (shown, told) = (path.display(), told.join(", "));
        complain(&format!("warning: {shown} cannot hold {told}; a .halfedges file can"));
    }
}

/// Says what of the file that was read is not in the one that was written.
fn tell_bare(path: &Path, obj: &Obj) {
    let shown = path.display();
    let kinds = ["texture coordinates (`vt`)", "normals (`vn`)"];
    for (count, kind) in obj.bare_faces().into_iter().zip(kinds) {
        if count > 0 {
            let (faces, have) = if count == 1 { ("face", "has") } else { ("faces", "have") };
            complain(&format!(
                "warning: {shown}: {count} {faces} with new corners {have} no {kind} any more"
            ));
        }
    }
    let words = obj.passed_over();
    if !words.is_empty() {
        let words: Vec<_> = words.iter().map(|word| format!("`{word}`")).collect();
        complain(&format!(
            "warning: {shown}: what the mesh that was read says with {} is not in it: a mesh has \
             vertices and faces",
            words.join(", ")
        ));
    }
}

/// Says which attributes of corners are not those of their corners any more.
pub(super) fn tell_displaced(path: &Path, places: &Places, mesh: &Mesh) {
    for told in places.displaced(mesh) {
        let (shown, attribute) = (path.display(), &told.attribute);
        let [some, all] = told.faces;
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
        complain(&format!(
            "warning: {shown}: `{attribute}` is wrong on {some} of {all} faces: {}; what the ops \
             do not set does not travel with the corners",
            parts.join(", and ")
        ));
    }
}

/// The numbers that elements have in a file of this name.
pub(super) fn numbers(path: &Path, obj: &Obj) -> WrittenNumbers {
    match is_tables(path) {
        true => WrittenNumbers::of_tables(&obj.mesh),
        false => obj.written_numbers(),
    }
}

/// Whether a mesh can: its name tells how it is written.
pub(super) fn expect_mesh(path: &Path) -> Result<(), Failure> {
    if is_standard(path) {
        return Ok(());
    }
    if !is_tables(path) && !may_be_obj(path) {
        let shown = path.display();
        let message = format!("{shown}: a mesh is written as .obj or .halfedges");
        return Err(Failure::usage(message));
    }
    expect_place(path)
}

/// Whether a file can go to a place, as far as can be told before there is one: asked first,
/// so that nobody waits for a result that cannot be written.
pub(super) fn expect_place(path: &Path) -> Result<(), Failure> {
    let shown = path.display();
    let folder = path.parent().unwrap_or(Path::new(""));
    if path.is_dir() {
        let message = format!("{shown}: this is a folder: write -o with the name of a file");
        Err(Failure::usage(message))
    } else if !folder.as_os_str().is_empty() && !folder.is_dir() {
        let message = format!("{shown}: the folder `{}` does not exist", folder.display());
        Err(Failure::usage(message))
    } else {
        let writable = expect_writable(path);
        writable.map_err(|reason| Failure::usage(format!("{shown}: {reason}")))
    }
}
