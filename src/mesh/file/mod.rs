//! Files of meshes, in and out: the one door.
//!
//! | ending | vertices | faces | corners | besides |
//! | --- | --- | --- | --- | --- |
//! | `.obj` | `color`, `alpha`, `weight` | | `uv`, `normal` | objects, groups, materials, smoothing groups |
//! | `.ply` | all attributes | all | all | attributes of edges, and what OBJ has |
//! | `.off` | `color`, `alpha`, `normal`, `uv` | `color`, `alpha` | | |
//! | `.stl` | | | | triangles alone |
//! | `.msh` | reals, vectors of three, matrices of nine | the same | | groups; triangles and quads alone |
//! | `.halfedges` | all | all | all | all meshes, also such as no list of polygons holds |
//!
//! A reader turns a file into [`contents`]: positions, polygons, columns and what is kept beside
//! them; these become a mesh in one place, and there repairs are made. What the mesh has no place
//! for (texture coordinates, normals, groups, materials) is kept beside it and written back;
//! `attributes` makes values of it where a program wants them. What a file says beyond that is
//! told when the mesh is written.
//!
//! In memory ids start at 0 and slots are reused; in a file numbers start at 1 and have
//! no gaps. [`MeshFile`] remembers which elements came from the file, and under which number.

mod attributes;
mod contents;
mod corners;
mod error;
mod format;
mod kept;
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
pub use error::{FileError, FileFaultKind, FileFaults, FileReason};
pub use format::{Encoding, FileFormat, MshVersion};
pub use materials::Material;
pub use mesh_file::{MeshFile, WrittenNumbers};
pub use read::{read_mesh, read_mesh_from, read_mesh_reordered};
pub use replace::{expect_writable, replace_file};
pub use write::{write_mesh, write_mesh_to};
