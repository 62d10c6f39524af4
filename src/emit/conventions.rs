//! The conventions of a mesh library.

/// The conventions of the mesh of a language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Conventions<'c> {
    /// True if halfedges store `prev`; if not, it is found by a walk.
    pub prev: bool,
    /// True if there are vertices at which no halfedge starts.
    pub isolated_vertices: bool,
    /// True if attributes lie in columns that have to be found first.
    pub columns: bool,
    /// True if the mesh knows what was done to it, and undoes it. Who changes it borrows it then,
    /// so that nothing else in the same call can look at it.
    pub undoes: bool,
    /// True if pointers are set that do not change.
    pub exhaustive: bool,
    /// Words that the mesh class keeps to itself.
    pub kept: &'c [String],
}
