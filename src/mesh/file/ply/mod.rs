//! The polygon file format of Stanford, PLY: text, or bytes in either order.
//!
//! The head of such a file says which numbers stand for each element and how they are called, so
//! a file holds whatever attributes a mesh has. The crates `ply-rs`, `ply-rs-bw` and `serde-ply`
//! want these names when a program is compiled, or make a map of names to values of each vertex;
//! here the columns are known when the file is read, and go in and out as columns.
//!
//! | property | attribute |
//! | --- | --- |
//! | `nx ny nz`, `red green blue` (whole numbers divided by their greatest), `s t` or `u v` | `normal`, `color`, `uv` of the vertex or face |
//! | a number `NAME` | `NAME: … int` or `real` |
//! | a list `NAME` of always 2, 3, 4, 9 or 16 numbers | `NAME: … vec2`, `vec3`, `vec4`, `mat3`, `mat4` |
//! | a list `texcoord` of a face; a list `NAME` of 1, 2, … for each of its corners | `uv: halfedge vec2`; `NAME: halfedge …` |
//! | numbers of the element `edge`, behind `vertex1 vertex2` | `NAME: edge …` |
//! | `object`, `group`, `material`, `smoothing` of a face, where comments name their values | what OBJ says with `o`, `g`, `usemtl`, `s` |
//!
//! Facts that a head cannot say stand in comments that other programs pass over: `comment
//! attribute KIND NAME TYPE DEFAULT`, as in tables of halfedges; `comment material 0 NAME` and its
//! like; `comment mtllib NAME`. Reals are written with 32 bits where that is exact.

mod body;
mod header;
mod read;
mod write;

pub(super) use read::read;
pub(super) use write::write;
