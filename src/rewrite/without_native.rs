//! In place of native code where it is not built in: the machine runs everything.

use super::engine::Way;
use super::{Call, Machine, Outcome, Trap, Watch};
use crate::mesh::Mesh;

/// There is no native code.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Native(());

impl Machine {
    #[inline]
    pub(super) fn run_native(
        &mut self,
        _mesh: &mut Mesh,
        _call: Call<'_>,
        _way: Way,
        _watch: &mut dyn Watch,
    ) -> Option<Result<Outcome, Trap>> {
        None
    }

    pub(super) fn find_types(&mut self, _mesh: &Mesh) {}
}
