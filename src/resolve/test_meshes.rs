//! The meshes of a test.

use crate::syntax::tree::Ident;

use super::program::TestMesh;

/// The meshes of a test.
#[derive(Debug, Default)]
pub(super) struct Meshes {
    pub(super) all: Vec<TestMesh>,
    /// The name and the number of each kept mesh.
    pub(super) kept: Vec<(Ident, u16)>,
}
