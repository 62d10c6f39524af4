//! The meshes of a test.

use crate::syntax::tree::Ident;

use super::program::TestMesh;

/// The meshes of a test.
#[derive(Debug, Default)]
pub(super) struct Meshes {
    pub(super) all: Vec<TestMesh>,
    /// Those that were given a name.
    pub(super) kept: Vec<(Ident, u16)>,
}
