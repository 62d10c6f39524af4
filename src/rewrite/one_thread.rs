//! In place of loops that several threads take where threads or native code are not built in.

use super::{Call, Machine, Trap, Watch};
use crate::mesh::Mesh;

impl Machine {
    /// One thread is to do it.
    pub(super) fn spread(
        &mut self,
        _mesh: &mut Mesh,
        _call: &Call<'_>,
        _part: (u16, usize),
        _watch: &mut dyn Watch,
    ) -> Option<Result<(), Trap>> {
        None
    }
}
