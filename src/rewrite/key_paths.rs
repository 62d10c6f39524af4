//! The paths of the keys of all drains of a run, each found out once.

use std::sync::Arc;

use super::paths::{Paths, Unbounded};
use super::{Call, Code, Function, Inst, reads};

/// The beginning of a drain: the operation, the function, the instruction.
type Place = (Option<u16>, Option<u16>, usize);

/// The paths of the keys of those drains that have run.
#[derive(Debug, Default)]
pub(super) struct KeyPaths(Vec<(Place, Option<Arc<Paths>>)>);

impl KeyPaths {
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// Those of the drain that an instruction of a call begins; none if its key has none.
    pub(super) fn of(&mut self, call: &Call<'_>, at: usize) -> Option<Arc<Paths>> {
        let place = (call.op, call.function, at);
        if let Some((_, known)) = self.0.iter().find(|(known, _)| *known == place) {
            return known.clone();
        }
        let paths = reads::paths(call.code, call.functions, at).ok().map(Arc::new);
        self.0.push((place, paths.clone()));
        paths
    }
}

/// For each drain in a code, the instruction that begins it and, if the keys to compute anew are
/// not found by walking back from what was written, why.
pub fn drains(code: &Code, functions: &[Function]) -> Vec<(usize, Option<Unbounded>)> {
    let opens = |(_, inst): &(usize, &Inst)| matches!(inst, Inst::DrainOpen { .. });
    let all = code.insts.iter().enumerate().filter(opens);
    all.map(|(at, _)| (at, reads::paths(code, functions, at).err())).collect()
}
