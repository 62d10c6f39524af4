//! The Python package of hedgerow: a thin translation of the library.
//!
//! Values are converted, errors raised, and the interpreter's lock released while something runs;
//! what a call means is said in the library. What is written in Python (`hedgerow/*.py`) makes
//! arrays of what it is given before they come here, so that here nothing else is met than
//! contiguous arrays of the right type, which is looked at all the same.

mod argument;
mod array;
mod column;
mod element;
mod error;
mod function;
mod item;
mod live;
mod measure;
mod mesh;
mod op;
mod outcome;
mod parameters;
mod picture;
mod pointers;
mod program;
mod script;
mod trial;
mod watch;

use pyo3::prelude::*;

#[cfg(target_os = "linux")]
#[global_allocator]
static ALLOCATOR: hedgerow::huge_pages::HugePages = hedgerow::huge_pages::HugePages;

/// The compiled part of the package.
#[pymodule]
mod _hedgerow {
    #[pymodule_export]
    use super::element::Elements;
    #[pymodule_export]
    use super::function::Function;
    #[pymodule_export]
    use super::live::LiveMask;
    #[pymodule_export]
    use super::measure::{mesh_measure, mesh_normals, mesh_summary};
    #[pymodule_export]
    use super::mesh::MeshTables;
    #[pymodule_export]
    use super::op::Op;
    #[pymodule_export]
    use super::outcome::{Applied, Refused};
    #[pymodule_export]
    use super::parameters::Parameter;
    #[pymodule_export]
    use super::picture::{mesh_pixels, mesh_png, picture_sizes, write_file};
    #[pymodule_export]
    use super::program::{Program, check_text};
    #[pymodule_export]
    use super::script::Script;
    #[pymodule_export]
    use super::trial::Trial;
}
