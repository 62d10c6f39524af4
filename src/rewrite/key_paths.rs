//! The paths of the keys of all drains of a run, each computed once.

use std::sync::Arc;

use super::paths::{Paths, Unbounded};
use super::{Call, Code, Function, Inst, Plan, reads};

/// The place where a drain begins: the operation, the function, the instruction.
type Place = (Option<u16>, Option<u16>, usize);

/// The paths of the keys of the drains that have run.
#[derive(Debug, Default)]
pub(super) struct KeyPaths(Vec<(Place, Option<Arc<Paths>>)>);

impl KeyPaths {
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// The paths for the drain that an instruction of a call opens; `None` if its key has none.
    pub(super) fn of(&mut self, call: &Call<'_>, at: usize) -> Option<Arc<Paths>> {
        let place = (call.op, call.function, at);
        if let Some((_, known)) = self.0.iter().find(|(known, _)| *known == place) {
            return known.clone();
        }
        let paths = reads::paths(call.code, call.functions, call.plans, at).ok().map(Arc::new);
        self.0.push((place, paths.clone()));
        paths
    }
}

/// For each drain in a code, the instruction that opens it and, if its stale keys are not found by
/// walking back from what was written, the reason.
pub fn drains(
    code: &Code,
    functions: &[Function],
    plans: &[Option<Plan>],
) -> Vec<(usize, Option<Unbounded>)> {
    let opens = |(_, inst): &(usize, &Inst)| matches!(inst, Inst::DrainOpen { .. });
    let all = code.insts.iter().enumerate().filter(opens);
    all.map(|(at, _)| (at, reads::paths(code, functions, plans, at).err())).collect()
}
