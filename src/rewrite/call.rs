//! One run of a code: its environment and its outcome.

use super::engine::CodeKind;
use super::{Code, Function, Phase, Plan, Refusal, Reg, Site, Steps, Trap};

/// The end of a run that did not trap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// The code has run to its end; an operation has been applied.
    Applied {
        /// The value that it returned, if any.
        result: Option<u32>,
    },
    /// The operation does not apply here; the mesh is unchanged.
    Refused {
        /// The number of the reason, if one was noted.
        reason: Option<u16>,
    },
}

/// The greatest depth of nested calls of functions.
pub(super) const MOST_CALLS: usize = 1000;

/// One run of a code.
#[derive(Clone, Copy, Debug)]
pub(super) struct Call<'c> {
    pub(super) code: &'c Code,
    pub(super) refusals: &'c [Refusal],
    pub(super) functions: &'c [Function],
    pub(super) texts: &'c [String],
    /// The operations that it may call, by number.
    pub(super) plans: &'c [Option<Plan>],
    /// The number of the running operation.
    pub(super) op: Option<u16>,
    /// The steps of the operation, if it is one in steps.
    pub(super) steps: Option<&'c Steps>,
    /// The number of the running function.
    pub(super) function: Option<u16>,
    /// The kind of the code.
    pub(super) kind: CodeKind,
    /// The start of the window in the stack, and of the buffers in those of the machine.
    pub(super) base: usize,
    pub(super) buffers: usize,
    pub(super) depth: usize,
}

impl<'c> Call<'c> {
    /// The call of a script.
    pub(super) fn top(code: &'c Code, plans: &'c [Option<Plan>]) -> Self {
        Self::first((code, CodeKind::Script), plans, &[], None)
    }

    /// The call of an operation that is not called by other code: as deep as from a script.
    pub(super) fn of(plan: &'c Plan, plans: &'c [Option<Plan>]) -> Self {
        let first =
            Self::first((&plan.code, CodeKind::Whole), plans, &plan.refusals, plan.steps.as_ref());
        Self { depth: 1, ..first }
    }

    fn first(
        (code, kind): (&'c Code, CodeKind),
        plans: &'c [Option<Plan>],
        refusals: &'c [Refusal],
        steps: Option<&'c Steps>,
    ) -> Self {
        Self {
            code,
            refusals,
            functions: &code.functions,
            texts: &code.texts,
            plans,
            op: None,
            steps,
            function: None,
            kind,
            base: 0,
            buffers: 0,
            depth: 0,
        }
    }

    /// The call of an operation from this call; its window and buffers are behind those of this
    /// one.
    #[inline]
    pub(super) fn calling(&self, op: u16, plan: &'c Plan) -> Self {
        Call {
            code: &plan.code,
            refusals: &plan.refusals,
            functions: &plan.code.functions,
            texts: &plan.code.texts,
            plans: self.plans,
            op: Some(op),
            steps: plan.steps.as_ref(),
            function: None,
            kind: CodeKind::Whole,
            base: self.base + usize::from(self.code.registers),
            buffers: self.buffers + usize::from(self.code.buffers),
            depth: self.depth + 1,
        }
    }

    /// Becomes the call of a function from this one.
    #[inline]
    pub(super) fn enter(&mut self, number: u16, function: &'c Function) {
        self.base += usize::from(self.code.registers);
        self.buffers += usize::from(self.code.buffers);
        self.become_function(number, function);
    }

    /// Becomes the call of a function, and leaves window and buffers as they are.
    #[inline]
    pub(super) fn become_function(&mut self, number: u16, function: &'c Function) {
        self.code = &function.code;
        self.function = Some(number);
        self.kind = CodeKind::Function;
    }

    /// Notes a refusal. Of several, the first of the latest phase is reported.
    pub(super) fn note(&self, noted: &mut Option<(Phase, u16)>, refusal: u16) {
        let reason = self.refusals.get(usize::from(refusal));
        let phase = reason.map_or(Phase::Match, |reason| reason.phase);
        if noted.is_none_or(|(earlier, _)| phase > earlier) {
            *noted = Some((phase, refusal));
        }
    }
}

/// The state of a caller, to return to.
#[derive(Debug)]
pub(super) struct Frame<'c> {
    code: &'c Code,
    function: Option<u16>,
    kind: CodeKind,
    pub(super) base: usize,
    buffers: usize,
    /// The instruction after the call.
    pub(super) at: usize,
    /// The register that gets the value.
    pub(super) to: Reg,
    /// Whether the caller holds ids, so that none may be reused.
    pub(super) holds: bool,
}

impl<'c> Frame<'c> {
    #[inline]
    pub(super) fn of(call: &Call<'c>, at: usize, to: Reg, holds: bool) -> Self {
        let Call { code, function, kind, base, buffers, .. } = *call;
        Self { code, function, kind, base, buffers, at, to, holds }
    }

    /// Restores the call of the caller.
    #[inline]
    pub(super) fn give_back(&self, call: &mut Call<'c>) {
        let Self { code, function, kind, base, buffers, .. } = *self;
        *call = Call { code, function, kind, base, buffers, ..*call };
    }
}

impl Trap {
    /// Adds the places of all running functions to the trace, the innermost first.
    #[cold]
    pub(super) fn through_all(self, call: &Call<'_>, at: usize, returns: &[Frame<'_>]) -> Self {
        self.through(call, at).through_callers(call, returns)
    }

    /// Adds the places of the callers of the running function to the trace.
    #[cold]
    pub(super) fn through_callers(self, call: &Call<'_>, returns: &[Frame<'_>]) -> Self {
        let outer = returns.iter().rev();
        outer.fold(self, |trap, one| {
            let mut outer = *call;
            one.give_back(&mut outer);
            trap.through(&outer, one.at - 1)
        })
    }

    /// Adds a call to the trace: its instruction at `at` trapped.
    #[cold]
    pub(super) fn through(mut self, call: &Call<'_>, at: usize) -> Self {
        self.trace.push(Site { op: call.op, function: call.function, place: call.code.place(at) });
        self
    }
}
