//! Meshes from files, and the files they go to.

use std::path::Path;

use super::failure::Failure;
use crate::mesh::{Obj, read_obj};

/// Reads a mesh. A file without a vertex is taken for something else.
pub(super) fn read(path: &Path) -> Result<Obj, Failure> {
    let obj = read_obj(path).map_err(Failure::usage)?;
    if obj.mesh.vertex_count() == 0 {
        let shown = path.display();
        let message = format!("{shown}: there is no vertex in it: is it an OBJ file?");
        return Err(Failure::usage(message));
    }
    Ok(obj)
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
        Ok(())
    }
}
