//! A file of a program.

use crate::syntax::tree;

/// A file of a program.
#[derive(Clone, Debug)]
pub struct Unit<'t> {
    /// Its tree.
    pub tree: &'t tree::File,
    /// The files it uses, by their indices among the units.
    pub uses: Vec<usize>,
    /// True if a file that it uses is not available.
    pub lacks: bool,
}
