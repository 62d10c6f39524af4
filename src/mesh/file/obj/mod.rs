//! Wavefront OBJ.
//!
//! A file is read in one pass by code of its own. `tobj`, the reader of OBJ files for Rust,
//! numbers the vertices of each group anew by their first use and drops the others, so that
//! groups tear the surface apart and the numbers of the file are lost; it tells no lines, knows
//! no continued ones, passes over a fourth number, and makes a texture index up where one is
//! missing. To get by with it, every file had to be taken apart and written anew for it, with
//! polygons invented to learn the numbers back, at a quarter of the speed. Of the libraries of
//! materials that files name, which are another format, it stays the reader
//! ([`MeshFile::read_materials`](super::MeshFile::read_materials)).
//!
//! Texture coordinates, normals, objects, groups, materials and smoothing groups are
//! [kept](super::kept) beside the mesh and written back. Fourth numbers of vertices become the
//! attribute `weight` (1 if there is none), those of colours `alpha`. Points, lines, curves and
//! what is no statement of the format are told when the mesh is written; comments are not
//! kept, since what they say of a file need not hold of the next.

mod parts;
mod read;
mod write;

pub(super) use parts::read;
pub(super) use write::{vertex_columns, write};
