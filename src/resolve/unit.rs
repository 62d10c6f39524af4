//! A file of a program.

use crate::syntax::tree;

/// A file of a program.
#[derive(Clone, Debug)]
pub struct Unit<'t> {
    /// Its tree.
    pub tree: &'t tree::File,
    /// The files it uses, by their places among the units.
    pub uses: Vec<usize>,
    /// True if it uses others that could not be had.
    pub lacks: bool,
}
