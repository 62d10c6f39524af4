//! Reading and writing mesh files.
//!
//! | ending | vertices | faces | corners | other |
//! | --- | --- | --- | --- | --- |
//! | `.obj` | `color`, `alpha`, `weight` | | `uv`, `normal` | objects, groups, materials, smoothing groups |
//! | `.ply` | all attributes | all | all | attributes of edges, and what OBJ has |
//! | `.off` | `color`, `alpha`, `normal`, `uv` | `color`, `alpha` | | |
//! | `.stl` | | | | triangles only |
//! | `.msh` | reals, vectors of three, matrices of nine | the same | | groups; triangles and quads only |
//! | `.halfedges` | all | all | all | all meshes, even if no polygon list can hold them |
//!
//! A reader turns a file into [`contents`]: positions, polygons, columns and what is kept beside
//! them; one function builds a mesh from these, with repairs on request. What the mesh cannot
//! represent (texture coordinates, normals, groups, materials) is kept beside it and written back;
//! `attributes` makes columns of it where a program wants them. Anything else in a file is lost,
//! which is reported when the mesh is written.
//!
//! In memory, ids start at 0 and slots are reused; in a file, numbers start at 1 and have no gaps.
//! [`MeshFile`] remembers which elements came from the file, and under which numbers.

mod attributes;
mod contents;
mod corners;
mod error;
mod format;
mod kept;
mod lost_values;
mod materials;
mod mesh_file;
mod msh;
mod obj;
mod off;
mod ply;
mod print;
mod read;
mod replace;
mod scan;
mod sources;
mod stl;
mod write;

pub use attributes::WantedAttribute;
pub use corners::BareFaces;
pub use error::{FileError, FileFaultKind, FileFaults, FileReason};
pub use format::{Encoding, FileFormat, MshVersion};
pub use lost_values::{Loss, LostValues};
pub use materials::Material;
pub use mesh_file::{MeshFile, WrittenNumbers};
pub use read::{open_file, read_mesh, read_mesh_from, read_mesh_reordered};
pub use replace::{expect_writable, replace_file};
pub use write::{write_mesh, write_mesh_to, write_mesh_unless};
