//! A file of a program.

use crate::syntax::tree::{self, QUALIFIES};

/// The word for a file in front of what it declares, `polygon::flip`: the name of the file, without
/// its folder and ending.
pub fn qualifier(file: &str) -> &str {
    let name = file.rsplit('/').next().unwrap_or(file);
    name.strip_suffix(".hedge").unwrap_or(name)
}

/// A name with the word for its file before it.
pub(super) fn qualified(file: &str, name: &str) -> String {
    format!("{file}{QUALIFIES}{name}")
}

/// A file of a program.
#[derive(Clone, Debug)]
pub struct Unit<'t> {
    /// The word for it in front of what it declares.
    pub qualifier: &'t str,
    /// Its tree.
    pub tree: &'t tree::File,
    /// The files it uses, by their indices among the units.
    pub uses: Vec<usize>,
    /// True if a file that it uses is not available.
    pub lacks: bool,
}
