//! A replacement for native code where it is not built in: the machine runs everything.

use super::dispatch::Place;
use super::{Call, Function, Machine, Outcome, Trap, Watch};
use crate::mesh::Mesh;

/// There is no native code.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Native(());

#[derive(Debug, Default)]
pub(crate) struct Scratch;

impl Call<'_> {
    #[inline]
    pub(super) fn has_looped(&self) -> bool {
        false
    }
}

impl Machine {
    #[inline]
    pub(super) fn run_native(
        &mut self,
        _mesh: &mut Mesh,
        _call: Call<'_>,
        _watch: &mut dyn Watch,
    ) -> Option<Result<Outcome, Trap>> {
        None
    }

    #[inline]
    pub(super) fn is_native_due(
        &mut self,
        _mesh: &Mesh,
        _caller: &Call<'_>,
        _called: (u16, &Function),
    ) -> bool {
        false
    }

    pub(super) fn go_on_native(
        &mut self,
        _mesh: &mut Mesh,
        _call: Call<'_>,
        _place: Place,
        _watch: &mut dyn Watch,
    ) -> Option<Result<Outcome, Trap>> {
        None
    }

    pub(super) fn call_function(
        &mut self,
        _mesh: &mut Mesh,
        caller: &Call<'_>,
        inst: usize,
        _watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        Err(Trap::new(super::Message::Malformed).through(caller, inst))
    }

    pub(super) fn find_types(&mut self, _mesh: &Mesh) {}
}
