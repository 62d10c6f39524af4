//! Operations in steps: they call others, all or nothing.
//!
//! The effects of a step are undone if a later one refuses, or if the mesh does not have its level
//! at the end: a journal of the mesh has recorded the writes, so both cost no more than the steps
//! did.

use super::{Call, Machine, Message, Outcome, Plan, Trap, Watch};
use crate::mesh::{BelowLevel, Level, Mesh, validate_level_near};

/// The data that the plan of an operation in steps has in addition.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Steps {
    /// The operations that it calls, each with its number and the number that its first refusal has
    /// among those of the caller.
    pub calls: Vec<(u16, u16)>,
    /// The number of the first of the refusals in [`BELOW`], which are in that order.
    pub below: u16,
}

/// The reasons why a mesh no longer has its level.
pub const BELOW: [&str; 10] = [
    "the mesh would be broken",
    "a face or hole would have fewer than three sides",
    "a face or hole would meet a vertex twice",
    "a vertex would keep a single edge",
    "a vertex would have holes only around it",
    "a vertex would lie on two holes",
    "an edge would have a hole on both sides",
    "an edge would end where it begins",
    "two edges would have the same ends",
    "two faces would have the same corners",
];

/// The place of a reason in [`BELOW`].
fn place(below: &BelowLevel) -> u16 {
    match below {
        BelowLevel::Invalid(_) => 0,
        BelowLevel::SmallLoop { .. } => 1,
        BelowLevel::MeetsTwice { .. } => 2,
        BelowLevel::SingleSpoke { .. } => 3,
        BelowLevel::NoFaceAround { .. } => 4,
        BelowLevel::Pinched { .. } => 5,
        BelowLevel::NoFaceAlong { .. } => 6,
        BelowLevel::EndsWhereItBegins { .. } => 7,
        BelowLevel::DoubleEdge { .. } => 8,
        BelowLevel::SameCorners { .. } => 9,
    }
}

impl Steps {
    /// The number among its own refusals of a refusal of an operation that it calls.
    pub(super) fn refusal_of(&self, op: u16, reason: Option<u16>) -> Option<u16> {
        let called = self.calls.iter().find(|(called, _)| *called == op);
        called.zip(reason).map(|((_, first), reason)| first.saturating_add(reason))
    }
}

impl Machine {
    /// Runs the code of an operation; an operation in steps is applied all or nothing.
    pub(super) fn carry_out<const OBSERVED: bool>(
        &mut self,
        mesh: &mut Mesh,
        plan: &Plan,
        call: Call<'_>,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        match &plan.steps {
            None => match self.run_native(mesh, call, watch) {
                Some(outcome) => outcome,
                None => self.execute::<OBSERVED>(mesh, call, watch),
            },
            Some(steps) => {
                let known = self.begin_steps(mesh, &steps.calls);
                let outcome = self.take::<OBSERVED>(mesh, (plan, steps), call, watch);
                self.end_steps(known, matches!(outcome, Ok(Outcome::Applied { .. })));
                outcome
            }
        }
    }

    /// Runs steps; what was done is kept if they apply, and else undone.
    #[cold]
    pub(super) fn take<const OBSERVED: bool>(
        &mut self,
        mesh: &mut Mesh,
        (plan, steps): (&Plan, &Steps),
        call: Call<'_>,
        watch: &mut dyn Watch,
    ) -> Result<Outcome, Trap> {
        // Operations in steps that call each other can run for long without a loop.
        if self.progress.tick(watch).is_break() {
            return Err(Trap::new(Message::Interrupted));
        }
        let (holding, drains) = (self.holding, self.drains.open_ones());
        let created = self.created.as_ref().map_or(0, Vec::len);
        let mark = mesh.open_journal();
        let mut outcome = match self.run_native(mesh, call, watch) {
            Some(outcome) => outcome,
            None if OBSERVED || call.code.drains() => self.execute::<true>(mesh, call, watch),
            None => self.execute::<false>(mesh, call, watch),
        };
        if let Ok(Outcome::Applied { .. }) = outcome
            && plan.level > Level::Map
        {
            let written = mesh.written_since(&mark);
            if self.drains.is_reading() {
                self.drains.read_level(mesh, &written);
            }
            if let Err(below) = validate_level_near(mesh, plan.level, &written) {
                let reason = Some(steps.below.saturating_add(place(&below)));
                outcome = Ok(Outcome::Refused { reason });
            }
        }
        // The steps may have left drains and calls open.
        self.holding = holding;
        self.drains.leave(drains);
        let is_applied = matches!(outcome, Ok(Outcome::Applied { .. }));
        if is_applied {
            mesh.keep(mark);
        } else {
            mesh.roll_back(mark);
            if let Some(all) = &mut self.created {
                all.truncate(created);
            }
        }
        outcome
    }
}
