//! The conventions of a mesh library.

/// The conventions of the mesh in a target language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Conventions<'c> {
    /// True if halfedges store `prev`; if not, it is found by a walk.
    pub prev: bool,
    /// True if there are vertices at which no halfedge starts.
    pub isolated_vertices: bool,
    /// True if attributes are stored in columns that have to be looked up first.
    pub columns: bool,
    /// True if the mesh records changes and can undo them. A call that changes it then borrows it,
    /// so that nothing else in the same call can read it.
    pub undoes: bool,
    /// True if pointers that do not change are set, too.
    pub exhaustive: bool,
    /// Words that the mesh class reserves.
    pub reserved: &'c [String],
}
