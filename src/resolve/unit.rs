//! A file of a program.

use crate::syntax::tree;

/// The qualifier of the names that a file declares, `polygon` of `polygon::flip`: the name of the
/// file, without its folder and ending.
pub fn qualifier(file: &str) -> &str {
    let name = file.rsplit('/').next().unwrap_or(file);
    name.strip_suffix(".hedge").unwrap_or(name)
}

/// A file of a program.
#[derive(Clone, Debug)]
pub struct Unit<'t> {
    /// The qualifier of the names that it declares.
    pub qualifier: &'t str,
    pub tree: &'t tree::File,
    /// The files it uses, by their indices among the units.
    pub uses: Vec<usize>,
    /// True if a file that it uses is not available.
    pub lacks: bool,
}
