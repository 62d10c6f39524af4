//! Gmsh, versions 2.2 and 4.1: text and binary files are read, text files are written. Files of
//! MuJoCo, which have the same ending ([`mujoco`]), are read only.
//!
//! The crate `mshio` reads only version 4.1, omits names and values, panics on what it does not
//! know (as its own notes say) and depends on many numeric crates; `gmshparser` and the like are
//! for other languages.
//!
//! Faces are the triangles and quads of a file; for elements of higher order, their corners.
//! Points, lines and volumes are reported. A physical group of surfaces is a group as in OBJ.
//! Values at nodes (`$NodeData`) and elements (`$ElementData`) of 1, 3 and 9 numbers are
//! attributes: reals, vectors and matrices.

mod mujoco;
mod read;
mod write;

pub(super) use mujoco::is_of_mujoco;
pub(super) use read::read;
pub(super) use write::{is_held, write};

/// The number of nodes of elements of each type; 0 for unused types.
const NODES: [u8; 32] = [
    0, 2, 3, 4, 4, 8, 6, 5, 3, 6, 9, 10, 27, 18, 14, 1, 8, 20, 15, 13, 9, 10, 12, 15, 15, 21, 4, 5,
    6, 20, 35, 56,
];

/// The number of nodes of an element of a type.
fn node_count(element: i64) -> Result<usize, String> {
    match usize::try_from(element).ok().and_then(|element| NODES.get(element)) {
        Some(&nodes @ 1..) => Ok(usize::from(nodes)),
        _ => Err(format!("there is no element of type {element}")),
    }
}

/// The number of corners of elements of a type that are faces; 0 for other types.
fn sides(element: usize) -> usize {
    match element {
        2 | 9 | 20 | 21 | 22 | 23 | 24 | 25 => 3,
        3 | 10 | 16 => 4,
        _ => 0,
    }
}
